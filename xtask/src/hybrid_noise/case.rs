//! One reduction of one measurement: noise and bias of the shear on the edge.

use stickslip_fem_core::body::SparseRow;
use stickslip_hybrid::data::{FringeLine, Measurement, NodalDisplacements};
use stickslip_hybrid::moire::Grating;
use stickslip_hybrid::reduce::{LocalPolynomial, Reduction};
use stickslip_hybrid::region::fit::{Amount, Fitter};
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::{Region, RegionError, independent_covariance};

use super::specimen::{self, DEVIATION, Specimen, angle, disturbed, tractions};
use crate::study::TaskError;

/// How nodes get their displacements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Method {
    /// Every node is measured itself, with an error of its own.
    Nodes,
    /// Linear on a triangle of data.
    Linear,
    /// Linear between neighbouring centres of fringe lines that follow the region's boundary. Not among [`Method::ALL`], as such data
    /// have no number in a cell.
    Lines,
    /// A quadratic through the nearest 12 data.
    Polynomial,
    /// All data of the region by least squares, with equilibrium inside and nothing else.
    Equilibrium,
    /// The same with smoothing along the boundary, as a share of the amount that cross-validation chooses.
    Smoothed(f64),
}

/// Sides of triangles above this many spacings are gaps in the data.
const LONGEST: f64 = 4.0;
/// Neighbours of a local polynomial, and the share of smoothing that is advised.
const NEIGHBOURS: usize = 12;
pub(crate) const SHARE: f64 = 0.4;
/// Order of the differences that are smoothed.
const ORDER: usize = 2;

impl Method {
    pub(crate) const ALL: [Self; 5] = [
        Self::Nodes,
        Self::Linear,
        Self::Polynomial,
        Self::Equilibrium,
        Self::Smoothed(SHARE),
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Nodes => "nodes themselves",
            Self::Linear => "linear on triangles",
            Self::Lines => "linear along fringe lines",
            Self::Polynomial => "local quadratics",
            Self::Equilibrium => "fit, equilibrium alone",
            Self::Smoothed(_) => "fit, smoothed",
        }
    }
}

/// A measurement, a mesh and a reduction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) method: Method,
    /// Size of the cells along the edge `[mm]`.
    pub(crate) size: f64,
    /// Spacing of the data `[mm]`.
    pub(crate) spacing: f64,
    /// Distance of the first data from the edge `[mm]`.
    pub(crate) stand_off: f64,
}

/// The answer of a case: root mean squares along the edge, two cells at either end left out `[MPa]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quality {
    /// Standard deviation of the shear by the propagated covariance.
    pub(crate) noise: f64,
    /// Standard deviation over the seeds.
    pub(crate) drawn: f64,
    /// Change of the shear, without noise, from that of the nodes' true displacements: the bias of the reduction.
    pub(crate) bias: f64,
    /// Error of the shear from the nodes' true displacements: the bias of the mesh.
    pub(crate) mesh: f64,
}

/// Region, edge, and the shear there by the nodes' true displacements.
struct Analysis {
    region: Region,
    edge: EdgeRows,
    truth: NodalDisplacements,
}

impl Analysis {
    fn new(specimen: &Specimen, size: f64) -> Result<Self, TaskError> {
        let body = specimen::body(&specimen::analysed(size))?;
        let region = Region::new(&body, &[])?;
        let nodes = region.prescribed_nodes();
        let places: Vec<_> = nodes
            .iter()
            .map(|&node| region.mesh().nodes()[node])
            .collect();
        let truth = NodalDisplacements {
            values: specimen.displacements_at(&places)?,
            covariance: independent_covariance(nodes.len(), [DEVIATION; 2]),
            nodes,
        };
        Ok(Self {
            edge: EdgeRows::new(&body, "inner")?,
            region,
            truth,
        })
    }

    fn quality(&self, exact: &NodalDisplacements, draws: &[f64]) -> Result<Quality, TaskError> {
        let shear: Vec<SparseRow> = self.edge.component(2);
        let propagated = self.region.propagate(&shear, exact)?;
        let mean = &propagated.values;
        let unreduced = self.region.solve(&self.truth)?.outputs(&shear);
        let applied: Vec<f64> = (self.edge.parameter.iter())
            .map(|s| tractions(angle(*s))[1])
            .collect();
        let states = self.region.outputs_of(&shear, draws)?;
        let states = states.chunks_exact(shear.len());
        let count = states.len() as f64;
        let squares: f64 = states.map(|state| apart(state, mean).powi(2)).sum();
        Ok(Quality {
            noise: inside(&propagated.deviations()),
            drawn: (squares / count).sqrt(),
            bias: apart(mean, &unreduced),
            mesh: apart(&unreduced, &applied),
        })
    }
}

impl Case {
    /// Solves it with `seeds` draws of the noise; `None` where the method needs data that are not there.
    pub(crate) fn solve(
        &self,
        specimen: &Specimen,
        seeds: u64,
    ) -> Result<Option<Quality>, TaskError> {
        let analysis = Analysis::new(specimen, self.size)?;
        let exact = specimen.measure(self.spacing, self.stand_off)?;
        match self.method {
            Method::Nodes => measured_nodes(&analysis, seeds).map(Some),
            Method::Linear | Method::Polynomial => self.nodal(&analysis, &exact, seeds),
            Method::Lines => self.along_lines(specimen, &analysis, seeds).map(Some),
            Method::Equilibrium => fitted(&analysis, &exact, 0.0, seeds),
            Method::Smoothed(share) => fitted(&analysis, &exact, share, seeds),
        }
    }

    fn nodal(
        &self,
        analysis: &Analysis,
        exact: &Measurement,
        seeds: u64,
    ) -> Result<Option<Quality>, TaskError> {
        let nodes = analysis.region.prescribed_nodes();
        let places = analysis.region.mesh().nodes();
        let reduction = if self.method == Method::Linear {
            Reduction::linear(exact, places, &nodes, Some(LONGEST * self.spacing))?
        } else {
            let fit = LocalPolynomial {
                order: 2,
                neighbours: NEIGHBOURS,
                largest_radius: f64::INFINITY,
                extrapolate: true,
            };
            Reduction::polynomial(exact, places, &nodes, &fit)?
        };
        let Ok(reduction) = reduction.complete() else {
            return Ok(None);
        };
        let from = reduction.displacements(exact)?;
        let [u, v] = &exact.displacements;
        drawn(analysis, &reduction, &from, [u, v], seeds).map(Some)
    }

    fn along_lines(
        &self,
        specimen: &Specimen,
        analysis: &Analysis,
        seeds: u64,
    ) -> Result<Quality, TaskError> {
        let grating = Grating::new(specimen::FREQUENCY)?;
        let [u, v] = specimen.lines(self.size, self.spacing)?;
        let nodes = analysis.region.prescribed_nodes();
        let places = analysis.region.mesh().nodes();
        let reduction = Reduction::along_lines([&u, &v], places, &nodes, 1e-6)?.complete()?;
        let error = [specimen::ERROR / 3.0_f64.sqrt(); 2];
        let from = reduction.fringe_displacements([&u, &v], &grating, error)?;
        let data = [&u, &v].map(|field| -> Vec<f64> {
            let orders = field.lines.iter().flat_map(FringeLine::orders);
            orders.map(|&order| grating.displacement(order)).collect()
        });
        drawn(analysis, &reduction, &from, [&data[0], &data[1]], seeds)
    }
}

/// Draws of the noise of data that are reduced to the nodes, `from` without it.
fn drawn(
    analysis: &Analysis,
    reduction: &Reduction,
    from: &NodalDisplacements,
    [u, v]: [&[f64]; 2],
    seeds: u64,
) -> Result<Quality, TaskError> {
    let exact = [u, v].concat();
    let draws = (0..seeds)
        .map(|seed| {
            let data = specimen::shaken(&exact, seed);
            let (u, v) = data.split_at(u.len());
            let drawn = NodalDisplacements {
                nodes: reduction.nodes().to_vec(),
                values: reduction.values([u, v])?,
                covariance: Vec::new(),
            };
            Ok(analysis.region.values(&drawn)?)
        })
        .collect::<Result<Vec<_>, TaskError>>()?;
    analysis.quality(from, &draws.concat())
}

/// Every prescribed node with an error of its own.
fn measured_nodes(analysis: &Analysis, seeds: u64) -> Result<Quality, TaskError> {
    let exact = analysis.region.values(&analysis.truth)?;
    let draws: Vec<f64> = (0..seeds)
        .flat_map(|seed| specimen::shaken(&exact, seed))
        .collect();
    analysis.quality(&analysis.truth, &draws)
}

/// A fit with `share` of the smoothing that cross-validation chooses; `None` where the data leave something open.
fn fitted(
    analysis: &Analysis,
    exact: &Measurement,
    share: f64,
    seeds: u64,
) -> Result<Option<Quality>, TaskError> {
    let fitter = match Fitter::new(&analysis.region, exact, ORDER) {
        Ok(fitter) => fitter,
        Err(RegionError::NotDetermined { .. }) => return Ok(None),
        Err(error) => return Err(error.into()),
    };
    // Every measurement chooses its own amount, as an experimentalist's would.
    let chosen = |state: &[Vec<f64>; 2]| -> Result<f64, RegionError> {
        let none = share == 0.0;
        Ok(if none {
            0.0
        } else {
            share * fitter.cross_validated(state)?
        })
    };
    let amount = chosen(&disturbed(exact, seeds).displacements)?;
    let Ok(fit) = fitter.fit(&exact.displacements, Amount::Given(amount)) else {
        return Ok(None);
    };
    let draws = (0..seeds)
        .map(|seed| {
            let state = disturbed(exact, seed).displacements;
            Ok(fitter.values(&state, chosen(&state)?)?)
        })
        .collect::<Result<Vec<_>, TaskError>>()?;
    analysis
        .quality(&fit.displacements, &draws.concat())
        .map(Some)
}

/// Root mean square of differences.
fn apart(first: &[f64], second: &[f64]) -> f64 {
    let differences: Vec<f64> = first.iter().zip(second).map(|(a, b)| a - b).collect();
    inside(&differences)
}

/// Root mean square over the nodes farther than two quadratic cells from the ends.
pub(crate) fn inside(values: &[f64]) -> f64 {
    const LEFT_OUT: usize = 4;
    let own = &values[LEFT_OUT..values.len() - LEFT_OUT];
    (own.iter().map(|v| v * v).sum::<f64>() / own.len() as f64).sqrt()
}
