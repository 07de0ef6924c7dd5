//! Errors over costs: what a curve of ever finer meshes promises, and which curves nothing beats.
//!
//! The error of one number passes through zero where it changes its sign, and the mesh on which that happens looks far better
//! than it is. A mesh is therefore credited with its *settled* error, the largest one of itself and all finer meshes of its
//! curve:
//!
//! ```text
//! e_settled(h) = max { e(h') : h' ≤ h }
//! ```

/// One mesh of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// What it costs: seconds or unknowns.
    pub(super) cost: f64,
    /// Relative error.
    pub(super) error: f64,
}

/// The settled errors of `points`, which go from the coarsest mesh to the finest.
pub(super) fn settled(points: &[Point]) -> Vec<Point> {
    let mut worst = 0.0_f64;
    let mut settled: Vec<Point> = points
        .iter()
        .rev()
        .map(|point| {
            worst = worst.max(point.error);
            Point {
                error: worst,
                ..*point
            }
        })
        .collect();
    settled.reverse();
    settled
}

/// The cost of an error of at most `target`, between two meshes interpolated along log cost over log error; `None` where the
/// finest mesh is worse. A coarsest mesh that is already better costs what it costs.
pub(super) fn cost_of(points: &[Point], target: f64) -> Option<f64> {
    let settled = settled(points);
    let index = settled.iter().position(|point| point.error <= target)?;
    let fine = settled[index];
    let Some(coarse) = index.checked_sub(1).map(|k| settled[k]) else {
        return Some(fine.cost);
    };
    // coarse.error > target ≥ fine.error, and an error of zero takes all of the way.
    let way = (coarse.error / target).ln() / (coarse.error / fine.error).ln();
    Some(coarse.cost * (fine.cost / coarse.cost).powf(way))
}

/// The Pareto front: the points that no other point beats in both cost and error, by cost.
pub(super) fn front(curves: &[Vec<Point>]) -> Vec<Point> {
    let mut points: Vec<Point> = curves.iter().flat_map(|curve| settled(curve)).collect();
    points.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
    let mut best = f64::INFINITY;
    points.retain(|point| {
        let better = point.error < best;
        best = best.min(point.error);
        better
    });
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f64, f64)]) -> Vec<Point> {
        points
            .iter()
            .map(|&(cost, error)| Point { cost, error })
            .collect()
    }

    #[test]
    fn a_lucky_mesh_is_not_better_than_the_finer_ones() {
        let lucky = curve(&[(1.0, 1e-1), (2.0, 1e-6), (4.0, 1e-2), (8.0, 1e-3)]);
        let errors: Vec<f64> = settled(&lucky).iter().map(|p| p.error).collect();
        assert_eq!(errors, [1e-1, 1e-2, 1e-2, 1e-3]);
    }

    #[test]
    fn costs_are_interpolated_between_meshes_only() {
        let line = curve(&[(1.0, 1e-1), (100.0, 1e-3)]);
        assert!((cost_of(&line, 1e-2).unwrap() - 10.0).abs() < 1e-12);
        assert_eq!(cost_of(&line, 0.5), Some(1.0));
        assert_eq!(cost_of(&line, 1e-3), Some(100.0));
        assert_eq!(cost_of(&line, 1e-4), None);
        assert_eq!(cost_of(&curve(&[(1.0, 0.1), (2.0, 0.0)]), 0.01), Some(1.0));
    }

    #[test]
    fn the_front_keeps_what_nothing_beats() {
        let a = curve(&[(1.0, 1e-1), (4.0, 1e-2)]);
        let b = curve(&[(2.0, 2e-1), (3.0, 5e-2), (5.0, 3e-2)]);
        let kept = front(&[a, b]);
        assert_eq!(kept, curve(&[(1.0, 1e-1), (3.0, 5e-2), (4.0, 1e-2)]));
    }
}
