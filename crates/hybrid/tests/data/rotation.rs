//! Finite rotations: what turned comes back as it was.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{Field, Measurement, Places};

use super::kirsch::displacement;

const CENTRE: Point = [0.5, -0.25];

/// Displacements around a hole at material points, without errors.
fn strained() -> Measurement {
    let mut data = Measurement {
        deviation: [1e-4; 2],
        ..Measurement::default()
    };
    for k in 0..41 * 37 {
        let place = [f64::from(k % 41) * 0.2 - 3.0, f64::from(k / 41) * 0.2 - 4.1];
        if let (Some(u), Some(v)) = (displacement(place, 0), displacement(place, 1)) {
            data.places.push(place);
            data.displacements[0].push(u);
            data.displacements[1].push(v);
        }
    }
    data.valid = [vec![true; data.places.len()], vec![true; data.places.len()]];
    data
}

/// What is measured of the same specimen when it has turned by `angle` about another point too.
fn turned(data: &Measurement, angle: f64, moved: Places) -> Measurement {
    let (sine, cosine) = angle.sin_cos();
    let (about, shift) = ([7.0, 2.0], [0.3, -0.2]);
    let mut all = data.clone();
    for (k, place) in data.places.iter().enumerate() {
        let strained = [0, 1].map(|c| place[c] + data.displacements[c][k]);
        let [x, y] = [0, 1].map(|c| strained[c] - about[c]);
        let now = [
            about[0] + shift[0] + cosine * x - sine * y,
            about[1] + shift[1] + sine * x + cosine * y,
        ];
        for c in 0..2 {
            all.displacements[c][k] = now[c] - place[c];
        }
        if moved == Places::Deformed {
            all.places[k] = now;
        }
    }
    all
}

/// Largest difference of displacements, less a translation.
fn apart(a: &Measurement, b: &Measurement) -> f64 {
    let mut most = 0.0_f64;
    for c in 0..2 {
        let offset = a.displacements[c][0] - b.displacements[c][0];
        for (x, y) in a.displacements[c].iter().zip(&b.displacements[c]) {
            most = most.max((x - y - offset).abs());
        }
    }
    most
}

#[test]
fn what_turned_comes_back_to_the_last_digits() {
    let data = strained();
    let own = data.rotation(Places::Reference).unwrap();
    let still = data.turned_back(own.angle, CENTRE, Places::Reference).0;
    for degrees in [0.0, 0.2, 0.5, 5.0, -5.0, 40.0] {
        let angle = f64::to_radians(degrees);
        let measured = turned(&data, angle, Places::Reference);
        let found = measured.rotation(Places::Reference).unwrap();
        assert!((found.angle - own.angle - angle).abs() < 1e-14, "{degrees}");
        let back = measured
            .turned_back(found.angle, CENTRE, Places::Reference)
            .0;
        assert!(
            apart(&still, &back) < 1e-13,
            "{degrees}: {}",
            apart(&still, &back)
        );
        assert_eq!(back.places, data.places);
        // 1/√Σx² of these places, and half of it by each component.
        assert!(
            (0.2e-6..2e-6).contains(&found.deviation),
            "{}",
            found.deviation
        );
    }
}

/// Seen after the deformation, a rotation about the centre itself gives the places back, but for the strains.
#[test]
fn places_after_the_deformation_turn_back_too() {
    let data = strained();
    for degrees in [0.2, 5.0] {
        let angle = f64::to_radians(degrees);
        let measured = turned(&data, angle, Places::Deformed);
        let found = measured.rotation(Places::Deformed).unwrap();
        // The mean rotation by the load is of the order of the strains, 1e-3 at most.
        assert!(
            (found.angle - angle).abs() < 1e-4,
            "{}",
            found.angle - angle
        );
        let back = measured
            .turned_back(found.angle, CENTRE, Places::Deformed)
            .0;
        let mut strain = 0.0_f64;
        for k in 1..data.places.len() {
            let from =
                |all: &Measurement, axis: usize| all.places[k][axis] - all.places[k - 1][axis];
            let length = from(&data, 0).hypot(from(&data, 1));
            for axis in 0..2 {
                strain = strain.max((from(&back, axis) - from(&data, axis)).abs() / length);
            }
        }
        assert!(strain < 5e-3, "{strain}");
        let still = turned(&data, 0.0, Places::Deformed);
        let own = still.rotation(Places::Deformed).unwrap();
        let still = still.turned_back(own.angle, CENTRE, Places::Deformed).0;
        assert!(apart(&still, &back) < 1e-12, "{}", apart(&still, &back));
    }
}

/// A rotation mixes both components: where one is missing, the other is of use only if the rotation is small.
#[test]
fn a_component_alone_is_masked_where_the_other_would_matter() {
    let data = strained();
    for (degrees, masked) in [(0.01, 0), (5.0, 100)] {
        let mut measured = turned(&data, f64::to_radians(degrees), Places::Reference);
        measured.mask(Field::V, |k| k < 100);
        let found = measured.rotation(Places::Reference).unwrap();
        let (back, lost) = measured.turned_back(found.angle, CENTRE, Places::Reference);
        assert_eq!(lost, masked);
        assert_eq!(back.count(Field::U), data.places.len() - masked);
        assert!(back.check().is_ok());
    }
    let mut alone = data.clone();
    alone.mask(Field::V, |_| true);
    assert!(alone.rotation(Places::Reference).is_none());
}
