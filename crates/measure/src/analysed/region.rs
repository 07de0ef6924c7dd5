//! Edge stresses of a measured state by the region of its experiment, with their checks.

use stickslip_fem_core::body::SparseRow;
use stickslip_hybrid::data::Measurement;
use stickslip_hybrid::region::RegionError;
use stickslip_hybrid::region::checks::{CheckInput, ChiSquared};
use stickslip_hybrid::region::direct::interpolate;
use stickslip_hybrid::region::locate::Locator;
use stickslip_hybrid::region::transfer::Propagated;

use super::boundary::{Boundary, field_of};
use super::edge::beyond_contact;
use super::held_out::split;
use super::workbench::Workbench;
use super::{Analysed, Checked, MisfitAt, NodalForce};
use crate::error::{ExperimentError, of_reduction, of_region};
use crate::measured::Measured;
use stickslip_experiment::Experiment;

/// Edge stresses of all states.
///
/// # Errors
/// [`ExperimentError`]: no `[region]`, a region that cannot be analysed, data that do not determine it.
pub fn all(experiment: &Experiment, fields: &[Measured]) -> Result<Vec<Analysed>, ExperimentError> {
    let bench = Workbench::new(experiment)?;
    fields.iter().map(|field| bench.analyse(field)).collect()
}

impl Workbench<'_> {
    /// The edge stresses of a measured state, with all checks.
    ///
    /// # Errors
    /// [`ExperimentError::Region`] and [`ExperimentError::Reduction`] for data that do not determine them.
    pub fn analyse(&self, measured: &Measured) -> Result<Analysed, ExperimentError> {
        let (used, unused) = split(&measured.measurement);
        let (boundary, mut found) = self.freed(measured, &used)?;
        let refuse = |cause| self.refuse(measured, cause);
        match self.direct(&used) {
            Ok(direct) => found.direct = Some(direct),
            Err(why) => found.without_direct = Some(why),
        }
        found.checks = self.checked(&found, &boundary, unused).map_err(refuse)?;
        found.nodal_forces = self.nodal_forces(&boundary).map_err(refuse)?;
        Ok(found)
    }

    /// The edge stresses of a measured state alone: the same numbers, without checks and comparison.
    ///
    /// # Errors
    /// As [`analyse`](Self::analyse).
    pub fn stresses(&self, measured: &Measured) -> Result<Analysed, ExperimentError> {
        let (used, _) = split(&measured.measurement);
        self.freed(measured, &used).map(|(_, found)| found)
    }

    /// Boundary and stresses, without what the picture added.
    fn freed(
        &self,
        measured: &Measured,
        used: &Measurement,
    ) -> Result<(Boundary, Analysed), ExperimentError> {
        let mut boundary = self.boundary(measured, used)?;
        let mut found = self.unchecked(measured, &boundary)?;
        let picture = self.without_picture_motions(&found, &mut boundary);
        let picture = picture.map_err(|cause| self.refuse(measured, cause))?;
        if !boundary.taken_off.is_empty() {
            found = self.unchecked(measured, &boundary)?;
        }
        found.picture = picture;
        Ok((boundary, found))
    }

    fn unchecked(
        &self,
        measured: &Measured,
        boundary: &Boundary,
    ) -> Result<Analysed, ExperimentError> {
        let refuse = |cause| self.refuse(measured, cause);
        let all = self
            .region
            .propagate(&self.edge.stresses, &boundary.displacements);
        let stresses = all.map_err(refuse)?;
        let bias = self.bias(boundary).map_err(refuse)?;
        let tractions = self.edge.tractions(&stresses, &bias);
        Ok(Analysed {
            state: measured.state,
            angle: self.edge.angle.clone(),
            resolution: self
                .edge
                .resolution(boundary.fit.map_or(1.0, |fit| fit.kept)),
            hoop: self.edge.hoop(&stresses.values),
            hoop_deviation: self.edge.hoop_deviation(&stresses, &bias),
            tractions,
            bias,
            fit: boundary.fit,
            scale: boundary.scale,
            scale_assumed: boundary.assumed.clone(),
            residuals: boundary.residuals.clone(),
            forces: self.forces(boundary).map_err(refuse)?,
            ..Analysed::default()
        })
    }

    /// Bias of pressure, shear and hoop stress at each place.
    fn bias(&self, boundary: &Boundary) -> Result<Vec<[f64; 3]>, RegionError> {
        if boundary.bias.is_empty() {
            return Ok(vec![[0.0; 3]; self.edge.angle.len()]);
        }
        let stresses = self
            .region
            .outputs_of(&self.edge.stresses, &boundary.bias)?;
        Ok(self.edge.by_place(&stresses))
    }

    /// The comparison without equilibrium: a local polynomial at every node that the edge's stresses need; as text why there is none.
    fn direct(&self, used: &Measurement) -> Result<Vec<[f64; 3]>, String> {
        const NEIGHBOURS: usize = 24;
        let dofs = self.edge.stresses.iter().flatten();
        let mut nodes: Vec<usize> = dofs.map(|(dof, _)| dof / 2).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let displacements = self
            .polynomial(used, &nodes, 2, NEIGHBOURS)
            .and_then(|reduction| reduction.displacements(used))
            .map_err(|cause| of_reduction(self.experiment, &cause))?;
        let body = self.region.body();
        let found = interpolate(body, &self.edge.stresses, &displacements)
            .map_err(|cause| of_region(self.experiment, &cause))?;
        Ok(self.edge.by_place(&found.values))
    }

    /// Force on the edge from its stresses plus that of its nodes on the region, which is nothing in balance.
    fn forces(&self, boundary: &Boundary) -> Result<Propagated, RegionError> {
        let by_stresses = &self.edge.resultant;
        let by_forces = self.region.reaction_resultant(&self.edge.nodes);
        let rows: Vec<SparseRow> = by_stresses.iter().cloned().chain(by_forces).collect();
        self.region.propagate(&rows, &boundary.displacements)
    }

    /// Forces at all nodes that move as measured.
    fn nodal_forces(&self, boundary: &Boundary) -> Result<Vec<NodalForce>, RegionError> {
        let region = &self.region;
        let forces = region.propagate(region.reaction_rows(), &boundary.displacements)?;
        let deviations = forces.deviations();
        // Both components of each node are prescribed, in turn.
        let nodes = region.prescribed().iter().step_by(2).enumerate();
        let force = |(k, dof): (usize, &usize)| NodalForce {
            place: region.mesh().nodes()[dof / 2],
            force: [0, 1].map(|axis| forces.values[2 * k + axis]),
            deviation: [0, 1].map(|axis| deviations[2 * k + axis]),
            inside: self.interior.binary_search(&(dof / 2)).is_ok(),
        };
        Ok(nodes.map(force).collect())
    }

    fn checked(
        &self,
        found: &Analysed,
        boundary: &Boundary,
        mut unused: Measurement,
    ) -> Result<Checked, RegionError> {
        for deviation in &mut unused.deviation {
            *deviation *= boundary.single.sqrt();
        }
        for (motion, amount) in &boundary.taken_off {
            let field = field_of(*motion, &unused, &self.experiment.specimen.hole);
            for (own, added) in unused.displacements.iter_mut().zip(field) {
                own.iter_mut()
                    .zip(added)
                    .for_each(|(u, added)| *u -= amount * added);
            }
        }
        let locator = Locator::new(self.region.mesh());
        // Few data may all be kept outside of the region.
        let any = (0..unused.places.len()).any(|k| {
            unused.valid.iter().any(|valid| valid[k]) && locator.locate(unused.places[k]).is_some()
        });
        let input = CheckInput {
            unused: any.then_some(&unused),
            ..CheckInput::default()
        };
        let checks = self.region.check(&boundary.displacements, input)?;
        let misfit = checks.misfit.as_ref();
        let points = misfit.into_iter().flat_map(|misfit| &misfit.points);
        let own = points.map(|point| MisfitAt {
            place: point.place,
            axis: point.axis,
            relative: point.misfit / point.deviation,
        });
        Ok(Checked {
            misfit: own.collect(),
            unused: misfit.map(|misfit| misfit.chi_squared),
            free_edge: self.free_edge(found)?,
            interior: checks.interior_forces,
            force: self.known_force(found, boundary)?,
        })
    }

    /// χ² of the tractions on the edge clear of contact, as uncertain as noise and smoothing make them; none on an edge that stands off
    /// from the hole, inside of the body.
    fn free_edge(&self, found: &Analysed) -> Result<Option<ChiSquared>, RegionError> {
        let ranges = beyond_contact(found);
        if self.stands_off() || ranges.is_empty() {
            return Ok(None);
        }
        let places: Vec<(usize, f64)> = (ranges.into_iter().flatten())
            .map(|place| (place, 1.0))
            .collect();
        let own = found.tractions.at(&places);
        let values = [own.pressure, own.shear].concat();
        ChiSquared::of(&values, &own.covariance).map(Some)
    }
}
