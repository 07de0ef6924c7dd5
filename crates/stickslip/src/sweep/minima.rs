//! Where numbers are least along an axis, and whether their errors say so.
//!
//! Along every axis with numbers, the others fixed, the least value of a number lies at one of the cases; where that is neither the first nor the last, it is a minimum of the
//! design. It is *open* where a neighbour may be as low: v + error ≥ v′ − error′.

use std::collections::BTreeMap;

use super::Sweep;
use super::row::{Measures, Row};

/// A number with its error.
type Stated = fn(&Measures) -> Option<[f64; 2]>;

/// The numbers whose minima are looked for, by the names of their columns; of loads the magnitudes.
const NUMBERS: [(&str, Stated); 4] = [
    ("peak_pressure", |own| {
        Some([own.peak_pressure?, own.errors.peak_pressure?])
    }),
    ("peak_hoop", |own| {
        Some([own.peak_hoop?[0], own.errors.peak_hoop?])
    }),
    ("first_ply_load", |own| {
        let first = own.first_ply.as_ref()?;
        Some([first.load?.abs(), first.load_error?])
    }),
    ("joint_load", |own| {
        let joint = own.joint.as_ref()?;
        Some([joint.load?.abs(), joint.load_error?])
    }),
];

/// The least value of a number along an axis, away from its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimum<'a> {
    /// Column of the number.
    pub number: &'static str,
    /// Index of the axis.
    pub axis: usize,
    /// The case.
    pub case: usize,
    /// Value and error, in the unit of the column.
    pub value: [f64; 2],
    /// Unit of the column.
    pub unit: &'a str,
    /// Whether a neighbour may be as low, by the errors of both.
    pub is_open: bool,
}

/// The minima of all numbers with errors along all axes with numbers, those of one axis together.
pub fn minima<'a>(sweep: &'a Sweep, rows: &[Row]) -> Vec<Minimum<'a>> {
    let by_case: BTreeMap<usize, &Row> = rows.iter().map(|row| (row.case, row)).collect();
    let mut found = Vec::new();
    for (axis, own) in sweep.axes.iter().enumerate() {
        let Some(numbers) = &own.numbers else {
            continue;
        };
        let mut order: Vec<usize> = (0..numbers.len()).collect();
        order.sort_by(|&a, &b| numbers[a].total_cmp(&numbers[b]));
        let starts = (0..sweep.cases()).filter(|&case| sweep.values_of(case)[axis] == order[0]);
        for start in starts {
            let line: Vec<Option<&Row>> = (order.iter())
                .map(|&value| {
                    by_case
                        .get(&case_beside(sweep, start, (axis, value)))
                        .copied()
                })
                .collect();
            found.extend(NUMBERS.iter().filter_map(|&(number, stated)| {
                let (case, value, is_open) = minimum(&line, stated)?;
                Some(Minimum {
                    number,
                    axis,
                    case,
                    value,
                    unit: if number.ends_with("load") {
                        &sweep.load_unit
                    } else {
                        sweep.scene.display.stress.name
                    },
                    is_open,
                })
            }));
        }
    }
    found
}

/// The case that differs from `case` by having `value` on the axis alone.
fn case_beside(sweep: &Sweep, case: usize, (axis, value): (usize, usize)) -> usize {
    let mut values = sweep.values_of(case);
    values[axis] = value;
    let digits = sweep.axes.iter().zip(values);
    digits.fold(0, |case, (axis, value)| axis.values.len() * case + value)
}

/// Case, value and openness of the least number of a line of cases. A neighbour without an answer may be as low.
fn minimum(line: &[Option<&Row>], stated: Stated) -> Option<(usize, [f64; 2], bool)> {
    let number = |row: Option<&Row>| stated(row?.measures()?);
    let values: Vec<Option<[f64; 2]>> = line.iter().copied().map(number).collect();
    let known = values.iter().enumerate();
    let known = known.filter_map(|(at, value)| Some((at, (*value)?)));
    let (at, [value, error]) = known.min_by(|a, b| a.1[0].total_cmp(&b.1[0]))?;
    let neighbours = [values.get(at.checked_sub(1)?)?, values.get(at + 1)?];
    let as_low =
        |other: &Option<[f64; 2]>| other.is_none_or(|[other, own]| value + error >= other - own);
    let case = line[at]?.case;
    Some((case, [value, error], neighbours.into_iter().any(as_low)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::row::{MeasureErrors, Outcome};

    fn row(case: usize, value: f64, error: f64) -> Row {
        Row {
            case,
            seconds: 0.0,
            outcome: Outcome::Solved(Box::new(Measures {
                peak_pressure: Some(value),
                errors: MeasureErrors {
                    peak_pressure: Some(error),
                    ..MeasureErrors::default()
                },
                ..Measures::default()
            })),
        }
    }

    fn found(values: &[[f64; 2]]) -> Option<(usize, bool)> {
        let rows: Vec<Row> = (values.iter().enumerate())
            .map(|(case, &[value, error])| row(case, value, error))
            .collect();
        let line: Vec<Option<&Row>> = rows.iter().map(Some).collect();
        minimum(&line, NUMBERS[0].1).map(|(case, _, is_open)| (case, is_open))
    }

    #[test]
    fn a_minimum_within_the_errors_of_its_neighbours_is_open() {
        assert_eq!(
            found(&[[3.0, 0.1], [1.0, 0.1], [2.0, 0.1]]),
            Some((1, false))
        );
        assert_eq!(
            found(&[[3.0, 0.1], [1.0, 0.6], [2.0, 0.5]]),
            Some((1, true))
        );
        // At an end it is no minimum of the design.
        assert_eq!(found(&[[1.0, 0.1], [2.0, 0.1], [3.0, 0.1]]), None);
        assert_eq!(found(&[[1.0, 0.1]]), None);
        // A neighbour without an answer leaves it open.
        let rows = [row(0, 3.0, 0.1), row(1, 1.0, 0.1)];
        let line = [Some(&rows[0]), Some(&rows[1]), None];
        let open = minimum(&line, NUMBERS[0].1).map(|(case, _, is_open)| (case, is_open));
        assert_eq!(open, Some((1, true)));
    }
}
