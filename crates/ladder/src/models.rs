//! The models of a ladder.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::InterfaceSolver;
use stickslip_scene::Scene;
use stickslip_scene::schema::{
    Body, Division as MeshDivision, KinematicsChoice, MeshSettings, Ramp,
};

use super::budget::Limited;
use super::division::Spaced;
use super::grading::{Domain, Grading};
use super::level::{Level, described, numbers};
use super::thinning;
use stickslip_engine::model::{Model, Seat};
use stickslip_engine::run::{Assembled, Progress, RunError, Seated, follow, follow_thinned, seats};

/// Nodes on half of a contact circle less one, of the model by series after which the coarsest one is graded.
const INTERVALS: usize = 30;
/// The finest nodes far from where contact changes are 2⁴ times closer than the coarsest.
const GRADINGS: usize = 4;
/// The finest cells are 2⁴ times smaller than the coarsest.
const HALVINGS: usize = 4;

/// By how much what a division leaves of displacements exceeds what it changed last, with re-entrant corners and of other general outlines.
const SLOW: [f64; 2] = [3.0, 1.5];

/// How the models of a ladder differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Division {
    /// Twice as many nodes of series from rung to rung.
    Series,
    /// Cells half as large from rung to rung.
    Elements,
    /// The division of the scene, after one of cells or nodes twice as far apart.
    Pinned,
}

/// Graded contact nodes, by angles or by places along a line contact.
#[derive(Clone, PartialEq)]
struct Graded {
    grading: Grading,
    angles: Vec<f64>,
}

impl Graded {
    fn new(grading: Grading) -> Self {
        Self {
            angles: grading.angles(),
            grading,
        }
    }
}

/// A model and its operators, ready for other increments and for the other geometry on which contact is found.
struct Made {
    rung: usize,
    graded: Option<Graded>,
    kinematics: KinematicsChoice,
    seating: Seating,
    model: Model,
    assembled: Assembled,
    /// The bodies of load steps in which they sit otherwise than in the model.
    seated: Vec<Option<Arc<Seated>>>,
    seconds: f64,
}

/// How bodies sit in their holes.
#[derive(Clone, Default, PartialEq)]
pub(super) struct Seating {
    /// In the model.
    seats: Vec<Option<Seat>>,
    /// In every load step, of bodies by series.
    steps: Vec<Vec<Option<Seat>>>,
}

/// Makes the models.
pub(super) struct Models<'a> {
    scene: &'a Scene,
    solver: &'a dyn InterfaceSolver,
    division: Division,
    /// Whether bodies are half-planes, whose contact nodes stand along a line.
    pub(super) of_lines: bool,
    /// How the contact nodes of rungs by series are graded, by rung.
    graded: BTreeMap<usize, Graded>,
    /// How bodies sit in their holes in the models that follow.
    seating: Seating,
    /// What was made last.
    made: Option<Made>,
    /// The model by which nodes were last found to have meshes, before bodies are seated.
    draft: Option<Model>,
    /// On which geometry contact is found.
    pub(super) kinematics: KinematicsChoice,
    /// When a model is given up, on the clock of the scene's host `[s]`.
    pub(super) until: Option<f64>,
    /// Whether the last one was given up.
    pub(super) stopped: bool,
}

impl<'a> Models<'a> {
    pub(super) fn new(scene: &'a Scene, solver: &'a dyn InterfaceSolver) -> Result<Self, RunError> {
        let is_pinned = scene.is_divided_anywhere() || scene.analysis.contact_nodes.is_some();
        let model = Model::build(scene)?;
        let mut series = model.bodies.iter().filter_map(|body| body.series.as_ref());
        let of_lines = series.clone().any(|body| body.line_nodes().is_some());
        let division = if is_pinned {
            Division::Pinned
        } else if series.next().is_some() {
            Division::Series
        } else {
            Division::Elements
        };
        let kinematics = match scene.kinematics() {
            // Half-planes have no other.
            KinematicsChoice::Auto if of_lines => KinematicsChoice::Small,
            asked => asked,
        };
        Ok(Self {
            scene,
            solver,
            division,
            of_lines,
            graded: BTreeMap::new(),
            seating: Seating::default(),
            made: None,
            draft: None,
            kinematics,
            until: None,
            stopped: false,
        })
    }

    pub(super) fn division(&self) -> Division {
        self.division
    }

    /// Whether the division is left to the program.
    pub(super) fn is_free(&self) -> bool {
        self.division != Division::Pinned
    }

    pub(super) fn solver(&self) -> &'a dyn InterfaceSolver {
        self.solver
    }

    /// Whether no finer rung than `rung` is tried.
    pub(super) fn is_finest(&self, rung: usize) -> bool {
        match self.division {
            Division::Series => rung >= GRADINGS,
            Division::Elements => rung >= HALVINGS,
            Division::Pinned => true,
        }
    }

    /// Whether nodes are graded.
    pub(super) fn is_graded(&self) -> bool {
        self.division == Division::Series
    }

    /// Indices of the bodies of `model` of which finer models have smaller cells in some places alone: where nodes are graded.
    pub(super) fn uneven(&self, model: &Model) -> Vec<usize> {
        if !self.is_graded() {
            return Vec::new();
        }
        let is_meshed = |&body: &usize| {
            let own = &model.bodies[body];
            own.elastic().is_some() && own.series.is_none()
        };
        (0..model.bodies.len()).filter(is_meshed).collect()
    }

    /// How nodes are spaced.
    pub(super) fn spaced(&self) -> Spaced {
        match (self.is_graded(), self.kinematics) {
            (false, _) => Spaced::Equally,
            (true, _) if self.of_lines => Spaced::GradedLine,
            (true, KinematicsChoice::DeformedGaps) => Spaced::GradedDeformed,
            (true, _) => Spaced::Graded,
        }
    }

    /// How bodies sit in the models that follow.
    pub(super) fn seating(&self) -> Seating {
        self.seating.clone()
    }

    /// Lets bodies sit in the models that follow as `seating` says.
    pub(super) fn sit_as(&mut self, seating: Seating) {
        self.seating = seating;
    }

    /// Grades the nodes of `rung` towards the places where contact changes in `level`, a model that is no finer, if they are those of series.
    pub(super) fn grade(&mut self, level: &Level, rung: usize) {
        if self.is_graded() {
            let mut seats = seats::seats(&level.model, &level.solved);
            // Elements keep their operator from one geometry to the other.
            for (seat, pair) in seats.iter_mut().zip(&level.model.pairs) {
                if level.model.bodies[pair.second].series.is_none() {
                    *seat = None;
                }
            }
            let steps = seats::of_steps(&level.model, &level.solved, &seats);
            self.seating = Seating { seats, steps };
            let mut edges = level.numbers.geometries.iter();
            let Some(domain) = edges.find(|edge| edge.contact).map(Domain::of) else {
                return;
            };
            let widest = PI / INTERVALS as f64;
            let graded = |mirrored| {
                Graded::new(Grading::new(
                    &level.numbers,
                    domain,
                    (rung, widest),
                    mirrored,
                ))
            };
            let is_whole_line = matches!(domain, Domain::Line([from, _]) if from < 0.0);
            self.graded.insert(rung, graded(is_whole_line));
            // The lattice in the middle of a disk's mesh bears many more cells on one side than on the other only so far.
            if domain == Domain::Circle {
                self.draft = Model::build(&self.scene_of(rung).0).ok();
                if self.draft.is_none() {
                    self.graded.insert(rung, graded(true));
                }
            }
        }
    }

    /// Seats bodies in their holes as they sit in `level`, where nodes of elements that are paired there are too far apart on the deformed geometry; whether the models that follow differ
    /// by that.
    pub(super) fn seat(&mut self, level: &Level) -> bool {
        if self.is_graded() {
            return false;
        }
        let wanted = seats::wanted(&level.model, &level.solved);
        let is_wanted = wanted.iter().any(Option::is_some);
        let seats = &mut self.seating.seats;
        seats.resize(wanted.len(), None);
        for (own, wanted) in seats.iter_mut().zip(wanted) {
            if wanted.is_some() {
                *own = wanted;
            }
        }
        is_wanted
    }

    /// Solves the model of a rung; rung 0 is the coarsest, and those whose nodes are graded need [`grade`](Self::grade) before.
    pub(super) fn level(
        &mut self,
        rung: usize,
        substeps: &[usize],
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Level, RunError> {
        let host = self.scene.host();
        let start = host.seconds();
        let (scene, division) = self.scene_of(rung);
        let made = self.made(&scene, rung, progress)?;
        let (mut model, making) = (made.model.with_laws_and_history(&scene)?, made.seconds);
        model.divide_history(substeps)?;
        let (assembled, seated) = (made.assembled.clone(), made.seated.clone());
        let ready = host.seconds();
        let graded = self.graded.get(&rung).filter(|_| self.is_graded());
        let chosen = graded.and_then(|graded| thinning::chosen(&model, &graded.grading));
        let limited = self
            .until
            .map(|until| Limited::new(self.solver, host, until));
        let solver = (limited.as_ref()).map_or(self.solver, |own| own as &dyn InterfaceSolver);
        let followed = match &chosen {
            Some(chosen) => follow_thinned(&model, assembled, solver, (chosen, &seated), progress),
            None => follow(
                &model,
                assembled.operators,
                assembled.interface,
                solver,
                progress,
            ),
        };
        self.stopped = limited.as_ref().is_some_and(Limited::has_refused);
        let mut solved = followed?;
        solved.phases.insert(0, ("operators", ready - start));
        let numbers = numbers(&model, &solved)?;
        let end = host.seconds();
        Ok(Level {
            rung,
            substeps: substeps.to_vec(),
            seconds: end - start,
            seconds_anew: end - ready + making,
            numbers,
            division: described(division, &solved),
            model,
            solved,
        })
    }

    /// The model and the operators of `scene`, that of `rung`: of what was made last as much as fits.
    fn made(
        &mut self,
        scene: &Scene,
        rung: usize,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<&Made, RunError> {
        let start = self.scene.host().seconds();
        let graded = self.graded.get(&rung).filter(|_| self.is_graded()).cloned();
        let kinematics = self.kinematics;
        let seating = self.seating.clone();
        // Load steps have nodes of their own where these are graded.
        let seated = |model: &Model, assembled: &Assembled| match graded {
            Some(_) => {
                let steps = (&*seating.steps, &*seating.seats);
                Seated::of_steps(model, assembled, steps, |seats| {
                    Model::build_on(scene, Some(model), seats)
                })
            }
            None => Ok(Vec::new()),
        };
        let last = self.made.take();
        let made = match last.filter(|made| made.rung == rung && made.graded == graded) {
            Some(made) if made.kinematics == kinematics && made.seating == seating => made,
            Some(made) if self.is_graded() || made.seating == seating => {
                let model = Model::build_on(scene, Some(&made.model), &seating.seats)?;
                let assembled = made.assembled.with_series_of(&model)?;
                Made {
                    kinematics,
                    seated: seated(&model, &assembled)?,
                    seating,
                    model,
                    assembled,
                    ..made
                }
            }
            _ => {
                let draft = self.draft.take();
                let model = Model::build_on(scene, draft.as_ref(), &seating.seats)?;
                let assembled = Assembled::of(&model, progress)?;
                Made {
                    rung,
                    kinematics,
                    seated: seated(&model, &assembled)?,
                    graded,
                    seating,
                    model,
                    assembled,
                    seconds: self.scene.host().seconds() - start,
                }
            }
        };
        Ok(self.made.insert(made))
    }

    /// What its series are.
    fn kind(&self) -> &'static str {
        if self.of_lines {
            "half-planes"
        } else {
            "series"
        }
    }

    /// How the model of `rung` is divided, for a reader.
    pub(super) fn division_of(&self, rung: usize) -> String {
        self.scene_of(rung).1
    }

    /// The scene of a rung, and how it is divided.
    fn scene_of(&self, rung: usize) -> (Scene, String) {
        let mut scene = self.scene.clone();
        scene.analysis.kinematics = Some(self.kinematics);
        if scene.analysis.ramp.is_none() && scene.analysis.substeps.is_none() {
            scene.analysis.ramp = Some(Ramp::Contact);
        }
        let graded = self.graded.get(&rung).filter(|_| self.is_graded());
        self.divide(&mut scene, rung, graded);
        let division = self.described(&scene, graded);
        (scene, division)
    }

    /// Divides `scene` as `rung` is.
    fn divide(&self, scene: &mut Scene, rung: usize, graded: Option<&Graded>) {
        match self.division {
            Division::Series => match graded {
                Some(Graded { angles, .. }) if self.of_lines => {
                    scene.mesh.division = MeshDivision::Places(angles.clone());
                }
                Some(Graded { angles, .. }) => {
                    scene.mesh.division = MeshDivision::AngleList(angles.clone());
                }
                None if self.of_lines => {}
                None => scene.analysis.contact_nodes = Some((INTERVALS << rung) + 1),
            },
            Division::Elements => {
                each_mesh(scene, coarsest);
                (0..rung).for_each(|_| each_mesh(scene, MeshSettings::finer));
            }
            Division::Pinned => {
                for _ in rung..1 {
                    match &mut scene.analysis.contact_nodes {
                        Some(count) => *count = (*count - 1).div_ceil(2) + 1,
                        None => each_mesh(scene, MeshSettings::coarser),
                    }
                }
            }
        }
    }

    /// How the divided `scene` is divided, for a reader.
    fn described(&self, scene: &Scene, graded: Option<&Graded>) -> String {
        let mut division = match (graded, scene.analysis.contact_nodes) {
            (Some(graded), _) => {
                let (kind, count) = (self.kind(), graded.angles.len());
                format!("{kind}, {count} graded nodes")
            }
            (None, None) if self.of_lines || self.division == Division::Series => {
                format!("{}, {}", self.kind(), scene.mesh.division)
            }
            (None, Some(count)) => format!("series, {count} nodes on half a circle"),
            (None, None) => format!("{} cells, {}", cells(scene), scene.mesh.division),
        };
        if let Some(own) = &scene.mesh_by_lengths {
            division = format!("{division} and {}", own.division);
        }
        if self.kinematics == KinematicsChoice::DeformedGaps {
            division += ", deformed gaps";
        }
        division
    }
}

/// The kinds of cells that the bodies of a scene have.
fn cells(scene: &Scene) -> String {
    let kind = |body: &Body| {
        let asked = body.mesh.as_ref().unwrap_or(&scene.mesh).element;
        body.shape.cells(asked).unwrap_or(asked).name()
    };
    let names: BTreeSet<&str> = scene.bodies.values().map(kind).collect();
    names.into_iter().collect::<Vec<_>>().join(" and ")
}

/// With fewer cells of outlines where no edge rules: finer ones than usual pay from the second model on.
fn coarsest(own: &MeshSettings) -> MeshSettings {
    MeshSettings {
        fineness: 0.5 * own.fineness,
        ..own.clone()
    }
}

fn each_mesh(scene: &mut Scene, change: fn(&MeshSettings) -> MeshSettings) {
    scene.mesh = change(&scene.mesh);
    scene.mesh_by_lengths = scene.mesh_by_lengths.as_ref().map(change);
    for body in scene.bodies.values_mut() {
        body.mesh = body.mesh.as_ref().map(change);
    }
}

/// By how much what a division of `model` leaves of displacements exceeds what it changed last.
pub(super) fn slowness(model: &Model) -> f64 {
    let own = model.bodies.iter().map(|body| {
        let is_general = body.is_general && body.series.is_none();
        match (is_general, body.corners.is_empty()) {
            (false, _) => 1.0,
            (true, false) => SLOW[0],
            (true, true) => SLOW[1],
        }
    });
    own.fold(1.0, f64::max)
}
