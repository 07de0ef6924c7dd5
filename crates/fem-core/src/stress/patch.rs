//! Superconvergent patch recovery.
//!
//! Around every corner node that is inside its block, the stress is fitted to the superconvergent samples of the cells that
//! share the node,
//!
//! ```text
//! σ*(x) = Σₖ cₖ pₖ(x),   min Σ_s |σ*(x_s) − σ(x_s)|²,   p = 1 x y (T3, Q4), 1 x y x² xy y² (T6, Q8, Q9),
//! ```
//!
//! and evaluated at the node. Mid-side and centre nodes take the mean of the fits at the corners they lie between;
//! nodes on the block's boundary take the mean of the fits at the interior corners of their cells, or the nearest such fit
//! where they have none. Fits do not cross from one block to another, because stress may jump there.
//!
//! Complete polynomials are invariant under linear maps, so the fit uses coordinates in which the samples have unit
//! covariance and does not mind stretched cells.
//!
//! Source: Zienkiewicz and Zhu, Int. J. Numer. Methods Eng. 33 (1992) 1331–1364.

use super::gauss::{ElasticField, Points, Samples};
use super::nodal::{BlockStresses, Mean, NodalStresses};
use crate::mesh::{ElementBlock, Point};
use crate::parallel;

impl ElasticField<'_> {
    /// Stress at every node by superconvergent patch recovery.
    ///
    /// Inside a smooth mesh the error falls as h² on T3 and Q4, between h² and h³ on T6, and as h⁴ on Q8 and Q9. Boundary
    /// nodes are extrapolated: h^1.3 on T3, h² on Q4, h³ on the others, with constants that make
    /// [`ElasticField::nodal_stresses`] the better choice where a cell is as large as the stress gradient's length; where
    /// the tractions are known, use [`edge_stresses`](super::edge_stresses).
    ///
    /// A block without any interior corner (a strip one cell wide) has no patch, and cells of order above 2 gain nothing by one; their
    /// values are those of [`ElasticField::nodal_stresses`].
    pub fn patch_recovery(&self) -> NodalStresses {
        let blocks = (0..self.mesh.blocks().len())
            .map(|block| self.recovered(block))
            .collect();
        NodalStresses {
            blocks,
            node_count: self.mesh.nodes().len(),
        }
    }

    fn recovered(&self, block: usize) -> BlockStresses {
        let cells = &self.mesh.blocks()[block];
        let nodes = self.mesh.nodes();
        let topology = Topology::new(cells, nodes.len());
        if topology.interior.is_empty() || cells.kind.order() > 2 {
            return self.extrapolated(block);
        }
        let samples = self.sample(block, Points::Superconvergent);
        let degree = cells.kind.order();
        let fits = parallel::map(&topology.interior, |&corner| {
            Fit::new(&samples, topology.cells_at(corner), degree)
        });
        topology.evaluate(cells, nodes, &fits)
    }
}

/// How the cells of one block hang together.
struct Topology {
    /// Cells at node `k`: `cells[first[k]..first[k + 1]]`.
    first: Vec<usize>,
    cells: Vec<usize>,
    /// Corner nodes that are not on the block's boundary, ascending.
    interior: Vec<usize>,
    /// Position in `interior` of every node that is there.
    fit: Vec<Option<usize>>,
}

impl Topology {
    fn new(block: &ElementBlock, node_count: usize) -> Self {
        let size = block.kind.nodes();
        let mut first = vec![0; node_count + 1];
        for &node in &block.connectivity {
            first[node + 1] += 1;
        }
        for k in 0..node_count {
            first[k + 1] += first[k];
        }
        let mut next = first.clone();
        let mut cells = vec![0; block.connectivity.len()];
        for (k, &node) in block.connectivity.iter().enumerate() {
            cells[next[node]] = k / size;
            next[node] += 1;
        }
        let interior = interior_corners(block, node_count);
        let mut fit = vec![None; node_count];
        for (k, &corner) in interior.iter().enumerate() {
            fit[corner] = Some(k);
        }
        Self {
            first,
            cells,
            interior,
            fit,
        }
    }

    fn cells_at(&self, node: usize) -> &[usize] {
        &self.cells[self.first[node]..self.first[node + 1]]
    }

    /// Positions in `interior` of those of `corners` that are there.
    fn fits_at<'s>(&'s self, corners: &'s [usize]) -> impl Iterator<Item = usize> + 's {
        corners.iter().filter_map(|&corner| self.fit[corner])
    }

    fn evaluate(&self, block: &ElementBlock, nodes: &[Point], fits: &[Fit]) -> BlockStresses {
        let (size, corners) = (block.kind.nodes(), block.kind.corners());
        let mut mean = Mean::new(nodes.len());
        for cell in block.connectivity.chunks_exact(size) {
            for (local, &node) in cell.iter().enumerate() {
                let mut ends = [0; 2];
                for fit in self.fits_at(supports(cell, local, corners, &mut ends)) {
                    mean.add(node, fits[fit].at(nodes[node]));
                }
            }
        }
        let reached: Vec<bool> = (0..nodes.len()).map(|node| mean.has(node)).collect();
        for cell in block.connectivity.chunks_exact(size) {
            for &node in cell.iter().filter(|&&node| !reached[node]) {
                for fit in self.fits_at(&cell[..corners]) {
                    mean.add(node, fits[fit].at(nodes[node]));
                }
            }
        }
        for &node in &block.connectivity {
            if !mean.has(node) {
                mean.add(node, fits[self.nearest(nodes, nodes[node])].at(nodes[node]));
            }
        }
        mean.into_block()
    }

    /// Position in `interior` of the corner nearest to `place`.
    fn nearest(&self, nodes: &[Point], place: Point) -> usize {
        let distance = |&corner: &usize| {
            let [x, y] = nodes[corner];
            (x - place[0]).powi(2) + (y - place[1]).powi(2)
        };
        let closer = |best: (usize, f64), (k, corner)| {
            let d = distance(corner);
            if d < best.1 { (k, d) } else { best }
        };
        self.interior
            .iter()
            .enumerate()
            .fold((0, f64::INFINITY), closer)
            .0
    }
}

/// The corner nodes between which local node `local` of `cell` lies: itself, two edge ends, which are put into `ends`, or all corners.
fn supports<'a>(
    cell: &'a [usize],
    local: usize,
    corners: usize,
    ends: &'a mut [usize; 2],
) -> &'a [usize] {
    if local < corners {
        &cell[local..=local]
    } else if local < 2 * corners {
        *ends = [cell[local - corners], cell[(local - corners + 1) % corners]];
        ends
    } else {
        &cell[..corners]
    }
}

fn interior_corners(block: &ElementBlock, node_count: usize) -> Vec<usize> {
    let (size, corners) = (block.kind.nodes(), block.kind.corners());
    let mut is_corner = vec![false; node_count];
    let mut edges = Vec::with_capacity(block.connectivity.len() / size * corners);
    for cell in block.connectivity.chunks_exact(size) {
        for k in 0..corners {
            let ends = [cell[k], cell[(k + 1) % corners]];
            is_corner[ends[0]] = true;
            edges.push([ends[0].min(ends[1]), ends[0].max(ends[1])]);
        }
    }
    edges.sort_unstable();
    for same in edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1) {
        same[0].iter().for_each(|&node| is_corner[node] = false);
    }
    (0..node_count).filter(|&node| is_corner[node]).collect()
}

/// Most terms of a fit: a complete quadratic.
const TERMS: usize = 6;
/// Smallest pivot of the scaled normal equations that counts as independent.
const PIVOT: f64 = 1e-9;
/// Smallest variance, as a share of the total, of a direction in which the samples have extent.
const EXTENT: f64 = 1e-12;

/// A polynomial fitted to samples, in coordinates `whiten (x − centre)`.
struct Fit {
    centre: Point,
    /// Lower triangle (00, 10, 11) of the map to unit covariance.
    whiten: [f64; 3],
    coefficients: [[f64; 3]; TERMS],
}

impl Fit {
    fn new(samples: &Samples, cells: &[usize], degree: usize) -> Self {
        let chosen: Vec<usize> = cells.iter().flat_map(|&cell| samples.of(cell)).collect();
        let share = 1.0 / chosen.len() as f64;
        let centre = chosen.iter().fold([0.0; 2], |[x, y], &s| {
            [x + share * samples.at[s][0], y + share * samples.at[s][1]]
        });
        let whiten = whitening(chosen.iter().map(|&s| samples.at[s]), centre, share);
        let mut fit = Self {
            centre,
            whiten,
            coefficients: [[0.0; 3]; TERMS],
        };
        let terms_of_degree = [1, 3, 6];
        for terms in terms_of_degree[..=degree].iter().rev() {
            if let Some(coefficients) = fit.least_squares(samples, &chosen, *terms) {
                fit.coefficients = coefficients;
                break;
            }
        }
        fit
    }

    fn basis(&self, place: Point) -> [f64; TERMS] {
        let [dx, dy] = [place[0] - self.centre[0], place[1] - self.centre[1]];
        let x = self.whiten[0] * dx;
        let y = self.whiten[1] * dx + self.whiten[2] * dy;
        [1.0, x, y, x * x, x * y, y * y]
    }

    fn at(&self, place: Point) -> [f64; 3] {
        let basis = self.basis(place);
        let mut value = [0.0; 3];
        for (p, c) in basis.iter().zip(&self.coefficients) {
            (0..3).for_each(|i| value[i] += p * c[i]);
        }
        value
    }

    /// Coefficients of the first `terms` terms; `None` if the samples do not determine them.
    fn least_squares(
        &self,
        samples: &Samples,
        chosen: &[usize],
        terms: usize,
    ) -> Option<[[f64; 3]; TERMS]> {
        if chosen.len() < terms {
            return None;
        }
        let share = 1.0 / chosen.len() as f64;
        let mut gram = [[0.0; TERMS]; TERMS];
        let mut right = [[0.0; 3]; TERMS];
        for &s in chosen {
            let basis = self.basis(samples.at[s]);
            for i in 0..terms {
                (0..terms).for_each(|j| gram[i][j] += share * basis[i] * basis[j]);
                (0..3).for_each(|j| right[i][j] += share * basis[i] * samples.stress[s][j]);
            }
        }
        solve(gram, right, terms)
    }
}

/// Inverse Cholesky factor of the covariance of `places`; zero along directions without extent.
fn whitening(places: impl Iterator<Item = Point>, centre: Point, share: f64) -> [f64; 3] {
    let [xx, xy, yy] = places.fold([0.0; 3], |[xx, xy, yy], [x, y]| {
        let [dx, dy] = [x - centre[0], y - centre[1]];
        [
            xx + share * dx * dx,
            xy + share * dx * dy,
            yy + share * dy * dy,
        ]
    });
    let inverse = |v: f64| {
        if v > EXTENT * (xx + yy) {
            1.0 / v.sqrt()
        } else {
            0.0
        }
    };
    let across = (xx * yy - xy * xy) / xx.max(f64::MIN_POSITIVE);
    let (w00, w11) = (inverse(xx), inverse(across));
    [w00, -xy * w00 * w00 * w11, w11]
}

/// Gaussian elimination of a symmetric positive semidefinite system; `None` if a pivot vanishes.
fn solve(
    mut a: [[f64; TERMS]; TERMS],
    mut b: [[f64; 3]; TERMS],
    terms: usize,
) -> Option<[[f64; 3]; TERMS]> {
    for k in 0..terms {
        if a[k][k] < PIVOT {
            return None;
        }
        for i in k + 1..terms {
            let factor = a[i][k] / a[k][k];
            (k..terms).for_each(|j| a[i][j] -= factor * a[k][j]);
            (0..3).for_each(|j| b[i][j] -= factor * b[k][j]);
        }
    }
    for k in (0..terms).rev() {
        for j in 0..3 {
            let known: f64 = (k + 1..terms).map(|i| a[k][i] * b[i][j]).sum();
            b[k][j] = (b[k][j] - known) / a[k][k];
        }
    }
    Some(b)
}
