//! `report.html`.

use std::fs;

use super::files::written;
use super::fixture::results;

#[test]
fn the_page_holds_everything_and_escapes_it() {
    let (_place, folder) = written(&results(), true);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("A &lt;plate&gt; &amp; its pin") && !page.contains("A <plate>"));
    let parts = [
        "plate.toml",
        "4 load steps",
        "The answer is not unique in load step 3: up to 1 contact points stick",
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

#[test]
fn captions_say_the_numbers() {
    let (_place, folder) = written(&results(), true);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    // 4000 N on 20 mm × 2 mm: σ_b = 100 MPa = 14504 psi.
    assert!(page.contains("Contact reaches to ±75°; it sticks within ±40°."));
    assert!(page.contains("The largest pressure is 14504 psi (1.00 σ_b) at φ = 0°."));
    assert!(
        page.contains(
            "3 steps of rising load (blue, solid) and 1 of falling load (orange, dashed)"
        )
    );
}
