//! Random general outlines: pins in several holes anywhere, and punches with rounded corners on blocks.

use serde_json::{Value, json};

use super::{Draft, laws};
use crate::torture::scenes::draw::digits;
use crate::torture::scenes::quantity::{deg, mm};

impl Draft {
    /// Adds a plate with one to three pins in holes anywhere, perhaps an empty hole, and a round end; the mesh settings.
    pub(super) fn holes(&mut self) -> Value {
        let radius = self.draw.magnitude(0.5, 60.0);
        let thickness = digits(radius * self.draw.magnitude(0.1, 2.0), 4);
        let made = [self.isotropic("sheet"), self.isotropic("pin")];
        let softest = made.iter().map(|made| made.moduli[0]);
        let softest = softest.fold(f64::INFINITY, f64::min);
        let share = self.draw.magnitude(1e-6, 3e-3);
        let (stress, slip) = (share * softest, share * radius);
        let pins = self.draw.whole(1, 3);
        let pitch = radius * self.draw.between(3.0, 6.0);
        let half = radius * self.draw.between(2.4, 5.0);
        let end = pitch * (pins - 1) as f64;
        let mut holes = serde_json::Map::new();
        let mut at = |name: String, x: f64, y: f64, radius: f64| {
            let centre = [x, y].map(|place| mm(digits(place, 6)));
            holes.insert(name, json!({ "centre": centre, "radius": mm(radius) }));
        };
        for k in 0..pins {
            let aside = radius * self.draw.between(-1.0, 1.0);
            at(format!("hole-{k}"), pitch * k as f64, aside, radius);
        }
        if self.draw.chance(0.3) {
            let small = digits(radius * self.draw.between(0.3, 0.8), 4);
            at("empty".into(), -3.0 * radius, 0.0, small);
            self.edges.push(json!({ "on": "sheet.empty" }));
        }
        let [left, right] = [-5.0 * radius - half, end + radius * 2.0].map(|x| digits(x, 6));
        let round = self.draw.chance(0.4).then_some(right + half);
        let mut outline = strip([left, right, digits(half, 6)], round.map(|x| digits(x, 6)));
        outline["holes"] = Value::Object(holes);
        self.bodies.insert(
            "sheet".into(),
            json!({ "material": "sheet", "thickness": mm(thickness), "shape": { "outline": outline } }),
        );
        for k in 0..pins {
            self.pin_in(k, [radius, thickness], [stress, slip]);
        }
        let force = digits(stress * radius * thickness * pins as f64, 4);
        let held = self.draw.chance(0.5) && pins > 1;
        let direction = self.direction();
        if held {
            (0..pins).for_each(|k| self.fix(&format!("pin-{k}.centre")));
            let steps = self.history(force, "N");
            self.load(
                "sheet.left",
                json!({ "force": { "direction": direction, "steps": steps } }),
            );
        } else {
            self.fix("sheet.left");
            for k in 0..pins {
                let steps = self.history(force, "N");
                let on = format!("pin-{k}.section");
                self.load(
                    &on,
                    json!({ "force": { "direction": direction, "steps": steps } }),
                );
            }
        }
        let spacing = self.draw.pick(&["6", "9", "10", "12"]);
        let element = self.draw.pick(&["T3", "T6", "Q8"]);
        json!({ "element": element, "spacing": format!("{spacing} deg") })
    }

    fn pin_in(&mut self, k: usize, [radius, thickness]: [f64; 2], [stress, slip]: [f64; 2]) {
        let name = format!("pin-{k}");
        let fitted = digits(radius * (1.0 - self.draw.magnitude(1e-6, 3e-2)), 9);
        self.bodies.insert(
            name.clone(),
            json!({
                "material": "pin", "thickness": mm(thickness), "shape": { "disk": { "radius": mm(fitted) } },
            }),
        );
        let law = laws::law(&mut self.draw, stress, slip, false);
        self.contacts.push(json!({
            "name": name, "first": format!("sheet.hole-{k}"), "second": format!("{name}.rim"), "friction": law,
        }));
    }

    /// Adds a punch with rounded corners or a cylinder on a block, as open edges; the mesh settings.
    pub(super) fn punch(&mut self) -> Value {
        let reach = self.draw.magnitude(0.2, 20.0);
        let flat = if self.draw.chance(0.5) {
            digits(reach * self.draw.between(0.2, 0.7), 4)
        } else {
            0.0
        };
        let radius = digits(reach * self.draw.magnitude(4.0, 60.0), 4);
        let thickness = digits(reach * self.draw.magnitude(0.1, 3.0), 4);
        let refine = self.draw.between(4.0, 20.0);
        let softest = ["punch", "block"].map(|name| self.isotropic(name).moduli[0]);
        let softest = softest[0].min(softest[1]);
        let rigid = self.draw.chance(0.1);
        let outlines = [
            ("punch", punch_outline([reach, flat, radius], refine)),
            ("block", block_outline(reach, refine)),
        ];
        for (name, outline) in outlines {
            let substance = if rigid && name == "block" {
                json!({ "rigid": true })
            } else {
                json!({ "material": name, "thickness": mm(thickness) })
            };
            let mut body = substance;
            body["shape"] = json!({ "outline": outline });
            if name == "punch" && self.draw.chance(0.2) {
                body["angle"] = deg(self.draw.between(-0.02, 0.02));
            }
            self.bodies.insert(name.into(), body);
        }
        let share = self.draw.magnitude(1e-6, 1e-3);
        let law = laws::law(&mut self.draw, share * softest, share * reach, false);
        self.contacts.push(json!({
            "name": "face", "first": "punch.face", "second": "block.top", "friction": law,
        }));
        self.fix(if rigid { "block.top" } else { "block.bottom" });
        self.press_on("punch", digits(share * softest * reach * thickness, 4));
        json!({ "element": self.draw.pick(&["T3", "T6", "Q8"]), "spacing": mm(digits(2.0 * reach, 4)) })
    }
}

fn place([x, y]: [f64; 2]) -> Value {
    json!([mm(x), mm(y)])
}

/// A strip from `left` to `right`, of half the width `half`; its right end an arc through `round`, if that is given.
fn strip([left, right, half]: [f64; 3], round: Option<f64>) -> Value {
    let mut end = json!({ "name": "right", "to": place([right, half]) });
    if let Some(x) = round {
        end["through"] = place([x, 0.0]);
    }
    json!({ "start": place([left, -half]), "edges": [
        { "name": "bottom", "to": place([right, -half]) },
        end,
        { "name": "top", "to": place([left, half]) },
        { "name": "left" },
    ] })
}

fn block_outline(reach: f64, refine: f64) -> Value {
    let wide = 8.0 * reach;
    json!({ "start": place([-wide, -wide]), "edges": [
        { "name": "bottom", "to": place([wide, -wide]) },
        { "name": "right", "to": place([wide, 0.0]) },
        { "name": "top", "to": place([1.5 * reach, 0.0]) },
        { "name": "top", "to": place([-1.5 * reach, 0.0]), "refine": refine },
        { "name": "top", "to": place([-wide, 0.0]) },
        { "name": "left" },
    ] })
}

/// A punch whose face is flat up to `flat` and an arc of `radius` up to `reach` on both sides.
fn punch_outline([reach, flat, radius]: [f64; 3], refine: f64) -> Value {
    let rise = |x: f64| radius - (radius * radius - (x - flat).powi(2)).sqrt();
    let middle = 0.5 * (flat + reach);
    let [end, between] = [rise(reach), rise(middle)];
    let wide = 6.0 * reach;
    let side = end + 2.0 * (reach - flat) / radius * (wide - reach);
    let arc = |to: [f64; 2], through: [f64; 2]| json!({ "name": "face", "to": place(to), "through": place(through), "refine": refine });
    let mut edges = vec![json!({ "name": "face", "to": place([-reach, end]) })];
    if flat > 0.0 {
        edges.push(arc([-flat, 0.0], [-middle, between]));
        edges.push(json!({ "name": "face", "to": place([flat, 0.0]), "refine": refine }));
        edges.push(arc([reach, end], [middle, between]));
    } else {
        edges.push(arc([reach, end], [0.0, 0.0]));
    }
    let plain = |name: &str, at| json!({ "name": name, "to": place(at) });
    edges.push(plain("face", [wide, side]));
    edges.push(plain("right", [wide, side + wide]));
    edges.push(plain("top", [-wide, side + wide]));
    edges.push(json!({ "name": "left" }));
    json!({ "start": place([-wide, side]), "edges": edges })
}
