//! Whether the mesh of the model resolves what one law explains more than another.
//!
//! ```text
//! e = u_A − u_B on the mesh twice as coarse,     gain = (r_B · e)² / |e|²,  r_B · e > 0:     χ²(B) − min over c of χ²(B + c e)
//! ```
//!
//! A law A with more parameters than B may fit better by the displacements of single contact points, such as the peak of shear where
//! static friction lets go. These have no length of their own and change with the mesh. What A explains of the data by
//! displacements that both meshes show is the gain above; it is compared with the criteria's penalty for A's further parameters. No
//! such comparison is needed where χ² rejects only one of the two laws.

use stickslip_hybrid::calibrate::Data;

use super::comparison::Fit;
use super::verdict::DECIDES;

/// Predictions of the fitted laws on both meshes.
pub(super) struct Resolved<'a> {
    data: &'a Data,
    laws: Vec<Law>,
}

struct Law {
    /// AICc less χ² over its inflation.
    penalty: f64,
    inflation: f64,
    /// Whether χ² accepts it.
    explains: bool,
    /// Displacements at all data on the model's mesh.
    fine: Vec<f64>,
    /// And on the coarser one, none where its polygon does not reach; none at all where it has no solution.
    coarse: Option<Vec<Option<f64>>>,
}

/// Displacements at all data on the model's mesh, and on the coarser one, as in [`Law`].
pub(super) type OnBothMeshes = (Vec<f64>, Option<Vec<Option<f64>>>);

impl<'a> Resolved<'a> {
    /// `meshes`: displacements of each of `fits` on the model's mesh and on the coarser one.
    pub(super) fn new(data: &'a Data, fits: &[Fit], meshes: Vec<OnBothMeshes>) -> Self {
        let law = |(fit, (fine, coarse)): (&Fit, OnBothMeshes)| {
            let own = &fit.calibration;
            let inflation = own.correlation.inflation;
            Law {
                penalty: own.aicc() - own.chi_squared / inflation,
                inflation,
                explains: fit.explains(),
                fine,
                coarse,
            }
        };
        Self {
            data,
            laws: fits.iter().zip(meshes).map(law).collect(),
        }
    }

    /// Whether the data prefer law `complex` to `simple` by what the coarser mesh shows as well.
    pub(super) fn prefers(&self, complex: usize, simple: usize) -> bool {
        let [a, b] = [complex, simple].map(|law| &self.laws[law]);
        if a.explains && !b.explains {
            return true;
        }
        let needed = DECIDES + a.penalty - b.penalty;
        // A criterion without a finite value prefers nothing.
        needed.is_finite() && self.gain(a, b) / b.inflation >= needed
    }

    /// By how much χ² of `b` falls with what the coarser mesh shows of its difference to `a`, in any positive amount.
    fn gain(&self, a: &Law, b: &Law) -> f64 {
        let (Some(of_a), Some(of_b)) = (&a.coarse, &b.coarse) else {
            return 0.0;
        };
        let both = of_a.iter().zip(of_b).zip(&b.fine);
        let moved: Vec<f64> = both
            .map(|((a, b), fine)| fine + a.zip(*b).map_or(0.0, |(a, b)| a - b))
            .collect();
        let left = self.data.residual(&b.fine);
        let change: Vec<f64> = (left.iter().zip(self.data.residual(&moved)))
            .map(|(before, after)| before - after)
            .collect();
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
        let (along, size) = (dot(&left, &change), dot(&change, &change));
        if along > 0.0 {
            along * along / size
        } else {
            0.0
        }
    }
}
