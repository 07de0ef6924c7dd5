//! `report.html`.

use std::fs;

use stickslip::results::{BodyStresses, SecondSide, StressPeak};

use super::files::written;
use super::findings::PSI;
use super::fixture::results;

#[test]
fn the_page_holds_everything_and_escapes_it() {
    let (_place, folder) = written(&results(), true);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("A &lt;plate&gt; &amp; its pin") && !page.contains("A <plate>"));
    let parts = [
        "plate.toml",
        "4 load steps",
        "answer is not unique in load step 3",
        "up to 1 contact points stick",
        "Bearing stress σ_b",
        "Load steps",
        "all is symmetric",
        "Signs and names",
        "CSHEAR1",
        "edge-pin-step-*.csv",
        "0123abcd",
        concat!("stickslip ", env!("CARGO_PKG_VERSION")),
        "One half of a symmetric model was solved",
    ];
    for part in parts {
        assert!(page.contains(part), "'{part}' is missing");
    }
    for remote in ["http-equiv", "<script", "<link", "src=\"http"] {
        assert!(!page.contains(remote), "{remote}");
    }
}

/// In display units, 25.4 µm are a thousandth of an inch.
#[test]
fn the_problem_states_the_clearance_of_each_contact() {
    let mut results = results();
    results.scene = r#"version = 1
contacts = [{ name = "pin", first = "plate.hole", second = "pin.rim" }, { name = "roller", first = "a.b", second = "c.d" }]
"#
    .to_owned();
    for (clearance, shown) in [
        (Some(0.0254), "0.001 in"),
        (Some(-0.0254), "interference 0.001 in"),
        (Some(0.0), "0 in"),
        (None, "–"),
    ] {
        results.edges[0].clearance = clearance;
        let (_place, folder) = written(&results, false);
        let page = fs::read_to_string(folder.join("report.html")).unwrap();
        assert!(page.contains("radial clearance"), "{shown}");
        let row = page.split("<td>pin.rim</td>").nth(1).unwrap();
        let (cell, _) = row.split_once("</td>").unwrap();
        assert!(cell.ends_with(&format!(">{shown}")), "{shown}: {cell}");
    }
}

#[test]
fn bodies_are_shown_whole_with_their_stresses_and_both_sides_of_a_contact() {
    let mut results = results();
    results.steps[2].fields = results.steps[3].fields.clone();
    let mesh = results.bodies[1].mesh.clone().unwrap();
    let path = mesh.edge_path("hole").unwrap();
    let angle = |&node: &usize| {
        let [x, y] = mesh.nodes()[node];
        y.atan2(x)
    };
    results.edges[0].second = Some(SecondSide {
        body: 1,
        parameter: path.nodes.iter().map(angle).collect(),
        normals: (path.nodes.iter().map(angle))
            .map(|at| [at.cos(), at.sin()])
            .collect(),
        nodes: path.nodes,
    });
    let peak = |stress: f64| StressPeak {
        stress: stress * PSI,
        at: [25.4, 0.0],
        beyond: 0.0,
        error: None,
    };
    results.bodies[1].yield_stress = Some(5000.0 * PSI);
    results.steps[2].stresses = vec![BodyStresses {
        body: 1,
        von_mises: peak(14000.0),
        largest_principal: peak(13000.0),
        least_principal: peak(-2000.0),
    }];
    let (_place, folder) = written(&results, true);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    for part in [
        "Both sides of &#x27;pin&#x27; at",
        "Deformed shape of",
        "The whole of &#x27;plate&#x27;",
        "A red line is the yield stress.",
        "a window, beyond which the body goes on",
        "without a yield stress in load step 3 alone",
        "<td class=\"number\">14000</td>",
        "<td class=\"number\">−2000</td>",
        "@page { size: A4;",
    ] {
        assert!(page.contains(part), "'{part}' is missing");
    }
    for name in ["sides-pin.svg", "deformed-plate-step-03.svg"] {
        assert!(folder.join("figures").join(name).exists(), "{name}");
    }
}

#[test]
fn captions_say_the_numbers() {
    let (_place, folder) = written(&results(), true);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    // 4000 N on 20 mm × 2 mm: σ_b = 100 MPa = 14504 psi.
    assert!(page.contains("Contact reaches to ±75°; it sticks within ±40°."));
    assert!(page.contains("The largest pressure is 14504 psi (1.00 σ_b) at φ = 0°."));
    assert!(page.contains("3 steps of rising load") && page.contains("1 of falling load"));
}
