//! Zones along open and closed contacts, and those of a mirrored half.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};
use stickslip_contact::Status::{Open, SlipNegative, SlipPositive, Stick};
use stickslip_contact::zones::{Zone, ends_of_contact, half_extent, mirrored, zones};
use stickslip_contact::{ContactState, Status};

use crate::{Ground, coulomb};
use stickslip_fem_core::GivenBody;

/// Zones of points at `parameter` with these statuses, all touching ones under the same pressure; the first and last cannot slide
/// unless `slides` says so.
fn zones_of(status: &[Status], slides: bool, parameter: &[f64], closed: Option<f64>) -> Vec<Zone> {
    let count = status.len();
    let mut compliance = DMatrix::identity(2 * count, 2 * count);
    if !slides {
        compliance[(1, 1)] = 0.0;
        compliance[(2 * count - 1, 2 * count - 1)] = 0.0;
    }
    let body = GivenBody::held(compliance, vec![DVector::zeros(2 * count)]).unwrap();
    let problem = Ground::along_x(vec![0.0; count], coulomb(0.3)).under(&body);
    let mut state = ContactState::unloaded(&problem);
    for (k, &status) in status.iter().enumerate() {
        state.status[k] = status;
        state.forces[2 * k] = if status.touches() { 1.0 } else { 0.0 };
    }
    zones(problem.contacts(), &state, 0, parameter, closed)
}

fn zone(status: Status, start: f64, end: f64) -> Zone {
    Zone { status, start, end }
}

fn close(found: &[Zone], expected: &[Zone]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.status, expected.status);
        let apart = (found.start - expected.start).abs() + (found.end - expected.end).abs();
        assert!(apart < 1e-12, "{found:?} {expected:?}");
    }
}

/// Eight points around a circle from −π.
fn circle() -> Vec<f64> {
    (0..8).map(|k| -PI + f64::from(k) * TAU / 8.0).collect()
}

#[test]
fn contact_all_around_is_one_zone_of_the_whole_circle() {
    let all = zones_of(&[Stick; 8], true, &circle(), Some(TAU));
    close(&all, &[zone(Stick, -PI, PI)]);
    assert_eq!(half_extent(&all, Some(TAU)), Some(PI));
    assert!(ends_of_contact(&all, Some(TAU)).is_empty());
}

#[test]
fn contact_across_the_start_of_the_walk_is_one_zone() {
    let mut status = [Open; 8];
    for k in [7, 0, 1] {
        status[k] = Stick;
    }
    let found = zones_of(&status, true, &circle(), Some(TAU));
    let end = 0.75 * PI;
    close(
        &found,
        &[zone(Open, -end, end), zone(Stick, end, TAU - end)],
    );
    assert!((half_extent(&found, Some(TAU)).unwrap() - 0.25 * PI).abs() < 1e-12);
    let ends = ends_of_contact(&found, Some(TAU));
    assert!(ends.len() == 2 && ends.iter().all(|at| (at.abs() - end).abs() < 1e-12));
    // The mirrored half says the same; its last point lies on the line of symmetry.
    let half = [zone(Open, 0.0, end), zone(Stick, end, PI)];
    close(&mirrored(&half, Some(TAU)), &found);
}

#[test]
fn slip_turns_at_a_point_of_symmetry() {
    let mut status = [Open; 8];
    (status[3], status[4], status[5]) = (SlipNegative, Stick, SlipPositive);
    let found = zones_of(&status, true, &circle(), Some(TAU));
    let (start, end) = (-0.25 * PI, 0.25 * PI);
    let whole = [
        zone(SlipNegative, start, 0.0),
        zone(SlipPositive, 0.0, end),
        zone(Open, end, TAU + start),
    ];
    close(&found, &whole);
    let half = zones_of(
        &[Stick, SlipPositive, Open, Open, Open],
        false,
        &circle()[4..8]
            .iter()
            .copied()
            .chain([PI])
            .collect::<Vec<_>>(),
        None,
    );
    close(&mirrored(&half, Some(TAU)), &whole);
    // The same at the far side, where the walk starts.
    let mut far = [Open; 8];
    (far[7], far[0], far[1]) = (SlipNegative, Stick, SlipPositive);
    let found = zones_of(&far, true, &circle(), Some(TAU));
    let end = 0.75 * PI;
    let expected = [
        zone(SlipPositive, -PI, -end),
        zone(Open, -end, end),
        zone(SlipNegative, end, PI),
    ];
    close(&found, &expected);
}

#[test]
fn one_sticking_point_between_slips_of_one_sign_is_a_zone() {
    let status = [SlipPositive, Stick, SlipPositive];
    let found = zones_of(&status, true, &[0.0, 1.0, 2.0], None);
    let expected = [
        zone(SlipPositive, 0.0, 0.5),
        zone(Stick, 0.5, 1.5),
        zone(SlipPositive, 1.5, 2.0),
    ];
    close(&found, &expected);
}

#[test]
fn a_line_is_mirrored_at_its_middle() {
    let half = [
        zone(Stick, 0.0, 1.0),
        zone(SlipPositive, 1.0, 2.0),
        zone(Open, 2.0, 5.0),
    ];
    let whole = mirrored(&half, None);
    let expected = [
        zone(Open, -5.0, -2.0),
        zone(SlipNegative, -2.0, -1.0),
        zone(Stick, -1.0, 1.0),
        zone(SlipPositive, 1.0, 2.0),
        zone(Open, 2.0, 5.0),
    ];
    close(&whole, &expected);
    assert_eq!(half_extent(&whole, None), Some(2.0));
    assert_eq!(ends_of_contact(&whole, None), [-2.0, 2.0]);
    assert_eq!(half_extent(&[zone(Open, 0.0, 1.0)], None), None);
}
