//! The initial load taken off, and front against back.

use stickslip_fem_core::mesh::Point;

use super::format::{LENGTH, not_negative, positive};
use super::{DataError, Field, FringeLine, FringeLines, Measurement, Track};
use crate::moire::Grating;
use crate::neighbours::Neighbours;
use crate::triangles::Triangles;

/// How the displacements at the initial load are taken to the places of the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NullField {
    /// Both were measured at the same places, up to a tolerance `[length]`.
    SamePlaces {
        /// Largest distance between places that count as one `[length]`.
        tolerance: f64,
    },
    /// Linear interpolation over triangles of the places at the initial load.
    Interpolated {
        /// Longest side of a triangle that is no gap in the data `[length]`.
        longest_side: f64,
    },
}

impl Measurement {
    /// What the load has added: these displacements minus those of the initial load `null`.
    ///
    /// A component is masked where either is masked or the null field was not measured. The standard deviation is √(σ² + σ₀²): exact at
    /// common places, an upper bound of each point's where the null field is interpolated (its correlation between neighbours,
    /// which share triangles, is not kept).
    ///
    /// # Errors
    /// [`DataError`]: a tolerance or side out of range, a null field that cannot be triangulated, no point left.
    pub fn minus(&self, null: &Self, how: NullField) -> Result<Self, DataError> {
        self.check()?;
        null.check()?;
        let mut difference = self.clone();
        for field in Field::BOTH {
            let c = field.component();
            if self.count(field) == 0 || null.count(field) == 0 {
                difference.mask(field, |_| true);
                continue;
            }
            let at = null.lookup(c, how)?;
            for k in 0..self.places.len() {
                let known = if self.valid[c][k] {
                    at(self.places[k])
                } else {
                    None
                };
                difference.valid[c][k] = known.is_some();
                difference.displacements[c][k] =
                    known.map_or(f64::NAN, |u| self.displacements[c][k] - u);
            }
        }
        difference.deviation = std::array::from_fn(|c| self.deviation[c].hypot(null.deviation[c]));
        if Field::BOTH.map(|field| difference.count(field)) == [0, 0] {
            return Err(DataError::AllMasked {
                file: "the difference to the null field".into(),
                rows: self.places.len(),
                remedy: "the null field has no valid point where the load has one",
            });
        }
        Ok(difference)
    }

    /// Masks a field's displacements at the places that `bad` names by their index.
    pub fn mask(&mut self, field: Field, bad: impl Fn(usize) -> bool) {
        let c = field.component();
        let marks = self.valid[c].iter_mut().zip(&mut self.displacements[c]);
        for (k, (valid, value)) in marks.enumerate() {
            if bad(k) {
                *valid = false;
                *value = f64::NAN;
            }
        }
    }

    /// Orders of a field at `places` `[length]` of a chosen line, interpolated over triangles with sides of at most
    /// `longest_side` `[length]`: what front and back are compared by where the data are no fringe centres.
    ///
    /// # Errors
    /// [`DataError`]: a place where the component is not known, a side out of range, valid places that cannot be triangulated, and
    /// as for [`FringeLine::new`] with a drawn track.
    pub fn along(
        &self,
        name: &str,
        field: Field,
        places: &[Point],
        longest_side: f64,
        grating: &Grating,
    ) -> Result<FringeLine, DataError> {
        self.check()?;
        let at = self.lookup(field.component(), NullField::Interpolated { longest_side })?;
        let centres = places
            .iter()
            .map(|&place| match at(place) {
                Some(displacement) => Ok((place, grating.order(displacement))),
                None => Err(DataError::NotCovered {
                    name: name.into(),
                    x: place[0],
                    y: place[1],
                }),
            })
            .collect::<Result<Vec<_>, _>>()?;
        FringeLine::new("measurement", name, Track::Drawn, &centres, f64::INFINITY)
    }

    /// Component `c` at any place, where it is known.
    fn lookup(
        &self,
        c: usize,
        how: NullField,
    ) -> Result<Box<dyn Fn(Point) -> Option<f64> + '_>, DataError> {
        let value = move |index: usize| self.displacements[c][index];
        match how {
            NullField::SamePlaces { tolerance } => {
                not_negative("the tolerance of common places", tolerance, LENGTH)?;
                let tree = Neighbours::new(&self.places, &self.valid[c]);
                Ok(Box::new(move |place| {
                    let (distance, index) = tree.nearest(place, 1).pop()?;
                    (distance <= tolerance).then(|| value(index))
                }))
            }
            NullField::Interpolated { longest_side } => {
                if longest_side != f64::INFINITY {
                    positive("the longest side", longest_side)?;
                }
                let triangles = Triangles::new(&self.places, &self.valid[c]).map_err(|cause| {
                    DataError::Triangulation {
                        component: c,
                        cause,
                    }
                })?;
                Ok(Box::new(move |place| {
                    let weights = triangles.weights(place, longest_side).ok()?;
                    Some(
                        weights
                            .iter()
                            .map(|&(index, weight)| weight * value(index))
                            .sum(),
                    )
                }))
            }
        }
    }
}

/// Fringe lines with the null field taken off.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Orders that the load has added, at the centres where the null field is known.
    pub lines: FringeLines,
    /// Line and place `[length]` of the centres that lie beyond the null field's line.
    pub left_out: Vec<(String, Point)>,
}

impl FringeLines {
    /// What the load has added: these orders minus those of the initial load `null`, which are interpolated along the line of the
    /// same name `[fringes]`. Of independent centres with the standard deviations σ here and σ₀ there, the differences have at most
    /// √(σ² + σ₀²), because an order between two centres is a mean of theirs.
    ///
    /// # Errors
    /// [`DataError::Fields`] for fields of two directions, [`DataError::NoSuchLine`] for a line that `null` has not,
    /// [`DataError::Apart`] for one of which fewer than 2 centres remain.
    pub fn minus(&self, null: &Self) -> Result<Difference, DataError> {
        if self.field != null.field {
            return Err(DataError::Fields {
                first: self.field,
                second: null.field,
            });
        }
        let mut left_out = Vec::new();
        let mut lines = Vec::new();
        for line in &self.lines {
            let other = null
                .line(line.name())
                .ok_or_else(|| DataError::NoSuchLine {
                    file: "null field".into(),
                    name: line.name().into(),
                    available: null
                        .lines
                        .iter()
                        .map(FringeLine::name)
                        .collect::<Vec<_>>()
                        .join(", "),
                })?;
            let (mut kept, mut orders) = (Vec::new(), Vec::new());
            for (k, (&place, &order)) in line.places().iter().zip(line.orders()).enumerate() {
                if let Some(initial) = other.order_at(place) {
                    kept.push(k);
                    orders.push(order - initial);
                } else {
                    left_out.push((line.name().to_owned(), place));
                }
            }
            if kept.len() < 2 {
                return Err(DataError::Apart {
                    first: line.name().into(),
                    second: format!("{} of the null field", other.name()),
                });
            }
            lines.push(line.with_orders(&kept, orders));
        }
        Ok(Difference {
            lines: Self {
                field: self.field,
                lines,
            },
            left_out,
        })
    }
}

/// How far front and back of a plate differ along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetry {
    /// Largest difference of the orders `[fringes]`, without sign.
    pub largest: f64,
    /// Where `[length]`.
    pub place: Point,
    /// Constant that was taken off first `[fringes]`.
    pub offset: f64,
    /// Fringe centres compared, of both sides.
    pub compared: usize,
    /// Whether the largest difference is at most the tolerance.
    pub symmetric: bool,
}

impl FringeLine {
    /// Compares this line with the same line on the back; `tolerance` `[fringes]` is ¼ for a plate that bears through its whole thickness.
    ///
    /// Orders are piecewise linear, so their difference is largest at a fringe centre of either side, and all are visited. Orders
    /// count from an arbitrary fringe on either side: `free_offset` takes off the constant that makes the largest difference least.
    ///
    /// # Errors
    /// [`DataError::Apart`] where the lines share fewer than 2 fringe centres' places; [`DataError::Setting`] for a tolerance that is
    /// negative or no number.
    pub fn symmetry(
        &self,
        back: &Self,
        tolerance: f64,
        free_offset: bool,
    ) -> Result<Symmetry, DataError> {
        let range = "it is a number of fringes, 0 or above";
        not_negative("the tolerance of symmetry", tolerance, range)?;
        let front = |place| self.order_at(place);
        let differences: Vec<(Point, f64)> = [self, back]
            .iter()
            .flat_map(|line| line.places())
            .filter_map(|&place| Some((place, front(place)? - back.order_at(place)?)))
            .collect();
        if differences.len() < 2 {
            return Err(DataError::Apart {
                first: self.name().into(),
                second: format!("{} of the back", back.name()),
            });
        }
        let (least, most) = differences.iter().fold(
            (f64::INFINITY, f64::NEG_INFINITY),
            |(least, most), &(_, d)| (least.min(d), most.max(d)),
        );
        let offset = if free_offset {
            0.5 * (least + most)
        } else {
            0.0
        };
        let (place, largest) =
            differences
                .iter()
                .fold((differences[0].0, 0.0), |worst, &(place, d)| {
                    let size = (d - offset).abs();
                    if size > worst.1 { (place, size) } else { worst }
                });
        Ok(Symmetry {
            largest,
            place,
            offset,
            compared: differences.len(),
            symmetric: largest <= tolerance,
        })
    }
}
