//! A row of fasteners as a pattern, beside the row written out.

use stickslip::results::{EdgeRow, Results};

use super::solved;

const FIVE: &str = include_str!("../../../../scenes/fasteners-five.toml");

/// What of the row is a pattern.
const PATTERN: &str = r#"
[bodies.plate.shape.outline.holes.hole]
centre = ["0 mm", "0 mm"]
radius = "3 mm"
pattern = { columns = 5, pitch = ["24 mm", "0 mm"] }
[bodies.bolt]
material = "steel"
thickness = "3 mm"
shape.disk.radius = "2.985 mm"
pattern.columns = 5
[bodies.bolt_1_2]
shape.disk.radius = "2.99 mm"
[bodies.bolt_1_3]
shape.disk.radius = "2.98 mm"
[bodies.bolt_1_4]
shape.disk.radius = "2.99 mm"
[[contacts]]
first = "plate.hole"
second = "bolt.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "bolt.section"
fix = ["x", "y"]
"#;

/// All numbers of all edges as bits.
fn bits(results: &Results) -> Vec<u64> {
    let edges = results.steps.iter().flat_map(|step| &step.edges);
    let of_row = |row: &EdgeRow| {
        let stresses = [row.sigma_normal, row.sigma_tangential, row.tau];
        [row.pressure, row.shear, row.gap, row.slip]
            .into_iter()
            .chain(stresses)
    };
    let numbers = edges.flat_map(|edge| edge.rows.iter().flat_map(of_row).chain(edge.resultant));
    numbers.map(f64::to_bits).collect()
}

#[test]
fn a_pattern_has_the_results_of_the_row_written_out_bit_for_bit() {
    let from = FIVE.find("[bodies.plate.shape.outline.holes]").unwrap();
    let to = FIVE.find("[mesh]").unwrap();
    let [contacts, loads] = ["[[contacts]]", "[[loads]]"].map(|part| FIVE.find(part).unwrap());
    let pattern = format!(
        "{}{PATTERN}{}{}",
        &FIVE[..from],
        &FIVE[to..contacts],
        &FIVE[loads..]
    );
    let coarse = [r#"mesh.spacing="6 deg""#];
    let [own, out] = [pattern.as_str(), FIVE].map(|text| solved(text, &coarse));
    assert_eq!(own.edges.len(), 5);
    assert_eq!(own.edges[1].name, "bolt_1_2");
    assert!(bits(&own) == bits(&out));
}
