//! Remedies as they are shown.

use super::*;

#[test]
fn names_that_were_meant_are_suggested() {
    let problem = SceneProblem::UnknownKey {
        key: "yung".to_owned(),
        nearest: Some("young".to_owned()),
        known: vec!["young".to_owned(), "poisson".to_owned()],
    };
    let help = problem.help().map(|help| help.to_string());
    assert_eq!(
        help.as_deref(),
        Some("did you mean 'young'? known keys here: young, poisson")
    );
}

#[test]
fn backticks_are_around_code_only() {
    let help = |example: &str| {
        let problem = SceneProblem::MissingKey {
            key: "scale".to_owned(),
            table: "table".to_owned(),
            example: example.to_owned(),
        };
        problem.help().map(|help| help.to_string())
    };
    assert_eq!(
        help("scale = \"1 mm\"").as_deref(),
        Some("add for example `scale = \"1 mm\"`")
    );
    assert_eq!(
        help("`scale = \"1 mm\"`, the length of a pixel").as_deref(),
        Some("add for example `scale = \"1 mm\"`, the length of a pixel")
    );
}
