//! Measured fields: displacements with their standard deviation and their mask, from tables, fringe pictures or fringe lines.
//!
//! ```text
//! u = (N − N₀) / f      orders less those of the carrier, or of the null field with the same carrier
//! ```
//!
//! A picture shows neither whole orders nor the rigid motion of the plate: U and V are known up to a constant each and, where the
//! carrier is not known to the last digit, a rotation. Neither changes any stress. A finite rotation does, to second order, and is taken off
//! each table before its null field is, and off pictures after it.

mod combine;
mod coverage;
mod elsewhere;
mod field;
mod lines;
mod phase;
mod pictures;
mod reading;
mod rotation;
mod scatter;
mod scope;
mod symmetry;
mod table;

use std::collections::BTreeMap;

use stickslip_hybrid::data::{Field, Measurement};

use super::ends::span;
use super::error::ExperimentError;
use super::finding::{FieldFinding, Finding, Located, Part};
use super::synthesis::{Shot, Shots};
use stickslip_experiment::{Experiment, Source};

pub use field::{Measured, PictureField};
pub use rotation::TakenOff;

use field::range;
use reading::Reading;
use scope::Scope;

/// The measured field of a state; `shots` are its synthetic pictures.
///
/// # Errors
/// [`ExperimentError`]: files that cannot be read, invalid data, pictures without fringes, a region without data.
pub fn state(
    experiment: &Experiment,
    state: usize,
    shots: &Shots,
) -> Result<Measured, ExperimentError> {
    let plan = &experiment.states[state];
    let key = format!("states.{state}");
    let scope = |key: String| Scope {
        experiment,
        state,
        key,
    };
    let read = |source: &Source, key: &str, shot: Shot| {
        let scope = scope(match source {
            Source::Step(_) => "fringes".to_owned(),
            Source::Table(_) => format!("{key}.table"),
            Source::Pictures(_) => format!("{key}.pictures"),
            Source::Lines(_) => format!("{key}.lines"),
        });
        read(&scope, source, shot, shots)
    };
    let own = read(&plan.source, &key, Shot::State)?;
    let null = plan.null.as_ref();
    let null = null
        .map(|source| read(source, &format!("{key}.null"), Shot::Null))
        .transpose()?;
    let scope = scope(key.clone());
    let compared = experiment.reduce.symmetry.as_ref().zip(plan.back.as_ref());
    // The back has no null field, so that it is compared with the front as that was measured.
    let front = match (compared, &null) {
        (Some(_), Some(_)) => {
            let front = combine::combined(&scope, own.clone(), None)?;
            Some((front, symmetry::of_carriers(&own)))
        }
        _ => None,
    };
    let mut measured = combine::combined(&scope, own, null)?;
    if let Some((line, source)) = compared {
        let back = read(source, &format!("{key}.back"), Shot::Back)?;
        let back = combine::combined(&scope, back, None)?;
        let (front, of_carriers) =
            front.map_or((None, None), |(front, found)| (Some(front), found));
        let sides = symmetry::compared(&scope, line, front.as_ref().unwrap_or(&measured), &back)?;
        let of_back = back.findings.into_iter().map(|(_, finding)| finding);
        measured.found_in(Part::Back, of_back);
        measured.symmetry = sides.found;
        measured.found(sides.findings.into_iter().chain(of_carriers));
    }
    if matches!(plan.source, Source::Table(_)) {
        measured.found(large(&measured.measurement));
    }
    coverage::check(&scope, &measured)?;
    Ok(measured)
}

/// What `source` says of a state, its null field or its back.
fn read(
    scope: &Scope<'_>,
    source: &Source,
    shot: Shot,
    shots: &Shots,
) -> Result<Reading, ExperimentError> {
    match source {
        Source::Step(_) => pictures::synthetic(scope, shots.get(shot)),
        Source::Table(source) => table::read(scope, source),
        Source::Pictures(source) => {
            // What a null field with the same carrier takes off need not be reported.
            let null = &scope.experiment.states[scope.state].null;
            let takes_off = matches!(shot, Shot::State) && null.is_none();
            pictures::read(scope, source, takes_off)
        }
        Source::Lines(source) => lines::read(scope, source),
    }
}

/// States that have the same data, each group once: a table under two loads, or one that was saved twice.
pub fn repeated(experiment: &Experiment, fields: &[Measured]) -> Vec<Located> {
    // Masked displacements are NaN, which equals nothing.
    let bits = |measured: &Measured| -> Vec<u64> {
        let data = &measured.measurement;
        let places = data.places.iter().flatten();
        let displacements = data.displacements.iter().flatten();
        places.chain(displacements).map(|x| x.to_bits()).collect()
    };
    let mut groups: BTreeMap<Vec<u64>, Vec<String>> = BTreeMap::new();
    for measured in fields {
        let names = groups.entry(bits(measured)).or_default();
        names.push(experiment.states[measured.state].name.clone());
    }
    let shared = groups.into_values().filter(|names| names.len() > 1);
    let found = shared.map(|states| Finding::Field(FieldFinding::SameData { states }));
    found.map(Located::of_all).collect()
}

/// Displacements that differ by more than small strains allow: the mark of a wrong scale.
fn large(measurement: &Measurement) -> Option<Finding> {
    const STRAIN: f64 = 0.02;
    let places = measurement.places.iter();
    let extent = [0, 1].map(|axis| span(places.clone().map(|place| place[axis])));
    let range = Field::BOTH.map(|field| range(measurement, field));
    let of_extent = range[0].max(range[1]) / extent[0].hypot(extent[1]);
    let found = FieldFinding::LargeDisplacements { of_extent };
    (of_extent > STRAIN).then_some(Finding::Field(found))
}
