//! How finely a contour is divided.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::{ElementKind, Point};

/// How finely a contour is divided.
#[derive(Clone, Debug, PartialEq)]
pub struct Division {
    /// T3 or T6.
    pub kind: ElementKind,
    /// Largest spacing of corner nodes `[length]`; `None` is a tenth of the body's narrower side. Cells are smaller around holes, on
    /// arcs and short pieces, at corners, and in gaps.
    pub spacing: Option<f64>,
    /// Growth of the cell size per unit of distance `[1]`, above 0 and at most 1.
    pub growth: f64,
    /// By how many times all sizes that neither `spacing` nor holes give, and `growth`, are smaller than usual `[1]`: with holes and `spacing`
    /// twice as fine, 2 halves every cell.
    pub fineness: f64,
    /// By how many times cells on pieces of the outline, counted from 0, and then of the cut-outs are smaller than the largest `[1]`.
    pub refined: BTreeMap<usize, f64>,
    /// Places `[length]` where edges meet, whose nodes are sets by these names.
    pub points: BTreeMap<String, Point>,
    /// Everything is moved by this `[length]`.
    pub centre: Point,
}

impl Default for Division {
    /// T6, growth 0.25, spacing by holes and body.
    fn default() -> Self {
        Self {
            kind: ElementKind::T6,
            spacing: None,
            growth: 0.25,
            fineness: 1.0,
            refined: BTreeMap::new(),
            points: BTreeMap::new(),
            centre: [0.0; 2],
        }
    }
}
