//! Gratings: the report's numbers, and strains.

use stickslip_hybrid::data::{FringeLine, Track};
use stickslip_hybrid::moire::{Grating, MoireError};

use super::hole;

#[test]
fn the_reports_grating() {
    // Post & Reddy (1988), part I, 2.2 and 4.2: 2400 lines/mm, 514.5 nm, a quarter fringe is about 1e-4 mm. In mm:
    let grating = Grating::new(2400.0).unwrap();
    let angle = grating.angle(514.5e-6).unwrap();
    // sin α = ½ · 2400 · 514.5e-6 = 0.6174.
    assert!((angle.sin() - 0.6174).abs() < 1e-12 && (angle.to_degrees() - 38.126).abs() < 1e-3);
    assert!((Grating::from_beams(514.5e-6, angle).unwrap().frequency() - 2400.0).abs() < 1e-9);
    // 1/9600 mm.
    assert!((grating.displacement(0.25) - 1.0416666666666667e-4).abs() < 1e-18);
    assert!((grating.order(1e-4) - 0.24).abs() < 1e-12);
    // 2400 lines/mm are the report's 60 960 lines/in.
    assert_eq!(grating.frequency() * 25.4, 60_960.0);
    // The specimen grating: 1200 lines/mm of light of 413 nm.
    let specimen = Grating::new(1200.0).unwrap().angle(413e-6).unwrap();
    assert!((specimen.to_degrees() - 14.348).abs() < 1e-3);
    assert!(matches!(
        grating.angle(1e-3),
        Err(MoireError::TooFine { .. })
    ));
    for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Grating::new(frequency).is_err());
    }
    assert!(Grating::from_beams(f64::NAN, 0.5).is_err() && Grating::from_beams(1.0, 0.0).is_err());
}

#[test]
fn strains_are_derivatives_of_orders() {
    let grating = Grating::new(100.0).unwrap();
    let gradients = [[1.0, 2.0], [3.0, 4.0]];
    assert_eq!(grating.strains(gradients), [0.01, 0.04, 0.05]);
    // N = s³ along a straight line and along a circle: slopes of steps are second-order accurate at their middles.
    for track in [Track::Straight, hole(false)] {
        let error = |count: i32| {
            let centres: Vec<_> = (0..=count)
                .map(|k| {
                    let s = f64::from(k) / f64::from(count);
                    let place = if track == Track::Straight {
                        [s, 0.0]
                    } else {
                        [s.cos(), s.sin()]
                    };
                    (place, s.powi(3))
                })
                .collect();
            let line = FringeLine::new("t", "a", track, &centres, 1e-9).unwrap();
            line.slopes(&grating).iter().fold(0.0, |worst: f64, slope| {
                let [x, y] = slope.place;
                let s = if track == Track::Straight {
                    x
                } else {
                    y.atan2(x)
                };
                worst.max((slope.value - 0.01 * 3.0 * s * s).abs())
            })
        };
        // (s+d)³−(s−d)³ = 2d(3s² + d²): the error is d²/f exactly, d half a step.
        for count in [10, 20] {
            let exact = 0.01 * (0.5 / f64::from(count)).powi(2);
            assert!((error(count) - exact).abs() < 1e-12);
        }
    }
}
