//! Stresses in the plies of a sheet, layers of one ply and angle together.

use std::sync::Arc;

use stickslip_fem_core::material::Material;
use stickslip_laminate::laminate::Layer;
use stickslip_laminate::{Ply, PlyLoading};

use crate::results::PlyGroup;
use crate::scene::schema::{LaminateSheet, Shape};

/// Layers with the same ply and fibre direction carry the same stresses in a membrane.
#[derive(Debug)]
struct Group {
    ply: Arc<Ply>,
    /// Stress in material axes for each component of the mean stress.
    per_stress: [[f64; 3]; 3],
    /// Stress in material axes per degree that the laminate is warmer `[MPa/K]`.
    per_degree: [f64; 3],
    held: [f64; 3],
}

/// Places of a body with the stresses that a step puts there.
#[derive(Debug, Default)]
pub(crate) struct Sites {
    /// Mean stress over the thickness (xx, yy, xy) `[MPa]`.
    pub(crate) stress: Vec<[f64; 3]>,
    /// Temperature rise of the body `[K]`.
    pub(crate) heating: f64,
}

impl Sites {
    /// The same places and, behind them, their mirror images across the line of symmetry.
    pub(crate) fn with_mirror_images(mut self) -> Self {
        let images: Vec<[f64; 3]> = self.stress.iter().map(|&[x, y, t]| [x, y, -t]).collect();
        self.stress.extend(images);
        self
    }
}

/// The coordinate that changes sign between the halves of a half model: y of round shapes, x of the others.
pub(crate) fn mirror_axis(shape: &Shape) -> usize {
    usize::from(shape.is_round())
}

/// Ply stresses of a sheet by its mean stress.
#[derive(Debug)]
pub(crate) struct PlyStresses {
    groups: Vec<Group>,
    shown: Vec<PlyGroup>,
}

/// Angle of fibres in (−90°, 90°].
fn direction(angle: f64) -> f64 {
    let turned = angle.rem_euclid(180.0);
    if turned > 90.0 {
        turned - 180.0
    } else {
        turned
    }
}

impl PlyStresses {
    pub(crate) fn new(sheet: &LaminateSheet) -> Self {
        let mut plies = Self {
            groups: Vec::new(),
            shown: Vec::new(),
        };
        for (index, layer) in sheet.laminate.layers().iter().enumerate() {
            let (name, angle) = (layer.ply().name(), direction(layer.angle()));
            let alike =
                |group: &&mut PlyGroup| group.ply == name && (group.angle - angle).abs() < 1e-9;
            if let Some(group) = plies.shown.iter_mut().find(alike) {
                group.layers.push(index);
                continue;
            }
            let group = Group::new(layer, sheet);
            plies.shown.push(PlyGroup {
                ply: name.to_owned(),
                angle,
                layers: vec![index],
                residual: group.held,
            });
            plies.groups.push(group);
        }
        plies
    }

    /// The groups as results show them.
    pub(crate) fn shown(&self) -> &[PlyGroup] {
        &self.shown
    }

    pub(crate) fn ply(&self, group: usize) -> &Ply {
        &self.groups[group].ply
    }

    /// Stress of the cure alone in material axes `[MPa]`.
    pub(crate) fn held(&self, group: usize) -> [f64; 3] {
        self.groups[group].held
    }

    /// Stress of the loads in material axes `[MPa]`, for the mean stress `mean` `[MPa]` and the temperature rise `heating` `[K]`.
    pub(crate) fn applied(&self, group: usize, mean: [f64; 3], heating: f64) -> [f64; 3] {
        let group = &self.groups[group];
        [0, 1, 2].map(|i| {
            let mechanical: f64 = (0..3).map(|j| group.per_stress[i][j] * mean[j]).sum();
            mechanical + group.per_degree[i] * heating
        })
    }

    pub(crate) fn loading(&self, group: usize, mean: [f64; 3], heating: f64) -> PlyLoading {
        PlyLoading {
            held: self.held(group),
            applied: self.applied(group, mean, heating),
        }
    }
}

impl Group {
    fn new(layer: &Layer, sheet: &LaminateSheet) -> Self {
        let compliance = sheet.membrane.compliance();
        let columns = [0, 1, 2].map(|j| {
            let strain = [0, 1, 2].map(|i: usize| compliance[i][j]);
            layer.stress(strain, 0.0)
        });
        let per_degree = layer.stress(sheet.membrane.thermal_strain(1.0), 1.0);
        Self {
            ply: Arc::new(layer.ply().clone()),
            per_stress: [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| columns[j][i])),
            per_degree,
            held: per_degree.map(|stress| stress * sheet.cure),
        }
    }
}
