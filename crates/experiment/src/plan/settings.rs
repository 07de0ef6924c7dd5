//! `[reduce]`, `[region]` and `[identify]`.

use std::fmt::Display;
use std::path::Path;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::region::fit::{Amount, Smoothing};

use super::refuse::{Refuse, place};
use crate::format::{
    FreeFormat, IdentifyFormat, MethodFormat, OutliersFormat, ReduceFormat, RegionFormat,
    SectorFormat, SmoothingFormat, SymmetryFormat,
};
use crate::{
    FreeMotion, Hole, Identify, MeshPlan, Method, Reduce, RegionPlan, RegionShape, SectorPlan,
    State, SymmetryPlan, ZonePlan,
};
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::units::{Length, Quantity};

/// Part of the cross-validated smoothing that keeps the bias of stresses below half of their noise.
const SHARE: f64 = 0.4;
/// How far off its neighbours an outlier is, over what is usual: smooth fields stay below 6.4 with any noise, and all gross errors of 100
/// standard deviations are beyond.
const OUTLIERS: f64 = 8.0;
/// A whole turn and rounding.
const WHOLE_TURN: f64 = std::f64::consts::TAU + 1e-9;

pub(super) fn reduce(refuse: Refuse<'_>, given: &ReduceFormat) -> Result<Reduce, SceneError> {
    let length = |given: &Option<Quantity<Length>>| given.as_ref().map(Quantity::value);
    let symmetry = given.symmetry.as_ref();
    Ok(Reduce {
        method: method(refuse, given)?,
        stride: given.stride,
        band: given.band.unwrap_or(0.75),
        least_modulation: given.least_modulation.unwrap_or(0.25),
        settled: given.settled.unwrap_or(1e-3),
        margin: length(&given.margin),
        longest_side: length(&given.longest_side),
        mask: refuse.areas("reduce.mask", &given.mask)?,
        outliers: match given.outliers {
            Some(OutliersFormat::Asked(false)) => None,
            Some(OutliersFormat::Asked(true)) | None => Some(OUTLIERS),
            Some(OutliersFormat::Beyond(threshold)) => Some(threshold),
        },
        common_places: length(&given.common_places),
        symmetry: symmetry
            .map(|line| self::symmetry(refuse, line))
            .transpose()?,
        free: free(&given.free),
    })
}

/// Each once, whatever the order.
fn free(given: &[FreeFormat]) -> Vec<FreeMotion> {
    let is_free = |motion: &FreeMotion| {
        given.contains(match motion {
            FreeMotion::Dilation => &FreeFormat::Dilation,
            FreeMotion::TiltX | FreeMotion::TiltY => &FreeFormat::Tilt,
        })
    };
    FreeMotion::ALL.into_iter().filter(is_free).collect()
}

fn method(refuse: Refuse<'_>, given: &ReduceFormat) -> Result<Method, SceneError> {
    let order = given.order.unwrap_or(2);
    let least = (order + 1) * (order + 2) / 2;
    let neighbours = given.neighbours.unwrap_or(2 * least);
    if neighbours < least {
        let allowed = format!("at least {least} for a polynomial of order {order}");
        return Err(refuse.out_of_range("reduce.neighbours", &neighbours, &allowed));
    }
    let reach = given.reach.as_ref();
    Ok(match given.method {
        MethodFormat::Linear => Method::Linear,
        MethodFormat::Polynomial => Method::Polynomial { order, neighbours },
        MethodFormat::Lines => Method::Lines {
            reach: reach.map_or(f64::INFINITY, Quantity::value),
        },
        MethodFormat::Fit => Method::Fit,
    })
}

fn symmetry(refuse: Refuse<'_>, given: &SymmetryFormat) -> Result<SymmetryPlan, SceneError> {
    let ends = [place(&given.from), place(&given.to)];
    if ends[0] == ends[1] {
        let message = "the line of symmetry has no length";
        let remedy = "give two different ends";
        return Err(refuse.conflict("reduce.symmetry.to", message, remedy));
    }
    Ok(SymmetryPlan {
        ends,
        tolerance: given.tolerance.unwrap_or(0.25),
        places: given.places.unwrap_or(41),
    })
}

pub(super) fn region(
    refuse: Refuse<'_>,
    given: &RegionFormat,
    hole: &Hole,
    folder: &Path,
) -> Result<RegionPlan, SceneError> {
    let shape = match (&given.sector, &given.mesh) {
        (Some(sector), None) => RegionShape::Sector(self::sector(refuse, sector, hole)?),
        (None, Some(mesh)) => RegionShape::Mesh(MeshPlan {
            file: folder.join(&mesh.file),
            scale: mesh.scale.value(),
        }),
        _ => {
            let message = "a region is a sector or a mesh";
            let remedy = "write sector = { angles = [\"-90 deg\", \"90 deg\"], outer = \"15 mm\", cells = [24, 6] }, or mesh = { file = \"region.msh\", scale = \"1 mm\" }";
            return Err(refuse.conflict("region", message, remedy));
        }
    };
    Ok(RegionPlan {
        shape,
        interior: refuse.areas("region.interior", &given.interior)?,
        whole_plate: given.whole_plate,
        smoothing: smoothing(refuse, given.smoothing.as_ref())?,
    })
}

fn sector(refuse: Refuse<'_>, given: &SectorFormat, hole: &Hole) -> Result<SectorPlan, SceneError> {
    let refused = |name: &str, found: &dyn Display, allowed: &str| {
        Err(refuse.out_of_range(&format!("region.sector.{name}"), found, allowed))
    };
    let [first, last] = &given.angles;
    let angles = [first.value(), last.value()];
    let turn = angles[1] - angles[0];
    if !(turn > 0.0 && turn <= WHOLE_TURN) {
        let found = format!("[{}, {}]", first.text(), last.text());
        let allowed = "two angles that increase by at most a whole turn";
        return refused("angles", &found, allowed);
    }
    let stand_off = given.stand_off.as_ref().map_or(0.0, Quantity::value);
    let (outer, inner) = (given.outer.value(), hole.radius + stand_off);
    if outer <= inner {
        let allowed = format!("greater than hole radius and stand-off together, {inner} mm");
        return refused("outer", &given.outer.text(), &allowed);
    }
    let [around, outwards] = given.cells;
    let fits = around > 0 && outwards > 0 && around.saturating_mul(outwards) <= 1_000_000;
    if !fits {
        let allowed = "at least one cell around and outwards, a million together at most";
        return refused("cells", &format!("[{around}, {outwards}]"), allowed);
    }
    Ok(SectorPlan {
        angles,
        outer,
        cells: given.cells,
        stand_off,
        growth: given.growth.unwrap_or(1.0),
        element: given.element.unwrap_or(ElementKind::Q8),
    })
}

fn smoothing(refuse: Refuse<'_>, given: Option<&SmoothingFormat>) -> Result<Smoothing, SceneError> {
    let order = given.and_then(|given| given.order).unwrap_or(2);
    let amount = given.and_then(|given| given.amount);
    let share = given.and_then(|given| given.share);
    let amount = match (amount, share) {
        (Some(amount), None) => Amount::Given(amount),
        (None, share) => Amount::CrossValidated {
            share: share.unwrap_or(SHARE),
        },
        (Some(_), Some(_)) => {
            let message = "amount and share are both given";
            let remedy = "keep one of them";
            return Err(refuse.conflict("region.smoothing", message, remedy));
        }
    };
    Ok(Smoothing { order, amount })
}

pub(super) fn identify(
    refuse: Refuse<'_>,
    given: &IdentifyFormat,
    states: &[State],
) -> Result<Identify, SceneError> {
    let mut zones = Vec::new();
    for (index, zone) in given.zones.iter().enumerate() {
        let key = format!("identify.zones.{index}");
        let Some(state) = states.iter().position(|state| state.name == zone.state) else {
            let known = states.iter().map(|state| state.name.clone());
            return Err(refuse.undefined("state", &format!("{key}.state"), &zone.state, known));
        };
        let angles = [zone.from.value(), zone.to.value()];
        if angles[1] <= angles[0] {
            let allowed = format!("greater than {}", zone.from.text());
            return Err(refuse.out_of_range(&format!("{key}.to"), &zone.to.text(), &allowed));
        }
        zones.push(ZonePlan { state, angles });
    }
    Ok(Identify {
        confidence: given.confidence.unwrap_or(0.95),
        samples: given.samples.unwrap_or(1000),
        seed: given.seed.unwrap_or(1),
        bearing: given.bearing.as_ref().map(Quantity::value),
        zones,
    })
}
