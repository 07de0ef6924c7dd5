//! Choices as a document shows them.

/// Choices that are texts, as a document shows them: `"Q8"`, `"Q9"`.
pub(crate) fn quoted(names: impl Iterator<Item = &'static str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`\"{name}\"`")).collect();
    names.join(", ")
}

/// Choices that are keys, as a document shows them.
pub(crate) fn coded(names: impl Iterator<Item = &'static str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    names.join(", ")
}
