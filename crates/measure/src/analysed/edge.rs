//! The edge of a region: its places and the rows of its stresses.

use std::f64::consts::PI;
use std::ops::Range;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::SparseRow;
use stickslip_hybrid::identify::Tractions;
use stickslip_hybrid::region::RegionError;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::transfer::Propagated;

use super::Analysed;
use stickslip_engine::results::wrapped;

/// Standard deviations by which a pressure has to exceed zero, and part of the largest, to count as contact.
pub(super) const CONTACT: [f64; 2] = [3.0, 0.05];
/// Part of the largest hoop stress that the largest pressure has to exceed as well: what noise and smoothing leave on the edge of an
/// open hole does not.
const OPEN: f64 = 0.03;
/// Part of the largest hoop stress below which a pressure with its uncertainty counts as zero.
const HIDDEN: f64 = 0.1;
/// Angle from θ = 0 from which on a contact bears elsewhere `[rad]`.
const ELSEWHERE: f64 = 5.0 * PI / 180.0;
/// Pressures of this part of the largest one must exceed their uncertainty, or noise may hide where contact ends.
const SEEN: f64 = 0.3;
/// Resolved angles between the last place in contact and the part of the edge that is taken as free.
const CELLS_BEYOND: f64 = 2.0;

/// Places and rows of an arc.
#[derive(Debug)]
pub(super) struct Edge {
    /// `[rad]`, ascending, the middle within half a turn of zero; a ring begins at its cut.
    pub(super) angle: Vec<f64>,
    /// Mean angle of the edge's cells `[rad]`.
    cell: f64,
    pub(super) nodes: Vec<usize>,
    /// Whether it is a whole ring.
    pub(super) closed: bool,
    /// σ_r of all places, then τ_rθ, then σ_θ.
    pub(super) stresses: Vec<SparseRow>,
    /// Force along x and y that the region exerts through the edge.
    pub(super) resultant: [SparseRow; 2],
}

/// Mean angle of an edge's cells `[rad]`.
fn cell(
    body: &ElasticBody,
    name: &str,
    parameter: &[f64],
    radius: f64,
) -> Result<f64, RegionError> {
    let cells = body.mesh().edge_set(name)?.edges.len();
    let (first, last) = (parameter.first(), parameter.last());
    let length = first.zip(last).map_or(0.0, |(first, last)| last - first);
    Ok(length / radius / cells.max(1) as f64)
}

/// How far smoothing spreads what happens at a place, where nodes are `spacing` apart and the part `kept` of a displacement is decided by
/// its own data.
///
/// Small second differences pass waves of number k by 1/(1 + (k/k_c)⁴). Of the waves that nodes h apart can have that is the part
/// h k_c/(2√2), the one that is kept; and its kernel, e^(−x k_c/√2) (cos + sin)(x k_c/√2), is zero first at x = 3π/(2√2 k_c), or 3π/8 of h
/// over that part, and within 5 % beyond. Third differences reach 1.05 of it, with 10 %.
pub(crate) fn smoothing_reach(spacing: f64, kept: f64) -> f64 {
    3.0 * std::f64::consts::PI / 8.0 * spacing / kept.max(f64::MIN_POSITIVE)
}

/// Makes a ring begin at the first place at or after the angle `cut` `[rad]`, in whichever turn.
fn turn(rows: &mut EdgeRows, radius: f64, cut: f64) {
    const ROUNDING: f64 = 1e-9;
    const CIRCLE: f64 = std::f64::consts::TAU;
    let first = rows.parameter.first().map_or(0.0, |s| s / radius);
    let start = first + (cut - first).rem_euclid(CIRCLE) - ROUNDING;
    let before = (rows.parameter).partition_point(|s| s / radius < start);
    rows.parameter.rotate_left(before);
    let kept = rows.parameter.len() - before;
    for s in &mut rows.parameter[kept..] {
        *s += CIRCLE * radius;
    }
    rows.nodes.rotate_left(before);
    rows.rows.rotate_left(3 * before);
    rows.normal.rotate_left(before);
    rows.weights.rotate_left(before);
}

impl Edge {
    /// The edge `name` of a body, an arc of `radius` `[mm]`; a closed ring begins at the angle `cut` `[rad]`.
    pub(super) fn new(
        body: &ElasticBody,
        name: &str,
        radius: f64,
        cut: f64,
    ) -> Result<Self, RegionError> {
        let mut rows = EdgeRows::new(body, name)?;
        let closed = body.mesh().edge_path(name)?.closed;
        if closed {
            turn(&mut rows, radius, cut);
        }
        let middle = rows.parameter[rows.parameter.len() / 2] / radius;
        // Half a turn is within half a turn, whatever the last digit.
        let turns = (middle / std::f64::consts::TAU - 1e-9).round() * std::f64::consts::TAU;
        let stresses = [0, 2, 1].map(|component| rows.component(component));
        Ok(Self {
            angle: rows.parameter.iter().map(|s| s / radius - turns).collect(),
            cell: cell(body, name, &rows.parameter, radius)?,
            stresses: stresses.concat(),
            resultant: rows.resultant(body.thickness()),
            nodes: rows.nodes,
            closed,
        })
    }

    /// Angle that can be resolved where the part `kept` of a displacement is decided by its own data `[rad]`: a cell, or half of the
    /// [reach of smoothing](smoothing_reach) where that is more: wherever stresses are not smooth twice this is left out.
    pub(super) fn resolution(&self, kept: f64) -> f64 {
        let nodes = self.angle.last().zip(self.angle.first());
        let spacing = nodes.map_or(0.0, |(last, first)| last - first)
            / self.count().saturating_sub(1).max(1) as f64;
        self.cell.max(0.5 * smoothing_reach(spacing, kept))
    }

    fn count(&self) -> usize {
        self.angle.len()
    }

    /// Pressure, shear and hoop stress per place, from the values of the rows.
    pub(super) fn by_place(&self, stresses: &[f64]) -> Vec<[f64; 3]> {
        let n = self.count();
        (0..n)
            .map(|k| [-stresses[k], stresses[n + k], stresses[2 * n + k]])
            .collect()
    }

    pub(super) fn hoop(&self, stresses: &[f64]) -> Vec<f64> {
        stresses[2 * self.count()..].to_vec()
    }

    /// Pressures and shears. The covariance of the `stresses` has been multiplied by the scale of the data's variance already; the
    /// bias is added as a standard deviation of its own at each place.
    pub(super) fn tractions(&self, stresses: &Propagated, bias: &[[f64; 3]]) -> Tractions {
        let n = self.count();
        let (part, all) = (2 * n, 3 * n);
        let mut covariance = vec![0.0; part * part];
        for i in 0..part {
            for j in 0..part {
                let sign = if (i < n) == (j < n) { 1.0 } else { -1.0 };
                covariance[i * part + j] = sign * stresses.covariance[i * all + j];
            }
            covariance[i * part + i] += bias[i % n][i / n].powi(2);
        }
        let values = self.by_place(&stresses.values);
        Tractions {
            pressure: values.iter().map(|value| value[0]).collect(),
            shear: values.iter().map(|value| value[1]).collect(),
            covariance,
        }
    }

    pub(super) fn hoop_deviation(&self, stresses: &Propagated, bias: &[[f64; 3]]) -> Vec<f64> {
        let n = self.count();
        let variance = |k: usize| stresses.covariance[(2 * n + k) * (3 * n + 1)];
        (0..n)
            .map(|k| (variance(k).max(0.0) + bias[k][2].powi(2)).sqrt())
            .collect()
    }
}

impl Analysed {
    /// Whether the edge is free beyond doubt: nowhere may there be a pressure that counts beside the hoop stress.
    pub fn is_free(&self) -> bool {
        let inner = self.inner();
        let [deviation, _] = self.deviations();
        let pressure = &self.tractions.pressure;
        let hoop = inner.clone().map(|k| self.hoop[k].abs());
        let most = HIDDEN * hoop.fold(0.0, f64::max);
        let may_be = |k: usize| pressure[k] + CONTACT[0] * deviation[k];
        !inner.is_empty() && self.contact().is_none() && inner.clone().all(|k| may_be(k) < most)
    }

    /// First and last place that bear pressure beyond doubt around the place of the largest, if any does.
    pub fn contact(&self) -> Option<Range<usize>> {
        let inner = self.inner();
        let [deviation, _] = self.deviations();
        let pressure = &self.tractions.pressure;
        let peak = inner
            .clone()
            .max_by(|a, b| pressure[*a].total_cmp(&pressure[*b]))?;
        let least = |k: usize| (CONTACT[0] * deviation[k]).max(CONTACT[1] * pressure[peak]);
        let bears = |k: &usize| pressure[*k] > least(*k);
        let hoop = inner.clone().map(|k| self.hoop[k].abs());
        if !bears(&peak) || pressure[peak] < OPEN * hoop.fold(0.0, f64::max) {
            return None;
        }
        let last = (peak..inner.end).take_while(bears).last()?;
        let first = (inner.start..=peak).rev().take_while(bears).last()?;
        Some(first..last + 1)
    }

    /// The place of the largest tension `[index]`, if it is beyond doubt, of the size of the other stresses, and more than any pressure: no
    /// contact pulls.
    pub fn pull(&self) -> Option<usize> {
        let inner = self.inner();
        let [deviation, _] = self.deviations();
        let pressure = &self.tractions.pressure;
        let by_pressure = |a: &usize, b: &usize| pressure[*a].total_cmp(&pressure[*b]);
        let (most, least) = (
            inner.clone().max_by(by_pressure)?,
            inner.clone().min_by(by_pressure)?,
        );
        let hoop = inner.map(|k| self.hoop[k].abs()).fold(0.0, f64::max);
        let others = (CONTACT[0] * deviation[least])
            .max(OPEN * hoop)
            .max(pressure[most]);
        (-pressure[least] > others).then_some(least)
    }

    /// The bearing point of `contact` `[rad]`: the one that is `stated`, or θ = 0 unless all of the contact is in sight and bears
    /// elsewhere.
    pub fn bearing(&self, contact: &Range<usize>, stated: Option<f64>) -> f64 {
        let seen = || {
            let inner = self.inner();
            let ends = inner.start < contact.start && contact.end < inner.end;
            (ends.then(|| self.force_direction(contact))).filter(|at| at.abs() > ELSEWHERE)
        };
        stated.or_else(seen).unwrap_or(0.0)
    }

    /// The place of `contact`, an index, nearest to its [bearing point](Self::bearing), which may be `stated` `[rad]`.
    pub fn bearing_place(&self, contact: &Range<usize>, stated: Option<f64>) -> usize {
        let bearing = self.bearing(contact, stated);
        let away = |k: &usize| wrapped(self.angle[*k] - bearing).abs();
        let nearest = (contact.clone()).min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.unwrap_or(contact.start)
    }

    /// Direction of the force ∫(p e_r − τ e_θ) dθ on the places `contact`, which have neighbours on both sides `[rad]`.
    fn force_direction(&self, contact: &Range<usize>) -> f64 {
        let width = |k: usize| 0.5 * (self.angle[k + 1] - self.angle[k - 1]);
        let [x, y] = self.force(contact.clone().map(|k| (k, width(k))), 1.0);
        y.atan2(x)
    }

    /// The [contact](Self::contact) and its largest pressure `[MPa]`; `None` where noise may hide the greater part of it.
    pub(super) fn clear_contact(&self) -> Option<(Range<usize>, f64)> {
        let contact = self.contact()?;
        let [deviation, _] = self.deviations();
        let pressures = self.tractions.pressure[contact.clone()].iter();
        let peak = pressures.copied().fold(0.0, f64::max);
        let is_hidden = self
            .inner()
            .any(|k| CONTACT[0] * deviation[k] > SEEN * peak);
        (!is_hidden).then_some((contact, peak))
    }
}

/// Places of the edge that are clear of contact, on either side. None of an edge without contact: beside the stresses of an open hole the
/// error of the mesh, which is in no standard deviation, is more than noise. Nor where noise may hide the greater part of a contact.
pub(super) fn beyond_contact(found: &Analysed) -> Vec<Range<usize>> {
    let Some((contact, _)) = found.clear_contact() else {
        return Vec::new();
    };
    let inner = found.inner();
    let reach = CELLS_BEYOND * found.resolution;
    let after = found.angle[contact.end - 1] + reach;
    let before = found.angle[contact.start] - reach;
    let start = found.angle.partition_point(|angle| *angle <= after);
    let end = found.angle.partition_point(|angle| *angle < before);
    [start..inner.end, inner.start..end]
        .into_iter()
        .filter(|range| range.len() > 2)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral of what order n passes, 1/(1 + k²ⁿ), times cos(kx), over k from 0 to where it no longer counts.
    fn kernel(order: i32, x: f64) -> f64 {
        let step = 1e-3;
        let waves = (0..60_000).map(|i| (f64::from(i) + 0.5) * step);
        waves
            .map(|k| (k * x).cos() / (1.0 + k.powi(2 * order)) * step)
            .sum()
    }

    #[test]
    fn beyond_its_reach_smoothing_spreads_no_more_than_a_tenth() {
        for (order, beyond) in [(2, 0.05), (3, 0.1)] {
            // With k_c = 1 and nodes 1 apart, of waves up to π.
            let kept = kernel(order, 0.0) / std::f64::consts::PI;
            let reach = smoothing_reach(1.0, kept);
            let part = |x: f64| kernel(order, x) / kernel(order, 0.0);
            println!("order {order}: reach {reach:.3}, {:.4} there", part(reach));
            // Second differences have their first zero there, third ones before.
            assert!(part(reach) < 1e-3, "{}", part(reach));
            assert!(order == 3 || part(reach).abs() < 1e-3);
            for k in 0..100 {
                let x = reach * (1.0 + 0.05 * f64::from(k));
                assert!(part(x).abs() < beyond, "{x} {}", part(x));
            }
        }
    }
}
