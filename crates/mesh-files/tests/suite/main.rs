//! Tests of readers, writers and curves as other crates use them.

mod abaqus;
mod assembly;
mod curves;
mod errors;
mod fuzz;
mod gmsh;
mod quality;
mod round_trip;
mod vtu;

use std::io;

use stickslip_fem_core::mesh::Mesh;
use stickslip_mesh_files::{Format, Imported, ReadError, read};

fn no_files(name: &str) -> io::Result<String> {
    Err(io::Error::other(format!("there is no file '{name}'")))
}

/// Reads a text whose mesh must be valid.
fn imported(text: &str, format: Format) -> Imported {
    let file = read(text, format, &no_files).expect("a readable file");
    Mesh::new(file.parts.clone()).expect("a valid mesh");
    file
}

fn refused(text: &str, format: Format) -> ReadError {
    read(text, format, &no_files).expect_err("a file with a defect")
}

/// File numbers of the ends of each edge of a set, the cell on the left.
fn ends(file: &Imported, set: &str) -> Vec<[u64; 2]> {
    let mesh = Mesh::new(file.parts.clone()).expect("a valid mesh");
    let edges = &mesh.edge_set(set).expect("an edge set").edges;
    let number = |node: usize| file.node_numbers[node];
    edges
        .iter()
        .map(|&edge| mesh.edge_nodes(edge).ends.map(number))
        .collect()
}
