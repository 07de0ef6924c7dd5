//! Splines in outlines: beside arcs, holes and closed forms, in contact, in cut-outs, moved and turned, and what is refused.

mod others;

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip::results::{EdgeResults, Results};

use super::open::{close, nose_on_block};
use super::solved;

/// Young's modulus over 1 − ν² of the bodies in plane strain `[MPa]`.
const PLANE: f64 = 70_000.0 / (1.0 - 0.09);

fn edge(results: &Results) -> &EdgeResults {
    &results.steps[0].edges[0]
}

fn place([x, y]: [f64; 2]) -> String {
    format!(r#"["{x} mm", "{y} mm"]"#)
}

/// `count` points of a curve over [−1, 1].
fn points(count: usize, at: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    (0..count)
        .map(|k| at(2.0 * k as f64 / (count - 1) as f64 - 1.0))
        .collect()
}

/// The keys of a spline through points, its ends left out.
fn spline(points: &[[f64; 2]]) -> String {
    let inner: Vec<String> = points[1..points.len() - 1]
        .iter()
        .map(|&at| place(at))
        .collect();
    format!("spline = [{}]", inner.join(", "))
}

/// A block with its upper side along y = 0, 80 mm wide and `depth` deep, with small cells up to `fine`, and a body above it whose face `way` runs from the first to the second of `ends`.
fn pressed(way: &str, [from, to]: [[f64; 2]; 2], force: f64, (depth, fine): (f64, f64)) -> String {
    format!(
        r#"
version = 1
analysis.plane = "strain"
materials.metal.isotropic = {{ young = "70 GPa", poisson = 0.3 }}
[bodies.block]
material = "metal"
thickness = "1 mm"
shape.outline = {{ start = ["-40 mm", "-{depth} mm"], edges = [{{ name = "bottom", to = ["40 mm", "-{depth} mm"] }}, {{ name = "right", to = ["40 mm", "0 mm"] }}, {{ name = "top", to = ["{fine} mm", "0 mm"] }}, {{ name = "top", to = ["-{fine} mm", "0 mm"], refine = 80 }}, {{ name = "top", to = ["-40 mm", "0 mm"] }}, {{ name = "left" }}] }}
[bodies.roller]
material = "metal"
thickness = "1 mm"
shape.outline = {{ start = {start}, edges = [{{ name = "face", to = {end}, {way}, refine = 80 }}, {{ name = "side", to = ["{x} mm", "30 mm"] }}, {{ name = "top", to = ["-{x} mm", "30 mm"] }}, {{ name = "back" }}] }}
[mesh]
spacing = "4 mm"
[[contacts]]
first = "roller.face"
second = "block.top"
friction.coulomb.mu = 0
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["y"]
[[loads]]
on = "roller.top"
force = {{ direction = [0, -1], steps = ["{force} N"] }}
[output]
fields = "none"
figures = false
"#,
        start = place(from),
        end = place(to),
        x = to[0],
    )
}

/// Radius of the roller `[mm]`.
const ROLLER: f64 = 20.0;
/// Force `[N]` under which its contact is of half-width 2 mm.
const FORCE: f64 = 0.025 * PI * PLANE;

/// Peak pressure and half-width under a roller whose face spans `angle` to either side, an arc or a spline through `count` points.
fn roller(angle: f64, count: Option<usize>) -> [f64; 2] {
    let at = |part: f64| {
        let (sin, cos) = (angle * part).sin_cos();
        [ROLLER * sin, ROLLER * (1.0 - cos)]
    };
    let way = count.map_or_else(
        || r#"through = ["0 mm", "0 mm"]"#.to_owned(),
        |count| spline(&points(count, at)),
    );
    let results = solved(&pressed(&way, [at(-1.0), at(1.0)], FORCE, (40.0, 3.0)), &[]);
    let edge = edge(&results);
    [
        edge.peak_pressure.unwrap().0,
        edge.contact_half_extent.unwrap(),
    ]
}

#[test]
fn a_roller_of_a_spline_is_one_of_an_arc() {
    let half = FRAC_PI_2 * 0.999;
    for (angle, count) in [(0.5 * FRAC_PI_2, 9), (half, 17)] {
        let [pressure, extent] = roller(angle, None);
        let [own, end] = roller(angle, Some(count));
        close(own, pressure, 1e-3);
        close(end, extent, 1e-3);
    }
}

/// A parabola y = x²/2R under the force of Hertz: p₀ = E* a/2R, 4 P R = π E* a².
#[test]
fn a_parabola_presses_as_hertz_says() {
    let parabola = |part: f64| [10.0 * part, 100.0 * part * part / (2.0 * ROLLER)];
    let way = spline(&points(9, parabola));
    let (modulus, half) = (PLANE / 2.0, 1.0);
    let force = PI * modulus * half * half / (4.0 * ROLLER);
    let ends = [parabola(-1.0), parabola(1.0)];
    let results = solved(&pressed(&way, ends, force, (40.0, 2.0)), &[]);
    let edge = edge(&results);
    close(
        edge.peak_pressure.unwrap().0,
        modulus * half / (2.0 * ROLLER),
        5e-3,
    );
    close(edge.contact_half_extent.unwrap(), half, 5e-3);
    close(edge.resultant[1], force, 1e-9);
}

/// A rigid punch y = A x⁴ on a half-plane: p(x) = 2 A E* (x² + a²/2) √(a² − x²), P = ¾ π A E* a⁴ (Steuermann 1939).
#[test]
fn a_punch_of_fourth_order_presses_as_steuermann_says() {
    const A: f64 = 1.25e-3;
    let quartic = |part: f64| [6.0 * part, A * (6.0 * part).powi(4)];
    let way = spline(&points(25, quartic));
    let half = 2.0_f64;
    let force = 0.75 * PI * A * PLANE * half.powi(4);
    let text = pressed(&way, [quartic(-1.0), quartic(1.0)], force, (60.0, 2.5));
    let text = text
        .replace(
            "[bodies.roller]\nmaterial = \"metal\"\nthickness = \"1 mm\"",
            "[bodies.roller]\nrigid = true",
        )
        .replace(
            "first = \"roller.face\"\nsecond = \"block.top\"",
            "first = \"block.top\"\nsecond = \"roller.face\"",
        )
        .replace(
            "[[platens]]\non = \"roller.top\"\nfree = [\"y\"]",
            "[[supports]]\non = \"roller.top\"\nfix = [\"x\"]",
        );
    // Between its points the spline dips below y = 0 by 3·10⁻⁶ mm, so it begins apart.
    let results = solved(&text, &[r#"bodies.roller.position=["0 mm", "0.01 mm"]"#]);
    let edge = edge(&results);
    let pressure = |x: f64| {
        let inside = (half * half - x * x).max(0.0);
        2.0 * A * PLANE * (x * x + half * half / 2.0) * inside.sqrt()
    };
    let peak = pressure(half / 2.0_f64.sqrt());
    close(edge.peak_pressure.unwrap().0, peak, 0.01);
    close(edge.contact_half_extent.unwrap(), half, 0.01);
    let mut apart = 0.0_f64;
    for (row, x) in edge.rows.iter().zip(&results.edges[0].parameter) {
        if x.abs() < 0.97 * half {
            apart = apart.max((row.pressure - pressure(*x)).abs());
        }
    }
    assert!(apart < 0.01 * peak, "{}", apart / peak);
}

/// The shape with these edges, each with its end and its way there; points go through `put`, the edges turned round where `is_mirrored`.
fn outline(
    start: [f64; 2],
    edges: &[(&str, [f64; 2], String)],
    put: impl Fn([f64; 2]) -> [f64; 2],
    is_mirrored: bool,
) -> String {
    let mut names: Vec<(&str, &String)> = Vec::new();
    let mut ends: Vec<[f64; 2]> = vec![start];
    for (name, to, way) in edges {
        names.push((name, way));
        ends.push(*to);
    }
    if is_mirrored {
        names.reverse();
        ends.reverse();
    }
    let list = names.iter().zip(&ends[1..]).map(|((name, way), to)| {
        format!(r#"{{ name = "{name}", to = {}{way} }}"#, place(put(*to)))
    });
    let list: Vec<String> = list.collect();
    format!(
        "shape.outline = {{ start = {}, edges = [{}] }}",
        place(put(ends[0])),
        list.join(", ")
    )
}

/// A nose between a spline and a line, pressed on a block by a spline, with friction; points go through `put`, turned round where `is_mirrored`.
fn nose(
    way: [&str; 2],
    put: impl Fn([f64; 2]) -> [f64; 2],
    is_mirrored: bool,
    place: &str,
) -> String {
    let at = |x: f64, y: f64| self::place(put([x, y]));
    let curve = |kind: &str, from: f64, to: f64, height: fn(f64) -> f64| {
        let middle = f64::midpoint(from, to);
        if kind == "arc" {
            return format!("through = {}", at(middle, height(middle)));
        }
        let list = (1..8).map(|k| {
            let x = from + (to - from) * f64::from(k) / 8.0;
            put([x, height(x)])
        });
        let mut list: Vec<[f64; 2]> = std::iter::once([0.0; 2])
            .chain(list)
            .chain([[0.0; 2]])
            .collect();
        if is_mirrored {
            list.reverse();
        }
        spline(&list)
    };
    let bulge = |x: f64| 30.0 - (900.0 - x * x).sqrt();
    let hollow = |x: f64| 90.0 - (8100.0 - x * x).sqrt();
    let [nose, bed] = [
        curve(way[0], -4.0, 4.0, bulge),
        curve(way[1], 10.0, -10.0, hollow),
    ];
    let outline = |start: [f64; 2], edges: &[(&str, [f64; 2], String)]| {
        outline(start, edges, &put, is_mirrored)
    };
    let fine = |way: &str| format!(", {way}, refine = 6");
    let block = outline(
        [-10.0, -8.0],
        &[
            ("bottom", [10.0, -8.0], String::new()),
            ("right", [10.0, hollow(10.0)], String::new()),
            ("face", [-10.0, hollow(10.0)], fine(&bed)),
            ("left", [-10.0, -8.0], String::new()),
        ],
    );
    let nose = outline(
        [-4.0, 6.0],
        &[
            ("left", [-4.0, bulge(4.0)], String::new()),
            ("face", [4.0, bulge(4.0)], fine(&nose)),
            ("right", [4.0, 6.0], String::new()),
            ("top", [-4.0, 6.0], String::new()),
        ],
    );
    let force = r#"{ direction = [0.1, -1], steps = ["1 kN"] }"#;
    nose_on_block(place, [&block, &nose], force) + "[output]\nfields = \"none\"\nfigures = false\n"
}

#[test]
fn moved_turned_and_mirrored_splines_press_as_arcs_do() {
    let numbers = |text: &str, changes: &[&str]| {
        let results = solved(text, changes);
        let edge = edge(&results);
        [
            edge.peak_pressure.unwrap().0,
            edge.contact_half_extent.unwrap(),
            edge.stick_half_extent.unwrap(),
        ]
    };
    let near = |name: &str, found: [f64; 3], expected: [f64; 3], part: f64| {
        for (own, other) in found.into_iter().zip(expected) {
            let apart = (own / other - 1.0).abs();
            assert!(apart < part, "{name}: {own} {other}: {apart:.2e}");
        }
    };
    let [smooth, round] = [["spline"; 2], ["arc"; 2]];
    let whole = |at: [f64; 2]| at;
    let still = numbers(&nose(smooth, whole, false, ""), &[]);
    let far = r#"position = ["64 mm", "-32 mm"]"#;
    near(
        "moved",
        numbers(&nose(smooth, whole, false, far), &[]),
        still,
        1e-9,
    );
    let mirrored = nose(smooth, |[x, y]| [-x, y], true, "");
    let pushed = "loads.0.force.direction=[-0.1, -1]";
    near("mirrored", numbers(&mirrored, &[pushed]), still, 1e-9);
    for ways in [round, ["arc", "spline"], ["spline", "arc"]] {
        near(
            ways[0],
            numbers(&nose(ways, whole, false, ""), &[]),
            still,
            5e-4,
        );
    }
    let (sin, cos) = (PI / 6.0).sin_cos();
    let [x, y] = [0.1 * cos + sin, 0.1 * sin - cos];
    let pushed = format!("loads.0.force.direction=[{x}, {y}]");
    let turned = numbers(
        &nose(smooth, whole, false, r#"angle = "30 deg""#),
        &[&pushed],
    );
    near("turned", turned, still, 1e-9);
    let drawn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
    near(
        "drawn turned",
        numbers(&nose(smooth, drawn, false, ""), &[&pushed]),
        turned,
        1e-9,
    );
}
