//! The scene as it is modelled: outlines of bodies, edges in contact, what is held and what is loaded.

mod walk;

use std::sync::Arc;

use stickslip_fem_core::mesh::{ElementBlock, Mesh, Point};
use stickslip_report::FigureError;
use stickslip_report::color::Color;
use stickslip_report::plane::{Marks, PlanePlot};
use stickslip_report::svg::Svg;
use toml::Value;

use self::walk::{ahead, along, arrow, beside, inwards, keep_apart, vector};
use super::{Group, Plan};
use stickslip_engine::results::Results;
use stickslip_scene::schema::DisplayUnits;

/// Margin around the bodies, and length of an arrow, as parts of the larger size of all.
const MARGIN: f64 = 0.13;
const ARROW: f64 = 0.1;
/// Marks along an edge that is held.
const HELD_MARKS: usize = 12;
/// Most cells that are drawn, and most names of sets.
const MOST_CELLS: usize = 6000;
const MOST_NAMES: usize = 40;
/// Width of the picture `[px]`.
const WIDTH: f64 = 720.0;
const CELLS: Color = Color::rgb(0xd4, 0xd8, 0xdd);
/// Colours of bodies; of more of them all have the first.
const BODIES: [Color; 6] = [
    Color::rgb(0x50, 0x58, 0x62),
    Color::rgb(0x8c, 0x56, 0x4b),
    Color::rgb(0x75, 0x5f, 0xb0),
    Color::rgb(0x4d, 0x7c, 0x3a),
    Color::rgb(0x1f, 0x6f, 0x78),
    Color::rgb(0x9a, 0x6b, 0x1f),
];
/// What else is drawn.
const KINDS: [(&str, Color); 5] = [
    ("edges in contact", Color::rgb(0xd5, 0x5e, 0x00)),
    ("held", Color::rgb(0x00, 0x9e, 0x73)),
    ("loads", Color::rgb(0x00, 0x72, 0xb2)),
    ("on springs", Color::rgb(0xcc, 0x79, 0xa7)),
    ("platens", Color::rgb(0xb8, 0x86, 0x0b)),
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
            "Bodies as they are modelled, names of sets, edges in contact, supports (crosses) and loads (arrows); cells of a given mesh unless there are many.{part}"
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
    plot.width = WIDTH;
    let mut kinds = KINDS.map(|(label, color)| Marks::new(label, color));
    let [contacts, held, loads, springs, platens] = &mut kinds;
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
    let per_pixel = (window[1] - window[0]) / WIDTH;
    let crosses = [&*held, &*springs, &*platens];
    let crosses: Vec<Point> = crosses.iter().flat_map(|own| own.points.clone()).collect();
    let mut outlines = own.outlines(per_pixel);
    let texts = outlines.iter_mut().map(|own| &mut own.texts);
    keep_apart(texts, &crosses, per_pixel);
    let cells = Marks {
        paths: own.cells(),
        width: 0.6,
        ..Marks::new("cells", CELLS)
    };
    let all = std::iter::once(cells).chain(outlines).chain(kinds);
    plot.marks = all.filter(|own| !own.is_empty()).collect();
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

    /// The edges of each body, with their names beside them inside.
    fn outlines(&self, per_pixel: f64) -> Vec<Marks> {
        let count = self.meshes().count();
        let sets = self.meshes().map(|(_, mesh)| mesh.edge_set_names().count());
        let is_named = sets.sum::<usize>() <= MOST_NAMES;
        let many = count > BODIES.len();
        let of_body = |(k, (name, mesh)): (usize, (&str, &Mesh))| {
            let label = if many { "bodies" } else { name };
            let mut own = Marks::new(label, BODIES[if many { 0 } else { k }]);
            for set in mesh.edge_set_names() {
                let Some((places, _)) = self.places(&format!("{name}.{set}")) else {
                    continue;
                };
                if is_named {
                    own.texts.extend(beside(&places, set, per_pixel));
                }
                own.paths.push(places);
            }
            own
        };
        let mut all: Vec<Marks> = self.meshes().enumerate().map(of_body).collect();
        if many {
            let rest = all.split_off(1);
            for own in rest {
                all[0].paths.extend(own.paths);
                all[0].texts.extend(own.texts);
            }
        }
        all
    }

    /// The borders of all cells, where the scene gives a mesh and there are not too many.
    fn cells(&self) -> Vec<Vec<Point>> {
        let bodies = self.scene.get("bodies").and_then(Value::as_table);
        let mut bodies = bodies.into_iter().flatten();
        let is_given = self.scene.contains_key("mesh")
            || bodies.any(|(_, body)| {
                body.get("mesh").is_some()
                    || body
                        .get("shape")
                        .is_some_and(|shape| shape.get("mesh").is_some())
            });
        let count: usize = self.meshes().map(|(_, mesh)| mesh.element_count()).sum();
        if !is_given || count > MOST_CELLS {
            return Vec::new();
        }
        let of_mesh = |(_, mesh): (&str, &Mesh)| {
            let of_block = |block: &ElementBlock| {
                let corners = block.kind.corners();
                let cells = block.connectivity.chunks(block.kind.nodes());
                let around = cells.map(|cell| {
                    let nodes = (0..=corners).map(|k| cell[k % corners]);
                    nodes.map(|node| self.shown(mesh.nodes()[node])).collect()
                });
                around.collect::<Vec<Vec<Point>>>()
            };
            mesh.blocks().iter().flat_map(of_block).collect::<Vec<_>>()
        };
        self.meshes().flat_map(of_mesh).collect()
    }

    fn list(&self, key: &str) -> impl Iterator<Item = &Value> {
        let list = self.scene.get(key).and_then(Value::as_array);
        list.into_iter().flatten()
    }

    fn contacts(&self) -> Vec<Vec<Point>> {
        let sides = |contact: &Value| {
            let side = |key| Some(self.places(contact.get(key)?.as_str()?)?.0);
            ["first", "second"].map(side)
        };
        let sides = self.list("contacts").flat_map(sides);
        sides.flatten().collect()
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
