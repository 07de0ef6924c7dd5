//! What a picture of a field shows.

use crate::color::Colormap;

/// A scalar field on a mesh of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldPlot<'a> {
    /// What the picture shows.
    pub title: String,
    /// A second, smaller line: case, load, step.
    pub subtitle: Option<String>,
    /// Coordinates of the nodes \[length\]; displace them for a deformed shape.
    pub nodes: &'a [[f64; 2]],
    /// Node indices around each cell, see the module's text.
    pub cells: &'a [Vec<usize>],
    /// One value per node, in the unit of `label`; cells that touch NaN or infinity are drawn grey.
    pub values: &'a [f64],
    /// Name, symbol and unit of the field, beside the colour bar.
    pub label: String,
    /// Names and units of the x and y axes.
    pub axes: [String; 2],
    /// Colours of the values.
    pub colormap: Colormap,
    /// Values at the ends of the colour bar, in the unit of `label`; those beyond it keep the end's colour and
    /// the bar is pointed. If not given, the least and largest value in sight, and for
    /// a diverging map ± the largest magnitude.
    pub range: Option<[f64; 2]>,
    /// The part to show, `[x_low, x_high, y_low, y_high]` \[length\].
    pub window: Option<[f64; 4]>,
    /// Whether mesh lines are drawn; they are left out where cells are so small
    /// (3 px) that lines would hide the field.
    pub draw_mesh: bool,
    /// Factors of x, y and the value in the mirror image that completes a half model: `[1, −1, 1]` a normal stress over y ≥ 0,
    /// `[−1, 1, −1]` a shear stress over x ≥ 0.
    pub mirror: Option<[f64; 3]>,
    /// A value along which a line is drawn, in the unit of `label`.
    pub contour: Option<f64>,
    /// What stands below the title instead of the least and the largest value with their places.
    pub stated: Option<String>,
    /// Largest width of the whole figure \[px\].
    pub width: f64,
}

impl<'a> FieldPlot<'a> {
    /// Makes the picture of a field over the whole mesh in the colours of Viridis, axes in `length_unit`; `nodes` are in it, `values` in the unit of `label`.
    pub fn new(
        title: impl Into<String>,
        label: impl Into<String>,
        length_unit: &str,
        nodes: &'a [[f64; 2]],
        cells: &'a [Vec<usize>],
        values: &'a [f64],
    ) -> Self {
        Self {
            title: title.into(),
            subtitle: None,
            nodes,
            cells,
            values,
            label: label.into(),
            axes: ["x", "y"].map(|name| format!("{name} [{length_unit}]")),
            colormap: Colormap::Viridis,
            range: None,
            window: None,
            draw_mesh: false,
            mirror: None,
            contour: None,
            stated: None,
            width: 720.0,
        }
    }

    /// Sets the line below the title.
    #[must_use]
    pub fn subtitle(mut self, subtitle: impl Into<String>) -> Self {
        self.subtitle = Some(subtitle.into());
        self
    }

    /// Sets the colours.
    #[must_use]
    pub fn colormap(mut self, colormap: Colormap) -> Self {
        self.colormap = colormap;
        self
    }

    /// Sets the values at the ends of the colour bar, in the unit of `label`.
    #[must_use]
    pub fn between(mut self, low: f64, high: f64) -> Self {
        self.range = Some([low, high]);
        self
    }

    /// Shows `[x_low, x_high, y_low, y_high]` \[length\] only.
    #[must_use]
    pub fn window(mut self, window: [f64; 4]) -> Self {
        self.window = Some(window);
        self
    }

    /// Draws the mesh lines.
    #[must_use]
    pub fn with_mesh(mut self) -> Self {
        self.draw_mesh = true;
        self
    }

    /// Completes a half model by its image, given by the factors \[1\] of x, y and the value.
    #[must_use]
    pub fn mirror(mut self, factors: [f64; 3]) -> Self {
        self.mirror = Some(factors);
        self
    }

    /// Draws a line where the value is `level`, in the unit of `label`.
    #[must_use]
    pub fn contour(mut self, level: f64) -> Self {
        self.contour = Some(level);
        self
    }

    /// States `text` instead of the least and the largest value with their places: of displaced nodes these are not those of the body, and
    /// values may have no limit.
    #[must_use]
    pub fn stating(mut self, text: impl Into<String>) -> Self {
        self.stated = Some(text.into());
        self
    }
}
