//! The commands that write, and what they read.

use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use tempfile::TempDir;

/// What is in the way of a writer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Old {
    /// Results of the same command, replaced as a whole.
    Results,
    /// A sweep that ended after its first row.
    Rows,
    /// An empty folder.
    Nothing,
}

/// A command that writes into `out`.
#[derive(Debug)]
pub(super) struct Writer {
    pub(super) name: &'static str,
    pub(super) arguments: &'static [&'static str],
    /// The file that it reads first.
    pub(super) reads: &'static str,
    pub(super) old: Old,
    /// Whether it may be repeated where its results are.
    pub(super) replaces: bool,
}

const fn results(name: &'static str, arguments: &'static [&'static str]) -> Writer {
    Writer {
        name,
        arguments,
        reads: arguments[1],
        old: Old::Results,
        replaces: true,
    }
}

pub(super) const WRITERS: [Writer; 7] = [
    results("run", &["run", "scene.toml", "--output", "out", "--force"]),
    results(
        "fringes",
        &["fringes", "fringes.toml", "--output", "out", "--force"],
    ),
    results(
        "reduce",
        &["reduce", "experiment.toml", "--output", "out", "--force"],
    ),
    results(
        "hybrid",
        &["hybrid", "experiment.toml", "--output", "out", "--force"],
    ),
    results(
        "identify",
        &["identify", "experiment.toml", "--output", "out", "--force"],
    ),
    Writer {
        name: "joint",
        arguments: &[
            "joint",
            "sweep.toml",
            "--output",
            "out",
            "--resume",
            "--jobs",
            "1",
        ],
        reads: "sweep.toml",
        old: Old::Rows,
        replaces: true,
    },
    Writer {
        name: "init",
        arguments: &["init", "experiment", "out/new.toml"],
        reads: "out",
        old: Old::Nothing,
        replaces: false,
    },
];

const SCENE: &str = r#"version = 1
title = "Pin"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "steel"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "90 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "15 deg"
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }
[output]
figures = false
"#;
const FRINGES: &str = r#"version = 1
title = "Pin"
[specimen]
scene = "scene.toml"
body = "plate"
[grating]
frequency = "2400 1/mm"
[fringes]
window = [["2 mm", "-5 mm"], ["12 mm", "5 mm"]]
pixel = "0.2 mm"
carrier = { u = ["1.2 1/mm", "0 1/mm"], v = ["0 1/mm", "1.2 1/mm"] }
"#;
const EXPERIMENT: &str = r#"version = 1
title = "Plate"
[specimen]
material.isotropic = { young = "70 GPa", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "5 mm" }
[[states]]
name = "up"
table = { file = "data.csv", scale = "1 mm", y_axis = "up", deviation = "1e-5 mm" }
[region]
sector = { angles = ["-80 deg", "80 deg"], outer = "8 mm", cells = [8, 3] }
"#;
const SWEEP: &str = r#"version = 1
title = "Friction"
scene = "scene.toml"
[[axes]]
key = "mu"
values = [0.1, 0.2, 0.3]
"#;

/// What the commands read, and a file of somebody else.
pub(super) fn inputs() -> Vec<(&'static str, String)> {
    let mut data = "x,y,u,v\n".to_owned();
    for row in -9..=9 {
        for column in -1..=9 {
            let (x, y) = (f64::from(column), f64::from(row));
            if x.hypot(y) > 5.0 {
                // Writing into a string does not fail.
                let _ = writeln!(data, "{x},{y},{:.6},{:.6}", 1e-3 * x, -3e-4 * y);
            }
        }
    }
    vec![
        ("scene.toml", SCENE.to_owned()),
        ("fringes.toml", FRINGES.to_owned()),
        ("experiment.toml", EXPERIMENT.to_owned()),
        ("sweep.toml", SWEEP.to_owned()),
        ("data.csv", data),
        ("out.txt", "somebody's notes\n".to_owned()),
    ]
}

/// This program under the name of the command, as which it is the command.
pub(super) fn program() -> io::Result<PathBuf> {
    static FOLDER: OnceLock<Result<TempDir, String>> = OnceLock::new();
    let made = FOLDER.get_or_init(|| linked().map_err(|cause| cause.to_string()));
    match made {
        Ok(folder) => Ok(folder.path().join(crate::COMMAND)),
        Err(cause) => Err(io::Error::other(cause.clone())),
    }
}

#[cfg(unix)]
fn linked() -> io::Result<TempDir> {
    let folder = tempfile::tempdir()?;
    std::os::unix::fs::symlink(std::env::current_exe()?, folder.path().join(crate::COMMAND))?;
    Ok(folder)
}

#[cfg(not(unix))]
fn linked() -> io::Result<TempDir> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Runs the command with `arguments` in `folder`.
pub(super) fn run(arguments: &[&str], folder: &Path) -> io::Result<Output> {
    started(Command::new(program()?).args(arguments), folder)
}

/// Runs a process in `folder`, on one thread, so that the order of its system calls is the same every time.
pub(super) fn started(command: &mut Command, folder: &Path) -> io::Result<Output> {
    command
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .output()
}
