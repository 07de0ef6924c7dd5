//! Fields on meshes: colours between nodes, outline, optional mesh lines, colour bar.
//!
//! ```text
//! x(ξ, η) = Σ Nᵢ(ξ, η) xᵢ        v(ξ, η) = Σ Nᵢ(ξ, η) vᵢ
//! ```
//!
//! A cell is the loop of its border nodes, in order: 3 and 4 nodes are linear, 6 and 8
//! are quadratic with mid-side nodes between the corners (c₀ m₀ c₁ m₁ …), so curved
//! edges stay curved; any other number is a polygon around its mean. N are the usual
//! Lagrange and serendipity functions (Zienkiewicz & Taylor, 2000). Each cell is cut
//! into pieces of one colour, small enough that steps are not seen; a large mesh is
//! painted pixel by pixel into an image inside the SVG.

pub(crate) mod color_bar;
mod contour;
mod layout;
mod outline;
mod patch;
mod pixels;
mod plot;
mod shading;

pub use plot::FieldPlot;

use crate::axis::{Axis, Padding, Span};
use crate::error::{FigureError, check_cells};
use crate::frame::OUTER;
use crate::image::Image;
use crate::svg::{Canvas, Svg};
use contour::Contour;
use layout::Layout;
use patch::Patch;

impl FieldPlot<'_> {
    /// Draws the field.
    ///
    /// # Errors
    /// [`FigureError::ValueCount`], [`FigureError::Node`] and [`FigureError::Cell`] for a
    /// mesh that does not fit together; [`FigureError::NoData`] if no cell or value is in
    /// sight; [`FigureError::Range`] and [`FigureError::Size`] for a window, a range or a
    /// width that cannot be drawn; [`FigureError::Raster`] if the image of a large mesh
    /// cannot be written.
    pub fn render(&self) -> Result<Svg, FigureError> {
        self.check()?;
        let patches = patch::visible(self);
        let extent = self.extent(&patches)?;
        let seen: Vec<[f64; 3]> = patches
            .iter()
            .flat_map(|patch| patch.corners().iter().copied())
            .filter(|corner| self.in_window([corner[0], corner[1]]) && corner[2].is_finite())
            .collect();
        let bar = self.bar_axis();
        let range = self.value_span(&bar, &patches, &seen)?;
        let layout = Layout::new(self, extent, &bar, &range, extremes(&seen).as_ref())?;
        self.draw(&patches, &layout, &range, &seen)
    }

    fn draw(
        &self,
        patches: &[Patch],
        layout: &Layout,
        range: &Span,
        seen: &[[f64; 3]],
    ) -> Result<Svg, FigureError> {
        let frame = &layout.frame;
        let paint = shading::Paint::new(frame, range, self.colormap);
        let image = pixels::painted(&paint, patches);
        let png = image.as_ref().map(Image::png).transpose();
        let png = png.map_err(|cause| FigureError::Raster {
            width: frame.area.width,
            height: frame.area.height,
            scale: pixels::SCALE,
            reason: cause.to_string(),
        })?;
        let mut canvas = Canvas::default();
        layout.heading.draw(&mut canvas, [OUTER, OUTER]);
        canvas.clipped(&frame.area, |canvas| {
            match image.zip(png) {
                Some((image, png)) => canvas.image(&frame.area, image, png),
                None => shading::fill(canvas, &paint, patches),
            }
            if let Some(level) = self.contour {
                let mut line = Contour::new(frame, level);
                for patch in patches {
                    if !line.meets(patch.corners()) {
                        continue;
                    }
                    patch.pieces(contour::CUTS, |piece| line.add(piece));
                }
                line.draw(canvas);
            }
            outline::draw(canvas, self, frame, patches.len());
        });
        frame.draw_axes(&mut canvas);
        let beyond = [
            seen.iter().any(|value| value[2] < range.low),
            seen.iter().any(|value| value[2] > range.high),
        ];
        color_bar::draw(&mut canvas, &layout.bar, self.colormap, beyond);
        Ok(canvas.finish(layout.width, layout.height, &self.title))
    }

    fn check(&self) -> Result<(), FigureError> {
        let title = || self.title.clone();
        let (nodes, values) = (self.nodes.len(), self.values.len());
        if nodes != values {
            return Err(FigureError::ValueCount {
                title: title(),
                values,
                nodes,
            });
        }
        if let Some(node) = self
            .nodes
            .iter()
            .position(|p| !(p[0].is_finite() && p[1].is_finite()))
        {
            let [x, y] = self.nodes[node];
            return Err(FigureError::Node {
                title: title(),
                node,
                x,
                y,
            });
        }
        check_cells(&self.title, nodes, self.cells)
    }

    fn in_window(&self, [x, y]: [f64; 2]) -> bool {
        self.window.is_none_or(|[x_low, x_high, y_low, y_high]| {
            (x_low..=x_high).contains(&x) && (y_low..=y_high).contains(&y)
        })
    }

    /// The ends of the x and y axes: the window, or the mesh with a little room.
    fn extent(&self, patches: &[Patch]) -> Result<[Span; 2], FigureError> {
        let [x, y] = self.coordinate_axes();
        let along = |axis: usize| {
            patches
                .iter()
                .flat_map(move |patch| patch.corners().iter().map(move |c| c[axis]))
        };
        Ok([
            x.span(along(0), Padding::Loose)?,
            y.span(along(1), Padding::Loose)?,
        ])
    }

    fn coordinate_axes(&self) -> [Axis; 2] {
        let mut axes = self.axes.clone().map(Axis::linear);
        if let Some([x_low, x_high, y_low, y_high]) = self.window {
            axes[0].range = Some([x_low, x_high]);
            axes[1].range = Some([y_low, y_high]);
        }
        axes
    }

    fn bar_axis(&self) -> Axis {
        Axis {
            range: self.range,
            ..Axis::linear(self.label.clone())
        }
    }

    /// The values at the ends of the colour bar.
    fn value_span(
        &self,
        bar: &Axis,
        patches: &[Patch],
        seen: &[[f64; 3]],
    ) -> Result<Span, FigureError> {
        let mut values: Vec<f64> = seen.iter().map(|corner| corner[2]).collect();
        if values.is_empty() {
            // The window lies inside cells and shows no node.
            values = patches
                .iter()
                .flat_map(|p| p.corners().iter().map(|c| c[2]))
                .collect();
        }
        color_bar::span(bar, self.colormap, values.into_iter())
    }
}

/// Where the least and the largest value are first met, as (x, y, value).
fn extremes(seen: &[[f64; 3]]) -> Option<[[f64; 3]; 2]> {
    let first = *seen.first()?;
    Some(seen.iter().fold([first, first], |[least, largest], &node| {
        [
            if node[2] < least[2] { node } else { least },
            if node[2] > largest[2] { node } else { largest },
        ]
    }))
}
