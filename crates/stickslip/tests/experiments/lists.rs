//! Lists of the wrong length, lists for tables and tables that say nothing: refused at the value, not read as far as they go.

use super::refusals::{check, field, says};
use super::{TABLE, fails, folder_with, grid, succeeds};

#[test]
fn lists_have_the_length_that_is_wanted() {
    let table = grid("x,y,u,v", field);
    for (from, to, found, key) in [
        (
            "centre = [\"0 mm\", \"0 mm\"]",
            "centre = [\"0 mm\", \"0 mm\", \"5 mm\"]",
            3,
            "specimen.hole.centre",
        ),
        (
            "centre = [\"0 mm\", \"0 mm\"]",
            "centre = [\"0 mm\"]",
            1,
            "specimen.hole.centre",
        ),
        (
            "y_axis = \"up\"",
            "y_axis = \"up\", origin = [0, 0, 3]",
            3,
            "states.0.table.origin",
        ),
        (
            "y_axis = \"up\"",
            "y_axis = \"up\", origin = []",
            0,
            "states.0.table.origin",
        ),
        (
            "y_axis = \"up\"",
            "y_axis = \"up\", reversed = [true, false, true]",
            3,
            "states.0.table.reversed",
        ),
    ] {
        let error = says(&TABLE.replace(from, to), &table);
        let counts = format!("2 values are wanted, found {found}");
        check(
            &error,
            &[&counts, "give a list of 2 values", key, "e.toml:"],
        );
    }
    let window = format!("{TABLE}[reduce]\nmask = [{{ window = [[\"0 mm\", \"0 mm\"]] }}]\n");
    check(
        &says(&window, &table),
        &["2 values are wanted, found 1", "reduce.mask.0.window"],
    );
    let free = format!(
        "{TABLE}[[laws]]\nfriction.coulomb = {{ mu = 0.3 }}\nfree = {{ mu = [0.0, 0.5, 1.0] }}\n"
    );
    check(
        &says(&free, &table),
        &["2 values are wanted, found 3", "laws.0.free.mu"],
    );
}

/// On the command line as in the file.
#[test]
fn lists_set_by_hand_are_checked_too() {
    let folder = folder_with(&[("e.toml", TABLE), ("up.csv", &grid("x,y,u,v", field))]);
    let set = |assignment: &str| fails(folder.path(), &["check", "e.toml", "--set", assignment]);
    check(
        &set("specimen.hole.centre=[\"0 mm\",\"0 mm\",\"5 mm\"]"),
        &["2 values are wanted, found 3", "--set"],
    );
    check(
        &set("states.0.edge_force=[\"4348 N\",\"0 N\",\"0 N\"]"),
        &[
            "expected a table, such as { x = \"5516 N\" }, found a list",
            "--set",
        ],
    );
}

#[test]
fn a_list_is_no_table() {
    let table = grid("x,y,u,v", field);
    for (from, to) in [
        (
            "hole = { centre = [\"0 mm\", \"0 mm\"], radius = \"5 mm\" }",
            "hole = [[\"0 mm\", \"0 mm\"], \"5 mm\"]",
        ),
        (
            "y_axis = \"up\"",
            "y_axis = \"up\", columns = [\"x\", \"y\", \"u\", \"v\"]",
        ),
    ] {
        check(
            &says(&TABLE.replace(from, to), &table),
            &["expected a table", "found a list", "e.toml:"],
        );
    }
}

#[test]
fn an_edge_force_names_a_component() {
    let table = grid("x,y,u,v", field);
    let with = |force: &str| format!("{TABLE}edge_force = {force}\n");
    check(
        &says(&with("{}"), &table),
        &[
            "edge_force names no component",
            "states.0.edge_force",
            "edge_force = { x = \"5516 N\" }",
            "e.toml:9",
        ],
    );
    check(
        &says(&with("{ x = \"1449.6 N/mm\" }"), &table),
        &["\"1449.6 N/mm\"", "a force per length; a force is expected"],
    );
    let one = with("{ y = \"10 N\" }");
    let folder = folder_with(&[("e.toml", &one), ("up.csv", &table)]);
    succeeds(folder.path(), &["reduce", "e.toml"]);
}

#[test]
fn only_code_stands_in_backticks() {
    let table = grid("x,y,u,v", field);
    let error = says(&TABLE.replace(", scale = \"1 mm\"", ""), &table);
    check(
        &error,
        &["add for example `scale = \"1 mm\"`, the length of"],
    );
    let dice = TABLE.replace("\"up.csv\"", "\"up.csv\", preset = \"dice\"");
    check(
        &says(&dice, &table),
        &["add for example `origin = [512, 384]`, the pixel"],
    );
    let region = format!(
        "{TABLE}[region]\nsector = {{ angles = [\"40 deg\", \"-40 deg\"], outer = \"11 mm\", cells = [4, 4] }}\n"
    );
    check(
        &says(&region, &table),
        &["angles must be two angles that increase"],
    );
}
