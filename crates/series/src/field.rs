//! Stresses and displacements anywhere in a body, from its nodal forces, load cases and rigid motions.
//!
//! ```text
//! σ_xx + σ_yy = 4 Re φ′,   σ_yy − σ_xx + 2iσ_xy = 2 (ζ̄ φ″ + ψ′),   2G u/R = κφ − ζ conj φ′ − conj ψ,     ζ = (z − c)/R
//! edge:  σ_rr + iσ_rθ from the hats,   σ_θθ = 4 Re φ′ − σ_rr
//! ```
//!
//! Tractions on the circle are hats, whose potentials are polylogarithms of ζ, or away from the circle a series that is cut off below rounding: stresses near the edge and
//! the hoop stress on it between nodes are exact for these tractions, to about 1e-13 of the largest one over the spacing in radians. At a node the hoop stress has a kink, of infinite slope (s ln s), as a piecewise linear
//! traction has. At the end of an [`arc`](crate::Nodes::arc) where the traction jumps it is infinite.

mod edges;
mod hats;
mod inside;
mod kink;
mod modes;
mod outer_planes;
mod outside;
mod planes;
mod polylog;
mod state;

use nalgebra::{Complex, DMatrix, DVector};
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::mesh::Point;

use crate::circle::Circle;
use crate::error::SeriesError;
use crate::expansion::displacement;
use crate::lekhnitskii::Planes;
use crate::nodes::Nodes;
pub(crate) use edges::{Edge, EdgeOf};
pub(crate) use hats::Hats;
pub(crate) use inside::Inside;
pub(crate) use outer_planes::OuterPlanes;
pub(crate) use outside::{Outer, Outside};
use state::State;

type C64 = Complex<f64>;

/// Part of the radius up to which a place is on the circle.
const ON_EDGE: f64 = 1e-12;

/// Stress `[stress]` along the radius from the circle's centre and around it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PolarStress {
    /// σ_rr.
    pub radial: f64,
    /// σ_θθ.
    pub hoop: f64,
    /// σ_rθ.
    pub shear: f64,
}

/// The state of a body: stresses and displacements at any of its points.
#[derive(Clone, Debug)]
pub struct Field {
    circle: Circle,
    /// Unit of the motions of the potentials `[length/stress]`.
    unit: f64,
    /// Stresses σ_rr + iσ_rθ on the circle, along x and y.
    hats: Hats,
    body: Body,
    /// Rigid motion in addition to that of the potentials: translation `[length]` and turn `[rad]`.
    translation: C64,
    turn: f64,
    /// Uniform strain that makes no stress.
    strain: [f64; 3],
}

#[derive(Clone, Debug)]
pub(crate) enum Body {
    /// With κ.
    Outside(Outside, f64),
    /// With κ.
    Inside(Inside, f64),
    /// An anisotropic plate.
    Planes(Outside, Box<Planes>),
}

/// What a field is made of besides its body.
pub(crate) struct Ingredients<'a> {
    pub(crate) nodes: &'a Nodes,
    pub(crate) circle: Circle,
    /// Unit of the motions of the potentials `[length/stress]`.
    pub(crate) unit: f64,
    /// Forces `[force]` on the nodes, 2n.
    pub(crate) forces: &'a [f64],
    /// Whether the body is inside of the circle.
    pub(crate) inside: bool,
}

impl Ingredients<'_> {
    /// Stresses σ_rr + iσ_rθ on the circle by the nodal forces.
    pub(crate) fn hats(&self) -> Hats {
        let sign = if self.inside { 1.0 } else { -1.0 };
        hats(self.nodes, self.circle, self.forces, sign)
    }
}

/// Stresses σ_rr + iσ_rθ on a circle, along x and y, by nodal forces `forces` (2n) times `sign`.
pub(crate) fn hats(nodes: &Nodes, circle: Circle, forces: &[f64], sign: f64) -> Hats {
    Hats::new(nodes, &values(nodes, circle, forces, sign))
}

/// The same at each knot.
fn values(nodes: &Nodes, circle: Circle, forces: &[f64], sign: f64) -> Vec<C64> {
    let area = circle.radius * circle.thickness;
    let value = |node: usize| {
        let [x, y] = [forces[2 * node], forces[2 * node + 1]];
        // Half of a force on the axis acts on the half; what is along y there is taken up by symmetry.
        let whole = if nodes.on_axis(node) {
            C64::new(2.0 * x, 0.0)
        } else {
            C64::new(x, y)
        };
        sign * whole / (area * nodes.knots()[node].weight)
    };
    let knots = nodes.knots().iter().enumerate();
    knots
        .map(|(k, knot)| {
            let own = value(knot.node);
            if k == knot.node { own } else { own.conj() }
        })
        .collect()
}

impl Field {
    /// The field of `body` with the rigid motion `motions` in the body's own `modes`, [x, y, turn·R] with zeros where it has none.
    pub(crate) fn new(of: &Ingredients<'_>, hats: Hats, body: Body, motions: [f64; 3]) -> Self {
        let [x, y, turn] = motions;
        Self {
            circle: of.circle,
            unit: of.unit,
            translation: C64::new(x, y),
            turn: turn / of.circle.radius,
            strain: [0.0; 3],
            hats,
            body,
        }
    }

    /// The same with the uniform `strain` that makes no stress.
    pub(crate) fn expanded(self, strain: [f64; 3]) -> Self {
        Self { strain, ..self }
    }

    /// Stress `[stress]` at the angle `theta` `[rad]` of the circle: σ_rr and σ_rθ interpolated between nodes, σ_θθ exact for these.
    pub fn edge(&self, theta: f64) -> PolarStress {
        let traction = self.hats.at(theta) * C64::from_polar(1.0, -theta);
        let sum = match &self.body {
            Body::Outside(outside, kappa) => outside.sum_on_edge(&self.hats, theta, *kappa),
            Body::Inside(inside, kappa) => inside.sum_on_edge(&self.hats, theta, *kappa),
            Body::Planes(outside, planes) => {
                planes::sum_on_edge(planes, outside, &self.hats, theta)
            }
        };
        PolarStress {
            radial: traction.re,
            hoop: sum - traction.re,
            shear: traction.im,
        }
    }

    /// Stress `[stress]` and displacement `[length]` at `point` `[length]`, as [`stress`](Self::stress) and [`displacement`](Self::displacement), in
    /// one evaluation.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a point that the body does not have.
    pub fn at(&self, point: Point) -> Result<(PolarStress, [f64; 2]), SeriesError> {
        let zeta = self.inside(point)?;
        let state = self.state(zeta);
        let stress = if on_edge(zeta) {
            self.edge(zeta.arg())
        } else {
            stress(zeta, &state)
        };
        Ok((stress, self.moved(zeta, &state)))
    }

    /// Stress `[stress]` at `point` `[length]`, on the circle as [`edge`](Self::edge); infinite at a disk's centre where a force acts there.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a point that the body does not have.
    pub fn stress(&self, point: Point) -> Result<PolarStress, SeriesError> {
        let zeta = self.inside(point)?;
        Ok(if on_edge(zeta) {
            self.edge(zeta.arg())
        } else {
            stress(zeta, &self.state(zeta))
        })
    }

    /// Displacement `[length]` along x and y at `point` `[length]`, counted as those of the operator; infinite at a disk's centre where a force acts there.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a point that the body does not have.
    pub fn displacement(&self, point: Point) -> Result<[f64; 2], SeriesError> {
        let zeta = self.inside(point)?;
        Ok(self.moved(zeta, &self.state(zeta)))
    }

    fn moved(&self, zeta: C64, state: &State) -> [f64; 2] {
        let turned = C64::new(0.0, self.turn * self.circle.radius) * zeta;
        let found = state.motion * self.unit + turned + self.translation;
        let place = zeta * self.circle.radius;
        let [x, y] = displacement(self.strain, [place.re, place.im]);
        [found.re + x, found.im + y]
    }

    fn state(&self, zeta: C64) -> State {
        match &self.body {
            Body::Outside(outside, kappa) => outside.at(&self.hats, zeta, *kappa).state(zeta),
            Body::Inside(inside, kappa) => inside.at(&self.hats, zeta, *kappa).state(zeta),
            Body::Planes(outside, planes) => planes::at(planes, outside, &self.hats, zeta),
        }
    }

    /// ζ of a point of the body, of a point of the circle with the length 1.
    fn inside(&self, point: Point) -> Result<C64, SeriesError> {
        let centre = self.circle.centre;
        let zeta = C64::new(point[0] - centre[0], point[1] - centre[1]) / self.circle.radius;
        let length = zeta.norm();
        let has = match &self.body {
            Body::Outside(outside, _) | Body::Planes(outside, _) => {
                length >= 1.0 - ON_EDGE && outside.contains(zeta)
            }
            Body::Inside(..) => length <= 1.0 + ON_EDGE,
        };
        if has {
            Ok(if on_edge(zeta) { zeta / length } else { zeta })
        } else {
            Err(SeriesError::OutsideBody { point })
        }
    }
}

fn on_edge(zeta: C64) -> bool {
    (zeta.norm() - 1.0).abs() < ON_EDGE
}

/// The stress of `state` at `zeta`.
fn stress(zeta: C64, state: &State) -> PolarStress {
    let &State {
        sum, difference, ..
    } = state;
    let length = zeta.norm();
    let direction = if length > 0.0 {
        zeta / length
    } else {
        1.0.into()
    };
    let turned = direction * direction * difference;
    PolarStress {
        radial: 0.5 * (sum - turned.re),
        hoop: 0.5 * (sum + turned.re),
        shear: 0.5 * turned.im,
    }
}

/// Checks the lengths of a state: 2n forces, a multiplier of each load case, an amount of each rigid motion.
pub(crate) fn check(state: &BodyLoad<'_>, expected: [usize; 3]) -> Result<(), SeriesError> {
    let given = [
        ("forces", state.forces),
        ("multipliers", state.multipliers),
        ("motions", state.motions),
    ];
    for ((what, values), expected) in given.into_iter().zip(expected) {
        if values.len() != expected {
            return Err(SeriesError::State {
                what,
                found: values.len(),
                expected,
            });
        }
    }
    Ok(())
}

/// The forces of checked states, 2n × states.
pub(crate) fn forces(
    states: &[BodyLoad<'_>],
    expected: [usize; 3],
) -> Result<DMatrix<f64>, SeriesError> {
    let mut forces = DMatrix::zeros(expected[0], states.len());
    for (state, mut column) in states.iter().zip(forces.column_iter_mut()) {
        check(state, expected)?;
        column.copy_from_slice(state.forces);
    }
    Ok(forces)
}

/// Amounts of the motions along x and y and of the turn; of a half model along x.
pub(crate) fn motions(amounts: &[f64]) -> [f64; 3] {
    let mut all = [0.0; 3];
    all[..amounts.len()].copy_from_slice(amounts);
    all
}

/// Σ m_k v_k.
pub(crate) fn combined<'a>(
    multipliers: &'a [f64],
    vectors: impl IntoIterator<Item = &'a DVector<f64>>,
    size: usize,
) -> DVector<f64> {
    let mut sum = DVector::zeros(size);
    for (factor, vector) in multipliers.iter().zip(vectors) {
        sum.axpy(*factor, vector, 1.0);
    }
    sum
}
