//! An elastic block, −1 ≤ x ≤ 1 and −1 ≤ y ≤ 0, with E = 1 and ν = 0.3 in plane stress, under a rigid plate or cylinder.

use std::sync::Arc;

use stickslip_contact::{
    Chain, ContactPair, ContactPoint, InterfaceProblem, LoadHistory, Ramp, StepRecord,
};
use stickslip_fem_core::generate::{Generate, Rectangle, geometric};
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh, MeshParts};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, RigidBody, Support};

use crate::publish::TaskError;
use crate::stability::joint::coulomb;

/// Radius of the cylinder.
const RADIUS: f64 = 4.0;
/// Growth of the layers below a thin one.
const GROWTH: f64 = 1.5;
/// Pressure of the plate.
const PRESSURE: f64 = 1e-3;
/// Share of the contact in which oscillation is measured: near its end pressure falls within a cell.
const INSIDE: f64 = 0.8;

/// What is wrong with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Defect {
    None,
    /// The surface layer is this many times as wide as deep.
    Aspect(f64),
    /// Inner corner nodes are moved by up to this share of a cell.
    Distorted(f64),
    /// Mid-side nodes of the contact edge stand at this share of their edge.
    MidSide(f64),
}

/// What presses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Indenter {
    round: bool,
    force: f64,
    pushed: bool,
}

impl Indenter {
    /// A plate over the whole block.
    pub(super) fn plate() -> Self {
        Self {
            round: false,
            force: 2.0 * PRESSURE,
            pushed: false,
        }
    }

    /// A cylinder that would touch a half-plane over `half_width` to either side: P = π E a²/(4 R) (Hertz 1882).
    pub(super) fn cylinder(half_width: f64) -> Self {
        let force = std::f64::consts::PI * half_width * half_width / (4.0 * RADIUS);
        Self {
            round: true,
            force,
            pushed: false,
        }
    }

    /// The same, pushed to and fro after pressing.
    pub(super) fn pushed(self) -> Self {
        Self {
            pushed: true,
            ..self
        }
    }
}

/// A meshed block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    /// Cells along x; half as many along y.
    pub(super) cells: usize,
    pub(super) kind: ElementKind,
    pub(super) defect: Defect,
}

/// What is measured of a pressed block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pressed {
    pub(super) peak: f64,
    /// Largest deviation from the plate's pressure, relative.
    pub(super) deviation: f64,
    /// Largest difference of a mid-side pressure from the mean of its neighbours inside the contact, over the peak.
    pub(super) oscillation: f64,
}

impl Block {
    /// Presses with each of `indenters` of one shape in turn, without friction unless `mu` is positive.
    pub(super) fn press(&self, indenters: &[Indenter], mu: f64) -> Result<Vec<Pressed>, TaskError> {
        let first = indenters.first().ok_or("nothing presses")?;
        let (problem, _) = self.problem(first, mu)?;
        let steps = indenters.iter().map(|own| vec![own.force, 0.0]).collect();
        let history = LoadHistory::new(steps, 1, Ramp::Linear)?;
        let records = history.follow(&problem, &Chain::default(), |_| {})?;
        let quadratic = self.kind.order() == 2;
        let points = || problem.points().iter();
        let place: Vec<f64> = points().map(|point| point.place.position[0]).collect();
        let pressed = |record: &StepRecord| {
            let pressures = points().enumerate();
            let pressure = pressures.map(|(k, point)| record.state.normal_force(k) / point.area);
            measured(&pressure.collect::<Vec<f64>>(), &place, quadratic)
        };
        Ok(records.iter().map(pressed).collect())
    }

    /// The contact problem and its loads: pressed, and pushed to and fro if so asked.
    pub(super) fn problem(
        &self,
        indenter: &Indenter,
        mu: f64,
    ) -> Result<(InterfaceProblem, Vec<Vec<f64>>), TaskError> {
        let mesh = Arc::new(self.mesh()?);
        let path = mesh.edge_path("top")?;
        let weights = mesh.edge_weights(&path, Some(Curve::Line));
        let positions: Vec<[f64; 2]> = path.nodes.iter().map(|&node| mesh.nodes()[node]).collect();
        let condensed = held(&mesh)?.condense(&path.nodes)?;
        let rigid = RigidBody::sliding(
            positions.clone(),
            [indenter.pushed, true],
            &[[0.0, -1.0], [1.0, 0.0]],
        );
        let gap = |x: f64| {
            if indenter.round {
                x.powi(2) / (2.0 * RADIUS)
            } else {
                0.0
            }
        };
        let point = |(k, [x, _]): (usize, &[f64; 2])| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal: [0.0, -1.0],
            gap: gap(*x),
            area: weights[k],
            material_angle: 0.0,
        };
        let points = positions.iter().enumerate().map(point).collect();
        let pair = ContactPair {
            name: "indenter".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points,
            law: coulomb(mu)?,
        };
        let problem = InterfaceProblem::new(&[&condensed, &rigid], vec![pair])?;
        let push = 0.6 * mu * indenter.force;
        let loads = if indenter.pushed {
            [(0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, -1.0), (0.5, 0.0)]
                .map(|(press, share)| vec![press * indenter.force, share * push])
                .to_vec()
        } else {
            vec![vec![indenter.force, 0.0]]
        };
        Ok((problem, loads))
    }

    fn mesh(&self) -> Result<Mesh, TaskError> {
        let mut rectangle = Rectangle::uniform(
            [-1.0, 1.0],
            [-1.0, 0.0],
            [self.cells, self.cells / 2],
            self.kind,
        )?;
        let width = 2.0 / self.cells as f64;
        if let Defect::Aspect(aspect) = self.defect
            && aspect > 1.0
        {
            let depths = geometric(0.0, 1.0, width / aspect, GROWTH)?;
            rectangle.ys = depths.iter().rev().map(|depth| -depth).collect();
        }
        let mesh = rectangle.generate()?;
        match self.defect {
            Defect::None | Defect::Aspect(_) => Ok(mesh),
            Defect::Distorted(share) => Ok(Mesh::new(distorted(mesh.into_parts(), share * width))?),
            Defect::MidSide(place) => {
                let edges: Vec<_> = mesh
                    .edge_set("top")?
                    .edges
                    .iter()
                    .map(|&edge| {
                        let nodes = mesh.edge_nodes(edge);
                        (nodes.ends, nodes.inner.first().copied())
                    })
                    .collect();
                let mut parts = mesh.into_parts();
                for (ends, mid) in edges {
                    let [start, end] = ends.map(|node| parts.nodes[node]);
                    if let Some(mid) = mid {
                        parts.nodes[mid] =
                            [0, 1].map(|i| (1.0 - place) * start[i] + place * end[i]);
                    }
                }
                Ok(Mesh::new(parts)?)
            }
        }
    }
}

/// The block, held at its bottom and at one corner along x, with a load case for each multiplier of the indenter.
fn held(mesh: &Arc<Mesh>) -> Result<Arc<ElasticBody>, TaskError> {
    let material: Arc<dyn Material> = Arc::new(Isotropic::new(1.0, 0.3, PlaneState::Stress)?);
    let bottom = mesh.node_set("bottom")?.to_vec();
    let x = |node: &usize| mesh.nodes()[*node][0];
    let lowest = bottom.iter().copied().min_by(|a, b| x(a).total_cmp(&x(b)));
    let corner = vec![lowest.ok_or("the block has no bottom")?];
    let support = |(nodes, direction)| Support {
        nodes,
        direction,
        displacement: 0.0,
    };
    let supports = [(bottom, HeldDirection::Y), (corner, HeldDirection::X)].map(support);
    let body = ElasticBody::new(Arc::clone(mesh), vec![material], 1.0)?.with_supports(supports);
    Ok(Arc::new(
        body.with_load_cases(vec![LoadCase::default(); 2])?,
    ))
}

/// Moves the inner corner nodes by up to `reach` along x and y; mid-side and centre nodes follow.
fn distorted(mut parts: MeshParts, reach: f64) -> MeshParts {
    let mut seed: u64 = 1;
    let mut draw = move || {
        // SplitMix64 (Steele, Lea & Flood 2014).
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = seed;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for node in &mut parts.nodes {
        let inside = node[0].abs() < 1.0 - 1e-9 && node[1] < -1e-9 && node[1] > -1.0 + 1e-9;
        let by = [draw(), draw()];
        if inside {
            *node = [node[0] + reach * by[0], node[1] + reach * by[1]];
        }
    }
    for block in &parts.blocks {
        for cell in block.connectivity.chunks_exact(block.kind.nodes()) {
            let corners = block.kind.corners();
            let mean = |nodes: &[usize], all: &[[f64; 2]]| {
                [0, 1].map(|i| {
                    nodes.iter().map(|&node| all[node][i]).sum::<f64>() / nodes.len() as f64
                })
            };
            if block.kind.order() == 2 {
                for k in 0..corners {
                    parts.nodes[cell[corners + k]] =
                        mean(&[cell[k], cell[(k + 1) % corners]], &parts.nodes);
                }
            }
            if let Some(&centre) = cell.get(2 * corners) {
                parts.nodes[centre] = mean(&cell[..corners], &parts.nodes);
            }
        }
    }
    parts
}

fn measured(pressure: &[f64], place: &[f64], quadratic: bool) -> Pressed {
    let peak = pressure.iter().copied().fold(0.0, f64::max);
    let deviation = pressure
        .iter()
        .map(|p| (p / PRESSURE - 1.0).abs())
        .fold(0.0, f64::max);
    let touching = pressure.iter().zip(place).filter(|(p, _)| **p > 0.0);
    let half_width = touching.map(|(_, x)| x.abs()).fold(0.0, f64::max);
    let step = if quadratic { 2 } else { 1 };
    let oscillation = (1..pressure.len().saturating_sub(1))
        .step_by(step)
        .filter(|&k| place[k].abs() < INSIDE * half_width)
        .map(|k| (pressure[k] - f64::midpoint(pressure[k - 1], pressure[k + 1])).abs())
        .fold(0.0, f64::max);
    Pressed {
        peak,
        deviation,
        oscillation: oscillation / peak,
    }
}
