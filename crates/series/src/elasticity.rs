//! What a plate is made of, isotropic or not.

use crate::circle::{Kolosov, Side, Surface};
use crate::lekhnitskii::Planes;

/// How a plate gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Elasticity {
    Isotropic(Kolosov),
    Anisotropic(Planes),
}

impl Elasticity {
    /// Unit of the displacements of its potentials, R/2G or R.
    pub(crate) fn unit(&self, radius: f64) -> f64 {
        match self {
            Self::Isotropic(material) => radius / (2.0 * material.shear),
            Self::Anisotropic(_) => radius,
        }
    }

    /// How the edge of a hole gives.
    pub(crate) fn outside(&self) -> Surface {
        match self {
            Self::Isotropic(material) => Surface::new(*material, Side::Outside),
            Self::Anisotropic(planes) => planes.matrix().surface(),
        }
    }
}
