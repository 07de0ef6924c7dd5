use super::*;
use crate::diagnostic::SourceText;
use crate::document::Format;

fn read_law(friction: &str) -> Result<ReadLaw, Box<Finding>> {
    let text = format!("[[contacts]]\n{friction}\n");
    let source = SourceText {
        name: "a.toml".into(),
        text,
    };
    let document = Document::parse(source, Format::Toml).unwrap();
    let table = document.get("contacts.0.friction").unwrap().clone();
    read(&document, "contacts.0.friction", &table, None)
}

fn refused(friction: &str) -> (String, String, String) {
    let finding = read_law(friction).err().unwrap();
    let summary = finding.summary();
    let span = finding.span.unwrap();
    (
        summary.message,
        summary.help.unwrap_or_default(),
        finding.source.text[span].to_owned(),
    )
}

#[test]
fn quantities_become_numbers_and_defaults_are_shown() {
    let read = read_law(
        "friction.slip_power = { static = 0.35, dynamic = 0.25, slip_scale = \"0.001 in\", exponent = 1 }",
    );
    let read = read.unwrap();
    let plain = serde_json::to_value(&read.law).unwrap();
    assert_eq!(plain["slip_power"]["slip_scale"], 0.0254);
    assert_eq!(read.shown["slip_power"]["slip_scale"], "0.001 in");
    assert_eq!(read.shown["slip_power"]["path"], "committed");
    assert_eq!(read.shown["slip_power"]["allow_strengthening"], false);
}

#[test]
fn nested_laws_and_lists_are_converted() {
    let text = "friction.fibre_coverage = { fibre_fraction = 0.6, kernel.tangent.width = \"5 deg\", \
                plies = [{ angle = \"90 deg\", fraction = 1.0 }], fibre.coulomb.mu = 0.1, \
                matrix.pressure_power = { mu = 0.3, reference_pressure = \"1 ksi\", exponent = 0.9 } }";
    let read = read_law(text).unwrap();
    let plain = serde_json::to_value(&read.law).unwrap();
    let coverage = &plain["fibre_coverage"];
    assert_eq!(coverage["plies"][0]["angle"], std::f64::consts::FRAC_PI_2);
    let reference = coverage["matrix"]["pressure_power"]["reference_pressure"]
        .as_f64()
        .unwrap();
    assert!((reference - 6.894757).abs() < 5e-7);
}

#[test]
fn a_bare_number_where_a_unit_belongs() {
    let (message, help, shown) = refused(
        "friction.slip_power = { static = 0.35, dynamic = 0.25, slip_scale = 0.001, exponent = 1 }",
    );
    assert_eq!(message, "0.001 has no unit; a length is expected");
    assert!(help.contains("\"0.001 mm\""), "{help}");
    assert_eq!(shown, "0.001");
}

#[test]
fn unknown_laws_and_parameters_are_named() {
    let (message, help, shown) = refused("friction.columb = { mu = 0.3 }");
    assert_eq!(message, "'columb' is not a friction law");
    assert!(
        help.starts_with("did you mean 'coulomb'? choices: coulomb, "),
        "{help}"
    );
    assert_eq!(shown, "columb");
    let (message, help, _) = refused("friction.coulomb = { mu = 0.3, nu = 1 }");
    assert_eq!(message, "unknown key 'nu'");
    assert!(help.ends_with("known keys here: mu"), "{help}");
    let (message, help, shown) = refused("friction.coulomb = {}");
    assert_eq!(message, "'mu' is missing in 'contacts.0.friction.coulomb'");
    assert_eq!(
        (help.as_str(), shown.as_str()),
        ("add for example `mu = 0.3`", "coulomb")
    );
    let (message, _, _) = refused("friction = { coulomb.mu = 0.1, static_dynamic = {} }");
    assert!(
        message.contains("exactly one of") && message.ends_with("found coulomb, static_dynamic"),
        "{message}"
    );
}

#[test]
fn the_law_speaks_for_itself() {
    let (message, help, shown) = refused("friction.coulomb = { mu = -0.1 }");
    assert_eq!(
        message,
        "friction law 'coulomb': mu = -0.1 is outside [0, ∞)"
    );
    assert_eq!(shown, "-0.1");
    assert!(help.contains("stickslip list"));
    let (message, _, shown) = refused("friction.static_dynamic = { static = 0.2, dynamic = 0.3 }");
    assert!(message.contains("allow_strengthening = true"), "{message}");
    assert_eq!(shown, "0.3");
}

#[test]
fn tables_that_hold_one_entry_are_known() {
    let law = "contacts.0.friction.fibre_coverage";
    for inner in [
        "kernel",
        "fibre",
        "matrix",
        "fibre.fibre_coverage.kernel",
        "matrix.fibre_coverage.fibre",
    ] {
        assert!(is_choice(&format!("{law}.{inner}")), "{inner}");
    }
    for other in [
        "",
        ".plies",
        ".plies.0",
        ".kernel.swept",
        ".fibre.coulomb",
        ".fibre.nothing",
    ] {
        assert!(!is_choice(&format!("{law}{other}")), "{other}");
    }
    assert!(!is_choice("loads.0.force") && !is_choice("contacts.0"));
}
