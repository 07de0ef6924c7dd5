//! Scenes as texts: TOML, and JSON with its keys in another order.

use serde_json::Value;

/// The scene as TOML.
///
/// # Errors
/// In words, if the scene holds what TOML cannot say.
pub(crate) fn toml(scene: &Value) -> Result<String, String> {
    toml::to_string(scene).map_err(|error| error.to_string())
}

/// The scene as JSON with the keys of every table from last to first.
pub(super) fn backwards(value: &Value) -> String {
    match value {
        Value::Object(map) => {
            let entries = map.iter().rev();
            let list: Vec<String> = entries
                .map(|(key, value)| format!("{}:{}", Value::from(key.as_str()), backwards(value)))
                .collect();
            format!("{{{}}}", list.join(","))
        }
        Value::Array(list) => {
            let list: Vec<String> = list.iter().map(backwards).collect();
            format!("[{}]", list.join(","))
        }
        other => other.to_string(),
    }
}

/// The scene of a TOML text.
///
/// # Errors
/// In words, where the text is no TOML.
pub(super) fn from_toml(text: &str) -> Result<Value, String> {
    toml::from_str(text).map_err(|error| error.to_string())
}
