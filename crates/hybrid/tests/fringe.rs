//! Fringe pictures of a plate with a hole: there and back.
//!
//! Aluminium under 60 MPa along x, hole of radius 2, window 12 × 12 (lengths in mm), grating of 2400 lines per mm, 512 × 512 pixels,
//! carrier of 0.16 fringes per pixel. Displacements of Kirsch's solution.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{
    Carrier, Constant, Depth, Exposure, Format, FourierOptions, FourierPhase, Frame, KnownOrder,
    Phase, PixelMap, Plane, decode, encode, four_pictures, four_step, fourier, measurement, orders,
    orders_of, picture, unwrap,
};

const FREQUENCY: f64 = 2400.0;
const RADIUS: f64 = 2.0;
const PIXEL: f64 = 12.0 / 512.0;
const CARRIER: Plane = Plane {
    gradient: [6.0, 3.4],
    constant: 0.3,
};

/// Displacement `[mm]` of an infinite plate in plane stress with a hole, stretched along x (Kirsch 1898).
fn kirsch(place: Point, component: usize) -> Option<f64> {
    let (stress, modulus, ratio) = (60.0, 71_700.0, 0.33);
    let (r, theta) = (place[0].hypot(place[1]), place[1].atan2(place[0]));
    let kappa = (3.0 - ratio) / (1.0 + ratio);
    let shear_modulus = modulus / (2.0 * (1.0 + ratio));
    let (q, cube) = (RADIUS / r, (RADIUS / r).powi(3));
    let shape = if component == 0 {
        (kappa + 1.0) * theta.cos() / q
            + 2.0 * q * ((1.0 + kappa) * theta.cos() + (3.0 * theta).cos())
            - 2.0 * cube * (3.0 * theta).cos()
    } else {
        (kappa - 3.0) * theta.sin() / q
            + 2.0 * q * ((1.0 - kappa) * theta.sin() + (3.0 * theta).sin())
            - 2.0 * cube * (3.0 * theta).sin()
    };
    (r > RADIUS).then_some(stress * RADIUS / (8.0 * shear_modulus) * shape)
}

fn frame() -> Frame {
    Frame::over([[-6.0, -6.0], [6.0, 6.0]], PIXEL).unwrap()
}

fn truth(component: usize) -> PixelMap {
    orders(frame(), FREQUENCY, &CARRIER, |place| {
        kirsch(place, component)
    })
    .unwrap()
}

fn options() -> FourierOptions {
    FourierOptions::new(Carrier::Found {
        towards: [1.0, 0.0],
    })
}

fn away(place: Point, distance: f64) -> bool {
    place[0].hypot(place[1]) > RADIUS + distance
        && place.iter().all(|value| value.abs() < 6.0 - distance)
}

/// Root mean square of the order's error, whole numbers aside, where `keep` holds.
fn error(phase: &Phase, truth: &PixelMap, keep: impl Fn(Point) -> bool) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (pixel, order) in phase
        .wrapped()
        .present()
        .filter(|&(pixel, _)| keep(truth.frame().place(pixel)))
    {
        let difference: f64 = order - truth.values()[pixel];
        sum += (difference - difference.round()).powi(2);
        count += 1.0;
    }
    f64::sqrt(sum / count)
}

fn recovered(orders: &PixelMap, exposure: &Exposure, seed: u64) -> FourierPhase {
    fourier(&picture(orders, exposure, seed).unwrap(), &options()).unwrap()
}

/// The bound is the one that fringe pictures are expected to meet away from edges; here it is met up to the edges.
#[test]
fn fourier_phase_of_clean_pictures_is_good_to_a_hundredth_of_a_fringe() {
    for (component, depth) in [
        (0, None),
        (1, None),
        (0, Some(Depth::Eight)),
        (1, Some(Depth::Eight)),
    ] {
        let truth = truth(component);
        let found = recovered(
            &truth,
            &Exposure {
                depth,
                ..Exposure::default()
            },
            1,
        );
        let whole = error(&found.phase, &truth, |_| true);
        let inside = error(&found.phase, &truth, |place| away(place, 12.0 * PIXEL));
        println!(
            "component {component}, {depth:?}: {whole:.5} fringes, {inside:.5} away from edges; share {:.3}",
            found.share
        );
        assert!(whole < 0.01 && inside < 0.002, "{whole} {inside}");
    }
}

/// Carriers of either sign and a hole in the mask that is none in the plate.
#[test]
fn a_given_carrier_sets_the_sign() {
    let falling = Plane {
        gradient: [-6.0, -3.4],
        constant: 0.1,
    };
    let truth = orders(frame(), FREQUENCY, &falling, |place| kirsch(place, 1)).unwrap();
    let truth = truth
        .restricted(|place| (place[0] - 4.0).hypot(place[1] + 3.0) > 0.6)
        .unwrap();
    let given = FourierOptions::new(Carrier::Given(falling.gradient));
    let found = fourier(&picture(&truth, &Exposure::default(), 1).unwrap(), &given).unwrap();
    assert!(error(&found.phase, &truth, |_| true) < 0.01);
    let mirrored = truth.present().map(|(pixel, order)| (pixel, -order));
    let values = mirrored.fold(
        vec![f64::NAN; truth.frame().pixels()],
        |mut values, (pixel, order)| {
            values[pixel] = order;
            values
        },
    );
    let mirrored = PixelMap::with_gaps(*truth.frame(), values).unwrap();
    let other = recovered(&truth, &Exposure::default(), 1);
    assert!(error(&other.phase, &mirrored, |_| true) < 0.01);
}

/// The first-order law of the deviation, with the noise as estimated from the picture. 512² pixels and a band of 2 % of the
/// frequencies leave some 5000 independent values, so the measured deviation scatters by 1 %; the law's next term is (σ/b)²/8.
#[test]
fn noise_of_orders_is_as_predicted() {
    for noise in [0.02, 0.05, 0.1, 0.2] {
        let truth = truth(1);
        let exposure = Exposure {
            noise,
            ..Exposure::default()
        };
        let found = recovered(&truth, &exposure, 3);
        let measured = error(&found.phase, &truth, |place| away(place, 0.3));
        let steps = four_step(&four_pictures(&truth, &exposure, 4).unwrap(), 0.0).unwrap();
        let (law, stepped) = (
            steps.deviation(noise, exposure.modulation),
            error(&steps, &truth, |_| true),
        );
        println!(
            "noise {noise}: estimated {:.4}, Fourier {measured:.5} / {:.5}, four-step {stepped:.5} / {law:.5}",
            found.noise,
            found.deviation()
        );
        assert!((found.noise / noise - 1.0).abs() < 0.02);
        assert!((measured / found.deviation() - 1.0).abs() < 0.05);
        // Of the four pictures' phases, the next term of the law is that of a ratio of normal variables, σ²/b² in relation.
        assert!((stepped / law - 1.0).abs() < 0.01 + (noise / exposure.modulation).powi(2));
    }
}

/// Errors of the orders and speckle are no additive white noise: the law is a good guide still.
#[test]
fn order_errors_and_speckle() {
    let cases = [
        (0.1, None),
        (0.25, None),
        (0.0, Some(16)),
        (0.0, Some(4)),
        (0.0, Some(1)),
    ];
    for (order_error, speckle_patterns) in cases {
        let truth = truth(1);
        let found = recovered(
            &truth,
            &Exposure {
                order_error,
                speckle_patterns,
                ..Exposure::default()
            },
            3,
        );
        let measured = error(&found.phase, &truth, |place| away(place, 0.3));
        let ratio = measured / found.deviation();
        println!(
            "order error {order_error}, speckle {speckle_patterns:?}: {measured:.4} fringes, {ratio:.2} of the law"
        );
        // Errors of the orders have no part along the fringes' amplitude, so that √1.5 times the law's is across.
        assert!((0.85..1.3).contains(&ratio), "{ratio}");
        let contrast = speckle_patterns.map_or(0.0, |patterns| f64::from(patterns).powf(-0.5));
        let expected = contrast * (0.5_f64.powi(2) + 0.5 * 0.4_f64.powi(2)).sqrt();
        assert!(
            contrast == 0.0 || (found.noise / expected - 1.0).abs() < 0.05,
            "{} {expected}",
            found.noise
        );
    }
}

/// Rounding of 2πN with N up to 70, in fringes: 70 ε; tenfold of it.
#[test]
fn four_steps_are_exact() {
    for component in 0..2 {
        let truth = truth(component);
        let pictures = four_pictures(&truth, &Exposure::default(), 1).unwrap();
        let phase = four_step(&pictures, 0.01).unwrap();
        let worst = |keep: &dyn Fn(Point) -> bool| error(&phase, &truth, keep);
        let bound = 700.0 * f64::EPSILON;
        assert!(worst(&|_| true) < bound);
        assert!(
            phase
                .modulation()
                .iter()
                .zip(truth.valid())
                .all(|(b, &valid)| if valid {
                    (b - 0.4).abs() < bound
                } else {
                    *b == 0.0
                })
        );
    }
}

#[test]
fn thirty_fringes_around_a_hole_are_unwrapped_exactly() {
    let truth = truth(0);
    let displacement = PixelMap::of(frame(), |place| kirsch(place, 0)).unwrap();
    assert_eq!(
        orders_of(&displacement, FREQUENCY, &CARRIER)
            .unwrap()
            .values()[5],
        truth.values()[5]
    );
    for carrier in [CARRIER, Plane::default()] {
        let truth = orders(frame(), FREQUENCY, &carrier, |place| kirsch(place, 0)).unwrap();
        let (low, high) = truth
            .present()
            .fold((f64::MAX, f64::MIN), |(low, high), (_, order)| {
                (low.min(order), high.max(order))
            });
        assert!(high - low > 30.0);
        let phase = four_step(
            &four_pictures(&truth, &Exposure::default(), 1).unwrap(),
            0.0,
        )
        .unwrap();
        let found = phase.unwrapped().unwrap();
        assert!(found.regions.len() == 1 && found.residues.is_empty() && found.cuts.is_empty());
        assert_eq!(found.regions[0].pixels, truth.present().count());
        let known = KnownOrder {
            place: frame().place(7),
            order: truth.values()[7],
        };
        let fixed = found.fixed(&[known], Constant::Whole).unwrap();
        let worst = fixed
            .present()
            .map(|(pixel, order)| (order - truth.values()[pixel]).abs())
            .fold(0.0, f64::max);
        assert!(worst < 1e-13, "{worst}");
    }
}

/// A phase that winds once around a point has one residue; around a hole it has none, but no unwrapping without cuts.
#[test]
fn inconsistent_loops_are_found() {
    let frame = Frame::new(40, 30, [-19.75, -14.75], [1.0, 1.0]).unwrap();
    let winding = |place: Point| (place[1].atan2(place[0])) / std::f64::consts::TAU;
    let open = PixelMap::of(frame, |place| Some(winding(place))).unwrap();
    let found = unwrap(&open, &vec![1.0; 1200]).unwrap();
    assert_eq!(found.residues.len(), 1);
    // The corners of the loop around the origin; the phase rises counter-clockwise, from x to y.
    assert_eq!(
        (
            frame.place(found.residues[0].pixel),
            found.residues[0].charge
        ),
        ([-0.75, -0.75], 1)
    );
    assert!(!found.cuts.is_empty());
    let ring = open
        .restricted(|place| place[0].hypot(place[1]) > 5.0)
        .unwrap();
    let found = unwrap(&ring, &vec![1.0; 1200]).unwrap();
    assert!(found.residues.is_empty() && found.regions.len() == 1);
    // A cut from the hole to the rim crosses at least the pixels between them.
    assert!(found.cuts.len() >= 9, "{}", found.cuts.len());
}

/// The flood leaves a noisy patch to the end, so that its errors stay inside.
#[test]
fn quality_guides_the_flood() {
    let frame = Frame::new(60, 60, [0.0, 0.0], [1.0, -1.0]).unwrap();
    let bad = |place: Point| (20.0..35.0).contains(&place[0]) && (-35.0..-20.0).contains(&place[1]);
    let slope = |place: Point| 0.11 * place[0] - 0.07 * place[1];
    let scramble = |place: Point| (place[0] * 12.9898 + place[1] * 78.233).sin() * 43758.5453;
    let wrapped = |place: Point| {
        let order: f64 = if bad(place) {
            scramble(place)
        } else {
            slope(place)
        };
        order - order.round()
    };
    let map = PixelMap::of(frame, |place| Some(wrapped(place))).unwrap();
    let quality: Vec<_> = (0..3600)
        .map(|pixel| if bad(frame.place(pixel)) { 0.1 } else { 1.0 })
        .collect();
    let found = unwrap(&map, &quality).unwrap();
    assert!(!found.residues.is_empty());
    let good = found
        .orders
        .present()
        .map(|(pixel, order)| (frame.place(pixel), order))
        .filter(|(place, _)| !bad(*place));
    let steps: Vec<_> = good.map(|(place, order)| order - slope(place)).collect();
    assert!(steps.iter().all(|step| (step - steps[0]).abs() < 1e-12));
}

#[test]
fn regions_have_constants_of_their_own() {
    let truth = orders(frame(), FREQUENCY, &CARRIER, |place| {
        kirsch(place, 1).filter(|_| place[0].abs() > 2.2)
    })
    .unwrap();
    let phase = four_step(
        &four_pictures(&truth, &Exposure::default(), 1).unwrap(),
        0.0,
    )
    .unwrap();
    let found = phase.unwrapped().unwrap();
    assert_eq!(found.regions.len(), 2);
    let at = |place: Point| KnownOrder {
        place,
        order: FREQUENCY * kirsch(place, 1).unwrap() + CARRIER.at(place),
    };
    let both = [at([-4.003, 1.0]), at([4.007, 0.5]), at([5.0, -2.0])];
    // Bilinear interpolation between pixels: second derivatives of some 3 fringes per mm² on 0.023 mm leave 1e-3 fringe.
    let fixed = found.fixed(&both, Constant::Any).unwrap();
    assert!(
        fixed
            .present()
            .all(|(pixel, order)| (order - truth.values()[pixel]).abs() < 1e-3)
    );
    let fixed = found.fixed(&both, Constant::Whole).unwrap();
    assert!(
        fixed
            .present()
            .all(|(pixel, order)| (order - truth.values()[pixel]).abs() < 1e-12)
    );
    let left = found.fixed(&both[..1], Constant::Whole).unwrap();
    assert!(
        left.present()
            .all(|(pixel, _)| frame().place(pixel)[0] < 0.0)
    );
}

#[test]
fn planes_are_fitted_and_removed() {
    let plane = Plane {
        gradient: [1.25, -0.5],
        constant: 7.0,
    };
    let far = Point::from([1.0e3, -2.0e3]);
    let frame = Frame::new(50, 40, far, [0.1, 0.1]).unwrap();
    let orders = PixelMap::of(frame, |place| {
        Some(plane.at(place) + if place[0] > 1.003e3 { 5.0 } else { 0.0 })
    })
    .unwrap();
    let fit = Plane::fit(&orders, |place| place[0] < 1.0029e3).unwrap();
    assert_eq!(fit.pixels, 29 * 40);
    // Coordinates of 2e3 with rounding 2e-13 over a region of 3: gradients to 1e-12, the constant 2e3 times that.
    assert!(
        (fit.plane.gradient[0] - 1.25).abs() < 1e-12
            && (fit.plane.gradient[1] + 0.5).abs() < 1e-12
            && fit.remainder < 1e-11
    );
    let flat = fit.plane.removed_from(&orders).unwrap();
    assert!(flat.present().all(|(pixel, order)| {
        (order
            - if frame.place(pixel)[0] > 1.003e3 {
                5.0
            } else {
                0.0
            })
        .abs()
            < 1e-9
    }));
}

/// From displacements over 8-bit files with noise back to displacements: error as predicted, a tenth of the grating's pitch.
#[test]
fn the_whole_way_there_and_back() {
    let exposure = Exposure {
        noise: 0.05,
        depth: Some(Depth::Eight),
        ..Exposure::default()
    };
    let returned = [0, 1].map(|component| {
        let bytes = encode(
            &picture(&truth(component), &exposure, 11 + component as u64).unwrap(),
            Format::Png,
            Depth::Eight,
        )
        .unwrap();
        let read = decode(&bytes)
            .unwrap()
            .placed(frame().place(0), frame().step(), None)
            .unwrap();
        let read = read
            .restricted(|place| place[0].hypot(place[1]) > RADIUS)
            .unwrap();
        let found = fourier(&read, &options()).unwrap();
        let flat = found
            .phase
            .demodulated(&CARRIER)
            .unwrap()
            .unwrapped()
            .unwrap();
        assert!(flat.cuts.is_empty());
        let known = KnownOrder {
            place: [4.0, 3.0],
            order: FREQUENCY * kirsch([4.0, 3.0], component).unwrap(),
        };
        (flat.fixed(&[known], Constant::Whole).unwrap(), found)
    });
    let [(u, first), (v, second)] = &returned;
    let stride = (first.resolution.max(second.resolution) / PIXEL).ceil() as usize;
    let measured = measurement(
        [Some(u), Some(v)],
        FREQUENCY,
        [first.deviation(), second.deviation()],
        stride,
    )
    .unwrap();
    assert!(
        measured.places.len() > 2000
            && measured
                .places
                .iter()
                .all(|place| place[0].hypot(place[1]) > RADIUS)
    );
    for axis in 0..2 {
        let inner = || (0..measured.places.len()).filter(|&k| away(measured.places[k], 0.3));
        let difference =
            |k: usize| measured.displacements[axis][k] - kirsch(measured.places[k], axis).unwrap();
        let deviation =
            (inner().map(|k| difference(k).powi(2)).sum::<f64>() / inner().count() as f64).sqrt();
        println!(
            "component {axis}: {deviation:.2e}, predicted {:.2e}",
            measured.deviation[axis]
        );
        assert!(measured.valid[axis].iter().all(|&valid| valid));
        // Some 2500 values scatter by 1.4 %; the truncated band adds 0.001 fringe to 0.005.
        assert!(
            (deviation / measured.deviation[axis] - 1.0).abs() < 0.1,
            "{deviation} {}",
            measured.deviation[axis]
        );
    }
}

#[test]
fn one_component_and_a_stride() {
    let u = PixelMap::with_gaps(
        Frame::new(3, 3, [0.0, 0.0], [1.0, -1.0]).unwrap(),
        vec![1., 2., 3., 4., 5., 6., 7., 8., f64::NAN],
    )
    .unwrap();
    let taken = measurement([None, Some(&u)], 2.0, [0.0, 0.5], 2).unwrap();
    assert_eq!(taken.places, [[0.0, 0.0], [2.0, 0.0], [0.0, -2.0]]);
    assert_eq!(
        (taken.displacements[1].as_slice(), taken.deviation),
        ([0.5, 1.5, 3.5].as_slice(), [0.0, 0.25])
    );
    assert_eq!(
        (taken.valid[0].as_slice(), taken.valid[1].as_slice()),
        ([false; 3].as_slice(), [true; 3].as_slice())
    );
    assert!(taken.displacements[0].iter().all(|value| value.is_nan()));
}

/// Same seed, same bits, whatever the number of threads; another seed, another picture.
#[test]
fn reproducible() {
    let exposure = Exposure {
        noise: 0.1,
        order_error: 0.1,
        speckle_patterns: Some(2),
        ..Exposure::default()
    };
    let bits = |map: &PixelMap| {
        map.values()
            .iter()
            .map(|value| value.to_bits())
            .collect::<Vec<_>>()
    };
    let run = |threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| bits(recovered(&truth(0), &exposure, seed).phase.wrapped()))
    };
    assert!(run(1, 5) == run(3, 5) && run(1, 5) != run(1, 6));
}
