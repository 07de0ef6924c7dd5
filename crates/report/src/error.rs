//! What can be wrong with a figure or a page.

use thiserror::Error;

/// A figure that cannot be drawn as asked.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FigureError {
    /// No finite (on a log axis: positive) value, and no range was given.
    #[error("axis '{axis}': no value can be drawn; give the axis a range or check the data")]
    NoData {
        /// Label of the axis.
        axis: String,
    },
    /// A range that is empty, reversed, not finite, or not positive on a log axis.
    #[error("axis '{axis}': range [{low}, {high}] cannot be drawn on a {scale} scale")]
    Range {
        /// Label of the axis.
        axis: String,
        /// Lower end as given, in the axis's unit.
        low: f64,
        /// Upper end as given, in the axis's unit.
        high: f64,
        /// `linear` or `log`.
        scale: &'static str,
    },
    /// A tick spacing that is not positive or gives too many ticks.
    #[error(
        "axis '{axis}': tick spacing {spacing} does not suit the range [{low}, {high}]; \
         it must be positive and give at most {limit} ticks"
    )]
    TickSpacing {
        /// Label of the axis.
        axis: String,
        /// Spacing as given, in the axis's unit; in decades on a log axis.
        spacing: f64,
        /// Lower end of the axis, in its unit.
        low: f64,
        /// Upper end of the axis, in its unit.
        high: f64,
        /// Largest number of ticks.
        limit: usize,
    },
    /// A width or an aspect that leaves no room to draw.
    #[error("'{title}': width {width} px and aspect {aspect} leave no room to draw")]
    Size {
        /// Title of the figure.
        title: String,
        /// Width of the figure \[px\].
        width: f64,
        /// Height over width of the plot area \[1\].
        aspect: f64,
    },
    /// Panels without any chart or column.
    #[error("'{title}': {panels} panels in {columns} columns; both must be at least 1")]
    NoPanels {
        /// Title of the panels.
        title: String,
        /// Number of panels.
        panels: usize,
        /// Number of columns.
        columns: usize,
    },
    /// A field whose values do not match its nodes.
    #[error("'{title}': {values} values for {nodes} nodes; there must be one per node")]
    ValueCount {
        /// Title of the figure.
        title: String,
        /// Number of values.
        values: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// A node without a place.
    #[error("'{title}': node {node} is at ({x}, {y}), which cannot be drawn")]
    Node {
        /// Title of the figure.
        title: String,
        /// Index of the node.
        node: usize,
        /// Its x as given \[length\].
        x: f64,
        /// Its y as given \[length\].
        y: f64,
    },
    /// A cell with fewer than three nodes, or one that names a node that is not there.
    #[error("'{title}': cell {cell} is not a polygon on {nodes} nodes: {corners:?}")]
    Cell {
        /// Title of the figure.
        title: String,
        /// Index of the cell.
        cell: usize,
        /// The cell's nodes as given.
        corners: Vec<usize>,
        /// Number of nodes.
        nodes: usize,
    },
    /// The picture would not fit in memory, or the drawing library refused it.
    #[error("no PNG of a {width} × {height} px figure at scale {scale}: {reason}")]
    Raster {
        /// Width of the figure \[px\].
        width: f64,
        /// Height of the figure \[px\].
        height: f64,
        /// PNG pixels per figure pixel \[1\].
        scale: f64,
        /// What went wrong.
        reason: String,
    },
}

/// Refuses a cell with fewer than three nodes, or with nodes beyond the `nodes` of the figure `title`.
pub(crate) fn check_cells<'a>(
    title: &str,
    nodes: usize,
    cells: impl IntoIterator<Item = &'a Vec<usize>>,
) -> Result<(), FigureError> {
    let bad = |cell: &Vec<usize>| cell.len() < 3 || cell.iter().any(|&node| node >= nodes);
    match cells.into_iter().enumerate().find(|(_, cell)| bad(cell)) {
        Some((cell, corners)) => Err(FigureError::Cell {
            title: title.to_owned(),
            cell,
            corners: corners.clone(),
            nodes,
        }),
        None => Ok(()),
    }
}

/// A page that could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PageError {
    /// Two figures or sections share an anchor.
    #[error("anchor '{anchor}' is used twice; links could reach only one of them")]
    DuplicateAnchor {
        /// The anchor.
        anchor: String,
    },
    /// The page's template failed.
    #[error("the page could not be put together")]
    Template {
        /// The template engine's reason.
        #[source]
        cause: Box<dyn std::error::Error + Send + Sync>,
    },
}

impl From<minijinja::Error> for PageError {
    fn from(cause: minijinja::Error) -> Self {
        Self::Template {
            cause: Box::new(cause),
        }
    }
}
