//! Figures of Post & Reddy (1988).

use approx::assert_abs_diff_eq;
use stickslip_laminate::{Curvature, Laminate, Ply, PlyConstants, Strengths};

fn quasi_isotropic(e1: f64, e2: f64, g12: f64) -> Laminate {
    let constants = PlyConstants {
        e1,
        e2,
        g12,
        nu12: 0.28,
        alpha1: 0.0,
        alpha2: 0.0,
        thickness: 0.005,
    };
    let ply = Ply::new("carbon", constants, Strengths::default()).unwrap();
    Laminate::new(&"(0₂/60₂/−60₂)s".parse().unwrap(), &ply).unwrap()
}

#[test]
fn back_calculated_ply_has_the_moduli_of_the_report() {
    let moduli = quasi_isotropic(19_585.0, 1_500.0, 847.0).membrane_moduli(Curvature::Suppressed);
    // The report prints three digits.
    assert_abs_diff_eq!(moduli.ex, 7_720.0, epsilon = 5.0);
    assert_abs_diff_eq!(moduli.gxy, 2_970.0, epsilon = 5.0);
    assert_abs_diff_eq!(moduli.nuxy, 0.30, epsilon = 0.005);
}

#[test]
fn textbook_ply_is_stiffer_than_the_report_says() {
    // T300/5208 (Tsai & Hahn 1980) [GPa]; 1e6 psi = 6.894757 GPa.
    let moduli = quasi_isotropic(181.0, 10.3, 7.17).membrane_moduli(Curvature::Suppressed);
    assert_abs_diff_eq!(moduli.ex / 6.894_757, 10.1, epsilon = 0.05);
    // Tsai & Hahn give 69.68 GPa and 26.88 GPa for the quasi-isotropic laminate.
    assert_abs_diff_eq!(moduli.ex, 69.68, epsilon = 0.01);
    assert_abs_diff_eq!(moduli.gxy, 26.88, epsilon = 0.01);
}
