//! What acts where, for whoever shows the model.

use stickslip_fem_core::mesh::Mesh;
use stickslip_scene::schema::{LoadKind, SetRef};

use super::meshes::Meshes;
use super::plan::Plan;
use crate::results::{Acting, Problem, Site, SitePart};

/// That of `plan` on `meshes`.
pub(super) fn of(plan: &Plan<'_>, meshes: &Meshes) -> Problem {
    let site = |body: usize, on: &SetRef| {
        let part = part(meshes.get(&body)?, &on.set);
        Some(Site { body, part })
    };
    let sides = plan.contacts.iter().flat_map(|contact| &contact.sides);
    let supports = plan.supports.iter();
    let (springs, platens) = (plan.springs.iter(), plan.platens.iter());
    let loads = plan.loads.iter().filter_map(|load| {
        let (on, direction) = match &load.of.kind {
            LoadKind::Force { on, direction, .. } | LoadKind::Bearing { on, direction, .. } => {
                (on, Some(*direction))
            }
            LoadKind::Pressure { on, .. } => (on, None),
            LoadKind::PolarTraction { .. } | LoadKind::Temperature { .. } => return None,
        };
        let site = site(load.body, on)?;
        Some(Acting { site, direction })
    });
    let shapes = plan.bodies.iter().filter(|body| body.elastic.is_some());
    Problem {
        plane: plan.analysis.plane,
        is_divided: plan.is_divided || shapes.map(|body| body.shape).any(|own| own.has_own_mesh()),
        contacts: sides.filter_map(|side| site(side.body, side.of)).collect(),
        held: supports
            .filter_map(|own| site(own.body, &own.of.on))
            .collect(),
        springs: springs
            .filter_map(|own| site(own.body, &own.of.on))
            .collect(),
        platens: platens
            .filter_map(|own| site(own.body, &own.of.on))
            .collect(),
        loads: loads.collect(),
    }
}

fn part(mesh: &Mesh, set: &str) -> SitePart {
    match (mesh.edge_path(set), mesh.node_set(set)) {
        (Ok(path), _) => {
            let first = path.nodes.first().copied().filter(|_| path.closed);
            SitePart::Edge(path.nodes.iter().copied().chain(first).collect())
        }
        (Err(_), Ok(nodes)) => SitePart::Points(nodes.to_vec()),
        (Err(_), Err(_)) => SitePart::Area,
    }
}
