//! Friction laws fitted by contact solves: truth known.

mod choice;
mod common;
mod contact;
mod fits;
mod mesh_error;
mod model;
mod page;
mod sensitivity;
mod static_bound;
mod whole;
