//! Outlines with rounded corners.

use std::fmt::Write as _;

/// A corner of an outline, and the edge from it to the next one.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: [f64; 2],
    /// Name of the edge, and by how much its cells are refined.
    pub(super) edge: (&'static str, f64),
    /// Radius of the corner; 0 of a sharp one. Its arc belongs to the edge before or to that after it.
    pub(super) radius: f64,
    pub(super) arc: (&'static str, f64),
}

impl Corner {
    /// A sharp corner.
    pub(super) fn sharp(at: [f64; 2], edge: (&'static str, f64)) -> Self {
        let (radius, arc) = (0.0, edge);
        Self {
            at,
            edge,
            radius,
            arc,
        }
    }
}

/// The corners in the mirror x = 0, counter-clockwise again, with the names that `name` gives to their edges; the edge of the last one is that of the last of `corners`.
pub(super) fn mirrored(
    corners: &[Corner],
    name: impl Fn(&'static str) -> &'static str,
) -> Vec<Corner> {
    let count = corners.len();
    let renamed = |(edge, refine): (&'static str, f64)| (name(edge), refine);
    let own = (0..count).rev().map(|k| Corner {
        at: [-corners[k].at[0], corners[k].at[1]],
        // The edge that led to the corner leaves it.
        edge: renamed(corners[(k + count - 1) % count].edge),
        radius: corners[k].radius,
        arc: renamed(corners[k].arc),
    });
    own.collect()
}

/// The table of an outline through `corners`, counter-clockwise `[mm]`; the first one is sharp.
pub(super) fn outline(corners: &[Corner]) -> String {
    let place = |[x, y]: [f64; 2]| format!("[\"{x} mm\", \"{y} mm\"]");
    let mut text = format!("start = {}\nedges = [\n", place(corners[0].at));
    let count = corners.len();
    let mut edge = |(name, refine): (&str, f64), to, through: Option<[f64; 2]>| {
        let through = through.map_or(String::new(), |at| format!(", through = {}", place(at)));
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "  {{ name = \"{name}\", to = {}{through}, refine = {refine} }},",
            place(to)
        );
    };
    for k in 1..=count {
        let corner = corners[k % count];
        let before = corners[k - 1];
        let after = corners[(k + 1) % count];
        if corner.radius == 0.0 {
            edge(before.edge, corner.at, None);
        } else {
            let [from, through, to] = rounded(corner, before.at, after.at);
            edge(before.edge, from, None);
            edge(corner.arc, to, Some(through));
        }
    }
    text + "]\n"
}

/// Where the arc of a corner begins, a point of it, and where it ends.
fn rounded(corner: Corner, before: [f64; 2], after: [f64; 2]) -> [[f64; 2]; 3] {
    let towards = |to: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| to[axis] - corner.at[axis]);
        let length = x.hypot(y);
        [x / length, y / length]
    };
    let (one, other) = (towards(before), towards(after));
    let half = 0.5 * (one[0] * other[0] + one[1] * other[1]).acos();
    let (tangent, apart) = (corner.radius / half.tan(), corner.radius / half.sin());
    let middle = [0, 1].map(|axis| one[axis] + other[axis]);
    let length = middle[0].hypot(middle[1]);
    let inwards = [middle[0] / length, middle[1] / length];
    let at =
        |direction: [f64; 2], far: f64| [0, 1].map(|axis| corner.at[axis] + far * direction[axis]);
    [
        at(one, tangent),
        at(inwards, apart - corner.radius),
        at(other, tangent),
    ]
}
