//! Elastic–plastic plies with Tsai–Hill as yield function.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip_fem_core::material::{apply, rotated_stiffness, rotated_strain};
use stickslip_laminate::failure::TsaiHill;
use stickslip_laminate::progressive::{TsaiHillPlasticity, YieldSurface};
use stickslip_laminate::{
    FailureCriterion, Ply, PlyLoading, PointHistory, PointModel, PointState, Strengths,
};

use crate::{STRENGTHS, assert_matrix, assert_vector, laminate, ply, ply_with};

/// Plastic modulus across the fibres of 200 ksi, a tenth of the elastic one: H Y² for the tensile strength.
const HARDENING: f64 = 200.0 / (10.1 * 10.1);

fn surface(hardening: f64) -> YieldSurface {
    YieldSurface::new(&ply(), hardening).unwrap()
}

/// The elastic strain of a stress.
fn strain_of(stress: [f64; 3]) -> [f64; 3] {
    apply(ply().compliance(), stress)
}

#[test]
fn uniaxial_and_biaxial_yield_are_exact() {
    let surface = surface(0.0);
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let uniaxial = [
        [xt, 0.0, 0.0],
        [-xc, 0.0, 0.0],
        [0.0, yt, 0.0],
        [0.0, -yc, 0.0],
        [0.0, 0.0, s],
    ];
    let biaxial = [[xt, yt, 0.0], [-xc, yt, s], [xt, -yc, -s], [-xc, -yc, 3.0]];
    for direction in uniaxial.into_iter().chain(biaxial) {
        let yield_stress = direction.map(|component| component / surface.value(direction));
        let step = |factor: f64| {
            surface
                .closest_point(strain_of(yield_stress.map(|c| factor * c)), 0.0)
                .unwrap()
        };
        assert!(step(1.0 - 1e-8).residuals.is_empty());
        let beyond = step(1.0 + 1e-8);
        assert!(!beyond.residuals.is_empty() && beyond.hardening_increment > 0.0);
        assert_vector(&beyond.stress, &yield_stress, 1e-8);
        // Far outside, the stress is still on the surface to rounding.
        assert_relative_eq!(surface.value(step(20.0).stress), 1.0, max_relative = 1e-12);
    }
    for strength in uniaxial {
        assert_relative_eq!(surface.value(strength), 1.0, max_relative = 1e-14);
    }
}

#[test]
fn the_surface_is_tsai_hill_up_to_the_interaction() {
    // X_t = X_c: the same. Otherwise, with u = σ₁/X, v = σ₂/Y and ρ = Y/X: the difference is ρ |1 − X²/(X_t X_c)| |uv|, the index at
    // least u² + v² − ρ |uv| ≥ (2 − ρ) |uv|.
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let equal = ply_with(Strengths::in_plane(xt, xt, yt, yc, s));
    for stress in [
        [100.0, 5.0, 6.0],
        [-100.0, 5.0, 6.0],
        [-150.0, -12.0, 4.0],
        [120.0, -12.0, 1.0],
    ] {
        let hill = |ply: &Ply| {
            TsaiHill
                .assess(ply, &PlyLoading::mechanical(stress))
                .unwrap()
                .index
        };
        let same = YieldSurface::new(&equal, 0.0).unwrap().value(stress);
        assert_relative_eq!(same * same, hill(&equal), max_relative = 1e-13);
        let value = surface(0.0).value(stress);
        let x = if stress[0] > 0.0 { xt } else { xc };
        let difference = (1.0 / (x * x) - 1.0 / (xt * xc)) * stress[0] * stress[1];
        assert_relative_eq!(
            value * value,
            hill(&ply()) + difference,
            max_relative = 1e-13
        );
        let ratio = if stress[1] > 0.0 { yt / x } else { yc / x };
        let bound = ratio / (2.0 - ratio) * (1.0 - x * x / (xt * xc)).abs();
        assert!(difference.abs() <= bound * hill(&ply()) && bound < 0.007);
    }
}

#[test]
fn uniaxial_hardening_in_closed_form() {
    // σ₂ = Y (1 + H λ), ε₂ = σ₂/E₂ + λ/Y, ε₁ = −ν₁₂ σ₂/E₁ − λ Y/(2 X_t X_c): one step and many end at the same place.
    let [xt, xc, yt, ..] = STRENGTHS;
    let surface = surface(HARDENING);
    let strain = |lambda: f64| {
        let elastic = strain_of([0.0, yt * (1.0 + HARDENING * lambda), 0.0]);
        let plastic = [-0.5 * lambda * yt / (xt * xc), lambda / yt, 0.0];
        (elastic, plastic)
    };
    for steps in [1, 10] {
        let (mut plastic, mut hardening, mut stress) = ([0.0; 3], 0.0, [0.0; 3]);
        for step in 1..=steps {
            let (elastic, total_plastic) = strain(0.05 * f64::from(step) / f64::from(steps));
            let trial = [0, 1, 2].map(|i| elastic[i] + total_plastic[i] - plastic[i]);
            let end = surface.closest_point(trial, hardening).unwrap();
            plastic = [0, 1, 2].map(|i| plastic[i] + end.plastic_increment[i]);
            hardening += end.hardening_increment;
            stress = end.stress;
        }
        assert_relative_eq!(hardening, 0.05, max_relative = 1e-11);
        assert_vector(&stress, &[0.0, yt * (1.0 + HARDENING * 0.05), 0.0], 1e-11);
        assert_vector(&plastic, &strain(0.05).1, 1e-11);
    }
}

#[test]
fn return_mapping_converges_quadratically() {
    for (hardening, stress) in [
        (0.0, [300.0, 40.0, 30.0]),
        (HARDENING, [-150.0, 40.0, 60.0]),
        (HARDENING, [100.0, -80.0, 5.0]),
    ] {
        let residuals = surface(hardening)
            .closest_point(strain_of(stress), 0.0)
            .unwrap()
            .residuals;
        assert!(
            residuals.len() >= 3 && residuals.len() <= 9,
            "{residuals:?}"
        );
        for pair in residuals.windows(2).filter(|pair| pair[0] < 0.3) {
            assert!(pair[1] < pair[0] * pair[0] + 1e-14, "{residuals:?}");
        }
    }
}

#[test]
fn tangent_of_a_ply_to_eight_digits() {
    // Central differences over h err by about (h/ε_y)² = 1e-8 here, and by the rounding 1e-14/h of the stress.
    let h = 1e-6;
    for (hardening, stress) in [
        (0.0, [300.0, 40.0, 30.0]),
        (HARDENING, [-150.0, 40.0, 60.0]),
        (HARDENING, [100.0, -80.0, 5.0]),
    ] {
        let surface = surface(hardening);
        let trial = strain_of(stress);
        let end = surface.closest_point(trial, 0.3).unwrap();
        let column = |j: usize| {
            let at = |step: f64| {
                let mut moved = trial;
                moved[j] += step;
                surface.closest_point(moved, 0.3).unwrap().stress
            };
            let (left, right) = (at(-h), at(h));
            [0, 1, 2].map(|i| (right[i] - left[i]) / (2.0 * h))
        };
        let columns = [0, 1, 2].map(column);
        let difference = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
        assert_matrix(&end.tangent, &difference, 1e-8);
        assert!(end.tangent[1][1] < 0.9 * ply().stiffness()[1][1]);
    }
}

/// Through `path` in `steps` steps each leg; the state and the work done, by the trapezoidal rule.
fn walk(model: &dyn PointModel, path: &[[f64; 3]], steps: usize) -> (PointState, f64) {
    let mut history = PointHistory::new(model.initial_state());
    let (mut work, mut stress) = (0.0, [0.0; 3]);
    for &target in path {
        let from = history.committed().strain;
        for step in 1..=steps {
            let share = step as f64 / steps as f64;
            let strain = [0, 1, 2].map(|i| from[i] + share * (target[i] - from[i]));
            let response = model.respond(history.committed(), strain, 0.0).unwrap();
            let before = history.committed().strain;
            work += (0..3)
                .map(|i| 0.5 * (stress[i] + response.stress[i]) * (strain[i] - before[i]))
                .sum::<f64>();
            stress = response.stress;
            history.commit(response.trial);
        }
    }
    (history.committed().clone(), work)
}

const PATH: [[f64; 3]; 3] = [[0.01, 0.0, 0.004], [0.012, 0.006, -0.01], [-0.01, 0.0, 0.0]];

#[test]
fn halving_the_step_halves_the_error() {
    let model = TsaiHillPlasticity::new(laminate("[0/±45/90]s"), HARDENING).unwrap();
    let (exact, _) = walk(&model, &PATH, 8000);
    let error = |steps| {
        let (state, _) = walk(&model, &PATH, steps);
        let square = |(a, b): (&_, &_)| -> f64 {
            let (a, b): (
                &stickslip_laminate::progressive::LayerState,
                &stickslip_laminate::progressive::LayerState,
            ) = (a, b);
            (0..3).map(|i| (a.stress[i] - b.stress[i]).powi(2)).sum()
        };
        state
            .layers
            .iter()
            .zip(&exact.layers)
            .map(square)
            .sum::<f64>()
            .sqrt()
    };
    let errors = [20, 40, 80, 160].map(error);
    // First order: a factor of 2, or more where the error happens to change sign.
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.65 * pair[0], "{errors:?}");
    }
    assert!(errors[0] < 10.0, "{errors:?}");
}

#[test]
fn work_is_stored_or_dissipated() {
    let model = TsaiHillPlasticity::new(laminate("[0/±45/90]s"), 0.0).unwrap();
    let error = |steps| {
        let (state, work) = walk(&model, &PATH, steps);
        (work - state.stored - state.dissipated).abs() / state.dissipated
    };
    let errors = [50, 100, 200].map(error);
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.6 * pair[0], "{errors:?}");
    }
    assert!(errors[2] < 0.02, "{errors:?}");
}

#[test]
fn elastic_laminate_until_the_first_ply_yields_then_softer() {
    let model = TsaiHillPlasticity::new(laminate("[0/90]s"), 0.0).unwrap();
    let material = model
        .laminate()
        .stiffness()
        .membrane
        .map(|row| row.map(|a| a / model.laminate().thickness()));
    let small = model
        .respond(&model.initial_state(), [0.002, 0.0, 0.0], 0.0)
        .unwrap();
    assert_matrix(&small.tangent, &material, 1e-13);
    let large = model
        .respond(&model.initial_state(), [0.008, 0.0, 0.0], 0.0)
        .unwrap();
    assert!(large.tangent[0][0] < 0.95 * material[0][0] && large.trial.layers[1].hardening > 0.0);
    // Unloading is elastic again and leaves strain behind.
    let back = model.respond(&large.trial, [0.007, 0.0, 0.0], 0.0).unwrap();
    assert_matrix(&back.tangent, &material, 1e-13);
    assert_eq!(back.trial.dissipated, large.trial.dissipated);
}

fn strain(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-size..size)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn plastic_strain_is_normal_to_a_convex_surface(trial in strain(0.05), other in prop::array::uniform3(-1.0..1.0_f64)) {
        let surface = surface(0.0);
        let end = surface.closest_point(trial, 0.0).unwrap();
        let scaled = [other[0] * 240.0, other[1] * 20.0, other[2] * 17.0];
        let inside = scaled.map(|component| component / surface.value(scaled).max(1.0));
        // Largest plastic work (Hill): no admissible stress does more on the plastic strain.
        let excess: f64 = (0..3).map(|i| (end.stress[i] - inside[i]) * end.plastic_increment[i]).sum();
        prop_assert!(excess >= -1e-11);
        let elastic = strain_of(end.stress);
        for i in 0..3 {
            prop_assert!((elastic[i] + end.plastic_increment[i] - trial[i]).abs() < 1e-14);
        }
        prop_assert!(surface.value(end.stress) < 1.0 + 1e-11);
    }

    #[test]
    fn return_mapping_ends_on_the_surface_from_anywhere(
        direction in strain(1.0),
        exponent in -4.0..3.0_f64,
        hardening in prop_oneof![Just(0.0), Just(HARDENING), Just(1e3 * HARDENING)],
        before in 0.0..10.0_f64,
    ) {
        let surface = surface(hardening);
        let trial = direction.map(|component| component * 10.0_f64.powf(exponent));
        let end = surface.closest_point(trial, before).unwrap();
        let level = 1.0 + hardening * (before + end.hardening_increment);
        prop_assert!(surface.value(end.stress) <= level * (1.0 + 1e-10));
        prop_assert!(end.residuals.is_empty() || surface.value(end.stress) >= level * (1.0 - 1e-10));
        prop_assert!(end.residuals.len() < 30, "{:?}", end.residuals);
    }

    #[test]
    fn plastic_work_is_never_negative(path in prop::collection::vec(strain(0.03), 1..6), temperature in -300.0..0.0_f64) {
        let model = TsaiHillPlasticity::new(laminate("[0/±45/90]s"), HARDENING).unwrap();
        let mut state = model.initial_state();
        for strain in path {
            let next = model.respond(&state, strain, temperature).unwrap().trial;
            prop_assert!(next.dissipated >= state.dissipated);
            prop_assert!(next.stored >= 0.0);
            state = next;
        }
    }

    #[test]
    fn tangent_is_the_derivative(before in strain(0.02), after in strain(0.02), hardening in prop_oneof![Just(0.0), Just(HARDENING)]) {
        let model = TsaiHillPlasticity::new(laminate("[0/±45/90]s"), hardening).unwrap();
        let state = model.respond(&model.initial_state(), before, 0.0).unwrap().trial;
        let here = model.respond(&state, after, 0.0).unwrap();
        let h = 1e-7;
        let size = here.tangent[0][0] + here.tangent[1][1];
        for j in 0..3 {
            let side = |step: f64| {
                let mut moved = after;
                moved[j] += step;
                model.respond(&state, moved, 0.0).unwrap().stress
            };
            let (left, right) = (side(-h), side(h));
            for i in 0..3 {
                let one_sided = [(here.stress[i] - left[i]) / h, (right[i] - here.stress[i]) / h];
                // Where a ply just yields or changes quadrant there is no derivative.
                prop_assume!((one_sided[0] - one_sided[1]).abs() < 1e-4 * size);
                let difference = 0.5 * (one_sided[0] + one_sided[1]);
                prop_assert!((difference - here.tangent[i][j]).abs() < 1e-4 * size, "{difference} {:?}", here.tangent);
            }
        }
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            prop_assert!((here.tangent[i][j] - here.tangent[j][i]).abs() < 1e-12 * size);
        }
    }

    #[test]
    fn response_turns_with_plies_and_strain(turn in -90.0..90.0_f64, applied in strain(0.02)) {
        let plain = TsaiHillPlasticity::new(laminate("[0/±45/90]s"), HARDENING).unwrap();
        let layup = format!("[{}/{}/{}/{}]s", turn, turn + 45.0, turn - 45.0, turn + 90.0);
        let turned = TsaiHillPlasticity::new(laminate(&layup), HARDENING).unwrap();
        let (s, c) = turn.to_radians().sin_cos();
        let strain = rotated_strain(applied, [c, -s]);
        let a = plain.respond(&plain.initial_state(), applied, 0.0).unwrap();
        let b = turned.respond(&turned.initial_state(), strain, 0.0).unwrap();
        let expected = rotated_stiffness(&a.tangent, [c, -s]);
        let size = a.tangent[0][0] + a.tangent[1][1];
        for (x, y) in b.tangent.iter().flatten().zip(expected.iter().flatten()) {
            prop_assert!((x - y).abs() < 1e-8 * size);
        }
        prop_assert!((a.trial.dissipated - b.trial.dissipated).abs() <= 1e-10 * (1.0 + a.trial.dissipated));
    }
}
