//! What is known of an edge, at all steps and at the end of each.

use std::f64::consts::TAU;

use stickslip_contact::Status;
use stickslip_contact::zones::Zone;

use super::{ContactFrame, Errors, RowErrors, Stated};

/// How places along an edge are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EdgeKind {
    /// A circle: `parameter` is the angle θ `[rad]`, counter-clockwise from +x about its centre.
    Circle {
        /// Centre `[mm]`.
        centre: [f64; 2],
        /// Radius `[mm]`.
        radius: f64,
    },
    /// A line or shallow arc along x: `parameter` is x `[mm]`.
    Line,
    /// Lines, arcs and splines: `parameter` is the arc length s from the middle of the edge, with the body on the left of its walk `[mm]`.
    Path,
}

/// An edge whose quantities are reported.
#[derive(Clone, Debug)]
pub struct EdgeGeometry {
    /// Contact name, or `body.set` of a further edge; part of file names.
    pub name: String,
    /// Whether it is a contact edge.
    pub contact: bool,
    /// Index of the body whose stresses are given (the first body of a contact).
    pub body: usize,
    /// Circle or line.
    pub kind: EdgeKind,
    /// Place of each node along the edge: θ `[rad]` or x `[mm]`, ascending.
    pub parameter: Vec<f64>,
    /// Corner node (true) or mid-side node (false).
    pub corner: Vec<bool>,
    /// Whether only half of a symmetric edge is modelled (the other half is its mirror image).
    pub half: bool,
    /// Radius of the hole less that of the circle in it `[mm]`, negative for an interference; `None` without two circles.
    pub clearance: Option<f64>,
    /// D·t `[mm²]` of a hole, by which a force becomes a bearing stress; `None` for lines.
    pub bearing_area: Option<f64>,
    /// Name of the friction law; empty without contact.
    pub law: String,
    /// From where its places are measured.
    pub frame: ContactFrame,
    /// The edge of the second body of a contact; `None` where that is rigid, and without contact.
    pub second: Option<SecondSide>,
}

/// The edge of the second body of a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct SecondSide {
    /// Index of the body.
    pub body: usize,
    /// Nodes of its mesh along the edge.
    pub nodes: Vec<usize>,
    /// Place of each along its own edge: θ `[rad]` or x `[mm]`, of a path the place s of the first edge that it faces `[mm]`, ascending.
    pub parameter: Vec<f64>,
    /// Unit normal `[1]` of the contact at each, from the second body into the first.
    pub normals: Vec<[f64; 2]>,
}

/// One node of an edge at the end of a load step. What is rounding beside the largest of the history is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeRow {
    /// Contact pressure, ≥ 0; on an edge without contact that of all that acts on it, of any sign `[MPa]`.
    pub pressure: f64,
    /// Tangential traction λ_t on the first body along e_t `[MPa]`.
    pub shear: f64,
    /// Gap, positive when open `[mm]`.
    pub gap: f64,
    /// Slip accumulated in the steps in which the point slipped, first minus second body along e_t `[mm]`.
    pub slip: f64,
    /// Status.
    pub status: Status,
    /// σ_r (circle) or σ_yy (line; across an arc), of contact, loads and reactions together `[MPa]`.
    pub sigma_normal: f64,
    /// σ_θ or σ_xx (along an arc) `[MPa]`.
    pub sigma_tangential: f64,
    /// τ_rθ or τ_xy `[MPa]`.
    pub tau: f64,
}

/// One edge at the end of a load step.
#[derive(Clone, Debug, Default)]
pub struct EdgeResults {
    /// One row per node.
    pub rows: Vec<EdgeRow>,
    /// Zones of equal status of the whole edge, also where half of it is modelled; empty without contact. On a circle a zone
    /// across θ = ±π starts before π and ends beyond it.
    pub zones: Vec<Zone>,
    /// Half of what contact reaches over, gaps between its parts included `[rad or mm]`: half of the distance from its first to its
    /// last place, on a circle half of all but the longest opening; `None` if the pair is open or not a contact.
    pub contact_half_extent: Option<f64>,
    /// Place of the step's own bearing point, as in `parameter`: the direction of the contact force on the first body `[rad]`, or the
    /// centre of pressure `[mm]`. `None` where nothing bears in the step; what is measured from it is then measured from the edge's
    /// [`frame`](EdgeGeometry::frame).
    pub bearing: Option<f64>,
    /// Half of the extent of the stick zone around the bearing point of the step `[rad or mm]`: 0 where that point slips or is
    /// open, `None` without contact, without friction, or without a bearing point unless all sticks all around.
    pub stick_half_extent: Option<f64>,
    /// Total lengths of the zones that slip away from the bearing point of the step and towards it, or along ±e_t `[rad or mm]`; `None`
    /// without contact.
    pub slip_lengths: Option<[f64; 2]>,
    /// Largest pressure `[MPa]` and its place `[rad or mm]`.
    pub peak_pressure: Option<(f64, f64)>,
    /// Largest tangential stress σ_θ or σ_xx `[MPa]` and its place `[rad or mm]`.
    pub peak_hoop: Option<(f64, f64)>,
    /// Uncertainty of that stress where it sits in the cusp at the end of contact `[MPa]`: the larger change to a neighbouring
    /// node. The peak there converges only like the root of the spacing; elsewhere `None`.
    pub peak_hoop_uncertainty: Option<f64>,
    /// σ_θ or σ_xx at the bearing point `[MPa]`; without one at θ = 0 or x = 0.
    pub hoop_at_bearing_point: Option<f64>,
    /// Resultant force on the first body, of the whole (both halves) `[N]`.
    pub resultant: [f64; 2],
    /// Signed sum of the friction forces over the whole contact `[N]`. On a circle ∫q dA with q = −λ_t sgn(sin(θ − θ_b)): q is positive
    /// where friction pulls the first body along the edge towards the bearing point, negative where it pulls away from it; parts
    /// of opposite signs cancel, so the sum says which prevails; zero without a bearing point. On a line the tangential force on
    /// the first body along +x.
    pub friction_force: f64,
    /// ∫p dA over the whole contact `[N]`.
    pub normal_force: f64,
    /// Work lost to friction in the step over the whole contact `[N·mm]`.
    pub friction_work: f64,
    /// Estimated errors of these numbers, where the scene asks for an accuracy or leaves the mesh to the program.
    pub errors: Errors,
    /// Those of the tractions and stresses of its rows; empty where none were estimated.
    pub row_errors: Vec<RowErrors>,
}

impl EdgeGeometry {
    /// The length of `parameter` after which the edge closes on itself `[rad]`, if it does.
    pub fn closed(&self) -> Option<f64> {
        matches!(self.kind, EdgeKind::Circle { .. }).then_some(TAU)
    }

    /// Where a reader looks for a place of `parameter`: its angle φ from the bearing point `[rad]`, or x `[mm]`.
    pub fn seen(&self, place: f64) -> f64 {
        match self.kind {
            EdgeKind::Circle { .. } => self.frame.angle(place),
            EdgeKind::Line | EdgeKind::Path => place,
        }
    }

    /// The place `[rad or mm]` from which positions count in a step that bears at `bearing`: without one where the history bears, or θ = 0, or the place `start` `[mm]` of a line, where x = 0.
    pub fn reference(&self, bearing: Option<f64>, start: f64) -> f64 {
        let start = match self.kind {
            EdgeKind::Circle { .. } | EdgeKind::Path => 0.0,
            EdgeKind::Line => start,
        };
        bearing.or(self.frame.bearing).unwrap_or(start)
    }
}

impl EdgeRow {
    /// The largest of its stresses in size `[MPa]`.
    pub fn largest_stress(&self) -> f64 {
        let all = [self.sigma_normal, self.sigma_tangential, self.tau];
        all.into_iter()
            .fold(0.0, |most: f64, own| most.max(own.abs()))
    }
}

impl EdgeResults {
    /// Moves places by `by` `[mm]`, on the edge `geometry`.
    pub fn place(&mut self, geometry: &EdgeGeometry, [by, _]: [f64; 2]) {
        if geometry.kind != EdgeKind::Line {
            return;
        }
        // Every field is named, so that a new one is either moved here or said to be no place.
        let Self {
            rows: _,
            zones,
            contact_half_extent: _,
            bearing,
            stick_half_extent: _,
            slip_lengths: _,
            peak_pressure,
            peak_hoop,
            peak_hoop_uncertainty: _,
            hoop_at_bearing_point: _,
            resultant: _,
            friction_force: _,
            normal_force: _,
            friction_work: _,
            errors: _,
            row_errors: _,
        } = self;
        for (_, at) in [peak_pressure, peak_hoop].into_iter().flatten() {
            *at += by;
        }
        for zone in zones {
            zone.start += by;
            zone.end += by;
        }
        if let Some(at) = bearing {
            *at += by;
        }
    }

    /// Estimated error of the magnitude of the resultant `[N]`, that of its components together.
    pub fn resultant_error(&self) -> Option<f64> {
        let [x, y] = [Stated::ResultantX, Stated::ResultantY].map(|stated| self.errors.get(stated));
        Some(x?.hypot(y?))
    }

    /// Bearing stress |resultant| / (D t) `[MPa]`; `None` for lines or without force.
    pub fn bearing_stress(&self, geometry: &EdgeGeometry) -> Option<f64> {
        let force = self.resultant[0].hypot(self.resultant[1]);
        geometry
            .bearing_area
            .filter(|_| force > 0.0)
            .map(|area| force / area)
    }
}

impl Stated {
    /// The number in `edge`, in base units.
    pub fn value(self, edge: &EdgeResults) -> Option<f64> {
        match self {
            Self::ContactExtent => edge.contact_half_extent,
            Self::StickExtent => edge.stick_half_extent,
            Self::Bearing => edge.bearing,
            Self::PeakPressure => edge.peak_pressure.map(|peak| peak.0),
            Self::PeakPressurePlace => edge.peak_pressure.map(|peak| peak.1),
            Self::PeakHoop => edge.peak_hoop.map(|peak| peak.0),
            Self::PeakHoopPlace => edge.peak_hoop.map(|peak| peak.1),
            Self::HoopAtBearing => edge.hoop_at_bearing_point,
            Self::FrictionForce => Some(edge.friction_force),
            Self::NormalForce => Some(edge.normal_force),
            Self::ResultantX => Some(edge.resultant[0]),
            Self::ResultantY => Some(edge.resultant[1]),
            Self::SlipAway => edge.slip_lengths.map(|lengths| lengths[0]),
            Self::SlipTowards => edge.slip_lengths.map(|lengths| lengths[1]),
            Self::FrictionWork => Some(edge.friction_work),
        }
    }
}
