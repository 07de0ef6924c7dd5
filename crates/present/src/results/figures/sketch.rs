//! The scene as it is modelled: outlines of bodies, edges in contact, what is held and what is loaded.

mod walk;

use std::sync::Arc;

use stickslip_fem_core::mesh::{ElementBlock, Mesh, Point};
use stickslip_report::FigureError;
use stickslip_report::color::Color;
use stickslip_report::plane::{Marks, PlanePlot};
use stickslip_report::svg::Svg;

use self::walk::{ahead, along, arrow, beside, inwards, keep_apart};
use super::{Group, Plan};
use stickslip_results::{Acting, Problem, Results, Site, SitePart};
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
        let picture = sketch(&results.title, &bodies, &results.problem, results.units)?;
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

/// Draws `bodies`, in the order of their indices, with the contacts, supports and loads of `problem`; `None` where no body has a mesh.
///
/// # Errors
/// [`FigureError`] for a picture that cannot be drawn.
pub fn sketch(
    title: &str,
    bodies: &[SketchBody],
    problem: &Problem,
    units: DisplayUnits,
) -> Result<Option<Svg>, FigureError> {
    let own = Sketch {
        bodies,
        problem,
        units,
    };
    let Some(window) = own.window() else {
        return Ok(None);
    };
    let size = (window[1] - window[0]).max(window[3] - window[2]);
    let mut plot = PlanePlot::new(title, units.length.name, window);
    plot.width = WIDTH;
    let mut kinds = KINDS.map(|(label, color)| Marks::new(label, color));
    let [contacts, held, loads, springs, platens] = &mut kinds;
    contacts.paths = (problem.contacts.iter())
        .filter_map(|side| own.walk(side))
        .collect();
    held.points = own.marks(&problem.held);
    springs.points = own.marks(&problem.springs);
    platens.points = own.marks(&problem.platens);
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
    problem: &'a Problem,
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

    fn mesh(&self, site: &Site) -> Option<&Mesh> {
        self.bodies.get(site.body)?.1.as_deref()
    }

    fn places(&self, mesh: &Mesh, nodes: &[usize]) -> Vec<Point> {
        let at = |&node: &usize| Some(self.shown(*mesh.nodes().get(node)?));
        nodes.iter().filter_map(at).collect()
    }

    /// The walk along the edge that a site is.
    fn walk(&self, site: &Site) -> Option<Vec<Point>> {
        match &site.part {
            SitePart::Edge(nodes) => Some(self.places(self.mesh(site)?, nodes)),
            SitePart::Points(_) | SitePart::Area => None,
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
                let (nodes, closed) = match (mesh.edge_path(set), mesh.node_set(set)) {
                    (Ok(path), _) => (path.nodes, path.closed),
                    (Err(_), Ok(nodes)) => (nodes.to_vec(), false),
                    (Err(_), Err(_)) => continue,
                };
                let mut places = self.places(mesh, &nodes);
                places.extend(places.first().copied().filter(|_| closed));
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
        let count: usize = self.meshes().map(|(_, mesh)| mesh.element_count()).sum();
        if !self.problem.is_divided || count > MOST_CELLS {
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

    /// Places along edges and points; an area is marked at its middle.
    fn marks(&self, sites: &[Site]) -> Vec<Point> {
        let of_site = |site: &Site| {
            Some(match &site.part {
                SitePart::Edge(_) => along(&self.walk(site)?, HELD_MARKS),
                SitePart::Points(nodes) => self.places(self.mesh(site)?, nodes),
                SitePart::Area => vec![self.middle(site)?],
            })
        };
        sites.iter().filter_map(of_site).flatten().collect()
    }

    /// Middle of the body of a site.
    fn middle(&self, site: &Site) -> Option<Point> {
        let [low, high] = self.mesh(site)?.bounding_box();
        Some(self.shown([0, 1].map(|axis| 0.5 * (low[axis] + high[axis]))))
    }

    /// An arrow for each force and pressure.
    fn loads(&self, length: f64) -> Vec<Vec<Point>> {
        let of_load = |Acting { site, direction }: &Acting| {
            let walk = self.walk(site);
            let at = match (&walk, &site.part) {
                (Some(walk), _) => along(walk, 3).get(1).copied(),
                (None, SitePart::Points(nodes)) => {
                    self.places(self.mesh(site)?, nodes).first().copied()
                }
                (None, SitePart::Edge(_) | SitePart::Area) => None,
            };
            let at = at.or_else(|| self.middle(site))?;
            // A pressure ends on its edge, a force begins there.
            let (direction, start) = if let Some(direction) = direction {
                (*direction, at)
            } else {
                let inwards = inwards(&walk?)?;
                (inwards, ahead(at, inwards, -length))
            };
            Some(arrow(start, direction, length))
        };
        self.problem
            .loads
            .iter()
            .filter_map(of_load)
            .flatten()
            .collect()
    }
}
