//! A body seen from chosen nodes.

use nalgebra::{DMatrix, DVector, Matrix2, Vector2};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;

use super::hats::Hats;
use crate::deformed::Facing;
use crate::problem::ContactPair;

/// A body whose displacements are means over hats, and whose forces are spread by them.
#[derive(Clone, Debug)]
pub(crate) struct ThinnedBody {
    /// The first hat of each pair and side that the body has.
    offsets: Vec<((usize, bool), usize)>,
    /// W: for each hat the body's own nodes and what takes their displacement into that of the hat.
    rows: Vec<Vec<(usize, Matrix2<f64>)>>,
    points: Vec<Point>,
    compliance: Option<DMatrix<f64>>,
    modes: DMatrix<f64>,
    responses: Vec<Option<DVector<f64>>>,
    mode_loads: Vec<DVector<f64>>,
}

impl ThinnedBody {
    /// The body `index` of `pairs` with `hats`.
    pub(crate) fn new(
        index: usize,
        body: &dyn InterfaceOperator,
        pairs: &[ContactPair],
        hats: &[Hats],
        facings: &[&Facing],
    ) -> Self {
        let (mut offsets, mut rows, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for (number, (pair, hats)) in pairs.iter().zip(hats).enumerate() {
            for (own, is_first) in [(pair.first, true), (pair.second, false)] {
                if own != index {
                    continue;
                }
                offsets.push(((number, is_first), rows.len()));
                let node = |k: usize| {
                    let point = &pair.points[k];
                    let stencil = if is_first {
                        &point.first
                    } else {
                        &point.second
                    };
                    stencil.node().unwrap_or_default()
                };
                let facing = facings.get(number);
                let centre = facing.and_then(|facing| {
                    if is_first {
                        facing.centre
                    } else {
                        facing.second.centre()
                    }
                });
                for hat in hats.all() {
                    let terms = hat.terms.iter().enumerate();
                    let term =
                        |(term, (k, _)): (usize, &(usize, f64))| (node(*k), hat.matrix(pair, term));
                    let terms: Vec<(usize, Matrix2<f64>)> = terms.map(term).collect();
                    points.push(match centre {
                        // As displacements are, so that a turn about it moves the mean as it moves the nodes.
                        Some(centre) => terms.iter().fold(centre, |sum, (node, matrix)| {
                            let own = body.points()[*node];
                            let away =
                                matrix * Vector2::new(own[0] - centre[0], own[1] - centre[1]);
                            [sum[0] + away[0], sum[1] + away[1]]
                        }),
                        None => [0, 1].map(|i| hat.mean(|k| body.points()[node(k)][i])),
                    });
                    rows.push(terms);
                }
            }
        }
        let cases = 0..body.load_cases();
        let mut thinned = Self {
            offsets,
            rows,
            points,
            compliance: None,
            modes: DMatrix::zeros(0, 0),
            responses: Vec::new(),
            mode_loads: cases
                .clone()
                .map(|case| body.mode_load(case).clone())
                .collect(),
        };
        thinned.compliance = body.matrix().map(|own| thinned.transformed(&own));
        thinned.modes = thinned.means(body.modes());
        let response = |case| Some(thinned.mean(body.load_response(case)?));
        thinned.responses = cases.map(response).collect();
        thinned
    }

    /// The first hat of pair `pair`, of which the body is the first one or the second.
    pub(crate) fn offset(&self, pair: usize, is_first: bool) -> usize {
        let mut own = self.offsets.iter();
        let found = own.find(|(key, _)| *key == (pair, is_first));
        found.map_or(0, |(_, offset)| *offset)
    }

    /// What each hat makes of a translation of the body.
    pub(crate) fn translated(&self) -> Vec<Matrix2<f64>> {
        let sum = |terms: &Vec<(usize, Matrix2<f64>)>| terms.iter().map(|(_, matrix)| matrix).sum();
        self.rows.iter().map(sum).collect()
    }

    /// W u of the displacements `u` of the body's own nodes.
    pub(crate) fn mean(&self, u: &DVector<f64>) -> DVector<f64> {
        self.means(&DMatrix::from_column_slice(u.len(), 1, u.as_slice()))
            .column(0)
            .into_owned()
    }

    fn means(&self, u: &DMatrix<f64>) -> DMatrix<f64> {
        let mut means = DMatrix::zeros(2 * self.rows.len(), u.ncols());
        for (from, mut to) in u.column_iter().zip(means.column_iter_mut()) {
            for (hat, terms) in self.rows.iter().enumerate() {
                let mut sum = Vector2::zeros();
                for (node, matrix) in terms {
                    sum += matrix * from.fixed_rows::<2>(2 * node);
                }
                to.fixed_rows_mut::<2>(2 * hat).copy_from(&sum);
            }
        }
        means
    }

    /// Wᵀ f of the forces `f` on the hats: those on `count` nodes of the body's own.
    pub(crate) fn spread(&self, f: &[f64], count: usize) -> Vec<f64> {
        let mut all = vec![0.0; 2 * count];
        for (hat, terms) in self.rows.iter().enumerate() {
            let own = Vector2::new(f[2 * hat], f[2 * hat + 1]);
            for (node, matrix) in terms {
                let force = matrix.transpose() * own;
                all[2 * node] += force[0];
                all[2 * node + 1] += force[1];
            }
        }
        all
    }

    /// W C Wᵀ.
    fn transformed(&self, compliance: &DMatrix<f64>) -> DMatrix<f64> {
        let mut spread = DMatrix::zeros(compliance.nrows(), 2 * self.rows.len());
        for (hat, terms) in self.rows.iter().enumerate() {
            for i in 0..2 {
                let mut column = spread.column_mut(2 * hat + i);
                for (node, matrix) in terms {
                    for j in 0..2 {
                        if matrix[(i, j)] != 0.0 {
                            let own = compliance.column(2 * node + j);
                            column.axpy(matrix[(i, j)], &own, 1.0);
                        }
                    }
                }
            }
        }
        self.means(&spread)
    }
}

impl InterfaceOperator for ThinnedBody {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        self.compliance.as_ref()
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.mode_loads.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        self.responses[case].as_ref()
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::problem::ContactPoint;
    use crate::thinned::EdgeNodes;
    use stickslip_fem_core::generate::{Generate, Rectangle};
    use stickslip_fem_core::interface::contract::{Known, check};
    use stickslip_fem_core::material::{Isotropic, PlaneState};
    use stickslip_fem_core::mesh::ElementKind;
    use stickslip_fem_core::{ElasticBody, LoadCase, RigidBody};
    use stickslip_friction::Coulomb;

    /// A floating block that rests on a rigid one, seen from five of its nine lower nodes.
    #[test]
    fn a_thinned_body_keeps_the_contract_of_operators() {
        let block = Rectangle::uniform([0.0, 8.0], [0.0, 2.0], [8, 2], ElementKind::Q4);
        let mesh = block.unwrap().generate().unwrap();
        let nodes = mesh.edge_path("bottom").unwrap().nodes;
        let points: Vec<Point> = nodes.iter().map(|&node| mesh.nodes()[node]).collect();
        let pushed = mesh.nodes()[3];
        let mut forces = vec![0.0; 2 * mesh.nodes().len()];
        forces[6..8].copy_from_slice(&[2.0, -1.0]);
        let case = LoadCase {
            forces,
            ..LoadCase::default()
        };
        let material = Isotropic::new(4.0, 0.3, PlaneState::Stress).unwrap();
        let body = ElasticBody::new(Arc::new(mesh), vec![Arc::new(material)], 1.0).unwrap();
        let body = Arc::new(body.with_load_cases(vec![case]).unwrap());
        let whole = body.condense(&nodes).unwrap();
        let base = RigidBody::held(points.clone(), 1);

        let point = |node: usize| ContactPoint {
            first: node.into(),
            second: node.into(),
            normal: [0.0, 1.0],
            gap: 0.0,
            area: 1.0,
            material_angle: 0.0,
        };
        let pairs = [ContactPair {
            name: "base".to_owned(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points: (0..nodes.len()).map(point).collect(),
            law: Arc::new(Coulomb::new(0.3).unwrap()),
        }];
        let edge = EdgeNodes {
            parameter: points.iter().map(|point| point[0]).collect(),
            closed: None,
            mirrored: [false; 2],
        };
        let hats = [Hats::new(&pairs[0], &edge, &[0, 1, 4, 6, 8]).unwrap()];
        let [x, y] = pushed;
        let known = Known {
            placed: true,
            resultants: &[[2.0, -1.0, -x - 2.0 * y]],
        };
        let operators: [&dyn InterfaceOperator; 2] = [&whole, &base];
        for (index, operator) in operators.into_iter().enumerate() {
            let thinned = ThinnedBody::new(index, operator, &pairs, &hats, &[]);
            assert_eq!(thinned.points().len(), 5);
            assert_eq!(thinned.gives(), operator.gives());
            assert_eq!(check(&thinned, known), Ok(()));
        }
    }
}
