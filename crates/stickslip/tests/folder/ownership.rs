//! What `--force` may replace, and that a folder is whole whenever somebody looks or a process is killed.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use stickslip::folder::{
    FolderError, LIST, MARKER, Overwrite, ResultFolder, Results, SharedFolder, write_atomic,
};

/// Older results are known by a summary that says `ours` and by tables.
const FORCE: Overwrite = Overwrite::Force(|summary| match summary {
    b"ours" => Some(Results::Same(|name| {
        Path::new(name).extension().is_some_and(|end| end == "csv") || name == MARKER
    })),
    b"theirs" => Some(Results::Other("`another command`")),
    _ => None,
});
const TABLES: [&str; 3] = ["a.csv", "deep/b.csv", "deep/er/c.csv"];

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

fn write(target: &Path, content: &str) {
    let results = ResultFolder::create(target, FORCE).unwrap();
    for name in TABLES {
        results.write(name, content.as_bytes()).unwrap();
    }
    results.finish(content).unwrap();
}

/// What all files of a whole folder say.
fn content(target: &Path) -> String {
    let said: BTreeSet<String> = [MARKER]
        .into_iter()
        .chain(TABLES)
        .map(|name| fs::read_to_string(target.join(name)).unwrap())
        .collect();
    assert_eq!(said.len(), 1, "{said:?}");
    said.into_iter().next().unwrap()
}

fn foreign(target: &Path) -> Vec<String> {
    let error = ResultFolder::create(target, FORCE).unwrap_err();
    let FolderError::Foreign { files, .. } = &error else {
        panic!("{error}")
    };
    for file in files {
        assert!(error.to_string().contains(file), "{error}");
    }
    files.clone()
}

#[test]
fn files_that_were_not_written_are_named_and_stay() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "old");
    fs::write(target.join("thesis.tex"), "mine").unwrap();
    fs::write(target.join("deep/d.csv"), "mine").unwrap();
    fs::create_dir_all(target.join(".git/objects")).unwrap();
    fs::create_dir(target.join("empty")).unwrap();
    let expected = [".git/", "deep/d.csv", "empty/", "thesis.tex"];
    assert_eq!(foreign(&target), expected);
    assert_eq!(content(&target), "old");
    assert_eq!(names(home.path()).len(), 1);
    for name in expected {
        let path = target.join(name);
        if path.is_dir() {
            fs::remove_dir_all(path).unwrap();
        } else {
            fs::remove_file(path).unwrap();
        }
    }
    write(&target, "new");
    assert_eq!(content(&target), "new");
}

#[cfg(unix)]
#[test]
fn links_in_the_place_of_results_are_not_followed() {
    let home = tempfile::tempdir().unwrap();
    let (target, other) = (home.path().join("results"), home.path().join("other"));
    write(&target, "old");
    fs::rename(target.join("deep"), &other).unwrap();
    std::os::unix::fs::symlink(&other, target.join("deep")).unwrap();
    assert_eq!(foreign(&target), ["deep"]);
    assert!(other.join("b.csv").is_file());
}

#[test]
fn older_results_are_known_by_their_summary_and_their_names() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    fs::create_dir_all(target.join("deep")).unwrap();
    fs::write(target.join(MARKER), "ours").unwrap();
    fs::write(target.join("deep/b.csv"), "old").unwrap();
    fs::write(target.join("notes.txt"), "mine").unwrap();
    assert_eq!(foreign(&target), ["notes.txt"]);
    fs::remove_file(target.join("notes.txt")).unwrap();
    write(&target, "new");
    assert_eq!(content(&target), "new");
}

#[test]
fn a_summary_of_something_else_makes_no_results() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    fs::create_dir_all(target.join(".git")).unwrap();
    fs::write(target.join(MARKER), "{}").unwrap();
    fs::write(target.join("letter.odt"), "mine").unwrap();
    assert_eq!(foreign(&target), [".git/", "letter.odt", MARKER]);
    // A list that this program did not write says nothing.
    fs::write(target.join(LIST), "letter.odt\nsummary.json\n").unwrap();
    assert_eq!(foreign(&target).len(), 4);
}

#[test]
fn results_of_another_command_are_not_replaced() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "theirs");
    let error = ResultFolder::create(&target, FORCE).unwrap_err();
    assert!(matches!(error, FolderError::OtherResults { .. }), "{error}");
    assert!(error.to_string().contains("`another command`"), "{error}");
    assert_eq!(content(&target), "theirs");
}

#[test]
fn a_folder_whose_files_the_user_deleted_is_still_replaced() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "old");
    fs::remove_file(target.join("deep/b.csv")).unwrap();
    fs::remove_file(target.join("deep/er/c.csv")).unwrap();
    write(&target, "new");
    assert_eq!(content(&target), "new");
}

#[test]
fn a_deletion_that_was_killed_is_ended_by_the_next_run() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "old");
    // The old results, as far as they were deleted.
    let half = home.path().join(".results.partial-1-0");
    fs::rename(&target, &half).unwrap();
    fs::remove_file(half.join("deep/b.csv")).unwrap();
    fs::remove_file(half.join("deep/er/c.csv")).unwrap();
    write(&target, "new");
    assert_eq!(names(home.path()), ["results".to_owned()].into());
}

#[test]
fn a_file_that_appears_during_the_run_is_kept() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "old");
    let results = ResultFolder::create(&target, FORCE).unwrap();
    results.write("a.csv", b"new").unwrap();
    fs::write(target.join("mine"), "1").unwrap();
    let error = results.finish("new").unwrap_err();
    let FolderError::NotPlaced { kept, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(fs::read(kept.join("a.csv")).unwrap(), b"new");
    assert_eq!(content(&target), "old");
    // What is kept for the user is no leftover.
    fs::remove_file(target.join("mine")).unwrap();
    write(&target, "newest");
    assert!(kept.join("a.csv").is_file());
}

#[test]
fn leftovers_of_dead_processes_go_and_those_of_living_ones_stay() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    let living = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    let dead = home.path().join(".results.partial-1-0");
    fs::create_dir_all(dead.join("figures")).unwrap();
    fs::write(home.path().join(".results.partial-1-1"), "half").unwrap();
    let others = [".results.partial-mine", ".other.partial-1-0"];
    for name in others {
        fs::write(home.path().join(name), "").unwrap();
    }
    let second = ResultFolder::create(&target, Overwrite::Refuse).unwrap();
    assert!(living.staging().is_dir() && !dead.exists());
    assert_eq!(names(home.path()).len(), 2 + others.len());
    drop((living, second));
    let table = home.path().join("table.csv");
    fs::write(home.path().join(".table.csv.partial-1-0"), "half").unwrap();
    write_atomic(&table, b"whole").unwrap();
    assert_eq!(names(home.path()).len(), 1 + others.len());
}

#[cfg(target_os = "linux")]
#[test]
fn a_reader_never_finds_the_folder_missing() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    write(&target, "0");
    let done = AtomicBool::new(false);
    let missing = std::thread::scope(|scope| {
        let reader = scope.spawn(|| {
            let mut missing = 0;
            while !done.load(Ordering::Relaxed) {
                missing += usize::from(!target.is_dir());
            }
            missing
        });
        for turn in 0..100 {
            write(&target, &turn.to_string());
        }
        done.store(true, Ordering::Relaxed);
        reader.join().unwrap()
    });
    assert_eq!(missing, 0);
}

/// Names the folder that the child process replaces.
const CHILD: &str = "STICKSLIP_REPLACES";

/// The child process of the test below.
#[test]
fn replaces_until_it_is_killed() {
    let Some(target) = std::env::var_os(CHILD) else {
        return;
    };
    for turn in 0.. {
        write(Path::new(&target), &format!("turn {turn}"));
    }
}

fn child(target: &Path) -> Child {
    Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "ownership::replaces_until_it_is_killed"])
        .env(CHILD, target)
        .stdout(Stdio::null())
        .spawn()
        .unwrap()
}

#[test]
fn a_killed_process_leaves_the_old_folder_or_the_new_one() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("results");
    for kill in 0..25_u64 {
        let start = Instant::now();
        let mut child = child(&target);
        while !target.exists() && start.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(1));
        }
        // Any place of the child's turn, which takes some milliseconds.
        std::thread::sleep(Duration::from_micros(10_000 + 1_370 * (kill * 7 % 25)));
        child.kill().unwrap();
        child.wait().unwrap();
        content(&target);
        drop(ResultFolder::create(&target, FORCE).unwrap());
        assert_eq!(names(home.path()).len(), 1, "{:?}", names(home.path()));
    }
}

#[test]
fn a_shared_folder_replaces_its_own_files_only() {
    let home = tempfile::tempdir().unwrap();
    let path = home.path().join("docs");
    fs::create_dir(&path).unwrap();
    fs::write(path.join("README.md"), "mine").unwrap();
    let mut shared = SharedFolder::open(&path, |_| false).unwrap();
    shared.write("figures/a.svg", b"1").unwrap();
    let error = shared.write("README.md", b"new").unwrap_err();
    assert!(
        matches!(&error, FolderError::Foreign { files, .. } if files == &["README.md"]),
        "{error}"
    );
    assert!(matches!(
        SharedFolder::open(&path, |_| false),
        Err(FolderError::Busy { .. })
    ));
    drop(shared);
    // Its own file, of an earlier process.
    let mut shared = SharedFolder::open(&path, |_| false).unwrap();
    shared.write("figures/a.svg", b"2").unwrap();
    assert_eq!(fs::read(path.join("figures/a.svg")).unwrap(), b"2");
    assert_eq!(fs::read(path.join("README.md")).unwrap(), b"mine");
    drop(shared);
    // A folder without a list owns what its maker knows by name.
    fs::remove_file(path.join(LIST)).unwrap();
    let mut shared = SharedFolder::open(&path, |name| name.starts_with("figures/")).unwrap();
    shared.write("figures/a.svg", b"3").unwrap();
    assert!(shared.write("README.md", b"new").is_err());
    // It is no folder that a run may replace.
    drop(shared);
    let error = ResultFolder::create(&path, FORCE).unwrap_err();
    assert!(matches!(error, FolderError::OtherResults { .. }), "{error}");
}
