//! Tests of operators as contact uses them.

mod contacts;
mod contract;
mod edges;
mod fields;
mod half_plane;
mod howland;
mod orthotropic;
mod peaks;
mod persson;
mod strip;
mod thinned;
