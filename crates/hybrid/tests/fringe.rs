//! Phases of fringe pictures of a plate with a hole, and the whole way from displacements to pictures and back.

mod kirsch;

use kirsch::{CARRIER, FREQUENCY, PIXEL, RADIUS, displacement, frame, truth};
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{
    Carrier, Constant, Depth, Exposure, Format, FourierOptions, FourierPhase, KnownOrder, Phase,
    PixelMap, Plane, decode, encode, four_pictures, four_step, fourier, measurement, orders,
    picture,
};

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

/// A beam that is brightest off the centre and down to a fifth in the corners; background and amplitude follow it.
#[test]
fn uneven_light_does_not_matter() {
    let truth = truth(1);
    let beam = |place: Point| {
        0.2 + 0.8 * (-((place[0] - 2.0).powi(2) + (place[1] + 1.0).powi(2)) / 30.0).exp()
    };
    let even = picture(&truth, &Exposure::default(), 1).unwrap();
    let lit = PixelMap::with_gaps(
        frame(),
        even.values()
            .iter()
            .enumerate()
            .map(|(k, value)| value * beam(frame().place(k)))
            .collect(),
    );
    let found = fourier(&lit.unwrap(), &options()).unwrap();
    println!(
        "uneven light: {:.5} fringes",
        error(&found.phase, &truth, |_| true)
    );
    assert!(error(&found.phase, &truth, |_| true) < 0.01);
    let wrong = found.phase.wrapped().present().filter(|&(k, _)| {
        (found.phase.modulation()[k] / (0.4 * beam(frame().place(k))) - 1.0).abs() > 0.1
    });
    // Amplitudes are worse than phases where the picture ends, and good to a tenth nearly everywhere.
    assert!(wrong.count() * 100 < truth.present().count());
    let bright = found.phase.above(0.2).unwrap();
    assert!(bright.wrapped().present().count() < truth.present().count());
    assert!(found.phase.above(1.0).is_err());
}

/// Carriers of either sign and a hole in the mask where the plate has none.
#[test]
fn a_given_carrier_sets_the_sign() {
    let falling = Plane {
        gradient: [-6.0, -3.4],
        constant: 0.1,
    };
    let truth = orders(frame(), FREQUENCY, &falling, |place| displacement(place, 1)).unwrap();
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

/// The first-order law of the standard deviation, with the noise as estimated from the picture. 512² pixels and a band of 2 % of the
/// frequencies leave some 5000 independent values, so the measured standard deviation scatters by 1 %; the law's next term is (σ/b)²/8.
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
            order: FREQUENCY * displacement([4.0, 3.0], component).unwrap(),
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
        let difference = |k: usize| {
            measured.displacements[axis][k] - displacement(measured.places[k], axis).unwrap()
        };
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
