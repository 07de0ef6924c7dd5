//! Numbers in sentences.

/// The numbers of a text in ascending order of their spelling: digits with a point, a sign and an exponent as they are written.
///
/// A reworded sentence has the same ones.
pub(super) fn numbers(text: &str) -> Vec<&str> {
    let part_of_number = |c: char| c.is_ascii_digit() || c == '.';
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let mut end = start + length(&rest[start..], part_of_number);
        let exponent = rest[end..].strip_prefix(['e', 'E']);
        if let Some(exponent) = exponent {
            let digits = exponent.trim_start_matches(['-', '+']);
            let sign = exponent.len() - digits.len();
            let power = length(digits, |c| c.is_ascii_digit());
            if sign <= 1 && power > 0 {
                end += 1 + sign + power;
            }
        }
        let signed = rest[..start].ends_with('-')
            && !rest[..start - 1].ends_with(|c: char| c.is_alphanumeric());
        let begin = if signed { start - 1 } else { start };
        found.push(rest[begin..end].trim_end_matches('.'));
        rest = &rest[end..];
    }
    found.sort_unstable();
    found
}

/// Bytes of the characters at the start that are `wanted`.
fn length(text: &str, wanted: impl Fn(char) -> bool) -> usize {
    text.find(|c| !wanted(c)).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::numbers;

    #[test]
    fn numbers_are_found_as_they_are_written() {
        assert_eq!(
            numbers("Step 3: 1.5 % of -2e-3 mm, at x = 7."),
            ["-2e-3", "1.5", "3", "7"]
        );
        assert_eq!(numbers("part-2 of Q8 at 90°, 1e4"), ["1e4", "2", "8", "90"]);
        assert!(numbers("none").is_empty());
    }
}
