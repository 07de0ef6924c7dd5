//! Random scenes over what the format can say, small enough to be solved in a fraction of a second.
//!
//! Sizes, moduli, loads and clearances are spread over decades, and what people rarely combine is combined: laws, elements, meshes of
//! their own, projections, histories that reverse, heat, interference. A scene may be refused, and may have no answer.

mod joint;
mod laws;
mod line;
mod loads;
mod materials;
mod outline;
mod plain;

use serde_json::{Map, Value, json};

use super::draw::Draw;
use super::quantity::{deg, mm};

/// A scene in the making.
struct Draft {
    draw: Draw,
    /// Whether in plane strain, where there are no laminates.
    strain: bool,
    /// Whether some bodies are heated.
    hot: bool,
    /// Load steps.
    steps: usize,
    materials: Map<String, Value>,
    bodies: Map<String, Value>,
    contacts: Vec<Value>,
    supports: Vec<Value>,
    platens: Vec<Value>,
    loads: Vec<Value>,
    edges: Vec<Value>,
    /// Bodies of laminates, with the radius of their hole.
    laminates: Vec<(String, f64)>,
}

/// What is modelled.
#[derive(Clone, Copy, Debug)]
enum Family {
    Pin,
    Bushing,
    Two,
    Line,
    Plain,
    Holes,
    Punch,
}

/// One of so many scenes is of general outlines.
const OUTLINES: u64 = 8;

/// The scene of `seed`.
pub(super) fn scene(seed: u64) -> Value {
    let mut draw = Draw::new(seed, 1);
    let family = family(&mut draw, seed);
    let mut draft = Draft {
        strain: draw.chance(0.2),
        hot: draw.chance(0.25),
        steps: draw.weighted(&[(0.3, 1), (0.25, 2), (0.25, 3), (0.2, 4)]),
        draw,
        materials: Map::new(),
        bodies: Map::new(),
        contacts: Vec::new(),
        supports: Vec::new(),
        platens: Vec::new(),
        loads: Vec::new(),
        edges: Vec::new(),
        laminates: Vec::new(),
    };
    let mesh = match family {
        Family::Pin => {
            draft.joint("", false);
            draft.round_mesh()
        }
        Family::Bushing => {
            draft.joint("", true);
            draft.round_mesh()
        }
        Family::Two => {
            draft.joint("a-", false);
            let bushed = draft.draw.chance(0.3);
            draft.joint("b-", bushed);
            draft.round_mesh()
        }
        Family::Line => draft.line_contact(),
        Family::Plain => draft.without_contact(),
        Family::Holes => draft.holes(),
        Family::Punch => draft.punch(),
    };
    draft.finish(seed, &mesh)
}

/// What the scene of `seed` models.
fn family(draw: &mut Draw, seed: u64) -> Family {
    // By the seed, so that the other scenes are those of earlier records.
    if seed % OUTLINES == 5 {
        return draw.weighted(&[(0.6, Family::Holes), (0.4, Family::Punch)]);
    }
    draw.weighted(&[
        (0.50, Family::Pin),
        (0.22, Family::Bushing),
        (0.05, Family::Two),
        (0.13, Family::Line),
        (0.10, Family::Plain),
    ])
}

impl Draft {
    /// Holds an edge or centre along both axes.
    fn fix(&mut self, on: &str) {
        self.supports.push(json!({ "on": on, "fix": ["x", "y"] }));
    }

    /// Adds a load.
    fn load(&mut self, on: &str, mut load: Value) {
        load["on"] = on.into();
        self.loads.push(load);
    }

    fn element(&mut self) -> &'static str {
        self.draw.weighted(&[
            (0.15, "T3"),
            (0.15, "T6"),
            (0.15, "Q4"),
            (0.34, "Q8"),
            (0.15, "Q9"),
            (0.02, "P2"),
            (0.02, "P3"),
            (0.02, "P5"),
        ])
    }

    /// Mesh settings of round bodies.
    fn round_mesh(&mut self) -> Value {
        let element = self.element();
        let mut mesh = json!({ "element": element });
        let spacings = [5.0, 6.0, 7.5, 9.0, 10.0, 12.0, 15.0];
        let spacing = spacings[self.draw.whole(0, spacings.len() - 1)];
        if self.draw.chance(0.06) {
            // Unequal, from 0 to 180°.
            let count = self.draw.whole(8, 24);
            let mut angles: Vec<Value> = vec![deg(0.0)];
            for k in 1..count {
                let place = k as f64 + self.draw.between(-0.25, 0.25);
                angles.push(deg(super::draw::digits(180.0 * place / count as f64, 4)));
            }
            angles.push(deg(180.0));
            mesh["angles"] = Value::Array(angles);
        } else {
            mesh["spacing"] = deg(spacing);
            if self.draw.chance(0.25) {
                mesh["fine_to"] = deg(self.draw.between(40.0, 170.0).round());
                if self.draw.chance(0.4) {
                    mesh["coarse_spacing"] = deg(spacing * self.draw.whole(1, 3) as f64);
                }
            }
        }
        if self.draw.chance(0.1) {
            mesh["layers"] = json!(self.draw.whole(1, 6));
        }
        mesh
    }

    fn analysis(&mut self) -> Value {
        let draw = &mut self.draw;
        let mut analysis = json!({
            "plane": if self.strain { "strain" } else { "stress" },
            "solver": draw.weighted(&[(0.6, "auto"), (0.1, "newton"), (0.2, "status"), (0.1, "pivoting")]),
            "substeps": draw.weighted(&[(0.6, 1), (0.2, 2), (0.2, 4)]),
        });
        if draw.chance(0.15) {
            analysis["model"] = json!("whole");
        }
        if draw.chance(0.1) {
            analysis["ramp"] = json!(if self.strain { "contact" } else { "quadratic" });
        }
        analysis
    }

    /// Failure of the plies of laminates.
    fn failure(&mut self) -> Option<Value> {
        let (_, radius) = self.laminates.first().cloned()?;
        if !self.draw.chance(0.3) {
            return None;
        }
        let all = [
            "max_stress",
            "max_strain",
            "tsai_hill",
            "tsai_hill_3d",
            "hoffman",
            "tsai_wu",
            "hashin",
            "yamada_sun",
        ];
        let mut failure =
            json!({ "criteria": [all[self.draw.whole(0, all.len() - 1)], "max_stress"] });
        if failure["criteria"][0] == "max_stress" {
            failure["criteria"] = json!(["max_stress"]);
        }
        let own: Vec<&str> = self
            .laminates
            .iter()
            .map(|(name, _)| name.as_str())
            .collect();
        failure["bodies"] = json!(own);
        if self.draw.chance(0.3) {
            failure["characteristic"] = json!({
                "tension": mm(super::draw::digits(radius * self.draw.between(0.02, 0.1), 3)),
                "compression": mm(super::draw::digits(radius * self.draw.between(0.05, 0.2), 3)),
            });
        }
        if self.draw.chance(0.2) {
            failure["envelopes"] = json!({ "planes": ["normal"], "directions": 12 });
        }
        Some(failure)
    }

    fn finish(mut self, seed: u64, mesh: &Value) -> Value {
        let fields = if self.draw.chance(0.05) {
            "last"
        } else {
            "none"
        };
        let mut scene = json!({
            "version": 1,
            "title": format!("seed {seed}"),
            "analysis": self.analysis(),
            "mesh": mesh,
            "output": { "fields": fields, "figures": false },
        });
        if self.materials.keys().any(|name| self.is_laminate(name)) {
            scene["plies"] = materials::plies();
        }
        if let Some(failure) = self.failure() {
            scene["failure"] = failure;
        }
        scene["materials"] = Value::Object(self.materials);
        scene["bodies"] = Value::Object(self.bodies);
        for (name, list) in [
            ("contacts", self.contacts),
            ("supports", self.supports),
            ("platens", self.platens),
            ("loads", self.loads),
            ("edges", self.edges),
        ] {
            if !list.is_empty() {
                scene[name] = Value::Array(list);
            }
        }
        scene
    }
}
