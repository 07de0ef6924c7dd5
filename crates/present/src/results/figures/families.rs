//! One quantity over the edge for all load steps: loading blue, from light to dark, unloading orange, from dark to light.

use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, Legend, LineChart, Panels, Series};
use stickslip_report::color::{Color, loading_sequence, sequence, unloading_sequence};
use stickslip_report::svg::Svg;

use super::edge::{around_contact, curve, margin, place_axis};
use super::{last_largest, margin_remark};
use crate::results::attempt::Attempt;
use crate::results::display::{EdgeView, even};
use crate::results::zones::contact_reach;
use stickslip_results::{EdgeRow, RowErrors};
use stickslip_text::{decimals, significant};

/// Steps up to which every curve has its own entry in the legend: as many as stand beside one chart.
const NAMED_STEPS: usize = 24;
/// Intervals between ticks under a panel.
const TICK_INTERVALS: f64 = 8.0;
/// Part of the edge that is shown, in extents of all contact.
const REACH: f64 = 1.12;

/// A quantity of a row, with what the axis and the caption call it.
struct Quantity {
    title: &'static str,
    symbol: String,
    value: fn(&EdgeRow) -> f64,
    error: fn(&RowErrors) -> f64,
    /// Whether only the contact is of interest.
    near_contact: bool,
}

/// CPRESS of all steps.
pub(super) fn pressure(view: &EdgeView<'_>) -> Attempt {
    let quantity = Quantity {
        title: "Contact pressure",
        symbol: "CPRESS".into(),
        value: |row| row.pressure,
        error: |errors| errors.pressure,
        near_contact: true,
    };
    let peak = largest(view, |step| view.step(step).peak_pressure);
    family(
        view,
        &quantity,
        peak_sentence(view, "The largest pressure", peak),
    )
}

/// CSHEAR1 of all steps.
pub(super) fn shear(view: &EdgeView<'_>) -> Attempt {
    let quantity = Quantity {
        title: "Friction traction",
        symbol: "CSHEAR1".into(),
        value: |row| row.shear,
        error: |errors| errors.shear,
        near_contact: true,
    };
    let peak = largest(view, |step| largest_shear(view, step));
    if peak.is_some_and(|(_, shear, _)| shear == 0.0) {
        return Ok(None);
    }
    family(
        view,
        &quantity,
        peak_sentence(view, "The largest friction traction", peak),
    )
}

/// The largest friction traction of a step and its place; of equal ones on both sides that at the larger angle.
fn largest_shear(view: &EdgeView<'_>, step: usize) -> Option<(f64, f64)> {
    const ROUNDING: f64 = 1e-7;
    let rows = view.step(step).rows.iter().map(|row| row.shear);
    let most = rows.clone().map(f64::abs).reduce(f64::max)?;
    let side = if view.geometry.frame.clockwise {
        -1.0
    } else {
        1.0
    };
    let high = rows
        .zip(&view.geometry.parameter)
        .filter(|(shear, _)| shear.abs() >= most * (1.0 - ROUNDING));
    high.map(|(shear, &place)| (side * shear, place))
        .max_by(|a, b| view.place(a.1).total_cmp(&view.place(b.1)))
}

/// σ_θ or σ_xx of all steps.
pub(super) fn hoop(view: &EdgeView<'_>) -> Attempt {
    let symbol = view.stress_symbols()[1];
    let quantity = Quantity {
        title: if view.is_circle() {
            "Hoop stress"
        } else {
            "Stress along the edge"
        },
        symbol: symbol.into(),
        value: |row| row.sigma_tangential,
        error: |errors| errors.sigma_tangential,
        near_contact: !view.is_circle(),
    };
    let peak = largest(view, |step| view.step(step).peak_hoop);
    family(
        view,
        &quantity,
        peak_sentence(view, &format!("The largest {symbol}"), peak),
    )
}

/// The step, value and place of the largest magnitude.
fn largest(
    view: &EdgeView<'_>,
    of_step: impl Fn(usize) -> Option<(f64, f64)>,
) -> Option<(usize, f64, f64)> {
    let steps = (0..view.results().steps.len())
        .filter_map(|step| of_step(step).map(|(value, place)| (step, value, place)));
    last_largest(steps, |(_, value, _)| value.abs())
}

fn peak_sentence(
    view: &EdgeView<'_>,
    name: &str,
    peak: Option<(usize, f64, f64)>,
) -> Option<String> {
    peak.map(|(step, value, place)| {
        let unit = view.units().stress.name;
        let stress = significant(view.stress(value), 4);
        let over = view.bearing(step).map_or(String::new(), |bearing| {
            format!(
                ", {} times the bearing stress",
                decimals(Some(value / bearing), 2)
            )
        });
        let load = view.load().text(step);
        format!(
            "{name} of all steps is {stress} {unit}{over}, at {load} and {}.",
            view.at(place)
        )
    })
}

fn family(view: &EdgeView<'_>, quantity: &Quantity, peak: Option<String>) -> Attempt {
    let results = view.results();
    if results.steps.len() < 2 {
        return Ok(None);
    }
    let unit = view.units().stress.name;
    let over_bearing = view.geometry.contact && view.bears();
    let title = format!(
        "{} on '{}' in every load step",
        quantity.title, view.geometry.name
    );
    let absolute = chart(
        view,
        quantity,
        format!("{} [{unit}]", quantity.symbol),
        |_, value| Some(view.stress(value)),
    );
    let picture = if over_bearing {
        let label = format!("{} / bearing stress σ_b of the step [–]", quantity.symbol);
        let relative = chart(view, quantity, label, |step, value| {
            view.bearing(step).map(|bearing| value / bearing)
        });
        side_by_side(&title, absolute, relative)?
    } else {
        LineChart {
            title,
            ..absolute.legend(Legend::Right).size(760.0, 0.6)
        }
        .render()?
    };
    let mut sentences = what_is_seen(view, quantity, over_bearing);
    sentences.extend(peak);
    sentences.extend(margin_remark(view));
    Ok(Some((picture, sentences.join(" "))))
}

fn side_by_side(
    title: &str,
    mut left: LineChart,
    mut right: LineChart,
) -> Result<Svg, FigureError> {
    left.title = "(a) in stress".into();
    right.title = "(b) relative to the bearing stress of each step".into();
    let charts = vec![left, right]
        .into_iter()
        .map(|chart| chart.size(520.0, 0.8))
        .collect();
    Panels::new(title, 2, charts).common_legend().render()
}

fn what_is_seen(view: &EdgeView<'_>, quantity: &Quantity, over_bearing: bool) -> Vec<String> {
    let falls = view.load().unloading();
    let (count, falling) = (falls.len(), falls.iter().filter(|falls| **falls).count());
    let order = if falling > 0 {
        let rising = count - falling;
        format!(
            "{rising} steps of rising load (blue, solid) and {falling} of falling load (orange, dashed)"
        )
    } else {
        format!("{count} load steps, from dark to light")
    };
    let parts = if over_bearing {
        ": (a) in stress, (b) over the bearing stress of the same step"
    } else {
        ""
    };
    let mut sentences = vec![format!(
        "{} {} in {order}{parts}.",
        quantity.title, quantity.symbol
    )];
    if count > NAMED_STEPS {
        sentences.push(format!(
            "The legend names {NAMED_STEPS} of the {count} steps; the shades of the others lie between."
        ));
    }
    let reaches = || (0..count).filter_map(|step| contact_reach(view, step));
    let halves = || reaches().map(|[start, end]| 0.5 * (end - start));
    let ends = halves().reduce(f64::min).zip(halves().reduce(f64::max));
    if let Some((low, high)) = ends.filter(|_| quantity.near_contact) {
        let (low, high) = (view.shown(low), view.shown(high));
        sentences.push(if reaches().all(even) {
            format!("The half-extent of contact lies between {low} and {high}.")
        } else {
            format!("Half of what contact reaches over lies between {low} and {high}.")
        });
    }
    sentences
}

fn chart(
    view: &EdgeView<'_>,
    quantity: &Quantity,
    label: String,
    scaled: impl Fn(usize, f64) -> Option<f64>,
) -> LineChart {
    let window = around_contact(view, REACH).filter(|_| quantity.near_contact);
    let mut chart = LineChart::new(
        "",
        place_axis(view, window, TICK_INTERVALS),
        Axis::linear(label),
    );
    for (step, look) in looks(view).into_iter().enumerate() {
        let shown = |value: f64| scaled(step, value).unwrap_or(f64::NAN);
        let points = curve(view, step, |row| shown((quantity.value)(row)));
        let margin = margin(view, step, &points, |errors| {
            shown((quantity.error)(errors))
        });
        let series = Series::new(look.label, points)
            .margin(margin)
            .color(look.color)
            .dash(look.dash)
            .width(1.6);
        chart = chart.with(series);
    }
    chart
}

/// How the curve of a step looks.
struct Look {
    label: String,
    color: Color,
    dash: Dash,
}

/// Looks of all steps; the legend names each, or of many steps the first, the last and some between.
fn looks(view: &EdgeView<'_>) -> Vec<Look> {
    let load = view.load();
    let falls = load.unloading();
    let count = falls.len();
    let falling = falls.iter().filter(|falls| **falls).count();
    let mut rising_colors = if falling > 0 {
        loading_sequence(count - falling)
    } else {
        sequence(count)
    }
    .into_iter();
    let mut falling_colors = unloading_sequence(falling).into_iter();
    let named = named_steps(&falls);
    let black = Color::rgb(0, 0, 0);
    (0..count)
        .map(|step| {
            let colors = if falls[step] {
                &mut falling_colors
            } else {
                &mut rising_colors
            };
            let branch = match (falling > 0, falls[step]) {
                (false, _) => ",",
                (true, false) => " ↑",
                (true, true) => " ↓",
            };
            let label = || {
                if load.is_load() {
                    format!("step {}{branch} {}", step + 1, load.text(step))
                } else {
                    load.text(step)
                }
            };
            Look {
                label: if named[step] { label() } else { String::new() },
                // Both sequences have as many colours as steps of their kind.
                color: colors.next().unwrap_or(black),
                dash: if falls[step] {
                    Dash::Dashed
                } else {
                    Dash::Solid
                },
            }
        })
        .collect()
}

/// Which steps the legend names: all, or of many the first and last of each branch and as many between as there is room for.
fn named_steps(falls: &[bool]) -> Vec<bool> {
    let count = falls.len();
    if count <= NAMED_STEPS {
        return vec![true; count];
    }
    let mut named = vec![false; count];
    let branches = if falls.contains(&true) {
        vec![false, true]
    } else {
        vec![false]
    };
    let share = NAMED_STEPS / branches.len();
    for branch in branches {
        let steps: Vec<usize> = (0..count).filter(|&step| falls[step] == branch).collect();
        let chosen = share.min(steps.len());
        for k in 0..chosen {
            // Evenly spread, both ends included.
            named[steps[k * (steps.len() - 1) / (chosen - 1).max(1)]] = true;
        }
    }
    named
}

#[cfg(test)]
mod tests {
    use super::named_steps;

    #[test]
    fn every_step_is_named_up_to_two_dozen() {
        let falls: Vec<bool> = (0..14).map(|step| step >= 7).collect();
        assert_eq!(named_steps(&falls), [true; 14]);
    }

    #[test]
    fn a_long_history_names_the_ends_of_both_branches() {
        let falls: Vec<bool> = (0..60).map(|step| step >= 30).collect();
        let named = named_steps(&falls);
        assert_eq!(named.iter().filter(|named| **named).count(), 24);
        assert!(named[0] && named[29] && named[30] && named[59]);
        let one_way = named_steps(&[false; 50]);
        assert!(one_way[0] && one_way[49]);
        assert_eq!(one_way.iter().filter(|named| **named).count(), 24);
    }
}
