//! What is varied.

use super::case::{ALUMINIUM, CLEARANCE, Case, Plate};

/// Loading to 1500 lb and unloading, finer than the report's steps: shear that sticks keeps the marks of long steps.
pub(crate) const LOADING: [f64; 18] = [
    20.0, 40.0, 70.0, 100.0, 150.0, 200.0, 250.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0, 900.0,
    1050.0, 1200.0, 1350.0, 1500.0,
];
const UNLOADING: [f64; 8] = [1350.0, 1200.0, 900.0, 700.0, 400.0, 200.0, 100.0, 20.0];
/// Unloading to 300 lb and loading again.
const AGAIN: [f64; 15] = [
    1300.0, 1100.0, 900.0, 700.0, 500.0, 300.0, 350.0, 400.0, 450.0, 500.0, 600.0, 750.0, 900.0,
    1200.0, 1500.0,
];
/// The law that charts show first: the scene's.
pub(crate) const USUAL: &str = "coulomb = { mu = 0.2 }";
/// Equal parts of 0°, 60° and −60°, for a plate that has no plies of its own.
const THIRDS: &str = "plies = [{ angle = \"0 deg\", fraction = 0.3333333333333333 }, { angle = \"60 deg\", fraction = 0.3333333333333333 }, \
                      { angle = \"-60 deg\", fraction = 0.3333333333333334 }]";

/// Young's modulus of a pin that is practically rigid `[ksi]`.
const RIGID: f64 = 1e7;

/// Names of the families, in the order of tables.
pub(crate) const COULOMB: &str = "Coulomb";
pub(crate) const DROPPING: &str = "static and dynamic";
pub(crate) const POWER: &str = "power laws";
pub(crate) const SWEPT: &str = "fibre coverage, swept";
pub(crate) const TANGENT: &str = "fibre coverage, tangent";
pub(crate) const LAYUPS: &str = "other lay-ups";
pub(crate) const FITS: &str = "clearance and pin";
pub(crate) const RELOADED: &str = "loaded again";

/// Values of a study.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) cases: Vec<Case>,
    /// Radial clearances `[in]`, Young's moduli of pins `[ksi]` and coefficients of friction of [`FITS`].
    pub(crate) clearances: &'static [f64],
    pub(crate) pins: &'static [f64],
    pub(crate) frictions: &'static [f64],
    /// Spacing of corner nodes `[degree]`.
    pub(crate) spacing: f64,
}

/// Values that a quick plan has fewer of.
struct Values {
    coulomb: &'static [f64],
    fibre_and_matrix: &'static [[f64; 2]],
    fractions: &'static [f64],
    kappas: &'static [f64],
    widths: &'static [f64],
    layups: &'static [&'static str],
    plates: &'static [Plate],
}

impl Plan {
    pub(crate) fn full() -> Self {
        Self::of(
            &Values {
                coulomb: &[0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6],
                fibre_and_matrix: &[[0.1, 0.4], [0.4, 0.1], [0.0, 0.6], [0.6, 0.0], [0.05, 0.2]],
                fractions: &[0.4, 0.6, 0.8],
                kappas: &[0.3, 1.0, 3.0],
                widths: &[5.0, 15.0, 30.0],
                layups: &[
                    "[0_12]",
                    "[90_12]",
                    "[0_5/90]s",
                    "[0/90_5]s",
                    "[±45]_3s",
                    "[±30]_3s",
                ],
                plates: &[Plate::Plies, Plate::Smeared],
            },
            &[0.0, 0.0002, CLEARANCE, 0.001, 0.002, 0.005],
            &[2_000.0, ALUMINIUM, 30_000.0, 100_000.0, RIGID],
            &[0.05, 0.2, 0.4],
            1.125,
        )
    }

    pub(crate) fn quick() -> Self {
        Self::of(
            &Values {
                coulomb: &[0.0, 0.2, 0.6],
                fibre_and_matrix: &[[0.1, 0.4], [0.0, 0.6]],
                fractions: &[0.6],
                kappas: &[1.0],
                widths: &[5.0],
                layups: &["[0_5/90]s", "[±45]_3s"],
                plates: &[Plate::Plies],
            },
            &[0.0, CLEARANCE, 0.002],
            &[ALUMINIUM, RIGID],
            &[0.2],
            4.5,
        )
    }

    fn of(
        values: &Values,
        clearances: &'static [f64],
        pins: &'static [f64],
        frictions: &'static [f64],
        spacing: f64,
    ) -> Self {
        let mut cases = Vec::new();
        for &plate in values.plates {
            cases.extend(
                laws(values, plate)
                    .into_iter()
                    .map(|case| Case { plate, ..case }),
            );
        }
        cases.extend(layups(values.layups));
        for &pin in pins {
            for &clearance in clearances {
                for &mu in frictions {
                    cases.push(Case {
                        clearance,
                        pin,
                        ..Case::new(
                            FITS,
                            &fit_name(mu, pin, clearance),
                            &coulomb(mu),
                            &history(),
                        )
                    });
                }
            }
        }
        cases.extend(reloaded());
        Self {
            cases,
            clearances,
            pins,
            frictions,
            spacing,
        }
    }
}

/// All laws over their parameters.
fn laws(values: &Values, plate: Plate) -> Vec<Case> {
    let history = history();
    let case = |family, name: &str, law: &str| Case::new(family, name, law, &history);
    let mut cases = Vec::new();
    for &mu in values.coulomb {
        cases.push(case(COULOMB, &format!("μ = {mu}"), &coulomb(mu)));
    }
    for (high, low) in [(0.2, 0.1), (0.35, 0.25), (0.4, 0.2), (0.6, 0.3), (0.6, 0.1)] {
        for transition in ["drop", "lagged"] {
            let law = format!(
                "static_dynamic = {{ static = {high}, dynamic = {low}, transition = \"{transition}\" }}"
            );
            cases.push(case(
                DROPPING,
                &format!("{high} and {low}, {transition}"),
                &law,
            ));
        }
    }
    for scale in ["1e-5", "1e-4", "1e-3"] {
        for path in ["committed", "current"] {
            let law = format!(
                "slip_power = {{ static = 0.4, dynamic = 0.1, slip_scale = \"{scale} in\", exponent = 1.0, path = \"{path}\" }}"
            );
            cases.push(case(
                POWER,
                &format!("of slip, 0.4 to 0.1 over {scale} in, {path}"),
                &law,
            ));
        }
    }
    for exponent in [0.5, 0.8] {
        let law = format!(
            "pressure_power = {{ mu = 0.2, reference_pressure = \"10 ksi\", exponent = {exponent} }}"
        );
        cases.push(case(
            POWER,
            &format!("of pressure, exponent {exponent}"),
            &law,
        ));
    }
    for &[fibre, matrix] in values.fibre_and_matrix {
        for &fraction in values.fractions {
            let named =
                |kernel: String| format!("{kernel}, V = {fraction}, μ = {fibre} | {matrix}");
            for &kappa in values.kappas {
                let law = coverage(
                    fraction,
                    &format!("swept = {{ kappa = {kappa} }}"),
                    [fibre, matrix],
                    plate,
                );
                cases.push(case(SWEPT, &named(format!("κ = {kappa}")), &law));
            }
            for &width in values.widths {
                let law = coverage(
                    fraction,
                    &format!("tangent = {{ width = \"{width} deg\" }}"),
                    [fibre, matrix],
                    plate,
                );
                cases.push(case(TANGENT, &named(format!("ψ = {width}°")), &law));
            }
        }
    }
    cases
}

fn layups(layups: &[&'static str]) -> Vec<Case> {
    let laws = [
        ("Coulomb, μ = 0.2", USUAL.to_owned()),
        ("Coulomb, μ = 0.4", coulomb(0.4)),
        (
            "coverage, tangent, ψ = 15°, V = 0.6, μ = 0.1 | 0.4",
            usual_coverage(),
        ),
    ];
    let all = layups
        .iter()
        .flat_map(|&layup| laws.iter().map(move |law| (layup, law)));
    all.map(|(layup, (name, law))| Case {
        plate: Plate::Layup(layup),
        ..Case::new(LAYUPS, &format!("{layup}, {name}"), law, &history())
    })
    .collect()
}

fn reloaded() -> Vec<Case> {
    let history: Vec<f64> = LOADING.into_iter().chain(AGAIN).collect();
    let mut cases: Vec<Case> = [0.1, 0.2, 0.4]
        .into_iter()
        .map(|mu| {
            Case::new(
                RELOADED,
                &format!("Coulomb, μ = {mu}"),
                &coulomb(mu),
                &history,
            )
        })
        .collect();
    let name = "coverage, tangent, ψ = 15°, V = 0.6, μ = 0.1 | 0.4";
    cases.push(Case::new(RELOADED, name, &usual_coverage(), &history));
    cases
}

fn history() -> Vec<f64> {
    LOADING.into_iter().chain(UNLOADING).collect()
}

/// Name of a case of [`FITS`].
pub(crate) fn fit_name(mu: f64, pin: f64, clearance: f64) -> String {
    format!("μ = {mu}, {}, clearance {clearance} in", pin_name(pin))
}

/// A pin by its Young's modulus `[ksi]`.
pub(crate) fn pin_name(pin: f64) -> String {
    if pin >= RIGID {
        "rigid pin".to_owned()
    } else if pin == ALUMINIUM {
        "aluminium pin".to_owned()
    } else {
        format!("pin of {pin} ksi")
    }
}

pub(crate) fn coulomb(mu: f64) -> String {
    format!("coulomb = {{ mu = {mu} }}")
}

/// The law of fibre coverage of the scene.
pub(crate) fn usual_coverage() -> String {
    coverage(
        0.6,
        "tangent = { width = \"15 deg\" }",
        [0.1, 0.4],
        Plate::Plies,
    )
}

fn coverage(fraction: f64, kernel: &str, [fibre, matrix]: [f64; 2], plate: Plate) -> String {
    let plies = match plate {
        Plate::Smeared => format!("{THIRDS}, "),
        Plate::Plies | Plate::Layup(_) => String::new(),
    };
    format!(
        "fibre_coverage = {{ {plies}fibre_fraction = {fraction}, kernel = {{ {kernel} }}, fibre = {{ coulomb = {{ mu = {fibre} }} }}, \
         matrix = {{ coulomb = {{ mu = {matrix} }} }} }}"
    )
}
