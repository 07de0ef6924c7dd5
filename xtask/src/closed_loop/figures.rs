//! The chart of the intervals.

use stickslip_hybrid::identify::Bounds;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, ReferenceLine, Series as Curve, SeriesStyle};
use stickslip_report::color::Color;

use super::Picture;
use super::study::Series;

/// Every seed's coefficient with its interval, by rank.
pub(super) fn intervals(series: &Series) -> Result<Picture, FigureError> {
    let truth = series.known.mu;
    let mut rows: Vec<(f64, [f64; 2], bool)> = (series.outcomes.iter())
        .filter_map(|one| {
            let fit = one.together.as_ref()?;
            let ends = match fit.bounds {
                Bounds::Between(low, high) => [low, high],
                Bounds::AtMost(high) => [0.0, high],
                Bounds::AtLeast(_) | Bounds::Nothing => return None,
            };
            Some((fit.mu, ends, one.holds(truth)))
        })
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let curve = |label: &str, holds: bool, color: Color| {
        let own = rows.iter().enumerate().filter(|(_, row)| row.2 == holds);
        let (points, spread): (Vec<_>, Vec<_>) = own
            .map(|(rank, row)| ([row.0, rank as f64 + 1.0], row.1))
            .unzip();
        Curve::new(label, points)
            .style(SeriesStyle::Markers)
            .spread(spread)
            .color(color)
    };
    let covered = series.covered();
    let missed = series.outcomes.len() - covered;
    let mut chart = LineChart::new(
        "Dynamic friction from fringe pictures, one row for each noise seed",
        Axis::linear("μd with its interval of 95 % [–]"),
        Axis::linear("seeds, by rank"),
    )
    .with(curve(
        &format!("holds the truth: {covered}"),
        true,
        Color::category(0),
    ))
    .reference(ReferenceLine::vertical(format!("truth {truth}"), truth))
    .size(720.0, 0.8);
    if missed > 0 {
        chart = chart.with(curve(
            &format!("misses it: {missed}"),
            false,
            Color::category(1),
        ));
    }
    Ok(Picture {
        name: "closed-loop",
        svg: chart.render()?,
        alternative: "Coefficients of all seeds with their intervals, sorted, beside the truth",
    })
}
