//! A keyword line.

/// A keyword with its parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Card {
    /// The keyword in capitals, without blanks.
    pub(super) keyword: String,
    /// The keyword as the file spells it.
    pub(super) shown: String,
    /// Parameters in capitals, without blanks, and their values, empty if there is none.
    parameters: Vec<(String, String)>,
}

impl Card {
    /// Takes a line that begins with a star apart.
    pub(super) fn parse(line: &str) -> Self {
        let mut parts = entries(line.trim_start_matches('*'));
        let shown = parts.next().unwrap_or_default().to_owned();
        let parameters = parts.filter(|part| !part.is_empty()).map(|part| {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            (capitals(key), unquoted(value).to_owned())
        });
        Self {
            keyword: capitals(&shown),
            parameters: parameters.collect(),
            shown,
        }
    }

    /// The value of a parameter, empty if it has none.
    pub(super) fn value(&self, parameter: &str) -> Option<&str> {
        let found = self.parameters.iter().find(|(key, _)| key == parameter);
        found.map(|(_, value)| value.as_str())
    }

    /// Whether a parameter is there.
    pub(super) fn has(&self, parameter: &str) -> bool {
        self.value(parameter).is_some()
    }
}

fn capitals(text: &str) -> String {
    let kept = text.chars().filter(|c| !c.is_whitespace());
    kept.flat_map(char::to_uppercase).collect()
}

/// The text without blanks and quotes around it.
pub(super) fn unquoted(text: &str) -> &str {
    let text = text.trim();
    let inner = text
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    inner.unwrap_or(text)
}

/// The entries of a line between its commas, without blanks around them. Commas in quotes do not count.
pub(super) fn entries(line: &str) -> impl Iterator<Item = &str> {
    let mut quoted = false;
    let parts = line.split(move |c| {
        quoted ^= c == '"';
        c == ',' && !quoted
    });
    parts.map(str::trim)
}
