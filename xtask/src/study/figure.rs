//! Figures from a description and tables: charts in panels; [`super::map`] has the maps.
//!
//! A chart's panels and a panel's curves are trees of nodes ([`super::record`]); a curve is drawn through the rows that have the values
//! of its `where` and of its panel's. What has no data is left out, so that one description serves full and quick plans.

use serde::Deserialize;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, ReferenceLine, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;
use toml::{Table, Value};

use super::TaskError;
use super::map::{CategoryOf, Map};
use super::quote::filled;
use super::record::{color, expanded, list, matches, number};
use super::table::Tables;

/// A figure as described.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Figure {
    /// One chart, or several in two columns with one legend.
    Chart(Chart),
    /// A cell for each row and column.
    Map(Box<Map>),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Chart {
    name: String,
    title: String,
    #[serde(default = "two")]
    columns: usize,
    /// A legend for each panel instead of one for all.
    #[serde(default)]
    own_legends: bool,
    panels: Vec<Value>,
}

#[derive(Debug, Deserialize)]
struct Panel {
    #[serde(default)]
    title: String,
    subtitle: Option<String>,
    table: String,
    #[serde(default, rename = "where")]
    wanted: Table,
    x: AxisOf,
    y: AxisOf,
    #[serde(default = "width")]
    width: f64,
    #[serde(default = "aspect")]
    aspect: f64,
    #[serde(default)]
    horizontal: Vec<Line>,
    #[serde(default)]
    vertical: Vec<Line>,
}

fn two() -> usize {
    2
}

fn width() -> f64 {
    460.0
}

fn aspect() -> f64 {
    0.72
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct AxisOf {
    label: String,
    #[serde(default)]
    log: bool,
    between: Option<[f64; 2]>,
    every: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    at: f64,
    #[serde(default)]
    label: String,
}

#[derive(Debug, Deserialize)]
struct Curve {
    label: String,
    #[serde(default, rename = "where")]
    wanted: Table,
    /// Formulas of the coordinates, one point for each row …
    #[serde(default)]
    x: String,
    #[serde(default)]
    y: String,
    /// … or the key of whole curves.
    points: Option<String>,
    /// Keys of the ends of an interval along x.
    spread: Option<[String; 2]>,
    /// Index of a colour, or `#rrggbb`; the curve's place among all of its panel otherwise.
    color: Option<Value>,
    #[serde(default)]
    dash: DashOf,
    #[serde(default)]
    style: StyleOf,
    width: Option<f64>,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
enum DashOf {
    #[default]
    Solid,
    Dashed,
    Dotted,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
enum StyleOf {
    #[default]
    Line,
    Markers,
    Both,
}

impl Figure {
    /// Name of its files, and the drawing; `None` without data.
    pub(crate) fn draw(
        &self,
        tables: &Tables,
        categories: &[CategoryOf],
    ) -> Result<Option<(&str, Svg)>, TaskError> {
        Ok(match self {
            Self::Chart(chart) => chart.draw(tables)?.map(|svg| (chart.name.as_str(), svg)),
            Self::Map(map) => map
                .draw(tables, categories)?
                .map(|svg| (map.name.as_str(), svg)),
        })
    }
}

impl Chart {
    fn draw(&self, tables: &Tables) -> Result<Option<Svg>, TaskError> {
        let mut charts = Vec::new();
        for record in expanded(&self.panels, &Table::new(), "panels", false)? {
            charts.extend(panel(&record, tables)?);
        }
        if let [chart] = charts.as_slice() {
            let chart = LineChart {
                title: self.title.clone(),
                ..chart.clone()
            };
            return Ok(Some(chart.render()?));
        }
        if charts.is_empty() {
            return Ok(None);
        }
        let panels = Panels::new(&self.title, self.columns, charts);
        let panels = if self.own_legends {
            panels
        } else {
            panels.common_legend()
        };
        Ok(Some(panels.render()?))
    }
}

/// A panel with its curves; `None` if none has data.
fn panel(record: &Table, tables: &Tables) -> Result<Option<LineChart>, TaskError> {
    let panel: Panel = record.clone().try_into()?;
    let logs = [panel.x.log, panel.y.log];
    let (x, y) = (panel.x.axis(), panel.y.axis());
    let mut chart = LineChart {
        subtitle: panel.subtitle,
        ..LineChart::new(panel.title, x, y).size(panel.width, panel.aspect)
    };
    let rows = tables.get(&panel.table).map_or(&[][..], Vec::as_slice);
    let rows: Vec<&Table> = rows
        .iter()
        .filter(|row| matches(row, &panel.wanted))
        .collect();
    let curves = expanded(list(record, "curves"), &Table::new(), "curves", false)?;
    for (index, curve) in curves.into_iter().enumerate() {
        let curve: Curve = curve.try_into()?;
        let own: Vec<&Table> = rows
            .iter()
            .copied()
            .filter(|row| matches(row, &curve.wanted))
            .collect();
        chart = chart.with(curve.series(&own, index, logs)?);
    }
    for line in panel.horizontal {
        chart = chart.reference(ReferenceLine::horizontal(line.label, line.at));
    }
    for line in panel.vertical {
        chart = chart.reference(ReferenceLine::vertical(line.label, line.at));
    }
    let has_data = chart.series.iter().any(|series| !series.points.is_empty());
    Ok(has_data.then_some(chart))
}

impl AxisOf {
    fn axis(self) -> Axis {
        let axis = if self.log {
            Axis::log(self.label)
        } else {
            Axis::linear(self.label)
        };
        Axis {
            tick_spacing: self.every,
            range: self.between,
            ..axis
        }
    }
}

impl Curve {
    /// The curve through `rows`; without points it is still in the legend, which is the same for all panels. Logarithmic axes have no
    /// place for numbers that are not positive.
    fn series(&self, rows: &[&Table], index: usize, logs: [bool; 2]) -> Result<Series, TaskError> {
        let is_drawable = |[x, y]: [f64; 2]| (x > 0.0 || !logs[0]) && (y > 0.0 || !logs[1]);
        let (mut points, mut spread) = (Vec::new(), Vec::new());
        for row in rows {
            if let Some(key) = &self.points {
                points.extend(list(row, key).iter().filter_map(pair));
            }
            let point = number(row, &self.x).zip(number(row, &self.y));
            let Some(point) = point
                .map(<[f64; 2]>::from)
                .filter(|point| is_drawable(*point))
            else {
                continue;
            };
            points.push(point);
            if let Some([low, high]) = &self.spread {
                spread.push([low, high].map(|key| number(row, key).unwrap_or(0.0)));
            }
        }
        let color = match &self.color {
            Some(Value::String(text)) => color(text)?,
            Some(Value::Integer(index)) => Color::category(usize::try_from(*index)?),
            _ => Color::category(index),
        };
        let series = Series::new(filled(&self.label, rows), points)
            .spread(spread)
            .color(color)
            .dash(match self.dash {
                DashOf::Solid => Dash::Solid,
                DashOf::Dashed => Dash::Dashed,
                DashOf::Dotted => Dash::Dotted,
            })
            .style(match self.style {
                StyleOf::Line => SeriesStyle::Line,
                StyleOf::Markers => SeriesStyle::Markers,
                StyleOf::Both => SeriesStyle::Both,
            });
        Ok(match self.width {
            Some(width) => series.width(width),
            None => series,
        })
    }
}

fn pair(value: &Value) -> Option<[f64; 2]> {
    let values = value.as_array()?;
    Some([values.first()?.as_float()?, values.get(1)?.as_float()?])
}
