//! Pairs of edges in contact.

use stickslip_friction::PlyFraction;

use super::{Builder, Fits, LONGEST_NAME, Materials};
use crate::diagnostic::SceneProblem;
use crate::document::Part;
use crate::format::SceneFormat;
use crate::friction;
use crate::schema::{Contact, ContactFormat, GapKind, SetRef, Substance};
use crate::shape::{Edge, Role, Touch};
use crate::units::{Length, UnitName};

/// Largest overlap of two circles, as a part of the hole's radius: small displacements hold far below it.
const LARGEST_OVERLAP: f64 = 0.1;
/// Smallest inner circle, as a part of the hole's radius: radii of the hole, along which gaps are found, miss a smaller one.
const SMALLEST_INNER: f64 = 0.5;

impl Builder<'_> {
    pub(super) fn contacts(
        &mut self,
        format: &mut SceneFormat,
        materials: &Materials,
    ) -> Vec<Contact> {
        let mut contacts: Vec<Contact> = Vec::new();
        for (index, given) in format.contacts.iter_mut().enumerate() {
            // The second edge is that of the pin or of the block.
            let second = given
                .second
                .split('.')
                .next()
                .unwrap_or_default()
                .to_owned();
            let name = given.name.get_or_insert(second).clone();
            let key = format!("contacts.{index}");
            self.contact_name(&key, &name);
            if contacts.iter().any(|other| other.name == name) {
                let message = format!("two contacts are called '{name}'");
                let remedy = "give each contact a name of its own";
                self.conflict(&format!("{key}.name"), message, remedy);
            }
            if let Some(contact) = self.contact(&key, name, given, materials) {
                // Edges that cannot touch need no second message.
                if !self.is_refused_at(&key) {
                    self.edges_are_free(&key, &contacts, &contact);
                }
                match closed_chain(&contacts, &contact) {
                    Some(chain) => self.circular(&key, &chain),
                    None => contacts.push(contact),
                }
            }
        }
        contacts
    }

    /// Names of contacts are parts of file names, otherwise free.
    fn contact_name(&mut self, key: &str, name: &str) {
        let letters = name.chars().count();
        if !(1..=LONGEST_NAME).contains(&letters) || name.contains(['/', '\\']) {
            let allowed = "1 to 64 letters without '/' and '\\'".to_owned();
            self.out_of_range(&format!("{key}.name"), &format!("\"{name}\""), allowed);
        }
    }

    /// A circle, a cap or a surface touches one other edge, an open edge each other one once.
    fn edges_are_free(&mut self, key: &str, others: &[Contact], contact: &Contact) {
        let edges = [&contact.first, &contact.second];
        let is_open = edges.map(|edge| {
            let own = self.edge_of(edge);
            own.is_some_and(|own| own.role == Role::Free && own.curve.path().is_some())
        });
        let has = |other: &Contact, edge: &SetRef| [&other.first, &other.second].contains(&edge);
        for (place, (edge, is_open)) in ["first", "second"]
            .iter()
            .zip(edges.into_iter().zip(is_open))
        {
            let mut others = others.iter().filter(|_| !is_open);
            if let Some(other) = others.find(|other| has(other, edge)) {
                let message = format!("{edge} is in contact '{}' already", other.name);
                let remedy = "a circle takes part in one contact: a bushing touches with its hole and its outer edge, and a bolt through several plates has a \
                              slice in the hole of each, joined by [fasteners.NAME] slices = […]";
                self.conflict(&format!("{key}.{place}"), message, remedy);
            }
        }
        let mut same = others.iter().filter(|_| is_open == [true; 2]);
        if let Some(same) = same.find(|other| edges.iter().all(|edge| has(other, edge))) {
            let [one, other] = edges;
            let message = format!("{one} and {other} are in contact '{}' already", same.name);
            self.conflict(key, message, "remove one of the two contacts");
        }
    }

    fn circular(&mut self, key: &str, chain: &[String]) {
        let message = match chain {
            [own] => format!("contact {own} is one of a body with itself"),
            _ => format!(
                "contacts form a circle, in which each body would stand inside the next: {}",
                chain.join(", ")
            ),
        };
        let remedy = "a hole holds another, smaller body: change or remove a contact";
        self.conflict(key, message, remedy);
    }

    fn contact(
        &mut self,
        key: &str,
        name: String,
        given: &mut ContactFormat,
        materials: &Materials,
    ) -> Option<Contact> {
        let first = self.set(&format!("{key}.first"), &given.first, Fits::Edges);
        let second = self.set(&format!("{key}.second"), &given.second, Fits::Edges);
        let law_key = format!("{key}.friction");
        let law = match &mut given.friction {
            None => {
                self.report(
                    key,
                    Part::Key,
                    SceneProblem::MissingFriction {
                        contact: name.clone(),
                    },
                );
                None
            }
            Some(table) => match friction::read(
                self.document,
                &law_key,
                table,
                first
                    .as_ref()
                    .and_then(|first| self.ply_fractions(first, materials)),
            ) {
                Ok(read) => {
                    *table = read.shown;
                    Some(read.law)
                }
                Err(finding) => {
                    self.findings.push(*finding);
                    None
                }
            },
        };
        let (first, second) = (first?, second?);
        // Contact of a body with itself is refused elsewhere.
        if first.body != second.body {
            self.pair(key, given, &first, &second);
        }
        Some(given.contact(name, [first, second], law?))
    }

    /// What the plies of the first body's laminate have of its thickness.
    fn ply_fractions(&self, first: &SetRef, materials: &Materials) -> Option<Vec<PlyFraction>> {
        let Substance::Elastic { material, .. } = &self.bodies.get(&first.body)?.substance else {
            return None;
        };
        let sheet = materials.get(material)?.laminate()?;
        Some(sheet.ply_fractions())
    }

    fn pair(&mut self, key: &str, given: &ContactFormat, first: &SetRef, second: &SetRef) {
        match self.touch(first, second) {
            Some(Touch::Circles { radii }) => {
                self.circles(given.interference, [first, second], radii);
            }
            Some(Touch::Cylinder { .. }) => self.divided_together(key, [first, second]),
            Some(Touch::Open) => self.open(key, given.gap, [first, second]),
            None => self.no_pair(key, first, second),
        }
    }

    /// Refuses open edges of shapes with an axis, and gaps that are not those of the true curves.
    fn open(&mut self, key: &str, gap: GapKind, edges: [&SetRef; 2]) {
        let has_axis = |edge: &&&SetRef| {
            let body = self.bodies.get(&edge.body);
            body.is_some_and(|body| body.shape.mirror().is_some())
        };
        if let Some(edge) = edges.iter().find(has_axis) {
            let message = format!(
                "{edge} is an edge of a shape that stands about the origin and touches by its circle or its contact edge"
            );
            let remedy = "draw the body as shape.outline";
            self.conflict(key, message, remedy);
            return;
        }
        if gap != GapKind::Exact {
            let message = "open edges have exact gaps; linearised and faceted ones are those of a circle in a hole or a cylinder on a block";
            let remedy = "leave out `gap`, which is then that of the true curves";
            self.conflict(&format!("{key}.gap"), message, remedy);
        }
    }

    pub(super) fn edge_of(&self, set: &SetRef) -> Option<Edge> {
        self.bodies.get(&set.body)?.shape.edge(&set.set)
    }

    fn touch(&self, first: &SetRef, second: &SetRef) -> Option<Touch> {
        self.edge_of(first)?.touches(&self.edge_of(second)?)
    }

    /// Refuses a cap and a surface of different sizes.
    fn divided_together(&mut self, key: &str, edges: [&SetRef; 2]) {
        let size = |edge: &SetRef| {
            let bounds = self.bodies.get(&edge.body).map(|body| body.shape.bounds());
            bounds.map_or([0.0; 2], |[low, high]| [high[0], high[1] - low[1]])
        };
        let [[length, depth], [other_length, other_depth]] = edges.map(size);
        if (length, depth) != (other_length, other_depth) {
            let [first, second] = edges.map(|edge| &edge.body);
            let message = format!(
                "'{first}' and '{second}' are divided together, but their half_length or depth differ \
                 ({length} and {other_length} mm, {depth} and {other_depth} mm)"
            );
            let remedy = "give both bodies the same half_length and depth";
            self.conflict(key, message, remedy);
        }
    }

    fn no_pair(&mut self, key: &str, first: &SetRef, second: &SetRef) {
        let swapped = self.touch(second, first).is_some();
        let is_hole = |on: &SetRef| self.edge_of(on).is_some_and(|own| own.role == Role::Hole);
        let uneven = [first, second].into_iter().find_map(|on| {
            let shape = &self.bodies.get(&on.body)?.shape;
            Some(format!(
                "'{on}' is no circle: {}, and 10⁻⁵ of the radius are allowed; write its coordinates with more digits, or name it in `circles` of its mesh",
                shape.why_not_round(&on.set)?
            ))
        });
        let remedy = if let Some(uneven) = uneven {
            uneven
        } else if is_hole(first) && is_hole(second) {
            format!(
                "plates in different layers are joined by bolts, and friction between them is not modelled: put a disk into each of the two holes \
                 (first = \"{first}\", second = \"bolt.rim\"), and join the disks by [fasteners.NAME] slices = […]"
            )
        } else if swapped {
            format!("swap them: first = \"{second}\", second = \"{first}\"")
        } else {
            "first is a circular hole and second the rim of a disk or the outer edge of a ring, or first the contact edge of a \
             cylinder and second that of a block, or both are open edges whose lines, arcs and splines are known: of outlines and rectangles, and of meshes along lines and arcs, or named in `splines` of their mesh"
                .to_owned()
        };
        let problem = SceneProblem::ContactPair {
            first: first.to_string(),
            second: second.to_string(),
            remedy,
        };
        self.report(key, Part::Key, problem);
    }

    /// Refuses two circles that overlap without being meant to, or that small displacements or gaps along radii cannot join.
    fn circles(&mut self, interference: bool, edges: [&SetRef; 2], [hole, inner]: [f64; 2]) {
        let [hole_key, inner_key] = edges.map(|edge| self.radius_key(edge));
        let text = |key: &str, radius: f64| {
            let value = self.document.get(key).and_then(serde_json::Value::as_str);
            let base = || UnitName::<Length>::base().unit().show(radius);
            value.map_or_else(base, str::to_owned)
        };
        let (hole_text, inner_text) = (text(&hole_key, hole), text(&inner_key, inner));
        // Differences are reported in the unit that the inner radius is written in.
        let unit = crate::units::unit_of(&inner_text);
        let show = |value: f64| unit.map_or_else(|| format!("{value} mm"), |unit| unit.show(value));
        // A fitted radius is none that the user wrote.
        let fitted = |edge: &SetRef, text: String| {
            let body = self.bodies.get(&edge.body);
            let fit = body.and_then(|body| body.shape.fit(&edge.set));
            match fit.filter(|fit| fit.given.is_none()) {
                Some(fit) if fit.counts(fit.scatter, inner - hole) => format!(
                    "{text}, fitted to nodes up to {:.1e} mm off it; `radii` of the mesh gives the true one",
                    fit.scatter
                ),
                _ => text,
            }
        };
        let hole_text = fitted(edges[0], hole_text);
        let inner_text = fitted(edges[1], inner_text);
        let second = self.bodies.get(&edges[1].body);
        let hollow = second.and_then(|body| body.shape.edge_with(Role::Hole));
        let part = if hollow.is_some() { "bushing" } else { "pin" };
        if inner > hole && !interference {
            let problem = SceneProblem::PinTooLarge {
                part,
                hole: hole_text,
                overlap: show(inner - hole),
                pin: inner_text,
            };
            self.report(&inner_key, Part::Value, problem);
        } else if inner - hole > LARGEST_OVERLAP * hole {
            let message = format!(
                "the {part} (radius {inner_text}) overlaps the hole (radius {hole_text}) by {}, {:.3} % of the hole's radius; \
                 displacements are taken as small, which they are not here",
                show(inner - hole),
                100.0 * (inner / hole - 1.0)
            );
            let most = show(hole * (1.0 + LARGEST_OVERLAP));
            let remedy = format!("give a radius of at most {most}");
            self.conflict(&inner_key, message, remedy);
        } else if inner < SMALLEST_INNER * hole {
            let message = format!(
                "the {part} (radius {inner_text}) is too small for the hole (radius {hole_text}): gaps are found along the hole's \
                 radii, and some of them miss a {part} of less than half its radius"
            );
            let least = show(SMALLEST_INNER * hole);
            let remedy = format!("give a radius of at least {least}, close to the hole's");
            self.conflict(&inner_key, message, remedy);
        }
    }

    /// Key of the radius of a circular edge.
    fn radius_key(&self, edge: &SetRef) -> String {
        let shape = format!("bodies.{}.shape", edge.body);
        match self.edge_of(edge).and_then(|edge| edge.size) {
            Some(size) => format!("{shape}.{size}"),
            None => shape,
        }
    }
}

/// The contacts by which `contact` would lead from a body back to itself, if it would.
fn closed_chain(others: &[Contact], contact: &Contact) -> Option<Vec<String>> {
    let mut chain = vec![format!("'{}'", contact.name)];
    let mut outer = &contact.first.body;
    // The others close no chain, so this walk ends.
    while *outer != contact.second.body {
        let holder = others.iter().find(|other| other.second.body == *outer)?;
        chain.push(format!("'{}'", holder.name));
        outer = &holder.first.body;
    }
    Some(chain)
}
