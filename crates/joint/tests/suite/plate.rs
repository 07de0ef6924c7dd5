//! A plate with a pinned hole: half model, pin held, plate pulled towards −x.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::{ContactPair, ContactPoint, Stencil};
use stickslip_fem_core::generate::{
    Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, RigidBody, Support};
use stickslip_friction::Coulomb;
use stickslip_joint::{Gauge, Joint, JointBody, Mark, ProgressiveBody, Pull};
use stickslip_laminate::progressive::PointModel;

/// Geometry `[mm]` and mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plate {
    pub(crate) radius: f64,
    pub(crate) half_width: f64,
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// Cells along the half circle.
    pub(crate) cells: usize,
    pub(crate) layers: usize,
    pub(crate) kind: ElementKind,
    pub(crate) friction: f64,
    pub(crate) clearance: f64,
}

impl Default for Plate {
    fn default() -> Self {
        Self {
            radius: 3.0,
            half_width: 9.0,
            left: 18.0,
            right: 12.0,
            cells: 16,
            layers: 6,
            kind: ElementKind::Q8,
            friction: 0.2,
            clearance: 0.0,
        }
    }
}

/// How the left end is pulled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    /// By 1 N in all (of the half plate: ½ N), spread evenly.
    Loaded,
    /// By 1 mm.
    Driven,
    /// Not at all: it is held, and the pin moves.
    Held,
}

impl Plate {
    pub(crate) fn mesh(&self) -> Arc<Mesh> {
        let plate = PlateWithHole {
            hole_radius: self.radius,
            outline: Outline::Strip {
                half_width: self.half_width,
                left: self.left,
                right: self.right,
            },
            extent: Extent::Half,
            angles: uniform_angles(Extent::Half, self.cells),
            layers: self.layers,
            growth: Growth::Geometric { aspect: 1.0 },
            far_cells: 3,
            kind: self.kind,
        };
        Arc::new(plate.generate().unwrap())
    }

    pub(crate) fn hole(mesh: &Mesh) -> Vec<usize> {
        mesh.counter_clockwise(&mesh.edge_path("hole").unwrap(), [0.0, 0.0])
            .nodes
    }

    pub(crate) fn body(
        &self,
        mesh: &Arc<Mesh>,
        material: Arc<dyn Material>,
        thickness: f64,
        end: End,
    ) -> Arc<ElasticBody> {
        let hold = |set: &str, direction, displacement| Support {
            nodes: mesh.node_set(set).unwrap().to_vec(),
            direction,
            displacement,
        };
        let mut supports = vec![hold("symmetry", HeldDirection::Y, 0.0)];
        let case = match end {
            End::Loaded => LoadCase {
                forces: edge_load(
                    mesh,
                    &mesh.edge_set("left").unwrap().edges,
                    thickness,
                    |_| [-0.5 / (thickness * self.half_width), 0.0],
                ),
                ..LoadCase::default()
            },
            End::Driven | End::Held => {
                let pull = if end == End::Driven { -1.0 } else { 0.0 };
                supports.push(hold("left", HeldDirection::X, pull));
                LoadCase {
                    moves_supports: true,
                    ..LoadCase::default()
                }
            }
        };
        let materials = vec![material; mesh.blocks().len()];
        let body = ElasticBody::new(Arc::clone(mesh), materials, thickness)
            .unwrap()
            .with_supports(supports)
            .with_load_cases(vec![case])
            .unwrap();
        Arc::new(body)
    }

    /// The pair of plate (body 0) and pin (body 1), and the pin's points.
    pub(crate) fn pair(&self, mesh: &Mesh, thickness: f64) -> (ContactPair, RigidBody) {
        let nodes = Self::hole(mesh);
        let count = nodes.len();
        let positions: Vec<[f64; 2]> = nodes.iter().map(|&node| mesh.nodes()[node]).collect();
        let quadratic = self.kind.order() == 2;
        let step = PI * self.radius / (count - 1) as f64 * if quadratic { 2.0 } else { 1.0 };
        let share = |k: usize| {
            let end = k == 0 || k + 1 == count;
            match (quadratic, k % 2 == 1, end) {
                (true, true, _) => 4.0 / 6.0,
                (true, false, true) => 1.0 / 6.0,
                (true, false, false) => 2.0 / 6.0,
                (false, _, true) => 0.5,
                (false, _, false) => 1.0,
            }
        };
        let points = (0..count).map(|k| {
            let [x, y] = positions[k];
            let theta = y.atan2(x);
            ContactPoint {
                first: Stencil::from(k),
                second: Stencil::from(k),
                normal: [theta.cos(), theta.sin()],
                gap: self.clearance * (1.0 - theta.cos()),
                area: thickness * step * share(k),
                material_angle: 0.0,
            }
        });
        let pair = ContactPair {
            name: "pin".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points: points.collect(),
            law: Arc::new(Coulomb::new(self.friction).unwrap()),
        };
        (pair, RigidBody::held(positions, 1))
    }

    pub(crate) fn gauge(mesh: &Mesh) -> Gauge {
        let far = mesh.node_set("left").unwrap()[0];
        Gauge {
            pull: Pull::Contact {
                pair: 0,
                direction: [1.0, 0.0],
            },
            multiple: 2.0,
            direction: [1.0, 0.0],
            first: Mark::Fixed,
            second: Mark::Node { body: 0, node: far },
            free_travel: 0.0,
        }
    }

    pub(crate) fn joint(&self, model: &Arc<dyn PointModel>, end: End) -> Joint {
        self.joint_at(model, end, 0.0)
    }

    /// With the residual stresses of the temperature rise `temperature` since the cure.
    pub(crate) fn joint_at(
        &self,
        model: &Arc<dyn PointModel>,
        end: End,
        temperature: f64,
    ) -> Joint {
        let mesh = self.mesh();
        let models = vec![Arc::clone(model); mesh.element_count()];
        self.joint_of(&mesh, models, end, temperature)
    }

    fn joint_of(
        &self,
        mesh: &Arc<Mesh>,
        models: Vec<Arc<dyn PointModel>>,
        end: End,
        temperature: f64,
    ) -> Joint {
        let (plate, pair, pin) = self.parts(mesh, models, end, temperature);
        let bodies = vec![plate, JointBody::Rigid(pin)];
        Joint::new(bodies, vec![pair], Self::gauge(mesh)).unwrap()
    }

    /// Plate, pair and rigid pin.
    pub(crate) fn parts(
        &self,
        mesh: &Arc<Mesh>,
        models: Vec<Arc<dyn PointModel>>,
        end: End,
        temperature: f64,
    ) -> (JointBody, ContactPair, RigidBody) {
        let laminate = models[0].laminate();
        let thickness = laminate.thickness();
        let material = Arc::new(laminate.membrane_material().unwrap());
        let body = self.body(mesh, material, thickness, end);
        let (pair, pin) = self.pair(mesh, thickness);
        let plate = ProgressiveBody::with_models(body, &Self::hole(mesh), models)
            .unwrap()
            .at_temperature(temperature)
            .unwrap();
        (JointBody::Progressive(Arc::new(plate)), pair, pin)
    }
}
