//! Stresses from measured displacements: covariance against draws, smoothing, fringe phase.
//!
//! ```text
//! Δ² = −K₂₂⁻¹ K₂₁ Δ¹,     Σ_y = T Σ Tᵀ
//! ```

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{
    Carrier, Exposure, FourierOptions, Frame, PixelMap, Plane, fourier, orders_of, picture,
};

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use super::sensitivity::Known;
use crate::hybrid_noise::case::{Case, Method, SHARE};
use crate::hybrid_noise::specimen::{self, FREQUENCY, RADIUS, Specimen};
use crate::publish::TaskError;

/// Cells along the edge `[mm]`.
const SIZE: f64 = 1.0;

/// Covariance, reductions and fringe phase.
pub(super) fn errors(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let (cells, seeds, draws) = laboratory.sized(([120, 50], 60, 1000), ([240, 100], 200, 4000));
    let mut checks = Checks::against("Monte Carlo simulation");
    covariance(&mut checks, draws)?;
    super::region_cost::checks(&mut checks)?;
    let specimen = Specimen::new(cells)?;
    reductions(&mut checks, &specimen, seeds)?;
    checks.now_against("the orders of which the picture was made");
    phase(&mut checks, &specimen)?;
    Ok(checks.into_list())
}

/// Variances over draws of the measured displacements, each solved by itself without T, against T Σ Tᵀ.
fn covariance(checks: &mut Checks, draws: usize) -> Result<(), TaskError> {
    let known = Known::new(1.0, 5.0)?;
    let (region, rows) = (&known.region, &known.edge.rows);
    let propagated = region.propagate(rows, &known.measured)?;
    let exact = region.values(&known.measured)?;
    let measured: Vec<f64> = (0..draws)
        .flat_map(|seed| specimen::shaken(&exact, seed as u64))
        .collect();
    let sample = region.outputs_of(rows, &measured)?;
    let ratios = propagated
        .deviations()
        .into_iter()
        .enumerate()
        .map(|(k, deviation)| {
            let own = sample.chunks_exact(rows.len());
            let squares = own.map(|draw| (draw[k] - propagated.values[k]).powi(2));
            squares.sum::<f64>() / draws as f64 / (deviation * deviation)
        });
    checks.near(format!(
            "variance of {draws} draws of ±1/4 fringe, each solved, over T Σ Tᵀ: mean of {} stresses",
            rows.len()
        ), [ratios.sum::<f64>() / rows.len() as f64, 1.0], Absolute(0.05, ""));
    checks.holds(
        "solves that T takes: the fewer of outputs and boundary displacements",
        region.prescribed().len().min(rows.len()).to_string(),
        propagated.solves.to_string(),
        propagated.solves == region.prescribed().len().min(rows.len()),
    );
    Ok(())
}

/// Noise of each reduction over seeds against its covariance; what smoothing gains.
fn reductions(checks: &mut Checks, specimen: &Specimen, seeds: u64) -> Result<(), TaskError> {
    let mut nodes = 0.0;
    for method in Method::ALL.into_iter().chain([Method::Lines]) {
        let case = Case {
            method,
            size: SIZE,
            spacing: SIZE / 4.0,
            stand_off: 0.0,
        };
        let row = case.solve(specimen, seeds)?;
        let row = row.ok_or("16 data per cell determine every reduction")?;
        checks.near(
            format!(
                "{}: noise of {seeds} seeds over the propagated one",
                method.name()
            ),
            [row.drawn / row.noise, 1.0],
            Absolute(0.1, ""),
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
fn phase(checks: &mut Checks, specimen: &Specimen) -> Result<(), TaskError> {
    const MARGIN: f64 = 0.3;
    let window = [[10.5, -4.0], [18.0, 4.0]];
    let frame = Frame::over(window, 0.02)?;
    let places: Vec<Point> = (0..frame.pixels()).map(|k| frame.place(k)).collect();
    let found = specimen.displacements_at(&places)?;
    for (axis, gradient) in [(0, [10.0, 0.0]), (1, [0.0, 10.0])] {
        let field = found.iter().skip(axis).step_by(2).copied().collect();
        let field = PixelMap::with_gaps(frame, field)?;
        let carrier = Plane {
            gradient,
            constant: 0.0,
        };
        let orders = orders_of(&field, FREQUENCY, &carrier)?;
        let picture = picture(&orders, &Exposure::default(), 1)?;
        let options = FourierOptions::new(Carrier::Given(gradient));
        let phase = fourier(&picture, &options)?.phase;
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
            [rms, 0.0],
            Absolute(0.01, " fringes"),
        );
    }
    Ok(())
}
