//! The report's sensitivity study: stresses on an edge from measured displacements with errors of known size.
//!
//! ```text
//! Δ² = −K₂₂⁻¹ K₂₁ Δ¹,     rms τ ∝ E e / h for errors e of nodes at distances h
//! ```

use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::{Region, independent_covariance};

use super::check::Tolerance::Relative;
use super::check::{Check, Checks};
use super::laboratory::{KSI, Laboratory};
use crate::hybrid_noise::case::inside;
use crate::hybrid_noise::specimen::{self, DEVIATION, FREQUENCY, analysed, loaded};
use crate::publish::TaskError;

const STUDY: &str = "Post & Reddy (1988), part I, 4.2, Figs 14–19";
const EXPECTED_BY: &str = "cells of 2 mm: Post & Reddy (1988), part I, 4.2, Figs 14–19; smaller ones: an independent calculation, noise goes as 1/h";
/// Shear error by ±1/4 fringe that is to be expected: cell size along the edge `[mm]` and root mean square `[ksi]`.
const EXPECTED: [[f64; 2]; 4] = [[2.0, 0.25], [1.5, 0.36], [0.75, 0.74], [0.5, 1.06]];

/// The report's model of a contact: −30 ksi cos² in the normal direction, a shear with a peak of `shear` ksi.
fn contact(shear: f64) -> impl Fn(f64) -> [f64; 2] {
    move |theta: f64| {
        let pressure = 30.0 * KSI * (1.5 * theta).cos().powi(2);
        [pressure, shear * KSI * (3.0 * theta).sin()]
    }
}

/// A region under known tractions, whose boundary is measured.
pub(super) struct Known {
    pub(super) region: Region,
    pub(super) edge: EdgeRows,
    pub(super) measured: NodalDisplacements,
    /// Radial, hoop and shear stress of each edge node by the forces `[MPa]`.
    stresses: Vec<f64>,
}

impl Known {
    /// Cells of `size` `[mm]` along the edge, a peak of `shear` `[ksi]`.
    pub(super) fn new(size: f64, shear: f64) -> Result<Self, TaskError> {
        let body: Arc<ElasticBody> = specimen::body(&analysed(size))?;
        let u = loaded(&body, contact(shear))?;
        let region = Region::new(&body, &[])?;
        let edge = EdgeRows::new(&body, "inner")?;
        let nodes = region.prescribed_nodes();
        let of = |row: &Vec<(usize, f64)>| row.iter().map(|&(dof, w)| w * u[dof]).sum();
        Ok(Self {
            stresses: edge.rows.iter().map(of).collect(),
            measured: NodalDisplacements {
                values: nodes
                    .iter()
                    .flat_map(|&n| [u[2 * n], u[2 * n + 1]])
                    .collect(),
                covariance: independent_covariance(nodes.len(), [DEVIATION; 2]),
                nodes,
            },
            region,
            edge,
        })
    }

    /// Greatest magnitude of a component `[MPa]`.
    fn peak(&self, component: usize) -> f64 {
        let own = self.stresses.iter().skip(component).step_by(3);
        own.fold(0.0, |most, value| value.abs().max(most))
    }

    /// Root mean square of a component's deviation by ±1/4 fringe, two cells at either end left out `[MPa]`.
    fn noise(&self, component: usize) -> Result<f64, TaskError> {
        let rows = self.edge.component(component);
        let found = self.region.propagate(&rows, &self.measured);
        Ok(inside(&found?.deviations()))
    }

    /// Errors of radial stress and shear `[MPa]`, root mean squares inside, for one draw of errors uniform in ±`quarters`/4 fringe.
    fn disturbed(&self, quarters: f64) -> Result<[f64; 2], TaskError> {
        let exact = &self.measured.values;
        let errors = specimen::shaken(&vec![0.0; exact.len()], 3);
        let values = exact.iter().zip(errors);
        let found = self.answer(&NodalDisplacements {
            values: values
                .map(|(value, error)| value + quarters * error)
                .collect(),
            ..self.measured.clone()
        })?;
        Ok([0, 2].map(|component| {
            let errors: Vec<f64> = (found.iter().zip(&self.stresses))
                .skip(component)
                .step_by(3)
                .map(|(a, b)| a - b)
                .collect();
            inside(&errors)
        }))
    }

    /// Stresses of the edge nodes from boundary displacements.
    fn answer(&self, measured: &NodalDisplacements) -> Result<Vec<f64>, TaskError> {
        let solution = self.region.solve(measured)?;
        Ok(solution.outputs(&self.edge.rows))
    }
}

/// The report's sensitivity study.
pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against(STUDY);
    driven(&mut checks)?;
    checks.now_against(EXPECTED_BY);
    for &[size, expected] in &EXPECTED[..laboratory.sized(3, 4)] {
        let noise = Known::new(size, 5.0)?.noise(2)? / KSI;
        checks.near(
            format!("±1/4 fringe, cells of {size} mm: rms of the edge shear"),
            [noise, expected],
            Relative(0.2, " ksi"),
        );
    }
    checks.now_against(STUDY);
    clear(&mut checks)?;
    lone_error(&mut checks)?;
    Ok(checks.into_list())
}

/// Force-driven against displacement-driven.
fn driven(checks: &mut Checks) -> Result<(), TaskError> {
    let known = Known::new(1.0, 5.0)?;
    let found = known.answer(&known.measured)?;
    let differences = found
        .iter()
        .zip(&known.stresses)
        .map(|(a, b)| (a - b).abs());
    checks.rounding_below(
        "edge stresses, displacements prescribed instead of forces",
        (
            "largest difference over the peak",
            differences.fold(0.0, f64::max) / known.peak(0),
        ),
        1e-9,
    );
    Ok(())
}

/// Noise over peaks for shears of 5 and 1 ksi, and for ten times the error.
fn clear(checks: &mut Checks) -> Result<(), TaskError> {
    let [strong, weak] = [Known::new(2.0, 5.0)?, Known::new(2.0, 1.0)?];
    let (normal, shear) = (strong.noise(0)?, strong.noise(2)?);
    checks.error_below(
        "±1/4 fringe, cells of 2 mm: noise of the radial stress over its peak",
        (format!("{:.2} ksi", normal / KSI), normal / strong.peak(0)),
        0.02,
    );
    for (known, peak, limit) in [(&strong, 5.0, 0.1), (&weak, 1.0, 0.4)] {
        checks.error_below(
            format!("±1/4 fringe, cells of 2 mm: noise over a shear peak of {peak} ksi"),
            (format!("{:.2} ksi", shear / KSI), shear / known.peak(2)),
            limit,
        );
    }
    one_draw(checks, &strong, 1.0, |radial, shear| {
        radial < 0.03 && shear < 0.12
    })?;
    one_draw(checks, &strong, 10.0, |radial, shear| {
        shear > 3.0 * radial && shear > 0.3
    })
}

/// One draw of errors uniform in ±`quarters`/4 fringe on cells of 2 mm; `met` is asked of the errors over their peaks.
fn one_draw(
    checks: &mut Checks,
    known: &Known,
    quarters: f64,
    met: impl Fn(f64, f64) -> bool,
) -> Result<(), TaskError> {
    let [radial, shear] = known.disturbed(quarters)?;
    let parts = [radial / known.peak(0), shear / known.peak(2)];
    checks.holds(
        format!(
            "±{} fringe, cells of 2 mm, one draw: rms error, and over the peak",
            0.25 * quarters
        ),
        if quarters > 1.0 {
            "large, worse in shear"
        } else {
            "no discernible change of the radial stress; shear clear"
        },
        format!(
            "radial {:.2} ksi, {:.1} %; shear {:.2} ksi, {:.1} %",
            radial / KSI,
            100.0 * parts[0],
            shear / KSI,
            100.0 * parts[1]
        ),
        met(parts[0], parts[1]),
    );
    Ok(())
}

/// One error of five fringes at a node of the edge.
fn lone_error(checks: &mut Checks) -> Result<(), TaskError> {
    const SIZE: f64 = 1.0;
    let known = Known::new(SIZE, 5.0)?;
    let middle = known.edge.nodes.len() / 4 * 2;
    let mut wrong = known.measured.clone();
    let entry = wrong
        .nodes
        .iter()
        .position(|n| *n == known.edge.nodes[middle]);
    let entry = entry.ok_or("the edge is not prescribed")?;
    wrong.values[2 * entry + 1] += 5.0 / FREQUENCY;
    let found = known.answer(&wrong)?;
    let error = |k: usize| (found[3 * k + 2] - known.stresses[3 * k + 2]).abs();
    let beyond = |cells: usize| {
        let far = (0..known.edge.nodes.len()).filter(|k| k.abs_diff(middle) >= 2 * cells);
        far.map(error).fold(0.0, f64::max)
    };
    let decay = 3.0 / (beyond(1) / beyond(4)).ln();
    checks.holds(
        format!(
            "cells of {SIZE} mm, one error of 5 fringes: {:.1} ksi of shear there, {:.2} ksi four cells on; it decays by e within",
            beyond(0) / KSI,
            beyond(4) / KSI
        ),
        "its neighbourhood: a cell",
        format!("{decay:.2} cells, {:.2} mm", decay * SIZE),
        (0.0..1.0).contains(&decay),
    );
    Ok(())
}
