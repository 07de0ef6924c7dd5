//! A random laboratory: a plate on a pin whose friction is known, what is measured of it, and the experiment that is asked.

use serde_json::{Value, json};

use super::parts::{
    Pin, Plate, asked, dilation, error_of, friction, laws, masks, medium, noise, region, rotation,
    scene,
};
use super::truth::{Friction, Medium};
use crate::torture::draw::Draw;

/// Share of laboratories whose laws are fitted, and of those whose model is a little wrong.
const FITTED: f64 = 0.45;
const WRONG: f64 = 0.2;
/// Share of those with many data and small errors, which show what sticks.
const FINE: f64 = 0.1;

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

/// Load steps of the states, from 1.
const STEPS: [&[usize]; 4] = [&[3], &[4, 6], &[3, 7], &[2, 4]];
/// The mesh of the truth.
const FINER: [&str; 2] = ["mesh.spacing=\"1.5 deg\"", "mesh.coarse_spacing=\"5 deg\""];

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
        let steps = STEPS[draw.whole(0, STEPS.len() - 1)].to_vec();
        let pictures = !fine && draw.chance(0.2);
        let fits = !fine && draw.chance(FITTED);
        let wrong = (fits && !pictures && draw.chance(WRONG))
            .then(|| *draw.weighted(&ERRORS.each_ref().map(|own| (1.0, own))));
        let is_wide = pictures || !fine && draw.chance(0.6);
        let free = !fits && is_wide && draw.chance(0.35);
        let dilation = if free || wrong == Some("dilation") {
            dilation(draw)
        } else {
            0.0
        };
        let rotation = rotation(draw, pictures);
        let pin = Pin::new(draw, &plate);
        let scene = scene(draw, &plate, &pin, &friction, &loads);
        let medium = medium(draw, &plate, pictures, fine);
        let noise = noise(draw, &plate, pictures, fine);
        let mut overrides = FINER.map(str::to_owned).to_vec();
        overrides.extend(wrong.and_then(|own| error_of(own, &pin, &loads, draw)));
        let region = region(draw, plate.radius, is_wide, fine);
        let masks = masks(draw, plate.radius);
        let experiment = asked(seed, &region, &masks, free, fits.then(|| laws(&friction)));
        let held = [
            (rotation != 0.0, "rotation"),
            (free, "dilation, free"),
            (fits, "laws fitted"),
            (!is_wide, "region that cuts the contact"),
            (fine, "many data, small errors"),
        ];
        let mut features = vec![friction.named(), plate.named(), medium.named()];
        features.extend(held.iter().filter(|own| own.0).map(|own| own.1.to_owned()));
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
    pub(super) fn values(&self) -> Value {
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
        assert_eq!(Lab::new(7).values(), Lab::new(7).values());
        assert_ne!(Lab::new(7).values(), Lab::new(8).values());
    }
}
