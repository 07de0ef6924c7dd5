//! Pictures as PNG files, with the embedded DejaVu Sans, so that they are the same on every
//! machine. The fonts are free (Bitstream Vera licence, DejaVu changes public domain).

mod glyphs;
mod outline;
mod palette;

use tiny_skia::{
    FillRule, FilterQuality, LineJoin, Mask, Paint, Path, PathBuilder, Pattern, Pixmap,
    PremultipliedColorU8, Rect, SpreadMode, StrokeDash, Transform,
};

use crate::color::Color;
use crate::error::FigureError;
use crate::image::Image;
use crate::shape::{Anchor, Area, Shape, Stroke, TextStyle};
use crate::svg::Svg;

/// PNG pixels per figure pixel \[1\] for screens and print.
pub const DEFAULT_SCALE: f64 = 2.0;
/// Longest side of a picture \[PNG pixels\].
const LONGEST_SIDE: f64 = 20_000.0;

/// Draws a picture as a PNG file on white, `scale` PNG pixels per figure pixel \[1\], in at most 256 colours.
///
/// Pictures of at most 256 colours are exact; of others the blends on edges may differ by what is not seen.
///
/// # Errors
/// [`FigureError::Raster`] for a scale that is not positive or gives a side of more
/// than 20 000 pixels.
pub fn to_png(picture: &Svg, scale: f64) -> Result<Vec<u8>, FigureError> {
    let fail = |reason: String| FigureError::Raster {
        width: picture.width(),
        height: picture.height(),
        scale,
        reason,
    };
    let width = (picture.width() * scale).ceil();
    let height = (picture.height() * scale).ceil();
    let drawable = |side: f64| (1.0..=LONGEST_SIDE).contains(&side);
    if !drawable(width) || !drawable(height) {
        return Err(fail(format!(
            "its sides must have 1 to {LONGEST_SIDE} pixels"
        )));
    }
    let mut pixels = Pixmap::new(width as u32, height as u32)
        .ok_or_else(|| fail("not enough memory".to_owned()))?;
    pixels.fill(tiny_skia::Color::WHITE);
    let scale = scale as f32;
    let mut raster = Raster {
        pixels,
        place: Transform::from_scale(scale, scale),
        clip: None,
    };
    raster.draw_all(&picture.picture().shapes);
    let image = palette::reduced(raster.pixels.pixels(), width as usize);
    image.png().map_err(|cause| fail(cause.to_string()))
}

/// Pixels being drawn.
struct Raster {
    pixels: Pixmap,
    /// From the figure to pixels.
    place: Transform,
    clip: Option<Clip>,
}

/// The part that is drawn.
#[derive(Clone)]
struct Clip {
    /// In pixels.
    bounds: Rect,
    mask: Mask,
}

impl Raster {
    fn draw_all(&mut self, shapes: &[Shape]) {
        for shape in shapes {
            self.draw(shape);
        }
    }

    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Rectangle {
                area,
                fill,
                outline,
            } => {
                let Some(rect) = rect(area) else { return };
                let path = PathBuilder::from_rect(rect);
                self.fill(&path, *fill, Transform::identity());
                if let Some(stroke) = outline {
                    self.stroke(&path, stroke, LineJoin::Miter);
                }
            }
            Shape::Line { ends, stroke } => {
                let mut line = PathBuilder::new();
                let [from, to] = ends.map(|end| end.map(|length| length as f32));
                line.move_to(from[0], from[1]);
                line.line_to(to[0], to[1]);
                if let Some(path) = line.finish() {
                    self.stroke(&path, stroke, LineJoin::Miter);
                }
            }
            Shape::Path { data, fill, stroke } => {
                let Some(path) = outline::path(data) else {
                    return;
                };
                if let Some(fill) = fill {
                    self.fill(&path, *fill, Transform::identity());
                }
                self.stroke(&path, stroke, LineJoin::Round);
            }
            Shape::Text { at, text, style } => self.text(*at, text, style),
            Shape::Image { area, image, .. } => self.image(area, image),
            Shape::Clipped { area, shapes } => {
                let outer = self.clip.clone();
                if self.clip_to(area) {
                    self.draw_all(shapes);
                }
                self.clip = outer;
            }
            Shape::Placed { at, picture } => {
                let outer = self.place;
                self.place = outer.pre_translate(at[0] as f32, at[1] as f32);
                self.draw_all(&picture.shapes);
                self.place = outer;
            }
        }
    }

    /// Restricts drawing to an area; false if nothing of the picture is left.
    fn clip_to(&mut self, area: &Area) -> bool {
        let Some(rect) = rect(area) else { return false };
        let Some(bounds) = rect.transform(self.place) else {
            return false;
        };
        let path = PathBuilder::from_rect(rect);
        let clip = match self.clip.take() {
            Some(mut clip) => {
                clip.mask
                    .intersect_path(&path, FillRule::Winding, true, self.place);
                clip.bounds
                    .intersect(&bounds)
                    .map(|bounds| Clip { bounds, ..clip })
            }
            None => Mask::new(self.pixels.width(), self.pixels.height()).map(|mut mask| {
                mask.fill_path(&path, FillRule::Winding, true, self.place);
                Clip { bounds, mask }
            }),
        };
        self.clip = clip;
        self.clip.is_some()
    }

    /// The mask for what lies within `bounds` \[figure\]; none where all of it is inside.
    fn mask(clip: Option<&Clip>, bounds: Option<Rect>, place: Transform) -> Option<&Mask> {
        let clip = clip?;
        let shown = bounds.and_then(|bounds| bounds.transform(place));
        let inside = shown.is_some_and(|shown| {
            shown.left() >= clip.bounds.left()
                && shown.right() <= clip.bounds.right()
                && shown.top() >= clip.bounds.top()
                && shown.bottom() <= clip.bounds.bottom()
        });
        (!inside).then_some(&clip.mask)
    }

    fn fill(&mut self, path: &Path, color: Color, own: Transform) {
        let place = self.place.pre_concat(own);
        let mask = Self::mask(self.clip.as_ref(), Some(path.bounds()), place);
        let paint = paint(color);
        self.pixels
            .fill_path(path, &paint, FillRule::Winding, place, mask);
    }

    fn stroke(&mut self, path: &Path, stroke: &Stroke, join: LineJoin) {
        let width = stroke.width as f32;
        let lengths = stroke.dashes.iter().map(|length| *length as f32);
        let style = tiny_skia::Stroke {
            width,
            line_join: join,
            dash: StrokeDash::new(lengths.collect(), 0.0),
            ..tiny_skia::Stroke::default()
        };
        // Corners of a rectangle reach beyond its sides by less than the width.
        let bounds = path.bounds().outset(width, width);
        let mask = Self::mask(self.clip.as_ref(), bounds, self.place);
        self.pixels
            .stroke_path(path, &paint(stroke.color), &style, self.place, mask);
    }

    fn text(&mut self, [x, y]: [f64; 2], text: &str, style: &TextStyle) {
        let line = glyphs::line(text, style.weight);
        let Some(path) = &line.path else { return };
        let size = style.size as f32;
        let before = match style.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -line.width / 2.0,
            Anchor::End => -line.width,
        };
        let mut own = Transform::from_translate(x as f32, y as f32);
        if style.upwards {
            own = own.pre_concat(Transform::from_rotate(-90.0));
        }
        let own = own.pre_scale(size, size).pre_translate(before, 0.0);
        self.fill(path, style.color, own);
    }

    fn image(&mut self, area: &Area, image: &Image) {
        let Some(pixels) = pixmap(image) else { return };
        let Some(rect) = rect(area) else { return };
        let stretch = Transform::from_row(
            rect.width() / pixels.width() as f32,
            0.0,
            0.0,
            rect.height() / pixels.height() as f32,
            rect.left(),
            rect.top(),
        );
        let shown = [
            stretch.sx * self.place.sx * pixels.width() as f32,
            stretch.sy * self.place.sy * pixels.height() as f32,
        ];
        // Between pixels as large as the picture's there is nothing to find.
        let filter = if is_of_its_size(shown, &pixels) {
            FilterQuality::Nearest
        } else {
            FilterQuality::Bilinear
        };
        let paint = Paint {
            shader: Pattern::new(pixels.as_ref(), SpreadMode::Pad, filter, 1.0, stretch),
            ..Paint::default()
        };
        let mask = Self::mask(self.clip.as_ref(), Some(rect), self.place);
        self.pixels.fill_rect(rect, &paint, self.place, mask);
    }
}

/// Whether an image is `shown` as wide and as high as it is, to a pixel from end to end.
fn is_of_its_size([width, height]: [f32; 2], pixels: &Pixmap) -> bool {
    let [own_width, own_height] = [pixels.width(), pixels.height()].map(|count| count as f32);
    (width - own_width).abs() < 1.0 && (height - own_height).abs() < 1.0
}

fn rect(area: &Area) -> Option<Rect> {
    let sides = [area.left, area.top, area.width, area.height];
    let [left, top, width, height] = sides.map(|length| length as f32);
    Rect::from_xywh(left, top, width, height)
}

fn paint(color: Color) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(color.red, color.green, color.blue, 255);
    paint
}

fn pixmap(image: &Image) -> Option<Pixmap> {
    let mut pixels = Pixmap::new(image.width as u32, image.height() as u32)?;
    let opaque = |color: &Color| {
        PremultipliedColorU8::from_rgba(color.red, color.green, color.blue, u8::MAX)
    };
    let mut colors: Vec<Option<PremultipliedColorU8>> = image.palette.iter().map(opaque).collect();
    if image.is_first_transparent {
        colors[0] = None;
    }
    for (pixel, index) in pixels.pixels_mut().iter_mut().zip(&image.indices) {
        // What is not drawn stays transparent.
        if let Some(color) = colors.get(usize::from(*index)).copied().flatten() {
            *pixel = color;
        }
    }
    Some(pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_of_their_own_size_are_not_interpolated() {
        let pixels = Pixmap::new(2000, 30).expect("pixels");
        assert!(is_of_its_size([2000.0, 30.4], &pixels));
        for other in [[2000.0, 60.0], [2002.0, 30.0], [1000.0, 15.0]] {
            assert!(!is_of_its_size(other, &pixels), "{other:?}");
        }
    }
}
