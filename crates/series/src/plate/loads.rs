//! Loads on the outer edges of a plate.

use nalgebra::Complex;
use stickslip_fem_core::mesh::Point;

use crate::circle::{Circle, check_load};
use crate::error::SeriesError;
use crate::nodes::Nodes;
use crate::outline::{Outline, Surrounding};

/// A force on an outer edge, as an even traction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeLoad {
    /// Index of the edge.
    pub edge: usize,
    /// Its whole force `[force]`, also in a half model.
    pub force: [f64; 2],
}

/// Load cases as tractions on edges and as resultants about the hole's centre: force along x and y, moment.
pub(super) struct Actions {
    pub(super) tractions: Vec<Vec<Complex<f64>>>,
    pub(super) resultants: Vec<[f64; 3]>,
}

pub(super) fn actions(
    nodes: &Nodes,
    circle: Circle,
    outline: &Outline,
    surrounding: &Surrounding,
    loads: &[Vec<EdgeLoad>],
) -> Result<Actions, SeriesError> {
    let mut found = Actions {
        tractions: Vec::with_capacity(loads.len()),
        resultants: Vec::with_capacity(loads.len()),
    };
    for (case, forces) in loads.iter().enumerate() {
        let mut tractions = vec![Complex::new(0.0, 0.0); outline.edges()];
        let mut resultant = [0.0; 3];
        for &EdgeLoad { edge, force } in forces {
            let [x, y] = force;
            check_load(
                case,
                false,
                &[("a force along x", x, false), ("a force along y", y, false)],
            )?;
            let edges = outline.edges();
            let side = surrounding.sides.get(edge);
            let side = side.ok_or(SeriesError::UnknownEdge { case, edge, edges })?;
            let area = side.length * circle.radius * circle.thickness;
            tractions[edge] += Complex::new(x, y) / area;
            let [start, end] = outline.edge(edge);
            let arm: Point = std::array::from_fn(|i| 0.5 * (start[i] + end[i]) - circle.centre[i]);
            let own = [x, y, arm[0] * y - arm[1] * x];
            resultant
                .iter_mut()
                .zip(own)
                .for_each(|(sum, part)| *sum += part);
        }
        if let (true, Some(images)) = (nodes.is_mirrored(), &surrounding.images) {
            let largest = tractions.iter().map(|t| t.norm()).fold(0.0, f64::max);
            for (edge, &image) in images.iter().enumerate() {
                let difference = (tractions[edge] - tractions[image].conj()).norm();
                if difference > 1e-9 * largest {
                    return Err(SeriesError::NotSymmetric {
                        case,
                        what: "the traction of an edge less the image of that on the opposite edge",
                        value: difference,
                    });
                }
            }
        }
        found.tractions.push(tractions);
        found.resultants.push(resultant);
    }
    Ok(found)
}
