//! Sides of a block.

/// A side of a block, in lattice terms: south is j = 0, west is i = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// j = 0.
    South,
    /// i = nᵢ.
    East,
    /// j = nⱼ.
    North,
    /// i = 0.
    West,
}
