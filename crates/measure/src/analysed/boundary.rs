//! Displacements of the nodes that hold a region, from the data of a state.

use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::reduce::{LocalPolynomial, ReduceError, Reduction};
use stickslip_hybrid::region::RegionError;
use stickslip_hybrid::region::fit::Fitter;

use super::FitFacts;
use super::scale::{Residual, least_scale, residuals, scale};
use super::workbench::Workbench;
use crate::error::{ExperimentError, of_region};
use crate::measured::Measured;
use stickslip_experiment::{FreeMotion, Hole, Method, Source};

/// Displacements of the region's boundary, and how they were found.
#[derive(Default)]
pub(super) struct Boundary {
    pub(super) displacements: NodalDisplacements,
    /// Bias of the prescribed displacements `[mm]`; empty where nothing was smoothed.
    pub(super) bias: Vec<f64>,
    pub(super) fit: Option<FitFacts>,
    pub(super) scale: f64,
    /// Why no residuals say what the scale is, as text.
    pub(super) assumed: Option<String>,
    /// Prescribed displacements `[mm]` that the fit makes of a unit of each motion of the picture.
    pub(super) responses: Vec<(FreeMotion, Vec<f64>)>,
    /// Motions of the picture that were taken off, with their amounts.
    pub(super) taken_off: Vec<(FreeMotion, f64)>,
    /// What residuals say of the variance of a single datum, at least that of its standard deviation.
    pub(super) single: f64,
    /// Residuals of the fit over the stated standard deviations; none where nothing was fitted.
    pub(super) residuals: Vec<Residual>,
}

/// Displacements of both components at the places of a measurement by a unit of `motion`.
pub(super) fn field_of(motion: FreeMotion, data: &Measurement, hole: &Hole) -> [Vec<f64>; 2] {
    let each = data
        .places
        .iter()
        .map(|&place| motion.displacement(place, hole));
    let each: Vec<[f64; 2]> = each.collect();
    [0, 1].map(|axis| each.iter().map(|own| own[axis]).collect())
}

impl Workbench<'_> {
    pub(super) fn boundary(
        &self,
        measured: &Measured,
        used: &Measurement,
    ) -> Result<Boundary, ExperimentError> {
        let reduced = match self.experiment.reduce.method {
            Method::Fit => {
                let fitted = self.fitted(used, measured.floor);
                return fitted.map_err(|cause| self.refuse(measured, cause));
            }
            Method::Linear => {
                let nodes = self.region.prescribed_nodes();
                let longest = self.experiment.reduce.longest_side;
                Reduction::linear(used, self.region.mesh().nodes(), &nodes, longest)
                    .and_then(Reduction::complete)
                    .and_then(|reduction| reduction.displacements(used))
            }
            Method::Polynomial { order, neighbours } => self
                .polynomial(used, &self.region.prescribed_nodes(), order, neighbours)
                .and_then(|reduction| reduction.displacements(used)),
            Method::Lines { reach } => return self.along_lines(measured, reach),
        };
        let name = &self.experiment.states[measured.state].name;
        let displacements = reduced.map_err(|cause| ExperimentError::reduction(name, cause))?;
        let mut boundary = Boundary::plain(displacements);
        // s² is that of a fit to the same data: residuals of the displacements themselves would hold their own errors too.
        match self.fitted(used, measured.floor) {
            Ok(fit) => {
                (boundary.scale, boundary.single) = (fit.scale, fit.single);
                boundary.residuals = fit.residuals;
            }
            Err(cause) => {
                boundary.scale = least_scale(used.deviation, measured.floor).max(1.0);
                boundary.assumed = Some(of_region(self.experiment, &cause));
            }
        }
        for entry in &mut boundary.displacements.covariance {
            *entry *= boundary.scale;
        }
        Ok(boundary)
    }

    pub(super) fn polynomial(
        &self,
        used: &Measurement,
        nodes: &[usize],
        order: usize,
        neighbours: usize,
    ) -> Result<Reduction, ReduceError> {
        // Nodes on the hole's edge lie outside of the data; how uncertain that makes them the covariance says.
        let fit = LocalPolynomial {
            order,
            neighbours,
            largest_radius: f64::INFINITY,
            extrapolate: true,
        };
        Reduction::polynomial(used, self.region.mesh().nodes(), nodes, &fit)
            .and_then(Reduction::complete)
    }

    fn along_lines(&self, measured: &Measured, reach: f64) -> Result<Boundary, ExperimentError> {
        let state = &self.experiment.states[measured.state];
        let (Some([u, v]), Some(grating), Source::Lines(source)) =
            (&measured.lines, &self.experiment.grating, &state.source)
        else {
            return Err(ExperimentError::missing(
                "reduce.method",
                format!("state '{}' has no fringe lines", state.name),
                "choose method = \"fit\", or give lines = { … }",
            ));
        };
        let nodes = self.region.prescribed_nodes();
        Reduction::along_lines([u, v], self.region.mesh().nodes(), &nodes, reach)
            .and_then(Reduction::complete)
            .and_then(|reduction| {
                reduction.fringe_displacements([u, v], grating, [source.deviation; 2])
            })
            .map(Boundary::plain)
            .map_err(|cause| ExperimentError::reduction(&state.name, cause))
    }

    /// The fit to all data, whose errors have at least the standard deviations `floor`.
    fn fitted(&self, used: &Measurement, floor: [f64; 2]) -> Result<Boundary, RegionError> {
        let smoothing = self.plan.smoothing;
        let fitter = Fitter::new(&self.region, used, smoothing.order)?;
        let mut fit = fitter.fit(&used.displacements, smoothing.amount)?;
        let solution = self.region.solve(&fit.displacements)?;
        let residuals = residuals(self.region.mesh(), used, &solution.displacements);
        let of_residuals = scale(&residuals, fit.parameters);
        let scale = of_residuals.max(least_scale(used.deviation, floor));
        for entry in &mut fit.displacements.covariance {
            *entry *= scale;
        }
        let hole = &self.experiment.specimen.hole;
        let response = |motion: FreeMotion| {
            let values = fitter.values(&field_of(motion, used, hole), fit.amount);
            values.map(|values| (motion, values))
        };
        let responses = FreeMotion::ALL.into_iter().map(response);
        Ok(Boundary {
            responses: responses.collect::<Result<_, RegionError>>()?,
            scale,
            single: (fit.residual / (fit.data as f64 - fit.parameters).max(1.0)).max(1.0),
            bias: fit.bias,
            fit: Some(FitFacts {
                order: smoothing.order,
                amount: fit.amount,
                parameters: fit.parameters,
                kept: self.kept(&fit.kept),
                data: fit.data,
                residual: fit.residual,
                of_residuals,
            }),
            displacements: fit.displacements,
            residuals,
            ..Boundary::default()
        })
    }

    /// Mean over the edge of the part of displacements that their own data decide.
    fn kept(&self, parts: &[f64]) -> f64 {
        let prescribed = self.region.prescribed().iter().zip(parts);
        let own = prescribed.filter(|(dof, _)| self.edge.nodes.contains(&(*dof / 2)));
        let (sum, count) = own.fold((0.0, 0.0), |(sum, count), (_, part)| {
            (sum + part, count + 1.0)
        });
        sum / f64::max(count, 1.0)
    }
}

impl Boundary {
    fn plain(displacements: NodalDisplacements) -> Self {
        Self {
            displacements,
            scale: 1.0,
            single: 1.0,
            ..Self::default()
        }
    }
}
