//! Uniform strains that nothing hinders, as by a change of temperature: they move places away from the circle's centre, and make no stress.
//!
//! ```text
//! u = ε (z − c),   u_x = ε_xx x + ½ γ_xy y,   u_y = ½ γ_xy x + ε_yy y
//! ```

use nalgebra::DVector;
use stickslip_fem_core::mesh::Point;

use crate::circle::check_load;
use crate::error::SeriesError;

/// Strains (ε_xx, ε_yy, γ_xy) `[1]` of a unit of each load case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Expansions(Vec<[f64; 3]>);

impl Expansions {
    /// Those `strains` of a unit of each load case, with the displacements of `points` about `centre` added to the `responses` to these; of a half model if `mirrored`.
    ///
    /// # Errors
    /// [`SeriesError::State`] for another number of strains than of load cases, [`SeriesError::LoadNotFinite`], and [`SeriesError::NotSymmetric`] for a shear strain of a half
    /// model.
    pub(crate) fn added_to(
        responses: &mut [Option<DVector<f64>>],
        strains: &[[f64; 3]],
        (points, centre): (&[Point], Point),
        mirrored: bool,
    ) -> Result<Self, SeriesError> {
        if strains.len() != responses.len() {
            return Err(SeriesError::State {
                what: "strains",
                found: strains.len(),
                expected: responses.len(),
            });
        }
        for (case, [xx, yy, xy]) in strains.iter().enumerate() {
            let values = [
                ("the strain along x", *xx, false),
                ("the strain along y", *yy, false),
                ("the shear strain", *xy, true),
            ];
            check_load(case, mirrored, &values)?;
        }
        for (strain, response) in strains.iter().zip(responses) {
            if *strain == [0.0; 3] {
                continue;
            }
            let moved = points
                .iter()
                .flat_map(|&[x, y]| displacement(*strain, [x - centre[0], y - centre[1]]));
            let moved = DVector::from_iterator(2 * points.len(), moved);
            *response = Some(match response.take() {
                Some(own) => own + moved,
                None => moved,
            });
        }
        Ok(Self(strains.to_vec()))
    }

    /// The strain of all load cases with these multipliers.
    pub(crate) fn of(&self, multipliers: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (strain, factor) in self.0.iter().zip(multipliers) {
            for (sum, part) in sum.iter_mut().zip(strain) {
                *sum += factor * part;
            }
        }
        sum
    }
}

/// The displacement by `strain` at a place `from` the centre, in its length.
pub(crate) fn displacement([xx, yy, xy]: [f64; 3], [x, y]: Point) -> [f64; 2] {
    [xx * x + 0.5 * xy * y, 0.5 * xy * x + yy * y]
}
