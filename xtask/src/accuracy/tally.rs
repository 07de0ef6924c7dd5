//! What was counted.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::{Compared, Number};

/// The truth is good to this part of the error that is tested, or the number is undecided.
const DECIDED: f64 = 0.35;
/// Errors below this part of the largest value are rounding.
const ROUNDING: f64 = 1e-9;

/// The numbers of all cases.
#[derive(Default)]
pub(crate) struct Tally {
    rows: BTreeMap<(&'static str, bool), Row>,
    asked: BTreeMap<u64, [usize; 3]>,
    families: BTreeMap<&'static str, Family>,
    failures: Vec<String>,
}

/// What was counted of one kind of draw.
#[derive(Default)]
struct Family {
    cases: usize,
    /// Cases whose accuracy was reached.
    reached: usize,
    held: usize,
    decided: usize,
}

#[derive(Default)]
struct Row {
    held: usize,
    missed: usize,
    undecided: usize,
    /// Without a limit, and so without an error.
    without: usize,
    /// Stated over true error.
    ratios: Vec<f64>,
    /// True over stated error of those missed.
    worst: f64,
}

impl Tally {
    /// Counts the numbers of a draw that was solved to the accuracy `asked`, and says which lie outside of their error.
    pub(super) fn add(&mut self, compared: &Compared, family: &'static str, asked: f64) -> String {
        let before = self.total();
        let counts = compared.numbers.iter();
        let misses = counts.filter_map(|number| self.count(number, compared));
        let misses: String = misses.collect();
        let counts = self.asked.entry(asked.to_bits()).or_default();
        counts[0] += 1;
        counts[1] += usize::from(compared.is_reached);
        counts[2] += usize::from(compared.is_met);
        let after = self.total();
        let own = self.families.entry(family).or_default();
        own.cases += 1;
        own.reached += usize::from(compared.is_reached);
        own.held += after.0 - before.0;
        own.decided += after.1 - before.1;
        misses
    }

    /// Counts a number; says so if it is decided and lies outside of its error.
    fn count(&mut self, number: &Number, compared: &Compared) -> Option<String> {
        let &Number {
            name,
            unloading,
            values: [value, exact],
            ..
        } = number;
        let row = self.rows.entry((name, unloading)).or_default();
        let Some([own, doubt]) = number.errors else {
            row.without += 1;
            return None;
        };
        let apart = (value - exact).abs();
        let rounding = ROUNDING * exact.abs().max(1.0);
        if apart <= rounding && own <= rounding {
            return None;
        }
        if doubt > DECIDED * own.max(apart) {
            row.undecided += 1;
            return None;
        }
        if apart <= own {
            row.held += 1;
        } else {
            row.missed += 1;
            row.worst = row.worst.max(apart / own.max(f64::MIN_POSITIVE));
        }
        row.ratios.push(own / apart.max(f64::MIN_POSITIVE));
        (apart > own).then(|| {
            format!(
                "  {name}: {value:.6e} ± {own:.2e}, {exact:.6e} ± {doubt:.2e}, {} nodes, {} increments, step {}\n",
                compared.nodes, compared.increments, number.step
            )
        })
    }

    pub(super) fn failed(&mut self, case: usize, family: &'static str, why: &str) -> String {
        self.families.entry(family).or_default().cases += 1;
        self.failures.push(format!("case {case}: {why}"));
        format!("  not solved: {why}\n")
    }

    /// Whether the stated errors hold in at least the share `least` of all numbers that are decided.
    pub(super) fn is_good(&self, least: f64) -> bool {
        let (held, decided) = self.total();
        held as f64 >= least * decided as f64
    }

    /// How many numbers lie within their error, of how many.
    pub(crate) fn total(&self) -> (usize, usize) {
        let sum =
            |sum: (usize, usize), row: &Row| (sum.0 + row.held, sum.1 + row.held + row.missed);
        self.rows.values().fold((0, 0), sum)
    }

    /// The same of each number, loading and unloading apart, by their names.
    pub(crate) fn shares(&self) -> impl Iterator<Item = (String, usize, usize)> {
        self.rows.iter().map(|((name, unloading), row)| {
            let name = format!("{name}, {}", steps(*unloading));
            (name, row.held, row.held + row.missed)
        })
    }

    /// The tables in Markdown.
    pub(super) fn text(&self, cases: usize, what: &str, seed: u64) -> String {
        let mut text = format!("{cases} random {what}, seed {seed}.\n\n");
        text += "| number | steps | within | of | median stated/true | worst miss, true/stated | undecided | no error |\n|---|---|---:|---:|---:|---:|---:|---:|\n";
        for ((name, unloading), row) in &self.rows {
            let decided = row.held + row.missed;
            let share = 100.0 * row.held as f64 / decided.max(1) as f64;
            let steps = steps(*unloading);
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {name} | {steps} | {share:.1} % | {decided} | {} | {} | {} | {} |",
                ratio(median(&row.ratios)),
                ratio(row.worst),
                row.undecided,
                row.without,
            );
        }
        text += "\n| asked | cases | reached | peak pressure and stress within |\n|---:|---:|---:|---:|\n";
        for (asked, [cases, reached, met]) in &self.asked {
            let percent = 100.0 * f64::from_bits(*asked);
            let _ = writeln!(text, "| {percent} % | {cases} | {reached} | {met} |");
        }
        if self.families.len() > 1 {
            text += &self.by_family();
        }
        if !self.failures.is_empty() {
            let _ = writeln!(text, "\nNot solved: {}.", self.failures.len());
            for failure in self.failures.iter().take(20) {
                let _ = writeln!(text, "- {failure}");
            }
        }
        text
    }
}

impl Tally {
    fn by_family(&self) -> String {
        let mut text =
            "\n| family | cases | reached | within | of |\n|---|---:|---:|---:|---:|\n".to_owned();
        for (name, own) in &self.families {
            let share = 100.0 * own.held as f64 / own.decided.max(1) as f64;
            let Family {
                cases,
                reached,
                decided,
                ..
            } = own;
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {name} | {cases} | {reached} | {share:.1} % | {decided} |"
            );
        }
        text
    }
}

fn steps(unloading: bool) -> &'static str {
    if unloading { "unloading" } else { "loading" }
}

/// A ratio, without digits where numbers agree to rounding.
fn ratio(value: f64) -> String {
    match value {
        value if value.is_nan() => "–".to_owned(),
        value if value > 1e3 => "> 1000".to_owned(),
        value => format!("{value:.1}"),
    }
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}
