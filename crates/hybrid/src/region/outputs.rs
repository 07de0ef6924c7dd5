//! Results of a region, as rows A of y = A Δ over the displacements of all nodes.
//!
//! Stresses at the nodes of an edge are those of the quadrature points, extrapolated in each cell and averaged,
//!
//! ```text
//! σ_a = (1/cells) Σ_cells Σ_q w_aq D B_q u,      [σ_nn, σ_tt, τ_nt] = rotation(n) σ_a,
//! ```
//!
//! and the force through the edge is their integral, t Σ_a w_a (σ_nn n + τ_nt t), with consistent weights w_a = ∫ N_a ds.

use std::collections::BTreeMap;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::element::{Element, KindVisitor, gather, physical_gradients, with_element};
use stickslip_fem_core::material::{Material, PlaneStiffness};
use stickslip_fem_core::mesh::{Curve, EdgePath, ElementBlock, Mesh, Point};
use stickslip_fem_core::stress::extrapolation;

use super::locate::Locator;
use super::{Region, RegionError};

/// An edge with the rows that make its stresses.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeRows {
    /// Nodes in walk order: counter-clockwise along an arc, otherwise with the region on the left.
    pub nodes: Vec<usize>,
    /// Position along the edge `[length]`: radius times continuous angle on an arc, otherwise the length of the polygon.
    pub parameter: Vec<f64>,
    /// Unit vector n `[1]` at each node: e_r on an arc, otherwise out of the region. The tangent t is n turned by +90°.
    pub normal: Vec<[f64; 2]>,
    /// Consistent weights ∫ N ds of the nodes `[length]`.
    pub weights: Vec<f64>,
    /// Rows of σ_nn, σ_tt and τ_nt `[stress/length]` of each node in turn: radial, hoop and shear on an arc.
    pub rows: Vec<SparseRow>,
}

impl EdgeRows {
    /// Stresses on the edges of the set `edge` of a body.
    ///
    /// # Errors
    /// [`RegionError::Mesh`] if the set does not exist or its edges make no single chain.
    pub fn new(body: &ElasticBody, edge: &str) -> Result<Self, RegionError> {
        let mesh = body.mesh();
        let curve = mesh.edge_set(edge)?.curve;
        let path = walk(mesh, edge)?;
        let (parameter, normal) = frames(mesh, &path, curve);
        let stresses = stress_rows(body, &path.nodes);
        let rows = (path.nodes.iter().zip(&normal))
            .flat_map(|(node, &n)| rotated(&stresses[node], n))
            .collect();
        Ok(Self {
            weights: mesh.edge_weights(&path, curve),
            nodes: path.nodes,
            parameter,
            normal,
            rows,
        })
    }

    /// Rows of one component: 0 for σ_nn, 1 for σ_tt, 2 for τ_nt; one per node.
    pub fn component(&self, which: usize) -> Vec<SparseRow> {
        self.rows.iter().skip(which).step_by(3).cloned().collect()
    }

    /// Rows of the force `[force/length]` along x and y that what lies beyond the edge, on the side of n, exerts through it on a
    /// body of `thickness` `[length]`.
    pub fn resultant(&self, thickness: f64) -> [SparseRow; 2] {
        [0, 1].map(|axis| {
            let nodes = self.weights.iter().zip(&self.normal).enumerate();
            let parts = nodes.flat_map(|(k, (weight, n))| {
                let t = [-n[1], n[0]];
                let part = |component: usize, direction: [f64; 2]| {
                    let factor = thickness * weight * direction[axis];
                    (factor, self.rows[3 * k + component].iter().copied())
                };
                [part(0, *n), part(2, t)]
            });
            sum(parts)
        })
    }
}

/// Rows `[1]` of the displacements along x and y at each of `places` `[length]` in turn.
///
/// # Errors
/// [`RegionError::Outside`] for a place that is not in the mesh.
pub fn displacement_rows(mesh: &Mesh, places: &[Point]) -> Result<Vec<SparseRow>, RegionError> {
    let locator = Locator::new(mesh);
    let mut rows = Vec::with_capacity(2 * places.len());
    for (index, &place) in places.iter().enumerate() {
        let located = locator
            .locate(place)
            .ok_or(RegionError::Outside { index, place })?;
        rows.extend([located.row(0), located.row(1)]);
    }
    Ok(rows)
}

impl Region {
    /// Rows of the sum of the forces along x and y `[force/length]` that act on the region at those of `nodes` that are prescribed.
    pub fn reaction_resultant(&self, nodes: &[usize]) -> [SparseRow; 2] {
        [0, 1].map(|axis| {
            let rows = self.prescribed().iter().zip(self.stiffness.reaction_rows());
            let own = rows.filter(|(dof, _)| *dof % 2 == axis && nodes.contains(&(*dof / 2)));
            sum(own.map(|(_, row)| (1.0, row.iter().copied())))
        })
    }

    /// Row of the force `[force/length]` that acts on the region at each prescribed degree of freedom.
    pub fn reaction_rows(&self) -> &[SparseRow] {
        self.stiffness.reaction_rows()
    }
}

/// The edges of a set as [`EdgeRows`] walks them.
fn walk(mesh: &Mesh, edge: &str) -> Result<EdgePath, RegionError> {
    let path = mesh.edge_path(edge)?;
    Ok(match mesh.edge_set(edge)?.curve {
        Some(Curve::Arc { centre, .. }) => mesh.counter_clockwise(&path, centre),
        _ => path,
    })
}

/// Parameter and normal of each node of a path.
fn frames(mesh: &Mesh, path: &EdgePath, curve: Option<Curve>) -> (Vec<f64>, Vec<[f64; 2]>) {
    let unit = |[x, y]: [f64; 2]| [x / x.hypot(y), y / x.hypot(y)];
    if let Some(Curve::Arc { centre, radius }) = curve {
        let angles = mesh.angles(path, centre);
        let normal = path.nodes.iter().map(|&node| {
            let [x, y] = mesh.nodes()[node];
            unit([x - centre[0], y - centre[1]])
        });
        let parameter = angles.iter().map(|angle| radius * angle).collect();
        return (parameter, normal.collect());
    }
    let count = path.nodes.len();
    let at = |k: usize| mesh.nodes()[path.nodes[k]];
    let mut parameter = vec![0.0; count];
    for k in 1..count {
        let ([x, y], [u, v]) = (at(k - 1), at(k));
        parameter[k] = parameter[k - 1] + (u - x).hypot(v - y);
    }
    let neighbour = |k: usize, step: usize| match (path.closed, step) {
        (true, _) => (k + count - 1 + 2 * step) % count,
        (false, 0) => k.saturating_sub(1),
        (false, _) => (k + 1).min(count - 1),
    };
    let normal = (0..count).map(|k| {
        let ([x, y], [u, v]) = (at(neighbour(k, 0)), at(neighbour(k, 1)));
        unit([v - y, x - u])
    });
    (parameter, normal.collect())
}

/// σ_nn, σ_tt and τ_nt from σ_xx, σ_yy and τ_xy.
fn rotated(stress: &[BTreeMap<usize, f64>; 3], [x, y]: [f64; 2]) -> [SparseRow; 3] {
    let factors = [
        [x * x, y * y, 2.0 * x * y],
        [y * y, x * x, -2.0 * x * y],
        [-x * y, x * y, x * x - y * y],
    ];
    factors.map(|factors| {
        let parts = factors.into_iter().zip(stress);
        sum(parts.map(|(factor, part)| (factor, part.iter().map(|(&dof, &entry)| (dof, entry)))))
    })
}

/// The sum of rows, each times its factor.
fn sum(parts: impl Iterator<Item = (f64, impl Iterator<Item = (usize, f64)>)>) -> SparseRow {
    let mut row = BTreeMap::new();
    for (factor, part) in parts {
        for (dof, entry) in part {
            *row.entry(dof).or_insert(0.0) += factor * entry;
        }
    }
    row.into_iter().collect()
}

/// Sum over the cells at a node of the rows of σ_xx, σ_yy and τ_xy, and their number.
#[derive(Default)]
struct NodeStress {
    rows: [BTreeMap<usize, f64>; 3],
    cells: u32,
}

fn stress_rows(body: &ElasticBody, nodes: &[usize]) -> BTreeMap<usize, [BTreeMap<usize, f64>; 3]> {
    let mut sums: BTreeMap<usize, NodeStress> = (nodes.iter())
        .map(|&node| (node, NodeStress::default()))
        .collect();
    for (block, material) in body.mesh().blocks().iter().zip(body.materials()) {
        let stiffness = Material::stiffness(material.as_ref());
        let mesh = body.mesh();
        let visit = Collect {
            mesh,
            block,
            stiffness,
            sums: &mut sums,
        };
        with_element(block.kind, visit);
    }
    let mean = |NodeStress { mut rows, cells }: NodeStress| {
        for value in rows.iter_mut().flat_map(BTreeMap::values_mut) {
            *value /= f64::from(cells);
        }
        rows
    };
    sums.into_iter()
        .map(|(node, sum)| (node, mean(sum)))
        .collect()
}

struct Collect<'a> {
    mesh: &'a Mesh,
    block: &'a ElementBlock,
    stiffness: PlaneStiffness,
    sums: &'a mut BTreeMap<usize, NodeStress>,
}

impl KindVisitor for Collect<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        let weights = extrapolation(E::KIND);
        let d = self.stiffness;
        for cell in self.block.connectivity.chunks_exact(N) {
            let wanted = (0..N).filter(|&a| self.sums.contains_key(&cell[a]));
            let wanted: Vec<usize> = wanted.collect();
            if wanted.is_empty() {
                continue;
            }
            let x = gather::<N>(self.mesh.nodes(), cell);
            for (q, point) in E::QUADRATURE.iter().enumerate() {
                let gradients = physical_gradients::<N, E>(&x, point.at).gradients;
                for &a in &wanted {
                    let Some(sum) = self.sums.get_mut(&cell[a]) else {
                        continue;
                    };
                    sum.cells += u32::from(q == 0);
                    for (row, d) in sum.rows.iter_mut().zip(&d) {
                        for (&node, [gx, gy]) in cell.iter().zip(gradients) {
                            let part = [d[0] * gx + d[2] * gy, d[1] * gy + d[2] * gx];
                            for (axis, part) in part.into_iter().enumerate() {
                                *row.entry(2 * node + axis).or_insert(0.0) +=
                                    weights[(a, q)] * part;
                            }
                        }
                    }
                }
            }
        }
    }
}
