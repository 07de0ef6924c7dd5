//! Random pins in holes.

use rand::RngExt as _;
use rand::rngs::StdRng;

pub(super) const ISOTROPIC: &str = "isotropic]\nyoung = \"70 GPa\"\npoisson = 0.33";

const LAY_UPS: [&str; 4] = ["[0/±45/90]s", "[0_2/±45/90]s", "[0/90]s", "[0/60/-60]s"];
/// The ply of the lay-ups.
pub(super) const PLY: &str = r#"[plies.carbon]
e1 = "131.7 GPa"
e2 = "13.8 GPa"
g12 = "6.2 GPa"
nu12 = 0.3
thickness = "0.25 mm"
strengths = { xt = "1582 MPa", xc = "1738 MPa", yt = "69.6 MPa", yc = "221 MPa", s12 = "119 MPa" }
"#;
const FAILURE: &str = r#"[failure]
criteria = ["max_stress", "tsai_wu"]
characteristic = { tension = "0.5 mm", compression = "1 mm" }
"#;

/// A scene without a mesh.
pub(crate) struct Draw {
    pub(super) text: String,
    /// What is drawn.
    pub(super) family: &'static str,
    /// Changes of the scene that divide its bodies for the truth; none where the ladder's finest model is the truth.
    pub(super) finest: Vec<String>,
    /// Whether bearing points and resultants follow from equilibrium, to rounding.
    pub(super) is_balanced: bool,
    /// Whether the program chooses the geometry on which contact is found.
    pub(super) chooses_kinematics: bool,
}

impl Draw {
    pub(crate) fn pin(_case: usize, rng: &mut StdRng) -> Self {
        let plane = if rng.random_bool(0.8) {
            "stress"
        } else {
            "strain"
        };
        let radius = 5.0;
        let mut outline = [1.8..6.0, 4.0..15.0, 2.0..6.0]
            .map(|range: std::ops::Range<f64>| radius * rng.random_range(range));
        let gap = if rng.random_bool(0.1) {
            -radius * rng.random_range(1e-4..2e-3)
        } else {
            radius * 10.0_f64.powf(rng.random_range(-4.0..-1.3))
        };
        let pin = if rng.random_bool(0.2) {
            "rigid = true".to_owned()
        } else {
            "material = \"pin\"\nthickness = \"2 mm\"".to_owned()
        };
        let young = 70.0 * 10.0_f64.powf(rng.random_range(-0.3..0.7));
        let poisson = rng.random_range(0.1..0.45);
        let law = law(rng);
        let mut plate = plate(rng);
        if plane == "strain" {
            plate = ISOTROPIC.into();
        }
        let is_laminate = plate.starts_with("laminate");
        let (thickness, ply, failure) = if is_laminate {
            ("", PLY, FAILURE)
        } else {
            ("thickness = \"2 mm\"\n", "", "")
        };
        let chooses_kinematics = rng.random_bool(0.3);
        let kinematics = if chooses_kinematics { "auto" } else { "small" };
        let steps = steps(rng);
        let loads = if rng.random_bool(0.15) {
            let part = rng.random_range(0.2..1.0);
            let aside: Vec<f64> = steps.iter().map(|force| part * force).collect();
            // The pull on the upper edge passes through the hole where that is in the middle.
            outline[2] = outline[1];
            [
                load("plate.left", "[-1, 0]", &steps),
                load("plate.top", "[0, 1]", &aside),
            ]
            .concat()
        } else {
            load("plate.left", "[-1, 0]", &steps)
        };
        let [half_width, left, right] = outline;
        let (rim, interference) = (radius - gap, gap < 0.0);
        Self {
            chooses_kinematics,
            family: "pins",
            finest: Vec::new(),
            is_balanced: true,
            text: format!(
                r#"version = 1
[analysis]
plane = "{plane}"
kinematics = "{kinematics}"
[materials.plate.{plate}
[materials.pin.isotropic]
young = "{young} GPa"
poisson = {poisson}
[bodies.plate]
material = "plate"
{thickness}[bodies.plate.shape.plate_with_hole]
hole_radius = "{radius} mm"
outline.strip = {{ half_width = "{half_width} mm", left = "{left} mm", right = "{right} mm" }}
[bodies.pin]
{pin}
shape.disk = {{ radius = "{rim} mm" }}
[[contacts]]
first = "plate.hole"
second = "pin.rim"
interference = {interference}
friction.{law}
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
{loads}
{ply}{failure}[output]
fields = "none"
figures = false
"#
            ),
        }
    }
}

/// The plate's material: isotropic, a laminate, orthotropic along the pull, or aside of it.
pub(super) fn plate(rng: &mut StdRng) -> String {
    let ratios: [f64; 2] = [rng.random_range(0.3..1.5), rng.random_range(0.15..0.7)];
    let [across, shear] = ratios.map(|ratio| 70.0 * ratio);
    let along = format!(
        "orthotropic]\ne1 = \"70 GPa\"\ne2 = \"{across} GPa\"\ng12 = \"{shear} GPa\"\nnu12 = 0.3"
    );
    match rng.random_range(0..10) {
        0..5 => ISOTROPIC.into(),
        5 => {
            let layup = LAY_UPS[rng.random_range(0..LAY_UPS.len())];
            format!("laminate]\nlayup = \"{layup}\"\nply = \"carbon\"")
        }
        6..9 => along,
        _ => format!("{along}\nangle = \"{} deg\"", rng.random_range(5..85)),
    }
}

fn law(rng: &mut StdRng) -> String {
    let mu: f64 = rng.random_range(0.02..1.0);
    match rng.random_range(0..4) {
        0 => "coulomb = { mu = 0 }".into(),
        1 => format!(
            "static_dynamic = {{ static = {mu}, dynamic = {} }}",
            0.7 * mu
        ),
        _ => format!("coulomb = {{ mu = {mu} }}"),
    }
}

/// Up and down again `[N]`.
fn steps(rng: &mut StdRng) -> Vec<f64> {
    let most = 10.0_f64.powf(rng.random_range(2.5..4.0));
    let (up, down) = (rng.random_range(1..4), rng.random_range(0..4));
    let up: Vec<f64> = (1..=up)
        .map(|k| most * f64::from(k) / f64::from(up))
        .collect();
    let fall = rng.random_range(0.3..0.85);
    let down = (1..=down).map(|k| most * f64::powi(fall, k));
    up.into_iter().chain(down).collect()
}

pub(super) fn load(on: &str, direction: &str, steps: &[f64]) -> String {
    let steps: Vec<String> = steps.iter().map(|force| format!("\"{force} N\"")).collect();
    let steps = steps.join(", ");
    format!("[[loads]]\non = \"{on}\"\nforce = {{ direction = {direction}, steps = [{steps}] }}\n")
}
