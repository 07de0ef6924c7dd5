//! Friction from the sample table of `stickslip init experiment`, which was computed with a dynamic coefficient of 0.25.

use super::{folder_with, succeeds};

#[test]
fn the_mesh_and_the_order_of_smoothing_do_not_decide_the_coefficient() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    for (order, cells) in [(2, "[30, 8]"), (2, "[60, 14]"), (3, "[80, 18]")] {
        let sector = format!(
            "region.sector={{ angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = {cells}, growth = 2.0 }}"
        );
        let smoothing = format!("region.smoothing={{ order = {order} }}");
        let arguments = [
            "identify",
            "mine.toml",
            "--force",
            "--set",
            &sector,
            "--set",
            &smoothing,
        ];
        let summary = succeeds(path, &arguments);
        let friction = &summary["friction"];
        let number = |name: &str| friction["mu_dynamic"][name].as_f64().unwrap();
        let [low, mu, high] = ["low", "best", "high"].map(number);
        println!("{cells}, order {order}: {low:.4} {mu:.4} {high:.4}");
        assert!(low < 0.25 && 0.25 < high, "{friction}");
        assert!((mu - 0.25).abs() < 0.02, "{friction}");
        let coarser = &friction["half_the_cells"];
        assert_eq!(coarser["cells"].as_array().unwrap().len(), 2, "{friction}");
        if let Some(coarse) = coarser["mu_dynamic"]["best"].as_f64() {
            assert!((coarse - mu).abs() < 0.5 * (high - low), "{friction}");
        }
    }
}

/// Noise that hides the pressure does not make an edge free.
#[test]
fn a_pressure_within_its_uncertainty_is_not_identifiable_rather_than_none() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let sector = "region.sector={ angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [40, 10], growth = 2.0 }";
    let arguments = [
        "identify",
        "mine.toml",
        "--set",
        sector,
        "--set",
        "states.0.table.deviation=20 um",
    ];
    let summary = succeeds(path, &arguments);
    let words = summary["friction"]["mu_static"]["in_words"].as_str();
    assert!(words.unwrap().starts_with("not identifiable"), "{summary}");
    let page = std::fs::read_to_string(path.join("mine-results/index.html")).unwrap();
    assert!(
        page.contains("no pressure on the edge exceeds its uncertainty"),
        "{page}"
    );
    assert!(!page.contains("no contact"), "{page}");
}
