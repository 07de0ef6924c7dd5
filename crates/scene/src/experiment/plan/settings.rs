//! `[reduce]`, `[region]` and `[identify]`.

use std::path::Path;

use stickslip_hybrid::region::fit::{Amount, Smoothing};

use super::read::{Refuse, place};
use super::{
    FreeMotion, Hole, Identify, MeshPlan, Method, Reduce, RegionPlan, RegionShape, SectorPlan,
    State, SymmetryPlan, ZonePlan,
};
use crate::diagnostic::{SceneError, SceneProblem, nearest};
use crate::experiment::format::{
    FreeFormat, IdentifyFormat, MethodFormat, OutliersFormat, ReduceFormat, RegionFormat,
    SymmetryFormat,
};

/// Part of the cross-validated smoothing that keeps the bias of stresses below half of their noise.
const SHARE: f64 = 0.4;
/// How far off its neighbours an outlier is, over what is usual: smooth fields stay below 6.4 with any noise, and all gross errors of 100
/// standard deviations are beyond.
const OUTLIERS: f64 = 8.0;
/// A whole turn and rounding.
const WHOLE_TURN: f64 = std::f64::consts::TAU + 1e-9;

pub(super) fn reduce(refuse: Refuse<'_>, given: &ReduceFormat) -> Result<Reduce, SceneError> {
    let number = |name: &str, value: f64, fits: bool, allowed: &str| {
        refuse.within(&format!("reduce.{name}"), value, fits, allowed)
    };
    let band = given.band.unwrap_or(0.75);
    let least = given.least_modulation.unwrap_or(0.25);
    let settled = given.settled.unwrap_or(1e-3);
    let margin = (given.margin.as_ref())
        .map(|margin| refuse.not_negative("reduce.margin", margin))
        .transpose()?;
    Ok(Reduce {
        method: method(refuse, given)?,
        stride: given
            .stride
            .map(|stride| refuse.within("reduce.stride", stride, stride > 0, "at least 1"))
            .transpose()?,
        band: number("band", band, band > 0.0 && band < 1.0, "between 0 and 1")?,
        least_modulation: number(
            "least_modulation",
            least,
            (0.0..1.0).contains(&least),
            "at least 0 and less than 1",
        )?,
        settled: number(
            "settled",
            settled,
            settled > 0.0 && settled < 1.0,
            "between 0 and 1",
        )?,
        margin,
        longest_side: (given.longest_side.as_ref())
            .map(|side| refuse.positive("reduce.longest_side", side))
            .transpose()?,
        mask: refuse.areas("reduce.mask", &given.mask)?,
        outliers: outliers(refuse, given.outliers)?,
        common_places: given
            .common_places
            .as_ref()
            .map(|length| refuse.not_negative("reduce.common_places", length))
            .transpose()?,
        symmetry: given
            .symmetry
            .as_ref()
            .map(|line| symmetry(refuse, line))
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

fn outliers(refuse: Refuse<'_>, given: Option<OutliersFormat>) -> Result<Option<f64>, SceneError> {
    match given {
        Some(OutliersFormat::Asked(false)) => Ok(None),
        Some(OutliersFormat::Asked(true)) | None => Ok(Some(OUTLIERS)),
        Some(OutliersFormat::Beyond(threshold)) => {
            let fits = threshold > 0.0 && threshold.is_finite();
            let allowed = "greater than 0, or false where none are to be looked for";
            refuse
                .within("reduce.outliers", threshold, fits, allowed)
                .map(Some)
        }
    }
}

fn method(refuse: Refuse<'_>, given: &ReduceFormat) -> Result<Method, SceneError> {
    let length = |name: &str, given: Option<&crate::units::Quantity<crate::units::Length>>| {
        let key = format!("reduce.{name}");
        given.map_or(Ok(f64::INFINITY), |length| refuse.positive(&key, length))
    };
    let reach = length("reach", given.reach.as_ref())?;
    let order = given.order.unwrap_or(2);
    refuse.within("reduce.order", order, (1..=3).contains(&order), "1, 2 or 3")?;
    let least = [3, 6, 10][order - 1];
    let neighbours = given.neighbours.unwrap_or(2 * least);
    refuse.within(
        "reduce.neighbours",
        neighbours,
        neighbours >= least,
        &format!("at least {least} for a polynomial of order {order}"),
    )?;
    Ok(match given.method {
        MethodFormat::Linear => Method::Linear,
        MethodFormat::Polynomial => Method::Polynomial { order, neighbours },
        MethodFormat::Lines => Method::Lines { reach },
        MethodFormat::Fit => Method::Fit,
    })
}

fn symmetry(refuse: Refuse<'_>, given: &SymmetryFormat) -> Result<SymmetryPlan, SceneError> {
    let ends = [place(&given.from), place(&given.to)];
    if ends[0] == ends[1] {
        return Err(refuse.conflict(
            "reduce.symmetry.to",
            "the line of symmetry has no length",
            "give two different ends",
        ));
    }
    let tolerance = given.tolerance;
    Ok(SymmetryPlan {
        ends,
        tolerance: refuse.within(
            "reduce.symmetry.tolerance",
            tolerance,
            tolerance >= 0.0,
            "at least 0, in fringes",
        )?,
        places: refuse.within(
            "reduce.symmetry.places",
            given.places,
            (2..=100_000).contains(&given.places),
            "from 2 to 100000",
        )?,
    })
}

pub(super) fn region(
    refuse: Refuse<'_>,
    given: &RegionFormat,
    hole: &Hole,
    folder: &Path,
) -> Result<RegionPlan, SceneError> {
    let shape = match (&given.sector, &given.mesh) {
        (Some(_), None) => RegionShape::Sector(sector(refuse, given, hole)?),
        (None, Some(mesh)) => RegionShape::Mesh(MeshPlan {
            file: folder.join(&mesh.file),
            scale: refuse.positive("region.mesh.scale", &mesh.scale)?,
        }),
        _ => {
            return Err(refuse.conflict(
                "region",
                "a region is a sector or a mesh",
                "write sector = { angles = [\"-90 deg\", \"90 deg\"], outer = \"15 mm\", cells = [24, 6] }, or mesh = { file = \"region.msh\", scale = \"1 mm\" }",
            ));
        }
    };
    Ok(RegionPlan {
        shape,
        interior: refuse.areas("region.interior", &given.interior)?,
        whole_plate: given.whole_plate,
        smoothing: smoothing(refuse, given)?,
    })
}

fn sector(refuse: Refuse<'_>, given: &RegionFormat, hole: &Hole) -> Result<SectorPlan, SceneError> {
    let Some(sector) = &given.sector else {
        return Err(refuse.missing("region", "sector", "sector = { … }"));
    };
    let angles = [sector.angles[0].value(), sector.angles[1].value()];
    let turn = angles[1] - angles[0];
    if !(turn > 0.0 && turn <= WHOLE_TURN) {
        let found = format!("[{}, {}]", sector.angles[0].text(), sector.angles[1].text());
        let allowed = "two angles that increase by at most a whole turn";
        return Err(refuse.out_of_range("region.sector.angles", &found, allowed));
    }
    let stand_off = match &sector.stand_off {
        Some(stand_off) => refuse.not_negative("region.sector.stand_off", stand_off)?,
        None => 0.0,
    };
    let outer = sector.outer.value();
    refuse.within(
        "region.sector.outer",
        sector.outer.text(),
        outer > hole.radius + stand_off,
        &format!(
            "greater than hole radius and stand-off together, {} mm",
            hole.radius + stand_off
        ),
    )?;
    let [around, outwards] = sector.cells;
    let fits = around > 0 && outwards > 0 && around.saturating_mul(outwards) <= 1_000_000;
    if !fits {
        let found = format!("[{around}, {outwards}]");
        let allowed = "at least one cell around and outwards, a million together at most";
        return Err(refuse.out_of_range("region.sector.cells", &found, allowed));
    }
    refuse.within(
        "region.sector.growth",
        sector.growth,
        sector.growth > 0.0,
        "greater than 0",
    )?;
    Ok(SectorPlan {
        angles,
        outer,
        cells: sector.cells,
        stand_off,
        growth: sector.growth,
        element: sector.element,
    })
}

fn smoothing(refuse: Refuse<'_>, given: &RegionFormat) -> Result<Smoothing, SceneError> {
    let Some(given) = &given.smoothing else {
        let amount = Amount::CrossValidated { share: SHARE };
        return Ok(Smoothing { order: 2, amount });
    };
    let key = "region.smoothing";
    let number = |name: &str, value: f64, fits: bool, allowed: &str| {
        refuse.within(&format!("{key}.{name}"), value, fits, allowed)
    };
    let amount = match (given.amount, given.share) {
        (Some(amount), None) => {
            Amount::Given(number("amount", amount, amount >= 0.0, "at least 0")?)
        }
        (None, share) => {
            let share = share.unwrap_or(SHARE);
            let share = number("share", share, share > 0.0, "greater than 0")?;
            Amount::CrossValidated { share }
        }
        (Some(_), Some(_)) => {
            return Err(refuse.conflict(
                key,
                "amount and share are two ways to say how much",
                "keep one of them",
            ));
        }
    };
    let order = refuse.within(
        "region.smoothing.order",
        given.order,
        [2, 3].contains(&given.order),
        "2 or 3",
    )?;
    Ok(Smoothing { order, amount })
}

pub(super) fn identify(
    refuse: Refuse<'_>,
    given: &IdentifyFormat,
    states: &[State],
) -> Result<Identify, SceneError> {
    let confidence = given.confidence.unwrap_or(0.95);
    let samples = given.samples.unwrap_or(1000);
    let mut zones = Vec::new();
    for (index, zone) in given.zones.iter().enumerate() {
        let key = format!("identify.zones.{index}");
        let Some(state) = states.iter().position(|state| state.name == zone.state) else {
            let known: Vec<String> = states.iter().map(|state| state.name.clone()).collect();
            let problem = SceneProblem::Undefined {
                what: "state",
                name: zone.state.clone(),
                nearest: nearest(&zone.state, known.iter().map(String::as_str)).map(str::to_owned),
                known,
            };
            return Err(refuse.at(&format!("{key}.state"), problem));
        };
        let angles = [zone.from.value(), zone.to.value()];
        refuse.within(
            &format!("{key}.to"),
            zone.to.text(),
            angles[1] > angles[0],
            &format!("greater than {}", zone.from.text()),
        )?;
        zones.push(ZonePlan { state, angles });
    }
    if let Some(own) = &given.bearing {
        refuse.within(
            "identify.bearing",
            own.text(),
            own.value().abs() <= WHOLE_TURN,
            "from -360 to 360 deg",
        )?;
    }
    Ok(Identify {
        confidence: refuse.within(
            "identify.confidence",
            confidence,
            confidence > 0.0 && confidence < 1.0,
            "between 0 and 1",
        )?,
        samples: refuse.within(
            "identify.samples",
            samples,
            (2..=1_000_000).contains(&samples),
            "from 2 to 1000000",
        )?,
        seed: given.seed.unwrap_or(1),
        bearing: given.bearing.as_ref().map(crate::units::Quantity::value),
        zones,
    })
}
