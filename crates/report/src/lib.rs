//! Figures, pages and result folders.
//!
//! | module     | holds                                                                    |
//! |------------|--------------------------------------------------------------------------|
//! | [`chart`]  | line charts with bands, reference lines and legends; panels of charts    |
//! | [`map`]    | maps of outcomes: a coloured cell for each row and column                |
//! | [`cells`]  | maps over two variables: a coloured cell with a number for each pair        |
//! | [`mesh_map`] | cells of a mesh in the colours of categories                              |
//! | [`plane`]  | pictures of pixels and values at scattered places, with marks                 |
//! | [`field`]  | fields on finite-element meshes with a colour bar                        |
//! | [`axis`]   | what the two have in common: labels, scales, ranges and ticks            |
//! | [`color`]  | categorical, sequential and diverging colours                            |
//! | [`svg`]    | the finished picture, a self-contained SVG document                      |
//! | [`raster`] | SVG → PNG with the embedded font                                         |
//! | [`table`]  | tables for the terminal and for the page                                 |
//! | [`page`]   | one self-contained HTML page                                             |
//! | [`plain`]  | text of others, safe for a terminal, a page, a picture and a spreadsheet |
//! | [`folder`] | result folders and files that appear whole or not at all                 |
//!
//! Nothing here knows what a number means: quantities arrive as plain values, and
//! labels carry their units. Equal input gives equal bytes.

pub mod axis;
pub mod cells;
pub mod chart;
pub mod color;
mod error;
pub mod field;
pub mod folder;
mod frame;
mod legend;
pub mod map;
pub mod mesh_map;
pub mod page;
pub mod plain;
pub mod plane;
pub mod raster;
pub mod svg;
pub mod table;
mod text;

pub use error::FigureError;
