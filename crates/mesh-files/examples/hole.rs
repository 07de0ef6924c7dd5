//! The radius of a hole, found in a mesh that Gmsh could have written.
//!
//! Run with `cargo run --release -p stickslip-mesh-files --example hole`.

use std::error::Error;
use std::io;

use stickslip_fem_core::generate::{
    Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::mesh::{Curve, ElementKind};
use stickslip_mesh_files::{Format, read, recognise_set, write_msh};

fn main() -> Result<(), Box<dyn Error>> {
    let plate = PlateWithHole {
        hole_radius: 0.375,
        outline: Outline::Ring { outer_radius: 2.0 },
        extent: Extent::Whole,
        angles: uniform_angles(Extent::Whole, 24),
        layers: 6,
        growth: Growth::Geometric { aspect: 1.0 },
        far_cells: 0,
        kind: ElementKind::T3,
    };
    let text = write_msh(&plate.generate()?)?;
    let file = read(&text, Format::Gmsh, &|name| {
        Err(io::Error::other(format!("no file '{name}'")))
    })?;
    let hole = recognise_set(&file.parts, "hole")?;
    let Curve::Arc { radius, .. } = hole.curve else {
        return Err("the hole is no circle".into());
    };
    println!("radius of the hole {radius:.6}, of the plate 0.375000");
    Ok(())
}
