//! `cargo xtask load-shares`: how rows of bolts share their load, beside bars and springs.
//!
//! Tight bolts without friction join a double lap. Their forces are compared with those of the classical model, in which the plates between the bolts are bars of the
//! compliance pitch/(E w t) and the bolts are springs:
//!
//! ```text
//! C (f_k+1 − f_k) + B_middle (P − S_k) − B_outer S_k = 0,    S_k = Σ_≤k f,    S_n = P
//! ```
//!
//! C is that of a joint of one bolt, less its bars, or by a formula ([`formulas`]). Bars that know of their holes are in [`holes`].

mod formulas;
mod holes;

use nalgebra::{DMatrix, DVector};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};
use toml::{Table, Value};

use crate::joints::{PLATES, Row, THICKNESSES, WIDTH};
use crate::study::record::{fields, needed};
use crate::study::table::Tables;
use crate::study::{Study, TaskError, solved_side_by_side};

pub(crate) const STUDY: Study = Study {
    name: "load-shares",
    solve,
    complete: |_| {},
};

/// Shanks between head and nut, and shanks that do not give.
const BEAM: &str = r#"beam = { head = "clamped", nut = "clamped" }"#;
const RIGID: &str = "rigid = {}";
/// From the last hole to a loaded or held side, and to a free one `[mm]`.
const ENDS: [f64; 2] = [48.0, 18.0];
/// Pull `[N]`; without clearance and friction all is in proportion to it.
const LOAD: f64 = 3e3;

fn solve(cases: &[Table]) -> Result<Tables, TaskError> {
    let spacing = needed(cases.first().ok_or("the study has no cases")?, "spacing")?;
    let whole = compliance_of_one(BEAM, spacing)?;
    let bearing = compliance_of_one(RIGID, spacing)?;
    let mut models = vec![("measured", whole)];
    models.extend(formulas::all()?);
    let mut tables = solved_side_by_side(cases, |case| shares(case, &models))?;
    let mut springs = vec![("bearing", bearing), ("shank", whole - bearing)];
    springs.extend([("beam", formulas::beam())]);
    springs.extend(models);
    let record = |(name, value): (&str, f64)| {
        Table::from_iter(fields([
            ("spring", name.into()),
            ("compliance_um_per_kN", (1e6 * value).into()),
        ]))
    };
    tables.insert(
        "springs".to_owned(),
        springs.into_iter().map(record).collect(),
    );
    Ok(tables)
}

/// Compliance `[mm/N]` of a bar of the middle plate and of both outer ones over `length` `[mm]`.
fn bars(length: f64) -> [f64; 2] {
    let [lower, middle, upper] = THICKNESSES;
    [middle, lower + upper].map(|thickness| length / (PLATES * WIDTH * thickness))
}

/// A row of `count` tight bolts: its forces `[N]`, and by how much the loaded side moves `[mm]`.
fn solved(
    count: usize,
    pitch: f64,
    springs: &str,
    spacing: f64,
) -> Result<(Vec<f64>, f64), TaskError> {
    let row = Row {
        clearances: &vec![[0.0; 3]; count],
        pitch,
        ends: ENDS,
        held: r#"["x"]"#,
        springs,
        spacing,
        load: LOAD,
    };
    let scene = Scene::from_text(
        &row.scene(),
        Format::Toml,
        "row.toml",
        std::path::Path::new(""),
        &[] as &[&str],
    )?;
    let results = run(&scene, &mut |_| {})?;
    let step = results.steps.first().ok_or("nothing was solved")?;
    let set = results.sets.iter().position(|set| set.name == "pull");
    let moved = set.and_then(|set| step.sets[set]);
    let moved = moved.ok_or("the loaded side has no displacement")?;
    let forces = step.fasteners.iter().map(|bolt| -bolt.layers[1].force[0]);
    Ok((forces.collect(), moved.displacement))
}

/// Compliance `[mm/N]` of a joint of one bolt, less that of its bars.
fn compliance_of_one(springs: &str, spacing: f64) -> Result<f64, TaskError> {
    let (_, moved) = solved(1, 0.0, springs, spacing)?;
    Ok(moved / LOAD - bars(ENDS[0]).iter().sum::<f64>())
}

/// Forces on `count` bolts as parts of the load, by springs of the compliance `spring` between bars `[mm/N]`.
fn classical(count: usize, spring: f64, bars: [f64; 2]) -> Option<Vec<f64>> {
    let mut system = DMatrix::<f64>::zeros(count, count);
    let mut side = DVector::<f64>::zeros(count);
    for k in 0..count - 1 {
        system[(k, k)] -= spring;
        system[(k, k + 1)] += spring;
        (0..=k).for_each(|j| system[(k, j)] -= bars[0] + bars[1]);
        side[k] = -bars[0];
    }
    system.row_mut(count - 1).fill(1.0);
    side[count - 1] = 1.0;
    let parts = system.lu().solve(&side)?;
    Some(parts.iter().copied().collect())
}

/// One row for each bolt, with its share `[% of the load]` by contact and by every model.
fn shares(case: &Table, models: &[(&str, f64)]) -> Result<Vec<Table>, TaskError> {
    let (count, pitch) = (needed(case, "bolts")? as usize, needed(case, "pitch_mm")?);
    let (forces, _) = solved(count, pitch, BEAM, needed(case, "spacing")?)?;
    let mut rows: Vec<Table> = forces
        .iter()
        .zip(1_i64..)
        .map(|(force, bolt)| {
            let mut row = case.clone();
            row.insert("bolt".to_owned(), bolt.into());
            row.insert("contact".to_owned(), (100.0 * force / LOAD).into());
            row
        })
        .collect();
    let bars = |spring: f64| classical(count, spring, bars(pitch));
    let mut found: Vec<(&str, Option<Vec<f64>>)> = models
        .iter()
        .map(|(name, spring)| (*name, bars(*spring)))
        .collect();
    let measured = models.first().map_or(0.0, |(_, spring)| *spring);
    found.push(("holes", holes::shares(count, pitch, measured)));
    for (name, parts) in found {
        let parts = parts.ok_or("the springs have no answer")?;
        let apart = parts.iter().zip(&forces);
        let apart = apart.map(|(part, force)| (part - force / LOAD).abs());
        let apart = 100.0 * apart.fold(0.0, f64::max);
        for (row, part) in rows.iter_mut().zip(parts) {
            row.insert(name.to_owned(), Value::Float(100.0 * part));
            row.insert(format!("{name}_apart"), apart.into());
        }
    }
    Ok(rows)
}
