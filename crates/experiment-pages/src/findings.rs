//! Sentences for findings: the only place where a finding becomes text.

mod data;
mod edge;
mod friction;
mod shown;

pub(super) use shown::shown;
use stickslip_experiment::Experiment;
use stickslip_measure::finding::{Finding, Level, Located, Part};

pub(super) use edge::why;
pub(super) use friction::on_half_the_cells;

/// A finding as a sentence, with the name of its state in front.
pub fn sentence(experiment: &Experiment, found: &Located) -> String {
    of("State", experiment, found)
}

/// The same in the lines of `stickslip check`, which begin with their subject.
pub(super) fn line(experiment: &Experiment, found: &Located) -> String {
    of("state", experiment, found)
}

fn of(state: &str, experiment: &Experiment, found: &Located) -> String {
    let part = match (found.part, found.finding.level()) {
        (Part::State, _) => "",
        (Part::NullField, Level::Remark) => "the null field: ",
        (Part::NullField, Level::Warning) => "The null field: ",
        (Part::Back, Level::Remark) => "the back: ",
        (Part::Back, Level::Warning) => "The back: ",
    };
    let message = message(experiment, &found.finding);
    match &found.state {
        Some(name) => format!("{state} '{name}': {part}{message}"),
        None => format!("{part}{message}"),
    }
}

fn message(experiment: &Experiment, finding: &Finding) -> String {
    match finding {
        Finding::File(own) => data::of_file(own),
        Finding::Table(own) => data::of_table(experiment, own),
        Finding::Field(own) => data::of_field(experiment, own),
        Finding::Picture(own) => data::of_pictures(own),
        Finding::Line(own) => data::of_lines(experiment, own),
        Finding::Back(own) => data::of_back(own),
        Finding::Fit(own) => edge::of_fit(experiment, own),
        Finding::Force(own) => edge::of_forces(experiment, own),
        Finding::Friction(own) => friction::of_zones(own),
        Finding::Model(own) => friction::of_model(experiment, own),
    }
}

pub(super) fn yes_or_no(is_so: bool) -> String {
    if is_so { "yes" } else { "no" }.to_owned()
}
