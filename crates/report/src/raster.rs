//! SVG → PNG, with the embedded DejaVu Sans, so that a picture is the same on every
//! machine. The fonts are free (Bitstream Vera licence, DejaVu changes public domain).

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::error::FigureError;
use crate::svg::Svg;

/// PNG pixels per figure pixel for screens and print.
pub const DEFAULT_SCALE: f64 = 2.0;
/// Longest side of a picture \[PNG pixels\].
const LONGEST_SIDE: f64 = 20_000.0;

static FONTS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_source(fontdb::Source::Binary(Arc::new(dejavu::sans::regular())));
    fonts.load_font_source(fontdb::Source::Binary(Arc::new(dejavu::sans::bold())));
    fonts.set_sans_serif_family("DejaVu Sans");
    Arc::new(fonts)
});

/// The picture as a PNG file on white, `scale` PNG pixels per figure pixel.
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
    let options = Options {
        fontdb: Arc::clone(&FONTS),
        ..Options::default()
    };
    let tree =
        Tree::from_str(picture.as_str(), &options).map_err(|cause| fail(cause.to_string()))?;
    let mut pixels = Pixmap::new(width as u32, height as u32)
        .ok_or_else(|| fail("not enough memory".to_owned()))?;
    pixels.fill(resvg::tiny_skia::Color::WHITE);
    let scale = scale as f32;
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    pixels.encode_png().map_err(|cause| fail(cause.to_string()))
}
