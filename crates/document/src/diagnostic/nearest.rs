//! The name that somebody probably meant.

/// The entry of `known` that differs from `word` by the fewest single-letter edits, if those are at most about a third of its letters
/// (Levenshtein 1966). The first of several wins.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() + 1).max(3) / 3;
    known
        .into_iter()
        .map(|candidate| (distance(word, candidate), candidate))
        .filter(|(edits, _)| *edits <= limit)
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Insertions, deletions and substitutions that turn `left` into `right`, letter case ignored.
fn distance(left: &str, right: &str) -> usize {
    let right: Vec<char> = right.to_lowercase().chars().collect();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (i, own) in left.to_lowercase().chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in right.iter().enumerate() {
            let substituted = diagonal + usize::from(own != *other);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[right.len()]
}

/// `body = "plate" or body = "lug"`.
pub fn one_of<S: AsRef<str>>(key: &str, names: &[S]) -> String {
    let stated = names
        .iter()
        .map(|name| format!("{key} = \"{}\"", name.as_ref()));
    stated.collect::<Vec<_>>().join(" or ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typing_errors_are_recognised_and_other_words_are_not() {
        let known = ["young", "poisson", "expansion"];
        assert_eq!(nearest("youngs", known), Some("young"));
        assert_eq!(nearest("Poison", known), Some("poisson"));
        assert_eq!(nearest("density", known), None);
        assert_eq!(nearest("mu", []), None);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
    }
}
