//! Dotted keys, `table.key`.

/// `parent.name`, or `name` at the top.
pub fn child(parent: &str, name: impl std::fmt::Display) -> String {
    if parent.is_empty() {
        name.to_string()
    } else {
        format!("{parent}.{name}")
    }
}
