//! One joint under one history: the sign of the shear on the edge in every load step.

use stickslip::results::{EdgeGeometry, EdgeKind, EdgeResults};
use stickslip::run::run;
use stickslip_contact::Status;
use stickslip_friction::{FrictionLaw, History, Place};
use toml::{Table, Value};

use super::curve::{Pattern, Point, Reading, Reversal, read};
use super::{begun, loads, of_report};
use crate::study::TaskError;
use crate::study::record::{curve, fields, scene, text};

/// Angles of the report within which a change of sign counts as the one that it saw at about 30° `[degree]`.
const SEEN: [f64; 2] = [20.0, 40.0];

/// The edge at the end of a load step.
struct Step {
    /// `[lbf]`
    load: f64,
    phase: &'static str,
    reading: Reading,
    /// Angle of the report `[degree]` and τ over P/(D t) of the nodes in contact on one half.
    profile: Vec<[f64; 2]>,
}

impl Step {
    /// Angle of the report up to which the shear is reversed, coming from the bearing point.
    fn reach(&self) -> Option<f64> {
        self.reading.reach().map(of_report)
    }

    /// Whether the shear is forward below about 30° of the report and reversed above.
    fn is_as_seen(&self) -> bool {
        self.reach()
            .is_some_and(|reach| (SEEN[0]..=SEEN[1]).contains(&reach))
    }

    fn is_reversed(&self) -> bool {
        !matches!(self.reading.pattern, Pattern::None | Pattern::Forward)
    }

    /// Angles of the report where the sign changes, from the end of contact to the bearing point.
    fn changes(&self) -> Value {
        let places = self
            .reading
            .crossings
            .iter()
            .rev()
            .map(|&angle| of_report(angle));
        places.collect::<Vec<_>>().into()
    }

    fn pattern(&self) -> &'static str {
        match self.reading.pattern {
            _ if self.is_as_seen() => "as the report saw it",
            Pattern::None => "none",
            Pattern::Forward => "forward",
            Pattern::ReversedInside => "inside",
            Pattern::ReversedOutside => "outside",
            Pattern::Reversed => "everywhere",
        }
    }
}

/// A row of the case, and unless it only refines another one of each of its load steps for the table `steps`.
pub(super) fn rows(case: &Table) -> Result<Vec<Table>, TaskError> {
    let mut steps = steps(case)?;
    let mut rows = vec![summary(case, &steps)];
    if text(case, "table")? == "refined" {
        steps.clear();
    }
    for (index, step) in steps.iter().enumerate() {
        let mut row = begun(case);
        row.extend(fields([
            ("table", "steps".into()),
            ("step", (index as i64).into()),
            ("load_lbf", step.load.into()),
            ("phase", step.phase.into()),
            ("pattern", step.pattern().into()),
            ("end_deg", of_report(step.reading.end).into()),
            ("changes_deg", step.changes()),
            ("shear", curve(step.profile.iter().copied())),
        ]));
        row.extend(
            step.reach()
                .map(|reach| ("reach_deg".to_owned(), reach.into())),
        );
        rows.push(row);
    }
    Ok(rows)
}

/// What loading does, and where the sign changes at some loads.
fn summary(case: &Table, steps: &[Step]) -> Table {
    let loading = || steps.iter().filter(|step| step.phase == "loading");
    let mut row = begun(case);
    row.extend(fields([
        (
            "reversed_while_loading",
            loading().any(Step::is_reversed).into(),
        ),
        (
            "as_the_report_saw_it",
            loading().any(Step::is_as_seen).into(),
        ),
    ]));
    if let Some(last) = loading().rfind(|step| step.is_reversed()) {
        row.extend(fields([("largest_load_reversed_lbf", last.load.into())]));
    }
    let reaches = loading().filter_map(|step| Some((step.reading.reach()?, step)));
    let furthest = reaches.max_by(|a, b| a.0.total_cmp(&b.0));
    let class = match furthest.map(|(reach, _)| of_report(reach)) {
        None => "nowhere",
        Some(angle) if angle > 75.0 => "down to 75°",
        Some(angle) if angle > 60.0 => "down to 60°",
        Some(angle) if angle > SEEN[1] => "down to 40°",
        Some(_) => "down to less",
    };
    row.extend(fields([("reach", class.into())]));
    if let Some((reach, step)) = furthest {
        row.extend(fields([
            ("furthest_angle_of_report_deg", of_report(reach).into()),
            ("furthest_load_lbf", step.load.into()),
        ]));
    }
    let reversals = loading().filter_map(|step| Some((step.reading.reversal?, step)));
    let largest = reversals.max_by(|a, b| a.0.of_peak.total_cmp(&b.0.of_peak));
    row.extend(
        largest
            .into_iter()
            .flat_map(|(reversal, step)| largest_reversal(reversal, step)),
    );
    let shown = [
        ("loading", 400.0),
        ("loading", 900.0),
        ("loading", 1500.0),
        ("unloading", 700.0),
    ];
    for (phase, load) in shown {
        let mut own = steps.iter();
        if let Some(step) = own.find(|step| step.phase == phase && step.load == load) {
            row.insert(format!("{phase}_{load}_lbf_changes_deg"), step.changes());
        }
    }
    row
}

/// Where and how much the shear is reversed most.
fn largest_reversal(
    reversal: Reversal,
    step: &Step,
) -> impl IntoIterator<Item = (String, Value)> + use<> {
    fields([
        ("largest_of_peak", reversal.of_peak.into()),
        ("largest_of_limit", reversal.of_limit.into()),
        (
            "largest_angle_of_report_deg",
            of_report(reversal.angle).into(),
        ),
        ("largest_load_lbf", step.load.into()),
        ("largest_sticks", reversal.sticks.into()),
    ])
}

fn steps(case: &Table) -> Result<Vec<Step>, TaskError> {
    let scene = scene(case)?;
    let results = run(&scene, &mut |_| {})?;
    let geometry = results.edges.first().ok_or("no edge")?;
    let EdgeKind::Circle { radius, .. } = geometry.kind else {
        return Err("the edge is no circle".into());
    };
    let law = scene.contacts[0].law.as_ref();
    let loads = loads(case);
    let histories = loads.iter().zip(phases(&loads));
    let step = |(step, (&load, phase)): (&stickslip::results::StepResults, (&f64, _))| {
        let edge = &step.edges[0];
        let mean = edge.bearing_stress(geometry).ok_or("no bearing stress")?;
        let points = points(geometry, edge, |pressure, theta| {
            limit(law, pressure, theta, radius)
        });
        Ok(Step {
            load,
            phase,
            reading: read(&points),
            profile: points
                .iter()
                .map(|own| [of_report(own.angle), own.shear / mean])
                .collect(),
        })
    };
    results.steps.iter().zip(histories).map(step).collect()
}

/// The nodes in contact on one half, with friction's `limit` by pressure and θ.
pub(crate) fn points(
    geometry: &EdgeGeometry,
    edge: &EdgeResults,
    limit: impl Fn(f64, f64) -> f64,
) -> Vec<Point> {
    let nodes = geometry.parameter.iter().zip(&edge.rows);
    nodes
        .filter(|(theta, row)| **theta >= 0.0 && row.status != Status::Open)
        .map(|(&theta, row)| Point {
            angle: theta.to_degrees(),
            shear: row.tau,
            limit: limit(row.pressure, theta),
            sticks: row.status == Status::Stick,
        })
        .collect()
}

/// Largest shear at a point that has not slipped; the fibres of all these plates are counted from x.
fn limit(law: &dyn FrictionLaw, pressure: f64, theta: f64, radius: f64) -> f64 {
    let (sine, cosine) = theta.sin_cos();
    let place = Place {
        position: [radius * cosine, radius * sine],
        tangent: [-sine, cosine],
        material_angle: 0.0,
    };
    law.bound(pressure, 0.0, &place, &History::default()).stick
}

/// The phase of every step of a history: `loading` where no load was larger, `reloading` where it grows again below a larger one.
fn phases(loads: &[f64]) -> Vec<&'static str> {
    let (mut last, mut largest) = (0.0, 0.0);
    let phase = |&load: &f64| {
        let phase = if load < last {
            "unloading"
        } else if load < largest {
            "reloading"
        } else {
            "loading"
        };
        last = load;
        largest = load.max(largest);
        phase
    };
    loads.iter().map(phase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phases_follow_the_largest_load_so_far() {
        let phases = phases(&[20.0, 100.0, 50.0, 60.0, 100.0, 120.0]);
        let expected = [
            "loading",
            "loading",
            "unloading",
            "reloading",
            "loading",
            "loading",
        ];
        assert_eq!(phases, expected);
    }

    /// Coulomb friction on the report's joint: forward at 400 lb and 900 lb, reversed outside while unloading, and at 20 lb reversed
    /// near the bearing point.
    #[test]
    fn coulomb_friction_reverses_the_outside_and_that_only_while_unloading() {
        use Pattern::{Forward, ReversedInside, ReversedOutside};
        let case: Table = toml::from_str(
            "scene = 'studies/shear-sign/joint.toml'\n\
             loads = ['20 lbf', '400 lbf', '900 lbf', '400 lbf']\n\
             set = ['mesh.spacing=4.5 deg', 'loads.0.force.steps=[\"20 lbf\", \"400 lbf\", \"900 lbf\", \"400 lbf\"]']",
        )
        .expect("it reads");
        let steps = steps(&case).expect("it is solved");
        let patterns: Vec<Pattern> = steps.iter().map(|step| step.reading.pattern).collect();
        assert_eq!(
            patterns,
            [ReversedInside, Forward, Forward, ReversedOutside]
        );
        // Half of 26°, to which contact reaches at that load.
        let reach = steps[0].reading.reach().expect("it is inside");
        assert!(reach < 18.0, "{reach}");
        for step in &steps {
            let carried = step
                .reading
                .reversal
                .map_or(0.0, |reversal| reversal.of_limit);
            assert!(carried < 1.0 + 1e-9, "{carried}");
        }
    }
}
