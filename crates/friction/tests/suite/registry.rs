//! The registry describes every parameter that a file may hold, and nothing else.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;
use stickslip_friction::registry::find;
use stickslip_friction::{Dimension, FrictionLaw, laws};

use super::every_law;

#[test]
fn finds_every_law_by_its_name() {
    let names: Vec<_> = laws().map(|law| law.name).collect();
    assert!(names.is_sorted_by(|a, b| a < b), "{names:?}");
    let samples = every_law();
    let sampled: BTreeSet<_> = samples.iter().map(|law| law.name()).collect();
    assert!(sampled.iter().eq(&names), "{sampled:?}, {names:?}");
    for law in laws() {
        assert_eq!(find(law.name), Some(law));
    }
    assert_eq!(find("no_such_law"), None);
}

#[test]
fn knows_the_dimensions() {
    let dimension_of = |law: &str, path: &str| {
        let parameters = find(law).unwrap().parameters;
        parameters
            .iter()
            .find(|parameter| parameter.path == path)
            .unwrap()
            .dimension
    };
    assert_eq!(dimension_of("coulomb", "mu"), Dimension::Dimensionless);
    assert_eq!(dimension_of("slip_power", "slip_scale"), Dimension::Length);
    assert_eq!(
        dimension_of("pressure_power", "reference_pressure"),
        Dimension::Stress
    );
    assert_eq!(
        dimension_of("fibre_coverage", "plies[].angle"),
        Dimension::Angle
    );
    assert_eq!(
        dimension_of("fibre_coverage", "kernel.tangent.width"),
        Dimension::Angle
    );
    assert_eq!(dimension_of("fibre_coverage", "matrix"), Dimension::Law);
    assert_eq!(
        dimension_of("static_dynamic", "transition"),
        Dimension::Text
    );
    assert_eq!(
        dimension_of("static_dynamic", "allow_strengthening"),
        Dimension::Flag
    );
}

/// Collects, per law, the paths of the values below its name, with the values.
fn collect(written: &Value, into: &mut BTreeMap<String, Vec<(String, Value)>>) {
    let (name, parameters) = written.as_object().unwrap().iter().next().unwrap();
    let mut leaves = vec![];
    walk(name, "", parameters, &mut leaves, into);
    into.entry(name.clone()).or_default().extend(leaves);
}

fn walk(
    law: &str,
    path: &str,
    value: &Value,
    leaves: &mut Vec<(String, Value)>,
    into: &mut BTreeMap<String, Vec<(String, Value)>>,
) {
    let parameters = find(law).unwrap().parameters;
    let is_law = |path: &str| {
        parameters
            .iter()
            .any(|p| p.path == path && p.dimension == Dimension::Law)
    };
    match value {
        nested if is_law(path) => {
            leaves.push((path.to_owned(), nested.clone()));
            collect(nested, into);
        }
        Value::Object(table) => {
            for (key, value) in table {
                let below = if path.is_empty() {
                    key.clone()
                } else {
                    format!("{path}.{key}")
                };
                walk(law, &below, value, leaves, into);
            }
        }
        Value::Array(list) => {
            for value in list {
                walk(law, &format!("{path}[]"), value, leaves, into);
            }
        }
        leaf => leaves.push((path.to_owned(), leaf.clone())),
    }
}

#[test]
fn describes_every_parameter_that_is_written_and_no_other() {
    let mut written = BTreeMap::new();
    for law in crate::every_law() {
        collect(&serde_json::to_value(&law).unwrap(), &mut written);
    }
    for law in laws() {
        let leaves = &written[law.name];
        let paths: BTreeSet<&str> = leaves.iter().map(|(path, _)| path.as_str()).collect();
        let described: BTreeSet<&str> = law
            .parameters
            .iter()
            .map(|parameter| parameter.path)
            .collect();
        assert_eq!(paths, described, "{}", law.name);
        for (path, value) in leaves {
            let parameter = law
                .parameters
                .iter()
                .find(|parameter| parameter.path == path)
                .unwrap();
            let fits = match parameter.dimension {
                Dimension::Text => value.is_string(),
                Dimension::Flag => value.is_boolean(),
                Dimension::Law => value.is_object(),
                Dimension::Dimensionless
                | Dimension::Length
                | Dimension::Stress
                | Dimension::Angle => value.is_number(),
            };
            assert!(fits, "{}: {path} = {value}", law.name);
        }
    }
}

/// A parameter with a default may be left out, and the default is what is described.
#[test]
fn defaults_are_those_of_the_laws() {
    let mut tried = BTreeSet::new();
    for law in every_law() {
        let name = law.name();
        let whole = serde_json::to_value(&law).unwrap();
        for parameter in find(name).unwrap().parameters {
            let Some(default) = parameter.default else {
                continue;
            };
            // A law that allows strengthening has values that another default refuses.
            let mut bare = whole.clone();
            bare[name].as_object_mut().unwrap().remove(parameter.path);
            let Ok(law) = serde_json::from_value::<Box<dyn FrictionLaw>>(bare) else {
                continue;
            };
            let read = serde_json::to_value(&law).unwrap();
            assert_eq!(read[name][parameter.path].to_string(), default, "{name}");
            tried.insert((name.to_owned(), parameter.path));
        }
    }
    for law in laws() {
        for parameter in law.parameters {
            let path = (law.name.to_owned(), parameter.path);
            assert_eq!(
                parameter.default.is_some(),
                tried.contains(&path),
                "{path:?}"
            );
        }
    }
}
