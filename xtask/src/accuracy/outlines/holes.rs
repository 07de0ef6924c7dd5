//! Random pins in plates with holes anywhere, and in lugs.

use std::f64::consts::PI;

use rand::RngExt as _;
use rand::rngs::StdRng;

use super::shape::{Corner, outline};
use super::{along, contact, fixed, friction, head, history, isotropic};
use crate::accuracy::draw::{Draw, ISOTROPIC, PLY, load, plate as material};

/// Radius of the hole with the pin.
const RADIUS: f64 = 5.0;
const THICKNESS: &str = "thickness = \"2 mm\"\n";

/// A pin in a hole that is nearer to some edges, alone or beside empty holes.
pub(super) fn plate(rng: &mut StdRng) -> Draw {
    let centre = [rng.random_range(-30.0..30.0), rng.random_range(-30.0..30.0)];
    let [right, bottom, top, half, left] =
        [1.8..5.0, 1.7..5.0, 1.7..5.0, 1.8..6.0, 5.0..14.0].map(|range| {
            let part: f64 = rng.random_range(range);
            RADIUS * part
        });
    let corner = |x: f64, y: f64, name| Corner::sharp([centre[0] + x, centre[1] + y], (name, 1.0));
    let corners = [
        corner(-left, -half, "bottom"),
        corner(right, -bottom, "right"),
        corner(right, top, "top"),
        corner(-left, half, "left"),
    ];
    let mut empty = Vec::new();
    let mut from = centre[0];
    for k in 0..[0, 0, 1, 2][rng.random_range(0..4)] {
        from -= RADIUS * rng.random_range(2.0..2.4);
        let aside = RADIUS * rng.random_range(-0.3..0.3);
        let radius = RADIUS * rng.random_range(0.25..0.6);
        if from > centre[0] - left + 1.5 * radius {
            empty.push((format!("open-{k}"), [from, centre[1] + aside], radius));
        }
    }
    let history = history(rng);
    let is_pulled = rng.random_bool(0.5);
    let held_and_loaded = if is_pulled {
        fixed("pin.section") + &load("body.left", "[-1, 0]", &history)
    } else {
        let towards = rng.random_range(-100.0_f64..100.0).to_radians();
        fixed("body.left") + &along("pin.section", towards, &history)
    };
    let holes: Vec<String> = (empty.iter())
        .map(|(name, at, radius)| hole(name, *at, *radius))
        .collect();
    let edges: Vec<String> = (empty.iter())
        .map(|(name, ..)| format!("[[edges]]\non = \"body.{name}\"\n"))
        .collect();
    let body = outline(&corners) + &hole("bolt", centre, RADIUS) + &holes.concat();
    pin(rng, "holes", &body, &(held_and_loaded + &edges.concat()))
}

/// A pin in a round-ended lug, pulled obliquely.
pub(super) fn lug(rng: &mut StdRng) -> Draw {
    let outer = RADIUS * rng.random_range(1.6..3.5);
    let margin = outer - RADIUS;
    let centre = [
        margin * rng.random_range(-0.2..0.3),
        margin * rng.random_range(-0.2..0.2),
    ];
    let length = outer + RADIUS * rng.random_range(2.0..8.0);
    let root = outer * rng.random_range(1.0..1.6);
    let body = format!(
        "start = [\"{} mm\", \"{} mm\"]\nedges = [\n  \
         {{ name = \"bottom\", to = [\"0 mm\", \"{} mm\"] }},\n  \
         {{ name = \"end\", to = [\"0 mm\", \"{outer} mm\"], through = [\"{outer} mm\", \"0 mm\"] }},\n  \
         {{ name = \"top\", to = [\"{} mm\", \"{root} mm\"] }},\n  {{ name = \"root\" }},\n]\n{}",
        -length,
        -root,
        -outer,
        -length,
        hole("bolt", centre, RADIUS)
    );
    let history = history(rng);
    let towards = PI * rng.random_range(-0.85..0.85);
    let mut loads = along("pin.section", towards, &history);
    if rng.random_bool(0.2) {
        let across: Vec<f64> = (1..=history.len())
            .map(|k| history[0] * 0.3 * k as f64)
            .collect();
        loads += &along("pin.section", towards + 0.5 * PI, &across);
    }
    pin(rng, "lugs", &body, &(fixed("body.root") + &loads))
}

fn hole(name: &str, [x, y]: [f64; 2], radius: f64) -> String {
    format!("holes.{name} = {{ centre = [\"{x} mm\", \"{y} mm\"], radius = \"{radius} mm\" }}\n")
}

/// A pin in the hole `bolt` of a body of an outline, which is held and loaded.
fn pin(rng: &mut StdRng, family: &'static str, outline: &str, held_and_loaded: &str) -> Draw {
    let is_strain = rng.random_bool(0.2);
    let plane = if is_strain { "strain" } else { "stress" };
    let made = if is_strain {
        ISOTROPIC.to_owned()
    } else {
        material(rng)
    };
    let is_laminate = made.starts_with("laminate");
    let (thickness, ply) = if is_laminate {
        ("", PLY)
    } else {
        (THICKNESS, "")
    };
    let gap = RADIUS * 10.0_f64.powf(rng.random_range(-4.0..-1.5));
    let overlap = rng.random_bool(0.05);
    let gap = if overlap { -0.1 * gap } else { gap };
    let chooses_kinematics = rng.random_bool(0.3);
    let text = [
        head(plane, chooses_kinematics),
        isotropic("pin", rng),
        format!("[materials.body.{made}\n"),
        format!(
            "[bodies.body]\nmaterial = \"body\"\n{thickness}[bodies.body.shape.outline]\n{outline}"
        ),
        format!(
            "[bodies.pin]\nmaterial = \"pin\"\n{THICKNESS}shape.disk.radius = \"{} mm\"\n",
            RADIUS - gap
        ),
        contact("body.bolt", "pin.rim", friction(rng)),
        format!("interference = {overlap}\n"),
        held_and_loaded.to_owned(),
        ply.to_owned(),
    ];
    Draw {
        family,
        chooses_kinematics,
        finest: vec!["mesh.spacing=0.75 deg".into()],
        is_balanced: true,
        text: text.concat(),
    }
}
