//! Curves of errors over the quality of meshes.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::{ASPECT, CYLINDER, DISTORTION, ELEMENTS, END, MID_SIDE, OSCILLATION, PLATE};
use crate::stability::Trouble;
use crate::stability::outcome::Outcome;
use crate::stability::row::{Row, element_name};

/// Width of a panel `[px]`, and its aspect.
const PANEL: f64 = 480.0;
const SHAPE: f64 = 0.8;
const REFUSED: &str = "refused";

/// Over the shape of the cells.
pub(super) fn over_cells(rows: &[Row]) -> Result<Svg, Trouble> {
    let aspect = || Axis::log("width over depth of the surface cells [1]");
    let share = || Axis::linear("largest move of inner nodes, in cells [1]");
    let charts = vec![
        chart(rows, "Thin surface cells, plate", ASPECT, PLATE, aspect()),
        chart(
            rows,
            "Thin surface cells, cylinder",
            ASPECT,
            CYLINDER,
            aspect(),
        ),
        chart(rows, "Distorted cells, plate", DISTORTION, PLATE, share()),
        chart(
            rows,
            "Distorted cells, cylinder",
            DISTORTION,
            CYLINDER,
            share(),
        ),
    ];
    Ok(Panels::new("What badly shaped cells cost", 2, charts)
        .common_legend()
        .render()?)
}

/// Over what happens along the contact edge.
pub(super) fn over_edges(rows: &[Row]) -> Result<Svg, Trouble> {
    let middle = || Axis::linear("place of mid-side nodes along the edge [1]");
    let end = || Axis::linear("half-width of contact, in cells [1]");
    let charts = vec![
        chart(
            rows,
            "Moved mid-side nodes, plate",
            MID_SIDE,
            PLATE,
            middle(),
        ),
        chart(
            rows,
            "Moved mid-side nodes, cylinder",
            MID_SIDE,
            CYLINDER,
            middle(),
        ),
        chart(rows, "Contact ends within an element", END, CYLINDER, end()),
        oscillation(rows, end()),
    ];
    Ok(Panels::new("What the contact edge costs", 2, charts)
        .common_legend()
        .render()?)
}

/// Errors of `what` over the cases that begin with `case`, one curve per element. Refused meshes are marked above the rest.
fn chart(rows: &[Row], title: &str, case: &str, what: &str, x: Axis) -> LineChart {
    let case = format!("{case}: {what}");
    let y = Axis::log(format!("error of the {what} [1]"));
    let own: Vec<&Row> = rows.iter().filter(|row| row.case == case).collect();
    let refused = |row: &&&Row| row.outcome == Outcome::Refused;
    let mut places: Vec<f64> = own.iter().filter(refused).map(|row| row.value).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let errors = own.iter().filter_map(|row| row.error);
    let top = 10.0 * errors.fold(f64::MIN_POSITIVE, f64::max);
    let marks = places.into_iter().map(|place| [place, top]).collect();
    curves(&own, LineChart::new(title, x, y)).with(
        Series::new(REFUSED, marks)
            .style(SeriesStyle::Markers)
            .color(Color::rgb(0x11, 0x11, 0x11)),
    )
}

fn oscillation(rows: &[Row], x: Axis) -> LineChart {
    let case = format!("{OSCILLATION}: {CYLINDER}");
    let own: Vec<&Row> = rows.iter().filter(|row| row.case == case).collect();
    let y = Axis::linear("jump at mid-side nodes over the peak [1]");
    curves(&own, LineChart::new("Oscillation of quadratic edges", x, y))
}

fn curves(rows: &[&Row], chart: LineChart) -> LineChart {
    let mut chart = chart.size(PANEL, SHAPE);
    for (index, kind) in ELEMENTS.into_iter().enumerate() {
        let own = rows.iter().filter(|row| row.method == element_name(kind));
        let points: Vec<[f64; 2]> = own
            .filter_map(|row| Some([row.value, row.error?]))
            .collect();
        // Also without points, so that all charts have the same legend.
        let series = Series::new(element_name(kind), points)
            .style(SeriesStyle::Both)
            .color(Color::category(index));
        chart = chart.with(series);
    }
    chart
}
