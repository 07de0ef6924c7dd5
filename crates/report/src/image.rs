//! Images of at most 256 colours, and their PNG files.

use crate::color::Color;

/// An image, row by row from the upper left corner.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Image {
    /// Pixels in a row, at least 1.
    pub(crate) width: usize,
    /// 1 to 256 colours.
    pub(crate) palette: Vec<Color>,
    /// Whether the first colour of the palette stands for no pixel at all.
    pub(crate) is_first_transparent: bool,
    /// Place of each pixel's colour in the palette; whole rows.
    pub(crate) indices: Vec<u8>,
}

impl Image {
    pub(crate) fn height(&self) -> usize {
        self.indices.len() / self.width
    }

    /// The image as a PNG file with a palette.
    pub(crate) fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let channels = |color: &Color| [color.red, color.green, color.blue];
        let palette: Vec<u8> = self.palette.iter().flat_map(channels).collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height() as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_palette(palette);
        if self.is_first_transparent {
            encoder.set_trns(vec![0_u8]);
        }
        // Level 6 takes half as long again and saves a tenth.
        encoder.set_deflate_compression(png::DeflateCompression::Level(4));
        // Differences of places in a palette mean nothing.
        encoder.set_filter(png::Filter::NoFilter);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.indices)?;
        writer.finish()?;
        Ok(file)
    }
}
