//! Angles of the corner nodes of a round body: all bodies of a scene share them unless it divides one by itself.

use std::f64::consts::{PI, TAU};

use super::{NODE_LIMIT, too_many};
use crate::model::ModelError;
use crate::model::plan::BodyPlan;
use stickslip_scene::schema::{Division, Grading};

/// Growth of the angular spacing from one interval to the next.
const ANGLE_GROWTH: f64 = 1.15;

/// Angles of the corner nodes on the contact circle, from 0 to π (half) or to below 2π (whole).
pub(in crate::model) fn on_circles(
    body: &BodyPlan<'_>,
    half: bool,
) -> Result<Vec<f64>, ModelError> {
    let refuse = |what: String| ModelError::MeshSettings {
        body: body.name.to_owned(),
        what,
    };
    let upper = match &body.mesh.division {
        Division::AngleList(angles) => angles.clone(),
        Division::Angular(grading) => graded_angles(body.name, *grading)?,
        Division::Linear(_) | Division::Places(_) => {
            return Err(refuse(
                "a round contact is divided by an angle, such as spacing = \"1 deg\"".into(),
            ));
        }
    };
    let Some(&last) = upper.last() else {
        return Err(refuse("the list of angles is empty".into()));
    };
    let spans_half = (last - PI).abs() < 1e-9;
    if half && !spans_half {
        return Err(refuse(format!(
            "a half model needs angles from 0 to 180 deg; the last one is {:.6} deg",
            last.to_degrees()
        )));
    }
    if half || !spans_half {
        return Ok(upper);
    }
    let lower = upper[1..upper.len() - 1]
        .iter()
        .rev()
        .map(|angle| TAU - angle);
    Ok(upper.iter().copied().chain(lower).collect())
}

/// About how many intervals [`graded_angles`] makes: equal ones, growing ones, coarse ones.
fn interval_estimate(grading: Grading, fine_to: f64) -> f64 {
    let Grading {
        spacing,
        coarse_spacing,
        ..
    } = grading;
    let ratio = coarse_spacing.map_or(4.0, |coarse| (coarse / spacing).max(1.0));
    let growing = ratio.ln() / ANGLE_GROWTH.ln();
    fine_to / spacing + growing + (PI - fine_to) / (ratio * spacing)
}

/// Angles from 0 to π: equal spacing up to `fine_to`, then growing to the coarse spacing.
fn graded_angles(body: &str, grading: Grading) -> Result<Vec<f64>, ModelError> {
    let fine_to = grading.fine_to.map_or(PI, |angle| angle.min(PI));
    let count = interval_estimate(grading, fine_to);
    if count * count * 0.7 > NODE_LIMIT as f64 {
        return Err(too_many(body, count * count * 3.0));
    }
    let fine = ((fine_to / grading.spacing) - 1e-9).ceil().max(1.0);
    let spacing = fine_to / fine;
    let mut angles: Vec<f64> = (0..=fine as usize).map(|k| spacing * k as f64).collect();
    let rest = PI - fine_to;
    if rest > 1e-9 {
        let largest = grading.coarse_spacing.unwrap_or(4.0 * spacing).max(spacing);
        let mut widths = Vec::new();
        let (mut width, mut sum) = (spacing, 0.0);
        while sum < rest {
            width = (width * ANGLE_GROWTH).min(largest);
            widths.push(width);
            sum += width;
        }
        if widths.len() > 1 && sum - rest > 0.5 * width {
            sum -= widths.pop().unwrap_or(0.0);
        }
        let mut at = fine_to;
        for width in widths {
            at += width * rest / sum;
            angles.push(at);
        }
    }
    if let Some(last) = angles.last_mut() {
        *last = PI;
    }
    Ok(angles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn graded_angles_end_at_the_half_turn_and_grow_smoothly() {
        let grading = Grading {
            spacing: 1.125_f64.to_radians(),
            fine_to: Some(100.0_f64.to_radians()),
            coarse_spacing: Some(4.5_f64.to_radians()),
        };
        let angles = graded_angles("plate", grading).unwrap();
        assert_eq!((angles[0], angles[angles.len() - 1]), (0.0, PI));
        let widths: Vec<f64> = angles.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(
            widths
                .windows(2)
                .all(|pair| pair[1] / pair[0] < 1.3 && pair[1] / pair[0] > 0.75)
        );
        let equal = Grading {
            fine_to: None,
            coarse_spacing: None,
            ..grading
        };
        let uniform = graded_angles("plate", equal).unwrap();
        assert_eq!(uniform.len(), 161);
    }

    #[test]
    fn a_billion_nodes_are_refused_before_anything_is_allocated() {
        let tiny = Grading {
            spacing: 1e-5,
            fine_to: None,
            coarse_spacing: None,
        };
        let refused = graded_angles("plate", tiny);
        assert!(
            matches!(refused, Err(ModelError::TooManyNodes { gigabytes, .. }) if gigabytes > 100.0)
        );
    }
}
