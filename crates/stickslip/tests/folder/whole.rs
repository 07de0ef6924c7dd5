//! Results appear whole or not at all, and nothing else is ever deleted.

use std::error::Error as _;
use std::fs;
use std::path::Path;

use stickslip::folder::{
    Abandoned, FolderError, LIST, MARKER, Overwrite, ResultFolder, write_atomic, write_new,
};

/// Replaces what a list says is its own.
const FORCE: Overwrite = Overwrite::Force(|_| None);

/// Names in a folder, hidden ones too, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn finished(path: &Path, overwrite: Overwrite, content: &str) {
    let results = ResultFolder::create(path, overwrite).unwrap();
    results.write("figures/a.svg", content.as_bytes()).unwrap();
    results.finish("{}").unwrap();
}

#[test]
fn results_appear_only_when_finished() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("deep/er/results");
    let results = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    results.write("table.csv", b"1").unwrap();
    results.write("figures/a.svg", b"<svg/>").unwrap();
    assert!(!target.exists());
    assert_eq!(results.path(), target);
    assert_eq!(results.finish("{\"ok\":true}").unwrap(), target);
    assert_eq!(names(&target), [LIST, "figures", MARKER, "table.csv"]);
    assert_eq!(fs::read(target.join(MARKER)).unwrap(), b"{\"ok\":true}");
    assert_eq!(names(target.parent().unwrap()), ["results"]);
}

#[test]
fn a_run_that_fails_leaves_no_trace() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    {
        let results = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
        results.write("table.csv", b"1").unwrap();
        assert_eq!(names(home.path()).len(), 1);
    }
    assert!(names(home.path()).is_empty());
}

#[test]
fn an_existing_folder_is_refused_before_the_run() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    finished(&target, Overwrite::Refuse, "old");
    let error = ResultFolder::create(&target, Overwrite::Refuse).unwrap_err();
    assert!(matches!(error, FolderError::Exists { .. }));
    assert!(
        error
            .to_string()
            .contains("results' exists; choose another folder")
    );
    assert_eq!(names(home.path()), ["results"]);
}

#[test]
fn force_replaces_results_only_when_the_new_ones_are_complete() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    finished(&target, Overwrite::Refuse, "old");
    let content = || fs::read_to_string(target.join("figures/a.svg")).unwrap();
    let failed = ResultFolder::create(&target, FORCE).unwrap();
    failed.write("figures/a.svg", b"half").unwrap();
    assert_eq!(content(), "old");
    drop(failed);
    assert_eq!(content(), "old");
    finished(&target, FORCE, "new");
    assert_eq!(content(), "new");
    assert_eq!(names(home.path()), ["results"]);
}

#[test]
fn force_never_deletes_what_is_not_a_result() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("thesis");
    fs::create_dir(&target).unwrap();
    finished(&target, Overwrite::Refuse, "an empty folder may be used");
    let other = home.path().join("other");
    fs::create_dir(&other).unwrap();
    fs::write(other.join("chapter.tex"), "years of work").unwrap();
    let error = ResultFolder::create(&other, FORCE).unwrap_err();
    assert!(
        matches!(&error, FolderError::Foreign { files, .. } if files == &["chapter.tex"]),
        "{error}"
    );
    assert_eq!(names(&other), ["chapter.tex"]);
    let file = home.path().join("file");
    fs::write(&file, "text").unwrap();
    let error = ResultFolder::create(&file, FORCE).unwrap_err();
    assert!(matches!(error, FolderError::NotAFolder { .. }));
    assert_eq!(names(home.path()), ["file", "other", "thesis"]);
}

#[test]
fn results_are_kept_when_the_target_is_taken_meanwhile() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    let results = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    results.write("table.csv", b"long run").unwrap();
    fs::create_dir(&target).unwrap();
    fs::write(target.join("mine"), "appeared during the run").unwrap();
    let error = results.finish("{}").unwrap_err();
    let FolderError::NotPlaced { kept, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(fs::read(kept.join("table.csv")).unwrap(), b"long run");
    assert_eq!(names(&target), ["mine"]);
    assert!(error.source().is_some());
}

#[test]
fn a_place_that_cannot_be_written_is_found_before_the_run() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("file");
    fs::write(&file, "text").unwrap();
    let error = ResultFolder::create(&file.join("results"), Overwrite::Refuse).unwrap_err();
    assert!(
        matches!(&error, FolderError::NotAFolder { file: found, .. } if *found == file),
        "{error}"
    );
    let error = ResultFolder::create(Path::new("/proc/results"), Overwrite::Refuse).unwrap_err();
    assert!(matches!(error, FolderError::Unwritable { .. }), "{error}");
    for nameless in ["", "/proc/self/.."] {
        assert!(ResultFolder::create(Path::new(nameless), Overwrite::Refuse).is_err());
    }
}

#[test]
fn names_cannot_lead_out_of_the_folder() {
    let home = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(&home.path().join("results"), Overwrite::Refuse).unwrap();
    for name in [
        "../escape",
        "/etc/passwd",
        "a/../../b",
        "",
        ".",
        "a\nb",
        MARKER,
        LIST,
    ] {
        let error = results.write(name, b"").unwrap_err();
        assert!(matches!(error, FolderError::Name { .. }), "{name}: {error}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_stays_a_link() {
    let home = tempfile::tempdir().unwrap();
    let (real, link) = (home.path().join("real"), home.path().join("link"));
    finished(&real, Overwrite::Refuse, "old");
    std::os::unix::fs::symlink(&real, &link).unwrap();
    finished(&link, FORCE, "new");
    assert!(link.is_symlink());
    assert_eq!(fs::read(real.join("figures/a.svg")).unwrap(), b"new");
}

#[test]
fn single_files_are_replaced_whole() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("chart.svg");
    write_atomic(&file, b"one").unwrap();
    write_atomic(&file, b"two").unwrap();
    assert_eq!(fs::read(&file).unwrap(), b"two");
    assert!(matches!(
        write_atomic(home.path(), b"x"),
        Err(FolderError::Unwritable { .. })
    ));
    assert!(matches!(
        write_atomic(&file.join("x"), b"x"),
        Err(FolderError::Unwritable { .. })
    ));
    assert_eq!(names(home.path()), ["chart.svg"]);
}

#[test]
fn an_abandoned_folder_is_gone_and_takes_no_more_files() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    let results = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    results.write("table.csv", b"1").unwrap();
    let handle = results.handle();
    let waiting = handle.abandon();
    assert!(matches!(waiting, Abandoned::Deleted(_)));
    drop(waiting);
    assert!(names(home.path()).is_empty());
    let error = results.write("figures/a.svg", b"2").unwrap_err();
    assert!(matches!(error, FolderError::Abandoned { .. }), "{error}");
    assert!(matches!(handle.abandon(), Abandoned::TooLate));
    assert!(results.finish("{}").is_err());
    assert!(names(home.path()).is_empty());
}

#[test]
fn complete_results_are_not_abandoned() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    let results = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    let handle = results.handle();
    results.finish("{}").unwrap();
    assert!(matches!(handle.abandon(), Abandoned::TooLate));
    assert_eq!(names(&target), [LIST, MARKER]);
}

#[test]
fn a_new_file_is_written_whole_and_replaces_none() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("scene.toml");
    write_new(&file, b"one").unwrap();
    let error = write_new(&file, b"two").unwrap_err();
    assert!(matches!(error, FolderError::Exists { .. }), "{error}");
    assert_eq!(fs::read(&file).unwrap(), b"one");
    assert!(write_new(&home.path().join("none/scene.toml"), b"one").is_err());
    assert_eq!(names(home.path()), ["scene.toml"]);
}
