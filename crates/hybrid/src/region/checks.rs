//! Checks that measured data carry with them.
//!
//! Each compares numbers v that should vanish, but for noise, with the covariance C that they then have,
//!
//! ```text
//! χ² = Σᵢ vᵢ² / Cᵢᵢ,     mean χ² = n,     var χ² = 2 Σᵢⱼ Cᵢⱼ² / (Cᵢᵢ Cⱼⱼ),
//! ```
//!
//! which is exact for normal noise, however correlated. The numbers are: measured less calculated displacements at points that were
//! not prescribed, C = T Σ Tᵀ + σ² I; tractions on a part of the edge that nothing touches; forces at prescribed nodes inside;
//! and the force through an arc less the known load.

use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::linalg::Matrix;
use stickslip_fem_core::mesh::Point;

use super::locate::Locator;
use super::outline::boundary_nodes;
use super::outputs::EdgeRows;
use super::{Region, RegionError};
use crate::data::{Measurement, NodalDisplacements};

/// A sum of squares in units of their variances, with what noise alone makes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChiSquared {
    /// Number of squares n, which is also the mean.
    pub count: usize,
    /// Their sum χ² `[1]`.
    pub value: f64,
    /// Standard deviation of χ² `[1]`.
    pub deviation: f64,
}

impl ChiSquared {
    /// Computes how many standard deviations χ² lies above its mean, (χ² − n)/σ `[1]`.
    pub fn excess(&self) -> f64 {
        (self.value - self.count as f64) / self.deviation
    }

    /// Computes χ² of `values` that should vanish, in any unit, with their covariance in its square, row by row, n × n.
    ///
    /// # Errors
    /// [`RegionError::Length`] for a covariance of another size, [`RegionError::NotCovariance`] for a value without variance.
    pub fn of(values: &[f64], covariance: &[f64]) -> Result<Self, RegionError> {
        let count = values.len();
        if covariance.len() != count * count {
            let name = "the covariance";
            return Err(super::length(name, count * count, covariance.len()));
        }
        let covariance = Matrix::from_fn(count, count, |i, j| covariance[i * count + j]);
        Self::new(values, &covariance)
    }

    fn new(values: &[f64], covariance: &Matrix) -> Result<Self, RegionError> {
        let count = values.len();
        let variance = |i: usize| covariance[(i, i)];
        if let Some(row) = (0..count).find(|&i| variance(i) <= 0.0) {
            return Err(RegionError::NotCovariance { row });
        }
        let value = values
            .iter()
            .enumerate()
            .map(|(i, v)| v * v / variance(i))
            .sum();
        let correlated: f64 = (0..count)
            .flat_map(|i| (0..count).map(move |j| (i, j)))
            .map(|(i, j)| covariance[(i, j)].powi(2) / (variance(i) * variance(j)))
            .sum();
        Ok(Self {
            count,
            value,
            deviation: (2.0 * correlated).sqrt(),
        })
    }
}

/// A measured displacement that was not prescribed, against the calculated one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MisfitPoint {
    /// Index of the place in the measurement.
    pub index: usize,
    /// Where `[length]`.
    pub place: Point,
    /// Component: 0 for x, 1 for y.
    pub axis: usize,
    /// Measured less calculated displacement `[length]`.
    pub misfit: f64,
    /// Its standard deviation `[length]`.
    pub deviation: f64,
}

/// Misfit of all valid measured displacements in the region.
#[derive(Clone, Debug, PartialEq)]
pub struct Misfit {
    /// The points, in the order of the measurement.
    pub points: Vec<MisfitPoint>,
    /// Indices of places that are not in the region.
    pub outside: Vec<usize>,
    /// Sum of the squares.
    pub chi_squared: ChiSquared,
}

/// A part of an edge that nothing touches.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeEdge {
    /// Edge set.
    pub edge: String,
    /// First and last position of each free part along it `[length]`, as [`EdgeRows::parameter`]; on an arc radius times angle.
    pub ranges: Vec<[f64; 2]>,
}

/// An edge through which a known force goes.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownForce {
    /// Edge set.
    pub edge: String,
    /// Force `[force]` along x and y that what lies beyond the edge, on the side of its normal, exerts.
    pub force: [f64; 2],
}

/// Force through an edge against the known one.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance {
    /// Edge set.
    pub edge: String,
    /// Force found from the stresses less the known one `[force]`.
    pub excess: [f64; 2],
    /// Its standard deviations `[force]`.
    pub deviation: [f64; 2],
}

/// What to check besides the forces at prescribed nodes inside.
#[derive(Clone, Copy, Debug, Default)]
pub struct CheckInput<'a> {
    /// Displacements that were not used, and are independent of those that were.
    pub unused: Option<&'a Measurement>,
    /// Edges without traction.
    pub free_edges: &'a [FreeEdge],
    /// Edges with a known force.
    pub known_forces: &'a [KnownForce],
}

/// The checks of one measured state.
#[derive(Clone, Debug, PartialEq)]
pub struct Checks {
    /// Misfit at unused points.
    pub misfit: Option<Misfit>,
    /// Tractions σ_nn and τ_nt on each free edge.
    pub free_edges: Vec<ChiSquared>,
    /// Balance of each known force.
    pub balance: Vec<Balance>,
    /// Forces at prescribed nodes inside, where nothing acts; `None` without such nodes.
    pub interior_forces: Option<ChiSquared>,
}

impl Region {
    /// Checks the state `measured`, displacements of the prescribed nodes `[length]` with their covariance `[length²]`.
    ///
    /// # Errors
    /// As [`Region::propagate`]; [`RegionError::Mesh`] for an unknown edge, [`RegionError::NoData`] if no unused point lies in the
    /// region or no node on a free edge, [`RegionError::NotCovariance`] if a number has no variance.
    pub fn check(
        &self,
        measured: &NodalDisplacements,
        input: CheckInput<'_>,
    ) -> Result<Checks, RegionError> {
        let values = self.values(measured)?;
        let covariance = self.covariance(measured)?;
        let state = State {
            region: self,
            values,
            covariance,
        };
        let misfit = input
            .unused
            .map(|unused| state.misfit(unused))
            .transpose()?;
        let free_edges = input
            .free_edges
            .iter()
            .map(|free| state.free_edge(free))
            .collect::<Result<_, _>>()?;
        let balance = input
            .known_forces
            .iter()
            .map(|known| state.balance(known))
            .collect::<Result<_, _>>()?;
        let interior_forces = state.interior_forces()?;
        Ok(Checks {
            misfit,
            free_edges,
            balance,
            interior_forces,
        })
    }
}

struct State<'a> {
    region: &'a Region,
    values: Vec<f64>,
    covariance: Matrix,
}

impl State<'_> {
    fn propagate(&self, rows: &[SparseRow]) -> Result<(Vec<f64>, Matrix), RegionError> {
        let transfer = self.region.transfer(rows)?;
        let covariance = transfer.matrix.propagate_covariance(&self.covariance);
        Ok((transfer.product(&self.values), covariance))
    }

    fn misfit(&self, unused: &Measurement) -> Result<Misfit, RegionError> {
        let Points {
            rows,
            places,
            outside,
        } = measured_rows(self.region, unused)?;
        let transfer = self.region.transfer(&rows)?;
        let calculated = transfer.product(&self.values);
        let through = transfer.matrix.multiply(&self.covariance);
        let mut points = Vec::with_capacity(rows.len());
        let mut own = Vec::with_capacity(rows.len());
        for (k, (&(index, axis), calculated)) in places.iter().zip(calculated).enumerate() {
            let noise = unused.deviation[axis].powi(2);
            let carried = (0..self.values.len()).map(|j| through[(k, j)] * transfer.matrix[(k, j)]);
            let variance = noise + carried.sum::<f64>();
            own.push(noise / variance);
            points.push(MisfitPoint {
                index,
                place: unused.places[index],
                axis,
                misfit: unused.displacements[axis][index] - calculated,
                deviation: variance.sqrt(),
            });
        }
        // With B = D^(-1/2) T: Σᵢⱼ Cᵢⱼ²/(Cᵢᵢ Cⱼⱼ) = Σ aᵢ² + 2 Σ aᵢ (1 − aᵢ) + tr (Σ BᵀB)², a the share of the point's own noise.
        let scaled = Matrix::from_fn(rows.len(), self.values.len(), |i, j| {
            transfer.matrix[(i, j)] / points[i].deviation
        });
        let gram = scaled.transpose_multiply(&scaled);
        let spread = self.covariance.multiply(&gram);
        let correlated = own.iter().map(|a| a * (2.0 - a)).sum::<f64>() + trace_of_square(&spread);
        let chi_squared = ChiSquared {
            count: points.len(),
            value: points
                .iter()
                .map(|p| (p.misfit / p.deviation).powi(2))
                .sum(),
            deviation: (2.0 * correlated).sqrt(),
        };
        Ok(Misfit {
            points,
            outside,
            chi_squared,
        })
    }

    fn free_edge(&self, free: &FreeEdge) -> Result<ChiSquared, RegionError> {
        let edge = EdgeRows::new(self.region.body(), &free.edge)?;
        let is_free = |k: &usize| {
            let mut ranges = free.ranges.iter();
            ranges.any(|[from, to]| (*from..=*to).contains(&edge.parameter[*k]))
        };
        let inside = (0..edge.nodes.len()).filter(is_free);
        let rows: Vec<SparseRow> = inside
            .flat_map(|k| [edge.rows[3 * k].clone(), edge.rows[3 * k + 2].clone()])
            .collect();
        if rows.is_empty() {
            return Err(RegionError::NoData {
                places: edge.nodes.len(),
            });
        }
        let (tractions, covariance) = self.propagate(&rows)?;
        ChiSquared::new(&tractions, &covariance)
    }

    fn balance(&self, known: &KnownForce) -> Result<Balance, RegionError> {
        let body = self.region.body();
        let rows = EdgeRows::new(body, &known.edge)?.resultant(body.thickness());
        let (force, covariance) = self.propagate(&rows)?;
        Ok(Balance {
            edge: known.edge.clone(),
            excess: [0, 1].map(|i| force[i] - known.force[i]),
            deviation: [0, 1].map(|i| covariance[(i, i)].max(0.0).sqrt()),
        })
    }

    fn interior_forces(&self) -> Result<Option<ChiSquared>, RegionError> {
        let boundary = boundary_nodes(self.region.mesh());
        let inside = self
            .region
            .prescribed()
            .iter()
            .zip(self.region.reaction_rows());
        let rows: Vec<SparseRow> = inside
            .filter(|(dof, _)| boundary.binary_search(&(*dof / 2)).is_err())
            .map(|(_, row)| row.clone())
            .collect();
        if rows.is_empty() {
            return Ok(None);
        }
        let (forces, covariance) = self.propagate(&rows)?;
        ChiSquared::new(&forces, &covariance).map(Some)
    }
}

/// Rows of the displacements that were measured in a region.
pub(super) struct Points {
    pub(super) rows: Vec<SparseRow>,
    /// Index of the place and component of each row.
    pub(super) places: Vec<(usize, usize)>,
    pub(super) outside: Vec<usize>,
}

/// The valid components of `data` that lie in the region.
pub(super) fn measured_rows(region: &Region, data: &Measurement) -> Result<Points, RegionError> {
    let count = data.places.len();
    for axis in 0..2 {
        for (name, found) in [
            ("the measured displacements", data.displacements[axis].len()),
            (
                "the flags of the measured displacements",
                data.valid[axis].len(),
            ),
        ] {
            if found != count {
                return Err(super::length(name, count, found));
            }
        }
        let deviation = data.deviation[axis];
        if !(deviation > 0.0 && deviation.is_finite()) {
            return Err(RegionError::Deviation(deviation));
        }
    }
    let locator = Locator::new(region.mesh());
    let mut points = Points {
        rows: Vec::new(),
        places: Vec::new(),
        outside: Vec::new(),
    };
    for (index, &place) in data.places.iter().enumerate() {
        if !place.iter().all(|x| x.is_finite()) {
            return Err(RegionError::NotFinite {
                what: "measured place",
                index,
            });
        }
        let Some(located) = locator.locate(place) else {
            points.outside.push(index);
            continue;
        };
        for axis in (0..2).filter(|&axis| data.valid[axis][index]) {
            if !data.displacements[axis][index].is_finite() {
                let what = "measured displacement flagged as valid,";
                return Err(RegionError::NotFinite { what, index });
            }
            points.rows.push(located.row(axis));
            points.places.push((index, axis));
        }
    }
    if points.rows.is_empty() {
        return Err(RegionError::NoData { places: count });
    }
    Ok(points)
}

fn trace_of_square(matrix: &Matrix) -> f64 {
    let n = matrix.rows();
    (0..n)
        .flat_map(|i| (0..n).map(move |j| matrix[(i, j)] * matrix[(j, i)]))
        .sum()
}
