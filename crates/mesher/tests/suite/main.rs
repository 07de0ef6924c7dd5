//! Meshes of outlines of lines, arcs and splines with circular holes.

mod area;
mod limits;
mod motion;
mod random;
mod refusals;
mod sets;
mod shape;
mod shapes;
mod splines;
