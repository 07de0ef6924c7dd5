//! How near to the hole's edge pictures are believed.

use super::{FRINGES, SCENE, folder_with, numbers, succeeds};

#[test]
fn a_phase_that_mixes_both_sides_of_the_edge_is_left_out_unless_a_margin_is_stated() {
    let text = format!("{FRINGES}[[states]]\nname = \"up\"\nstep = 2\n");
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", &text)]);
    // Radius of the hole 5 mm, pixels of 0.04 mm; carrier of 6 fringes/mm, of which the band is three quarters.
    let nearest = |more: &[&str]| {
        let arguments = [&["reduce", "e.toml", "--force"], more].concat();
        succeeds(folder.path(), &arguments);
        let rows = numbers(&folder.path().join("e-results/measured-up.csv"));
        let valid = rows.iter().filter(|row| row[2].is_finite());
        valid
            .map(|row| row[0].hypot(row[1]) - 5.0)
            .fold(f64::INFINITY, f64::min)
    };
    let resolved = nearest(&[]);
    let stated = nearest(&["--set", "reduce.margin=0 mm"]);
    let four = nearest(&["--set", "fringes.pictures=four"]);
    println!("nearest datum to the edge: {resolved:.3}, {stated:.3} and {four:.3} mm");
    assert!(resolved > 0.5 / (0.75 * 6.0) * 0.99, "{resolved}");
    assert!(stated < 0.06 && four < 0.06, "{stated} {four}");
}
