//! Pins in plates: tractions on the hole against the pull, both bodies, all steps.

use proptest::prelude::*;
use stickslip::results::{EdgeGeometry, EdgeResults, Results, StepResults};
use stickslip_contact::{Status, StepRecord};
use stickslip_tests::balance::{internal_forces, load_forces, resultant};
use stickslip_tests::{Draft, Solution};

use super::{NODAL, dot, residual_and_reaction, virtual_displacement};

/// Radius of the hole and thickness of all joints `[mm]`.
const RADIUS: f64 = 5.0;
const THICKNESS: f64 = 2.0;

/// Resultants: sums of some tens of tractions, each as accurate as the solvers promise (1e-10 of the largest force).
const SUMS: f64 = 1e-9;

/// A friction law and the most shear that it carries at a pressure.
#[derive(Clone, Debug)]
struct Law {
    text: String,
    mu: f64,
    /// Exponent of the pressure, 1 for proportional laws.
    exponent: f64,
}

/// Reference pressure of the pressure power law `[MPa]`.
const REFERENCE: f64 = 50.0;

impl Law {
    fn most_shear(&self, pressure: f64) -> f64 {
        self.mu * REFERENCE * (pressure.max(0.0) / REFERENCE).powf(self.exponent)
    }
}

fn laws() -> impl Strategy<Value = Law> {
    let mu = prop_oneof![1 => Just(0.0), 6 => 0.02..0.8_f64];
    (mu, 0..7_u8, 0.5..1.0_f64).prop_map(|(mu, kind, share)| {
        let other = mu * share;
        let text = match kind {
            0 | 1 => format!("coulomb = {{ mu = {mu} }}"),
            2 => format!("static_dynamic = {{ static = {mu}, dynamic = {other} }}"),
            3 => format!(
                "static_dynamic = {{ static = {mu}, dynamic = {other}, transition = \"lagged\" }}"
            ),
            4 => format!(
                "slip_power = {{ static = {mu}, dynamic = {other}, slip_scale = \"2 um\", exponent = 1.0 }}"
            ),
            5 => format!(
                "pressure_power = {{ mu = {mu}, reference_pressure = \"{REFERENCE} MPa\", exponent = {share} }}"
            ),
            _ => format!(
                "fibre_coverage = {{ plies = [{{ angle = \"0 deg\", fraction = 0.5 }}, {{ angle = \"90 deg\", \
                 fraction = 0.5 }}], fibre_fraction = 0.6, kernel.swept = {{ kappa = 0.5 }}, fibre.coulomb = {{ mu = {mu} }}, \
                 matrix.coulomb = {{ mu = {other} }} }}"
            ),
        };
        Law {
            text,
            mu,
            exponent: if kind == 5 { share } else { 1.0 },
        }
    })
}

/// A joint, its pulls `[N]` and its law.
#[derive(Clone, Debug)]
struct Joint {
    draft: Draft,
    pulls: Vec<f64>,
    law: Law,
}

fn joints() -> impl Strategy<Value = Joint> {
    let element = prop::sample::select(vec!["T3", "T6", "Q4", "Q8", "Q9"]);
    let spacing = prop::sample::select(vec![9, 10, 12, 15]);
    let outline = (8.0..40.0_f64, 8.0..90.0_f64, 7.0..60.0_f64, any::<bool>());
    let clearance = prop_oneof![1 => Just(0.0), 4 => 1e-4..0.05_f64, 1 => -0.005..-1e-4_f64];
    let pin = prop::sample::select(vec!["70 GPa", "210 GPa", "rigid"]);
    let material = prop::sample::select(vec![None, Some(0), Some(30), Some(-65)]);
    let setting = (any::<bool>(), any::<bool>(), 1..=3_usize);
    let pulls = prop::collection::vec(
        prop_oneof![1 => Just(0.0), 5 => 100.0..3000.0_f64, 1 => -1500.0..-100.0_f64],
        1..5,
    );
    let shape = (element, spacing, outline, clearance);
    (shape, pin, material, setting, laws(), pulls).prop_map(
        |((element, spacing, outline, clearance), pin, material, setting, law, pulls)| {
            let (half_width, left, right, ring) = outline;
            let (strain, whole, substeps) = setting;
            let mut draft = Draft::pin()
                .set("mesh.element", element)
                .set("mesh.spacing", format!("{spacing} deg"))
                .set("bodies.pin.shape.disk.radius", format!("{} mm", RADIUS - clearance))
                .set("contacts.0.interference", clearance < 0.0)
                .set("analysis.model", if whole { "whole" } else { "auto" })
                .set("analysis.substeps", substeps)
                .set("output.fields", "all")
                .friction(&law.text)
                .forces(0, &pulls);
            draft = if ring {
                let ring = format!("{{ ring = {{ radius = \"{half_width} mm\" }} }}");
                draft
                    .set("bodies.plate.shape.plate_with_hole.outline", ring)
                    .set("loads.0.on", "plate.outer")
            } else {
                let strip = format!(
                    "{{ half_width = \"{half_width} mm\", left = \"{left} mm\", right = \"{right} mm\" }}"
                );
                draft.set("bodies.plate.shape.plate_with_hole.outline.strip", strip)
            };
            draft = match pin {
                "rigid" => draft.set("bodies.pin", format!("{{ rigid = true, shape.disk = {{ radius = \"{} mm\" }} }}", RADIUS - clearance)),
                young => draft.set("materials.pin.isotropic.young", young),
            };
            if let Some(angle) = material {
                let ply = format!(
                    "{{ e1 = \"140 GPa\", e2 = \"10 GPa\", g12 = \"5 GPa\", nu12 = 0.3, angle = \"{angle} deg\" }}"
                );
                draft = draft.set("materials.plate.orthotropic", ply);
            } else if strain {
                draft = draft.set("analysis.plane", "strain");
            }
            Joint { draft, pulls, law }
        },
    )
}

/// Contact area `[mm²]` of each node of an edge divided into equal angles: the edge's consistent weights on the arc.
fn areas(edge: &EdgeGeometry) -> Vec<f64> {
    let (angle, count) = (&edge.parameter, edge.parameter.len());
    let quadratic = edge.corner.iter().any(|corner| !corner);
    let node = (angle[1] - angle[0]) * RADIUS * THICKNESS;
    (0..count)
        .map(|k| {
            let end = edge.half && (k == 0 || k + 1 == count);
            let share = match (quadratic, edge.corner[k]) {
                (false, _) => 1.0,
                (true, true) => 2.0 / 3.0,
                (true, false) => 4.0 / 3.0,
            };
            node * if end { share / 2.0 } else { share }
        })
        .collect()
}

/// Forces `[N]` of the plate's edge tractions on the plate, interleaved.
fn edge_forces(geometry: &EdgeGeometry, edge: &EdgeResults) -> Vec<f64> {
    areas(geometry)
        .iter()
        .zip(&geometry.parameter)
        .zip(&edge.rows)
        .flat_map(|((area, theta), row)| {
            let (s, c) = theta.sin_cos();
            [
                area * (row.pressure * c - row.shear * s),
                area * (row.pressure * s + row.shear * c),
            ]
        })
        .collect()
}

struct Checked<'a> {
    joint: &'a Joint,
    results: Results,
    solution: Solution,
    /// Largest force of the history `[N]`: pulls, and pressures times areas where an interference fit makes its own.
    scale: f64,
    /// Largest tangential displacement of the history `[mm]`.
    slip: f64,
}

impl<'a> Checked<'a> {
    fn new(joint: &'a Joint, results: Results) -> Self {
        let pulls = joint.pulls.iter().map(|pull| pull.abs());
        let rows = results.steps.iter().flat_map(|step| &step.edges[0].rows);
        let presses = results.steps.iter().map(|step| step.edges[0].normal_force);
        Self {
            scale: pulls.chain(presses).fold(0.0, f64::max),
            slip: rows.map(|row| row.slip.abs()).fold(0.0, f64::max),
            solution: joint.draft.solve(),
            results,
            joint,
        }
    }

    /// Whether the sum over the modelled part is half of that over the whole.
    fn double(&self) -> f64 {
        if self.solution.model.half { 2.0 } else { 1.0 }
    }

    fn pairs(&self) -> impl Iterator<Item = (f64, &StepResults, &StepRecord)> {
        let steps = self.results.steps.iter().zip(self.solution.records());
        self.joint
            .pulls
            .iter()
            .zip(steps)
            .map(|(pull, (step, record))| (*pull, step, record))
    }

    fn supports(&self, body: &str) -> Vec<(&'static str, [bool; 2])> {
        let mut held = Vec::new();
        if self.solution.model.half {
            held.push(("symmetry", [false, true]));
        }
        if body == "pin" {
            held.push(("centre", [true, true]));
        }
        held
    }

    fn close(&self, what: &str, found: f64, expected: f64, tolerance: f64) {
        let difference = (found - expected).abs();
        assert!(
            difference <= tolerance * self.scale,
            "{what}: {found} instead of {expected} (scale {}) in {:?}",
            self.scale,
            self.joint
        );
    }

    /// Tractions add up to the pull and turn nothing; the table says the same.
    fn resultants(&self, pull: f64, step: &StepResults) {
        let (geometry, edge) = (&self.results.edges[0], &step.edges[0]);
        let forces = edge_forces(geometry, edge);
        let places: Vec<[f64; 2]> = geometry
            .parameter
            .iter()
            .map(|theta| [RADIUS * theta.cos(), RADIUS * theta.sin()])
            .collect();
        let ([x, y], moment) = resultant(&forces, &places);
        self.close("resultant along x", self.double() * x, pull, SUMS);
        self.close("reported resultant", edge.resultant[0], pull, SUMS);
        self.close("reported across", edge.resultant[1], 0.0, SUMS);
        if !geometry.half {
            self.close("resultant along y", y, 0.0, SUMS);
            self.close("moment", moment / RADIUS, 0.0, SUMS);
        }
        let pressed: f64 = edge
            .rows
            .iter()
            .zip(areas(geometry))
            .map(|(row, area)| row.pressure * area)
            .sum();
        self.close(
            "normal force",
            edge.normal_force,
            self.double() * pressed,
            SUMS,
        );
        if let Some(bearing) = edge.bearing_stress(geometry) {
            let area = 2.0 * RADIUS * THICKNESS;
            self.close("bearing stress", bearing * area, pull.abs(), SUMS);
        }
        assert!(
            step.residuals.largest() < 1e-9 && step.balance_residual < 1e-9,
            "{:?} {} {:?}",
            step.residuals,
            step.balance_residual,
            self.joint
        );
    }

    /// What the pin does to the plate, the plate does to the pin, and the pin's support carries it.
    fn action_and_reaction(&self, pull: f64, record: &StepRecord) {
        let (plate, pin) = (self.solution.body("plate"), self.solution.body("pin"));
        let on_plate = self.solution.contact_forces(plate, record);
        let on_pin = self.solution.contact_forces(pin, record);
        for (action, reaction) in on_plate.iter().zip(&on_pin) {
            self.close("reaction at a node", *reaction, -action, 1e-14);
        }
        for (name, body) in [("plate", plate), ("pin", pin)] {
            if self.solution.elastic(body).is_none() {
                continue;
            }
            let held = self.supports(name);
            let (left, [x, _]) = residual_and_reaction(&self.solution, body, record, &held);
            self.close("nodal residual", left, 0.0, NODAL);
            let expected = if name == "pin" { pull } else { 0.0 };
            self.close("support", self.double() * x, expected, SUMS);
        }
    }

    /// Stresses do the work on any displacement that loads and reported tractions do.
    fn virtual_work(&self, step: &StepResults, record: &StepRecord) {
        let (geometry, edge) = (&self.results.edges[0], &step.edges[0]);
        let forces = edge_forces(geometry, edge);
        let (mut inside, mut outside) = (0.0, 0.0);
        for (name, sign) in [("plate", 1.0), ("pin", -1.0)] {
            let body = self.solution.body(name);
            let Some(elastic) = self.solution.elastic(body) else {
                continue;
            };
            let v = virtual_displacement(&self.solution, body, &self.supports(name));
            let u = self.solution.displacement(body, record);
            inside += dot(&v, &internal_forces(elastic, &u));
            outside += dot(&v, &load_forces(elastic, &record.state.multipliers));
            // The contact points of both bodies are in the order of the edge.
            for (force, &node) in forces
                .chunks_exact(2)
                .zip(&self.solution.model.bodies[body].interface)
            {
                outside += sign * dot(force, &v[2 * node..2 * node + 2]);
            }
        }
        self.close("virtual work", inside, outside, SUMS);
    }

    /// Pressure only where closed, shear within the law's bound, friction loses work.
    fn contact_conditions(&self, step: &StepResults) {
        let stress = self.scale / (RADIUS * THICKNESS);
        for row in &step.edges[0].rows {
            let slack = 1e-8 * stress;
            assert!(row.pressure >= -slack, "{row:?} {:?}", self.joint);
            assert!(row.gap >= -1e-9 * RADIUS, "{row:?} {:?}", self.joint);
            let bound = self.joint.law.most_shear(row.pressure);
            assert!(
                row.shear.abs() <= bound * (1.0 + 1e-8) + slack,
                "{row:?} {bound} {:?}",
                self.joint
            );
            if row.status == Status::Open {
                assert!(
                    row.pressure.abs() <= slack && row.shear.abs() <= slack,
                    "{row:?}"
                );
            }
        }
        assert!(
            step.dissipation >= -1e-9 * self.scale * self.slip,
            "dissipation {} {:?}",
            step.dissipation,
            self.joint
        );
    }
}

proptest! {
    // Of 13 000 such joints one in 300 ended in a typed refusal of the solvers, nearly all neat fits in skew plies or without pull.
    #![proptest_config(ProptestConfig { cases: 80, max_global_rejects: 4, ..ProptestConfig::default() })]

    #[test]
    fn every_joint_is_in_equilibrium(joint in joints()) {
        let results = joint.draft.run_if_solvable();
        prop_assume!(results.is_some(), "the solvers say that they did not solve it");
        if let Some(results) = results {
            let checked = Checked::new(&joint, results);
            for (pull, step, record) in checked.pairs() {
                checked.resultants(pull, step);
                checked.action_and_reaction(pull, record);
                checked.virtual_work(step, record);
                checked.contact_conditions(step);
            }
        }
    }
}
