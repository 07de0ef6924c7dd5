//! What the edge of a laminate offers to friction: the shares of its plies, and the fibre-coverage law made of them.

use stickslip_friction::{FibreCoverage, FrictionError, FrictionLaw, Kernel, PlyFraction};

use super::Laminate;

impl Laminate {
    /// Computes the fraction of the thickness per fibre angle, in the form that the law [`FibreCoverage`] takes: angles in radians in
    /// (−π/2, π/2], in the order of first appearance from the bottom, fractions summing to 1.
    pub fn ply_fractions(&self) -> Vec<PlyFraction> {
        let mut angles: Vec<(f64, f64)> = Vec::new();
        for layer in &self.layers {
            // A fibre has no head and tail.
            let turned = layer.angle.rem_euclid(180.0);
            let angle = if turned > 90.0 {
                turned - 180.0
            } else {
                turned
            };
            let thickness = layer.ply.thickness();
            match angles.iter_mut().find(|(known, _)| *known == angle) {
                Some((_, sum)) => *sum += thickness,
                None => angles.push((angle, thickness)),
            }
        }
        let fraction = |(angle, thickness): (f64, f64)| PlyFraction {
            angle: angle.to_radians(),
            fraction: (thickness / self.thickness).min(1.0),
        };
        angles.into_iter().map(fraction).collect()
    }

    /// Makes the fibre-coverage friction on this laminate's edges: `fibre` where fibres are bare and `matrix` elsewhere. With the lay-up,
    /// the volume fraction `fibre_fraction` (dimensionless), the kernel and the two laws are all that it asks for.
    ///
    /// # Errors
    /// As [`FibreCoverage::new`].
    pub fn fibre_coverage(
        &self,
        fibre_fraction: f64,
        kernel: Kernel,
        fibre: Box<dyn FrictionLaw>,
        matrix: Box<dyn FrictionLaw>,
    ) -> Result<FibreCoverage, FrictionError> {
        FibreCoverage::new(self.ply_fractions(), fibre_fraction, kernel, fibre, matrix)
    }
}
