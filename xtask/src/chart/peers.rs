//! Other programs on the pin benchmark (`scenes/pin-benchmark.toml`, frictionless and with μ = 0.25).
//!
//! Their last measured runs are in `docs/charts/peers.csv`; `--peers` runs the programs that are installed and replaces their
//! rows. Programs differ in what they solve: contact on the undeformed or on the deformed shape, 0.3 % apart in the peak
//! pressure. Each contact method of a program is held against the reference that is nearer to its finest run, and no error is
//! called smaller than that reference is known:
//!
//! ```text
//! e = max(|p/p_r − 1|, u_r/p_r),     r: the reference with the smaller e on the finest mesh of the program and contact method
//! ```

mod calculix;
mod getfem;
mod job;

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::curve::Point;
use crate::publish::TaskError;

/// A reference for the peak pressure at 1240 lb while loading, and how well it is known `[psi]`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Known(f64, f64);

impl Known {
    /// How well it is known, relative.
    fn uncertainty(self) -> f64 {
        self.1 / self.0
    }

    fn error(self, peak: f64) -> f64 {
        (peak / self.0 - 1.0).abs().max(self.uncertainty())
    }
}

/// μ, and the references on the undeformed and on the deformed shape: on the undeformed one a condensed node-to-node code,
/// Q4 and Q8 agreeing; on the deformed one GetFEM, Kratos and CalculiX on fine meshes.
const REFERENCES: [(f64, [Known; 2]); 2] = [
    (0.0, [Known(31501.0, 2.0), Known(31600.0, 15.0)]),
    (0.25, [Known(25229.0, 2.0), Known(25293.0, 15.0)]),
];

/// A run that claims convergence with an error beyond this is a wrong answer: off the charts, and not held against the other runs
/// of its curve.
pub(super) const WRONG: f64 = 0.2;

/// Load steps of the job.
pub(super) const LOAD_STEPS: usize = 14;

/// A program's run of the whole history: a row of the file.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub(super) struct PeerRun {
    /// Program and version.
    pub(super) program: String,
    /// Its contact method.
    pub(super) contact: String,
    /// Its element.
    pub(super) element: String,
    /// Coefficient of friction.
    pub(super) mu: f64,
    /// Spacing of corner nodes `[deg]`.
    pub(super) spacing_deg: f64,
    /// Displacement unknowns.
    pub(super) unknowns: usize,
    /// Load steps that met the program's own tolerance, of 14.
    pub(super) steps_converged: usize,
    /// Largest pressure at 1240 lb while loading `[psi]`.
    pub(super) peak_pressure_psi: Option<f64>,
    /// Contact half-angle there `[deg]`.
    pub(super) contact_half_angle_deg: Option<f64>,
    /// σ_θ at 90° there `[psi]`.
    pub(super) hoop_at_90_deg_psi: Option<f64>,
    /// Friction force over μ times normal force there.
    pub(super) shear_ratio: Option<f64>,
    /// Wall time `[s]`.
    pub(super) wall_s: f64,
    /// Processor time `[s]`.
    pub(super) cpu_s: Option<f64>,
    /// One sparse Cholesky factorisation of its own stiffness matrix on the same machine `[s]`.
    pub(super) factorisation_s: Option<f64>,
    /// Processor time over that.
    pub(super) cpu_over_factorisation: Option<f64>,
    /// One sparse Cholesky factorisation of about 41 000 unknowns (Q4, 1.125°) on the same machine `[s]`.
    pub(super) yardstick_s: f64,
    /// Contact iterations of the whole history.
    pub(super) iterations: Option<usize>,
    /// When it was measured.
    pub(super) measured: String,
    /// Where.
    pub(super) machine: String,
    /// What its peak pressure is held against.
    #[serde(skip)]
    reference: Option<Known>,
}

impl PeerRun {
    /// Curve that it belongs to.
    pub(super) fn label(&self) -> String {
        let contact = self.contact.split(',').next().unwrap_or(&self.contact);
        format!("{}, {contact}, {}", self.name(), self.element)
    }

    fn same_method(&self, other: &Self) -> bool {
        self.name() == other.name() && self.contact == other.contact
    }

    /// The program without its version.
    fn name(&self) -> &str {
        self.program.split(' ').next().unwrap_or(&self.program)
    }

    /// The smaller one of wall and processor time `[s]`: runs shared the machine, so the kinder number.
    pub(super) fn seconds(&self) -> f64 {
        self.cpu_s.map_or(self.wall_s, |cpu| cpu.min(self.wall_s))
    }

    /// Relative error of the peak pressure, where all steps converged.
    pub(super) fn error(&self) -> Option<f64> {
        if self.steps_converged < LOAD_STEPS {
            return None;
        }
        Some(self.reference?.error(self.peak_pressure_psi?))
    }

    /// Seconds and error.
    pub(super) fn point(&self) -> Option<Point> {
        let (cost, error) = (self.seconds(), self.error()?);
        Some(Point { cost, error })
    }
}

/// Holds each contact method of a program, at each friction, against the reference that is nearer to its finest converged run.
fn refer(runs: &mut [PeerRun]) {
    let family = |a: &PeerRun, b: &PeerRun| a.same_method(b) && a.mu == b.mu;
    let chosen = |run: &PeerRun| {
        let others = runs
            .iter()
            .filter(|other| family(run, other) && other.steps_converged == LOAD_STEPS);
        let known = others.filter_map(|other| {
            let peak = other.peak_pressure_psi?;
            let reference = nearer(run.mu, peak)?;
            (reference.error(peak) < WRONG).then_some((other.unknowns, reference))
        });
        let finest = known.max_by_key(|(unknowns, _)| *unknowns);
        finest.map(|(_, reference)| reference)
    };
    let chosen: Vec<Option<Known>> = runs.iter().map(chosen).collect();
    for (run, reference) in runs.iter_mut().zip(chosen) {
        run.reference = reference;
    }
}

/// The reference from which a peak pressure `[psi]` is less off.
fn nearer(mu: f64, peak: f64) -> Option<Known> {
    let (_, references) = REFERENCES.iter().find(|(known, _)| *known == mu)?;
    let nearest = references
        .iter()
        .min_by(|a, b| a.error(peak).total_cmp(&b.error(peak)));
    nearest.copied()
}

/// The smallest error that can be resolved with the coefficient of friction `mu`.
pub(super) fn finest_error(mu: f64) -> f64 {
    let found = REFERENCES.iter().find(|(known, _)| *known == mu);
    found.map_or(0.0, |(_, [small, _])| small.uncertainty())
}

/// Relative error of a peak pressure `[MPa]` on the undeformed shape with the coefficient of friction `mu`, no smaller than can be resolved.
pub(super) fn undeformed_error(mu: f64, peak: f64) -> f64 {
    let found = REFERENCES.iter().find(|(known, _)| *known == mu);
    found.map_or(f64::NAN, |(_, [small, _])| small.error(peak / job::PSI))
}

/// Reads the runs of `path`.
pub(super) fn read(path: &Path) -> Result<Vec<PeerRun>, TaskError> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(path)?;
    let mut runs: Vec<PeerRun> = reader.deserialize().collect::<Result<_, _>>()?;
    refer(&mut runs);
    Ok(runs)
}

/// Runs the programs that are installed and puts their rows in place of those that they had with the same contact method.
pub(super) fn renew(
    runs: &mut Vec<PeerRun>,
    today: &str,
    machine: &str,
    yardstick: f64,
) -> Result<(), TaskError> {
    type Runs = fn(&str) -> Result<Vec<PeerRun>, TaskError>;
    let programs: [(&str, Option<String>, Runs); 2] = [
        ("CalculiX", calculix::version(), calculix::runs),
        ("GetFEM", getfem::version(), getfem::runs),
    ];
    let mut fresh = Vec::new();
    for (name, version, runs) in programs {
        match version {
            Some(version) => {
                eprintln!("  {name}: {version}");
                fresh.extend(runs(&version)?);
            }
            None => eprintln!("  {name} is not installed; its last measured runs are drawn"),
        }
    }
    for run in &mut fresh {
        today.clone_into(&mut run.measured);
        machine.clone_into(&mut run.machine);
        run.yardstick_s = job::rounded(yardstick, 4);
    }
    runs.retain(|old| !fresh.iter().any(|new| new.same_method(old)));
    runs.extend(fresh);
    refer(runs);
    Ok(())
}

/// `runs` as a table.
pub(super) fn csv(runs: &[PeerRun]) -> Result<Vec<u8>, TaskError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for run in runs {
        writer.serialize(run)?;
    }
    Ok(writer.into_inner()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_committed_runs_read_and_have_the_errors_that_their_numbers_say() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/charts/peers.csv");
        let runs = read(&path).unwrap();
        assert!(runs.len() > 40);
        assert!(
            runs.iter()
                .all(|run| run.seconds() > 0.0 && run.yardstick_s > 0.0)
        );
        assert!(runs.iter().filter_map(PeerRun::error).count() > 30);
    }

    fn run(unknowns: usize, mu: f64, peak: f64) -> PeerRun {
        PeerRun {
            program: "A 1".into(),
            unknowns,
            mu,
            steps_converged: LOAD_STEPS,
            peak_pressure_psi: Some(peak),
            ..PeerRun::default()
        }
    }

    #[test]
    fn a_method_keeps_the_reference_of_its_finest_run() {
        // The coarse run is near the other reference by chance, and the last one is wrong by whatever reference.
        let mut runs = [
            run(10, 0.0, 31600.0),
            run(90, 0.0, 31510.0),
            run(900, 0.0, 104_230.0),
        ];
        refer(&mut runs);
        assert!((runs[0].error().unwrap() - 99.0 / 31501.0).abs() < 1e-12);
        assert!((runs[1].error().unwrap() - 9.0 / 31501.0).abs() < 1e-12);
        assert!(runs[2].error().unwrap() > WRONG);
    }

    #[test]
    fn errors_are_not_below_the_uncertainty_of_the_reference() {
        for (mu, peak, expected) in [
            (0.25, 25293.0, Some(15.0 / 25293.0)),
            (0.25, 25229.5, Some(2.0 / 25229.0)),
            (0.5, 1.0, None),
        ] {
            let mut runs = [run(10, mu, peak)];
            refer(&mut runs);
            assert_eq!(runs[0].error(), expected);
        }
    }
}
