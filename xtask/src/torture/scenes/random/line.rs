//! Random line contacts: a cylinder on a block.

use serde_json::{Value, json};

use super::{Draft, laws};
use crate::torture::scenes::draw::digits;
use crate::torture::scenes::quantity::mm;

impl Draft {
    /// Adds a cylinder on a block; the mesh settings.
    pub(super) fn line_contact(&mut self) -> Value {
        let half = self.draw.magnitude(0.5, 50.0);
        let radius = digits(half * self.draw.magnitude(1.2, 50.0), 4);
        let rise = radius - (radius * radius - half * half).sqrt();
        let depth = digits(rise + half * self.draw.between(0.6, 1.5), 4);
        let thickness = digits(half * self.draw.magnitude(0.05, 2.0), 4);
        let mut softest = f64::INFINITY;
        for name in ["upper", "lower"] {
            let made = if name == "upper" && self.draw.chance(0.3) {
                self.material(name)
            } else {
                self.isotropic(name)
            };
            let mut body = json!({ "material": name });
            if made.thickness.is_none() {
                body["thickness"] = mm(thickness);
            }
            body["shape"] = if name == "upper" {
                json!({ "cylinder": { "radius": mm(radius), "half_length": mm(half), "depth": mm(depth) } })
            } else {
                json!({ "block": { "half_length": mm(half), "depth": mm(depth) } })
            };
            if name == "lower" && self.draw.chance(0.1) {
                body = json!({ "rigid": true, "shape": body["shape"].clone() });
            } else {
                softest = softest.min(made.moduli[0]);
            }
            self.bodies.insert(name.to_owned(), body);
        }
        let share = self.draw.magnitude(1e-5, 3e-3);
        let plies = self.is_laminate("upper");
        let law = laws::law(&mut self.draw, share * softest, share * half, plies);
        let mut contact = json!({
            "name": "line", "first": "upper.contact", "second": "lower.contact", "friction": law,
        });
        if self.draw.chance(0.15) {
            contact["gap"] = json!(self.draw.pick(&["linearised", "faceted"]));
        }
        self.contacts.push(contact);
        let rigid = self.bodies["lower"].get("rigid").is_some();
        let under = if rigid {
            "lower.contact"
        } else {
            "lower.bottom"
        };
        self.fix(under);
        self.press_on("upper", digits(share * softest * half * thickness, 4));
        self.line_mesh(half)
    }

    /// Presses the top of `body` and perhaps pushes it along x.
    pub(super) fn press_on(&mut self, body: &str, force: f64) {
        let top = format!("{body}.top");
        let free = if self.draw.chance(0.6) {
            json!(["x", "y"])
        } else {
            json!(["y"])
        };
        let slides = free.as_array().is_some_and(|axes| axes.len() == 2);
        self.platens.push(json!({ "on": top, "free": free }));
        let steps = self.one_sided(force, "N");
        let press = json!({ "name": "press", "on": top, "force": { "direction": [0.0, -1.0], "steps": steps } });
        self.loads.push(press);
        if slides && self.draw.chance(0.7) {
            let most = digits(force * self.draw.between(0.001, 0.06), 4);
            let steps = self.history(most, "N");
            let push = json!({ "name": "push", "on": top, "force": { "direction": [1.0, 0.0], "steps": steps } });
            self.loads.push(push);
        }
        if self.hot && self.draw.chance(0.5) {
            let steps = self.heat();
            self.load(body, json!({ "temperature": { "steps": steps } }));
        }
        if self.is_laminate(body) {
            self.laminates.clear();
        }
    }

    fn line_mesh(&mut self, half: f64) -> Value {
        let element = self.element();
        let fine = self.draw.between(0.1, 0.4);
        let cells = self.draw.whole(3, 8) as f64;
        json!({
            "element": element,
            "spacing": mm(digits(half * fine / cells, 4)),
            "fine_to": mm(digits(half * fine, 4)),
        })
    }
}
