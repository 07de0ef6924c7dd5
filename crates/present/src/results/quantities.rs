//! The numbers of an edge at the end of a load step. Each is declared once: `summary.json`, `steps.csv` and the tables of load steps show
//! what stands here, in this order.

use std::borrow::Cow;

use serde::{Serialize, Serializer};
use stickslip_report::table::Columns;
use stickslip_results::Stated;
use stickslip_text::{decimals, short, significant, tidy};

use super::display::{EdgeView, energy_unit};
use super::quantity::Quantity;
use super::sharing::{is_shared, share};
use stickslip_report::csv::number;

/// One number of an edge.
pub(super) struct EdgeQuantity {
    /// Key in `summary.json` and heading in `steps.csv`, to which places and extents add theirs.
    name: &'static str,
    kind: Kind,
    edges: Edges,
    /// Heading in tables of load steps, which leave out quantities without one.
    heading: Option<fn(&EdgeView<'_>) -> String>,
    /// The number in base units.
    value: Value,
    /// Its estimated error in base units, of a ratio that of what is divided.
    error: Option<ErrorOf>,
}

/// An estimated error.
#[derive(Clone, Copy)]
enum ErrorOf {
    Stated(Stated),
    /// That of the resultant over the bearing area.
    BearingStress,
    /// That of a share of the load.
    Share,
}

impl ErrorOf {
    fn of(self, edge: &EdgeView<'_>, step: usize) -> Option<f64> {
        match self {
            Self::Stated(stated) => edge.step(step).errors.get(stated),
            Self::BearingStress => edge.bearing_error(step),
            Self::Share => share(edge, step)?.error,
        }
    }
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
    /// Total length of slip zones `[rad or mm]`.
    Slip,
    /// `[N·mm]`.
    Work,
    /// A stress over the bearing stress; in `summary.json` and full tables only.
    Ratio,
    /// A part of a whole.
    Part,
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

// The path of a method names one lifetime of a view, a closure takes all.
#[allow(clippy::redundant_closure_for_method_calls)]
static QUANTITIES: [EdgeQuantity; 19] = [
    half("contact", |edge, step| edge.step(step).contact_half_extent).stated(Stated::ContactExtent),
    half("stick", |edge, step| edge.step(step).stick_half_extent).stated(Stated::StickExtent),
    slip("slip_away", |edge, step| {
        Some(edge.step(step).slip_lengths?[0])
    })
    .stated(Stated::SlipAway),
    slip("slip_towards", |edge, step| {
        Some(edge.step(step).slip_lengths?[1])
    })
    .stated(Stated::SlipTowards),
    place("bearing", |edge, step| edge.step(step).bearing).stated(Stated::Bearing),
    stress("peak_pressure", 5, |edge, step| {
        Some(edge.step(step).peak_pressure?.0)
    })
    .stated(Stated::PeakPressure)
    .headed(|_| "max p".into()),
    ratio("peak_pressure_over_bearing", |edge, step| {
        Some(edge.step(step).peak_pressure?.0 / edge.bearing(step)?)
    })
    .stated(Stated::PeakPressure)
    .headed(|_| "max p/σ_b".into()),
    place("peak_pressure", |edge, step| {
        Some(edge.geometry.seen(edge.step(step).peak_pressure?.1))
    })
    .stated(Stated::PeakPressurePlace)
    .headed(at),
    stress("bearing_stress", 5, |edge, step| edge.bearing(step))
        .with_error(ErrorOf::BearingStress)
        .on(Edges::Bearing),
    stress("peak_hoop", 5, |edge, step| {
        Some(edge.step(step).peak_hoop?.0)
    })
    .stated(Stated::PeakHoop)
    .on(Edges::All)
    .headed(|edge| format!("max {}", edge.stress_symbols()[1])),
    stress("peak_hoop_uncertainty", 2, |edge, step| {
        edge.step(step).peak_hoop_uncertainty
    })
    .on(Edges::All),
    place("peak_hoop", |edge, step| {
        Some(edge.geometry.seen(edge.step(step).peak_hoop?.1))
    })
    .stated(Stated::PeakHoopPlace)
    .on(Edges::All)
    .headed(at),
    ratio("peak_hoop_over_bearing", |edge, step| {
        Some(edge.step(step).peak_hoop?.0 / edge.bearing(step)?)
    })
    .stated(Stated::PeakHoop)
    .headed(|edge| format!("max {}/σ_b", edge.stress_symbols()[1])),
    stress("hoop_at_bearing_point", 5, |edge, step| {
        edge.step(step).hoop_at_bearing_point
    })
    .stated(Stated::HoopAtBearing)
    .on(Edges::All),
    ratio("hoop_at_bearing_point_over_bearing", |edge, step| {
        Some(edge.step(step).hoop_at_bearing_point? / edge.bearing(step)?)
    })
    .stated(Stated::HoopAtBearing),
    force("friction_force", |edge, step| edge.friction_force(step)).stated(Stated::FrictionForce),
    force("normal_force", |edge, step| {
        (edge.geometry.contact).then_some(edge.step(step).normal_force)
    })
    .stated(Stated::NormalForce),
    EdgeQuantity::new("load_share", Kind::Part, |edge, step| {
        Some(share(edge, step)?.part)
    })
    .with_error(ErrorOf::Share),
    EdgeQuantity::new("friction_work", Kind::Work, |edge, step| {
        Some(edge.step(step).friction_work)
    })
    .stated(Stated::FrictionWork),
];

/// The number of an edge in a step in base units.
type Value = fn(&EdgeView<'_>, usize) -> Option<f64>;

const fn half(name: &'static str, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Half, value)
}

const fn slip(name: &'static str, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Slip, value)
}

const fn place(name: &'static str, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Place, value)
}

const fn stress(name: &'static str, digits: usize, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Stress(digits), value)
}

const fn force(name: &'static str, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Force, value)
}

const fn ratio(name: &'static str, value: Value) -> EdgeQuantity {
    EdgeQuantity::new(name, Kind::Ratio, value).on(Edges::Bearing)
}

fn at(edge: &EdgeView<'_>) -> String {
    format!("at {}", edge.place_symbol())
}

/// The columns of `edge` in `steps.csv`, for steps; `prefix` stands before each name.
pub(super) fn csv_columns<'a>(edge: EdgeView<'a>, prefix: &str) -> Columns<'a, usize> {
    let here = |own: &&EdgeQuantity| own.kind != Kind::Ratio && own.has_column(&edge);
    let quantities = QUANTITIES.iter().filter(here);
    quantities.fold(Columns::new(), |columns, own| {
        let name = format!("{prefix}{}", own.file_name(&edge));
        let error = format!("{name}_error");
        let columns = columns.with(name, own.unit(&edge), move |step| {
            own.shown(&edge, step).map_or(String::new(), number)
        });
        if own.error.is_some() && edge.results().ladder.is_some() {
            columns.with(error, own.unit(&edge), move |step| {
                own.error(&edge, step).map_or(String::new(), number)
            })
        } else {
            columns
        }
    })
}

/// The columns of `edge` in a table of load steps, without ratios unless it is `full`.
pub(super) fn table_columns(edge: EdgeView<'_>, full: bool) -> Columns<'_, usize> {
    let here = |own: &&EdgeQuantity| (full || own.kind != Kind::Ratio) && own.has_column(&edge);
    let headed = QUANTITIES
        .iter()
        .filter(here)
        .filter_map(|own| Some((own, own.heading?)));
    headed.fold(Columns::new(), |columns, (own, heading)| {
        columns.with(heading(&edge), own.unit(&edge), move |step| {
            own.cell_with_error(&edge, step)
        })
    })
}

impl EdgeQuantity {
    /// A quantity of contacts that tables of load steps leave out.
    const fn new(name: &'static str, kind: Kind, value: Value) -> Self {
        Self {
            name,
            kind,
            edges: Edges::Contacts,
            heading: None,
            value,
            error: None,
        }
    }

    /// Shows the estimated error of `stated` beside the number.
    const fn stated(self, stated: Stated) -> Self {
        self.with_error(ErrorOf::Stated(stated))
    }

    const fn with_error(mut self, error: ErrorOf) -> Self {
        self.error = Some(error);
        self
    }

    const fn on(mut self, edges: Edges) -> Self {
        self.edges = edges;
        self
    }

    /// Shows the quantity in tables of load steps.
    const fn headed(mut self, heading: fn(&EdgeView<'_>) -> String) -> Self {
        self.heading = Some(heading);
        self
    }

    fn has_column(&self, edge: &EdgeView<'_>) -> bool {
        // Beside an estimated error the change to the neighbouring node says less.
        if self.name == "peak_hoop_uncertainty" && edge.results().ladder.is_some() {
            return false;
        }
        if self.kind == Kind::Part && !is_shared(edge) {
            return false;
        }
        match self.edges {
            Edges::All => true,
            Edges::Contacts => edge.geometry.contact,
            Edges::Bearing => edge.geometry.contact && edge.geometry.bearing_area.is_some(),
        }
    }

    fn unit(&self, edge: &EdgeView<'_>) -> Cow<'static, str> {
        let name = match self.kind {
            Kind::Work => return energy_unit(edge.units()).into(),
            Kind::Stress(_) => edge.units().stress.name,
            Kind::Force => edge.units().force.name,
            Kind::Place | Kind::Half | Kind::Slip => edge.place_unit(),
            Kind::Ratio | Kind::Part => "–",
        };
        name.into()
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
            Kind::Work => edge.work(value),
            Kind::Place | Kind::Half | Kind::Slip => edge.length(value),
            Kind::Ratio | Kind::Part => value,
        })
    }

    /// Its estimated error in display units.
    fn error(&self, edge: &EdgeView<'_>, step: usize) -> Option<f64> {
        let error = self.error?.of(edge, step)?;
        let shown = self.shown(edge, step)?;
        Some(match self.kind {
            Kind::Stress(_) => edge.stress(error),
            Kind::Force => edge.units().force.from_base(error),
            Kind::Place | Kind::Half | Kind::Slip => edge.length(error),
            Kind::Work => edge.work(error),
            Kind::Part => error,
            Kind::Ratio => {
                let own = ErrorOf::BearingStress.of(edge, step)?;
                (error + shown.abs() * own) / edge.bearing(step)?
            }
        })
    }

    /// The number in a table, with its estimated error.
    fn cell_with_error(&self, edge: &EdgeView<'_>, step: usize) -> String {
        let cell = self.cell(edge, step);
        match self.error(edge, step) {
            Some(error) => format!("{cell} ± {}", significant(error, 2)),
            None => cell,
        }
    }

    /// The number in a table.
    fn cell(&self, edge: &EdgeView<'_>, step: usize) -> String {
        let value = self.shown(edge, step);
        let digits = |digits| value.map_or("–".into(), |value| significant(value, digits));
        match self.kind {
            Kind::Stress(count) => digits(count),
            Kind::Force | Kind::Work => digits(5),
            Kind::Place | Kind::Half | Kind::Slip if edge.is_circle() => decimals(value, 1),
            Kind::Place | Kind::Half | Kind::Slip => value.map_or("–".into(), short),
            Kind::Ratio | Kind::Part => decimals(value, 3),
        }
    }

    fn file_name(&self, edge: &EdgeView<'_>) -> String {
        let ending = match (self.kind, edge.is_circle()) {
            (Kind::Place | Kind::Slip, true) => "_angle",
            (Kind::Place, false) => "_position",
            (Kind::Half, true) => "_half_angle",
            (Kind::Half, false) => "_half_width",
            (Kind::Slip, false) => "_width",
            _ => "",
        };
        let along_edge = !edge.slips_about_bearing();
        let name = match self.name {
            "slip_away" if along_edge => "slip_plus",
            "slip_towards" if along_edge => "slip_minus",
            name => name,
        };
        format!("{name}{ending}")
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
    Quantity(Quantity),
}

impl SummaryQuantities {
    pub(super) fn of(edge: &EdgeView<'_>, step: usize) -> Self {
        let here = |own: &&EdgeQuantity| own.edges != Edges::Bearing || edge.is_circle();
        let entry = |own: &EdgeQuantity, name: String, value: Option<f64>| match (own.kind, value) {
            (Kind::Place | Kind::Half | Kind::Slip, _) if edge.is_circle() => {
                (name + "_deg", Number::Plain(value.and_then(tidy)))
            }
            (Kind::Ratio | Kind::Part, _) | (_, None) => {
                (name, Number::Plain(value.and_then(tidy)))
            }
            (_, Some(value)) => (name, Number::Quantity(Quantity::new(value, own.unit(edge)))),
        };
        let entries = |own: &EdgeQuantity| {
            let name = own.file_name(edge);
            let error = own.error.filter(|_| edge.results().ladder.is_some());
            let error = error.map(|_| entry(own, format!("{name}_error"), own.error(edge, step)));
            std::iter::once(entry(own, name, own.shown(edge, step))).chain(error)
        };
        Self(QUANTITIES.iter().filter(here).flat_map(entries).collect())
    }
}

impl Serialize for SummaryQuantities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, number)| (key, number)))
    }
}

#[cfg(test)]
mod tests {
    use stickslip_results::{EdgeResults, Stated};

    use super::{ErrorOf, QUANTITIES};

    /// The components of the resultant have theirs with its magnitude, the place of the largest stress with two quantities.
    #[test]
    fn every_number_with_an_error_shows_it() {
        for stated in Stated::ALL {
            let shows = |error: ErrorOf| matches!(error, ErrorOf::Stated(own) if own == stated);
            let is_component = matches!(stated, Stated::ResultantX | Stated::ResultantY);
            let is_shown = QUANTITIES.iter().any(|own| own.error.is_some_and(shows));
            assert!(is_shown || is_component, "{stated:?}");
        }
    }

    /// A new field has to be named here: as what is shown in another way, or as what a quantity above shows.
    #[test]
    fn every_result_of_an_edge_is_shown() {
        let EdgeResults {
            rows: _,
            zones: _,
            resultant: _,
            contact_half_extent: _,
            bearing: _,
            stick_half_extent: _,
            slip_lengths: _,
            peak_pressure: _,
            peak_hoop: _,
            peak_hoop_uncertainty: _,
            hoop_at_bearing_point: _,
            friction_force: _,
            normal_force: _,
            friction_work: _,
            errors: _,
            row_errors: _,
        } = EdgeResults::default();
    }
}
