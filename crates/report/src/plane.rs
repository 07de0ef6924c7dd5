//! Pictures of pixels and values at scattered places in one plane, with marks over them.
//!
//! Pixels are averaged where there are more of them than the figure shows, except in cyclic colours, whose mean is no colour of
//! theirs; there the nearest one is shown.

mod image;
mod plot;

use crate::axis::{Axis, Padding, Span};
use crate::color::{Color, Colormap};
use crate::error::FigureError;
use crate::field::color_bar::{self, ColorBar};
use crate::frame::{Frame, Heading, OUTER, TICK_SIZE, TITLE_SIZE};
use crate::legend::{self, Category};
use crate::markup::push_point;
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::{Canvas, Svg};
use plot::no_value;
pub use plot::{Marks, Pixels, PlanePlot};

/// Room left of the plot for ticks and label, and right of it \[px\].
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const BAR_GAP: f64 = 16.0;

impl<'a> PlanePlot<'a> {
    /// Makes an empty plane with axes in `length_unit`, which is the unit of `window` too.
    pub fn new(title: impl Into<String>, length_unit: &str, window: [f64; 4]) -> Self {
        Self {
            title: title.into(),
            subtitle: None,
            pixels: None,
            dots: &[],
            marks: Vec::new(),
            label: None,
            axes: ["x", "y"].map(|name| format!("{name} [{length_unit}]")),
            colormap: Colormap::Viridis,
            range: None,
            window,
            width: 480.0,
            sharpness: 2.0,
        }
    }

    /// Shows values at pixels.
    #[must_use]
    pub fn pixels(mut self, pixels: Pixels<'a>) -> Self {
        self.pixels = Some(pixels);
        self
    }

    /// Sets colours and, with a name and unit, a colour bar.
    #[must_use]
    pub fn colors(mut self, colormap: Colormap, label: Option<String>) -> Self {
        self.colormap = colormap;
        self.label = label;
        self
    }

    /// Draws the picture, with equal scales on both axes.
    ///
    /// # Errors
    /// [`FigureError::ValueCount`] for pixels that are no rectangle, [`FigureError::NoData`] without any value,
    /// [`FigureError::Range`] and [`FigureError::Size`] for a window, range or width that cannot be drawn, and
    /// [`FigureError::Raster`] if the image cannot be written.
    pub fn render(&self) -> Result<Svg, FigureError> {
        self.check()?;
        let range = self.value_span()?;
        let subtitle = self.subtitle.as_deref().unwrap_or_default();
        let heading = Heading::new(
            &self.title,
            TITLE_SIZE,
            &[subtitle],
            self.width - 2.0 * OUTER,
        );
        let area = Area::new(
            [LEFT, OUTER + heading.height() + 6.0],
            [self.width - LEFT - RIGHT - self.bar_room(&range)?, 0.0],
        );
        let frame = Frame::to_scale(&self.axes, self.window, area, (&self.title, self.width))?;
        self.draw(&frame, &range, &heading)
    }

    fn draw(&self, frame: &Frame, range: &Span, heading: &Heading) -> Result<Svg, FigureError> {
        let area = frame.area;
        let image = image::painted(self, &area, range);
        let png = image.as_ref().map(|(_, image)| image.png()).transpose();
        let png = png.map_err(|cause| FigureError::Raster {
            width: area.width,
            height: area.height,
            scale: self.sharpness,
            reason: cause.to_string(),
        })?;
        let mut canvas = Canvas::default();
        heading.draw(&mut canvas, [OUTER, OUTER]);
        canvas.clipped(&area, |canvas| {
            if let Some(((area, image), png)) = image.zip(png) {
                canvas.image(&area, image, png);
            }
            self.draw_dots(canvas, frame, range);
            for marks in &self.marks {
                draw_marks(canvas, frame, marks);
            }
        });
        frame.draw_axes(&mut canvas);
        if let Some(bar) = self.bar(range, [area.right() + BAR_GAP, area.top], area.height)? {
            let beyond = [
                self.values().any(|value| value < range.low),
                self.values().any(|value| value > range.high),
            ];
            color_bar::draw(&mut canvas, &bar, self.colormap, beyond);
        }
        let mut bottom = area.bottom() + frame.bottom_margin();
        if !self.marks.is_empty() {
            let category = |marks: &Marks| Category {
                label: marks.label.clone(),
                mark: String::new(),
                color: marks.color,
            };
            let categories: Vec<Category> = self.marks.iter().map(category).collect();
            let all: Vec<usize> = (0..categories.len()).collect();
            bottom = legend::draw(&mut canvas, &categories, &all, self.width, bottom + 8.0);
        }
        Ok(canvas.finish(self.width, bottom + OUTER, &self.title))
    }

    fn check(&self) -> Result<(), FigureError> {
        if let Some(pixels) = &self.pixels
            && (pixels.columns == 0 || !pixels.values.len().is_multiple_of(pixels.columns))
        {
            return Err(FigureError::ValueCount {
                title: self.title.clone(),
                values: pixels.values.len(),
                nodes: pixels.columns,
            });
        }
        Ok(())
    }

    /// All values that there are.
    fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let pixels = self.pixels.iter().flat_map(|pixels| pixels.values);
        let dots = self.dots.iter().map(|(_, value)| value);
        pixels
            .chain(dots)
            .copied()
            .filter(|value| value.is_finite())
    }

    fn bar_axis(&self) -> Axis {
        Axis {
            range: self.range,
            ..Axis::linear(self.label.clone().unwrap_or_else(|| self.title.clone()))
        }
    }

    fn value_span(&self) -> Result<Span, FigureError> {
        let nothing = self.pixels.is_none() && self.dots.is_empty();
        let axis = self.bar_axis();
        if nothing {
            return axis.span([0.0, 1.0].into_iter(), Padding::Tight);
        }
        color_bar::span(&axis, self.colormap, self.values())
    }

    fn bar(
        &self,
        range: &Span,
        at: [f64; 2],
        height: f64,
    ) -> Result<Option<ColorBar>, FigureError> {
        // Room for the points at both ends.
        const ENDS: f64 = 13.0;
        if self.label.is_none() {
            return Ok(None);
        }
        let height = (height - 2.0 * ENDS).max(40.0);
        ColorBar::new(&self.bar_axis(), range, [at[0], at[1] + ENDS], height).map(Some)
    }

    fn bar_room(&self, range: &Span) -> Result<f64, FigureError> {
        let bar = self.bar(range, [0.0; 2], 300.0)?;
        Ok(bar.map_or(0.0, |bar| bar.width() + BAR_GAP))
    }

    fn color(&self, range: &Span, value: f64) -> Color {
        match range.fraction(value) {
            Some(fraction) if value.is_finite() => self.colormap.at(fraction),
            _ => no_value(self.colormap),
        }
    }

    fn draw_dots(&self, canvas: &mut Canvas, frame: &Frame, range: &Span) {
        if self.dots.is_empty() {
            return;
        }
        // Dots of a dense field touch each other, and few ones can still be seen.
        let each = (frame.area.width * frame.area.height / self.dots.len() as f64).sqrt();
        let size = (1.05 * each).clamp(1.2, 9.0);
        for &(place, value) in self.dots {
            if let Some([x, y]) = frame.pixel(place) {
                let area = Area::new([x - size / 2.0, y - size / 2.0], [size, size]);
                canvas.rectangle(&area, self.color(range, value), None);
            }
        }
    }
}

fn draw_marks(canvas: &mut Canvas, frame: &Frame, marks: &Marks) {
    const ARM: f64 = 3.0;
    let mut data = String::new();
    for place in &marks.points {
        if let Some([x, y]) = frame.pixel(*place) {
            push_point(&mut data, 'M', [x - ARM, y - ARM]);
            push_point(&mut data, 'L', [x + ARM, y + ARM]);
            push_point(&mut data, 'M', [x - ARM, y + ARM]);
            push_point(&mut data, 'L', [x + ARM, y - ARM]);
        }
    }
    for path in &marks.paths {
        let pixels = path.iter().filter_map(|place| frame.pixel(*place));
        for (k, pixel) in pixels.enumerate() {
            push_point(&mut data, if k == 0 { 'M' } else { 'L' }, pixel);
        }
    }
    canvas.stroked_path(&data, &Stroke::solid(marks.color, marks.width));
    let style = TextStyle::new(TICK_SIZE, marks.color, Anchor::Middle);
    for (place, text) in &marks.texts {
        if let Some([x, y]) = frame.pixel(*place) {
            canvas.text([x, y + 0.35 * TICK_SIZE], text, &style);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: [f64; 4] = [0.0, 2.0, 0.0, 1.0];

    #[test]
    fn a_plane_shows_pixels_dots_and_marks() {
        let values: Vec<f64> = (0..200).map(f64::from).collect();
        let pixels = Pixels {
            columns: 20,
            values: &values,
            edges: WINDOW,
        };
        let mut plot = PlanePlot::new("Orders", "mm", WINDOW)
            .pixels(pixels)
            .colors(Colormap::Viridis, Some("N [fringes]".into()));
        plot.dots = &[([0.5, 0.5], 3.0), ([0.7, 0.5], f64::NAN)];
        plot.marks = vec![Marks {
            points: vec![[1.0, 0.5]],
            paths: vec![vec![[0.1, 0.1], [0.2, 0.2]]],
            ..Marks::new("inconsistent", Color::category(1))
        }];
        let svg = plot.render().unwrap();
        for part in ["<image", "N [fringes]", "inconsistent", "#e4e4e4", "x [mm]"] {
            assert!(svg.as_str().contains(part), "{part}");
        }
        assert_eq!(svg, plot.render().unwrap());
        roxmltree::Document::parse(svg.as_str()).unwrap();
    }

    #[test]
    fn a_legend_names_each_colour_once() {
        let named = |colors: &[usize]| {
            let mut plot = PlanePlot::new("Scene", "mm", WINDOW);
            let marks = |&color: &usize| Marks {
                points: vec![[1.0, 0.5]],
                ..Marks::new("held", Color::category(color))
            };
            plot.marks = colors.iter().map(marks).collect();
            plot.render().unwrap().as_str().matches("held").count()
        };
        assert_eq!(named(&[1, 2, 1]), 2 * named(&[1]));
        assert_eq!(named(&[1, 1]), named(&[1]));
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        let plot = PlanePlot::new("p", "mm", WINDOW);
        let uneven = |values, columns| {
            let pixels = Pixels {
                columns,
                values,
                edges: WINDOW,
            };
            plot.clone().pixels(pixels).render()
        };
        assert!(matches!(
            uneven(&[1.0; 3], 2),
            Err(FigureError::ValueCount { .. })
        ));
        assert!(matches!(
            uneven(&[1.0; 3], 0),
            Err(FigureError::ValueCount { .. })
        ));
        assert!(matches!(
            uneven(&[f64::NAN; 4], 2),
            Err(FigureError::NoData { .. })
        ));
        let thin = PlanePlot::new("p", "mm", [0.0, 1.0, 0.0, 1e-6]);
        assert!(matches!(thin.render(), Err(FigureError::Size { .. })));
    }
}
