//! The sign of the shear along one half of a loaded edge.
//!
//! ```text
//! τ = τ_rθ sgn θ       positive where friction pulls the plate's edge towards the bearing point θ = 0
//! ```
//!
//! An edge that slips while the load grows is stretched away from the bearing point, so that τ > 0. Where τ < 0 the shear is called
//! reversed.

/// Shear below this part of its peak has no sign.
const NEGLIGIBLE: f64 = 1e-3;

/// A node in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point {
    /// |θ| from the bearing point `[degree]`.
    pub(crate) angle: f64,
    /// τ `[stress]`.
    pub(crate) shear: f64,
    /// Largest shear that friction carries there before any slip `[stress]`.
    pub(crate) limit: f64,
    /// Whether it sticks.
    pub(crate) sticks: bool,
}

/// How the sign runs from the bearing point to the end of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Pattern {
    /// There is no shear.
    None,
    /// Not reversed anywhere.
    Forward,
    /// Reversed somewhere, not at the end of contact.
    ReversedInside,
    /// Reversed at the end of contact, not everywhere.
    ReversedOutside,
    /// Reversed everywhere.
    Reversed,
}

/// The largest reversed shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reversal {
    /// |θ| where it is `[degree]`.
    pub(crate) angle: f64,
    /// Its part of the peak shear of the edge, in (0, 1].
    pub(crate) of_peak: f64,
    /// Its part of the friction's limit at its place.
    pub(crate) of_limit: f64,
    /// Whether its place sticks.
    pub(crate) sticks: bool,
}

/// What a curve says.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reading {
    pub(crate) pattern: Pattern,
    /// |θ| of the last node in contact `[degree]`; 0 without contact.
    pub(crate) end: f64,
    /// Largest |τ| `[stress]`.
    pub(crate) peak: f64,
    /// |θ| of every change of sign `[degree]`, ascending.
    pub(crate) crossings: Vec<f64>,
    pub(crate) reversal: Option<Reversal>,
}

impl Reading {
    /// |θ| up to which the shear is reversed `[degree]`, where contact goes on beyond it with shear that is not: the outermost
    /// passage from reversed to forward shear.
    pub(crate) fn reach(&self) -> Option<f64> {
        match self.pattern {
            Pattern::ReversedInside => self.crossings.last().copied(),
            Pattern::ReversedOutside if self.crossings.len() > 1 => {
                self.crossings.iter().rev().nth(1).copied()
            }
            _ => None,
        }
    }
}

/// Reads the sign off the nodes in contact of one half, by ascending angle; the bearing point itself has no sign.
pub(crate) fn read(points: &[Point]) -> Reading {
    let peak = points
        .iter()
        .fold(0.0_f64, |most, p| most.max(p.shear.abs()));
    let signed: Vec<&Point> = points
        .iter()
        .filter(|point| peak > 0.0 && point.shear.abs() > NEGLIGIBLE * peak)
        .collect();
    let curve: Vec<[f64; 2]> = signed
        .iter()
        .map(|point| [point.angle, point.shear])
        .collect();
    let crossings = super::crossings(&curve);
    let reversed = signed.iter().filter(|point| point.shear < 0.0);
    let largest = reversed.min_by(|a, b| a.shear.total_cmp(&b.shear));
    let last_is_reversed = signed.last().is_some_and(|point| point.shear < 0.0);
    let forward = signed.iter().any(|point| point.shear > 0.0);
    Reading {
        pattern: match (forward, largest.is_some()) {
            (false, false) => Pattern::None,
            (true, false) => Pattern::Forward,
            (false, true) => Pattern::Reversed,
            (true, true) if last_is_reversed => Pattern::ReversedOutside,
            (true, true) => Pattern::ReversedInside,
        },
        end: points.last().map_or(0.0, |point| point.angle),
        peak,
        crossings,
        reversal: largest.map(|point| Reversal {
            angle: point.angle,
            of_peak: -point.shear / peak,
            of_limit: -point.shear / point.limit,
            sticks: point.sticks,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(shear: impl Fn(f64) -> f64) -> Vec<Point> {
        (0..=80)
            .map(|degree| Point {
                angle: f64::from(degree),
                shear: shear(f64::from(degree)),
                limit: 2.0,
                sticks: degree < 20,
            })
            .collect()
    }

    #[test]
    fn shear_of_one_sign_is_forward() {
        let reading = read(&curve(|a| (2.0 * a).to_radians().sin()));
        assert_eq!(reading.pattern, Pattern::Forward);
        assert_eq!((reading.end, reading.reach()), (80.0, None));
        assert!((reading.peak - 1.0).abs() < 1e-12);
        assert!(reading.crossings.is_empty() && reading.reversal.is_none());
    }

    #[test]
    fn the_report_s_reversal_is_inside_and_its_place_and_size_are_found() {
        let reading = read(&curve(|a| (3.0 * (a - 60.2)).to_radians().sin()));
        assert_eq!(reading.pattern, Pattern::ReversedInside);
        // Interpolation of a sine of 3 a over one degree errs by less than its curvature, and here the passage is nearly straight.
        let reach = reading.reach().expect("it has an outer end");
        assert!((reach - 60.2).abs() < 1e-3, "{reach}");
        let reversal = reading.reversal.expect("reversed");
        // The sine is −1 at 30.2°; the nearest node is at 30°.
        assert_eq!((reversal.angle, reversal.sticks), (30.0, false));
        assert!((reversal.of_peak - 1.0).abs() < 1e-12);
        assert!((reversal.of_limit - 0.5).abs() < 1e-4);
    }

    #[test]
    fn a_crossing_between_nodes_is_interpolated() {
        let reading = read(&curve(|a| a - 12.25));
        assert_eq!(reading.pattern, Pattern::ReversedInside);
        assert_eq!(reading.crossings, [12.25]);
        let reversal = reading.reversal.expect("reversed");
        assert_eq!((reversal.angle, reversal.sticks), (0.0, true));
        assert!((reversal.of_limit - 12.25 / 2.0).abs() < 1e-12);
        assert!((reversal.of_peak - 12.25 / 67.75).abs() < 1e-12);
    }

    #[test]
    fn partial_unloading_reverses_outside() {
        let reading = read(&curve(|a| 50.5 - a));
        assert_eq!(reading.pattern, Pattern::ReversedOutside);
        assert_eq!((reading.crossings.len(), reading.reach()), (1, None));
        let band = read(&curve(|a| (a - 20.5) * (a - 60.5) * (70.5 - a)));
        assert_eq!(band.pattern, Pattern::ReversedOutside);
        let reach = band.reach().expect("a reversed band lies inside");
        assert!((reach - 60.5).abs() < 0.1, "{reach}");
    }

    #[test]
    fn rounding_has_no_sign() {
        let reading = read(&curve(|a| if a < 5.0 { -1e-9 } else { 1.0 }));
        assert_eq!(reading.pattern, Pattern::Forward);
        assert_eq!(read(&curve(|_| 0.0)).pattern, Pattern::None);
        assert_eq!(read(&[]).pattern, Pattern::None);
        assert_eq!(read(&curve(|_| -1.0)).pattern, Pattern::Reversed);
    }
}
