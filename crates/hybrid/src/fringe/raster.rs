//! Pictures as PNG and TIFF.

use std::io::Cursor;

use image::{DynamicImage, ImageBuffer, ImageFormat, ImageReader, Luma};
use stickslip_fem_core::mesh::Point;

use super::{Depth, Frame, FringeError, PixelMap};

/// Formats of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Portable network graphics.
    Png,
    /// Tagged image file format.
    Tiff,
}

/// A grey picture as a file has it: without places.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Grey levels of the file.
    pub depth: Depth,
    /// Intensities row by row, as parts of full scale.
    pub intensities: Vec<f64>,
    /// False where the file marks a pixel as wholly transparent.
    pub opaque: Vec<bool>,
}

impl Raster {
    /// The picture in the plane: `first` is the centre of the pixel of column 0 and row 0 and `step` leads from pixel to pixel
    /// `[length]`, see [`Frame::new`]. Missing are transparent pixels and, if `dark` is given, those of at most that intensity.
    ///
    /// # Errors
    ///
    /// A frame that is none; no pixel that is there.
    pub fn placed(
        self,
        first: Point,
        step: [f64; 2],
        dark: Option<f64>,
    ) -> Result<PixelMap, FringeError> {
        let frame = Frame::new(self.columns, self.rows, first, step)?;
        let lit = |intensity: f64| dark.is_none_or(|dark| intensity > dark);
        let valid = self
            .intensities
            .iter()
            .zip(&self.opaque)
            .map(|(&intensity, &opaque)| opaque && lit(intensity))
            .collect();
        PixelMap::new(frame, self.intensities, valid)
    }
}

/// Grey picture file of intensities, which are parts of full scale: clipped to 0 … 1, rounded to the grey levels, black where
/// missing.
///
/// # Errors
///
/// A picture that is too large for the format.
pub fn encode(picture: &PixelMap, format: Format, depth: Depth) -> Result<Vec<u8>, FringeError> {
    let (columns, rows) = (picture.frame().columns(), picture.frame().rows());
    let unfit = || {
        FringeError::File(format!(
            "{columns} x {rows} pixels are too many for a picture file"
        ))
    };
    let (Ok(width), Ok(height)) = (u32::try_from(columns), u32::try_from(rows)) else {
        return Err(unfit());
    };
    let levels = picture.values().iter().map(|&value| {
        let level = (value * depth.full_scale()).round();
        if level.is_nan() {
            0.0
        } else {
            level.clamp(0.0, depth.full_scale())
        }
    });
    let whole = match depth {
        Depth::Eight => ImageBuffer::<Luma<u8>, _>::from_raw(
            width,
            height,
            levels.map(|level| level as u8).collect(),
        )
        .map(DynamicImage::ImageLuma8),
        Depth::Sixteen => ImageBuffer::<Luma<u16>, _>::from_raw(
            width,
            height,
            levels.map(|level| level as u16).collect(),
        )
        .map(DynamicImage::ImageLuma16),
    };
    let format = match format {
        Format::Png => ImageFormat::Png,
        Format::Tiff => ImageFormat::Tiff,
    };
    let mut bytes = Cursor::new(Vec::new());
    whole
        .ok_or_else(unfit)?
        .write_to(&mut bytes, format)
        .map_err(|cause| FringeError::File(cause.to_string()))?;
    Ok(bytes.into_inner())
}

/// Columns and rows of a PNG or TIFF file's picture, which its first bytes say; nothing of the picture is decoded.
///
/// # Errors
///
/// Bytes that are no such file.
pub fn size(bytes: &[u8]) -> Result<[usize; 2], FringeError> {
    let failed = |cause: String| FringeError::File(cause);
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let dimensions = reader
        .map_err(|cause| failed(cause.to_string()))?
        .into_dimensions();
    let (columns, rows) = dimensions.map_err(|cause| failed(cause.to_string()))?;
    Ok([columns as usize, rows as usize])
}

/// Grey picture of a PNG or TIFF file's bytes, 8 or 16 bits, with or without transparency. Grey levels are taken as proportional
/// to intensity. Colour is refused: which mixture of channels is the intensity, only the maker of the picture knows.
///
/// # Errors
///
/// Bytes that are no such file, or a picture in colour.
pub fn decode(bytes: &[u8]) -> Result<Raster, FringeError> {
    let failed = |cause: image::ImageError| FringeError::File(cause.to_string());
    let (depth, columns, rows, levels, alpha) =
        match image::load_from_memory(bytes).map_err(failed)? {
            DynamicImage::ImageLuma8(grey) => (
                Depth::Eight,
                grey.width(),
                grey.height(),
                wide(grey.as_raw()),
                None,
            ),
            DynamicImage::ImageLuma16(grey) => (
                Depth::Sixteen,
                grey.width(),
                grey.height(),
                grey.into_raw(),
                None,
            ),
            DynamicImage::ImageLumaA8(grey) => {
                let (levels, alpha) = split(&wide(grey.as_raw()));
                (
                    Depth::Eight,
                    grey.width(),
                    grey.height(),
                    levels,
                    Some(alpha),
                )
            }
            DynamicImage::ImageLumaA16(grey) => {
                let (levels, alpha) = split(grey.as_raw());
                (
                    Depth::Sixteen,
                    grey.width(),
                    grey.height(),
                    levels,
                    Some(alpha),
                )
            }
            other => return Err(FringeError::Colour(format!("{:?}", other.color()))),
        };
    let intensities: Vec<_> = levels
        .iter()
        .map(|&level| f64::from(level) / depth.full_scale())
        .collect();
    let opaque = alpha.map_or_else(
        || vec![true; intensities.len()],
        |alpha| alpha.iter().map(|&value| value > 0).collect(),
    );
    Ok(Raster {
        columns: columns as usize,
        rows: rows as usize,
        depth,
        intensities,
        opaque,
    })
}

fn wide(levels: &[u8]) -> Vec<u16> {
    levels.iter().copied().map(u16::from).collect()
}

fn split(pairs: &[u16]) -> (Vec<u16>, Vec<u16>) {
    pairs.chunks_exact(2).map(|pair| (pair[0], pair[1])).unzip()
}
