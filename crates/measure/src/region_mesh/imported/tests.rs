//! Meshes of sectors, written as Gmsh writes them and read again.

use std::fmt::Write as _;
use std::path::PathBuf;

use stickslip_hybrid::region::sector::ArcSector;
use stickslip_scene::host::MemoryFiles;

use super::*;

const HOLE: Hole = Hole {
    centre: [1.0, 2.0],
    radius: 5.0,
};

fn sector(kind: ElementKind) -> Mesh {
    let sector = ArcSector {
        centre: HOLE.centre,
        hole: HOLE.radius,
        stand_off: 0.0,
        outer: 9.0,
        angles: [-0.5, 1.0],
        cells: [6, 3],
        growth: 1.5,
        kind,
    };
    sector.mesh().unwrap()
}

fn number(kind: ElementKind) -> usize {
    match kind {
        ElementKind::T3 => 2,
        ElementKind::T6 => 9,
        ElementKind::Q4 => 3,
        ElementKind::Q8 => 16,
        ElementKind::Q9 => 10,
        other => unreachable!("{other:?} is not read from .msh files"),
    }
}

/// The mesh with tags from 11, its coordinates over `scale`, every other cell walked clockwise.
fn text(mesh: &Mesh, scale: f64) -> String {
    let nodes = mesh.nodes();
    let count = nodes.len();
    let last = count + 10;
    let mut text = format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {count} 11 {last}\n2 1 0 {count}\n"
    );
    for tag in 11..=last {
        let _ = writeln!(text, "{tag}");
    }
    for [x, y] in nodes {
        let _ = writeln!(text, "{} {} 0", x / scale, y / scale);
    }
    let cells = mesh.element_count();
    let kind = mesh.element(0).0;
    let _ = write!(
        text,
        "$EndNodes\n$Elements\n1 {cells} 1 {cells}\n2 1 {} {cells}\n",
        number(kind)
    );
    for cell in 0..cells {
        let mut own = mesh.element(cell).1.to_vec();
        if cell % 2 == 1 {
            reverse(&mut own, kind);
        }
        let tags: Vec<String> = own.iter().map(|node| (node + 11).to_string()).collect();
        let _ = writeln!(text, "{} {}", cell + 1, tags.join(" "));
    }
    text + "$EndElements\n"
}

fn read(text: &str, scale: f64) -> Result<Mesh, ExperimentError> {
    let file = PathBuf::from("region.msh");
    let host = Host::of(MemoryFiles::from_iter([(&file, text)]));
    mesh(&MeshPlan { file, scale }, &HOLE, "inner", host)
}

#[test]
fn a_mesh_comes_back_with_its_hole() {
    for kind in [ElementKind::Q4, ElementKind::Q8, ElementKind::Q9] {
        let written = sector(kind);
        let found = read(&text(&written, 25.4), 25.4).unwrap();
        assert_eq!(found.element_count(), written.element_count());
        let lengths = |mesh: &Mesh| {
            let set = mesh.edge_set("inner").unwrap();
            let mut ends: Vec<[i64; 4]> = (set.edges.iter())
                .map(|&edge| {
                    let [a, b] = mesh.edge_nodes(edge).ends.map(|node| mesh.nodes()[node]);
                    [a[0], a[1], b[0], b[1]].map(|x| (1e6 * x).round() as i64)
                })
                .collect();
            ends.sort_unstable();
            ends
        };
        assert_eq!(lengths(&found), lengths(&written), "{kind:?}");
    }
}

/// The `text` of a mesh with further `elements`: number of the kind in Gmsh, and nodes of each.
fn with_elements(text: &str, elements: &[(usize, &[usize])]) -> String {
    let (before, after) = text.split_once("$Elements\n").unwrap();
    let (header, rest) = after.split_once('\n').unwrap();
    let cells: usize = header.split(' ').nth(1).unwrap().parse().unwrap();
    let all = cells + elements.len();
    let mut blocks = String::new();
    for (k, (kind, nodes)) in elements.iter().enumerate() {
        let tags: Vec<String> = nodes.iter().map(|node| (node + 11).to_string()).collect();
        let tag = cells + 1 + k;
        let _ = write!(blocks, "2 1 {kind} 1\n{tag} {}\n", tags.join(" "));
    }
    let count = 1 + elements.len();
    let rest = rest.replace("$EndElements", &format!("{blocks}$EndElements"));
    format!("{before}$Elements\n{count} {all} 1 {all}\n{rest}")
}

#[test]
fn cells_of_other_kinds_are_refused_by_kind_and_count() {
    let written = text(&sector(ElementKind::Q4), 1.0);
    let cubic: Vec<usize> = (0..10).collect();
    let others: [(usize, &[usize]); 3] = [(21, &cubic), (4, &cubic[..4]), (21, &cubic)];
    let Err(ExperimentError::Missing { key, what, .. }) =
        read(&with_elements(&written, &others), 1.0)
    else {
        panic!("cubic triangles and tetrahedra are not read");
    };
    assert_eq!(key, "region.mesh");
    for count in ["1 of Gmsh's kind Tet4", "2 of Gmsh's kind Tri10"] {
        assert!(what.contains(count), "{what}");
    }
}

#[test]
fn points_and_lines_that_mark_corners_and_edges_are_passed_over() {
    let mesh = sector(ElementKind::Q4);
    let marks: [(usize, &[usize]); 3] = [(15, &[0]), (1, &[0, 1]), (26, &[0, 1, 2, 3])];
    let found = read(&with_elements(&text(&mesh, 1.0), &marks), 1.0).unwrap();
    assert_eq!(found.element_count(), mesh.element_count());
}

#[test]
fn what_is_no_mesh_of_the_hole_is_refused() {
    let written = text(&sector(ElementKind::Q4), 1.0);
    assert!(matches!(
        read("no mesh", 1.0),
        Err(ExperimentError::File { .. })
    ));
    let half = &written[..written.len() / 2];
    assert!(matches!(read(half, 1.0), Err(ExperimentError::File { .. })));
    // Inches taken for millimetres.
    let Err(ExperimentError::Missing { what, .. }) = read(&written, 1.0 / 25.4) else {
        panic!("no edge is on the hole");
    };
    assert!(what.contains("off its edge"), "{what}");
    let empty = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    assert!(matches!(
        read(empty, 1.0),
        Err(ExperimentError::Missing { .. })
    ));
}
