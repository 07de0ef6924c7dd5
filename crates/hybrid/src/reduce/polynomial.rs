//! Local weighted polynomials: settings, neighbours, and what makes a node extrapolated.

use stickslip_fem_core::mesh::Point;

use super::{Reason, ReduceError, Stencil, error, fit};
use crate::data::{Field, Measurement};
use crate::neighbours::Neighbours;

/// The factor by which the radius of a local fit exceeds the distance of its farthest counted neighbour, so that this one, and all
/// that are as far, have a weight.
const MARGIN: f64 = 1.05;

/// So often neighbours are doubled where they do not determine the polynomial.
const DOUBLED: u32 = 2;

/// A local weighted polynomial fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalPolynomial {
    /// Order of the polynomial, 1 to 3.
    pub order: usize,
    /// Neighbours of a node that take part, at least 3, 6, 10 for orders 1, 2, 3; points as far as the last one take part too, and up to
    /// four times as many where these do not determine the polynomial.
    pub neighbours: usize,
    /// Distance within which they must lie `[length]`; infinite where any will do.
    pub largest_radius: f64,
    /// Whether a node may lie outside its neighbours' hull, on an edge that the data do not reach, say. Its variance grows
    /// quickly with the distance, which the covariance shows.
    pub extrapolate: bool,
}

impl LocalPolynomial {
    pub(super) fn check(&self, measurement: &Measurement) -> Result<(), ReduceError> {
        if !(1..=3).contains(&self.order) {
            return Err(ReduceError::Order(self.order));
        }
        let needed = fit::terms(self.order);
        if self.neighbours < needed {
            return Err(ReduceError::Neighbours {
                order: self.order,
                needed,
                found: self.neighbours,
            });
        }
        error::positive("the largest radius", self.largest_radius)?;
        for field in Field::BOTH {
            let valid = measurement.count(field);
            if valid < self.neighbours {
                return Err(ReduceError::TooFew {
                    component: field.component(),
                    valid,
                    needed: self.neighbours,
                });
            }
        }
        Ok(())
    }

    /// Neighbours that do not determine the polynomial, such as the first rows of a grid beside an edge, are doubled, twice at most.
    pub(super) fn stencil(
        &self,
        tree: &Neighbours,
        places: &[Point],
        at: Point,
    ) -> Result<Stencil, Reason> {
        let own = self.of_neighbours(self.neighbours, tree, places, at);
        (1..=DOUBLED).fold(own, |found, times| match found {
            Err(Reason::Degenerate) => self
                .of_neighbours(self.neighbours << times, tree, places, at)
                .map_err(|_| Reason::Degenerate),
            _ => found,
        })
    }

    fn of_neighbours(
        &self,
        neighbours: usize,
        tree: &Neighbours,
        places: &[Point],
        at: Point,
    ) -> Result<Stencil, Reason> {
        let nearest = tree.nearest(at, neighbours);
        let farthest = nearest
            .last()
            .map_or(f64::INFINITY, |&(distance, _)| distance);
        if farthest > self.largest_radius {
            return Err(Reason::Sparse {
                neighbours,
                radius: farthest,
                largest: self.largest_radius,
            });
        }
        let radius = MARGIN * farthest;
        let indices: Vec<usize> = tree
            .within(at, radius)
            .iter()
            .map(|&(_, index)| index)
            .collect();
        let around: Vec<Point> = indices.iter().map(|&index| places[index]).collect();
        let open = fit::open_angle(&around, at);
        // A node among the places of a straight edge sees half a turn without any, up to rounding.
        if !self.extrapolate && open > std::f64::consts::PI + 1e-6 && !around.contains(&at) {
            return Err(Reason::OneSided {
                open: open.to_degrees(),
            });
        }
        let weights = fit::weights(&around, at, radius, self.order).ok_or(Reason::Degenerate)?;
        Ok(indices.into_iter().zip(weights).collect())
    }
}
