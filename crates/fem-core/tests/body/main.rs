//! Bodies from mesh to interface operator: exactness, convergence, condensation, supports, equilibrium.
//!
//! Every reference is made independently of the code under test: exact fields of elasticity, or dense algebra on
//! stiffness matrices assembled entry by entry.

mod blocks;
mod condensation;
mod equilibrium;
mod errors;
mod fields;
mod floating;
mod high_order;
mod manufactured;
mod meshes;
mod norms;
mod patch;
mod platen;
mod recovery;
mod reference;
mod section;
mod supports;
mod tangent;
mod thermal;
