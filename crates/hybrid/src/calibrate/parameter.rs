//! Parameters and their ranges.

/// Most parameters that a fit may have; the grid of starts grows with their number's power.
pub const MOST_PARAMETERS: usize = 4;

/// A parameter and where to look for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name for results.
    pub name: String,
    /// Least and greatest value that is looked at, both of them allowed, in the model's unit.
    pub range: [f64; 2],
    /// Whether the range is divided evenly in the logarithm, as that of a length of unknown order.
    pub logarithmic: bool,
}

impl Parameter {
    /// Makes a parameter whose `range`, least and greatest value in the model's unit, is divided evenly.
    pub fn new(name: impl Into<String>, range: [f64; 2]) -> Self {
        Self {
            name: name.into(),
            range,
            logarithmic: false,
        }
    }

    /// The same with a range that is divided evenly in the logarithm.
    #[must_use]
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// The value at the part `part` of the range, from 0 to 1.
    pub(super) fn at(&self, part: f64) -> f64 {
        let [low, high] = self.range;
        let value = if self.logarithmic {
            low * (high / low).powf(part)
        } else {
            low + part * (high - low)
        };
        value.clamp(low, high)
    }

    /// How fast the value grows with the part.
    pub(super) fn slope(&self, part: f64) -> f64 {
        let [low, high] = self.range;
        if self.logarithmic {
            self.at(part) * (high / low).ln()
        } else {
            high - low
        }
    }
}
