//! What a picture may add to the displacements of a state: a dilation, and the tilt of the specimen towards the camera.
//!
//! ```text
//! m = H d + C q + errors,   C = x                      dilation: the specimen or the camera came nearer
//!                           C = x X/r, x Y/r           tilt: the near side of the specimen is seen larger, by q at the distance r
//! free edge:  0 = A (d − R q)   ⇒   q = G A d,   G = (Yᵀ V Y)⁻¹ Yᵀ V,   Y = A R,   V = diag(1/variances)
//! ```
//!
//! with x = (X, Y) from the middle of the hole, r its radius, R the boundary displacements that the fit makes of C, and A the tractions on
//! the edge clear of contact. In a region whose whole boundary moves as measured, a dilation looks like a uniform strain: it is in
//! equilibrium, and no datum inside contradicts it. Only the edge clear of contact distinguishes it from a load, because its tractions are
//! known to vanish. A known force through the edge would be ten times less sensitive: a uniform stress has no resultant on a whole turn,
//! and a dilation of 1e-4 adds some per cent to the force of a half. Without a free edge nothing is taken off, and the result says so.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::body::SparseRow;
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::RegionError;

use super::Analysed;
use super::boundary::Boundary;
use super::edge::beyond_contact;
use super::workbench::Workbench;
use stickslip_experiment::FreeMotion;

/// Pressures on the free edge by the error of the mesh, part of the hoop stress there.
const MESH: f64 = 0.01;
/// Mean squares of the tractions that remain on the free edge, over their variances, beyond which it is not free, or not understood.
const UNEXPLAINED: f64 = 4.0;

/// What the free edge says of one amount.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureMotion {
    /// What it is.
    pub motion: FreeMotion,
    /// Its amount, a strain at the distance of the hole's radius, and its standard deviation by noise and smoothing `[1]`; `None` where the data
    /// do not distinguish it from a load, or a free edge contradicts it.
    pub amount: Option<[f64; 2]>,
    /// Whether it was taken off, and its uncertainty added to that of all results.
    pub taken_off: bool,
    /// Largest change of the pressure on the edge by a unit of it `[MPa]`.
    pub pressure: f64,
}

/// The amounts that the tractions of a free edge ask for, as they follow from these.
struct Estimate {
    motions: Vec<FreeMotion>,
    /// G, motions × tractions of the free edge.
    gain: DMatrix<f64>,
    amounts: DVector<f64>,
    covariance: DMatrix<f64>,
    /// Places of the edge that are free.
    places: Vec<usize>,
}

impl Workbench<'_> {
    /// Estimates the amounts, and takes those off `boundary` that the experiment declares to be free.
    pub(super) fn without_picture_motions(
        &self,
        found: &Analysed,
        boundary: &mut Boundary,
    ) -> Result<Vec<PictureMotion>, RegionError> {
        let free = &self.experiment.reduce.free;
        let motions = if free.is_empty() {
            vec![FreeMotion::Dilation]
        } else {
            free.clone()
        };
        let responses: Vec<Vec<f64>> = motions
            .iter()
            .map(|own| boundary.response(self, *own))
            .collect();
        let stresses = responses.iter();
        let stresses: Vec<Vec<f64>> = stresses
            .map(|own| self.region.outputs_of(&self.edge.stresses, own))
            .collect::<Result<_, _>>()?;
        let estimate = self.estimate(found, motions.clone(), &stresses);
        let taken_off = !free.is_empty() && estimate.is_some();
        if let Some(own) = estimate.as_ref().filter(|_| taken_off) {
            self.take_off(own, &responses, boundary)?;
        }
        let places = found.angle.len();
        let motion = |(k, &motion): (usize, &FreeMotion)| PictureMotion {
            motion,
            amount: estimate
                .as_ref()
                .map(|own| [own.amounts[k], own.covariance[(k, k)].max(0.0).sqrt()]),
            taken_off,
            pressure: stresses[k][..places]
                .iter()
                .fold(0.0, |most, own| own.abs().max(most)),
        };
        Ok(motions.iter().enumerate().map(motion).collect())
    }

    /// What the free edge says; `None` without one, or where it does not distinguish the motions.
    fn estimate(
        &self,
        found: &Analysed,
        motions: Vec<FreeMotion>,
        stresses: &[Vec<f64>],
    ) -> Option<Estimate> {
        if self.stands_off() {
            return None;
        }
        let places: Vec<usize> = beyond_contact(found).into_iter().flatten().collect();
        let count = found.angle.len();
        let free: Vec<(usize, f64)> = places.iter().map(|&place| (place, 1.0)).collect();
        let free = found.tractions.at(&free);
        // Pressure, then shear, as in the covariance.
        let rows: Vec<usize> = (0..2)
            .flat_map(|part| places.iter().map(move |k| part * count + k))
            .collect();
        let own = |row: usize, column: usize| {
            let value = stresses[column][row];
            if row < count { -value } else { value }
        };
        let y = DMatrix::from_fn(rows.len(), motions.len(), |i, k| own(rows[i], k));
        let covariance = DMatrix::from_row_slice(rows.len(), rows.len(), &free.covariance);
        let tractions = DVector::from_vec([free.pressure, free.shear].concat());
        let bias = rows.iter().map(|&row| found.bias[row % count][row / count]);
        let bias = DVector::from_iterator(rows.len(), bias);
        let weighted = DMatrix::from_fn(rows.len(), motions.len(), |i, k| {
            y[(i, k)] / covariance[(i, i)]
        });
        let gain = weighted.tr_mul(&y).cholesky()?.solve(&weighted.transpose());
        let amounts = &gain * &tractions;
        // What no motion of the picture explains is an error of the free edge: of mesh, correlated noise, or contact after all.
        let left = &tractions - &y * &amounts;
        let degrees = rows.len().saturating_sub(motions.len()).max(1) as f64;
        let pressed = |&row: &usize| if row < count { found.hoop[row] } else { 0.0 };
        let mesh: Vec<f64> = rows.iter().map(|row| MESH * pressed(row)).collect();
        let square = |i: usize| left[i].powi(2) / (covariance[(i, i)] + mesh[i].powi(2));
        let excess = ((0..rows.len()).map(square).sum::<f64>() / degrees).max(1.0);
        if excess > UNEXPLAINED {
            return None;
        }
        let mesh = &gain * DVector::from_vec(mesh);
        let systematic = &gain * bias;
        Some(Estimate {
            amounts,
            covariance: excess * (&gain * covariance * gain.transpose())
                + &systematic * systematic.transpose()
                + &mesh * mesh.transpose(),
            gain,
            motions,
            places,
        })
    }

    /// Boundary displacements d − R G A d, with the covariance that this has.
    fn take_off(
        &self,
        own: &Estimate,
        responses: &[Vec<f64>],
        boundary: &mut Boundary,
    ) -> Result<(), RegionError> {
        let count = self.edge.angle.len();
        let rows: Vec<SparseRow> = (0..2)
            .flat_map(|part| own.places.iter().map(move |k| part * count + k))
            .map(|row| self.edge.stresses[row].clone())
            .collect();
        let transfer = self.region.transfer(&rows)?;
        let prescribed = self.region.prescribed();
        let pressures = own.places.len();
        let tractions = DMatrix::from_fn(rows.len(), prescribed.len(), |i, j| {
            let value = transfer.derivative(i, j);
            if i < pressures { -value } else { value }
        });
        let responses = DMatrix::from_fn(prescribed.len(), responses.len(), |i, k| responses[k][i]);
        let change = &responses * (&own.gain * tractions);
        let displacements = &mut boundary.displacements;
        let positions: Vec<usize> = prescribed
            .iter()
            .map(|dof| position(displacements, *dof))
            .collect();
        let size = displacements.values.len();
        let values = DVector::from_iterator(
            positions.len(),
            positions.iter().map(|&k| displacements.values[k]),
        );
        let values = &values - &change * &values;
        let keep = DMatrix::identity(positions.len(), positions.len()) - change;
        let covariance = DMatrix::from_fn(positions.len(), positions.len(), |i, j| {
            displacements.covariance[positions[i] * size + positions[j]]
        });
        let covariance = &keep * covariance * keep.transpose();
        for (i, &row) in positions.iter().enumerate() {
            displacements.values[row] = values[i];
            for (j, &column) in positions.iter().enumerate() {
                displacements.covariance[row * size + column] = covariance[(i, j)];
            }
        }
        if !boundary.bias.is_empty() {
            let bias = &keep * DVector::from_column_slice(&boundary.bias);
            boundary.bias = bias.as_slice().to_vec();
        }
        boundary.taken_off = (own.motions.iter().copied())
            .zip(own.amounts.iter().copied())
            .collect();
        Ok(())
    }
}

/// Where a degree of freedom stands among the values of nodes.
fn position(displacements: &NodalDisplacements, dof: usize) -> usize {
    // Nodes of a boundary are those of the region, ascending.
    2 * displacements.nodes.partition_point(|&node| node < dof / 2) + dof % 2
}

impl Boundary {
    /// Prescribed displacements that a unit of a motion makes of the data.
    fn response(&self, bench: &Workbench<'_>, motion: FreeMotion) -> Vec<f64> {
        if let Some((_, found)) = self.responses.iter().find(|(own, _)| *own == motion) {
            return found.clone();
        }
        // Interpolations of at least first order keep a dilation, and others nearly.
        let nodes = bench.region.mesh().nodes();
        let at = |dof: &usize| {
            motion.displacement(nodes[dof / 2], &bench.experiment.specimen.hole)[dof % 2]
        };
        bench.region.prescribed().iter().map(at).collect()
    }
}
