//! The scene as it is modelled: outlines of bodies, edges in contact, what is held and what is loaded.

use std::sync::Arc;

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_report::FigureError;
use stickslip_report::color::Color;
use stickslip_report::plane::{Marks, PlanePlot};
use stickslip_report::svg::Svg;
use toml::Value;

use super::{Group, Plan};
use stickslip_engine::results::Results;
use stickslip_scene::schema::DisplayUnits;

/// Margin around the bodies, and length of an arrow, as parts of the larger size of all.
const MARGIN: f64 = 0.13;
const ARROW: f64 = 0.1;
/// Marks along an edge that is held.
const HELD_MARKS: usize = 12;
/// Colours of bodies, edges in contact, supports, loads, springs and platens.
const COLORS: [Color; 6] = [
    Color::rgb(0x6b, 0x73, 0x7c),
    Color::rgb(0xd5, 0x5e, 0x00),
    Color::rgb(0x00, 0x9e, 0x73),
    Color::rgb(0x00, 0x72, 0xb2),
    Color::rgb(0xcc, 0x79, 0xa7),
    Color::rgb(0xb8, 0x86, 0x0b),
];

/// A body of a sketch: its name and its mesh; `None` for a rigid one.
pub type SketchBody = (String, Option<Arc<Mesh>>);

/// The picture of a run's scene.
pub(super) fn all(results: &Results) -> Vec<Plan<'_>> {
    if results.scene.is_empty() {
        return Vec::new();
    }
    let bodies = results.bodies.iter();
    let bodies: Vec<SketchBody> = bodies
        .map(|body| (body.name.clone(), body.mesh.clone()))
        .collect();
    let draw = move || {
        let picture = sketch(&bodies, &results.scene, results.units)?;
        let half = results.edges.iter().any(|edge| edge.half);
        let part = if half {
            " Half of the scene is modelled, and its mirror image is left out."
        } else {
            ""
        };
        let text = format!(
            "Bodies as they are modelled, edges in contact, supports (crosses) and loads (arrows).{part}"
        );
        Ok(picture.map(|picture| (picture, text)))
    };
    vec![Plan::new(Group::Problem, "sketch".into(), draw)]
}

/// Draws `bodies` with the contacts, supports and loads of the resolved scene `scene`; `None` where no body has a mesh.
///
/// # Errors
/// [`FigureError`] for a picture that cannot be drawn.
pub fn sketch(
    bodies: &[SketchBody],
    scene: &str,
    units: DisplayUnits,
) -> Result<Option<Svg>, FigureError> {
    let scene: toml::Table = toml::from_str(scene).unwrap_or_default();
    let own = Sketch {
        bodies,
        scene: &scene,
        units,
    };
    let Some(window) = own.window() else {
        return Ok(None);
    };
    let size = (window[1] - window[0]).max(window[3] - window[2]);
    let title = scene
        .get("title")
        .and_then(Value::as_str)
        .unwrap_or("Scene");
    let mut plot = PlanePlot::new(title, units.length.name, window);
    plot.width = 720.0;
    let mut kinds = [
        marks("bodies", COLORS[0]),
        marks("edges in contact", COLORS[1]),
        marks("held", COLORS[2]),
        marks("loads", COLORS[3]),
        marks("on springs", COLORS[4]),
        marks("platens", COLORS[5]),
    ];
    let [bodies_drawn, contacts, held, loads, springs, platens] = &mut kinds;
    bodies_drawn.paths = own.outlines();
    contacts.paths = own.contacts();
    let gives = |support: &Value| {
        ["stiffness", "bed"]
            .iter()
            .any(|key| support.get(key).is_some())
    };
    held.points = own.held("supports", |support| !gives(support));
    springs.points = own.held("supports", gives);
    platens.points = own.held("platens", |_| true);
    loads.paths = own.loads(ARROW * size);
    let kinds = kinds.into_iter();
    plot.marks = kinds
        .filter(|own| !own.paths.is_empty() || !own.points.is_empty())
        .collect();
    plot.render().map(Some)
}

struct Sketch<'a> {
    bodies: &'a [SketchBody],
    scene: &'a toml::Table,
    units: DisplayUnits,
}

impl Sketch<'_> {
    fn meshes(&self) -> impl Iterator<Item = (&str, &Mesh)> {
        let bodies = self.bodies.iter();
        bodies.filter_map(|(name, mesh)| Some((name.as_str(), mesh.as_deref()?)))
    }

    fn shown(&self, at: Point) -> Point {
        at.map(|x| self.units.length.from_base(x))
    }

    /// The part of the plane that holds all bodies, with a margin.
    fn window(&self) -> Option<[f64; 4]> {
        let boxes = self.meshes().map(|(_, mesh)| mesh.bounding_box());
        let [low, high] = boxes.reduce(|[low, high], [less, more]| {
            let least = [0, 1].map(|axis| f64::min(low[axis], less[axis]));
            [least, [0, 1].map(|axis| f64::max(high[axis], more[axis]))]
        })?;
        let ([x_low, y_low], [x_high, y_high]) = (self.shown(low), self.shown(high));
        let margin = MARGIN * (x_high - x_low).max(y_high - y_low);
        Some([
            x_low - margin,
            x_high + margin,
            y_low - margin,
            y_high + margin,
        ])
    }

    /// The nodes of an edge in walk order, the body on the left; of a point or another set its nodes.
    fn places(&self, on: &str) -> Option<(Vec<Point>, bool)> {
        let (name, set) = on.split_once('.')?;
        let (_, mesh) = self.meshes().find(|(own, _)| *own == name)?;
        let at = |&node: &usize| self.shown(mesh.nodes()[node]);
        match mesh.edge_path(set) {
            Ok(path) => {
                let mut places: Vec<Point> = path.nodes.iter().map(at).collect();
                if let (true, Some(&first)) = (path.closed, places.first()) {
                    places.push(first);
                }
                Some((places, true))
            }
            Err(_) => Some((mesh.node_set(set).ok()?.iter().map(at).collect(), false)),
        }
    }

    fn outlines(&self) -> Vec<Vec<Point>> {
        let of_body = |(name, mesh): (&str, &Mesh)| {
            let sets = mesh.edge_set_names();
            let paths = sets.filter_map(|set| Some(self.places(&format!("{name}.{set}"))?.0));
            paths.collect::<Vec<_>>()
        };
        self.meshes().flat_map(of_body).collect()
    }

    fn list(&self, key: &str) -> impl Iterator<Item = &Value> {
        let list = self.scene.get(key).and_then(Value::as_array);
        list.into_iter().flatten()
    }

    fn contacts(&self) -> Vec<Vec<Point>> {
        let first = |contact: &Value| Some(self.places(contact.get("first")?.as_str()?)?.0);
        self.list("contacts").filter_map(first).collect()
    }

    /// Places along edges and points that the entries `chosen` of a list hold; an area is marked at its middle.
    fn held(&self, list: &str, chosen: impl Fn(&Value) -> bool) -> Vec<Point> {
        let of_support = |support: &Value| {
            let on = support.get("on")?.as_str()?;
            Some(match self.places(on) {
                Some((places, true)) => along(&places, HELD_MARKS),
                Some((places, false)) => places,
                None => vec![self.middle(on)?],
            })
        };
        let all = self.list(list).filter(|own| chosen(own));
        all.filter_map(of_support).flatten().collect()
    }

    /// Middle of the body whose area `on` names.
    fn middle(&self, on: &str) -> Option<Point> {
        let (name, _) = on.split_once('.')?;
        let (_, mesh) = self.meshes().find(|(own, _)| *own == name)?;
        let [low, high] = mesh.bounding_box();
        Some(self.shown([0, 1].map(|axis| 0.5 * (low[axis] + high[axis]))))
    }

    /// An arrow for each force and pressure.
    fn loads(&self, length: f64) -> Vec<Vec<Point>> {
        let of_load = |load: &Value| {
            let on = load.get("on")?.as_str()?;
            let (places, is_edge) = self.places(on).unwrap_or_default();
            let at = if is_edge {
                along(&places, 3).get(1).copied()
            } else {
                places.first().copied()
            };
            let at = at.or_else(|| self.middle(on))?;
            let kinds = ["force", "bearing"];
            let given = kinds
                .iter()
                .find_map(|kind| load.get(kind)?.get("direction"));
            let direction = match given {
                Some(given) => vector(given)?,
                None if load.get("pressure").is_some() && is_edge => inwards(&places)?,
                None => return None,
            };
            // A pressure ends on its edge, a force begins there.
            let start = if given.is_some() {
                at
            } else {
                ahead(at, direction, -length)
            };
            Some(arrow(start, direction, length))
        };
        self.list("loads").filter_map(of_load).flatten().collect()
    }
}

fn marks(label: &str, color: Color) -> Marks {
    Marks {
        label: label.to_owned(),
        color,
        points: Vec::new(),
        paths: Vec::new(),
    }
}

/// `count` places at equal distances along a walk, its ends included.
fn along(walk: &[Point], count: usize) -> Vec<Point> {
    let mut lengths = vec![0.0];
    for pair in walk.windows(2) {
        let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        lengths.push(lengths[lengths.len() - 1] + step);
    }
    let total = lengths[lengths.len() - 1];
    let place = |k: usize| {
        let wanted = total * k as f64 / (count - 1) as f64;
        let to = lengths.partition_point(|length| *length < wanted).max(1);
        let (from, to) = (to - 1, to.min(walk.len() - 1));
        let width = lengths[to] - lengths[from];
        let part = if width > 0.0 {
            (wanted - lengths[from]) / width
        } else {
            0.0
        };
        [0, 1].map(|axis| (1.0 - part) * walk[from][axis] + part * walk[to][axis])
    };
    if walk.len() < 2 {
        return walk.to_vec();
    }
    (0..count).map(place).collect()
}

/// The unit vector of two numbers.
fn vector(given: &Value) -> Option<Point> {
    let number = |value: &Value| {
        value
            .as_float()
            .or(value.as_integer().map(|whole| whole as f64))
    };
    let [x, y] = given.as_array()?.as_slice() else {
        return None;
    };
    unit([number(x)?, number(y)?])
}

fn unit([x, y]: Point) -> Option<Point> {
    let size = x.hypot(y);
    (size > 0.0).then(|| [x / size, y / size])
}

/// The unit normal into the body in the middle of a walk with the body on the left.
fn inwards(places: &[Point]) -> Option<Point> {
    let middle = places.len() / 2;
    let (from, to) = (places.get(middle.checked_sub(1)?)?, places.get(middle)?);
    unit([from[1] - to[1], to[0] - from[0]])
}

fn ahead(at: Point, [x, y]: Point, by: f64) -> Point {
    [at[0] + by * x, at[1] + by * y]
}

/// A shaft of `length` from `start`, and two strokes of its head.
fn arrow(start: Point, direction: Point, length: f64) -> Vec<Vec<Point>> {
    let end = ahead(start, direction, length);
    let [x, y] = direction;
    let stroke = |side: f64| {
        let back = ahead(end, direction, -0.3 * length);
        vec![ahead(back, [-y * side, x * side], 0.15 * length), end]
    };
    vec![vec![start, end], stroke(1.0), stroke(-1.0)]
}
