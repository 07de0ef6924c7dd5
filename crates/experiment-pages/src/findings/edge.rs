//! Sentences for findings of edge stresses.

use stickslip_experiment::Experiment;
use stickslip_measure::finding::{
    BearingFails, Check, FitFinding, ForceFinding, LoadFails, NotCompared,
};
use stickslip_text::{short, significant};

use super::shown;

pub(super) fn of_fit(experiment: &Experiment, finding: &FitFinding) -> String {
    match finding {
        FitFinding::FreeInRegionOnly => {
            "What [reduce] free declares is taken off the region alone: the whole plate and friction laws take displacements as they are."
                .to_owned()
        }
        FitFinding::CheckFails {
            check,
            chi_squared,
            count,
            deviation,
            dilation,
        } => format!(
            "{} has χ² = {} where {count} ± {} is expected: data, region or material do not fit together.{}",
            checked(*check),
            short(*chi_squared),
            short(*deviation),
            dilation.map_or_else(String::new, explanation)
        ),
        FitFinding::NoDirectStresses { cause } => {
            format!("no direct interpolation to compare with: {cause}.")
        }
        FitFinding::NoiseFactorAssumed { factor, cause } => format!(
            "the noise factor is assumed to be {}, because the fit whose residuals determine it fails: {cause}. Bands hold errors of the \
             standard deviation alone, and are too narrow where errors are larger or correlated.",
            short(*factor)
        ),
        FitFinding::ManyParameters { data, parameters } => format!(
            "{data} data determine {parameters:.0} parameters of the fit: the region has too many nodes for them, and neither its stresses nor \
             their bands can be trusted. Take fewer cells or smaller areas of region.interior, or state a smoothing amount."
        ),
        FitFinding::SmallResiduals {
            variance_ratio,
            stated,
        } => small_residuals(*variance_ratio, *stated),
        FitFinding::CorrelatedResiduals {
            of_means,
            of_singles,
            amount_stated,
        } => format!(
            "means of neighbouring residuals vary {} times as much as independent errors would make them, single residuals {}: errors of \
             neighbours are correlated, as those of overlapping subsets or filtered data are. Bands follow, but {}.",
            short(*of_means),
            short(*of_singles),
            of_smoothing(*amount_stated)
        ),
        FitFinding::WrongDeviation { variance_ratio } => format!(
            "the variance of the residuals is {} times that of the deviation; bands follow the residuals. Check the standard deviation.",
            short(*variance_ratio)
        ),
        FitFinding::NotSeparable {
            motion,
            pressure_per_unit,
        } => not_separable(experiment, motion, *pressure_per_unit),
    }
}

fn checked(check: Check) -> &'static str {
    match check {
        Check::UnusedPlaces => "the misfit at unused places",
        Check::FreeEdge => "the traction on the free edge",
        Check::NodesInside => "the force on the nodes inside that move as measured",
    }
}

/// A dilation that would explain tractions on the free edge.
fn explanation([amount, deviation]: [f64; 2]) -> String {
    format!(
        " If the picture was dilated, by {} ± {}, [reduce] free = [\"dilation\"] takes that off.",
        short(amount),
        significant(deviation, 2)
    )
}

/// What residuals far below the standard deviation of the data mean.
fn small_residuals(variance_ratio: f64, stated: bool) -> String {
    let found = format!(
        "the residuals have {} of the variance of the deviation",
        short(variance_ratio)
    );
    if stated {
        format!(
            "{found} that was stated, which bands follow: smoothed data have small residuals whatever their errors are. If the data are not \
             smoothed, state a smaller deviation; if they are, state the smoothing amount, which is found from residuals."
        )
    } else {
        format!(
            "{found} that was estimated: the data are calculated or smoothed, and bands hold what rounds their digits and the bias of \
             smoothing, not the error of a measurement or of the mesh. State the standard deviation that the measurement has."
        )
    }
}

/// What correlated errors of neighbours mean for the amount of smoothing.
fn of_smoothing(amount_stated: bool) -> &'static str {
    if amount_stated {
        "so do residuals where the stated amount smooths the displacements themselves away: compare a smaller region.smoothing amount"
    } else {
        "cross-validation takes errors for independent and smooths too little: state a smoothing amount, or take one of so many places \
         that their errors are independent"
    }
}

fn not_separable(experiment: &Experiment, motion: &str, pressure_per_unit: f64) -> String {
    format!(
        "the {motion} of the picture is declared free, and cannot be distinguished from the load: no part of the region's edge is \
         certainly clear of contact, or mesh, material or contact cause the tractions there. It is not taken off; 1e-5 of it \
         changes the pressure by up to {}. Take a region whose edge goes on beyond the contact, and finer cells.",
        shown(experiment.display.stress, 1e-5 * pressure_per_unit)
    )
}

pub(super) fn of_forces(experiment: &Experiment, finding: &ForceFinding) -> String {
    let (force, stress) = (experiment.display.force, experiment.display.stress);
    match finding {
        ForceFinding::EdgeForceFails {
            axis,
            excess,
            explained,
        } => format!(
            "the force on the edge along {axis} is {} off the stated edge_force, where {} are explained by noise, mesh, smoothing and ends of \
             the edge: check that the edge holds all of the contact that edge_force is of and does not stand off from the hole, and scale, \
             thickness and material.",
            shown(force, excess.abs()),
            shown(force, *explained),
        ),
        ForceFinding::EdgeForceIsNoEvidence {
            axis,
            explained,
            of_force,
        } => format!(
            "the stated edge_force along {axis} is no evidence of scale, thickness and material: noise, smoothing, mesh and ends of the edge \
             explain {}, {:.0} % of the force. Take more cells, more data, or a region whose edge goes on beyond the contact.",
            shown(force, *explained),
            100.0 * of_force
        ),
        ForceFinding::LoadNotChecked { reason } => format!(
            "the size of the force on the edge is not checked, for {}: wrong units of thickness, moduli or displacements would not show. {}.",
            why(*reason),
            remedy(*reason)
        ),
        ForceFinding::Pulled {
            tension,
            theta_degrees,
        } => format!(
            "the edge bears a tension of {} at θ = {theta_degrees:.0}°, more than any pressure, and no contact pulls: check the signs of the \
             displacements (table.reversed, the sense of the fringe orders) and which state is the unloaded one.",
            shown(stress, *tension)
        ),
        ForceFinding::LoadFails(own) => load_fails(experiment, own),
        ForceFinding::BearingFails(own) => bearing_fails(own),
    }
}

/// Why the force on an edge and the load of its state are not compared.
pub(crate) fn why(reason: NotCompared) -> &'static str {
    match reason {
        NotCompared::NoLoad => "no load is stated",
        NotCompared::ZeroLoad => "the load is zero",
        NotCompared::OtherLoads => "other loads or contacts of the scene take part",
        NotCompared::NoContact => "no pressure on it exceeds its uncertainty",
        NotCompared::Noise => "noise hides where the contact ends",
        NotCompared::NoEnd => "neither end of the contact is in sight",
        NotCompared::DoubtfulBearing => "the bearing point is doubtful",
        NotCompared::HiddenBearing => "the bearing point is out of sight",
    }
}

/// What makes a check of it.
fn remedy(reason: NotCompared) -> &'static str {
    match reason {
        NotCompared::NoLoad => {
            "State load, with a region that holds an end of the contact, or edge_force"
        }
        NotCompared::ZeroLoad => "A state whose load is not that of its null field would show them",
        NotCompared::OtherLoads => "State edge_force: what of them crosses this edge",
        NotCompared::NoContact | NotCompared::Noise => {
            "State edge_force, or take pictures with less noise or more load"
        }
        NotCompared::NoEnd | NotCompared::HiddenBearing => {
            "State edge_force, or take a region that holds an end of the contact and the bearing point"
        }
        NotCompared::DoubtfulBearing => "Check identify.bearing, or state edge_force",
    }
}

fn load_fails(experiment: &Experiment, own: &LoadFails) -> String {
    let force = experiment.display.force;
    let null = if own.above_null {
        ", which counts from the null field"
    } else {
        ""
    };
    let bearing = own.bearing_degrees.map_or_else(String::new, |bearing| {
        format!(
            "; the bearing point at θ = {bearing:.0}° (identify.bearing), about which the part of the contact that the region cuts is taken \
             for the mirror image of the other"
        )
    });
    format!(
        "the force on the edge is {} ± {}{null}, {} times the stated load of {}: check units and values of thickness ({}), of the material's \
         moduli, of load, and of displacement_scale or the grating's frequency{bearing}; or whether this load is that of the contact.",
        shown(force, own.force),
        shown(force, own.deviation),
        short(own.force / own.load),
        shown(force, own.load),
        shown(experiment.display.length, own.thickness)
    )
}

fn bearing_fails(own: &BearingFails) -> String {
    let assumed = if own.stated {
        "stated by identify.bearing"
    } else {
        "assumed, as identify.bearing is not stated"
    };
    let remedy = if own.is_whole {
        format!(
            "All of the contact is in sight: write [identify] bearing = \"{:.0} deg\", or leave it out",
            own.direction_degrees
        )
    } else {
        "The region cuts the contact: write as [identify] bearing the direction in which the pin presses the hole, counted from +x \
         towards +y in the frame of the data, or take a region that holds all of the contact"
            .to_owned()
    };
    format!(
        "the force on the edge in sight points to θ = {:.1} ± {:.1}°, {:.0}° beyond what a bearing point at θ = {:.1}° explains, which is \
         {assumed}. Slip zones are counted from there, and friction may be wrong. {remedy}.",
        own.direction_degrees, own.deviation_degrees, own.beyond_degrees, own.bearing_degrees
    )
}
