//! Numbers with their units.

use stickslip_scene::units::Unit;
use stickslip_text::short;

/// A value of base units in `unit`.
pub(crate) fn shown(unit: &Unit, value: f64) -> String {
    format!("{} {}", short(unit.from_base(value)), unit.name)
}
