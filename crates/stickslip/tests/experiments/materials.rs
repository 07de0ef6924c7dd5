//! One material in three grammars: isotropic, orthotropic, laminate.

use std::path::Path;

use super::{folder_with, numbers, succeeds};

/// Young's modulus of the template's aluminium \[GPa\], and Poisson's ratio.
const ALUMINIUM: [f64; 2] = [71.7, 0.33];

/// Young's modulus \[GPa\] and Poisson's ratio of a quasi-isotropic stack of plies: mean stiffness over all angles (Tsai & Pagano 1968).
fn quasi_isotropic([e1, e2, g12, nu12]: [f64; 4]) -> [f64; 2] {
    let part = 1.0 - nu12 * nu12 * e2 / e1;
    let [q11, q22, q12] = [e1 / part, e2 / part, nu12 * e2 / part];
    let along = (3.0 * q11 + 3.0 * q22 + 2.0 * q12 + 4.0 * g12) / 8.0;
    let across = (q11 + q22 + 6.0 * q12 - 4.0 * g12) / 8.0;
    [(along * along - across * across) / along, across / along]
}

fn isotropic([young, poisson]: [f64; 2]) -> String {
    format!("material.isotropic = {{ young = \"{young} GPa\", poisson = {poisson} }}")
}

/// The same with three planes of symmetry, turned by some angle that must not matter.
fn orthotropic([young, poisson]: [f64; 2], angle: f64) -> String {
    let shear = young / (2.0 * (1.0 + poisson));
    format!(
        "material.orthotropic = {{ e1 = \"{young} GPa\", e2 = \"{young} GPa\", g12 = \"{shear} GPa\", nu12 = {poisson}, angle = \"{angle} deg\" }}"
    )
}

/// Rows of the edge's table of the template's sample with this material.
fn edge(path: &Path, name: &str, material: &str, more: &str) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(path.join("mine.toml")).unwrap();
    let before = isotropic(ALUMINIUM);
    assert!(text.contains(&before));
    let text = text.replace(&before, material).replace(
        "[reduce]",
        "[region]\nsector = { angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [24, 6], growth = 2.0 }\n[reduce]",
    );
    let file = format!("{name}.toml");
    std::fs::write(path.join(&file), text + more).unwrap();
    succeeds(path, &["hybrid", &file, "--output", name]);
    numbers(&path.join(name).join("edge-up.csv"))
}

/// Largest difference of any number of two tables, over the largest number of its column.
fn difference(one: &[Vec<f64>], other: &[Vec<f64>]) -> f64 {
    assert!(one.len() == other.len() && one.len() > 20);
    let mut most = 0.0_f64;
    for column in 0..one[0].len() {
        let largest = one.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for (a, b) in one.iter().zip(other) {
            assert_eq!(a[column].is_nan(), b[column].is_nan());
            if a[column].is_finite() {
                most = most.max((a[column] - b[column]).abs() / largest);
            }
        }
    }
    most
}

#[test]
fn edge_stresses_are_those_of_the_same_material_in_another_grammar() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let plain = edge(path, "isotropic", &isotropic(ALUMINIUM), "");
    let turned = edge(path, "orthotropic", &orthotropic(ALUMINIUM, 30.0), "");
    let first = difference(&plain, &turned);

    let ply = [140.0, 10.0, 5.0, 0.3];
    // Twelve plies of 0.127 mm are as thick as the template's plate.
    let plies = "[plies.carbon]\ne1 = \"140 GPa\"\ne2 = \"10 GPa\"\ng12 = \"5 GPa\"\nnu12 = 0.3\nthickness = \"0.127 mm\"\n";
    let stack = "material.laminate = { layup = \"[0_2/60_2/-60_2]s\", ply = \"carbon\" }";
    let laminate = edge(path, "laminate", stack, plies);
    let moduli = edge(path, "moduli", &orthotropic(quasi_isotropic(ply), 0.0), "");
    let second = difference(&laminate, &moduli);
    println!(
        "orthotropic against isotropic: {first:.1e}; laminate against its moduli: {second:.1e}"
    );
    assert!(first < 1e-8 && second < 1e-8, "{first} {second}");
    // The two materials are not alike, or all of this would say nothing.
    assert!(difference(&plain, &moduli) > 0.05);
}
