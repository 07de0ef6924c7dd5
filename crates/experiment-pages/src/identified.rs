//! Friction on the page, as a table, and in the summary.

mod figures;

use serde_json::{Value, json};
use stickslip_hybrid::identify::{Bounds, SlipFit};
use stickslip_report::table::Table;

use crate::findings::on_half_the_cells;
use crate::report::ExperimentReport;
use stickslip_experiment::Experiment;
use stickslip_measure::analysed::{Analysed, true_edge};
use stickslip_measure::chain::Friction;
use stickslip_measure::identified::{
    CONSISTENT, Grip, Identified, SlipZone, describe_bounds, ratio, static_friction,
};
use stickslip_measure::truth::Truth;
use stickslip_report::csv;

/// What is said of either coefficient where nothing touches the edge.
const NO_CONTACT: &str = "no pressure on the edge: no contact, no friction to identify";
/// The same where contact cannot be resolved.
const HIDDEN: &str = "not identifiable: no pressure on the edge exceeds its uncertainty";

/// Stands in place of an interval where χ² rejects one coefficient.
const REJECTED: &str = "no interval: one coefficient is rejected, for this zone or for all";

/// What is reported, and its source.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrictionResults<'a> {
    pub(crate) experiment: &'a Experiment,
    pub(crate) analysed: &'a [Analysed],
    pub(crate) friction: &'a Friction,
    pub(crate) truth: Option<&'a Truth>,
}

/// Reports friction.
pub(crate) fn report(results: &FrictionResults<'_>, report: &mut ExperimentReport) {
    let (experiment, identified) = (results.experiment, &results.friction.identified);
    report.section("Friction");
    report.text(include_str!("identified/text.txt").trim_end());
    answers(results, report);
    mesh(results, report);
    report.findings(
        experiment,
        results.friction.findings(experiment, results.analysed),
    );
    if results.bears() || identified.dynamic.is_some() {
        report.table(table(experiment, results.analysed, identified));
        let truth: Vec<_> = (results.analysed.iter())
            .map(|found| true_edge(experiment, results.truth, found.state))
            .collect();
        report.figure(
            "friction",
            "Shear over pressure along the edge, the zones that slip, and the coefficient that they share with its interval; where the \
             truth is known it is a thin line.",
            figures::friction(experiment, results.analysed, identified, &truth),
        );
    }
    report.file(
        "friction.csv",
        "shear over pressure at all places in contact",
        csv(experiment, results.analysed),
    );
    report.entry("friction", entry(results));
}

impl FrictionResults<'_> {
    /// Whether any edge bears pressure beyond doubt.
    fn bears(&self) -> bool {
        self.analysed.iter().any(|found| found.contact().is_some())
    }

    /// Why there is no result where no edge bears.
    fn without(&self) -> &'static str {
        if self.analysed.iter().all(Analysed::is_free) {
            NO_CONTACT
        } else {
            HIDDEN
        }
    }

    /// What is known of static friction.
    fn of_static(&self) -> String {
        match self.friction.identified.dynamic {
            None if !self.bears() => self.without().to_owned(),
            _ => {
                let confidence = 100.0 * self.experiment.identify.confidence;
                let found = describe_static(self.experiment, &self.friction.identified, confidence);
                let [from, to] = static_friction::RATIOS;
                match &self.friction.moves {
                    Some(Ok(fringes)) => format!(
                        "{found}. {to} instead of {from} times μd deforms the hole's edge by at most {fringes:.2} fringes"
                    ),
                    _ => found,
                }
            }
        }
    }
}

/// Both coefficients and the simulation.
fn answers(results: &FrictionResults<'_>, report: &mut ExperimentReport) {
    let (experiment, identified) = (results.experiment, &results.friction.identified);
    let confidence = 100.0 * experiment.identify.confidence;
    match &identified.dynamic {
        Some(fit) => {
            report.answer(
                "Dynamic friction μd",
                describe_dynamic(identified, fit, confidence),
            );
        }
        None if !results.bears() => report.answer("Dynamic friction μd", results.without()),
        None => report.answer(
            "Dynamic friction μd",
            "not identifiable: no slip zone is recognised",
        ),
    }
    report.answer("Static friction μs", results.of_static());
    let explained = identified.is_explained();
    if let Some(simulation) = identified.simulation.as_ref().filter(|_| explained) {
        report.text(format!(
            "Monte Carlo simulation of {} draws of the noise around the fit: mean {:.4}, standard deviation {:.4}, {confidence} % of them \
             between {:.4} and {:.4}.",
            simulation.samples,
            simulation.mean,
            simulation.deviation,
            simulation.interval[0],
            simulation.interval[1]
        ));
    }
}

/// What half of the cells say.
fn mesh(results: &FrictionResults<'_>, report: &mut ExperimentReport) {
    let coarser = match &results.friction.coarser {
        Ok(Some(coarser)) => coarser,
        Ok(None) => return,
        Err(cause) => {
            report.text(format!(
                "The interval does not hold the error of the mesh, because half of the cells do not show it: {cause}."
            ));
            return;
        }
    };
    let held = match results.friction.identified.mesh {
        Some(_) => "Intervals hold this difference as an error of the mesh.",
        None => "The interval does not hold the error of the mesh.",
    };
    let dynamic = coarser.dynamic.as_ref().map(|fit| (fit.mu, fit.bounds));
    let text = on_half_the_cells(coarser.cells, dynamic);
    report.text(format!("{text} {held}"));
}

/// The coefficient `fit` of all zones with its bounds, or why it has none.
pub(super) fn describe_dynamic(identified: &Identified, fit: &SlipFit, confidence: f64) -> String {
    if !identified.is_explained() {
        return format!(
            "{:.4} at best; no interval: one coefficient for all zones is rejected, χ² = {:.1} with {} degrees of freedom{}",
            fit.mu,
            fit.chi_squared,
            fit.degrees,
            if identified.zones_agree {
                ""
            } else {
                ", more than those of the zones by themselves"
            }
        );
    }
    let bounds = identified.dynamic_bounds().unwrap_or(Bounds::Nothing);
    let interval = describe_bounds(bounds);
    match bounds {
        Bounds::Between(..) => format!("{:.4}, {interval} ({confidence} %)", fit.mu),
        Bounds::AtMost(_) | Bounds::AtLeast(_) => format!("{interval} ({confidence} %)"),
        Bounds::Nothing => interval,
    }
}

fn describe_static(experiment: &Experiment, identified: &Identified, confidence: f64) -> String {
    if let Some(grip) = identified.static_bound() {
        let [from, to] = grip.angles.map(f64::to_degrees);
        return format!(
            "at least {:.4} ({confidence} %), exceeded by shear over pressure all along θ = {from:.1} to {to:.1}° in state '{}', which \
             sticks; no upper bound: not identifiable beyond that",
            grip.at_least, experiment.states[grip.state].name
        );
    }
    let stuck = identified.grip.is_some() && identified.dynamic.is_some();
    let text = if stuck {
        "not identifiable: at least μd, and no point certainly sticks at a larger ratio of tractions than points that slip have"
    } else {
        "not identifiable: nothing that clearly sticks beside a slip zone is wide enough"
    };
    text.to_owned()
}

fn table(experiment: &Experiment, analysed: &[Analysed], identified: &Identified) -> Table {
    let headings = "state | from [deg] | to [deg] | places | friction along | μ | bounds | χ² | degrees of freedom";
    let zones = &identified.zones;
    let mut table = Table::headed("Zones that slip", headings);
    for zone in zones {
        let [from, to] = angles(analysed, zone).map(|angle| format!("{angle:.1}"));
        let along = if zone.positive { "+θ" } else { "−θ" };
        let own = [
            experiment.states[zone.state].name.clone(),
            from,
            to,
            zone.places.len().to_string(),
            along.to_owned(),
        ];
        let fit = fit_cells(&zone.fit, identified.zone_bounds(zone));
        table.push(own.into_iter().chain(fit));
    }
    if let Some(fit) = identified.dynamic.as_ref().filter(|_| zones.len() > 1) {
        let places: usize = zones.iter().map(|zone| zone.places.len()).sum();
        let own = ["all together", "", "", &places.to_string(), ""].map(str::to_owned);
        let fit = fit_cells(fit, identified.dynamic_bounds());
        table.push(own.into_iter().chain(fit));
    }
    table
}

fn fit_cells(fit: &SlipFit, bounds: Option<Bounds>) -> [String; 4] {
    [
        format!("{:.4}", fit.mu),
        bounds.map_or_else(|| REJECTED.to_owned(), describe_bounds),
        format!("{:.1}", fit.chi_squared),
        fit.degrees.to_string(),
    ]
}

/// First and last angle of a zone, in degrees.
fn angles(analysed: &[Analysed], zone: &SlipZone) -> [f64; 2] {
    let found = analysed.iter().find(|found| found.state == zone.state);
    let at = |k: usize| {
        found
            .and_then(|found| found.angle.get(k))
            .map_or(f64::NAN, |angle| angle.to_degrees())
    };
    [at(zone.places.start), at(zone.places.end.saturating_sub(1))]
}

fn csv(experiment: &Experiment, analysed: &[Analysed]) -> Vec<u8> {
    let mut rows = vec![csv::headings(
        "state | theta [deg] | ratio tau/p | deviation",
    )];
    for found in analysed {
        for k in found.contact().unwrap_or(0..0) {
            let (ratio, deviation) = ratio(found, k);
            let name = experiment.states[found.state].name.clone();
            let angle = found.angle[k].to_degrees();
            let [angle, ratio, deviation] = [angle, ratio, deviation].map(|own| own.to_string());
            rows.push(vec![name, angle, ratio, deviation]);
        }
    }
    csv::texts(rows)
}

fn entry(results: &FrictionResults<'_>) -> Value {
    let (experiment, identified) = (results.experiment, &results.friction.identified);
    let grip = identified.static_bound();
    let bearings = results.analysed.iter().map(|found| {
        let check = found.bearing_check(experiment.identify.bearing);
        json!({
            "state": experiment.states[found.state].name,
            "bearing_degrees": check.map(|own| own.bearing.to_degrees()),
            "direction_degrees": check.map(|own| own.direction.to_degrees()),
            "deviation_degrees": check.map(|own| own.deviation.to_degrees()),
            "beyond_degrees": check.map(|own| own.beyond.to_degrees()),
            "doubtful": check.map(|own| own.fails()),
        })
    });
    let zones = identified.zones.iter().map(|zone| {
        json!({
            "state": experiment.states[zone.state].name,
            "places": zone.places.len(),
            "along_theta": zone.positive,
            "given": zone.given,
            "mu": fit_entry(&zone.fit, identified.zone_bounds(zone)),
        })
    });
    json!({
        "confidence": experiment.identify.confidence,
        "mu_dynamic": identified.dynamic.as_ref().map(|fit| fit_entry(fit, identified.dynamic_bounds())),
        "half_the_cells": results.friction.coarser.as_ref().ok().and_then(Option::as_ref).map(|coarser| json!({
            "cells": coarser.cells,
            "mu_dynamic": coarser.dynamic.as_ref().map(|fit| fit_entry(fit, fit.is_consistent(CONSISTENT).then_some(fit.bounds))),
        })),
        "mesh_error": identified.mesh,
        "simulation": identified.simulation.filter(|_| identified.is_explained()).map(|simulation| json!({
            "samples": simulation.samples,
            "mean": simulation.mean,
            "deviation": simulation.deviation,
            "interval": simulation.interval,
        })),
        "mu_static": {
            "low": grip.map(|grip| grip.at_least),
            "high": null,
            "by": grip.map(|grip| grip_entry(experiment, grip)),
            "fringes": results.friction.moves.as_ref().and_then(|moves| moves.as_ref().ok()),
            "in_words": results.of_static(),
        },
        "zones": zones.collect::<Vec<_>>(),
        "bearing": bearings.collect::<Vec<_>>(),
    })
}

fn grip_entry(experiment: &Experiment, grip: &Grip) -> Value {
    json!({
        "state": experiment.states[grip.state].name,
        "from_degrees": grip.angles[0].to_degrees(),
        "to_degrees": grip.angles[1].to_degrees(),
        "ratio": grip.ratio,
    })
}

/// A coefficient with its interval, if it has one.
fn fit_entry(fit: &SlipFit, bounds: Option<Bounds>) -> Value {
    let [low, high] = bounds.map_or([None; 2], Bounds::ends);
    json!({
        "best": fit.mu,
        "low": low,
        "high": high,
        "chi_squared": fit.chi_squared,
        "degrees_of_freedom": fit.degrees,
        "rejected": bounds.is_none(),
        "in_words": bounds.map_or_else(|| REJECTED.to_owned(), describe_bounds),
    })
}
