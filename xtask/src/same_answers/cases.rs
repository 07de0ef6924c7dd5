//! The files that are run, and how.

use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

use crate::publish::TaskError;

/// Most cases of a sweep that is run whole.
const MOST_CASES: usize = 40;

/// A file and the subcommand that runs it.
#[derive(Debug, PartialEq)]
pub(super) struct Case {
    /// The shipped file, from the root of the workspace.
    pub(super) file: PathBuf,
    /// The file that is run: a smaller copy of a large sweep.
    run: PathBuf,
    verb: &'static str,
}

impl Case {
    /// The folder of its results: the file below `scenes`, without its ending.
    pub(super) fn name(&self) -> String {
        let file = self.file.with_extension("");
        let file = file.strip_prefix("scenes").unwrap_or(&file);
        file.to_string_lossy().into_owned()
    }

    /// Arguments of the command; pictures are left out where that can be asked.
    pub(super) fn arguments(&self) -> Vec<String> {
        let mut arguments = vec![
            self.verb.to_owned(),
            self.run.to_string_lossy().into_owned(),
        ];
        if self.verb == "run" {
            arguments.extend(["--set".to_owned(), "output.figures=false".to_owned()]);
        }
        arguments
    }
}

/// The `chosen` files, or all below `scenes` but experiments that fit laws. Copies of large sweeps go into `work`.
pub(super) fn all(root: &Path, work: &Path, chosen: &[PathBuf]) -> Result<Vec<Case>, TaskError> {
    let mut cases = Vec::new();
    if chosen.is_empty() {
        for file in toml_files(&root.join("scenes"))? {
            let table: Table = toml::from_str(&fs::read_to_string(&file)?)?;
            if !table.contains_key("laws") {
                cases.push(case(root, work, &file, &table)?);
            }
        }
    }
    for file in chosen {
        let file = file
            .canonicalize()
            .map_err(|cause| format!("{}: {cause}", file.display()))?;
        let table = toml::from_str(&fs::read_to_string(&file)?)?;
        cases.push(case(root, work, &file, &table)?);
    }
    Ok(cases)
}

fn toml_files(folder: &Path) -> Result<Vec<PathBuf>, TaskError> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(toml_files(&path)?);
        } else if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn case(root: &Path, work: &Path, file: &Path, table: &Table) -> Result<Case, TaskError> {
    let shipped = file.strip_prefix(root).unwrap_or(file).to_owned();
    let mut run = shipped.clone();
    let verb = if table.contains_key("axes") {
        if let Some(smaller) = smaller(table, file) {
            let copy = work.join(file.file_name().unwrap_or_default());
            fs::write(&copy, toml::to_string(&smaller)?)?;
            run = PathBuf::from(copy.strip_prefix(root).unwrap_or(&copy));
        }
        "joint"
    } else if table.contains_key("region") {
        "identify"
    } else if table.contains_key("specimen") {
        "fringes"
    } else {
        "run"
    };
    Ok(Case {
        file: shipped,
        run,
        verb,
    })
}

/// A sweep with the first and the last value of each axis, if it has many cases.
fn smaller(sweep: &Table, file: &Path) -> Option<Table> {
    let mut sweep = sweep.clone();
    let scene = sweep.get("scene")?.as_str()?;
    let scene = file.parent()?.join(scene);
    sweep.insert(
        "scene".to_owned(),
        Value::from(scene.to_string_lossy().into_owned()),
    );
    let axes = sweep.get_mut("axes")?.as_array_mut()?;
    let mut cases = 1;
    for axis in axes {
        let axis = axis.as_table_mut()?;
        if let Some(Value::Array(values)) = axis.get_mut("values") {
            cases *= values.len();
            let last = values.pop();
            values.truncate(1);
            values.extend(last);
        } else if let Some(Value::Integer(count)) = axis.get_mut("count") {
            cases *= usize::try_from(*count).ok()?;
            *count = 2.min(*count);
        }
    }
    (cases > MOST_CASES).then_some(sweep)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Case, case, smaller};

    #[test]
    fn large_sweeps_are_cut_to_the_ends_of_their_axes() {
        let axis = "[[axes]]\nkey = \"a\"\nvalues = [1, 2, 3]\n";
        let counted = "[[axes]]\nkey = \"b\"\nfrom = 0\nto = 1\ncount = 20\n";
        let text = |axes: &str| format!("scene = \"base.toml\"\n{axes}");
        let sweep = |axes: &str| toml::from_str(&text(axes)).expect("a table");
        let file = Path::new("/scenes/sweep.toml");
        assert!(smaller(&sweep(axis), file).is_none());
        let cut = smaller(&sweep(&format!("{axis}{counted}")), file).expect("60 cases");
        assert_eq!(cut["scene"].as_str(), Some("/scenes/base.toml"));
        assert_eq!(cut["axes"][0]["values"].to_string(), "[1, 3]");
        assert_eq!(cut["axes"][1]["count"].as_integer(), Some(2));
    }

    #[test]
    fn each_kind_of_file_has_its_subcommand() {
        let verb = |text: &str| {
            let table = toml::from_str(text).expect("a table");
            let file = Path::new("/tree/scenes/a/b.toml");
            case(Path::new("/tree"), Path::new("/none"), file, &table).expect("a case")
        };
        let expected = |verb| Case {
            file: "scenes/a/b.toml".into(),
            run: "scenes/a/b.toml".into(),
            verb,
        };
        assert_eq!(verb("bodies = 1"), expected("run"));
        assert_eq!(verb("axes = []"), expected("joint"));
        assert_eq!(verb("specimen = 1"), expected("fringes"));
        assert_eq!(verb("specimen = 1\nregion = 1"), expected("identify"));
        assert_eq!(expected("run").name(), "a/b");
    }
}
