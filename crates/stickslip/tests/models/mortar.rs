//! Bodies whose meshes do not match: the mortar projection in scenes.

use stickslip::model::{Model, ModelError};
use stickslip::results::Results;

use super::{BUSHING, difference, model, scene, solved, tractions, upper};

const MU: f64 = 0.25;

/// A pin in a strip, loaded and unloaded.
const PIN: &str = r#"
version = 1
[materials.metal.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "2 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.25 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["4 kN", "1 kN"] }
[output]
fields = "none"
figures = false
"#;

/// A cylinder that is pressed on a block and pushed along it.
const ROLLER: &str = r#"
version = 1
[analysis]
plane = "strain"
[materials.stiff.isotropic]
young = "210 GPa"
poisson = 0.3
[materials.soft.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "soft"
thickness = "1 mm"
shape.block = { half_length = "12 mm", depth = "12 mm" }
[bodies.roller]
material = "stiff"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "12 mm", depth = "12 mm" }
[mesh]
spacing = "0.06 mm"
fine_to = "1.5 mm"
[[contacts]]
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.25 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["x", "y"]
[[loads]]
on = "roller.top"
force = { direction = [0, -1], steps = ["600 N", "600 N"] }
[[loads]]
on = "roller.top"
force = { direction = [1, 0], steps = ["0 N", "75 N"] }
[output]
fields = "none"
figures = false
"#;

/// Two blocks, the upper one a cylinder without measurable curvature, pressed on each other.
const BLOCKS: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "10 mm", depth = "10 mm" }
[bodies.upper]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "1e15 mm", half_length = "10 mm", depth = "10 mm" }
[mesh]
spacing = "0.5 mm"
fine_to = "5 mm"
[[contacts]]
first = "upper.contact"
second = "block.contact"
gap = "linearised"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "block.bottom"
fix = ["y"]
[[loads]]
on = "upper.top"
pressure.steps = ["50 MPa"]
[output]
fields = "none"
figures = false
"#;

/// Peak pressure, half extent of contact, and friction over μ times the normal force, after a step.
fn figures(results: &Results, step: usize) -> [f64; 3] {
    let edge = &results.steps[step].edges[0];
    let (peak, _) = edge.peak_pressure.unwrap();
    [
        peak,
        edge.contact_half_extent.unwrap(),
        edge.friction_force / (MU * edge.normal_force),
    ]
}

fn deviations(results: &Results, reference: &Results, step: usize) -> [f64; 3] {
    let (found, known) = (figures(results, step), figures(reference, step));
    std::array::from_fn(|i| (found[i] / known[i] - 1.0).abs())
}

fn worst_balance(results: &Results) -> f64 {
    let steps = results.steps.iter();
    steps.fold(0.0, |worst, step| worst.max(step.balance_residual))
}

fn discretisation(model: &Model) -> [&str; 2] {
    let found = model
        .choices
        .iter()
        .find(|choice| choice.what.starts_with("contact discretisation"));
    found
        .map(|choice| [choice.value.as_str(), choice.reason.as_str()])
        .unwrap()
}

#[test]
fn probe() {
    for (what, text, second) in [("pin", PIN, "pin"), ("roller", ROLLER, "block")] {
        let (unit, base, others) = if what == "pin" {
            ("deg", 2.0, [1.3, 3.1, 4.0])
        } else {
            ("mm", 0.06, [0.04, 0.09, 0.12])
        };
        let reference = solved(text, &[]);
        let fine = solved(text, &[&format!("mesh.spacing={} {unit}", base / 2.0)]);
        println!(
            "{what} reference {:?} {:?}",
            figures(&reference, 0),
            figures(&reference, 1)
        );
        println!(
            "   against half the spacing {:.5?} {:.5?}",
            deviations(&reference, &fine, 0),
            deviations(&reference, &fine, 1)
        );
        for how in ["mortar", "dual-mortar"] {
            let projection = format!("contacts.0.projection={how}");
            for other in [base, others[0], others[1], others[2]] {
                let spacing = format!("bodies.{second}.mesh.spacing={other} {unit}");
                for model in ["half", "whole"] {
                    if model == "half" && what == "roller" {
                        continue;
                    }
                    let scene = super::scene(
                        text,
                        &[&projection, &spacing, &format!("analysis.model={model}")],
                    );
                    let results = match stickslip::run::run(&scene, &mut |_| {}) {
                        Ok(r) => r,
                        Err(e) => {
                            println!("{what} {how} {other} {model} {e}");
                            continue;
                        }
                    };
                    println!(
                        "{what} {how} {other} {model}: {:.5?} {:.5?} balance {:.1e}  tractions {:.1e} {:?}",
                        deviations(&results, &reference, 0),
                        deviations(&results, &reference, 1),
                        worst_balance(&results),
                        difference(
                            tractions(&upper(&reference, 0, 0)),
                            tractions(&upper(&results, 0, 0))
                        ),
                        results
                            .steps
                            .iter()
                            .map(|s| s.solvers.clone())
                            .collect::<Vec<_>>()
                    );
                }
            }
        }
    }
}
