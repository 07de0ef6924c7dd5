//! What a run answered, as plain numbers that can be mirrored, turned and scaled, and the largest difference of two answers.
//!
//! Each number is measured by the largest of its kind on its edge in the whole history of both answers: stresses by the largest
//! pressure or stress, gaps and slips by the largest of both or by what the largest pressure gives the softest body, forces by the
//! largest force. Stresses and forces below a millionth of what the largest motion would give if it were strain count as zero.

use std::f64::consts::{FRAC_PI_2, TAU};

use stickslip::results::{ContactFinding, EdgeKind, EdgeRow, Finding, Results};

/// How far apart two places on an edge are still one: radians, or parts of the edge's length.
const SAME_PLACE: f64 = 1e-7;

/// Part of the stress that a motion would give a body which counts as none at all.
const REST: f64 = 1e-6;

/// One node of an edge: pressure, shear, gap, slip, stress along the edge.
#[derive(Clone, Copy, Debug)]
struct Row {
    place: f64,
    values: [f64; 5],
}

impl Row {
    fn of(place: f64, row: &EdgeRow) -> Self {
        let [p, shear, gap, slip] = [row.pressure, row.shear, row.gap, row.slip];
        let values = [p, shear, gap, slip, row.sigma_tangential];
        Self { place, values }
    }
}

/// Names of a row's numbers.
const NAMES: [&str; 5] = ["CPRESS", "CSHEAR1", "COPEN", "CSLIP1", "hoop stress"];

#[derive(Clone, Debug)]
struct EdgeStep {
    rows: Vec<Row>,
    resultant: [f64; 2],
    normal: f64,
}

#[derive(Clone, Debug)]
struct Edge {
    name: String,
    circle: bool,
    /// Whether slip means anything: a body that turns freely carries an arbitrary one.
    slips: bool,
    steps: Vec<EdgeStep>,
}

/// What the findings say is free at the end of a step.
#[derive(Clone, Debug, Default)]
struct Free {
    /// Edges whose gaps and slips are one of many.
    places: Vec<String>,
    /// Whether everything else is, because it follows from such gaps.
    all: bool,
}

impl Free {
    /// For each step of `results`.
    fn of(results: &Results) -> Vec<Self> {
        let mut free = vec![Self::default(); results.steps.len()];
        for finding in &results.findings {
            let Finding::Contact {
                contact,
                finding:
                    ContactFinding::GapsUndetermined { steps, .. }
                    | ContactFinding::SlipUndetermined { steps, .. },
            } = finding
            else {
                continue;
            };
            let first = steps[0];
            for (index, step) in free.iter_mut().enumerate().skip(first - 1) {
                step.places.push(contact.clone());
                step.all |= index >= first || results.steps[index].increments > 1;
            }
        }
        free
    }
}

/// The numbers of a run.
#[derive(Clone, Debug)]
pub(super) struct Answer {
    edges: Vec<Edge>,
    dissipation: Vec<f64>,
    free: Vec<Free>,
}

/// The largest difference of two answers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Difference {
    /// Relative to the largest number of its kind.
    pub(super) relative: f64,
    /// Which number, and both of its values.
    pub(super) found: String,
}

impl Answer {
    /// The numbers of `results`.
    pub(super) fn of(results: &Results) -> Self {
        let edges = results.edges.iter().enumerate().map(|(index, geometry)| {
            let steps = results.steps.iter().map(|step| {
                let edge = &step.edges[index];
                let rows = geometry.parameter.iter().zip(&edge.rows);
                EdgeStep {
                    rows: rows.map(|(place, row)| Row::of(*place, row)).collect(),
                    resultant: edge.resultant,
                    normal: edge.normal_force,
                }
            });
            let moves_freely = |finding: &Finding| match finding {
                Finding::FreeBody(free) => free.contacts.contains(&geometry.name),
                Finding::Contact { contact, finding } => {
                    let slides = matches!(finding, ContactFinding::SlipUndetermined { .. });
                    slides && *contact == geometry.name
                }
                _ => false,
            };
            Edge {
                name: geometry.name.clone(),
                circle: matches!(geometry.kind, EdgeKind::Circle { .. }),
                slips: !results.findings.iter().any(moves_freely),
                steps: steps.collect(),
            }
        });
        Self {
            edges: edges.collect(),
            dissipation: results.steps.iter().map(|step| step.dissipation).collect(),
            free: Free::of(results),
        }
    }

    fn each_step(&mut self) -> impl Iterator<Item = (bool, &mut EdgeStep)> {
        self.edges.iter_mut().flat_map(|edge| {
            let circle = edge.circle;
            edge.steps.iter_mut().map(move |step| (circle, step))
        })
    }

    /// The mirror image about the x axis of `round` bodies, also of their straight edges, or about the y axis of a line contact.
    pub(super) fn mirrored(mut self, round: bool) -> Self {
        for edge in &mut self.edges {
            if let Some((body, set)) = edge.name.split_once('.') {
                let other = match set {
                    "top" => "bottom",
                    "bottom" => "top",
                    _ => set,
                };
                edge.name = format!("{body}.{other}");
            }
        }
        for (circle, step) in self.each_step() {
            step.resultant[usize::from(round)] *= -1.0;
            for row in &mut step.rows {
                if circle || !round {
                    row.place = -row.place;
                }
                row.values[1] *= -1.0;
                row.values[3] *= -1.0;
            }
        }
        self
    }

    /// Turned by `quarters` of a turn about the centres of the circles.
    pub(super) fn turned(mut self, quarters: u8) -> Self {
        for (_, step) in self.each_step() {
            for _ in 0..quarters {
                let [x, y] = step.resultant;
                step.resultant = [-y, x];
            }
            for row in &mut step.rows {
                row.place += f64::from(quarters) * FRAC_PI_2;
            }
        }
        self
    }

    /// Turned by `angle` `[rad]` with the bodies.
    pub(super) fn spun(mut self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        for (circle, step) in self.each_step() {
            let [x, y] = step.resultant;
            step.resultant = [cos * x - sin * y, sin * x + cos * y];
            for row in step.rows.iter_mut().filter(|_| circle) {
                row.place += angle;
            }
        }
        self
    }

    /// With lengths multiplied by `length` and stresses by `stress`.
    pub(super) fn scaled(mut self, length: f64, stress: f64) -> Self {
        let force = stress * length * length;
        for (circle, step) in self.each_step() {
            step.resultant = step.resultant.map(|part| part * force);
            step.normal *= force;
            for row in &mut step.rows {
                if !circle {
                    row.place *= length;
                }
                let factors = [stress, stress, length, length, stress];
                row.values = std::array::from_fn(|k| factors[k] * row.values[k]);
            }
        }
        for work in &mut self.dissipation {
            *work *= force * length;
        }
        self
    }

    /// The last step alone, without what the path leaves: slip and dissipation.
    pub(super) fn end(mut self) -> Self {
        for edge in &mut self.edges {
            edge.slips = false;
            edge.steps.drain(..edge.steps.len().saturating_sub(1));
        }
        self.dissipation.clear();
        self.free.drain(..self.free.len().saturating_sub(1));
        self
    }

    /// Whether the findings call some gaps free.
    pub(super) fn is_free(&self) -> bool {
        self.free.iter().any(|step| !step.places.is_empty())
    }

    /// The largest difference of the two at the places of `self`; `give` is the length `[mm]` that a stress of 1 MPa gives. With `firm`
    /// what the findings of either call free is left out.
    pub(super) fn difference(&self, other: &Self, give: f64, firm: bool) -> Difference {
        let mut worst = Difference {
            relative: 0.0,
            found: "nothing".into(),
        };
        if self.edges.len() != other.edges.len() {
            let [own, others] = [self, other].map(|answer| answer.edges.len());
            return Difference::other(format!("{own} edges against {others}"));
        }
        let mut work = 0.0_f64;
        for own in &self.edges {
            let Some(others) = other.edges.iter().find(|edge| edge.name == own.name) else {
                return Difference::other(format!("edge '{}' is missing", own.name));
            };
            let scales = Scales::of(own, others, give);
            work += scales.force * scales.values[3];
            for (step, (a, b)) in own.steps.iter().zip(&others.steps).enumerate() {
                if firm && self.is_free_in(other, step) {
                    continue;
                }
                let gaps = !(firm && self.frees(other, &own.name, step));
                let slips = gaps && own.slips && others.slips;
                let compared = [true, true, gaps, slips, true];
                worst.against(own, [a, b], step, &scales, compared);
            }
        }
        for (step, (a, b)) in self.dissipation.iter().zip(&other.dissipation).enumerate() {
            if !(firm && self.is_free_in(other, step)) {
                worst.take(*a, *b, work, || format!("dissipation, step {}", step + 1));
            }
        }
        worst
    }

    /// Whether the findings of either say that everything in `step` may be another.
    fn is_free_in(&self, other: &Self, step: usize) -> bool {
        [self, other].iter().any(|answer| answer.free[step].all)
    }

    /// Whether the findings of either say that the gaps of `edge` at the end of `step` may be others.
    fn frees(&self, other: &Self, edge: &str, step: usize) -> bool {
        let names = |answer: &&Self| answer.free[step].places.iter().any(|name| name == edge);
        [self, other].iter().any(names)
    }
}

/// What numbers of an edge are measured by.
struct Scales {
    values: [f64; 5],
    force: f64,
}

impl Scales {
    fn of(first: &Edge, second: &Edge, give: f64) -> Self {
        let steps = || first.steps.iter().chain(&second.steps);
        let rows = || steps().flat_map(|step| &step.rows);
        let largest =
            |index: usize| rows().fold(0.0, |most: f64, row| most.max(row.values[index].abs()));
        let stress = largest(0).max(largest(1));
        let slips = first.slips && second.slips;
        let slip = if slips { largest(3) } else { 0.0 };
        let motion = largest(2).max(slip);
        let length = motion.max(give * stress);
        // Where nothing presses, stresses and forces are the rounding of motions.
        let over = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        let rest = over(REST * motion, give);
        let lifted = over(rest, stress).max(1.0);
        let stress = stress.max(rest);
        let forces = steps().flat_map(|step| step.resultant.into_iter().chain([step.normal]));
        Self {
            values: [stress, stress, length, length, largest(4).max(stress)],
            force: lifted * forces.fold(0.0, |most: f64, force| most.max(force.abs())),
        }
    }
}

impl Difference {
    /// What cannot be compared.
    fn other(found: String) -> Self {
        let relative = f64::INFINITY;
        Self { relative, found }
    }

    fn take(&mut self, a: f64, b: f64, scale: f64, name: impl FnOnce() -> String) {
        let apart = (a - b).abs();
        let relative = if apart == 0.0 { 0.0 } else { apart / scale };
        if relative > self.relative || relative.is_nan() {
            let values = format!("{a:.9e} against {b:.9e}, {relative:.1e} of {scale:.3e}");
            self.relative = if relative.is_nan() {
                f64::INFINITY
            } else {
                relative
            };
            self.found = format!("{}: {values}", name());
        }
    }

    fn against(
        &mut self,
        edge: &Edge,
        pair: [&EdgeStep; 2],
        step: usize,
        scales: &Scales,
        compared: [bool; 5],
    ) {
        let places = pair[0].rows.iter().map(|row| row.place.abs());
        let size = places.fold(1e-300, f64::max);
        for own in &pair[0].rows {
            let apart = |other: &&Row| {
                if edge.circle {
                    let turns = (own.place - other.place) / TAU;
                    (turns - turns.round()).abs() * TAU
                } else {
                    (own.place - other.place).abs() / size
                }
            };
            let others = pair[1].rows.iter();
            let Some(other) = others.min_by(|a, b| apart(a).total_cmp(&apart(b))) else {
                continue;
            };
            if apart(&other) > SAME_PLACE {
                *self = Self::other(format!("edge '{}': no node at {}", edge.name, own.place));
                return;
            }
            let place = if edge.circle {
                own.place.to_degrees()
            } else {
                own.place
            };
            for index in (0..NAMES.len()).filter(|index| compared[*index]) {
                let [a, b, scale] = [own.values, other.values, scales.values].map(|all| all[index]);
                let (quantity, name, step) = (NAMES[index], &edge.name, step + 1);
                self.take(a, b, scale, || {
                    format!("{quantity} of '{name}' at {place:.4}, step {step}")
                });
            }
        }
        let forces = [
            ("resultant x", pair.map(|step| step.resultant[0])),
            ("resultant y", pair.map(|step| step.resultant[1])),
            ("normal force", pair.map(|step| step.normal)),
        ];
        for (name, [a, b]) in forces {
            self.take(a, b, scales.force, || {
                format!("{name} of '{}', step {}", edge.name, step + 1)
            });
        }
    }
}
