//! Stresses in the plies of a sheet, layers of one ply and angle together.

use std::sync::Arc;

use stickslip_fem_core::material::Material;
use stickslip_laminate::laminate::Layer;
use stickslip_laminate::{Ply, PlyLoading};

use crate::results::PlyGroup;
use stickslip_scene::schema::LaminateSheet;

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
#[derive(Clone, Debug, Default)]
pub(crate) struct Sites {
    /// Mean stress over the thickness (xx, yy, xy) `[MPa]`.
    pub(crate) stress: Vec<[f64; 3]>,
    /// Temperature rise of the body `[K]`.
    pub(crate) heating: f64,
}

impl Sites {
    /// Some of the places.
    pub(crate) fn chosen(&self, places: &[usize]) -> Self {
        Self {
            stress: places.iter().map(|&place| self.stress[place]).collect(),
            heating: self.heating,
        }
    }

    /// The same places and, behind them, their mirror images across the line of symmetry.
    pub(crate) fn with_mirror_images(mut self) -> Self {
        let images: Vec<[f64; 3]> = self.stress.iter().map(|&[x, y, t]| [x, y, -t]).collect();
        self.stress.extend(images);
        self
    }
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

    /// Whether the plies at a mirror image carry the stresses of those here but for the sign of τ₁₂: whether every ply has its
    /// counterpart of the opposite angle, and the sheet does not couple tension with shear.
    pub(crate) fn are_their_mirror_image(&self) -> bool {
        self.shown.iter().zip(&self.groups).all(|(own, group)| {
            let opposite = direction(-own.angle);
            let alike =
                |other: &PlyGroup| other.ply == own.ply && (other.angle - opposite).abs() < 1e-9;
            let other = self.shown.iter().position(alike);
            other.is_some_and(|other| group.mirrors(&self.groups[other]))
        })
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

/// How components (xx, yy, xy) change sign at a mirror image.
const MIRRORED: [f64; 3] = [1.0, 1.0, -1.0];
/// Rounding of ply stresses, relative to the largest of their kind.
const ROUNDING: f64 = 1e-12;

impl Group {
    fn mirrors(&self, other: &Self) -> bool {
        let alike = |own: &[f64], other: &[f64], signs: &[f64]| {
            let largest = own
                .iter()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            let mut pairs = own.iter().zip(other).zip(signs);
            pairs.all(|((a, b), sign)| (a - sign * b).abs() <= ROUNDING * largest)
        };
        let signs = MIRRORED.map(|row| MIRRORED.map(|column| row * column));
        let [stress, image] = [self, other].map(|group| group.per_stress.as_flattened());
        alike(stress, image, signs.as_flattened())
            && alike(&self.per_degree, &other.per_degree, &MIRRORED)
    }

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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use stickslip_scene::{Format, Scene};

    fn plies(layup: &str) -> PlyStresses {
        let text = format!(
            r#"
version = 1
[plies.carbon]
e1 = "135 GPa"
e2 = "10 GPa"
g12 = "5.8 GPa"
nu12 = 0.28
expansion1 = "0.02e-6 1/K"
expansion2 = "22.5e-6 1/K"
thickness = "0.125 mm"
[materials.laminate.laminate]
layup = "{layup}"
ply = "carbon"
cure = "-100 K"
[bodies.coupon]
material = "laminate"
shape.rectangle = {{ width = "60 mm", height = "20 mm" }}
[mesh]
spacing = "10 mm"
[[supports]]
on = "coupon.left"
fix = ["x"]
[[loads]]
on = "coupon.right"
pressure.steps = ["-1 MPa"]
"#
        );
        let changes: [&str; 0] = [];
        let scene =
            Scene::from_text(&text, Format::Toml, "scene.toml", Path::new(""), &changes).unwrap();
        PlyStresses::new(scene.materials["laminate"].laminate().unwrap())
    }

    #[test]
    fn balanced_plies_alone_are_their_mirror_image() {
        for layup in [
            "[0/±45/90]s",
            "[0_2/60_2/-60_2]s",
            "[90]",
            "[30/-30/-30/30]",
        ] {
            assert!(plies(layup).are_their_mirror_image(), "{layup}");
        }
        // Without a counterpart, and with one that is outnumbered: the sheet shears under tension.
        for layup in ["[30]", "[0/30/90]s", "[30/-30/30]s"] {
            assert!(!plies(layup).are_their_mirror_image(), "{layup}");
        }
    }

    #[test]
    fn the_mirror_image_of_a_balanced_laminate_asks_the_same_but_for_the_sign_of_shear() {
        let plies = plies("[0/±45/90]s");
        for (group, own) in plies.shown().iter().enumerate() {
            let opposite = direction(-own.angle);
            let other = (plies.shown().iter()).position(|ply| (ply.angle - opposite).abs() < 1e-9);
            let here = plies.loading(group, [30.0, -20.0, 7.0], 5.0).at(1.0);
            let there = plies
                .loading(other.unwrap(), [30.0, -20.0, -7.0], 5.0)
                .at(1.0);
            for ((one, other), sign) in here.iter().zip(there).zip(MIRRORED) {
                // Rounding of stresses up to 100 MPa.
                assert!((one - sign * other).abs() < 1e-10, "{own:?}");
            }
        }
    }
}
