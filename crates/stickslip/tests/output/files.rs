//! The result folder: which files there are, and that each can be read.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::keep::{self, KeepError};
use stickslip::output::OutputError;
use stickslip::results::Results;
use tempfile::TempDir;

use super::fixture::{LOADS, RADIUS, open_hole, results};

/// Writes `results` into a new folder.
pub(crate) fn written(results: &Results, figures: bool) -> (TempDir, PathBuf) {
    let place = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(&place.path().join("run"), Overwrite::Refuse).unwrap();
    let path = keep::results(results, folder, figures).unwrap();
    (place, path)
}

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

fn table(path: &Path) -> (Vec<String>, Vec<Vec<String>>) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let header = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    let rows = reader
        .records()
        .map(|row| row.unwrap().iter().map(str::to_owned).collect());
    (header, rows.collect())
}

#[test]
fn a_folder_holds_every_kind_of_file() {
    let (_place, folder) = written(&results(), true);
    let found = names(&folder);
    for name in [
        "summary.json",
        "report.html",
        "steps.csv",
        "results.pvd",
        "fields",
        "figures",
    ] {
        assert!(found.contains(name), "{name} is not among {found:?}");
    }
    for edge in ["pin", "roller", "plate.left"] {
        for step in 1..=LOADS.len() {
            assert!(found.contains(&format!("edge-{edge}-step-0{step}.csv")));
        }
    }
    assert_eq!(
        names(&folder.join("fields")),
        BTreeSet::from(["plate-step-04.vtu".to_owned()])
    );
    let figures = names(&folder.join("figures"));
    let expected = [
        "stresses-pin",
        "pressure-pin",
        "shear-pin",
        "hoop-pin",
        "map-pin",
        "extent-pin",
        "friction-pin",
        "stresses-roller",
        "map-roller",
        "stresses-plate.left",
        "hoop-plate.left",
        "field-von-mises-step-04",
        "field-normal-stress-step-04",
    ];
    for name in expected {
        assert!(
            figures.contains(&format!("{name}.svg")),
            "{name} is not among {figures:?}"
        );
        assert!(figures.contains(&format!("{name}.png")));
    }
    assert!(
        !figures.contains("pressure-plate.left.svg"),
        "there is no contact on it"
    );
}

#[test]
fn an_edge_table_has_units_in_its_header_and_a_row_per_node() {
    let (_place, folder) = written(&results(), false);
    let (header, rows) = table(&folder.join("edge-pin-step-03.csv"));
    assert_eq!(
        header,
        [
            "theta [deg]",
            "CPRESS [psi]",
            "CSHEAR1 [psi]",
            "COPEN [in]",
            "CSLIP1 [in]",
            "CSTATUS",
            "sigma_r [psi]",
            "sigma_theta [psi]",
            "tau_rtheta [psi]",
        ]
    );
    assert_eq!(rows.len(), 37);
    assert_eq!(rows[0][5], "stick");
    assert_eq!(rows[36][0], "180");
    assert_eq!(rows[36][5], "open");
    // 100 MPa; 1 psi = 4.4482216152605 N / (25.4 mm)². Twelve digits are written.
    let pressure: f64 = rows[0][1].parse().unwrap();
    let exact = 100.0 * 25.4 * 25.4 / 4.448_221_615_260_5;
    assert!((pressure / exact - 1.0).abs() < 1e-11, "{pressure}");
    let (header, rows) = table(&folder.join("edge-plate.left-step-01.csv"));
    assert_eq!(
        header,
        ["x [in]", "sigma_yy [psi]", "sigma_xx [psi]", "tau_xy [psi]"]
    );
    let first: f64 = rows[0][0].parse().unwrap();
    assert!((first + 5.0 / 25.4).abs() < 1e-11);
}

#[test]
fn the_table_of_steps_has_a_number_in_every_cell() {
    let (_place, folder) = written(&results(), false);
    let (header, rows) = table(&folder.join("steps.csv"));
    assert_eq!(
        header[..3],
        ["step", "load pull [lbf]", "load cool, slowly [K]"]
    );
    assert!(
        header.contains(&"contact_half_angle [deg]".to_owned()),
        "{header:?}"
    );
    assert!(
        header.contains(&"roller: contact_half_width [in]".to_owned()),
        "{header:?}"
    );
    assert_eq!(rows.len(), LOADS.len());
    for cell in rows.iter().flatten() {
        assert!(cell.parse::<f64>().is_ok_and(f64::is_finite), "'{cell}'");
    }
}

#[test]
fn field_files_are_xml_in_display_units() {
    let (_place, folder) = written(&results(), false);
    let text = fs::read_to_string(folder.join("fields/plate-step-04.vtu")).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let arrays: Vec<&str> = document
        .descendants()
        .filter_map(|node| node.attribute("Name"))
        .collect();
    for name in [
        "displacement [in]",
        "stress_xx [psi]",
        "von_mises [psi]",
        "sigma_theta [psi]",
    ] {
        assert!(arrays.contains(&name), "{arrays:?}");
    }
    let collection = fs::read_to_string(folder.join("results.pvd")).unwrap();
    let collection = roxmltree::Document::parse(&collection).unwrap();
    let set = collection
        .descendants()
        .find(|node| node.has_tag_name("DataSet"))
        .unwrap();
    assert_eq!(set.attribute("timestep"), Some("4"));
    assert_eq!(set.attribute("file"), Some("fields/plate-step-04.vtu"));
    // The outer radius is 4 R = 40 mm, and u_x = 10⁻³ x there.
    let largest = |name: &str| values(&document, name).into_iter().fold(0.0, f64::max);
    assert!((largest("Points") - 4.0 * RADIUS / 25.4).abs() < 1e-12);
    assert!((largest("displacement [in]") - 4e-3 * RADIUS / 25.4).abs() < 1e-15);
    // 100 MPa in psi; two roundings.
    let stress = 100.0 * 25.4 * 25.4 / 4.448_221_615_260_5;
    assert!((largest("stress_xx [psi]") / stress - 1.0).abs() < 1e-15);
    assert!((largest("von_mises [psi]") / stress - 1.0).abs() < 1e-15);
}

/// The numbers of array `name`: base64 of a byte count of 8 bytes and little-endian doubles.
fn values(document: &roxmltree::Document<'_>, name: &str) -> Vec<f64> {
    let array = document
        .descendants()
        .find(|node| node.attribute("Name") == Some(name))
        .unwrap();
    let digit = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let text = array.text().unwrap().trim().trim_end_matches('=');
    let mut bits = 0_u32;
    let mut count = 0;
    let mut bytes = Vec::new();
    for c in text.bytes() {
        bits = bits << 6 | u32::from(digit(c));
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes[8..]
        .chunks_exact(8)
        .map(|b| f64::from_le_bytes(b.try_into().unwrap()))
        .collect()
}

#[test]
fn figures_are_pictures_without_nan() {
    let (_place, folder) = written(&results(), true);
    for name in names(&folder.join("figures")) {
        let bytes = fs::read(folder.join("figures").join(&name)).unwrap();
        if Path::new(&name)
            .extension()
            .is_some_and(|ending| ending == "png")
        {
            assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n", "{name}");
            continue;
        }
        let text = String::from_utf8(bytes).unwrap();
        let picture = roxmltree::Document::parse(&text).unwrap();
        // Letters of an image inside mean nothing.
        let attributes = (picture.descendants())
            .flat_map(|part| part.attributes())
            .filter(|attribute| attribute.name() != "href")
            .map(|attribute| attribute.value());
        let words = picture.descendants().filter_map(|part| part.text());
        for text in attributes.chain(words) {
            assert!(
                !text.contains("NaN") && !text.contains("inf"),
                "{name}: {text}"
            );
        }
    }
}

#[test]
fn without_figures_there_are_none() {
    let (_place, folder) = written(&results(), false);
    assert!(!folder.join("figures").exists());
    assert!(
        !fs::read_to_string(folder.join("report.html"))
            .unwrap()
            .contains("<svg")
    );
}

#[test]
fn one_step_of_an_open_hole_gives_its_hoop_stress_alone() {
    let (_place, folder) = written(&open_hole(), true);
    let figures = names(&folder.join("figures"));
    assert_eq!(
        figures,
        BTreeSet::from([
            "sketch.png".to_owned(),
            "sketch.svg".to_owned(),
            "stresses-plate.hole.png".to_owned(),
            "stresses-plate.hole.svg".to_owned()
        ])
    );
    // 72 nodes, and the first one again at +180°.
    let text = fs::read_to_string(folder.join("figures/stresses-plate.hole.svg")).unwrap();
    assert!(text.contains("σ_θ") && !text.contains("τ_rθ"));
}

#[test]
fn a_figure_that_cannot_be_drawn_costs_no_results() {
    let mut results = results();
    for step in &mut results.steps {
        for row in &mut step.edges[2].rows {
            row.sigma_tangential = f64::NAN;
        }
    }
    let (_place, folder) = written(&results, true);
    let summary = fs::read_to_string(folder.join("summary.json")).unwrap();
    assert!(
        summary.contains("The figure 'hoop-plate.left' could not be drawn"),
        "{summary}"
    );
    assert!(
        fs::read_to_string(folder.join("report.html"))
            .unwrap()
            .contains("hoop-plate.left")
    );
    let (_, rows) = table(&folder.join("edge-plate.left-step-01.csv"));
    assert_eq!(rows[0][2], "");
}

#[test]
fn results_that_do_not_fit_together_are_refused_and_leave_nothing() {
    let mut results = results();
    results.steps[1].edges[0].rows.pop();
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("run");
    let folder = ResultFolder::create(&path, Overwrite::Refuse).unwrap();
    let error = keep::results(&results, folder, true).unwrap_err();
    assert!(matches!(
        &error,
        KeepError::Results(OutputError::Inconsistent {
            found: 36,
            expected: 37,
            ..
        })
    ));
    assert!(error.to_string().contains("step 2, edge 'pin': rows"));
    assert!(names(place.path()).is_empty());

    let mut results = super::fixture::results();
    results.steps[3].fields[0].body = 0;
    let folder = ResultFolder::create(&path, Overwrite::Refuse).unwrap();
    let error = keep::results(&results, folder, true).unwrap_err();
    assert!(matches!(
        error,
        KeepError::Results(OutputError::NoBody { step: 4, body: 0 })
    ));
}

#[test]
fn equal_results_give_equal_bytes() {
    let (_first_place, first) = written(&results(), true);
    let (_second_place, second) = written(&results(), true);
    for name in [
        "summary.json",
        "report.html",
        "steps.csv",
        "figures/map-pin.svg",
    ] {
        assert_eq!(
            fs::read(first.join(name)).unwrap(),
            fs::read(second.join(name)).unwrap(),
            "{name}"
        );
    }
}

/// A press fit without a pull has pressures, but no bearing stress to compare them with.
#[test]
fn pressures_without_a_bearing_stress_are_drawn_all_the_same() {
    let mut results = results();
    for step in &mut results.steps {
        for edge in &mut step.edges {
            edge.resultant = [0.0; 2];
        }
    }
    let (_place, folder) = written(&results, true);
    let figures = names(&folder.join("figures"));
    for name in ["pressure-pin.svg", "extent-pin.svg"] {
        assert!(figures.contains(name), "{name} is not among {figures:?}");
    }
}
