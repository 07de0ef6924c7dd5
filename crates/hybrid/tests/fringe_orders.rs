//! Orders without jumps, constants, planes, and displacements at places.

mod kirsch;

use kirsch::{CARRIER, FREQUENCY, displacement, frame, truth};
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{
    Constant, Exposure, Frame, FringeError, KnownOrder, PixelMap, Plane, four_pictures, four_step,
    measurement, orders, orders_of, unwrap,
};

#[test]
fn thirty_fringes_around_a_hole_are_unwrapped_exactly() {
    let truth = truth(0);
    let field = PixelMap::of(frame(), |place| displacement(place, 0)).unwrap();
    assert_eq!(
        orders_of(&field, FREQUENCY, &CARRIER).unwrap().values()[5],
        truth.values()[5]
    );
    for carrier in [CARRIER, Plane::default()] {
        let truth = orders(frame(), FREQUENCY, &carrier, |place| displacement(place, 0)).unwrap();
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
        displacement(place, 1).filter(|_| place[0].abs() > 2.2)
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
        order: FREQUENCY * displacement(place, 1).unwrap() + CARRIER.at(place),
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

#[test]
fn known_orders_and_planes_without_sense() {
    let small = Frame::new(128, 96, [0.0, 0.0], [1.0, -1.0]).unwrap();
    let straight = PixelMap::of(small, |place| Some(0.13 * place[0] + 0.05 * place[1])).unwrap();
    let map = straight.restricted(|place| place[0] < 50.0).unwrap();
    let found = unwrap(&map, &vec![1.0; 128 * 96]).unwrap();
    let known = |x: f64, order: f64| KnownOrder {
        place: [x, -3.0],
        order,
    };
    assert!(matches!(
        found.fixed(&[known(80.0, 1.0)], Constant::Any),
        Err(FringeError::NoOrderAt { .. })
    ));
    assert!(matches!(
        found.fixed(&[known(-7.0, 1.0)], Constant::Any),
        Err(FringeError::NoOrderAt { .. })
    ));
    assert!(matches!(
        found.fixed(&[known(f64::NAN, 1.0)], Constant::Any),
        Err(FringeError::NoOrderAt { .. })
    ));
    assert!(matches!(
        found.fixed(&[], Constant::Any),
        Err(FringeError::Masked { .. })
    ));
    let contradicting = found
        .fixed(&[known(0.0, 0.0), known(10.0, 9.0)], Constant::Whole)
        .unwrap_err();
    assert!(
        matches!(contradicting, FringeError::KnownOrders { difference, .. } if (difference - 7.7).abs() < 1e-9),
        "{contradicting}"
    );
    // On rims and corners, where four pixels do not surround a place, the nearest counts.
    for x in [-0.4, 0.0, 20.3, 49.0, 49.4] {
        let fixed = found
            .fixed(&[known(x, 0.13 * x - 0.15)], Constant::Whole)
            .unwrap();
        assert!(
            fixed
                .present()
                .all(|(pixel, order)| (order - map.values()[pixel]).abs() < 1e-12)
        );
    }
    assert_eq!(
        Plane::fit(&map, |place| place[1] == -3.0).unwrap_err(),
        FringeError::NoPlane { pixels: 50 }
    );
    assert_eq!(
        Plane::fit(&map, |_| false).unwrap_err(),
        FringeError::NoPlane { pixels: 0 }
    );
}
