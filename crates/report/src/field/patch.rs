//! A cell's geometry and values between its nodes.
//!
//! Quadrilaterals live on (ξ, η) ∈ \[0, 1\]², triangles on ξ, η ≥ 0, ξ + η ≤ 1.

use std::array;

use super::FieldPlot;
use crate::axis::extent;

/// One cell, or one triangle of a polygon: nodes as (x, y, value).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Patch {
    nodes: [[f64; 3]; 8],
    count: usize,
}

impl Patch {
    /// A linear or quadratic cell, if it has 3, 4, 6 or 8 nodes.
    fn new(loop_nodes: &[[f64; 3]]) -> Option<Self> {
        let count = loop_nodes.len();
        if !matches!(count, 3 | 4 | 6 | 8) {
            return None;
        }
        let mut nodes = [[0.0; 3]; 8];
        nodes[..count].copy_from_slice(loop_nodes);
        Some(Self { nodes, count })
    }

    /// The nodes, (x, y, value).
    pub(crate) fn corners(&self) -> &[[f64; 3]] {
        &self.nodes[..self.count]
    }

    pub(crate) fn is_triangle(&self) -> bool {
        self.count == 3 || self.count == 6
    }

    pub(crate) fn is_quadratic(&self) -> bool {
        self.count > 4
    }

    /// Points of the patch beside those of the flat triangles with the same corners: the middle of each side, and of a quadrilateral on both
    /// diagonals, of which a cut takes one.
    pub(crate) fn departures(&self) -> impl Iterator<Item = [[f64; 3]; 2]> {
        let corners = if self.is_triangle() { 3 } else { 4 };
        let stride = self.count / corners;
        let corner = move |k: usize| self.nodes[k % corners * stride];
        let sides = (0..corners)
            .filter(move |_| stride == 2)
            .map(move |k| [self.nodes[2 * k + 1], mean([corner(k), corner(k + 1)])]);
        let diagonals = (0..corners - 2)
            .filter(move |_| corners == 4)
            .map(move |k| [self.at(0.5, 0.5), mean([corner(k), corner(k + 2)])]);
        sides.chain(diagonals)
    }

    /// x, y and value at (ξ, η).
    pub(crate) fn at(&self, xi: f64, eta: f64) -> [f64; 3] {
        let mut weights = [0.0; 8];
        match self.count {
            3 => weights[..3].copy_from_slice(&[1.0 - xi - eta, xi, eta]),
            4 => weights[..4].copy_from_slice(&bilinear(xi, eta)),
            6 => weights[..6].copy_from_slice(&quadratic_triangle(xi, eta)),
            _ => weights = serendipity(xi, eta),
        }
        let mut sum = [0.0; 3];
        for (weight, node) in weights.iter().zip(self.corners()) {
            for (total, part) in sum.iter_mut().zip(node) {
                *total += weight * part;
            }
        }
        sum
    }

    /// Calls `draw` with the 3 or 4 corners of each piece when every side is cut in
    /// `cuts` (≥ 1): cuts² pieces.
    pub(crate) fn pieces(&self, cuts: usize, mut draw: impl FnMut(&[[f64; 3]])) {
        let step = 1.0 / cuts as f64;
        let point = |i: usize, j: usize| self.at(i as f64 * step, j as f64 * step);
        let row = |j: usize| -> Vec<[f64; 3]> {
            let last = if self.is_triangle() { cuts - j } else { cuts };
            (0..=last).map(|i| point(i, j)).collect()
        };
        let mut below = row(0);
        for j in 0..cuts {
            let above = row(j + 1);
            for i in 0..below.len() - 1 {
                if self.is_triangle() {
                    draw(&[below[i], below[i + 1], above[i]]);
                    if i + 1 < above.len() {
                        draw(&[below[i + 1], above[i + 1], above[i]]);
                    }
                } else {
                    draw(&[below[i], below[i + 1], above[i + 1], above[i]]);
                }
            }
            below = above;
        }
    }

    fn meets(&self, [x_low, x_high, y_low, y_high]: [f64; 4]) -> bool {
        let [left, right, bottom, top] = extent(self.corners().iter().map(|&[x, y, _]| [x, y]));
        left <= x_high && right >= x_low && bottom <= y_high && top >= y_low
    }
}

fn mean([a, b]: [[f64; 3]; 2]) -> [f64; 3] {
    array::from_fn(|k| 0.5 * (a[k] + b[k]))
}

/// N of corners (0,0), (1,0), (1,1), (0,1).
fn bilinear(xi: f64, eta: f64) -> [f64; 4] {
    [
        (1.0 - xi) * (1.0 - eta),
        xi * (1.0 - eta),
        xi * eta,
        (1.0 - xi) * eta,
    ]
}

/// N of c₀ m₀ c₁ m₁ c₂ m₂.
fn quadratic_triangle(xi: f64, eta: f64) -> [f64; 6] {
    let l = 1.0 - xi - eta;
    [
        l * (2.0 * l - 1.0),
        4.0 * l * xi,
        xi * (2.0 * xi - 1.0),
        4.0 * xi * eta,
        eta * (2.0 * eta - 1.0),
        4.0 * eta * l,
    ]
}

/// N of c₀ m₀ c₁ m₁ c₂ m₂ c₃ m₃: each corner loses half of its two mid-sides.
fn serendipity(xi: f64, eta: f64) -> [f64; 8] {
    let middle = |t: f64| 4.0 * t * (1.0 - t);
    let sides = [
        middle(xi) * (1.0 - eta),
        xi * middle(eta),
        middle(xi) * eta,
        (1.0 - xi) * middle(eta),
    ];
    let corners = bilinear(xi, eta);
    array::from_fn(|k| {
        let side = k / 2;
        if k % 2 == 1 {
            sides[side]
        } else {
            corners[side] - 0.5 * (sides[side] + sides[(side + 3) % 4])
        }
    })
}

/// The patches of all cells, mirrored where asked, that meet the window.
pub(crate) fn visible(plot: &FieldPlot<'_>) -> Vec<Patch> {
    let mut patches = Vec::new();
    for cell in plot.cells {
        let node = |&index: &usize| {
            let [x, y] = plot.nodes[index];
            [x, y, plot.values[index]]
        };
        let corners: Vec<[f64; 3]> = cell.iter().map(node).collect();
        add_cell(&corners, &mut patches);
        if let Some(factors) = plot.mirror {
            let image = |corner: &[f64; 3]| array::from_fn(|part| factors[part] * corner[part]);
            let mirrored: Vec<[f64; 3]> = corners.iter().map(image).collect();
            add_cell(&mirrored, &mut patches);
        }
    }
    if let Some(window) = plot.window {
        patches.retain(|patch| patch.meets(window));
    }
    patches
}

fn add_cell(corners: &[[f64; 3]], patches: &mut Vec<Patch>) {
    if let Some(patch) = Patch::new(corners) {
        patches.push(patch);
        return;
    }
    let mut mean = [0.0; 3];
    for corner in corners {
        for (total, part) in mean.iter_mut().zip(corner) {
            *total += part / corners.len() as f64;
        }
    }
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    patches.extend(ends.filter_map(|(&a, &b)| Patch::new(&[a, b, mean])));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(count: usize) -> Patch {
        let loop_nodes: [[f64; 2]; 8] = [
            [0.0, 0.0],
            [0.5, 0.0],
            [1.0, 0.0],
            [1.0, 0.5],
            [1.0, 1.0],
            [0.5, 1.0],
            [0.0, 1.0],
            [0.0, 0.5],
        ];
        let stride = 8 / count;
        let nodes: Vec<[f64; 3]> = loop_nodes
            .iter()
            .step_by(stride)
            .map(|&[x, y]| [x, y, quadratic(x, y)])
            .collect();
        Patch::new(&nodes).unwrap()
    }

    fn triangle() -> Patch {
        let nodes = [
            [0.0, 0.0],
            [0.5, 0.0],
            [1.0, 0.0],
            [0.5, 0.5],
            [0.0, 1.0],
            [0.0, 0.5],
        ]
        .map(|[x, y]| [x, y, quadratic(x, y)]);
        Patch::new(&nodes).unwrap()
    }

    fn quadratic(x: f64, y: f64) -> f64 {
        1.0 + x - 2.0 * y + 3.0 * x * x - x * y + 0.5 * y * y
    }

    #[test]
    fn quadratic_cells_reproduce_quadratic_fields() {
        for patch in [square(8), triangle()] {
            for (xi, eta) in [(0.0, 0.0), (0.3, 0.2), (0.7, 0.1), (0.25, 0.75)] {
                let [x, y, value] = patch.at(xi, eta);
                assert!((x - xi).abs() < 1e-14 && (y - eta).abs() < 1e-14);
                // Rounding of eight products of numbers up to 4.
                assert!((value - quadratic(x, y)).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn pieces_fill_the_cell_without_overlap() {
        let area = |corners: &[[f64; 3]]| {
            let ends = corners.iter().zip(corners.iter().cycle().skip(1));
            ends.map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1]))
                .sum::<f64>()
        };
        for (patch, total) in [(square(4), 1.0), (square(8), 1.0), (triangle(), 0.5)] {
            for cuts in [1, 2, 7] {
                let (mut count, mut sum) = (0, 0.0);
                patch.pieces(cuts, |corners| {
                    count += 1;
                    assert!(area(corners) > 0.0);
                    sum += area(corners);
                });
                assert_eq!(count, cuts * cuts);
                assert!((sum - total).abs() < 1e-13);
            }
        }
    }

    /// The error of flat triangles falls with the square of the cuts from what the departures say.
    #[test]
    fn departures_bound_the_error_of_flat_pieces() {
        let bent = |patch: Patch| {
            let bend =
                |[x, y, v]: [f64; 3]| [x + 0.2 * y * y - 0.1 * x * y, y + 0.15 * x * (1.0 - x), v];
            let nodes: Vec<[f64; 3]> = patch.corners().iter().map(|&node| bend(node)).collect();
            Patch::new(&nodes).unwrap()
        };
        let apart =
            |a: [f64; 3], b: [f64; 3]| (a[0] - b[0]).hypot(a[1] - b[1]).max((a[2] - b[2]).abs());
        for patch in [bent(square(4)), bent(square(8))] {
            let departure = patch
                .departures()
                .map(|[a, b]| apart(a, b))
                .fold(0.0, f64::max);
            for cuts in [1_u32, 2, 5] {
                let side = 1.0 / f64::from(cuts);
                let mut worst: f64 = 0.0;
                for (i, j) in (0..cuts).flat_map(|i| (0..cuts).map(move |j| (i, j))) {
                    let at = |s: f64, t: f64| {
                        patch.at((f64::from(i) + s) * side, (f64::from(j) + t) * side)
                    };
                    for (s, t) in [(0.5, 0.0), (0.5, 0.5), (0.75, 0.25), (0.3, 0.2), (0.9, 0.6)] {
                        // The half below the diagonal from the first corner.
                        let flat = array::from_fn(|k| {
                            (1.0 - s) * at(0.0, 0.0)[k]
                                + (s - t) * at(1.0, 0.0)[k]
                                + t * at(1.0, 1.0)[k]
                        });
                        worst = worst.max(apart(at(s, t), flat));
                    }
                }
                let bound = 1.5 * departure * side * side;
                assert!(worst <= bound, "{cuts} cuts: {worst} > {bound}");
                assert!(
                    departure * side * side <= 3.0 * worst,
                    "{departure} {worst}"
                );
            }
        }
    }

    #[test]
    fn other_polygons_become_triangles_around_their_mean() {
        let mut patches = Vec::new();
        let pentagon: Vec<[f64; 3]> = (0..5)
            .map(|k| f64::from(k) * 1.2566)
            .map(|t| [t.cos(), t.sin(), 2.0])
            .collect();
        add_cell(&pentagon, &mut patches);
        assert_eq!(patches.len(), 5);
        assert!(
            patches
                .iter()
                .all(|patch| (patch.at(0.3, 0.3)[2] - 2.0).abs() < 1e-14)
        );
    }
}
