//! The report's sensitivity study rerun: how errors of the measured displacements show in the stresses at the contact edge.
//!
//! Post & Reddy, *Friction Phenomenon in Contact Stress Problems* (1988), part I, 4.2 and Figs 14–19: aluminium with
//! E = 10.2e6 psi and ν = 0.34, 2400 lines/mm, so that a quarter of a fringe is 1e-4 mm. Lengths here are mm, stresses ksi.

use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::Region;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::sector::ArcSector;

/// Radius of the hole, 0.375 in.
const RADIUS: f64 = 9.525;
/// Half the angle of the sector.
const HALF: f64 = std::f64::consts::FRAC_PI_3;
/// A quarter of a fringe.
const QUARTER: f64 = 1e-4;

struct Case {
    region: Region,
    edge: EdgeRows,
    /// Boundary displacements of the force-driven analysis.
    boundary: NodalDisplacements,
    /// Edge stresses of the force-driven analysis.
    truth: Vec<f64>,
    forces: Vec<f64>,
}

/// A sector pressed by σ_r = −30 ksi cos² and sheared by a peak of `shear` ksi at its inner edge, held at the outer one, with
/// cells of about `size` mm at the inner edge.
fn case(size: f64, shear: f64) -> Case {
    let around = (2.0 * HALF * RADIUS / size).round() as usize;
    let sector = ArcSector {
        centre: [0.0, 0.0],
        hole: RADIUS,
        stand_off: 0.0,
        outer: 2.0 * RADIUS,
        angles: [-HALF, HALF],
        cells: [around, (around / 2).max(3)],
        growth: 2.0,
        kind: ElementKind::Q8,
    };
    let mesh = Arc::new(sector.mesh().unwrap());
    let aluminium = Isotropic::new(10.2e3, 0.34, PlaneState::Stress).unwrap();
    let materials: Vec<Arc<dyn Material>> = vec![Arc::new(aluminium)];
    let body = Arc::new(ElasticBody::new(Arc::clone(&mesh), materials, 1.524).unwrap());
    let inner = &mesh.edge_set("inner").unwrap().edges;
    let forces = edge_load(&mesh, inner, 1.524, |point| {
        let theta = point.position[1].atan2(point.position[0]);
        let (s, c) = theta.sin_cos();
        let pressure = 30.0 * (1.5 * theta).cos().powi(2);
        let tau = shear * (3.0 * theta).sin();
        // Traction on the inner edge, n = −e_r: −σ_r e_r − τ_rθ e_θ.
        [pressure * c + tau * s, pressure * s - tau * c]
    });
    let held = |direction| Support {
        nodes: mesh.node_set("outer").unwrap().to_vec(),
        direction,
        displacement: 0.0,
    };
    let driven = ElasticBody::clone(&body)
        .with_supports([held(HeldDirection::X), held(HeldDirection::Y)])
        .with_load_cases(vec![LoadCase {
            forces: forces.clone(),
            ..LoadCase::default()
        }])
        .unwrap();
    let u = Arc::new(driven)
        .condense(&[])
        .unwrap()
        .displacements(&[], &[1.0], &[]);
    let region = Region::new(&body, &[]).unwrap();
    let edge = EdgeRows::new(&body, "inner").unwrap();
    let nodes = region.prescribed_nodes();
    let boundary = NodalDisplacements {
        values: nodes
            .iter()
            .flat_map(|&node| [u[2 * node], u[2 * node + 1]])
            .collect(),
        nodes,
        covariance: Vec::new(),
    };
    let truth = (edge.rows.iter())
        .map(|row| row.iter().map(|&(dof, weight)| weight * u[dof]).sum())
        .collect();
    Case {
        region,
        edge,
        boundary,
        truth,
        forces,
    }
}

/// Errors of the edge stresses in `count` draws of uniform displacement errors up to `amplitude`.
fn errors(case: &Case, amplitude: f64, count: usize) -> Vec<Vec<f64>> {
    let mut random = StdRng::seed_from_u64(1988);
    let draws: Vec<f64> = (0..count)
        .flat_map(|_| case.boundary.values.clone())
        .map(|value| value + random.random_range(-amplitude..=amplitude))
        .collect();
    let found = case.region.outputs_of(&case.edge.rows, &draws).unwrap();
    found
        .chunks_exact(case.truth.len())
        .map(|state| state.iter().zip(&case.truth).map(|(a, b)| a - b).collect())
        .collect()
}

/// Root mean square of radial, hoop and shear error over the draws and over the nodes farther than two cells from the sector's ends.
fn rms(errors: &[Vec<f64>]) -> [f64; 3] {
    let nodes = errors[0].len() / 3;
    [0, 1, 2].map(|component| {
        let inside = errors
            .iter()
            .flat_map(|e| (4..nodes - 4).map(move |k| e[3 * k + component]));
        let (sum, count) = inside.fold((0.0, 0.0), |(sum, count), e| (sum + e * e, count + 1.0));
        (sum / count).sqrt()
    })
}

/// Largest magnitude of a component.
fn peak(stresses: &[f64], component: usize) -> f64 {
    let values = stresses.iter().skip(component).step_by(3);
    values.fold(0.0, |most, value| value.abs().max(most))
}

#[test]
fn displacement_driven_is_force_driven() {
    let case = case(1.0, 5.0);
    let solution = case.region.solve(&case.boundary).unwrap();
    let stresses = solution.outputs(&case.edge.rows);
    let scale = peak(&case.truth, 0);
    let worst = (stresses.iter().zip(&case.truth))
        .map(|(a, b)| (a - b).abs() / scale)
        .fold(0.0, f64::max);
    let force = case
        .forces
        .iter()
        .fold(0.0_f64, |most, f| f.abs().max(most));
    let edge = case.region.mesh().node_set("inner").unwrap();
    let off = (case.region.prescribed().iter().zip(&solution.reactions))
        .filter(|(dof, _)| {
            let [x, y] = case.region.mesh().nodes()[**dof / 2];
            // Where inner and outer edge end, nothing but the load acts; the outer edge carries its reactions.
            edge.contains(&(**dof / 2)) || x.hypot(y) < 1.99 * RADIUS
        })
        .map(|(&dof, reaction)| (reaction - case.forces[dof]).abs() / force)
        .fold(0.0, f64::max);
    println!("force-driven against displacement-driven: stresses {worst:.1e}, forces {off:.1e}");
    assert!(worst < 1e-9 && off < 1e-9);
}

#[test]
fn quarter_fringe_errors_leave_a_shear_of_5_ksi_clear_and_one_of_1_ksi_visible() {
    println!("shear error in ksi by uniform errors of ±1/4 fringe; inner cells in mm");
    println!(
        "{:>6} {:>8} {:>8} {:>8} {:>8}",
        "cell", "radial", "hoop", "shear", "× cell"
    );
    let mut products = Vec::new();
    for size in [2.0, 1.5, 0.75, 0.5] {
        let case = case(size, 1.0);
        let around = (case.edge.nodes.len() - 1) / 2;
        let h = 2.0 * HALF * RADIUS / around as f64;
        let [radial, hoop, shear] = rms(&errors(&case, QUARTER, 200));
        println!(
            "{h:6.3} {radial:8.3} {hoop:8.3} {shear:8.3} {:8.3}",
            shear * h
        );
        products.push(shear * h);
    }
    // Noise goes as 1/h: a difference quotient of errors that do not depend on h.
    let (low, high) = (
        products.iter().copied().fold(f64::INFINITY, f64::min),
        products.iter().copied().fold(0.0, f64::max),
    );
    assert!(high < 1.25 * low, "{products:?}");
    // The report's 0.25 ksi on cells of about 2 mm, to a factor that its reading of a chart allows.
    assert!((0.3..0.8).contains(&low), "{products:?}");
    for shear in [5.0, 1.0] {
        let case = case(2.0, shear);
        let noise = errors(&case, QUARTER, 200);
        let ratio = peak(&case.truth, 2) / rms(&noise)[2];
        println!(
            "peaks: radial {:.1}, hoop {:.1}, shear {:.2} ksi; shear peak over noise {ratio:.1}",
            peak(&case.truth, 0),
            peak(&case.truth, 1),
            peak(&case.truth, 2)
        );
        assert!(ratio > 2.5 * shear);
    }
}

#[test]
fn errors_of_2_and_a_half_fringes_bury_the_shear() {
    let case = case(2.0, 5.0);
    let small = rms(&errors(&case, QUARTER, 100));
    let large = rms(&errors(&case, 10.0 * QUARTER, 100));
    let relative = [0, 2].map(|k| large[k] / peak(&case.truth, k));
    println!(
        "±2.5 fringes: radial {:.2}, hoop {:.2}, shear {:.2} ksi; {:.0} % of the radial peak, {:.0} % of the shear peak",
        large[0],
        large[1],
        large[2],
        100.0 * relative[0],
        100.0 * relative[1]
    );
    // The analysis is linear, and both use the same draws.
    assert!((0..3).all(|k| (large[k] / small[k] - 10.0).abs() < 1e-6));
    assert!(relative[1] > 3.0 * relative[0]);
}

#[test]
fn one_error_of_5_fringes_stays_where_it_is() {
    println!(
        "one error of 5 fringes at the middle of the inner edge: shear error in ksi over cells from it"
    );
    for size in [2.0, 1.0, 0.5] {
        let case = case(size, 5.0);
        let middle = case.edge.nodes.len() / 4 * 2;
        let node = case.edge.nodes[middle];
        let mut wrong = case.boundary.clone();
        let k = wrong.nodes.iter().position(|&n| n == node).unwrap();
        wrong.values[2 * k + 1] += 20.0 * QUARTER;
        let found = case.region.solve(&wrong).unwrap().outputs(&case.edge.rows);
        let error = |k: usize| (found[3 * k + 2] - case.truth[3 * k + 2]).abs();
        let largest = (0..case.edge.nodes.len()).map(error).fold(0.0, f64::max);
        // Largest error at nodes at least so many cells away.
        let beyond = |cells: usize| {
            let nodes = (0..case.edge.nodes.len()).filter(|&k| k.abs_diff(middle) >= 2 * cells);
            nodes.map(error).fold(0.0, f64::max)
        };
        let tail = [0, 1, 2, 3, 4].map(beyond);
        // Cells per e-fold from the first cell to the fourth.
        let decay = 3.0 / (tail[1] / tail[4]).ln();
        println!(
            "{size:4.1} mm: {tail:8.3?}, e-fold in {decay:.2} cells = {:.2} mm",
            decay * size
        );
        assert!(tail[3] < 0.05 * largest, "{tail:?}");
    }
}
