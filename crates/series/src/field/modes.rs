//! Modes t_±K of a traction with kinks, computed as far as a place asks for them.

use std::sync::OnceLock;

use nalgebra::Complex;

use super::kink::Kink;

type C64 = Complex<f64>;

/// Orders of the first level; each next one has twice as many.
const FIRST: usize = 32;
const LEVELS: usize = 10;
/// ln 1e-16: what is left of a sum of modes that are bounded.
const DIGITS: f64 = 36.8;
/// Modes that take as long as one kink's polylogarithms, half of it because modes are to be computed first.
const PER_KINK: usize = 4;
/// Modes that are always preferred.
const ALWAYS: usize = 64;

/// t_K and t_−K by K ≥ 1, level after level.
#[derive(Clone, Debug, Default)]
pub(super) struct Modes {
    levels: [OnceLock<Vec<[C64; 2]>>; LEVELS],
}

impl Modes {
    /// Number of modes whose rest at the radius e^−`depth` is below rounding, if they are cheaper than the polylogarithms of `kinks` kinks.
    pub(super) fn enough(kinks: usize, depth: f64) -> Option<usize> {
        let most = (PER_KINK * kinks).clamp(ALWAYS, FIRST * ((1 << LEVELS) - 1));
        // On the circle rounding may put a place beyond it.
        let needed = DIGITS / depth.max(0.0);
        (needed <= most as f64).then(|| needed.ceil() as usize)
    }

    /// The first `count` pairs t_K, t_−K, at most those that [`enough`](Self::enough) gives and a few more.
    pub(super) fn first(&self, kinks: &[Kink], count: usize) -> impl Iterator<Item = [C64; 2]> {
        let mut start = 0;
        let levels = self.levels.iter().enumerate().map_while(move |(l, level)| {
            let (before, size) = (start, FIRST << l);
            start += size;
            (before < count).then(|| level.get_or_init(|| pairs(kinks, before + 1, size)))
        });
        levels.flatten().copied().take(count)
    }
}

/// `count` pairs from the order `first` on.
fn pairs(kinks: &[Kink], first: usize, count: usize) -> Vec<[C64; 2]> {
    let (zero, i) = (C64::new(0.0, 0.0), C64::new(0.0, 1.0));
    let [mut slopes, mut jumps] = [(); 2].map(|()| vec![[zero; 2]; count]);
    for kink in kinks {
        let turn = C64::from_polar(1.0, kink.angle);
        let sums = |sums: &mut [[C64; 2]], amount: C64| {
            let mut phase = C64::from_polar(1.0, first as f64 * kink.angle);
            for [positive, negative] in sums {
                *positive += amount * phase.conj();
                *negative += amount * phase;
                phase *= turn;
            }
        };
        sums(&mut slopes, kink.slope);
        if kink.jump != zero {
            sums(&mut jumps, kink.jump);
        }
    }
    let both = slopes.into_iter().zip(jumps).enumerate();
    both.map(|(index, (slopes, jumps))| {
        let k = (first + index) as f64;
        let [of_slopes, of_jumps] = [-1.0 / (k * k), 1.0 / k];
        [
            slopes[0] * of_slopes - i * jumps[0] * of_jumps,
            slopes[1] * of_slopes + i * jumps[1] * of_jumps,
        ]
    })
    .collect()
}
