//! What each load step should yield.

use stickslip::results::EdgeResults;

use super::Problem;
use crate::error::LaboratoryError;
use crate::references::{aluminium, line_contact, persson, rigid_pin};

/// Points closer to the contact's end than this `[deg]` are left out: the tables are least accurate there.
const END: f64 = 3.0;

/// Pressure and shear λ_t on the first body `[MPa]` at a place ≥ 0 along the edge.
type Profile = Box<dyn Fn(f64) -> [f64; 2]>;

/// The answer at the end of one load step.
pub(super) struct Expected {
    pub(super) step: usize,
    /// `[MPa]`
    pub(super) peak_pressure: f64,
    /// Half-angle `[rad]` or half-width `[mm]`.
    pub(super) extent: f64,
    /// Largest shear `[MPa]`.
    largest_shear: f64,
    profile: Profile,
    /// Where the profile is known, if not everywhere.
    points: Option<Vec<f64>>,
    /// Whether the shear at −x is that at x, or turned.
    even_shear: bool,
    /// Angle `[rad]` and σ_θ there `[MPa]`.
    pub(super) hoop: Option<(f64, f64)>,
}

impl Expected {
    /// Errors of pressure and shear: root mean square over the contact, of the largest.
    pub(super) fn profile_errors(&self, parameter: &[f64], edge: &EdgeResults) -> [f64; 2] {
        let mut square = [0.0; 2];
        let mut total = 0.0;
        let mut add = |weight: f64, place: f64, found: [f64; 2]| {
            let mut exact = (self.profile)(place.abs());
            if place < 0.0 && !self.even_shear {
                exact[1] = -exact[1];
            }
            total += weight;
            for ((sum, found), exact) in square.iter_mut().zip(found).zip(exact) {
                *sum += weight * (found - exact).powi(2);
            }
        };
        if let Some(points) = &self.points {
            let [pressure, shear] = [
                edge.rows.iter().map(|row| row.pressure).collect::<Vec<_>>(),
                edge.rows.iter().map(|row| row.shear).collect(),
            ];
            for &place in points {
                let value =
                    |values: &[f64]| interpolate(parameter, values, place).unwrap_or(f64::NAN);
                add(1.0, place, [value(&pressure), value(&shear)]);
            }
        } else {
            for (k, (row, &place)) in edge.rows.iter().zip(parameter).enumerate() {
                if place.abs() <= self.extent {
                    add(share(parameter, k), place, [row.pressure, row.shear]);
                }
            }
        }
        let mean = |sum: f64, scale: f64| (sum / total).sqrt() / scale;
        [
            mean(square[0], self.peak_pressure),
            mean(square[1], self.largest_shear),
        ]
    }
}

/// Half of the distance between the neighbours of node `k`.
fn share(parameter: &[f64], k: usize) -> f64 {
    let next = parameter[(k + 1).min(parameter.len() - 1)];
    0.5 * (next - parameter[k.saturating_sub(1)])
}

/// Linear between ascending places; a place within rounding of an end is there. `None` outside.
pub(super) fn interpolate(places: &[f64], values: &[f64], place: f64) -> Option<f64> {
    let slack = 1e-9 * (places.last()? - places.first()?);
    if place < places.first()? - slack || place > places.last()? + slack {
        return None;
    }
    let next = places
        .partition_point(|&at| at < place)
        .clamp(1, places.len() - 1);
    let (left, right) = (places[next - 1], places[next]);
    let part = ((place - left) / (right - left)).clamp(0.0, 1.0);
    Some((1.0 - part) * values[next - 1] + part * values[next])
}

/// The load steps of a problem whose answers are known.
pub(super) fn expected(problem: Problem) -> Result<Vec<Expected>, LaboratoryError> {
    match problem {
        Problem::Persson => Ok(of_persson()),
        Problem::Hertz => Ok(vec![line(0, line_contact::PEAK, |_| 0.0)]),
        Problem::CattaneoMindlin => {
            let peak = 0.1 * line_contact::PEAK;
            Ok(vec![
                line(1, peak, line_contact::shear_loaded),
                line(2, peak, line_contact::shear_returned),
                line(3, peak, |x| -line_contact::shear_loaded(x)),
            ])
        }
        Problem::OrthotropicPin => of_rigid_pin(),
        Problem::AluminiumFrictionless => of_aluminium(aluminium::FRICTIONLESS),
        Problem::AluminiumFrictional => of_aluminium(aluminium::FRICTIONAL),
    }
}

fn of_persson() -> Vec<Expected> {
    let steps = persson::STEPS.into_iter().enumerate();
    steps
        .map(|(step, (half_angle, factor))| {
            let epsilon = half_angle.to_radians();
            let hoop = factor * persson::hoop_at_net_section(epsilon);
            Expected {
                step,
                peak_pressure: factor * persson::pressure(epsilon, 0.0),
                extent: epsilon,
                largest_shear: 1.0,
                profile: Box::new(move |phi| [factor * persson::pressure(epsilon, phi), 0.0]),
                points: None,
                even_shear: false,
                hoop: Some((std::f64::consts::FRAC_PI_2, hoop)),
            }
        })
        .collect()
}

/// `shear` over μp₀. On the upper body friction acts along −x when it is pushed along +x, and e_t is −x.
fn line(step: usize, peak: f64, shear: fn(f64) -> f64) -> Expected {
    let scale = line_contact::FRICTION * peak;
    Expected {
        step,
        peak_pressure: peak,
        extent: line_contact::HALF_WIDTH,
        // Of all states: the largest is at the end of the stick zone at Q = 0.5 μP.
        largest_shear: scale * line_contact::shear_loaded(line_contact::STICK),
        profile: Box::new(move |x| [peak * line_contact::pressure(x), scale * shear(x)]),
        points: None,
        even_shear: true,
        hoop: None,
    }
}

fn of_rigid_pin() -> Result<Vec<Expected>, LaboratoryError> {
    let points = rigid_pin::points(rigid_pin::ORTHOTROPIC)?;
    let of = |value: fn(&rigid_pin::EdgePoint) -> f64| -> Vec<f64> {
        points.iter().map(value).collect()
    };
    let angle = of(|point| point.angle.to_radians());
    let pressure = of(|point| -rigid_pin::BEARING * point.stresses[0]);
    let shear = of(|point| -rigid_pin::BEARING * point.stresses[2]);
    let net = points.iter().find(|point| point.angle == 90.0);
    let places = points
        .iter()
        .filter(|point| point.angle < rigid_pin::ORTHOTROPIC_END - END)
        .map(|point| point.angle.to_radians())
        .collect();
    Ok(vec![Expected {
        step: 0,
        peak_pressure: rigid_pin::BEARING * rigid_pin::ORTHOTROPIC_PEAK,
        extent: rigid_pin::ORTHOTROPIC_END.to_radians(),
        largest_shear: shear
            .iter()
            .fold(0.0, |most, value| f64::max(most, value.abs())),
        hoop: net.map(|point| {
            let stress = rigid_pin::BEARING * point.stresses[1];
            (point.angle.to_radians(), stress)
        }),
        profile: tabulated(angle, pressure, shear),
        points: Some(places),
        even_shear: false,
    }])
}

fn of_aluminium(text: &str) -> Result<Vec<Expected>, LaboratoryError> {
    let steps = aluminium::STEPS.into_iter();
    steps
        .map(|step| {
            let profile = aluminium::profile(text, step)?;
            let sizes = profile.shear.iter().map(|value| value.abs());
            Ok(Expected {
                step,
                peak_pressure: profile.peak_pressure,
                extent: profile.extent,
                largest_shear: sizes.fold(f64::MIN_POSITIVE, f64::max),
                hoop: Some((std::f64::consts::FRAC_PI_2, profile.hoop)),
                profile: tabulated(profile.angle, profile.pressure, profile.shear),
                points: None,
                even_shear: false,
            })
        })
        .collect()
}

fn tabulated(place: Vec<f64>, pressure: Vec<f64>, shear: Vec<f64>) -> Profile {
    Box::new(move |at| {
        [&pressure, &shear].map(|values| interpolate(&place, values, at).unwrap_or(0.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_is_linear_and_ends() {
        let (places, values) = ([0.0, 1.0, 3.0], [1.0, 2.0, 6.0]);
        for (place, expected) in [
            (0.0, Some(1.0)),
            (0.5, Some(1.5)),
            (2.0, Some(4.0)),
            (3.0, Some(6.0)),
            (3.1, None),
        ] {
            assert_eq!(interpolate(&places, &values, place), expected);
        }
    }

    #[test]
    fn every_problem_has_its_answers() {
        for problem in Problem::ALL {
            let steps = expected(problem).unwrap();
            assert!(!steps.is_empty());
            for step in &steps {
                assert!(step.peak_pressure > 0.0 && step.extent > 0.0);
                let [pressure, shear] = (step.profile)(0.1 * step.extent);
                assert!(pressure > 0.5 * step.peak_pressure, "{}", problem.name());
                assert_eq!(problem.friction(), shear != 0.0, "{}", problem.name());
            }
        }
    }
}
