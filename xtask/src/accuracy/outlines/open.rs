//! Random open edges: cylinders and punches with rounded corners on blocks, and dovetails.

use std::f64::consts::PI;

use rand::RngExt as _;
use rand::rngs::StdRng;

use super::shape::{Corner, mirrored, outline};
use super::{contact as touching, fixed, friction, head};
use crate::accuracy::draw::{Draw, load};

/// Thickness of the bodies, so that forces are those on 1 mm.
const THICKNESS: &str = "thickness = \"1 mm\"\n";
/// Refinement of an edge that is divided as its body is.
const PLAIN: f64 = 1.0;

pub(super) fn contact(rng: &mut StdRng) -> Draw {
    if rng.random_range(0..4) == 0 {
        dovetail(rng)
    } else {
        punch(rng)
    }
}

/// A flat with corners of a large radius, or a cylinder, pressed on a block to a half extent of contact near `a` and pushed.
fn punch(rng: &mut StdRng) -> Draw {
    let a: f64 = rng.random_range(0.4..3.0);
    let radius = a * rng.random_range(8.0..60.0);
    let flat = a * [0.0, rng.random_range(0.2..0.9)][rng.random_range(0..2)];
    let refine = 16.0 * rng.random_range(0.7..2.0);
    let moduli = [
        70.0,
        70.0 * [1.0, rng.random_range(0.5..5.0)][rng.random_range(0..2)],
    ];
    let poisson = rng.random_range(0.1..0.45);
    let compliance = moduli.map(|young| (1.0 - poisson * poisson) / (1e3 * young));
    let edge = (flat / a).asin();
    let shape = PI - 2.0 * edge - (2.0 * edge).sin();
    let press = a * a * shape / (4.0 * radius * (compliance[0] + compliance[1]));
    let mu = friction(rng);
    let (loads, free) = history(rng, press, mu);
    let text = [
        head("strain", rng.random_bool(0.3)),
        isotropic("block", moduli[0], poisson),
        isotropic("punch", moduli[1], poisson),
        body("block", &block(a, refine)),
        body("punch", &face([a, flat, radius], refine)),
        touching("punch.face", "block.top", mu),
        fixed("block.bottom"),
        format!("[[platens]]\non = \"punch.top\"\nfree = [{free}]\n"),
        loads,
    ];
    Draw {
        family: "punches and cylinders",
        chooses_kinematics: false,
        finest: vec![format!("mesh.spacing={} mm", a / 8.0)],
        is_balanced: true,
        text: text.concat(),
    }
}

/// Loads on the punch, and along which axes it is free.
fn history(rng: &mut StdRng, press: f64, mu: f64) -> (String, &'static str) {
    let push = mu * press * rng.random_range(0.1..0.9);
    let back = -push * rng.random_range(0.0..1.0);
    let kinds: [[&[f64]; 2]; 3] = [
        [&[0.5 * press, press, 0.5 * press], &[]],
        [&[press, press, press], &[0.0, push, back]],
        [&[0.5 * press, press], &[0.5 * push, push]],
    ];
    let kind = if mu == 0.0 { 0 } else { rng.random_range(0..3) };
    let [down, along] = kinds[kind];
    let mut loads = load("punch.top", "[0, -1]", down);
    if along.is_empty() {
        return (loads, "\"y\"");
    }
    loads += &load("punch.top", "[1, 0]", along);
    (loads, "\"x\", \"y\"")
}

fn block(a: f64, refine: f64) -> String {
    let (wide, reach) = (10.0 * a, 1.4 * a);
    outline(&[
        Corner::sharp([-wide, -8.0 * a], ("bottom", PLAIN)),
        Corner::sharp([wide, -8.0 * a], ("right", PLAIN)),
        Corner::sharp([wide, 0.0], ("top", PLAIN)),
        Corner::sharp([reach, 0.0], ("top", refine)),
        Corner::sharp([-reach, 0.0], ("top", PLAIN)),
        Corner::sharp([-wide, 0.0], ("left", PLAIN)),
    ])
}

/// A punch with a flat of half-width `flat` between arcs of `radius`, which flanks go on along their tangents.
fn face([a, flat, radius]: [f64; 3], refine: f64) -> String {
    let (reach, wide) = (1.4 * a, 8.0 * a);
    let rise = |x: f64| radius - (radius * radius - (x - flat).powi(2)).sqrt();
    let slope = (reach - flat) / (radius - rise(reach));
    let side = rise(reach) + slope * (wide - reach);
    let (middle, top) = (0.5 * (flat + reach), side + 8.0 * a);
    let edge = |to: [f64; 2], through: Option<[f64; 2]>| {
        let through = through.map_or(String::new(), |[x, y]| {
            format!(", through = [\"{x} mm\", \"{y} mm\"]")
        });
        let [x, y] = to;
        format!(
            "  {{ name = \"face\", to = [\"{x} mm\", \"{y} mm\"]{through}, refine = {refine} }},\n"
        )
    };
    let arcs = if flat == 0.0 {
        edge([reach, rise(reach)], Some([0.0, 0.0]))
    } else {
        edge([-flat, 0.0], Some([-middle, rise(middle)]))
            + &edge([flat, 0.0], None)
            + &edge([reach, rise(reach)], Some([middle, rise(middle)]))
    };
    let plain = |name: &str, [x, y]: [f64; 2]| {
        format!("  {{ name = \"{name}\", to = [\"{x} mm\", \"{y} mm\"] }},\n")
    };
    [
        format!("start = [\"{} mm\", \"{side} mm\"]\nedges = [\n", -wide),
        plain("face", [-reach, rise(reach)]),
        arcs,
        plain("face", [wide, side]),
        plain("right", [wide, top]),
        plain("top", [-wide, top]),
        "  { name = \"left\" },\n]\n".to_owned(),
    ]
    .concat()
}

/// The root of a blade that hangs in a slot by two flanks, pulled and released.
fn dovetail(rng: &mut StdRng) -> Draw {
    let slope = rng.random_range(35.0_f64..60.0).to_radians().tan();
    let refine = rng.random_range(25.0..45.0);
    let mu = friction(rng);
    let most = 10.0_f64.powf(rng.random_range(1.5..2.5));
    let steps = [0.5 * most, most, most * rng.random_range(0.3..0.9)];
    let poisson = rng.random_range(0.1..0.45);
    let text = [
        head("strain", rng.random_bool(0.3)),
        isotropic("blade", 115.0, poisson),
        isotropic("disc", 115.0 * rng.random_range(0.7..1.8), poisson),
        body("blade", &blade(slope, refine)),
        body("disc", &slot(slope, refine)),
        touching("blade.flank-right", "disc.flank-right", mu) + "name = \"right\"\n",
        touching("blade.flank-left", "disc.flank-left", mu) + "name = \"left\"\n",
        fixed("disc.bottom"),
        load("blade.top", "[0, 1]", &steps),
    ];
    Draw {
        family: "dovetails",
        chooses_kinematics: false,
        finest: vec!["mesh.spacing=0.7 mm".into()],
        is_balanced: false,
        text: text.concat(),
    }
}

/// Height of the right flank, whose middle is at (9, 3) mm.
fn flank(slope: f64, x: f64) -> [f64; 2] {
    [x, 3.0 + (9.0 - x) * slope]
}

fn blade(slope: f64, refine: f64) -> String {
    let on = ("flank-right", refine);
    let round = |at, edge, radius, arc| Corner {
        at,
        edge,
        radius,
        arc,
    };
    let right = [
        Corner::sharp([11.5, -4.0], ("side-right", PLAIN)),
        round(flank(slope, 11.5), on, 2.0, on),
        round(
            flank(slope, 6.0),
            ("neck-right", PLAIN),
            2.0,
            ("fillet-right", 0.3 * refine),
        ),
        Corner::sharp([6.0, 20.0], ("top", PLAIN)),
    ];
    outline(&both(&right, "bottom"))
}

fn slot(slope: f64, refine: f64) -> String {
    let on = ("flank-right", refine);
    let right = [
        Corner::sharp([25.0, 10.0], ("top-right", PLAIN)),
        Corner::sharp([7.0, 10.0], ("lip-right", PLAIN)),
        Corner {
            at: flank(slope, 7.0),
            edge: on,
            radius: 1.5,
            arc: on,
        },
        Corner::sharp(flank(slope, 12.5), ("slot-right", PLAIN)),
        Corner::sharp([12.5, -7.0], ("slot-bottom", PLAIN)),
    ];
    let bottom = [
        Corner::sharp([-25.0, -20.0], ("bottom", PLAIN)),
        Corner::sharp([25.0, -20.0], ("right", PLAIN)),
    ];
    outline(&[&bottom, &both(&right, "left")[..]].concat())
}

/// The corners `right` and their mirror images, of which the edge `last` leaves the last one.
fn both(right: &[Corner], last: &'static str) -> Vec<Corner> {
    let mut left = mirrored(right, left);
    if let Some(corner) = left.last_mut() {
        corner.edge = (last, PLAIN);
    }
    [right, &left].concat()
}

/// The name of an edge in the mirror.
fn left(name: &'static str) -> &'static str {
    match name {
        "flank-right" => "flank-left",
        "side-right" => "side-left",
        "fillet-right" => "fillet-left",
        "neck-right" => "neck-left",
        "top-right" => "top-left",
        "lip-right" => "lip-left",
        "slot-right" => "slot-left",
        "right" => "left",
        own => own,
    }
}

fn isotropic(name: &str, young: f64, poisson: f64) -> String {
    format!("[materials.{name}.isotropic]\nyoung = \"{young} GPa\"\npoisson = {poisson}\n")
}

fn body(name: &str, outline: &str) -> String {
    format!(
        "[bodies.{name}]\nmaterial = \"{name}\"\n{THICKNESS}[bodies.{name}.shape.outline]\n{outline}"
    )
}
