//! A region from a mesh of Gmsh against the sector of the same cells.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use super::{fails, folder_with, numbers, succeeds};

const RADIUS: f64 = 9.525;
const OUTER: f64 = 13.0;
const ANGLES: [f64; 2] = [-10.0, 110.0];
const CELLS: [usize; 2] = [24, 6];

/// Text of a mesh in Gmsh's format 4.1: quadrilaterals of eight nodes between two radii, the hole and an arc of radius `outer` mm, in units of
/// `unit` mm.
fn polar(unit: f64, outer: f64) -> String {
    // Twice as fine a grid, without the middles of cells.
    let [around, outwards] = CELLS.map(|cells| 2 * cells);
    let mut tags = vec![vec![None; outwards + 1]; around + 1];
    let (mut names, mut places, mut count) = (String::new(), String::new(), 0);
    for (i, column) in tags.iter_mut().enumerate() {
        for (j, tag) in column.iter_mut().enumerate() {
            if i % 2 == 1 && j % 2 == 1 {
                continue;
            }
            count += 1;
            *tag = Some(count);
            let part = |k: usize, all: usize| k as f64 / all as f64;
            let theta = ANGLES[0] + (ANGLES[1] - ANGLES[0]) * part(i, around);
            let r = RADIUS + (outer - RADIUS) * part(j, outwards);
            let (sin, cos) = theta.to_radians().sin_cos();
            writeln!(names, "{count}").unwrap();
            writeln!(places, "{} {} 0", r * cos / unit, r * sin / unit).unwrap();
        }
    }
    let mut cells = String::new();
    for i in (0..around).step_by(2) {
        for j in (0..outwards).step_by(2) {
            let corners = [[0, 0], [0, 2], [2, 2], [2, 0]];
            let middles = [[0, 1], [1, 2], [2, 1], [1, 0]];
            let nodes = corners.iter().chain(&middles);
            let nodes: Vec<String> = nodes
                .map(|[di, dj]| tags[i + di][j + dj].unwrap().to_string())
                .collect();
            let cell = cells.lines().count() + 1;
            writeln!(cells, "{cell} {}", nodes.join(" ")).unwrap();
        }
    }
    let all = CELLS[0] * CELLS[1];
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n{names}{places}$EndNodes\n\
         $Elements\n1 {all} 1 {all}\n2 1 16 {all}\n{cells}$EndElements\n"
    )
}

/// Rows of the edge's table in the order of their angles.
fn edge(folder: &Path, output: &str) -> Vec<Vec<f64>> {
    let mut rows = numbers(&folder.join(output).join("edge-up.csv"));
    rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
    rows
}

#[test]
fn a_mesh_of_gmsh_gives_the_stresses_of_the_sector_of_the_same_cells() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let hybrid = |output: &str, region: &str| {
        let region = format!("region={region}");
        let arguments = ["hybrid", "mine.toml", "--output", output, "--set", &region];
        succeeds(path, &arguments)
    };
    let [around, outwards] = CELLS;
    let sector = format!(
        "{{ sector = {{ angles = [\"{} deg\", \"{} deg\"], outer = \"{OUTER} mm\", cells = [{around}, {outwards}] }} }}",
        ANGLES[0], ANGLES[1]
    );
    hybrid("sector", &sector);
    fs::write(path.join("region.msh"), polar(10.0, OUTER)).unwrap();
    let mesh = "{ mesh = { file = \"region.msh\", scale = \"1 cm\" } }";
    let summary = hybrid("mesh", mesh);
    assert_eq!(summary["edge_stresses"][0]["contact"], true, "{summary}");
    let (own, other) = (edge(path, "mesh"), edge(path, "sector"));
    assert_eq!(own.len(), other.len());
    let largest = |column: usize| {
        let values = other.iter().map(|row| row[column].abs());
        values.fold(0.0, f64::max)
    };
    // Pressure, shear and hoop stress with their standard deviations and biases. The cells are the same and their nodes numbered otherwise,
    // so that only rounding differs: 1e-16 in coordinates, times a condition number of 1e6 or so of the system behind the stresses.
    for column in 1..=9 {
        for (own, other) in own.iter().zip(&other) {
            let difference = (own[column] - other[column]).abs();
            assert!(
                (own[0] - other[0]).abs() < 1e-9 && difference < 1e-9 * largest(column),
                "column {column}: {own:?} {other:?}"
            );
        }
    }
}

#[test]
fn a_mesh_that_reaches_beyond_the_data_is_refused_by_every_method_with_the_place() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    fs::write(path.join("region.msh"), polar(10.0, 5.0 * OUTER)).unwrap();
    for method in ["fit", "linear", "polynomial"] {
        let method = format!("reduce.method=\"{method}\"");
        let text = fails(
            path,
            &[
                "hybrid",
                "mine.toml",
                "--set",
                "region={ mesh = { file = \"region.msh\", scale = \"1 cm\" } }",
                "--set",
                &method,
            ],
        );
        for part in ["do not cover the region", "the first at (", "θ ="] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}

#[test]
fn headers_with_other_sizes_of_numbers_are_refused() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let mesh = "region={ mesh = { file = \"region.msh\", scale = \"1 mm\" } }";
    let endless = "9".repeat(80);
    for header in [
        format!("4.1 0 {endless}"),
        "4.1 1 3\n\u{1}\0\0\0".to_owned(),
    ] {
        let text = polar(1.0, OUTER).replacen("4.1 0 8", &header, 1);
        fs::write(path.join("region.msh"), text).unwrap();
        let error = fails(path, &["hybrid", "mine.toml", "--set", mesh]);
        assert!(error.contains("not a mesh in Gmsh's format 4.1"), "{error}");
    }
}
