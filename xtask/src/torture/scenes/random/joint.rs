//! Random pinned joints: a plate or ring, a bushing or none, and a pin.

use serde_json::json;

use super::materials::Made;
use super::{Draft, laws};
use crate::torture::scenes::draw::digits;
use crate::torture::scenes::quantity::{deg, mm};

/// A body in the making.
struct Part {
    name: String,
    made: Option<Made>,
    thickness: f64,
}

/// What stays the same for a joint.
struct Sizes {
    /// Force that changes the joint noticeably `[N]`, and the pressure `[MPa]` and slip `[mm]` that go with it.
    force: f64,
    stress: f64,
    slip: f64,
}

impl Draft {
    /// Adds a joint whose bodies' names begin with `prefix`.
    pub(super) fn joint(&mut self, prefix: &str, bushed: bool) {
        let radius = self.draw.magnitude(0.5, 60.0);
        let thickness = digits(radius * self.draw.magnitude(0.05, 3.0), 4);
        let plate = self.part(prefix, "plate", thickness);
        let ring = self.outline(&plate, radius);
        let mut inner = radius;
        let bush = bushed.then(|| self.part(prefix, "bush", thickness));
        let rigid = !bushed && self.draw.chance(0.12);
        let pin = if rigid {
            Part {
                name: format!("{prefix}pin"),
                made: None,
                thickness,
            }
        } else {
            self.part(prefix, "pin", thickness)
        };
        let parts = [Some(&plate), bush.as_ref(), Some(&pin)]
            .into_iter()
            .flatten();
        let moduli = parts.filter_map(|part| Some(part.made.as_ref()?.moduli[0]));
        let softest = moduli.fold(f64::INFINITY, f64::min);
        let share = self.draw.magnitude(1e-6, 4e-3);
        let sizes = Sizes {
            force: digits(share * softest * radius * plate.thickness, 4),
            stress: share * softest,
            slip: share * radius,
        };
        if let Some(bush) = &bush {
            let outer = self.fitted(radius);
            inner = digits(radius * self.draw.between(0.55, 0.9), 4);
            self.bodies[&bush.name]["shape"] = json!({ "plate_with_hole": {
                "hole_radius": mm(inner), "outline": { "ring": { "radius": mm(outer) } },
            } });
            self.contact([&plate, bush], "outer", [radius, outer], &sizes);
        }
        let fitted = self.fitted(inner);
        if pin.made.is_none() {
            self.bodies
                .insert(pin.name.clone(), json!({ "rigid": true }));
        }
        self.bodies[&pin.name]["shape"] = json!({ "disk": { "radius": mm(fitted) } });
        let holder = bush.as_ref().unwrap_or(&plate);
        self.contact([holder, &pin], "rim", [inner, fitted], &sizes);
        self.hold_and_load([&plate, &pin], ring, &sizes);
        if self.hot {
            for part in [Some(&plate), bush.as_ref(), Some(&pin)]
                .into_iter()
                .flatten()
            {
                self.maybe_heat(part);
            }
        }
    }

    /// A body with a material of its own, without shape as yet.
    fn part(&mut self, prefix: &str, what: &str, thickness: f64) -> Part {
        let name = format!("{prefix}{what}");
        let made = if what == "plate" {
            self.material(&name)
        } else {
            self.isotropic(&name)
        };
        let mut thickness = made.thickness.unwrap_or(thickness);
        let mut body = json!({ "material": name });
        if made.thickness.is_none() {
            if what == "pin" && self.draw.chance(0.15) {
                thickness = digits(thickness * self.draw.between(0.5, 3.0), 4);
            }
            body["thickness"] = mm(thickness);
        }
        if what != "plate" && self.draw.chance(0.15) {
            let element = self.element();
            body["mesh"] = json!({ "element": element });
            if self.draw.chance(0.8) {
                body["mesh"]["spacing"] = deg(self.draw.between(5.0, 15.0));
            }
        }
        self.bodies.insert(name.clone(), body);
        Part {
            name,
            made: Some(made),
            thickness,
        }
    }

    /// Gives the plate its outline; whether that is a ring.
    fn outline(&mut self, plate: &Part, radius: f64) -> bool {
        let ring = self.draw.chance(0.3);
        let mut beyond =
            |least: f64, most: f64| mm(digits(radius * self.draw.magnitude(least, most), 4));
        let outline = if ring {
            json!({ "ring": { "radius": beyond(1.15, 8.0) } })
        } else {
            json!({ "strip": {
                "half_width": beyond(1.4, 5.0), "left": beyond(1.5, 12.0), "right": beyond(1.4, 6.0),
            } })
        };
        self.bodies[&plate.name]["shape"] =
            json!({ "plate_with_hole": { "hole_radius": mm(radius), "outline": outline } });
        if self.is_laminate(&plate.name) {
            self.laminates.push((plate.name.clone(), radius));
        }
        if self.draw.chance(0.15) {
            let set = if ring {
                "outer"
            } else {
                self.draw.pick(&["top", "bottom"])
            };
            self.edges
                .push(json!({ "on": format!("{}.{set}", plate.name) }));
        }
        ring
    }

    /// Radius of what goes into a hole: neat, with clearance of any size, or with interference.
    fn fitted(&mut self, hole: f64) -> f64 {
        let clearance = self.draw.magnitude(1e-6, 3e-2);
        let overlap = self.draw.magnitude(1e-5, 3e-3);
        match self.draw.weighted(&[(0.2, 0), (0.68, 1), (0.12, 2)]) {
            0 => hole,
            1 => digits(hole * (1.0 - clearance), 9),
            _ => digits(hole * (1.0 + overlap), 9),
        }
    }

    fn contact(&mut self, [first, second]: [&Part; 2], set: &str, radii: [f64; 2], sizes: &Sizes) {
        let plies = first.name.ends_with("plate") && self.is_laminate(&first.name);
        let mut contact = json!({
            "name": second.name,
            "first": format!("{}.hole", first.name),
            "second": format!("{}.{set}", second.name),
            "friction": laws::law(&mut self.draw, sizes.stress, sizes.slip, plies),
        });
        if radii[1] > radii[0] {
            contact["interference"] = json!(true);
        }
        let gap = self
            .draw
            .weighted(&[(0.7, "exact"), (0.15, "linearised"), (0.15, "faceted")]);
        if gap != "exact" {
            contact["gap"] = json!(gap);
        }
        let tied = self
            .draw
            .weighted(&[(0.85, ""), (0.08, "mortar"), (0.07, "dual-mortar")]);
        if !tied.is_empty() && second.made.is_some() {
            contact["projection"] = json!(tied);
        }
        self.contacts.push(contact);
    }

    /// Holds the joint so that it has an answer in most cases, and loads it.
    fn hold_and_load(&mut self, [plate, pin]: [&Part; 2], ring: bool, sizes: &Sizes) {
        let edge = if ring {
            "outer"
        } else {
            self.draw
                .pick(&["left", "left", "left", "right", "top", "bottom"])
        };
        let edge = format!("{}.{edge}", plate.name);
        let centre = format!("{}.centre", pin.name);
        let how = self
            .draw
            .weighted(&[(0.3, 0), (0.25, 1), (0.2, 2), (0.15, 3), (0.1, 4)]);
        match how {
            // The pin is held and the plate pulled, free to turn: along the line of the pin, or nothing balances it.
            0 if !ring => {
                let edge = format!("{}.left", plate.name);
                self.fix(&centre);
                self.pull(&edge, [-1.0, 0.0], sizes.force);
            }
            // The same with a plate that cannot turn.
            0 | 1 => {
                self.fix(&centre);
                self.platens.push(json!({ "on": edge, "free": ["x", "y"] }));
                let direction = self.direction();
                self.pull(&edge, direction, sizes.force);
            }
            // The plate is held and the pin pushed; a rigid pin that is held takes no load, and all of a ring is held.
            2 => self.push_pin([&edge, &pin.name], sizes.force),
            3 | 4 if ring && pin.made.is_none() => self.push_pin([&edge, &pin.name], sizes.force),
            // The pin is moved.
            3 if pin.made.is_some() => {
                self.hold(&edge);
                let along = digits(sizes.slip * self.draw.between(-1.0, 1.0), 4);
                self.displace(&centre, "x", along);
                let across = if self.draw.chance(0.5) {
                    0.0
                } else {
                    digits(sizes.slip * self.draw.between(-1.0, 1.0), 4)
                };
                self.displace(&centre, "y", across);
                if !ring && self.draw.chance(0.5) {
                    self.press_beside(&plate.name, &edge, sizes.stress);
                }
            }
            // Both are held: pressure on the plate, heat or interference.
            _ => {
                self.fix(&centre);
                self.hold(&edge);
                if ring {
                    self.pull(&format!("{}.rim", pin.name), [1.0, 0.0], sizes.force);
                } else {
                    self.press_beside(&plate.name, &edge, sizes.stress);
                }
            }
        }
    }

    fn hold(&mut self, edge: &str) {
        match self.draw.weighted(&[(0.7, 0), (0.15, 1), (0.15, 2)]) {
            0 => self.fix(edge),
            1 => self.platens.push(json!({ "on": edge, "free": [] })),
            _ => {
                let normal = self.draw.between(-80.0, 80.0).round();
                self.supports
                    .push(json!({ "on": edge, "normal": deg(normal) }));
                self.supports
                    .push(json!({ "on": edge, "normal": deg(normal + 90.0) }));
            }
        }
    }

    fn displace(&mut self, on: &str, axis: &str, by: f64) {
        let support = json!({ "on": on, "fix": [axis], "displacement": mm(by) });
        self.supports.push(support);
    }

    fn pull(&mut self, edge: &str, direction: [f64; 2], force: f64) {
        let steps = self.history(force, "N");
        self.load(
            edge,
            json!({ "force": { "direction": direction, "steps": steps } }),
        );
    }

    /// Holds `edge` and pushes the pin.
    fn push_pin(&mut self, [edge, pin]: [&str; 2], force: f64) {
        self.hold(edge);
        let direction = self.direction();
        self.pull(&format!("{pin}.rim"), direction, force);
    }

    /// Presses on a side of a strip other than the one that is held.
    fn press_beside(&mut self, plate: &str, held: &str, stress: f64) {
        let sides = ["left", "right", "top", "bottom"].map(|side| format!("{plate}.{side}"));
        let free: Vec<&str> = sides
            .iter()
            .map(String::as_str)
            .filter(|side| *side != held)
            .collect();
        let side = free[self.draw.whole(0, free.len() - 1)];
        let steps = self.history(digits(stress, 4), "MPa");
        self.load(side, json!({ "pressure": { "steps": steps } }));
    }

    fn maybe_heat(&mut self, part: &Part) {
        if part.made.is_some() && self.draw.chance(0.5) {
            let steps = self.heat();
            self.load(&part.name, json!({ "temperature": { "steps": steps } }));
        }
    }
}
