//! Hybrid analysis of measured displacements.
//!
//! This crate is the place of everything that starts from measured fields: fringe orders N of moiré gratings of frequency f
//! and the displacements they mean,
//!
//! ```text
//! U = N_x / f,   V = N_y / f,   f = (2/λ) sin α,
//! ```
//!
//! localized hybrid analysis, where measured displacements Δ¹ drive a region whose inner forces vanish,
//!
//! ```text
//! Δ² = K₂₂⁻¹ (F² − K²¹ Δ¹),   F¹ = (K¹¹ − K¹² K₂₂⁻¹ K²¹) Δ¹ + K¹² K₂₂⁻¹ F²,
//! ```
//!
//! and the friction coefficients that follow. It will know the results of `stickslip-contact` and never its solvers. Nothing
//! of it is public yet.
