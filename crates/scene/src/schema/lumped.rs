//! Formulas for the compliance of a whole fastener, bearing included `[length/force]`.
//!
//! Plate 1 is the first of a single lap or the middle one of a symmetric double lap, plate 2 the other or an outer one; thickness t, Young's moduli E and E_b of plates
//! and fastener, its shear modulus G, diameter d, area A and second moment I. C is the displacement of plate 1 against plate 2 over the force that plate 1 hands on.
//!
//! | formula | laps | C |
//! | --- | --- | --- |
//! | Huth | single n = 1, double n = 2 | ((t₁ + t₂)/2d)^a (b/n) (1/t₁E₁ + 1/n t₂E₂ + 1/2t₁E_b + 1/2n t₂E_b) |
//! | Boeing | single | Σ 2^((t_i/d)^0.85)/t_i (1/E_i + 3/8E_b) |
//! | Swift | single | 5/dE_b + 0.8 (1/t₁E₁ + 1/t₂E₂) |
//! | Grumman | single | (t₁ + t₂)²/(E_b d³) + 3.7 (1/t₁E₁ + 1/t₂E₂) |
//! | Tate–Rosenfeld | double | ½ {(2t₂ + t₁)/3GA + (8t₂³ + 16t₂²t₁ + 8t₂t₁² + t₁³)/192E_bI + (2t₂ + t₁)/(t₁t₂E_b) + 1/t₂E₂ + 2/t₁E₁} |
//!
//! | Huth's joint | a | b |
//! | --- | --- | --- |
//! | bolts in metal | 2/3 | 3.0 |
//! | rivets in metal | 2/5 | 2.2 |
//! | bolts in graphite–epoxy | 2/3 | 4.2 |
//!
//! Sources: H. Huth, LBF FB-172 (1984) and ASTM STP 927 (1986) 221–250; L. Jarfall, Saab KH R-3360 (1983), for Boeing; T. Swift, ASTM STP 486 (1971) 164–214, there for
//! one modulus; Grumman as Huth has it; M. B. Tate & S. J. Rosenfeld, NACA TN 1051 (1946).

use std::f64::consts::PI;

/// A kind of joint to which Huth fitted his formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HuthJoint {
    /// Bolts in metal.
    BoltedMetal,
    /// Rivets in metal.
    RivetedMetal,
    /// Bolts in graphite–epoxy.
    BoltedComposite,
}

/// A formula for the compliance of a fastener.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formula {
    /// Of Huth, for a kind of joint.
    Huth(HuthJoint),
    /// Of Boeing.
    Boeing,
    /// Of Swift, at Douglas.
    Swift,
    /// Of Grumman.
    Grumman,
    /// Of Tate and Rosenfeld.
    TateRosenfeld,
}

/// A plate of a lap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LapPlate {
    /// Thickness `[length]`.
    pub thickness: f64,
    /// Young's modulus along the load `[stress]`.
    pub young: f64,
}

/// A lap with one fastener.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lap {
    /// The first plate and the other one; of a double lap the middle plate and one of two equal outer ones.
    pub plates: [LapPlate; 2],
    /// Whether there are two outer plates.
    pub is_double: bool,
    /// Diameter of the fastener `[length]`.
    pub diameter: f64,
    /// Young's modulus of the fastener `[stress]`.
    pub young: f64,
    /// Poisson's ratio of the fastener `[1]`.
    pub poisson: f64,
}

impl Formula {
    /// Compliance of the fastener of `lap` `[length/force]`; `None` where the formula is not made for a single or for a double lap.
    pub fn compliance(self, lap: &Lap) -> Option<f64> {
        let own = match self {
            Self::Huth(joint) => lap.huth(joint),
            Self::TateRosenfeld if lap.is_double => lap.tate_rosenfeld(),
            Self::Boeing if !lap.is_double => lap.boeing(),
            Self::Swift if !lap.is_double => {
                5.0 / (lap.diameter * lap.young) + 0.8 * lap.plate_bearing()
            }
            Self::Grumman if !lap.is_double => lap.grumman(),
            _ => return None,
        };
        Some(own)
    }

    /// Its authors, as messages name it.
    pub fn authors(self) -> &'static str {
        match self {
            Self::Huth(_) => "Huth",
            Self::Boeing => "Boeing",
            Self::Swift => "Swift",
            Self::Grumman => "Grumman",
            Self::TateRosenfeld => "Tate and Rosenfeld",
        }
    }
}

impl Lap {
    /// 1/t₁E₁ + 1/t₂E₂.
    fn plate_bearing(&self) -> f64 {
        let plates = self.plates.iter();
        plates
            .map(|plate| 1.0 / (plate.thickness * plate.young))
            .sum()
    }

    fn huth(&self, joint: HuthJoint) -> f64 {
        let (exponent, factor) = match joint {
            HuthJoint::BoltedMetal => (2.0 / 3.0, 3.0),
            HuthJoint::RivetedMetal => (0.4, 2.2),
            HuthJoint::BoltedComposite => (2.0 / 3.0, 4.2),
        };
        let sides = if self.is_double { 2.0 } else { 1.0 };
        let bearing = |plate: &LapPlate| 1.0 / plate.young + 0.5 / self.young;
        let [first, other] = &self.plates;
        let sum = bearing(first) / first.thickness + bearing(other) / (sides * other.thickness);
        let slenderness = (first.thickness + other.thickness) / (2.0 * self.diameter);
        slenderness.powf(exponent) * factor / sides * sum
    }

    fn boeing(&self) -> f64 {
        let side = |plate: &LapPlate| {
            let growth = (plate.thickness / self.diameter).powf(0.85).exp2();
            growth / plate.thickness * (1.0 / plate.young + 0.375 / self.young)
        };
        self.plates.iter().map(side).sum()
    }

    fn grumman(&self) -> f64 {
        let grip = self.plates[0].thickness + self.plates[1].thickness;
        grip * grip / (self.young * self.diameter.powi(3)) + 3.7 * self.plate_bearing()
    }

    fn tate_rosenfeld(&self) -> f64 {
        let [middle, outer] = &self.plates;
        let (t, s) = (middle.thickness, outer.thickness);
        let area = 0.25 * PI * self.diameter.powi(2);
        let inertia = area * self.diameter.powi(2) / 16.0;
        let shear = self.young / (2.0 * (1.0 + self.poisson));
        let bending = 8.0 * s.powi(3) + 16.0 * s * s * t + 8.0 * s * t * t + t.powi(3);
        let bearing = (2.0 * s + t) / (s * t * self.young)
            + 1.0 / (s * outer.young)
            + 2.0 / (t * middle.young);
        0.5 * ((2.0 * s + t) / (3.0 * shear * area)
            + bending / (192.0 * self.young * inertia)
            + bearing)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Aluminium plates and a steel bolt, in mm and MPa.
    fn lap(thicknesses: [f64; 2], diameter: f64, is_double: bool) -> Lap {
        Lap {
            plates: thicknesses.map(|thickness| LapPlate {
                thickness,
                young: 72e3,
            }),
            is_double,
            diameter,
            young: 210e3,
            poisson: 0.3,
        }
    }

    fn is_near(found: Option<f64>, wanted: f64) {
        let found = found.unwrap();
        assert!((found / wanted - 1.0).abs() < 1e-3, "{found} {wanted}");
    }

    /// Worked by hand for plates of 3 and 4 mm and a bolt of 6 mm: 1/tE = 4.6296e-6 and 3.4722e-6.
    #[test]
    fn formulas_have_the_values_of_a_calculation_by_hand() {
        let single = lap([3.0, 4.0], 6.0, false);
        is_near(
            Formula::Swift.compliance(&single),
            3.968e-6 + 0.8 * 8.1019e-6,
        );
        is_near(
            Formula::Grumman.compliance(&single),
            1.0803e-6 + 3.7 * 8.1019e-6,
        );
        // (7/12)^⅔ = 0.69815; 1/2tE_b = 7.9365e-7 and 5.9524e-7.
        let huth = 0.69815 * 3.0 * (8.1019e-6 + 1.38889e-6);
        is_near(
            Formula::Huth(HuthJoint::BoltedMetal).compliance(&single),
            huth,
        );
        // 0.5^0.85 = 0.55478, 2^ of it 1.46896; 0.66667^0.85 = 0.70846, 1.63405; 3/8E_b = 1.78571e-6 and 1/E = 1.38889e-5.
        let boeing = (1.46896 / 3.0 + 1.63405 / 4.0) * 1.56746e-5;
        is_near(Formula::Boeing.compliance(&single), boeing);
    }

    /// In single laps nothing depends on which plate is the first.
    #[test]
    fn plates_of_a_single_lap_may_be_exchanged() {
        for formula in [
            Formula::Huth(HuthJoint::RivetedMetal),
            Formula::Boeing,
            Formula::Swift,
            Formula::Grumman,
        ] {
            let [one, other] = [[2.0, 5.0], [5.0, 2.0]]
                .map(|own| formula.compliance(&lap(own, 5.0, false)).unwrap());
            assert!((one / other - 1.0).abs() < 1e-12);
            let is_for_double = formula.compliance(&lap([2.0, 5.0], 5.0, true)).is_some();
            assert_eq!(is_for_double, matches!(formula, Formula::Huth(_)));
        }
    }

    /// Tate and Rosenfeld's shank is a beam between clamped ends under even pressures; its deflection in the middle, with the greatest shear stress 4V/3A.
    #[test]
    fn the_shank_of_tate_and_rosenfeld_is_a_clamped_beam() {
        const CELLS: usize = 200_000;
        let (t, s, diameter) = (4.0, 2.5, 6.0);
        let own = lap([t, s], diameter, true);
        let area = 0.25 * PI * diameter * diameter;
        let bending = 210e3 * area * diameter * diameter / 16.0;
        let shear = 0.75 * 210e3 / 2.6 * area;
        // From an end to the middle, where the shank does not tilt either: M is found by no turn between both.
        let half = s + 0.5 * t;
        let step = half / CELLS as f64;
        let force = |z: f64| {
            if z < s {
                0.5 * z / s
            } else {
                0.5 - (z - s) / t
            }
        };
        let (mut moment, mut turned, mut turn_of_one) = (0.0, 0.0, 0.0);
        let mut deflection = [0.0; 2];
        for cell in 0..CELLS {
            let z = (cell as f64 + 0.5) * step;
            moment += force(z) * step;
            turned += moment / bending * step;
            turn_of_one += step / bending;
            deflection[0] += turned * step;
            deflection[1] += turn_of_one * step;
        }
        let by_bending = deflection[0] - deflection[1] * turned / turn_of_one;
        let by_shear: f64 = (0..CELLS)
            .map(|cell| force((cell as f64 + 0.5) * step) / shear * step)
            .sum();
        let bearing = 0.5 * ((2.0 * s + t) / (s * t * 210e3) + 1.0 / (s * 72e3) + 2.0 / (t * 72e3));
        let wanted = by_bending.abs() + by_shear + bearing;
        is_near(Formula::TateRosenfeld.compliance(&own), wanted);
    }
}
