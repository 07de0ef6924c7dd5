//! What fasteners hand on between layers.

/// A fastener as it was modelled.
#[derive(Clone, Debug, PartialEq)]
pub struct Fastener {
    /// Name in the scene.
    pub name: String,
    /// Its layers, from the first face on.
    pub layers: Vec<Layer>,
}

/// A layer of a fastener.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Index of the slice in [`Results::bodies`](super::Results::bodies).
    pub slice: usize,
    /// Index of the plate there.
    pub plate: usize,
    /// Height of its middle above the first face of the fastener `[mm]`.
    pub height: f64,
}

/// A fastener at the end of a load step.
#[derive(Clone, Debug, PartialEq)]
pub struct FastenerStep {
    /// What happens in each of its layers.
    pub layers: Vec<LayerStep>,
    /// Moment of the forces F_i on its slices at the heights z_i, (Σ F_x z, Σ F_y z) `[N·mm]`: about +y and, turned, about −x. Head, nut and plates take it
    /// by bending out of the plane, which is not modelled; 0 for a shank that may tilt.
    pub tilting: [f64; 2],
}

/// A layer of a fastener at the end of a load step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerStep {
    /// Contact force of the plate on the slice `[N]`.
    pub force: [f64; 2],
    /// Contact moment of the plate on the slice about its centre `[N·mm]`.
    pub moment: f64,
    /// Shear force in the shank between this layer and the next: the sum of the forces up to here `[N]`.
    pub shear: [f64; 2],
    /// Mean displacement of the slice from where it starts `[mm]`.
    pub displacement: [f64; 2],
}
