//! Maps of a study's rows.

use stickslip_report::FigureError;
use stickslip_report::map::{Group, OutcomeMap};
use stickslip_report::svg::Svg;

use super::outcome::{Outcome, categories};
use super::row::Row;

/// What a map says besides its cells.
pub(crate) struct Legend<'a> {
    pub(crate) title: &'a str,
    pub(crate) subtitle: &'a str,
    /// Name, symbol and unit of the varied quantity.
    pub(crate) varied: &'a str,
    /// A value of the varied quantity as its column is labelled.
    pub(crate) label: &'a dyn Fn(f64) -> String,
    /// Lines before the first column that reaches a value: case, value, name.
    pub(crate) dividers: &'a [(String, f64, String)],
}

/// The rows as a map: one group per case, one row per method, one column per value, each in the order in which it is first met.
pub(crate) fn map(rows: &[Row], legend: &Legend<'_>) -> Result<Svg, FigureError> {
    let mut columns: Vec<f64> = Vec::new();
    let mut cases: Vec<&str> = Vec::new();
    for row in rows {
        if !columns.contains(&row.value) {
            columns.push(row.value);
        }
        if !cases.contains(&row.case.as_str()) {
            cases.push(&row.case);
        }
    }
    columns.sort_by(f64::total_cmp);
    let groups = cases
        .into_iter()
        .map(|case| group(case, rows, &columns, legend))
        .collect();
    OutcomeMap {
        title: legend.title.into(),
        subtitle: legend.subtitle.into(),
        x_label: legend.varied.into(),
        columns: columns.iter().map(|&value| (legend.label)(value)).collect(),
        groups,
        categories: categories(),
        width: 860.0,
    }
    .render()
}

fn group(case: &str, rows: &[Row], columns: &[f64], legend: &Legend<'_>) -> Group {
    let mut names: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| row.case == case) {
        if !names.contains(&row.method) {
            names.push(row.method);
        }
    }
    let cell = |name: &str, value: f64| {
        let mut own = rows.iter();
        let row = own.find(|row| row.case == case && row.method == name && row.value == value)?;
        Outcome::ALL
            .iter()
            .position(|&outcome| outcome == row.outcome)
    };
    let untried = Outcome::ALL
        .iter()
        .position(|&outcome| outcome == Outcome::NotTried);
    let rows = names
        .into_iter()
        .map(|name| {
            let cells: Vec<_> = columns.iter().map(|&value| cell(name, value)).collect();
            (name.to_owned(), cells)
        })
        .filter(|(_, cells)| cells.iter().flatten().any(|&index| Some(index) != untried))
        .collect();
    let divider = legend.dividers.iter().find(|(of, _, _)| of == case);
    let divider = divider.and_then(|(_, value, name)| {
        let column = columns.iter().position(|column| column >= value)?;
        Some((column, name.clone()))
    });
    Group {
        label: case.to_owned(),
        rows,
        divider,
    }
}

/// A power of ten, or the plain number: 10⁻³, −10⁻⁸, 0, 0.5.
pub(crate) fn power(value: f64) -> String {
    let exponent = value.abs().log10();
    let rounded = exponent.round();
    if value == 0.0 || (exponent - rounded).abs() > 1e-6 || (-1.5..1.5).contains(&rounded) {
        return format!("{value}").replace('-', "−");
    }
    let digits: String = format!("{rounded}")
        .chars()
        .map(|character| match character {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            // The superscripts of 0 and 4 to 9 follow one another.
            digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
        })
        .collect();
    format!("{}10{digits}", if value < 0.0 { "−" } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_short() {
        let texts = [1e-8, -1e-3, 0.0, 1.0, 1e12, 0.25].map(power);
        assert_eq!(texts, ["10⁻⁸", "−10⁻³", "0", "1", "10¹²", "0.25"]);
    }
}
