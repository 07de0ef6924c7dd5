//! Linearised operators of all bodies, and the factorisations that they share.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::material::PlaneStiffness;
use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::{BlockCompliance, InterfaceOperator, Linearised, TangentBody};

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

    fn blocks(&self) -> Option<&BlockCompliance> {
        self.body.blocks()
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

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_fem_core::generate::{Generate, Rectangle};
    use stickslip_fem_core::interface::contract::{Known, check};
    use stickslip_fem_core::material::{Isotropic, PlaneState};
    use stickslip_fem_core::mesh::ElementKind;
    use stickslip_fem_core::{ElasticBody, LoadCase};

    #[test]
    fn a_widened_body_keeps_the_contract_of_operators_and_gives_as_before() {
        let strip = Rectangle::uniform([0.0, 6.0], [0.0, 1.0], [12, 2], ElementKind::Q4);
        let mesh = strip.unwrap().generate().unwrap();
        let mut interface = mesh.node_set("left").unwrap().to_vec();
        let mut ends = vec![interface.len()];
        interface.extend(mesh.node_set("right").unwrap());
        ends.push(interface.len());
        let [x, y] = mesh.nodes()[3];
        let mut forces = vec![0.0; 2 * mesh.nodes().len()];
        forces[6..8].copy_from_slice(&[2.0, -1.0]);
        let case = LoadCase {
            forces,
            ..LoadCase::default()
        };
        let material = Isotropic::new(4.0, 0.3, PlaneState::Stress).unwrap();
        let body = ElasticBody::new(Arc::new(mesh), vec![Arc::new(material)], 1.0).unwrap();
        let body = Arc::new(body.with_load_cases(vec![case]).unwrap());
        let known = Known {
            placed: true,
            resultants: &[[2.0, -1.0, -x - 2.0 * y], [0.0; 3]],
        };
        let in_blocks = body.condense_edges(&interface, &ends).unwrap();
        for own in [body.condense(&interface).unwrap(), in_blocks] {
            let widened = Widened::new(&own);
            assert_eq!(check(&widened, known), Ok(()));
            assert_eq!(widened.matrix(), own.matrix());
        }
    }
}
