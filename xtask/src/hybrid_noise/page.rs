//! The table, the charts, the findings in words, and the page.

use std::fmt::Write as _;

use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::case::{Case, Method, Row, SHARE, Varied};
use super::specimen::peak_shear;
use super::{Picture, SIZE, SPACING, Trouble};

const WIDTH: f64 = 460.0;
const ASPECT: f64 = 0.8;
/// Biases below this are rounding `[MPa]`.
const ROUNDING: f64 = 1e-9;
const MESH: Color = Color::rgb(0x22, 0x22, 0x22);

/// All cases.
pub(super) fn csv(rows: &[Row]) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "varied",
        "reduction",
        "cell_mm",
        "spacing_mm",
        "points_per_cell",
        "stand_off_mm",
        "noise_MPa",
        "noise_of_draws_MPa",
        "bias_of_reduction_MPa",
        "bias_of_mesh_MPa",
    ])?;
    for row in rows {
        let varied = match row.case.varied {
            Varied::Points => "points per cell",
            Varied::Mesh => "cell size",
            Varied::Smoothing => "smoothing",
            Varied::StandOff => "stand-off",
        };
        let mut record = vec![varied.to_owned(), row.case.method.name()];
        record.extend([row.case.size, row.case.spacing, row.points()].map(|v| format!("{v:.4}")));
        record.push(format!("{:.4}", row.case.stand_off));
        record.extend([row.noise, row.drawn, row.bias, row.mesh].map(|v| format!("{v:.5}")));
        writer.write_record(&record)?;
    }
    Ok(writer.into_inner()?)
}

/// Rows of one curve, in the order of the cases.
fn curve(rows: &[Row], varied: Varied, method: Method) -> impl Iterator<Item = &Row> {
    rows.iter()
        .filter(move |row| row.case.varied == varied && row.case.method == method)
}

pub(super) fn pictures(rows: &[Row]) -> Result<Vec<Picture>, FigureError> {
    let picture = |name, svg, alternative| Picture {
        name,
        svg,
        alternative,
    };
    Ok(vec![
        picture(
            "points",
            panels(rows, Varied::Points)?,
            "Noise and bias of the edge shear over the number of data per cell",
        ),
        picture(
            "mesh",
            panels(rows, Varied::Mesh)?,
            "Noise and bias of the edge shear over the size of the cells",
        ),
        picture(
            "stand-off",
            panels(rows, Varied::StandOff)?,
            "Noise and bias of the edge shear over the distance of the data from the edge",
        ),
        picture(
            "smoothing",
            smoothing(rows)?,
            "Noise over bias of the edge shear as smoothing grows, with the other reductions beside it",
        ),
    ])
}

/// Noise in one panel, bias in the other, a curve for each reduction.
fn panels(rows: &[Row], varied: Varied) -> Result<Svg, FigureError> {
    let x = || match varied {
        Varied::Points => Axis::log("data per cell at the edge [1]"),
        Varied::Mesh => Axis::log("cell size along the edge [mm]"),
        Varied::Smoothing | Varied::StandOff => {
            Axis::linear("distance of the first data from the edge [mm]")
        }
    };
    let at = |row: &Row| match varied {
        Varied::Points => row.points(),
        Varied::Mesh => row.case.size,
        Varied::Smoothing | Varied::StandOff => row.case.stand_off,
    };
    let panel = |title: &str, of: fn(&Row) -> f64| {
        let y = Axis::log(format!("{title} [MPa rms]"));
        let mut chart = LineChart::new(title, x(), y).size(WIDTH, ASPECT);
        for (index, method) in Method::ALL.into_iter().enumerate() {
            let points: Vec<[f64; 2]> = curve(rows, varied, method)
                .map(|row| [at(row), of(row)])
                .filter(|[_, y]| *y > ROUNDING)
                .collect();
            let series = Series::new(method.name(), points);
            chart = chart.with(
                series
                    .style(SeriesStyle::Both)
                    .color(Color::category(index)),
            );
        }
        chart
    };
    let mesh: Vec<[f64; 2]> = curve(rows, varied, Method::Nodes)
        .map(|row| [at(row), row.mesh])
        .collect();
    let charts = [
        panel("noise of ±1/4 fringe", |row| row.noise),
        panel("bias of the reduction", |row| row.bias),
    ];
    let charts = charts.map(|chart| {
        let series = Series::new("error of the mesh itself", mesh.clone());
        chart.with(series.color(MESH).dash(Dash::Dashed))
    });
    let fixed = match varied {
        Varied::Points => format!("cells of {SIZE} mm"),
        Varied::Mesh => format!("data every {SPACING} mm"),
        Varied::Smoothing | Varied::StandOff => {
            format!("cells of {SIZE} mm, data every {SPACING} mm")
        }
    };
    let title = format!(
        "Errors of the edge shear (peak {:.0} MPa): {fixed}",
        peak_shear()
    );
    Panels::new(title, 2, charts.to_vec())
        .common_legend()
        .render()
}

/// Spacings among the rows on smoothing, coarse first.
fn spacings(rows: &[Row]) -> Vec<f64> {
    let own = rows.iter().filter(|r| r.case.varied == Varied::Smoothing);
    let mut all: Vec<f64> = own.map(|row| row.case.spacing).collect();
    all.sort_by(|a, b| b.total_cmp(a));
    all.dedup();
    all
}

/// Noise over bias along the amount of smoothing, a curve for each density of the data; the other reductions are points.
fn smoothing(rows: &[Row]) -> Result<Svg, FigureError> {
    let x = Axis::log("bias of the edge shear [MPa rms]");
    let y = Axis::log("noise of the edge shear [MPa rms]");
    let title = format!("Smoothing trades noise for bias (cells of {SIZE} mm)");
    let mut chart = LineChart::new(title, x, y).size(680.0, 0.72);
    for (index, spacing) in spacings(rows).into_iter().enumerate() {
        let own = rows.iter().filter(|r| r.case.varied == Varied::Smoothing);
        let own = own.filter(|row| row.case.spacing == spacing);
        let points: Vec<[f64; 2]> = own.map(|row| [row.bias, row.noise]).collect();
        let label = format!("smoothed, {:.0} data per cell", (SIZE / spacing).powi(2));
        let color = Color::category(index);
        chart = chart.with(
            Series::new(label, points)
                .style(SeriesStyle::Both)
                .color(color),
        );
    }
    let advised = curve(rows, Varied::Smoothing, Method::Smoothed(SHARE));
    let points: Vec<[f64; 2]> = advised.map(|row| [row.bias, row.noise]).collect();
    let label = format!("smoothed by {SHARE} × cross-validation");
    chart = chart.with(
        Series::new(label, points)
            .style(SeriesStyle::Markers)
            .color(MESH),
    );
    for (index, method) in Method::ALL.into_iter().skip(1).take(3).enumerate() {
        let points: Vec<[f64; 2]> = curve(rows, Varied::Points, method)
            .filter(|row| {
                [1.0, 4.0, 16.0]
                    .iter()
                    .any(|n| (row.points() - n).abs() < 0.1)
            })
            .map(|row| [row.bias, row.noise])
            .collect();
        if !points.is_empty() {
            let label = format!("{}, 1, 4, 16 data per cell", method.name());
            chart = chart.with(
                Series::new(label, points)
                    .style(SeriesStyle::Both)
                    .color(Color::category(index + 4))
                    .dash(Dash::Dotted),
            );
        }
    }
    chart.render()
}

/// What came out, one sentence for each question.
pub(super) fn findings(rows: &[Row]) -> Vec<String> {
    let mut sentences = vec![confirmed(rows)];
    sentences.extend(gain(rows));
    sentences.extend(order(rows));
    sentences.extend(mesh(rows));
    sentences.extend(stand_off(rows));
    sentences
}

/// How far draws and covariance are apart.
fn confirmed(rows: &[Row]) -> String {
    const LIMIT: f64 = 0.1;
    let apart = |row: &&Row| (row.drawn / row.noise - 1.0).abs();
    let (near, far): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| apart(row) <= LIMIT);
    let worst = near.iter().map(apart).fold(0.0, f64::max);
    let mut sentence = format!(
        "**Noise is what the covariance says**: in {} of {} cases the deviation of the draws is within {:.1} % of T Σ Tᵀ.",
        near.len(),
        rows.len(),
        100.0 * worst
    );
    if !far.is_empty() {
        let told: Vec<String> = far
            .iter()
            .map(|row| {
                let Case {
                    method, stand_off, ..
                } = row.case;
                format!(
                    "{} ({:.0} data per cell, stand-off {stand_off} mm) {:+.0} %",
                    method.name(),
                    row.points(),
                    100.0 * (row.drawn / row.noise - 1.0)
                )
            })
            .collect();
        // Writing into a string does not fail.
        let _ = write!(
            sentence,
            " The others smooth a lot, by an amount that every draw chooses anew; the choice adds noise that no covariance for a given \
             amount holds: {}.",
            told.join("; ")
        );
    }
    sentence
}

fn ratio_range(pairs: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    pairs.fold(None, |range: Option<[f64; 2]>, value| {
        let [low, high] = range.unwrap_or([value, value]);
        Some([low.min(value), high.max(value)])
    })
}

/// Noise of nodes with errors of their own over that of the fits, for the densities of the data.
fn gain(rows: &[Row]) -> Vec<String> {
    let told = |method: Method| -> Vec<String> {
        let nodes: Vec<&Row> = curve(rows, Varied::Points, Method::Nodes).collect();
        curve(rows, Varied::Points, method)
            .filter_map(|row| {
                let own = nodes.iter().find(|n| n.case.spacing == row.case.spacing)?;
                let gain = own.noise / row.noise;
                let digits = if gain < 1.0 { 2 } else { 1 };
                Some(format!(
                    "{:.0} data per cell: {gain:.digits$} ({:.2})",
                    row.points(),
                    row.bias / row.noise
                ))
            })
            .collect()
    };
    let sentence = |title: &str, method: Method| {
        let told = told(method).join("; ");
        format!(
            "**{title}**: how many times less noise than nodes that are measured themselves (and bias of the reduction over the noise that \
             is left): {told}."
        )
    };
    vec![
        sentence("Linear reduction", Method::Linear),
        sentence("Local quadratics", Method::Polynomial),
        sentence("Equilibrium alone", Method::Equilibrium),
        sentence("Declared smoothing", Method::Smoothed(SHARE)),
    ]
}

/// Order of the noise in the cell size.
fn order(rows: &[Row]) -> Option<String> {
    let own: Vec<&Row> = curve(rows, Varied::Mesh, Method::Nodes).collect();
    let (coarse, fine) = (own.first()?, own.last()?);
    let order = (fine.noise / coarse.noise).ln() / (coarse.case.size / fine.case.size).ln();
    Some(format!(
        "**Cell size.** With nodes that are measured themselves the noise goes from {:.2} to {:.2} MPa over cells of {} to {} mm, as h^−{order:.2}; the \
         smoothed fit stays between {} MPa.",
        coarse.noise,
        fine.noise,
        coarse.case.size,
        fine.case.size,
        ratio_range(curve(rows, Varied::Mesh, Method::Smoothed(SHARE)).map(|row| row.noise))
            .map_or_else(|| "–".to_owned(), |[a, b]| format!("{a:.2} and {b:.2}")),
    ))
}

/// The cell size with the least error of all kinds, of the smoothed fit.
fn mesh(rows: &[Row]) -> Option<String> {
    let own = || curve(rows, Varied::Mesh, Method::Smoothed(SHARE));
    let usual = own().find(|row| row.case.size == SIZE)?;
    let best = own().min_by(|a, b| a.total().total_cmp(&b.total()))?;
    Some(format!(
        "**The mesh itself** errs by {:.2} MPa with cells of {SIZE} mm, beside {:.2} MPa of noise and bias of the smoothed fit. The sum of all \
         is least, {:.2} instead of {:.2} MPa, with cells of {} mm, whose own error is {:.2} MPa.",
        usual.mesh,
        usual.error(),
        best.total(),
        usual.total(),
        best.case.size,
        best.mesh
    ))
}

/// What missing data at the edge cost.
fn stand_off(rows: &[Row]) -> Option<String> {
    let own: Vec<&Row> = curve(rows, Varied::StandOff, Method::Smoothed(SHARE)).collect();
    let told: Vec<String> = own
        .iter()
        .map(|row| {
            format!(
                "{} mm: noise {:.2}, bias {:.2} MPa",
                row.case.stand_off, row.noise, row.bias
            )
        })
        .collect();
    (!own.is_empty()).then(|| {
        format!(
            "**Stand-off** of the data from the edge, smoothed fit up to the edge: {}.",
            told.join("; ")
        )
    })
}

/// The page of the study.
pub(super) fn page(rows: &[Row], pictures: &[Picture], seeds: u64) -> String {
    let mut text = format!(
        "<!-- Generated by `cargo xtask hybrid-noise`; do not edit. -->\n\n# Noise and bias of stresses at a measured edge\n\n\
         A sector of aluminium (hole of 9.525 mm, one radius wide, ±57°) is pressed and sheared at its hole, the shear with a peak of \
         {:.1} MPa. Its displacements, from a much finer mesh, are measured at scattered places with errors uniform in ±1/4 fringe at \
         2400 lines/mm and reduced to the boundary of a mesh of quadratic cells, which may also be measured themselves; localized hybrid analysis makes stresses \
         of them. *Noise* is the deviation of the shear at the edge by the propagated covariance T Σ Tᵀ, *bias* the change that the \
         reduction makes without noise, beside the error of the mesh itself; all are root mean squares along the edge, two cells at either end left out. Every case was repeated \
         with {seeds} draws of the noise.\n\n## Findings\n\n",
        peak_shear()
    );
    for sentence in findings(rows) {
        // Writing into a string does not fail.
        let _ = writeln!(text, "- {sentence}");
    }
    for picture in pictures {
        let _ = write!(text, "\n![{}]({}.png)\n", picture.alternative, picture.name);
    }
    text.push_str("\n## What to take\n\n");
    text.push_str(&best_table(rows));
    text.push_str(
        "\nAll cases: [noise-and-bias.csv](noise-and-bias.csv). To repeat: `cargo xtask hybrid-noise`, or \
         `cargo xtask hybrid-noise --quick` for a few of them.\n",
    );
    text
}

/// Errors for each density of the data, and for each cell size those with the mesh's own.
fn best_table(rows: &[Row]) -> String {
    let mut text = format!(
        "Noise and bias of the reduction together, root of the sum of squares [MPa], cells of {SIZE} mm; the error of this mesh comes on top:\n\n"
    );
    let points = |row: &Row| format!("{:.0}", row.points());
    table(
        &mut text,
        rows,
        (Varied::Points, "data per cell"),
        points,
        Row::error,
    );
    // Writing into a string does not fail.
    let _ = writeln!(
        text,
        "\nNoise, bias and error of the mesh together [MPa], data every {SPACING} mm:\n"
    );
    let size = |row: &Row| row.case.size.to_string();
    table(
        &mut text,
        rows,
        (Varied::Mesh, "cell size [mm]"),
        size,
        Row::total,
    );
    text
}

/// One line for each value of what is varied, by its `name`, one column for each reduction.
fn table(
    text: &mut String,
    rows: &[Row],
    (varied, title): (Varied, &str),
    name: impl Fn(&Row) -> String,
    error: impl Fn(&Row) -> f64,
) {
    let methods = Method::ALL.map(Method::name).join(" | ");
    let rule = " --- |".repeat(Method::ALL.len() + 1);
    // Writing into a string does not fail.
    let _ = write!(text, "| {title} | {methods} |\n|{rule}");
    let own = rows.iter().filter(|row| row.case.varied == varied);
    let mut names: Vec<String> = own.map(&name).collect();
    names.dedup();
    for value in names {
        let _ = write!(text, "\n| {value} |");
        for method in Method::ALL {
            let found = curve(rows, varied, method).find(|row| name(row) == value);
            let cell = found.map_or_else(|| "–".to_owned(), |row| format!("{:.2}", error(row)));
            let _ = write!(text, " {cell} |");
        }
    }
    text.push('\n');
}
