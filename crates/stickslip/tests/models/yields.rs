//! The yield stress of a metal: which bodies exceed it, where, and in which steps.

use stickslip::results::{
    BodyStresses, Finding, Quantity, Results, StepResults, StressPeak, Yield,
};
use stickslip::scene::{Format, Scene};

use super::displacement::ELEMENTS;
use super::series::PIN;
use super::solved;

/// A ring of radii 10 and 20 mm under pressure in its hole.
const RING: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
yield = "95 MPa"
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "10 mm", outline.ring.radius = "20 mm" }
[mesh]
spacing = "3 deg"
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
on = "ring.hole"
pressure.steps = ["40 MPa", "80 MPa", "100 MPa", "50 MPa"]
[[edges]]
on = "ring.hole"
[output]
fields = "none"
figures = false
"#;
/// An open hole in a wide plate in tension: 3 σ at ±90°, and as von Mises, because the edge is free.
const HOLE: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
yield = "250 MPa"
[bodies.plate]
material = "metal"
thickness = "1 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "1 mm"
outline.strip = { half_width = "100 mm", left = "100 mm", right = "100 mm" }
[mesh]
spacing = "3 deg"
[[supports]]
on = "plate.right"
fix = ["x"]
[[loads]]
on = "plate.left"
pressure.steps = ["-50 MPa", "-100 MPa"]
[[edges]]
on = "plate.hole"
[output]
fields = "none"
figures = false
"#;

fn yields(results: &Results) -> Option<&Yield> {
    results.findings.iter().find_map(|finding| match finding {
        Finding::Yields(found) => Some(found),
        _ => None,
    })
}

/// σ_r, σ_θ at the hole of a ring whose outer edge is clamped, under the pressure p there, in plane stress (modulus 1, ν = 0.3) or strain.
fn lame(p: f64, plane_strain: bool) -> [f64; 3] {
    let (a, b, nu) = (10.0_f64, 20.0_f64, 0.3_f64);
    // u = A r + B/r vanishes at b; σ_r = k (A (1 + n) − B (1 − n)/r²) with n of the plane state.
    let n = if plane_strain { nu / (1.0 - nu) } else { nu };
    let ratio = (1.0 + n) / b.powi(2) + (1.0 - n) / a.powi(2);
    let [radial, hoop] = [1.0, -1.0].map(|sign| {
        let own = (1.0 + n) / b.powi(2) + sign * (1.0 - n) / a.powi(2);
        -p * own / ratio
    });
    let across = if plane_strain {
        nu * (radial + hoop)
    } else {
        0.0
    };
    [radial, hoop, across]
}

#[test]
fn a_ring_under_pressure_yields_where_its_von_mises_stress_says_so() {
    for strain in [false, true] {
        let state = if strain { "strain" } else { "stress" };
        let results = solved(RING, &[&format!("analysis.plane={state}")]);
        let [r, t, z] = lame(1.0, strain);
        let per_pressure = (0.5 * ((r - t).powi(2) + (t - z).powi(2) + (z - r).powi(2))).sqrt();
        let limit = 95.0;
        let beyond: Vec<usize> = [40.0, 80.0, 100.0, 50.0]
            .iter()
            .zip(1..)
            .filter(|(p, _)| *p * per_pressure > limit)
            .map(|(_, step)| step)
            .collect();
        for (step, pressure) in results.steps.iter().zip([40.0, 80.0, 100.0, 50.0]) {
            let found = step.stresses[0].von_mises;
            // Q8 of 3° on the hole: the discretisation's error of the edge stress.
            assert!(
                (found.stress / (pressure * per_pressure) - 1.0).abs() < 1e-4,
                "{state}: {found:?} beside {}",
                pressure * per_pressure
            );
            assert!((found.at[0].hypot(found.at[1]) - 10.0).abs() < 1e-9);
        }
        let found = yields(&results).map(|found| (found.step, found.steps.clone()));
        assert_eq!(found, (!beyond.is_empty()).then_some((3, beyond)));
    }
}

#[test]
fn an_open_hole_yields_at_a_third_of_the_yield_stress() {
    let results = solved(HOLE, &[]);
    let found = yields(&results).unwrap();
    assert_eq!((found.step, &*found.steps), (2, &[2][..]));
    // 3 σ of the infinite plate; in one of 100 radii 3 + 1e-3 or less.
    let stress = found.von_mises.value();
    assert!((stress - 300.0).abs() < 1.0, "{stress}");
    let [x, y] = found.at.map(Quantity::value);
    assert!(x.abs() < 0.06 && (y.abs() - 1.0).abs() < 2e-3, "{x} {y}");
}

#[test]
fn a_laminate_has_no_yield_stress() {
    let laminate = HOLE.replace(
        "[materials.metal.isotropic]\nyoung = \"70 GPa\"\npoisson = 0.3\nyield",
        "[materials.metal.orthotropic]\ne1 = \"140 GPa\"\ne2 = \"9 GPa\"\ng12 = \"5 GPa\"\nnu12 = 0.3\nyield",
    );
    let none: [&str; 0] = [];
    let error =
        Scene::from_text(&laminate, Format::Toml, "s.toml", "".as_ref(), &none).unwrap_err();
    assert_eq!(error.to_string(), "s.toml:8:1: unknown key 'yield'");
}

/// Largest stresses of a pinned plate lie within the errors of series and of elements, and those of a clamped one within its own of cells four times as fine.
#[test]
fn largest_stresses_have_errors_that_hold() {
    let pinned = PIN
        .replace("substeps = 1\n", "")
        .replace("pin.centre", "pin.section")
        .replace("poisson = 0.3\n", "poisson = 0.3\nyield = \"2 GPa\"\n")
        .replace("poisson = 0.33\n", "poisson = 0.33\nyield = \"2 GPa\"\n");
    let asked = "analysis.accuracy=2 %";
    let series = solved(&pinned, &[asked]);
    let given = [asked, "analysis.kinematics=auto", "mesh.spacing=1.5 deg"];
    let elements = solved(&pinned, &[&given[..], &ELEMENTS].concat());
    for (one, other) in series.steps.iter().zip(&elements.steps) {
        assert_eq!(one.stresses.len(), 2);
        for (one, other) in peaks(one).into_iter().zip(peaks(other)) {
            let both = one.error.unwrap() + other.error.unwrap();
            assert!(
                (one.stress - other.stress).abs() <= both,
                "{one:?} {other:?}"
            );
        }
    }
    // Beside the clamp stress is left out within a twentieth of the height, and grows towards there.
    let clamped = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
yield = "2 GPa"
[bodies.plate]
material = "metal"
thickness = "3 mm"
[bodies.plate.shape.outline]
start = ["0 mm", "0 mm"]
edges = [{ name = "bottom", to = ["60 mm", "0 mm"] }, { name = "right", to = ["60 mm", "20 mm"] }, { name = "top", to = ["0 mm", "20 mm"] }, { name = "left" }]
holes.eye = { centre = ["30 mm", "12 mm"], radius = "3 mm" }
[[supports]]
on = "plate.left"
fix = ["x", "y"]
[[loads]]
on = "plate.right"
force = { direction = [0.3, -1], steps = ["500 N"] }
[output]
fields = "none"
figures = false
"#;
    let own = solved(clamped, &[asked]);
    let fine = clamped.replace("name =", "refine = 4, name =");
    let fine = solved(&fine, &["mesh.spacing=0.5 deg"]);
    for (one, truth) in peaks(&own.steps[0]).into_iter().zip(peaks(&fine.steps[0])) {
        assert!(
            (one.stress - truth.stress).abs() <= one.error.unwrap(),
            "{one:?} {truth:?}"
        );
        assert_eq!(truth.error, None);
    }
    // Beside a re-entrant corner there is no limit.
    let notched = clamped.replace(
        "{ name = \"top\", to",
        "{ name = \"deep\", to = [\"20 mm\", \"20 mm\"] }, { name = \"drop\", to = [\"20 mm\", \"14 mm\"] }, { name = \"top\", to",
    );
    let notched = notched
        .replace("[\"0 mm\", \"20 mm\"]", "[\"0 mm\", \"14 mm\"]")
        .replace("30 mm\", \"12", "40 mm\", \"8");
    let notched = solved(&notched, &[asked]);
    let highest = peaks(&notched.steps[0])[0];
    assert!(
        highest.error.is_none() && (highest.at[0] - 20.0).abs() < 1.0,
        "{highest:?}"
    );
}

fn peaks(step: &StepResults) -> Vec<StressPeak> {
    let own = |own: &BodyStresses| [own.von_mises, own.largest_principal, own.least_principal];
    step.stresses.iter().flat_map(own).collect()
}
