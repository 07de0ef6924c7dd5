//! Bounds that are not proportional to pressure.

use std::sync::Arc;

use approx::assert_abs_diff_eq;
use stickslip_contact::Status;
use stickslip_friction::PressurePower;

use super::{CONVERGED, every_solver, follow, problem, root};

/// K(n, t) = [[2, −1], [−1, 3]]: with u_n = 0 and u_t = v, λ_n = −v − F_n and 3 v + F(λ_n) = F_t.
#[test]
fn bound_that_is_not_proportional_to_pressure() {
    let bound = |pressure: f64| 0.4 * pressure.powf(0.6);
    let law = Arc::new(PressurePower::new(0.4, 1.0, 0.6).unwrap());
    let problem = problem(&[&[2.0, -1.0], &[-1.0, 3.0]], law);
    let (press, pull) = (-2.0, 2.0);
    let slip = root(|v| 3.0 * v + bound(-v - press) - pull, 0.0, 1.0);
    for solver in every_solver() {
        let records = follow(&problem, &*solver, &[&[press, pull]]);
        let state = &records[0].state;
        assert_eq!(state.status, [Status::SlipPositive]);
        assert_abs_diff_eq!(state.tangential_displacement(0), slip, epsilon = CONVERGED);
        assert_abs_diff_eq!(state.normal_force(0), -slip - press, epsilon = CONVERGED);
        assert_abs_diff_eq!(
            state.tangential_force(0),
            -bound(-slip - press),
            epsilon = CONVERGED
        );
    }
}

/// At small pressure μ(p) = μ₀ (p/p₀)^(m−1) is large: 0.3 carries a shear of 0.48 where Coulomb's law with μ₀ carries 0.12.
#[test]
fn light_pressure_sticks_under_the_power_law() {
    let law = Arc::new(PressurePower::new(0.4, 10.0, 0.5).unwrap());
    let problem = problem(&[&[1.0, 0.0], &[0.0, 1.0]], law);
    let bound = 4.0 * (0.03_f64).sqrt();
    for solver in every_solver() {
        let records = follow(
            &problem,
            &*solver,
            &[&[-0.3, bound - 0.01], &[-0.3, bound + 0.01]],
        );
        assert_eq!(records[0].state.status, [Status::Stick]);
        assert_eq!(records[1].state.status, [Status::SlipPositive]);
        assert_abs_diff_eq!(
            records[1].state.tangential_displacement(0),
            0.01,
            epsilon = CONVERGED
        );
    }
}
