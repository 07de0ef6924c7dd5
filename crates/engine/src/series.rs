//! Bodies by series: operators about the circle of their contact, and what is reported of them, without a factorisation.
//!
//! Such a body keeps a mesh as the places where fields are shown; nothing is solved on it.

use stickslip_contact::StepRecord;
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::{BodyBalance, BodyLoad};
use stickslip_fem_core::material::PlaneStiffness;
use stickslip_fem_core::mesh::Point;
use stickslip_series::{
    Disk, Field, HalfPlane, HalfPlaneField, LineNodes, Nodes, Plate, PolarStress,
};

pub use stickslip_series::SeriesError;

/// A body by series, ready for contact.
#[derive(Clone, Debug)]
pub enum SeriesBody {
    /// A plate with straight outer edges around a hole.
    Plate(Box<Plate>),
    /// A pin.
    Disk(Box<Disk>),
    /// What a block or a cylinder of a line contact stands for.
    HalfPlane {
        /// Its operator.
        body: Box<HalfPlane>,
        /// The smaller of the half length and the depth of its outline `[mm]`.
        size: f64,
    },
}

/// The contact nodes of a body by series.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SeriesNodes<'a> {
    /// On a circle.
    Circle(&'a Nodes),
    /// On a straight edge.
    Line(&'a LineNodes),
}

/// What a body by series has at any place: displacements `[mm]` and stresses `[MPa]`, exact between nodes.
#[derive(Clone, Debug)]
pub enum SeriesField {
    /// About a circle.
    Circle(Box<Field>),
    /// Of a half-plane.
    HalfPlane(HalfPlaneField),
}

impl SeriesBody {
    /// Compliance on its contact nodes, as contact uses it.
    pub fn interface(&self) -> &dyn InterfaceOperator {
        match self {
            Self::Plate(plate) => plate.as_ref(),
            Self::Disk(disk) => disk.as_ref(),
            Self::HalfPlane { body, .. } => body.as_ref(),
        }
    }

    /// Real unknowns of its fit and of its contact nodes.
    pub fn unknowns(&self) -> usize {
        let fitted = match self {
            Self::Plate(plate) => plate.fit().columns,
            Self::Disk(_) | Self::HalfPlane { .. } => 0,
        };
        2 * self.interface().points().len() + fitted
    }

    /// Largest traction that the fit of the outer edge leaves, relative to the mean one `[1]`; 0 for a closed form.
    pub fn residual(&self) -> f64 {
        match self {
            Self::Plate(plate) => plate.fit().residual,
            Self::Disk(_) | Self::HalfPlane { .. } => 0.0,
        }
    }

    /// The field under `state`.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn field(&self, state: &BodyLoad<'_>) -> Result<SeriesField, SeriesError> {
        Ok(match self {
            Self::Plate(plate) => SeriesField::Circle(Box::new(plate.field(state)?)),
            Self::Disk(disk) => SeriesField::Circle(Box::new(disk.field(state)?)),
            Self::HalfPlane { body, .. } => SeriesField::HalfPlane(body.field(state)?),
        })
    }

    /// The field in the step of `record` under the contact forces `forces`, without its rigid motions; `None` for numbers of another operator.
    pub(crate) fn strained(&self, record: &StepRecord, forces: &[f64]) -> Option<SeriesField> {
        let still = vec![0.0; self.interface().modes().ncols()];
        let state = BodyLoad {
            forces,
            multipliers: &record.state.multipliers,
            motions: &still,
        };
        self.field(&state).ok()
    }

    /// Stresses (xx, yy, xy) `[MPa]` at `places` in the step of `record` under the contact forces `forces`; zero where they have no bound, at the centre of a loaded disk.
    pub(crate) fn stresses(
        &self,
        record: &StepRecord,
        forces: &[f64],
        places: &[Point],
    ) -> Vec<[f64; 3]> {
        let Some(field) = self.strained(record, forces) else {
            return Vec::new();
        };
        let at = |&place: &Point| stress_at(&field, self, place);
        places.iter().map(at).collect()
    }

    /// Stresses normal to its contact edge, along it and shear at `places`, angles `[rad]` or x `[mm]`, under each of `states`, by state and place.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub(crate) fn edge_stresses(
        &self,
        states: &[BodyLoad<'_>],
        places: &[f64],
    ) -> Result<Vec<Vec<[f64; 3]>>, SeriesError> {
        let found = match self {
            Self::Plate(plate) => plate.edge_stresses(states, places)?,
            Self::Disk(disk) => disk.edge_stresses(states, places)?,
            Self::HalfPlane { body, .. } => {
                let mut found = body.edge_stresses(states, places)?;
                found
                    .iter_mut()
                    .flatten()
                    .for_each(|[xx, yy, _]| std::mem::swap(xx, yy));
                return Ok(found);
            }
        };
        let polar = |stress: &PolarStress| [stress.radial, stress.hoop, stress.shear];
        let rows = found.iter().map(|row| row.iter().map(polar).collect());
        Ok(rows.collect())
    }

    /// Centre `[mm]` of its circle, and the length by which its turn is divided, the radius `[mm]`; a half-plane does not turn.
    fn circle(&self) -> (Point, f64) {
        let circle = match self {
            Self::Plate(plate) => plate.circle(),
            Self::Disk(disk) => disk.circle(),
            Self::HalfPlane { .. } => return ([0.0; 2], 1.0),
        };
        (circle.centre, circle.radius)
    }

    /// Along which axes it moves freely, where it is a half-plane.
    fn free(&self) -> Option<[bool; 2]> {
        match self {
            Self::HalfPlane { body, .. } => Some(body.ground().free),
            Self::Plate(_) | Self::Disk(_) => None,
        }
    }

    /// Displacements by the `amounts` of its free rigid motions at `places`, x and y of each in turn.
    pub(crate) fn rigid_displacements(&self, amounts: &[f64], places: &[Point]) -> Vec<f64> {
        let ([cx, cy], radius) = self.circle();
        if let Some(free) = self.free() {
            let mut amounts = amounts.iter().copied();
            let moved = free.map(|free| {
                if free {
                    amounts.next().unwrap_or_default()
                } else {
                    0.0
                }
            });
            return places.iter().flat_map(|_| moved).collect();
        }
        let floats = matches!(self, Self::Plate(_)) || amounts.len() > 1;
        let [x, y, turn] = match *amounts {
            [turn] if !floats && self.is_whole() => [0.0, 0.0, turn],
            [x] => [x, 0.0, 0.0],
            [x, y, turn] => [x, y, turn],
            _ => [0.0; 3],
        };
        let turn = turn / radius;
        let at = |[px, py]: &Point| [x - turn * (py - cy), y + turn * (px - cx)];
        places.iter().flat_map(at).collect()
    }

    /// The smaller of the half length and the depth of the outline `[mm]` that a half-plane leaves out.
    pub(crate) fn outline(&self) -> Option<f64> {
        match self {
            Self::HalfPlane { size, .. } => Some(*size),
            Self::Plate(_) | Self::Disk(_) => None,
        }
    }

    /// Its contact nodes.
    pub(crate) fn nodes(&self) -> SeriesNodes<'_> {
        match self {
            Self::Plate(plate) => SeriesNodes::Circle(plate.nodes()),
            Self::Disk(disk) => SeriesNodes::Circle(disk.nodes()),
            Self::HalfPlane { body, .. } => SeriesNodes::Line(body.nodes()),
        }
    }

    /// Its contact nodes on a circle.
    pub(crate) fn circle_nodes(&self) -> Option<&Nodes> {
        match self.nodes() {
            SeriesNodes::Circle(nodes) => Some(nodes),
            SeriesNodes::Line(_) => None,
        }
    }

    /// Its contact nodes on a straight edge.
    pub fn line_nodes(&self) -> Option<&LineNodes> {
        match self.nodes() {
            SeriesNodes::Circle(_) => None,
            SeriesNodes::Line(nodes) => Some(nodes),
        }
    }

    fn is_whole(&self) -> bool {
        match self.nodes() {
            SeriesNodes::Circle(nodes) => !nodes.is_mirrored(),
            SeriesNodes::Line(nodes) => !nodes.is_mirrored(),
        }
    }

    /// The balance of contact forces, loads and reactions in the state of `record`, which the series holds by construction: what is left is what
    /// contact leaves in the body's free motions; of the slice of a fastener, `is_carried`, that is what the fastener takes.
    pub(crate) fn balance(
        &self,
        forces: &[f64],
        record: &StepRecord,
        is_carried: bool,
    ) -> BodyBalance {
        let operator = self.interface();
        let mut rest = operator
            .modes()
            .tr_mul(&nalgebra::DVector::from_column_slice(forces));
        for (case, &factor) in record.state.multipliers.iter().enumerate() {
            rest.axpy(factor, operator.mode_load(case), 1.0);
        }
        if is_carried {
            return BodyBalance {
                reaction: [-rest[0], -rest[1]],
                ..BodyBalance::default()
            };
        }
        let size = forces.iter().map(|force| force.abs()).sum::<f64>() * 0.5;
        let left = if size > 0.0 { rest.amax() / size } else { 0.0 };
        BodyBalance {
            reaction: self.reaction(forces),
            reaction_moment: 0.0,
            force: left,
            moment: 0.0,
            nodal: 0.0,
        }
    }

    /// What the support at the centre of a held disk takes, and that of a half-plane far away.
    fn reaction(&self, forces: &[f64]) -> [f64; 2] {
        let held = match self {
            Self::Plate(_) => [false; 2],
            Self::Disk(disk) => [disk.modes().ncols() == usize::from(self.is_whole()); 2],
            Self::HalfPlane { body, .. } => body.ground().free.map(|free| !free),
        };
        let sum = |axis: usize| forces.iter().skip(axis).step_by(2).sum::<f64>();
        [0, 1].map(|axis| if held[axis] { -sum(axis) } else { 0.0 })
    }
}

impl SeriesField {
    /// Displacement `[mm]` at `place`.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a place that the body does not have.
    pub fn displacement(&self, place: Point) -> Result<[f64; 2], SeriesError> {
        match self {
            Self::Circle(field) => field.displacement(place),
            Self::HalfPlane(field) => field.displacement(place),
        }
    }
}

/// Stresses (xx, yy, xy) `[MPa]` of `field` at a place of `body`; zero where they have no bound, at the centre of a loaded disk.
pub(crate) fn stress_at(field: &SeriesField, body: &SeriesBody, place: Point) -> [f64; 3] {
    let field = match field {
        SeriesField::Circle(field) => field,
        SeriesField::HalfPlane(field) => {
            return field.stress(place).unwrap_or_default();
        }
    };
    let ([cx, cy], _) = body.circle();
    let PolarStress {
        radial,
        hoop,
        shear,
    } = field.stress(place).unwrap_or_default();
    let (sin, cos) = (place[1] - cy).atan2(place[0] - cx).sin_cos();
    let found = [
        radial * cos * cos + hoop * sin * sin - 2.0 * shear * sin * cos,
        radial * sin * sin + hoop * cos * cos + 2.0 * shear * sin * cos,
        (radial - hoop) * sin * cos + shear * (cos * cos - sin * sin),
    ];
    if found.iter().all(|part| part.is_finite()) {
        found
    } else {
        [0.0; 3]
    }
}

/// Whether a material of this stiffness `[MPa]` is isotropic in the plane.
pub fn is_isotropic(d: &PlaneStiffness) -> bool {
    let (along, cross) = (d[0][0], d[0][1]);
    let differences = [
        along - d[1][1],
        d[0][2],
        d[1][2],
        d[2][2] - 0.5 * (along - cross),
    ];
    differences.iter().all(|part| part.abs() <= 1e-9 * along)
}
