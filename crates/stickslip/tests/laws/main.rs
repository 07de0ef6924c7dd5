//! Friction laws fitted by contact solves: truth known.

mod common;
mod contact;
mod fits;
mod mesh_error;
mod model;
mod page;
mod sensitivity;
mod whole;
