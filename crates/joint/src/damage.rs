//! Which plies failed where, in which mode, and when.

use stickslip_fem_core::mesh::Point;
use stickslip_laminate::failure::FailureMode;
use stickslip_laminate::progressive::PointState;
use stickslip_laminate::{Damage, Strength};

use crate::body::ProgressiveBody;

/// What happened to a ply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlyEventKind {
    /// It failed in this mode. The part that failed, fibres or matrix, is the model's word; tension, compression or shear is that of
    /// the stress of the sound ply that is nearest to its strength.
    Failure(FailureMode),
    /// It began to flow.
    Yield,
}

/// A ply that fails or begins to flow at a quadrature point.
#[derive(Clone, Debug, PartialEq)]
pub struct PlyEvent {
    /// Index of the body.
    pub body: usize,
    /// Index of the cell.
    pub cell: usize,
    /// Index of the quadrature point.
    pub point: usize,
    /// Its place `[length]`.
    pub position: Point,
    /// Index of the layer, from the bottom, from 0.
    pub layer: usize,
    /// Fibre angle of the layer `[degree]`.
    pub angle: f64,
    /// What happened.
    pub kind: PlyEventKind,
    /// Volume of the ply that the point stands for `[length³]`.
    pub volume: f64,
    /// Load `[force]` by the joint's gauge, before stress is redistributed.
    pub load: f64,
    /// Displacement `[length]` by the joint's gauge, likewise.
    pub displacement: f64,
    /// Redistributions at constant load before it in the same increment: 0 for a ply that the load itself breaks.
    pub pass: usize,
}

impl PlyEvent {
    /// Whether fibres failed.
    pub fn breaks_fibres(&self) -> bool {
        matches!(self.kind, PlyEventKind::Failure(mode) if mode.is_fibre())
    }

    /// Whether anything failed, rather than began to flow.
    pub fn is_failure(&self) -> bool {
        matches!(self.kind, PlyEventKind::Failure(_))
    }
}

/// Damage of one ply all over a body, by indices of quadrature points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlyDamage {
    /// Fibre angle `[degree]`.
    pub angle: f64,
    /// Points where the matrix failed and the fibres did not.
    pub matrix: Vec<usize>,
    /// Points where the fibres failed.
    pub fibre: Vec<usize>,
    /// Points where the ply flowed.
    pub yielded: Vec<usize>,
}

/// Damage of each ply of `body` in the states `points`, from the bottom up. Where laminates differ from cell to cell, plies are
/// identified by their position and have the angle of the first cell.
pub fn damage_map(body: &ProgressiveBody, points: &[PointState]) -> Vec<PlyDamage> {
    let mut map: Vec<PlyDamage> = Vec::new();
    for (point, state) in points.iter().enumerate() {
        for (index, layer) in state.layers.iter().enumerate() {
            if map.len() <= index {
                let layers = body.model(point).laminate().layers();
                map.push(PlyDamage {
                    angle: layers[index].angle(),
                    ..PlyDamage::default()
                });
            }
            let ply = &mut map[index];
            match layer.damage {
                Damage { fibre: true, .. } => ply.fibre.push(point),
                Damage { matrix: true, .. } => ply.matrix.push(point),
                Damage { .. } => {}
            }
            if layer.hardening > 0.0 {
                ply.yielded.push(point);
            }
        }
    }
    map
}

/// A layer that lost stiffness between two states of one point.
pub(crate) fn newly_damaged(before: &[PointState], after: &[PointState]) -> Vec<(usize, usize)> {
    changed(before, after, |old, new| old.damage != new.damage)
}

/// A layer that began to flow.
pub(crate) fn newly_flowing(before: &[PointState], after: &[PointState]) -> Vec<(usize, usize)> {
    changed(before, after, |old, new| {
        old.hardening == 0.0 && new.hardening > 0.0
    })
}

fn changed(
    before: &[PointState],
    after: &[PointState],
    differs: impl Fn(
        &stickslip_laminate::progressive::LayerState,
        &stickslip_laminate::progressive::LayerState,
    ) -> bool,
) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (point, (old, new)) in before.iter().zip(after).enumerate() {
        for (index, layers) in old.layers.iter().zip(&new.layers).enumerate() {
            if differs(layers.0, layers.1) {
                found.push((point, index));
            }
        }
    }
    found
}

/// The event of layer `layer` at `point` on the way from `before` to `after`.
pub(crate) fn event(
    (index, body): (usize, &ProgressiveBody),
    (point, layer): (usize, usize),
    (before, after): (&PointState, &PointState),
) -> PlyEvent {
    let laminate = body.model(point).laminate();
    let own = &laminate.layers()[layer];
    let kind = if before.layers[layer].damage == after.layers[layer].damage {
        PlyEventKind::Yield
    } else {
        let stress = own.stress(after.strain, after.temperature);
        let fibre = after.layers[layer].damage.fibre && !before.layers[layer].damage.fibre;
        PlyEventKind::Failure(mode_of(own.ply(), stress, fibre))
    };
    PlyEvent {
        body: index,
        cell: body.cell(point),
        point,
        position: body.points().positions()[point],
        layer,
        angle: own.angle(),
        kind,
        volume: body.volume(point) * own.ply().thickness() / laminate.thickness(),
        load: 0.0,
        displacement: 0.0,
        pass: 0,
    }
}

/// The mode of a failure of fibres or matrix under `stress` of the sound ply.
fn mode_of(ply: &stickslip_laminate::Ply, [s1, s2, t]: [f64; 3], fibre: bool) -> FailureMode {
    if fibre {
        return if s1 < 0.0 {
            FailureMode::FibreCompression
        } else {
            FailureMode::FibreTension
        };
    }
    let ratio = |value: f64, strength: Strength| {
        let strength = ply.strengths().get(strength);
        value.abs() / strength.unwrap_or(f64::INFINITY)
    };
    let shear = ratio(t, Strength::S12);
    if s2 < 0.0 {
        if ratio(s2, Strength::Yc) >= shear {
            return FailureMode::MatrixCompression;
        }
    } else if ratio(s2, Strength::Yt) >= shear {
        return FailureMode::MatrixTension;
    }
    FailureMode::Shear
}
