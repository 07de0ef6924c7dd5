//! Meshes of outlines of lines and arcs with circular holes.

mod area;
mod limits;
mod motion;
mod random;
mod refusals;
mod sets;
mod shape;
mod shapes;
