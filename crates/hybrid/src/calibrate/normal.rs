//! Quantiles of the normal distribution.

/// The z for which a standard normal number lies within ±z with the probability `confidence`, between 0 and 1, by the rational
/// approximation of Acklam (2003), whose relative error is below 1.2e-9.
pub fn two_sided_quantile(confidence: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 6] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
        1.0,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 5] = [
        7.784_695_709_041_462e-3,
        3.224_671_290_700_398e-1,
        2.445_134_137_142_996,
        3.754_408_661_907_416,
        1.0,
    ];
    const TAIL: f64 = 0.024_25;
    let polynomial = |terms: &[f64], x: f64| terms.iter().fold(0.0, |sum, term| sum * x + term);
    let upper = 0.5 * (1.0 - confidence);
    if upper < TAIL {
        let q = (-2.0 * upper.ln()).sqrt();
        return -polynomial(&C, q) / polynomial(&D, q);
    }
    let q = 0.5 * confidence;
    polynomial(&A, q * q) * q / polynomial(&B, q * q)
}

#[cfg(test)]
mod tests {
    use super::two_sided_quantile;

    #[test]
    fn quantiles_are_those_of_tables() {
        // Abramowitz & Stegun (1964), Table 26.6; the square of the 95 % quantile is that of χ² with one degree of freedom.
        for (confidence, quantile) in [
            (0.5, 0.674_489_75),
            (0.9, 1.644_853_63),
            (0.95, 1.959_963_98),
            (0.99, 2.575_829_30),
            (0.999, 3.290_526_73),
        ] {
            assert!((two_sided_quantile(confidence) - quantile).abs() < 1e-8);
        }
    }
}
