//! Load steps on some of the nodes, of a pin with friction in a strip, beside the same steps on all of them.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use stickslip_contact::deformed::{Curve, CurveEnds, CurveShape};
use stickslip_contact::history::StepRecord;
use stickslip_contact::thinned::{EdgeNodes, Thinned, Whole};
use stickslip_contact::{
    Chain, ContactPair, ContactPoint, DeformedGaps, Facing, Interface, Kinematics, LoadHistory,
    Ramp,
};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_friction::Coulomb;
use stickslip_series::{Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, Nodes, Outline, Plate};

const UNIT: Circle = Circle {
    centre: [0.0, 0.0],
    radius: 1.0,
    thickness: 1.0,
};
const CLEARANCE: f64 = 1e-3;
const FORCE: f64 = 4e-3;
/// Load steps in parts of the largest force.
const STEPS: [f64; 4] = [0.4, 1.0, 0.6, 0.1];

/// A pin in a strip, half of it or the whole.
struct Pin {
    plate: Plate,
    disk: Disk,
    interface: Interface,
    facings: Vec<Facing>,
    edges: Vec<EdgeNodes>,
}

impl Pin {
    /// Its nodes stand at `upper`, from 0 to π, and in the whole at their images.
    fn new(upper: &[f64], half: bool) -> Self {
        let nodes = if half {
            Nodes::mirrored(upper.to_vec()).unwrap()
        } else {
            let lower = upper[1..].iter().rev().map(|angle| -angle);
            let inner = upper[..upper.len() - 1].iter().copied();
            Nodes::circle(lower.chain(inner).collect()).unwrap()
        };
        let metal = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
        let pull = vec![EdgeLoad {
            edge: 3,
            force: [-FORCE, 0.0],
        }];
        let strip = Outline::strip(8.0, 4.0, 3.0);
        let accuracy = Accuracy::default();
        let plate = Plate::new(nodes.clone(), &metal, UNIT, &strip, &[pull], accuracy).unwrap();
        let (pin, facing) = pin(&nodes, &nodes);
        let (weights, means) = (nodes.weights(), nodes.mean_angles());
        let points = means.iter().zip(&weights).enumerate();
        let points = points.map(|(k, (angle, weight))| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal: [angle.cos(), angle.sin()],
            gap: CLEARANCE * (1.0 - angle.cos()),
            area: *weight,
            material_angle: 0.0,
        });
        let pair = ContactPair {
            name: "pin".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points: points.collect(),
            law: Arc::new(Coulomb::new(0.3).unwrap()),
        };
        let angles = nodes.angles().to_vec();
        let bodies: [&dyn InterfaceOperator; 2] = [&plate, &pin];
        Self {
            interface: Interface::new(&bodies, vec![pair]).unwrap(),
            facings: vec![facing],
            edges: vec![EdgeNodes {
                parameter: angles,
                closed: (!half).then_some(TAU),
                mirrored: [half; 2],
            }],
            plate,
            disk: pin,
        }
    }

    fn bodies(&self) -> [&dyn InterfaceOperator; 2] {
        [&self.plate, &self.disk]
    }

    fn kinematics(&self, deformed: bool) -> Kinematics<'_> {
        if !deformed {
            return Kinematics::Small;
        }
        let pairs = self.interface.contacts().pairs();
        let gaps = DeformedGaps::new(&self.bodies(), pairs, &self.facings);
        Kinematics::DeformedGaps(gaps.unwrap())
    }

    fn followed(&self, deformed: bool) -> Vec<StepRecord> {
        let kinematics = self.kinematics(deformed);
        let chain = Chain::default();
        let followed = history().follow_parts(&self.interface, &kinematics, &chain, || {});
        followed.unwrap()
    }

    /// The same with the nodes `chosen` in each step, all points.
    fn thinned(&self, deformed: bool, chosen: impl Fn(usize) -> Vec<usize>) -> Vec<StepRecord> {
        let kinematics = self.kinematics(deformed);
        let (bodies, edges) = (self.bodies(), self.edges.clone());
        let whole = Whole::new(&bodies, &self.interface, &kinematics, edges).unwrap();
        let thinned: Vec<Thinned> = (0..STEPS.len())
            .map(|step| Thinned::new(&whole, &[chosen(step)]).unwrap())
            .collect();
        let wholes = vec![whole; STEPS.len()];
        let thin = history().follow_thinned(&wholes, &thinned, &Chain::default(), || {});
        thin.unwrap().all
    }

    /// The same on all nodes, where those of the pin stand in each step where `facing` puts them.
    fn seated(&self, half: bool, facing: impl Fn(usize, f64) -> f64) -> Vec<StepRecord> {
        let pins = (0..STEPS.len()).map(|step| {
            let hole = self.plate.nodes();
            let angles = hole
                .angles()
                .iter()
                .map(|angle| facing(step, *angle))
                .collect();
            let nodes = if half {
                Nodes::mirrored(angles)
            } else {
                Nodes::circle(angles)
            };
            let (disk, facing) = pin(&nodes.unwrap(), hole);
            (disk, [facing])
        });
        let pins: Vec<(Disk, [Facing; 1])> = pins.collect();
        let pairs = self.interface.contacts().pairs();
        let mut wholes = Vec::new();
        for (disk, facings) in &pins {
            let bodies: [&dyn InterfaceOperator; 2] = [&self.plate, disk];
            let gaps = DeformedGaps::new(&bodies, pairs, facings).unwrap();
            let kinematics = Kinematics::DeformedGaps(gaps);
            let edges = self.edges.clone();
            wholes.push(Whole::new(&bodies, &self.interface, &kinematics, edges).unwrap());
        }
        let all: Vec<usize> = (0..self.edges[0].parameter.len()).collect();
        let thinned = wholes
            .iter()
            .map(|whole| Thinned::new(whole, std::slice::from_ref(&all)).unwrap());
        let thinned: Vec<Thinned> = thinned.collect();
        let thin = history().follow_thinned(&wholes, &thinned, &Chain::default(), || {});
        thin.unwrap().all
    }

    fn pressures(&self, record: &StepRecord) -> Vec<[f64; 2]> {
        let points = self.interface.contacts().points().iter().enumerate();
        points
            .map(|(k, point)| {
                let state = &record.state;
                [state.normal_force(k), state.tangential_force(k)].map(|force| force / point.area)
            })
            .collect()
    }
}

/// The pin with its own `nodes`, and the edges where those of the hole are `hole`.
fn pin(nodes: &Nodes, hole: &Nodes) -> (Disk, Facing) {
    let metal = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    let still = [DiskLoad::default()];
    let disk = Disk::held(nodes.clone(), &metal, UNIT, Anchor::default(), &still).unwrap();
    let ends = if nodes.is_mirrored() {
        CurveEnds::Open {
            mirrored: [true; 2],
        }
    } else {
        CurveEnds::Closed
    };
    // The pin touches at θ = 0, so its centre stands off by the clearance.
    let rim = CurveShape::Circle {
        centre: [CLEARANCE, 0.0],
        radius: 1.0 - CLEARANCE,
    };
    let angles = nodes.angles().to_vec();
    let curve = Curve::new(rim, (0..nodes.len()).collect(), angles, 1, ends).unwrap();
    let means = hole.mean_angles();
    let facing = Facing {
        first: means
            .iter()
            .map(|angle| [angle.cos(), angle.sin()])
            .collect(),
        centre: Some([0.0; 2]),
        second: curve.standing_at(nodes.mean_angles()).unwrap(),
    };
    (disk, facing)
}

fn history() -> LoadHistory {
    let steps = STEPS.iter().map(|part| vec![*part]).collect();
    LoadHistory::new(steps, 3, Ramp::Linear).unwrap()
}

/// Angles that grow and shrink smoothly from 0.8° to 2°.
fn uneven() -> Vec<f64> {
    let count = 140;
    let at = |k: usize| {
        let part = k as f64 / f64::from(count);
        part + 0.07 * (4.0 * PI * part).sin() / PI
    };
    (0..=count as usize).map(|k| PI * at(k)).collect()
}

/// The largest difference of pressures and shears to those of `other`, in parts of the largest pressure.
fn apart(one: &[[f64; 2]], other: &[[f64; 2]]) -> f64 {
    let peak = other.iter().fold(0.0_f64, |peak, own| peak.max(own[0]));
    let both = one.iter().zip(other);
    let differences = both.map(|(a, b)| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()));
    differences.fold(0.0, f64::max) / peak
}

#[test]
fn all_nodes_chosen_change_nothing() {
    for (half, deformed) in [(true, false), (true, true), (false, false), (false, true)] {
        let pin = Pin::new(&uneven(), half);
        let all: Vec<usize> = (0..pin.edges[0].parameter.len()).collect();
        let found = pin.thinned(deformed, |_| all.clone());
        for (found, known) in found.iter().zip(&pin.followed(deformed)) {
            let [found, known] = [found, known].map(|record| pin.pressures(record));
            let apart = apart(&found, &known);
            assert!(apart < 1e-9, "{half} {deformed}: {apart:e}");
        }
    }
}

/// Every second node, the even ones and the odd ones in turn, and few where nothing touches: friction carries over from nodes to others, and bodies balance as on all nodes. A whole pin is
/// free to turn, and held by friction alone.
#[test]
fn states_go_over_to_other_nodes() {
    for (half, deformed) in [(true, false), (true, true), (false, false), (false, true)] {
        let pin = Pin::new(&uneven(), half);
        let angles = &pin.edges[0].parameter;
        let last = angles.len() - 1;
        let zero = angles.iter().position(|angle| *angle == 0.0).unwrap();
        let chosen = |step: usize| -> Vec<usize> {
            let is_chosen = |k: usize| {
                let away = k.abs_diff(zero);
                k == 0 || away == 0 || away % 20 == 0 || away < 80 && away % 2 == step % 2
            };
            (0..=last).filter(|&k| is_chosen(k)).collect()
        };
        let found = pin.thinned(deformed, chosen);
        for (step, (found, known)) in found.iter().zip(&pin.followed(deformed)).enumerate() {
            let sums = [found, known].map(|record| record.audit.pairs[0].resultant[0]);
            let part = STEPS[step] * FORCE;
            assert!((sums[0] - sums[1]).abs() < 2e-6 * part, "{sums:?}");
            let balance = found.audit.balance();
            assert!(balance < 1e-9, "{balance:e}");
            // Within contact and stick, away from their ends, where errors fall with the root of the spacing.
            let status = |k: usize| known.state.status[k.min(last)];
            let inner = |k: usize| {
                let near = k.saturating_sub(8)..=k + 8;
                near.into_iter().all(|near| status(near) == status(k))
            };
            let of = |record: &StepRecord| -> Vec<[f64; 2]> {
                let all = pin.pressures(record).into_iter().enumerate();
                all.filter(|(k, _)| inner(*k)).map(|(_, own)| own).collect()
            };
            let apart = apart(&of(found), &of(known));
            assert!(apart < 4e-3, "{half} {deformed}, step {step}: {apart:e}");
        }
    }
}

/// Where the nodes of the pin stand matters little, and little that they stand elsewhere from step to step: friction remembers where material is, not nodes.
#[test]
fn states_go_over_to_a_pin_with_other_nodes() {
    for half in [true, false] {
        let pin = Pin::new(&uneven(), half);
        let known = pin.followed(true);
        // By up to a fifth of the distance of nodes to and fro.
        let facing = |step: usize, angle: f64| {
            let sign = if step.is_multiple_of(2) { 1.0 } else { -1.0 };
            angle + sign * 3e-3 * angle.sin()
        };
        let found = pin.seated(half, facing);
        for (step, (found, known)) in found.iter().zip(&known).enumerate() {
            let [own, other] = [found, known].map(|record| pin.pressures(record));
            let apart = apart(&own, &other);
            assert!(apart < 4e-3, "{half}, step {step}: {apart:e}");
            let balance = found.audit.balance();
            assert!(balance < 1e-9, "{balance:e}");
        }
    }
}

#[test]
fn choices_that_make_no_hats_are_refused() {
    let pin = Pin::new(&uneven(), true);
    let bodies = pin.bodies();
    let whole = Whole::new(
        &bodies,
        &pin.interface,
        &Kinematics::Small,
        pin.edges.clone(),
    );
    let whole = whole.unwrap();
    for chosen in [vec![0, 1], vec![0, 2, 1], vec![0, 1, 141]] {
        let why = Thinned::new(&whole, &[chosen]).unwrap_err().to_string();
        assert!(why.contains("chosen"), "{why}");
    }
    assert!(Whole::new(&bodies, &pin.interface, &Kinematics::Small, Vec::new()).is_none());
}
