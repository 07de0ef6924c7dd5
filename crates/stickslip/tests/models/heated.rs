//! Changes of temperature of bodies by series, which nothing hinders but contact.

use stickslip::results::{Results, SetStated, Stated};

use super::displacement::ELEMENTS;
use super::series::PIN;
use super::{difference, solved, tractions};

const PRESSED: &str = "contacts.0.interference=true";

/// PIN with expansions, and its pin held over its section.
fn scene() -> String {
    PIN.replace(
        "poisson = 0.33",
        "poisson = 0.33\nexpansion = \"23e-6 1/K\"",
    )
    .replace(
        "poisson = 0.3\n",
        "poisson = 0.3\nexpansion = \"12e-6 1/K\"\n",
    )
    .replace("pin.centre", "pin.section")
}

fn heated(body: &str, by: [f64; 3]) -> String {
    let [one, two, three] = by;
    format!(
        "loads.1={{ on = \"{body}\", temperature.steps = [\"{one} K\", \"{two} K\", \"{three} K\"] }}"
    )
}

/// A pin that is hotter by 100 K is larger by 12 µm in 10 mm.
#[test]
fn a_heated_pin_is_a_larger_one() {
    // With friction the path would matter, on which one grows and the other is as large from the first.
    let pinned = [
        "contacts.0.friction.coulomb.mu=0",
        "analysis.contact_nodes=121",
        "analysis.kinematics=small",
        "contacts.0.gap=linearised",
        PRESSED,
    ];
    let hot = solved(
        &scene(),
        &[&pinned[..], &[&heated("pin", [100.0; 3])]].concat(),
    );
    let radius = format!("bodies.pin.shape.disk.radius={} mm", 4.99 * (1.0 + 12e-4));
    let large = solved(&scene(), &[&pinned[..], &[&radius]].concat());
    for step in 1..3 {
        let [one, other] = [&hot, &large].map(|own| tractions(&own.steps[step].edges[0].rows));
        let apart = difference(one, other);
        // The radius itself changes by a thousandth.
        assert!(apart < 3e-3, "{step} {apart}");
    }
    assert!(
        hot.steps[1].edges[0].contact_half_extent
            > solved(&scene(), &pinned).steps[1].edges[0].contact_half_extent
    );
}

/// A plate that is cooled shrinks onto its pin, by series as by elements, an orthotropic one unequally.
#[test]
fn series_and_elements_expand_alike() {
    let orthotropic = scene()
        .replace("[materials.aluminium.isotropic]", "[materials.aluminium.orthotropic]")
        .replace(
            "young = \"72 GPa\"\npoisson = 0.33\nexpansion = \"23e-6 1/K\"",
            "e1 = \"110 GPa\"\ne2 = \"9 GPa\"\ng12 = \"5 GPa\"\nnu12 = 0.3\nexpansion1 = \"1e-6 1/K\"\nexpansion2 = \"25e-6 1/K\"",
        );
    let cold = |text: &str, accuracy: &str, elements: &[&str]| {
        let changes = [
            heated("plate", [0.0, -120.0, -120.0]),
            format!("analysis.accuracy={accuracy} %"),
            PRESSED.into(),
        ];
        let changes: Vec<&str> = changes
            .iter()
            .map(String::as_str)
            .chain(elements.iter().copied())
            .collect();
        solved(&text.replace("substeps = 1\n", ""), &changes)
    };
    // A quarter turn leaves rounding of shear in the half model.
    let turned = orthotropic.replace("nu12 = 0.3\n", "nu12 = 0.3\nangle = \"90 deg\"\n");
    assert_ne!(turned, orthotropic);
    for text in [scene(), orthotropic, turned] {
        // A search for elements takes twenty times as long as two meshes do.
        let given = ["analysis.kinematics=deformed-gaps", "mesh.spacing=2 deg"];
        let elements = [&ELEMENTS[..], &given].concat();
        let both = [cold(&text, "1", &[]), cold(&text, "3", &elements)];
        let is_series = both.each_ref().map(|own| {
            let mut choices = own.choices.iter();
            choices.any(|choice| choice.what == "bodies by series" && choice.value == "pin, plate")
        });
        assert_eq!(is_series, [true, false]);
        for step in 0..3 {
            for stated in [
                Stated::PeakPressure,
                Stated::ContactExtent,
                Stated::FrictionForce,
                Stated::HoopAtBearing,
            ] {
                let number = |own: &Results| {
                    let edge = &own.steps[step].edges[0];
                    (
                        stated.value(edge).unwrap(),
                        edge.errors.get(stated).unwrap(),
                    )
                };
                let [one, other] = [&both[0], &both[1]].map(number);
                assert!(
                    (one.0 - other.0).abs() <= one.1 + other.1,
                    "{stated:?} {step} {one:?} {other:?}"
                );
            }
            let moved = |own: &Results| {
                let stated = SetStated::Displacement;
                let value = own.set_numbers(0, step).get(stated).unwrap();
                (value, own.set_errors(0, step).get(stated).unwrap())
            };
            let [one, other] = [&both[0], &both[1]].map(moved);
            assert!(
                (one.0 - other.0).abs() <= one.1 + other.1,
                "{step} {one:?} {other:?}"
            );
        }
    }
}

/// In plane strain a heated body that nothing holds in its plane is pressed across it, σ_zz = −E α ΔT, which is its von Mises stress where contact is far.
#[test]
fn a_heated_series_is_pressed_across_the_plane() {
    let strain = [
        "analysis.plane=strain",
        "output.fields=all",
        "bodies.pin.shape.disk.radius=4 mm",
        &heated("plate", [100.0, 100.0, 100.0]),
    ];
    let found = solved(&scene(), &strain);
    let expected = -72e3 * 23e-6 * 100.0;
    let fields = found.steps[0].fields.iter();
    let plate = fields.filter(|own| found.bodies[own.body].name == "plate");
    for own in plate {
        let mesh = found.bodies[own.body].mesh.as_ref().unwrap();
        let nodes = mesh.nodes().iter().zip(&own.thickness_stress);
        // Behind the hole the pull leaves little.
        let mut behind = nodes
            .filter(|([x, y], _)| *x > 17.0 && y.abs() > 17.0)
            .peekable();
        assert!(behind.peek().is_some());
        for (_, across) in behind {
            assert!(
                (across - expected).abs() < 0.02 * expected.abs(),
                "{across}"
            );
        }
    }
}
