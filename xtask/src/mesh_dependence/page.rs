//! The table, the chart, the finding in words, and the page.

use std::fmt::Write as _;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, ReferenceLine, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::{Row, Specimen, Strengths, pin, strip};

const WIDTH: f64 = 460.0;

impl Specimen {
    fn title(self) -> &'static str {
        match self {
            Self::Strip => "Strip with a crack along its fibres",
            Self::Pin => "Pinned joint, [0/±45/90]s",
        }
    }

    fn strength(self) -> &'static str {
        match self {
            Self::Strip => "largest mean stress [MPa]",
            Self::Pin => "largest load / (D t) [MPa]",
        }
    }
}

impl Strengths {
    const BOTH: [Self; 2] = [Self::Own, Self::CrackBands];

    fn name(self) -> &'static str {
        match self {
            Self::Own => "own strengths",
            Self::CrackBands => "crack bands",
        }
    }

    fn dash(self) -> Dash {
        match self {
            Self::Own => Dash::Dashed,
            Self::CrackBands => Dash::Solid,
        }
    }
}

/// Rows of one curve, from coarse to fine.
fn curve(rows: &[Row], specimen: Specimen, kind: ElementKind, strengths: Strengths) -> Vec<Row> {
    let own = |row: &&Row| {
        let case = row.case;
        (case.specimen, case.kind, case.strengths) == (specimen, kind, strengths)
    };
    rows.iter().filter(own).copied().collect()
}

const CURVES: [(Specimen, ElementKind); 3] = [
    (Specimen::Strip, ElementKind::Q4),
    (Specimen::Strip, ElementKind::Q8),
    (Specimen::Pin, ElementKind::Q8),
];

/// What the chart shows, for readers without it.
pub(super) const ALTERNATIVE: &str =
    "Strength over the size of the cells, with the plies' own strengths and with crack bands";

/// Strength over the size of the cells, both on logarithmic axes.
pub(super) fn chart(rows: &[Row]) -> Result<Svg, FigureError> {
    let panel = |specimen: Specimen| {
        let x = Axis::log("size of the cells [mm]");
        let mut chart = LineChart::new(specimen.title(), x, Axis::log(specimen.strength()));
        chart = chart.size(WIDTH, 0.8);
        let own = CURVES.iter().filter(|(own, _)| *own == specimen);
        for (index, &(_, kind)) in own.enumerate() {
            for (which, &strengths) in Strengths::BOTH.iter().enumerate() {
                let points = curve(rows, specimen, kind, strengths);
                let points = points.iter().map(|row| [row.size, row.strength]).collect();
                let series = Series::new(format!("{}, {kind:?}", strengths.name()), points);
                chart = chart.with(
                    series
                        .style(SeriesStyle::Both)
                        .color(Color::category(2 * index + which))
                        .dash(strengths.dash()),
                );
            }
        }
        match strip::fracture_mechanics() {
            Some(known) if specimen == Specimen::Strip => {
                chart.reference(ReferenceLine::horizontal("fracture mechanics", known))
            }
            _ => chart,
        }
    };
    let charts = vec![panel(Specimen::Strip), panel(Specimen::Pin)];
    let title = "Ply discount: strength over the size of the cells";
    Panels::new(title, 2, charts).render()
}

/// All cases.
pub(super) fn csv(rows: &[Row]) -> String {
    let mut text = String::from("specimen,element,strengths,cells,size_mm,strength_MPa\n");
    for Row {
        case,
        size,
        strength,
    } in rows
    {
        let _ = writeln!(
            text,
            "{},{:?},{},{},{size:.4},{strength:.3}",
            match case.specimen {
                Specimen::Strip => "strip",
                Specimen::Pin => "pinned joint",
            },
            case.kind,
            case.strengths.name(),
            case.cells,
        );
    }
    text
}

/// "25.1 to 13.3 MPa (×0.53)" from the coarsest to the finest mesh.
fn change(rows: &[Row]) -> String {
    match (rows.first(), rows.last()) {
        (Some(coarse), Some(fine)) => format!(
            "{:.1} → {:.1} MPa, ×{:.2}",
            coarse.strength,
            fine.strength,
            fine.strength / coarse.strength
        ),
        _ => "–".to_owned(),
    }
}

/// What comes out, one sentence per curve.
pub(super) fn findings(rows: &[Row]) -> String {
    let mut lines = Vec::new();
    for (specimen, kind) in CURVES {
        let plain = curve(rows, specimen, kind, Strengths::Own);
        let sizes = plain.first().zip(plain.last());
        let sizes = sizes.map_or(String::new(), |(coarse, fine)| {
            format!("{:.2} → {:.2} mm", coarse.size, fine.size)
        });
        let changes = Strengths::BOTH.iter().map(|&strengths| {
            let rows = curve(rows, specimen, kind, strengths);
            format!("{} {}", strengths.name(), change(&rows))
        });
        let changes: Vec<String> = changes.collect();
        lines.push(format!(
            "- {}, {kind:?}, cells of {sizes}: {}.",
            specimen.title(),
            changes.join("; ")
        ));
    }
    lines.join("\n")
}

/// The page.
pub(super) fn page(rows: &[Row]) -> String {
    let known = strip::fracture_mechanics().map_or(String::new(), |stress| format!("{stress:.1}"));
    let cells: Vec<String> = rows
        .iter()
        .map(|row| {
            let case = row.case;
            format!(
                "| {} | {:?} | {} | {:.3} | {:.2} |",
                case.specimen.title(),
                case.kind,
                case.strengths.name(),
                row.size,
                row.strength
            )
        })
        .collect();
    format!(
        "<!-- Generated by `cargo xtask mesh-dependence`; do not edit. -->

# What ply discount makes of a finer mesh

A ply that loses its stiffness at once, down to the part d, dissipates ½ X²(1 − d)/E per volume. Its failure gathers in one row of points, so
the energy that a crack takes per area goes with the size h of the cells, and the load at which a crack runs with √h: a finer mesh is
a weaker part, and there is no limit. Crack bands (Bažant & Oh 1983) give every cell the strength √(2 E G/((1 − d) h)), with which a
row dissipates the fracture energy G on any mesh.

![{ALTERNATIVE}](strength.png)

{findings}

**A crack.** With the plies' own strengths the load at which the strip's crack runs is an answer about the mesh, and refining it leads
nowhere. With crack bands it is a property of the material, to a few per cent on cells of half the crack's {crack} mm or less, and the same
on both kinds of cells. Its level stays above linear fracture mechanics ({known} MPa), because a row fails by the stress at its points and not by the energy that its failure sets free.

**A joint is no crack.** Its load is that of a volume of the hole's size in which plies fail one after the other, and of fibres that
break where the stress is smooth on the scale of a cell. With the plies' own strengths it falls as well, but slowly. Crack bands make it worse: on cells smaller than l₀ = 2 E G/((1 − d) X²) they raise the strength above the ply's own by
√(l₀/h), and the first failure, which no crack precedes, rises with it.

**The lesson.** Ply discount has no length of its own, and one rule does not serve both. State the size of the cells with every load of a
progressive analysis. Where a crack longer than l₀ decides, crack bands with measured fracture energies serve. Where an edge without one does,
use the plies' own strengths, show two meshes, and take the difference as part of the answer. Cells of the size l₀ are where both agree; measured
energies of broken fibres (80 to 90 kJ/m²) have it near 10 mm, larger than most holes. Scenes never raise a strength, so on the cells that a hole needs their
`crack_band` leaves the strengths of fibres as they are, and the results say so.

The strip: fibres along x, half a crack of {crack} mm in half a width of 12 mm (one quarter of the whole), pulled across its fibres; own strengths on rows of {strip_own} mm. The
joint: rigid pin of D = {diameter} mm, W/D = 2, e/D = 2, μ = 0.2, {layup} of T300/5208, its end driven until the load drops; own strengths on rows of
{pin_own:.3} mm, half a cell where 16 go along the half circle. Rows are one linear cell wide or half a quadratic one.

| specimen | cells | strengths | size [mm] | strength [MPa] |
| --- | --- | --- | --- | --- |
{table}
",
        findings = findings(rows),
        crack = strip::CRACK,
        strip_own = strip::OWN,
        diameter = 2.0 * pin::RADIUS,
        layup = pin::LAYUP,
        pin_own = pin::OWN,
        table = cells.join("\n"),
    )
}
