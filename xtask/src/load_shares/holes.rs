//! Bars that know of their holes.
//!
//! With β = 1/E w t of a plate, radius a of the holes, and N_k the mean of the section forces on both sides of bolt k, the forces f of the bolts, of the sum P, have the least
//!
//! ```text
//! Σ_k {½ C' f_k² + Σ_plates β (3a f_k N_k + ½ (3πa²/w) N_k²)} + Σ_plates Σ_between ½ β pitch N²
//! C' = C − (3a/2 + 3πa²/4w) Σ_plates β
//! ```
//!
//! Under a section force N the edge of a hole on which a bolt bears moves by 3aβN against the centre, and a hole makes its plate longer by (3πa²/w) βN, both as in a wide plate (Kirsch
//! 1898). C is the compliance that is measured on one bolt, which all load reaches from one side: N = f/2.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::bars;
use crate::joints::{RADIUS, WIDTH};

/// A plate longer by so much `[mm]`: what a hole adds under a section force, and a bolt's displacement against it.
const LONGER: f64 = 3.0 * PI * RADIUS * RADIUS / WIDTH;
const MOVED: f64 = 3.0 * RADIUS;

/// Forces on `count` bolts as parts of the load, by springs of the compliance `spring` `[mm/N]` at a `pitch` `[mm]`.
pub(super) fn shares(count: usize, pitch: f64, spring: f64) -> Option<Vec<f64>> {
    let beta = bars(1.0);
    let own = spring - (0.5 * MOVED + 0.25 * LONGER) * beta.iter().sum::<f64>();
    // Forms of the forces, and of the load in the last place.
    let mut energy = DMatrix::<f64>::zeros(count + 1, count + 1);
    let mut add = |factor: f64, one: &DVector<f64>, other: &DVector<f64>| {
        energy.ger(0.5 * factor, one, other, 1.0);
        energy.ger(0.5 * factor, other, one, 1.0);
    };
    for bolt in 0..count {
        let force = DVector::from_fn(count + 1, |k, _| if k == bolt { 1.0 } else { 0.0 });
        add(own, &force, &force);
        for (plate, beta) in beta.into_iter().enumerate() {
            let (left, right) = (section(plate, count, bolt), section(plate, count, bolt + 1));
            let mean = 0.5 * (&left + &right);
            add(2.0 * MOVED * beta, &force, &mean);
            add(LONGER * beta, &mean, &mean);
            if bolt + 1 < count {
                add(pitch * beta, &right, &right);
            }
        }
    }
    let mut system = DMatrix::<f64>::zeros(count + 1, count + 1);
    system
        .view_mut((0, 0), (count, count))
        .copy_from(&energy.view((0, 0), (count, count)));
    let mut side = -energy.column(count).into_owned();
    for bolt in 0..count {
        system[(count, bolt)] = 1.0;
        system[(bolt, count)] = 1.0;
    }
    side[count] = 1.0;
    let found = system.lu().solve(&side)?;
    Some(found.iter().take(count).copied().collect())
}

/// Section force of a plate, the middle one or the outer ones, after the first `before` of `count` bolts.
fn section(plate: usize, count: usize, before: usize) -> DVector<f64> {
    let (sign, load) = if plate == 0 { (-1.0, 1.0) } else { (1.0, 0.0) };
    DVector::from_fn(count + 1, |k, _| match k {
        _ if k == count => load,
        _ if k < before => sign,
        _ => 0.0,
    })
}
