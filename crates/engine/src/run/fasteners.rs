//! What fasteners hand on at the end of a load step.

use nalgebra::DVector;
use stickslip_contact::StepRecord;

use super::solved::Solved;
use crate::model::{Model, ModelFastener};
use crate::results::{Fastener, FastenerStep, Finding, Layer, LayerStep, StepResults};

/// Part of the largest force of all fasteners in the history up to which forces are rounding.
const ROUNDING: f64 = 1e-12;
/// Part of the sum of forces times heights on a fastener, or of the largest force at the greatest height, up to which their moment is rounding:
/// solvers stop at 1e-10 of the largest force.
const BALANCED: f64 = 1e-9;

/// The fasteners of `model`.
pub(super) fn all(model: &Model) -> Vec<Fastener> {
    let plate = |slice: usize| {
        let pair = model.pairs.iter().find(|pair| pair.second == slice);
        pair.map_or(slice, |pair| pair.first)
    };
    let fastener = |own: &ModelFastener| Fastener {
        name: own.name.clone(),
        layers: (own.slices().iter().zip(&own.heights))
            .map(|(&slice, &height)| Layer {
                slice,
                plate: plate(slice),
                height,
            })
            .collect(),
    };
    model.fasteners.iter().map(fastener).collect()
}

/// The fasteners of `model` at the end of every load step.
pub(super) fn of_steps(model: &Model, solved: &Solved) -> Vec<Vec<FastenerStep>> {
    let fasteners = || model.fasteners.iter();
    let at = |record| {
        let all = fasteners().map(|fastener| step(fastener, model, solved, record));
        all.collect()
    };
    let mut steps: Vec<Vec<FastenerStep>> = solved.records.iter().map(at).collect();
    let layers = steps.iter().flatten().flat_map(|step| &step.layers);
    let largest = layers.map(|layer| size(layer.force)).fold(0.0, f64::max);
    for step in &mut steps {
        for (own, fastener) in step.iter_mut().zip(fasteners()) {
            clear_rounding(own, largest, &fastener.heights);
        }
    }
    steps
}

/// Sets to zero what is rounding in `step` beside the largest force `largest` of the history.
fn clear_rounding(step: &mut FastenerStep, largest: f64, heights: &[f64]) {
    for layer in &mut step.layers {
        for vector in [&mut layer.force, &mut layer.shear] {
            if size(*vector) <= ROUNDING * largest {
                *vector = [0.0; 2];
            }
        }
    }
    let sizes = step.layers.iter().zip(heights);
    let sizes = sizes.map(|(layer, height)| size(layer.force) * height);
    let highest = heights.last().copied().unwrap_or_default();
    let rounding = BALANCED * sizes.sum::<f64>().max(largest * highest);
    if size(step.tilting) <= rounding {
        step.tilting = [0.0; 2];
    }
}

fn size([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

fn step(
    fastener: &ModelFastener,
    model: &Model,
    solved: &Solved,
    record: &StepRecord,
) -> FastenerStep {
    let mut shear = [0.0; 2];
    let mut tilting = [0.0; 2];
    let mut layers = Vec::with_capacity(fastener.heights.len());
    for (&slice, &height) in fastener.slices().iter().zip(&fastener.heights) {
        let operator = solved.operators[slice].interface();
        let forces = solved.forces_on_body(record, slice);
        // Its motions are two translations and the turn times the radius.
        let pushed = operator.modes().tr_mul(&DVector::from_vec(forces));
        let mut loaded = pushed.clone();
        for (case, &factor) in record.state.multipliers.iter().enumerate() {
            loaded.axpy(factor, operator.mode_load(case), 1.0);
        }
        let moved = solved.interface.motions_of_body(slice, &record.state);
        for axis in 0..2 {
            shear[axis] += loaded[axis];
            tilting[axis] += loaded[axis] * height;
        }
        layers.push(LayerStep {
            force: [pushed[0], pushed[1]],
            moment: pushed[2] * model.radius_of(slice),
            shear,
            displacement: [moved[0], moved[1]],
        });
    }
    FastenerStep { layers, tilting }
}

/// Fasteners whose forces lie in layers beside each other.
pub(super) fn eccentric(model: &Model, steps: &[StepResults]) -> Option<Finding> {
    let tilts = |(index, _): &(usize, &ModelFastener)| {
        let mut own = steps.iter().map(|step| &step.fasteners[*index]);
        own.any(|own| own.tilting != [0.0; 2])
    };
    let fasteners = model.fasteners.iter().enumerate().filter(tilts);
    let fasteners: Vec<String> = fasteners.map(|(_, own)| own.name.clone()).collect();
    (!fasteners.is_empty()).then_some(Finding::EccentricLayers { fasteners })
}
