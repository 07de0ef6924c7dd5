//! Tables that random scenes share.

use rand::RngExt as _;
use rand::rngs::StdRng;

use crate::accuracy::draw::load;

/// Processor time after which no finer model is tried `[s]`: the finest ones take minutes.
const BUDGET: f64 = 2.0;

/// The beginning of a scene, which may leave the geometry on which contact is found to the program.
pub(super) fn head(plane: &str, chooses_kinematics: bool) -> String {
    let kinematics = if chooses_kinematics { "auto" } else { "small" };
    format!(
        "version = 1\n[analysis]\nplane = \"{plane}\"\nkinematics = \"{kinematics}\"\nbudget = \"{BUDGET} s\"\n\
         [output]\nfields = \"none\"\nfigures = false\n"
    )
}

/// Young's modulus of another body than one of 70 GPa, and Poisson's ratio, as a material.
pub(super) fn isotropic(name: &str, rng: &mut StdRng) -> String {
    let young = 70.0 * 10.0_f64.powf(rng.random_range(-0.3..0.7));
    let poisson = rng.random_range(0.1..0.45);
    format!("[materials.{name}.isotropic]\nyoung = \"{young} GPa\"\npoisson = {poisson}\n")
}

/// Coulomb friction up to 0.6, in one of six cases none.
pub(super) fn friction(rng: &mut StdRng) -> f64 {
    if rng.random_range(0..6) == 0 {
        0.0
    } else {
        rng.random_range(0.05..0.6)
    }
}

/// One or two steps `[N]`, the last of which may unload.
pub(super) fn history(rng: &mut StdRng) -> Vec<f64> {
    let most: f64 = 10.0_f64.powf(rng.random_range(2.5..4.0));
    let kinds: [&[f64]; 3] = [&[1.0], &[0.5, 1.0], &[1.0, rng.random_range(0.2..0.8)]];
    let steps = kinds[rng.random_range(0..3)].iter();
    steps.map(|part| part * most).collect()
}

pub(super) fn contact(first: &str, second: &str, mu: f64) -> String {
    format!(
        "[[contacts]]\nfirst = \"{first}\"\nsecond = \"{second}\"\nfriction.coulomb = {{ mu = {mu} }}\n"
    )
}

pub(super) fn fixed(on: &str) -> String {
    format!("[[supports]]\non = \"{on}\"\nfix = [\"x\", \"y\"]\n")
}

/// A force along the angle `towards` `[rad]`.
pub(super) fn along(on: &str, towards: f64, steps: &[f64]) -> String {
    let (sin, cos) = towards.sin_cos();
    load(on, &format!("[{cos}, {sin}]"), steps)
}
