//! Names and platens that are refused at check.

use super::refusals::refused;

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
