//! Draws every kind of figure from made-up data and Kirsch's stresses around a hole, as SVG and PNG:
//! `cargo run --release -p stickslip-report --example gallery -- FOLDER`; without a folder it draws all and prints their sizes and the peak stress.

use std::error::Error;
use std::path::PathBuf;

use stickslip_report::axis::Axis;
use stickslip_report::chart::{
    Band, Dash, Legend, LineChart, Panels, ReferenceLine, Series, SeriesStyle,
};
use stickslip_report::color::{Color, Colormap, loading_sequence, unloading_sequence};
use stickslip_report::field::FieldPlot;
use stickslip_report::page::{Block, Figure, Page, Section};
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_report::svg::Svg;
use stickslip_report::table::{Column, Table};

const STICK: Color = Color::rgb(0x1f, 0x6f, 0xb4);
const SLIP: Color = Color::rgb(0xe0, 0x7b, 0x1a);
const OPEN: Color = Color::rgb(0x88, 0x88, 0x88);
/// Radius of the hole [mm].
const HOLE: f64 = 4.76;

fn main() -> Result<(), Box<dyn Error>> {
    let mut pictures = vec![
        ("traction", hole_edge_traction().render()?),
        ("family", load_steps().render()?),
        ("convergence", convergence().render()?),
        ("panels", panels().render()?),
    ];
    pictures.extend(ring_fields()?);
    let folder = std::env::args().nth(1).map(PathBuf::from);
    let mut bytes = [0; 2];
    for (name, picture) in &pictures {
        let png = to_png(picture, DEFAULT_SCALE)?;
        bytes[0] += picture.as_str().len();
        bytes[1] += png.len();
        if let Some(folder) = &folder {
            std::fs::create_dir_all(folder)?;
            std::fs::write(folder.join(format!("{name}.svg")), picture.as_str())?;
            std::fs::write(folder.join(format!("{name}.png")), png)?;
        }
    }
    let [svg, png] = bytes.map(|bytes| bytes / 1000);
    println!(
        "{} figures, {svg} kB as SVG, {png} kB as PNG",
        pictures.len()
    );
    let page = page(pictures).render()?;
    if let Some(folder) = &folder {
        std::fs::write(folder.join("page.html"), page)?;
    }
    let peak = Ring::new(8, 24)
        .values(hoop)
        .into_iter()
        .fold(0.0, f64::max);
    // Three times the remote stress.
    assert!((peak - 300.0).abs() < 1e-9);
    println!("largest hoop stress beside the hole: {peak:.1} MPa");
    Ok(())
}

/// Points of `f` at every degree from −180° to 180°.
fn around(f: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    (-180..=180)
        .map(|degree| [f64::from(degree), f(f64::from(degree))])
        .collect()
}

/// A cosine pressure that ends at 82° with a vertical tangent [MPa].
fn pressure(degree: f64) -> f64 {
    let s = (degree / 82.0).abs();
    if s < 1.0 {
        385.0 * (1.0 - s * s).sqrt() * degree.to_radians().cos().powf(0.3)
    } else {
        0.0
    }
}

/// Shear that slips at 0.2 p beyond 38° [MPa].
fn shear(degree: f64) -> f64 {
    let bound = 0.2 * pressure(degree);
    let sticking = 0.2 * pressure(38.0) * (degree / 38.0).clamp(-1.0, 1.0).powi(3);
    sticking.clamp(-bound, bound)
}

fn hole_edge_traction() -> LineChart {
    let hoop = |degree: f64| 610.0 * degree.to_radians().sin().powi(2) - 95.0;
    let zones = [(-180, -82), (-82, -38), (-38, 38), (38, 82), (82, 180)];
    let names = [
        ("open", OPEN),
        ("slip", SLIP),
        ("stick", STICK),
        ("slip", SLIP),
        ("open", OPEN),
    ];
    let mut chart = LineChart::new(
        "Tractions on the hole edge",
        Axis::linear("Angle θ from the bearing point [deg]")
            .between(-180.0, 180.0)
            .every(30.0),
        Axis::linear("Traction, stress [MPa]"),
    )
    .subtitle("Pin-loaded plate, W/D = 6, [45/−45/0/90]s, μ = 0.2, P = 1240 lbf")
    .with(Series::new("CPRESS, contact pressure", around(pressure)))
    .with(Series::new("CSHEAR1, friction", around(shear)).dash(Dash::Dashed))
    .with(Series::new("σθθ, hoop stress in the plate", around(hoop)).dash(Dash::DashDotted))
    .reference(ReferenceLine::horizontal(
        "nominal bearing stress P/(D t)",
        302.0,
    ))
    .reference(ReferenceLine::vertical("contact ends", 82.0))
    .reference(ReferenceLine::vertical("contact ends", -82.0));
    for ((low, high), (name, color)) in zones.into_iter().zip(names) {
        chart = chart.band(Band::new(name, f64::from(low), f64::from(high), color));
    }
    chart
}

fn load_steps() -> LineChart {
    let mut chart = LineChart::new(
        "Friction through one load cycle",
        Axis::linear("Angle θ from the bearing point [deg]")
            .between(0.0, 90.0)
            .every(15.0),
        Axis::linear("CSHEAR1 [MPa]"),
    )
    .subtitle("Seven steps of loading, then seven of unloading")
    .legend(Legend::Right);
    let colors = loading_sequence(7).into_iter().chain(unloading_sequence(7));
    for (step, color) in colors.enumerate() {
        let up = step < 7;
        let load = if up {
            (step + 1) as f64 / 7.0
        } else {
            (13 - step) as f64 / 7.0
        };
        // Reversed slip grows while the load falls, and ends with the contact.
        let share = if up {
            load
        } else {
            load - 2.0 * (1.0 - load) * load.sqrt()
        };
        let at = |degree: f64| {
            let reach = 20.0 + 60.0 * load;
            [degree, share * shear(degree * 80.0 / reach)]
        };
        let points = (0..=180).map(|half| at(f64::from(half) / 2.0)).collect();
        let label = format!(
            "{} P = {:.2} Pmax",
            if up { "loading" } else { "unloading" },
            load
        );
        let dash = if up { Dash::Solid } else { Dash::Dashed };
        chart = chart.with(
            Series::new(label, points)
                .color(color)
                .dash(dash)
                .width(1.5),
        );
    }
    chart
}

fn convergence() -> LineChart {
    let study = |order: i32, constant: f64| -> Vec<[f64; 2]> {
        (0..7)
            .map(|level| 0.5 * 0.5_f64.powi(level))
            .map(|h| [h, constant * h.powi(order) * (1.0 + 0.4 * (9.0 * h).sin())])
            .collect()
    };
    LineChart::new(
        "Error of the contact half-width",
        Axis::log("Element size at the contact edge h/a [–]"),
        Axis::log("Relative error |Δa| / a [–]"),
    )
    .subtitle("Hertz contact of two cylinders, plane strain")
    .with(Series::new("Q4", study(1, 0.31)).style(SeriesStyle::Both))
    .with(Series::new("Q8", study(2, 0.17)).style(SeriesStyle::Both))
    .with(Series::new("Q9, mortar pairs", study(3, 0.08)).style(SeriesStyle::Both))
    .reference(ReferenceLine::horizontal("asked accuracy", 1e-4))
}

fn panels() -> Panels {
    let load: Vec<f64> = (0..=40)
        .map(|k| 1.0 - (f64::from(k) / 20.0 - 1.0).abs())
        .collect();
    let history = |f: &dyn Fn(f64, bool) -> f64| -> Vec<[f64; 2]> {
        load.iter()
            .enumerate()
            .map(|(k, &p)| [k as f64 / 40.0, f(p, k > 20)])
            .collect()
    };
    let zones = LineChart::new(
        "(a) Slip zone",
        Axis::linear("Load time t/T [–]"),
        Axis::linear("Slip angle [deg]"),
    )
    .with(
        Series::new(
            "",
            history(&|p, down| {
                if down {
                    82.0 - 60.0 * p
                } else {
                    30.0 + 22.0 * p
                }
            }),
        )
        .style(SeriesStyle::Step),
    )
    .size(440.0, 0.62);
    let slip = LineChart::new(
        "(b) Slip at θ = 60°",
        Axis::linear("Load time t/T [–]"),
        Axis::linear("CSLIP1 [mm]"),
    )
    .with(Series::new(
        "μ = 0.1",
        history(&|p, down| if down { 2e-5 } else { 3e-5 * p * p }),
    ))
    .with(Series::new(
        "μ = 0.4",
        history(&|p, down| if down { 8e-6 } else { 1e-5 * p * p }),
    ))
    .size(440.0, 0.62);
    Panels::new("One load cycle", 2, vec![zones, slip])
}

/// A half ring of quadratic quadrilaterals.
struct Ring {
    nodes: Vec<[f64; 2]>,
    cells: Vec<Vec<usize>>,
}

impl Ring {
    /// Radii 4.76 mm to 19 mm, `radial` × `around` cells.
    fn new(radial: usize, around: usize) -> Self {
        let (inner, outer) = (HOLE, 19.0_f64);
        let columns = 2 * radial + 1;
        let mut nodes = Vec::new();
        for j in 0..=2 * around {
            let angle = std::f64::consts::PI * j as f64 / (2 * around) as f64;
            for i in 0..columns {
                let r = inner * (outer / inner).powf(i as f64 / (2 * radial) as f64);
                // Exactly on the axis at both ends, so that the halves meet.
                let y = if j % (2 * around) == 0 {
                    0.0
                } else {
                    r * angle.sin()
                };
                nodes.push([r * angle.cos(), y]);
            }
        }
        let border = [
            [0, 0],
            [1, 0],
            [2, 0],
            [2, 1],
            [2, 2],
            [1, 2],
            [0, 2],
            [0, 1],
        ];
        let mut cells = Vec::new();
        for j in 0..around {
            for i in 0..radial {
                let node = |[di, dj]: [usize; 2]| (2 * j + dj) * columns + 2 * i + di;
                cells.push(border.map(node).to_vec());
            }
        }
        Self { nodes, cells }
    }

    fn values(&self, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        self.nodes
            .iter()
            .map(|[x, y]| f(x.hypot(*y), y.atan2(*x)))
            .collect()
    }
}

/// Hoop stress around a hole in a plate that 100 MPa pull along x, after Kirsch (1898).
fn hoop(r: f64, t: f64) -> f64 {
    let part = HOLE / r;
    50.0 * (1.0 + part.powi(2)) - 50.0 * (1.0 + 3.0 * part.powi(4)) * (2.0 * t).cos()
}

/// Hoop and shear stress around that hole.
fn ring_fields() -> Result<Vec<(&'static str, Svg)>, Box<dyn Error>> {
    let (coarse, fine) = (Ring::new(8, 24), Ring::new(80, 300));
    let shear = |r: f64, t: f64| {
        let part = HOLE / r;
        -50.0 * (1.0 + 2.0 * part.powi(2) - 3.0 * part.powi(4)) * (2.0 * t).sin()
    };
    let (hoop_coarse, hoop_fine) = (coarse.values(hoop), fine.values(hoop));
    let shear_coarse = coarse.values(shear);
    let label = "Hoop stress σθθ [MPa]";
    let whole = FieldPlot::new(
        "Plate with a hole",
        label,
        "mm",
        &coarse.nodes,
        &coarse.cells,
        &hoop_coarse,
    )
    .subtitle("100 MPa along x, half model completed by symmetry")
    .mirror([1.0, -1.0, 1.0])
    .with_mesh();
    let signed = FieldPlot::new(
        "Plate with a hole",
        "Shear stress τrθ [MPa]",
        "mm",
        &coarse.nodes,
        &coarse.cells,
        &shear_coarse,
    )
    .colormap(Colormap::BlueWhiteRed)
    .mirror([1.0, -1.0, -1.0]);
    let zoom = FieldPlot::new(
        "Hole edge",
        label,
        "mm",
        &fine.nodes,
        &fine.cells,
        &hoop_fine,
    )
    .subtitle("24 000 cells, colours end at 0 and 250 MPa")
    .between(0.0, 250.0)
    .window([-3.0, 5.0, 2.0, 7.0]);
    let large = FieldPlot::new(
        "Large mesh",
        label,
        "mm",
        &fine.nodes,
        &fine.cells,
        &hoop_fine,
    );
    Ok(vec![
        ("field", whole.render()?),
        ("field_signed", signed.render()?),
        ("field_zoom", zoom.render()?),
        ("field_large", large.render()?),
    ])
}

fn page(pictures: Vec<(&'static str, Svg)>) -> Page {
    let mut zones = Table::new(
        "Contact zones at full load",
        vec![
            Column::new("Zone", ""),
            Column::new("From", "deg"),
            Column::new("To", "deg"),
            Column::new("CPRESS max", "MPa"),
            Column::new("CSHEAR1 max", "MPa"),
            Column::new("CSLIP1 max", "mm"),
        ],
    )
    .note("Angles are counter-clockwise from the bearing point.");
    zones.push(["slip", "−82.0", "−38.0", "322.1", "64.4", "3.1×10⁻³"]);
    zones.push(["stick", "−38.0", "38.0", "385.0", "64.4", "–"]);
    zones.push(["slip", "38.0", "82.0", "322.1", "64.4", "3.1×10⁻³"]);
    println!("{}", zones.to_text(Some(100)));
    let mut figures = Section::new("Figures").with(Block::Table(zones));
    for (name, picture) in pictures {
        let caption = format!("The picture '{name}'. All numbers are made up.");
        figures = figures.with(Block::Figure(Figure::new(picture, caption, name)));
    }
    let mut page = Page::new(
        "Pin in a quasi-isotropic plate",
        "Made-up numbers for the gallery",
    );
    page.warnings = vec!["All numbers are made up.".to_owned()];
    page.summary = [
        ("Peak contact pressure", "385.0 MPa at 0°"),
        ("Contact angle", "±82.0°"),
        ("Stick zone", "±38.0°"),
        ("Bearing load, from contact", "1240.0 lbf"),
        ("Bearing load, from reactions", "1240.0 lbf"),
        ("Estimated error", "0.4 %"),
    ]
    .map(|(name, value)| (name.to_owned(), value.to_owned()))
    .to_vec();
    page.notes = vec!["Half model: geometry, load and lay-up are symmetric.".to_owned()];
    page.sections = vec![
        Section::new("Model").with(Block::Text("A pin of 9.525 mm in a plate.".to_owned())),
        figures,
    ];
    page.footer = String::from("stickslip gallery");
    page
}
