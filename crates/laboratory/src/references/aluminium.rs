//! The pin benchmark (`scenes/pin-benchmark.toml`) on a mesh much finer than those that are compared.
//!
//! There is no closed form, so the same equations solved at a node spacing of a fraction of a degree stand for the answer: the
//! profiles of pressure and shear at 1240 lb while loading and at 1210 lb while unloading. Each file names the command that
//! made it. An independent condensed node-to-node code gives peak pressures of 31501 and 25229 psi at 1240 lb (without and
//! with friction 0.25), and 39590 and 42255 psi for σ_θ at 90°.

use crate::error::LaboratoryError;

/// Load steps that are compared: 1240 lb while loading, 1210 lb while unloading.
pub const STEPS: [usize; 2] = [3, 9];

/// The frictionless case.
pub const FRICTIONLESS: &str = include_str!("../../data/aluminium-frictionless.csv");
/// Friction 0.25.
pub const FRICTIONAL: &str = include_str!("../../data/aluminium-frictional.csv");

/// The answer at the end of one load step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    /// Largest pressure `[MPa]`.
    pub peak_pressure: f64,
    /// Half of the contact's extent `[rad]`.
    pub extent: f64,
    /// σ_θ at 90° `[MPa]`.
    pub hoop: f64,
    /// Angles from the bearing point `[rad]`, ascending.
    pub angle: Vec<f64>,
    /// Pressure at each `[MPa]`.
    pub pressure: Vec<f64>,
    /// λ_t on the plate at each `[MPa]`.
    pub shear: Vec<f64>,
}

/// The profile of load step `step` (from 0) in a file of this kind.
///
/// # Errors
/// [`LaboratoryError::Missing`] for a step that is not there or a line that does not read.
pub fn profile(text: &str, step: usize) -> Result<Profile, LaboratoryError> {
    let broken = |line: &str| LaboratoryError::Missing(format!("a line is broken: {line}"));
    let mut profile = Profile::default();
    for line in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let mut fields = line.split(',');
        let (Some(kind), Some(own)) = (fields.next(), fields.next()) else {
            return Err(broken(line));
        };
        if own.parse::<usize>().map_err(|_| broken(line))? != step + 1 {
            continue;
        }
        let numbers: Vec<f64> = fields
            .map(|field| field.parse().map_err(|_| broken(line)))
            .collect::<Result<_, _>>()?;
        match (kind, &numbers[..]) {
            ("step", &[peak, extent, hoop]) => {
                profile.peak_pressure = peak;
                profile.extent = extent.to_radians();
                profile.hoop = hoop;
            }
            ("node", &[angle, pressure, shear]) => {
                profile.angle.push(angle.to_radians());
                profile.pressure.push(pressure);
                profile.shear.push(shear);
            }
            _ => return Err(broken(line)),
        }
    }
    if profile.angle.is_empty() || profile.extent == 0.0 {
        let what = format!("no profile of load step {}", step + 1);
        return Err(LaboratoryError::Missing(what));
    }
    Ok(profile)
}
