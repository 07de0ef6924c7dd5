//! Fields show every value in its place, as paths or as an image.

use roxmltree::Document;
use stickslip_report::FigureError;
use stickslip_report::color::Colormap;
use stickslip_report::field::FieldPlot;
use stickslip_report::raster::to_png;
use stickslip_report::svg::Svg;

/// `columns` × `rows` linear quadrilaterals on [0, 2] × [0, 1].
fn grid(columns: usize, rows: usize) -> (Vec<[f64; 2]>, Vec<Vec<usize>>) {
    let (width, height) = (columns as f64, rows as f64);
    let nodes = (0..=rows)
        .flat_map(|j| (0..=columns).map(move |i| [2.0 * i as f64 / width, j as f64 / height]))
        .collect();
    let at = |i: usize, j: usize| j * (columns + 1) + i;
    let cells = (0..rows)
        .flat_map(|j| (0..columns).map(move |i| (i, j)))
        .map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect();
    (nodes, cells)
}

fn values(nodes: &[[f64; 2]], f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    nodes.iter().map(|[x, y]| f(*x, *y)).collect()
}

fn texts(picture: &Svg) -> Vec<String> {
    let document = Document::parse(picture.as_str()).unwrap();
    let nodes = document
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    nodes
        .map(|node| node.text().unwrap_or_default().to_owned())
        .collect()
}

fn count(picture: &Svg, tag: &str) -> usize {
    let document = Document::parse(picture.as_str()).unwrap();
    document
        .descendants()
        .filter(|node| node.has_tag_name(tag))
        .count()
}

/// The colour at a place of the picture, given as parts of its width and height.
fn color_at(picture: &Svg, part_x: f64, part_y: f64) -> [u8; 3] {
    let file = to_png(picture, 1.0).unwrap();
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let (x, y) = (
        part_x * f64::from(info.width),
        part_y * f64::from(info.height),
    );
    let start = 4 * (y as usize * info.width as usize + x as usize);
    [pixels[start], pixels[start + 1], pixels[start + 2]]
}

#[test]
fn a_field_has_labels_extremes_and_the_ends_of_its_bar() {
    let (nodes, cells) = grid(8, 4);
    let values = values(&nodes, |x, y| 100.0 * x - 50.0 * y);
    let plot = FieldPlot::new("Field", "σ_xx [MPa] < all", "mm", &nodes, &cells, &values);
    let picture = plot.clone().render().unwrap();
    let stated = texts(&plot.stating("max 150 MPa inside").render().unwrap());
    assert!(stated.contains(&"max 150 MPa inside".to_owned()));
    assert!(!stated.iter().any(|text| text.starts_with("min ")));
    let texts = texts(&picture);
    for expected in [
        "Field",
        "σ_xx [MPa] < all",
        "x [mm]",
        "y [mm]",
        "−50",
        "200",
    ] {
        assert!(
            texts.iter().any(|text| text == expected),
            "{expected} in {texts:?}"
        );
    }
    assert!(
        texts.contains(&"min −50.00 MPa at (0, 1.000), max 200.0 MPa at (2.000, 0)".to_owned())
    );
    assert_eq!(count(&picture, "image"), 0);
    assert!(!picture.as_str().contains("NaN"));
}

#[test]
fn paths_and_images_show_the_same_colours() {
    let shown = |columns: usize, rows: usize| {
        let (nodes, cells) = grid(columns, rows);
        let values = values(&nodes, |x, _| x);
        let plot = FieldPlot::new("Same", "v [–]", "mm", &nodes, &cells, &values);
        plot.render().unwrap()
    };
    let (paths, image) = (shown(8, 4), shown(220, 110));
    assert_eq!([count(&paths, "image"), count(&image, "image")], [0, 1]);
    for part_x in [0.2, 0.45, 0.7] {
        let pair = [color_at(&paths, part_x, 0.5), color_at(&image, part_x, 0.5)];
        for channel in 0..3 {
            // One of 128 colour steps of Viridis changes a channel by at most 4; the two
            // pictures may be one step apart on either side.
            assert!(
                pair[0][channel].abs_diff(pair[1][channel]) <= 8,
                "{pair:?} at {part_x}"
            );
        }
    }
}

#[test]
fn files_stay_small() {
    let wave = |x: f64, y: f64| (40.0 * x).sin() * (40.0 * y).cos();
    for (columns, rows) in [(4, 2), (40, 20), (140, 70), (400, 200)] {
        let (nodes, cells) = grid(columns, rows);
        let values = values(&nodes, wave);
        let plot = FieldPlot::new("Wave", "v", "mm", &nodes, &cells, &values).with_mesh();
        let size = plot.render().unwrap().as_str().len();
        assert!(size < 2_000_000, "{columns} × {rows}: {size} bytes");
    }
}

#[test]
fn a_mirrored_field_shows_both_halves() {
    let (nodes, cells) = grid(8, 4);
    let values = values(&nodes, |_, y| y);
    let half = FieldPlot::new("Half", "τ [MPa]", "mm", &nodes, &cells, &values)
        .colormap(Colormap::BlueWhiteRed);
    let whole = half.clone().mirror([1.0, -1.0, -1.0]).render().unwrap();
    assert!(texts(&whole).contains(
        &"min −1.000 MPa at (0.2500, −1.000), max 1.000 MPa at (0.2500, 1.000)".to_owned()
    ));
    let same = half.mirror([1.0, -1.0, 1.0]).render().unwrap();
    assert!(
        texts(&same)
            .iter()
            .any(|text| text.starts_with("min 0 MPa at (0, 0), max 1.000"))
    );
    let below = color_at(&same, 0.4, 0.85);
    assert!(
        below[0] > below[2],
        "red where the mirrored value is positive: {below:?}"
    );
}

#[test]
fn a_window_shows_only_its_part() {
    let (nodes, cells) = grid(40, 20);
    let values = values(&nodes, |x, _| x);
    let plot = FieldPlot::new("Part", "v", "mm", &nodes, &cells, &values);
    let part = plot
        .clone()
        .window([0.5, 1.0, 0.25, 0.75])
        .render()
        .unwrap();
    let stated = texts(&part)
        .into_iter()
        .find(|text| text.starts_with("min "))
        .unwrap();
    assert!(stated.starts_with("min 0.5000 at (0.5000,"), "{stated}");
    assert!(stated.contains("max 1.000 at (1.000,"), "{stated}");
    // A window inside one cell still has colours.
    assert!(
        plot.clone()
            .window([0.501, 0.502, 0.501, 0.502])
            .render()
            .is_ok()
    );
    let outside = plot
        .clone()
        .window([5.0, 6.0, 5.0, 6.0])
        .render()
        .unwrap_err();
    assert_eq!(
        outside,
        FigureError::NoData {
            axis: "v".to_owned()
        }
    );
    assert!(plot.window([1.0, 0.0, 0.0, 1.0]).render().is_err());
}

#[test]
fn cells_without_a_value_are_grey_and_the_rest_is_shown() {
    let (nodes, cells) = grid(8, 4);
    let mut values = values(&nodes, |x, _| x);
    values[0] = f64::NAN;
    let picture = FieldPlot::new("Gap", "v", "mm", &nodes, &cells, &values)
        .render()
        .unwrap();
    assert!(picture.as_str().contains("#d8d8d8"));
    assert!(!picture.as_str().contains("NaN"));
    let nothing = vec![f64::NAN; nodes.len()];
    assert!(
        FieldPlot::new("None", "v", "mm", &nodes, &cells, &nothing)
            .render()
            .is_err()
    );
}

#[test]
fn the_bar_is_pointed_where_values_lie_beyond_it() {
    let (nodes, cells) = grid(8, 4);
    let values = values(&nodes, |x, _| x);
    let plot = FieldPlot::new("Bar", "v", "mm", &nodes, &cells, &values);
    let paths = |range: [f64; 2]| {
        // A point is a filled path with an ink outline; nothing else is.
        let picture = plot.clone().between(range[0], range[1]).render().unwrap();
        let document = Document::parse(picture.as_str()).unwrap();
        document
            .descendants()
            .filter(|node| node.has_tag_name("path") && node.attribute("stroke") == Some("#222222"))
            .filter(|node| node.attribute("fill") != Some("none"))
            .count()
    };
    assert_eq!(
        [paths([0.0, 2.0]), paths([0.5, 2.0]), paths([0.5, 1.5])],
        [0, 1, 2]
    );
    assert!(plot.clone().between(1.0, 1.0).render().is_err());
}

#[test]
fn meshes_that_do_not_fit_together_are_refused() {
    let (nodes, cells) = grid(2, 1);
    let values = values(&nodes, |x, _| x);
    let short = FieldPlot::new("f", "v", "mm", &nodes, &cells, &values[1..]).render();
    assert!(matches!(
        short,
        Err(FigureError::ValueCount {
            values: 5,
            nodes: 6,
            ..
        })
    ));
    for bad in [vec![0, 1], vec![0, 1, 99]] {
        let refused =
            FieldPlot::new("f", "v", "mm", &nodes, &[cells[0].clone(), bad], &values).render();
        assert!(matches!(refused, Err(FigureError::Cell { cell: 1, .. })));
    }
    let mut lost = nodes.clone();
    lost[3] = [f64::NAN, 0.0];
    let refused = FieldPlot::new("f", "v", "mm", &lost, &cells, &values).render();
    assert!(matches!(refused, Err(FigureError::Node { node: 3, .. })));
    assert!(
        FieldPlot::new("f", "v", "mm", &nodes, &[], &values)
            .render()
            .is_err()
    );
}

#[test]
fn flat_tall_and_uniform_fields_can_be_drawn() {
    let (nodes, cells) = grid(8, 4);
    let constant = vec![3.0; nodes.len()];
    for [x, y] in [[1.0, 0.2], [0.02, 1.0], [1e-6, 1e-6], [1e6, 1e6]] {
        let scaled: Vec<[f64; 2]> = nodes.iter().map(|p| [x * p[0], y * p[1]]).collect();
        let picture = FieldPlot::new("Flat", "v", "m", &scaled, &cells, &constant).render();
        let expected = picture.as_ref().err().map(ToString::to_string);
        assert!(picture.is_ok(), "{x} {y}: {expected:?}");
    }
}
