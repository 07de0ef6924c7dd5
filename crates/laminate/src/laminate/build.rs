//! From plies and angles to the matrices of the laminate.

use std::sync::Arc;

use super::{Laminate, LaminateError, Layer, PlateMatrix};
use crate::degradation::{Damage, Degradation};
use crate::layup::Layup;
use crate::ply::Ply;

impl Laminate {
    /// Stacks one ply throughout; where the lay-up names a ply it must be this one.
    ///
    /// # Errors
    /// As [`Laminate::of_plies`].
    pub fn new(layup: &Layup, ply: &Ply) -> Result<Self, LaminateError> {
        Self::of_plies(layup, ply, &[])
    }

    /// Stacks the ply `default` where the lay-up names none, and of those in `named`, or `default`, where it does.
    ///
    /// # Errors
    /// [`LaminateError::UnknownPly`] if a name is not given; [`LaminateError::NotInvertible`] if the stiffness overflows.
    pub fn of_plies(layup: &Layup, default: &Ply, named: &[Ply]) -> Result<Self, LaminateError> {
        let plies: Vec<Arc<Ply>> = std::iter::once(default)
            .chain(named)
            .map(|ply| Arc::new(ply.clone()))
            .collect();
        let find = |layer: usize, name: Option<&str>| match name {
            None => Ok(Arc::clone(&plies[0])),
            Some(name) => plies
                .iter()
                .rev()
                .find(|ply| ply.name() == name)
                .map(Arc::clone)
                .ok_or_else(|| {
                    let mut known: Vec<String> = Vec::new();
                    for ply in plies.iter().map(|ply| ply.name()) {
                        if !known.iter().any(|other| other == ply) {
                            known.push(ply.to_owned());
                        }
                    }
                    let ply = name.to_owned();
                    LaminateError::UnknownPly { layer, ply, known }
                }),
        };
        let stack = layup.stack().iter().enumerate();
        let stacked =
            stack.map(|(layer, stacked)| Ok((find(layer, stacked.ply.as_deref())?, stacked.angle)));
        Self::from_layers(stacked.collect::<Result<Vec<_>, LaminateError>>()?)
    }

    /// Stacks plies with the angles of their fibres `[degree]`, from the bottom up.
    ///
    /// # Errors
    /// [`LaminateError::Empty`] without plies, [`LaminateError::Angle`] unless the angles are finite,
    /// [`LaminateError::NotInvertible`] if the stiffness overflows.
    pub fn from_layers(
        plies: impl IntoIterator<Item = (Arc<Ply>, f64)>,
    ) -> Result<Self, LaminateError> {
        let mut layers = Vec::new();
        let mut height = 0.0;
        for (layer, (ply, angle)) in plies.into_iter().enumerate() {
            if !angle.is_finite() {
                return Err(LaminateError::Angle {
                    layer,
                    ply: ply.name().to_owned(),
                    angle,
                });
            }
            let bottom = height;
            height += ply.thickness();
            layers.push(Layer::new(ply, angle, [bottom, height]));
        }
        if layers.is_empty() {
            return Err(LaminateError::Empty);
        }
        for layer in &mut layers {
            layer.bottom -= 0.5 * height;
            layer.top -= 0.5 * height;
        }
        Self::of_layers(layers, height)
    }

    /// Makes the same laminate with its plies softened as `degradation` has it for the damage of each layer, from the bottom up.
    ///
    /// # Errors
    /// [`LaminateError::LayerCount`] unless there is one record per layer; [`LaminateError::NotInvertible`] if the factors are
    /// so small that the stiffness is singular in floating point.
    pub fn damaged(
        &self,
        damage: &[Damage],
        degradation: &Degradation,
    ) -> Result<Self, LaminateError> {
        if damage.len() != self.layers.len() {
            return Err(LaminateError::LayerCount {
                layers: self.layers.len(),
                given: damage.len(),
            });
        }
        let softened = |(layer, damage): (&Layer, &Damage)| {
            let mut layer = layer.clone();
            layer.local = degradation.stiffness(&layer.ply, *damage);
            layer.stiffness = layer.laminate_stiffness(&layer.local);
            layer
        };
        let layers = self.layers.iter().zip(damage).map(softened).collect();
        Self::of_layers(layers, self.thickness)
    }

    fn of_layers(layers: Vec<Layer>, thickness: f64) -> Result<Self, LaminateError> {
        let stiffness = PlateMatrix::sum(&layers);
        let compliance = stiffness.inverse().ok_or(LaminateError::NotInvertible)?;
        Ok(Self {
            layers,
            thickness,
            stiffness,
            compliance,
        })
    }
}

impl Layer {
    fn new(ply: Arc<Ply>, angle: f64, [bottom, top]: [f64; 2]) -> Self {
        let axis = direction(angle);
        let mut layer = Self {
            angle,
            axis,
            bottom,
            top,
            local: *ply.stiffness(),
            stiffness: *ply.stiffness(),
            expansion: stickslip_fem_core::material::rotated_strain(
                ply.expansion(),
                [axis[0], -axis[1]],
            ),
            ply,
        };
        layer.stiffness = layer.laminate_stiffness(&layer.local);
        layer
    }

    /// ∫ (1, z, z²) dz over the layer; of its mean height and thickness, so that mirrored layers cancel exactly.
    pub(super) fn moments(&self) -> [f64; 3] {
        let thickness = self.ply.thickness();
        let middle = 0.5 * (self.bottom + self.top);
        [
            thickness,
            thickness * middle,
            thickness * (middle * middle + thickness * thickness / 12.0),
        ]
    }
}

/// Unit vector at `angle` `[degree]` from x, exact at multiples of 90°.
fn direction(angle: f64) -> [f64; 2] {
    let turned = angle.rem_euclid(360.0);
    if turned == 0.0 {
        [1.0, 0.0]
    } else if turned == 90.0 {
        [0.0, 1.0]
    } else if turned == 180.0 {
        [-1.0, 0.0]
    } else if turned == 270.0 {
        [0.0, -1.0]
    } else {
        let radians = turned.to_radians();
        [radians.cos(), radians.sin()]
    }
}
