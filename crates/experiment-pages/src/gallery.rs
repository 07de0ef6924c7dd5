//! Synthetic pictures as files, a gallery, and an experiment file that reads them back.

mod restart;

use std::path::Path;

use stickslip_hybrid::data::Field;
use stickslip_hybrid::fringe::PixelMap;
use stickslip_report::FigureError;
use stickslip_report::chart::tile;
use stickslip_report::color::{Color, Colormap};
use stickslip_report::context;
use stickslip_report::plane::{Marks, Pixels, PlanePlot};
use stickslip_report::prose::Prose;
use stickslip_report::raster::to_png;
use stickslip_report::svg::Svg;
use stickslip_report::table::Table;

use super::report::ExperimentReport;
use stickslip_experiment::{Experiment, State};
use stickslip_measure::ExperimentError;
use stickslip_measure::synthesis::{Camera, Shot, Shots};
use stickslip_scene::units::Unit;
use stickslip_text::{counted, short};

/// Folder of the picture files.
pub(super) const FOLDER: &str = "fringes";
/// Width of one picture on the page \[px\].
const WIDTH: f64 = 360.0;
/// Width of one picture on the sheet of all \[px\], and pictures in a row.
const SMALL: f64 = 200.0;
const IN_A_ROW: usize = 8;

/// How large a picture is shown.
#[derive(Clone, Copy, Debug)]
enum Size {
    Page,
    Sheet,
}

/// The gallery, filled state by state.
#[derive(Debug)]
pub(super) struct Gallery<'a> {
    experiment: &'a Experiment,
    figures: Vec<(usize, Result<Svg, FigureError>)>,
    sheet: Vec<Result<Svg, FigureError>>,
    /// Least and greatest order of either field without carrier, per state.
    extremes: Vec<(usize, [Option<[f64; 2]>; 2])>,
}

impl<'a> Gallery<'a> {
    pub(super) fn new(experiment: &'a Experiment) -> Self {
        Self {
            experiment,
            figures: Vec::new(),
            sheet: Vec::new(),
            extremes: Vec::new(),
        }
    }

    /// Adds the pictures of a state.
    pub(super) fn add(
        &mut self,
        camera: &Camera<'_>,
        state: usize,
        shots: &Shots,
        report: &mut ExperimentReport,
    ) -> Result<(), ExperimentError> {
        for (shot, fields) in shots.iter() {
            for (field, pictures) in Field::BOTH.into_iter().zip(fields) {
                for (name, bytes) in camera.files(state, *shot, field, pictures)? {
                    report.file(
                        format!("{FOLDER}/{name}"),
                        "synthetic fringe pictures of the U and the V field",
                        bytes,
                    );
                }
            }
        }
        if let Some(fields) = shots.get(Shot::State) {
            let both = [0, 1].map(|k| fields[k].pictures.first());
            if let [Some(u), Some(v)] = both {
                let figure = self.figure(state, [u, v]);
                self.figures.push((state, figure));
                let name = &self.experiment.states[state].name;
                for (field, picture) in ["U", "V"].into_iter().zip([u, v]) {
                    self.sheet.push(self.picture(
                        &format!("{field}, {name}"),
                        picture,
                        Size::Sheet,
                    ));
                }
            }
            let carrier = camera.fringes().carrier;
            let range = [0, 1].map(|k| without_carrier(&fields[k].orders, carrier[k]));
            self.extremes.push((state, range));
        }
        report.findings(self.experiment, shots.located(self.experiment, state));
        Ok(())
    }

    fn picture(&self, title: &str, picture: &PixelMap, size: Size) -> Result<Svg, FigureError> {
        let length = self.experiment.display.length;
        let mut plot = picture_plot(title, picture, length).colors(Colormap::Gray, None);
        plot.range = Some([0.0, 1.0]);
        (plot.width, plot.sharpness) = match size {
            Size::Page => (WIDTH, 2.0),
            Size::Sheet => (SMALL, 1.0),
        };
        plot.render()
    }

    fn figure(&self, state: usize, [u, v]: [&PixelMap; 2]) -> Result<Svg, FigureError> {
        let drawn = [
            self.picture("U field", u, Size::Page)?,
            self.picture("V field", v, Size::Page)?,
        ];
        tile(&caption(self.experiment, state), 2, &drawn)
    }

    /// All pictures on one sheet, as PNG.
    fn sheet(&mut self) -> Result<Vec<u8>, FigureError> {
        let drawn: Result<Vec<Svg>, FigureError> = self.sheet.drain(..).collect();
        to_png(&tile(&self.experiment.title, IN_A_ROW, &drawn?)?, 1.0)
    }

    /// Puts the gallery on the page, and the experiment file that restarts from its pictures into the folder.
    pub(super) fn report(
        &mut self,
        camera: &Camera<'_>,
        folder: &Path,
        report: &mut ExperimentReport,
    ) {
        report.section("Fringe pictures");
        report.prose(self.introduction(camera));
        report.table(self.table());
        let experiment = self.experiment;
        report.answer("Fringe pictures", counted(experiment.states.len(), "state"));
        for (state, figure) in std::mem::take(&mut self.figures) {
            let name = format!("fringes-{}", experiment.states[state].name);
            let text = format!(
                "U (left) and V (right) fringe pictures, {}.",
                caption(experiment, state)
            );
            report.figure(&name, &text, figure);
        }
        match self.sheet() {
            Ok(bytes) => report.file("gallery.png", "all pictures on one sheet", bytes),
            Err(cause) => report.warn(format!(
                "The sheet of all pictures cannot be drawn: {cause}."
            )),
        }
        let fringes = camera.fringes();
        if !fringes.four && fringes.carrier.contains(&[0.0; 2]) {
            report.answer(
                "measured.toml",
                "not written: single pictures without a carrier cannot be read back, because they do not show whether orders rise or fall. \
                 State a carrier, or pictures = \"four\""
                    .to_owned(),
            );
            return;
        }
        match restart::text(experiment, camera, folder) {
            Ok(text) => report.file(
                "measured.toml",
                "an experiment file that reads these pictures as measured ones",
                text.into_bytes(),
            ),
            Err(cause) => report.warn(format!(
                "The experiment file that would read these pictures cannot be written: {cause}."
            )),
        }
    }

    /// How the pictures are made.
    fn introduction(&self, camera: &Camera<'_>) -> Prose {
        let (fringes, frame) = (camera.fringes(), camera.frame());
        let exposure = &fringes.exposure;
        let carrier = fringes.carrier.as_flattened();
        let positive = |value: f64| (value > 0.0).then(|| short(value));
        Prose::new(
            include_str!("gallery/text.jinja"),
            context! {
                frequency => short(camera.grating().frequency()),
                fringe => short(1e3 * camera.grating().displacement(1.0)),
                pixels => format!("{} × {}", frame.columns(), frame.rows()),
                pixel => self.experiment.display.length.show(fringes.pixel),
                carrier => (carrier != [0.0; 4]).then(|| carrier.iter().map(|own| short(*own)).collect::<Vec<_>>()),
                order_error => positive(exposure.order_error),
                speckle => exposure.speckle_patterns.map(|count| count.to_string()),
                noise => positive(exposure.noise),
                levels => exposure_levels(fringes).to_string(),
            },
        )
    }

    fn table(&self) -> Table {
        let force = self.experiment.display.force;
        let headings = format!(
            "state | load [{}] | direction | U orders, from [fringes] | to [fringes] | V orders, from [fringes] | to [fringes]",
            force.name
        );
        let mut table = Table::headed("Orders in the window, without carrier", &headings);
        for (state, ranges) in &self.extremes {
            let own = &self.experiment.states[*state];
            let load = own.load.map(|load| short(force.from_base(load)));
            let direction = own.direction.name().to_owned();
            let mut row = vec![own.name.clone(), load.unwrap_or_default(), direction];
            for range in ranges {
                row.extend(
                    range
                        .unwrap_or([f64::NAN; 2])
                        .map(|end| format!("{end:.2}")),
                );
            }
            table.push(row);
        }
        table
    }
}

fn exposure_levels(fringes: &stickslip_experiment::Fringes) -> f64 {
    fringes.depth.full_scale() + 1.0
}

fn without_carrier(orders: &PixelMap, carrier: [f64; 2]) -> Option<[f64; 2]> {
    let values = orders.present().map(|(pixel, order)| {
        let place = orders.frame().place(pixel);
        order - carrier[0] * place[0] - carrier[1] * place[1]
    });
    values.fold(None, |range, value| {
        let [low, high] = range.unwrap_or([value; 2]);
        Some([value.min(low), value.max(high)])
    })
}

/// "up, 1250 lbf, loading".
pub(super) fn caption(experiment: &Experiment, state: usize) -> String {
    let State {
        name,
        load,
        direction,
        ..
    } = &experiment.states[state];
    let force = experiment.display.force;
    match load {
        Some(load) => format!("{name}, {}, {}", force.show(*load), direction.name()),
        None => format!("{name}, {}", direction.name()),
    }
}

/// The edge of the hole at some angles `[rad]`.
pub(super) fn edge_of_hole(experiment: &Experiment, angles: impl Iterator<Item = f64>) -> Marks {
    let unit = experiment.display.length;
    let hole = experiment.specimen.hole;
    let path = angles.map(|angle| {
        let (sin, cos) = angle.sin_cos();
        [
            unit.from_base(hole.centre[0] + hole.radius * cos),
            unit.from_base(hole.centre[1] + hole.radius * sin),
        ]
    });
    Marks {
        paths: vec![path.collect()],
        ..Marks::new("edge of the hole", Color::rgb(0x22, 0x22, 0x22))
    }
}

/// A plot of a picture's pixels over its own window, in a unit of length.
pub(super) fn picture_plot<'a>(title: &str, picture: &'a PixelMap, unit: &Unit) -> PlanePlot<'a> {
    let edges = edges(picture, unit);
    PlanePlot::new(title, unit.name, edges).pixels(Pixels {
        columns: picture.frame().columns(),
        values: picture.values(),
        edges,
    })
}

/// Edges of a picture in a unit of length, `[x_low, x_high, y_low, y_high]`.
pub(super) fn edges(picture: &PixelMap, unit: &Unit) -> [f64; 4] {
    let frame = picture.frame();
    let (first, last) = (
        frame.place(0),
        frame.place(frame.pixels().saturating_sub(1)),
    );
    let step = frame.step();
    let [left, right] = [first[0] - 0.5 * step[0], last[0] + 0.5 * step[0]];
    let [top, bottom] = [first[1] - 0.5 * step[1], last[1] + 0.5 * step[1]];
    [
        left.min(right),
        left.max(right),
        top.min(bottom),
        top.max(bottom),
    ]
    .map(|x| unit.from_base(x))
}

/// Name of a field for keys and files.
pub(super) fn letter(field: Field) -> String {
    field.name().to_lowercase()
}
