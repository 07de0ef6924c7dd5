//! Random rows of fasteners in one plate, and laps that fasteners join.

use std::fmt::Write as _;

use rand::RngExt as _;
use rand::rngs::StdRng;

use super::shape::{Corner, outline};
use super::{contact, fixed, friction, head, history, isotropic};
use crate::accuracy::draw::{Draw, ISOTROPIC, load};

/// Radius of the holes.
const RADIUS: f64 = 3.0;
/// Thickness of the plates.
const THICKNESS: f64 = 3.0;

pub(super) fn fasteners(rng: &mut StdRng) -> Draw {
    let text = if rng.random_range(0..3) == 0 {
        lap(rng)
    } else {
        plate(rng)
    };
    Draw {
        family: "several fasteners",
        chooses_kinematics: false,
        finest: vec!["mesh.spacing=0.75 deg".into()],
        is_balanced: false,
        text,
    }
}

/// Two to four pins in a plate, beside each other or behind each other, each held by its section; a part of the pull may pass by.
fn plate(rng: &mut StdRng) -> String {
    let count = [2, 2, 2, 2, 3, 4][rng.random_range(0..6)];
    let pitch = RADIUS * rng.random_range(3.2..6.0);
    let half = RADIUS * rng.random_range(2.0..5.0);
    let [before, behind] = [3.0..12.0, 2.0..6.0].map(|range| {
        let part: f64 = rng.random_range(range);
        RADIUS * part
    });
    let is_row = count != 4 && rng.random_bool(0.6);
    let places: Vec<[f64; 2]> = (0..count)
        .map(|k| match (count, is_row) {
            (4, _) => [pitch * f64::from(k / 2), pitch * (f64::from(k % 2) - 0.5)],
            (_, true) => [pitch * f64::from(k), 0.0],
            _ => [0.0, pitch * (f64::from(k) - 0.5 * f64::from(count - 1))],
        })
        .collect();
    let most = |axis: usize| places.iter().fold(0.0_f64, |most, at| most.max(at[axis]));
    let (end, wide) = (most(0) + behind, most(1) + half);
    let mu = friction(rng);
    let history = history(rng);
    let plates = format!("[materials.plate.{ISOTROPIC}\n");
    let mut text = head("stress", false) + &isotropic("pin", rng) + &plates;
    text += &body("plate", [-before, end, wide], &places);
    for k in 0..places.len() {
        let gap = RADIUS * 10.0_f64.powf(rng.random_range(-3.5..-2.0));
        text += &disk(&format!("pin-{k}"), RADIUS - gap);
        text += &contact(&format!("plate.hole-{k}"), &format!("pin-{k}.rim"), mu);
        text += &fixed(&format!("pin-{k}.section"));
    }
    text += &load("plate.left", "[-1, 0]", &history);
    if rng.random_bool(0.3) {
        let part = rng.random_range(0.1..0.6);
        let past: Vec<f64> = history.iter().map(|force| part * force).collect();
        text += &load("plate.right", "[1, 0]", &past);
    }
    text
}

/// Two plates that two bolts join.
fn lap(rng: &mut StdRng) -> String {
    let pitch = RADIUS * rng.random_range(4.0..8.0);
    let half = RADIUS * rng.random_range(2.5..5.0);
    let [free, end] = [3.0..5.0, 6.0..12.0].map(|range| {
        let part: f64 = rng.random_range(range);
        RADIUS * part
    });
    let mu = friction(rng);
    let springs = [
        "rigid = {}",
        "beam = { head = \"clamped\", nut = \"clamped\" }",
    ][rng.random_range(0..2)];
    let places = [[0.0, 0.0], [pitch, 0.0]];
    let history = history(rng);
    let plates = format!("[materials.plate.{ISOTROPIC}\n");
    let mut text = head("stress", false) + &isotropic("pin", rng) + &plates;
    text += &body("lower", [-end, pitch + free, half], &places);
    text += &body("upper", [-free, pitch + end, half], &places);
    for k in 0..places.len() {
        let radius = RADIUS * (1.0 - 10.0_f64.powf(rng.random_range(-3.5..-2.0)));
        for (slice, plate) in ["lower", "upper"].iter().enumerate() {
            let name = format!("bolt-{k}-{slice}");
            text += &disk(&name, radius);
            text += &contact(&format!("{plate}.hole-{k}"), &format!("{name}.rim"), mu);
        }
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "[fasteners.bolt-{k}]\nslices = [\"bolt-{k}-0\", \"bolt-{k}-1\"]\nsprings.{springs}"
        );
    }
    text += &fixed("upper.right");
    text += &load("lower.left", "[-1, 0]", &history);
    text
}

/// A strip from `left` to `right` of half width `half` with holes at `places`.
fn body(name: &str, [left, right, half]: [f64; 3], places: &[[f64; 2]]) -> String {
    let corner = |x, y, edge| Corner::sharp([x, y], (edge, 1.0));
    let corners = [
        corner(left, -half, "bottom"),
        corner(right, -half, "right"),
        corner(right, half, "top"),
        corner(left, half, "left"),
    ];
    let holes = places.iter().enumerate().map(|(k, [x, y])| {
        format!(
            "holes.hole-{k} = {{ centre = [\"{x} mm\", \"{y} mm\"], radius = \"{RADIUS} mm\" }}\n"
        )
    });
    format!(
        "[bodies.{name}]\nmaterial = \"plate\"\nthickness = \"{THICKNESS} mm\"\n[bodies.{name}.shape.outline]\n{}{}",
        outline(&corners),
        holes.collect::<String>()
    )
}

fn disk(name: &str, radius: f64) -> String {
    format!(
        "[bodies.{name}]\nmaterial = \"pin\"\nthickness = \"{THICKNESS} mm\"\nshape.disk.radius = \"{radius} mm\"\n"
    )
}
