//! `cargo xtask cosine`: the assumed cosine load against computed contact.
//!
//! The same joint, a hole in a laminated strip, is solved with the pressure 4P/(π D t) cos θ that handbooks assume and with a steel bolt
//! in contact, over clearance, friction and lay-up. Stresses are over P/(D t) at the load step `compared`, one of the bearing stresses
//! `means`; first-ply failure is at its own load.

use stickslip::results::{BodyFailure, FirstPly};
use toml::Table;

use crate::study::record::{curve, fields, needed, numbers, solved, text};
use crate::study::table::Tables;
use crate::study::{Study, TaskError, solved_side_by_side};

pub(crate) const STUDY: Study = Study {
    name: "cosine",
    solve: |cases| solved_side_by_side(cases, joint),
    complete: beside_assumed,
};

/// Hole radius of both scenes `[mm]`.
const RADIUS: f64 = 3.0;

fn joint(case: &Table) -> Result<Vec<Table>, TaskError> {
    let results = solved(case)?;
    let (means, mean) = (numbers(case, "means"), needed(case, "compared")?);
    let step = means
        .iter()
        .position(|own| *own == mean)
        .ok_or("no such step")?;
    let (geometry, edge) = (&results.edges[0], &results.steps[step].edges[0]);
    // θ `[degree]`, −σ_r, σ_θ, τ_rθ over half of the edge.
    let profile: Vec<[f64; 4]> = (edge.rows.iter().zip(&geometry.parameter))
        .filter(|(_, theta)| **theta >= 0.0)
        .map(|(row, theta)| {
            let [pressure, hoop, shear] =
                [-row.sigma_normal, row.sigma_tangential, row.tau].map(|stress| stress / mean);
            [theta.to_degrees(), pressure, hoop, shear]
        })
        .collect();
    let net = profile.iter().find(|row| (row[0] - 90.0).abs() < 1e-6);
    let net = net.ok_or("no node at 90°")?[2];
    let peak = |column: usize| {
        let largest = profile
            .iter()
            .max_by(|a, b| a[column].total_cmp(&b[column]));
        largest.map_or([f64::NAN; 2], |row| [row[column], row[0]])
    };
    let ([pressure, pressure_at], [hoop, hoop_at]) = (peak(1), peak(2));
    let end = match text(case, "load")? {
        "cosine" => 90.0,
        _ => edge.contact_half_extent.map_or(f64::NAN, f64::to_degrees),
    };
    let mut row = case.clone();
    row.extend(fields([
        ("peak_hoop", hoop.into()),
        ("peak_hoop_angle_deg", hoop_at.into()),
        ("hoop_at_90_deg", net.into()),
        ("peak_pressure", pressure.into()),
        ("peak_pressure_angle_deg", pressure_at.into()),
        (
            "peak_shear",
            profile
                .iter()
                .fold(0.0, |most: f64, row| row[3].abs().max(most))
                .into(),
        ),
        ("contact_end_deg", end.into()),
        (
            "pressures",
            curve(profile.iter().map(|row| [row[0], row[1]])),
        ),
        ("hoops", curve(profile.iter().map(|row| [row[0], row[2]]))),
    ]));
    let failure = results
        .failure
        .first()
        .ok_or("the scene has no [failure]")?;
    for first in failure.first_ply.iter().flatten() {
        row.extend(first_ply(failure, first, &means));
    }
    Ok(vec![row])
}

/// First-ply failure by one criterion: bearing stress, ply, mode and place.
fn first_ply(failure: &BodyFailure, first: &FirstPly, means: &[f64]) -> Table {
    let end = means[first.step];
    let bearing = if first.reached {
        let start = first.step.checked_sub(1).map_or(0.0, |step| means[step]);
        start + first.factor * (end - start)
    } else {
        end * first.factor
    };
    let polar = failure.polar(first.at.position);
    let (theta, r) = polar.unwrap_or((f64::NAN, f64::NAN));
    let own = fields([
        ("bearing_MPa", bearing.into()),
        ("reached", first.reached.into()),
        ("ply", failure.ply_name(first.at.ply).into()),
        ("mode", first.at.mode.to_string().into()),
        ("angle_deg", theta.to_degrees().into()),
        ("r_over_R", (r / RADIUS).into()),
    ]);
    let criterion = first.at.criterion;
    own.into_iter()
        .map(|(key, value)| (format!("{criterion}_{key}"), value))
        .collect()
}

/// Puts beside each row with a bolt, under `assumed_…`, what its lay-up has with the assumed load.
fn beside_assumed(tables: &mut Tables) {
    let is_assumed = |row: &&Table| text(row, "load").is_ok_and(|load| load == "cosine");
    let rows = tables.get("cosine").into_iter().flatten();
    let assumed: Vec<Table> = rows.filter(is_assumed).cloned().collect();
    for row in tables.values_mut().flatten() {
        let own = assumed
            .iter()
            .find(|own| own.get("layup") == row.get("layup"));
        for (key, value) in own.into_iter().flatten() {
            row.insert(format!("assumed_{key}"), value.clone());
        }
    }
}
