//! Rigid pin in an infinite plate: stresses at the hole edge every 5°, over the bearing stress P/(2Rt) at full load.
//!
//! The tables and where they come from are described in `data/README.md`.

use crate::error::LaboratoryError;

/// Average bearing stress P/(2Rt) at full load `[MPa]`: 81.9 ksi. All stresses are divided by it.
pub const BEARING: f64 = 81.9 * 6.894757293168361;

/// Orthotropic plate, μ = 0.2.
pub const ORTHOTROPIC: &str = include_str!("../../data/rigid-pin-orthotropic-mu-0.2.csv");
/// Largest −σ_r over the bearing stress and end of contact `[deg]` of [`ORTHOTROPIC`], from the same solution at spacing 0.125°.
pub const ORTHOTROPIC_PEAK: f64 = 1.14146;
/// End of contact `[deg]` of [`ORTHOTROPIC`], as [`ORTHOTROPIC_PEAK`].
pub const ORTHOTROPIC_END: f64 = 84.56;

/// One line of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint {
    /// Angle from the bearing point `[deg]`.
    pub angle: f64,
    /// σ_r, σ_θ, τ_rθ over the bearing stress P/(2 R t) `[1]`.
    pub stresses: [f64; 3],
    /// Estimated error of each `[1]`.
    pub errors: [f64; 3],
}

/// The lines of a table.
///
/// # Errors
/// [`LaboratoryError::Missing`] for a line that does not read.
pub fn points(table: &str) -> Result<Vec<EdgePoint>, LaboratoryError> {
    let lines = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            let number = |k: usize| fields.get(k)?.trim().parse::<f64>().ok();
            let three =
                |first: usize| Some([number(first)?, number(first + 1)?, number(first + 2)?]);
            number(0)
                .zip(three(1).zip(three(5)))
                .map(|(angle, (stresses, errors))| EdgePoint {
                    angle,
                    stresses,
                    errors,
                })
                .ok_or_else(|| {
                    LaboratoryError::Missing(format!("a line of a table is broken: {line}"))
                })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};

    use super::*;

    #[test]
    fn every_table_reads() {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
        let files = fs::read_dir(data).unwrap().map(|file| file.unwrap().path());
        let own = |path: &PathBuf| path.to_string_lossy().contains("rigid-pin-");
        let tables: Vec<PathBuf> = files.filter(own).collect();
        assert_eq!(tables.len(), 7);
        for table in tables {
            let table = fs::read_to_string(table).unwrap();
            let points = points(&table).unwrap();
            assert_eq!(points.len(), 37);
            assert_eq!((points[0].angle, points[36].angle), (0.0, 180.0));
        }
        assert!(points("head\n1,2").is_err());
    }

    #[test]
    fn the_peak_lies_above_all_stations() {
        let highest = points(ORTHOTROPIC).unwrap();
        let highest = highest.iter().map(|s| -s.stresses[0]).fold(0.0, f64::max);
        assert!((0.0..0.01).contains(&(ORTHOTROPIC_PEAK - highest)));
    }
}
