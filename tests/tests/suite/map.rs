//! The map and the territory: ARCHITECTURE.md, README, documents and scenes name what is there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use stickslip::experiment::Experiment;
use stickslip::host::HOST;
use stickslip::scene::{Format, Scene};
use stickslip::sweep::Sweep;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Files below `folder` whose names end in `.extension`, without build products and hidden folders.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        if path.is_dir() {
            if name != "target" && !name.starts_with('.') {
                found.extend(files(&path, extension));
            }
        } else if path.extension().is_some_and(|other| other == extension) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// A row of the map's table: the folder, and what it says that the crate knows of.
struct Room {
    folder: String,
    knows: String,
}

fn rooms() -> Vec<Room> {
    let text = read(&root().join("ARCHITECTURE.md"));
    let rooms = text.split("## Rooms").nth(1).expect("a section on rooms");
    let rows = rooms
        .lines()
        .skip_while(|line| !line.starts_with("| ---"))
        .skip(1);
    rows.take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            Room {
                folder: cells[0].trim_matches('`').trim_end_matches('/').to_owned(),
                knows: cells[cells.len() - 1].to_owned(),
            }
        })
        .collect()
}

fn manifest(folder: &str) -> toml::Table {
    let path = root().join(folder).join("Cargo.toml");
    toml::from_str(&read(&path)).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Short names of the crates of this workspace that a crate is built on, tests aside.
fn dependencies(folder: &str) -> BTreeSet<String> {
    let manifest = manifest(folder);
    let tables = manifest.get("dependencies").and_then(toml::Value::as_table);
    tables
        .into_iter()
        .flat_map(toml::Table::keys)
        .filter_map(|name| match name.strip_prefix("stickslip") {
            Some("") => Some("stickslip".to_owned()),
            Some(rest) => rest.strip_prefix('-').map(str::to_owned),
            None => None,
        })
        .collect()
}

#[test]
fn the_map_shows_every_crate_and_no_other() {
    let mapped: BTreeSet<String> = rooms().into_iter().map(|room| room.folder).collect();
    for folder in &mapped {
        assert!(
            root().join(folder).is_dir(),
            "ARCHITECTURE.md names {folder}, which is not there"
        );
    }
    let mut present: BTreeSet<String> = ["xtask", "tests", "studies", "scenes"]
        .map(str::to_owned)
        .into();
    for parent in ["crates", "examples", "xtask"] {
        for entry in fs::read_dir(root().join(parent)).expect("a readable folder") {
            let entry = entry.expect("a readable entry");
            if entry.path().join("Cargo.toml").is_file() {
                present.insert(format!("{parent}/{}", entry.file_name().to_string_lossy()));
            }
        }
    }
    assert_eq!(present, mapped);
}

#[test]
fn dependencies_are_those_on_the_map() {
    let mut above: BTreeSet<String> = BTreeSet::new();
    for room in rooms() {
        let name = room
            .folder
            .rsplit('/')
            .next()
            .unwrap_or_default()
            .to_owned();
        if ["studies", "scenes"].contains(&room.folder.as_str()) {
            continue;
        }
        let known: BTreeSet<String> = match room.knows.as_str() {
            "all above" => above.clone(),
            "nothing of this workspace" => BTreeSet::new(),
            list => list
                .split(", ")
                .map(|name| name.split(' ').next().unwrap_or_default().to_owned())
                .collect(),
        };
        let used = dependencies(&room.folder);
        let right = if room.knows == "all above" {
            used.is_subset(&known)
        } else {
            used == known
        };
        assert!(right, "{}: uses {used:?}, knows of {known:?}", room.folder);
        assert!(
            known.is_subset(&above),
            "{}: {known:?} are not all above it",
            room.folder
        );
        above.insert(name);
    }
}

/// The README's table of crates shows those that may be published.
#[test]
fn the_readme_lists_the_crates_for_publication() {
    let readme = read(&root().join("README.md"));
    let table = readme
        .split("## Crates")
        .nth(1)
        .expect("a section on crates");
    let listed: BTreeSet<&str> = table
        .lines()
        .skip_while(|line| !line.starts_with("| ---"))
        .skip(1)
        .take_while(|line| line.starts_with('|'))
        .filter_map(|line| line.split('`').nth(1))
        .collect();
    let folders = fs::read_dir(root().join("crates")).expect("a readable folder");
    let published: BTreeSet<String> = folders
        .map(|entry| entry.expect("a readable entry").file_name())
        .map(|folder| manifest(&format!("crates/{}", folder.to_string_lossy())))
        .filter(|manifest| manifest["package"].get("publish") != Some(&toml::Value::from(false)))
        .filter_map(|manifest| Some(manifest["package"].get("name")?.as_str()?.to_owned()))
        .collect();
    assert_eq!(listed, published.iter().map(String::as_str).collect());
}

/// Words of a text that look like paths: characters of file names with at least one slash.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let separator = |c: char| !(c.is_ascii_alphanumeric() || "._-/*:#".contains(c));
    text.split(separator)
        .map(|word| word.trim_end_matches(['.', '/', ':']))
        .filter(|word| word.contains('/') && !word.contains("//"))
        // Patterns and placeholders name no file of ours.
        .filter(|word| !word.contains('*') && !word.contains("NAME"))
        .map(|word| word.split('#').next().unwrap_or_default())
}

/// Targets of links and images, `[text](target)`, that lead to files.
fn links(text: &str) -> impl Iterator<Item = &str> {
    text.split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .filter(|target| {
            !target.contains("://") && !target.starts_with('#') && !target.starts_with("mailto:")
        })
        .map(|target| target.split(['#', ' ']).next().unwrap_or_default())
}

#[test]
fn documents_refer_to_files_that_exist() {
    let root = root();
    let documents = files(&root, "md");
    assert!(documents.len() > 4, "{documents:?}");
    let mut missing = Vec::new();
    for document in &documents {
        let text = read(document);
        let folder = document.parent().expect("a file in a folder");
        for target in links(&text) {
            if !folder.join(target).exists() {
                missing.push(format!("{}: link to {target}", document.display()));
            }
        }
        for path in paths(&text) {
            let first = path.split('/').next().unwrap_or_default();
            // Only what starts in a folder of ours; others' paths, URLs and fractions are not claims about this repository, and what
            // is built is not there on a fresh clone.
            let bases = [root.clone(), root.join("crates"), folder.to_owned()];
            let claims: Vec<_> = bases
                .iter()
                .filter(|base| !["", "..", "target"].contains(&first) && base.join(first).is_dir())
                .collect();
            if !claims.is_empty() && !claims.iter().any(|base| base.join(path).exists()) {
                missing.push(format!("{}: {path}", document.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// Every path of the map leads to a file or folder from the root or from `crates`, so that a reader need not guess the crate.
#[test]
fn paths_of_the_map_are_complete() {
    let text = read(&root().join("ARCHITECTURE.md"));
    let quoted = text.split('`').skip(1).step_by(2);
    let named = quoted.filter(|word| word.contains('/') && !word.contains([' ', '\n', '*']));
    let mut count = 0;
    for path in named.filter(|word| !word.contains("NAME")) {
        let bases = [root(), root().join("crates")];
        let resolves = bases.iter().any(|base| base.join(path).exists());
        assert!(resolves, "ARCHITECTURE.md names {path}, which is not there");
        count += 1;
    }
    assert!(count > 20, "{count} paths");
}

/// That linked pictures exist is part of `documents_refer_to_files_that_exist`.
#[test]
fn every_picture_in_docs_is_shown_by_a_document() {
    let root = root();
    let mut shown = BTreeSet::new();
    for document in files(&root, "md") {
        let folder = document.parent().expect("a file in a folder");
        let text = read(&document);
        let found = links(&text).filter_map(|target| folder.join(target).canonicalize().ok());
        shown.extend(found);
    }
    let pictures = ["png", "svg"].map(|extension| files(&root.join("docs"), extension));
    let unseen: Vec<_> = pictures
        .into_iter()
        .flatten()
        .filter_map(|picture| picture.canonicalize().ok())
        .filter(|picture| !shown.contains(picture))
        .collect();
    assert!(unseen.is_empty(), "no document shows {unseen:?}");
}

/// The README's table of scenes and its folder agree; `-b` beside `a.toml` stands for the file with that ending.
#[test]
fn the_readme_lists_every_scene() {
    let readme = read(&root().join("README.md"));
    let mut listed = BTreeSet::new();
    for row in readme
        .lines()
        .filter(|line| line.starts_with('|') && line.contains(".toml`"))
    {
        let cell = row.split('|').nth(1).unwrap_or_default();
        let mut before = String::new();
        for name in cell.split('`').skip(1).step_by(2) {
            let full = match name.strip_prefix('-') {
                Some(ending) => {
                    let stem = before.trim_end_matches(".toml");
                    let (stem, _) = stem.rsplit_once('-').unwrap_or((stem, ""));
                    format!("{stem}-{}.toml", ending.trim_end_matches(".toml"))
                }
                None => name.to_owned(),
            };
            before.clone_from(&full);
            listed.insert(full);
        }
    }
    let present: BTreeSet<String> = fs::read_dir(root().join("scenes"))
        .expect("a readable folder")
        .map(|entry| {
            entry
                .expect("a readable entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .filter(|name| {
            Path::new(name)
                .extension()
                .is_some_and(|extension| extension == "toml")
        })
        .collect();
    assert_eq!(listed, present);
}

/// Fenced blocks of a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let fence = format!("```{language}\n");
    text.split(fence.as_str())
        .skip(1)
        .filter_map(|rest| rest.split("\n```").next())
        .collect()
}

/// Every TOML block of a document parses, and one that gives a version is a whole scene and passes its check.
#[test]
fn toml_in_documents_is_right() {
    let scenes = root().join("scenes");
    let mut whole = 0;
    for document in files(&root(), "md") {
        for block in blocks(&read(&document), "toml") {
            let table: Result<toml::Table, _> = toml::from_str(block);
            let table = table.unwrap_or_else(|error| panic!("{}: {error}", document.display()));
            if table.contains_key("version") && table.contains_key("bodies") {
                let name = document.display().to_string();
                let scene =
                    Scene::from_text_on(block, Format::Toml, &name, &scenes, &[] as &[&str], HOST);
                scene.unwrap_or_else(|error| panic!("{}: {error}\n{block}", document.display()));
                whole += 1;
            }
        }
    }
    assert!(whole > 0, "no document shows a scene");
}

/// Whether a file has a table or list at its top: only sweeps have `axes`, only experiments a `specimen`.
fn has(path: &Path, key: &str) -> bool {
    let table: toml::Table = toml::from_str(&read(path)).expect("a table");
    table.contains_key(key)
}

#[test]
fn every_experiment_is_read() {
    let files = files(&root().join("scenes"), "toml");
    let experiments: Vec<_> = files.iter().filter(|path| has(path, "specimen")).collect();
    assert!(experiments.len() >= 4);
    for path in experiments {
        let experiment = Experiment::from_file(path, &[] as &[&str], HOST);
        experiment.unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn every_scene_passes_its_check_in_toml_and_json_alike() {
    let (sweeps, scenes): (Vec<_>, Vec<_>) = files(&root().join("scenes"), "toml")
        .into_iter()
        .filter(|path| !has(path, "specimen"))
        .partition(|path| has(path, "axes"));
    assert!(scenes.len() > 10);
    for path in sweeps {
        let sweep = Sweep::from_file(&path, &[] as &[&str], HOST);
        sweep.unwrap_or_else(|error| panic!("{error}"));
    }
    for path in scenes {
        let scene =
            Scene::from_file(&path, &[] as &[&str], HOST).unwrap_or_else(|error| panic!("{error}"));
        let table: serde_json::Value = toml::from_str(&read(&path)).expect("what was read before");
        let json = serde_json::to_string_pretty(&table).expect("tables with text keys");
        let base = path.parent().expect("a file in a folder");
        let name = path.with_extension("json").display().to_string();
        let other = Scene::from_text_on(&json, Format::Json, &name, base, &[] as &[&str], HOST)
            .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(scene.hash, other.hash, "{}", path.display());
        let resolved = Scene::from_text_on(
            scene.resolved(),
            Format::Toml,
            &name,
            base,
            &[] as &[&str],
            HOST,
        )
        .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(scene.hash, resolved.hash, "{}", path.display());
    }
}
