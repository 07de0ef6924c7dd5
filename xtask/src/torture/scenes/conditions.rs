//! Conditions that a single answer meets, from its written results alone.
//!
//! Tolerances: solvers promise residuals of 1e-10 of the largest force. A node's traction is its force over its area, and areas differ
//! by up to the ratio of the mesh's spacings, so pressures carry [`ROUNDING`] of the largest pressure of their contact in the history.

use std::f64::consts::{FRAC_PI_2, TAU};

use serde_json::Value;
use stickslip::results::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow};
use stickslip_contact::Status;

use super::bound::{axis_and_plies, bound};
use super::quantity;
use super::sample::{Sample, Verdict};

/// What rounding and the solvers' residuals leave, relative to the largest number of its kind.
const ROUNDING: f64 = 1e-8;

/// A contact edge: its index among the results' edges, its text in the scene, and its geometry.
struct Contact<'a> {
    index: usize,
    text: &'a Value,
    geometry: &'a EdgeGeometry,
}

/// The contacts of a sample in the order of its results.
fn contacts(sample: &Sample) -> impl Iterator<Item = Contact<'_>> {
    let texts = quantity::list(&sample.value, "contacts");
    let edges = texts.enumerate().zip(&sample.results.edges);
    let contact = |((index, text), geometry)| Contact {
        index,
        text,
        geometry,
    };
    edges.map(contact).filter(|own| own.geometry.contact)
}

impl Contact<'_> {
    fn steps<'a>(&self, sample: &'a Sample) -> impl Iterator<Item = &'a EdgeResults> {
        let (index, steps) = (self.index, sample.results.steps.iter());
        steps.filter_map(move |step| step.edges.get(index))
    }

    fn most(&self, sample: &Sample, of: impl Fn(&EdgeRow) -> f64) -> f64 {
        let rows = self.steps(sample).flat_map(|edge| &edge.rows);
        rows.fold(0.0, |most: f64, row| most.max(of(row).abs()))
    }

    /// Areas of the nodes of a circle, and their relative error: an arc is longer than the chords that carry the loads by h²/24 for
    /// the angle h between corner nodes; twice that, for areas and directions, and twice again, for slopes, is allowed.
    fn areas(&self, sample: &Sample) -> Option<(Vec<f64>, f64)> {
        let EdgeKind::Circle { radius, .. } = self.geometry.kind else {
            return None;
        };
        let body = &sample.results.bodies[self.geometry.body].name;
        let scale = radius * sample.thickness(body)?;
        let areas = areas(self.geometry, scale)?;
        let steps = (self.geometry.parameter.windows(2)).map(|pair| pair[1] - pair[0]);
        let is_quadratic = self.geometry.corner.contains(&false);
        let corners = if is_quadratic { 2.0 } else { 1.0 };
        let step = corners * steps.fold(0.0, f64::max);
        Some((areas, step * step / 6.0 + ROUNDING))
    }

    /// The first row of which `wrong` says something.
    fn first(
        &self,
        sample: &Sample,
        wrong: impl Fn(usize, &EdgeRow, f64) -> Option<String>,
    ) -> Option<String> {
        self.steps(sample).enumerate().find_map(|(step, edge)| {
            let rows = self.geometry.parameter.iter().zip(&edge.rows);
            rows.into_iter().find_map(|(place, row)| {
                let found = wrong(step, row, *place)?;
                let place = match self.geometry.kind {
                    EdgeKind::Circle { .. } => format!("{:.3}°", place.to_degrees()),
                    EdgeKind::Line | EdgeKind::Path => format!("x = {place:.4} mm"),
                };
                Some(format!(
                    "'{}', step {}, {place}: {found}",
                    self.geometry.name,
                    step + 1
                ))
            })
        })
    }
}

fn of_contacts(sample: &Sample, wrong: impl Fn(&Contact<'_>) -> Option<String>) -> Verdict {
    let mut any = false;
    for contact in contacts(sample) {
        any = true;
        if let Some(found) = wrong(&contact) {
            return Verdict::Fails(found);
        }
    }
    if any { Verdict::Holds } else { Verdict::Beside }
}

/// All numbers are finite.
pub(super) fn numbers(sample: &Sample) -> Verdict {
    for (index, step) in sample.results.steps.iter().enumerate() {
        let rows = step
            .edges
            .iter()
            .flat_map(|edge| &edge.rows)
            .flat_map(|row| {
                let contact = [row.pressure, row.shear, row.gap, row.slip];
                let stresses = [row.sigma_normal, row.sigma_tangential, row.tau];
                contact.into_iter().chain(stresses)
            });
        let sums = (step.edges.iter()).flat_map(|edge| {
            let [x, y] = edge.resultant;
            [x, y, edge.normal_force]
        });
        let fields = step.fields.iter().flat_map(|field| {
            let stresses = field.stress.iter().flatten();
            field.displacement.iter().chain(stresses).copied()
        });
        let whole = [step.dissipation, step.balance_residual];
        let mut all = rows.chain(sums).chain(fields).chain(whole);
        if let Some(wrong) = all.find(|value| !value.is_finite()) {
            return Verdict::Fails(format!("step {}: {wrong}", index + 1));
        }
    }
    Verdict::Holds
}

/// p ≥ 0, g ≥ 0, p g = 0, and a status that says which.
pub(super) fn unilateral(sample: &Sample) -> Verdict {
    let give = sample.give();
    of_contacts(sample, |contact| {
        let pressure = ROUNDING * contact.most(sample, |row| row.pressure);
        let length = contact.most(sample, |row| row.gap.abs().max(row.slip.abs()));
        let length = ROUNDING * length.max(give * pressure / ROUNDING);
        contact.first(sample, |_, row, _| {
            let touches = row.status != Status::Open;
            let wrong = if row.pressure < -pressure {
                "tension"
            } else if row.gap < -length {
                "penetration"
            } else if row.pressure > pressure && row.gap > length {
                "pressure across a gap"
            } else if touches && row.gap.abs() > length || !touches && row.pressure > pressure {
                "a status that contradicts pressure and gap"
            } else {
                return None;
            };
            Some(format!(
                "{wrong}: p = {:e} MPa, g = {:e} mm, {}",
                row.pressure, row.gap, row.status
            ))
        })
    })
}

/// |τ| within the bound of the law, at it where the point slips.
pub(super) fn cone(sample: &Sample) -> Verdict {
    of_contacts(sample, |contact| {
        let most = contact.most(sample, |row| row.pressure.max(row.shear.abs()));
        let body = contact.text["first"].as_str()?.split('.').next()?;
        let (axis, plies) = axis_and_plies(&sample.value, body);
        contact.first(sample, |_, row, place| {
            let tangent = match contact.geometry.kind {
                EdgeKind::Circle { .. } => place + FRAC_PI_2,
                EdgeKind::Line | EdgeKind::Path => 0.0,
            };
            let (law, pressure) = (&contact.text["friction"], row.pressure.max(0.0));
            let allowed = match bound(law, pressure, tangent - axis, &plies) {
                Ok(allowed) => allowed,
                Err(unknown) => return Some(unknown),
            };
            let shear = row.shear.abs();
            let beyond = match row.status {
                Status::Open => shear,
                Status::Stick => shear - allowed.stick,
                Status::SlipPositive | Status::SlipNegative => {
                    (allowed.slip[0] - shear).max(shear - allowed.slip[1])
                }
            };
            (beyond > ROUNDING * most).then(|| {
                format!(
                    "{}: |τ| = {shear:e} MPa, p = {:e} MPa, {allowed:?}",
                    row.status, row.pressure
                )
            })
        })
    })
}

/// Friction acts against slip: τ ≤ 0 where the first body slips along +e_t, and the slip of a step has the sign of its status where
/// the step was solved in one increment.
pub(super) fn direction(sample: &Sample) -> Verdict {
    of_contacts(sample, |contact| {
        let stress = ROUNDING * contact.most(sample, |row| row.pressure.max(row.shear.abs()));
        let length = ROUNDING * contact.most(sample, |row| row.slip.abs().max(row.gap.abs()));
        let edges: Vec<&EdgeResults> = contact.steps(sample).collect();
        let starts: Vec<f64> = contact.geometry.parameter.clone();
        contact.first(sample, |step, row, place| {
            let sign = match row.status {
                Status::SlipPositive => 1.0,
                Status::SlipNegative => -1.0,
                Status::Open | Status::Stick => 0.0,
            };
            if sign * row.shear > stress {
                return Some(format!("{} under τ = {:e} MPa", row.status, row.shear));
            }
            let node = starts.iter().position(|own| *own == place)?;
            let before = step
                .checked_sub(1)
                .map_or(0.0, |last| edges[last].rows[node].slip);
            let slipped = row.slip - before;
            let one = sample.results.steps[step].increments == 1;
            let wrong = match row.status {
                Status::SlipPositive | Status::SlipNegative => one && sign * slipped < -length,
                Status::Stick => one && slipped.abs() > length,
                Status::Open => false,
            };
            wrong.then(|| format!("{}, but it slipped by {slipped:e} mm", row.status))
        })
    })
}

/// Dissipation is never negative. Of a step that was solved in one increment, with circles alone, it lies between half of Σ |τ Δs| A by
/// the traction at the end and all of it by the larger traction of both ends, up to the error of nodal areas.
pub(super) fn dissipation(sample: &Sample) -> Verdict {
    if contacts(sample).next().is_none() {
        return Verdict::Beside;
    }
    let work: f64 = contacts(sample)
        .map(|contact| {
            let forces = contact.steps(sample);
            let most = forces.fold(0.0, |most: f64, edge| most.max(edge.normal_force));
            // Without slip, dissipation is the rounding of what the contact does elastically.
            let give = sample.give();
            most * contact.most(sample, |row| row.slip.abs().max(give * row.pressure))
        })
        .sum();
    for (index, step) in sample.results.steps.iter().enumerate() {
        let found = step.dissipation;
        let wrong = found < -ROUNDING * work
            || step.increments == 1
                && rubbed(sample, index).is_some_and(|[least, most, tolerance]| {
                    let beyond = (least - found).max(found - most);
                    beyond > tolerance * most + ROUNDING * work
                });
        if wrong {
            let bounds = rubbed(sample, index);
            return Verdict::Fails(format!(
                "step {}: {found:e} N·mm, where {work:e} would be much; least and most by tractions and slips: {bounds:?}",
                index + 1
            ));
        }
    }
    Verdict::Holds
}

/// Least and most work of friction in a step by the written tractions and slips, and the relative error of areas.
fn rubbed(sample: &Sample, step: usize) -> Option<[f64; 3]> {
    let mut sums = [0.0; 3];
    for contact in contacts(sample) {
        let (areas, tolerance) = contact.areas(sample)?;
        let edges: Vec<&EdgeResults> = contact.steps(sample).collect();
        let double = if contact.geometry.half { 2.0 } else { 1.0 };
        for (node, area) in areas.iter().enumerate() {
            let row = &edges[step].rows[node];
            if !matches!(row.status, Status::SlipPositive | Status::SlipNegative) {
                continue;
            }
            let before = step.checked_sub(1).map(|last| &edges[last].rows[node]);
            let slipped = (row.slip - before.map_or(0.0, |row| row.slip)).abs();
            let shear = row.shear.abs();
            sums[0] += 0.5 * double * shear * slipped * area;
            sums[1] +=
                double * before.map_or(0.0, |row| row.shear.abs()).max(shear) * slipped * area;
        }
        sums[2] = tolerance.max(sums[2]);
    }
    Some(sums)
}

/// The written resultant is the sum of the written tractions: over nodal areas by the trapezoidal rule, by Simpson's on quadratic
/// edges.
pub(super) fn resultant(sample: &Sample) -> Verdict {
    of_contacts(sample, |contact| {
        let (areas, tolerance) = contact.areas(sample)?;
        let most = contact
            .steps(sample)
            .fold(0.0, |most: f64, edge| most.max(edge.normal_force));
        contact.steps(sample).enumerate().find_map(|(index, edge)| {
            let mut sum = [0.0; 2];
            let rows = contact.geometry.parameter.iter().zip(&edge.rows);
            for ((place, row), area) in rows.zip(&areas) {
                let (s, c) = place.sin_cos();
                sum[0] += (row.pressure * c - row.shear * s) * area;
                sum[1] += (row.pressure * s + row.shear * c) * area;
            }
            if contact.geometry.half {
                sum = [2.0 * sum[0], 0.0];
            }
            let apart = (sum[0] - edge.resultant[0]).hypot(sum[1] - edge.resultant[1]);
            (apart > tolerance * most).then(|| {
                let (name, step, written) = (&contact.geometry.name, index + 1, edge.resultant);
                format!("'{name}', step {step}: {written:?} N written, {sum:?} N by the tractions")
            })
        })
    })
}

/// Areas of the nodes of a circle, times `scale` = radius × thickness, by the rule of Gauss and Lobatto on whose nodes edges of order n have theirs,
///
/// ```text
/// w = 2 / (n (n + 1) Pₙ(x)²)  on −1 … 1,
/// ```
///
/// the trapezoidal rule on linear edges and Simpson's on quadratic ones.
fn areas(geometry: &EdgeGeometry, scale: f64) -> Option<Vec<f64>> {
    let (angles, corners) = (&geometry.parameter, &geometry.corner);
    let count = angles.len();
    let first = corners.iter().position(|corner| *corner)?;
    let order = (1..count).find(|k| corners[(first + k) % count])?;
    let end = if geometry.half {
        count - order
    } else {
        first + count
    };
    let at = |k: usize| angles[k % count] + TAU * (k / count) as f64;
    let mut areas = vec![0.0; count];
    for start in (first..end).step_by(order) {
        let length = at(start + order) - at(start);
        for node in start..=start + order {
            let x = 2.0 * (at(node) - at(start)) / length - 1.0;
            let share = 1.0 / ((order * (order + 1)) as f64 * legendre(order, x).powi(2));
            areas[node % count] += share * scale * length;
        }
    }
    Some(areas)
}

/// Legendre's polynomial of degree `order`.
fn legendre(order: usize, x: f64) -> f64 {
    let terms = (1..order).map(|k| k as f64);
    let (last, _) = terms.fold((x, 1.0), |(now, before), k| {
        (((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0), now)
    });
    last
}
