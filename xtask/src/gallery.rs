//! `cargo xtask gallery`: runs shipped scenes and shows each with its sketch and one figure, in docs/gallery.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Mutex;

use clap::Args;
use stickslip::folder::write_atomic;
use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run::run;
use stickslip::scene::Scene;

use crate::publish::{TaskError, root};

/// Scenes, and the figure that is shown of each beside its sketch.
const SHOWN: [(&str, &str); 18] = [
    ("pin-loaded-aluminium", "pressure-pin"),
    ("pin-quasi-isotropic", "stresses-coulomb"),
    ("bushed-pin", "field-von-mises"),
    ("interference-pin", "pressure-pin"),
    ("lug-oblique", "field-von-mises"),
    ("lug-imported", "pressure-pin"),
    ("link-imported", "field-von-mises"),
    ("eccentric-hole", "pressure-pin"),
    ("bearing-bypass", "hoop-bolt"),
    ("fasteners-five", "field-von-mises"),
    ("double-lap", "field-von-mises"),
    ("single-lap", "field-von-mises"),
    ("rounded-punch", "shear-block"),
    ("dovetail", "field-von-mises"),
    ("roller", "pressure-plate"),
    ("cam", "pressure-cam"),
    ("fretting-half-planes", "shear-cylinder"),
    ("open-hole", "field-von-mises"),
];

/// Which scenes are shown.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Only scenes whose name contains this; the page is left as it is.
    #[arg(long)]
    only: Option<String>,
}

/// Runs the task.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let folder = root().join("docs/gallery");
    std::fs::create_dir_all(&folder)?;
    let only = options.only.as_deref().unwrap_or_default();
    let mut page = String::from(
        "# Gallery\n\nShipped scenes with their sketches: bodies, edges in contact (orange), what is held (green) and loads (blue). `cargo xtask gallery` makes this page.\n",
    );
    for (name, figure) in SHOWN.into_iter().filter(|(name, _)| name.contains(only)) {
        eprintln!("{name}");
        let file = root().join("scenes").join(name).with_extension("toml");
        let scene = Scene::from_file(&file, &[""; 0], HOST)?;
        let results = run(&scene, &mut |_| {}).map_err(|cause| format!("{name}: {cause}"))?;
        for (kind, picture) in pictures(&results, ["sketch", figure])? {
            write_atomic(&folder.join(format!("{name}-{kind}.png")), &picture)?;
        }
        let table: toml::Table = toml::from_str(&std::fs::read_to_string(&file)?)?;
        let text = |key: &str| {
            table
                .get(key)
                .and_then(toml::Value::as_str)
                .unwrap_or_default()
        };
        write!(
            page,
            "\n## {}\n\n{} `stickslip run scenes/{name}.toml`\n\n| scene | {} |\n| --- | --- |\n| ![Sketch of the scene]({name}-sketch.png) | ![{2}]({name}-figure.png) |\n",
            text("title"),
            text("description"),
            caption(figure),
        )?;
    }
    if options.only.is_none() {
        write_atomic(&folder.join("README.md"), page.as_bytes())?;
    }
    Ok(true)
}

/// The PNG files of the first figures whose names begin with `wanted`, as `sketch` and `figure`.
fn pictures(
    results: &Results,
    wanted: [&str; 2],
) -> Result<BTreeMap<&'static str, Vec<u8>>, TaskError> {
    let found: Mutex<BTreeMap<&str, (String, Vec<u8>)>> = Mutex::new(BTreeMap::new());
    let keep = |name: &str, bytes: &[u8]| {
        let file = Path::new(name);
        let is_picture = file.extension().is_some_and(|ending| ending == "png");
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        for (kind, prefix) in ["sketch", "figure"].into_iter().zip(wanted) {
            if is_picture && stem.starts_with(prefix) {
                let mut found = found.lock().map_err(|_| "a figure was not drawn")?;
                let (first, picture) = found
                    .entry(kind)
                    .or_insert_with(|| (name.to_owned(), Vec::new()));
                if name <= first.as_str() {
                    (*first, *picture) = (name.to_owned(), bytes.to_vec());
                }
            }
        }
        Ok(())
    };
    stickslip::output::write(results, true, &keep)?;
    let found = found.into_inner().map_err(|_| "a figure was not drawn")?;
    match found.len() {
        2 => Ok(found
            .into_iter()
            .map(|(kind, (_, picture))| (kind, picture))
            .collect()),
        _ => Err(format!("no figure is called {}", wanted.join(" or ")).into()),
    }
}

/// What a figure shows.
fn caption(figure: &str) -> &'static str {
    match figure.split('-').next() {
        Some("pressure") => "Contact pressure in every load step",
        Some("shear") => "Friction traction in every load step",
        Some("hoop") => "Stress along the edge in every load step",
        Some("stresses") => "Stresses along the edge",
        _ => "Von Mises stress",
    }
}
