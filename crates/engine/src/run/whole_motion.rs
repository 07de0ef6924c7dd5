//! Bodies that move as a whole where nothing resists: which, and how.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::freedom::unresisted_motions;
use stickslip_contact::interface::Part;
use stickslip_contact::solver::FailureCause;
use stickslip_contact::{ContactError, Interface};
use stickslip_fem_core::mesh::Point;

use super::solved::Operator;
use crate::model::Model;
use crate::results::FreeMotion;

/// Part of the largest motion below which another one is rounding.
const NEGLIGIBLE: f64 = 1e-6;
/// A body turns about a point that is at most so many of its half sizes away from its middle; about a farther one it slides too.
const NEAR: f64 = 2.0;

/// How a body moves as a whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WholeMotion {
    /// It slides along a unit vector `[1]`.
    Slides([f64; 2]),
    /// It turns about a point in or beside it.
    Turns {
        /// Whether clockwise.
        clockwise: bool,
    },
    /// It turns while it slides along a unit vector.
    SlidesAndTurns {
        /// The unit vector `[1]`.
        along: [f64; 2],
        /// Whether it turns clockwise.
        clockwise: bool,
    },
}

impl WholeMotion {
    /// The motion as a verb: "slides along −y".
    pub fn describe(self) -> String {
        let turns = |clockwise| {
            if clockwise {
                "turns clockwise"
            } else {
                "turns counter-clockwise"
            }
        };
        match self {
            Self::Slides(along) => format!("slides along {}", direction(along)),
            Self::Turns { clockwise } => turns(clockwise).to_owned(),
            Self::SlidesAndTurns { along, clockwise } => {
                format!("slides along {} and {}", direction(along), turns(clockwise))
            }
        }
    }
}

/// "x", "−y" or "(0.6, 0.8)".
fn direction([x, y]: [f64; 2]) -> String {
    if y.abs() < NEGLIGIBLE {
        if x > 0.0 { "x" } else { "−x" }.to_owned()
    } else if x.abs() < NEGLIGIBLE {
        if y > 0.0 { "y" } else { "−y" }.to_owned()
    } else {
        format!("({x:.2}, {y:.2})").replace('-', "−")
    }
}

impl MovingBody {
    /// The body and its motion: "'pin' slides along −y".
    pub fn describe(&self) -> String {
        format!("'{}' {}", self.body, self.motion.describe())
    }
}

/// A body that moves as a whole.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingBody {
    /// Its name.
    pub body: String,
    /// How it moves.
    pub motion: WholeMotion,
}

/// The velocity of a body as a whole: of its middle, and of its farthest point about that by turning.
#[derive(Clone, Copy, Debug)]
struct Velocity {
    middle: [f64; 2],
    /// Counter-clockwise positive.
    turning: f64,
}

impl Velocity {
    /// The best fit to the displacements `moved`, interleaved, of `points`; `None` without points.
    fn of(points: &[Point], moved: &[f64]) -> Option<Self> {
        let count = points.len() as f64;
        let mean = |values: &mut dyn Iterator<Item = [f64; 2]>| {
            let sum = values.fold([0.0; 2], |[x, y], [dx, dy]| [x + dx, y + dy]);
            sum.map(|part| part / count)
        };
        let moved: Vec<[f64; 2]> = moved.chunks_exact(2).map(|own| [own[0], own[1]]).collect();
        let centre = mean(&mut points.iter().copied());
        let middle = mean(&mut moved.iter().copied());
        let (mut inertia, mut moment, mut radius) = (0.0, 0.0, 0.0_f64);
        for ([x, y], [u, v]) in points.iter().zip(&moved) {
            let [x, y] = [x - centre[0], y - centre[1]];
            inertia += x * x + y * y;
            moment += x * (v - middle[1]) - y * (u - middle[0]);
            radius = radius.max(x.hypot(y));
        }
        let turning = if inertia > 0.0 {
            moment / inertia * radius
        } else {
            0.0
        };
        (count > 0.0).then_some(Self { middle, turning })
    }

    fn size(self) -> f64 {
        let [x, y] = self.middle;
        x.hypot(y).max(self.turning.abs())
    }

    /// The motion in words' terms.
    fn motion(self) -> WholeMotion {
        let [x, y] = self.middle;
        let speed = x.hypot(y);
        let along = [x / speed, y / speed];
        let clockwise = self.turning < 0.0;
        if self.turning.abs() <= NEGLIGIBLE * speed {
            WholeMotion::Slides(along)
        } else if speed <= NEAR * self.turning.abs() {
            WholeMotion::Turns { clockwise }
        } else {
            WholeMotion::SlidesAndTurns { along, clockwise }
        }
    }
}

/// The velocity of each body of `part` in the rigid motion `motion` of its problem, with the body's index.
fn velocities(operators: &[Operator], part: &Part, motion: &[f64]) -> Vec<(usize, Velocity)> {
    let problem = part.problem();
    let rigid = DVector::from_column_slice(motion);
    let none = DVector::zeros(2 * problem.points().len());
    let bodies = part.group().bodies.iter().enumerate();
    let velocity = |(local, &index): (usize, &usize)| {
        let amounts = problem.motions_of_body(local, &rigid, &none, &[]);
        let found = if let Some(own) = operators[index].elastic() {
            let moved = own.rigid_displacements(&amounts);
            Velocity::of(own.body().mesh().nodes(), &moved)
        } else {
            let own = operators[index].interface();
            let moved = own.modes() * DVector::from_vec(amounts);
            Velocity::of(own.points(), moved.as_slice())
        };
        Some((index, found?))
    };
    bodies.filter_map(velocity).collect()
}

/// Which motions nothing resists of the bodies with the indices `bodies`, which move together and are seated by `apart` `[rad]`.
pub(super) fn free_motions(
    operators: &[Operator],
    part: &Part,
    bodies: &[usize],
    apart: f64,
) -> Vec<FreeMotion> {
    let free = unresisted_motions(part.problem(), apart);
    if free.is_empty() {
        return Vec::new();
    }
    let columns = free.column_iter().map(|motion| {
        let found = velocities(operators, part, motion.clone_owned().as_slice());
        let own = found.into_iter().filter(|(body, _)| bodies.contains(body));
        let each =
            own.flat_map(|(_, Velocity { middle, turning })| [middle[0], middle[1], turning]);
        DVector::from_vec(each.collect())
    });
    let columns: Vec<DVector<f64>> = columns.collect();
    let motions = DMatrix::from_columns(&columns);
    let independent =
        |motions: DMatrix<f64>| motions.rank(NEGLIGIBLE.max(2.0 * apart) * free.amax());
    let turning = motions.select_rows(&(2..motions.nrows()).step_by(3).collect::<Vec<_>>());
    let (all, turns) = (independent(motions), independent(turning));
    let rotation = (turns > 0).then_some(FreeMotion::Rotation);
    let translation = (all > turns).then_some(FreeMotion::Translation);
    rotation.into_iter().chain(translation).collect()
}

/// The part of the load that is not balanced `[1]` and the bodies that it moves, and how, where the end `error` of a history proves that nothing balances it; otherwise none.
pub(super) fn moving(
    model: &Model,
    operators: &[Operator],
    interface: &Interface,
    error: &ContactError,
) -> Option<(f64, Vec<MovingBody>)> {
    let ContactError::StepFailed { bodies, cause, .. } = error else {
        return None;
    };
    let mut attempts = cause.attempts.iter();
    let (unbalanced, motion) = attempts.find_map(|(_, cause)| match cause {
        FailureCause::Unbalanced {
            part,
            motion,
            proved: true,
        } => Some((*part, motion)),
        _ => None,
    })?;
    let mut parts = interface.parts().iter();
    let part = parts.find(|part| bodies.is_empty() || part.group().bodies == *bodies)?;
    let all = velocities(operators, part, motion);
    let largest = all.iter().map(|(_, own)| own.size()).fold(0.0, f64::max);
    let moves = all
        .iter()
        .filter(|(_, own)| own.size() > NEGLIGIBLE * largest);
    let named = moves.map(|&(index, own)| MovingBody {
        body: model.bodies[index].name.clone(),
        motion: own.motion(),
    });
    Some((unbalanced, named.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a square of side 2 about (5, 0).
    const SQUARE: [Point; 4] = [[4.0, -1.0], [6.0, -1.0], [6.0, 1.0], [4.0, 1.0]];

    /// The motion of the square with the velocity `at` of the origin, and the turn `turn` about that.
    fn motion(at: [f64; 2], turn: f64) -> WholeMotion {
        let moved = SQUARE
            .iter()
            .flat_map(|[x, y]| [at[0] - turn * y, at[1] + turn * x]);
        let moved: Vec<f64> = moved.collect();
        Velocity::of(&SQUARE, &moved).expect("four points").motion()
    }

    #[test]
    fn motions_are_told_by_their_centre() {
        assert_eq!(motion([0.0, -3.0], 0.0).describe(), "slides along −y");
        assert_eq!(motion([2.0, 0.0], 0.0).describe(), "slides along x");
        assert_eq!(
            motion([-3.0, 4.0], 0.0).describe(),
            "slides along (−0.60, 0.80)"
        );
        // About its middle, and about its corner.
        assert_eq!(
            motion([0.0, -5.0], 1.0).describe(),
            "turns counter-clockwise"
        );
        assert_eq!(motion([1.0, 4.0], -1.0).describe(), "turns clockwise");
        // About the origin, more than two half diagonals away.
        let far = motion([0.0; 2], 1.0).describe();
        assert_eq!(far, "slides along y and turns counter-clockwise");
        assert!(Velocity::of(&[], &[]).is_none());
        let one = Velocity::of(&SQUARE[..1], &[0.0, 1.0]).expect("a point");
        assert_eq!(one.motion(), WholeMotion::Slides([0.0, 1.0]));
    }
}
