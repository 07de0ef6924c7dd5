//! The region of an experiment, ready for any number of states.

use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::material::Material;
use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::reduce::{LocalPolynomial, Reduction};
use stickslip_hybrid::region::checks::{CheckInput, FreeEdge};
use stickslip_hybrid::region::direct::interpolate;
use stickslip_hybrid::region::fit::Fitter;
use stickslip_hybrid::region::locate::Locator;
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::transfer::Propagated;
use stickslip_hybrid::region::{Region, RegionError};

use super::edge::Edge;
use super::held_out::split;
use super::imported;
use super::scale::{Residual, least_scale, scale};
use super::{Analysed, FitFacts, MisfitAt};
use crate::experiment::error::ExperimentError;
use crate::experiment::measured::Measured;
use crate::experiment::plan::{Experiment, Method, RegionPlan, RegionShape, Source};

/// The edge set on which stresses are asked for.
const EDGE: &str = "inner";

/// A factorised region with the rows of its edge.
#[derive(Debug)]
pub struct Workbench<'a> {
    experiment: &'a Experiment,
    plan: &'a RegionPlan,
    region: Region,
    edge: Edge,
}

/// Displacements of the region's boundary, and how they were found.
struct Boundary {
    displacements: NodalDisplacements,
    /// Bias of the prescribed displacements `[mm]`; empty where nothing was smoothed.
    bias: Vec<f64>,
    fit: Option<FitFacts>,
    scale: f64,
}

impl<'a> Workbench<'a> {
    /// Meshes and factorises the region of `experiment`.
    ///
    /// # Errors
    /// [`ExperimentError::Missing`] without `[region]`, [`ExperimentError::Region`] for one that cannot be analysed.
    pub fn new(experiment: &'a Experiment) -> Result<Self, ExperimentError> {
        const SECTOR: &str = "write [region] sector = { angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [40, 10] }";
        let missing = |what: &str, remedy: &str| ExperimentError::Missing {
            key: "region".to_owned(),
            what: what.to_owned(),
            remedy: remedy.to_owned(),
        };
        let plan = experiment
            .region
            .as_ref()
            .ok_or_else(|| missing("edge stresses need a [region]", SECTOR))?;
        let refuse = |cause: RegionError| ExperimentError::Region {
            state: "all".to_owned(),
            key: "region".to_owned(),
            cause: Box::new(cause),
        };
        let specimen = &experiment.specimen;
        let (mesh, radius) = match &plan.shape {
            RegionShape::Sector(sector) => {
                let sector = ArcSector {
                    centre: specimen.hole.centre,
                    hole: specimen.hole.radius,
                    stand_off: sector.stand_off,
                    outer: sector.outer,
                    angles: sector.angles,
                    cells: sector.cells,
                    growth: sector.growth,
                    kind: sector.element,
                };
                (sector.mesh().map_err(refuse)?, sector.inner())
            }
            RegionShape::Mesh(mesh) => (
                imported::mesh(mesh, &specimen.hole, EDGE)?,
                specimen.hole.radius,
            ),
        };
        let mesh = Arc::new(mesh);
        let material = specimen
            .material
            .in_plane(specimen.plane)
            .map_err(|cause| {
                missing(
                    &format!("the specimen's material is none: {cause}"),
                    "correct its constants",
                )
            })?;
        let material: Arc<dyn Material> = Arc::from(material);
        let materials = mesh
            .blocks()
            .iter()
            .map(|_| Arc::clone(&material))
            .collect();
        let body = ElasticBody::new(mesh, materials, specimen.thickness);
        let body = Arc::new(body.map_err(|cause| refuse(cause.into()))?);
        let region = Region::new(&body, &[]).map_err(refuse)?;
        let edge = Edge::new(&body, EDGE, radius).map_err(refuse)?;
        Ok(Self {
            experiment,
            plan,
            region,
            edge,
        })
    }

    /// The edge stresses of a measured state, with all checks.
    ///
    /// # Errors
    /// [`ExperimentError::Region`] and [`ExperimentError::Reduction`] for data that do not determine them.
    pub fn analyse(&self, measured: &Measured) -> Result<Analysed, ExperimentError> {
        let (used, unused) = split(&measured.measurement);
        let boundary = self.boundary(measured, &used)?;
        let mut found = self.unchecked(measured, &boundary)?;
        found.direct = self.direct(&used);
        self.check(&mut found, &boundary, &unused)
            .map_err(|cause| self.refuse(measured, cause))?;
        Ok(found)
    }

    /// The edge stresses of a measured state alone: the same numbers, without checks and comparison.
    ///
    /// # Errors
    /// As [`analyse`](Self::analyse).
    pub fn stresses(&self, measured: &Measured) -> Result<Analysed, ExperimentError> {
        let (used, _) = split(&measured.measurement);
        let boundary = self.boundary(measured, &used)?;
        self.unchecked(measured, &boundary)
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
            direct: None,
            fit: boundary.fit,
            scale: boundary.scale,
            misfit: Vec::new(),
            unused: None,
            free_edge: None,
            forces: self.forces(boundary).map_err(refuse)?,
        })
    }

    fn refuse(&self, measured: &Measured, cause: RegionError) -> ExperimentError {
        ExperimentError::Region {
            state: self.experiment.states[measured.state].name.clone(),
            key: "region".to_owned(),
            cause: Box::new(cause),
        }
    }

    fn boundary(
        &self,
        measured: &Measured,
        used: &Measurement,
    ) -> Result<Boundary, ExperimentError> {
        let reduced = match self.experiment.reduce.method {
            Method::Fit => {
                let fitted = self.fitted(used, measured.floor);
                return fitted.map_err(|cause| self.refuse(measured, cause));
            }
            Method::Linear { longest_side } => {
                let nodes = self.region.prescribed_nodes();
                Reduction::linear(used, self.region.mesh().nodes(), &nodes, longest_side)
                    .and_then(Reduction::complete)
                    .and_then(|reduction| reduction.displacements(used))
            }
            Method::Polynomial { order, neighbours } => self
                .polynomial(used, &self.region.prescribed_nodes(), order, neighbours)
                .and_then(|reduction| reduction.displacements(used)),
            Method::Lines { reach } => return self.along_lines(measured, reach),
        };
        let displacements = reduced.map_err(|cause| ExperimentError::Reduction {
            state: self.experiment.states[measured.state].name.clone(),
            key: "reduce".to_owned(),
            cause: Box::new(cause),
        })?;
        Ok(Boundary::plain(displacements))
    }

    fn polynomial(
        &self,
        used: &Measurement,
        nodes: &[usize],
        order: usize,
        neighbours: usize,
    ) -> Result<Reduction, stickslip_hybrid::reduce::ReduceError> {
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
            return Err(ExperimentError::Missing {
                key: "reduce.method".to_owned(),
                what: format!("state '{}' has no fringe lines", state.name),
                remedy: "choose method = \"fit\", or give lines = { … }".to_owned(),
            });
        };
        let nodes = self.region.prescribed_nodes();
        Reduction::along_lines([u, v], self.region.mesh().nodes(), &nodes, reach)
            .and_then(Reduction::complete)
            .and_then(|reduction| {
                reduction.fringe_displacements([u, v], grating, [source.deviation; 2])
            })
            .map(Boundary::plain)
            .map_err(|cause| ExperimentError::Reduction {
                state: state.name.clone(),
                key: "reduce".to_owned(),
                cause: Box::new(cause),
            })
    }

    /// The fit to all data, whose errors have at least the deviations `floor`.
    fn fitted(&self, used: &Measurement, floor: [f64; 2]) -> Result<Boundary, RegionError> {
        let smoothing = self.plan.smoothing;
        let fitter = Fitter::new(&self.region, used, smoothing.order)?;
        let mut fit = fitter.fit(&used.displacements, smoothing.amount)?;
        let residuals = self.residuals(used, &fit.displacements)?;
        let of_residuals = scale(&residuals, fit.parameters);
        let scale = of_residuals.max(least_scale(used.deviation, floor));
        for entry in &mut fit.displacements.covariance {
            *entry *= scale;
        }
        Ok(Boundary {
            scale,
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

    /// Measured less calculated displacements over the stated deviations, of all valid data in the region.
    fn residuals(
        &self,
        data: &Measurement,
        boundary: &NodalDisplacements,
    ) -> Result<Vec<Residual>, RegionError> {
        let solution = self.region.solve(boundary)?;
        let locator = Locator::new(self.region.mesh());
        let mut residuals = Vec::new();
        for (k, &place) in data.places.iter().enumerate() {
            let Some(located) = locator.locate(place) else {
                continue;
            };
            for axis in (0..2).filter(|&axis| data.valid[axis][k]) {
                let parts = located.shape.iter();
                let calculated: f64 = parts
                    .map(|&(node, weight)| weight * solution.displacements[2 * node + axis])
                    .sum();
                residuals.push(Residual {
                    place,
                    axis,
                    value: (data.displacements[axis][k] - calculated) / data.deviation[axis],
                });
            }
        }
        Ok(residuals)
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

    /// The comparison without equilibrium: a local polynomial at every node that the edge's stresses need.
    fn direct(&self, used: &Measurement) -> Option<Vec<[f64; 3]>> {
        const NEIGHBOURS: usize = 24;
        let dofs = self.edge.stresses.iter().flatten();
        let mut nodes: Vec<usize> = dofs.map(|(dof, _)| dof / 2).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let reduction = self.polynomial(used, &nodes, 2, NEIGHBOURS).ok()?;
        let displacements = reduction.displacements(used).ok()?;
        let body = self.region.body();
        let found = interpolate(body, &self.edge.stresses, &displacements).ok()?;
        Some(self.edge.by_place(&found.values))
    }

    /// Force on the edge from its stresses plus that of its nodes on the region, which is nothing in balance.
    fn forces(&self, boundary: &Boundary) -> Result<Propagated, RegionError> {
        let by_stresses = &self.edge.resultant;
        let by_forces = self.region.reaction_resultant(&self.edge.nodes);
        let rows: Vec<SparseRow> = by_stresses.iter().cloned().chain(by_forces).collect();
        self.region.propagate(&rows, &boundary.displacements)
    }

    fn check(
        &self,
        found: &mut Analysed,
        boundary: &Boundary,
        unused: &Measurement,
    ) -> Result<(), RegionError> {
        let free: Vec<FreeEdge> = (super::edge::beyond_contact(found).into_iter())
            .map(|places| FreeEdge {
                edge: EDGE.to_owned(),
                range: [places.start, places.end - 1].map(|k| self.edge.parameter[k]),
            })
            .collect();
        let mut unused = unused.clone();
        // What the residuals say of the deviation of a single place; where they say less than was stated, the statement holds.
        if let Some(fit) = &found.fit {
            let single = fit.residual / (fit.data as f64 - fit.parameters).max(1.0);
            for deviation in &mut unused.deviation {
                *deviation *= single.max(1.0).sqrt();
            }
        }
        let any = (0..2).any(|axis| unused.valid[axis].contains(&true));
        let input = CheckInput {
            unused: any.then_some(&unused),
            free_edges: &free,
            known_forces: &[],
        };
        let checks = self.region.check(&boundary.displacements, input)?;
        found.free_edge = checks.free_edges.into_iter().next();
        if let Some(misfit) = checks.misfit {
            found.misfit = (misfit.points.iter())
                .map(|point| MisfitAt {
                    place: point.place,
                    axis: point.axis,
                    relative: point.misfit / point.deviation,
                })
                .collect();
            found.unused = Some(misfit.chi_squared);
        }
        Ok(())
    }
}

impl Boundary {
    fn plain(displacements: NodalDisplacements) -> Self {
        Self {
            displacements,
            bias: Vec::new(),
            fit: None,
            scale: 1.0,
        }
    }
}
