//! Fields against the operators that they belong to, and against Hooke's law and the loads.

use std::f64::consts::PI;

use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{
    Isotropic, Material, Orthotropic, OrthotropicConstants, PlaneState, PlaneStiffness,
};
use stickslip_fem_core::nalgebra::DVector;
use stickslip_series::{
    Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, FarLoad, Field, Hole, Nodes, Outline,
    Plate, SeriesError,
};

const CIRCLE: Circle = Circle {
    centre: [0.3, 0.0],
    radius: 2.0,
    thickness: 0.5,
};

fn material() -> Isotropic {
    Isotropic::new(3.0, 0.25, PlaneState::Strain).unwrap()
}

fn node_sets() -> Vec<Nodes> {
    let graded = vec![0.0, 0.001, 0.01, 0.1, 0.4, 0.9, 1.5, 2.1, 2.5, 2.9, PI];
    vec![
        Nodes::uniform_half(13).unwrap(),
        Nodes::mirrored(graded.clone()).unwrap(),
        Nodes::uniform_circle(16).unwrap(),
        Nodes::arc(graded).unwrap(),
    ]
}

/// Forces on the nodes by tractions that jump from node to node, without those that symmetry takes up.
fn forces(nodes: &Nodes) -> DVector<f64> {
    let weights = nodes.weights();
    let traction = |row: usize| ((row * row + 3) % 7) as f64 - 2.5;
    let mut forces = DVector::from_fn(2 * nodes.len(), |row, _| weights[row / 2] * traction(row));
    if nodes.is_mirrored() {
        for (k, angle) in nodes.angles().iter().enumerate() {
            if [0.0, PI].contains(angle) {
                forces[2 * k + 1] = 0.0;
            }
        }
    }
    forces
}

/// A body, its field and the displacements of its nodes by the operator, under forces that balance its loads.
struct Case {
    nodes: Nodes,
    field: Field,
    expected: DVector<f64>,
    stiffness: PlaneStiffness,
    /// Traction that may be left on the outer edge.
    left: f64,
}

fn case(
    operator: &dyn InterfaceOperator,
    nodes: &Nodes,
    mut forces: DVector<f64>,
    field: impl Fn(&BodyLoad<'_>) -> Field,
) -> Case {
    let multiplier = 0.7;
    let modes = operator.modes();
    let motions = DVector::from_fn(modes.ncols(), |row, _| 0.3 - row as f64);
    if modes.ncols() > 0 {
        let wanted = operator.mode_load(0) * multiplier + modes.transpose() * &forces;
        let gram = (modes.transpose() * modes).try_inverse().unwrap();
        forces -= modes * (gram * wanted);
    }
    let mut expected = operator.compliance().unwrap() * &forces + modes * &motions;
    if let Some(response) = operator.load_response(0) {
        expected += response * multiplier;
    }
    let state = BodyLoad {
        forces: forces.as_slice(),
        multipliers: &[multiplier],
        motions: motions.as_slice(),
    };
    Case {
        nodes: nodes.clone(),
        field: field(&state),
        expected,
        stiffness: material().stiffness(),
        left: 2e-4,
    }
}

fn holes() -> Vec<Case> {
    let mut found = Vec::new();
    for nodes in node_sets() {
        let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        let far = FarLoad {
            force: [3.0, 2.0 * skew],
            moment: 1.5 * skew,
            stress: [1.0, -0.4, 0.3 * skew],
        };
        let hole = Hole::floating(nodes.clone(), &material(), CIRCLE, &[far]).unwrap();
        found.push(case(&hole, &nodes, forces(&nodes), |state| {
            hole.field(state).unwrap()
        }));
    }
    found
}

fn disks() -> Vec<Case> {
    let mut found = Vec::new();
    for nodes in node_sets() {
        let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        for anchor in [Anchor::Area, Anchor::default()] {
            let load = DiskLoad {
                force: [3.0, 2.0 * skew],
                moment: 1.5 * skew,
                ..DiskLoad::default()
            };
            let disk = Disk::floating(nodes.clone(), &material(), CIRCLE, anchor, &[load]).unwrap();
            found.push(case(&disk, &nodes, forces(&nodes), |state| {
                disk.field(state).unwrap()
            }));
            let moved = DiskLoad {
                displacement: [0.2, 0.1 * skew],
                ..DiskLoad::default()
            };
            let disk = Disk::held(nodes.clone(), &material(), CIRCLE, anchor, &[moved]).unwrap();
            found.push(case(&disk, &nodes, forces(&nodes), |state| {
                disk.field(state).unwrap()
            }));
        }
    }
    found
}

fn outline() -> Outline {
    Outline::new(vec![[-5.0, -4.0], [7.0, -4.0], [7.0, 4.0], [-5.0, 4.0]])
}

fn edge_loads(nodes: &Nodes) -> Vec<EdgeLoad> {
    let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
    vec![
        EdgeLoad {
            edge: 1,
            force: [3.0, 2.0 * skew],
        },
        EdgeLoad {
            edge: 2,
            force: [skew, -1.0],
        },
        EdgeLoad {
            edge: 0,
            force: [0.0, 1.0],
        },
    ]
}

fn plates() -> Vec<Case> {
    let accuracy = Accuracy {
        tolerance: 1e-4,
        degree: 80,
    };
    let mut found = Vec::new();
    for nodes in node_sets() {
        let loads = [edge_loads(&nodes)];
        let plate = Plate::new(
            nodes.clone(),
            &material(),
            CIRCLE,
            &outline(),
            &loads,
            accuracy,
        )
        .unwrap();
        found.push(case(&plate, &nodes, forces(&nodes), |state| {
            plate.field(state).unwrap()
        }));
    }
    found
}

/// A unidirectional layer along x, one along y, a (±45)s laminate, whose roots are images of each other, and a layer aside.
fn anisotropic() -> Vec<Box<dyn Material>> {
    let layer = OrthotropicConstants {
        e1: 14.0,
        e2: 1.0,
        g12: 0.6,
        nu12: 0.3,
    };
    let stiff_in_shear = OrthotropicConstants {
        e1: 2.0,
        e2: 2.0,
        g12: 3.5,
        nu12: 0.7,
    };
    [
        (layer, 0.0),
        (layer, 0.5 * PI),
        (stiff_in_shear, 0.0),
        (layer, 0.6),
    ]
    .map(|(constants, angle)| {
        Box::new(Orthotropic::new(constants, angle).unwrap()) as Box<dyn Material>
    })
    .into()
}

fn anisotropic_plates() -> Vec<Case> {
    let accuracy = Accuracy {
        tolerance: 1e-4,
        degree: 100,
    };
    let mut found = Vec::new();
    for nodes in node_sets() {
        for material in anisotropic() {
            if nodes.is_mirrored() && !material.symmetric_about_x() {
                continue;
            }
            let loads = [edge_loads(&nodes)];
            let plate = Plate::anisotropic(
                nodes.clone(),
                material.as_ref(),
                CIRCLE,
                &outline(),
                &loads,
                accuracy,
            )
            .unwrap();
            // At most 2e-2 of the mean traction.
            assert!(plate.fit().residual < 2e-2, "{:?}", plate.fit());
            found.push(Case {
                stiffness: material.stiffness(),
                left: 1e-3,
                ..case(&plate, &nodes, forces(&nodes), |state| {
                    plate.field(state).unwrap()
                })
            });
        }
    }
    found
}

fn at(theta: f64, ratio: f64) -> [f64; 2] {
    let [x, y] = CIRCLE.centre;
    [
        x + ratio * CIRCLE.radius * theta.cos(),
        y + ratio * CIRCLE.radius * theta.sin(),
    ]
}

/// Means over hats of the field on the edge are the displacements of the nodes.
fn agrees_with_the_operator(cases: &[Case], tolerance: f64) {
    for Case {
        nodes,
        field,
        expected,
        ..
    } in cases
    {
        let means = [0, 1]
            .map(|axis| nodes.mean(|theta| field.displacement(at(theta, 1.0)).unwrap()[axis]));
        for (node, angle) in nodes.angles().iter().enumerate() {
            for axis in 0..2 {
                let on_axis = nodes.is_mirrored() && axis == 1 && [0.0, PI].contains(angle);
                let error = (means[axis][node] - expected[2 * node + axis]).abs();
                assert!(
                    on_axis || error < tolerance * expected.amax(),
                    "{node} {axis} {error:e} {}",
                    expected.amax()
                );
            }
        }
    }
}

#[test]
fn edges_move_as_the_operators_say() {
    // Gauss's rule of 8 points on each element, with s² ln s at its ends, s ln s where a traction jumps.
    agrees_with_the_operator(&holes(), 3e-5);
    agrees_with_the_operator(&disks(), 3e-5);
    agrees_with_the_operator(&plates(), 3e-5);
    agrees_with_the_operator(&anisotropic_plates(), 3e-5);
}

/// Stresses are Hooke's law of central differences of displacements, and go over into those of the edge.
fn obeys_hooke(cases: &[Case], ratios: &[f64]) {
    for Case {
        field, stiffness, ..
    } in cases
    {
        for &ratio in ratios {
            let step = 1e-3 * CIRCLE.radius * ratio.min((ratio - 1.0).abs()).min(1.0);
            for theta in [0.05, 1.0, 2.3, 3.5, 5.9] {
                let [x, y] = at(theta, ratio);
                let u = |dx: f64, dy: f64| field.displacement([x + dx, y + dy]).unwrap();
                let [east, west, north, south] =
                    [u(step, 0.0), u(-step, 0.0), u(0.0, step), u(0.0, -step)];
                let slope =
                    |a: [f64; 2], b: [f64; 2], axis: usize| (a[axis] - b[axis]) / (2.0 * step);
                let strain = [
                    slope(east, west, 0),
                    slope(north, south, 1),
                    slope(east, west, 1) + slope(north, south, 0),
                ];
                let [xx, yy, xy] =
                    stiffness.map(|row| (0..3).map(|k| row[k] * strain[k]).sum::<f64>());
                let (sin, cos) = theta.sin_cos();
                let found = field.stress([x, y]).unwrap();
                let expected = [
                    xx * cos * cos + yy * sin * sin + 2.0 * xy * sin * cos,
                    xx * sin * sin + yy * cos * cos - 2.0 * xy * sin * cos,
                    (yy - xx) * sin * cos + xy * (cos * cos - sin * sin),
                ];
                let size = expected.iter().fold(1.0, |size: f64, s| size.max(s.abs()));
                for (found, expected) in
                    [found.radial, found.hoop, found.shear].iter().zip(expected)
                {
                    // Differences err by the square of the step over the distance to the edge or to the centre, and by rounding.
                    assert!(
                        (found - expected).abs() < 2e-5 * size,
                        "{ratio} {theta} {found} {expected}"
                    );
                }
            }
        }
    }
}

#[test]
fn stresses_are_those_of_the_displacements() {
    obeys_hooke(&holes(), &[1.05, 1.7, 30.0]);
    obeys_hooke(&disks(), &[0.01, 0.1, 0.49, 0.51, 0.8, 0.95]);
    obeys_hooke(&plates(), &[1.05, 1.5, 1.9]);
    obeys_hooke(&anisotropic_plates(), &[1.05, 1.5, 1.9]);
}

#[test]
fn stresses_inside_go_over_into_those_of_the_edge() {
    for (cases, side) in [
        (holes(), 1.0),
        (disks(), -1.0),
        (plates(), 1.0),
        (anisotropic_plates(), 1.0),
    ] {
        for Case { field, .. } in cases {
            for theta in [0.05, 1.0, 2.3, 3.5, 5.9] {
                let edge = field.edge(theta);
                let near = field.stress(at(theta, 1.0 + side * 1e-9)).unwrap();
                let size = edge.hoop.abs() + edge.radial.abs() + 1.0;
                for (a, b) in [
                    (edge.hoop, near.hoop),
                    (edge.radial, near.radial),
                    (edge.shear, near.shear),
                ] {
                    assert!((a - b).abs() < 2e-5 * size, "{theta} {edge:?} {near:?}");
                }
            }
        }
    }
}

#[test]
fn outer_edges_carry_their_loads() {
    let all = plates().into_iter().chain(anisotropic_plates());
    for Case {
        nodes, field, left, ..
    } in all
    {
        let lengths = [12.0, 8.0, 12.0, 8.0];
        let edges: [fn(f64) -> [f64; 2]; 4] = [
            |t| [-5.0 + 12.0 * t, -4.0],
            |t| [7.0, -4.0 + 8.0 * t],
            |t| [7.0 - 12.0 * t, 4.0],
            |t| [-5.0, 4.0 - 8.0 * t],
        ];
        for (edge, place) in edges.iter().enumerate() {
            let normal = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]][edge];
            let force = edge_loads(&nodes)
                .into_iter()
                .find(|load| load.edge == edge);
            let force = force.map_or([0.0; 2], |load| load.force);
            for t in [0.1, 0.33, 0.5, 0.8] {
                let [x, y] = place(t);
                let theta = (y - CIRCLE.centre[1]).atan2(x - CIRCLE.centre[0]);
                let s = field.stress([x, y]).unwrap();
                // Traction in the polar frame, then along x and y.
                let (sin, cos) = theta.sin_cos();
                let [nr, nt] = [
                    normal[0] * cos + normal[1] * sin,
                    normal[1] * cos - normal[0] * sin,
                ];
                let [tr, tt] = [s.radial * nr + s.shear * nt, s.shear * nr + s.hoop * nt];
                let traction = [tr * cos - tt * sin, tr * sin + tt * cos];
                for axis in 0..2 {
                    let expected = 0.7 * force[axis] / (lengths[edge] * CIRCLE.thickness);
                    let error = (traction[axis] - expected).abs();
                    assert!(
                        error < left,
                        "{edge} {t} {axis}: {} {expected}",
                        traction[axis]
                    );
                }
            }
        }
    }
}

#[test]
fn states_and_points_that_do_not_fit_are_refused() {
    let nodes = Nodes::uniform_half(9).unwrap();
    let disk = Disk::held(nodes.clone(), &material(), CIRCLE, Anchor::Area, &[]).unwrap();
    let state = BodyLoad {
        forces: &[0.0; 18],
        multipliers: &[1.0],
        motions: &[],
    };
    assert_eq!(
        disk.field(&state).unwrap_err().to_string(),
        "1 multipliers of a body that has 0"
    );
    let state = BodyLoad {
        forces: &[0.0; 18],
        multipliers: &[],
        motions: &[],
    };
    let field = disk.field(&state).unwrap();
    assert_eq!(
        field.stress([0.0, 5.0]).unwrap_err().to_string(),
        "the point (0, 5) is outside of the body"
    );
    let plate = Plate::new(
        nodes,
        &material(),
        CIRCLE,
        &outline(),
        &[],
        Accuracy::default(),
    )
    .unwrap();
    let state = BodyLoad {
        forces: &[0.0; 18],
        multipliers: &[],
        motions: &[0.0],
    };
    let field = plate.field(&state).unwrap();
    assert!(field.displacement([0.3, 0.0]).is_err());
    assert!(field.displacement([7.1, 0.0]).is_err());
    assert!(field.displacement([6.9, 3.9]).is_ok());
}

#[test]
fn stress_and_displacement_together_are_those_alone() {
    for (cases, ratios) in [
        (holes(), [1.0, 1.01, 1.7]),
        (disks(), [1.0, 0.97, 0.3]),
        (plates(), [1.0, 1.05, 1.9]),
        (anisotropic_plates(), [1.0, 1.05, 1.9]),
    ] {
        for Case { field, .. } in cases {
            for ratio in ratios {
                let point = at(2.3, ratio);
                let both = (
                    field.stress(point).unwrap(),
                    field.displacement(point).unwrap(),
                );
                assert_eq!(field.at(point).unwrap(), both);
            }
        }
    }
}

/// A uniform strain moves nodes as its field moves them, about the centre of the circle, and makes no stress.
#[test]
fn a_strain_that_nothing_hinders_makes_no_stress() {
    let strain = [2e-3, -1e-3, 4e-4];
    let nodes = Nodes::uniform_circle(16).unwrap();
    let outline = Outline::strip(5.0, 7.0, 6.0);
    let disk = Disk::floating(
        nodes.clone(),
        &material(),
        CIRCLE,
        Anchor::Area,
        &[DiskLoad::default()],
    );
    let disk = disk.unwrap().with_expansions(&[strain]).unwrap();
    let accuracy = Accuracy::default();
    let plate = Plate::new(
        nodes.clone(),
        &material(),
        CIRCLE,
        &outline,
        &[vec![]],
        accuracy,
    );
    let plate = plate.unwrap().with_expansions(&[strain]).unwrap();
    let (none, still) = (vec![0.0; 32], [0.0; 3]);
    let state = BodyLoad {
        forces: &none,
        multipliers: &[-2.0],
        motions: &still,
    };
    let bodies: [(&dyn InterfaceOperator, Field); 2] = [
        (&disk, disk.field(&state).unwrap()),
        (&plate, plate.field(&state).unwrap()),
    ];
    for (body, field) in bodies {
        let moved = body.displacements(&none, &still, &[-2.0]);
        let expected = |[px, py]: [f64; 2]| {
            let [x, y] = [px - CIRCLE.centre[0], py - CIRCLE.centre[1]];
            [-2.0 * (2e-3 * x + 2e-4 * y), -2.0 * (2e-4 * x - 1e-3 * y)]
        };
        let close = |found: [f64; 2], expected: [f64; 2]| {
            let apart = [0, 1].map(|axis| (found[axis] - expected[axis]).abs());
            assert!(apart[0].max(apart[1]) < 1e-14, "{found:?} {expected:?}");
        };
        for (k, (point, angle)) in body.points().iter().zip(nodes.angles()).enumerate() {
            close([moved[2 * k], moved[2 * k + 1]], expected(*point));
            let [cx, cy] = CIRCLE.centre;
            let place = [cx + 2.0 * angle.cos(), cy + 2.0 * angle.sin()];
            close(field.displacement(place).unwrap(), expected(place));
            let stress = field.stress(place).unwrap();
            assert!(
                stress.hoop.abs().max(stress.radial.abs()) < 1e-12,
                "{stress:?}"
            );
        }
    }
    let of = |strains: &[[f64; 3]], nodes: Nodes| {
        let loads = [DiskLoad::default()];
        let disk = Disk::floating(nodes, &material(), CIRCLE, Anchor::Area, &loads).unwrap();
        disk.with_expansions(strains).map(|_| ())
    };
    assert!(matches!(
        of(&[], nodes.clone()),
        Err(SeriesError::State { .. })
    ));
    let infinite = [[f64::INFINITY, 0.0, 0.0]];
    assert!(matches!(
        of(&infinite, nodes),
        Err(SeriesError::LoadNotFinite { .. })
    ));
    let half = Nodes::uniform_half(13).unwrap();
    assert!(matches!(
        of(&[strain], half),
        Err(SeriesError::NotSymmetric { .. })
    ));
}
