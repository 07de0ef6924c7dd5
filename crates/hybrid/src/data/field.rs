//! The two displacements that a fringe pattern may show.

/// Which displacement a fringe pattern shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The component x.
    U,
    /// The component y.
    V,
}

impl Field {
    /// Both fields, U first.
    pub const BOTH: [Self; 2] = [Self::U, Self::V];

    /// Index of the component, 0 or 1.
    pub fn component(self) -> usize {
        match self {
            Self::U => 0,
            Self::V => 1,
        }
    }

    /// What it is called: "U" or "V".
    pub fn name(self) -> &'static str {
        letter(self.component())
    }
}

/// What a component is called in messages: U along x, V along y.
pub(crate) fn letter(component: usize) -> &'static str {
    if component == 0 { "U" } else { "V" }
}
