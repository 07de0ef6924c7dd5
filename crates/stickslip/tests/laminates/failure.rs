//! First-ply failure: against lamination theory where stresses are uniform, and what must hold around a hole.

use stickslip::results::{Finding, FirstPly, Results};
use stickslip_laminate::failure::{criterion_named, first_ply_failure};
use stickslip_laminate::{Deformation, LaminateLoad};

use super::{COUPON, PIN, close, scene, solved};

fn first(results: &Results, criterion: usize) -> FirstPly {
    results.failure[0].first_ply[criterion].clone().unwrap()
}

fn load(first: &FirstPly) -> f64 {
    first.load.as_ref().unwrap().value
}

#[test]
fn a_coupon_fails_where_lamination_theory_says() {
    for cure in ["0 K", "-100 K"] {
        let change = format!("materials.laminate.laminate.cure={cure}");
        let changes = [change.as_str(), "failure.envelopes.directions=8"];
        let laminate = scene(COUPON, &changes);
        let sheet = laminate.materials["laminate"].laminate().unwrap();
        let results = solved(COUPON, &changes);
        let failure = &results.failure[0];
        let thickness = sheet.laminate.thickness();
        let theory = LaminateLoad {
            temperature: sheet.cure,
            ..LaminateLoad::membrane([100.0 * thickness, 0.0, 0.0])
        };
        for (k, name) in failure.criteria.iter().enumerate() {
            let criterion = criterion_named(name).unwrap();
            let expected = first_ply_failure(&sheet.laminate, &theory, criterion.as_ref()).unwrap();
            let found = first(&results, k);
            assert!(!found.reached && found.step == 0, "{name}");
            close(expected.assessment.reserve_factor, found.factor, 1e-10);
            close(-100.0 * found.factor, load(&found), 1e-14);
            assert_eq!(expected.assessment.mode, found.at.mode, "{name} {cure}");
            let group = &failure.plies[found.at.ply];
            assert!(group.layers.contains(&expected.layer), "{name} {cure}");
            // The first point of an envelope is tension along x.
            let envelope = failure
                .envelopes
                .iter()
                .find(|own| own.criterion == *name)
                .unwrap();
            close(envelope.points[0].stress[0], 100.0 * found.factor, 1e-10);
        }
    }
}

/// Without a mesh loads, indices and places of failing plies have errors, which hold what a finer answer finds; with a mesh they have none.
#[test]
fn failing_plies_have_errors_where_an_accuracy_is_sought() {
    let free = PIN.replace("[mesh]\nspacing = \"6 deg\"\n", "");
    let [found, finer] = ["5 %", "0.5 %"].map(|accuracy| {
        let accuracy = format!("analysis.accuracy=\"{accuracy}\"");
        solved(&free, &[&accuracy])
    });
    let [own, better] = [&found, &finer].map(|results| &results.failure[0]);
    for k in 0..own.criteria.len() {
        let (own, better) = (first(&found, k), first(&finer, k));
        let [error, doubt] = [&own, &better].map(|first| first.load_error.unwrap());
        assert!((load(&own) - load(&better)).abs() <= error + doubt);
        let [error, doubt] = [&own, &better].map(|first| first.at.errors.unwrap().place);
        let apart = [0, 1].map(|axis| own.at.position[axis] - better.at.position[axis]);
        assert!(apart[0].hypot(apart[1]) <= error + doubt);
    }
    let steps = own
        .steps
        .iter()
        .flatten()
        .zip(better.steps.iter().flatten());
    for (own, better) in steps {
        let [errors, doubts] = [own, better].map(|point| point.errors.unwrap());
        let apart = (own.index - better.index).abs();
        assert!(apart <= errors.index.unwrap() + doubts.index.unwrap());
    }
    let meshed = solved(PIN, &[] as &[&str]);
    assert!(first(&meshed, 0).load_error.is_none() && first(&meshed, 0).at.errors.is_none());
}

#[test]
fn stresses_in_the_plies_are_those_of_lamination_theory() {
    let changes = [
        "materials.laminate.laminate.cure=-120 K",
        "edges=[{ on = \"coupon.top\" }]",
    ];
    let laminate = scene(COUPON, &changes);
    let sheet = laminate.materials["laminate"].laminate().unwrap();
    let results = solved(COUPON, &changes);
    let failure = &results.failure[0];
    let load = LaminateLoad {
        temperature: sheet.cure,
        ..LaminateLoad::membrane([100.0 * sheet.laminate.thickness(), 0.0, 0.0])
    };
    let deformation: Deformation = sheet.laminate.deformation(&load);
    let states = sheet.laminate.ply_states(&deformation, sheet.cure);
    let edge = &failure.edges[0];
    assert_eq!(edge.parameter.len(), results.edges[0].parameter.len());
    for (group, plies) in failure.plies.iter().zip(&edge.steps[0]) {
        for layer in &group.layers {
            let state = states.iter().find(|state| state.layer == *layer).unwrap();
            for ply in plies {
                for (one, other) in state.stress.iter().zip(ply.stress) {
                    // Of stresses up to 200 MPa.
                    assert!(
                        (one - other).abs() < 1e-8,
                        "{:?} {:?}",
                        state.stress,
                        ply.stress
                    );
                }
            }
        }
    }
    // Without load the cure alone is left, and it balances itself over the plies.
    let balance: f64 = failure
        .plies
        .iter()
        .map(|group| group.layers.len() as f64 * (group.residual[0] + group.residual[1]))
        .sum();
    assert!(balance.abs() < 1e-9, "{balance}");
}

#[test]
fn heat_acts_like_the_cure_and_grows_with_the_load() {
    let heat = "loads=[{ name = \"tension\", on = \"coupon.right\", pressure = { steps = [\"0 MPa\", \"-100 MPa\"] } }, \
                { on = \"coupon\", temperature = { steps = [\"-100 K\", \"-100 K\"] } }]";
    let heated = solved(COUPON, &[heat]);
    let cured = solved(COUPON, &["materials.laminate.laminate.cure=-100 K"]);
    // Cooled first and pulled then: the same stresses in the plies, so the same load on the way.
    for criterion in 0..5 {
        let (one, other) = (first(&heated, criterion), first(&cured, criterion));
        if other.factor < 1.0 {
            assert!(one.reached && one.step == 1);
            close(load(&other), load(&one), 1e-9);
        } else {
            assert!(!one.reached);
        }
        let index =
            |results: &Results, step: usize| results.failure[0].steps[step][criterion].index;
        close(index(&cured, 0), index(&heated, 1), 1e-9);
    }
}

#[test]
fn the_failure_load_does_not_depend_on_the_loads_of_the_history() {
    let at = |steps: &str| solved(PIN, &[&format!("loads.0.force.steps={steps}")]);
    let one = at("[\"1 kN\"]");
    let double = at("[\"2 kN\"]");
    let through = at("[\"1 kN\", \"30 kN\", \"2 kN\"]");
    for criterion in 0..5 {
        let [one, double, through] =
            [&one, &double, &through].map(|results| first(results, criterion));
        assert!(!one.reached && !double.reached);
        close(one.factor, 2.0 * double.factor, 1e-9);
        close(load(&one), load(&double), 1e-9);
        assert!(through.reached && through.step == 1, "{through:?}");
        close(load(&one), load(&through), 1e-9);
        for (a, b) in one.at.stress.iter().zip(through.at.stress) {
            assert!((a - b).abs() < 1e-6 * 1500.0);
        }
        assert_eq!((one.at.ply, one.at.mode), (through.at.ply, through.at.mode));
    }
}

#[test]
fn twice_the_strength_is_twice_the_load() {
    let strong = "plies.carbon.strengths={ xt = \"3000 MPa\", xc = \"2400 MPa\", yt = \"100 MPa\", yc = \"400 MPa\", \
                  s12 = \"140 MPa\", s23 = \"200 MPa\" }";
    let (weak, strong) = (solved(PIN, &[]), solved(PIN, &[strong]));
    for criterion in 0..5 {
        let (weak, strong) = (first(&weak, criterion), first(&strong, criterion));
        close(2.0 * load(&weak), load(&strong), 1e-9);
        assert_eq!(weak.at.position, strong.at.position);
    }
}

#[test]
fn a_half_model_stands_for_the_whole() {
    for changes in [
        vec!["bodies.pin.shape.disk.radius=4.99 mm"],
        // Symmetric as a sheet, but not ply by ply: fibres at 60° have no twin at −60°.
        vec![
            "materials.laminate.laminate.layup=[0/60/-60]s",
            "materials.laminate.laminate.cure=-80 K",
        ],
    ] {
        let steps = "loads.0.force.steps=[\"1 kN\", \"4 kN\", \"2 kN\"]";
        let with = |model: &'static str| {
            let mut all = changes.clone();
            all.extend([
                steps,
                model,
                "failure.characteristic={ tension = \"1 mm\", compression = \"2 mm\" }",
            ]);
            solved(PIN, &all)
        };
        let half = with("analysis.model=half");
        let whole = with("analysis.model=whole");
        let [one, other] = [&half, &whole].map(|results| &results.failure[0]);
        for (one, other) in one.steps.iter().flatten().zip(other.steps.iter().flatten()) {
            // Residuals of the two contact solutions, about 1e-10 of the largest force.
            close(one.reserve_factor, other.reserve_factor, 1e-7);
            assert_eq!((one.ply, one.mode), (other.ply, other.mode));
            for axis in 0..2 {
                assert!((one.position[axis] - other.position[axis]).abs() < 1e-9);
            }
        }
        let [left, right] = [one, other].map(|failure| &failure.edges[0]);
        assert_eq!(left.parameter.len(), right.parameter.len());
        for (a, b) in left.parameter.iter().zip(&right.parameter) {
            assert!((a - b).abs() < 1e-12);
        }
        for (step, (a, b)) in left.steps.iter().zip(&right.steps).enumerate() {
            for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                for (a, b) in a.index.iter().zip(&b.index) {
                    assert!(
                        (a - b).abs() < 1e-6 * (1.0 + a.abs()),
                        "step {step}: {a} {b}"
                    );
                }
            }
        }
        let curves = [one, other].map(|failure| failure.characteristic.clone().unwrap());
        assert_eq!(curves[0].angles.len(), curves[1].angles.len());
        for (a, b) in curves[0].curve.iter().zip(&curves[1].curve) {
            let (a, b) = (a.as_ref().unwrap(), b.as_ref().unwrap());
            close(a.first.factor, b.first.factor, 1e-7);
            assert_eq!((a.mode, a.first.at.ply), (b.mode, b.first.at.ply));
        }
        // Patches at the line of symmetry are one-sided in a half model, which has no effect two cells of 6° away.
        let indices = curves[0].index.iter().zip(&curves[1].index);
        for (a, b) in indices
            .flat_map(|(a, b)| a.iter().zip(b).zip(&curves[0].angles))
            .filter_map(|(pair, angle)| (angle.to_degrees().abs() > 15.0).then_some(pair))
        {
            assert!((a - b).abs() < 1e-6 * (1.0 + a.abs()), "{a} {b}");
        }
    }
}

/// Loads of failure by series and by elements: at characteristic distances, and on the hole's edge, where cells miss some of the cusp.
#[test]
fn plies_of_series_fail_as_those_of_elements() {
    let free = PIN.replace("[mesh]\nspacing = \"6 deg\"\n", "");
    for layup in ["[0_2/60_2/-60_2]s", "[0_4/90_2]s", "[0/45/0/45/90_2]s"] {
        let layup = format!("materials.laminate.laminate.layup={layup}");
        let both = ["analysis.contact_nodes=241", "mesh.spacing=0.75 deg"].map(|division| {
            let curve = "failure.characteristic={ tension = \"1 mm\", compression = \"2 mm\" }";
            solved(&free, &[&layup, division, curve])
        });
        assert_eq!(both.each_ref().map(|found| found.factorisations), [0, 2]);
        let [one, other] = both.each_ref().map(|results| &results.failure[0]);
        for (one, other) in one.first_ply.iter().zip(&other.first_ply) {
            let (one, other) = (one.as_ref().unwrap(), other.as_ref().unwrap());
            close(one.factor, other.factor, 0.03);
            assert_eq!((one.at.ply, one.at.mode), (other.at.ply, other.at.mode));
        }
        let [one, other] = [one, other].map(|found| found.characteristic.as_ref().unwrap());
        for (one, other) in [
            (&one.net_section, &other.net_section),
            (&one.bearing_point, &other.bearing_point),
        ] {
            for (one, other) in one.iter().zip(other) {
                let (one, other) = (one.as_ref().unwrap(), other.as_ref().unwrap());
                close(one.factor, other.factor, 5e-3);
                // On the axis plies at 60° and −60° fail together.
                assert_eq!(one.at.mode, other.at.mode);
            }
        }
    }
}

#[test]
fn a_cure_that_breaks_plies_is_reported() {
    let results = solved(COUPON, &["materials.laminate.laminate.cure=-600 K"]);
    let found = first(&results, 0);
    assert!(found.reached && found.factor == 0.0 && load(&found) == 0.0);
    assert_eq!(results.failure[0].steps[0][0].reserve_factor, 0.0);
}

#[test]
fn without_load_nothing_fails() {
    let results = solved(COUPON, &["loads.0.pressure.steps=[\"0 MPa\"]"]);
    assert!(results.failure[0].first_ply.iter().all(Option::is_none));
    assert!(results.failure[0].steps[0][0].reserve_factor.is_infinite());
}

/// A reserve factor multiplies all that presses the pin, which is no factor on the load where interference does.
#[test]
fn reserve_factors_beside_interference_are_reported() {
    let said = |changes: &[&str]| {
        let results = solved(PIN, changes);
        let about = |finding: &&Finding| matches!(finding, Finding::ReserveWithInterference { .. });
        results.findings.iter().filter(about).count()
    };
    assert_eq!(said(&["mesh.spacing=15 deg"]), 0);
    let tight = [
        "mesh.spacing=15 deg",
        "contacts.0.interference=true",
        "bodies.pin.shape.disk.radius=5.01 mm",
    ];
    assert_eq!(said(&tight), 1);
}
