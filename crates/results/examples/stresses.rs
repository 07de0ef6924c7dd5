//! The von Mises stress and the principal stresses of a plane state.
//!
//! Run with `cargo run --release -p stickslip-results --example stresses`.

use stickslip_results::{principal, von_mises};

fn main() {
    // Pure shear: the principal stresses are ± τ, and the von Mises stress is √3 τ.
    let state = [0.0, 0.0, 100.0];
    let [largest, least] = principal(state);
    let equivalent = von_mises(state, 0.0);
    assert!((equivalent - 173.205).abs() < 1e-3);
    println!("von Mises {equivalent:.1} MPa, principal {largest:.1} and {least:.1} MPa");
}
