//! Sentences on the assumed signs and axes: a wrong sign reverses friction and shows nowhere else.

use stickslip_hybrid::data::YAxis;

use stickslip_experiment::{Experiment, LineSource, PictureSource, Source, State, TableSource};

/// Signs and axes of the data of each state that are files, states with the same ones together: their names, and the signs.
pub(crate) fn signs(experiment: &Experiment) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    for state in &experiment.states {
        let Some(signs) = of_state(state) else {
            continue;
        };
        match all.iter_mut().find(|(_, listed)| *listed == signs) {
            Some((names, _)) => *names = format!("{names}, {}", state.name),
            None => all.push((state.name.clone(), signs)),
        }
    }
    all
}

/// Those of a state, and of its null field and its back where they differ.
fn of_state(state: &State) -> Option<String> {
    let own = of_source(&state.source);
    let others = [("the null field", &state.null), ("the back", &state.back)];
    let others = others.into_iter().filter_map(|(name, source)| {
        let signs = of_source(source.as_ref()?)?;
        (Some(&signs) != own.as_ref()).then(|| format!("{name}: {signs}"))
    });
    let all: Vec<String> = own.iter().cloned().chain(others).collect();
    (!all.is_empty()).then(|| all.join("; "))
}

fn of_source(source: &Source) -> Option<String> {
    match source {
        Source::Step(_) => None,
        Source::Table(own) => Some(of_table(own)),
        Source::Lines(own) => Some(of_lines(own)),
        Source::Pictures(own) => Some(of_pictures(own)),
    }
}

fn of_table(own: &TableSource) -> String {
    format!(
        "y of the table points {}; {}",
        pointing(own.reading.y_axis == YAxis::Up),
        counting("", own.reading.reversed)
    )
}

fn of_lines(own: &LineSource) -> String {
    let [u, v] = &own.reading;
    format!(
        "y of the tables points {}; {}",
        pointing(u.y_axis == YAxis::Up),
        counting("orders of ", [u.reversed, v.reversed])
    )
}

fn pointing(up: bool) -> &'static str {
    if up { "up" } else { "down" }
}

/// Along which axes displacements count.
fn counting(what: &str, reversed: [bool; 2]) -> String {
    match reversed {
        [false, false] => {
            format!("{what}u and v count along its x and y, as neither is `reversed`")
        }
        [true, false] => {
            format!("{what}u count against its x, as `reversed` says, {what}v along its y")
        }
        [false, true] => {
            format!("{what}u count along its x, {what}v against its y, as `reversed` says")
        }
        [true, true] => {
            format!("{what}u and v count against its x and y, as both are `reversed`")
        }
    }
}

fn of_pictures(own: &PictureSource) -> String {
    let orders = match (own.files.iter().any(|files| files.len() > 1), own.carrier) {
        (true, _) => {
            "orders rise where the phase does, by a quarter from one of the four pictures to the next"
                .to_owned()
        }
        (false, Some(_)) => "orders rise along the carrier that is stated".to_owned(),
        (false, None) => {
            let [u, v] = own.rising.map(|[x, y]| format!("({x}, {y})"));
            format!("orders of u rise along {u}, of v along {v}, carrier included, by `rising`")
        }
    };
    format!(
        "y points {} in the pictures; {orders}",
        pointing(own.upright)
    )
}
