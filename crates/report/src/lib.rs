//! Charts, field pictures, tables and self-contained HTML pages for engineering results.
//!
//! | module       | holds                                                                    |
//! |--------------|--------------------------------------------------------------------------|
//! | [`chart`]    | line charts with bands, reference lines and legends; panels of charts    |
//! | [`map`]      | maps of outcomes: a coloured cell for each row and column                |
//! | [`cells`]    | maps over two variables: a coloured cell with a number for each pair     |
//! | [`mesh_map`] | cells of a mesh in the colours of categories                             |
//! | [`plane`]    | pictures of pixels and values at scattered places, with marks            |
//! | [`field`]    | fields on finite-element meshes with a colour bar                        |
//! | [`axis`]     | what figures have in common: labels, scales, ranges and ticks            |
//! | [`color`]    | categorical, sequential and diverging colours                            |
//! | [`svg`]      | the finished picture, a self-contained SVG document                      |
//! | [`raster`]   | the same as a PNG file, with the embedded font                           |
//! | [`table`]    | tables for the terminal and for the page                                 |
//! | [`csv`]      | tables as files of values with commas                                    |
//! | [`page`]     | one self-contained HTML page                                             |
//! | [`prose`]    | texts of several sentences from templates                                |
//! | [`plain`]    | text of others, safe for a terminal, a page, a picture and a spreadsheet |
//!
//! Nothing here knows what a number means: quantities arrive as plain values, and labels carry their units. Nothing here opens a
//! file, starts a thread or reads a clock: pictures and pages are returned as text and bytes, and equal input gives equal bytes.
//!
//! ```
//! use stickslip_report::axis::Axis;
//! use stickslip_report::chart::{LineChart, Series};
//! use stickslip_report::raster::{DEFAULT_SCALE, to_png};
//!
//! let points = (0..=100).map(|k| f64::from(k) / 100.0).map(|x| [x, (1.0 - x * x).sqrt()]);
//! let chart = LineChart::new("Hertz", Axis::linear("x / a"), Axis::linear("p / p₀"))
//!     .with(Series::new("pressure", points.collect()));
//! let picture = chart.render()?;
//! assert!(picture.as_str().starts_with("<svg"));
//! assert_eq!(&to_png(&picture, DEFAULT_SCALE)?[1..4], b"PNG");
//! # Ok::<(), stickslip_report::FigureError>(())
//! ```

pub mod axis;
pub mod cells;
pub mod chart;
pub mod color;
pub mod csv;
mod error;
pub mod field;
mod frame;
mod grid;
mod image;
mod legend;
pub mod map;
mod markup;
pub mod mesh_map;
pub mod page;
pub mod plane;
pub mod prose;
pub mod raster;
mod shape;
pub mod svg;
pub mod table;
mod text;

/// Takes a file by its name in the folder of results and its bytes, and says why it cannot be kept; may be called from several threads.
pub type PutFile<'a> =
    dyn Fn(&str, &[u8]) -> Result<(), Box<dyn std::error::Error + Send + Sync>> + Sync + 'a;

pub use error::FigureError;
pub use minijinja::context;
pub use stickslip_text::plain;

/// The README's example.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
