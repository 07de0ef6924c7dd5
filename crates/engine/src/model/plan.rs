//! What a scene says of each body, contact and load: its names are resolved here, and become indices.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

use stickslip_fem_core::mesh::Point;
use stickslip_friction::{History, Place};
use stickslip_scene::schema::{
    self, Analysis, Contact, Division, Fastener, Hold, KinematicsChoice, Load, LoadKind,
    MeshSettings, Platen, SetRef, SpringSupport, Substance, Support,
};
use stickslip_scene::shape::{Edge, Role, Shape};
use stickslip_scene::{Scene, placement};

use crate::series::SeriesBody;

/// A scene whose bodies and edges are known by index, bodies in the order of their names.
pub(super) struct Plan<'a> {
    pub(super) analysis: Analysis,
    /// Whether the scene gives a mesh, for all bodies or for one.
    pub(super) is_divided: bool,
    pub(super) bodies: Vec<BodyPlan<'a>>,
    pub(super) contacts: Vec<ContactPlan<'a>>,
    pub(super) fasteners: Vec<FastenerPlan<'a>>,
    pub(super) supports: Vec<Placed<'a, Support>>,
    pub(super) springs: Vec<Placed<'a, SpringSupport>>,
    pub(super) platens: Vec<Placed<'a, Platen>>,
    pub(super) loads: Vec<Placed<'a, Load>>,
    /// Edges to report besides those in contact.
    pub(super) edges: Vec<Placed<'a, SetRef>>,
}

/// A body.
#[derive(Clone)]
pub(super) struct BodyPlan<'a> {
    pub(super) name: &'a str,
    pub(super) shape: &'a Shape,
    /// What it is made of; `None` for a rigid body.
    pub(super) elastic: Option<Elastic<'a>>,
    pub(super) mesh: MeshSettings,
    /// Its operator where it is modelled by series.
    pub(super) series: Option<Arc<SeriesBody>>,
    /// Where its centre stands `[mm]`.
    pub(super) centre: Point,
    /// How it sits in the hole that holds it, where its nodes are to face those of the hole.
    pub(super) seat: Option<Seat>,
}

/// How a round body sits in a hole under load: which places of the two face each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Seat {
    /// Angles along the hole `[rad]`, ascending.
    angles: Vec<f64>,
    /// By how much the places of the body that face them lie farther along `[rad]`.
    shifts: Vec<f64>,
    /// Whether the angles go around.
    closed: bool,
}

impl Seat {
    /// That where the angle `facing` of the body faces each of `angles` of the hole, all around if `closed`, else from axis to axis of a half model.
    pub(crate) fn new(angles: &[f64], facing: impl Fn(usize) -> f64, closed: bool) -> Self {
        let shift = |(k, angle): (usize, &f64)| {
            let apart = facing(k) - angle;
            apart - TAU * (apart / TAU).round()
        };
        let mut shifts: Vec<f64> = angles.iter().enumerate().map(shift).collect();
        // On the axis of a half model nothing shifts.
        if let (false, [first, .., last]) = (closed, shifts.as_mut_slice()) {
            [*first, *last] = [0.0; 2];
        }
        Self {
            angles: angles.to_vec(),
            shifts,
            closed,
        }
    }

    /// The largest angle `[rad]` by which places of the body that face those of the hole lie farther along.
    pub(crate) fn largest_shift(&self) -> f64 {
        let shifts = self.shifts.iter();
        shifts.fold(0.0, |most: f64, shift| most.max(shift.abs()))
    }

    /// The largest angle `[rad]` between places of the body that face one of the hole in the two.
    pub fn apart(&self, other: &Self) -> f64 {
        let own = self.angles.iter().zip(&self.shifts);
        own.map(|(angle, shift)| (angle + shift - other.facing(*angle)).abs())
            .fold(0.0, f64::max)
    }

    /// The angle of the body that faces `angle` of the hole.
    pub(super) fn facing(&self, angle: f64) -> f64 {
        let (count, first) = (self.angles.len(), self.angles[0]);
        let at = if self.closed {
            first + (angle - first).rem_euclid(TAU)
        } else {
            angle
        };
        let after = self.angles.partition_point(|own| *own <= at);
        let (from, to) = match after {
            after if after < count => (after.saturating_sub(1), after),
            _ if self.closed => (count - 1, 0),
            _ => (count - 1, count - 1),
        };
        let ahead = |from: f64, to: f64| (to - from).rem_euclid(TAU);
        let width = ahead(self.angles[from], self.angles[to]);
        let part = if width > 0.0 {
            (ahead(self.angles[from], at) / width).min(1.0)
        } else {
            0.0
        };
        angle + (1.0 - part) * self.shifts[from] + part * self.shifts[to]
    }
}

/// What an elastic body is made of.
#[derive(Clone, Copy)]
pub(super) struct Elastic<'a> {
    /// Name of the material.
    pub(super) name: &'a str,
    pub(super) material: &'a schema::Material,
    /// Thickness `[mm]`.
    pub(super) thickness: f64,
}

/// Something that a scene puts on an edge, a point, or the whole of a body.
pub(super) struct Placed<'a, T> {
    /// Index of the body.
    pub(super) body: usize,
    /// The edge, if it is one.
    pub(super) edge: Option<Edge>,
    pub(super) of: &'a T,
}

/// Two edges that may touch.
pub(super) struct ContactPlan<'a> {
    pub(super) of: &'a Contact,
    pub(super) sides: [Placed<'a, SetRef>; 2],
    /// Centre of the second circle of a round contact, seen from that of the first `[mm]`.
    pub(super) offset: Point,
}

/// A fastener.
pub(super) struct FastenerPlan<'a> {
    pub(super) of: &'a Fastener,
    /// Indices of its slices, in the order of the layers.
    pub(super) slices: Vec<usize>,
}

impl<'a> Plan<'a> {
    /// Resolves the names of `scene`. It was checked: all of them refer to something in it.
    pub(super) fn of(scene: &'a Scene) -> Self {
        let numbers = scene.bodies.keys().map(String::as_str).zip(0..);
        let numbers: BTreeMap<&str, usize> = numbers.collect();
        let names = Names { scene, numbers };
        let contact = |of: &'a Contact| ContactPlan {
            of,
            sides: [&of.first, &of.second].map(|on| names.placed(on, on)),
            offset: placement::offset(scene, of),
        };
        let fastener = |of: &'a Fastener| FastenerPlan {
            of,
            slices: of
                .slices
                .iter()
                .map(|name| names.numbers[name.as_str()])
                .collect(),
        };
        let load = |of: &'a Load| match &of.kind {
            LoadKind::Force { on, .. }
            | LoadKind::Bearing { on, .. }
            | LoadKind::Pressure { on, .. }
            | LoadKind::PolarTraction { on, .. } => names.placed(on, of),
            LoadKind::Temperature { body, .. } => Placed {
                body: names.numbers[body.as_str()],
                edge: None,
                of,
            },
        };
        let (supports, platens) = (scene.supports.iter(), scene.platens.iter());
        Self {
            analysis: scene.analysis,
            is_divided: scene.is_divided_anywhere(),
            bodies: scene.bodies.keys().map(|name| names.body(name)).collect(),
            contacts: scene.contacts.iter().map(contact).collect(),
            fasteners: scene.fasteners.iter().map(fastener).collect(),
            supports: supports.map(|of| names.placed(&of.on, of)).collect(),
            springs: (scene.springs.iter())
                .map(|of| names.placed(&of.on, of))
                .collect(),
            platens: platens.map(|of| names.placed(&of.on, of)).collect(),
            loads: scene.loads.iter().map(load).collect(),
            edges: scene.edges.iter().map(|on| names.placed(on, on)).collect(),
        }
    }

    /// Seats the second body of each contact as `seats` say where gaps follow the displacement, so that its nodes face those of the first.
    pub(super) fn seat(&mut self, seats: &[Option<Seat>]) {
        if !self.finds_gaps_deformed() {
            return;
        }
        for (contact, seat) in self.contacts.iter().zip(seats) {
            self.bodies[contact.sides[1].body].seat.clone_from(seat);
        }
    }

    /// Whether contact is found on the deformed geometry.
    pub(super) fn finds_gaps_deformed(&self) -> bool {
        self.analysis.kinematics == Some(KinematicsChoice::DeformedGaps)
    }

    pub(super) fn is_rigid(&self, body: usize) -> bool {
        self.bodies[body].elastic.is_none()
    }

    /// The supports of a body.
    pub(super) fn supports_of(&self, body: usize) -> impl Iterator<Item = &'a Support> {
        on(&self.supports, body)
    }

    /// The platens of a body.
    pub(super) fn platens_of(&self, body: usize) -> impl Iterator<Item = &'a Platen> {
        on(&self.platens, body)
    }

    /// Whether the body stands on springs.
    pub(super) fn is_sprung(&self, body: usize) -> bool {
        self.springs.iter().any(|own| own.body == body)
    }

    /// Unit vectors along which supports, springs and platens hold the edge `on`.
    pub(super) fn held_along(&self, on: &SetRef) -> Vec<[f64; 2]> {
        let supports = self.supports.iter().map(|support| support.of);
        let holds = supports.filter(|support| support.on == *on);
        let mut held: Vec<[f64; 2]> = holds
            .flat_map(|support| support.hold.directions())
            .collect();
        let springs = self.springs.iter().map(|own| own.of);
        let springs = springs.filter(|own| own.on == *on);
        held.extend(springs.flat_map(|own| own.hold.directions()));
        if self.platens.iter().any(|platen| platen.of.on == *on) {
            held.extend([[1.0, 0.0], [0.0, 1.0]]);
        }
        held
    }

    /// Along which axes its supports leave a rigid body free.
    pub(super) fn free_axes(&self, body: usize) -> [bool; 2] {
        self.supports_of(body)
            .fold([true; 2], |[x, y], support| match support.hold {
                Hold::Axes(axes) => [x && !axes.x, y && !axes.y],
                Hold::Direction(_) => [false; 2],
            })
    }

    /// The fastener of which a body is a slice.
    pub(super) fn fastener_of(&self, body: usize) -> Option<&FastenerPlan<'a>> {
        let mut fasteners = self.fasteners.iter();
        fasteners.find(|fastener| fastener.slices.contains(&body))
    }

    /// The indices of the two bodies of every contact.
    pub(super) fn pairs(&self) -> Vec<[usize; 2]> {
        let sides = self.contacts.iter().map(|contact| &contact.sides);
        sides.map(|[one, other]| [one.body, other.body]).collect()
    }
}

impl<T> Placed<'_, T> {
    /// Radius of the closed circle that it is on.
    pub(super) fn circle(&self) -> Option<f64> {
        self.edge.as_ref()?.circle()
    }
}

impl ContactPlan<'_> {
    /// Radii `[mm]` of the two circles of a round contact.
    pub(super) fn radii(&self) -> Option<[f64; 2]> {
        let [first, second] = &self.sides;
        Some([first.circle()?, second.circle()?])
    }

    /// Whether its law holds anything under pressure.
    pub(super) fn rubs(&self) -> bool {
        let anywhere = Place {
            position: [0.0; 2],
            tangent: [-1.0, 0.0],
            material_angle: 0.0,
        };
        let bound = (self.of.law).bound(1.0, 0.0, &anywhere, &History::default());
        bound.stick.max(bound.slip) > 0.0
    }
}

impl BodyPlan<'_> {
    /// Thickness `[mm]`; 1 for a rigid body.
    pub(super) fn thickness(&self) -> f64 {
        self.elastic.map_or(1.0, |elastic| elastic.thickness)
    }

    /// Radius `[mm]` of its rim, of a disk.
    pub(super) fn radius(&self) -> Option<f64> {
        self.shape.edge_with(Role::Rim)?.circle()
    }

    /// Material angle `[rad]`.
    pub(super) fn material_angle(&self) -> f64 {
        self.elastic.map_or(0.0, |elastic| elastic.material.angle())
    }

    /// Up to which angle `[rad]` or length `[mm]` along its contact edge its mesh is fine; `None` for all of it.
    pub(super) fn fine_to(&self) -> Option<f64> {
        match self.mesh.division {
            Division::Angular(grading) | Division::Linear(grading) => {
                self.shape.fine_to(grading.fine_to)
            }
            Division::AngleList(_) | Division::Places(_) => None,
        }
    }
}

fn on<'a, T>(all: &[Placed<'a, T>], body: usize) -> impl Iterator<Item = &'a T> {
    let own = all.iter().filter(move |placed| placed.body == body);
    own.map(|placed| placed.of)
}

/// The names of a scene.
struct Names<'a> {
    scene: &'a Scene,
    /// The index of each body.
    numbers: BTreeMap<&'a str, usize>,
}

impl<'a> Names<'a> {
    fn placed<T>(&self, on: &SetRef, of: &'a T) -> Placed<'a, T> {
        Placed {
            body: self.numbers[on.body.as_str()],
            edge: self.scene.bodies[&on.body].shape.edge(&on.set),
            of,
        }
    }

    fn body(&self, name: &'a str) -> BodyPlan<'a> {
        let body = &self.scene.bodies[name];
        let elastic = match &body.substance {
            Substance::Elastic {
                material,
                thickness,
            } => Some(Elastic {
                name: material,
                material: &self.scene.materials[material],
                thickness: *thickness,
            }),
            Substance::Rigid => None,
        };
        BodyPlan {
            name,
            shape: &body.shape,
            elastic,
            mesh: self.scene.mesh_of(name).clone(),
            series: None,
            centre: placement::centre(self.scene, name),
            seat: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn seats_go_on_around_a_circle_and_rest_on_the_axis() {
        let angles: Vec<f64> = (0..90).map(|k| TAU / 90.0 * f64::from(k) - PI).collect();
        let facing = |angle: f64| angle + 0.01 * (2.0 * angle).sin() - 0.02;
        let whole = Seat::new(&angles, |k| facing(angles[k]), true);
        for angle in [-PI, -3.1, 0.3, 3.1, 3.2, 2.0 * PI] {
            assert!(
                (whole.facing(angle) - facing(angle)).abs() < 3e-5,
                "{angle}"
            );
        }
        let upper: Vec<f64> = (0..=45).map(|k| PI / 45.0 * f64::from(k)).collect();
        let half = Seat::new(&upper, |k| upper[k] + 0.01 * upper[k].sin() + 1e-9, false);
        assert_eq!(half.facing(0.0).to_bits(), 0.0_f64.to_bits());
        assert_eq!(half.facing(PI).to_bits(), PI.to_bits());
        assert!((half.facing(1.0) - 1.0 - 0.01 * 1.0_f64.sin()).abs() < 1e-5);
    }

    /// The same places are no way apart, whatever the angles at which two seats are known, all around a circle.
    #[test]
    fn seats_are_apart_by_what_faces_the_hole() {
        let seat = |count: i32, from: f64, turn: f64| {
            let at = |k: i32| from + TAU / f64::from(count) * f64::from(k);
            let angles: Vec<f64> = (0..count).map(at).collect();
            Seat::new(&angles, |k| angles[k] + 0.01 * angles[k].sin() + turn, true)
        };
        let (fine, coarse) = (seat(360, -PI, 0.0), seat(90, 0.0, 0.0));
        assert!(fine.apart(&coarse) < 1e-5 && coarse.apart(&fine) < 1e-5);
        let turned = seat(120, -PI, 3e-3);
        for apart in [fine.apart(&turned), turned.apart(&coarse)] {
            assert!((apart - 3e-3).abs() < 1e-5, "{apart}");
        }
    }
}
