//! Stresses from measured displacements: the report's sensitivity study, covariance against draws, smoothing, fringe phase.
//!
//! ```text
//! Δ² = −K₂₂⁻¹ K₂₁ Δ¹,     Σ_y = T Σ Tᵀ,     rms τ ∝ E e / h for errors e of nodes at distances h
//! ```

use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::fringe::{
    Carrier, Exposure, FourierOptions, Frame, PixelMap, Plane, fourier, orders_of, picture,
};
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::{Region, independent_covariance};

use super::check::{Check, Checks, Tolerance};
use super::laboratory::{Laboratory, Trouble};
use crate::hybrid_noise::SIZE;
use crate::hybrid_noise::case::{Case, Method, SHARE, Varied, inside};
use crate::hybrid_noise::specimen::{self, DEVIATION, RADIUS, Specimen, analysed, loaded};

const MPA_PER_KSI: f64 = 6.894_757_293_168_361;
/// Lines per millimetre.
const FREQUENCY: f64 = 2400.0;
const STUDY: &str = "Post & Reddy (1988), part I, 4.2, Figs 14–19";
const EXPECTED_BY: &str = "cells of 2 mm: Post & Reddy (1988), part I, 4.2, Figs 14–19; smaller ones: an independent calculation, noise goes as 1/h";
/// Shear error by ±1/4 fringe that is to be expected: cell size along the edge `[mm]` and root mean square `[ksi]`.
const EXPECTED: [[f64; 2]; 4] = [[2.0, 0.25], [1.5, 0.36], [0.75, 0.74], [0.5, 1.06]];

fn stopped(cause: impl std::fmt::Display) -> Trouble {
    Trouble::Missing(cause.to_string())
}

/// The report's model of a contact: −30 ksi cos² in the normal direction, a shear with a peak of `shear` ksi.
fn contact(shear: f64) -> impl Fn(f64) -> [f64; 2] {
    move |theta: f64| {
        let pressure = 30.0 * MPA_PER_KSI * (1.5 * theta).cos().powi(2);
        [pressure, shear * MPA_PER_KSI * (3.0 * theta).sin()]
    }
}

/// A region under known tractions, whose boundary is measured.
struct Known {
    region: Region,
    edge: EdgeRows,
    measured: NodalDisplacements,
    /// Radial, hoop and shear stress of each edge node by the forces `[MPa]`.
    stresses: Vec<f64>,
}

impl Known {
    fn new(size: f64, shear: f64) -> Result<Self, Trouble> {
        let body: Arc<ElasticBody> = specimen::body(&analysed(size)).map_err(stopped)?;
        let u = loaded(&body, contact(shear)).map_err(stopped)?;
        let region = Region::new(&body, &[]).map_err(stopped)?;
        let edge = EdgeRows::new(&body, "inner").map_err(stopped)?;
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
    fn noise(&self, component: usize) -> Result<f64, Trouble> {
        let rows = self.edge.component(component);
        let found = self.region.propagate(&rows, &self.measured);
        Ok(inside(&found.map_err(stopped)?.deviations()))
    }

    /// Errors of radial stress and shear over their peaks, root mean squares inside, for one draw of errors uniform in ±`quarters`/4
    /// fringe.
    fn disturbed(&self, quarters: f64) -> Result<[f64; 2], Trouble> {
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
            inside(&errors) / self.peak(component)
        }))
    }

    /// Stresses of the edge nodes from boundary displacements.
    fn answer(&self, measured: &NodalDisplacements) -> Result<Vec<f64>, Trouble> {
        let solution = self.region.solve(measured).map_err(stopped)?;
        Ok(solution.outputs(&self.edge.rows))
    }
}

/// The report's sensitivity study.
pub(super) fn sensitivity(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let mut checks = Checks::against(STUDY);
    driven(&mut checks)?;
    checks.now_against(EXPECTED_BY);
    for &[size, expected] in &EXPECTED[..laboratory.sized(3, 4)] {
        let noise = Known::new(size, 5.0)?.noise(2)? / MPA_PER_KSI;
        checks.near(
            format!("±1/4 fringe, cells of {size} mm: rms of the edge shear"),
            noise,
            expected,
            " ksi",
            Tolerance::Relative(0.2),
        );
    }
    checks.now_against(STUDY);
    clear(&mut checks)?;
    lone_error(&mut checks)?;
    Ok(checks.into_list())
}

/// Force-driven against displacement-driven.
fn driven(checks: &mut Checks) -> Result<(), Trouble> {
    let known = Known::new(1.0, 5.0)?;
    let found = known.answer(&known.measured)?;
    let differences = found
        .iter()
        .zip(&known.stresses)
        .map(|(a, b)| (a - b).abs());
    checks.rounding_below(
        "edge stresses, displacements prescribed instead of forces",
        "largest difference over the peak",
        differences.fold(0.0, f64::max) / known.peak(0),
        1e-9,
    );
    Ok(())
}

/// Noise over peaks for shears of 5 and 1 ksi, and for ten times the error.
fn clear(checks: &mut Checks) -> Result<(), Trouble> {
    let [strong, weak] = [Known::new(2.0, 5.0)?, Known::new(2.0, 1.0)?];
    let (normal, shear) = (strong.noise(0)?, strong.noise(2)?);
    checks.error_below(
        "±1/4 fringe, cells of 2 mm: noise of the radial stress over its peak",
        format!("{:.2} ksi", normal / MPA_PER_KSI),
        normal / strong.peak(0),
        0.02,
    );
    for (known, peak, limit) in [(&strong, 5.0, 0.1), (&weak, 1.0, 0.4)] {
        checks.error_below(
            format!("±1/4 fringe, cells of 2 mm: noise over a shear peak of {peak} ksi"),
            format!("{:.2} ksi", shear / MPA_PER_KSI),
            shear / known.peak(2),
            limit,
        );
    }
    let small = strong.disturbed(1.0)?;
    checks.holds(
        "±1/4 fringe, one draw: rms error over the peak, normal and shear",
        "no discernible change; clear",
        format!(
            "{:.1} % radial, {:.1} % in shear",
            100.0 * small[0],
            100.0 * small[1]
        ),
        small[0] < 0.03 && small[1] < 0.12,
    );
    let large = strong.disturbed(10.0)?;
    checks.holds(
        "±2.5 fringes, one draw: rms error over the peak, normal and shear",
        "large, worse in shear",
        format!(
            "{:.0} % radial, {:.0} % in shear",
            100.0 * large[0],
            100.0 * large[1]
        ),
        large[1] > 3.0 * large[0] && large[1] > 0.3,
    );
    Ok(())
}

/// One error of five fringes at a node of the edge.
fn lone_error(checks: &mut Checks) -> Result<(), Trouble> {
    let known = Known::new(1.0, 5.0)?;
    let middle = known.edge.nodes.len() / 4 * 2;
    let mut wrong = known.measured.clone();
    let entry = wrong
        .nodes
        .iter()
        .position(|n| *n == known.edge.nodes[middle]);
    let entry = entry.ok_or_else(|| stopped("the edge is not prescribed"))?;
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
            "one error of 5 fringes, {:.1} ksi where it is: it decays by e within",
            beyond(0) / MPA_PER_KSI
        ),
        "its neighbourhood: a cell",
        format!("{decay:.2} cells"),
        (0.0..1.0).contains(&decay),
    );
    Ok(())
}

/// Covariance, reductions and fringe phase.
pub(super) fn errors(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let (cells, seeds, draws) = laboratory.sized(([120, 50], 60, 1000), ([240, 100], 200, 4000));
    let mut checks = Checks::against("Monte Carlo simulation");
    covariance(&mut checks, draws)?;
    super::region_cost::checks(&mut checks)?;
    let specimen = Specimen::new(cells).map_err(stopped)?;
    reductions(&mut checks, &specimen, seeds)?;
    checks.now_against("the orders of which the picture was made");
    phase(&mut checks, &specimen)?;
    Ok(checks.into_list())
}

/// Variances of normal draws against T Σ Tᵀ.
fn covariance(checks: &mut Checks, draws: usize) -> Result<(), Trouble> {
    let known = Known::new(1.0, 5.0)?;
    let (region, rows) = (&known.region, &known.edge.rows);
    let propagated = region.propagate(rows, &known.measured).map_err(stopped)?;
    let sample = region
        .simulate(rows, &known.measured, draws, 11)
        .map_err(stopped)?;
    let ratios = propagated
        .deviations()
        .into_iter()
        .enumerate()
        .map(|(k, deviation)| {
            let own = sample.chunks_exact(rows.len());
            let squares = own.map(|draw| (draw[k] - propagated.values[k]).powi(2));
            squares.sum::<f64>() / draws as f64 / (deviation * deviation)
        });
    checks.near(
        format!(
            "variance of {draws} draws over T Σ Tᵀ, mean of {} stresses",
            rows.len()
        ),
        ratios.sum::<f64>() / rows.len() as f64,
        1.0,
        "",
        Tolerance::Absolute(0.05),
    );
    checks.holds(
        "solves that T takes: the fewer of outputs and boundary displacements",
        region.prescribed().len().min(rows.len()).to_string(),
        propagated.solves.to_string(),
        propagated.solves == region.prescribed().len().min(rows.len()),
    );
    Ok(())
}

/// Noise of each reduction over seeds against its covariance; what smoothing gains.
fn reductions(checks: &mut Checks, specimen: &Specimen, seeds: u64) -> Result<(), Trouble> {
    let mut nodes = 0.0;
    for method in Method::ALL {
        let case = Case {
            varied: Varied::Points,
            method,
            size: SIZE,
            spacing: SIZE / 4.0,
            stand_off: 0.0,
        };
        let row = case.solve(specimen, seeds).map_err(stopped)?;
        let row = row.ok_or_else(|| stopped("16 data per cell determine every reduction"))?;
        checks.near(
            format!(
                "{}: noise of {seeds} seeds over the propagated one",
                method.name()
            ),
            row.drawn / row.noise,
            1.0,
            "",
            Tolerance::Absolute(0.1),
        );
        if method == Method::Nodes {
            nodes = row.noise;
        }
        if method == Method::Smoothed(SHARE) {
            checks.holds(
                "smoothed fit, 16 data per cell: gain over nodes measured themselves; added bias over noise",
                "≥ 4; ≤ 0.5",
                format!("{:.1}; {:.2}", nodes / row.noise, row.bias / row.noise),
                nodes >= 4.0 * row.noise && row.bias <= 0.5 * row.noise,
            );
        }
    }
    Ok(())
}

/// Fourier phase of noise-free pictures of both fields beside the hole.
fn phase(checks: &mut Checks, specimen: &Specimen) -> Result<(), Trouble> {
    const MARGIN: f64 = 0.3;
    let window = [[10.5, -4.0], [18.0, 4.0]];
    let frame = Frame::over(window, 0.02).map_err(stopped)?;
    let places: Vec<Point> = (0..frame.pixels()).map(|k| frame.place(k)).collect();
    let found = specimen.displacements_at(&places).map_err(stopped)?;
    for (axis, gradient) in [(0, [10.0, 0.0]), (1, [0.0, 10.0])] {
        let field = found.iter().skip(axis).step_by(2).copied().collect();
        let field = PixelMap::with_gaps(frame, field).map_err(stopped)?;
        let carrier = Plane {
            gradient,
            constant: 0.0,
        };
        let orders = orders_of(&field, FREQUENCY, &carrier).map_err(stopped)?;
        let picture = picture(&orders, &Exposure::default(), 1).map_err(stopped)?;
        let options = FourierOptions::new(Carrier::Given(gradient));
        let phase = fourier(&picture, &options).map_err(stopped)?.phase;
        let inside = |[x, y]: Point| {
            (window[0][0] + MARGIN..window[1][0] - MARGIN).contains(&x)
                && (window[0][1] + MARGIN..window[1][1] - MARGIN).contains(&y)
                && x.hypot(y) > RADIUS + MARGIN
        };
        let squares: Vec<f64> = (phase.wrapped().present())
            .filter(|&(pixel, _)| inside(places[pixel]))
            .map(|(pixel, order)| order - orders.values()[pixel])
            .map(|difference| (difference - difference.round()).powi(2))
            .collect();
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        checks.near(
            format!("Fourier phase of the {} field: rms error", ["U", "V"][axis]),
            rms,
            0.0,
            " fringes",
            Tolerance::Absolute(0.01),
        );
    }
    Ok(())
}
