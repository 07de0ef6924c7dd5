//! The arguments at which a law is tested.

use std::f64::consts::TAU;
use std::fmt;

use crate::history::{History, PointStatus};
use crate::law::Place;

/// One set of arguments of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Pressure `[stress]`.
    pub pressure: f64,
    /// |Δs| of the step in progress `[length]`.
    pub slip_increment: f64,
    /// Where the point lies.
    pub place: Place,
    /// Its committed past.
    pub past: History,
}

impl fmt::Display for State {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [tangent_x, tangent_y] = self.place.tangent;
        write!(
            formatter,
            "pressure {}, slip increment {}, tangent ({tangent_x}, {tangent_y}), material angle {} rad, past: {} with slip path {}",
            self.pressure,
            self.slip_increment,
            self.place.material_angle,
            self.past.status(),
            self.past.slip_path(),
        )
    }
}

/// A grid of arguments, and the length of the random histories that are run beside it.
///
/// A law with scales of its own is tested best at a sample of those scales, from [`Sample::default_for`].
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Pressures `[stress]`, all > 0 and finite.
    pub pressures: Vec<f64>,
    /// |Δs| `[length]`, all ≥ 0 and finite.
    pub slip_increments: Vec<f64>,
    /// Places; the tangents are unit vectors.
    pub places: Vec<Place>,
    /// Committed pasts.
    pub histories: Vec<History>,
    /// Steps of each random history.
    pub steps: usize,
    /// Where the random numbers start; equal seeds give equal histories.
    pub seed: u64,
}

impl Sample {
    /// A sample around `pressure_scale` > 0 `[stress]` and `slip_scale` > 0 `[length]`: pressures from 1/1000 to 3 of the scale,
    /// slip increments of 0 and from 1/100 to 10 of the scale, points around a hole in a straight and in a turned body, and the
    /// ways a point can have come to its status.
    pub fn default_for(pressure_scale: f64, slip_scale: f64) -> Self {
        Self {
            pressures: [0.001, 0.03, 0.3, 1.0, 3.0]
                .map(|p| p * pressure_scale)
                .to_vec(),
            slip_increments: [0.0, 0.01, 0.3, 1.0, 10.0].map(|s| s * slip_scale).to_vec(),
            places: places_around_a_hole(),
            histories: typical_histories(slip_scale),
            steps: 100,
            seed: 1988,
        }
    }

    /// What makes this sample useless, if anything.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        let finite_above =
            |numbers: &[f64], least: f64| numbers.iter().all(|x| x.is_finite() && *x >= least);
        if self.places.is_empty() || self.histories.is_empty() {
            Some("it holds no place or no history")
        } else if self.pressures.is_empty() || !finite_above(&self.pressures, f64::MIN_POSITIVE) {
            Some("it needs pressures, all finite and positive")
        } else if !finite_above(&self.slip_increments, 0.0)
            || !self.slip_increments.iter().any(|s| *s > 0.0)
        {
            Some("it needs slip increments, all finite, none negative and one positive")
        } else {
            None
        }
    }

    /// All combinations of arguments, in a fixed order.
    pub(crate) fn states(&self) -> impl Iterator<Item = State> + '_ {
        self.pasts().flat_map(move |(place, past)| {
            self.pressures.iter().flat_map(move |&pressure| {
                self.slip_increments
                    .iter()
                    .map(move |&slip_increment| State {
                        pressure,
                        slip_increment,
                        place,
                        past,
                    })
            })
        })
    }

    /// All combinations of a place and a past.
    pub(crate) fn pasts(&self) -> impl Iterator<Item = (Place, History)> + '_ {
        self.places
            .iter()
            .flat_map(move |&place| self.histories.iter().map(move |&past| (place, past)))
    }
}

/// Every 15° of the edge, the body straight; and every 30°, the body turned by 0.3 rad.
fn places_around_a_hole() -> Vec<Place> {
    let place = |part: f64, material_angle: f64| {
        let (sine, cosine) = (TAU * part).sin_cos();
        Place {
            position: [cosine, sine],
            tangent: [-sine, cosine],
            material_angle,
        }
    };
    let straight = (0..24).map(|i| place(f64::from(i) / 24.0, 0.0));
    let turned = (0..12).map(|i| place(f64::from(i) / 12.0, 0.3));
    straight.chain(turned).collect()
}

fn typical_histories(slip_scale: f64) -> Vec<History> {
    let fresh = History::default();
    let stuck = fresh.commit(PointStatus::Stick, 0.0);
    let forward = stuck.commit(PointStatus::Slip, 0.2 * slip_scale);
    let backward = forward.commit(PointStatus::Slip, -slip_scale);
    let far = backward.commit(PointStatus::Slip, 20.0 * slip_scale);
    vec![
        fresh,
        stuck,
        forward,
        backward,
        backward.commit(PointStatus::Stick, 0.0),
        backward.commit(PointStatus::Open, 0.0),
        far,
    ]
}

/// SplitMix64 (Steele, Lea & Flood 2014): enough for test histories, and the same everywhere.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^= mixed >> 31;
        // The upper 53 bits fill a double exactly.
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }
}
