//! Curves and markers in pixels.

use super::{Series, SeriesStyle};
use crate::color::Color;
use crate::frame::Frame;
use crate::markup::{Px, push_point};
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::Canvas;

/// Points nearer to the last one than this are not drawn \[px\].
const INVISIBLE: f64 = 0.15;
/// Lines are cut this far outside the frame, so that far points stay finite \[px\].
const OVERSCAN: f64 = 50.0;
/// Strength of the colour of a margin.
const MARGIN_TINT: f64 = 0.3;
/// Margins that are nowhere higher than this are not drawn \[px\].
const VISIBLE: f64 = 1.5;
const MARKER_RADIUS: f64 = 3.4;
/// Half height of the ticks that end a bar \[px\].
const BAR_END: f64 = 3.0;

/// The series' unbroken runs of points in pixels, stairs written out.
pub(crate) fn runs(frame: &Frame, series: &Series) -> Vec<Vec<[f64; 2]>> {
    let mut runs: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut open = false;
    for &point in &series.points {
        let Some(pixel) = frame.pixel(point) else {
            open = false;
            continue;
        };
        match runs.last_mut().filter(|_| open) {
            Some(run) => {
                if let (SeriesStyle::Step, Some(&[_, y])) = (series.style, run.last()) {
                    run.push([pixel[0], y]);
                }
                run.push(pixel);
            }
            None => runs.push(vec![pixel]),
        }
        open = true;
    }
    runs
}

/// Draws the line of a series; a lone point between gaps becomes a dot.
pub(crate) fn draw_line(canvas: &mut Canvas, frame: &Frame, series: &Series, color: Color) {
    if series.style == SeriesStyle::Markers {
        return;
    }
    let cut = frame.area.grown(OVERSCAN);
    let mut data = String::new();
    for run in runs(frame, series) {
        match run.as_slice() {
            [point] if series.style != SeriesStyle::Both && cut.contains(*point) => {
                let outline = Stroke::solid(color, 0.0);
                canvas.filled_path(&circle(*point, series.width), color, &outline);
            }
            _ => trace(&run, &cut, &mut data),
        }
    }
    canvas.stroked_path(
        &data,
        &Stroke::dashed(color, series.width, series.dash.pattern()),
    );
}

/// Draws a bar from the low to the high end of each point's spread, with a tick at both.
pub(crate) fn draw_spread(canvas: &mut Canvas, frame: &Frame, series: &Series, color: Color) {
    let cut = frame.area.grown(OVERSCAN);
    let mut data = String::new();
    for (&[_, y], &[low, high]) in series.points.iter().zip(&series.spread) {
        let (Some(from), Some(to)) = (frame.pixel([low, y]), frame.pixel([high, y])) else {
            continue;
        };
        let Some([start, end]) = clip(from, to, &cut) else {
            continue;
        };
        push_point(&mut data, 'M', start);
        push_point(&mut data, 'L', end);
        for [x, y] in [start, end] {
            push_point(&mut data, 'M', [x, y - BAR_END]);
            push_point(&mut data, 'L', [x, y + BAR_END]);
        }
    }
    canvas.stroked_path(&data, &Stroke::solid(color, 1.0));
}

/// Draws the band between the ends of the points' margins, if it is wide enough to be seen.
pub(crate) fn draw_margin(canvas: &mut Canvas, frame: &Frame, series: &Series, color: Color) {
    let cut = frame.area.grown(OVERSCAN);
    let ends = |(&[x, _], ends): (&[f64; 2], &[f64; 2])| {
        let [low, high] = ends.map(|y| frame.pixel([x, y]));
        Some([low?, high?].map(|[x, y]| [x, y.clamp(cut.top, cut.bottom())]))
    };
    let points: Vec<Option<[[f64; 2]; 2]>> =
        series.points.iter().zip(&series.margin).map(ends).collect();
    let mut data = String::new();
    for run in points.split(Option::is_none) {
        let run: Vec<[[f64; 2]; 2]> = run.iter().copied().flatten().collect();
        let height = run.iter().map(|[low, high]| (low[1] - high[1]).abs());
        if height.fold(0.0, f64::max) < VISIBLE {
            continue;
        }
        let there = run.iter().map(|ends| ends[1]);
        let back = run.iter().rev().map(|ends| ends[0]);
        for (k, point) in there.chain(back).enumerate() {
            push_point(&mut data, if k == 0 { 'M' } else { 'L' }, point);
        }
        data.push('z');
    }
    let color = color.tint(MARGIN_TINT);
    canvas.filled_path(&data, color, &Stroke::solid(color, 0.0));
}

/// Appends path data for the part of `run` inside `cut`.
fn trace(run: &[[f64; 2]], cut: &Area, data: &mut String) {
    let mut pen: Option<[f64; 2]> = None;
    let last = run.len().saturating_sub(2);
    for (index, pair) in run.windows(2).enumerate() {
        let from = pen.unwrap_or(pair[0]);
        if index != last && pen.is_some() && distance(from, pair[1]) < INVISIBLE {
            continue;
        }
        let Some([start, end]) = clip(from, pair[1], cut) else {
            pen = None;
            continue;
        };
        if pen.is_none() || start != from {
            push_point(data, 'M', start);
        }
        push_point(data, 'L', end);
        pen = (end == pair[1]).then_some(end);
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The part of a segment inside `area`, after Liang and Barsky (1984).
pub(crate) fn clip(from: [f64; 2], to: [f64; 2], area: &Area) -> Option<[[f64; 2]; 2]> {
    let step = [to[0] - from[0], to[1] - from[1]];
    let bounds = [[area.left, area.right()], [area.top, area.bottom()]];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        if step[axis] == 0.0 {
            if from[axis] < bounds[axis][0] || from[axis] > bounds[axis][1] {
                return None;
            }
            continue;
        }
        let [a, b] = bounds[axis].map(|bound| (bound - from[axis]) / step[axis]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    if enter > leave {
        return None;
    }
    let at = |t: f64| [from[0] + t * step[0], from[1] + t * step[1]];
    Some([
        if enter > 0.0 { at(enter) } else { from },
        if leave < 1.0 { at(leave) } else { to },
    ])
}

/// Draws the markers of series number `index`; the number chooses their shape.
pub(crate) fn draw_markers(
    canvas: &mut Canvas,
    frame: &Frame,
    series: &Series,
    color: Color,
    index: usize,
) {
    if !matches!(series.style, SeriesStyle::Markers | SeriesStyle::Both) {
        return;
    }
    let visible = frame.area.grown(0.5);
    let mut data = String::new();
    for pixel in series.points.iter().filter_map(|&point| frame.pixel(point)) {
        if visible.contains(pixel) {
            data.push_str(&marker(pixel, index));
        }
    }
    canvas.filled_path(&data, color, &marker_outline());
}

/// Draws what stands for a series in a legend, `width` px wide from `at`, its middle left.
pub(crate) fn draw_sample(
    canvas: &mut Canvas,
    at: [f64; 2],
    width: f64,
    series: &Series,
    color: Color,
    index: usize,
) {
    let [x, y] = at;
    if series.style != SeriesStyle::Markers {
        let stroke = Stroke::dashed(color, series.width, series.dash.pattern());
        canvas.line([x, y], [x + width, y], &stroke);
    }
    if matches!(series.style, SeriesStyle::Markers | SeriesStyle::Both) {
        canvas.filled_path(
            &marker([x + width / 2.0, y], index),
            color,
            &marker_outline(),
        );
    }
}

/// Draws `text` in `color`, its middle height at `at`.
pub(crate) fn draw_name(canvas: &mut Canvas, at: [f64; 2], text: &str, size: f64, color: Color) {
    canvas.centred_text(at, text, &TextStyle::new(size, color, Anchor::Start));
}

fn marker_outline() -> Stroke {
    Stroke::solid(Color::rgb(255, 255, 255), 0.8)
}

/// Path data of marker shape `index`: disc, square, triangle, diamond, inverted triangle.
fn marker(at: [f64; 2], index: usize) -> String {
    let r = MARKER_RADIUS;
    let polygon = |corners: &[[f64; 2]]| {
        let mut data = String::new();
        for (k, corner) in corners.iter().enumerate() {
            let command = if k == 0 { 'M' } else { 'L' };
            push_point(
                &mut data,
                command,
                [at[0] + r * corner[0], at[1] + r * corner[1]],
            );
        }
        data + "z"
    };
    match index % 5 {
        0 => circle(at, r),
        1 => polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]),
        2 => polygon(&[[0.0, -1.25], [1.15, 0.85], [-1.15, 0.85]]),
        3 => polygon(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]),
        _ => polygon(&[[0.0, 1.25], [1.15, -0.85], [-1.15, -0.85]]),
    }
}

/// Path data of a disc, in four cubic Bézier curves (radius true to 0.03 %).
fn circle([x, y]: [f64; 2], r: f64) -> String {
    /// Length of a control arm of a quarter of the unit circle, 4/3 tan(π/8).
    const ARM: f64 = 0.552_284_749_8;
    let (arm, rest) = (ARM * r, r - ARM * r);
    let quarter = |points: [f64; 6]| -> String {
        let texts = points.map(|length| Px(length).to_string());
        format!("c{}", texts.join(" "))
    };
    [
        format!("M{} {}", Px(x - r), Px(y)),
        quarter([0.0, arm, rest, r, r, r]),
        quarter([arm, 0.0, r, -rest, r, -r]),
        quarter([0.0, -arm, -rest, -r, -r, -r]),
        quarter([-arm, 0.0, -r, rest, -r, r]),
        "z".to_owned(),
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Area = Area::new([0.0, 0.0], [10.0, 10.0]);

    #[test]
    fn segments_are_cut_at_the_border() {
        assert_eq!(
            clip([1.0, 1.0], [2.0, 2.0], &AREA),
            Some([[1.0, 1.0], [2.0, 2.0]])
        );
        assert_eq!(
            clip([-5.0, 5.0], [15.0, 5.0], &AREA),
            Some([[0.0, 5.0], [10.0, 5.0]])
        );
        assert_eq!(clip([-5.0, 12.0], [15.0, 12.0], &AREA), None);
        assert_eq!(clip([11.0, 0.0], [20.0, 9.0], &AREA), None);
        // A segment that starts very far away keeps its direction.
        let [_, end] = clip([-1e12, -1e12], [5.0, 5.0], &AREA).unwrap();
        assert_eq!(end, [5.0, 5.0]);
    }

    #[test]
    fn a_line_that_leaves_and_returns_has_two_parts() {
        let run = [[1.0, 5.0], [5.0, -50.0], [9.0, 5.0]];
        let mut data = String::new();
        trace(&run, &AREA, &mut data);
        assert_eq!(data.matches('M').count(), 2, "{data}");
    }

    #[test]
    fn points_within_one_pixel_are_merged_but_the_last_is_kept() {
        let run: Vec<[f64; 2]> = (0..=10_000).map(|k| [f64::from(k) * 1e-3, 5.0]).collect();
        let mut data = String::new();
        trace(&run, &AREA, &mut data);
        assert!(data.matches('L').count() < 100);
        assert!(data.ends_with("L10 5"), "{data}");
    }
}
