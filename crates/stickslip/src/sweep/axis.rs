//! The axes of a sweep, and the scene keys that they set.
//!
//! With D the diameter of the hole, e the distance from its centre to the end that the pin pushes towards, W the width:
//!
//! ```text
//! e_over_d    bodies.PLATE.shape.plate_with_hole.outline.strip.right        = (e/D) D
//! w_over_d    bodies.PLATE.shape.plate_with_hole.outline.strip.half_width   = (W/D) D / 2
//! clearance   bodies.PIN.shape.disk.radius                                  = D/2 − clearance
//! mu          contacts.N.friction                                           = { coulomb = { mu } }
//! layup       materials.MATERIAL.laminate.layup
//! ```
//!
//! PLATE and PIN are the first and the second body of the joint's contact, MATERIAL is the plate's. D is that of the case: another
//! axis may set `hole_radius`. Any other key is one of the scene, as `--set` names it.

use serde_json::Value;

use stickslip_scene::units::{Dimension, Expected, Unit, parse, unit_of};

/// What an axis varies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AxisKey {
    /// End distance over hole diameter.
    EndDistance,
    /// Width over hole diameter.
    Width,
    /// Radius of the hole less that of the pin.
    Clearance,
    /// Coulomb's coefficient of friction.
    Friction,
    /// Lay-up of the plate.
    LayUp,
    /// Any key of the scene.
    Scene(String),
}

impl AxisKey {
    /// Names that are no keys of a scene.
    pub const NAMES: [&'static str; 5] = ["e_over_d", "w_over_d", "clearance", "mu", "layup"];

    /// The axis called `name`.
    pub fn named(name: &str) -> Self {
        match name {
            "e_over_d" => Self::EndDistance,
            "w_over_d" => Self::Width,
            "clearance" => Self::Clearance,
            "mu" => Self::Friction,
            "layup" => Self::LayUp,
            key => Self::Scene(key.to_owned()),
        }
    }

    /// Its name in sweep files and tables.
    pub fn name(&self) -> &str {
        match self {
            Self::EndDistance => Self::NAMES[0],
            Self::Width => Self::NAMES[1],
            Self::Clearance => Self::NAMES[2],
            Self::Friction => Self::NAMES[3],
            Self::LayUp => Self::NAMES[4],
            Self::Scene(key) => key,
        }
    }

    /// Its name on figures.
    fn symbol(&self) -> &str {
        match self {
            Self::EndDistance => "e/D",
            Self::Width => "W/D",
            Self::Clearance => "radial clearance",
            Self::Friction => "μ",
            Self::LayUp => "lay-up",
            Self::Scene(key) => key,
        }
    }

    /// What an axis's name is given with on figures that have room for it.
    fn long_name(&self) -> String {
        match self {
            Self::EndDistance => "End distance over hole diameter e/D".to_owned(),
            Self::Width => "Width over hole diameter W/D".to_owned(),
            Self::Clearance => "Radial clearance".to_owned(),
            Self::Friction => "Coefficient of friction μ".to_owned(),
            Self::LayUp => "Lay-up".to_owned(),
            Self::Scene(key) => key.clone(),
        }
    }
}

/// One axis with its values.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it varies.
    pub key: AxisKey,
    /// Name on figures, if the file gives one.
    pub label: Option<String>,
    /// Its values as the file has them, at least one.
    pub values: Vec<Value>,
    /// Its values as numbers in [`unit`](Self::unit), where all of them are numbers, or quantities of one dimension.
    pub numbers: Option<Vec<f64>>,
    /// Unit of the numbers: that of the first value.
    pub unit: Option<&'static Unit>,
}

impl Axis {
    pub(super) fn new(key: AxisKey, label: Option<String>, values: Vec<Value>) -> Self {
        let read: Option<Vec<(f64, Option<&'static Unit>)>> = values.iter().map(number).collect();
        let (mut numbers, mut unit) = (None, None);
        if let Some(read) = read {
            unit = read.first().and_then(|(_, unit)| *unit);
            let dimension = |unit: Option<&'static Unit>| unit.map(|unit| unit.dimension);
            if read
                .iter()
                .all(|(_, own)| dimension(*own) == dimension(unit))
            {
                let value = |(value, _): &(f64, _)| {
                    unit.map_or(*value, |unit| tidy(unit.from_base(*value)))
                };
                numbers = Some(read.iter().map(value).collect());
            } else {
                unit = None;
            }
        }
        Self {
            key,
            label,
            values,
            numbers,
            unit,
        }
    }

    /// A value as tables have it, without the unit that the heading names.
    pub fn cell(&self, index: usize) -> String {
        match (&self.numbers, self.values.get(index)) {
            (Some(numbers), _) => numbers.get(index).map_or_else(String::new, f64::to_string),
            (None, Some(value)) => plain(value),
            (None, None) => String::new(),
        }
    }

    /// A value for a reader, with its unit.
    pub fn value_text(&self, index: usize) -> String {
        match self.unit {
            Some(unit) => format!("{} {}", self.cell(index), unit.name),
            None => self.cell(index),
        }
    }

    /// Heading of its column: `clearance [mm]`.
    pub fn heading(&self) -> String {
        match self.unit {
            Some(unit) => format!("{} [{}]", self.key.name(), unit.name),
            None => self.key.name().to_owned(),
        }
    }

    /// Its short name on figures: "e/D".
    pub fn symbol(&self) -> &str {
        self.label.as_deref().unwrap_or_else(|| self.key.symbol())
    }

    /// Its name for an axis of a figure, with its unit.
    pub fn title(&self) -> String {
        let name = self.label.clone().unwrap_or_else(|| self.key.long_name());
        match (self.unit, &self.numbers) {
            (Some(unit), _) => format!("{name} [{}]", unit.name),
            (None, Some(_)) => format!("{name} [–]"),
            (None, None) => name,
        }
    }

    /// "e/D = 2".
    pub fn assignment(&self, index: usize) -> String {
        format!("{} = {}", self.symbol(), self.value_text(index))
    }
}

/// `count` values from `from` to `to`, in equal steps: numbers, or quantities in the unit of `from`. `None` for ends that are neither,
/// or are not alike, and for a `count` below 2.
pub(super) fn between(from: &Value, to: &Value, count: usize) -> Option<Vec<Value>> {
    let ((low, unit), (high, other)) = (number(from)?, number(to)?);
    if unit.map(|unit| unit.dimension) != other.map(|unit| unit.dimension) || count < 2 {
        return None;
    }
    let value = |k: usize| {
        let part = k as f64 / (count - 1) as f64;
        let value = (1.0 - part) * low + part * high;
        match unit {
            Some(unit) => Value::String(format!("{} {}", tidy(unit.from_base(value)), unit.name)),
            None => Value::from(tidy(value)),
        }
    };
    Some((0..count).map(value).collect())
}

/// A number, or a quantity in base units with the unit that it is written in; of a list, its only entry.
fn number(value: &Value) -> Option<(f64, Option<&'static Unit>)> {
    match value {
        Value::Number(number) => Some((number.as_f64()?, None)),
        Value::String(text) => {
            let (value, _) = parse(text, &Expected::any(&Dimension::ALL)).ok()?;
            Some((value, unit_of(text)))
        }
        Value::Array(list) => match list.as_slice() {
            [only] => number(only),
            _ => None,
        },
        _ => None,
    }
}

/// `value` to twelve digits, so that 0.1 + 0.2 is 0.3.
pub(super) fn tidy(value: f64) -> f64 {
    // Formatted by this function's own pattern, so it is a number.
    format!("{value:.11e}").parse().unwrap_or(value)
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(list) => {
            let entries: Vec<String> = list.iter().map(plain).collect();
            entries.join("; ")
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn axis(name: &str, values: Value) -> Axis {
        let Value::Array(values) = values else {
            return Axis::new(AxisKey::named(name), None, vec![values]);
        };
        Axis::new(AxisKey::named(name), None, values)
    }

    #[test]
    fn quantities_are_numbers_in_the_unit_of_the_first() {
        let clearance = axis("clearance", json!(["0.01 mm", "20 um", "0.001 in"]));
        assert_eq!(clearance.heading(), "clearance [mm]");
        assert_eq!(clearance.cell(1), "0.02");
        assert_eq!(clearance.cell(2), "0.0254");
        assert_eq!(clearance.assignment(1), "radial clearance = 0.02 mm");
        let steps = axis("loads.0.force.steps", json!([["1 kN"], ["2 kN"]]));
        assert_eq!(steps.heading(), "loads.0.force.steps [kN]");
        assert_eq!(steps.numbers, Some(vec![1.0, 2.0]));
    }

    #[test]
    fn what_is_no_number_stays_a_text() {
        let mixed = axis("clearance", json!(["0.01 mm", "20 N"]));
        assert_eq!((mixed.numbers.clone(), mixed.unit.is_none()), (None, true));
        assert_eq!(mixed.cell(1), "20 N");
        let layup = axis("layup", json!(["[0/90]s"]));
        assert_eq!(
            (layup.cell(0).as_str(), layup.title().as_str()),
            ("[0/90]s", "Lay-up")
        );
        let law = axis("contacts.0.friction", json!([{"coulomb": {"mu": 0.1}}]));
        assert_eq!(law.cell(0), r#"{"coulomb":{"mu":0.1}}"#);
    }

    #[test]
    fn ranges_have_both_their_ends() {
        let values = between(&json!(0.1), &json!(0.4), 4);
        assert_eq!(
            values,
            Some(vec![json!(0.1), json!(0.2), json!(0.3), json!(0.4)])
        );
        let values = between(&json!("10 um"), &json!("0.03 mm"), 3);
        assert_eq!(
            values,
            Some(vec![json!("10 um"), json!("20 um"), json!("30 um")])
        );
        assert_eq!(between(&json!("10 um"), &json!(3), 3), None);
        assert_eq!(between(&json!("ten"), &json!(3), 3), None);
    }
}
