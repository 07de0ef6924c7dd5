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

/// Scenes, and the figure that is shown of each beside its sketch; the names of variants begin with that of the scene before them, whose sketch is theirs.
const SHOWN: [(&str, &str); 35] = [
    ("pin-loaded-aluminium", "pressure-pin"),
    ("pin-loaded-aluminium-mu-0.15", "friction-pin"),
    ("pin-loaded-aluminium-mu-0.30", "friction-pin"),
    ("pin-loaded-aluminium-mesh-a", "hoop-pin"),
    ("pin-loaded-aluminium-mesh-b", "hoop-pin"),
    ("pin-loaded-aluminium-mesh-c", "hoop-pin"),
    ("pin-quasi-isotropic", "stresses-coulomb"),
    ("pin-benchmark", "map-pin"),
    ("pin-infinite-plate", "hoop-pin"),
    ("pin-orthotropic", "stresses-pin"),
    ("pin-mortar", "shear-pin"),
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
    ("joint-assumed-cosine", "ply-index"),
    ("joint-computed-contact", "ply-map"),
    ("joint-bearing", "damage-plate"),
    ("joint-net-tension", "load-displacement"),
    ("joint-shear-out", "damage-plate"),
    ("failure-envelope", "envelope-normal"),
    ("rounded-punch", "shear-block"),
    ("dovetail", "field-von-mises"),
    ("roller", "pressure-plate"),
    ("cam", "pressure-cam"),
    ("hertz-cylinder", "stresses-cylinder"),
    ("cattaneo-mindlin", "shear-cylinder"),
    ("fretting-half-planes", "shear-cylinder"),
    ("open-hole", "field-von-mises"),
];

/// Name of the figure that shows the scene.
const SKETCH: &str = "sketch";

/// Which scenes are shown.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Only scenes whose name contains this; the page is left as it is.
    #[arg(long)]
    only: Option<String>,
}

/// Runs the task.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    all_are_shown()?;
    let folder = root().join("docs/gallery");
    std::fs::create_dir_all(&folder)?;
    let only = options.only.as_deref().unwrap_or_default();
    let mut page = String::from(
        "# Gallery\n\nEvery scene of `scenes` itself with its sketch and a figure, variants with a figure alone. Sketches show bodies, edges in contact (orange), what is held (green) and loads (blue). `cargo xtask gallery` makes this page.\n",
    );
    for (name, figure) in SHOWN.into_iter().filter(|(name, _)| name.contains(only)) {
        eprintln!("{name}");
        let file = root().join(format!("scenes/{name}.toml"));
        let scene = Scene::from_file(&file, &[""; 0], HOST)?;
        let results = run(&scene, &mut |_| {}).map_err(|cause| format!("{name}: {cause}"))?;
        let wanted = [SKETCH, figure];
        let wanted = if is_variant(name) {
            &wanted[1..]
        } else {
            &wanted
        };
        let mut row = String::from("|");
        for (&prefix, picture) in wanted.iter().zip(pictures(&results, wanted)?) {
            let kind = if prefix == SKETCH { SKETCH } else { "figure" };
            write_atomic(&folder.join(format!("{name}-{kind}.png")), &picture)?;
            write!(row, " ![{}]({name}-{kind}.png) |", caption(prefix))?;
        }
        let table: toml::Table = toml::from_str(&std::fs::read_to_string(&file)?)?;
        let text = |key: &str| {
            table
                .get(key)
                .and_then(toml::Value::as_str)
                .unwrap_or_default()
        };
        let heads: Vec<&str> = wanted.iter().map(|prefix| caption(prefix)).collect();
        write!(
            page,
            "\n## {}\n\n{} `stickslip run scenes/{name}.toml`\n\n| {} |\n|{}\n{row}\n",
            text("title"),
            text("description"),
            heads.join(" | "),
            " --- |".repeat(heads.len()),
        )?;
    }
    if options.only.is_none() {
        write_atomic(&folder.join("README.md"), page.as_bytes())?;
    }
    Ok(true)
}

/// Whether a scene is one before it with other values.
fn is_variant(name: &str) -> bool {
    let before = SHOWN.iter().map(|(other, _)| other);
    let mut before = before.take_while(|other| **other != name);
    before.any(|other| (name.strip_prefix(other)).is_some_and(|rest| rest.starts_with('-')))
}

/// Whether every scene beside the folders of `scenes` is shown.
fn all_are_shown() -> Result<(), TaskError> {
    for entry in std::fs::read_dir(root().join("scenes"))? {
        let path = entry?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let is_scene = path.extension().is_some_and(|ending| ending == "toml");
        if is_scene && SHOWN.iter().all(|(name, _)| *name != stem) {
            return Err(format!("scene {stem} is not in the list of the gallery").into());
        }
    }
    Ok(())
}

/// The PNG files of the first figures whose names begin with each of `wanted`.
fn pictures(results: &Results, wanted: &[&str]) -> Result<Vec<Vec<u8>>, TaskError> {
    let found: Mutex<BTreeMap<&str, (String, Vec<u8>)>> = Mutex::new(BTreeMap::new());
    let keep = |name: &str, bytes: &[u8]| {
        let file = Path::new(name);
        let is_picture = file.extension().is_some_and(|ending| ending == "png");
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        for &prefix in wanted {
            if is_picture && stem.starts_with(prefix) {
                let mut found = found.lock().map_err(|_| "a figure was not drawn")?;
                let (first, picture) = found
                    .entry(prefix)
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
    let picture = |prefix: &&str| {
        let own = found.get(prefix).map(|(_, picture)| picture.clone());
        own.ok_or_else(|| format!("no figure is called {prefix}").into())
    };
    wanted.iter().map(picture).collect()
}

/// What a figure shows.
fn caption(figure: &str) -> &'static str {
    match figure.split('-').next() {
        Some(SKETCH) => "Sketch of the scene",
        Some("pressure") => "Contact pressure in every load step",
        Some("shear") => "Friction traction in every load step",
        Some("friction") => "Friction over pressure through the history",
        Some("hoop") => "Stress along the edge in every load step",
        Some("map") => "Where it sticks, slips and is open",
        Some("stresses") => "Stresses along the edge",
        Some("damage") => "Where plies have failed",
        Some("load") => "Load over displacement",
        Some("envelope") => "Failure envelopes",
        Some("ply") => "Failure index of the plies",
        _ => "Von Mises stress",
    }
}
