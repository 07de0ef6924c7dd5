//! Whole scenes: what must hold whatever the numbers in them, equilibrium above all.

mod arcs;
mod equilibrium;
