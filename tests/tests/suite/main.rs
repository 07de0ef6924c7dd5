//! Whole scenes: what must hold whatever the numbers in them, equilibrium above all.

mod absence;
mod answers;
mod arcs;
mod circles;
mod determinism;
mod equilibrium;
mod files;
mod history;
mod laws;
mod map;
mod materials;
mod scaling;
mod symmetry;
