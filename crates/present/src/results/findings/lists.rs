//! Lists of names and load steps.

/// "'a', 'b' and 'c'".
pub fn quoted<T: AsRef<str>>(names: impl IntoIterator<Item = T>) -> String {
    let quoted = names.into_iter().map(|name| format!("'{}'", name.as_ref()));
    listed(quoted.collect())
}

/// "a, b and c".
pub(in crate::results) fn listed(mut names: Vec<String>) -> String {
    let last = names.pop().unwrap_or_default();
    if names.is_empty() {
        last
    } else {
        format!("{} and {last}", names.join(", "))
    }
}

/// "load step 3", or ascending numbers with runs shortened: "load steps 2–5, 9".
pub(in crate::results) fn load_steps(steps: &[usize]) -> String {
    let runs = steps.chunk_by(|a, b| a + 1 == *b);
    let shown = runs.map(|run| match run {
        [first, .., last] => format!("{first}–{last}"),
        one => one.iter().map(ToString::to_string).collect(),
    });
    let shown = shown.collect::<Vec<_>>().join(", ");
    match steps {
        [_] => format!("load step {shown}"),
        _ => format!("load steps {shown}"),
    }
}
