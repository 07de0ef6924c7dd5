//! Walks in the registry of a law's parameters, whose paths name nested tables and lists: `plies[].angle`.

use stickslip_friction::{LawInfo, ParameterInfo};

/// Whether a parameter is registered under this path.
pub(super) fn has_parameter(info: &LawInfo, path: &str) -> bool {
    let mut parameters = info.parameters.iter();
    parameters.any(|parameter| parameter.path == path)
}

/// The parameters at or below a registered path.
pub(super) fn below<'a>(
    info: &'a LawInfo,
    path: &'a str,
) -> impl Iterator<Item = &'a ParameterInfo> {
    info.parameters.iter().filter(move |parameter| {
        parameter
            .path
            .strip_prefix(path)
            .is_some_and(|rest| path.is_empty() || rest.is_empty() || rest.starts_with(['.', '[']))
    })
}

/// The rest of a parameter's path below `prefix`.
pub(super) fn rest<'a>(parameter: &'a ParameterInfo, prefix: &str) -> &'a str {
    let rest = parameter.path.strip_prefix(prefix).unwrap_or_default();
    rest.strip_prefix('.').unwrap_or(rest)
}

/// The keys that may stand in the table at `prefix`.
pub(super) fn names_below<'a>(info: &'a LawInfo, prefix: &'a str) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for parameter in below(info, prefix) {
        let name = rest(parameter, prefix)
            .split(['.', '['])
            .next()
            .unwrap_or_default();
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Whether the table at `prefix` is a choice: below the law's own table, one that holds only tables, as `kernel` does.
pub(super) fn holds_one(info: &LawInfo, prefix: &str) -> bool {
    !prefix.is_empty()
        && below(info, prefix).next().is_some()
        && below(info, prefix).all(|parameter| rest(parameter, prefix).contains('.'))
        && !below(info, prefix).any(|parameter| rest(parameter, prefix).starts_with('['))
}
