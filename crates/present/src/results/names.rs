//! File names from names in a scene.

use std::collections::BTreeSet;

use stickslip_results::Results;

/// File names that are safe on every system and differ from each other, also where case does not count.
#[derive(Debug, Default)]
pub(super) struct FileNames {
    used: BTreeSet<String>,
}

impl FileNames {
    /// `name` with everything but letters, digits, `-`, `_` and `.` replaced, and a number where it was used before.
    pub(super) fn unique(&mut self, name: &str) -> String {
        let safe = |c: char| {
            if c.is_ascii_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '_'
            }
        };
        let plain: String = name.chars().map(safe).collect();
        let mut candidate = plain.clone();
        let mut count = 1;
        while !self.used.insert(candidate.to_ascii_lowercase()) {
            count += 1;
            candidate = format!("{plain}-{count}");
        }
        candidate
    }
}

/// `name-step-07`, with as many digits as the last step needs, at least two.
pub(super) fn step_name(name: &str, step: usize, results: &Results) -> String {
    let digits = results.steps.len().to_string().len().max(2);
    format!("{name}-step-{:0digits$}", step + 1)
}

#[cfg(test)]
mod tests {
    use super::FileNames;

    #[test]
    fn names_are_safe_and_differ() {
        let mut names = FileNames::default();
        assert_eq!(names.unique("edge-plate.hole"), "edge-plate.hole");
        assert_eq!(names.unique("edge-../a b"), "edge-.._a_b");
        assert_eq!(names.unique("edge-..:a b"), "edge-.._a_b-2");
        assert_eq!(names.unique("EDGE-plate.hole"), "EDGE-plate.hole-2");
    }
}
