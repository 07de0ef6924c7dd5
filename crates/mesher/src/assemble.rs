//! The mesh of a triangulation and its rings.

use std::collections::{BTreeMap, BTreeSet};

use stickslip_fem_core::mesh::{
    Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshParts, Point,
};

use crate::edges::Origin;
use crate::frame::Framed;
use crate::plan::Plan;
use crate::ring::{Ring, cut};
use crate::symmetry::Mirror;
use crate::triangulate::Triangles;
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
pub(crate) struct Corners<'a> {
    points: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    rims: Vec<Rim<'a>>,
}

/// Makes the mesh of at most `limit` nodes.
pub(crate) fn assembled(
    plan: &Plan,
    mut corners: Corners<'_>,
    division: &Division,
    limit: usize,
) -> Result<Mesh, ContourError> {
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
    /// What has been triangulated in a frame, where it was, with the layers of the rings of `plan`.
    pub(crate) fn new(
        framed: &Framed,
        plan: &'a Plan,
        whole: Triangles,
        mirrors: &[Mirror],
    ) -> Self {
        let mut corners = Self {
            points: whole.points,
            triangles: whole.cells,
            rims: Vec::new(),
        };
        let rings = &framed.plan.rings;
        let mut outer: Vec<Vec<usize>> = rings
            .iter()
            .map(|ring| vec![0; ring.angles.len()])
            .collect();
        for segment in &whole.segments {
            if let Origin::Ring { ring, ray } = segment.origin {
                outer[ring][ray] = segment.ends[1];
            }
        }
        let rims = rings.iter().zip(outer);
        let rims: Vec<Vec<usize>> = rims
            .map(|(ring, outer)| corners.layers(ring, outer, mirrors))
            .collect();
        corners.return_from(framed);
        for segment in &whole.segments {
            if let Origin::Piece {
                piece, from, to, ..
            } = segment.origin
            {
                let length = framed.plan.outline.tracks[piece].length();
                let parts = [from, to].map(|s| s / length);
                corners.on_piece(
                    segment.ends,
                    parts,
                    plan,
                    framed.tracks[piece],
                    framed.mirrors(),
                );
            }
        }
        for (k, nodes) in rims.iter().enumerate() {
            let ring = &plan.rings[framed.holes[k]];
            corners.on_hole(ring, nodes, &framed.rays[k]);
        }
        corners
    }

    /// Nodes and triangles where they were before they were framed.
    fn return_from(&mut self, framed: &Framed) {
        for point in &mut self.points {
            *point = framed.back(*point);
        }
        if framed.mirrors() {
            for [_, b, c] in &mut self.triangles {
                std::mem::swap(b, c);
            }
        }
    }

    /// Puts an edge on the exact curve of a piece, between two parts of its length.
    fn on_piece(
        &mut self,
        mut ends: [usize; 2],
        mut parts: [f64; 2],
        plan: &'a Plan,
        track: usize,
        mirrored: bool,
    ) {
        if mirrored {
            ends.reverse();
            parts = [1.0 - parts[1], 1.0 - parts[0]];
        }
        let set = &plan.outline.names[track];
        let track = &plan.outline.tracks[track];
        let at = |part: f64| track.at(part * track.length());
        for (node, part) in ends.into_iter().zip(parts) {
            self.points[node] = at(part);
        }
        let halfway = at(f64::midpoint(parts[0], parts[1]));
        self.rims.push(Rim { ends, set, halfway });
    }

    /// Puts nodes on the exact circle of a hole, each on one of its `rays`.
    fn on_hole(&mut self, ring: &'a Ring, nodes: &[usize], rays: &[usize]) {
        let count = nodes.len();
        let mut by_ray = vec![0; count];
        for (&node, &ray) in nodes.iter().zip(rays) {
            by_ray[ray] = node;
            self.points[node] = ring.rows[0][ray];
        }
        let rims = (0..count).map(|ray| Rim {
            ends: [by_ray[(ray + 1) % count], by_ray[ray]],
            set: &ring.name,
            halfway: ring.halfway(ray),
        });
        self.rims.extend(rims);
    }

    /// Adds the layers of a ring inside its outermost row of nodes, and returns the nodes of the hole.
    fn layers(&mut self, ring: &Ring, outer: Vec<usize>, mirrors: &[Mirror]) -> Vec<usize> {
        let count = outer.len();
        let layers = ring.rows.len() - 1;
        let mut far = outer;
        for row in ring.rows[..layers].iter().rev() {
            let first = self.points.len();
            self.points.extend(row);
            let near: Vec<usize> = (first..first + count).collect();
            for ray in 0..count {
                let next = (ray + 1) % count;
                let mut corners = [near[ray], far[ray], far[next], near[next]];
                let [a, b, c, d] = corners.map(|node| self.points[node]);
                let centre = middle(middle(a, d), middle(b, c));
                let copies = mirrors.iter().filter(|mirror| mirror.copies(centre));
                // Of two diagonals that are equally long a copy has the other one.
                if copies.count() % 2 == 1 {
                    corners.rotate_left(1);
                }
                self.quadrilateral(corners);
            }
            far = near;
        }
        far
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
