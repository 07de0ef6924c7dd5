//! Results that no run made: three steps up and one down, on a half circle and on a line, with simple closed-form quantities.

use std::sync::Arc;

use stickslip::results::{
    BearingSource, BodyFields, BodySummary, Choice, ContactFrame, EdgeGeometry, EdgeKind,
    EdgeResults, EdgeRow, Finding, LoadValue, Problem, Results, StepNotes, StepResults,
};
use stickslip::scene::schema::DisplayUnits;
use stickslip::units::{Dimension, Unit};
use stickslip_contact::Status;
use stickslip_contact::history::{Cycle, Difference, FailedAttempts, Otherwise, Recovery};
use stickslip_contact::solver::{Residuals, Work};
use stickslip_contact::zones::{Zone, mirrored};
use stickslip_fem_core::generate::{
    Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

/// Hole radius [mm].
pub(crate) const RADIUS: f64 = 10.0;
/// Plate thickness [mm].
pub(crate) const THICKNESS: f64 = 2.0;
/// Loads of the steps [N].
pub(crate) const LOADS: [f64; 4] = [1000.0, 2000.0, 4000.0, 1500.0];

/// Results with a half circle "pin", a line contact "roller" and a line without contact "plate.left".
pub(crate) fn results() -> Results {
    let mesh = Arc::new(plate());
    let edges = vec![circle(), line("roller", true), line("plate.left", false)];
    let steps = (0..LOADS.len())
        .map(|index| step(index, &edges, &mesh))
        .collect();
    Results {
        title: "A <plate> & its pin".into(),
        source: "plate.toml".into(),
        scene_hash: "0123abcd".into(),
        scene: "version = 1\n".into(),
        problem: Problem::default(),
        meshes: false,
        units: units("in", "lbf", "psi"),
        choices: vec![Choice {
            what: "model".into(),
            value: "half".into(),
            reason: "all is symmetric".into(),
        }],
        blocks: None,
        findings: vec![Finding::PointsInDoubt {
            steps: vec![3],
            points: 1,
        }],
        bodies: vec![
            BodySummary {
                name: "pin".into(),
                mesh: None,
                dofs: 0,
                factor_entries: 0,
                free_motions: 0,
                yield_stress: None,
            },
            BodySummary {
                name: "plate".into(),
                dofs: 2 * mesh.nodes().len(),
                factor_entries: 1234,
                free_motions: 1,
                yield_stress: None,
                mesh: Some(mesh),
            },
        ],
        factorisations: 1,
        edges,
        sets: Vec::new(),
        parts: Vec::new(),
        fasteners: Vec::new(),
        steps,
        failure: Vec::new(),
        phases: vec![("mesh", 0.25), ("contact", 0.5)],
        ladder: None,
    }
}

/// One step of a whole hole without contact.
pub(crate) fn open_hole() -> Results {
    let mut results = results();
    let mut edge = circle();
    edge.name = "plate.hole".into();
    edge.contact = false;
    edge.law = String::new();
    edge.frame = ContactFrame::NONE;
    edge.half = false;
    // A closed walk from −π: its last node lies one interval before +π.
    edge.parameter = (0..72)
        .map(|k| (f64::from(k) * 5.0 - 180.0).to_radians())
        .collect();
    edge.corner = vec![true; 72];
    let mut step = results.steps.swap_remove(0);
    step.edges = vec![edge_step(&edge, 0)];
    results.edges = vec![edge];
    results.steps = vec![step];
    results
}

pub(crate) fn units(length: &str, force: &str, stress: &str) -> DisplayUnits {
    DisplayUnits {
        length: Unit::named(length, Dimension::Length).unwrap(),
        force: Unit::named(force, Dimension::Force).unwrap(),
        stress: Unit::named(stress, Dimension::Stress).unwrap(),
    }
}

fn plate() -> Mesh {
    PlateWithHole {
        hole_radius: RADIUS,
        outline: Outline::Ring {
            outer_radius: 4.0 * RADIUS,
        },
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, 12),
        layers: 4,
        growth: Growth::Geometric { aspect: 1.0 },
        far_cells: 1,
        kind: ElementKind::Q8,
    }
    .generate()
    .unwrap()
}

fn circle() -> EdgeGeometry {
    EdgeGeometry {
        name: "pin".into(),
        contact: true,
        body: 1,
        kind: EdgeKind::Circle {
            centre: [0.0, 0.0],
            radius: RADIUS,
        },
        parameter: (0..=36)
            .map(|k| (f64::from(k) * 5.0).to_radians())
            .collect(),
        corner: (0..=36).map(|k| k % 2 == 0).collect(),
        half: true,
        clearance: Some(0.01 * RADIUS),
        bearing_area: Some(2.0 * RADIUS * THICKNESS),
        law: "static_dynamic".into(),
        frame: bears_at_zero(),
        second: None,
    }
}

fn line(name: &str, contact: bool) -> EdgeGeometry {
    EdgeGeometry {
        name: name.into(),
        contact,
        body: 1,
        kind: EdgeKind::Line,
        parameter: (-20..=20).map(|k| f64::from(k) * 0.25).collect(),
        corner: vec![true; 41],
        half: false,
        clearance: None,
        bearing_area: None,
        law: if contact {
            "coulomb".into()
        } else {
            String::new()
        },
        frame: if contact {
            bears_at_zero()
        } else {
            ContactFrame::NONE
        },
        second: None,
    }
}

/// Contact is largest in the third step.
fn bears_at_zero() -> ContactFrame {
    ContactFrame {
        bearing: Some(0.0),
        found: BearingSource::Contact { step: 2 },
        clockwise: false,
    }
}

fn step(index: usize, edges: &[EdgeGeometry], mesh: &Mesh) -> StepResults {
    let unloading = index == LOADS.len() - 1;
    let load = |name: &str, value: f64, unit: &str| LoadValue {
        name: name.into(),
        value,
        unit: unit.into(),
    };
    let lbf = units("in", "lbf", "psi").force;
    StepResults {
        loads: vec![
            load("pull", lbf.from_base(LOADS[index]), "lbf"),
            load("cool, slowly", -50.0, "K"),
        ],
        unloading,
        edges: edges.iter().map(|edge| edge_step(edge, index)).collect(),
        sets: Vec::new(),
        set_errors: Vec::new(),
        fasteners: Vec::new(),
        work: Work {
            solves: 3 + index,
            ..Work::default()
        },
        solvers: vec!["status iteration"],
        increments: 1,
        cutbacks: 0,
        doubtful: usize::from(index == 2),
        notes: if index == 2 {
            notes()
        } else {
            StepNotes::default()
        },
        residuals: Residuals {
            complementarity: 1e-14,
            cone: 2e-15,
            balance: 3e-16,
        },
        balance_residual: 4e-13,
        balance: Vec::new(),
        dissipation: 0.5,
        fields: if unloading {
            vec![fields(mesh)]
        } else {
            Vec::new()
        },
        stresses: Vec::new(),
        seconds: 0.001,
    }
}

/// A cycle of one point at (25.4, 0) mm, three solutions, and friction beyond the estimate.
fn notes() -> StepNotes {
    let (solver, period) = ("semismooth Newton", 2);
    StepNotes {
        recovery: Recovery {
            failures: vec![FailedAttempts {
                solver,
                kind: "cycled",
                count: 4,
            }],
            first_cycle: Some(Cycle {
                solver,
                period,
                points: vec![3],
            }),
        },
        cycle_places: vec![[25.4, 0.0]],
        solutions: Some(3),
        otherwise: Otherwise {
            other_solver: Some(Difference {
                solver: "pivoting",
                increments: 1,
                peak_pressure: -0.01,
                traction: 0.02,
                slip: 0.01,
                dissipation: -0.03,
                work: 0.5,
            }),
            finer: None,
            path: None,
            path_missing: None,
            missing: None,
        },
        friction: 0.5,
        uniqueness: Some(0.4),
    }
}

/// u = (10⁻³ x, 0) and uniaxial tension of 100 MPa.
fn fields(mesh: &Mesh) -> BodyFields {
    BodyFields {
        body: 1,
        displacement: mesh
            .nodes()
            .iter()
            .flat_map(|node| [1e-3 * node[0], 0.0])
            .collect(),
        stress: vec![[100.0, 0.0, 0.0]; mesh.nodes().len()],
        thickness_stress: vec![0.0; mesh.nodes().len()],
    }
}

/// Half-extent of contact in a step: 80° or 2 mm at the largest load, as its root below.
pub(crate) fn contact_half(edge: &EdgeGeometry, step: usize) -> f64 {
    let share = (LOADS[step] / LOADS[2]).sqrt();
    share
        * if matches!(edge.kind, EdgeKind::Line) {
            2.0
        } else {
            80_f64.to_radians()
        }
}

/// Elliptic pressure with 100 MPa at the largest load; the inner half sticks, the outer half slips at 0.2 p.
fn edge_step(edge: &EdgeGeometry, step: usize) -> EdgeResults {
    let half = contact_half(edge, step);
    let sign = if step == LOADS.len() - 1 { 1.0 } else { -1.0 };
    let row = |&place: &f64| {
        let inside = edge.contact && place.abs() < half;
        let pressure = if inside {
            100.0 * (half * half - place * place).sqrt() / half
        } else {
            0.0
        };
        let shear = 0.2 * sign * pressure * (2.0 * place / half).clamp(-1.0, 1.0);
        EdgeRow {
            pressure,
            shear,
            gap: if inside {
                0.0
            } else {
                1e-3 * (place.abs() - half).abs()
            },
            slip: -1e-5 * sign * place,
            status: status(edge, place, half, sign),
            sigma_normal: -pressure,
            sigma_tangential: 150.0 * place.sin().powi(2) - 20.0,
            tau: -shear,
        }
    };
    let rows: Vec<EdgeRow> = edge.parameter.iter().map(row).collect();
    let touching = edge.contact.then_some(half);
    // What is added to the results of an edge is none of this fixture's business.
    #[allow(clippy::needless_update)]
    let results = EdgeResults {
        zones: zones(edge, &rows),
        bearing: edge.contact.then_some(0.0),
        contact_half_extent: touching,
        stick_half_extent: touching.map(|half| half / 2.0),
        peak_pressure: touching.map(|_| (100.0, 0.0)),
        peak_hoop_uncertainty: Some(2.0),
        peak_hoop: Some((130.0, edge.parameter[edge.parameter.len() / 2])),
        hoop_at_bearing_point: Some(-20.0),
        resultant: if edge.contact {
            [LOADS[step], 0.0]
        } else {
            [0.0; 2]
        },
        friction_force: if edge.contact { 100.0 } else { 0.0 },
        normal_force: if edge.contact { LOADS[step] } else { 0.0 },
        rows,
        ..EdgeResults::default()
    };
    let slip = edge.contact.then(|| results.lengths_of_slip(edge));
    EdgeResults {
        slip_lengths: slip.flatten(),
        ..results
    }
}

fn status(edge: &EdgeGeometry, place: f64, half: f64, sign: f64) -> Status {
    if !edge.contact || place.abs() >= half {
        Status::Open
    } else if place.abs() <= half / 2.0 {
        Status::Stick
    } else {
        Status::slip_along(-sign * place)
    }
}

/// Zones of the whole edge: those of its half at places ≥ 0, and their mirror images.
fn zones(edge: &EdgeGeometry, rows: &[EdgeRow]) -> Vec<Zone> {
    let places = edge.parameter.iter().zip(rows);
    let own = places.filter(|(place, _)| edge.contact && **place >= 0.0);
    let mut zones: Vec<Zone> = Vec::new();
    for (&place, row) in own {
        match zones.last_mut() {
            Some(last) if last.status == row.status => last.end = place,
            Some(last) => {
                let start = last.end;
                zones.push(Zone {
                    status: row.status,
                    start,
                    end: place,
                });
            }
            None => zones.push(Zone {
                status: row.status,
                start: place,
                end: place,
            }),
        }
    }
    mirrored(&zones, edge.closed())
}
