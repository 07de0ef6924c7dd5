//! Displacements of nodes from measured ones, with their covariance.
//!
//! ```text
//! q = W u,   Σ_q = W diag(σ²) Wᵀ
//! ```
//!
//! with the measured displacements u, independent and of standard deviation σ, and the nodes' displacements q. Every reduction here is
//! linear in the data, so its weights W are all there is to it: they depend on places and masks alone, are found once, serve every
//! load that was measured at the same places, and the covariance is exact. Nodes that share data are correlated; components x and y
//! are not.
//!
//! | reduction | weights | error of a smooth field on spacing h |
//! | --- | --- | --- |
//! | [`Reduction::along_lines`] | linear between two fringe centres of a line | O(h²) |
//! | [`Reduction::linear`] | linear on a Delaunay triangle | O(h²) |
//! | [`Reduction::polynomial`] | local weighted polynomial of order p | O(hᵖ⁺¹) |
//!
//! ```
//! use stickslip_hybrid::data::{Format, Measurement, Reading};
//! use stickslip_hybrid::reduce::Reduction;
//!
//! let table = "px,py,du,dv\n0,0,0.0,0.1\n10,0,0.2,0.1\n0,10,0.4,0.3\n10,10,0.6,0.3\n";
//! let format = Format::columns(["px", "py"], ["du", "dv"]);
//! let reading = Reading { scale: Some(0.5), deviation: [0.01, 0.01], ..Reading::default() };
//! let measurement = Measurement::read(table.as_bytes(), "camera.csv", &format, &reading)?;
//!
//! let nodes = [[2.5, 0.0]];
//! let reduction = Reduction::linear(&measurement, &nodes, &[0], Some(f64::INFINITY))?.complete()?;
//! let found = reduction.displacements(&measurement)?;
//! assert!((found.values[0] - 0.05).abs() < 1e-12 && (found.covariance[0] - 0.5e-4).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A node that the data do not cover has no displacement: it is listed with its place and the reason.
//!
//! Sources: Post & Reddy (1988), part I, 4.3, interpolation between fringe centres; Lancaster & Salkauskas (1981) and Cleveland
//! (1979), local fits.

mod cover;
mod error;
mod fit;
mod polynomial;

use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::parallel;

pub use cover::{Reason, Uncovered};
pub use error::ReduceError;
pub use polynomial::LocalPolynomial;

use crate::data::{Field, FringeLine, FringeLines, Measurement, NodalDisplacements};
use crate::moire::Grating;
use crate::neighbours::Neighbours;
use crate::triangles::Triangles;

/// Data that make one displacement, and their weights.
type Stencil = Vec<(usize, f64)>;

/// Weights of measured displacements for those of nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction {
    nodes: Vec<usize>,
    stencils: [Vec<Stencil>; 2],
    /// Data of either component.
    data: [usize; 2],
    uncovered: Vec<Uncovered>,
}

/// Median longest sides of triangles beyond which one is a gap unless another is stated.
const GAP: f64 = 4.0;

impl Reduction {
    /// Linear interpolation on the Delaunay triangles of the valid places. `places` are those of all nodes `[length]`, `nodes` the
    /// indices of the wanted ones. Triangles with a side above `longest_side` `[length]` (infinite: none) are gaps in the data: the
    /// hole of a plate, masked regions, hollows of the outline. Unless stated it is four times the median of all triangles' longest sides.
    ///
    /// # Errors
    /// [`ReduceError`]: a node that does not exist, numbers that are not finite, places that cannot be triangulated.
    pub fn linear(
        measurement: &Measurement,
        places: &[Point],
        nodes: &[usize],
        longest_side: Option<f64>,
    ) -> Result<Self, ReduceError> {
        measurement.check()?;
        error::check_nodes(places, nodes)?;
        if let Some(side) = longest_side {
            error::positive("the longest side of a triangle", side)?;
        }
        let mesh = |c: usize| {
            Triangles::new(&measurement.places, &measurement.valid[c]).map_err(|cause| {
                ReduceError::Triangulation {
                    component: c,
                    cause,
                }
            })
        };
        let meshes = [mesh(0)?, mesh(1)?];
        let longest = meshes
            .each_ref()
            .map(|own| longest_side.unwrap_or_else(|| GAP * own.typical_side()));
        let found = nodes
            .iter()
            .map(|&node| {
                let at = |c: usize| meshes[c].weights(places[node], longest[c]);
                [0, 1].map(|c| at(c).map_err(Reason::from))
            })
            .collect();
        Ok(Self::new(
            places,
            nodes,
            [measurement.places.len(); 2],
            found,
        ))
    }

    /// A polynomial fitted around each node to its nearest valid places. `places` are those of all nodes `[length]`, `nodes` the
    /// indices of the wanted ones.
    ///
    /// # Errors
    /// [`ReduceError`]: a node that does not exist, numbers that are not finite, an order that does not exist, fewer neighbours
    /// than terms, fewer valid places than neighbours.
    pub fn polynomial(
        measurement: &Measurement,
        places: &[Point],
        nodes: &[usize],
        fit: &LocalPolynomial,
    ) -> Result<Self, ReduceError> {
        measurement.check()?;
        error::check_nodes(places, nodes)?;
        fit.check(measurement)?;
        let trees = [0, 1].map(|c| Neighbours::new(&measurement.places, &measurement.valid[c]));
        let found = parallel::map(nodes, |&node| {
            [0, 1].map(|c| fit.stencil(&trees[c], &measurement.places, places[node]))
        });
        Ok(Self::new(
            places,
            nodes,
            [measurement.places.len(); 2],
            found,
        ))
    }

    /// Linear interpolation between neighbouring fringe centres, the U field's lines first; `places` are those of all nodes
    /// `[length]`, `nodes` the indices of the wanted ones. Each field's nearest line within `reach` `[length]` of a node serves it.
    ///
    /// # Errors
    /// [`ReduceError`]: fields that are not U and V, a node that does not exist, numbers that are not finite.
    pub fn along_lines(
        fields: [&FringeLines; 2],
        places: &[Point],
        nodes: &[usize],
        reach: f64,
    ) -> Result<Self, ReduceError> {
        for (c, lines) in fields.iter().enumerate() {
            if lines.field.component() != c {
                return Err(ReduceError::Field {
                    place: c,
                    field: lines.field,
                });
            }
        }
        error::check_nodes(places, nodes)?;
        error::positive("the reach of a line", reach)?;
        let found = nodes
            .iter()
            .map(|&node| fields.map(|lines| on_nearest_line(lines, places[node], reach)))
            .collect();
        let data = fields.map(|lines| lines.lines.iter().map(|line| line.orders().len()).sum());
        Ok(Self::new(places, nodes, data, found))
    }

    fn new(
        places: &[Point],
        nodes: &[usize],
        data: [usize; 2],
        found: Vec<[Result<Stencil, Reason>; 2]>,
    ) -> Self {
        let mut reduction = Self {
            nodes: Vec::new(),
            stencils: [Vec::new(), Vec::new()],
            data,
            uncovered: Vec::new(),
        };
        for (&node, pair) in nodes.iter().zip(found) {
            match pair {
                [Ok(x), Ok(y)] => {
                    reduction.nodes.push(node);
                    reduction.stencils[0].push(x);
                    reduction.stencils[1].push(y);
                }
                [Err(reason), _] => reduction.leave_out(places, node, 0, reason),
                [_, Err(reason)] => reduction.leave_out(places, node, 1, reason),
            }
        }
        reduction
    }

    fn leave_out(&mut self, places: &[Point], node: usize, component: usize, reason: Reason) {
        self.uncovered.push(Uncovered {
            node,
            place: places[node],
            component,
            reason,
        });
    }

    /// Nodes that have displacements, in the order asked for.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Nodes that the data do not cover.
    pub fn uncovered(&self) -> &[Uncovered] {
        &self.uncovered
    }

    /// This reduction if it covers every requested node.
    ///
    /// # Errors
    /// [`ReduceError::Uncovered`] with the nodes that are not, their places and the reasons.
    pub fn complete(self) -> Result<Self, ReduceError> {
        if self.uncovered.is_empty() {
            return Ok(self);
        }
        Err(ReduceError::Uncovered {
            wanted: self.nodes.len() + self.uncovered.len(),
            nodes: self.uncovered,
        })
    }

    /// Data (index and weight `[1]`) that make a field's displacement of the `k`-th of [`Reduction::nodes`].
    pub fn stencil(&self, k: usize, field: Field) -> Option<&[(usize, f64)]> {
        self.stencils[field.component()].get(k).map(Vec::as_slice)
    }

    /// Displacements of the nodes from a measurement at the places this reduction was made for, and their covariance.
    ///
    /// # Errors
    /// [`ReduceError::Size`] or [`ReduceError::Masked`] where the measurement has other places or lacks one that is used.
    pub fn displacements(
        &self,
        measurement: &Measurement,
    ) -> Result<NodalDisplacements, ReduceError> {
        measurement.check()?;
        for c in 0..2 {
            let valid = &measurement.valid[c];
            if valid.len() != self.data[c] {
                return Err(self.size(c, valid.len()));
            }
            let masked =
                |stencil: &Stencil| stencil.iter().find(|&&(index, _)| !valid[index]).copied();
            if let Some((index, _)) = self.stencils[c].iter().find_map(masked) {
                return Err(ReduceError::Masked {
                    component: c,
                    place: measurement.places[index],
                });
            }
        }
        let values = self.values([0, 1].map(|c| measurement.displacements[c].as_slice()))?;
        Ok(self.with_covariance(values, measurement.deviation))
    }

    /// Displacements of the nodes from fringe lines with the centres this reduction was made for, U field first; `deviation` is
    /// that of the orders of either field `[fringes]`.
    ///
    /// # Errors
    /// [`ReduceError::Size`] where the lines have another number of centres.
    pub fn fringe_displacements(
        &self,
        fields: [&FringeLines; 2],
        grating: &Grating,
        deviation: [f64; 2],
    ) -> Result<NodalDisplacements, ReduceError> {
        let data = fields.map(|lines| -> Vec<f64> {
            let orders = lines.lines.iter().flat_map(FringeLine::orders);
            orders.map(|&order| grating.displacement(order)).collect()
        });
        let values = self.values([&data[0], &data[1]])?;
        Ok(self.with_covariance(values, deviation.map(|order| grating.displacement(order))))
    }

    /// W u: x and y of each node in turn, in the unit of the data, from all data of either component.
    ///
    /// # Errors
    /// [`ReduceError::Size`] where there are not as many data as places.
    pub fn values(&self, data: [&[f64]; 2]) -> Result<Vec<f64>, ReduceError> {
        for c in 0..2 {
            if data[c].len() != self.data[c] {
                return Err(self.size(c, data[c].len()));
            }
        }
        Ok((0..2 * self.nodes.len())
            .map(|row| {
                let (k, c) = (row / 2, row % 2);
                self.stencils[c][k]
                    .iter()
                    .map(|&(index, weight)| weight * data[c][index])
                    .sum()
            })
            .collect())
    }

    /// W diag(σ²) Wᵀ `[length²]`, square, row by row, for the standard `deviation` of either component's data `[length]`.
    pub fn covariance(&self, deviation: [f64; 2]) -> Vec<f64> {
        let size = 2 * self.nodes.len();
        let mut covariance = vec![0.0; size * size];
        for c in 0..2 {
            let variance = deviation[c] * deviation[c];
            let mut users: Vec<Stencil> = vec![Vec::new(); self.data[c]];
            for (k, stencil) in self.stencils[c].iter().enumerate() {
                for &(index, weight) in stencil {
                    users[index].push((2 * k + c, weight));
                }
            }
            for list in &users {
                for &(row, first) in list {
                    for &(column, second) in list {
                        covariance[row * size + column] += variance * first * second;
                    }
                }
            }
        }
        covariance
    }

    fn with_covariance(&self, values: Vec<f64>, deviation: [f64; 2]) -> NodalDisplacements {
        NodalDisplacements {
            nodes: self.nodes.clone(),
            values,
            covariance: self.covariance(deviation),
        }
    }

    fn size(&self, component: usize, found: usize) -> ReduceError {
        ReduceError::Size {
            component,
            found,
            needed: self.data[component],
        }
    }
}

/// Weights on the centres of the nearest line, counted through all lines of the field.
fn on_nearest_line(lines: &FringeLines, place: Point, reach: f64) -> Result<Stencil, Reason> {
    let mut best: Option<(f64, Stencil)> = None;
    let mut start = 0;
    for line in &lines.lines {
        if let Some(found) = line.locate(place)
            && best
                .as_ref()
                .is_none_or(|(distance, _)| found.distance < *distance)
        {
            let stencil = [0, 1].map(|e| (start + found.centres[e], found.weights[e]));
            best = Some((found.distance, stencil.to_vec()));
        }
        start += line.orders().len();
    }
    match best {
        Some((distance, stencil)) if distance <= reach => Ok(stencil),
        Some((distance, _)) => Err(Reason::OffLines { distance, reach }),
        None => Err(Reason::BeyondLines),
    }
}
