//! Places of copies, in the unit and with the digits in which they would be written.

use serde_json::Value;

use super::grid::{Cell, named};
use crate::units::{Dimension, Expected, Length, Quantity, parse, unit_of};

/// Decimal digits of a sum of lengths, one fewer than numbers have.
const DIGITS: i32 = 15;

/// Moves a list of two lengths by as many steps along x and y.
pub(super) fn move_place(place: &mut Value, steps: &[(usize, &Quantity<Length>)]) {
    let Value::Array(parts) = place else {
        return;
    };
    for (part, (count, pitch)) in parts.iter_mut().zip(steps) {
        let moved = part.as_str().and_then(|text| sum(text, *count, pitch));
        // What is no length is refused where it is read.
        if let Some(moved) = moved {
            *part = Value::String(moved);
        }
    }
}

/// Moves the edges of a cut-out, and names them after its cell.
pub(super) fn move_edges(edges: &mut Value, steps: &[(usize, &Quantity<Length>)], cell: Cell) {
    let Value::Array(edges) = edges else {
        return;
    };
    for edge in edges {
        for key in ["to", "through"] {
            if let Some(place) = edge.get_mut(key) {
                move_place(place, steps);
            }
        }
        let points = edge.get_mut("spline").and_then(Value::as_array_mut);
        for place in points.into_iter().flatten() {
            move_place(place, steps);
        }
        if let Some(Value::String(name)) = edge.get_mut("name") {
            *name = named(name, cell);
        }
    }
}

/// `text` and `count` times the pitch, in the unit of `text`.
fn sum(text: &str, count: usize, pitch: &Quantity<Length>) -> Option<String> {
    let (value, _) = parse(text, &Expected::one(Dimension::Length)).ok()?;
    if count == 0 {
        return None;
    }
    let unit = unit_of(text)?;
    let terms = [value, count as f64 * pitch.value()].map(|term| unit.from_base(term));
    Some(format!("{} {}", decimal(terms), unit.name))
}

/// The sum of two numbers, to the digits that the larger has.
fn decimal([a, b]: [f64; 2]) -> f64 {
    let largest = a.abs().max(b.abs());
    if !(largest > 0.0 && largest.is_finite()) {
        return a + b;
    }
    // At most 308 in magnitude.
    let places = (DIGITS - 1 - largest.log10().floor() as i32).max(0) as usize;
    let rounded = format!("{:.places$}", a + b);
    // Zero has no sign.
    rounded.parse::<f64>().unwrap_or(a + b) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_have_the_digits_that_a_person_writes() {
        let pitch = |text: &str| -> Quantity<Length> {
            serde_json::from_value(Value::String(text.to_owned())).unwrap()
        };
        for (from, count, step, to) in [
            ("0 mm", 2, "24 mm", "48 mm"),
            ("0.1 mm", 1, "0.2 mm", "0.3 mm"),
            ("-0.3 in", 3, "0.1 in", "0 in"),
            ("0.375 in", 2, "25.4 mm", "2.375 in"),
            ("1.1 mm", 3, "1.1 mm", "4.4 mm"),
            ("-12 mm", 1, "0 mm", "-12 mm"),
        ] {
            assert_eq!(
                sum(from, count, &pitch(step)).as_deref(),
                Some(to),
                "{from}"
            );
        }
        assert_eq!(sum("0.10 mm", 0, &pitch("1 mm")), None);
        assert_eq!(sum("a while", 1, &pitch("1 mm")), None);
    }
}
