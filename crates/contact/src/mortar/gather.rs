//! The integrals of a projection, segment by segment.

use std::collections::BTreeMap;

use nalgebra::{DVector, Matrix2};
use stickslip_fem_core::element::{EdgeValues, edge_rule};

use super::basis::{Family, combination};
use super::{EdgeSide, InitialGap, Projection};
use crate::problem::StencilTerm;

/// ∫ ψ N F ds per node of a body.
pub(super) type Terms = BTreeMap<usize, Matrix2<f64>>;

/// The integrals of one multiplier.
#[derive(Clone, Debug, Default)]
pub(super) struct NodeSums {
    /// ∫ ψ ds.
    pub(super) weight: f64,
    /// ∫ ψ g₀ ds of an exact gap.
    pub(super) gap: f64,
    pub(super) first: Terms,
    pub(super) second: Terms,
}

/// Part of an edge that faces one edge of the other body.
struct Segment {
    from: f64,
    to: f64,
    /// Edge of the second side, and the shift of its parameter to the first side's.
    other: usize,
    shift: f64,
}

/// A point of integration.
struct Sample {
    weight: f64,
    /// Shape functions of the first edge, and those that multipliers are made of.
    shape: EdgeValues,
    family: EdgeValues,
    other: usize,
    other_shape: EdgeValues,
    /// Rows e_n and e_t.
    frame: Matrix2<f64>,
    gap: f64,
}

/// The integrals of all nodes of `first`.
pub(super) fn all(
    first: &EdgeSide,
    second: &EdgeSide,
    period: Option<f64>,
    projection: &Projection<'_>,
) -> Vec<NodeSums> {
    let mut sums = vec![NodeSums::default(); first.nodes().len()];
    for edge in 0..first.edges() {
        let segments = segments(&first.span(edge), second, period);
        if !segments.is_empty() {
            let samples = samples(first, second, edge, &segments, projection);
            add_edge(&mut sums, first, second, edge, &samples, projection);
        }
    }
    sums
}

/// Smallest overlap, relative to the edge; less is rounding of two ends that coincide.
const SLIVER: f64 = 1e-10;

fn segments(span: &[f64], second: &EdgeSide, period: Option<f64>) -> Vec<Segment> {
    let [start, end] = ends(span);
    let mut segments = Vec::new();
    for other in 0..second.edges() {
        let [other_start, other_end] = ends(&second.span(other));
        // With a period, copies from the one that ends first after `start` can reach the edge; neither edge is longer than
        // the period, so three are enough.
        let (nearest, copies) = period.map_or((0.0, 1), |period| {
            (((start - other_end) / period).ceil() * period, 3)
        });
        for copy in 0..copies {
            let shift = nearest + f64::from(copy) * period.unwrap_or(0.0);
            let (from, to) = (start.max(other_start + shift), end.min(other_end + shift));
            if to - from > SLIVER * (end - start) {
                segments.push(Segment {
                    from,
                    to,
                    other,
                    shift,
                });
            }
        }
    }
    segments
}

fn ends(span: &[f64]) -> [f64; 2] {
    [span[0], span[span.len() - 1]]
}

fn samples(
    first: &EdgeSide,
    second: &EdgeSide,
    edge: usize,
    segments: &[Segment],
    projection: &Projection<'_>,
) -> Vec<Sample> {
    let span = first.span(edge);
    let [start, end] = ends(&span);
    let covered: f64 = segments
        .iter()
        .map(|segment| segment.to - segment.from)
        .sum();
    let whole = covered > (1.0 - 1e-8) * (end - start);
    let family = if first.order() == 1 || whole {
        Family::Shape
    } else {
        Family::Hats
    };
    let mut samples = Vec::new();
    for segment in segments {
        let inside = |at: &f64| family == Family::Hats && segment.from < *at && *at < segment.to;
        let inner = span.iter().copied().filter(inside);
        let breaks: Vec<f64> = [segment.from]
            .into_iter()
            .chain(inner)
            .chain([segment.to])
            .collect();
        for part in breaks.windows(2) {
            let (from, to) = (part[0], part[1]);
            for &(xi, weight) in edge_rule(first.order().max(second.order())) {
                let at = f64::midpoint(from, to) + xi * (to - from) / 2.0;
                let shape = first.shape(edge, at);
                let [nx, ny] = (projection.normal)(at);
                samples.push(Sample {
                    weight: weight * (to - from) / 2.0 * projection.length,
                    shape,
                    family: family.values(&span, shape, at),
                    other: segment.other,
                    other_shape: second.shape(segment.other, at - segment.shift),
                    frame: Matrix2::new(nx, ny, -ny, nx),
                    gap: match projection.gap {
                        InitialGap::Exact(gap) => gap(at),
                        InitialGap::Faceted(..) => 0.0,
                    },
                });
            }
        }
    }
    samples
}

fn add_edge(
    sums: &mut [NodeSums],
    first: &EdgeSide,
    second: &EdgeSide,
    edge: usize,
    samples: &[Sample],
    projection: &Projection<'_>,
) {
    let places = first.places(edge);
    let size = first.order() + 1;
    let of_family: Vec<_> = samples
        .iter()
        .map(|sample| (sample.weight, &sample.family[..size]))
        .collect();
    let combination = combination(projection.multipliers, size, &of_family);
    for sample in samples {
        let values = &combination * DVector::from_column_slice(&sample.family[..size]);
        let other_places = second.places(sample.other);
        for (place, &value) in places.clone().zip(values.iter()) {
            let weight = sample.weight * value;
            let node = &mut sums[place];
            node.weight += weight;
            node.gap += weight * sample.gap;
            add(
                &mut node.first,
                first,
                places.clone(),
                sample.shape,
                weight,
                sample,
            );
            add(
                &mut node.second,
                second,
                other_places.clone(),
                sample.other_shape,
                weight,
                sample,
            );
        }
    }
}

fn add(
    terms: &mut Terms,
    side: &EdgeSide,
    places: impl Iterator<Item = usize>,
    shape: EdgeValues,
    weight: f64,
    sample: &Sample,
) {
    // Functions that vanish at a point of integration vanish on the whole part of the edge.
    if weight == 0.0 {
        return;
    }
    for (place, value) in places.zip(shape) {
        if value != 0.0 {
            *terms.entry(side.nodes()[place]).or_default() += weight * value * sample.frame;
        }
    }
}

/// The term of `node` from ∫ ψ N F ds / ∫ ψ ds, in the frame of a point with `normal`; without shear only normal motion.
pub(super) fn in_frame(
    node: usize,
    sum: &Matrix2<f64>,
    normal: [f64; 2],
    shears: bool,
) -> StencilTerm {
    let [nx, ny] = normal;
    let turned = sum * Matrix2::new(nx, -ny, ny, nx);
    let row = |i: usize| [turned[(i, 0)], turned[(i, 1)]];
    StencilTerm {
        node,
        weights: [row(0), if shears { row(1) } else { [0.0; 2] }],
    }
}
