//! What studies share: options, cases solved side by side, and the files that are written in the end.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use stickslip_report::folder::{FolderError, SharedFolder, write_atomic};
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_report::svg::Svg;

/// Why a study stopped.
pub(crate) type Trouble = Box<dyn std::error::Error + Send + Sync>;

/// How much of a study is wanted, and where.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Few values on coarser meshes: at most a minute. Nothing is written unless a folder is named.
    #[arg(long)]
    quick: bool,
    /// Folder for table, pictures and page; the study's own below docs for a full run.
    #[arg(long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// A picture, the name of its files, and a text for readers without it.
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) svg: Svg,
    pub(crate) alternative: &'static str,
}

/// What a study leaves behind.
pub(crate) struct Publication {
    /// Names and contents.
    pub(crate) tables: Vec<(&'static str, Vec<u8>)>,
    pub(crate) pictures: Vec<Picture>,
    /// The page, in Markdown.
    pub(crate) page: String,
    /// What the terminal shows.
    pub(crate) findings: String,
}

/// Runs a study, quick or full, that lives in `docs/{name}`: progress on stderr, findings on stdout.
pub(crate) fn main(
    name: &str,
    options: &Options,
    study: impl FnOnce(bool) -> Result<Publication, Trouble>,
) -> ExitCode {
    let start = Instant::now();
    let outcome = study(options.quick).and_then(|publication| {
        if let Some(mut published) = published(name, options)? {
            write(&publication, &mut published)?;
        }
        Ok(publication.findings)
    });
    eprintln!("{:.0} s", start.elapsed().as_secs_f64());
    match outcome {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

/// A folder that a task writes its files into.
pub(crate) enum Published {
    /// The task's own, below `docs` or `target`: its files are replaced.
    Own(PathBuf),
    /// One that the user named: nothing is replaced but what a task has written there.
    Named(SharedFolder),
}

impl Published {
    /// The folder that was `named`, otherwise the task's `own`, if it writes one.
    pub(crate) fn open(
        named: Option<&Path>,
        own: Option<PathBuf>,
    ) -> Result<Option<Self>, FolderError> {
        match named {
            Some(path) => Ok(Some(Self::Named(SharedFolder::open(path, |_| false)?))),
            None => Ok(own.map(Self::Own)),
        }
    }

    /// Where it is.
    pub(crate) fn path(&self) -> PathBuf {
        match self {
            Self::Own(path) => path.clone(),
            Self::Named(folder) => folder.file(""),
        }
    }

    /// Writes a file whole or not at all.
    pub(crate) fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        match self {
            Self::Own(path) => {
                let unwritable = |cause| FolderError::Unwritable {
                    path: path.clone(),
                    cause,
                };
                std::fs::create_dir_all(&*path).map_err(unwritable)?;
                write_atomic(&path.join(name), bytes)
            }
            Self::Named(folder) => folder.write(name, bytes),
        }
    }
}

fn published(name: &str, options: &Options) -> Result<Option<Published>, FolderError> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let own = (!options.quick).then(|| docs.join(name));
    Published::open(options.output.as_deref(), own)
}

fn write(publication: &Publication, folder: &mut Published) -> Result<(), Trouble> {
    for (name, bytes) in &publication.tables {
        folder.write(name, bytes)?;
    }
    for picture in &publication.pictures {
        let svg = picture.svg.as_str().as_bytes();
        folder.write(&format!("{}.svg", picture.name), svg)?;
        let png = to_png(&picture.svg, DEFAULT_SCALE)?;
        folder.write(&format!("{}.png", picture.name), &png)?;
    }
    folder.write("README.md", publication.page.as_bytes())?;
    Ok(())
}

/// Solves `cases` on all cores with a bar of progress; the order of the results is that of the cases.
pub(crate) fn side_by_side<C: Sync, R: Send>(
    cases: &[C],
    solve: impl Fn(&C) -> Result<R, Trouble> + Sync,
) -> Result<Vec<R>, Trouble> {
    let progress = ProgressBar::new(cases.len() as u64);
    // The template is a constant that is known to parse; without a style the bar only looks plainer.
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} {elapsed}") {
        progress.set_style(style);
    }
    let results = cases
        .par_iter()
        .map(|case| {
            let result = solve(case);
            progress.inc(1);
            result
        })
        .collect();
    progress.finish_and_clear();
    results
}
