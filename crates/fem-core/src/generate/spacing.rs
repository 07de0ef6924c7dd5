//! Graded lists of coordinates.
//!
//! ```text
//! Δₖ = Δ₀ qᵏ,   Σ Δₖ = Δ₀ (qⁿ − 1)/(q − 1) = length
//! ```

use super::GenerateError;

/// Refuses what is not positive and finite.
pub(super) fn positive(what: &'static str, value: f64) -> Result<(), GenerateError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(GenerateError::NotPositive { what, value })
    }
}

/// Refuses a count below `needed`.
pub(super) fn at_least(
    what: &'static str,
    count: usize,
    needed: usize,
) -> Result<(), GenerateError> {
    if count < needed {
        Err(GenerateError::TooFew {
            what,
            count,
            needed,
        })
    } else {
        Ok(())
    }
}

/// Refuses a list that is not finite and strictly increasing.
pub(super) fn increasing(what: &'static str, list: &[f64]) -> Result<(), GenerateError> {
    if let Some(&value) = list.iter().find(|value| !value.is_finite()) {
        return Err(GenerateError::NotFinite { what, value });
    }
    match list.windows(2).position(|pair| pair[0] >= pair[1]) {
        Some(k) => Err(GenerateError::NotIncreasing {
            what,
            index: k + 1,
            previous: list[k],
            value: list[k + 1],
        }),
        None => Ok(()),
    }
}

/// `cells + 1` coordinates from `from` to `to` `[length]` whose spacing grows geometrically; `ratio` `[1]` is the last spacing over
/// the first.
///
/// # Errors
/// [`GenerateError::TooFew`] without cells, [`GenerateError::NotPositive`] for the ratio, [`GenerateError::NotIncreasing`]
/// or [`GenerateError::NotFinite`] for the ends.
pub fn graded(from: f64, to: f64, cells: usize, ratio: f64) -> Result<Vec<f64>, GenerateError> {
    at_least("cells", cells, 1)?;
    positive("ratio of the last to the first spacing", ratio)?;
    increasing("ends of the graded list", &[from, to])?;
    let growth = if cells == 1 {
        1.0
    } else {
        ratio.powf(1.0 / (cells - 1) as f64)
    };
    let list = placed(from, to, &fractions(cells, growth));
    increasing("graded list", &list)?;
    Ok(list)
}

/// Coordinates `[length]` as by [`graded`], but symmetric about the middle: `ratio` `[1]` is the spacing in the middle over that at both ends.
///
/// # Errors
/// As [`graded`]; `cells` must be even.
pub fn graded_both(
    from: f64,
    to: f64,
    cells: usize,
    ratio: f64,
) -> Result<Vec<f64>, GenerateError> {
    at_least("cells of a list graded to both ends", cells, 2)?;
    if !cells.is_multiple_of(2) {
        return Err(GenerateError::WrongEnd {
            what: "number of cells of a list graded to both ends",
            expected: "even",
            value: cells as f64,
        });
    }
    increasing("ends of the graded list", &[from, to])?;
    let half = graded(0.0, 1.0, cells / 2, ratio)?;
    let mirrored = half.iter().rev().skip(1).map(|f| 1.0 - f / 2.0);
    let both: Vec<f64> = half.iter().map(|f| f / 2.0).chain(mirrored).collect();
    let list = placed(from, to, &both);
    increasing("graded list", &list)?;
    Ok(list)
}

/// Coordinates from `from` to `to` `[length]` with a first spacing of about `first`, growing by at most `growth` ≥ 1 `[1]` from cell
/// to cell. The number of cells follows.
///
/// # Errors
/// [`GenerateError::NotPositive`] for `first`, [`GenerateError::WrongEnd`] for a growth below 1,
/// [`GenerateError::NotIncreasing`] or [`GenerateError::NotFinite`] for the ends.
pub fn geometric(from: f64, to: f64, first: f64, growth: f64) -> Result<Vec<f64>, GenerateError> {
    let cells = geometric_cells(from, to, first, growth)?;
    Ok(placed(
        from,
        to,
        &layer_fractions(cells, first / (to - from)),
    ))
}

/// Number of cells of [`geometric`], saturating.
pub(super) fn geometric_cells(
    from: f64,
    to: f64,
    first: f64,
    growth: f64,
) -> Result<usize, GenerateError> {
    positive("first spacing", first)?;
    increasing("ends of the graded list", &[from, to])?;
    if !(growth >= 1.0 && growth.is_finite()) {
        let expected = "at least 1 and finite";
        return Err(GenerateError::WrongEnd {
            what: "growth of the spacing",
            expected,
            value: growth,
        });
    }
    let total = (to - from) / first;
    let excess = growth - 1.0;
    let cells = if excess * total < 1e-9 {
        total
    } else {
        (excess * total).ln_1p() / excess.ln_1p()
    };
    // A length of 4.000000001 cells is meant to be 4; the cast saturates.
    Ok((cells - 1e-6).ceil().max(1.0) as usize)
}

/// Fractions 0 … 1 of `cells` layers, the first of which takes `first`; equal layers if that is more than their share.
pub(super) fn layer_fractions(cells: usize, first: f64) -> Vec<f64> {
    if cells < 2 || first * cells as f64 >= 1.0 {
        return fractions(cells, 1.0);
    }
    // The sum exceeds q^(n-1), which bounds q from above; bisection to the last bit is monotone and deterministic.
    let (mut low, mut high) = (1.0, (1.0 / first).powf(1.0 / (cells - 1) as f64));
    for _ in 0..64 {
        let middle = f64::midpoint(low, high);
        if first * geometric_sum(middle, cells as f64) < 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    fractions(cells, f64::midpoint(low, high))
}

/// Partial sums of qᵏ scaled to end at exactly 1.
fn fractions(cells: usize, growth: f64) -> Vec<f64> {
    let total = geometric_sum(growth, cells as f64);
    let mut list: Vec<f64> = (0..=cells)
        .map(|k| geometric_sum(growth, k as f64) / total)
        .collect();
    if let Some(last) = list.last_mut() {
        *last = 1.0;
    }
    list
}

/// 1 + q + … + q^(n−1), without cancellation near q = 1.
fn geometric_sum(growth: f64, terms: f64) -> f64 {
    let excess = growth - 1.0;
    if excess.abs() < 1e-12 {
        terms
    } else {
        (terms * excess.ln_1p()).exp_m1() / excess
    }
}

/// The list of fractions laid between two ends, which it reaches exactly.
fn placed(from: f64, to: f64, fractions: &[f64]) -> Vec<f64> {
    fractions
        .iter()
        .map(|f| (1.0 - f) * from + f * to)
        .collect()
}

/// Value of a list at a step: the entry, or what divides two neighbours in the ratio of the fraction.
pub(super) fn at_step(list: &[f64], step: f64) -> f64 {
    let last = list.len() - 1;
    let whole = (step as usize).min(last);
    let next = (whole + 1).min(last);
    let rest = step - whole as f64;
    (1.0 - rest) * list[whole] + rest * list[next]
}

/// The number that divides `a` to `b` at `part`; exactly `a` where both are equal, so that straight sides stay straight.
pub(super) fn between(a: f64, b: f64, part: f64) -> f64 {
    if a == b {
        a
    } else {
        (1.0 - part) * a + part * b
    }
}
