//! A modulus of elasticity in base units, and what is said of a length in its place.
//!
//! Run with `cargo run --release -p stickslip-units --example convert`.

use stickslip_units::{Dimension, Expected, UnitError, parse};

fn main() -> Result<(), UnitError> {
    let stress = Expected::one(Dimension::Stress);
    let (modulus, _) = parse("10.4 Msi", &stress)?;
    // 1 psi is 6.894757 kPa.
    assert!((modulus - 71_705.47).abs() < 0.01);
    println!("10.4 Msi is {modulus:.2} MPa");
    if let Err(error) = parse("2 in", &stress) {
        println!("{error}");
    }
    Ok(())
}
