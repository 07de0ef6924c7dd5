//! The experiments that come with the program.

use std::path::Path;

use super::succeeds;

#[test]
fn ready_experiments_are_accepted() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut count = 0;
    for folder in ["appendix-a", "appendix-b", "hybrid-aluminium"] {
        for entry in scenes.join(folder).read_dir().unwrap() {
            let file = entry.unwrap().path();
            if file.extension().is_none_or(|end| end != "toml") {
                continue;
            }
            count += 1;
            let summary = succeeds(&scenes, &["check", file.to_str().unwrap()]);
            let lines = summary["checked"].as_array().unwrap();
            assert!(
                lines.iter().any(|line| line["what"] == "state"),
                "{summary}"
            );
            assert!(
                !lines.iter().any(|line| line["what"] == "warning"),
                "{summary}"
            );
        }
    }
    assert_eq!(count, 6);
}
