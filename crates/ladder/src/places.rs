//! Where a peak may be as well: at every node whose value is within the error of the peak.

use super::numbers::{Numbers, Table};
use stickslip_engine::results::{EdgeRow, Errors, Nodes, Stated};

/// The peak whose place is `stated`, if it is one.
pub(super) fn peak_at(stated: Stated) -> Option<Stated> {
    match stated {
        Stated::PeakPressurePlace => Some(Stated::PeakPressure),
        Stated::PeakHoopPlace => Some(Stated::PeakHoop),
        _ => None,
    }
}

/// Widens the errors of the places of peaks among `errors` of the numbers `of` to where the errors of those peaks, now with all their parts, reach: a load
/// path may move the largest stress from one end of slip to another. On a closed edge nothing is farther away than half of it.
pub(super) fn widen(errors: &mut Table, of: &Numbers) {
    for (step, edges) in errors.iter_mut().enumerate() {
        for (edge, own) in edges.iter_mut().enumerate() {
            let widened = Errors::of(|stated| {
                let error = own.get(stated)?;
                let of_peak = peak_at(stated).and_then(|peak| own.get(peak));
                let reach = of_peak.map_or(0.0, |peak| reach(of, [step, edge], stated, peak));
                let error = error.max(reach);
                let closed = of.geometries[edge].closed();
                let half = closed.filter(|_| peak_at(stated).is_some());
                Some(half.map_or(error, |length| error.min(0.5 * length)))
            });
            *own = widened;
        }
    }
}

/// How far from the `place` of a peak, in a step and on an edge, a node lies whose value is within the peak's `error`.
pub(super) fn reach(of: &Numbers, [step, edge]: [usize; 2], place: Stated, error: f64) -> f64 {
    let (results, geometry) = (&of.steps[step][edge], &of.own[step][edge]);
    let is_hoop = place == Stated::PeakHoopPlace;
    let found = if is_hoop {
        results.peak_hoop
    } else {
        results.peak_pressure
    };
    let Some((most, place)) = found else {
        return 0.0;
    };
    let value = |row: &EdgeRow| {
        if is_hoop {
            row.sigma_tangential
        } else {
            row.pressure
        }
    };
    let rows = results.rows.iter().zip(&geometry.parameter);
    let high = rows.filter(|(row, _)| value(row) >= most - error);
    let away = high.map(|(_, at)| {
        let away = (at - place).abs();
        let closed = geometry.closed();
        closed.map_or(away, |length| away.min(length - away))
    });
    // A fit between nodes has the place of the largest stress.
    let own = if is_hoop {
        0.0
    } else {
        0.5 * Nodes::of(geometry).spacing(place)
    };
    away.fold(own, f64::max)
}
