//! Random pins in holes.

use rand::RngExt as _;
use rand::rngs::StdRng;

const ISOTROPIC: &str = "isotropic]\nyoung = \"70 GPa\"\npoisson = 0.33";

/// A scene without a mesh.
pub(super) struct Draw {
    pub(super) text: String,
    /// Whether the program chooses the geometry on which contact is found.
    pub(super) chooses_kinematics: bool,
}

impl Draw {
    pub(super) fn new(rng: &mut StdRng) -> Self {
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
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
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
[output]
fields = "none"
figures = false
"#
            ),
        }
    }
}

/// The plate's material: isotropic, orthotropic along the pull, or aside of it.
fn plate(rng: &mut StdRng) -> String {
    let ratios: [f64; 2] = [rng.random_range(0.3..1.5), rng.random_range(0.15..0.7)];
    let [across, shear] = ratios.map(|ratio| 70.0 * ratio);
    let along = format!(
        "orthotropic]\ne1 = \"70 GPa\"\ne2 = \"{across} GPa\"\ng12 = \"{shear} GPa\"\nnu12 = 0.3"
    );
    match rng.random_range(0..10) {
        0..6 => ISOTROPIC.into(),
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

fn load(on: &str, direction: &str, steps: &[f64]) -> String {
    let steps: Vec<String> = steps.iter().map(|force| format!("\"{force} N\"")).collect();
    let steps = steps.join(", ");
    format!("[[loads]]\non = \"{on}\"\nforce = {{ direction = {direction}, steps = [{steps}] }}\n")
}
