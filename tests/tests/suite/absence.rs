//! What must not be: the invariants of absence in ARCHITECTURE.md, tested by reading sources and manifests.
//!
//! A row of [`PATHS`] names Rust paths and the only places that may use them; a row of [`CRATES`] names a dependency and the only
//! manifests that may list it. Comments, text and test modules do not count.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use stickslip_tests::source;

/// Sources of the crates that take and return values only.
const LIBRARIES: &[&str] = &[
    "crates/fem-core/src",
    "crates/friction/src",
    "crates/contact/src",
    "crates/series/src",
    "crates/mesher/src",
    "crates/mesh-files/src",
    "crates/laminate/src",
    "crates/joint/src",
    "crates/hybrid/src",
    "crates/text/src",
    "crates/units/src",
    "crates/report/src",
    "crates/document/src",
    "crates/scene/src",
    "crates/experiment/src",
    "crates/results/src",
    "crates/engine/src",
    "crates/ladder/src",
    "crates/measure/src",
    "crates/present/src",
    "crates/experiment-pages/src",
];

/// All Rust code of the workspace.
const EVERYTHING: &[&str] = &["crates", "tests", "xtask", "examples"];

/// Rust paths that stand nowhere below some folders but in a few places.
struct Absence {
    /// What must be absent.
    what: &'static str,
    /// Beginnings of paths (`std::fs`) and macros (`println!`).
    marks: &'static [&'static str],
    /// Folders whose code is read.
    below: &'static [&'static str],
    /// Files and folders that may, by the beginning of their names.
    except: &'static [&'static str],
}

const PATHS: &[Absence] = &[
    Absence {
        what: "faer outside of its wrapper",
        marks: &["faer"],
        below: EVERYTHING,
        except: &["crates/fem-core/src/linalg"],
    },
    Absence {
        what: "threads outside of their seam",
        marks: &["rayon", "std::thread"],
        below: LIBRARIES,
        except: &[
            "crates/fem-core/src/parallel.rs",
            "crates/fem-core/src/linalg/yardstick.rs",
        ],
    },
    Absence {
        what: "files in a library",
        marks: &[
            "std::fs",
            "std::os",
            "std::path::absolute",
            ".canonicalize(",
            ".exists(",
            ".metadata(",
        ],
        below: LIBRARIES,
        except: &[],
    },
    Absence {
        what: "a clock in a library",
        marks: &["std::time"],
        below: LIBRARIES,
        except: &[],
    },
    Absence {
        what: "the terminal in a library",
        marks: &[
            "print!",
            "println!",
            "eprint!",
            "eprintln!",
            "dbg!",
            "std::io::stdin",
            "std::io::stdout",
            "std::io::stderr",
        ],
        below: LIBRARIES,
        except: &[],
    },
    Absence {
        what: "the process or its surroundings in a library",
        marks: &["std::process", "std::env", "std::net"],
        below: LIBRARIES,
        except: &[],
    },
    Absence {
        what: "models and runs in the readers of scenes",
        marks: &["stickslip_engine"],
        below: &[
            "crates/document/src",
            "crates/scene/src",
            "crates/experiment/src",
        ],
        except: &[],
    },
    Absence {
        what: "pages in what finds",
        marks: &[
            "stickslip_present",
            "stickslip_experiment_pages",
            "stickslip_report",
        ],
        below: &[
            "crates/document/src",
            "crates/scene/src",
            "crates/experiment/src",
            "crates/results/src",
            "crates/engine/src",
            "crates/ladder/src",
            "crates/measure/src",
        ],
        except: &[],
    },
    Absence {
        what: "scenes behind the model, which resolves their names",
        marks: &[
            "stickslip_scene::Scene",
            "stickslip_scene::schema::SetRef",
            "stickslip_scene::placement",
        ],
        below: &["crates/engine/src"],
        // The entry point: a test below names it.
        except: &["crates/engine/src/model", "crates/engine/src/run.rs"],
    },
    Absence {
        what: "bodies, edges and contacts looked up by name behind the model",
        marks: &[
            "body.name==",
            "edge.name==",
            "geometry.name==",
            "pair.name==",
            "contact.name==",
            "load.name==",
            "node_set",
            "edge_set",
            "edge_path",
        ],
        below: &[
            "crates/engine/src",
            "crates/ladder/src",
            "crates/present/src",
        ],
        // The picture of the problem names the sets that meshes have.
        except: &[
            "crates/engine/src/model",
            "crates/present/src/results/figures/sketch.rs",
        ],
    },
    Absence {
        what: "the text of a scene read again by what runs or shows it",
        marks: &["toml::from_str", "toml::Table", "toml::Value"],
        below: &[
            "crates/results/src",
            "crates/engine/src",
            "crates/ladder/src",
            "crates/measure/src",
            "crates/present/src",
            "crates/experiment-pages/src",
        ],
        // The page shows its keys as they are written.
        except: &["crates/present/src/results/problem.rs"],
    },
    Absence {
        what: "enums of scenes that are not tagged from outside, so that an error points nowhere",
        marks: &["untagged", "serde(tag"],
        below: &["crates/scene/src", "crates/experiment/src"],
        // Written only, and a choice of two plain values.
        except: &[
            "crates/scene/src/schema/demand.rs",
            "crates/experiment/src/history.rs",
            "crates/experiment/src/format/settings.rs",
        ],
    },
    Absence {
        what: "files deleted or replaced by the command outside of its folders",
        marks: &[
            "fs::remove_file",
            "fs::remove_dir",
            "fs::remove_dir_all",
            "fs::rename",
        ],
        below: &["crates/stickslip/src"],
        // `init` takes back what it has just written.
        except: &[
            "crates/stickslip/src/folder",
            "crates/stickslip/src/cli/init.rs",
        ],
    },
    Absence {
        what: "contact in the finite elements",
        marks: &["stickslip_contact", "stickslip_friction"],
        below: &["crates/fem-core"],
        except: &[],
    },
    Absence {
        what: "meshes and matrices in friction laws",
        marks: &["stickslip_fem_core", "nalgebra"],
        below: &["crates/friction"],
        except: &[],
    },
    Absence {
        what: "cells and their matrices in contact, which sees edges only",
        marks: &[
            "stickslip_fem_core::mesh::Mesh",
            "stickslip_fem_core::mesh::ElementBlock",
            "stickslip_fem_core::element::Element",
            "stickslip_fem_core::element::KindVisitor",
            "stickslip_fem_core::element::with_element",
            "stickslip_fem_core::body",
        ],
        below: &["crates/contact/src"],
        except: &[],
    },
];

/// A dependency that only some manifests list, tests and benches aside.
struct Crate {
    name: &'static str,
    /// Folders of the crates that may.
    only: &'static [&'static str],
}

const CRATES: &[Crate] = &[
    Crate {
        name: "faer",
        only: &["crates/fem-core"],
    },
    Crate {
        name: "rayon",
        only: &["crates/fem-core", "crates/stickslip", "xtask"],
    },
    Crate {
        name: "tiny-skia",
        only: &["crates/report"],
    },
    Crate {
        name: "rustybuzz",
        only: &["crates/report"],
    },
    Crate {
        name: "comfy-table",
        only: &["crates/report"],
    },
];

/// Crates of this workspace whose types stand in no public item, with the libraries that list them nevertheless. All others are re-exported.
const INSIDE: &[(&str, &[&str])] = &[
    (
        "stickslip-text",
        &[
            "document",
            "experiment-pages",
            "measure",
            "mesh-files",
            "present",
            "results",
            "scene",
        ],
    ),
    // Their own interface takes scenes and results, whose crates re-export these.
    ("stickslip-contact", &["ladder", "present"]),
    ("stickslip-fem-core", &["experiment-pages"]),
    ("stickslip-friction", &["experiment-pages", "ladder"]),
    ("stickslip-hybrid", &["experiment-pages"]),
    ("stickslip-joint", &["present"]),
    ("stickslip-scene", &["experiment-pages"]),
    ("stickslip-laminate", &["present"]),
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Names, relative to the root, of the files below `folder` whose names end in `ending`.
fn files(folder: &str, ending: &str) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root().join(folder)).expect("a readable folder") {
        let entry = entry.expect("a readable entry");
        let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            if !name.ends_with("/target") {
                found.extend(files(&name, ending));
            }
        } else if name.ends_with(ending) {
            found.push(name);
        }
    }
    found.sort();
    found
}

fn is_letter(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || sign == '_'
}

/// The code of a source without tests, comments and what stands in literals, with spaces between words only.
fn code(text: &str) -> String {
    fn write(tokens: TokenStream, code: &mut String) {
        for tree in tokens {
            match tree {
                TokenTree::Group(group) => {
                    let [open, close] = match group.delimiter() {
                        Delimiter::Parenthesis => ["(", ")"],
                        Delimiter::Brace => ["{", "}"],
                        Delimiter::Bracket => ["[", "]"],
                        Delimiter::None => ["", ""],
                    };
                    code.push_str(open);
                    write(group.stream(), code);
                    code.push_str(close);
                }
                TokenTree::Ident(word) => {
                    if code.ends_with(is_letter) {
                        code.push(' ');
                    }
                    code.push_str(&word.to_string());
                }
                TokenTree::Punct(sign) => code.push(sign.as_char()),
                TokenTree::Literal(_) => code.push_str("\"\""),
            }
        }
    }
    let tokens = source::code(text).unwrap_or_else(|cause| panic!("{cause}: {text}"));
    let mut code = String::new();
    write(tokens, &mut code);
    code
}

/// Every path of the trees of `use` declarations, in full.
fn imported(code: &str) -> Vec<String> {
    fn expand(before: &str, tree: &str, paths: &mut Vec<String>) {
        let Some((stem, group)) = tree.split_once('{') else {
            paths.push(format!("{before}{}", tree.trim()));
            return;
        };
        let group = group.trim_end().strip_suffix('}').unwrap_or(group);
        let (mut depth, mut first) = (0, 0);
        for (k, byte) in group.bytes().chain([b',']).enumerate() {
            match byte {
                b'{' => depth += 1,
                b'}' => depth -= 1,
                b',' if depth == 0 => {
                    expand(&format!("{before}{}", stem.trim()), &group[first..k], paths);
                    first = (k + 1).min(group.len());
                }
                _ => {}
            }
        }
    }
    let mut paths = Vec::new();
    for (k, mark) in code.match_indices("use") {
        let (before, after) = (&code[..k], &code[k + mark.len()..]);
        if !before.ends_with(is_letter) && !after.starts_with(is_letter) {
            let tree = after.split(';').next().unwrap_or_default();
            expand("", tree, &mut paths);
        }
    }
    paths
}

/// Whether `text` holds `mark` as whole identifiers; a mark that ends in `==` as either side of that comparison.
fn mentions(text: &str, mark: &str) -> bool {
    if let Some(operand) = mark.strip_suffix("==") {
        return is_compared(text, operand);
    }
    let goes_on =
        |left: &str, right: &str| left.ends_with(is_letter) && right.starts_with(is_letter);
    text.match_indices(mark).any(|(k, _)| {
        let (before, after) = (&text[..k], &text[k + mark.len()..]);
        !goes_on(before, mark) && !goes_on(mark, after)
    })
}

/// Whether the field `operand`, or what is made of it (`Some(&operand)`, `operand.as_str()`), stands beside `==`.
fn is_compared(text: &str, operand: &str) -> bool {
    let wraps = |c: char| c.is_ascii_alphanumeric() || "_.&*()".contains(c);
    text.match_indices(operand).any(|(k, _)| {
        let before = &text[..k];
        let after = &text[k + operand.len()..];
        !before.ends_with(is_letter)
            && !after.starts_with(is_letter)
            && (before.trim_end_matches(wraps).ends_with("==")
                || after.trim_start_matches(wraps).starts_with("=="))
    })
}

/// The mark that a source uses, if any.
fn used<'a>(source: &str, marks: &[&'a str]) -> Option<&'a str> {
    let code = code(source);
    let imported = imported(&code);
    let in_it =
        |mark: &&&str| mentions(&code, mark) || imported.iter().any(|path| mentions(path, mark));
    marks.iter().find(in_it).copied()
}

#[test]
fn what_must_be_absent_is_absent() {
    let mut wrong = Vec::new();
    for row in PATHS {
        for exception in row.except {
            assert!(
                root().join(exception).exists(),
                "{}: {exception} is not there",
                row.what
            );
        }
        for name in row.below.iter().flat_map(|folder| files(folder, ".rs")) {
            let excepted = row.except.iter().any(|start| name.starts_with(start));
            if let Some(mark) = used(&read(&root().join(&name)), row.marks)
                && !excepted
            {
                wrong.push(format!("{}: {name} uses {mark}", row.what));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Behind the model nothing of `engine` takes a scene but these.
const ENTRY_POINTS: &[&str] = &["run_with"];

#[test]
fn only_the_entry_points_of_runs_take_a_scene() {
    let mut found = Vec::new();
    let files = files("crates/engine/src", ".rs").into_iter();
    for name in files.filter(|name| !name.starts_with("crates/engine/src/model")) {
        let code = code(&read(&root().join(&name)));
        for (start, _) in code.match_indices("fn ") {
            let signature = code[start + 3..]
                .split(['{', ';'])
                .next()
                .unwrap_or_default();
            if mentions(signature, "Scene") {
                let function = signature.split(['(', '<']).next().unwrap_or_default();
                found.push(function.to_owned());
            }
        }
    }
    assert_eq!(found, ENTRY_POINTS);
}

/// An exception that is used no more, or a mark that is misspelt, would hide the next offence.
#[test]
fn every_exception_is_needed() {
    for row in PATHS {
        for exception in row.except {
            let folder = exception
                .rsplit_once('/')
                .map_or(*exception, |(folder, _)| folder);
            let mut own = files(folder, ".rs").into_iter();
            assert!(
                own.any(|name| name.starts_with(exception)
                    && used(&read(&root().join(&name)), row.marks).is_some()),
                "{}: {exception} has no need of its exception",
                row.what
            );
        }
    }
}

#[test]
fn dependencies_stand_where_they_may() {
    let mut wrong = Vec::new();
    for name in EVERYTHING
        .iter()
        .flat_map(|folder| files(folder, "/Cargo.toml"))
    {
        let manifest: toml::Table = toml::from_str(&read(&root().join(&name)))
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        let listed = manifest.get("dependencies").and_then(toml::Value::as_table);
        let folder = name.trim_end_matches("/Cargo.toml");
        for row in CRATES {
            let lists = listed.is_some_and(|listed| listed.contains_key(row.name));
            if lists != row.only.contains(&folder) {
                wrong.push(format!("{folder}: lists {}: {lists}", row.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whoever depends on a library needs no second dependency to name what it takes and returns.
#[test]
fn libraries_re_export_the_crates_that_their_interface_holds() {
    for library in LIBRARIES {
        let folder = library.trim_end_matches("/src");
        let own = folder.trim_start_matches("crates/");
        let manifest: toml::Table =
            toml::from_str(&read(&root().join(folder).join("Cargo.toml"))).expect("a manifest");
        let listed = manifest.get("dependencies").and_then(toml::Value::as_table);
        let code = code(&read(&root().join(library).join("lib.rs")));
        let public = code.match_indices("pub use").map(|(k, mark)| {
            let tree = &code[k + mark.len()..];
            tree.split(';').next().unwrap_or_default()
        });
        let public: Vec<&str> = public.collect();
        let names = listed.into_iter().flatten().map(|(name, _)| name);
        for name in names.filter(|name| name.starts_with("stickslip-")) {
            let is_public = public
                .iter()
                .any(|tree| mentions(tree, &name.replace('-', "_")));
            let mut inside = INSIDE.iter();
            let is_inside = inside.any(|(held, by)| held == name && by.contains(&own));
            assert_ne!(is_public, is_inside, "{own}: {name}");
        }
    }
}

#[test]
fn sources_are_read_as_code() {
    let marks: &[&str] = &["std::fs", "println!", "rayon", ".exists(", "edge.name=="];
    for clean in [
        "// std::fs\nlet x = \"std::fs \\\" std::fs\";",
        "//! [`println!`]",
        "let a = '\"'; // rayon\nlet b = r#\"rayon \"rayon\" \"#;",
        "use crate::std::fs_like; let crayon = my_println!();",
        "fn f() {}\n#[cfg(test)]\nmod tests { use std::fs; }",
        "fn f() { path.exists_not() }",
        "let x = ledge.name == name && edge.names == name;",
    ] {
        assert_eq!(used(clean, marks), None, "{clean}");
    }
    for (foul, mark) in [
        ("let x = std::fs::read(p);", "std::fs"),
        ("use std::{\n    io,\n    fs::{self, File},\n};", "std::fs"),
        ("use std::{io::{Read, Write}, fs};", "std::fs"),
        ("let s = \"a\"; println!(\"b\");", "println!"),
        ("use rayon::prelude::*;", "rayon"),
        ("#[cfg(test)]\nmod tests;\nuse std::fs;", "std::fs"),
        ("#[cfg(test)]\nmod tests {}\nuse std::fs;", "std::fs"),
        ("use ::{rayon};", "rayon"),
        ("let here = path\n    .exists();", ".exists("),
        ("let x = self.edge.name == name;", "edge.name=="),
        ("let x = name == &self.edge.name;", "edge.name=="),
        ("let x = Some(edge.name.as_str()) == name;", "edge.name=="),
        ("let x = name == Some(&edge.name);", "edge.name=="),
    ] {
        assert_eq!(used(foul, marks), Some(mark), "{foul}");
    }
}
