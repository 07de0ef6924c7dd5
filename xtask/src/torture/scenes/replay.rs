//! Scenes that failed once, asked again.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use super::sample::{Sample, Verdict, data_folder, run};
use super::{checks, spelling};

/// Makes the checks on the scene at `path`: the one that its title names, or all if it names none. One line for each, and whether none
/// failed.
///
/// # Errors
/// In words, if the file cannot be read or the scene has no answer.
pub(crate) fn replay(path: &Path) -> Result<(String, bool), String> {
    let text =
        std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let value: Value = if path
        .extension()
        .is_some_and(|extension| extension == "json")
    {
        serde_json::from_str(&text).map_err(|error| error.to_string())?
    } else {
        spelling::from_toml(&text)?
    };
    let title = value
        .get("title")
        .and_then(Value::as_str)
        .unwrap_or_default()
        .to_owned();
    let sample = sample(value)?;
    let named = title.split(':').next().unwrap_or_default();
    let any = checks().any(|check| check.name == named);
    let (mut lines, mut clean) = (String::new(), true);
    for check in checks().filter(|check| !any || check.name == named) {
        let verdict = (check.verdict)(&sample);
        clean &= !matches!(verdict, Verdict::Fails(_));
        if verdict != Verdict::Beside {
            // Writing into a string does not fail.
            let _ = writeln!(lines, "{:15} {verdict:?}", check.name);
        }
    }
    Ok((lines, clean))
}

fn sample(value: Value) -> Result<Sample, String> {
    let scene = super::sample::read(&value.to_string(), stickslip::scene::Format::Json).map_err(
        |none| {
            format!(
                "{} (tables are looked for in {})",
                none.describe(),
                data_folder().display()
            )
        },
    )?;
    let results = run(&scene).map_err(|none| none.describe())?;
    Ok(Sample {
        value,
        scene,
        results,
    })
}
