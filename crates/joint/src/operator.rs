//! Linearised operators of all bodies, and the factorisations that they share.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::material::PlaneStiffness;
use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::{InterfaceOperator, Linearised, TangentBody};

use crate::body::ProgressiveBody;

/// Factors kept per body: the sound body's, and those of the last iterations.
const KEPT: usize = 3;

/// Condensed bodies by their tangents. A body whose tangents have been seen lately is not factorised again, so the elastic part of
/// a history costs one factorisation.
#[derive(Debug, Default)]
pub(crate) struct Factors {
    /// Most recently used first.
    kept: Vec<Vec<Arc<TangentBody>>>,
    pub(crate) factorisations: usize,
}

impl Factors {
    pub(crate) fn new(bodies: usize) -> Self {
        Self {
            kept: vec![Vec::new(); bodies],
            factorisations: 0,
        }
    }

    /// Body `index` condensed with `tangents`.
    pub(crate) fn get(
        &mut self,
        index: usize,
        body: &ProgressiveBody,
        tangents: &[PlaneStiffness],
    ) -> Result<Arc<TangentBody>, BodyError> {
        let kept = &mut self.kept[index];
        let known = kept.iter().position(|known| known.tangents() == tangents);
        let found = if let Some(place) = known {
            kept.remove(place)
        } else {
            self.factorisations += 1;
            let (elements, structure) = (Arc::clone(body.body()), Arc::clone(body.structure()));
            Arc::new(TangentBody::new(elements, structure, tangents.to_vec())?)
        };
        kept.insert(0, Arc::clone(&found));
        kept.truncate(KEPT);
        Ok(found)
    }
}

/// A body with one load case more than it has, which does nothing to it.
#[derive(Debug)]
pub(crate) struct Widened<'a> {
    body: &'a dyn InterfaceOperator,
    no_load: DVector<f64>,
}

impl<'a> Widened<'a> {
    pub(crate) fn new(body: &'a dyn InterfaceOperator) -> Self {
        Self {
            no_load: DVector::zeros(body.modes().ncols()),
            body,
        }
    }
}

impl InterfaceOperator for Widened<'_> {
    fn points(&self) -> &[Point] {
        self.body.points()
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        self.body.compliance()
    }

    fn modes(&self) -> &DMatrix<f64> {
        self.body.modes()
    }

    fn load_cases(&self) -> usize {
        self.body.load_cases() + 1
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        if case == self.body.load_cases() {
            None
        } else {
            self.body.load_response(case)
        }
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        if case == self.body.load_cases() {
            &self.no_load
        } else {
            self.body.mode_load(case)
        }
    }
}

/// The operator of one body in one iteration.
#[derive(Debug)]
pub(crate) enum Operator<'a> {
    Linearised(Box<Linearised>),
    Linear(Widened<'a>),
}

impl Operator<'_> {
    pub(crate) fn interface(&self) -> &dyn InterfaceOperator {
        match self {
            Self::Linearised(body) => body.as_ref(),
            Self::Linear(body) => body,
        }
    }
}
