//! The contract of a shape, for every shape of the list.

use std::f64::consts::PI;
use std::io;
use std::path::Path;

use stickslip_fem_core::generate::{self, Extent, Generate, Growth, PlateWithHole, uniform_angles};
use stickslip_fem_core::material::PlaneState;
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};

use stickslip_mesh_files::write_inp;

use super::outline::CIRCLE_KEYS;
use super::{Curve, Divided, EXAMPLES, Edge, Role, Shape, ShapeFormat, Sizes};
use crate::document::child;
use crate::keys::declared;
use crate::units::{Length, Quantity};

/// Rounding of coordinates of some 100 mm, with room for a dozen operations.
const EXACT: f64 = 1e-12;

/// Arcs that turn by more have no height over x `[rad]`.
const STEEP: f64 = 2.0;

/// Sizes of examples are right.
struct Right;

impl Sizes for Right {
    fn refuse(&mut self, key: &str, size: &Quantity<Length>, allowed: &str) {
        panic!("{key} = {} is not {allowed}", size.text());
    }

    fn file(&self, path: &Path, included: Option<&str>) -> io::Result<String> {
        assert_eq!((path, included), (Path::new("ring.inp"), None));
        let ring = PlateWithHole {
            hole_radius: 5.0,
            outline: generate::Outline::Ring { outer_radius: 15.0 },
            extent: Extent::Whole,
            angles: uniform_angles(Extent::Whole, 48),
            layers: 9,
            growth: Growth::Geometric { aspect: 1.0 },
            far_cells: 3,
            kind: ElementKind::Q8,
        };
        Ok(write_inp(&ring.generate().unwrap(), PlaneState::Stress).unwrap())
    }

    fn bad_file(&mut self, key: &str, path: &str, cause: String, remedy: String) {
        panic!("{key}: {path}: {cause}; {remedy}");
    }

    fn conflict(&mut self, key: &str, message: String, remedy: &str) {
        panic!("{key}: {message}; {remedy}");
    }
}

/// All shapes as scenes write them.
fn formats() -> impl Iterator<Item = ShapeFormat> {
    let read = |text: &&str| toml::from_str(text).unwrap_or_else(|why| panic!("{text}: {why}"));
    EXAMPLES.iter().map(read)
}

fn shapes() -> Vec<Shape> {
    formats()
        .map(|given| given.read("shape", &mut Right))
        .collect()
}

/// The shape that `own` is divided together with, if it is.
fn partner(own: &Shape) -> Option<Shape> {
    let wanted = match own.edges().first()?.role {
        Role::Cap => Role::Surface,
        Role::Surface => Role::Cap,
        _ => return None,
    };
    let mut others = shapes().into_iter();
    others.find(|other| other.edge_with(wanted).is_some())
}

fn mesh(shape: &Shape, kind: ElementKind, extent: Extent, centre: Point) -> Mesh {
    let own = |given: &Divided<'_>| {
        let meshing = shape.meshing(given).unwrap();
        assert!(meshing.layers.is_none() || shape.is_round(), "{shape:?}");
        meshing.generator.generate().unwrap()
    };
    divided(shape, extent, |given| {
        own(&Divided {
            kind,
            centre,
            ..*given
        })
    })
}

/// Calls `then` with a division of `shape` into Q8.
fn divided<T>(shape: &Shape, extent: Extent, then: impl Fn(&Divided<'_>) -> T) -> T {
    let partner = partner(shape);
    let count = if extent == Extent::Half { 24 } else { 48 };
    let angles = uniform_angles(extent, count);
    then(&Divided {
        kind: ElementKind::Q8,
        angles: if shape.is_round() { &angles } else { &[] },
        spacing: (!shape.is_round()).then_some(0.75),
        fine_to: None,
        places: None,
        layers: None,
        fineness: 1.0,
        most_layers: usize::MAX,
        extent,
        centre: [0.0; 2],
        partner: partner.as_deref(),
        most: 1_000_000,
    })
}

/// How far `at` lies from the curve `[mm]`.
fn distance(curve: &Curve, [x, y]: Point) -> f64 {
    match *curve {
        Curve::Chain { .. } => 0.0,
        Curve::Circle {
            centre: [centre_x, centre_y],
            radius,
        } => ((x - centre_x).hypot(y - centre_y) - radius).abs(),
        Curve::Arc {
            centre,
            radius,
            turn,
            ..
        } if turn.abs() > STEEP => ((x - centre[0]).hypot(y - centre[1]) - radius).abs(),
        Curve::Arc {
            centre,
            radius,
            ends: [from, to],
            ..
        } => {
            // The arc's digits near the origin are those of its height, so it is measured along y.
            let across = x - centre[0];
            let depth = radius - ((radius - across) * (radius + across)).sqrt();
            let beyond = (from[0] - x).max(x - to[0]).max(0.0);
            (y - (centre[1] - radius + depth)).abs().max(beyond)
        }
        Curve::Segment {
            ends: [[ax, ay], [bx, by]],
        } => {
            let (dx, dy) = (bx - ax, by - ay);
            let part = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
            let part = part.clamp(0.0, 1.0);
            (x - ax - part * dx).hypot(y - ay - part * dy)
        }
    }
}

/// Every shape, element and extent that makes a mesh, with its nodes about the body's centre.
fn all(check: impl Fn(&str, &Shape, &Mesh, Extent, &[Point])) {
    for shape in shapes() {
        let kinds = ElementKind::ALL.into_iter();
        for kind in kinds.filter(|kind| shape.cells(*kind).is_some()) {
            for extent in [Extent::Half, Extent::Whole] {
                if extent == Extent::Half && shape.mirror().is_none() {
                    continue;
                }
                // Bodies that are divided by lengths stay at the origin.
                let centre = if shape.is_round() {
                    [0.25, 0.0]
                } else {
                    [0.0; 2]
                };
                let mesh = mesh(&shape, kind, extent, centre);
                let nodes: Vec<Point> = (mesh.nodes().iter())
                    .map(|[x, y]| [x - centre[0], y - centre[1]])
                    .collect();
                let name = format!("{shape:?} {kind:?} {extent:?}");
                check(&name, &shape, &mesh, extent, &nodes);
            }
        }
    }
}

/// A body that is similar to all of its kind is condensed once for all sizes.
#[test]
fn a_shape_that_is_similar_is_scaled_by_any_of_its_sizes() {
    let mut compared = 0;
    for example in EXAMPLES {
        let given: toml::Table = toml::from_str(example).unwrap();
        let read = |table: &toml::Table| {
            let given: ShapeFormat = table.clone().try_into().unwrap();
            given.read("shape", &mut Right)
        };
        let own = read(&given);
        if !own.is_similar() {
            continue;
        }
        let nodes = |shape: &Shape| {
            let mesh = mesh(shape, ElementKind::Q8, Extent::Whole, [0.0; 2]);
            let size = mesh
                .nodes()
                .iter()
                .map(|node| node[0].abs())
                .fold(0.0, f64::max);
            mesh.nodes()
                .iter()
                .map(|node| node.map(|x| x / size))
                .collect::<Vec<_>>()
        };
        let before = nodes(&own);
        let (name, keys) = given.iter().next().unwrap();
        for (key, value) in keys.as_table().unwrap() {
            let (number, unit) = value.as_str().unwrap().split_once(' ').unwrap();
            let other = format!("{} {unit}", 3.0 * number.parse::<f64>().unwrap());
            let mut changed = given.clone();
            changed[name][key] = other.into();
            let after = nodes(&read(&changed));
            assert_eq!(before.len(), after.len(), "{name}.{key}");
            compared += 1;
            for (a, b) in before.iter().zip(&after) {
                let apart = (a[0] - b[0]).hypot(a[1] - b[1]);
                assert!(apart < EXACT, "{name}.{key}: {a:?} {b:?}");
            }
        }
    }
    assert!(compared > 0);
}

/// Whether a half model of `shape` has no part of the edge.
fn left_out(shape: &Shape, edge: &Edge, extent: Extent) -> bool {
    let side = shape.mirror().and_then(|across| edge.side(across));
    extent == Extent::Half && side == Some(-1.0)
}

#[test]
fn the_list_names_every_shape_once() {
    let shapes = shapes();
    assert_eq!(shapes.len(), 8);
    for (index, shape) in shapes.iter().enumerate() {
        let kind = std::mem::discriminant(shape);
        assert!(
            shapes[..index]
                .iter()
                .all(|other| std::mem::discriminant(other) != kind)
        );
        assert!(EXAMPLES[index].starts_with(shape.name()), "{shape:?}");
        let line = shape.describe(&|value| format!("{value} mm"));
        assert!(line.contains(" mm"), "{line}");
    }
}

#[test]
fn what_is_read_is_written_as_it_was() {
    for text in EXAMPLES {
        let given: ShapeFormat = toml::from_str(text).unwrap();
        let written = toml::to_string(&given).unwrap();
        let again: ShapeFormat = toml::from_str(&written).unwrap();
        let [first, second] = [given, again].map(|given| given.read("shape", &mut Right));
        assert_eq!(first, second, "{text}");
    }
}

#[test]
fn edges_and_points_exist_where_the_shape_says() {
    all(|name, shape, mesh, extent, nodes| {
        for edge in shape.edges() {
            if left_out(shape, &edge, extent) {
                assert!(mesh.node_set(&edge.name).is_err(), "{name} {}", edge.name);
                continue;
            }
            let set = mesh.node_set(&edge.name).unwrap();
            assert!(set.len() > 2, "{name} {}", edge.name);
            assert!(mesh.edge_set(&edge.name).is_ok(), "{name} {}", edge.name);
            for &node in set {
                let error = distance(&edge.curve, nodes[node]);
                assert!(error < EXACT, "{name} {}: {error:e}", edge.name);
            }
        }
        for (point, [x, y]) in shape.points() {
            let set = mesh.node_set(&point).unwrap();
            assert_eq!(set.len(), 1, "{name} {point}");
            let at = nodes[set[0]];
            assert!((at[0] - x).hypot(at[1] - y) < EXACT, "{name} {point}");
        }
    });
}

#[test]
fn edges_reach_the_ends_that_they_state() {
    all(|name, shape, mesh, extent, nodes| {
        for edge in shape.edges() {
            let (Curve::Segment { ends } | Curve::Arc { ends, .. }) = edge.curve else {
                continue;
            };
            if left_out(shape, &edge, extent) {
                continue;
            }
            let set = mesh.node_set(&edge.name).unwrap();
            for [x, y] in ends {
                let kept = shape.mirror().is_none_or(|across| [x, y][across] >= 0.0);
                if extent == Extent::Half && !kept {
                    continue;
                }
                let gap = |&node: &usize| (nodes[node][0] - x).hypot(nodes[node][1] - y);
                let nearest = set.iter().map(gap).fold(f64::INFINITY, f64::min);
                assert!(nearest < EXACT, "{name} {}: {nearest:e}", edge.name);
            }
        }
    });
}

#[test]
fn the_extent_holds_all_nodes_and_is_reached() {
    all(|name, shape, _, extent, nodes| {
        let [low, high] = shape.bounds();
        // A steep arc reaches farthest between two nodes, which are 15° apart at most.
        let rise = |edge: &Edge| match edge.curve {
            Curve::Arc { turn, radius, .. } if turn > STEEP => radius * (1.0 - (PI / 24.0).cos()),
            _ => 0.0,
        };
        let apart = shape.edges().iter().map(rise).fold(EXACT, f64::max);
        for axis in [0, 1] {
            let along = nodes.iter().map(|node| node[axis]);
            let (least, most) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
                (a.min(x), b.max(x))
            });
            let halved = extent == Extent::Half && shape.mirror() == Some(axis);
            let low = if halved { 0.0 } else { low[axis] };
            assert!((least - low).abs() < apart, "{name}: {least} and {low}");
            assert!(least > low - EXACT && most < high[axis] + EXACT, "{name}");
            assert!((most - high[axis]).abs() < apart, "{name}: {most}");
        }
    });
}

#[test]
fn whole_meshes_have_the_symmetry_that_the_shape_claims() {
    all(|name, shape, mesh, extent, nodes| {
        let Some(across) = shape.mirror() else {
            return;
        };
        if extent == Extent::Half {
            for &node in mesh.node_set("symmetry").unwrap() {
                assert!(nodes[node][across].abs() < EXACT, "{name}");
            }
            assert!(nodes.iter().all(|node| node[across] > -EXACT), "{name}");
            return;
        }
        let image = |&node: &Point| {
            let mut image = node;
            image[across] *= -1.0;
            image
        };
        // Sorted by the coordinate along the line of symmetry, an image is searched among its neighbours only.
        let along = 1 - across;
        let mut sorted = nodes.to_vec();
        sorted.sort_by(|a, b| a[along].total_cmp(&b[along]));
        for image in nodes.iter().map(image) {
            let from = sorted.partition_point(|node| node[along] < image[along] - 1e-9);
            let near = sorted[from..].iter();
            let mut near = near.take_while(|node| node[along] < image[along] + 1e-9);
            let found = near.any(|node| (node[0] - image[0]).hypot(node[1] - image[1]) < EXACT);
            assert!(found, "{name}: no node at {image:?}");
        }
    });
}

#[test]
fn edges_on_the_line_of_symmetry_are_their_own_images() {
    for shape in shapes() {
        let Some(across) = shape.mirror() else {
            continue;
        };
        let crossing = (shape.edges().into_iter()).filter(|edge| edge.side(across).is_none());
        for edge in crossing {
            let (Curve::Segment { ends } | Curve::Arc { ends, .. }) = edge.curve else {
                continue;
            };
            let [from, mut image] = ends;
            image[across] *= -1.0;
            assert_eq!(from, image, "{shape:?} {edge:?}");
        }
    }
}

#[test]
fn normals_point_in_where_the_edge_says() {
    all(|name, shape, mesh, extent, nodes| {
        for edge in shape.edges() {
            // Results take e_r of circles and +y of other edges.
            if left_out(shape, &edge, extent) || !edge.is_reportable() {
                continue;
            }
            let path = mesh.edge_path(&edge.name).unwrap();
            let own = path.nodes[path.nodes.len() / 2 / path.order * path.order];
            let [x, y] = nodes[own];
            let normal = match edge.curve {
                Curve::Circle { centre, radius } => {
                    [(x - centre[0]) / radius, (y - centre[1]) / radius]
                }
                Curve::Arc { .. } | Curve::Segment { .. } | Curve::Chain { .. } => [0.0, 1.0],
            };
            let cells = (0..mesh.element_count()).map(|cell| mesh.element(cell).1);
            let mut depth = 0.0;
            for other in cells.filter(|cell| cell.contains(&own)).flatten() {
                let [px, py] = nodes[*other];
                depth += (px - x) * normal[0] + (py - y) * normal[1];
            }
            assert_eq!(
                depth > 0.0,
                edge.has_inward_normal(),
                "{name} {}",
                edge.name
            );
        }
    });
}

#[test]
fn keys_of_sizes_lead_to_the_sizes() {
    for (shape, text) in shapes().iter().zip(EXAMPLES) {
        let table: toml::Value = toml::from_str(text).unwrap();
        for edge in shape.edges() {
            let Some(key) = edge.size.clone() else {
                continue;
            };
            let value = key
                .split('.')
                .try_fold(&table, |table, name| table.get(name));
            let value: Quantity<Length> = value.unwrap().clone().try_into().unwrap();
            let size = match edge.curve {
                Curve::Circle { radius, .. } | Curve::Arc { radius, .. } => radius,
                Curve::Segment { .. } | Curve::Chain { .. } => {
                    edge.level(0).or(edge.level(1)).unwrap().abs()
                }
            };
            assert_eq!(value.value(), size, "{key}");
        }
    }
}

#[test]
fn a_hole_takes_a_rim_a_cap_a_surface_and_an_open_edge_another() {
    let edges: Vec<Edge> = shapes().iter().flat_map(|shape| shape.edges()).collect();
    for first in &edges {
        for second in &edges {
            let is_open = |edge: &Edge| edge.role == Role::Free && edge.curve.path().is_some();
            let fits = matches!(
                (first.role, second.role),
                (Role::Hole, Role::Rim) | (Role::Cap, Role::Surface)
            ) || (is_open(first) && is_open(second));
            assert_eq!(
                first.touches(second).is_some(),
                fits,
                "{first:?} {second:?}"
            );
        }
    }
}

#[test]
fn a_mesh_of_its_own_is_known_before_it_is_read() {
    let own = formats().map(|given| given.has_own_mesh());
    let read = shapes().into_iter().map(|shape| shape.has_own_mesh());
    assert!(own.eq(read));
}

#[test]
fn mesh_keys_are_those_that_change_the_mesh() {
    for shape in shapes() {
        let keys = shape.mesh_keys();
        if shape.has_own_mesh() {
            continue;
        }
        assert!(keys.contains(&"spacing"), "{shape:?}");
        for key in keys {
            assert!(declared(&child("mesh", key)).is_some(), "{key}");
        }
        divided(&shape, Extent::Whole, |given| {
            let nodes = |given: &Divided<'_>| {
                let meshing = shape.meshing(given).unwrap();
                meshing.generator.generate().unwrap().nodes().to_vec()
            };
            let layers = Some(2);
            let changed = nodes(&Divided { layers, ..*given }) != nodes(given);
            assert_eq!(changed, keys.contains(&"layers"), "{shape:?}");
            // What round shapes are given has been divided by all keys of angles.
            if shape.is_round() {
                assert!(
                    CIRCLE_KEYS.iter().all(|key| keys.contains(key)),
                    "{shape:?}"
                );
                return;
            }
            let fine_to = Some(7.5);
            let changed = nodes(&Divided { fine_to, ..*given }) != nodes(given);
            assert_eq!(changed, keys.contains(&"fine_to"), "{shape:?}");
            assert!(!keys.contains(&"coarse_spacing"), "{shape:?}");
        });
    }
}

#[test]
fn plates_have_the_roles_by_which_they_are_measured() {
    for shape in shapes() {
        for (role, axis) in [(Role::End, 0), (Role::Side, 1)] {
            if let Some(edge) = shape.edge_with(role) {
                assert!(
                    edge.level(axis) > Some(0.0) && edge.size.is_some(),
                    "{edge:?}"
                );
                assert!(shape.edge_with(Role::Hole).is_some(), "{shape:?}");
            }
        }
    }
}
