//! What several figures show alike: zones, remarks in captions.

use stickslip_contact::Status;
use stickslip_report::chart::Band;
use stickslip_report::color::Color;

use crate::results::display::EdgeView;
use crate::results::zones::shown_ranges;

/// The largest of `values` by `size`; of those that are equal but for rounding the last.
pub(super) fn last_largest<T: Copy>(
    values: impl Iterator<Item = T>,
    size: impl Fn(T) -> f64,
) -> Option<T> {
    const ROUNDING: f64 = 1e-7;
    let values: Vec<T> = values.collect();
    let most = values.iter().map(|&value| size(value)).reduce(f64::max)?;
    let high = |value: &&T| size(**value) >= most * (1.0 - ROUNDING);
    values.iter().rev().find(high).copied()
}

/// Colour of a zone in every figure.
pub(super) fn zone_color(status: Status) -> Color {
    match status {
        Status::Open => Color::rgb(0x9a, 0x9a, 0x9a),
        Status::Stick => Color::rgb(0x1f, 0x6f, 0xb4),
        Status::SlipPositive => Color::rgb(0xe0, 0x7b, 0x1a),
        Status::SlipNegative => Color::rgb(0x2a, 0x93, 0x5c),
    }
}

/// Name of a zone for a reader.
pub(super) fn zone_name(view: &EdgeView<'_>, status: Status) -> &'static str {
    let [positive, negative] = view.slip_names();
    match status {
        Status::Open => "open",
        Status::Stick => "stick",
        Status::SlipPositive => positive,
        Status::SlipNegative => negative,
    }
}

/// Zones of a step as bands over the place axis.
pub(super) fn zone_bands(view: &EdgeView<'_>, step: usize) -> Vec<Band> {
    let ranges = shown_ranges(view, step).into_iter();
    ranges
        .map(|(status, [start, end])| {
            Band::new(zone_name(view, status), start, end, zone_color(status))
        })
        .collect()
}

/// What bands around curves are, for captions.
pub(super) fn margin_remark(view: &EdgeView<'_>) -> Option<String> {
    let mut steps = view.results().steps.iter();
    let known = steps.any(|step| step.edges.iter().any(|edge| !edge.row_errors.is_empty()));
    known.then(|| "Bands around curves are estimated errors.".to_owned())
}

/// What a half model shows, for captions.
pub(super) fn half_remark(view: &EdgeView<'_>) -> Option<String> {
    let remark = "One half is modelled; the other is its mirror image.";
    view.geometry.half.then(|| remark.to_owned())
}
