//! Pictures as PNG and TIFF.

use std::io::Cursor;

use stickslip_fem_core::mesh::Point;
use tiff::ColorType;
use tiff::decoder::{Decoder as TiffDecoder, DecodingResult, Limits};
use tiff::encoder::TiffEncoder;
use tiff::encoder::colortype::{Gray8, Gray16};

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
    /// Intensities row by row, as parts of full scale `[intensity]`.
    pub intensities: Vec<f64>,
    /// False where the file marks a pixel as wholly transparent.
    pub opaque: Vec<bool>,
}

impl Raster {
    /// The picture in the plane: `first` is the centre of the pixel of column 0 and row 0 and `step` leads from pixel to pixel
    /// `[length]`, see [`Frame::new`]. Missing are transparent pixels and, if `dark` is given, those of at most that intensity `[intensity]`.
    ///
    /// # Errors
    ///
    /// An invalid frame; no valid pixel.
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
    let mut bytes = Vec::new();
    match (format, depth) {
        (Format::Png, Depth::Eight) => {
            let levels: Vec<u8> = levels.map(|level| level as u8).collect();
            write_png(&mut bytes, [width, height], png::BitDepth::Eight, &levels)?;
        }
        (Format::Png, Depth::Sixteen) => {
            let levels: Vec<u8> = levels
                .flat_map(|level| (level as u16).to_be_bytes())
                .collect();
            write_png(&mut bytes, [width, height], png::BitDepth::Sixteen, &levels)?;
        }
        (Format::Tiff, depth) => {
            let mut encoder = TiffEncoder::new(Cursor::new(&mut bytes)).map_err(failed)?;
            match depth {
                Depth::Eight => {
                    let levels: Vec<u8> = levels.map(|level| level as u8).collect();
                    encoder.write_image::<Gray8>(width, height, &levels)
                }
                Depth::Sixteen => {
                    let levels: Vec<u16> = levels.map(|level| level as u16).collect();
                    encoder.write_image::<Gray16>(width, height, &levels)
                }
            }
            .map_err(failed)?;
        }
    }
    Ok(bytes)
}

fn write_png(
    bytes: &mut Vec<u8>,
    [width, height]: [u32; 2],
    depth: png::BitDepth,
    levels: &[u8],
) -> Result<(), FringeError> {
    let mut encoder = png::Encoder::new(bytes, width, height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(levels).map_err(failed)?;
    writer.finish().map_err(failed)
}

fn failed(cause: impl std::fmt::Display) -> FringeError {
    FringeError::File(cause.to_string())
}

/// Most bytes that reading a picture takes beside the file.
const MOST_BYTES: usize = 512 * 1024 * 1024;

/// Readers of the two formats before the first pixel.
enum Reader<'a> {
    Png(Box<png::Reader<Cursor<&'a [u8]>>>),
    Tiff(Box<TiffDecoder<Cursor<&'a [u8]>>>),
}

impl<'a> Reader<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self, FringeError> {
        let file = Cursor::new(bytes);
        if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
            let limits = png::Limits { bytes: MOST_BYTES };
            let mut decoder = png::Decoder::new_with_limits(file, limits);
            // Fewer than 8 bits become 8, and a transparent grey becomes a second channel.
            decoder.set_transformations(png::Transformations::EXPAND);
            let reader = decoder.read_info().map_err(failed)?;
            return Ok(Self::Png(Box::new(reader)));
        }
        if [&b"II*\0"[..], b"MM\0*", b"II+\0", b"MM\0+"]
            .iter()
            .any(|start| bytes.starts_with(start))
        {
            let mut limits = Limits::default();
            limits.decoding_buffer_size = MOST_BYTES;
            limits.intermediate_buffer_size = MOST_BYTES;
            limits.ifd_value_size = MOST_BYTES;
            let decoder = TiffDecoder::new(file).map_err(failed)?;
            return Ok(Self::Tiff(Box::new(decoder.with_limits(limits))));
        }
        Err(failed("neither a PNG nor a TIFF file"))
    }

    fn size(&mut self) -> Result<[usize; 2], FringeError> {
        let (columns, rows) = match self {
            Self::Png(reader) => reader.info().size(),
            Self::Tiff(decoder) => decoder.dimensions().map_err(failed)?,
        };
        Ok([columns as usize, rows as usize])
    }

    fn levels(self) -> Result<Levels, FringeError> {
        match self {
            Self::Png(reader) => png_levels(*reader),
            Self::Tiff(decoder) => tiff_levels(*decoder),
        }
    }
}

/// Grey levels and, where the file has them, opacities, row by row.
struct Levels {
    depth: Depth,
    grey: Vec<u16>,
    alpha: Option<Vec<u16>>,
}

impl Levels {
    /// From samples that go grey, alpha, grey, alpha …, or grey alone.
    fn new(depth: Depth, samples: Vec<u16>, has_alpha: bool) -> Self {
        if !has_alpha {
            return Self {
                depth,
                grey: samples,
                alpha: None,
            };
        }
        let pairs = samples.chunks_exact(2).map(|pair| (pair[0], pair[1]));
        let (grey, alpha) = pairs.unzip();
        Self {
            depth,
            grey,
            alpha: Some(alpha),
        }
    }
}

fn png_levels(mut reader: png::Reader<Cursor<&[u8]>>) -> Result<Levels, FringeError> {
    use png::BitDepth::{Eight, Sixteen};
    use png::ColorType::{Grayscale, GrayscaleAlpha};

    let (color, bits) = reader.output_color_type();
    let has_alpha = match color {
        Grayscale => false,
        GrayscaleAlpha => true,
        other => return Err(FringeError::Colour(format!("{other:?}{}", bits as u8))),
    };
    let depth = match bits {
        Eight => Depth::Eight,
        Sixteen => Depth::Sixteen,
        other => return Err(failed(format!("{} bits in a sample", other as u8))),
    };
    let size = reader
        .output_buffer_size()
        .filter(|size| *size <= MOST_BYTES)
        .ok_or_else(|| failed("the picture is too large"))?;
    let mut bytes = vec![0; size];
    let frame = reader.next_frame(&mut bytes).map_err(failed)?;
    bytes.truncate(frame.buffer_size());
    let samples = match depth {
        Depth::Eight => bytes.into_iter().map(u16::from).collect(),
        Depth::Sixteen => bytes
            .chunks_exact(2)
            .map(|pair| u16::from_be_bytes([pair[0], pair[1]]))
            .collect(),
    };
    Ok(Levels::new(depth, samples, has_alpha))
}

fn tiff_levels(mut decoder: TiffDecoder<Cursor<&[u8]>>) -> Result<Levels, FringeError> {
    let color = decoder.colortype().map_err(failed)?;
    let columns = decoder.dimensions().map_err(failed)?.0 as usize;
    let (bits, has_alpha) = match color {
        ColorType::Gray(bits @ (1 | 8 | 16)) => (bits, false),
        ColorType::GrayA(bits @ (8 | 16)) => (bits, true),
        ColorType::Gray(bits) | ColorType::GrayA(bits) => {
            return Err(failed(format!("{bits} bits in a sample")));
        }
        other => return Err(FringeError::Colour(format!("{other:?}"))),
    };
    let mut samples = DecodingResult::U8(Vec::new());
    let layout = decoder.read_image_to_buffer(&mut samples).map_err(failed)?;
    if samples.as_buffer(0).as_bytes().len() < layout.complete_len {
        return Err(failed("the picture is too large"));
    }
    let (depth, samples): (Depth, Vec<u16>) = match samples {
        DecodingResult::U8(bytes) if bits == 1 => (Depth::Eight, expanded(&bytes, columns)),
        DecodingResult::U8(bytes) => (Depth::Eight, bytes.into_iter().map(u16::from).collect()),
        DecodingResult::U16(levels) => (Depth::Sixteen, levels),
        _ => return Err(failed("samples that are no unsigned integers")),
    };
    if has_alpha && layout.planes > 1 {
        let (grey, alpha) = samples.split_at(samples.len() / 2);
        return Ok(Levels {
            depth,
            grey: grey.to_vec(),
            alpha: Some(alpha.to_vec()),
        });
    }
    Ok(Levels::new(depth, samples, has_alpha))
}

/// Black and white of rows of bits, which begin at whole bytes, as levels of 8 bits.
fn expanded(bytes: &[u8], columns: usize) -> Vec<u16> {
    let rows = bytes.chunks_exact(columns.div_ceil(8).max(1));
    let bit = |row: &[u8], column: usize| row[column / 8] >> (7 - column % 8) & 1;
    rows.flat_map(|row| (0..columns).map(move |column| 255 * u16::from(bit(row, column))))
        .collect()
}

/// Columns and rows of a PNG or TIFF file's picture, which its first bytes say; nothing of the picture is decoded.
///
/// # Errors
///
/// Bytes that are no such file.
pub fn size(bytes: &[u8]) -> Result<[usize; 2], FringeError> {
    Reader::new(bytes)?.size()
}

/// Grey picture of a PNG or TIFF file's bytes, 8 or 16 bits, with or without transparency. Grey levels are taken as proportional
/// to intensity. Colour is refused: which mixture of channels is the intensity, only the maker of the picture knows.
///
/// # Errors
///
/// Bytes that are no such file, or a picture in colour.
pub fn decode(bytes: &[u8]) -> Result<Raster, FringeError> {
    let mut reader = Reader::new(bytes)?;
    let [columns, rows] = reader.size()?;
    let levels = reader.levels()?;
    let full = levels.depth.full_scale();
    let intensities: Vec<_> = levels
        .grey
        .iter()
        .map(|&level| f64::from(level) / full)
        .collect();
    let opaque = levels.alpha.map_or_else(
        || vec![true; intensities.len()],
        |alpha| alpha.iter().map(|&value| value > 0).collect(),
    );
    Ok(Raster {
        columns,
        rows,
        depth: levels.depth,
        intensities,
        opaque,
    })
}
