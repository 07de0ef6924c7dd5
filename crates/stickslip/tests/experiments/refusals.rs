//! Bad files and bad data: each an error with its place and a remedy, never a silent zero.

use std::fs;

use super::{FRINGES, SCENE, TABLE, fails, folder_with, grid, succeeds};

pub(super) fn field(x: f64, y: f64) -> [f64; 2] {
    [1e-3 * x, -3e-4 * y]
}

/// What `stickslip reduce` says of an experiment and its table.
pub(super) fn says(experiment: &str, table: &str) -> String {
    let folder = folder_with(&[("e.toml", experiment), ("up.csv", table)]);
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(!folder.path().join("e-results").exists());
    error
}

pub(super) fn check(error: &str, parts: &[&str]) {
    for part in parts {
        assert!(error.contains(part), "'{part}' is missing in:\n{error}");
    }
}

#[test]
fn what_must_be_stated_is_asked_for() {
    let table = grid("x,y,u,v", field);
    let without = |part: &str| says(&TABLE.replace(part, ""), &table);
    check(
        &without(", scale = \"1 mm\""),
        &[
            "'scale' is missing",
            "states.0.table",
            "e.toml:8",
            "scale = \"1 mm\"",
        ],
    );
    check(
        &without(", y_axis = \"up\""),
        &["'y_axis' is missing", "e.toml:8"],
    );
    check(
        &says(&TABLE.replace("\"1 mm\", y", "1, y"), &table),
        &["1 has no unit", "a length", "e.toml:8"],
    );
    check(
        &says(&TABLE.replace("\"1 mm\", y", "\"1 N\", y"), &table),
        &["\"1 N\"", "a force; a length is expected"],
    );
    let dice = TABLE.replace("\"up.csv\"", "\"up.csv\", preset = \"dice\"");
    check(
        &says(&dice, &table),
        &["'origin' is missing", "origin = [512, 384]"],
    );
    check(
        &without("thickness = \"1.5 mm\"\n"),
        &["'thickness' is missing"],
    );
    check(
        &says(&TABLE.replace("poisson = 0.33", "poisson = 0.7"), &table),
        &["specimen.material", "poisson"],
    );
    check(
        &says(&TABLE.replace("scale =", "scala ="), &table),
        &["unknown key 'scala'", "did you mean 'scale'"],
    );
    check(
        &says(&TABLE.replace("version = 1", "version = 2"), &table),
        &["version 2 of the experiment format"],
    );
    let lines = TABLE
        .replace("table = {", "lines = { u = \"a\", v = \"b\", ")
        .replace("file = \"up.csv\",", "")
        .replace(", deviation = \"1e-4 mm\"", "");
    check(&says(&lines, &table), &["'grating' is missing"]);
}

#[test]
fn tables_that_are_none_are_refused_at_their_line() {
    let table = grid("x,y,u,v", field);
    check(
        &says(TABLE, &table.replacen("x,y,u,v", "x,y,ux,v", 1)),
        &[
            "up.csv",
            "line 1 names no column 'u'",
            "x, y, ux, v",
            "e.toml:8",
        ],
    );
    check(
        &says(TABLE, &table.replacen("x,y,u,v", "x,y,u,u", 1)),
        &["names column 'u' 2 times"],
    );
    let twice = format!("{table}7,7,0,0\n");
    check(
        &says(TABLE, &twice),
        &["both at (7, 7)", "keep one of them"],
    );
    let word = table.replacen("-12,-12,", "-12,-12,abc", 1);
    check(
        &says(TABLE, &word),
        &["line 2, column 'u'", "is not a number"],
    );
    let infinite = format!("{table}20,20,inf,0\n");
    check(&says(TABLE, &infinite), &["is not finite", "write NaN"]);
    let nowhere = format!("{table}NaN,20,1,0\n");
    check(&says(TABLE, &nowhere), &["is no place for a displacement"]);
    check(&says(TABLE, "x,y,u,v\n"), &["there are no data"]);
    check(
        &says(&TABLE.replace("up.csv", "gone.csv"), &table),
        &["gone.csv", "cannot be read", "e.toml:8"],
    );
}

#[test]
fn fields_that_are_masked_everywhere_are_refused() {
    let none = grid("x,y,u,v", |_, _| [f64::NAN; 2]);
    check(
        &says(TABLE, &none),
        &["none of", "has a valid displacement"],
    );
    let far = TABLE.replace("1 mm\", y", "0.1 mm\", y");
    check(
        &says(&far, &grid("x,y,u,v", field)),
        &[
            "lie in the hole or under a mask",
            "scale, origin and y_axis",
        ],
    );
    let mask = format!(
        "{TABLE}[reduce]\nmask = [{{ centre = [\"0 mm\", \"0 mm\"], radius = \"50 mm\" }}]\n"
    );
    check(
        &says(&mask, &grid("x,y,u,v", field)),
        &["lie in the hole or under a mask"],
    );
    let dark =
        format!("{FRINGES}missing = [{{ centre = [\"7 mm\", \"0 mm\"], radius = \"20 mm\" }}]\n");
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", &dark)]);
    check(
        &fails(folder.path(), &["fringes", "e.toml"]),
        &["pixels are missing or masked", "fringes.window"],
    );
}

#[test]
fn data_that_do_not_cover_the_region_are_refused_with_the_place() {
    let region = "[region]\nsector = { angles = [\"-40 deg\", \"40 deg\"], outer = \"OUT\", cells = [16, 4], stand_off = \"0.5 mm\" }\n";
    let text = format!("{TABLE}{region}");
    let error = says(&text.replace("OUT", "30 mm"), &grid("x,y,u,v", field));
    check(
        &error,
        &["do not cover the region", "θ =", "mm", "[region]"],
    );
    let folder = folder_with(&[
        ("e.toml", &text.replace("OUT", "11 mm")),
        ("up.csv", &grid("x,y,u,v", field)),
    ]);
    super::succeeds(folder.path(), &["reduce", "e.toml"]);
    // A hole in the middle of the data, by a mask.
    let mask = "[reduce]\nmask = [{ centre = [\"11 mm\", \"0 mm\"], radius = \"4.5 mm\" }]\n";
    let error = says(
        &(text.replace("OUT", "11 mm") + mask),
        &grid("x,y,u,v", field),
    );
    check(&error, &["do not cover the region", "θ ="]);
}

#[test]
fn a_region_needs_both_components() {
    let region = "[region]\nsector = { angles = [\"-40 deg\", \"40 deg\"], outer = \"11 mm\", cells = [16, 4], stand_off = \"0.5 mm\" }\n";
    let u_alone = grid("x,y,u,v", |x, y| [field(x, y)[0], f64::NAN]);
    for text in [TABLE, &TABLE.replace(", deviation = \"1e-4 mm\"", "")] {
        let text = format!("{text}{region}");
        let folder = folder_with(&[("e.toml", &text), ("up.csv", &u_alone)]);
        for command in ["reduce", "hybrid", "identify"] {
            check(
                &fails(folder.path(), &[command, "e.toml"]),
                &[
                    "state 'up'",
                    "no valid V displacement",
                    "states.0",
                    "e.toml:6",
                    "give the V field too",
                ],
            );
        }
    }
}

#[test]
fn fringe_lines_out_of_order_are_refused() {
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    let experiment = format!(
        "{head}\nlines = {{ u = \"up.csv\", v = \"up.csv\", scale = \"1 mm\", y_axis = \"up\", track = \"drawn\" }}\n[grating]\nfrequency = \"2400 1/mm\"\n"
    );
    let ordered = "line,x,y,order\na,6,0,1\na,7,0,2\na,8,0,3\n";
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", ordered)]);
    super::succeeds(folder.path(), &["reduce", "e.toml"]);
    let back = "line,x,y,order\na,6,0,1\na,8,0,3\na,7,0,2\n";
    check(&says(&experiment, back), &["turns back", "(8, 0)"]);
    let twice = "line,x,y,order\na,6,0,1\na,6,0,2\na,7,0,3\n";
    check(&says(&experiment, twice), &["at one place"]);
}

#[test]
fn states_and_settings_that_contradict_each_other_are_refused() {
    let table = grid("x,y,u,v", field);
    let two = format!(
        "{TABLE}[[states]]\nname = \"up\"\ntable = {{ file = \"up.csv\", scale = \"1 mm\", y_axis = \"up\" }}\n"
    );
    check(&says(&two, &table), &["two states 'up'"]);
    check(
        &says(&TABLE.replace("name = \"up\"", "name = \"a/b\""), &table),
        &["not a valid name of a state"],
    );
    check(
        &says(&format!("{TABLE}step = 1\n"), &table),
        &["one of step, table, pictures and lines"],
    );
    check(
        &says(
            &TABLE.replace("[specimen]", "[specimen]\nbody = \"plate\""),
            &table,
        ),
        &["'body' belongs to a scene"],
    );
    let zone =
        format!("{TABLE}[[identify.zones]]\nstate = \"upp\"\nfrom = \"0 deg\"\nto = \"30 deg\"\n");
    check(
        &says(&zone, &table),
        &["there is no state 'upp'", "did you mean 'up'"],
    );
    let law = format!("{TABLE}[[laws]]\nfriction.coulom = {{ mu = 0.3 }}\n");
    check(
        &says(&law, &table),
        &["'coulom' is not a friction law", "did you mean 'coulomb'"],
    );
    let free = format!(
        "{TABLE}[[laws]]\nfriction.coulomb = {{ mu = 0.3 }}\nfree = {{ mu = [1.0, 0.0] }}\n"
    );
    check(
        &says(&free, &table),
        &["'mu' is free without a valid range", "laws.0.free.mu"],
    );
    let region = format!(
        "{TABLE}[region]\nsector = {{ angles = [\"40 deg\", \"-40 deg\"], outer = \"11 mm\", cells = [4, 4] }}\n"
    );
    check(&says(&region, &table), &["angles", "that increase"]);
}

#[test]
fn scenes_of_synthetic_experiments_are_checked_too() {
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", FRINGES)]);
    let says = |text: &str| {
        fs::write(folder.path().join("e.toml"), text).unwrap();
        fails(folder.path(), &["fringes", "e.toml"])
    };
    check(
        &says(&FRINGES.replace("scene.toml", "gone.toml")),
        &["gone.toml", "relative to the folder"],
    );
    check(
        &says(&FRINGES.replace("\"plate\"", "\"plat\"")),
        &["there is no body 'plat'", "did you mean 'plate'"],
    );
    check(
        &says(&format!("{FRINGES}[[states]]\nname = \"a\"\nstep = 4\n")),
        &["step = 4 is outside", "from 1 to 3"],
    );
    check(
        &says(&FRINGES.replace(
            "scene = \"scene.toml\"",
            "scene = \"scene.toml\"\noverrides = [\"mesh.spacin=3 deg\"]",
        )),
        &["unknown key 'spacin'"],
    );
    check(
        &says(&FRINGES.replace("pixel = \"0.04 mm\"", "pixel = \"40 mm\"")),
        &["0 x 0 pixels", "fringes"],
    );
    check(
        &says(&format!("{FRINGES}bits = 12\n")),
        &["bits = 12", "8 or 16"],
    );
    check(
        &says(&FRINGES.replace("frequency = \"2400 1/mm\"", "wavelength = \"514.5 mm\"")),
        &["wavelength and angle"],
    );
}

/// Ends of ranges are spelled as the parameter is: a length is no stress, and no bare number.
#[test]
fn ranges_of_free_parameters_have_the_dimension_of_the_parameter() {
    let table = grid("x,y,u,v", field);
    let law = |range: &str| {
        format!(
            "{TABLE}[[laws]]\nfriction.slip_power = {{ static = 0.35, dynamic = 0.25, slip_scale = \"0.002 mm\", exponent = 2.0 }}\nfree = {{ {range} }}\n"
        )
    };
    for (range, parts) in [
        (
            "slip_scale = [1e-4, 0.1]",
            ["0.0001 has no unit", "a length", "slip_scale.0"],
        ),
        (
            "slip_scale = [\"1e-4 mm\", \"0.1 MPa\"]",
            [
                "a length is expected",
                "\"0.1 MPa\" has the unit of a stress",
                "slip_scale.1",
            ],
        ),
        (
            "slip_scale = [\"1e-4 mm\", \"0.1 foo\"]",
            ["'foo'", "not a known unit", "slip_scale.1"],
        ),
        (
            "static = [0.0, \"1 mm\"]",
            [
                "a number without unit or quotes",
                "1 mm",
                "laws.0.free.static.1",
            ],
        ),
    ] {
        let error = says(&law(range), &table);
        check(&error, &parts);
        check(&error, &["e.toml:11"]);
    }
    let fits = law("static = [0.0, 1.0], slip_scale = [\"0.1 um\", \"0.1 mm\"]");
    let folder = folder_with(&[("e.toml", &fits), ("up.csv", &table)]);
    super::succeeds(folder.path(), &["reduce", "e.toml"]);
}

#[test]
fn a_column_is_one_thing_only() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let columns =
        "states.0.table.columns={ x = \"X_mm\", y = \"Y_mm\", u = \"DX_um\", v = \"dx_um\" }";
    let error = fails(path, &["reduce", "mine.toml", "--set", columns]);
    assert!(
        error.contains("column 'dx_um' is named for two of x, y, u and v"),
        "{error}"
    );
}
