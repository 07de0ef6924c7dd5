//! What is varied, and all results.

use super::Trouble;
use super::case::{Load, Row, solve};
use crate::publish::side_by_side;

/// The criterion of charts; it names the mode that governs.
pub(super) const CRITERION: &str = "max_stress";
/// Clearance at which friction is varied in charts, and friction at which clearance is.
pub(super) const CLEARANCE: f64 = 0.0025;
pub(super) const FRICTION: f64 = 0.2;

/// Values of a study.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    pub(super) layups: &'static [&'static str],
    pub(super) clearances: &'static [f64],
    pub(super) frictions: &'static [f64],
    /// Spacing of corner nodes `[degree]`.
    pub(super) spacing: f64,
}

impl Plan {
    pub(super) const FULL: Self = Self {
        layups: &["[0/±45/90]s", "[0_2/60_2/-60_2]s", "[0_4/90]s", "[±45]_2s"],
        clearances: &[0.0, 0.001, CLEARANCE, 0.005, 0.01],
        frictions: &[0.0, 0.1, FRICTION, 0.35, 0.5],
        spacing: 1.5,
    };
    pub(super) const QUICK: Self = Self {
        layups: &["[0/±45/90]s", "[0_4/90]s"],
        clearances: &[0.0, CLEARANCE, 0.01],
        frictions: &[0.0, FRICTION, 0.5],
        spacing: 4.5,
    };
}

/// All joints that were solved.
pub(super) struct Study {
    pub(super) plan: Plan,
    /// For each lay-up the cosine first, then contact by clearance and friction.
    pub(super) rows: Vec<Row>,
    /// The joint for which the assumed load is worst, on a mesh of half the spacing.
    pub(super) refined: Option<Row>,
}

impl Study {
    /// Solves all joints of `plan`, side by side.
    pub(super) fn of(plan: Plan) -> Result<Self, Trouble> {
        let mut joints = Vec::new();
        for &layup in plan.layups {
            joints.push((layup, Load::Cosine));
            for &clearance in plan.clearances {
                let contact = |&friction: &f64| Load::Contact {
                    clearance,
                    friction,
                };
                let own = plan.frictions.iter().map(contact);
                joints.extend(own.map(|load| (layup, load)));
            }
        }
        let rows = side_by_side(&joints, |&(layup, load)| {
            let row = solve(layup, load, plan.spacing);
            Ok(row.map_err(|trouble| format!("{layup}, {load:?}: {trouble}"))?)
        })?;
        let mut study = Self {
            plan,
            rows,
            refined: None,
        };
        if let Some(worst) = study.worst() {
            study.refined = Some(solve(worst.layup, worst.load, 0.5 * plan.spacing)?);
        }
        Ok(study)
    }

    /// The joint whose first-ply load the assumption overstates most.
    pub(super) fn worst(&self) -> Option<&Row> {
        let ratio = |(row, assumed): &(&Row, &Row)| {
            let strengths = row.strength(CRITERION).zip(assumed.strength(CRITERION));
            strengths.map_or(f64::INFINITY, |(computed, assumed)| computed / assumed)
        };
        let least = self.pairs().min_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        least.map(|(row, _)| row)
    }

    /// The row of a lay-up with the assumed load.
    pub(super) fn cosine(&self, layup: &str) -> Option<&Row> {
        let mut own = self.rows.iter().filter(|row| row.layup == layup);
        own.find(|row| row.load == Load::Cosine)
    }

    /// The row of a lay-up with a pin.
    pub(super) fn contact(&self, layup: &str, clearance: f64, friction: f64) -> Option<&Row> {
        let load = Load::Contact {
            clearance,
            friction,
        };
        let mut own = self.rows.iter().filter(|row| row.layup == layup);
        own.find(|row| row.load == load)
    }

    /// All rows with a pin beside the one of their lay-up with the assumed load.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (&Row, &Row)> {
        self.rows
            .iter()
            .filter(|row| row.load != Load::Cosine)
            .filter_map(|row| Some((row, self.cosine(row.layup)?)))
    }
}

impl Row {
    /// P/(D t) at first-ply failure by `criterion` `[MPa]`.
    pub(super) fn strength(&self, criterion: &str) -> Option<f64> {
        let mut failures = self.failures.iter();
        let own = failures.find(|failure| failure.criterion == criterion)?;
        Some(own.bearing)
    }

    /// Clearance in percent of the radius and friction; `None` of the assumed load.
    pub(super) fn fit(&self) -> Option<(f64, f64)> {
        match self.load {
            Load::Cosine => None,
            Load::Contact {
                clearance,
                friction,
            } => Some((100.0 * clearance, friction)),
        }
    }
}
