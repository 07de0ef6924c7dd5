//! Lists for the terminal.

/// A title and two aligned columns.
pub(super) fn table(title: &str, rows: impl Iterator<Item = (String, String)>) -> String {
    let rows: Vec<_> = rows.collect();
    let width = rows
        .iter()
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or_default();
    let line = |(name, text): &(String, String)| format!("  {name:width$}  {text}");
    let lines: Vec<_> = rows.iter().map(line).collect();
    format!("{title}\n{}\n", lines.join("\n"))
}
