//! A random laboratory: a plate on a pin whose friction is known, what is measured of it, and the experiment that is asked.

use serde_json::{Value, json};

use super::parts::{
    Pin, Plate, error_of, friction, laws, masks, medium, noise, region, rotation, scene,
};
use crate::torture::draw::{Draw, digits};

/// Share of laboratories whose laws are fitted, and of those whose model is a little wrong.
const FITTED: f64 = 0.45;
const WRONG: f64 = 0.2;
/// Share of those with many data and small errors, which show what sticks.
const FINE: f64 = 0.1;

/// Friction of the truth.
#[derive(Clone, Debug)]
pub(super) struct Friction {
    /// Kind of the law, `coulomb` where there is no friction.
    pub(super) kind: &'static str,
    pub(super) fixed: f64,
    pub(super) moving: f64,
    /// Slip scale `[mm]` of `slip_power`.
    pub(super) scale: f64,
    pub(super) law: Value,
}

/// How displacements are seen.
#[derive(Clone, Debug)]
pub(super) enum Medium {
    /// A table on a square grid; errors are means over squares of `reach` places.
    Table { spacing: f64, reach: usize },
    /// Fringe pictures of 8 bits: lines per mm, carrier `[1/mm]`, pixel `[mm]`, light that falls off by this part towards the corners.
    Pictures {
        frequency: f64,
        carrier: f64,
        pixel: f64,
        falloff: f64,
    },
}

/// All that is drawn from a seed.
#[derive(Clone, Debug)]
pub(super) struct Lab {
    pub(super) seed: u64,
    /// Radius of the hole `[mm]`.
    pub(super) radius: f64,
    pub(super) friction: Friction,
    pub(super) medium: Medium,
    /// Standard deviation of displacements in tables `[mm]`; of intensities in pictures, with errors of orders, `[fringes]`.
    pub(super) noise: f64,
    /// Data begin at so many radii.
    pub(super) clear: f64,
    /// Rotation `[rad]` and dilation that the picture adds.
    pub(super) rotation: f64,
    pub(super) dilation: f64,
    /// Load steps of the states, from 1.
    pub(super) steps: Vec<usize>,
    /// Scene with the mesh of the model.
    pub(super) scene: Value,
    /// What makes the scene that of the truth.
    pub(super) overrides: Vec<String>,
    /// The experiment without its states.
    pub(super) experiment: Value,
    /// Loads of all steps `[N]`.
    pub(super) loads: Vec<f64>,
    /// Whether the force on the edge, and the standard deviation of tables, are stated.
    pub(super) states_force: bool,
    pub(super) states_deviation: bool,
    /// What the model has wrong.
    pub(super) wrong: Option<&'static str>,
    /// What is held, for the counts.
    pub(super) features: Vec<String>,
}

impl Friction {
    fn named(&self) -> String {
        let kind = if self.moving == 0.0 {
            "none"
        } else {
            self.kind
        };
        format!("friction {kind}")
    }
}

impl Medium {
    fn named(&self) -> String {
        let name = match self {
            Self::Table { reach: 1, .. } => "table, independent errors",
            Self::Table { .. } => "table, correlated errors",
            Self::Pictures { .. } => "fringe pictures",
        };
        name.to_owned()
    }
}

/// Errors of the model.
const ERRORS: [&str; 6] = [
    "clearance",
    "load",
    "modulus",
    "dilation",
    "scale",
    "origin",
];

impl Lab {
    pub(super) fn new(seed: u64) -> Self {
        let draw = &mut Draw::new(seed, 11);
        let plate = Plate::new(draw);
        let fine = draw.chance(FINE);
        let friction = friction(draw, plate.strain * plate.radius, fine);
        let loads = plate.loads();
        let steps = match draw.whole(0, 3) {
            0 => vec![3],
            1 => vec![4, 6],
            2 => vec![3, 7],
            _ => vec![2, 4],
        };
        let pictures = !fine && draw.chance(0.2);
        let fits = !fine && draw.chance(FITTED);
        let wrong = (fits && !pictures && draw.chance(WRONG))
            .then(|| *draw.weighted(&ERRORS.each_ref().map(|own| (1.0, own))));
        let is_wide = pictures || !fine && draw.chance(0.6);
        let free = !fits && is_wide && draw.chance(0.35);
        let dilation = if free || wrong == Some("dilation") {
            let sign = [(0.5, 1.0), (0.5, -1.0)];
            digits(draw.magnitude(2e-5, 2e-4) * draw.weighted(&sign), 3)
        } else {
            0.0
        };
        let rotation = rotation(draw, pictures);
        let pin = Pin::new(draw, &plate);
        let scene = scene(draw, &plate, &pin, &friction, &loads);
        let medium = medium(draw, &plate, pictures, fine);
        let noise = noise(draw, &plate, pictures, fine);
        let mut overrides = vec![
            "mesh.spacing=\"1.5 deg\"".to_owned(),
            "mesh.coarse_spacing=\"5 deg\"".to_owned(),
        ];
        overrides.extend(wrong.and_then(|own| error_of(own, &pin, &loads, draw)));
        let mut experiment = json!({
            "version": 1,
            "specimen": { "scene": "scene.json", "body": "plate", "edge": "hole" },
            "region": region(draw, plate.radius, is_wide, fine),
            "reduce": { "mask": masks(draw, plate.radius) },
            "identify": { "samples": 20, "seed": seed % 1000 },
        });
        if free {
            experiment["reduce"]["free"] = json!(["dilation"]);
        }
        if fits {
            experiment["laws"] = laws(&friction);
        }
        let more = [
            (rotation != 0.0, "rotation"),
            (free, "dilation, free"),
            (fits, "laws fitted"),
            (!is_wide, "region that cuts the contact"),
            (fine, "many data, small errors"),
        ];
        let mut features = vec![friction.named(), plate.named(), medium.named()];
        features.extend(more.iter().filter(|own| own.0).map(|own| own.1.to_owned()));
        features.extend(wrong.map(|own| format!("model wrong: {own}")));
        Self {
            seed,
            radius: plate.radius,
            friction,
            medium,
            noise,
            clear: 1.0 + draw.between(0.005, 0.03),
            rotation,
            dilation,
            steps,
            scene,
            overrides,
            experiment,
            loads,
            states_force: is_wide && draw.chance(0.7),
            states_deviation: draw.chance(0.5),
            wrong,
            features,
        }
    }

    /// All of it in one file.
    pub(super) fn told(&self) -> Value {
        json!({
            "seed": self.seed,
            "scene": self.scene,
            "overrides_of_the_truth": self.overrides,
            "experiment": self.experiment,
            "medium": format!("{:?}", self.medium),
            "noise": self.noise,
            "rotation_rad": self.rotation,
            "dilation": self.dilation,
            "steps": self.steps,
            "model_wrong": self.wrong,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_seeds_draw_equal_laboratories() {
        assert_eq!(Lab::new(7).told(), Lab::new(7).told());
        assert_ne!(Lab::new(7).told(), Lab::new(8).told());
    }
}
