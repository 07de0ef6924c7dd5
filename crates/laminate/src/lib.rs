//! Laminated plates as plane materials.
//!
//! This crate is the place of lay-ups, classical lamination theory, failure criteria and progressive models:
//!
//! ```text
//! (N, M) = [A B; B D] (ε⁰, κ),   Q̄_k the stiffness of ply k in laminate axes,   A = Σ_k Q̄_k h_k
//! ```
//!
//! A balanced symmetric lay-up acts in its plane as the homogeneous plate with stiffness A/h, which is a
//! [`Material`](stickslip_fem_core::material::Material) of `stickslip-fem-core`; its ply fractions are what the fibre-coverage
//! law of [`stickslip_friction`] asks for. Nothing of that is public yet: until it is, give a quasi-isotropic laminate by its
//! in-plane constants, as an isotropic or orthotropic material.
