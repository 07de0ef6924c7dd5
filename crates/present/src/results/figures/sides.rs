//! Stresses on both sides of a contact at the largest load: of the first body along its edge, of the second at the nodes of its field.

use stickslip_fem_core::stress::polar;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Series};
use stickslip_report::color::Color;
use stickslip_report::table::Table;
use stickslip_results::SecondSide;
use stickslip_text::significant;

use super::edge::{TICK_INTERVALS, along, around_contact, curve, place_axis};
use super::half_remark;
use crate::results::attempt::Attempt;
use crate::results::display::EdgeView;
use crate::results::zones::is_closed;

/// One side: its body, and points (place, stress) across the edge and along it, in display units.
struct Side<'a> {
    body: &'a str,
    across: Vec<[f64; 2]>,
    hoop: Vec<[f64; 2]>,
}

/// Both sides of `view` at the end of `step`, where that has the field of the second body.
fn sides<'a>(view: &EdgeView<'a>, step: usize) -> Option<[Side<'a>; 2]> {
    let second = view.geometry.second.as_ref()?;
    let results = view.results();
    let mut fields = results.steps[step].fields.iter();
    let fields = fields.find(|own| own.body == second.body)?;
    let stresses = |part: usize| {
        let of_node = |((&node, &at), normal): ((&usize, &f64), &[f64; 2])| {
            let own = polar(fields.stress[node], normal[1].atan2(normal[0]));
            (view.place(at), view.stress(own[part]))
        };
        let SecondSide {
            nodes,
            parameter,
            normals,
            ..
        } = second;
        let places = nodes.iter().zip(parameter).zip(normals);
        along(places.map(of_node), is_closed(view))
    };
    Some([
        Side {
            body: view.body(),
            across: curve(view, step, |row| view.stress(row.sigma_normal)),
            hoop: curve(view, step, |row| view.stress(row.sigma_tangential)),
        },
        Side {
            body: &results.bodies[second.body].name,
            across: stresses(0),
            hoop: stresses(1),
        },
    ])
}

/// Stresses across and along the contact on both sides.
pub(super) fn chart(view: &EdgeView<'_>) -> Attempt {
    let Some(step) = view.load().peak_step() else {
        return Ok(None);
    };
    let Some(sides) = sides(view, step) else {
        return Ok(None);
    };
    let window = around_contact(view, 2.5).filter(|_| !view.is_circle());
    let [normal, tangential, _] = view.stress_symbols();
    let unit = view.units().stress.name;
    let mut chart = LineChart::new(
        format!("Both sides of '{}'", view.geometry.name),
        place_axis(view, window, TICK_INTERVALS),
        Axis::linear(format!("Stress [{unit}]")),
    )
    .subtitle(format!("At {}", view.load().step_text(step)))
    .size(760.0, 0.45);
    for (index, side) in sides.iter().enumerate() {
        let color = Color::category(index);
        let across = Series::new(format!("{normal} of '{}'", side.body), side.across.clone());
        let hoop = Series::new(
            format!("{tangential} of '{}'", side.body),
            side.hoop.clone(),
        );
        chart = chart
            .with(across.color(color))
            .with(hoop.color(color).dash(Dash::Dashed));
    }
    let text = format!(
        "Stresses across (solid) and along (dashed) the contact in both bodies. Those of '{}' are nodal stresses recovered from its cells, with the error of its mesh \
         where the contact ends; where nothing else acts on the edge, {normal} of both is −p. {}",
        sides[1].body,
        half_remark(view).unwrap_or_default()
    );
    Ok(Some((chart.render()?, text.trim_end().to_owned())))
}

/// The largest and the least stresses on both sides, a row for each body; `None` without the field of the second.
pub(in crate::results) fn table(view: &EdgeView<'_>) -> Option<Table> {
    let step = view.load().peak_step()?;
    let sides = sides(view, step)?;
    let [normal, tangential, _] = view.stress_symbols();
    let (unit, place) = (view.units().stress.name, view.place_unit());
    let at = format!("at {} [{place}]", view.place_symbol());
    let headings = format!(
        "body | max {tangential} [{unit}] | {at} | min {tangential} [{unit}] | {at} | min {normal} [{unit}] | {at}"
    );
    let cells = |found: Option<[f64; 2]>| {
        found.map_or(["–".to_owned(), "–".to_owned()], |[place, stress]| {
            [significant(stress, 4), significant(place, 3)]
        })
    };
    let row = |side: &Side<'_>| {
        let least = |points: &[[f64; 2]]| {
            let points = points.iter().copied();
            points.min_by(|one, other| one[1].total_cmp(&other[1]))
        };
        let most = side.hoop.iter().copied();
        let most = most.max_by(|one, other| one[1].total_cmp(&other[1]));
        let own = [most, least(&side.hoop), least(&side.across)].map(cells);
        std::iter::once(side.body.to_owned()).chain(own.into_iter().flatten())
    };
    let caption = format!(
        "Both sides of '{}' at {}",
        view.geometry.name,
        view.load().step_text(step)
    );
    Some(Table::headed(caption, &headings).with_rows(sides.iter().map(row)))
}
