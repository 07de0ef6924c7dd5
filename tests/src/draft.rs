//! Small scenes, changed key by key as by `--set`.

use std::fmt::{self, Debug, Display, Write as _};
use std::path::Path;

use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run;
use stickslip::scene::{Format, Scene};
use stickslip_contact::ContactError;

use crate::Solution;

/// A pin in a strip, its centre held, the strip pulled towards −x; coarse enough to solve in milliseconds.
const PIN: &str = r#"
version = 1
title = "Pin joint"

[materials.plate.isotropic]
young = "70 GPa"
poisson = 0.33

[materials.pin.isotropic]
young = "70 GPa"
poisson = 0.33

[bodies.plate]
material = "plate"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }

[bodies.pin]
material = "pin"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }

[mesh]
element = "Q8"
spacing = "9 deg"

[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.25 }

[[supports]]
on = "pin.centre"
fix = ["x", "y"]

[[loads]]
name = "pull"
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }

[output]
fields = "none"
figures = false
"#;

/// A cylinder pressed on a block and pushed along it, its top glued to a platen that moves without turning.
const CYLINDER: &str = r#"
version = 1
title = "Cylinder on a block"

[analysis]
plane = "strain"

[materials.lower.isotropic]
young = "70 GPa"
poisson = 0.33

[materials.upper.isotropic]
young = "70 GPa"
poisson = 0.33

[bodies.lower]
material = "lower"
thickness = "1 mm"
shape.block = { half_length = "12 mm", depth = "12 mm" }

[bodies.upper]
material = "upper"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "12 mm", depth = "12 mm" }

[mesh]
element = "Q8"
spacing = "0.2 mm"
fine_to = "1.6 mm"

[[contacts]]
name = "cylinder"
first = "upper.contact"
second = "lower.contact"
friction.coulomb = { mu = 0.4 }

[[supports]]
on = "lower.bottom"
fix = ["x", "y"]

[[platens]]
on = "upper.top"
free = ["x", "y"]

[[loads]]
name = "press"
on = "upper.top"
force = { direction = [0, -1], steps = ["500 N"] }

[[loads]]
name = "push"
on = "upper.top"
force = { direction = [1, 0], steps = ["100 N"] }

[output]
fields = "none"
figures = false
"#;

/// A scene and the changes to it.
#[derive(Clone)]
pub struct Draft {
    text: &'static str,
    overrides: Vec<String>,
}

/// Shows the changes alone, one a line, as arguments of the command.
impl Debug for Draft {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = self.overrides.iter();
        lines.try_for_each(|change| writeln!(formatter, "  --set '{change}'"))
    }
}

impl Draft {
    /// The pin joint: hole of 5 mm radius in a strip 40 mm wide and 2 mm thick, clearance 0.01 mm, μ = 0.25, pull 1 kN.
    pub fn pin() -> Self {
        Self {
            text: PIN,
            overrides: Vec::new(),
        }
    }

    /// The cylinder of 50 mm radius on a block, plane strain, μ = 0.4, press 500 N, push 100 N.
    pub fn cylinder() -> Self {
        Self {
            text: CYLINDER,
            overrides: Vec::new(),
        }
    }

    /// The scene with the key replaced or added.
    #[must_use]
    pub fn set(mut self, key: &str, value: impl Display) -> Self {
        self.overrides.push(format!("{key}={value}"));
        self
    }

    /// The scene with another friction law, in TOML: `coulomb = { mu = 0.3 }`.
    #[must_use]
    pub fn friction(self, law: &str) -> Self {
        self.set("contacts.0.friction", format!("{{ {law} }}"))
    }

    /// The scene with the steps of force `load`, in newtons.
    #[must_use]
    pub fn forces(self, load: usize, newtons: &[f64]) -> Self {
        self.set(
            &format!("loads.{load}.force.steps"),
            quantities(newtons, "N"),
        )
    }

    /// The scene, checked.
    pub fn scene(&self) -> Scene {
        Scene::from_text_on(
            self.text,
            Format::Toml,
            "draft.toml",
            Path::new(""),
            &self.overrides,
            HOST,
        )
        .unwrap_or_else(|error| panic!("{error}:\n{self:?}"))
    }

    /// What a run of it finds.
    pub fn run(&self) -> Results {
        run::run(&self.scene(), &mut |_| {}).unwrap_or_else(|error| panic!("{error}:\n{self:?}"))
    }

    /// The same, or `None` where the contact solvers say that they did not solve a step. Every other error panics.
    pub fn run_if_solvable(&self) -> Option<Results> {
        match run::run(&self.scene(), &mut |_| {}) {
            Ok(results) => Some(results),
            Err(error) => match error.contact() {
                Some(ContactError::StepFailed { .. }) => None,
                _ => panic!("{error}:\n{self:?}"),
            },
        }
    }

    /// Its model, solved.
    pub fn solve(&self) -> Solution {
        Solution::of(&self.scene())
    }
}

/// A list of quantities in TOML: `["1 N", "2 N"]`.
pub fn quantities(values: &[f64], unit: &str) -> String {
    let mut list = String::from("[");
    for value in values {
        // Writing into a string does not fail.
        let _ = write!(list, "\"{value} {unit}\", ");
    }
    list.push(']');
    list
}
