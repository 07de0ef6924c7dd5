//! A pinned plate of elastic–plastic plies.

use stickslip_contact::Chain;
use stickslip_joint::{JointHistory, Options};

use crate::models::plastic;
use crate::plate::{End, Plate};

/// Displacement of the end `[mm]` at which the plies around a quarter of the hole flow.
const PULL: f64 = 0.2;

fn pulled(plate: &Plate, increments: usize) -> JointHistory {
    let options = Options {
        increments,
        tolerance: 1e-11,
        ..Options::default()
    };
    plate
        .joint(&plastic("[0/45/-45/90]s", 0.005), End::Driven)
        .with_options(options)
        .unwrap()
        .follow(&[vec![PULL]], &Chain::newton_first(), |_, _| {})
        .unwrap()
}

/// The consistent tangent shows: once the contact has settled, each residual is of the order of the square of the one before.
#[test]
fn newton_converges_quadratically() {
    let plate = Plate {
        friction: 0.0,
        ..Plate::default()
    };
    let history = pulled(&plate, 2);
    for record in &history.records {
        println!("{:.1} {:?}", record.load, record.residuals);
    }
    let last = &history.records[1].residuals;
    assert!(last.len() <= 8, "{last:?}");
    let settled = last
        .windows(2)
        .filter(|pair| pair[0] < 1e-2 && pair[1] > 1e-13);
    assert!(settled.clone().count() >= 1);
    for pair in settled {
        assert!(pair[1] < 50.0 * pair[0] * pair[0], "{last:?}");
    }
}

/// The implicit step is of first order: halving the increments halves the change of the load at the end. The energy balance
/// closes with the increments as well, and what is dissipated never falls.
#[test]
fn the_load_converges_with_the_increments() {
    let plate = Plate::default();
    let mut loads = Vec::new();
    let mut imbalances = Vec::new();
    for increments in [4, 8, 16, 32] {
        let history = pulled(&plate, increments);
        let last = &history.records[history.records.len() - 1];
        let dissipated = history.records.iter().map(|r| r.energy.dissipated);
        assert!(dissipated.collect::<Vec<_>>().is_sorted());
        assert!(last.energy.friction > 0.0 && last.energy.dissipated > 0.0);
        assert_eq!(last.energy.released, 0.0);
        loads.push(last.load);
        imbalances.push(last.energy.imbalance().abs());
    }
    let changes: Vec<f64> = loads.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    let rates: Vec<f64> = changes.windows(2).map(|w| (w[0] / w[1]).log2()).collect();
    println!("loads {loads:?}\nrates {rates:.2?}\nimbalance {imbalances:?}");
    assert!(changes[2] < 1e-3 * loads[3]);
    assert!(rates.iter().all(|rate| *rate > 0.7), "{rates:?}");
    assert!(imbalances.windows(2).all(|w| w[1] < 0.7 * w[0]));
    assert!(imbalances[3] < 0.01);
}
