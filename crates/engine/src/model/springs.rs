//! Springs between edges or points of a body and the ground.

use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::{Mesh, MeshError};
use stickslip_fem_core::{ElasticBody, HeldDirection, Spring, SpringSite};
use stickslip_scene::schema::{Hold, SetRef, SpringSize, SpringSupport};

use super::plan::Plan;

/// The springs of the body with the index `index` and `thickness` `[mm]`.
pub(super) fn of_body(
    plan: &Plan<'_>,
    index: usize,
    mesh: &Mesh,
    thickness: f64,
) -> Result<Vec<Spring>, MeshError> {
    let mut all = Vec::new();
    let own = plan.springs.iter().filter(|own| own.body == index);
    for SpringSupport {
        on,
        hold,
        stiffness,
        ..
    } in own.map(|own| own.of)
    {
        let (site, area) = site(mesh, on, thickness)?;
        let stiffness = match *stiffness {
            SpringSize::Whole(stiffness) => stiffness / area,
            SpringSize::Bed(bed) => bed,
        };
        let directions = match *hold {
            Hold::Direction(angle) => vec![HeldDirection::Angle(angle)],
            Hold::Axes(axes) => [(axes.x, HeldDirection::X), (axes.y, HeldDirection::Y)]
                .into_iter()
                .filter_map(|(is_held, direction)| is_held.then_some(direction))
                .collect(),
        };
        all.extend(directions.into_iter().map(|direction| Spring {
            site: site.clone(),
            direction,
            stiffness,
        }));
    }
    Ok(all)
}

/// Nodes with their weights along x and y.
type NodeWeights = Vec<(usize, [f64; 2])>;

/// The weights of the mean displacement of `body` on `springs` along `direction`, whose sum along it is one, and the stiffness of all of them `[N/mm]`.
pub(super) fn mean(
    body: &ElasticBody,
    springs: &SpringSupport,
    direction: [f64; 2],
) -> Result<(NodeWeights, f64), MeshError> {
    let (mesh, thickness, on) = (body.mesh(), body.thickness(), &springs.on);
    let (site, area) = site(mesh, on, thickness)?;
    let weights = match site {
        SpringSite::Edges(edges) => {
            let parts = edge_load(mesh, &edges, thickness, |_| direction);
            let parts = parts.chunks_exact(2).enumerate();
            let own = parts.filter(|(_, part)| *part != [0.0; 2]);
            let own = own.map(|(node, part)| (node, [part[0] / area, part[1] / area]));
            own.collect()
        }
        SpringSite::Node(node) => vec![(node, direction)],
    };
    Ok((weights, total(springs, area)))
}

/// Stiffness of all springs of a support `[N/mm]`.
pub(super) fn whole(
    mesh: &Mesh,
    springs: &SpringSupport,
    thickness: f64,
) -> Result<f64, MeshError> {
    let (_, area) = site(mesh, &springs.on, thickness)?;
    Ok(total(springs, area))
}

fn total(springs: &SpringSupport, area: f64) -> f64 {
    match springs.stiffness {
        SpringSize::Whole(stiffness) => stiffness,
        SpringSize::Bed(bed) => bed * area,
    }
}

/// Where springs stand, and the area of an edge `[mm²]`, 1 of a point.
fn site(mesh: &Mesh, on: &SetRef, thickness: f64) -> Result<(SpringSite, f64), MeshError> {
    if let Ok(set) = mesh.edge_set(&on.set) {
        let along_x = edge_load(mesh, &set.edges, thickness, |_| [1.0, 0.0]);
        return Ok((SpringSite::Edges(set.edges.clone()), along_x.iter().sum()));
    }
    let nodes = mesh.node_set(&on.set)?;
    let empty = || MeshError::EmptySet {
        set: on.set.clone(),
    };
    let node = nodes.first().copied().ok_or_else(empty)?;
    Ok((SpringSite::Node(node), 1.0))
}
