//! Compliances in blocks: the answers of one matrix, within the error that is stated.

use stickslip::model::Model;
use stickslip::results::Results;

use super::{difference, model, scene, solved, tractions};

const FIVE: &str = include_str!("../../../../scenes/fasteners-five.toml");
const COARSE: &str = r#"mesh.spacing="6 deg""#;
const MATRIX: &str = r#"analysis.compliance="matrix""#;
const BLOCKS: &str = r#"analysis.compliance="blocks""#;

#[test]
fn blocks_agree_with_one_matrix_within_the_stated_error() {
    for friction in ["0", "0.2", "0.6"] {
        let changes: Vec<String> = (0..5)
            .map(|k| format!("contacts.{k}.friction.coulomb.mu={friction}"))
            .collect();
        let by = |compliance| {
            let own = changes.iter().map(String::as_str);
            let all: Vec<&str> = own.chain([COARSE, compliance]).collect();
            solved(FIVE, &all)
        };
        let (matrix, blocks) = (by(MATRIX), by(BLOCKS));
        let error = blocks.blocks.unwrap().tractions;
        assert!(error < 1e-8, "{error:.1e}");
        let all = |results: &Results| -> Vec<f64> {
            let edges = results.steps.iter().flat_map(|step| &step.edges);
            edges.flat_map(|edge| tractions(&edge.rows)).collect()
        };
        let apart = difference(all(&matrix), all(&blocks));
        // The stated error is of the step with the largest displacement that is left out, to four digits; rounding of either answer adds
        // 1e-13 of motions, which contact multiplies by the stiffness of single nodes.
        assert!(
            apart < 2.0 * error + 1e-9,
            "{friction}: {apart:.1e}, stated {error:.1e}"
        );
        assert_eq!(matrix.choices.len() + 1, blocks.choices.len());
        assert!(matrix.blocks.is_none());
    }
}

#[test]
fn one_matrix_is_held_up_to_its_size() {
    let ends = |changes: &[&str]| -> Vec<usize> {
        let model = model(FIVE, changes);
        let plate = model.bodies.iter().find(|body| body.name == "plate");
        plate.unwrap().ends.clone()
    };
    assert!(ends(&[COARSE]).is_empty());
    assert_eq!(ends(&[COARSE, BLOCKS]), [120, 240, 360, 480, 600]);
    // Five holes of 480 nodes have 4800 components.
    assert_eq!(ends(&[r#"mesh.spacing="1.5 deg""#]).len(), 5);
    assert!(ends(&[r#"mesh.spacing="1.5 deg""#, MATRIX]).is_empty());
    let solver = r#"analysis.solver="pivoting""#;
    assert!(ends(&[r#"mesh.spacing="1.5 deg""#, solver]).is_empty());
}

#[test]
fn blocks_are_refused_where_they_cannot_be_had() {
    let refused = |changes: &[&str]| {
        let changes: Vec<&str> = changes.iter().copied().chain([COARSE, BLOCKS]).collect();
        Model::build(&scene(FIVE, &changes))
            .unwrap_err()
            .to_string()
    };
    let solver = refused(&[r#"analysis.solver="pivoting""#]);
    assert!(
        solver.contains("solver = \"pivoting\" works on one matrix"),
        "{solver}"
    );
    let gaps = refused(&[r#"analysis.kinematics="deformed-gaps""#]);
    assert!(gaps.contains("deformed-gaps"), "{gaps}");
    for message in [solver, gaps] {
        assert!(message.contains("compliance = \"matrix\""), "{message}");
    }
}
