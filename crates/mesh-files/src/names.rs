//! Lists of names in sentences.

/// Most names that are listed.
const MOST_NAMES: usize = 30;

/// "'a', 'b' and 3 more".
pub(crate) fn listed(names: &[&str]) -> String {
    let shown = names.iter().take(MOST_NAMES);
    let shown: Vec<String> = shown.map(|name| format!("'{name}'")).collect();
    match names.len() - shown.len() {
        _ if names.is_empty() => "none".to_owned(),
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}
