//! Stress fields around the contact, undeformed, half models completed by their mirror image: the plate around a hole, whose pin
//! would show little but the support at its centre, and both bodies of a line contact.

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::stress::polar;
use stickslip_report::axis::extent;
use stickslip_report::color::Colormap;
use stickslip_report::field::FieldPlot;

use super::edge::all_contact;
use super::{Group, Plan};
use crate::results::attempt::Attempt;
use crate::results::display::EdgeView;
use crate::results::findings::quoted;
use crate::results::vtk_files::von_mises_stresses;
use stickslip_results::{BodyFields, EdgeKind, Results, StepResults};
use stickslip_text::significant;

/// Half of the window around a hole, in radii.
const HOLE_WINDOW: f64 = 3.0;
/// Half of the window around a contact line, in half-widths of the contact.
const LINE_WINDOW: f64 = 4.0;

/// Pictures of the largest load and of the last step, where they have fields.
pub(super) fn all(results: &Results) -> Vec<Plan<'_>> {
    let Some(edge) = EdgeView::main(results) else {
        return Vec::new();
    };
    let with_fields = |step: &usize| !results.steps[*step].fields.is_empty();
    let mut steps: Vec<usize> = edge
        .load()
        .peak_step()
        .into_iter()
        .chain(results.steps.len().checked_sub(1))
        .collect();
    steps.retain(with_fields);
    steps.dedup();
    let plan = |field: &str, step: usize, draw: fn(&Scene<'_>) -> Attempt| {
        let stem = format!("field-{field}-step-{:02}", step + 1);
        Plan::new(Group::Field, stem, move || draw(&Scene::new(&edge, step)))
    };
    steps
        .into_iter()
        .flat_map(|step| {
            [
                plan("von-mises", step, von_mises),
                plan("normal-stress", step, normal_stress),
            ]
        })
        .collect()
}

/// Fields of the bodies that are drawn.
fn shown<'a>(
    edge: &'a EdgeView<'_>,
    record: &'a StepResults,
) -> impl Iterator<Item = &'a BodyFields> {
    let own = move |fields: &&BodyFields| fields.body == edge.geometry.body;
    record
        .fields
        .iter()
        .filter(move |fields| !edge.is_circle() || own(fields))
}

/// Nodes `[display unit]`, cells and nodal values of all bodies of one step.
struct Scene<'a> {
    edge: &'a EdgeView<'a>,
    step: usize,
    nodes: Vec<Point>,
    cells: Vec<Vec<usize>>,
    /// Whether each node is of the edge's body. The colours follow that body alone.
    leads: Vec<bool>,
}

impl<'a> Scene<'a> {
    fn new(edge: &'a EdgeView<'a>, step: usize) -> Self {
        let mut scene = Self {
            edge,
            step,
            nodes: Vec::new(),
            cells: Vec::new(),
            leads: Vec::new(),
        };
        let unit = edge.units().length;
        for fields in shown(edge, scene.record()) {
            let body = &edge.results().bodies[fields.body];
            let Some(mesh) = &body.mesh else { continue };
            let first = scene.nodes.len();
            let leads = fields.body == edge.geometry.body;
            scene
                .leads
                .extend(std::iter::repeat_n(leads, mesh.nodes().len()));
            scene
                .cells
                .extend((0..mesh.element_count()).flat_map(|cell| drawn(mesh, cell, first)));
            scene.nodes.extend(
                mesh.nodes()
                    .iter()
                    .map(|node| node.map(|x| unit.from_base(x))),
            );
        }
        scene
    }

    fn record(&self) -> &'a StepResults {
        &self.edge.results().steps[self.step]
    }

    /// A value per node in the display unit, from its polar (on circles) and its Cartesian stress `[MPa]`.
    fn values(&self, value: impl Fn(Option<[f64; 3]>, [f64; 3]) -> f64) -> Vec<f64> {
        let circles = self.circles();
        let mut values = Vec::with_capacity(self.nodes.len());
        for fields in shown(self.edge, self.record()) {
            let Some(mesh) = &self.edge.results().bodies[fields.body].mesh else {
                continue;
            };
            let nodes = mesh.nodes().iter().zip(&fields.stress);
            values.extend(nodes.map(|(at, &stress)| {
                let turned = nearest(&circles, at).map(|[x, y]| {
                    let angle = (at[1] - y).atan2(at[0] - x);
                    polar(stress, angle)
                });
                self.edge.stress(value(turned, stress))
            }));
        }
        values
    }

    fn plot<'p>(&'p self, title: &str, label: String, values: &'p [f64]) -> FieldPlot<'p> {
        let unit = self.edge.units().length.name;
        let title = format!("{title} in {}", quoted(self.bodies()));
        let mut plot = FieldPlot::new(title, label, unit, &self.nodes, &self.cells, values)
            .subtitle(format!(
                "At {}{}",
                self.edge.load().step_text(self.step),
                if self.is_cut() {
                    "; a window of the larger body"
                } else {
                    ""
                }
            ))
            .window(self.window());
        if self.edge.geometry.half {
            let [x, y] = self.image();
            plot = plot.mirror([x, y, 1.0]);
        }
        plot
    }

    /// Around the hole or the contact, as far as there are bodies `[display unit]`.
    fn window(&self) -> [f64; 4] {
        let unit = self.edge.units().length;
        let (centre, reach) = match self.edge.geometry.kind {
            EdgeKind::Circle { .. } => {
                let (centre, reach) = self.around_circles();
                (
                    centre.map(|x| unit.from_base(x)),
                    reach.map(|x| unit.from_base(x)),
                )
            }
            EdgeKind::Path => ([0.0; 2], [f64::INFINITY; 2]),
            EdgeKind::Line => {
                all_contact(self.edge).map_or(([0.0, 0.0], [f64::INFINITY; 2]), |[start, end]| {
                    let reach = LINE_WINDOW * 0.5 * (end - start);
                    ([0.5 * (start + end), 0.0], [reach; 2])
                })
            }
        };
        let images = self.nodes.iter().map(|&[x, y]| {
            let [along, across] = self.image();
            [along * x, across * y]
        });
        let images = images.filter(|_| self.edge.geometry.half);
        around(
            extent(self.nodes.iter().copied().chain(images)),
            centre,
            reach,
        )
    }

    /// Names of the bodies that are drawn.
    fn bodies(&self) -> Vec<&'a str> {
        let bodies = &self.edge.results().bodies;
        shown(self.edge, self.record())
            .map(|fields| bodies[fields.body].name.as_str())
            .collect()
    }

    /// Whether the window leaves out parts of the bodies.
    fn is_cut(&self) -> bool {
        let window = self.window();
        self.nodes.iter().any(|node| !is_within(window, node))
    }

    /// Centre and radius of every circle of the body along which contact is reported `[mm]`.
    fn circles(&self) -> Vec<(Point, f64)> {
        let all = EdgeView::all(self.edge.results()).into_iter();
        let circle = |own: EdgeView<'_>| match own.geometry.kind {
            EdgeKind::Circle { centre, radius } => Some((centre, radius)),
            EdgeKind::Line | EdgeKind::Path => None,
        };
        let beside = all.filter(|own| {
            let is_own = own.is_same(self.edge);
            is_own || (own.geometry.contact && own.geometry.body == self.edge.geometry.body)
        });
        beside.filter_map(circle).collect()
    }

    /// Middle and half of the sizes of the window around all circles `[mm]`.
    fn around_circles(&self) -> (Point, [f64; 2]) {
        let circles = self.circles();
        let ends = [0, 1].map(|axis| {
            let least = circles
                .iter()
                .map(|(at, radius)| at[axis] - HOLE_WINDOW * radius);
            let most = circles
                .iter()
                .map(|(at, radius)| at[axis] + HOLE_WINDOW * radius);
            [
                least.fold(f64::INFINITY, f64::min),
                most.fold(f64::NEG_INFINITY, f64::max),
            ]
        });
        (
            ends.map(|[low, high]| 0.5 * (low + high)),
            ends.map(|[low, high]| 0.5 * (high - low)),
        )
    }

    /// Factors of x and y in the mirror image of a half.
    fn image(&self) -> [f64; 2] {
        if self.edge.is_circle() {
            [1.0, -1.0]
        } else {
            [-1.0, 1.0]
        }
    }

    /// Largest magnitude in sight in the edge's body.
    fn largest(&self, values: &[f64]) -> f64 {
        let window = self.window();
        let nodes = self.nodes.iter().zip(&self.leads).zip(values);
        let shown = nodes.filter(|((node, leads), _)| **leads && is_within(window, node));
        shown.map(|(_, value)| value.abs()).fold(0.0, f64::max)
    }

    fn remark(&self) -> String {
        let image = match (self.edge.geometry.half, self.edge.is_circle()) {
            (false, _) => "",
            (true, true) => "; y < 0 is the mirror image of the model",
            (true, false) => "; x < 0 is the mirror image of the model",
        };
        let cut = if self.is_cut() {
            "; a window, beyond which the body goes on"
        } else {
            ""
        };
        format!(
            " Shape before deformation{cut}{image}. Beyond the ends of the colour bar the colour stays."
        )
    }
}

/// The centre of the circle that is nearest to `at`.
fn nearest(circles: &[(Point, f64)], at: &Point) -> Option<Point> {
    let beyond =
        |(centre, radius): &(Point, f64)| (at[0] - centre[0]).hypot(at[1] - centre[1]) - radius;
    let nearest = circles
        .iter()
        .min_by(|a, b| beyond(a).total_cmp(&beyond(b)));
    nearest.map(|(centre, _)| *centre)
}

fn von_mises(scene: &Scene<'_>) -> Attempt {
    let values: Vec<f64> = shown(scene.edge, scene.record())
        .flat_map(von_mises_stresses)
        .map(|stress| scene.edge.stress(stress))
        .collect();
    let unit = scene.edge.units().stress.name;
    let largest = scene.largest(&values);
    let mut plot = scene.plot("Von Mises stress", format!("σ_vM [{unit}]"), &values);
    if largest > 0.0 {
        plot = plot.between(0.0, largest);
    }
    let bodies = &scene.edge.results().bodies;
    let limit = bodies[scene.edge.geometry.body].yield_stress;
    if let Some(limit) = limit {
        plot = plot.contour(scene.edge.stress(limit));
    }
    let thick = shown(scene.edge, scene.record())
        .flat_map(|fields| &fields.thickness_stress)
        .any(|&stress| stress != 0.0);
    let formula = if thick {
        "Von Mises stress of σ_xx, σ_yy, τ_xy and σ_zz, which holds ε_zz = 0 in plane strain,"
    } else {
        "√(σ_xx² − σ_xx σ_yy + σ_yy² + 3 τ_xy²), as σ_zz = 0 in plane stress,"
    };
    let text = format!(
        "{formula} at {}. Its largest value in sight in '{}' is {} {unit}.",
        scene.edge.load().step_text(scene.step),
        scene.edge.body(),
        significant(largest, 4),
    );
    let beyond = limit.map_or_else(String::new, |limit| {
        let limit = scene.edge.stress(limit);
        let yields = if largest > limit {
            "The red line is"
        } else {
            "It stays below"
        };
        format!(
            " {yields} the yield stress of {} {unit}.",
            significant(limit, 4)
        )
    });
    Ok(Some((plot.render()?, text + &beyond + &scene.remark())))
}

fn normal_stress(scene: &Scene<'_>) -> Attempt {
    // Along lines, arcs and splines no component of the plane is the one across the contact everywhere.
    if scene.edge.geometry.kind == EdgeKind::Path {
        return Ok(None);
    }
    let symbol = scene.edge.stress_symbols()[0];
    let values = scene.values(|polar, stress| polar.map_or(stress[1], |polar| polar[0]));
    let label = format!("{symbol} [{}]", scene.edge.units().stress.name);
    let title = if scene.edge.is_circle() {
        match scene.circles().len() {
            0 | 1 => "Radial stress about the hole's centre",
            _ => "Radial stress about the centre of the nearest hole",
        }
    } else {
        "Stress normal to the contact"
    };
    let largest = scene.largest(&values);
    let mut plot = scene
        .plot(title, label, &values)
        .colormap(Colormap::BlueWhiteRed);
    if largest > 0.0 {
        plot = plot.between(-largest, largest);
    }
    let contact = if scene.edge.geometry.contact && !scene.edge.is_circle() {
        " Where the bodies touch it passes from one to the other without a jump."
    } else {
        ""
    };
    let text = format!(
        "{symbol} at {}: compression blue, tension red.{contact}",
        scene.edge.load().step_text(scene.step),
    );
    Ok(Some((plot.render()?, text + &scene.remark())))
}

/// The loops of nodes around the parts of a cell that pictures show, of quadratic edges corner, mid-side, corner; `first` is the number
/// of the mesh's first node.
pub(crate) fn drawn(mesh: &Mesh, cell: usize, first: usize) -> Vec<Vec<usize>> {
    let (kind, nodes, _) = mesh.element(cell);
    let parts = kind.drawn_cells().into_iter();
    parts
        .map(|part| part.into_iter().map(|local| first + nodes[local]).collect())
        .collect()
}

/// What of a body with these ends along x and y lies so near to `centre` along x and y.
pub(crate) fn around(
    [left, right, bottom, top]: [f64; 4],
    centre: Point,
    reach: [f64; 2],
) -> [f64; 4] {
    [
        left.max(centre[0] - reach[0]),
        right.min(centre[0] + reach[0]),
        bottom.max(centre[1] - reach[1]),
        top.min(centre[1] + reach[1]),
    ]
}

/// Whether a node lies in the part `[x_low, x_high, y_low, y_high]` of the plane.
pub(crate) fn is_within([left, right, bottom, top]: [f64; 4], node: &Point) -> bool {
    (left..=right).contains(&node[0]) && (bottom..=top).contains(&node[1])
}

/// The distance of the nearest node to `centre`: of the centre of a hole, its radius.
pub(crate) fn distance(nodes: &[Point], centre: Point) -> f64 {
    let distances = nodes
        .iter()
        .map(|[x, y]| (x - centre[0]).hypot(y - centre[1]));
    distances.fold(f64::INFINITY, f64::min)
}
