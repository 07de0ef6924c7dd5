//! What `identify` states of a laboratory, and whether the truth is in it.

use stickslip::experiment::FreeMotion;
use stickslip::experiment::analysed::{
    Analysed, ForceCheck, LoadCheck, PictureMotion, TruePlace, all, true_edge,
};
use stickslip::experiment::identified::{Identified, identify, on_half_the_cells};
use stickslip::experiment::laws::{Fit, Known, LawStage, Verdict, stage};
use stickslip::experiment::measured::{Measured, state};
use stickslip::experiment::synthesis::Shots;
use stickslip_hybrid::data::{Measurement, Places};
use stickslip_hybrid::identify::Bounds;

use super::data::Measurable;
use super::lab::Lab;
use super::truth::Medium;
use crate::publish::TaskError;
use crate::torture::draw::Draw;

/// Standard deviations on either side of a value that hold 95 % of errors.
const OF_95: f64 = 1.96;
/// Error of stresses by the mesh of the region, part of the largest hoop stress.
const MESH: f64 = 0.01;

/// Something that was stated, or was asked for and not stated.
#[derive(Clone, Debug)]
pub(super) struct Statement {
    /// Kind of the statement.
    pub(super) check: String,
    /// How it came out.
    pub(super) outcome: Outcome,
}

#[derive(Clone, Debug)]
pub(super) enum Outcome {
    /// The truth is in it.
    Held,
    /// It is not: the distance in half widths of the stated interval, and a sentence.
    Missed(f64, String),
    /// Not identifiable, or rejected.
    Unstated,
}

/// Asks the experiment of `lab`.
pub(super) fn statements(lab: &Lab, data: &Measurable) -> Result<Vec<Statement>, TaskError> {
    let experiment = &data.asked;
    let fields = (0..experiment.states.len())
        .map(|own| state(experiment, own, &Shots::default()))
        .collect::<Result<Vec<Measured>, _>>()?;
    let analysed = all(experiment, &fields)?;
    let identified = identify(experiment, &analysed)?;
    let coarser = on_half_the_cells(experiment, &fields);
    let identified = identified.beside(coarser.as_ref().ok().and_then(Option::as_ref));
    let known = Known {
        analysed: &analysed,
        ..Known::default()
    };
    let laws = stage(experiment, &fields, known, &mut |_| ())?;
    let mut all = List::default();
    if lab.wrong.is_none() {
        all.friction(lab, &identified);
        all.edges(lab, data, &analysed);
        all.sizes(lab, data, &analysed);
        all.motions(lab, data, &fields, &analysed);
    }
    if let Some(stage) = &laws {
        all.laws(lab, stage);
    }
    Ok(all.0)
}

#[derive(Default)]
struct List(Vec<Statement>);

impl List {
    fn push(&mut self, check: &str, outcome: Outcome) {
        self.0.push(Statement {
            check: check.to_owned(),
            outcome,
        });
    }

    /// What slip zones say.
    fn friction(&mut self, lab: &Lab, found: &Identified) {
        // A coefficient that changes with the slip is any between both.
        let law = &lab.friction;
        let truth = if law.kind == "slip_power" {
            [law.moving, law.fixed]
        } else {
            [law.moving; 2]
        };
        let best = found.dynamic.as_ref().map_or(f64::NAN, |fit| fit.mu);
        self.push(
            "dynamic friction",
            outcome(found.dynamic_bounds(), best, truth),
        );
        for zone in &found.zones {
            let bounds = found.zone_bounds(zone);
            self.push("friction of a zone", outcome(bounds, zone.fit.mu, truth));
        }
        let grip = found.static_bound();
        let half = grip.map_or(f64::NAN, |grip| grip.ratio - grip.at_least);
        let bounds = grip.map(|grip| Bounds::AtLeast(grip.at_least));
        let stated = outcome_within(bounds, half, [law.fixed; 2]);
        self.push("static friction", stated);
    }

    /// Stresses of one place of each state's edge, their largest values, and the force through it.
    fn edges(&mut self, lab: &Lab, data: &Measurable, analysed: &[Analysed]) {
        let mut draw = Draw::new(lab.seed, 13);
        for found in analysed {
            let truth = true_edge(&data.known, Some(&data.truth), found.state);
            let inner = found.inner();
            if inner.is_empty() || truth.is_empty() {
                continue;
            }
            // No band holds the error of the mesh.
            let mesh = MESH
                * inner
                    .clone()
                    .map(|k| found.hoop[k].abs())
                    .fold(0.0, f64::max);
            // A dilation that cannot be separated from the load stays in the stresses, and a warning reports how large it may be.
            let dilated =
                |own: &PictureMotion| own.motion == FreeMotion::Dilation && !own.taken_off;
            let untold = lab.dilation != 0.0 && found.picture.iter().any(dilated);
            let stated = |outcome: Outcome| if untold { Outcome::Unstated } else { outcome };
            let place = draw.whole(inner.start, inner.end - 1);
            let [pressure, shear] = found.deviations();
            let own = [
                ("pressure", &found.tractions.pressure, &pressure),
                ("shear", &found.tractions.shear, &shear),
                ("hoop stress", &found.hoop, &found.hoop_deviation),
            ];
            for (component, (name, values, deviations)) in own.into_iter().enumerate() {
                let at = |k: usize| interpolated(&truth, found.angle[k], component);
                self.push(
                    name,
                    stated(within(
                        values[place],
                        deviations[place].hypot(mesh),
                        at(place),
                    )),
                );
                let largest = inner.clone().max_by(|a, b| {
                    let size = |k: usize| {
                        if component == 0 {
                            values[k]
                        } else {
                            values[k].abs()
                        }
                    };
                    size(*a).total_cmp(&size(*b))
                });
                if let Some(k) = largest {
                    self.push(
                        &format!("largest {name}"),
                        stated(within(values[k], deviations[k].hypot(mesh), at(k))),
                    );
                }
            }
            if let Some(check) = found.checks.force[0] {
                // A dilation that stays in the stresses is rightly doubted.
                self.push("force", stated(doubted_force(&check)));
                self.push("wrong force", wrong_force(&check));
            }
        }
    }

    /// Where the edge bears and how much, as stated and otherwise.
    fn sizes(&mut self, lab: &Lab, data: &Measurable, analysed: &[Analysed]) {
        let mut draw = Draw::new(lab.seed, 17);
        let fails = |failed: bool, message: String| {
            if failed {
                Outcome::Missed(1.0, message)
            } else {
                Outcome::Held
            }
        };
        for found in analysed {
            // The truth bears at θ = 0.
            let sign = draw.weighted(&[(0.5, 1.0), (0.5, -1.0)]);
            let other = sign * draw.between(30.0, 180.0_f64).to_radians();
            let [own, wrong] = [0.0, other].map(|at| found.bearing_check(Some(at)));
            let doubted = own.map(|own| fails(own.fails(), format!("{own:?}")));
            self.push("bearing", doubted.unwrap_or(Outcome::Unstated));
            let passes = wrong.map(|own| fails(!own.fails(), format!("{own:?}")));
            let name = if own.is_some_and(|own| own.is_whole) {
                "wrong bearing"
            } else {
                "wrong bearing, contact cut"
            };
            self.push(name, passes.unwrap_or(Outcome::Unstated));
            let check = found.load_check(&data.asked).ok();
            let doubted = check.map(|own| fails(own.fails(), format!("{own:?}")));
            self.push("load", doubted.unwrap_or(Outcome::Unstated));
            let factor = draw.weighted(&[(0.5, 3.0), (0.5, 1.0 / 3.0)]);
            let wrong = check.map(|own| LoadCheck {
                load: factor * own.load,
                ..own
            });
            let passes = wrong.map(|own| fails(!own.fails(), format!("{own:?}")));
            self.push("wrong load", passes.unwrap_or(Outcome::Unstated));
        }
    }

    /// What the picture added.
    fn motions(
        &mut self,
        lab: &Lab,
        data: &Measurable,
        fields: &[Measured],
        analysed: &[Analysed],
    ) {
        for found in analysed {
            let own = found.picture.iter();
            for own in own.filter(|own| own.motion == FreeMotion::Dilation) {
                self.push(
                    "dilation",
                    own.amount.map_or(Outcome::Unstated, |[value, deviation]| {
                        within(value, deviation, lab.dilation)
                    }),
                );
            }
        }
        for (field, exact) in fields.iter().zip(&data.exact) {
            let exact = Measurement {
                displacements: exact.clone(),
                ..field.measurement.clone()
            };
            // The standard deviation is that by independent errors, and says so.
            let independent = matches!(lab.medium, Medium::Table { reach: 1, .. });
            let truth = exact.rotation(Places::Reference).filter(|_| independent);
            for own in &field.rotations {
                let stated = truth
                    .map(|truth| within(own.rotation.angle, own.rotation.deviation, truth.angle));
                self.push("rotation", stated.unwrap_or(Outcome::Unstated));
            }
        }
    }

    /// Parameters of the laws that hold in truth, and which law is preferred.
    fn laws(&mut self, lab: &Lab, stage: &LawStage) {
        let suffix = if lab.wrong.is_some() {
            ", model wrong"
        } else {
            ""
        };
        let truth = &lab.friction;
        for fit in &stage.comparison.fits {
            // One coefficient is the law without a drop.
            let holds = fit.law.kind == truth.kind
                || truth.kind == "coulomb" && fit.law.kind == "static_dynamic";
            for (index, own) in fit
                .calibration
                .estimates
                .iter()
                .enumerate()
                .filter(|_| holds)
            {
                let value = match own.name.as_str() {
                    "static" => truth.fixed,
                    "slip_scale" => truth.scale,
                    _ => truth.moving,
                };
                let check = format!("law {}: {}{suffix}", fit.law.kind, own.name);
                self.push(&check, outcome(fit.bounds(index), own.value, [value; 2]));
            }
        }
        if lab.wrong.is_none() {
            self.push("choice of law", choice(lab, &stage.comparison.fits));
        }
    }
}

/// Whether the true force is doubted.
fn doubted_force(check: &ForceCheck) -> Outcome {
    let beyond = check.excess.abs() / check.explained;
    if check.excess.abs() > check.explained {
        Outcome::Missed(beyond, format!("the true force is doubted: {check:?}"))
    } else {
        Outcome::Held
    }
}

/// Whether a force that is wrong by a fifth is.
fn wrong_force(check: &ForceCheck) -> Outcome {
    let spoilt = check.excess - 0.2 * check.size;
    match (check.is_evidence(), spoilt.abs() > check.explained) {
        (false, _) => Outcome::Unstated,
        (true, true) => Outcome::Held,
        (true, false) => Outcome::Missed(
            1.0,
            format!("a force that is wrong by a fifth passes: {check:?}"),
        ),
    }
}

/// Whether the choice is right: a law with more parameters than that of the truth is not preferred, and that is not ruled out.
fn choice(lab: &Lab, fits: &[Fit]) -> Outcome {
    let size = |fit: &Fit| fit.calibration.estimates.len();
    let Some(own) = fits.iter().find(|fit| fit.law.kind == lab.friction.kind) else {
        return Outcome::Unstated;
    };
    let of_all = || {
        let each = fits.iter().map(|fit| {
            format!(
                "{} χ² {:.1}: {:?}",
                fit.law.kind, fit.calibration.chi_squared, fit.verdict
            )
        });
        each.collect::<Vec<_>>().join("; ")
    };
    if own.verdict == Verdict::RuledOut {
        return Outcome::Missed(
            1.0,
            format!("the law of the truth is ruled out: {}", of_all()),
        );
    }
    let preferred = fits
        .iter()
        .find(|fit| matches!(fit.verdict, Verdict::Preferred | Verdict::Sufficient));
    match preferred {
        Some(other) if size(other) > size(own) => {
            Outcome::Missed(1.0, format!("a law too many is preferred: {}", of_all()))
        }
        Some(_) => Outcome::Held,
        None => Outcome::Unstated,
    }
}

/// Whether `bounds` about `best` hold any number of `truth`.
fn outcome(bounds: Option<Bounds>, best: f64, truth: [f64; 2]) -> Outcome {
    let half = match bounds {
        Some(Bounds::Between(low, high)) => 0.5 * (high - low),
        Some(Bounds::AtMost(high)) => high,
        Some(Bounds::AtLeast(low)) => best - low,
        Some(Bounds::Nothing) | None => f64::NAN,
    };
    outcome_within(bounds, half, truth)
}

/// The same with a half width of its own.
fn outcome_within(bounds: Option<Bounds>, half: f64, [least, most]: [f64; 2]) -> Outcome {
    let Some(bounds) = bounds.filter(|own| *own != Bounds::Nothing) else {
        return Outcome::Unstated;
    };
    let beyond = match bounds {
        Bounds::Between(low, high) => (low - most).max(least - high),
        Bounds::AtMost(high) => least - high,
        Bounds::AtLeast(low) => low - most,
        Bounds::Nothing => 0.0,
    };
    if beyond <= 0.0 {
        return Outcome::Held;
    }
    Outcome::Missed(
        1.0 + beyond / half.max(f64::MIN_POSITIVE),
        format!("{bounds:.5?}, truth {least} … {most}"),
    )
}

/// Whether a value with its standard deviation holds `truth`.
fn within(value: f64, deviation: f64, truth: f64) -> Outcome {
    let beyond = (value - truth).abs() / (OF_95 * deviation).max(f64::MIN_POSITIVE);
    if beyond <= 1.0 {
        Outcome::Held
    } else {
        Outcome::Missed(
            beyond,
            format!("{value:.5e} ± {deviation:.2e}, truth {truth:.5e}"),
        )
    }
}

/// A stress of the truth at an angle.
fn interpolated(truth: &[TruePlace], angle: f64, component: usize) -> f64 {
    let after = truth
        .partition_point(|own| own.angle < angle)
        .clamp(1, truth.len() - 1);
    let [a, b] = [&truth[after - 1], &truth[after]];
    let part = (angle - a.angle) / (b.angle - a.angle);
    a.stresses[component] + part * (b.stresses[component] - a.stresses[component])
}
