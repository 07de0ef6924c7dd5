//! Modes of failure: of made-up damage, and of small plates with the geometry for each.

use stickslip_contact::Chain;
use stickslip_joint::{DamageSite, Hole, JointMode, ModeRule, Options, Reserve, call_mode};

use crate::models::discount;
use crate::plate::{End, Plate};

const HOLE: Hole = Hole {
    centre: [1.0, 2.0],
    radius: 3.0,
    bearing: [0.0, -1.0],
    side_distance: 9.0,
    end_distance: 12.0,
};

/// Damage at `angle` `[degree]` from the bearing point, `radii` from the centre.
fn site(angle: f64, radii: f64, fibre: bool, late: bool) -> DamageSite {
    let (s, c) = angle.to_radians().sin_cos();
    let r = radii * HOLE.radius;
    // The bearing point lies at −y; angles count to either side.
    let position = [HOLE.centre[0] + r * s, HOLE.centre[1] - r * c];
    DamageSite {
        position,
        volume: 1.0,
        fibre,
        late,
        collapse: false,
    }
}

fn called(sites: &[DamageSite]) -> JointMode {
    call_mode(&HOLE, sites, None).unwrap().mode
}

#[test]
fn the_angle_near_the_hole_makes_the_mode() {
    let fan = |from: i32, to: i32| -> Vec<DamageSite> {
        let angles = (from..=to).step_by(5);
        let one = |angle: i32| site(f64::from(angle), 1.1, true, true);
        angles.map(one).collect()
    };
    assert_eq!(called(&fan(-35, 35)), JointMode::Bearing);
    assert_eq!(called(&fan(45, 75)), JointMode::ShearOut);
    assert_eq!(called(&fan(-75, -45)), JointMode::ShearOut);
    assert_eq!(called(&fan(85, 105)), JointMode::NetTension);
    assert_eq!(called(&fan(0, 100)), JointMode::Mixed);
    let shares = call_mode(&HOLE, &fan(40, 40), None).unwrap().shares;
    assert!((shares[0] - 0.5).abs() < 1e-12 && (shares[1] - 0.5).abs() < 1e-12);
}

#[test]
fn a_severed_path_decides() {
    // Most damage ahead of the pin, but a crack through the whole ligament.
    let mut sites: Vec<DamageSite> = (-3..=3)
        .map(|k| site(10.0 * f64::from(k), 1.1, true, true))
        .collect();
    sites.extend((0..=10).map(|k| site(90.0, 1.0 + 0.2 * f64::from(k), true, true)));
    let call = call_mode(&HOLE, &sites[..], Some(0.3)).unwrap();
    assert_eq!(call.mode, JointMode::NetTension);
    assert!((call.reach[2] - 1.0).abs() < 1e-12);
    assert_eq!((call.rule, call.retained), (ModeRule::Severed, Some(0.3)));
    // The same crack ahead of the pin splits the end.
    let split: Vec<DamageSite> = (0..=15)
        .map(|k| site(0.0, 1.0 + 0.2 * f64::from(k), true, true))
        .collect();
    let call = call_mode(&HOLE, &split, None).unwrap();
    assert_eq!(call.mode, JointMode::ShearOut);
    assert_eq!((call.rule, call.retained), (ModeRule::Split, None));
    // Two lines beside the plug, to the end.
    let lines = (0..=18).flat_map(|k| {
        [-1.0, 1.0].map(|side| DamageSite {
            position: [
                HOLE.centre[0] + 3.0 * side,
                HOLE.centre[1] - 1.5 - 0.6 * f64::from(k),
            ],
            ..site(0.0, 1.0, true, true)
        })
    });
    let call = call_mode(&HOLE, &lines.collect::<Vec<_>>(), None).unwrap();
    assert_eq!(call.mode, JointMode::ShearOut);
    assert!(call.reach[1] > 0.95);
}

#[test]
fn late_broken_fibres_outweigh_early_cracks() {
    let mut sites: Vec<DamageSite> = (0..40)
        .map(|k| site(80.0 + 0.5 * f64::from(k), 1.2, false, false))
        .collect();
    sites.push(site(5.0, 1.1, true, true));
    assert_eq!(called(&sites), JointMode::Bearing);
    // Without late or broken fibres the cracks are all there is.
    sites.pop();
    assert_eq!(called(&sites), JointMode::NetTension);
    assert!(call_mode(&HOLE, &[], None).is_none());
}

/// What fails in the increment that finds no equilibrium is named, and the path at the last equilibrium stands beside it.
#[test]
fn damage_of_the_collapse_is_distinguished() {
    let crack = |k: i32| site(90.0, 1.0 + 0.2 * f64::from(k), true, true);
    // The side lies 2 radii from the edge: two fifths are broken in equilibrium.
    let mut sites: Vec<DamageSite> = (0..4).map(crack).collect();
    let before = call_mode(&HOLE, &sites, None).unwrap();
    assert!((before.reach[2] - 0.4).abs() < 1e-12 && before.collapse == 0.0);
    assert_eq!(before.reach, before.followed_reach);
    assert!(!before.reserve.without_collapse && !before.reserve.without_its_paths);
    sites.extend((4..=10).map(|k| DamageSite {
        collapse: true,
        ..crack(k)
    }));
    let call = call_mode(&HOLE, &sites, None).unwrap();
    assert!((call.reach[2] - 1.0).abs() < 1e-12);
    assert_eq!(call.followed_reach, before.reach);
    assert!((call.collapse - 7.0 / 11.0).abs() < 1e-12);
}

/// A call names the modes to which a tenth of the damage more, a fifth of a path, or the collapse alone would turn it.
#[test]
fn a_call_near_its_threshold_names_the_other_mode() {
    let shares = |bearing: usize, shear: usize| -> Vec<DamageSite> {
        let mut sites = vec![site(10.0, 1.1, true, true); bearing];
        sites.extend(vec![site(60.0, 1.1, true, true); shear]);
        sites
    };
    let others = |sites: &[DamageSite]| call_mode(&HOLE, sites, None).unwrap().others;
    assert_eq!(called(&shares(65, 35)), JointMode::Bearing);
    assert_eq!(called(&shares(55, 45)), JointMode::Bearing);
    assert_eq!(others(&shares(95, 5)), []);
    assert_eq!(called(&shares(35, 65)), JointMode::ShearOut);
    assert_eq!(others(&shares(35, 65)), [JointMode::Mixed]);
    assert_eq!(others(&shares(5, 95)), []);
    // Mixed damage names what takes part in it.
    let half = shares(42, 58);
    assert_eq!(called(&half), JointMode::Mixed);
    assert_eq!(others(&half), [JointMode::Bearing, JointMode::ShearOut]);
    // Bearing in equilibrium, a net section that only the collapse parts.
    let mut sites = shares(30, 5);
    sites.extend((0..=10).map(|k| DamageSite {
        collapse: true,
        ..site(90.0, 1.0 + 0.2 * f64::from(k), true, true)
    }));
    assert_eq!(called(&sites), JointMode::NetTension);
    assert!(others(&sites).contains(&JointMode::Bearing));
}

/// The reserve is what was asked: shares apart, damage that lies in no zone, and the collapse only where there was one.
#[test]
fn the_reserve_holds_what_was_asked() {
    use JointMode::{Mixed, NetTension, ShearOut};
    let damage = |parts: [usize; 4]| -> Vec<DamageSite> {
        let angles = [10.0, 60.0, 92.0, 170.0];
        let sites = angles.into_iter().zip(parts);
        let sites = sites.map(|(angle, count)| vec![site(angle, 1.1, true, true); count]);
        sites.collect::<Vec<_>>().concat()
    };
    let call = |sites: &[DamageSite]| {
        let call = call_mode(&HOLE, sites, None).unwrap();
        (call.mode, call.others, call.reserve)
    };
    // A tenth from behind the hole makes shear-out of it, a tenth to there ends it.
    let (mode, others, reserve) = call(&damage([0, 55, 0, 45]));
    assert_eq!((mode, &others[..]), (Mixed, &[ShearOut][..]));
    assert_eq!(reserve.near, [ShearOut]);
    let (mode, others, _) = call(&damage([0, 65, 0, 35]));
    assert_eq!((mode, &others[..]), (ShearOut, &[Mixed][..]));
    // Net tension holds a third, and no tenth more makes it the mode.
    let (mode, others, reserve) = call(&damage([0, 55, 33, 12]));
    assert_eq!((mode, &others[..]), (Mixed, &[ShearOut, NetTension][..]));
    assert_eq!(
        reserve,
        Reserve {
            near: vec![ShearOut],
            part: Some((0.2, vec![ShearOut, NetTension])),
            without_collapse: false,
            without_its_paths: false,
        }
    );
    // All late fibres break in the collapse, and of the early cracks no mode is asked.
    let fallen = |site: DamageSite| DamageSite {
        collapse: true,
        ..site
    };
    let mut sites = vec![site(10.0, 1.1, false, false); 50];
    sites.extend(damage([0, 95, 0, 0]).into_iter().map(fallen));
    let (mode, _, reserve) = call(&sites);
    assert_eq!((mode, &reserve.near[..]), (ShearOut, &[][..]));
    assert!(!reserve.without_collapse && reserve.without_its_paths);
    // A collapse of a few fibres is left out whole.
    let mut sites = damage([0, 90, 0, 0]);
    sites.extend(damage([0, 5, 0, 0]).into_iter().map(fallen));
    let (_, others, reserve) = call(&sites);
    assert_eq!(others, []);
    assert!(reserve.without_collapse && !reserve.without_its_paths);
}

/// Geometries of the textbook: a wide plate with a far end bears, one with a near end loses that end, a narrow one tears.
#[test]
fn computed_joints_fail_as_their_geometry_has_it() {
    let cases = [
        ("[0/45/-45/90]s", 24.0, 18.0, 0.3, JointMode::Bearing),
        ("[0/45/-45/90]s", 12.0, 5.0, 0.3, JointMode::ShearOut),
        ("[0/45/-45/90]s", 4.5, 12.0, 0.6, JointMode::NetTension),
    ];
    for (layup, half_width, right, pull, expected) in cases {
        let plate = Plate {
            half_width,
            right,
            left: 1.5 * half_width.max(6.0),
            cells: 16,
            layers: 6,
            ..Plate::default()
        };
        let options = Options {
            increments: 30,
            residual_load: 0.6,
            ..Options::default()
        };
        let history = plate
            .joint(&discount(layup), End::Driven)
            .with_options(options)
            .unwrap()
            .follow(&[vec![pull]], &Chain::newton_first(), |_, _| {})
            .unwrap();
        let hole = Hole {
            centre: [0.0; 2],
            radius: plate.radius,
            bearing: [1.0, 0.0],
            side_distance: half_width,
            end_distance: right,
        };
        let call = history.mode(0, &hole).unwrap();
        let peak = &history.records[history.peak()];
        println!(
            "{layup} W/D {:.1} e/D {:.1}: {} at {:.0} N ({:.3} mm), shares {:.2?}, reach {:.2?}, {} records, {} factorisations",
            half_width / plate.radius,
            right / plate.radius / 2.0,
            call.mode,
            peak.load,
            peak.displacement,
            call.shares,
            call.reach,
            history.records.len(),
            history.factorisations
        );
        println!("   {:?} {:?}", call.rule, call.reserve);
        assert_eq!(call.mode, expected, "{layup} {half_width} {right}");
    }
}
