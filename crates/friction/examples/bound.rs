//! What a point carries before and after it slips, by a law with static and dynamic friction.
//!
//! Run with `cargo run --release -p stickslip-friction --example bound`. Stresses in MPa, lengths in mm.

use stickslip_friction::{
    FrictionError, FrictionLaw, History, Place, PointStatus, StaticDynamic, Transition,
};

fn main() -> Result<(), FrictionError> {
    let law = StaticDynamic::new(0.5, 0.3, Transition::Drop)?;
    let place = Place {
        position: [0.0, 0.0],
        tangent: [1.0, 0.0],
        material_angle: 0.0,
    };
    let pressure = 80.0;
    let untouched = History::default();
    let at_first = law.bound(pressure, 0.0, &place, &untouched);
    let slipped = untouched.commit(PointStatus::Slip, 0.02);
    let after = law.bound(pressure, 0.0, &place, &slipped);
    println!("sticks up to {:.1} MPa at first", at_first.stick);
    println!("slips at     {:.1} MPa", at_first.slip);
    println!(
        "sticks up to {:.1} MPa after a slip of 0.02 mm",
        after.stick
    );
    Ok(())
}
