//! The benchmark's meshes, numbered as one, and the peak pressure of somebody else's displacements on them.

use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use stickslip::model::{Model, ModelBodyKind};
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::internal_forces;
use stickslip_fem_core::mesh::{EdgeRef, ElementKind, Point};
use stickslip_laboratory::problems::{Pairing, Problem};

use super::{LOAD_STEPS, PeerRun};
use crate::publish::TaskError;

/// 1 psi in MPa.
pub(super) const PSI: f64 = 6.894757293168361e-3;
/// The load step that is compared: 1240 lb while loading.
pub(super) const COMPARED: usize = 3;
/// Runs of other programs are stopped after this time.
const LIMIT: Duration = Duration::from_secs(175);

/// Plate and pin, upper half; mm, N, MPa.
#[derive(Debug)]
pub(super) struct Job {
    pub(super) mu: f64,
    pub(super) element: ElementKind,
    pub(super) spacing: f64,
    plate: Arc<ElasticBody>,
    pin: Arc<ElasticBody>,
    /// Pull on the half plate's left edge at the end of each step `[N]`.
    pub(super) pulls: Vec<f64>,
}

/// Young's modulus `[MPa]` and Poisson's ratio of both bodies, plane stress.
pub(super) const YOUNG: f64 = 10.4e6 * PSI;
pub(super) const POISSON: f64 = 0.33;

/// One of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Plate,
    Pin,
}

impl Job {
    pub(super) fn new(mu: f64, element: ElementKind, spacing: f64) -> Result<Self, TaskError> {
        let problem = if mu == 0.0 {
            Problem::AluminiumFrictionless
        } else {
            Problem::AluminiumFrictional
        };
        let scene = problem.build(spacing, element, Pairing::NodePairs)?;
        let model = Model::build(&scene)?;
        let body = |name: &str| {
            let found = model.bodies.iter().find(|body| body.name == name);
            match found.map(|body| &body.kind) {
                Some(ModelBodyKind::Elastic(body)) => Ok(Arc::clone(body)),
                _ => Err(TaskError::from(format!(
                    "the benchmark has no elastic {name}"
                ))),
            }
        };
        // The scene gives the whole plate's pull; this is half of it.
        let whole = scene
            .loads
            .first()
            .map_or(&[][..], |load| load.kind.steps());
        Ok(Self {
            mu,
            element,
            spacing,
            plate: body("plate")?,
            pin: body("pin")?,
            pulls: whole.iter().map(|pull| 0.5 * pull).collect(),
        })
    }

    pub(super) fn body(&self, part: Part) -> &ElasticBody {
        match part {
            Part::Plate => &self.plate,
            Part::Pin => &self.pin,
        }
    }

    /// Number of a part's first node and first cell in the common numbering, from 0.
    pub(super) fn offsets(&self, part: Part) -> [usize; 2] {
        match part {
            Part::Plate => [0, 0],
            Part::Pin => {
                let mesh = self.plate.mesh();
                [mesh.nodes().len(), mesh.element_count()]
            }
        }
    }

    pub(super) fn unknowns(&self) -> usize {
        2 * (self.plate.mesh().nodes().len() + self.pin.mesh().nodes().len())
    }

    /// Traction `[MPa]` on the plate's left edge of `height` `[mm]` at the end of each step.
    pub(super) fn tractions(&self) -> Vec<f64> {
        let [low, high] = self.plate.mesh().bounding_box();
        let area = (high[1] - low[1]) * self.plate.thickness();
        self.pulls.iter().map(|pull| pull / area).collect()
    }

    /// Nodes of a named set of a part, in the common numbering from 0.
    pub(super) fn nodes(&self, part: Part, set: &str) -> Result<Vec<usize>, TaskError> {
        let [first, _] = self.offsets(part);
        let mesh = self.body(part).mesh();
        let nodes = mesh.node_set(set)?;
        Ok(nodes.iter().map(|node| first + node).collect())
    }

    /// Edges of a named set of a part; cells in the common numbering from 0.
    pub(super) fn edges(&self, part: Part, set: &str) -> Result<Vec<EdgeRef>, TaskError> {
        let [_, first] = self.offsets(part);
        let mesh = self.body(part).mesh();
        let edges = mesh.edge_set(set)?;
        Ok(edges
            .edges
            .iter()
            .map(|edge| EdgeRef {
                element: first + edge.element,
                ..*edge
            })
            .collect())
    }

    /// Coordinates of all nodes `[mm]` and nodes of all cells, in the common numbering.
    pub(super) fn mesh(&self) -> (Vec<Point>, Vec<Vec<usize>>) {
        let mut points = Vec::new();
        let mut cells = Vec::new();
        for part in [Part::Plate, Part::Pin] {
            let first = points.len();
            let mesh = self.body(part).mesh();
            points.extend_from_slice(mesh.nodes());
            for cell in 0..mesh.element_count() {
                let (_, nodes, _) = mesh.element(cell);
                cells.push(nodes.iter().map(|node| first + node).collect());
            }
        }
        (points, cells)
    }

    /// The row of a run that yielded the displacements `steps` of the plate's nodes at the end of each step.
    pub(super) fn peer_run(
        &self,
        program: &str,
        contact: String,
        element: String,
        cost: Cost,
        steps: &[Vec<[f64; 2]>],
    ) -> Result<PeerRun, TaskError> {
        let compared = steps.get(COMPARED);
        let peak = compared.map(|u| self.peak_pressure(u)).transpose()?;
        let run = PeerRun {
            program: program.to_owned(),
            contact,
            element,
            mu: self.mu,
            spacing_deg: self.spacing,
            unknowns: self.unknowns(),
            steps_converged: steps.len(),
            peak_pressure_psi: peak.map(|psi| rounded(psi, 1)),
            wall_s: rounded(cost.wall, 3),
            cpu_s: cost.cpu.map(|seconds| rounded(seconds, 3)),
            ..PeerRun::default()
        };
        eprintln!(
            "  {program}, {}, {}, μ = {}, {}°: {:.2} s, {} of {LOAD_STEPS} steps, peak pressure {:.0} psi",
            run.contact,
            run.element,
            run.mu,
            run.spacing_deg,
            run.seconds(),
            run.steps_converged,
            peak.unwrap_or(f64::NAN)
        );
        Ok(run)
    }

    /// Largest contact pressure `[psi]` of the displacements `u` `[mm]` of the plate's nodes: nodal forces K u on the hole over
    /// the nodes' lengths of arc.
    pub(super) fn peak_pressure(&self, u: &[[f64; 2]]) -> Result<f64, TaskError> {
        let mesh = self.plate.mesh();
        if u.len() != mesh.nodes().len() {
            return Err("displacements of another mesh".into());
        }
        let forces = internal_forces(&self.plate, &u.concat());
        let path = mesh.edge_path("hole")?;
        let hole = mesh.edge_set("hole")?;
        let weights = mesh.edge_weights(&path, hole.curve);
        let mut highest = 0.0_f64;
        for (&node, length) in path.nodes.iter().zip(weights) {
            let [x, y] = mesh.nodes()[node];
            let radius = x.hypot(y);
            let force = [forces[2 * node], forces[2 * node + 1]];
            // On the line of symmetry the vertical part is the support's.
            let on_axis = y.abs() < 1e-9 * radius;
            let outward = (force[0] * x + if on_axis { 0.0 } else { force[1] * y }) / radius;
            highest = highest.max(outward / (length * self.plate.thickness()));
        }
        Ok(highest / PSI)
    }
}

/// Displacements `[mm]` of the plate's nodes at the end of each step.
pub(super) type Steps = Vec<Vec<[f64; 2]>>;

/// What a run took `[s]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cost {
    pub(super) wall: f64,
    /// User and system, where the system reports them.
    pub(super) cpu: Option<f64>,
}

/// Runs `command` without output, at most as long as a run may take.
pub(super) fn wait(command: &mut Command) -> Result<Cost, TaskError> {
    let before = children_seconds();
    let start = Instant::now();
    let mut child = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()?;
    while child.try_wait()?.is_none() {
        if start.elapsed() > LIMIT {
            child.kill()?;
            child.wait()?;
            break;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    Ok(Cost {
        wall: start.elapsed().as_secs_f64(),
        cpu: before
            .zip(children_seconds())
            .map(|(before, after)| after - before),
    })
}

/// Processor time of all children that ended `[s]`: fields 16 and 17 of Linux's `/proc/self/stat`, in hundredths.
fn children_seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The second field, in brackets, may contain spaces.
    let (_, rest) = text.rsplit_once(')')?;
    let fields: Vec<&str> = rest.split_whitespace().collect();
    let ticks = |k: usize| fields.get(k)?.parse::<f64>().ok();
    Some(0.01 * (ticks(13)? + ticks(14)?))
}

/// `value` with so many decimals, as it is kept in the file.
pub(super) fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10_f64.powi(decimals);
    (scale * value).round() / scale
}

#[cfg(test)]
mod tests {
    use stickslip::run::run;
    use stickslip::scene::schema::FieldOutput;

    use super::*;

    /// The measure that other programs are held to gives this program's own pressure back.
    #[test]
    fn the_peak_of_our_own_displacements_is_our_own_peak() {
        let mut scene = Problem::AluminiumFrictional
            .build(9.0, ElementKind::Q8, Pairing::NodePairs)
            .unwrap();
        scene.output.fields = FieldOutput::All;
        let results = run(&scene, &mut |_| {}).unwrap();
        let step = &results.steps[COMPARED];
        let plate = results
            .bodies
            .iter()
            .position(|b| b.name == "plate")
            .unwrap();
        let fields = step.fields.iter().find(|f| f.body == plate).unwrap();
        let u: Vec<[f64; 2]> = fields
            .displacement
            .chunks_exact(2)
            .map(|pair| [pair[0], pair[1]])
            .collect();
        let job = Job::new(0.25, ElementKind::Q8, 9.0).unwrap();
        let peak = job.peak_pressure(&u).unwrap();
        let own = step.edges[0].peak_pressure.unwrap().0 / PSI;
        // Nodal forces from displacements: rounding of K u over the contact force.
        assert!((peak / own - 1.0).abs() < 1e-6, "{peak} {own}");
        assert!((job.tractions()[COMPARED] / PSI - 1240.0 / (3.0 * 0.06)).abs() < 1e-6);
    }
}
