//! Imports between the files of a crate, and circles among them.
//!
//! File A imports file B if code of A names something that B defines: by `use`, or by a path that starts at `crate`, `super`,
//! `self`, a child module or a name brought in by `use`. Names are followed through re-exports to the file that defines them.
//! Declaring a module and re-exporting its items (`mod`, `pub use`) is no import, nor is naming a module without anything in it.
//!
//! A path that leads into another subject (`crate::mesh::Point` from outside of `mesh`) imports the file of that module as well,
//! wherever the name is defined.
//!
//! A circle is a set of two or more files each of which reaches all others by imports (a strongly connected component). What a
//! child takes from a module above it (`super::Mesh`) makes no circle between subjects: the child is a part of that module. If the
//! module also uses the child, the two are a circle within a family, which is counted apart. Top-level modules are looked at as wholes
//! too: two of them are a circle if a file of either imports one of the other, though no two files do.

mod names;
mod read;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::source;
use names::Names;
use read::{Module, Place, read};

/// Imports between the files of a crate.
#[derive(Debug, Default)]
pub struct Imports {
    edges: BTreeMap<(String, String), Edge>,
}

/// What one file takes from another.
#[derive(Debug)]
struct Edge {
    names: BTreeSet<String>,
    /// Whether the other file is a module above this one.
    upward: bool,
}

/// Which imports count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counted {
    /// All but those of a child from the modules above it.
    BetweenSubjects,
    /// All.
    WithFamilies,
}

impl Imports {
    /// Reads the crate whose root is `lib.rs` in the folder `source`, or `main.rs` where there is no library; files are named from there.
    ///
    /// # Panics
    /// If a file cannot be read, or is not made of Rust tokens.
    pub fn of(source: &Path) -> Self {
        let files = source::files(source)
            .unwrap_or_else(|cause| panic!("{}: {cause}", source.display()))
            .into_iter()
            .map(|path| {
                let text = fs::read_to_string(&path)
                    .unwrap_or_else(|cause| panic!("{}: {cause}", path.display()));
                let name = path.strip_prefix(source).unwrap_or(&path);
                (name.to_string_lossy().into_owned(), text)
            });
        let has_library = source.join("lib.rs").is_file();
        Self::of_texts(files.filter(|(name, _)| !(has_library && name == "main.rs")))
    }

    fn of_texts(files: impl Iterator<Item = (String, String)>) -> Self {
        let mut modules = BTreeMap::new();
        for (file, text) in files {
            let tokens = source::code(&text).unwrap_or_else(|cause| panic!("{file}: {cause}"));
            let mut place: Place = file
                .trim_end_matches(".rs")
                .split('/')
                .map(str::to_owned)
                .collect();
            let is_root = place == ["lib"] || place == ["main"];
            if is_root || place.last().is_some_and(|last| last == "mod") {
                place.pop();
            }
            read(&file, tokens, &place, &mut modules);
        }
        let names = Names { modules };
        let mut imports = Self::default();
        for (place, module) in &names.modules {
            for path in &module.named {
                let Some(definer) = names.definer(place, path, 0) else {
                    continue;
                };
                let subject = names.subject(place, path);
                let name = path.last().cloned().unwrap_or_default();
                for target in [Some(definer), subject].into_iter().flatten() {
                    imports.add(place, module, target, &name);
                }
            }
        }
        imports
    }

    fn add(&mut self, place: &Place, module: &Module, (target, file): (&Place, &str), name: &str) {
        if file != module.file {
            let ends = (module.file.clone(), file.to_owned());
            self.join(ends, [name.to_owned()], place.starts_with(target));
        }
    }

    /// Adds an import to what one file takes from another, upward only if all of it is.
    fn join(
        &mut self,
        ends: (String, String),
        names: impl IntoIterator<Item = String>,
        upward: bool,
    ) {
        let edge = self.edges.entry(ends).or_insert_with(|| Edge {
            names: BTreeSet::new(),
            upward: true,
        });
        edge.names.extend(names);
        edge.upward &= upward;
    }

    /// The imports between the top-level modules, each with all files below it.
    #[must_use]
    pub fn between_modules(&self) -> Self {
        let mut between = Self::default();
        for ((from, to), edge) in &self.edges {
            let (from, to) = (module_of(from), module_of(to));
            if from != to {
                between.join((from, to), edge.names.iter().cloned(), edge.upward);
            }
        }
        between
    }

    /// Finds the circles of the imports that are `counted`: sets of files in the order of their names.
    pub fn circles(&self, counted: Counted) -> Vec<Vec<String>> {
        let mut imported: BTreeMap<&String, Vec<&String>> = BTreeMap::new();
        for (from, to, _) in self.counted(counted) {
            imported.entry(from).or_default().push(to);
        }
        let reached: BTreeMap<&String, BTreeSet<&String>> = imported
            .keys()
            .map(|&file| (file, reached_from(file, &imported)))
            .collect();
        let mut circles = BTreeSet::new();
        for file in imported.into_keys() {
            let circle: Vec<String> = reached[file]
                .iter()
                .filter(|other| reached.get(**other).is_some_and(|back| back.contains(file)))
                .map(|&other| other.clone())
                .collect();
            if circle.len() > 1 {
                circles.insert(circle);
            }
        }
        circles.into_iter().collect()
    }

    /// Shows what ties the files of a circle, one import a line: `a.rs -> b.rs: names`.
    pub fn ties(&self, circle: &[String], counted: Counted) -> String {
        let inside = self
            .counted(counted)
            .filter(|(from, to, _)| circle.contains(from) && circle.contains(to));
        let lines = inside.map(|(from, to, edge)| {
            let names: Vec<&str> = edge.names.iter().map(String::as_str).collect();
            format!("  {from} -> {to}: {}", names.join(", "))
        });
        lines.collect::<Vec<_>>().join("\n")
    }

    fn counted(&self, counted: Counted) -> impl Iterator<Item = (&String, &String, &Edge)> {
        let kept = move |edge: &Edge| counted == Counted::WithFamilies || !edge.upward;
        self.edges
            .iter()
            .filter(move |(_, edge)| kept(edge))
            .map(|((from, to), edge)| (from, to, edge))
    }
}

/// The top-level module that a file belongs to.
fn module_of(file: &str) -> String {
    let name = file.split('/').next().unwrap_or(file);
    name.trim_end_matches(".rs").to_owned()
}

/// The files that `file` imports, those that these import, and so on.
fn reached_from<'a>(
    file: &'a String,
    imported: &BTreeMap<&String, Vec<&'a String>>,
) -> BTreeSet<&'a String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![file];
    while let Some(from) = open.pop() {
        let next = imported.get(from).into_iter().flatten();
        open.extend(next.filter(|&&to| reached.insert(to)));
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::{Counted, Imports};

    fn read(files: &[(&str, &str)]) -> Imports {
        let files = files
            .iter()
            .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
        Imports::of_texts(files)
    }

    /// The circles, each as its names joined by spaces.
    fn all(counted: Counted, imports: &Imports) -> Vec<String> {
        let circles = imports.circles(counted);
        circles.iter().map(|circle| circle.join(" ")).collect()
    }

    fn circles(files: &[(&str, &str)]) -> Vec<String> {
        all(Counted::BetweenSubjects, &read(files))
    }

    #[test]
    fn two_files_that_name_each_other_are_a_circle() {
        let root = ("lib.rs", "mod a; mod b; mod c;");
        let a = ("a.rs", "use crate::b::{c::D, B as E}; pub struct A;");
        let once = ("b.rs", "pub struct B; pub mod c { pub struct D; }");
        assert!(circles(&[root, a, once]).is_empty());
        for twice in [
            "use super::a::A; pub struct B;",
            "pub struct B(crate::a::A);",
            "use crate::a; pub struct B { a: a::A }",
            "pub struct B; fn f() { vec![super::a::A] }",
            "mod d { use super::super::a::A; } pub struct B;",
        ] {
            assert_eq!(
                circles(&[root, a, ("b.rs", twice)]),
                ["a.rs b.rs"],
                "{twice}"
            );
        }
        let third = ("c.rs", "use crate::a::A; pub struct C;");
        let b = ("b.rs", "use crate::c::C; pub struct B;");
        assert_eq!(circles(&[root, a, b, third]), ["a.rs b.rs c.rs"]);
    }

    #[test]
    fn tests_comments_and_modules_without_names_are_no_imports() {
        let root = ("lib.rs", "mod a; mod b;");
        let a = ("a.rs", "use crate::b::B; pub struct A;");
        for text in [
            "pub struct B; #[cfg(test)] mod tests { use crate::a::A; }",
            "/// Of [`crate::a::A`]. \npub struct B; // crate::a::A",
            "use crate::a; pub struct B; fn f() { \"crate::a::A\" }",
            "pub use crate::a::A; pub struct B;",
        ] {
            assert!(circles(&[root, a, ("b.rs", text)]).is_empty(), "{text}");
        }
    }

    #[test]
    fn a_parent_and_its_child_are_a_circle_within_a_family_if_the_parent_uses_the_child() {
        let root = ("lib.rs", "pub mod a;");
        let child = ("a/b.rs", "use super::A; pub struct B(A); pub fn f() {}");
        let families = |parent: &str| {
            let files = [root, ("a.rs", parent), child];
            assert!(circles(&files).is_empty(), "{parent}");
            all(Counted::WithFamilies, &read(&files))
        };
        assert!(families("mod b; pub use b::{B, f as g}; pub struct A;").is_empty());
        assert_eq!(families("mod b; use b::B; pub struct A;"), ["a.rs a/b.rs"]);
        let called = families("mod b; pub struct A; fn g() { b::f() }");
        assert_eq!(called, ["a.rs a/b.rs"]);
    }

    #[test]
    fn a_program_without_a_library_is_read_from_its_main_file() {
        let files = [
            ("main.rs", "mod a; mod b;"),
            ("a.rs", "use crate::b::B; pub struct A(B);"),
            ("b.rs", "use super::a::A; pub struct B(A);"),
        ];
        assert_eq!(circles(&files), ["a.rs b.rs"]);
    }

    #[test]
    fn modules_are_joined_as_a_family_only_if_all_their_imports_are() {
        let root = (
            "lib.rs",
            "mod a; pub mod c { pub struct D; } pub struct A; fn f() { a::g() }",
        );
        let other = ("a.rs", "mod b; use crate::c::D; pub fn g() {}");
        let child = ("a/b.rs", "use crate::A;");
        let between = read(&[root, other, child]).between_modules();
        assert_eq!(all(Counted::BetweenSubjects, &between), ["a lib"]);
    }

    #[test]
    fn names_are_followed_to_the_file_that_defines_them() {
        let root = ("lib.rs", "mod a; mod c; pub use a::B; pub use c::*;");
        let parent = (
            "a.rs",
            "mod b; pub use self::b::B; use crate::C; pub struct A(C);",
        );
        let child = ("a/b.rs", "pub struct B;");
        let other = ("c.rs", "use crate::B; pub struct C;");
        assert!(circles(&[root, parent, child, other]).is_empty());
        let back = ("a/b.rs", "use crate::C; pub struct B;");
        assert_eq!(circles(&[root, parent, back, other]), ["a/b.rs c.rs"]);
    }

    #[test]
    fn a_path_into_another_subject_imports_it_wherever_the_name_is_defined() {
        let root = ("lib.rs", "mod a; mod c;");
        let parent = (
            "a.rs",
            "mod b; pub use self::b::B; use crate::c::C; pub struct A(C);",
        );
        let other = ("c.rs", "use crate::a::B; pub struct C;");
        let child = ("a/b.rs", "pub struct B;");
        assert_eq!(circles(&[root, parent, child, other]), ["a.rs c.rs"]);
    }

    #[test]
    fn modules_are_a_circle_without_one_of_their_files() {
        let root = ("lib.rs", "mod a; mod b; pub const C: i32 = 1;");
        let files = [
            root,
            ("a.rs", "mod d; pub struct A;"),
            ("a/d.rs", "use crate::{C, b::B}; pub struct D(B);"),
            ("b.rs", "mod e; pub struct B;"),
            ("b/e.rs", "use crate::a::A; pub struct E(A);"),
        ];
        let between = |files| all(Counted::BetweenSubjects, &read(files).between_modules());
        assert!(circles(&files).is_empty());
        assert_eq!(between(&files), ["a b"]);
        assert!(between(&files[..4]).is_empty());
    }

    #[test]
    fn ties_show_the_names() {
        let files = [
            ("a.rs", "use crate::b::B; pub struct A;"),
            ("b.rs", "use crate::a::A; pub struct B;"),
            ("lib.rs", "mod a; mod b;"),
        ];
        let imports = read(&files);
        let ties = imports.ties(
            &imports.circles(Counted::WithFamilies)[0],
            Counted::WithFamilies,
        );
        assert_eq!(ties, "  a.rs -> b.rs: B\n  b.rs -> a.rs: A");
    }
}
