//! From measured displacements to edge stresses and friction.
//!
//! Moiré gratings of frequency f show displacements as fringe orders N; a region of finite elements whose edge moves as measured, and
//! whose inner forces vanish, has the stresses that cannot be measured:
//!
//! ```text
//! U = N_x / f,   V = N_y / f,   f = (2/λ) sin α,
//! Δ² = K₂₂⁻¹ (F² − K²¹ Δ¹),   F¹ = (K¹¹ − K¹² K₂₂⁻¹ K²¹) Δ¹ + K¹² K₂₂⁻¹ F².
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`data`] | measured displacements: places, values, what failed, their standard deviation |
//! | [`moire`] | gratings: frequency, fringe orders, displacements, strains |
//! | [`fringe`] | fringe pictures: synthesis, phase, unwrapping, carrier |
//! | [`reduce`] | displacements of nodes from measured ones, with covariance |
//! | [`region`] | localized hybrid analysis of a region, with the covariance of all that follows |
//! | [`calibrate`] | parameters of any model by weighted least squares, with profiles, and the comparison of models |
//! | [`identify`] | friction coefficients from edge tractions, with intervals, or reported as not identifiable |
//!
//! The stress in a ring whose edges are strained by 10⁻³ along x, with its standard deviation:
//!
//! ```
//! use std::f64::consts::TAU;
//! use std::sync::Arc;
//! use stickslip_fem_core::ElasticBody;
//! use stickslip_fem_core::material::{Isotropic, PlaneState};
//! use stickslip_fem_core::mesh::ElementKind;
//! use stickslip_hybrid::data::NodalDisplacements;
//! use stickslip_hybrid::region::outputs::EdgeRows;
//! use stickslip_hybrid::region::sector::ArcSector;
//! use stickslip_hybrid::region::{Region, independent_covariance};
//!
//! let ring = ArcSector {
//!     centre: [0.0, 0.0],
//!     hole: 1.0,
//!     stand_off: 0.0,
//!     outer: 2.0,
//!     angles: [0.0, TAU],
//!     cells: [16, 3],
//!     growth: 1.0,
//!     kind: ElementKind::Q8,
//! };
//! let mesh = Arc::new(ring.mesh()?);
//! let material = Isotropic::new(70e3, 0.0, PlaneState::Stress)?;
//! let body = ElasticBody::new(Arc::clone(&mesh), vec![Arc::new(material)], 1.0)?;
//! let region = Region::new(&Arc::new(body), &[])?;
//! let nodes = region.prescribed_nodes();
//! let measured = NodalDisplacements {
//!     values: nodes.iter().flat_map(|&node| [1e-3 * mesh.nodes()[node][0], 0.0]).collect(),
//!     covariance: independent_covariance(nodes.len(), [1e-6; 2]),
//!     nodes,
//! };
//! let edge = EdgeRows::new(region.body(), "inner")?;
//! let stresses = region.propagate(&edge.rows, &measured)?;
//! // Node 0 lies at θ = 0, where the radial stress is E ε.
//! let start = (0..edge.nodes.len()).find(|&k| edge.parameter[k].abs() < 1e-9).ok_or("a node at 0")?;
//! assert!((stresses.values[3 * start] - 70.0).abs() < 1e-6);
//! assert!(stresses.deviations()[3 * start] > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Units are free: any consistent set works. Meshes, bodies and points are those of `stickslip-fem-core`, re-exported as
//! [`fem_core`].

pub mod calibrate;
pub mod data;
pub mod fringe;
pub mod identify;
mod least_squares;
pub mod moire;
mod neighbours;
mod order_statistics;
mod random;
pub mod reduce;
pub mod region;
mod triangles;

pub use stickslip_fem_core as fem_core;
