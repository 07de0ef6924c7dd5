//! A pinned plate whose plies fail at once.

use std::time::Instant;

use stickslip_contact::Chain;
use stickslip_joint::{Ending, Halt, JointBody, JointHistory, Options, damage_map};

use crate::models::discount;
use crate::plate::{End, Plate};

fn options() -> Options {
    Options {
        increments: 25,
        ..Options::default()
    }
}

fn narrow() -> Plate {
    Plate {
        half_width: 6.0,
        cells: 12,
        layers: 5,
        ..Plate::default()
    }
}

fn driven() -> JointHistory {
    narrow()
        .joint(&discount("[0/45/-45/90]s"), End::Driven)
        .with_options(options())
        .unwrap()
        .follow(&[vec![0.4]], &Chain::newton_first(), |_, _| {})
        .unwrap()
}

/// A driven end carries the curve past the peak to final failure. The balance of energies closes to the rounding of the linear
/// pieces, save for what friction does to the trapezoidal rule.
#[test]
fn a_driven_end_passes_the_peak() {
    let clock = Instant::now();
    let history = driven();
    let seconds = clock.elapsed().as_secs_f64();
    let peak = &history.records[history.peak()];
    println!(
        "{seconds:.2} s, {} factorisations, {:?}",
        history.factorisations, history.ending
    );
    assert!(matches!(history.ending, Ending::LoadDropped { .. }));
    assert_eq!(history.strength(), Some(peak.load));
    assert_eq!(history.first_peak(0.3), Some(history.peak()));
    assert!(history.first_peak(0.9).is_none());
    let first = history.first_failure().unwrap();
    assert!(first.load < 0.7 * peak.load && first.pass == 0);
    for record in &history.records {
        assert!(record.energy.imbalance().abs() < 1e-2);
        assert!(record.energy.released >= 0.0);
    }
    // Elastic increments share one factorisation.
    let elastic = history.records.iter().take_while(|r| r.events.is_empty());
    assert_eq!(elastic.map(|r| r.factorisations).sum::<usize>(), 1);
}

/// Each event is in the map of its ply, and nothing else is.
#[test]
fn the_damage_map_is_what_the_events_made() {
    let plate = narrow();
    let joint = plate.joint(&discount("[0/45/-45/90]s"), End::Driven);
    let history = joint
        .follow(&[vec![0.15]], &Chain::newton_first(), |_, _| {})
        .unwrap();
    let JointBody::Progressive(body) = &joint.bodies()[0] else {
        panic!("the plate has a history");
    };
    let map = damage_map(body, &history.state.bodies[0].points);
    assert_eq!(map.len(), 8);
    for (layer, ply) in map.iter().enumerate() {
        let mut broken: Vec<usize> = (history.events())
            .filter(|event| event.layer == layer)
            .map(|event| event.point)
            .collect();
        broken.sort_unstable();
        broken.dedup();
        let mut known: Vec<usize> = ply.matrix.iter().chain(&ply.fibre).copied().collect();
        known.sort_unstable();
        assert_eq!(broken, known);
        assert!(ply.yielded.is_empty());
    }
    assert_eq!(map[0].matrix, map[7].matrix);
}

/// Under given loads the same plate snaps where the driven one passes its peak: the load reached is the strength.
#[test]
fn given_loads_end_at_the_strength() {
    let peak = driven().strength().unwrap();
    let joint = narrow()
        .joint(&discount("[0/45/-45/90]s"), End::Loaded)
        .with_options(options())
        .unwrap();
    let history = joint
        .follow(&[vec![2.0 * peak]], &Chain::newton_first(), |_, _| {})
        .unwrap();
    let strength = history.strength().unwrap();
    println!(
        "driven {peak:.1}, loaded {strength:.1}: {:?}",
        history.ending
    );
    let Ending::NoEquilibrium { reached, cause, .. } = &history.ending else {
        panic!("{:?}", history.ending);
    };
    assert!(matches!(
        cause,
        Halt::LoadPathLost { .. } | Halt::Cascade { .. }
    ));
    assert!((reached * 2.0 * peak / strength - 1.0).abs() < 1e-9);
    // Two ways to bear load beside the peak: they differ by what fails first where the load is spread differently.
    assert!((strength / peak - 1.0).abs() < 0.1);
}

/// The same bits twice, and whatever was observed on the way.
#[test]
fn histories_repeat() {
    let (a, b) = (driven(), driven());
    assert_eq!(a.records.len(), b.records.len());
    for (x, y) in a.records.iter().zip(&b.records) {
        assert_eq!(x.load.to_bits(), y.load.to_bits());
        assert_eq!(x.events, y.events);
    }
}

/// The cure's residual stresses pull the plies across their fibres, so the first one fails earlier; without load nothing moves.
#[test]
fn residual_stress_breaks_the_first_ply_earlier() {
    let plate = narrow();
    let model = discount("[0/45/-45/90]s");
    let mut loads = Vec::new();
    for temperature in [0.0, -60.0] {
        let joint = plate.joint_at(&model, End::Driven, temperature);
        let history = joint
            .follow(&[vec![0.0], vec![0.08]], &Chain::newton_first(), |_, _| {})
            .unwrap();
        assert!(history.records[0].load.abs() < 1e-9);
        loads.push(history.first_failure().unwrap().load);
    }
    println!("first ply failure {loads:.1?} N");
    assert!(loads[1] < 0.95 * loads[0]);
}
