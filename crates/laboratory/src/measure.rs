//! Wall times of repeated runs.
//!
//! Times on a shared machine are skewed: most runs take about as long, a few much longer. So a time is given by the median of
//! repeated runs, its spread by the quartiles q₁ and q₃; neither moves when a few runs are disturbed.

use std::time::{Duration, Instant};

/// Processor time `[s]` that the calling thread has used, which does not depend on other programs on the machine; `None`
/// where the system does not report it.
pub fn thread_seconds() -> Option<f64> {
    #[cfg(unix)]
    {
        use rustix::time::{ClockId, clock_gettime};
        let time = clock_gettime(ClockId::ThreadCPUTime);
        Some(time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64)
    }
    #[cfg(not(unix))]
    None
}

/// How often a piece of work is repeated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// Runs before the clock starts, which fill caches and memory pools.
    pub warm_up: usize,
    /// Fewest timed runs; at least one is made.
    pub least: usize,
    /// Most timed runs.
    pub most: usize,
    /// Timed runs go on until they took this long together `[s]`.
    pub seconds: f64,
}

impl Default for Repeat {
    fn default() -> Self {
        Self {
            warm_up: 1,
            least: 5,
            most: 50,
            seconds: 0.5,
        }
    }
}

impl Repeat {
    /// One timed run without warm-up.
    pub const ONCE: Self = Self {
        warm_up: 0,
        least: 1,
        most: 1,
        seconds: 0.0,
    };

    /// Whether another run is due after `runs` timed ones that took `total` `[s]` together.
    pub fn goes_on(&self, runs: usize, total: f64) -> bool {
        runs < self.least.max(1) || (runs < self.most && total < self.seconds)
    }
}

/// Median and quartiles of repeated runs `[s]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// Median.
    pub median: f64,
    /// First quartile.
    pub lower: f64,
    /// Third quartile.
    pub upper: f64,
    /// Number of runs.
    pub runs: usize,
}

impl Timing {
    /// Median and quartiles of `samples` `[s]`, interpolated linearly between neighbours (Hyndman & Fan 1996, type 7); all
    /// NaN without samples.
    pub fn of(samples: &[f64]) -> Self {
        let mut sorted = samples.to_vec();
        sorted.sort_by(f64::total_cmp);
        let quantile = |part: f64| {
            let place = part * sorted.len().saturating_sub(1) as f64;
            let below = place.floor() as usize;
            let at = |k: usize| sorted.get(k).copied().unwrap_or(f64::NAN);
            let next = at((below + 1).min(sorted.len().saturating_sub(1)));
            at(below) + (place - below as f64) * (next - at(below))
        };
        Self {
            median: quantile(0.5),
            lower: quantile(0.25),
            upper: quantile(0.75),
            runs: sorted.len(),
        }
    }
}

/// Median and quartiles of times `[s]` that were measured elsewhere: [`Timing::of`].
pub fn summary(samples: &[f64]) -> Timing {
    Timing::of(samples)
}

/// Times `work` as often as `repeat` says; returns what the last run returned, and the timing.
///
/// # Errors
/// The first error of `work`.
pub fn time<T, E>(
    repeat: Repeat,
    mut work: impl FnMut() -> Result<T, E>,
) -> Result<(T, Timing), E> {
    for _ in 0..repeat.warm_up {
        work()?;
    }
    let mut samples = Vec::new();
    let mut total = Duration::ZERO;
    loop {
        let start = Instant::now();
        let value = work()?;
        let taken = start.elapsed();
        total += taken;
        samples.push(taken.as_secs_f64());
        if !repeat.goes_on(samples.len(), total.as_secs_f64()) {
            return Ok((value, Timing::of(&samples)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_those_of_the_definition() {
        let timing = Timing::of(&[4.0, 1.0, 3.0, 2.0, 100.0]);
        assert_eq!(
            timing,
            Timing {
                median: 3.0,
                lower: 2.0,
                upper: 4.0,
                runs: 5
            }
        );
        assert_eq!(summary(&[2.0, 1.0]).median, 1.5);
        assert!(Timing::of(&[]).median.is_nan());
    }

    #[test]
    fn runs_are_counted_and_errors_returned() {
        let mut calls = 0;
        let repeat = Repeat {
            warm_up: 2,
            least: 3,
            most: 3,
            seconds: 0.0,
        };
        let (value, timing) = time(repeat, || {
            calls += 1;
            Ok::<_, ()>(calls)
        })
        .unwrap();
        assert_eq!((value, timing.runs), (5, 3));
        assert!(timing.lower <= timing.median && timing.median <= timing.upper);
        assert_eq!(time(Repeat::ONCE, || Err::<(), _>("no")), Err("no"));
    }

    #[test]
    fn sleep_takes_no_processor_time() {
        let (start, Some(before)) = (Instant::now(), thread_seconds()) else {
            return;
        };
        std::thread::sleep(Duration::from_millis(30));
        let used = thread_seconds().unwrap() - before;
        assert!(used >= 0.0 && used < 0.5 * start.elapsed().as_secs_f64());
    }

    #[test]
    fn a_long_run_is_made_once() {
        assert!(Repeat::ONCE.goes_on(0, 0.0));
        assert!(!Repeat::ONCE.goes_on(1, 0.0));
        let repeat = Repeat::default();
        assert!(repeat.goes_on(4, 10.0));
        assert!(repeat.goes_on(5, 0.1));
        assert!(!repeat.goes_on(5, 0.6));
        assert!(!repeat.goes_on(50, 0.1));
    }
}
