//! Prints numbers as tables and sentences show them.
//!
//! Run with `cargo run --release -p stickslip-text --example numbers`.

use stickslip_text::{counted, short, significant};

fn main() {
    println!("{} of {}", counted(1, "step"), counted(14, "step"));
    for value in [1234.5678, 0.000_123_4, 2.0] {
        println!("{} {}", short(value), significant(value, 3));
    }
}
