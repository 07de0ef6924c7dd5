//! What every [`InterfaceOperator`] must fulfil, as a check that a new implementation calls in its tests.
//!
//! ```text
//! C = Cᵀ,   λᵀ C λ ≥ 0                          a body takes up work
//! R: translations and turns of the points        on which no contact force works that is in balance
//! r_k = Rᵀ f_k                                   the resultants of load case k, where they are known
//! ```

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use thiserror::Error;

use super::InterfaceOperator;
use super::misfit::{Misfit, fits};
use crate::mesh::Point;

/// Part of the largest entry up to which an asymmetry is rounding.
const SYMMETRIC: f64 = 1e-10;
/// Part of the largest eigenvalue up to which a negative one is rounding.
const SEMIDEFINITE: f64 = 1e-9;
/// Part of a motion, of the forces of a load case, or of a compliance in two forms, up to which a difference is rounding.
const SAME: f64 = 1e-8;

/// What is known of the body behind an operator.
#[derive(Clone, Copy, Debug, Default)]
pub struct Known<'a> {
    /// Whether its points lie where the body has them, so that its free motions are translations and turns of them. Not so of a
    /// [`GivenBody`](super::GivenBody), whose points are a list.
    pub placed: bool,
    /// Resultants of each load case: force along x and y `[force]`, moment about the origin `[force·length]`. Needs `placed`; empty
    /// if they are not known.
    pub resultants: &'a [[f64; 3]],
}

/// How an operator breaks the contract.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum Breach {
    /// A matrix or a vector does not fit the number of points or of free motions, or is not finite.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// The compliance is not symmetric.
    #[error("the compliance is asymmetric by {difference:.1e} of its largest entry")]
    Asymmetric {
        /// Largest difference, relative to the largest entry `[1]`.
        difference: f64,
    },
    /// A force does negative work.
    #[error(
        "the compliance has an eigenvalue of {ratio:.1e} times the largest: the body would release energy"
    )]
    Indefinite {
        /// Least eigenvalue over the largest `[1]`.
        ratio: f64,
    },
    /// The compliance in blocks is not that of the matrix.
    #[error(
        "the compliance in blocks differs from its matrix by {difference:.1e} of the largest entry"
    )]
    Blocks {
        /// Largest difference, relative to the largest entry `[1]`.
        difference: f64,
    },
    /// A free motion deforms the contact.
    #[error("free motion {motion} differs from every rigid motion by {difference:.1e} of its size")]
    NotRigid {
        /// Index of the motion.
        motion: usize,
        /// Largest difference, relative to its largest displacement `[1]`.
        difference: f64,
    },
    /// The resultant of a load case is not that of its forces.
    #[error(
        "load case {case}: the resultant in free motion {motion} is {found}, that of its forces {expected}"
    )]
    Resultant {
        /// Index of the load case.
        case: usize,
        /// Index of the motion.
        motion: usize,
        /// What the operator says `[force]`.
        found: f64,
        /// What the forces make `[force]`.
        expected: f64,
    },
}

/// Tests `operator` by what is `known` of its body.
///
/// ```
/// use stickslip_fem_core::interface::contract::{Known, check};
/// use stickslip_fem_core::RigidBody;
///
/// let block = RigidBody::sliding(vec![[0.0, 0.0], [1.0, 0.0]], [true, true], &[[3.0, -4.0]]);
/// let known = Known { placed: true, resultants: &[[3.0, -4.0, 0.0]] };
/// assert_eq!(check(&block, known), Ok(()));
/// ```
///
/// # Errors
/// The first [`Breach`].
pub fn check(operator: &dyn InterfaceOperator, known: Known<'_>) -> Result<(), Breach> {
    let size = 2 * operator.points().len();
    let free = operator.modes().ncols();
    let name = |what: &'static str| move || what.to_owned();
    if let Some(compliance) = operator.compliance() {
        fits(name("the compliance"), compliance, [size, size])?;
        check_compliance(compliance)?;
    }
    if let Some(blocks) = operator.blocks() {
        let whole = blocks.matrix();
        fits(name("the compliance in blocks"), &whole, [size, size])?;
        check_compliance(&whole)?;
        if let Some(compliance) = operator.compliance() {
            let difference = (&whole - compliance).amax() / compliance.amax();
            if difference > SAME {
                return Err(Breach::Blocks { difference });
            }
        }
    }
    let modes = operator.modes();
    fits(name("the matrix of free motions"), modes, [size, free])?;
    for case in 0..operator.load_cases() {
        let name = |what: &'static str| move || format!("{what} load case {case}");
        if let Some(response) = operator.load_response(case) {
            fits(name("the response to"), response, [size, 1])?;
        }
        let load = operator.mode_load(case);
        fits(name("the resultants of"), load, [free, 1])?;
    }
    if known.placed {
        check_motions(operator, known.resultants)?;
    }
    Ok(())
}

fn check_compliance(compliance: &DMatrix<f64>) -> Result<(), Breach> {
    let largest = compliance.amax();
    if largest == 0.0 {
        return Ok(());
    }
    let difference = (compliance - compliance.transpose()).amax() / largest;
    if difference > SYMMETRIC {
        return Err(Breach::Asymmetric { difference });
    }
    let values = SymmetricEigen::new(compliance.clone()).eigenvalues;
    let ratio = values.min() / values.amax();
    if ratio < -SEMIDEFINITE {
        return Err(Breach::Indefinite { ratio });
    }
    Ok(())
}

/// Compares each free motion with the rigid motion nearest to it, and its resultants with those of the forces along that motion.
fn check_motions(operator: &dyn InterfaceOperator, resultants: &[[f64; 3]]) -> Result<(), Breach> {
    let basis = Basis::of(operator.points());
    let Some(basis) = basis else { return Ok(()) };
    let motions = operator.modes().column_iter().enumerate();
    for (motion, column) in motions {
        let column = column.into_owned();
        let amounts = basis.nearest(&column);
        let size = column.amax();
        let difference = (&basis.motions * &amounts - column).amax() / size.max(f64::MIN_POSITIVE);
        if difference > SAME {
            return Err(Breach::NotRigid { motion, difference });
        }
        for (case, resultant) in resultants.iter().enumerate().take(operator.load_cases()) {
            let [x, y, moment] = *resultant;
            let [cx, cy] = basis.centre;
            let parts = [x, y, (moment - cx * y + cy * x) / basis.length];
            let expected: f64 = parts.iter().zip(amounts.iter()).map(|(f, u)| f * u).sum();
            let scale: f64 = parts
                .iter()
                .zip(amounts.iter())
                .map(|(f, u)| (f * u).abs())
                .sum();
            let found = operator.mode_load(case)[motion];
            if (found - expected).abs() > SAME * scale.max(found.abs()) {
                return Err(Breach::Resultant {
                    case,
                    motion,
                    found,
                    expected,
                });
            }
        }
    }
    Ok(())
}

/// Translations and the turn about the middle of some points, divided by their extent.
struct Basis {
    motions: DMatrix<f64>,
    centre: Point,
    length: f64,
}

impl Basis {
    /// `None` where the points are one place, which does not know turns.
    fn of(points: &[Point]) -> Option<Self> {
        let count = points.len() as f64;
        let sum = points
            .iter()
            .fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
        let centre = sum.map(|value| value / count);
        let reach = |p: &Point| (p[0] - centre[0]).hypot(p[1] - centre[1]);
        let length = points.iter().map(reach).fold(0.0, f64::max);
        (length > 0.0).then(|| Self {
            motions: super::rigid_motions(points, centre, length),
            centre,
            length,
        })
    }

    /// Amounts of the rigid motion nearest to `column`, by least squares: columns are independent where points are two places.
    fn nearest(&self, column: &DVector<f64>) -> DVector<f64> {
        let normal = self.motions.tr_mul(&self.motions);
        let side = self.motions.tr_mul(column);
        normal
            .lu()
            .solve(&side)
            .unwrap_or_else(|| DVector::zeros(3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Block, BlockCompliance, GivenBody, RigidBody};

    const UNKNOWN: Known<'static> = Known {
        placed: false,
        resultants: &[],
    };

    fn given(compliance: [f64; 4]) -> GivenBody {
        let compliance = DMatrix::from_row_slice(2, 2, &compliance);
        GivenBody::held(compliance, Vec::new()).unwrap()
    }

    #[test]
    fn shipped_operators_of_numbers_keep_the_contract() {
        assert_eq!(check(&given([2.0, 0.5, 0.5, 1.0]), UNKNOWN), Ok(()));
        let points = vec![[1.0, 2.0], [3.0, -1.0], [0.5, 0.0]];
        let known = Known {
            placed: true,
            resultants: &[[2.0, -1.0, 7.0]],
        };
        assert_eq!(check(&RigidBody::held(points.clone(), 1), known), Ok(()));
        let block = RigidBody::sliding(points, [true, false], &[[2.0, -1.0]]);
        assert_eq!(check(&block, known), Ok(()));
    }

    /// A held body whose compliance has a block for either component of its point.
    #[derive(Debug)]
    struct InBlocks {
        body: GivenBody,
        has_matrix: bool,
        blocks: BlockCompliance,
    }

    impl InBlocks {
        fn new(has_matrix: bool, own: [f64; 2], core: [f64; 2]) -> Self {
            let blocks = own.into_iter().enumerate().map(|(row, own)| Block {
                rows: vec![row],
                own: DMatrix::from_element(1, 1, own),
                shapes: DMatrix::from_element(1, 1, 1.0),
            });
            let core = DMatrix::from_row_slice(2, 2, &[0.0, core[0], core[1], 0.0]);
            Self {
                body: given([2.0, 0.5, 0.5, 1.0]),
                has_matrix,
                blocks: BlockCompliance::new(blocks.collect(), core),
            }
        }
    }

    impl InterfaceOperator for InBlocks {
        fn points(&self) -> &[Point] {
            self.body.points()
        }

        fn compliance(&self) -> Option<&DMatrix<f64>> {
            self.body.compliance().filter(|_| self.has_matrix)
        }

        fn blocks(&self) -> Option<&BlockCompliance> {
            Some(&self.blocks)
        }

        fn modes(&self) -> &DMatrix<f64> {
            self.body.modes()
        }

        fn load_cases(&self) -> usize {
            0
        }

        fn load_response(&self, _case: usize) -> Option<&DVector<f64>> {
            None
        }

        fn mode_load(&self, case: usize) -> &DVector<f64> {
            self.body.mode_load(case)
        }
    }

    #[test]
    fn blocks_keep_the_contract_of_a_matrix_and_agree_with_it() {
        let found = |has_matrix, own, core| check(&InBlocks::new(has_matrix, own, core), UNKNOWN);
        for has_matrix in [true, false] {
            assert_eq!(found(has_matrix, [2.0, 1.0], [0.5; 2]), Ok(()));
            assert!(matches!(
                found(has_matrix, [2.0, 1.0], [0.5, 0.4]),
                Err(Breach::Asymmetric { .. })
            ));
            assert!(matches!(
                found(has_matrix, [1.0, 1.0], [2.0; 2]),
                Err(Breach::Indefinite { .. })
            ));
        }
        let other = [2.0, 1.5];
        assert_eq!(found(false, other, [0.5; 2]), Ok(()));
        let difference = 0.25;
        assert_eq!(
            found(true, other, [0.5; 2]),
            Err(Breach::Blocks { difference })
        );
    }

    #[test]
    fn breaches_are_found() {
        assert!(matches!(
            check(&given([2.0, 0.5, 0.4, 1.0]), UNKNOWN),
            Err(Breach::Asymmetric { .. })
        ));
        assert!(matches!(
            check(&given([1.0, 2.0, 2.0, 1.0]), UNKNOWN),
            Err(Breach::Indefinite { ratio }) if (ratio + 1.0 / 3.0).abs() < 1e-12
        ));
        let points = vec![[0.0, 0.0], [1.0, 0.0]];
        let block = RigidBody::sliding(points, [true, true], &[[2.0, -1.0]]);
        let wrong = Known {
            placed: true,
            resultants: &[[2.0, 1.0, 0.0]],
        };
        let found = Breach::Resultant {
            case: 0,
            motion: 1,
            found: -1.0,
            expected: 1.0,
        };
        assert_eq!(check(&block, wrong), Err(found));
        let stretched = GivenBody::floating(
            DMatrix::identity(4, 4),
            DMatrix::from_column_slice(4, 1, &[0.0, 0.0, 0.0, 1.0]),
            Vec::new(),
            Vec::new(),
        );
        // Its points lie above each other, so a motion of the upper one alone stretches them.
        let placed = Known {
            placed: true,
            ..UNKNOWN
        };
        assert!(matches!(
            check(&stretched.unwrap(), placed),
            Err(Breach::NotRigid { motion: 0, .. })
        ));
    }
}
