//! Random materials and lay-ups.

use serde_json::{Value, json};

use super::Draft;
use crate::torture::scenes::quantity::{deg, mm, mpa, text};

/// Thickness of a ply `[mm]`.
const PLY: f64 = 0.125;

/// Lay-ups with their numbers of plies.
const LAYUPS: [(&str, usize); 9] = [
    ("[0/45/-45/90]s", 8),
    ("[0/90]s", 4),
    ("[±45]s", 4),
    ("[0_2/±45/90]s", 10),
    ("[±30]s", 4),
    ("[-37/86]s", 4),
    ("[0]", 1),
    ("[0/60/-60]s", 6),
    ("[25/70]s", 4),
];

/// The plies that all laminates are made of.
pub(super) fn plies() -> Value {
    json!({ "c": {
        "e1": "140000 MPa", "e2": "9000 MPa", "g12": "5000 MPa", "nu12": 0.3, "thickness": mm(PLY),
        "expansion1": "2e-8 1/K", "expansion2": "2.2e-5 1/K",
        "strengths": {
            "xt": "1500 MPa", "xc": "1200 MPa", "yt": "50 MPa", "yc": "200 MPa", "s12": "70 MPa",
            "zt": "50 MPa", "zc": "200 MPa", "s13": "70 MPa", "s23": "100 MPa", "linear_strain_limits": true,
        },
    } })
}

/// A material as bodies see it.
pub(super) struct Made {
    /// Smallest and largest modulus `[MPa]`.
    pub(super) moduli: [f64; 2],
    /// Thickness that the material prescribes `[mm]`.
    pub(super) thickness: Option<f64>,
}

impl Draft {
    /// Adds a random material by this name.
    pub(super) fn material(&mut self, name: &str) -> Made {
        let kind = self.draw.weighted(&[
            (0.5, 0),
            (0.28, 1),
            (if self.strain { 0.0 } else { 0.22 }, 2),
        ]);
        match kind {
            0 => self.isotropic(name),
            1 => self.orthotropic(name),
            _ => self.laminate(name),
        }
    }

    /// An angle between fibres and the load axis `[deg]`, often one that keeps symmetry.
    fn skew(&mut self) -> f64 {
        let skew = (self.draw.between(-90.0, 90.0) * 10.0).round() / 10.0;
        self.draw
            .weighted(&[(0.45, 0.0), (0.15, 90.0), (0.4, skew)])
    }

    /// Adds an isotropic material.
    pub(super) fn isotropic(&mut self, name: &str) -> Made {
        let soft = self.draw.chance(0.12);
        let young = if soft {
            self.draw.magnitude(2.0, 1000.0)
        } else {
            self.draw.magnitude(1e3, 3e5)
        };
        let poisson = self.draw.between(0.0, 0.45);
        let mut constants = json!({ "young": mpa(young), "poisson": poisson });
        if self.hot {
            constants["expansion"] = text(self.draw.magnitude(1e-6, 1e-4), "1/K");
        }
        self.materials
            .insert(name.to_owned(), json!({ "isotropic": constants }));
        Made {
            moduli: [young; 2],
            thickness: None,
        }
    }

    fn orthotropic(&mut self, name: &str) -> Made {
        let e1 = self.draw.magnitude(3e3, 2e5);
        let e2 = super::super::draw::digits(e1 * self.draw.magnitude(0.04, 1.0), 4);
        let g12 = super::super::draw::digits(e2 * self.draw.between(0.2, 0.6), 4);
        let (nu12, angle) = (self.draw.between(0.05, 0.35), self.skew());
        let mut constants = json!({
            "e1": mpa(e1), "e2": mpa(e2), "g12": mpa(g12), "nu12": nu12, "angle": deg(angle),
        });
        if self.strain {
            constants["e3"] = mpa(e2);
            constants["nu13"] = json!(nu12);
            constants["nu23"] = json!(self.draw.between(0.05, 0.4));
        }
        if self.hot {
            constants["expansion1"] = text(self.draw.magnitude(1e-7, 1e-5), "1/K");
            constants["expansion2"] = text(self.draw.magnitude(5e-6, 1e-4), "1/K");
        }
        self.materials
            .insert(name.to_owned(), json!({ "orthotropic": constants }));
        Made {
            moduli: [g12.min(e2), e1],
            thickness: None,
        }
    }

    fn laminate(&mut self, name: &str) -> Made {
        let (layup, plies) = LAYUPS[self.draw.whole(0, LAYUPS.len() - 1)];
        let mut laminate = json!({ "layup": layup, "ply": "c" });
        let angle = self.skew();
        if angle != 0.0 {
            laminate["angle"] = deg(angle);
        }
        if self.draw.chance(0.4) {
            laminate["cure"] = text(-self.draw.between(20.0, 160.0).round(), "K");
        }
        self.materials
            .insert(name.to_owned(), json!({ "laminate": laminate }));
        Made {
            moduli: [5000.0, 140_000.0],
            thickness: Some(PLY * plies as f64),
        }
    }

    /// Whether the material of this name is a laminate.
    pub(super) fn is_laminate(&self, name: &str) -> bool {
        self.materials[name].get("laminate").is_some()
    }
}
