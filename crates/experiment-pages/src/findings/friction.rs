//! Sentences for findings of friction.

use stickslip_experiment::Experiment;
use stickslip_hybrid::identify::Bounds;
use stickslip_measure::finding::{FrictionFinding, ModelFinding};
use stickslip_measure::identified::describe_bounds;
use stickslip_text::short;

pub(super) fn of_zones(finding: &FrictionFinding) -> String {
    match finding {
        FrictionFinding::Rejected => {
            "One coefficient does not explain all slip zones together: friction changes within them, or the edge does not slip all over \
             them. No interval is given; fit laws by [[laws]], or state [identify] zones."
                .to_owned()
        }
        FrictionFinding::ZonesDisagree => {
            "The coefficients of the slip zones differ by more than their errors: at least one of them holds places that stick. No \
             interval is given; state [identify] zones, or fit laws by [[laws]]."
                .to_owned()
        }
        FrictionFinding::ZoneWithoutEnd => {
            "A slip zone reaches the bearing point, where friction turns: in this noise sticking places cannot be distinguished from \
             slipping ones. Only the outer half of it is used, and μd may still be larger than its interval says. State [identify] zones near \
             the end of contact, smooth more, or measure more data."
                .to_owned()
        }
        FrictionFinding::MeshMoves {
            half_the_cells,
            mu_on_half,
            bounds_on_half,
            ..
        } => format!(
            "The mesh moves μd by more than either interval leaves to noise. {} Take more cells until it stays.",
            on_half_the_cells(*half_the_cells, Some((*mu_on_half, *bounds_on_half)))
        ),
        FrictionFinding::MovesUnknown { cause } => {
            format!("How far static friction moves the edge is not known: {cause}.")
        }
        FrictionFinding::NoPressure { state } => {
            format!("state '{state}': no pressure exceeds its uncertainty.")
        }
        FrictionFinding::NoZone {
            state,
            after,
            bearing_degrees,
        } => format!(
            "state '{state}': no zone that slips is recognised at θ {} {bearing_degrees:.0}°.",
            if *after { ">" } else { "<" }
        ),
    }
}

/// What half of the cells give.
pub(crate) fn on_half_the_cells(
    [along, across]: [usize; 2],
    dynamic: Option<(f64, Bounds)>,
) -> String {
    let given = match dynamic {
        Some((mu, bounds)) => format!("μd is {mu:.4}, {}", describe_bounds(bounds)),
        None => "no zone is recognised".to_owned(),
    };
    format!("On half of the cells, [{along}, {across}], {given}.")
}

pub(super) fn of_model(experiment: &Experiment, finding: &ModelFinding) -> String {
    match finding {
        ModelFinding::LeftOutOfLaws(own) => own.to_string(),
        ModelFinding::NoWholePlate { state, reason } => {
            format!("State '{state}' is not analysed as a whole plate: {reason}.")
        }
        ModelFinding::NullLoadAssumed { state, step, load } => {
            let load = load.map_or_else(String::new, |load| {
                format!(" of {}", experiment.display.force.show(load))
            });
            format!(
                "The load of the measured null field of state '{state}' is not known: it is taken for that of step {step} of the scene, the \
                 smallest load{load} before it."
            )
        }
        ModelFinding::SharedMesh => {
            "The fitted model has the very mesh that made the synthetic pictures: errors of discretisation cancel, and what is found looks \
             better than it would be of a measurement. [specimen] model_overrides = [\"mesh.spacing=\\\"3 deg\\\"\"] gives the model a \
             mesh of its own."
                .to_owned()
        }
        ModelFinding::WithoutMeshError { cause } => format!(
            "Intervals hold the errors of the data alone and not that of the model's mesh, and a law may be preferred for what that mesh \
             does not resolve: a mesh twice as coarse, which would show it, cannot be solved: {cause}."
        ),
        ModelFinding::SensitivityUnknown {
            law,
            parameter,
            value,
            cause,
        } => format!(
            "How far the edge moves with '{parameter}' = {value} of law '{law}' is not known: {cause}."
        ),
        ModelFinding::DropWithoutLength => {
            "The drop from static to dynamic friction has no length of its own: what the static coefficient does depends on the spacing of \
             the contact nodes, and its bounds move with the mesh."
                .to_owned()
        }
        ModelFinding::NoLawExplains {
            law,
            chi_squared,
            degrees,
            excess,
        } => format!(
            "No law explains the data: that of the best, '{law}', leaves χ² = {} of {} degrees of freedom, {} standard deviations too many. \
             No interval is given: load, clearance, material, scale or place of the hole may be wrong; look at the residuals near the edge.",
            short(*chi_squared),
            degrees,
            short(*excess),
        ),
    }
}
