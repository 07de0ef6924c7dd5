//! What governs, in a sentence or two, and how many cases have findings.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::row::{JointLoad, Measures, Row};
use super::{Sweep, minima};
use stickslip_engine::results::JointMode;
use stickslip_text::{counted, short};

/// The modes from bearing to net tension.
pub(super) const ORDER: [JointMode; 5] = [
    JointMode::Bearing,
    JointMode::BearingAndShearOut,
    JointMode::ShearOut,
    JointMode::ShearOutAndNetTension,
    JointMode::NetTension,
];

/// Which mode governs how many cases, and between which values of the axes of the map; and the weakest and the strongest case.
pub fn verdict(sweep: &Sweep, rows: &[Row]) -> String {
    let unresolved = rows.iter().filter(|row| row.measures().is_none()).count();
    let failed: Vec<(usize, &JointLoad)> = rows
        .iter()
        .filter_map(|row| Some((row.case, row.joint()?)))
        .collect();
    let mut sentences = Vec::new();
    if sweep.scene.failure.is_none() {
        sentences.extend(spreads(sweep, rows));
    } else if failed.is_empty() {
        sentences.push(if sweep.criterion.is_some() {
            "No case has a failure on its characteristic curve.".to_owned()
        } else {
            "The scene asks for no characteristic curve, so no mode is called.".to_owned()
        });
    } else {
        sentences.push(modes(sweep, &failed));
        sentences.extend(called_by(sweep));
        sentences.extend(extremes(sweep, &failed));
    }
    if unresolved > 0 {
        let are = if unresolved == 1 {
            "case has"
        } else {
            "cases have"
        };
        sentences.push(format!(
            "{unresolved} of {} {are} no answer; the table gives the reasons.",
            rows.len()
        ));
    }
    sentences.extend(open_minima(sweep, rows));
    let asked = sweep.scene.failure.as_ref();
    if asked.is_some_and(|failure| failure.envelopes.is_some()) {
        sentences.push("A sweep draws none of the scene's failure.envelopes.".to_owned());
    }
    sentences.join(" ")
}

/// Number of cases with each kind of finding.
pub fn findings(rows: &[Row]) -> BTreeMap<&str, usize> {
    let mut counts = BTreeMap::new();
    for kind in rows.iter().flat_map(kinds) {
        *counts.entry(kind.as_str()).or_default() += 1;
    }
    counts
}

/// How many cases have findings, and of which kinds; `None` if no case has any.
pub fn warning(rows: &[Row]) -> Option<String> {
    let doubtful = rows.iter().filter(|row| !kinds(row).is_empty()).count();
    let mut counts: Vec<_> = findings(rows).into_iter().collect();
    counts.sort_by_key(|(_, count)| Reverse(*count));
    let counts = counts.iter().map(|(kind, count)| format!("{kind} {count}"));
    let counts: Vec<String> = counts.collect();
    (doubtful > 0).then(|| {
        format!(
            "Findings in {doubtful} of {}: {}; see the column findings of cases.csv.",
            counted(rows.len(), "case"),
            counts.join(", ")
        )
    })
}

/// Kinds of the findings of a case.
fn kinds(row: &Row) -> &[String] {
    let findings = row.measures().and_then(|own| own.findings.as_deref());
    findings.unwrap_or_default()
}

/// Between which cases the contact of joints without failure criteria lies.
fn spreads(sweep: &Sweep, rows: &[Row]) -> Option<String> {
    let stress = sweep.scene.display.stress.name;
    let pressure = spread(sweep, rows, stress, |own| own.peak_pressure)?;
    let hoop = spread(sweep, rows, "σ_b", |own| {
        Some(own.peak_hoop?[0] / own.bearing_stress?)
    });
    let hoop = hoop.map_or_else(String::new, |hoop| {
        format!(", the largest hoop stress {hoop}")
    });
    Some(format!("The largest pressure lies {pressure}{hoop}."))
}

/// "between 1 MPa (μ = 0) and 2 MPa (μ = 1)".
fn spread(
    sweep: &Sweep,
    rows: &[Row],
    unit: &str,
    value: fn(&Measures) -> Option<f64>,
) -> Option<String> {
    let known = rows
        .iter()
        .filter_map(|row| Some((row.case, value(row.measures()?)?)));
    let least = known.clone().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let most = known.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let say =
        |(case, value): (usize, f64)| format!("{} {unit} ({})", short(value), sweep.name_of(case));
    Some(format!("between {} and {}", say(least), say(most)))
}

fn modes(sweep: &Sweep, failed: &[(usize, &JointLoad)]) -> String {
    let mut parts = Vec::new();
    for mode in ORDER {
        let own = failed.iter().filter(|(_, joint)| joint.mode == mode);
        let cases: Vec<usize> = own.map(|(case, _)| *case).collect();
        if cases.is_empty() {
            continue;
        }
        let places: Vec<String> = (sweep.map.iter().flatten())
            .filter_map(|&axis| range(sweep, axis, &cases))
            .collect();
        let place = if places.is_empty() {
            String::new()
        } else {
            format!(" ({})", places.join(", "))
        };
        parts.push(format!("{} governs {}{place}", mode.name(), cases.len()));
    }
    let mut text = format!("Of {} joints, {}.", failed.len(), parts.join("; "));
    if let [only] = parts.as_slice() {
        let mode = only.split(" governs ").next().unwrap_or_default();
        text = format!("All {} joints fail by {mode}.", failed.len());
    }
    text
}

/// Which criterion calls the modes, and what it leaves out.
fn called_by(sweep: &Sweep) -> Option<String> {
    let wanted = sweep.criterion.as_deref()?;
    let mut criteria = sweep.scene.failure.iter().flat_map(|own| &own.criteria);
    let criterion = criteria.find(|own| own.name() == wanted)?;
    let title = criterion.title();
    Some(if criterion.is_ultimate() {
        format!("The mode is called by {title} along the characteristic curve.")
    } else {
        format!(
            "The mode is called by {title} along the characteristic curve, at the first failure of a ply there, which may be a crack between fibres: these are no ultimate \
             loads (\"yamada_sun\" among the scene's failure.criteria calls those)."
        )
    })
}

/// Between which values of an axis the cases lie, if they do not lie at all of them.
fn range(sweep: &Sweep, axis: usize, cases: &[usize]) -> Option<String> {
    let values = cases.iter().map(|&case| sweep.values_of(case)[axis]);
    let own = &sweep.axes[axis];
    let (low, high) = (values.clone().min()?, values.max()?);
    if low == 0 && high + 1 == own.values.len() {
        return None;
    }
    own.numbers.as_ref()?;
    Some(if low == high {
        own.assignment(low)
    } else {
        format!(
            "{} from {} to {}",
            own.symbol(),
            own.cell(low),
            own.value_text(high)
        )
    })
}

/// How many minima along axes are open, if any is.
fn open_minima(sweep: &Sweep, rows: &[Row]) -> Option<String> {
    let all = minima(sweep, rows);
    let open = all.iter().filter(|own| own.is_open).count();
    (open > 0).then(|| {
        format!(
            "Of {} along the axes, {open} may as well lie at a neighbour, by the errors.",
            if all.len() == 1 {
                "1 minimum".to_owned()
            } else {
                format!("{} minima", all.len())
            },
        )
    })
}

fn extremes(sweep: &Sweep, failed: &[(usize, &JointLoad)]) -> Option<String> {
    let loads = failed
        .iter()
        .filter_map(|(case, joint)| Some((*case, joint.load?, joint.mode)));
    let least = loads
        .clone()
        .min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let most = loads.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let unit = &sweep.load_unit;
    let say = |(case, load, mode): (usize, f64, JointMode)| {
        format!(
            "{} {unit} by {} ({})",
            short(load),
            mode.name(),
            sweep.name_of(case)
        )
    };
    (least.0 != most.0).then(|| {
        format!(
            "The weakest carries {}, the strongest {}.",
            say(least),
            say(most)
        )
    })
}
