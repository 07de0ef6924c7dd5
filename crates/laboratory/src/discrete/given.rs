//! A body given by its numbers instead of a mesh.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;

/// Compliance, rigid motions and loads as they stand in the equation of an
/// [`InterfaceOperator`]. Points lie on the y axis, one apart.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenBody {
    points: Vec<[f64; 2]>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    responses: Vec<DVector<f64>>,
    mode_loads: Vec<DVector<f64>>,
}

impl GivenBody {
    /// A held body with compliance `compliance` `[length/force]`, 2n × 2n, and `responses[k]` `[length]` the motion of its
    /// points by load case `k`, 2n.
    pub fn held(compliance: DMatrix<f64>, responses: Vec<DVector<f64>>) -> Self {
        let modes = DMatrix::zeros(compliance.nrows(), 0);
        let mode_loads = vec![DVector::zeros(0); responses.len()];
        Self::floating(compliance, modes, responses, mode_loads)
    }

    /// A body that floats along `modes`, 2n × m, with `mode_loads[k]` `[force]` the resultants of load case `k` in them, m.
    pub fn floating(
        compliance: DMatrix<f64>,
        modes: DMatrix<f64>,
        responses: Vec<DVector<f64>>,
        mode_loads: Vec<DVector<f64>>,
    ) -> Self {
        let points = (0..compliance.nrows() / 2)
            .map(|k| [0.0, k as f64])
            .collect();
        Self {
            points,
            compliance,
            modes,
            responses,
            mode_loads,
        }
    }
}

impl InterfaceOperator for GivenBody {
    fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        Some(&self.compliance)
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.responses.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        Some(&self.responses[case])
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
