//! How far loaded sets move and what held ones take: tables, columns of `steps.csv` and entries of `summary.json`.

use serde::Serialize;
use stickslip_engine::LoadScale;
use stickslip_engine::results::{LoadedSet, Results, SetKind, SetMotion, Stiffness};
use stickslip_report::table::{Columns, Table};
use stickslip_text::{short, significant, tidy};

use super::quantity::Quantity;
use stickslip_report::csv::number;

/// Reactions up to this part of the largest show as zero.
const ROUNDING: f64 = 1e-9;

/// A set with its results of all steps, in display units.
#[derive(Clone, Copy)]
pub(super) struct SetView<'a> {
    pub(super) set: &'a LoadedSet,
    results: &'a Results,
    index: usize,
}

impl<'a> SetView<'a> {
    /// The sets with numbers, in their order.
    pub(super) fn all(results: &'a Results) -> Vec<Self> {
        let view = |(index, set)| Self {
            set,
            results,
            index,
        };
        let mut all: Vec<Self> = results.sets.iter().enumerate().map(view).collect();
        all.retain(|own| (0..results.steps.len()).any(|step| own.at(step).is_some()));
        all
    }

    fn at(&self, step: usize) -> Option<SetMotion> {
        *self.results.steps[step].sets.get(self.index)?
    }

    fn stiffness(&self, step: usize) -> Stiffness {
        self.results.stiffness(self.index, step)
    }

    /// Whether it is held where it stands.
    fn rests(&self) -> bool {
        let moves = |step| self.at(step).is_some_and(|own| own.displacement != 0.0);
        self.is_held() && !(0..self.results.steps.len()).any(moves)
    }

    fn is_held(&self) -> bool {
        matches!(self.set.kind, SetKind::Held { .. })
    }

    /// "x", "−y", "30°", or against the normal.
    fn direction(&self) -> String {
        match self.set.kind {
            SetKind::Pressure => "−n".to_owned(),
            SetKind::Force { direction } | SetKind::Held { direction } => named(direction),
        }
    }

    /// What the set is called: its load, or the set and the direction in which it is held.
    fn name(&self) -> String {
        if self.is_held() {
            format!("{} {}", self.set.name, self.direction())
        } else {
            self.set.name.clone()
        }
    }

    fn force_unit(&self) -> &'static str {
        self.results.units.force.name
    }

    fn force(&self, step: usize) -> Option<f64> {
        Some(self.results.units.force.from_base(self.at(step)?.force))
    }

    fn displacement(&self, step: usize) -> Option<f64> {
        let unit = self.results.units.length;
        Some(unit.from_base(self.at(step)?.displacement))
    }

    fn stiffness_unit(&self) -> String {
        let units = self.results.units;
        format!("{}/{}", units.force.name, units.length.name)
    }

    /// A stiffness in display units.
    fn shown(&self, stiffness: f64) -> f64 {
        let units = self.results.units;
        units.force.from_base(stiffness) / units.length.from_base(1.0)
    }

    fn secant(&self, step: usize) -> Option<f64> {
        self.stiffness(step).secant.map(|own| self.shown(own))
    }

    fn tangent(&self, step: usize) -> Option<f64> {
        self.stiffness(step).tangent.map(|own| self.shown(own))
    }

    /// Its entry in `summary.json` at the end of `step`.
    fn entry(self, step: usize) -> Entry<'a> {
        Entry {
            name: &self.set.name,
            on: &self.set.on,
            kind: match self.set.kind {
                SetKind::Force { .. } => "force",
                SetKind::Pressure => "pressure",
                SetKind::Held { .. } => "held",
            },
            direction_deg: match self.set.kind {
                SetKind::Pressure => None,
                SetKind::Force { direction: [x, y] } | SetKind::Held { direction: [x, y] } => {
                    tidy(y.atan2(x).to_degrees())
                }
            },
            force: self
                .force(step)
                .map(|value| Quantity::new(value, self.force_unit())),
            displacement: (self.displacement(step))
                .map(|value| Quantity::new(value, self.results.units.length.name)),
            stiffness: (self.secant(step)).map(|value| Quantity::new(value, self.stiffness_unit())),
            tangent_stiffness: (self.tangent(step))
                .map(|value| Quantity::new(value, self.stiffness_unit())),
        }
    }
}

/// A direction for a reader.
fn named([x, y]: [f64; 2]) -> String {
    const PARALLEL: f64 = 1e-12;
    let sign = |part: f64| if part < 0.0 { "−" } else { "" };
    if y.abs() < PARALLEL {
        format!("{}x", sign(x))
    } else if x.abs() < PARALLEL {
        format!("{}y", sign(y))
    } else {
        format!("{}°", short(y.atan2(x).to_degrees()))
    }
}

/// Force, displacement and stiffness of every set that moves, one table each.
pub(super) fn tables(results: &Results) -> Vec<Table> {
    let mut sets = SetView::all(results);
    sets.retain(|own| !own.rests());
    sets.into_iter().map(table).collect()
}

fn table(set: SetView<'_>) -> Table {
    let cell = |value: Option<f64>| value.map_or("–".into(), |value| significant(value, 5));
    let unit = set.stiffness_unit();
    let mut columns = Columns::new()
        .with("step", "", |step: usize| (step + 1).to_string())
        .with("force", set.force_unit(), move |step| cell(set.force(step)))
        .with("displacement", set.results.units.length.name, move |step| {
            cell(set.displacement(step))
        })
        .with("stiffness", unit.clone(), move |step| {
            cell(set.secant(step))
        });
    let steps = set.results.steps.len();
    if steps > 1 {
        columns = columns.with("tangent", unit, move |step| cell(set.tangent(step)));
    }
    let on = &set.set.on;
    let caption = if set.is_held() {
        format!("Displacement of {on} along {}", set.direction())
    } else {
        format!("Displacement of {on} along '{}'", set.set.name)
    };
    columns.table(caption, 0..steps)
}

/// What held sets take in the step of the largest load; `None` where nothing is held.
pub(super) fn reactions(results: &Results) -> Option<Table> {
    let step = LoadScale::of(results).peak_step()?;
    let mut sets = SetView::all(results);
    sets.retain(SetView::is_held);
    if sets.is_empty() {
        return None;
    }
    let caption = format!(
        "Reactions in step {}; those of all steps are in steps.csv",
        step + 1
    );
    let headings = format!("set | along | reaction [{}]", results.units.force.name);
    let largest = sets.iter().filter_map(|own| own.force(step));
    let largest = largest.fold(0.0, |most: f64, force| most.max(force.abs()));
    let row = |own: SetView<'_>| {
        let force = own.force(step).map(|force| {
            if force.abs() > ROUNDING * largest {
                significant(force, 5)
            } else {
                "0".to_owned()
            }
        });
        [
            own.set.on.clone(),
            own.direction(),
            force.unwrap_or_else(|| "–".into()),
        ]
    };
    Some(Table::headed(caption, &headings).with_rows(sets.into_iter().map(row)))
}

/// The columns of all sets in `steps.csv`.
pub(super) fn csv_columns(results: &Results) -> Columns<'_, usize> {
    let mut columns = Columns::new();
    for set in SetView::all(results) {
        let cell = |value: Option<f64>| value.map_or_else(String::new, number);
        let column = |what: &str| format!("{}: {what}", set.name());
        let unit = set.stiffness_unit();
        if set.is_held() {
            columns = columns.with(column("reaction"), set.force_unit(), move |step| {
                cell(set.force(step))
            });
        }
        if set.rests() {
            continue;
        }
        let length = results.units.length.name;
        columns = columns
            .with(column("displacement"), length, move |step| {
                cell(set.displacement(step))
            })
            .with(column("stiffness"), unit.clone(), move |step| {
                cell(set.secant(step))
            })
            .with(column("tangent_stiffness"), unit, move |step| {
                cell(set.tangent(step))
            });
    }
    columns
}

/// A set in `summary.json`, in a step.
#[derive(Debug, Serialize)]
pub(super) struct Entry<'a> {
    name: &'a str,
    on: &'a str,
    kind: &'static str,
    direction_deg: Option<f64>,
    force: Option<Quantity>,
    displacement: Option<Quantity>,
    stiffness: Option<Quantity>,
    tangent_stiffness: Option<Quantity>,
}

/// The sets at the end of `step` in `summary.json`.
pub(super) fn entries(results: &Results, step: usize) -> Vec<Entry<'_>> {
    let all = SetView::all(results).into_iter();
    all.map(|own| own.entry(step)).collect()
}
