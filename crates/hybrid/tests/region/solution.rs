use std::sync::Arc;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::stress::{ElasticField, polar};
use stickslip_hybrid::region::Region;
use stickslip_hybrid::region::direct::unbalanced_forces;
use stickslip_hybrid::region::outline::{boundary_nodes, smooth_chains};
use stickslip_hybrid::region::outputs::{EdgeRows, displacement_rows};

use super::support::{body, sampled, sector, uniform, uniform_stress};

#[test]
fn a_uniform_strain_is_exact_on_every_kind_of_cell() {
    for kind in ElementKind::COMMON {
        // Straight-sided cells carry it exactly; curved isoparametric ones too.
        let body = body(sector([9, 5], kind).mesh().unwrap());
        let mesh = body.mesh();
        let region = Region::new(&body, &[]).unwrap();
        let solution = region
            .solve(&sampled(mesh, &boundary_nodes(mesh), uniform))
            .unwrap();
        for (node, u) in solution.displacements.chunks_exact(2).enumerate() {
            let exact = uniform(mesh.nodes()[node]);
            assert!(
                (0..2).all(|i| (u[i] - exact[i]).abs() < 1e-13),
                "{kind:?} {u:?} {exact:?}"
            );
        }
        let edge = EdgeRows::new(&body, "inner").unwrap();
        let stresses = solution.outputs(&edge.rows);
        for (k, stress) in stresses.chunks_exact(3).enumerate() {
            let exact = polar(uniform_stress(), edge.parameter[k] / 10.0);
            assert!(
                (0..3).all(|i| (stress[i] - exact[i]).abs() < 1e-9),
                "{kind:?} {stress:?} {exact:?}"
            );
        }
        let total = solution
            .reactions
            .chunks_exact(2)
            .fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
        assert!(total.iter().all(|f| f.abs() < 1e-8), "{total:?}");
        let every: Vec<usize> = (0..mesh.nodes().len()).collect();
        let forces = unbalanced_forces(&body, &sampled(mesh, &every, uniform)).unwrap();
        assert!(!forces.is_empty());
        assert!(forces.iter().all(|(_, f)| f[0].hypot(f[1]) < 1e-8));
    }
}

#[test]
fn edge_rows_are_the_extrapolated_stresses() {
    let body = body(sector([7, 4], ElementKind::Q8).mesh().unwrap());
    let mesh = body.mesh();
    let u: Vec<f64> = (0..2 * mesh.nodes().len())
        .map(|k| 1e-3 * ((k * k) as f64).sin())
        .collect();
    let material = body.materials()[0].as_ref();
    let materials = [material];
    let field = ElasticField::new(mesh, &materials, &u, None).unwrap();
    let nodal = field.nodal_stresses().averaged();
    for name in ["inner", "outer", "start", "end"] {
        let edge = EdgeRows::new(&body, name).unwrap();
        for (k, &node) in edge.nodes.iter().enumerate() {
            let [x, y] = edge.normal[k];
            let exact = polar(nodal[node], y.atan2(x));
            for (i, exact) in exact.into_iter().enumerate() {
                let found: f64 = edge.rows[3 * k + i]
                    .iter()
                    .map(|&(dof, w)| w * u[dof])
                    .sum();
                assert!(
                    (found - exact).abs() < 1e-9,
                    "{name} {node} {i}: {found} {exact}"
                );
            }
        }
    }
}

#[test]
fn forces_through_the_boundary_are_its_reactions() {
    let body = body(sector([24, 12], ElementKind::Q8).mesh().unwrap());
    let mesh = Arc::clone(body.mesh());
    let region = Region::new(&body, &[]).unwrap();
    let solution = region
        .solve(&sampled(&mesh, &boundary_nodes(&mesh), uniform))
        .unwrap();
    let [xx, yy, xy] = uniform_stress();
    // ∫ σ e_r ds over the inner arc, and the reactions of the whole boundary, which vanish.
    let (r, [a, b]) = (10.0_f64, [-0.9_f64, 1.2]);
    let normal = [r * (b.sin() - a.sin()), r * (a.cos() - b.cos())];
    let exact = [
        2.0 * (xx * normal[0] + xy * normal[1]),
        2.0 * (xy * normal[0] + yy * normal[1]),
    ];
    let found = solution.outputs(&EdgeRows::new(&body, "inner").unwrap().resultant(2.0));
    for i in 0..2 {
        // Three-node weights integrate the products of harmonics with an error of h⁴, h = 0.0875.
        assert!(
            (found[i] - exact[i]).abs() < 1e-5 * exact[0].abs(),
            "{found:?} {exact:?}"
        );
    }
    let all = solution.outputs(&region.reaction_resultant(&boundary_nodes(&mesh)));
    assert!(
        all.iter().all(|f| f.abs() < 1e-8 * exact[0].abs()),
        "{all:?}"
    );
}

#[test]
fn a_known_load_and_part_of_the_unknowns_prescribed() {
    // A bar pulled by a force at one end: y is prescribed nowhere but at one node, x on one end.
    use stickslip_fem_core::generate::{Generate, Rectangle};
    let rectangle = Rectangle::uniform([0.0, 4.0], [0.0, 1.0], [8, 2], ElementKind::Q8).unwrap();
    let body = body(rectangle.generate().unwrap());
    let mesh = body.mesh();
    let left = mesh.node_set("left").unwrap();
    let corner = *left
        .iter()
        .find(|&&node| mesh.nodes()[node][1] == 0.0)
        .unwrap();
    let dofs: Vec<usize> = left
        .iter()
        .map(|node| 2 * node)
        .chain([2 * corner + 1])
        .collect();
    let region = Region::with_dofs(&body, &dofs).unwrap();
    let right = &mesh.edge_set("right").unwrap().edges;
    let load = stickslip_fem_core::load::edge_load(mesh, right, 2.0, |_| [50.0, 0.0]);
    let measured = sampled(mesh, left, |_| [0.0, 0.0]);
    let solution = region.solve_loaded(&measured, &load).unwrap();
    for (u, [x, y]) in solution.displacements.chunks_exact(2).zip(mesh.nodes()) {
        let exact = [
            50.0 / super::support::YOUNG * x,
            -50.0 * 0.3 / super::support::YOUNG * y,
        ];
        assert!((0..2).all(|i| (u[i] - exact[i]).abs() < 1e-14));
    }
    let pull: f64 = region
        .prescribed()
        .iter()
        .zip(&solution.reactions)
        .filter(|(dof, _)| *dof % 2 == 0)
        .map(|(_, f)| f)
        .sum();
    assert!((pull + 100.0).abs() < 1e-10, "{pull}");
}

#[test]
fn places_are_found_and_chains_end_at_corners() {
    for kind in ElementKind::COMMON {
        let sector = sector([11, 6], kind);
        let mesh = sector.mesh().unwrap();
        let places: Vec<_> = (0..200)
            .map(|k| {
                let (f, g) = (f64::from(k % 20) / 19.0, f64::from(k / 20) / 9.0);
                let (theta, r) = (-0.89 + 2.08 * f, 10.1 + 9.7 * g);
                [3.0 + r * theta.cos(), -1.0 + r * theta.sin()]
            })
            .collect();
        let rows = displacement_rows(&mesh, &places).unwrap();
        for (rows, place) in rows.chunks_exact(2).zip(&places) {
            let exact = uniform(*place);
            for (row, exact) in rows.iter().zip(exact) {
                let found: f64 = row
                    .iter()
                    .map(|&(dof, n)| n * uniform(mesh.nodes()[dof / 2])[dof % 2])
                    .sum();
                assert!((found - exact).abs() < 1e-12, "{kind:?} {place:?}");
            }
        }
        assert!(displacement_rows(&mesh, &[[3.0, -1.0]]).is_err());
        assert_eq!(smooth_chains(&mesh).len(), 4);
        let ring = stickslip_hybrid::region::sector::ArcSector {
            angles: [0.0, std::f64::consts::TAU],
            cells: [24, 4],
            ..sector
        };
        let chains = smooth_chains(&ring.mesh().unwrap());
        assert_eq!(chains.len(), 2);
        assert!(
            chains
                .iter()
                .all(|chain| chain.closed && chain.nodes.len() == 24 * kind.order())
        );
    }
}
