//! stickslip.
pub mod units;
