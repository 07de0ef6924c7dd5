//! `cargo xtask closed-loop`: friction from synthetic fringe pictures, again and again with other noise.
//!
//! The pin-loaded aluminium plate of `scenes/hybrid-aluminium` is solved with known friction and photographed once for every seed; its
//! friction is identified from the pictures by the same functions that `stickslip identify` calls. How often the interval holds the
//! truth says whether it is one of 95 %.

use std::ops::RangeInclusive;

use stickslip::experiment::analysed::Workbench;
use stickslip::experiment::identified::identify;
use stickslip::experiment::measured;
use stickslip::experiment::synthesis::Camera;
use stickslip::experiment::truth::Truth;
use stickslip::experiment::{Experiment, ExperimentError};
use stickslip::host::HOST;
use stickslip_hybrid::identify::{Bounds, SlipFit};
use toml::Table;

use crate::study::record::{fields, needed, number, text};
use crate::study::table::{Tables, read};
use crate::study::{Study, TaskError, root, side_by_side};

pub(crate) const STUDY: Study = Study {
    name: "closed-loop",
    solve: |cases| {
        let rows = cases
            .iter()
            .map(|case| seeds(text(case, "experiment")?, truth(case)?, range(case)?));
        let rows = rows.collect::<Result<Vec<_>, TaskError>>()?.concat();
        Ok(Tables::from([("closed-loop".to_owned(), rows)]))
    },
    complete,
};

/// The experiments with friction and without it, by their files in `scenes/hybrid-aluminium`, and the dynamic coefficients of their scenes.
pub(crate) const WITH_FRICTION: (&str, f64) = ("experiment.toml", 0.25);
pub(crate) const WITHOUT_FRICTION: (&str, f64) = ("no-friction.toml", 0.0);

/// The scene's settings were chosen with seeds 1 to 20: none of these is asked again.
pub(crate) const FIRST: u64 = 1001;

/// How far an identified coefficient may be from the truth.
pub(crate) const NEAR: f64 = 0.01;

/// How many of `seeds` intervals of 95 % are to hold the truth: 90 to 99 % of many, at least 90 % of a few.
pub(crate) fn wanted(seeds: usize) -> RangeInclusive<usize> {
    const MANY: usize = 100;
    let most = if seeds < MANY {
        seeds
    } else {
        seeds * 99 / 100
    };
    (seeds * 90).div_ceil(100)..=most
}

fn truth(row: &Table) -> Result<f64, TaskError> {
    needed(row, "truth")
}

fn range(case: &Table) -> Result<RangeInclusive<u64>, TaskError> {
    Ok(FIRST..=FIRST + needed(case, "seeds")? as u64 - 1)
}

/// One row per seed and zone, and one for all zones together: the scene is solved once, and every seed goes through the whole chain.
fn seeds(file: &str, truth: f64, seeds: RangeInclusive<u64>) -> Result<Vec<Table>, TaskError> {
    let path = root().join("scenes/hybrid-aluminium").join(file);
    let mut experiment = Experiment::from_file(&path, &[] as &[&str], HOST)?;
    // The draws that confirm the interval are not asked for here.
    experiment.identify.samples = 2;
    let scene = experiment
        .specimen
        .scene
        .clone()
        .ok_or("the experiment has no scene")?;
    let solved = Truth::solve(&scene, &mut |_| ())?;
    let camera = Camera::new(&experiment, &solved)?;
    let bench = Workbench::new(&experiment)?;
    let row = |seed: u64, zone: &str, fit: &SlipFit| {
        let (low, high) = match fit.bounds {
            Bounds::Between(low, high) => (Some(low), Some(high)),
            Bounds::AtMost(high) => (None, Some(high)),
            Bounds::AtLeast(low) => (Some(low), None),
            Bounds::Nothing => (None, None),
        };
        let mut row = Table::from_iter(fields([
            ("experiment", file.into()),
            ("truth", truth.into()),
            ("seed", (seed as i64).into()),
            ("zone", zone.into()),
            ("mu", fit.mu.into()),
            ("holds_truth", fit.bounds.contain(truth).into()),
            ("chi_squared", fit.chi_squared.into()),
            ("degrees_of_freedom", (fit.degrees as i64).into()),
        ]));
        row.extend(low.map(|low| ("low".to_owned(), low.into())));
        row.extend(high.map(|high| ("high".to_owned(), high.into())));
        row
    };
    let seeds: Vec<u64> = seeds.collect();
    let rows = side_by_side(&seeds, |&seed| {
        let (zones, together) = found(&experiment, &camera.with_seed(seed), &bench)?;
        let mut rows = Vec::new();
        for (state, [from, to], fit) in zones {
            let mut row = row(seed, &experiment.states[state].name, &fit);
            row.extend(fields([("from_deg", from.into()), ("to_deg", to.into())]));
            rows.push(row);
        }
        rows.extend(together.map(|fit| row(seed, "together", &fit)));
        Ok(rows)
    })?;
    Ok(rows.concat())
}

/// Index of the state, first and last angle `[degree]` and coefficient of a zone.
type Zone = (usize, [f64; 2], SlipFit);

/// All zones, and the coefficient of all of them; `None` where no zone was recognised.
fn found(
    experiment: &Experiment,
    camera: &Camera<'_>,
    bench: &Workbench<'_>,
) -> Result<(Vec<Zone>, Option<SlipFit>), ExperimentError> {
    let mut analysed = Vec::new();
    for state in 0..experiment.states.len() {
        let measured = measured::state(experiment, state, &camera.shots(state)?)?;
        analysed.push(bench.stresses(&measured)?);
    }
    let found = identify(experiment, &analysed)?;
    let zones = found.zones.into_iter().map(|zone| {
        let angle = &analysed[zone.state].angle;
        let ends = [zone.places.start, zone.places.end - 1].map(|k| angle[k].to_degrees());
        (zone.state, ends, zone.fit)
    });
    Ok((zones.collect(), found.dynamic))
}

/// Whether a row has an interval, of two ends, that holds the truth: bounds on one side hold too much to say so.
fn holds(row: &Table) -> bool {
    let ends = number(row, "low").zip(number(row, "high"));
    let truth = number(row, "truth").unwrap_or(f64::NAN);
    ends.is_some_and(|(low, high)| (low..=high).contains(&truth))
}

/// Half widths of intervals, and for the chart the rank of a seed's coefficient among all of its experiment.
fn complete(tables: &mut Tables) {
    let mut rows: Vec<&mut Table> = tables.values_mut().flatten().collect();
    rows.sort_by(|a, b| {
        let mu = |row: &Table| number(row, "mu").unwrap_or(f64::NAN);
        mu(a).total_cmp(&mu(b))
    });
    let mut rank = 0_i64;
    for row in rows {
        if let Some((low, high)) = number(row, "low").zip(number(row, "high")) {
            row.extend(fields([("half_width", (0.5 * (high - low)).into())]));
        }
        let held = holds(row);
        row.extend(fields([("held", held.into())]));
        let is_shown = |row: &Table| -> Result<bool, TaskError> {
            let together = text(row, "zone")? == "together" && row.contains_key("high");
            Ok(together && text(row, "experiment")? == WITH_FRICTION.0)
        };
        if is_shown(row).unwrap_or(false) {
            rank += 1;
            row.extend(fields([("rank", rank.into())]));
        }
    }
}

/// Coefficients of all zones together over the seeds of one experiment.
#[derive(Debug)]
pub(crate) struct Series {
    pub(crate) truth: f64,
    /// Seeds that were asked; some may have no coefficient.
    pub(crate) seeds: usize,
    rows: Vec<Table>,
}

impl Series {
    /// Solves an experiment with some seeds.
    pub(crate) fn of(known: (&str, f64), asked: RangeInclusive<u64>) -> Result<Self, TaskError> {
        let count = asked.clone().count();
        let rows = seeds(known.0, known.1, asked)?;
        Ok(Self {
            seeds: count,
            ..Self::among(rows, known)
        })
    }

    /// What the last full run left of an experiment in `docs/closed-loop`.
    pub(crate) fn recorded(known: (&str, f64)) -> Result<Self, TaskError> {
        let path = root().join("docs/closed-loop/closed-loop.csv");
        Ok(Self::among(read(std::fs::File::open(path)?)?, known))
    }

    fn among(mut rows: Vec<Table>, (file, truth): (&str, f64)) -> Self {
        let is = |row: &Table, key: &str, value: &str| text(row, key).is_ok_and(|own| own == value);
        rows.retain(|row| is(row, "experiment", file) && is(row, "zone", "together"));
        Self {
            truth,
            seeds: rows.len(),
            rows,
        }
    }

    fn coefficients(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().filter_map(|row| number(row, "mu"))
    }

    /// Mean of the coefficients found.
    pub(crate) fn mean(&self) -> f64 {
        self.coefficients().sum::<f64>() / self.rows.len() as f64
    }

    /// Seeds with an interval, of two ends, that holds the truth.
    pub(crate) fn covered(&self) -> usize {
        self.rows.iter().filter(|row| holds(row)).count()
    }

    /// The farthest coefficient from the truth; infinite where a seed has none.
    pub(crate) fn farthest(&self) -> f64 {
        if self.rows.len() < self.seeds {
            return f64::INFINITY;
        }
        let distances = self.coefficients().map(|mu| (mu - self.truth).abs());
        distances.fold(0.0, f64::max)
    }

    /// Seeds whose bounds say that there is no friction or at most a little.
    pub(crate) fn none_found(&self) -> usize {
        let highs = self.rows.iter().filter(|row| !row.contains_key("low"));
        highs
            .filter(|row| number(row, "high").is_some_and(|high| high <= NEAR))
            .count()
    }

    /// Seeds of `other` whose coefficient is the one here to the digits of the table: then the record is one of this program.
    pub(crate) fn repeated_by(&self, other: &Self) -> usize {
        const ROUNDED: f64 = 1e-5;
        let is_same = |row: &&Table| {
            let near = |own: &Table, key: &str| {
                let both = number(own, key).zip(number(row, key));
                both.is_some_and(|(a, b)| (a - b).abs() <= ROUNDED)
            };
            self.rows
                .iter()
                .any(|own| near(own, "seed") && near(own, "mu"))
        };
        other.rows.iter().filter(is_same).count()
    }
}
