//! Least distances to cones and polyhedra (Lawson & Hanson 1974, chapter 23).

use nalgebra::{DMatrix, DVector};

/// Square of the largest violation over the way out of it, up to which that way is rounding of there being none.
const WAY_OUT: f64 = 1e-8;

/// The smallest x with aₖ·x ≥ hₖ for all columns aₖ of `edges`, m × n, and `least`, n, of which one at least is positive; `None` if there
/// is none. Least distance programming: minimal |x|, from the remainder of [Aᵀ; hᵀ] z = (0, …, 0, 1).
pub(crate) fn least_distance(edges: &DMatrix<f64>, least: &[f64]) -> Option<DVector<f64>> {
    let motions = edges.nrows();
    let largest = least.iter().fold(0.0, |most: f64, value| most.max(*value));
    let bordered = DMatrix::from_fn(motions + 1, least.len(), |row, k| {
        if row < motions {
            edges[(row, k)]
        } else {
            least[k] / largest
        }
    });
    let mut wanted = DVector::zeros(motions + 1);
    wanted[motions] = -1.0;
    let remainder = nearest(&bordered, &wanted);
    let last = -remainder[motions];
    (last > WAY_OUT).then(|| remainder.rows(0, motions) * (largest / last))
}

/// Remainder r + A z of the z ≥ 0 that makes it smallest (Lawson & Hanson 1974, NNLS).
pub(super) fn nearest(edges: &DMatrix<f64>, load: &DVector<f64>) -> DVector<f64> {
    let scale = load.norm();
    let mut active: Vec<usize> = Vec::new();
    let mut weights: Vec<f64> = Vec::new();
    let mut remainder = load.clone();
    for _ in 0..100 * (1 + edges.nrows()) {
        let slopes = edges.tr_mul(&remainder);
        let entering = (0..edges.ncols()).min_by(|&a, &b| slopes[a].total_cmp(&slopes[b]));
        let Some(entering) =
            entering.filter(|&k| slopes[k] < -1e-12 * scale * edges.column(k).norm())
        else {
            break;
        };
        if active.contains(&entering) {
            break;
        }
        active.push(entering);
        weights.push(0.0);
        while let Some(target) = least_squares(edges, &active, load) {
            // As far towards the unconstrained optimum as all weights allow; the first to vanish leaves.
            let blocked = (0..active.len())
                .filter(|&k| target[k] <= 0.0)
                .map(|k| {
                    (
                        weights[k] / (weights[k] - target[k]).max(f64::MIN_POSITIVE),
                        k,
                    )
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((part, leaving)) = blocked else {
                weights = target.as_slice().to_vec();
                break;
            };
            for (weight, goal) in weights.iter_mut().zip(target.iter()) {
                *weight += part * (goal - *weight);
            }
            active.remove(leaving);
            weights.remove(leaving);
        }
        remainder.copy_from(load);
        for (&k, &weight) in active.iter().zip(&weights) {
            remainder.axpy(weight, &edges.column(k), 1.0);
        }
    }
    remainder
}

/// Weights of the active columns that bring A z closest to −r.
fn least_squares(
    edges: &DMatrix<f64>,
    active: &[usize],
    load: &DVector<f64>,
) -> Option<DVector<f64>> {
    if active.is_empty() {
        return None;
    }
    let columns = edges.select_columns(active);
    columns.svd(true, true).solve(&-load, 1e-12).ok()
}
