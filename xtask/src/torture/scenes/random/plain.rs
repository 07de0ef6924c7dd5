//! Random bodies without contact: open holes, rings, beams; assumed bearing loads, pressures and stresses from a table.

use serde_json::{Value, json};

use super::Draft;
use crate::torture::scenes::draw::digits;
use crate::torture::scenes::quantity::mm;

impl Draft {
    /// Adds a body that touches nothing; the mesh settings.
    pub(super) fn without_contact(&mut self) -> Value {
        if self.draw.chance(0.2) {
            return self.beam();
        }
        let radius = self.draw.magnitude(0.5, 60.0);
        let made = self.material("plate");
        let thickness = made.thickness.unwrap_or_else(|| digits(radius * 0.4, 4));
        let ring = self.draw.chance(0.4);
        let outline = if ring {
            json!({ "ring": { "radius": mm(digits(radius * self.draw.magnitude(1.2, 8.0), 4)) } })
        } else {
            let mut beyond = |most: f64| mm(digits(radius * self.draw.magnitude(1.5, most), 4));
            json!({ "strip": { "half_width": beyond(5.0), "left": beyond(9.0), "right": beyond(6.0) } })
        };
        let mut body = json!({
            "material": "plate",
            "shape": { "plate_with_hole": { "hole_radius": mm(radius), "outline": outline } },
        });
        if made.thickness.is_none() {
            body["thickness"] = mm(thickness);
        } else {
            self.laminates.push(("plate".into(), radius));
        }
        self.bodies.insert("plate".into(), body);
        let (held, pulled) = if ring {
            ("plate.outer", "plate.hole")
        } else {
            ("plate.left", "plate.right")
        };
        self.fix(held);
        let stress = digits(made.moduli[0] * self.draw.magnitude(1e-5, 3e-3), 4);
        let force = digits(stress * radius * thickness, 4);
        let direction = self.direction();
        let load = match self
            .draw
            .weighted(&[(0.3, 0), (0.3, 1), (0.2, 2), (0.2, 3)])
        {
            0 => {
                json!({ "on": pulled, "force": { "direction": direction, "steps": self.history(force, "N") } })
            }
            1 => {
                let law = self.draw.pick(&["cosine", "uniform"]);
                let steps = self.one_sided(force, "N");
                json!({ "on": "plate.hole", "bearing": { "direction": direction, "law": law, "steps": steps } })
            }
            2 => json!({ "on": pulled, "pressure": { "steps": self.history(stress, "MPa") } }),
            _ => {
                let steps: Vec<f64> = (0..self.steps)
                    .map(|_| self.draw.between(-1.0, 1.0))
                    .collect();
                json!({ "on": "plate.hole", "polar_traction": {
                    "file": "persson-ring5R-65deg.csv", "stress": "MPa", "steps": steps,
                } })
            }
        };
        self.loads.push(load);
        self.edges.push(json!({ "on": "plate.hole" }));
        self.round_mesh()
    }

    fn beam(&mut self) -> Value {
        let width = self.draw.magnitude(2.0, 100.0);
        let height = digits(width * self.draw.between(0.1, 1.0), 4);
        let made = self.material("beam");
        let thickness = made.thickness.unwrap_or_else(|| digits(height * 0.3, 4));
        let mut body = json!({
            "material": "beam", "shape": { "rectangle": { "width": mm(width), "height": mm(height) } },
        });
        if made.thickness.is_none() {
            body["thickness"] = mm(thickness);
        }
        self.bodies.insert("beam".into(), body);
        self.fix("beam.left");
        let force = digits(made.moduli[0] * 1e-4 * height * thickness, 4);
        let (steps, direction) = (self.history(force, "N"), self.direction());
        self.load(
            "beam.right",
            json!({ "force": { "direction": direction, "steps": steps } }),
        );
        self.edges.push(json!({ "on": "beam.top" }));
        let spacing = digits(height / self.draw.whole(2, 5) as f64, 4);
        let element = self.element();
        json!({ "element": element, "spacing": mm(spacing) })
    }
}
