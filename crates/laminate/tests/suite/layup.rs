//! The lay-up notation.

use proptest::prelude::*;
use stickslip_laminate::layup::MAXIMUM_PLIES;
use stickslip_laminate::{Layup, LayupError};

fn angles(text: &str) -> Vec<f64> {
    let layup: Layup = text.parse().unwrap_or_else(|error| panic!("{error}"));
    layup.stack().iter().map(|ply| ply.angle).collect()
}

#[test]
fn notation_means_what_the_table_says() {
    let cases: [(&str, &[f64]); 12] = [
        ("[0/90]", &[0.0, 90.0]),
        ("[0_2/90]", &[0.0, 0.0, 90.0]),
        (
            "[0/±45/90]s",
            &[0.0, 45.0, -45.0, 90.0, 90.0, -45.0, 45.0, 0.0],
        ),
        ("[0/90]_2s", &[0.0, 90.0, 0.0, 90.0, 90.0, 0.0, 90.0, 0.0]),
        ("[0/90]2s", &[0.0, 90.0, 0.0, 90.0, 90.0, 0.0, 90.0, 0.0]),
        ("[0/45/90~]s", &[0.0, 45.0, 90.0, 45.0, 0.0]),
        ("[0/45/0\u{304}]s", &[0.0, 45.0, 0.0, 45.0, 0.0]),
        ("[(±45)_2/0]", &[45.0, -45.0, 45.0, -45.0, 0.0]),
        ("[∓30/22.5]t", &[-30.0, 30.0, 22.5]),
        (
            "( 0₂ / 60₂ / −60₂ )s",
            &[
                0.0, 0.0, 60.0, 60.0, -60.0, -60.0, -60.0, -60.0, 60.0, 60.0, 0.0, 0.0,
            ],
        ),
        (
            "[+-45, +/-30°, -+10]",
            &[45.0, -45.0, 30.0, -30.0, -10.0, 10.0],
        ),
        (
            "[(0/90~)s/45]_s",
            &[0.0, 90.0, 0.0, 45.0, 45.0, 0.0, 90.0, 0.0],
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(angles(text), expected, "{text}");
    }
}

#[test]
fn plies_can_be_named() {
    let layup: Layup = "[0_2:carbon/±45:glass_8/90~]s".parse().unwrap();
    let names: Vec<_> = layup
        .stack()
        .iter()
        .map(|ply| ply.ply.as_deref().unwrap_or(""))
        .collect();
    let half = ["carbon", "carbon", "glass_8", "glass_8"];
    let expected: Vec<_> = half
        .into_iter()
        .chain([""])
        .chain(half.into_iter().rev())
        .collect();
    assert_eq!(names, expected);
    assert_eq!(layup.to_string(), "[0_2:carbon/±45:glass_8/90~]s");
}

#[test]
fn errors_name_the_place_and_the_way_out() {
    let cases = [
        ("", 1, "found the end, expected ["),
        ("0/90", 1, "found '0', expected ["),
        ("[]", 2, "no ply here"),
        ("[0//90]", 4, "no ply here"),
        ("[0/90", 6, "found the end, expected / or ]"),
        ("[0/90)", 6, "found ')', expected / or ]"),
        ("[0/90]x", 7, "found 'x', expected the end"),
        ("[0/90]_", 8, "a number of repeats, or s"),
        ("[0/abc/90]", 4, "'abc' is not an angle"),
        ("[0/nan]", 4, "'nan' is not an angle"),
        ("[0/1.2.3]", 4, "'1.2.3' is not an angle"),
        ("[0/900]", 4, "'900' is not an angle"),
        ("[0/--45]", 5, "'-45' is not an angle"),
        ("[0_0/90]", 4, "'0' is not a number of plies"),
        ("[0_/90]", 4, "a number of plies after _"),
        ("[0/1 0]", 6, "found '0', expected / or ]"),
        (
            "[0/±45_2]",
            8,
            "(±45)_2 for pairs, or 45_2/-45_2 for blocks",
        ),
        ("[0/90~]", 6, "the last in a bracket that ends in s"),
        ("[0~/90]s", 3, "the last in a bracket that ends in s"),
        ("[0/90~]_2s", 6, "the last in a bracket that ends in s"),
        ("[0/90_2~]s", 8, "one single ply"),
        ("[0/±45~]s", 7, "one single ply"),
        ("[0:/90]", 4, "the name of a ply after :"),
    ];
    for (text, position, message) in cases {
        let error = text.parse::<Layup>().unwrap_err().to_string();
        assert!(error.contains(message), "{text}: {error}");
        assert!(
            error.contains(&format!("character {position}:")),
            "{text}: {error}"
        );
    }
}

#[test]
fn sizes_beyond_reason_are_refused_without_being_built() {
    let too_many =
        |text: &str| matches!(text.parse::<Layup>(), Err(LayupError::TooManyPlies { .. }));
    assert_eq!(angles(&format!("[0]_{MAXIMUM_PLIES}")).len(), MAXIMUM_PLIES);
    assert!(too_many(&format!("[0/90]_{MAXIMUM_PLIES}")));
    assert!(too_many("[(0_4000000000)_4000000000]_4000000000s"));
    assert!(matches!(
        "[0_99999999999999999999]".parse::<Layup>(),
        Err(LayupError::Count { .. })
    ));
    let deep = format!("{}0{}", "[".repeat(1000), "]".repeat(1000));
    assert!(matches!(
        deep.parse::<Layup>(),
        Err(LayupError::TooDeep { .. })
    ));
}

/// Texts that are lay-ups.
fn notation() -> impl Strategy<Value = String> {
    let ply = (
        prop_oneof![Just(""), Just("-")],
        -0.0..180.0_f64,
        1..4_usize,
        prop_oneof![Just(""), Just(":cf")],
    );
    let single = ply.prop_map(|(sign, angle, count, name)| format!("{sign}{angle}_{count}{name}"));
    let pair = (prop_oneof![Just("±"), Just("∓")], 1..90_u8)
        .prop_map(|(sign, angle)| format!("{sign}{angle}"));
    let item = prop_oneof![single, pair];
    let suffix = || prop_oneof![Just(""), Just("s"), Just("_2"), Just("_3s")];
    let group = move |item: BoxedStrategy<String>| {
        (prop::collection::vec(item, 1..4), suffix())
            .prop_map(|(items, suffix)| format!("[{}]{suffix}", items.join("/")))
    };
    item.boxed()
        .prop_recursive(3, 24, 4, move |inner| group(inner).boxed())
        .prop_map(|text| {
            if text.starts_with('[') {
                text
            } else {
                format!("[{text}]s")
            }
        })
}

proptest! {
    #[test]
    fn display_reads_back_as_the_same_layup(text in notation()) {
        let layup: Layup = text.parse().unwrap();
        let again: Layup = layup.to_string().parse().unwrap();
        prop_assert_eq!(again, layup);
    }

    #[test]
    fn no_text_panics(text in "[\\[\\]()0-9/_s~±+. −:a\u{304}-]{0,24}") {
        if let Ok(layup) = text.parse::<Layup>() {
            prop_assert!(!layup.stack().is_empty());
            prop_assert_eq!(layup.to_string().parse::<Layup>().unwrap(), layup);
        }
    }
}
