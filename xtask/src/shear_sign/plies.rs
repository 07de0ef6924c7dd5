//! Stress across the fibres along the edge, where matrix cracks are to be expected.

use stickslip::run::run;

use super::case::{CLEARANCE, Case};
use crate::publish::Trouble;

/// Transverse strength of the scene's ply `[ksi]`.
pub(crate) const STRENGTH: f64 = 10.1;
/// Loads that are looked at `[lbf]`.
pub(crate) const LOADS: [f64; 4] = [400.0, 900.0, 1200.0, 1500.0];
const STEPS: [f64; 10] = [
    20.0, 100.0, 200.0, 300.0, 400.0, 500.0, 700.0, 900.0, 1200.0, 1500.0,
];

/// A plate whose plies are asked.
#[derive(Clone, Debug)]
pub(crate) struct Question {
    pub(crate) name: &'static str,
    pub(crate) law: String,
    /// Temperature since the cure `[K]`.
    pub(crate) cure: f64,
    /// Radial `[in]`.
    pub(crate) clearance: f64,
}

impl Question {
    /// The scene's clearance.
    pub(crate) fn new(name: &'static str, law: String, cure: f64) -> Self {
        Self {
            name,
            law,
            cure,
            clearance: CLEARANCE,
        }
    }
}

/// σ₂ of one ply along the edge at one load.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) name: &'static str,
    pub(crate) cure: f64,
    pub(crate) clearance: f64,
    /// `[lbf]`
    pub(crate) load: f64,
    /// Direction of the fibres from the load `[degree]`.
    pub(crate) ply: f64,
    /// Angle of the report `[degree]`, ascending over the side of the pin, and σ₂ `[ksi]`.
    pub(crate) profile: Vec<[f64; 2]>,
    /// Stress of the cure in it `[ksi]`.
    pub(crate) residual: f64,
}

impl Curve {
    /// Angle of the report and size of the largest tension.
    pub(crate) fn peak(&self) -> [f64; 2] {
        let largest = self.profile.iter().max_by(|a, b| a[1].total_cmp(&b[1]));
        largest.copied().unwrap_or([f64::NAN; 2])
    }

    /// Value at an angle of the report `[degree]`, from the nearest node.
    pub(crate) fn at(&self, angle: f64) -> f64 {
        let away = |row: &&[f64; 2]| (row[0] - angle).abs();
        let nearest = self
            .profile
            .iter()
            .min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.map_or(f64::NAN, |row| row[1])
    }

    /// Smallest and largest angle of the report of the stretch around the peak in which the strength is reached.
    pub(crate) fn cracked(&self) -> Option<[f64; 2]> {
        let [peak, largest] = self.peak();
        if largest < STRENGTH {
            return None;
        }
        let top = self.profile.partition_point(|row| row[0] < peak);
        let weak = |row: &&[f64; 2]| row[1] >= STRENGTH;
        let from = self
            .profile
            .get(..=top)?
            .iter()
            .rev()
            .take_while(weak)
            .last()?;
        let to = self.profile.get(top..)?.iter().take_while(weak).last()?;
        Some([from[0], to[0]])
    }
}

/// Solves the joint and reads the plies. A half model serves: the laminate is balanced, so the mean stresses are symmetric, and on the
/// other half the ply of the opposite direction takes the place of each, which the results allow for.
pub(crate) fn ask(question: &Question, spacing: f64) -> Result<Vec<Curve>, Trouble> {
    let case = Case {
        clearance: question.clearance,
        ..Case::new("plies", question.name, &question.law, &STEPS)
    };
    let cure = format!("materials.laminate.laminate.cure=\"{} K\"", question.cure);
    let more = [
        cure.as_str(),
        "output.fields=\"none\"",
        "failure.criteria=[\"max_stress\"]",
    ];
    let results = run(&case.scene(spacing, &more)?, &mut |_| {})?;
    let failure = results
        .failure
        .first()
        .ok_or("nothing is asked of the plies")?;
    let edge = failure.edges.first().ok_or("no edge")?;
    let stress = |value: f64| results.units.stress.from_base(value);
    let mut curves = Vec::new();
    for (load, own) in STEPS
        .iter()
        .zip(&edge.steps)
        .filter(|(load, _)| LOADS.contains(load))
    {
        for (group, points) in failure.plies.iter().zip(own) {
            let mut profile: Vec<[f64; 2]> = edge
                .parameter
                .iter()
                .zip(points)
                .map(|(theta, point)| [90.0 - theta.to_degrees(), stress(point.stress[1])])
                .filter(|row| (-10.0..=190.0).contains(&row[0]))
                .collect();
            profile.sort_by(|a, b| a[0].total_cmp(&b[0]));
            curves.push(Curve {
                name: question.name,
                cure: question.cure,
                clearance: question.clearance,
                load: *load,
                ply: group.angle,
                profile,
                residual: stress(group.residual[1]),
            });
        }
    }
    Ok(curves)
}
