//! Whole scenes: what must hold whatever the numbers in them, equilibrium above all.

mod arcs;
mod determinism;
mod equilibrium;
mod history;
mod laws;
mod map;
mod materials;
mod symmetry;
