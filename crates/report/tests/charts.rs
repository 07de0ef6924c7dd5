//! Charts are well-formed, show what they are given, and refuse what they cannot show.

use roxmltree::{Document, Node};
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{
    Band, Legend, LineChart, Panels, ReferenceLine, Series, SeriesStyle, tile,
};
use stickslip_report::color::Color;
use stickslip_report::raster::to_png;
use stickslip_report::svg::Svg;

const RED: Color = Color::rgb(200, 10, 20);

fn parsed(picture: &Svg) -> Document<'_> {
    Document::parse(picture.as_str()).expect("well-formed XML")
}

fn texts(document: &Document<'_>) -> Vec<String> {
    let nodes = document
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    nodes
        .map(|node| node.text().unwrap_or_default().to_owned())
        .collect()
}

/// Paths that are stroked but not filled in `color`: lines of curves.
fn lines<'a>(document: &'a Document<'a>, color: Color) -> Vec<Node<'a, 'a>> {
    let stroke = color.to_string();
    document
        .descendants()
        .filter(|node| node.has_tag_name("path") && node.attribute("fill") == Some("none"))
        .filter(|node| node.attribute("stroke") == Some(stroke.as_str()))
        .collect()
}

fn chart(points: Vec<[f64; 2]>) -> LineChart {
    LineChart::new("Chart", Axis::linear("x [mm]"), Axis::linear("y [MPa]"))
        .with(Series::new("curve", points).color(RED))
}

#[test]
fn labels_are_shown_and_escaped() {
    let picture = chart(vec![[0.0, 0.0], [1.0, 2.0]])
        .subtitle("P < 2 kN & \"μ\" = 0.2")
        .with(Series::new(
            "<script>alert(1)</script>",
            vec![[0.0, 1.0], [1.0, 0.0]],
        ))
        .render()
        .unwrap();
    let document = parsed(&picture);
    let texts = texts(&document);
    for expected in [
        "Chart",
        "P < 2 kN & \"μ\" = 0.2",
        "x [mm]",
        "y [MPa]",
        "curve",
        "<script>alert(1)</script>",
    ] {
        assert!(
            texts.iter().any(|text| text == expected),
            "{expected} in {texts:?}"
        );
    }
    assert!(
        !document
            .descendants()
            .any(|node| node.has_tag_name("script"))
    );
    assert!(!picture.as_str().contains(" id="));
}

#[test]
fn nan_interrupts_a_line_and_never_reaches_the_file() {
    let points = vec![
        [0.0, 1.0],
        [1.0, 2.0],
        [2.0, f64::NAN],
        [3.0, 1.0],
        [4.0, 3.0],
    ];
    let picture = chart(points).legend(Legend::Hidden).render().unwrap();
    let document = parsed(&picture);
    let data = lines(&document, RED)[0].attribute("d").unwrap().to_owned();
    assert_eq!(
        (data.matches('M').count(), data.matches('L').count()),
        (2, 2),
        "{data}"
    );
    assert!(!picture.as_str().contains("NaN") && !picture.as_str().contains("inf"));
}

#[test]
fn a_lone_point_between_gaps_is_a_dot() {
    let points = vec![
        [0.0, 1.0],
        [1.0, f64::NAN],
        [2.0, 3.0],
        [3.0, f64::NAN],
        [4.0, 1.0],
    ];
    let picture = chart(points).legend(Legend::Hidden).render().unwrap();
    let document = parsed(&picture);
    let dots = document
        .descendants()
        .filter(|node| node.attribute("fill") == Some(RED.to_string().as_str()))
        .count();
    assert_eq!(dots, 3);
    assert!(lines(&document, RED).is_empty());
}

#[test]
fn non_positive_values_interrupt_a_line_on_a_log_axis() {
    let mut chart = chart(vec![
        [1.0, 1e-3],
        [2.0, 0.0],
        [3.0, 1e-2],
        [4.0, -1.0],
        [5.0, 1e-1],
    ]);
    chart.y = Axis::log("error [–]");
    let picture = chart.render().unwrap();
    assert!(texts(&parsed(&picture)).iter().any(|text| text == "0.01"));
    assert!(!picture.as_str().contains("NaN"));
}

#[test]
fn stairs_hold_each_value_until_the_next() {
    let series = Series::new("", vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]])
        .style(SeriesStyle::Step)
        .color(RED);
    let picture = LineChart::new("", Axis::linear("x"), Axis::linear("y"))
        .with(series)
        .render()
        .unwrap();
    let document = parsed(&picture);
    let data = lines(&document, RED)[0].attribute("d").unwrap().to_owned();
    assert_eq!(data.matches('L').count(), 4, "{data}");
}

#[test]
fn wide_bands_are_named_above_and_narrow_ones_in_the_legend() {
    let blue = Color::rgb(0, 0, 200);
    let picture = chart(vec![[0.0, 0.0], [100.0, 1.0]])
        .band(Band::new("stick", 0.0, 50.0, blue))
        .band(Band::new("partial slip", 50.0, 52.0, RED))
        .band(Band::new("elsewhere", 200.0, 300.0, RED))
        .render()
        .unwrap();
    let texts = texts(&parsed(&picture));
    let count = |name: &str| texts.iter().filter(|text| *text == name).count();
    assert_eq!(
        [count("stick"), count("partial slip"), count("elsewhere")],
        [1, 1, 0]
    );
}

#[test]
fn reference_lines_widen_a_fitted_axis_and_keep_to_a_given_one() {
    let limit = ReferenceLine::horizontal("limit", 10.0);
    let fitted = chart(vec![[0.0, 0.0], [1.0, 1.0]])
        .reference(limit.clone())
        .render()
        .unwrap();
    assert!(texts(&parsed(&fitted)).iter().any(|text| text == "limit"));
    let mut given = chart(vec![[0.0, 0.0], [1.0, 1.0]]).reference(limit);
    given.y = given.y.between(0.0, 1.0);
    let given = given.render().unwrap();
    assert!(!texts(&parsed(&given)).iter().any(|text| text == "limit"));
}

#[test]
fn a_legend_inside_stands_on_no_curve() {
    // Up along the left, then along the top: only the lower right is free.
    let points = vec![[0.0, 0.0], [0.1, 1.0], [1.0, 1.0]];
    let picture = chart(points).render().unwrap();
    let document = parsed(&picture);
    let label = document
        .descendants()
        .find(|node| node.has_tag_name("text") && node.text() == Some("curve"))
        .unwrap();
    let y: f64 = label.attribute("y").unwrap().parse().unwrap();
    assert!(
        y > picture.height() / 2.0 && y < picture.height() - 60.0,
        "{y}"
    );
}

#[test]
fn fourteen_curves_have_fourteen_entries_beside_the_frame() {
    let mut chart = LineChart::new("", Axis::linear("x"), Axis::linear("y"));
    for step in 0..14 {
        let points = (0..50)
            .map(|k| [f64::from(k), f64::from(k * step % 17)])
            .collect();
        chart = chart.with(Series::new(format!("step {step}"), points));
    }
    let picture = chart.render().unwrap();
    let texts = texts(&parsed(&picture));
    assert_eq!(
        texts
            .iter()
            .filter(|text| text.starts_with("step "))
            .count(),
        14
    );
}

#[test]
fn far_points_keep_their_direction_and_stay_drawable() {
    let mut chart = chart(vec![[0.0, -1e300], [0.5, 0.5], [1.0, 1e300]]);
    chart.y = chart.y.between(0.0, 1.0);
    let picture = chart.render().unwrap();
    let longest = picture
        .as_str()
        .split([' ', '"', 'L', 'M'])
        .map(str::len)
        .max()
        .unwrap();
    assert!(longest < 60, "a coordinate has {longest} characters");
    assert!(to_png(&picture, 1.0).is_ok());
}

#[test]
fn what_cannot_be_drawn_is_refused_with_a_reason() {
    let empty = chart(vec![]).render().unwrap_err();
    assert_eq!(
        empty,
        FigureError::NoData {
            axis: "x [mm]".to_owned()
        }
    );
    let narrow = chart(vec![[0.0, 0.0], [1.0, 1.0]])
        .size(80.0, 0.5)
        .render()
        .unwrap_err();
    assert!(
        matches!(narrow, FigureError::Size { width: 80.0, .. }),
        "{narrow}"
    );
    for (width, aspect) in [
        (f64::NAN, 0.5),
        (720.0, f64::INFINITY),
        (720.0, -1.0),
        (1e9, 0.5),
    ] {
        assert!(
            chart(vec![[0.0, 0.0], [1.0, 1.0]])
                .size(width, aspect)
                .render()
                .is_err()
        );
    }
    assert!(matches!(
        tile("none", 2, &[]),
        Err(FigureError::NoPanels { panels: 0, .. })
    ));
}

/// The band of a margin is a closed path below the curve, in a tint of its colour; one that cannot be seen is not drawn, and the axis has room for it.
#[test]
fn margins_are_bands() {
    let points = vec![[0.0, 1.0], [1.0, 2.0], [2.0, 1.5]];
    let with = |width: f64| {
        let margin = points.iter().map(|[_, y]| [y - width, y + width]);
        let series = Series::new("curve", points.clone()).margin(margin.collect());
        let chart = LineChart::new("", Axis::linear("x"), Axis::linear("y"));
        chart.with(series.color(Color::rgb(0, 0, 200)))
    };
    let bands = |width: f64| {
        let tint = Color::rgb(0, 0, 200).tint(0.3).to_string();
        let picture = with(width).render().unwrap();
        let document = parsed(&picture);
        let paths = document.descendants().filter(|node| {
            node.has_tag_name("path") && node.attribute("fill") == Some(tint.as_str())
        });
        paths
            .filter(|node| node.attribute("d").is_some_and(|data| data.ends_with('z')))
            .count()
    };
    assert_eq!([bands(0.4), bands(1e-5)], [1, 0]);
    let reaches_four = |width: f64| {
        let picture = with(width).render().unwrap();
        texts(&parsed(&picture)).iter().any(|text| text == "4")
    };
    assert!(reaches_four(3.0) && !reaches_four(0.1));
}

#[test]
fn panels_line_up() {
    let small = chart(vec![[0.0, 0.0], [1.0, 1.0]])
        .size(360.0, 0.6)
        .legend(Legend::Hidden);
    let mut wide_labels = small.clone();
    wide_labels.y = Axis::linear("y").between(0.0, 99_999.0);
    let picture = Panels::new("All", 1, vec![small, wide_labels])
        .render()
        .unwrap();
    let document = parsed(&picture);
    let lefts: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("svg") && node.attribute("overflow").is_some())
        .filter_map(|node| node.attribute("x"))
        .collect();
    assert_eq!(lefts.len(), 2);
    assert_eq!(lefts[0], lefts[1]);
}

#[test]
fn a_common_legend_names_every_curve_once() {
    let mut family = LineChart::new("", Axis::linear("x"), Axis::linear("y"));
    for step in 1..=14 {
        let points = vec![[0.0, 0.0], [1.0, f64::from(step)]];
        family = family.with(Series::new(format!("step {step}"), points));
    }
    let charts = vec![family.clone(), family];
    let picture = Panels::new("All", 2, charts)
        .common_legend()
        .render()
        .unwrap();
    let document = parsed(&picture);
    let names = texts(&document);
    for step in 1..=14 {
        let name = format!("step {step}");
        assert_eq!(names.iter().filter(|text| **text == name).count(), 1);
    }
}

#[test]
fn equal_charts_give_equal_bytes() {
    let draw = || chart(vec![[0.0, 0.0], [1.0, 1.0]]).render().unwrap();
    assert_eq!(draw(), draw());
    assert_eq!(to_png(&draw(), 1.0).unwrap(), to_png(&draw(), 1.0).unwrap());
}

#[test]
fn a_png_has_the_asked_size_and_shows_text() {
    let picture = chart(vec![[0.0, 0.0], [1.0, 1.0]]).render().unwrap();
    let file = to_png(&picture, 2.0).unwrap();
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let expected = [picture.width(), picture.height()].map(|side| (2.0 * side).ceil() as u32);
    assert_eq!([info.width, info.height], expected);
    // The title stands in the first rows, in ink on white.
    let rows = 4 * info.width as usize * 60;
    let dark = pixels[..rows]
        .chunks(4)
        .filter(|pixel| pixel[0] < 80)
        .count();
    assert!(dark > 100, "{dark} dark pixels where the title should be");
    for scale in [0.0, -1.0, f64::NAN, 1e6] {
        assert!(matches!(
            to_png(&picture, scale),
            Err(FigureError::Raster { .. })
        ));
    }
}

#[test]
fn a_spread_is_a_bar_with_two_ends_and_widens_the_axis() {
    let series = Series::new("curve", vec![[1.0, 1.0], [2.0, 2.0]])
        .style(SeriesStyle::Markers)
        .spread(vec![[0.5, 4.0]])
        .color(RED);
    let picture = LineChart::new("", Axis::linear("x"), Axis::linear("y"))
        .with(series)
        .render()
        .unwrap();
    let document = parsed(&picture);
    let bars = lines(&document, RED);
    let data = bars[0].attribute("d").unwrap();
    assert_eq!(data.matches('M').count(), 3, "{data}");
    assert!(texts(&document).iter().any(|t| t.parse() == Ok(4.0)));
}
