//! What is refused, with the value, the place and the way out.

use super::{COUPON, PIN, read};

/// The scene with one change is refused; message, key and remedy hold these parts.
#[track_caller]
fn refused(text: &str, change: &str, parts: &[&str]) {
    let error = read(text, &[change]).expect_err(change);
    let reported: Vec<String> = error
        .findings()
        .iter()
        .map(|finding| {
            let summary = finding.summary();
            format!(
                "{} at {} help: {}",
                summary.message,
                finding.key,
                summary.help.unwrap_or_default()
            )
        })
        .collect();
    let all = reported.join("\n");
    assert_eq!(reported.len(), 1, "{change}:\n{all}");
    for part in parts {
        assert!(
            all.contains(part),
            "'{part}' is missing for {change}:\n{all}"
        );
    }
}

#[test]
fn plies() {
    refused(
        PIN,
        "plies.carbon.e2=-9 GPa",
        &["ply 'carbon'", "-9000", "plies.carbon"],
    );
    refused(
        PIN,
        "plies.carbon.nu12=4.0",
        &[
            "ply 'carbon'",
            "4",
            "at plies.carbon.nu12",
            "which of the two moduli",
        ],
    );
    refused(
        PIN,
        "plies.carbon.thickness=0 mm",
        &["ply 'carbon'", "thickness = 0", "at plies.carbon.thickness"],
    );
    refused(
        PIN,
        "plies.carbon.strengths.yc=-200 MPa",
        &["yc = -200", "magnitudes", "at plies.carbon.strengths.yc"],
    );
    refused(
        PIN,
        "plies.carbon.strengths={}",
        &["'xt' is missing", "plies.carbon.strengths"],
    );
    refused(
        PIN,
        "plies.carbon.density=1.6",
        &["unknown key 'density'", "thickness"],
    );
}

#[test]
fn layups() {
    let layup = |text: &str| format!("materials.laminate.laminate.layup={text}");
    refused(
        PIN,
        &layup("[]"),
        &[
            "material 'laminate'",
            "no ply here",
            "at materials.laminate.laminate.layup",
        ],
    );
    refused(
        PIN,
        &layup("[0/fourty/90]s"),
        &["character 4", "fourty", "stickslip list layups"],
    );
    refused(
        PIN,
        &layup("[0/90:glass]s"),
        &["ply 'glass'", "carbon", "[plies.NAME]"],
    );
    refused(
        PIN,
        &layup("[0/90]"),
        &["not symmetric", "coupling of 0.", "held_flat = true"],
    );
    refused(
        PIN,
        "materials.laminate.laminate.ply=carbn",
        &["there is no ply 'carbn'", "did you mean 'carbon'?"],
    );
    refused(
        PIN,
        "analysis.plane=strain",
        &[
            "'laminate' is a laminate",
            "plane = \"strain\"",
            "e3, nu13 and nu23",
        ],
    );
    refused(
        PIN,
        "bodies.plate.thickness=2 mm",
        &[
            "thickness = 2 mm",
            "1.5 mm thick",
            "at bodies.plate.thickness",
            "leave thickness out",
        ],
    );
    let flat =
        "materials.laminate.laminate={ layup = \"[0/90]\", ply = \"carbon\", held_flat = true }";
    assert!(read(PIN, &[flat]).is_ok());
    assert!(read(PIN, &["bodies.plate.thickness=1.5 mm"]).is_ok());
}

#[test]
fn a_layup_needs_a_ply() {
    let named = "materials.laminate.laminate={ layup = \"[0:carbon/90:carbon]s\" }";
    assert!(read(PIN, &[named]).is_ok());
    let unnamed = "materials.laminate.laminate={ layup = \"[0:carbon/90]s\" }";
    refused(PIN, unnamed, &["'ply' is missing", "ply = \"carbon\""]);
    let unknown = "materials.laminate.laminate={ layup = \"[0:glass/90:glass]s\" }";
    refused(PIN, unknown, &["there is no ply 'glass'", "carbon"]);
}

#[test]
fn questions() {
    refused(
        PIN,
        "failure.criteria=[\"tsai\"]",
        &["'tsai' is not a failure criterion", "tsai_wu"],
    );
    refused(PIN, "failure.criteria=[]", &["at least one"]);
    refused(
        PIN,
        "failure.criteria=[\"hashin\", \"hashin\"]",
        &["'hashin' is named twice"],
    );
    refused(
        PIN,
        "failure={ criteria = [\"hashin\"], tsai_wu_interaction = -0.3 }",
        &["'tsai_wu' is not among the criteria"],
    );
    refused(
        PIN,
        "failure.criteria=[\"max_strain\"]",
        &[
            "max_strain",
            "strain_1t",
            "'carbon'",
            "at failure.criteria.0",
            "linear_strain_limits = true",
        ],
    );
    refused(
        PIN,
        "failure.criteria=[\"max_stress\", \"tsai_hill_3d\"]",
        &["zt", "'carbon'", "failure.criteria.1"],
    );
    refused(
        PIN,
        "failure.bodies=[\"pin\"]",
        &["body 'pin' has no plies", "plate"],
    );
    refused(
        PIN,
        "failure.bodies=[\"plat\"]",
        &["there is no body 'plat'", "did you mean 'plate'?"],
    );
    refused(PIN, "failure.bodies=[]", &["at least one body"]);
    refused(
        PIN,
        "failure.tsai_wu_interaction=1.5",
        &["F12", "at failure.tsai_wu_interaction"],
    );
    refused(
        PIN,
        "failure.hashin_shear_weight=2",
        &["2", "at failure.hashin_shear_weight"],
    );
    refused(
        PIN,
        "failure.characteristic={ tension = \"0 mm\", compression = \"1 mm\" }",
        &["tension = 0 mm", "greater than 0"],
    );
    refused(
        PIN,
        "failure.characteristic={ tension = \"1 mm\" }",
        &["'compression' is missing"],
    );
    refused(
        COUPON,
        "failure.characteristic={ tension = \"1 mm\", compression = \"1 mm\" }",
        &["body 'coupon' has none"],
    );
    refused(
        COUPON,
        "failure.envelopes.directions=2",
        &["directions = 2", "from 3"],
    );
    refused(
        COUPON,
        "failure.envelopes.planes=[]",
        &["\"normal\" and \"shear\""],
    );
    refused(
        COUPON,
        "failure.envelopes.last_ply={ fibre = 0.0, matrix = 0.1 }",
        &["fibre = 0", "at failure.envelopes.last_ply.fibre"],
    );
    let linear = "plies.carbon.strengths.linear_strain_limits=true";
    assert!(read(PIN, &["failure.criteria=[\"max_strain\"]", linear]).is_ok());
}

#[test]
fn questions_without_strengths_or_laminates() {
    let bare = PIN.replace("strengths = {", "# {");
    refused(
        &bare,
        "failure.criteria=[\"max_stress\"]",
        &[
            "'carbon'",
            "no strengths at all",
            "[plies.carbon.strengths]",
        ],
    );
    let steel = "bodies.plate={ material = \"steel\", thickness = \"1.5 mm\", shape = { plate_with_hole = { hole_radius = \"5 mm\", \
                 outline = { ring = { radius = \"50 mm\" } } } } }";
    let text = PIN.replace("on = \"plate.left\"", "on = \"plate.hole\"");
    let parts = [
        "no body of this scene is made of a laminate",
        "remove [failure]",
    ];
    refused(&text, steel, &parts);
}

/// Of several laminates that may be followed the missing key names each.
#[test]
fn the_body_of_a_progressive_failure() {
    let failing = "failure.progressive={model={ply_discount={fibre=0.01,matrix=0.1}}}";
    let another = "bodies.pin.material=laminate";
    let error = read(PIN, &[failing, another]).unwrap_err();
    let reported = format!("{:?}", error.findings()[0].summary());
    assert!(
        reported.contains("body = ") && reported.contains(" or body = "),
        "{reported}"
    );
}
