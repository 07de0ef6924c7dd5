//! Measures of meshes, independent of the generators.

use std::collections::BTreeMap;

use stickslip_fem_core::element::{Element, KindVisitor, gather, jacobian, with_element};
use stickslip_fem_core::mesh::{EdgeRef, Mesh, Point};

struct Area<'a> {
    nodes: &'a [Point],
    connectivity: &'a [usize],
}

impl KindVisitor for Area<'_> {
    type Output = f64;

    fn visit<const N: usize, E: Element<N>>(self) -> f64 {
        let cells = self.connectivity.chunks_exact(N);
        let area = |cell: &[usize]| -> f64 {
            let x: [Point; N] = gather(self.nodes, cell);
            let points = E::QUADRATURE.iter();
            points
                .map(|point| point.weight * jacobian::<N, E>(&x, point.at).det)
                .sum()
        };
        cells.map(area).sum()
    }
}

/// Area of all cells by the elements' own quadrature.
pub(crate) fn area(mesh: &Mesh) -> f64 {
    let area = |(nodes, connectivity), kind| {
        with_element(
            kind,
            Area {
                nodes,
                connectivity,
            },
        )
    };
    mesh.blocks()
        .iter()
        .map(|block| area((mesh.nodes(), &block.connectivity[..]), block.kind))
        .sum()
}

fn all_edges(mesh: &Mesh) -> impl Iterator<Item = EdgeRef> {
    let cells = 0..mesh.element_count();
    cells.flat_map(|element| {
        (0..mesh.element(element).0.edges()).map(move |edge| EdgeRef { element, edge })
    })
}

/// Edges that belong to one cell only, sorted.
pub(crate) fn boundary(mesh: &Mesh) -> Vec<EdgeRef> {
    let mut owners = BTreeMap::<[usize; 2], Vec<EdgeRef>>::new();
    for edge in all_edges(mesh) {
        let mut ends = mesh.edge_nodes(edge).ends;
        ends.sort_unstable();
        owners.entry(ends).or_default().push(edge);
    }
    let mut single: Vec<EdgeRef> = owners
        .into_values()
        .filter(|edges| edges.len() == 1)
        .flatten()
        .collect();
    single.sort_unstable();
    single
}

/// All edges of all edge sets, sorted, repetitions kept.
pub(crate) fn named_edges(mesh: &Mesh) -> Vec<EdgeRef> {
    let sets = mesh
        .edge_set_names()
        .filter_map(|name| mesh.edge_set(name).ok());
    let mut named: Vec<EdgeRef> = sets.flat_map(|set| set.edges.iter().copied()).collect();
    named.sort_unstable();
    named
}

/// Longest edge [length].
pub(crate) fn longest_edge(mesh: &Mesh) -> f64 {
    let length = |edge| {
        let [a, b] = mesh.edge_nodes(edge).ends.map(|node| mesh.nodes()[node]);
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    all_edges(mesh).map(length).fold(0.0, f64::max)
}

/// Smallest and largest corner angle of all cells, between straight edges [degrees].
pub(crate) fn corner_angles(mesh: &Mesh) -> [f64; 2] {
    let mut range = [180.0_f64, 0.0_f64];
    for element in 0..mesh.element_count() {
        let (kind, cell, _) = mesh.element(element);
        let n = kind.corners();
        let corner = |k: usize| mesh.nodes()[cell[k % n]];
        for k in 0..n {
            let (at, next, last) = (corner(k), corner(k + 1), corner(k + n - 1));
            let (a, b) = (
                [next[0] - at[0], next[1] - at[1]],
                [last[0] - at[0], last[1] - at[1]],
            );
            let angle = (a[0] * b[1] - a[1] * b[0])
                .atan2(a[0] * b[0] + a[1] * b[1])
                .to_degrees();
            range = [range[0].min(angle), range[1].max(angle)];
        }
    }
    range
}
