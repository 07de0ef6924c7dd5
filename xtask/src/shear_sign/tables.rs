//! The study as comma-separated tables.

use super::case::{Phase, Plate, Row, Step};
use super::plies::Curve;
use super::study::{Study, of_report};
use crate::publish::Trouble;

const COLUMNS: [&str; 19] = [
    "family",
    "law",
    "plate",
    "clearance_in",
    "pin_ksi",
    "reversed_while_loading",
    "as_the_report_saw_it",
    "largest_load_reversed_lbf",
    "furthest_angle_of_report_deg",
    "furthest_load_lbf",
    "largest_of_peak",
    "largest_of_limit",
    "largest_angle_of_report_deg",
    "largest_load_lbf",
    "largest_sticks",
    "loading_400_lbf_changes_deg",
    "loading_900_lbf_changes_deg",
    "loading_1500_lbf_changes_deg",
    "unloading_700_lbf_changes_deg",
];

/// One line per case: what loading does, and where the sign changes at some loads, in angles of the report.
pub(crate) fn cases(study: &Study) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for row in &study.rows {
        let mut cells = vec![
            row.case.family.to_owned(),
            row.case.name.clone(),
            plate(row.case.plate).to_owned(),
            row.case.clearance.to_string(),
            row.case.pin.to_string(),
            row.loading().any(Step::is_reversed).to_string(),
            row.loading().any(Step::is_as_seen).to_string(),
        ];
        let last = row.loading().filter(|step| step.is_reversed()).last();
        cells.push(last.map_or_else(String::new, |step| step.load.to_string()));
        cells.extend(furthest(row));
        cells.extend(largest(row));
        let places = [
            (Phase::Loading, 400.0),
            (Phase::Loading, 900.0),
            (Phase::Loading, 1500.0),
            (Phase::Unloading, 700.0),
        ];
        cells.extend(
            places.map(|(phase, load)| row.at(phase, load).map_or_else(String::new, changes)),
        );
        writer.write_record(&cells)?;
    }
    Ok(writer.into_inner()?)
}

pub(crate) fn plate(plate: Plate) -> &'static str {
    match plate {
        Plate::Plies => "[0_2/60_2/-60_2]s",
        Plate::Smeared => "smeared",
        Plate::Layup(layup) => layup,
    }
}

fn furthest(row: &Row) -> [String; 2] {
    let furthest = row
        .furthest()
        .and_then(|step| Some((step, step.reading.reach()?)));
    furthest.map_or_else(Default::default, |(step, reach)| {
        [format!("{:.2}", of_report(reach)), step.load.to_string()]
    })
}

fn largest(row: &Row) -> [String; 5] {
    let largest = row
        .most_reversed()
        .and_then(|step| Some((step, step.reading.reversal?)));
    largest.map_or_else(Default::default, |(step, reversal)| {
        [
            format!("{:.4}", reversal.of_peak),
            format!("{:.4}", reversal.of_limit),
            format!("{:.2}", of_report(reversal.angle)),
            step.load.to_string(),
            reversal.sticks.to_string(),
        ]
    })
}

/// Angles of the report where the sign changes, from the end of contact to the bearing point.
pub(crate) fn changes(step: &Step) -> String {
    let places = step.reading.crossings.iter().rev();
    let texts: Vec<String> = places
        .map(|&angle| format!("{:.1}", of_report(angle)))
        .collect();
    texts.join("; ")
}

/// Where the sign of the shear changes beneath the edge.
pub(crate) fn beneath(study: &Study) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "friction",
        "clearance_in",
        "load_lbf",
        "depth_over_thickness",
        "forward_at_bearing_point",
        "changes_deg",
    ])?;
    for arc in &study.arcs {
        let (forward, places) = arc.signs();
        let texts: Vec<String> = places
            .iter()
            .rev()
            .map(|&angle| format!("{:.1}", of_report(angle)))
            .collect();
        writer.write_record([
            arc.joint.friction.to_string(),
            arc.joint.clearance.to_string(),
            arc.load.to_string(),
            arc.depth.to_string(),
            forward.to_string(),
            texts.join("; "),
        ])?;
    }
    Ok(writer.into_inner()?)
}

/// Largest stress across the fibres of each ply.
pub(crate) fn plies(study: &Study) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "law",
        "cure_K",
        "clearance_in",
        "load_lbf",
        "ply_deg",
        "residual_ksi",
        "largest_ksi",
        "largest_at_deg",
        "at_20_deg_ksi",
        "at_30_deg_ksi",
        "at_150_deg_ksi",
        "cracked_from_deg",
        "cracked_to_deg",
    ])?;
    for curve in &study.curves {
        let Curve {
            name,
            cure,
            clearance,
            load,
            ply,
            residual,
            ..
        } = curve;
        let [angle, largest] = curve.peak();
        let mut cells = vec![(*name).to_owned()];
        cells.extend([cure, clearance, load, ply].map(ToString::to_string));
        let stresses = [
            *residual + 0.0,
            largest,
            angle,
            curve.at(20.0),
            curve.at(30.0),
            curve.at(150.0),
        ];
        cells.extend(stresses.map(|value| format!("{value:.3}")));
        let cracked = curve
            .cracked()
            .map(|range| range.map(|angle| format!("{angle:.1}")));
        cells.extend(cracked.unwrap_or_default());
        writer.write_record(&cells)?;
    }
    Ok(writer.into_inner()?)
}
