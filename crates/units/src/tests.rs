use miette::Diagnostic;

use std::f64::consts::PI;

use super::*;

fn value(text: &str, dimension: Dimension) -> f64 {
    parse(text, &Expected::one(dimension)).unwrap().0
}

#[test]
fn values_arrive_in_base_units() {
    // One rounding per factor and one per product: 3 ulp.
    let close = |left: f64, right: f64| {
        assert!(
            (left - right).abs() <= 3.0 * f64::EPSILON * right.abs(),
            "{left} ≠ {right}"
        );
    };
    close(value("0.375 in", Dimension::Length), 9.525);
    close(value("-2 mil", Dimension::Length), -0.0508);
    close(value("1 ft", Dimension::Length), 304.8);
    close(value("12µm", Dimension::Length), 0.012);
    close(value("1 kip", Dimension::Force), 4448.2216152605);
    close(
        value("20 lb", Dimension::Force),
        value("20lbf", Dimension::Force),
    );
    // 1 ksi = 6.894757 MPa (NIST SP 811, 7 digits).
    assert!((value("1 ksi", Dimension::Stress) - 6.894757).abs() < 5e-7);
    close(
        value("10400 ksi", Dimension::Stress),
        value("10.4 Msi", Dimension::Stress),
    );
    assert_eq!(value("180 deg", Dimension::Angle), PI);
    close(value("9 degF", Dimension::Temperature), 5.0);
    close(value("2.3e-5 1/K", Dimension::PerTemperature), 2.3e-5);
    close(value("1e-6/degF", Dimension::PerTemperature), 1.8e-6);
}

#[test]
fn base_units_are_consistent_and_first() {
    for dimension in Dimension::ALL {
        let first = UNITS
            .iter()
            .find(|unit| unit.dimension == dimension)
            .unwrap();
        assert_eq!((first.name, first.in_base), (dimension.base_unit(), 1.0));
    }
    // 1 psi · 1 in² = 1 lbf.
    let product = value("1 psi", Dimension::Stress) * value("1 in", Dimension::Length).powi(2);
    assert!((product / value("1 lbf", Dimension::Force) - 1.0).abs() < 4.0 * f64::EPSILON);
}

#[test]
fn refusals_carry_the_text() {
    let length = Expected::one(Dimension::Length);
    let refused = |text: &str| parse(text, &length).unwrap_err();
    assert_eq!(
        refused("0.375").to_string(),
        "0.375 has no unit; a length is expected"
    );
    assert_eq!(
        refused("3 MPa").to_string(),
        "\"3 MPa\" has the unit of a stress; a length is expected"
    );
    assert_eq!(
        refused("3 inch").to_string(),
        "'inch' in \"3 inch\" is not a known unit; a length is expected"
    );
    assert!(
        refused("3 inch")
            .help()
            .unwrap()
            .to_string()
            .contains("mm, cm, m, um, nm, in, ft, mil")
    );
    assert!(matches!(refused("mm"), UnitError::NotANumber { .. }));
    assert!(matches!(refused(""), UnitError::NotANumber { .. }));
    assert!(matches!(refused("1.2.3 mm"), UnitError::NotANumber { .. }));
    for text in ["nan mm", "inf mm", "-inf mm", "NaN", "1e999 mm", "1e308 ft"] {
        assert!(
            matches!(refused(text), UnitError::NotFinite { .. }),
            "{text}"
        );
    }
    assert!(matches!(refused("3 e"), UnitError::UnknownUnit { .. }));
    assert!(matches!(refused("3e mm"), UnitError::UnknownUnit { .. }));
}

#[test]
fn one_of_two_dimensions() {
    let either = Expected::any(&[Dimension::Angle, Dimension::Length]);
    assert_eq!(parse("2 mm", &either).unwrap(), (2.0, Dimension::Length));
    assert_eq!(parse("1 rad", &either).unwrap(), (1.0, Dimension::Angle));
    let error = parse("1 N", &either).unwrap_err();
    assert!(matches!(
        &error,
        UnitError::WrongDimension { text, expected, found: Dimension::Force } if text == "1 N" && *expected == either
    ));
    assert!(error.to_string().contains("an angle or a length"));
}

/// A fracture energy shares its unit with a stiffness and a line load, and whoever writes those has never meant an energy.
#[test]
fn a_unit_of_several_meanings_is_named_by_its_parts() {
    for (text, expected, words) in [
        (
            "1449.6 N/mm",
            Dimension::Force,
            "a force per length; a force",
        ),
        ("3 lbf/in", Dimension::Force, "a force per length; a force"),
        ("2 kJ/m²", Dimension::Stress, "an energy per area; a stress"),
        (
            "2 N",
            Dimension::FractureEnergy,
            "a force; a fracture energy",
        ),
        (
            "2 N/mm",
            Dimension::BedStiffness,
            "a force per length; a bed stiffness",
        ),
    ] {
        let error = parse(text, &Expected::one(expected)).unwrap_err();
        assert!(matches!(error, UnitError::WrongDimension { .. }), "{error}");
        assert!(error.to_string().contains(words), "{error}");
    }
    assert_eq!(value("2 N/mm", Dimension::SpringStiffness), 2.0);
    assert_eq!(value("2 N/mm", Dimension::FractureEnergy), 2.0);
}

#[test]
fn quantities_are_read_and_written_as_text() {
    let thickness: Quantity<Length> = serde_json::from_str("\"0.06 in\"").unwrap();
    assert!((thickness.value() - 1.524).abs() < 1e-15);
    assert_eq!(serde_json::to_string(&thickness).unwrap(), "\"0.06 in\"");
    let refused = serde_json::from_str::<Quantity<Length>>("0.06")
        .unwrap_err()
        .to_string();
    assert!(refused.contains("0.06 has no unit"), "{refused}");
    let unit: UnitName<Stress> = serde_json::from_str("\"ksi\"").unwrap();
    assert_eq!(unit.unit().name, "ksi");
    assert!(serde_json::from_str::<UnitName<Stress>>("\"in\"").is_err());
}
