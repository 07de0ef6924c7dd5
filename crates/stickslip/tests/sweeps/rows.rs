//! Cases, rows, and tables that are read again.

use stickslip::host::HOST;
use stickslip::sweep::row::Outcome;
use stickslip::sweep::{Sweep, SweepError, figures, findings, table, verdict, warning};

use super::{COARSE, SWEEP, folder_with, read, scenes, solved};

/// A pin in a strip, without a mesh.
const PIN: &str = r#"
version = 1
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "steel"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "4 mm"
outline.strip = { half_width = "20 mm", left = "40 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "2 mm"
shape.disk = { radius = "3.99 mm" }
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["4 kN"] }
"#;

#[test]
fn cases_are_the_full_product() {
    let sweep = read(&folder_with(SWEEP));
    assert_eq!(sweep.cases(), 6);
    assert_eq!(sweep.values_of(3), [1, 1]);
    assert_eq!(sweep.name_of(3), "e/D = 4, μ = 0.3");
    // D is 6 mm.
    let resolved = sweep.scene_of(4).unwrap().resolved().to_owned();
    assert!(resolved.contains("right = \"30 mm\""), "{resolved}");
    assert!(resolved.contains("mu = 0"), "{resolved}");
}

#[test]
fn ratios_are_those_of_the_hole_of_the_case() {
    let text = SWEEP.replace(
        "\"mu\"",
        "\"bodies.plate.shape.plate_with_hole.hole_radius\"",
    );
    let text = text.replace("[0, 0.3]", "[\"3 mm\", \"4 mm\"]");
    let sweep = read(&folder_with(&format!(
        "{text}[[axes]]\nkey = \"clearance\"\nvalues = [\"0.02 mm\"]\n[[axes]]\nkey = \"w_over_d\"\nvalues = [4]\n"
    )));
    let resolved = sweep.scene_of(1).unwrap().resolved().to_owned();
    assert!(resolved.contains("right = \"16 mm\""), "{resolved}");
    assert!(resolved.contains("half_width = \"16 mm\""), "{resolved}");
    assert!(resolved.contains("radius = \"3.98 mm\""), "{resolved}");
}

#[test]
fn a_table_is_read_again_as_it_was_written() {
    let sweep = read(&folder_with(SWEEP));
    let rows = solved(&sweep, &[0, 1, 2, 3, 4, 5]);
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    let again = table::read(&sweep, &text).unwrap();
    assert_eq!(again.len(), 6);
    for (row, again) in rows.iter().zip(&again) {
        assert_eq!((row.case, &row.outcome), (again.case, &again.outcome));
    }
    // Killed in the middle of the last row.
    let torn = &text[..text.len() - 20];
    assert_eq!(table::read(&sweep, torn).unwrap().len(), 5);
    assert!(table::read(&sweep, "").unwrap().is_empty());
}

#[test]
fn rows_keep_the_kinds_of_findings() {
    let folder = folder_with(SWEEP);
    let penalty = ["analysis.solver=penalty", "analysis.experimental=true"];
    let overrides = [COARSE, penalty[0], penalty[1]];
    let sweep = Sweep::from_file(&folder.path().join("sweep.toml"), &overrides, HOST).unwrap();
    let rows = solved(&sweep, &[0, 1]);
    assert_eq!(findings(&rows)["unverified"], 2);
    let warning = warning(&rows).unwrap();
    for part in ["Findings in 2 of 2 cases: ", "unverified 2", "cases.csv"] {
        assert!(warning.contains(part), "{warning}");
    }
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    assert!(text.lines().next().unwrap().ends_with(",outcome,findings"));
    let again = table::read(&sweep, &text).unwrap();
    assert_eq!(again[1].outcome, rows[1].outcome);
}

#[test]
fn a_table_without_findings_is_read() {
    let sweep = read(&folder_with(SWEEP));
    let mut rows = solved(&sweep, &[0, 1]);
    let Outcome::Solved(measures) = &mut rows[1].outcome else {
        panic!("{rows:?}");
    };
    measures.findings = Some(Vec::new());
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    assert!(text.ends_with(",solved,none\n"), "{text}");
    assert_eq!(
        table::read(&sweep, &text).unwrap()[1].outcome,
        rows[1].outcome
    );
    let lines = text.lines().filter_map(|line| line.rsplit_once(','));
    let old: String = lines.flat_map(|(line, _)| [line, "\n"]).collect();
    let old = table::read(&sweep, &old).unwrap();
    let known: Vec<bool> = (old.iter())
        .map(|row| row.measures().unwrap().findings.is_some())
        .collect();
    assert_eq!(known, [false, false]);
    assert!(findings(&old).is_empty() && warning(&old).is_none());
}

/// Cases without a mesh find their own models, with an error of each number.
#[test]
fn numbers_without_a_mesh_have_their_errors() {
    let folder = folder_with(&SWEEP.replace("[2, 4, 5]", "[4, 5]"));
    let path = folder.path().join("joint.toml");
    std::fs::write(&path, PIN).unwrap();
    let file = folder.path().join("sweep.toml");
    let sweep = Sweep::from_file(&file, &[] as &[&str], HOST).unwrap();
    assert!(sweep.states_errors());
    let rows = solved(&sweep, &[0, 1, 2, 3]);
    for row in &rows {
        let measures = row.measures().unwrap();
        let (pressure, errors) = (measures.peak_pressure.unwrap(), measures.errors);
        assert!(errors.peak_pressure.unwrap() < 0.01 * pressure);
        let extent = measures.contact_half_angle.unwrap();
        assert!(errors.contact_half_angle.unwrap() < 0.01 * extent);
        assert!(errors.peak_hoop.is_some() && errors.peak_hoop_angle.is_some());
    }
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    let head = text.lines().next().unwrap();
    for name in [
        "peak_pressure [MPa],peak_pressure_error [MPa]",
        "contact_half_angle [deg],contact_half_angle_error [deg]",
        "peak_hoop [MPa],peak_hoop_error [MPa]",
        "peak_hoop_angle [deg],peak_hoop_angle_error [deg]",
        "first_ply_load [N],first_ply_load_error [N]",
        "joint_load [N],joint_load_error [N]",
    ] {
        assert!(head.contains(name), "{head}");
    }
    let again = table::read(&sweep, &text).unwrap();
    for (row, again) in rows.iter().zip(&again) {
        assert_eq!((row.case, &row.outcome), (again.case, &again.outcome));
    }
    // |F| / (D t) of 4 kN on 8 mm × 2 mm.
    let bearing = rows[0].measures().unwrap().bearing_stress.unwrap();
    assert!((bearing - 250.0).abs() < 1e-6, "{bearing}");
    let (drawings, remarks) = figures::draw(&sweep, &rows);
    let names: Vec<&str> = drawings.iter().map(|own| own.name.as_str()).collect();
    for what in ["pressure", "hoop", "extent", "stick"] {
        for axis in 1..=2 {
            let name = format!("{what}-over-axis-{axis}");
            assert!(names.contains(&name.as_str()), "{name} in {names:?}");
        }
    }
    assert!(remarks.is_empty(), "{remarks:?}");
    let verdict = verdict(&sweep, &rows);
    assert!(
        verdict.starts_with("The largest pressure lies between "),
        "{verdict}"
    );
    // With a mesh there are none.
    let meshed = Sweep::from_file(&file, &["mesh.spacing=6 deg"], HOST).unwrap();
    assert!(!meshed.states_errors());
    assert!(!table::headings(&meshed).join(",").contains("_error"));
}

#[test]
fn a_table_of_another_sweep_is_refused() {
    let sweep = read(&folder_with(SWEEP));
    let rows = solved(&sweep, &[0]);
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    let other = read(&folder_with(&SWEEP.replace("[2, 4, 5]", "[3, 4, 5]")));
    let error = table::read(&other, &text).unwrap_err();
    assert!(matches!(error, SweepError::Other { .. }), "{error}");
    assert!(
        error
            .to_string()
            .contains("case 0 has e_over_d = 2, here it is 3"),
        "{error}"
    );
    let other = read(&folder_with(&SWEEP.replace("e_over_d", "w_over_d")));
    assert!(matches!(
        table::read(&other, &text),
        Err(SweepError::Other { .. })
    ));
    let broken = text.replace("solved", "");
    let error = table::read(&sweep, &broken).unwrap_err();
    assert!(matches!(error, SweepError::Row { line: 2, .. }), "{error}");
    assert_ne!(other.hash, sweep.hash);
    assert_eq!(read(&folder_with(SWEEP)).hash, sweep.hash);
}

#[test]
fn a_case_without_an_answer_is_a_row_with_its_reason() {
    // The characteristic curve leaves the plate of the narrowest joint.
    let text = SWEEP
        .replace("e_over_d", "w_over_d")
        .replace("[2, 4, 5]", "[1.15, 4]");
    let sweep = read(&folder_with(&text));
    let rows = solved(&sweep, &[0, 1, 2, 3]);
    for row in &rows[..2] {
        let Outcome::Unresolved(reason) = &row.outcome else {
            panic!("{row:?}");
        };
        assert!(reason.contains("characteristic curve"), "{reason}");
    }
    assert!(rows[2..].iter().all(|row| row.joint().is_some()));
    let words = verdict(&sweep, &rows);
    assert!(words.contains("2 of 4 cases have no answer"), "{words}");
    let text = String::from_utf8(table::text(&sweep, &rows).unwrap()).unwrap();
    assert_eq!(
        table::read(&sweep, &text).unwrap()[0].outcome,
        rows[0].outcome
    );
    let (drawings, remarks) = figures::draw(&sweep, &rows);
    assert_eq!((drawings.len(), remarks.len()), (2, 0));
}

#[test]
fn each_mode_governs_where_it_should() {
    let sweep = Sweep::from_file(
        &scenes().join("mode-map.toml"),
        &["mesh.spacing=6 deg"],
        HOST,
    )
    .unwrap();
    // Short of end, a little longer, narrow, and neither.
    let rows = solved(&sweep, &[4, 19, 25, 29]);
    assert_eq!(sweep.name_of(19), "e/D = 3, W/D = 6");
    let modes: Vec<&str> = rows
        .iter()
        .map(|row| row.joint().unwrap().mode.name())
        .collect();
    let expected = [
        "shear-out and net tension",
        "shear-out",
        "net tension",
        "bearing",
    ];
    assert_eq!(modes, expected);
    let load = |row: usize| rows[row].joint().unwrap().load.unwrap();
    assert!(load(0) < 0.9 * load(3) && load(2) < 0.7 * load(3));
    assert!(verdict(&sweep, &rows).contains("is called by Yamada–Sun"));
    // First failures of plies are not passed off as the end of a joint.
    let changes = ["mesh.spacing=6 deg", "failure.criteria=[\"hashin\"]"];
    let first = Sweep::from_file(&scenes().join("mode-map.toml"), &changes, HOST).unwrap();
    let rows_of_first = solved(&first, &[29]);
    let said = verdict(&first, &rows_of_first);
    assert!(
        said.contains("is called by Hashin") && said.contains("no ultimate loads"),
        "{said}"
    );
    assert!(rows.iter().all(|row| row.joint().unwrap().reached));
}

#[test]
fn a_scene_without_failure_has_contact_alone() {
    let folder = folder_with(SWEEP);
    let scene = std::fs::read_to_string(folder.path().join("joint.toml")).unwrap();
    let (before, after) = scene.split_once("[failure]").unwrap();
    let (_, rest) = after.split_once("[output]").unwrap();
    std::fs::write(
        folder.path().join("joint.toml"),
        format!("{before}[output]{rest}"),
    )
    .unwrap();
    let sweep = Sweep::from_file(&folder.path().join("sweep.toml"), &[COARSE], HOST).unwrap();
    assert_eq!(sweep.criterion, None);
    let rows = solved(&sweep, &[0, 1]);
    let pressure = |row: usize| rows[row].measures().unwrap().peak_pressure.unwrap();
    // Friction carries a part of the load.
    assert!(pressure(1) < pressure(0));
    assert!(rows[0].measures().unwrap().first_ply.is_none());
    assert!(verdict(&sweep, &rows).starts_with("The largest pressure lies between "));
    let (drawings, _) = figures::draw(&sweep, &rows);
    let is_curve = |own: &figures::Drawing| own.name.contains("-over-axis-");
    assert!(!drawings.is_empty() && drawings.iter().all(is_curve));
}

/// One model serves cases that differ in laws only, and must not where half of it does for the first law alone.
#[test]
fn a_case_whose_law_does_not_mirror_is_modelled_whole() {
    let law = |angle: &str| {
        format!(
            "{{ fibre_coverage = {{ plies = [{{ angle = \"{angle} deg\", fraction = 1.0 }}], fibre_fraction = 0.6, \
             kernel = {{ tangent = {{ width = \"40 deg\" }} }}, fibre = {{ coulomb = {{ mu = 0.0 }} }}, \
             matrix = {{ coulomb = {{ mu = 0.8 }} }} }} }}"
        )
    };
    let key = "contacts.0.friction.fibre_coverage.plies.0.angle";
    let sweep = |angles: &str| {
        let folder = folder_with(&format!(
            "version = 1\nscene = \"joint.toml\"\n[[axes]]\nkey = \"{key}\"\nvalues = [{angles}]\n"
        ));
        let friction = format!("contacts.0.friction={}", law("0"));
        let overrides = [COARSE, friction.as_str()];
        Sweep::from_file(&folder.path().join("sweep.toml"), &overrides, HOST).unwrap()
    };
    let outcome = |angles: &str, cases: &[usize]| {
        let rows = solved(&sweep(angles), cases);
        rows.last().unwrap().outcome.clone()
    };
    let after_a_half = outcome("\"0 deg\", \"45 deg\"", &[0, 1]);
    assert!(matches!(after_a_half, Outcome::Solved(_)));
    assert_eq!(after_a_half, outcome("\"45 deg\", \"0 deg\"", &[0]));
}

/// Another joint's load, in megapascals and before the joint's own, leaves the row of the joint as it is.
#[test]
fn loads_are_those_of_the_joint_of_the_sweep() {
    let alone = read(&folder_with(SWEEP));
    let folder = folder_with(SWEEP);
    let path = folder.path().join("joint.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let spare = r#"[bodies.spare]
material = "aluminium"
thickness = "1 mm"
shape.plate_with_hole = { hole_radius = "3 mm", outline.ring.radius = "12 mm" }
[[supports]]
on = "spare.outer"
fix = ["x", "y"]
[[loads]]
on = "spare.hole"
pressure.steps = ["1 MPa", "2 MPa", "3 MPa", "4 MPa", "5 MPa", "6 MPa"]
[[loads]]
name = "pull"
"#;
    let pull = "[[loads]]\nname = \"pull\"\n";
    assert!(text.contains(pull));
    std::fs::write(&path, text.replace(pull, spare)).unwrap();
    let beside = read(&folder);
    assert_eq!((&*alone.load_unit, &*beside.load_unit), ("N", "N"));
    assert_eq!(table::headings(&alone), table::headings(&beside));
    let [alone, beside] = [&alone, &beside].map(|sweep| solved(sweep, &[3]));
    let [alone, beside] = [&alone, &beside].map(|rows| rows[0].measures().unwrap());
    let joint = beside.joint.as_ref().unwrap();
    assert!(joint.load.is_some() && joint.bearing_stress.is_some());
    assert_eq!(alone, beside);
}
