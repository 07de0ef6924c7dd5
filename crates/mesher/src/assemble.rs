//! The mesh of a triangulation and its rings.

use std::collections::{BTreeMap, BTreeSet};

use stickslip_fem_core::mesh::{
    Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshParts, Point,
};

use crate::edges::Origin;
use crate::plan::Plan;
use crate::ring::{Ring, cut};
use crate::triangulate::Refinement;
use crate::vector::{along, distance, middle};
use crate::{ContourError, Division};

/// A boundary edge of the body.
struct Rim<'a> {
    /// With the body on the left.
    ends: [usize; 2],
    set: &'a str,
    /// The true curve half-way.
    halfway: Point,
}

/// Corner nodes, triangles, and the boundary.
struct Corners<'a> {
    points: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    rims: Vec<Rim<'a>>,
}

/// Makes the mesh of at most `limit` nodes.
pub(crate) fn assembled(
    plan: &Plan,
    refinement: &Refinement<'_>,
    division: &Division,
    limit: usize,
) -> Result<Mesh, ContourError> {
    let mut corners = Corners::new(plan, refinement);
    let mut edges: BTreeMap<[usize; 2], EdgeRef> = BTreeMap::new();
    for (element, &[a, b, c]) in corners.triangles.iter().enumerate() {
        for (edge, ends) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
            edges.insert(ends, EdgeRef { element, edge });
        }
    }
    let connectivity = if division.kind == ElementKind::T6 {
        quadratic(&mut corners)
    } else {
        corners.triangles.concat()
    };
    let nodes = corners.points.len();
    if nodes > limit {
        return Err(ContourError::TooLarge { nodes, limit });
    }
    let mut edge_sets: BTreeMap<String, EdgeSet> = BTreeMap::new();
    for rim in &corners.rims {
        let set = edge_sets.entry(rim.set.to_owned()).or_default();
        set.edges.extend(edges.get(&rim.ends));
    }
    for (name, set) in &mut edge_sets {
        set.curve = plan
            .shared_curve(name)
            .map(|curve| moved(curve, division.centre));
    }
    let mut node_sets = on_edges(&edge_sets, division.kind, &connectivity);
    node_sets.extend(division.points.iter().map(|(name, &at)| {
        let away = |node: &usize| distance(corners.points[*node], at);
        let nearest = (0..nodes).min_by(|a, b| away(a).total_cmp(&away(b)));
        (name.clone(), nearest.into_iter().collect())
    }));
    let places = corners.points.into_iter();
    Ok(Mesh::new(MeshParts {
        nodes: places.map(|p| along(p, 1.0, division.centre)).collect(),
        blocks: vec![ElementBlock {
            name: "body".into(),
            kind: division.kind,
            connectivity,
        }],
        node_sets,
        edge_sets,
        ..MeshParts::default()
    })?)
}

/// The nodes of each edge set, ascending.
fn on_edges(
    edge_sets: &BTreeMap<String, EdgeSet>,
    kind: ElementKind,
    connectivity: &[usize],
) -> BTreeMap<String, Vec<usize>> {
    let nodes = |edge: &EdgeRef| {
        let cell = &connectivity[edge.element * kind.nodes()..][..kind.nodes()];
        let local = kind.edge_nodes(edge.edge);
        let inner = cell[local.inner].iter().copied();
        let ends = local.ends.map(|k| cell[k]).into_iter();
        ends.chain(inner).collect::<Vec<_>>()
    };
    let of_set = |(name, set): (&String, &EdgeSet)| {
        let all: BTreeSet<usize> = set.edges.iter().flat_map(nodes).collect();
        (name.clone(), all.into_iter().collect())
    };
    edge_sets.iter().map(of_set).collect()
}

fn moved(curve: Curve, by: Point) -> Curve {
    match curve {
        Curve::Arc { centre, radius } => Curve::Arc {
            centre: along(centre, 1.0, by),
            radius,
        },
        Curve::Line => Curve::Line,
    }
}

impl<'a> Corners<'a> {
    fn new(plan: &'a Plan, refinement: &Refinement<'_>) -> Self {
        let mut corners = Self {
            points: refinement.points(),
            triangles: refinement.triangles(),
            rims: Vec::new(),
        };
        let mut outer: Vec<Vec<usize>> = plan
            .rings
            .iter()
            .map(|ring| vec![0; ring.angles.len()])
            .collect();
        for segment in refinement.segments() {
            match segment.origin {
                Origin::Piece {
                    piece, from, to, ..
                } => {
                    let track = &plan.outline.tracks[piece];
                    corners.rims.push(Rim {
                        ends: segment.ends,
                        set: &plan.outline.names[piece],
                        halfway: track.at(f64::midpoint(from, to)),
                    });
                }
                Origin::Ring { ring, ray } => outer[ring][ray] = segment.ends[1],
            }
        }
        for (ring, outer) in plan.rings.iter().zip(outer) {
            corners.ring(ring, outer);
        }
        corners
    }

    /// Adds the layers of a ring inside its outermost row of nodes, and the hole's edge.
    fn ring(&mut self, ring: &'a Ring, outer: Vec<usize>) {
        let count = outer.len();
        let layers = ring.rows.len() - 1;
        let mut far = outer;
        for row in ring.rows[..layers].iter().rev() {
            let first = self.points.len();
            self.points.extend(row);
            let near: Vec<usize> = (first..first + count).collect();
            for ray in 0..count {
                let next = (ray + 1) % count;
                self.quadrilateral([near[ray], far[ray], far[next], near[next]]);
            }
            far = near;
        }
        let rims = (0..count).map(|ray| Rim {
            ends: [far[(ray + 1) % count], far[ray]],
            set: &ring.name,
            halfway: ring.halfway(ray),
        });
        self.rims.extend(rims);
    }

    /// Adds two triangles, cut along the shorter diagonal.
    fn quadrilateral(&mut self, nodes: [usize; 4]) {
        let cells = cut(nodes.map(|node| self.points[node]));
        self.triangles
            .extend(cells.map(|cell| cell.map(|n| nodes[n])));
    }
}

/// Adds the inner nodes of edges, on the true curve of the boundary, and returns the connectivity of T6.
///
/// A curved edge of an angle 2φ folds its cell where the tangent of an angle at its ends is below 2 tan(φ/2). Arcs of the outline have
/// edges of 15°, which fold no cell with angles above 7.5°; rings see to theirs, and `Mesh::new` to what is left.
fn quadratic(corners: &mut Corners<'_>) -> Vec<usize> {
    let key = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    let rims = corners.rims.iter();
    let true_middles: BTreeMap<[usize; 2], Point> =
        rims.map(|rim| (key(rim.ends), rim.halfway)).collect();
    let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let mut connectivity = Vec::with_capacity(6 * corners.triangles.len());
    for &[a, b, c] in &corners.triangles {
        connectivity.extend([a, b, c]);
        for ends in [[a, b], [b, c], [c, a]] {
            let node = *middles.entry(key(ends)).or_insert_with(|| {
                let chord = || middle(corners.points[ends[0]], corners.points[ends[1]]);
                let at = true_middles.get(&key(ends)).copied().unwrap_or_else(chord);
                corners.points.push(at);
                corners.points.len() - 1
            });
            connectivity.push(node);
        }
    }
    connectivity
}
