//! Condenses a steel block to its top edge and presses on it.
//!
//! ```text
//! u = C λ,     v = −p h / E  under a uniform pressure p
//! ```
//!
//! Lengths in mm, stresses in MPa, forces in N.

use std::error::Error;
use std::sync::Arc;

use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::nalgebra::DVector;
use stickslip_fem_core::{ElasticBody, HeldDirection, InterfaceOperator, Support};

fn main() -> Result<(), Box<dyn Error>> {
    let (width, height, thickness) = (20.0, 10.0, 5.0);
    let (young, poisson, pressure) = (200e3, 0.3, 100.0);

    let block = Rectangle::uniform([0.0, width], [0.0, height], [8, 4], ElementKind::Q8)?;
    let mesh = Arc::new(block.generate()?);
    let rollers = |set: &str, direction| {
        mesh.node_set(set).map(|nodes| Support {
            nodes: nodes.to_vec(),
            direction,
            displacement: 0.0,
        })
    };
    let supports = [
        rollers("left", HeldDirection::X)?,
        rollers("bottom", HeldDirection::Y)?,
    ];
    let steel = Isotropic::new(young, poisson, PlaneState::Stress)?;
    let body = ElasticBody::new(Arc::clone(&mesh), vec![Arc::new(steel)], thickness)?
        .with_supports(supports);

    // One factorisation of the whole block leaves a dense matrix on the nodes of the top edge.
    let top = mesh.node_set("top")?;
    let condensed = Arc::new(body).condense(top)?;
    let compliance = condensed
        .compliance()
        .ok_or("an elastic body has a compliance")?;

    let edges = &mesh.edge_set("top")?.edges;
    let nodal = edge_load(&mesh, edges, thickness, |at| {
        at.normal.map(|n| -pressure * n)
    });
    let on_top = top
        .iter()
        .flat_map(|&node| [nodal[2 * node], nodal[2 * node + 1]]);
    let forces = DVector::from_iterator(2 * top.len(), on_top);
    let u = compliance * forces;

    let settlement = -u[1];
    let exact = pressure * height / young;
    println!(
        "{} nodes condensed to {}: the top settles {settlement:.6} mm, p h / E = {exact:.6} mm",
        mesh.nodes().len(),
        top.len()
    );
    assert!((settlement - exact).abs() < 1e-9 * exact);
    Ok(())
}
