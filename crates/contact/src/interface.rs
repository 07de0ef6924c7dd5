//! All contacts of a scene, in independent parts.
//!
//! Contacts depend on each other where bodies that give or move link them; a fixed rigid body transmits nothing. Without such
//! links the compliance of all contacts and their rigid motions are block-diagonal,
//!
//! ```text
//! A = diag(A_1, …, A_P),   G = diag(G_1, …, G_P),
//! ```
//!
//! so that each part is an [`InterfaceProblem`] of its own with its own scales, increments and proofs, and memory and work are sums
//! over the parts. Points, pairs, bodies and rigid motions keep their numbers in the whole problem.

use std::collections::BTreeMap;
use std::ops::Range;

use nalgebra::DVector;
use stickslip_fem_core::{InterfaceOperator, parallel};

use crate::error::ContactError;
use crate::problem::{ContactPair, Contacts, InterfaceProblem, Link, check, link};
use crate::state::ContactState;

/// All contacts of a scene, in independent parts.
#[derive(Clone, Debug)]
pub struct Interface {
    parts: Vec<Part>,
    contacts: Contacts,
    /// First rigid motion of each body, and the number of rigid motions at the end.
    mode_offsets: Vec<usize>,
}

/// Bodies that are linked by contact, and their interface problem.
#[derive(Clone, Debug)]
pub struct Part {
    problem: InterfaceProblem,
    group: Group,
    /// The number in the whole of each of its points.
    points: Vec<usize>,
    /// The number in the whole of each of its rigid motions.
    modes: Vec<usize>,
}

/// Bodies that are linked by contact, and their pairs, both ascending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// Indices of the bodies.
    pub bodies: Vec<usize>,
    /// Indices of the pairs.
    pub pairs: Vec<usize>,
}

/// Groups the bodies that `pairs` link, given by the indices of their two bodies, and those of each of `together`, which springs link. `links[b]`
/// says whether body `b` gives or moves; one that does neither is in every group that touches it, and in none without contact.
pub fn groups(links: &[bool], pairs: &[[usize; 2]], together: &[&[usize]]) -> Vec<Group> {
    let mut parent: Vec<usize> = (0..links.len()).collect();
    let sprung = together.iter().flat_map(|bodies| bodies.windows(2));
    let sprung = sprung.map(|bodies| [bodies[0], bodies[1]]);
    for [first, second] in pairs.iter().copied().chain(sprung) {
        if links[first] && links[second] {
            let (one, other) = (root(&mut parent, first), root(&mut parent, second));
            parent[one.max(other)] = one.min(other);
        }
    }
    // A root is the least of its bodies.
    let mut groups: BTreeMap<usize, Group> = BTreeMap::new();
    for body in (0..links.len()).filter(|&body| links[body]) {
        let group = groups.entry(root(&mut parent, body)).or_default();
        group.bodies.push(body);
    }
    for (index, &[first, second]) in pairs.iter().enumerate() {
        let link = if links[first] { first } else { second };
        let group = groups.entry(root(&mut parent, link)).or_default();
        group.pairs.push(index);
        group.bodies.extend([first, second]);
    }
    let mut groups: Vec<Group> = groups.into_values().collect();
    for group in &mut groups {
        group.bodies.sort_unstable();
        group.bodies.dedup();
    }
    groups
}

fn root(parent: &mut [usize], mut body: usize) -> usize {
    while parent[body] != body {
        parent[body] = parent[parent[body]];
        body = parent[body];
    }
    body
}

impl Interface {
    /// Assembles the problems of `pairs` between `bodies`, those of different parts side by side.
    ///
    /// # Errors
    /// As [`InterfaceProblem::new`].
    pub fn new(
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
    ) -> Result<Self, ContactError> {
        Self::linked(bodies, pairs, &[])
    }

    /// As [`new`](Self::new), with springs `links` between rigid motions of bodies.
    ///
    /// # Errors
    /// As [`InterfaceProblem::linked`].
    pub fn linked(
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
        links: &[Link],
    ) -> Result<Self, ContactError> {
        check::all(&pairs, bodies)?;
        link::check(links, bodies)?;
        let moves = |body: usize| bodies[body].modes().ncols() > 0;
        let gives: Vec<bool> = (0..bodies.len())
            .map(|body| moves(body) || bodies[body].gives())
            .collect();
        let ends: Vec<[usize; 2]> = pairs.iter().map(|pair| [pair.first, pair.second]).collect();
        let together: Vec<&[usize]> = links.iter().map(|link| &*link.bodies).collect();
        let mut groups = groups(&gives, &ends, &together);
        // Others have nothing to solve for.
        groups.retain(|group| !group.pairs.is_empty() || group.bodies.iter().any(|&b| moves(b)));
        if groups.len() < 2 {
            return Ok(InterfaceProblem::linked(bodies, pairs, links)?.into());
        }
        let mode_offsets = link::mode_offsets(bodies, links);
        let mut contacts = Contacts::new(pairs, bodies);
        let whole = (&contacts, links, mode_offsets.as_slice());
        let part = |group: &Group| Part::new(group.clone(), bodies, whole);
        let parts: Vec<Part> = parallel::map(&groups, part)
            .into_iter()
            .collect::<Result<_, _>>()?;
        let points = contacts.points_mut();
        for part in &parts {
            for (&k, point) in part.points.iter().zip(part.problem.points()) {
                points[k].slides = point.slides;
            }
        }
        Ok(Self {
            parts,
            contacts,
            mode_offsets,
        })
    }

    /// The parts, ordered by their first body.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// All pairs and points.
    pub fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// Number of rigid motions of all bodies.
    pub fn mode_count(&self) -> usize {
        self.mode_offsets[self.mode_offsets.len() - 1]
    }

    /// Range of the rigid motions of body `body` among those of all bodies.
    pub fn body_modes(&self, body: usize) -> Range<usize> {
        self.mode_offsets[body]..self.mode_offsets[body + 1]
    }

    /// Amounts of the own rigid motions, as [`InterfaceProblem::motions_of_body`], of body `index` with `state` that of all parts, in the units of its [`modes`](InterfaceOperator::modes).
    pub fn motions_of_body(&self, index: usize, state: &ContactState) -> Vec<f64> {
        // A body that moves is in one part only.
        let own = self.parts.iter().find_map(|part| {
            let local = part.group.bodies.binary_search(&index).ok()?;
            Some((part, local))
        });
        let Some((part, local)) = own else {
            return Vec::new();
        };
        let multipliers = &state.multipliers;
        if self.is_undivided() {
            return (part.problem).motions_of_body(local, &state.rigid, &state.forces, multipliers);
        }
        let rigid = state.rigid.select_rows(&part.modes);
        let forces = part.own_components(&state.forces);
        (part.problem).motions_of_body(local, &rigid, &forces, multipliers)
    }

    /// Whether springs link bodies.
    pub fn is_linked(&self) -> bool {
        self.parts.iter().any(|part| part.problem.is_linked())
    }

    /// The rigid motions of all bodies, none of them linked, that are `amounts` of each body's own: what
    /// [`motions_of_body`](Self::motions_of_body) takes apart.
    pub(crate) fn rigid_of(&self, amounts: &[Vec<f64>]) -> DVector<f64> {
        let mut rigid = DVector::zeros(self.mode_count());
        for (index, own) in amounts.iter().enumerate() {
            let range = self.body_modes(index);
            rigid
                .rows_mut(range.start, range.len())
                .copy_from_slice(own);
        }
        for part in &self.parts {
            for (local, &body) in part.group.bodies.iter().enumerate() {
                let units = part.problem.mode_units(local);
                for (mode, unit) in self.body_modes(body).zip(units) {
                    rigid[mode] /= *unit;
                }
            }
        }
        rigid
    }

    /// Numbers held in the compliances and rigid motions of all parts.
    pub fn entries(&self) -> usize {
        let parts = self.parts.iter().map(|part| &part.problem);
        parts
            .map(|problem| problem.compliance().entries() + problem.modes().len())
            .sum()
    }

    /// Forces `[force]` on the contact points, as [`InterfaceProblem::forces_on_body`], of all parts that touch body `index`; `forces` `[force]`, 2n.
    pub fn forces_on_body(&self, index: usize, count: usize, forces: &DVector<f64>) -> Vec<f64> {
        let mut on_body = vec![0.0; 2 * count];
        for part in &self.parts {
            let Ok(local) = part.group.bodies.binary_search(&index) else {
                continue;
            };
            let found = if self.is_undivided() {
                part.problem.forces_on_body(local, count, forces)
            } else {
                part.problem
                    .forces_on_body(local, count, &part.own_components(forces))
            };
            let both = on_body.iter_mut().zip(found);
            both.for_each(|(sum, force)| *sum += force);
        }
        on_body
    }

    /// Whether one problem holds all bodies.
    pub(crate) fn is_undivided(&self) -> bool {
        self.parts.len() == 1
    }
}

/// One part that holds all bodies, linked or not.
impl From<InterfaceProblem> for Interface {
    fn from(problem: InterfaceProblem) -> Self {
        let bodies = problem.body_count();
        let ends = (0..bodies).map(|body| problem.body_modes(body).end);
        let contacts = problem.contacts().clone();
        Self {
            mode_offsets: std::iter::once(0).chain(ends).collect(),
            parts: vec![Part {
                group: Group {
                    bodies: (0..bodies).collect(),
                    pairs: (0..contacts.pairs().len()).collect(),
                },
                points: (0..contacts.points().len()).collect(),
                modes: (0..problem.modes().ncols()).collect(),
                problem,
            }],
            contacts,
        }
    }
}

impl Part {
    fn new(
        group: Group,
        bodies: &[&dyn InterfaceOperator],
        (contacts, links, mode_offsets): (&Contacts, &[Link], &[usize]),
    ) -> Result<Self, ContactError> {
        let own: Vec<&dyn InterfaceOperator> =
            group.bodies.iter().map(|&body| bodies[body]).collect();
        // Both bodies of each of its pairs are among its own.
        let local = |body: usize| group.bodies.partition_point(|&other| other < body);
        let pairs = group.pairs.iter().map(|&pair| {
            let pair = &contacts.pairs()[pair];
            ContactPair {
                first: local(pair.first),
                second: local(pair.second),
                ..pair.clone()
            }
        });
        let modes = |&body: &usize| mode_offsets[body]..mode_offsets[body + 1];
        // The bodies of a link are in one part.
        let linked = links
            .iter()
            .filter_map(|link| link.among(|body| group.bodies.binary_search(&body).ok()));
        let linked: Vec<Link> = linked.collect();
        Ok(Self {
            problem: InterfaceProblem::linked(&own, pairs.collect(), &linked)?,
            points: (group.pairs.iter())
                .flat_map(|&pair| contacts.pair_points(pair))
                .collect(),
            modes: group.bodies.iter().flat_map(modes).collect(),
            group,
        })
    }

    /// Its interface problem, in which bodies, pairs and points are counted anew in the order of [`group`](Self::group).
    pub fn problem(&self) -> &InterfaceProblem {
        &self.problem
    }

    /// Its bodies and pairs.
    pub fn group(&self) -> &Group {
        &self.group
    }

    /// The number in the whole of each of its points.
    pub fn points(&self) -> &[usize] {
        &self.points
    }

    /// The number in the whole of each of its rigid motions.
    pub fn modes(&self) -> &[usize] {
        &self.modes
    }

    /// Its part of the state `all` of the whole.
    pub(crate) fn own_state(&self, all: &ContactState) -> ContactState {
        let modes = self.modes.iter().map(|&mode| all.rigid[mode]);
        ContactState {
            forces: self.own_components(&all.forces),
            motion: self.own_components(&all.motion),
            rigid: DVector::from_iterator(self.modes.len(), modes),
            status: self.points.iter().map(|&k| all.status[k]).collect(),
            history: self.points.iter().map(|&k| all.history[k]).collect(),
            multipliers: all.multipliers.clone(),
        }
    }

    /// Its normal and tangential components of `all`, those of the whole.
    pub(crate) fn own_components(&self, all: &DVector<f64>) -> DVector<f64> {
        let rows = self.points.iter().flat_map(|&k| [2 * k, 2 * k + 1]);
        DVector::from_iterator(2 * self.points.len(), rows.map(|row| all[row]))
    }
}
