//! Quantities with units.
//!
//! ```text
//! value in base units = number × factor of the unit,     base units: mm, N, MPa, rad, K
//! ```
//!
//! The base units are consistent: 1 MPa · 1 mm² = 1 N. Factors are exact by definition (1 in = 25.4 mm and 1 lbf = 4.4482216152605 N:
//! NIST Special Publication 811, 2008, appendix B) up to rounding in `f64`. Temperatures are differences, so 1 degF is 5/9 K and
//! no zero point enters.
//!
//! | dimension         | units                          |
//! |-------------------|--------------------------------|
//! | length            | m, cm, mm, um (µm), nm, in, ft, mil |
//! | force             | N, kN, MN, lbf (lb), kip       |
//! | stress            | Pa, kPa, MPa, GPa, psi, ksi, Msi |
//! | angle             | deg, rad                       |
//! | temperature       | K, degC, degF                  |
//! | per temperature   | 1/K, 1/degC, 1/degF (or /K, …)  |
//! | fracture energy   | N/mm, kJ/m2, J/m2, lbf/in       |
//! | per length        | 1/mm, 1/cm, 1/m, 1/um, 1/in     |
//! | spring stiffness  | N/mm, kN/mm, N/m, kN/m, lbf/in, kip/in |
//! | bed stiffness     | N/mm3, MPa/mm, MPa/m, lbf/in3, psi/in |
//!
//! N/mm and lbf/in belong to two dimensions: a quantity has the one that its place expects, and a fracture energy where either does.
//!
//! ```
//! use stickslip_units::{Dimension, Expected, parse};
//!
//! let (stress, dimension) = parse("30 Msi", &Expected::one(Dimension::Stress))?;
//! assert!((stress / 206_842.72 - 1.0).abs() < 1e-7 && dimension == Dimension::Stress);
//! assert!(parse("0.375 in", &Expected::one(Dimension::Stress)).is_err());
//! # Ok::<(), stickslip_units::UnitError>(())
//! ```

mod parse;
mod quantity;
mod unit;

/// The crate of the diagnostics that [`UnitError`] is.
pub use miette;

pub use parse::{Expected, UnitError, parse, unit_of};
pub use quantity::{
    Angle, AngleOrLength, BedStiffness, Force, FractureEnergy, Length, Measure, PerLength,
    PerTemperature, QUANTITY_TAG, Quantity, SpringStiffness, Stress, Temperature, UNIT_TAG,
    UnitName, dimensions_of_tag,
};
pub use unit::{Dimension, UNITS, Unit};

#[cfg(test)]
mod tests;
