//! The back of a specimen that cannot be compared with its front.

use std::fs;

use serde_json::json;

use super::refusals::{check, field, says};
use super::{TABLE, fails, finding, findings, folder_with, grid};

#[test]
fn a_back_that_nothing_is_compared_with_is_refused() {
    let back = "back.table = { file = \"back.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    let line = "[reduce]\nsymmetry = { from = [\"6 mm\", \"0 mm\"], to = [\"11 mm\", \"3 mm\"] }\n";
    let grating = "[grating]\nfrequency = \"2400 1/mm\"\n";
    let table = grid("x,y,u,v", field);
    check(
        &says(&format!("{TABLE}{back}"), &table),
        &[
            "no line along which",
            "states.0.back",
            "e.toml:9",
            "[reduce] symmetry",
        ],
    );
    check(
        &says(&format!("{TABLE}{line}"), &table),
        &[
            "no state has a back",
            "reduce.symmetry",
            "e.toml:10",
            "remove symmetry",
        ],
    );
    let folder = folder_with(&[
        ("e.toml", &format!("{TABLE}{back}{line}{grating}")),
        ("up.csv", &table),
    ]);
    let says_of_back = |back: &dyn Fn(f64, f64) -> [f64; 2]| {
        fs::write(folder.path().join("back.csv"), grid("x,y,u,v", back)).unwrap();
        fails(folder.path(), &["reduce", "e.toml"])
    };
    check(
        &says_of_back(&|x, y| [field(x, y)[0], f64::NAN]),
        &[
            "state 'up': the back has no V",
            "states.0.back",
            "e.toml:9",
            "leave V out",
        ],
    );
    fs::write(
        folder.path().join("up.csv"),
        grid("x,y,u,v", |x, y| [f64::NAN, field(x, y)[1]]),
    )
    .unwrap();
    check(
        &says_of_back(&|x, y| [field(x, y)[0], f64::NAN]),
        &["the back has no V"],
    );
    // A V of the back alone is reported.
    fs::write(
        folder.path().join("up.csv"),
        grid("x,y,u,v", |x, y| [field(x, y)[0], f64::NAN]),
    )
    .unwrap();
    fs::write(folder.path().join("back.csv"), &table).unwrap();
    let summary = super::succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(finding(&summary, "front_lacks", "remark")["field"], "V");
}

#[test]
fn fringe_lines_of_the_back_need_the_names_of_the_front() {
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    let of = |file: &str| {
        format!("lines = {{ u = \"{file}\", v = \"{file}\", scale = \"1 mm\", y_axis = \"up\" }}")
    };
    let experiment = format!(
        "{head}\n{}\nback.{}\n[reduce]\nsymmetry = {{ from = [\"6 mm\", \"0 mm\"], to = [\"8 mm\", \"0 mm\"] }}\n[grating]\nfrequency = \"2400 1/mm\"\n",
        of("up.csv"),
        of("back.csv")
    );
    let lines = |names: [&str; 2]| {
        let [a, b] = names;
        format!("line,x,y,order\n{a},6,0,1\n{a},7,0,2\n{a},8,0,3\n{b},6,2,1\n{b},7,2,2\n")
    };
    let folder = folder_with(&[
        ("e.toml", &experiment),
        ("up.csv", &lines(["a", "b"])),
        ("back.csv", &lines(["c", "d"])),
    ]);
    check(
        &fails(folder.path(), &["reduce", "e.toml"]),
        &[
            "no line of the U field",
            "the front has a, b, the back c, d",
            "states.0.back",
            "e.toml:9",
        ],
    );
    fs::write(folder.path().join("back.csv"), lines(["a", "d"])).unwrap();
    let summary = super::succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(summary["measured"][0]["u"]["symmetric"], true, "{summary}");
    for (found, field) in (findings(&summary, "lines_of_front_alone").iter()).zip(["U", "V"]) {
        let reported = (&found["field"], &found["lines"], &found["level"]);
        assert_eq!(reported, (&field.into(), &json!(["b"]), &"remark".into()));
    }
    let page = fs::read_to_string(folder.path().join("e-results/index.html")).unwrap();
    assert!(page.contains("lines b of the U field are not on the back"));
}
