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
//! | [`element`], [`material`] | shape functions and element matrices; plane stiffness |
//! | [`support`], [`load`], [`body`] | how a body is held and loaded; its condensation |
//! | [`points`] | strains and stresses at quadrature points, where materials with history live |
//! | [`interface`] | the operator that contact sees, of elastic and rigid bodies |
//! | [`stress`] | stresses at Gauss points, nodes and edges |
//! | [`linalg`] | the factorisations (the only module that knows faer) |
//!
//! Nothing here knows that contact exists. Units are free: any consistent set works.

pub mod body;
pub mod element;
pub mod generate;
pub mod interface;
pub mod linalg;
pub mod load;
pub mod material;
pub mod mesh;
pub mod points;
pub mod stress;
pub mod support;
pub mod vtk;

pub use body::{
    BodyError, BodyStructure, CondensedBody, ElasticBody, Linearised, LoadCase, TangentBody,
};
pub use interface::{GivenBody, GivenBodyError, InterfaceOperator, RigidBody};
pub use points::QuadraturePoints;
pub use support::{HeldDirection, Platen, Support};
