//! Scenes of double laps: a row of bolts through a middle plate that is pulled along −x and two outer plates that are held.

use std::fmt::Write as _;

/// Radius of the bolts, and width of the plates `[mm]`.
pub(crate) const RADIUS: f64 = 3.0;
pub(crate) const WIDTH: f64 = 24.0;
/// Thicknesses of the layers `[mm]`.
pub(crate) const THICKNESSES: [f64; 3] = [2.5, 4.0, 2.5];
/// Young's modulus of plates and bolts `[MPa]`, and Poisson's ratio of the bolts.
pub(crate) const PLATES: f64 = 72e3;
pub(crate) const BOLTS: f64 = 210e3;
pub(crate) const POISSON: f64 = 0.3;

/// Names of the layers' plates.
const NAMES: [&str; 3] = ["lower", "middle", "upper"];

/// A row of bolts without friction.
#[derive(Debug)]
pub(crate) struct Row<'a> {
    /// Radial clearance `[µm]` of each bolt in the holes of its three layers.
    pub(crate) clearances: &'a [[f64; 3]],
    /// Distance of the bolts `[mm]`.
    pub(crate) pitch: f64,
    /// From the last hole to a loaded or held side, and to a free one `[mm]`.
    pub(crate) ends: [f64; 2],
    /// Along which axes the right sides of the outer plates are held, as scenes have it.
    pub(crate) held: &'a str,
    /// What couples the slices, as scenes have it.
    pub(crate) springs: &'a str,
    /// Spacing of the mesh around holes `[degree]`.
    pub(crate) spacing: f64,
    /// Pull `[N]`.
    pub(crate) load: f64,
}

impl Row<'_> {
    /// The scene.
    pub(crate) fn scene(&self) -> String {
        let mut text = format!(
            r#"
version = 1
[materials.aluminium.isotropic]
young = "{PLATES} MPa"
poisson = 0.33
[materials.steel.isotropic]
young = "{BOLTS} MPa"
poisson = {POISSON}
[mesh]
spacing = "{} deg"
[output]
fields = "none"
figures = false
[[loads]]
name = "pull"
on = "middle.left"
force = {{ direction = [-1, 0], steps = ["{} N"] }}
"#,
            self.spacing, self.load
        );
        (0..3).for_each(|layer| self.plate(&mut text, layer));
        (0..self.clearances.len()).for_each(|bolt| self.bolt(&mut text, bolt));
        text
    }

    /// Writing to a text does not fail.
    fn plate(&self, text: &mut String, layer: usize) {
        let (name, thickness) = (NAMES[layer], THICKNESSES[layer]);
        let last = self.pitch * (self.clearances.len() - 1) as f64;
        let [far, near] = self.ends;
        let [left, right] = match layer {
            1 => [-far, last + near],
            _ => [-near, last + far],
        };
        let half = 0.5 * WIDTH;
        let _ = write!(
            text,
            r#"
[bodies.{name}]
material = "aluminium"
thickness = "{thickness} mm"
[bodies.{name}.shape.outline]
start = ["{left} mm", "-{half} mm"]
edges = [
  {{ name = "bottom", to = ["{right} mm", "-{half} mm"] }},
  {{ name = "right", to = ["{right} mm", "{half} mm"] }},
  {{ name = "top", to = ["{left} mm", "{half} mm"] }},
  {{ name = "left" }},
]
[bodies.{name}.shape.outline.holes]
"#
        );
        for (bolt, clearances) in self.clearances.iter().enumerate() {
            let (x, radius) = (self.pitch * bolt as f64, RADIUS + 1e-3 * clearances[layer]);
            let _ = writeln!(
                text,
                "h{bolt} = {{ centre = [\"{x} mm\", \"0 mm\"], radius = \"{radius} mm\" }}"
            );
        }
        if layer != 1 {
            let held = self.held;
            let _ = write!(text, "[[supports]]\non = \"{name}.right\"\nfix = {held}\n");
        }
    }

    fn bolt(&self, text: &mut String, bolt: usize) {
        for (layer, plate) in NAMES.iter().enumerate() {
            let thickness = THICKNESSES[layer];
            let _ = write!(
                text,
                r#"
[bodies.b{bolt}-{layer}]
material = "steel"
thickness = "{thickness} mm"
shape.disk.radius = "{RADIUS} mm"
[[contacts]]
first = "{plate}.h{bolt}"
second = "b{bolt}-{layer}.rim"
friction.coulomb = {{ mu = 0.0 }}
"#
            );
        }
        let _ = write!(
            text,
            "[fasteners.b{bolt}]\nslices = [\"b{bolt}-0\", \"b{bolt}-1\", \"b{bolt}-2\"]\nsprings.{}\n",
            self.springs
        );
    }
}
