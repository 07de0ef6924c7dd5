//! Friction on the page, as a table, and in the summary.

mod figures;

use std::fmt::Write as _;

use serde_json::{Value, json};
use stickslip_hybrid::identify::{Bounds, SlipFit};
use stickslip_report::table::{Column, Table};

use crate::experiment::findings::on_half_the_cells;
use crate::experiment::story::Story;
use stickslip_measure::analysed::{Analysed, true_edge};
use stickslip_measure::chain::Friction;
use stickslip_measure::identified::{
    CONSISTENT, Grip, Identified, SlipZone, ratio, static_friction, words,
};
use stickslip_measure::truth::Truth;
use stickslip_scene::experiment::Experiment;

/// What is said of either coefficient where nothing touches the edge.
const NO_CONTACT: &str = "no pressure on the edge: no contact, no friction to identify";
/// The same where contact cannot be resolved.
const HIDDEN: &str = "not identifiable: no pressure on the edge exceeds its uncertainty";

/// Stands in place of an interval where χ² rejects one coefficient.
const REJECTED: &str = "no interval: one coefficient is rejected, for this zone or for all";

/// What is reported, and its source.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Told<'a> {
    pub(crate) experiment: &'a Experiment,
    pub(crate) analysed: &'a [Analysed],
    pub(crate) friction: &'a Friction,
    pub(crate) truth: Option<&'a Truth>,
}

/// Tells of friction.
pub(crate) fn tell(told: &Told<'_>, story: &mut Story) {
    let (experiment, identified) = (told.experiment, &told.friction.identified);
    story.section("Friction");
    story.text(
        "Where an edge slips, the shear is μ times the pressure, and both are uncertain with errors that go together; μ is where χ² of \
         τ − μp is least, and its interval is that in which χ² rises no further than chance would have it. Slip starts at the ends of \
         contact. A zone goes from there inwards as far as one coefficient explains it and its inner parts ask for no lesser one; at either end twice the angle that the edge \
         resolves is left out, where stresses are not smooth. That angle is a cell, or more where the smoothing goes on beyond cells.",
    );
    answers(told, story);
    mesh(told, story);
    story.report(
        experiment,
        told.friction.findings(experiment, told.analysed),
    );
    if told.bears() || identified.dynamic.is_some() {
        story.table(table(experiment, told.analysed, identified));
        let truth: Vec<_> = (told.analysed.iter())
            .map(|found| true_edge(experiment, told.truth, found.state))
            .collect();
        story.figure(
            "friction",
            "Shear over pressure along the edge, the zones that slip, and the coefficient that they share with its interval; where the \
             truth is known it is a thin line.",
            figures::friction(experiment, told.analysed, identified, &truth),
        );
    }
    story.file(
        "friction.csv",
        "shear over pressure at all places in contact",
        csv(experiment, told.analysed),
    );
    story.entry("friction", entry(told));
}

impl Told<'_> {
    /// Whether any edge bears pressure beyond doubt.
    fn bears(&self) -> bool {
        self.analysed.iter().any(|found| found.contact().is_some())
    }

    /// Words on edges that do not.
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
                let found = static_words(self.experiment, &self.friction.identified, confidence);
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
fn answers(told: &Told<'_>, story: &mut Story) {
    let (experiment, identified) = (told.experiment, &told.friction.identified);
    let confidence = 100.0 * experiment.identify.confidence;
    match &identified.dynamic {
        Some(fit) => {
            story.answer(
                "Dynamic friction μd",
                dynamic_words(identified, fit, confidence),
            );
        }
        None if !told.bears() => story.answer("Dynamic friction μd", told.without()),
        None => story.answer(
            "Dynamic friction μd",
            "not identifiable: no slip zone is recognised",
        ),
    }
    story.answer("Static friction μs", told.of_static());
    let explained = identified.is_explained();
    if let Some(simulation) = identified.simulation.as_ref().filter(|_| explained) {
        story.text(format!(
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
fn mesh(told: &Told<'_>, story: &mut Story) {
    let coarser = match &told.friction.coarser {
        Ok(Some(coarser)) => coarser,
        Ok(None) => return,
        Err(cause) => {
            story.text(format!(
                "The interval does not hold the error of the mesh, because half of the cells do not show it: {cause}."
            ));
            return;
        }
    };
    let held = match told.friction.identified.mesh {
        Some(_) => "Intervals hold this difference as an error of the mesh.",
        None => "The interval does not hold the error of the mesh.",
    };
    let dynamic = coarser.dynamic.as_ref().map(|fit| (fit.mu, fit.bounds));
    let words = on_half_the_cells(coarser.cells, dynamic);
    story.text(format!("{words} {held}"));
}

/// The coefficient `fit` of all zones with its bounds, or why it has none.
pub(super) fn dynamic_words(identified: &Identified, fit: &SlipFit, confidence: f64) -> String {
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
    let told = words(bounds);
    match bounds {
        Bounds::Between(..) => format!("{:.4}, {told} ({confidence} %)", fit.mu),
        Bounds::AtMost(_) | Bounds::AtLeast(_) => format!("{told} ({confidence} %)"),
        Bounds::Nothing => told,
    }
}

fn static_words(experiment: &Experiment, identified: &Identified, confidence: f64) -> String {
    if let Some(grip) = identified.static_bound() {
        let [from, to] = grip.angles.map(f64::to_degrees);
        return format!(
            "at least {:.4} ({confidence} %), exceeded by shear over pressure all along θ = {from:.1} to {to:.1}° in state '{}', which \
             sticks; no upper bound: not identifiable beyond that",
            grip.at_least, experiment.states[grip.state].name
        );
    }
    let stuck = identified.grip.is_some() && identified.dynamic.is_some();
    let words = if stuck {
        "not identifiable: at least μd, and nothing sticks beyond doubt at a larger ratio than slip has"
    } else {
        "not identifiable: nothing that clearly sticks beside a slip zone is wide enough"
    };
    words.to_owned()
}

fn table(experiment: &Experiment, analysed: &[Analysed], identified: &Identified) -> Table {
    let columns = vec![
        Column::new("state", ""),
        Column::new("from", "deg"),
        Column::new("to", "deg"),
        Column::new("places", ""),
        Column::new("friction along", ""),
        Column::new("μ", ""),
        Column::new("bounds", ""),
        Column::new("χ²", ""),
        Column::new("degrees of freedom", ""),
    ];
    let mut table = Table::new("Zones that slip", columns);
    for zone in &identified.zones {
        let [from, to] = angles(analysed, zone);
        table.push(row(
            &experiment.states[zone.state].name,
            [format!("{from:.1}"), format!("{to:.1}")],
            zone.places.len(),
            if zone.positive { "+θ" } else { "−θ" },
            (&zone.fit, identified.zone_bounds(zone)),
        ));
    }
    if let (Some(fit), true) = (&identified.dynamic, identified.zones.len() > 1) {
        let places = identified.zones.iter().map(|zone| zone.places.len()).sum();
        table.push(row(
            "all together",
            [String::new(), String::new()],
            places,
            "",
            (fit, identified.dynamic_bounds()),
        ));
    }
    table
}

fn row(
    name: &str,
    [from, to]: [String; 2],
    places: usize,
    along: &str,
    (fit, bounds): (&SlipFit, Option<Bounds>),
) -> Vec<String> {
    vec![
        name.to_owned(),
        from,
        to,
        places.to_string(),
        along.to_owned(),
        format!("{:.4}", fit.mu),
        bounds.map_or_else(|| REJECTED.to_owned(), words),
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
    let mut text = "state,theta [deg],ratio tau/p,deviation\n".to_owned();
    for found in analysed {
        // Names of states have no characters that a table would have to quote.
        let name = &experiment.states[found.state].name;
        for k in found.contact().unwrap_or(0..0) {
            let (ratio, deviation) = ratio(found, k);
            let angle = found.angle[k].to_degrees();
            // Writing into a string does not fail.
            let _ = writeln!(text, "{name},{angle},{ratio},{deviation}");
        }
    }
    text.into_bytes()
}

fn entry(told: &Told<'_>) -> Value {
    let (experiment, identified) = (told.experiment, &told.friction.identified);
    let grip = identified.static_bound();
    let bearings = told.analysed.iter().map(|found| {
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
        "half_the_cells": told.friction.coarser.as_ref().ok().and_then(Option::as_ref).map(|coarser| json!({
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
            "fringes": told.friction.moves.as_ref().and_then(|moves| moves.as_ref().ok()),
            "in_words": told.of_static(),
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
    let (low, high) = match bounds {
        None | Some(Bounds::Nothing) => (None, None),
        Some(Bounds::Between(low, high)) => (Some(low), Some(high)),
        Some(Bounds::AtMost(high)) => (None, Some(high)),
        Some(Bounds::AtLeast(low)) => (Some(low), None),
    };
    json!({
        "best": fit.mu,
        "low": low,
        "high": high,
        "chi_squared": fit.chi_squared,
        "degrees_of_freedom": fit.degrees,
        "rejected": bounds.is_none(),
        "in_words": bounds.map_or_else(|| REJECTED.to_owned(), words),
    })
}
