//! Plane finite elements, condensed to their interfaces.
//!
//! A linear elastic body obeys `K u = f + Bᵀ λ`, K sparse, λ the forces on its few contact nodes. With the contact
//! unknowns ordered last, the Cholesky factor of K holds the factor of the Schur complement in its trailing block, so one
//! factorisation gives the small dense operator `u_c = C λ + u₀ + R α` that a contact solver needs, and the fields inside
//! come back with one pair of triangular solves when they are asked for.
//!
//! | module | subject |
//! | --- | --- |
//! | [`mesh`], [`generate`], [`vtk`] | meshes, their generators, files for ParaView |
//! | [`vector`] | arithmetic of plane vectors |
//! | [`element`], [`material`] | shape functions and element matrices; plane stiffness |
//! | [`support`], [`load`], [`body`] | how a body is held and loaded; its condensation |
//! | [`points`] | strains and stresses at quadrature points, where materials with history live |
//! | [`interface`] | the operator that contact sees, of elastic and rigid bodies |
//! | [`stress`] | stresses at Gauss points, nodes and edges |
//! | [`linalg`] | dense and sparse algebra (the only module that knows faer) |
//! | [`parallel`] | threads behind one seam: feature `parallel`, off by default, same bits |
//!
//! A block pressed by unit forces on two nodes of its top:
//!
//! ```
//! use std::sync::Arc;
//! use stickslip_fem_core::generate::{Generate, Rectangle};
//! use stickslip_fem_core::material::{Isotropic, PlaneState};
//! use stickslip_fem_core::mesh::ElementKind;
//! use stickslip_fem_core::nalgebra::dvector;
//! use stickslip_fem_core::{ElasticBody, HeldDirection, InterfaceOperator, Support};
//!
//! let mesh = Rectangle::uniform([0.0, 1.0], [0.0, 1.0], [1, 1], ElementKind::Q4)?.generate()?;
//! let held = |set: &str, direction| {
//!     mesh.node_set(set).map(|nodes| Support {
//!         nodes: nodes.to_vec(),
//!         direction,
//!         displacement: 0.0,
//!     })
//! };
//! let supports = [held("left", HeldDirection::X)?, held("bottom", HeldDirection::Y)?];
//! let top = mesh.node_set("top")?.to_vec();
//! let material = Isotropic::new(4.0, 0.0, PlaneState::Stress)?;
//! let body = ElasticBody::new(Arc::new(mesh), vec![Arc::new(material)], 1.0)?;
//! let condensed = Arc::new(body.with_supports(supports)).condense(&top)?;
//! let compliance = condensed.compliance().ok_or("an elastic body has a compliance")?;
//! let u = compliance * dvector![0.0, -1.0, 0.0, -1.0];
//! assert!((u[1] + 0.5).abs() < 1e-12); // two forces of 1 on an area of 1: v = −2 h / E
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing here knows that contact exists. Units are free: any consistent set works. Vectors and matrices of the interface are those of
//! [`nalgebra`], which is re-exported.

pub mod body;
pub mod element;
pub mod generate;
pub mod interface;
mod kind;
pub mod linalg;
pub mod load;
pub mod material;
pub mod mesh;
pub mod parallel;
pub mod points;
pub mod stress;
pub mod support;
pub mod vector;
pub mod vtk;

pub use nalgebra;

pub use body::{
    BodyError, BodyStructure, CondensedBody, ElasticBody, Linearised, LoadCase, TangentBody,
};
pub use interface::{
    Block, BlockCompliance, GivenBody, GivenBodyError, InterfaceOperator, Misfit, RigidBody,
};
pub use points::QuadraturePoints;
pub use support::{HeldDirection, Platen, SectionHold, Spring, SpringSite, Support};
