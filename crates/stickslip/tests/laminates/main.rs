//! Laminates in scenes: stiffness, ply stresses, first-ply failure, characteristic distances, and how they are written.

mod characteristic;
mod failure;
mod files;
mod progressive;
mod refusals;
mod several;
mod stiffness;
mod supports;

use std::path::Path;

use stickslip::diagnostic::SceneError;
use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run;
use stickslip::scene::{Format, Scene};

/// A pin that fits the hole of a quasi-isotropic strip, coarse. Without clearance everything is in proportion to the load.
const PIN: &str = r#"
version = 1
[plies.carbon]
e1 = "135 GPa"
e2 = "10 GPa"
g12 = "5.8 GPa"
nu12 = 0.28
expansion1 = "0.02e-6 1/K"
expansion2 = "22.5e-6 1/K"
thickness = "0.125 mm"
strengths = { xt = "1500 MPa", xc = "1200 MPa", yt = "50 MPa", yc = "200 MPa", s12 = "70 MPa", s23 = "100 MPa" }
[materials.laminate.laminate]
layup = "[0_2/60_2/-60_2]s"
ply = "carbon"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "laminate"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "80 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "1.5 mm"
shape.disk = { radius = "5 mm" }
[mesh]
spacing = "6 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
name = "pull"
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }
[failure]
criteria = ["max_stress", "tsai_hill", "tsai_wu", "hashin", "yamada_sun"]
[output]
fields = "none"
figures = false
"#;

/// A coupon of the same plies under a stress along x.
const COUPON: &str = r#"
version = 1
[plies.carbon]
e1 = "135 GPa"
e2 = "10 GPa"
g12 = "5.8 GPa"
nu12 = 0.28
expansion1 = "0.02e-6 1/K"
expansion2 = "22.5e-6 1/K"
thickness = "0.125 mm"
strengths = { xt = "1500 MPa", xc = "1200 MPa", yt = "50 MPa", yc = "200 MPa", s12 = "70 MPa", s23 = "100 MPa" }
[materials.laminate.laminate]
layup = "[0/±45/90]s"
ply = "carbon"
[bodies.coupon]
material = "laminate"
shape.rectangle = { width = "60 mm", height = "20 mm" }
[mesh]
spacing = "10 mm"
[[supports]]
on = "coupon.left"
fix = ["x"]
[[loads]]
name = "tension"
on = "coupon.right"
pressure.steps = ["-100 MPa"]
[failure]
criteria = ["max_stress", "tsai_hill", "hoffman", "tsai_wu", "hashin"]
[output]
fields = "none"
figures = false
"#;

fn read(text: &str, changes: &[&str]) -> Result<Scene, SceneError> {
    Scene::from_text_on(
        text,
        Format::Toml,
        "scene.toml",
        Path::new(""),
        changes,
        HOST,
    )
}

fn scene(text: &str, changes: &[&str]) -> Scene {
    read(text, changes).unwrap_or_else(|error| panic!("{error} with {changes:?}"))
}

fn solved(text: &str, changes: &[&str]) -> Results {
    let scene = scene(text, changes);
    run::run(&scene, &mut |_| {}).unwrap_or_else(|error| panic!("{error} with {changes:?}"))
}

/// Asserts that two numbers agree to `tolerance`, relative to the first.
#[track_caller]
fn close(one: f64, other: f64, tolerance: f64) {
    let apart = (one - other).abs() / one.abs();
    assert!(
        apart <= tolerance,
        "{one} and {other} differ by {apart:.2e}"
    );
}
