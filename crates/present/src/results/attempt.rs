//! What drawing a figure yields.

use stickslip_report::FigureError;
use stickslip_report::svg::Svg;

/// A figure before it has a file name; `None` where it does not apply.
pub(super) type Attempt = Result<Option<(Svg, String)>, FigureError>;
