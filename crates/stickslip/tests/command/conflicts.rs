//! Names and platens that are refused at check.

use super::refusals::refused;
use super::{fails, folder_with};

#[test]
fn names_that_make_no_file_names() {
    for name in [String::new(), "a/b".to_owned(), "x".repeat(65)] {
        let named = format!("name = \"{name}\"");
        refused("name = \"pin\"", &named, &["1 to 64 letters without '/'"]);
    }
}

#[test]
fn a_platen_on_a_contact_edge() {
    let platen = "[[platens]]\non = \"plate.hole\"\nfree = [\"x\"]\n[[loads]]";
    refused(
        "[[loads]]",
        platen,
        &["plate.hole is an edge of a contact", "glue another edge"],
    );
}

#[test]
fn a_second_platen_of_a_body() {
    let two = "[[platens]]\non = \"plate.left\"\nfree = [\"x\"]\n[[platens]]\non = \"plate.right\"\nfree = [\"x\"]\n[[loads]]";
    refused(
        "[[loads]]",
        two,
        &[
            "bad.toml:30:6",
            "'plate' has a platen on plate.left already",
            "hold plate.right by a support",
        ],
    );
}

#[test]
fn what_is_named_twice() {
    refused(
        "fix = [\"x\", \"y\"]",
        "fix = [\"x\", \"x\"]",
        &["one direction is named twice", "supports.0.fix"],
    );
    refused(
        "[[loads]]",
        "[[edges]]\non = \"plate.top\"\n[[edges]]\non = \"plate.top\"\n[[loads]]",
        &["plate.top is listed twice", "remove one of the two"],
    );
}

const LAP: &str = include_str!("../../../../scenes/single-lap.toml");

/// The only finding of the single lap with `tail`.
#[track_caller]
fn refused_lap(tail: &str, parts: &[&str]) {
    let folder = folder_with("lap.toml", &format!("{LAP}{tail}"));
    let message = fails(folder.path(), &["check", "lap.toml"]);
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    assert_eq!(message.matches("help:").count(), 1, "{message}");
}

#[test]
fn plates_in_different_layers_do_not_touch() {
    let pair = |first: &str, second: &str| {
        format!(
            "[[contacts]]\nname = \"plates\"\nfirst = \"{first}\"\nsecond = \"{second}\"\nfriction.coulomb = {{ mu = 0.1 }}\n"
        )
    };
    for edges in [["lower.top", "upper.top"], ["upper.right", "lower.left"]] {
        refused_lap(
            &pair(edges[0], edges[1]),
            &[
                "lap.toml:106:1",
                "contact 'plates' is between '",
                "which lie in different layers",
                "friction between plates",
                "is not modelled",
            ],
        );
    }
    refused_lap(
        &pair("lower.a", "upper.a"),
        &[
            "'lower.a' and 'upper.a' cannot be in contact",
            "friction between them is not modelled",
            "[fasteners.NAME]",
        ],
    );
}

#[test]
fn a_second_pin_in_a_hole() {
    let second = "[bodies.other]\nmaterial = \"steel\"\nthickness = \"2 mm\"\nshape.disk.radius = \"4.9 mm\"\n\
                  [[contacts]]\nfirst = \"plate.hole\"\nsecond = \"other.rim\"\nfriction.coulomb.mu = 0\n[[loads]]";
    refused(
        "[[loads]]",
        second,
        &[
            "plate.hole is in contact 'pin' already",
            "a bushing touches with its hole and its outer edge",
            "joined by [fasteners.NAME]",
        ],
    );
}
