//! Stress across the fibres along the edge, where matrix cracks are to be expected.

use toml::Table;

use super::{begun, loads};
use crate::study::TaskError;
use crate::study::record::{curve, fields, needed, numbers, solved};

/// A row for each of the loads `looked_at` `[lbf]` and each ply. A half model serves: the laminate is balanced, so the mean stresses are
/// symmetric, and on the other half the ply of the opposite direction takes the place of each, which the results allow for.
pub(super) fn rows(case: &Table) -> Result<Vec<Table>, TaskError> {
    let results = solved(case)?;
    let failure = results
        .failure
        .first()
        .ok_or("the scene has no [failure]")?;
    let edge = failure.edges.first().ok_or("no edge")?;
    let stress = |value: f64| results.units.stress.from_base(value);
    let looked_at = numbers(case, "looked_at");
    let mut rows = Vec::new();
    for (load, own) in loads(case)
        .iter()
        .zip(&edge.steps)
        .filter(|(load, _)| looked_at.contains(load))
    {
        for (group, points) in failure.plies.iter().zip(own) {
            // Angle of the report on both sides of the pin, and σ₂.
            let mut profile: Vec<[f64; 2]> = (edge.parameter.iter().zip(points))
                .map(|(theta, point)| [90.0 - theta.to_degrees(), stress(point.stress[1])])
                .filter(|row| (-10.0..=190.0).contains(&row[0]))
                .collect();
            profile.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let largest = profile
                .iter()
                .max_by(|a, b| a[1].total_cmp(&b[1]))
                .ok_or("no place")?;
            let mut row = begun(case);
            row.extend(fields([
                ("load_lbf", (*load).into()),
                ("ply_deg", group.angle.into()),
                // Without minus zero.
                ("residual_ksi", (stress(group.residual[1]) + 0.0).into()),
                ("largest_ksi", largest[1].into()),
                ("largest_at_deg", largest[0].into()),
                ("at_20_deg_ksi", at(&profile, 20.0).into()),
                ("at_30_deg_ksi", at(&profile, 30.0).into()),
                ("at_150_deg_ksi", at(&profile, 150.0).into()),
                ("stress", curve(profile.iter().copied())),
            ]));
            if let Some([from, to]) = cracked(&profile, largest, needed(case, "strength_ksi")?) {
                row.extend(fields([
                    ("cracked_from_deg", from.into()),
                    ("cracked_to_deg", to.into()),
                ]));
            }
            rows.push(row);
        }
    }
    Ok(rows)
}

/// Value at an angle of the report `[degree]`, from the nearest node.
fn at(profile: &[[f64; 2]], angle: f64) -> f64 {
    let away = |row: &&[f64; 2]| (row[0] - angle).abs();
    let nearest = profile.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
    nearest.map_or(f64::NAN, |row| row[1])
}

/// Smallest and largest angle of the report of the stretch around the peak in which the strength is reached.
fn cracked(profile: &[[f64; 2]], peak: &[f64; 2], strength: f64) -> Option<[f64; 2]> {
    let top = profile.partition_point(|row| row[0] < peak[0]);
    let weak = |row: &&[f64; 2]| row[1] >= strength;
    let from = profile.get(..=top)?.iter().rev().take_while(weak).last()?;
    let to = profile.get(top..)?.iter().take_while(weak).last()?;
    Some([from[0], to[0]])
}
