//! What error bars cost on a region of 20 150 displacements, in triangular solves of one right-hand side.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::SparseRow;
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::{Region, independent_covariance};

use super::check::Checks;
use crate::hybrid_noise::specimen::{analysed, body};
use crate::publish::TaskError;

const DRAWS: usize = 1000;
/// Rounds behind a median, and single solves timed in each.
const ROUNDS: usize = 7;
const SOLVES: usize = 51;
/// What everything is wanted to cost at the most, in triangular solves.
const MOST: f64 = 500.0;
/// Triangular solves in one of the symmetric system.
const TRIANGLES: f64 = 2.0;

/// Region, measured displacements and outputs of the case.
struct Work {
    body: Arc<ElasticBody>,
    region: Region,
    measured: NodalDisplacements,
    values: Vec<f64>,
    rows: Vec<SparseRow>,
}

/// One factorisation, the exact covariance of the edge stresses and [`DRAWS`] draws.
pub(super) fn checks(checks: &mut Checks) -> Result<(), TaskError> {
    let work = Work::new()?;
    let (outputs, prescribed) = (work.rows.len(), work.values.len());
    let propagated = work.region.propagate(&work.rows, &work.measured);
    let solves = propagated?.solves;
    let displacements = 2 * work.body.mesh().nodes().len();
    checks.completes(
        format!("region of {displacements} displacements: solves that the covariance of {outputs} stresses takes"),
        format!("the fewer of {outputs} and {prescribed}"),
        solves.to_string(),
        solves == outputs.min(prescribed),
    );
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut counts = vec![cores, 1];
    counts.dedup();
    for threads in counts {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let all = pool?.install(|| work.parts())?;
        let sum = all.iter().sum::<f64>();
        let name = if threads == 1 { "thread" } else { "threads" };
        // Times are shown and not asserted: a busy machine is no error.
        checks.show(
            format!("the same on {threads} {name}: times of the factorisation, the covariance and {DRAWS} draws, over that of one triangular solve"),
            format!("{MOST} in all"),
            format!("{:.0} + {:.0} + {:.0} = {sum:.0}", all[0], all[1], all[2]),
        );
    }
    Ok(())
}

impl Work {
    fn new() -> Result<Self, TaskError> {
        let sector = ArcSector {
            cells: [84, 39],
            ..analysed(1.0)
        };
        let body = body(&sector)?;
        let region = Region::new(&body, &[])?;
        let nodes = region.prescribed_nodes();
        let places = body.mesh().nodes();
        let measured = NodalDisplacements {
            values: (nodes.iter())
                .flat_map(|&node| places[node].map(|x| 1e-3 * x))
                .collect(),
            covariance: independent_covariance(nodes.len(), [6e-5; 2]),
            nodes,
        };
        Ok(Self {
            rows: EdgeRows::new(&body, "inner")?.rows,
            values: region.values(&measured)?,
            measured,
            region,
            body,
        })
    }

    /// Times of factorisation, covariance and draws over that of one triangular solve, of the round whose sum is the median. The parts
    /// of a round stand beside a single solve at the same time, as the machine's speed drifts.
    fn parts(&self) -> Result<[f64; 3], TaskError> {
        let Self {
            region,
            measured,
            values,
            rows,
            ..
        } = self;
        let transfer = region.transfer(rows)?;
        let round = |_| {
            let one = median(SOLVES, || drop(black_box(region.outputs_of(&[], values))));
            let all = [
                median(1, || drop(black_box(Region::new(&self.body, &[])))),
                median(1, || {
                    let transfer = region.transfer(rows);
                    drop(black_box(
                        transfer.map(|own| region.propagate_by(&own, measured)),
                    ));
                }),
                median(1, || {
                    drop(black_box(region.simulate_by(&transfer, measured, DRAWS, 7)));
                }),
            ];
            all.map(|time| TRIANGLES * time / one)
        };
        let mut rounds: Vec<[f64; 3]> = (0..ROUNDS).map(round).collect();
        let total = |parts: &[f64; 3]| parts.iter().sum::<f64>();
        rounds.sort_by(|a, b| total(a).total_cmp(&total(b)));
        Ok(rounds[ROUNDS / 2])
    }
}

/// Median of `samples` times of `work` `[s]`.
fn median(samples: usize, work: impl Fn()) -> f64 {
    let mut times: Vec<f64> = (0..samples)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[samples / 2]
}
