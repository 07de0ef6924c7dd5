//! How far loaded sets move and what held ones take: tables, columns of `steps.csv` and entries of `summary.json`.

use serde::ser::{Serialize, SerializeMap, Serializer};
use stickslip_report::table::{Columns, Table};
use stickslip_results::LoadScale;
use stickslip_results::{LoadedSet, Results, SetKind, SetMotion, SetStated};
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

    fn unit(&self, stated: SetStated) -> String {
        let units = self.results.units;
        match stated {
            SetStated::Force => units.force.name.to_owned(),
            SetStated::Displacement => units.length.name.to_owned(),
            SetStated::Secant | SetStated::Tangent => {
                format!("{}/{}", units.force.name, units.length.name)
            }
        }
    }

    /// A number or an error in display units.
    fn shown(&self, stated: SetStated, value: f64) -> f64 {
        let units = self.results.units;
        match stated {
            SetStated::Force => units.force.from_base(value),
            SetStated::Displacement => units.length.from_base(value),
            SetStated::Secant | SetStated::Tangent => {
                units.force.from_base(value) / units.length.from_base(1.0)
            }
        }
    }

    fn number(&self, step: usize, stated: SetStated) -> Option<f64> {
        let numbers = self.results.set_numbers(self.index, step);
        Some(self.shown(stated, numbers.get(stated)?))
    }

    fn error(&self, step: usize, stated: SetStated) -> Option<f64> {
        let errors = self.results.set_errors(self.index, step);
        Some(self.shown(stated, errors.get(stated)?))
    }

    /// A number with its error, for a table.
    fn cell(&self, step: usize, stated: SetStated) -> String {
        let Some(value) = self.number(step, stated) else {
            return "–".into();
        };
        let value = significant(value, 5);
        match self.error(step, stated) {
            Some(error) => format!("{value} ± {}", significant(error, 2)),
            None => value,
        }
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
            numbers: SetStated::ALL.map(|stated| {
                let quantity = |value| Quantity::new(value, self.unit(stated));
                let number = self.number(step, stated).map(quantity);
                (key(stated), number, self.error(step, stated).map(quantity))
            }),
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
    let steps = set.results.steps.len();
    let mut columns = Columns::new().with("step", "", |step: usize| (step + 1).to_string());
    for (heading, stated) in [
        ("force", SetStated::Force),
        ("displacement", SetStated::Displacement),
        ("stiffness", SetStated::Secant),
        ("tangent", SetStated::Tangent),
    ] {
        if steps > 1 || stated != SetStated::Tangent {
            let unit = set.unit(stated);
            columns = columns.with(heading, unit, move |step| set.cell(step, stated));
        }
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
    let force = |own: SetView<'_>| own.number(step, SetStated::Force);
    let largest = sets.iter().filter_map(|own| force(*own));
    let largest = largest.fold(0.0, |most: f64, force| most.max(force.abs()));
    let row = |own: SetView<'_>| {
        let is_zero = force(own).is_some_and(|force| force.abs() <= ROUNDING * largest);
        let reaction = if is_zero {
            "0".to_owned()
        } else {
            own.cell(step, SetStated::Force)
        };
        [own.set.on.clone(), own.direction(), reaction]
    };
    Some(Table::headed(caption, &headings).with_rows(sets.into_iter().map(row)))
}

/// The columns of all sets in `steps.csv`.
pub(super) fn csv_columns(results: &Results) -> Columns<'_, usize> {
    let mut columns = Columns::new();
    for set in SetView::all(results) {
        for stated in SetStated::ALL {
            let is_shown = match stated {
                SetStated::Force => set.is_held(),
                _ => !set.rests(),
            };
            if !is_shown {
                continue;
            }
            let what = if stated == SetStated::Force {
                "reaction"
            } else {
                key(stated)
            };
            let name = format!("{}: {what}", set.name());
            let cell = |value: Option<f64>| value.map_or_else(String::new, number);
            let error = format!("{name}_error");
            columns = columns.with(name, set.unit(stated), move |step| {
                cell(set.number(step, stated))
            });
            if results.ladder.is_some() {
                columns = columns.with(error, set.unit(stated), move |step| {
                    cell(set.error(step, stated))
                });
            }
        }
    }
    columns
}

/// The name of a number in files.
fn key(stated: SetStated) -> &'static str {
    match stated {
        SetStated::Force => "force",
        SetStated::Displacement => "displacement",
        SetStated::Secant => "stiffness",
        SetStated::Tangent => "tangent_stiffness",
    }
}

/// A set in `summary.json`, in a step.
#[derive(Debug)]
pub(super) struct Entry<'a> {
    name: &'a str,
    on: &'a str,
    kind: &'static str,
    direction_deg: Option<f64>,
    /// Key, number and error.
    numbers: [(&'static str, Option<Quantity>, Option<Quantity>); 4],
}

impl Serialize for Entry<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", self.name)?;
        map.serialize_entry("on", self.on)?;
        map.serialize_entry("kind", self.kind)?;
        map.serialize_entry("direction_deg", &self.direction_deg)?;
        for (key, number, error) in &self.numbers {
            map.serialize_entry(key, number)?;
            if let Some(error) = error {
                map.serialize_entry(&format!("{key}_error"), error)?;
            }
        }
        map.end()
    }
}

/// The sets at the end of `step` in `summary.json`.
pub(super) fn entries(results: &Results, step: usize) -> Vec<Entry<'_>> {
    let all = SetView::all(results).into_iter();
    all.map(|own| own.entry(step)).collect()
}
