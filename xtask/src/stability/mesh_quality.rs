//! Study 6: bad meshes, and where in an element contact ends.

mod block;
mod curves;

use stickslip_fem_core::mesh::ElementKind;

use super::history::Stages;
use super::methods::{CHAIN, methods};
use super::outcome::{Outcome, regularised};
use super::picture::{Legend, map};
use super::row::{Row, csv, element_name};
use super::{Context, Findings, Study, Trouble};
use block::{Block, Defect, Indenter};

pub(super) const STUDY: Study = Study {
    name: "06-mesh-quality",
    title: "Mesh quality",
    varied: "an elastic block under a rigid plate and under a rigid cylinder: surface layer up to 10⁴ times as wide as deep; \
             inner nodes moved by up to half a cell; mid-side nodes of the contact edge moved from the middle to the quarter \
             points; contact ending at every position within an element",
    expectation: "Uniform pressure is exact on any valid mesh, up to rounding; a mesh that is not valid is refused. Under the \
                  cylinder accuracy falls slowly with the mesh, the contact solvers do not mind, and the error has no jumps as \
                  the end of contact moves. Quadratic edges may oscillate between corner and mid-side nodes.",
    run,
};

const PLATE: &str = "uniform pressure";
const CYLINDER: &str = "peak pressure";
const BAD: &str = "Q8, cylinder pressed and pushed with friction 0.3";
/// What is moved, in the order of the table; the names of cases begin with these.
const ASPECT: &str = "aspect ratio";
const DISTORTION: &str = "distortion";
const MID_SIDE: &str = "mid-side position";
const END: &str = "end of contact";
const OSCILLATION: &str = "oscillation";
const ELEMENTS: [ElementKind; 5] = [
    ElementKind::T3,
    ElementKind::Q4,
    ElementKind::T6,
    ElementKind::Q8,
    ElementKind::Q9,
];
/// Meshes of the map of solvers, with their labels.
const MESHES: [(&str, Defect); 6] = [
    ("regular", Defect::None),
    ("aspect 10²", Defect::Aspect(1e2)),
    ("aspect 10⁴", Defect::Aspect(1e4)),
    ("distorted 0.15", Defect::Distorted(0.15)),
    ("distorted 0.25", Defect::Distorted(0.25)),
    ("mid-side 0.3", Defect::MidSide(0.3)),
];

fn run(context: &Context) -> Result<Findings, Trouble> {
    let cells = context.sized(20, 40);
    let nominal = 0.4;
    let mut jobs: Vec<(&str, f64, ElementKind, Defect)> = Vec::new();
    let aspects: &[f64] = context.sized(
        &[1.0, 1e2, 1e4],
        &[1.0, 3.0, 10.0, 30.0, 1e2, 3e2, 1e3, 3e3, 1e4],
    );
    let shares: &[f64] = context.sized(
        &[0.0, 0.3, 0.6],
        &[0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.55, 0.6],
    );
    let places: &[f64] = context.sized(
        &[0.5, 0.3, 0.25],
        &[0.5, 0.45, 0.4, 0.35, 0.3, 0.28, 0.26, 0.251, 0.25],
    );
    for kind in ELEMENTS {
        jobs.extend(
            aspects
                .iter()
                .map(|&value| (ASPECT, value, kind, Defect::Aspect(value))),
        );
        jobs.extend(
            shares
                .iter()
                .map(|&value| (DISTORTION, value, kind, Defect::Distorted(value))),
        );
        if kind.order() == 2 {
            jobs.extend(
                places
                    .iter()
                    .map(|&value| (MID_SIDE, value, kind, Defect::MidSide(value))),
            );
        }
    }
    let fine = Block {
        cells: 4 * cells,
        kind: ElementKind::Q9,
        defect: Defect::None,
    };
    let peak = fine.press(&[Indenter::cylinder(nominal)], 0.0)?[0].peak;
    let mut rows = context.rows_of(&jobs, |&(case, value, kind, defect)| {
        let block = Block {
            cells,
            kind,
            defect,
        };
        let plate = block.press(&[Indenter::plate()], 0.0);
        let cylinder = block.press(&[Indenter::cylinder(nominal)], 0.0);
        Ok(vec![
            row(
                format!("{case}: {PLATE}"),
                value,
                kind,
                plate.map(|found| found[0].deviation),
            ),
            row(
                format!("{case}: {CYLINDER}"),
                value,
                kind,
                cylinder.map(|found| (found[0].peak / peak - 1.0).abs()),
            ),
        ])
    })?;
    rows.extend(ends(context, cells, &fine)?);
    let order = [ASPECT, DISTORTION, MID_SIDE, END, OSCILLATION];
    rows.sort_by_key(|row| order.iter().position(|case| row.case.starts_with(case)));
    let solvers = solvers(context, cells)?;
    findings(&rows, solvers)
}

/// Contact that ends at every position within an element: the load moves it over one cell and a half.
fn ends(context: &Context, cells: usize, fine: &Block) -> Result<Vec<Row>, Trouble> {
    let count = context.sized(4, 24);
    let width = 2.0 / cells as f64;
    let inner = (0.4 / width).floor();
    let positions: Vec<f64> = (0..=count)
        .map(|k| inner + 1.5 * f64::from(k) / f64::from(count))
        .collect();
    let loads: Vec<Indenter> = positions
        .iter()
        .map(|&position| Indenter::cylinder(position * width))
        .collect();
    let exact = fine.press(&loads, 0.0)?;
    context.rows_of(&ELEMENTS, |&kind| {
        let own = Block {
            cells,
            kind,
            defect: Defect::None,
        }
        .press(&loads, 0.0)?;
        let mut rows = Vec::new();
        for ((&position, own), exact) in positions.iter().zip(&own).zip(&exact) {
            let error = (own.peak / exact.peak - 1.0).abs();
            rows.push(row(format!("{END}: {CYLINDER}"), position, kind, Ok(error)));
            if kind.order() == 2 {
                rows.push(row(
                    format!("{OSCILLATION}: {CYLINDER}"),
                    position,
                    kind,
                    Ok(own.oscillation),
                ));
            }
        }
        Ok(rows)
    })
}

/// Every contact solver on bad meshes.
fn solvers(context: &Context, cells: usize) -> Result<Vec<Row>, Trouble> {
    let numbered: Vec<(usize, Defect)> = MESHES
        .iter()
        .map(|(_, defect)| *defect)
        .enumerate()
        .collect();
    context.rows_of(&numbered, |&(index, defect)| {
        let block = Block {
            cells,
            kind: ElementKind::Q8,
            defect,
        };
        let (problem, loads) = block.problem(&Indenter::cylinder(0.4).pushed(), 0.3)?;
        Ok(Stages::follow(&problem, &loads).rows(BAD, index as f64, &methods()))
    })
}

fn row(case: String, value: f64, kind: ElementKind, found: Result<f64, Trouble>) -> Row {
    let (outcome, error, note) = match found {
        Ok(error) if error < 1e-7 => (Outcome::Solved, Some(error), String::new()),
        Ok(error) => (regularised(Some(error), error), Some(error), String::new()),
        Err(trouble) => (Outcome::Refused, None, trouble.to_string()),
    };
    Row {
        case,
        value,
        method: element_name(kind),
        outcome,
        solved: usize::from(error.is_some()),
        error,
        note,
        ..Row::default()
    }
}

fn findings(rows: &[Row], solvers: Vec<Row>) -> Result<Findings, Trouble> {
    let picture = map(
        &solvers,
        &Legend {
            title: "Contact solvers on bad meshes",
            subtitle: "Rigid cylinder on a block of Q8 elements, friction 0.3, pressed and pushed to and fro.",
            varied: "mesh",
            label: &|index| MESHES[index as usize].0.to_owned(),
            dividers: &[],
        },
    )?;
    let worst = |case: &str| {
        let own = rows.iter().filter(|row| row.case == case);
        own.filter_map(|row| row.error).fold(0.0, f64::max)
    };
    let refused = rows
        .iter()
        .filter(|row| row.outcome == Outcome::Refused && row.case.ends_with(PLATE))
        .count();
    let oscillation = worst(&format!("{OSCILLATION}: {CYLINDER}"));
    let mut remarks = vec![
        format!(
            "Uniform pressure is off by at most {:.0e} at any aspect ratio, {:.0e} on distorted cells and {:.0e} with moved mid-side nodes.",
            worst(&format!("{ASPECT}: {PLATE}")),
            worst(&format!("{DISTORTION}: {PLATE}")),
            worst(&format!("{MID_SIDE}: {PLATE}")),
        ),
        format!("{refused} meshes were refused, each with its cell or node."),
        format!(
            "Wherever contact ends, the peak pressure is off by at most {:.1} %.",
            100.0 * worst(&format!("{END}: {CYLINDER}"))
        ),
        format!(
            "Between mid-side nodes and the mean of their neighbours the pressure of quadratic edges jumps by up to {:.1} % of its peak.",
            100.0 * oscillation
        ),
    ];
    let chain = solvers.iter().filter(|row| row.method == CHAIN);
    if chain.clone().all(|row| row.outcome.is_answer()) {
        remarks.push("The default chain solves every step on every one of these meshes.".into());
    }
    let cells = curves::over_cells(rows)?;
    let edges = curves::over_edges(rows)?;
    let table = csv("value", rows);
    Ok(Findings {
        tables: vec![("", table), ("-solvers", csv("mesh", &solvers))],
        pictures: vec![
            (
                "-cells",
                cells,
                "Errors of each element over the shape of its cells".into(),
            ),
            (
                "-edge",
                edges,
                "Errors of each element over mid-side nodes and the end of contact".into(),
            ),
            (
                "-solvers",
                picture,
                "Outcome of each method on bad meshes".into(),
            ),
        ],
        remarks,
        rows: solvers,
        ..Findings::default()
    })
}
