//! Cylinders on blocks.
