//! The numbers of an edge at the end of a load step. Each is declared once: `summary.json`, `steps.csv` and the tables of load steps show
//! what stands here, in this order.

use serde::{Serialize, Serializer};
use stickslip_text::{decimals, short, significant, tidy};

use super::cells::number;
use super::display::EdgeView;

/// One number of an edge.
pub(super) struct EdgeQuantity {
    /// Key in `summary.json` and heading in `steps.csv`, to which places and extents add theirs.
    name: &'static str,
    kind: Kind,
    edges: Edges,
    /// Heading in tables of load steps, which leave out quantities without one.
    heading: Option<fn(&EdgeView<'_>) -> String>,
    /// The number in base units.
    value: fn(&EdgeView<'_>, usize) -> Option<f64>,
}

/// What a number measures.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// `[MPa]`, in tables with so many digits.
    Stress(usize),
    /// `[N]`.
    Force,
    /// A place along the edge as a reader sees it `[rad or mm]`.
    Place,
    /// Half of a length along the edge `[rad or mm]`.
    Half,
    /// A stress over the bearing stress; in `summary.json` and full tables only.
    Ratio,
}

/// The edges that have a quantity.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Edges {
    All,
    /// Contacts; null in the summary of others.
    Contacts,
    /// Contacts with a bearing stress; in the summary those of all circles.
    Bearing,
}

static QUANTITIES: [EdgeQuantity; 15] = [
    EdgeQuantity {
        name: "contact",
        kind: Kind::Half,
        edges: Edges::Contacts,
        heading: None,
        value: |edge, step| edge.step(step).contact_half_extent,
    },
    EdgeQuantity {
        name: "stick",
        kind: Kind::Half,
        edges: Edges::Contacts,
        heading: None,
        value: |edge, step| edge.step(step).stick_half_extent,
    },
    EdgeQuantity {
        name: "bearing",
        kind: Kind::Place,
        edges: Edges::Contacts,
        heading: None,
        value: |edge, step| edge.step(step).bearing,
    },
    EdgeQuantity {
        name: "peak_pressure",
        kind: Kind::Stress(5),
        edges: Edges::Contacts,
        heading: Some(|_| "max p".into()),
        value: |edge, step| Some(edge.step(step).peak_pressure?.0),
    },
    EdgeQuantity {
        name: "peak_pressure_over_bearing",
        kind: Kind::Ratio,
        edges: Edges::Bearing,
        heading: Some(|_| "max p/σ_b".into()),
        value: |edge, step| Some(edge.step(step).peak_pressure?.0 / edge.bearing(step)?),
    },
    EdgeQuantity {
        name: "peak_pressure",
        kind: Kind::Place,
        edges: Edges::Contacts,
        heading: Some(at),
        value: |edge, step| Some(edge.geometry.seen(edge.step(step).peak_pressure?.1)),
    },
    EdgeQuantity {
        name: "bearing_stress",
        kind: Kind::Stress(5),
        edges: Edges::Bearing,
        heading: None,
        value: |edge, step| edge.bearing(step),
    },
    EdgeQuantity {
        name: "peak_hoop",
        kind: Kind::Stress(5),
        edges: Edges::All,
        heading: Some(|edge| format!("max {}", edge.stress_symbols()[1])),
        value: |edge, step| Some(edge.step(step).peak_hoop?.0),
    },
    EdgeQuantity {
        name: "peak_hoop_uncertainty",
        kind: Kind::Stress(2),
        edges: Edges::All,
        heading: Some(|_| "±".into()),
        value: |edge, step| edge.step(step).peak_hoop_uncertainty,
    },
    EdgeQuantity {
        name: "peak_hoop",
        kind: Kind::Place,
        edges: Edges::All,
        heading: Some(at),
        value: |edge, step| Some(edge.geometry.seen(edge.step(step).peak_hoop?.1)),
    },
    EdgeQuantity {
        name: "peak_hoop_over_bearing",
        kind: Kind::Ratio,
        edges: Edges::Bearing,
        heading: Some(|edge| format!("max {}/σ_b", edge.stress_symbols()[1])),
        value: |edge, step| Some(edge.step(step).peak_hoop?.0 / edge.bearing(step)?),
    },
    EdgeQuantity {
        name: "hoop_at_bearing_point",
        kind: Kind::Stress(5),
        edges: Edges::All,
        heading: None,
        value: |edge, step| edge.step(step).hoop_at_bearing_point,
    },
    EdgeQuantity {
        name: "hoop_at_bearing_point_over_bearing",
        kind: Kind::Ratio,
        edges: Edges::Bearing,
        heading: None,
        value: |edge, step| Some(edge.step(step).hoop_at_bearing_point? / edge.bearing(step)?),
    },
    EdgeQuantity {
        name: "friction_force",
        kind: Kind::Force,
        edges: Edges::Contacts,
        heading: None,
        value: |edge, step| edge.friction_force(step),
    },
    EdgeQuantity {
        name: "normal_force",
        kind: Kind::Force,
        edges: Edges::Contacts,
        heading: None,
        value: |edge, step| (edge.geometry.contact).then_some(edge.step(step).normal_force),
    },
];

fn at(edge: &EdgeView<'_>) -> String {
    format!("at {}", edge.place_symbol())
}

/// A column with its heading, its unit and the cell of a step.
pub(super) struct QuantityColumn<'a> {
    pub(super) heading: String,
    pub(super) unit: &'static str,
    pub(super) cell: Box<dyn Fn(usize) -> String + 'a>,
}

/// The columns of `edge` in `steps.csv`.
pub(super) fn csv_columns(edge: EdgeView<'_>) -> impl Iterator<Item = QuantityColumn<'_>> {
    let here = move |own: &&EdgeQuantity| own.kind != Kind::Ratio && own.has_column(&edge);
    (QUANTITIES.iter().filter(here)).map(move |own| QuantityColumn {
        heading: own.file_name(&edge),
        unit: own.unit(&edge),
        cell: Box::new(move |step| own.shown(&edge, step).map_or(String::new(), number)),
    })
}

/// The columns of `edge` in a table of load steps, without ratios unless it is `full`.
pub(super) fn table_columns(
    edge: EdgeView<'_>,
    full: bool,
) -> impl Iterator<Item = QuantityColumn<'_>> {
    let here =
        move |own: &&EdgeQuantity| (full || own.kind != Kind::Ratio) && own.has_column(&edge);
    (QUANTITIES.iter().filter(here)).filter_map(move |own| {
        Some(QuantityColumn {
            heading: own.heading?(&edge),
            unit: own.unit(&edge),
            cell: Box::new(move |step| own.cell(&edge, step)),
        })
    })
}

impl EdgeQuantity {
    fn has_column(&self, edge: &EdgeView<'_>) -> bool {
        match self.edges {
            Edges::All => true,
            Edges::Contacts => edge.geometry.contact,
            Edges::Bearing => edge.geometry.contact && edge.geometry.bearing_area.is_some(),
        }
    }

    fn unit(&self, edge: &EdgeView<'_>) -> &'static str {
        match self.kind {
            Kind::Stress(_) => edge.units().stress.name,
            Kind::Force => edge.units().force.name,
            Kind::Place | Kind::Half => edge.place_unit(),
            Kind::Ratio => "–",
        }
    }

    /// The number in display units.
    fn shown(&self, edge: &EdgeView<'_>, step: usize) -> Option<f64> {
        if self.edges == Edges::Contacts && !edge.geometry.contact {
            return None;
        }
        let value = (self.value)(edge, step)?;
        Some(match self.kind {
            Kind::Stress(_) => edge.stress(value),
            Kind::Force => edge.units().force.from_base(value),
            Kind::Place | Kind::Half => edge.length(value),
            Kind::Ratio => value,
        })
    }

    /// The number in a table.
    fn cell(&self, edge: &EdgeView<'_>, step: usize) -> String {
        let value = self.shown(edge, step);
        let digits = |digits| value.map_or("–".into(), |value| significant(value, digits));
        match self.kind {
            Kind::Stress(count) => digits(count),
            Kind::Force => digits(5),
            Kind::Place | Kind::Half if edge.is_circle() => decimals(value, 1),
            Kind::Place | Kind::Half => value.map_or("–".into(), short),
            Kind::Ratio => decimals(value, 3),
        }
    }

    fn file_name(&self, edge: &EdgeView<'_>) -> String {
        let ending = match (self.kind, edge.is_circle()) {
            (Kind::Place, true) => "_angle",
            (Kind::Place, false) => "_position",
            (Kind::Half, true) => "_half_angle",
            (Kind::Half, false) => "_half_width",
            _ => "",
        };
        format!("{}{ending}", self.name)
    }
}

/// The quantities of `edge` at the end of `step` in `summary.json`.
#[derive(Debug)]
pub(super) struct SummaryQuantities(Vec<(String, Number)>);

/// A number in `summary.json`: a quantity, unless it has no dimension or its key ends in its unit.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Number {
    Plain(Option<f64>),
    Quantity {
        value: Option<f64>,
        unit: &'static str,
    },
}

impl SummaryQuantities {
    pub(super) fn of(edge: &EdgeView<'_>, step: usize) -> Self {
        let here = |own: &&EdgeQuantity| own.edges != Edges::Bearing || edge.is_circle();
        let entry = |own: &EdgeQuantity| {
            let name = own.file_name(edge);
            let value = own.shown(edge, step);
            match (own.kind, value) {
                (Kind::Place | Kind::Half, _) if edge.is_circle() => {
                    (name + "_deg", Number::Plain(value.and_then(tidy)))
                }
                (Kind::Ratio, _) | (_, None) => (name, Number::Plain(value.and_then(tidy))),
                (_, Some(value)) => {
                    let (value, unit) = (tidy(value), own.unit(edge));
                    (name, Number::Quantity { value, unit })
                }
            }
        };
        Self(QUANTITIES.iter().filter(here).map(entry).collect())
    }
}

impl Serialize for SummaryQuantities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, number)| (key, number)))
    }
}
