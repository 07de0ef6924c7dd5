//! The whole of every elastic body in its deformed shape, exaggerated, with its von Mises stress, half models completed by their mirror image.

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_report::axis::extent;
use stickslip_report::field::FieldPlot;
use stickslip_results::LoadScale;
use stickslip_results::{BodyFields, Results, von_mises};
use stickslip_text::{short, significant};

use super::fields::drawn;
use super::{Group, Plan};
use crate::results::attempt::Attempt;
use crate::results::names::step_name;

/// Part of a body's size that the largest displacement is drawn as, at most.
const DRAWN: f64 = 0.05;

/// One picture for each elastic body, at the largest load that acts there, where that step has fields.
pub(super) fn all(results: &Results) -> Vec<Plan<'_>> {
    let bodies = 0..results.bodies.len();
    let shapes = bodies.filter_map(|index| Shape::of(results, index));
    shapes
        .map(|shape| {
            let stem = step_name(&format!("deformed-{}", shape.name()), shape.step, results);
            Plan::new(Group::Field, stem, move || shape.draw())
        })
        .collect()
}

/// A body at the end of a step.
struct Shape<'a> {
    results: &'a Results,
    step: usize,
    mesh: &'a Mesh,
    fields: &'a BodyFields,
}

impl<'a> Shape<'a> {
    fn of(results: &'a Results, index: usize) -> Option<Self> {
        let mesh = results.bodies[index].mesh.as_deref()?;
        let step = LoadScale::of_body(results, index).peak_step()?;
        let fields = &results.steps[step].fields;
        Some(Self {
            results,
            step,
            mesh,
            fields: fields.iter().find(|own| own.body == index)?,
        })
    }

    fn name(&self) -> &str {
        &self.results.bodies[self.fields.body].name
    }

    /// Factors of x and y in the image of the other half, where one half is modelled.
    fn image(&self) -> Option<[f64; 2]> {
        let half = self.results.edges.iter().find(|edge| edge.half)?;
        Some(match half.kind {
            stickslip_results::EdgeKind::Circle { .. } => [1.0, -1.0],
            stickslip_results::EdgeKind::Line | stickslip_results::EdgeKind::Path => [-1.0, 1.0],
        })
    }

    /// Displacements of the nodes beside the mean one `[mm]`, which would only move the picture.
    fn displacements(&self) -> Vec<[f64; 2]> {
        let all: Vec<[f64; 2]> = (self.fields.displacement.chunks_exact(2))
            .map(|own| [own[0], own[1]])
            .collect();
        let image = self.image().unwrap_or([1.0; 2]);
        let count = all.len().max(1) as f64;
        // Across the line of symmetry the other half moves the other way.
        let mean = [0, 1].map(|axis| {
            let sum: f64 = all.iter().map(|own| own[axis]).sum();
            if image[axis] < 0.0 { 0.0 } else { sum / count }
        });
        all.into_iter()
            .map(|[x, y]| [x - mean[0], y - mean[1]])
            .collect()
    }

    fn draw(&self) -> Attempt {
        let (results, mesh) = (self.results, self.mesh);
        let units = results.units;
        let displacements = self.displacements();
        let sizes = displacements.iter().map(|[x, y]| x.hypot(*y));
        let largest_displacement = sizes.fold(0.0, f64::max);
        let [left, right, bottom, top] = extent(mesh.nodes().iter().copied());
        let factor = factor(DRAWN * (right - left).hypot(top - bottom) / largest_displacement);
        let nodes: Vec<Point> = (mesh.nodes().iter().zip(&displacements))
            .map(|(at, moved)| {
                [0, 1].map(|axis| units.length.from_base(at[axis] + factor * moved[axis]))
            })
            .collect();
        let cells: Vec<Vec<usize>> = (0..mesh.element_count())
            .flat_map(|cell| drawn(mesh, cell, 0))
            .collect();
        let stresses = self.fields.stress.iter().zip(&self.fields.thickness_stress);
        let values: Vec<f64> = stresses
            .map(|(&stress, &zz)| units.stress.from_base(von_mises(stress, zz)))
            .collect();
        let unit = units.stress.name;
        let load = LoadScale::of_body(results, self.fields.body);
        let mut plot = FieldPlot::new(
            format!(
                "Deformed shape of '{}', {} times",
                self.name(),
                short(factor)
            ),
            format!("σ_vM [{unit}]"),
            units.length.name,
            &nodes,
            &cells,
            &values,
        )
        .subtitle(format!("Von Mises stress at {}", load.step_text(self.step)));
        let mut own = results.steps[self.step].stresses.iter();
        let own = own.find(|own| own.body == self.fields.body);
        let largest = own.map(|own| units.stress.from_base(own.von_mises.stress));
        plot = plot.stating(largest.map_or_else(String::new, |largest| {
            format!("max {} {unit} away from supports", significant(largest, 4))
        }));
        if let Some(largest) = largest.filter(|largest| *largest > 0.0) {
            plot = plot.between(0.0, largest);
        }
        if let Some([x, y]) = self.image() {
            plot = plot.mirror([x, y, 1.0]);
        }
        let limit = results.bodies[self.fields.body].yield_stress;
        if let Some(limit) = limit {
            plot = plot.contour(units.stress.from_base(limit));
        }
        let displaced = units.length.from_base(largest_displacement);
        let text = format!(
            "The whole of '{}', displacements {} times as large, without the mean one of the body; the largest is {} {}.{}{}",
            self.name(),
            short(factor),
            significant(displaced, 3),
            units.length.name,
            largest.map_or_else(String::new, |largest| format!(
                " The colour bar ends at the largest von Mises stress away from supports, {} {unit}.",
                significant(largest, 4)
            )),
            limit.map_or("", |_| " A red line is the yield stress."),
        );
        Ok(Some((plot.render()?, text)))
    }
}

/// The factor 1, 2 or 5 times a power of ten that is not larger than `most`; 1 of a body that does not move.
fn factor(most: f64) -> f64 {
    if !most.is_finite() || most <= 0.0 {
        return 1.0;
    }
    let power = 10_f64.powf(most.log10().floor());
    let steps = [5.0, 2.0, 1.0];
    let step = steps.into_iter().find(|step| step * power <= most);
    step.unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn factors_are_round_and_not_larger() {
        assert_eq!([factor(7.3), factor(49.0), factor(0.15)], [5.0, 20.0, 0.1]);
        assert_eq!([factor(f64::INFINITY), factor(0.0)], [1.0, 1.0]);
    }
}
