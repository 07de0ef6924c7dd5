//! What the laboratory measures: the truth on a finer mesh, seen with errors, in files of the experiment format.

use std::fmt::Write as _;
use std::path::Path;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use serde_json::{Value, json};
use stickslip::experiment::Experiment;
use stickslip::experiment::synthesis::Camera;
use stickslip::experiment::truth::Truth;
use stickslip::host::HOST;
use stickslip::scene::Format;
use stickslip_hybrid::data::Field;
use stickslip_hybrid::fringe::{self, Depth, PixelMap};

use super::lab::Lab;
use super::parts::is_loading;
use super::truth::Medium;
use crate::publish::TaskError;
use crate::torture::quantity::{mm, text};

/// Half of the window that is seen, over the radius of the hole.
const WINDOW: f64 = 1.5;

/// The solved truth and the files of what is measured of it.
pub(super) struct Measurable {
    pub(super) truth: Truth,
    /// The experiment whose states are load steps of the truth.
    pub(super) known: Experiment,
    /// The experiment that is asked, whose states are files.
    pub(super) asked: Experiment,
    /// Displacements `[mm]` of each state without errors, rotation included, at the rows of its table.
    pub(super) exact: Vec<[Vec<f64>; 2]>,
}

impl Measurable {
    /// Solves the truth of `lab`, and writes what is measured into `folder`.
    pub(super) fn new(lab: &Lab, folder: &Path) -> Result<Self, TaskError> {
        std::fs::write(folder.join("scene.json"), lab.scene.to_string())?;
        let known = experiment(&known(lab), folder)?;
        let scene = known.specimen.scene.as_ref().ok_or("no scene")?;
        let truth = Truth::solve(scene, &mut |_| ())?;
        let mut exact = Vec::new();
        let mut states = Vec::new();
        for (index, &step) in lab.steps.iter().enumerate() {
            let name = format!("s{step}");
            let mut state = json!({
                "name": name,
                "load": text(lab.loads[step - 1], "N"),
                "direction": if is_loading(step) { "loading" } else { "unloading" },
            });
            if lab.states_force {
                state["edge_force"] = json!({ "x": text(lab.loads[step - 1], "N"), "y": "0 N" });
            }
            let mut random = StdRng::seed_from_u64(lab.seed.wrapping_mul(1009) + index as u64);
            match lab.medium {
                Medium::Table { spacing, reach } => {
                    let own = table(lab, &truth, step - 1, (spacing, reach), &mut random);
                    std::fs::write(folder.join(format!("{name}.csv")), own.text)?;
                    state["table"] = source_of_table(lab, &name);
                    exact.push(own.exact);
                }
                Medium::Pictures { .. } => {
                    let camera = Camera::new(&known, &truth)?;
                    pictures(lab, &camera, step - 1, folder, &name, &mut random)?;
                    state["pictures"] = source_of_pictures(lab, &name);
                }
            }
            states.push(state);
        }
        let mut asked = lab.experiment.clone();
        asked["states"] = states.into();
        if let Medium::Pictures { frequency, .. } = lab.medium {
            asked["grating"] = json!({ "frequency": text(frequency, "1/mm") });
        }
        let asked = experiment(&asked, folder)?;
        Ok(Self {
            truth,
            known,
            asked,
            exact,
        })
    }
}

fn experiment(value: &Value, folder: &Path) -> Result<Experiment, TaskError> {
    let none: [&str; 0] = [];
    let text = value.to_string();
    Ok(Experiment::from_text(
        &text,
        Format::Json,
        "experiment.json",
        folder,
        &none,
        HOST,
    )?)
}

/// The experiment whose states are load steps of the truth.
fn known(lab: &Lab) -> Value {
    let mut known = json!({
        "version": 1,
        "specimen": lab.experiment["specimen"],
        "states": lab.steps.iter().map(|step| json!({ "name": format!("s{step}"), "step": step })).collect::<Vec<_>>(),
        "grating": { "frequency": "100 1/mm" },
        "fringes": { "window": window(lab), "pixel": mm(lab.radius) },
    });
    known["specimen"]["overrides"] = lab.overrides.clone().into();
    if let Medium::Pictures {
        frequency, pixel, ..
    } = lab.medium
    {
        known["grating"]["frequency"] = text(frequency, "1/mm");
        known["fringes"]["pixel"] = mm(pixel);
    }
    known
}

fn window(lab: &Lab) -> Value {
    let half = WINDOW * lab.radius;
    json!([[mm(-half), mm(-half)], [mm(half), mm(half)]])
}

fn source_of_table(lab: &Lab, name: &str) -> Value {
    let mut source = json!({ "file": format!("{name}.csv"), "scale": "1 mm", "y_axis": "up" });
    if lab.states_deviation {
        source["deviation"] = mm(lab.noise);
    }
    match lab.wrong {
        Some("scale") => source["displacement_scale"] = "1.01 mm".into(),
        Some("origin") => source["origin"] = json!([0.006 * lab.radius, 0.0]),
        _ => {}
    }
    source
}

fn source_of_pictures(lab: &Lab, name: &str) -> Value {
    let Medium::Pictures { carrier, pixel, .. } = lab.medium else {
        return Value::Null;
    };
    let half = WINDOW * lab.radius;
    json!({
        "u": format!("{name}-u.png"),
        "v": format!("{name}-v.png"),
        "pixel": mm(pixel),
        "top_left": [mm(-half), mm(half)],
        "y_axis": "up",
        "dark": 0.02,
        "carrier": { "u": [text(carrier, "1/mm"), "0 1/mm"], "v": ["0 1/mm", text(carrier, "1/mm")] },
    })
}

/// A table of a state.
struct Table {
    text: String,
    exact: [Vec<f64>; 2],
}

/// Displacements on a square grid around the hole, turned and dilated as a whole, with errors.
fn table(
    lab: &Lab,
    truth: &Truth,
    step: usize,
    (spacing, reach): (f64, usize),
    random: &mut StdRng,
) -> Table {
    let half = (WINDOW * lab.radius / spacing).floor() as i64;
    let side = 2 * half as usize + 1 + reach;
    let errors: [Vec<f64>; 2] = [0, 1].map(|_| (0..side * side).map(|_| normal(random)).collect());
    let indices: Vec<[i64; 2]> = (-half..=half)
        .flat_map(|i| (-half..=half).map(move |j| [i, j]))
        .collect();
    let place = |own: &[i64; 2]| own.map(|k| spacing * k as f64);
    let places: Vec<[f64; 2]> = indices.iter().map(place).collect();
    let sampling = truth.sampled(&places);
    let moved = [0, 1].map(|axis| truth.component(&sampling, step, axis));
    let (sine, cosine) = lab.rotation.sin_cos();
    let mut found = Table {
        text: "x,y,u,v\n".to_owned(),
        exact: [Vec::new(), Vec::new()],
    };
    for (k, own) in indices.iter().enumerate() {
        let [x, y] = places[k];
        let (Some(u), Some(v)) = (moved[0][k], moved[1][k]) else {
            continue;
        };
        if x.hypot(y) < lab.clear * lab.radius {
            continue;
        }
        let [a, b] = [x + u, y + v].map(|own| own * (1.0 + lab.dilation));
        let exact = [cosine * a - sine * b - x, sine * a + cosine * b - y];
        let [row, column] = own.map(|k| (k + half) as usize);
        let error = |axis: usize| {
            let near = (0..reach * reach)
                .map(|k| errors[axis][(row + k / reach) * side + column + k % reach]);
            lab.noise * near.sum::<f64>() / reach as f64
        };
        // Writing into a string does not fail.
        let _ = writeln!(
            found.text,
            "{x:.6},{y:.6},{:.8},{:.8}",
            exact[0] + error(0),
            exact[1] + error(1)
        );
        for axis in 0..2 {
            found.exact[axis].push(exact[axis]);
        }
    }
    found
}

/// Pictures of 8 bits in uneven light, of a specimen turned and dilated as a whole.
fn pictures(
    lab: &Lab,
    camera: &Camera<'_>,
    step: usize,
    folder: &Path,
    name: &str,
    random: &mut StdRng,
) -> Result<(), TaskError> {
    let Medium::Pictures {
        frequency,
        carrier,
        falloff,
        ..
    } = lab.medium
    else {
        return Ok(());
    };
    let corner = WINDOW * lab.radius * 2.0_f64.sqrt();
    for (axis, field) in Field::BOTH.into_iter().enumerate() {
        let moved = camera.displacement(step, field)?;
        let frame = *camera.frame();
        let intensity = |(pixel, displacement): (usize, &f64)| {
            if !displacement.is_finite() {
                return f64::NAN;
            }
            let place = frame.place(pixel);
            let turned = [-lab.rotation * place[1], lab.rotation * place[0]][axis];
            let seen = displacement + turned + lab.dilation * place[axis];
            let error = lab.noise * (2.0 * random.random::<f64>() - 1.0);
            let order = frequency * seen + carrier * place[axis] + error;
            let light = 1.0 - falloff * (place[0].hypot(place[1]) / corner).powi(2);
            let camera = 0.01 * normal(random);
            (light * (0.5 + 0.4 * (std::f64::consts::TAU * order).cos()) + camera).max(0.03)
        };
        let values = moved.values().iter().enumerate().map(intensity).collect();
        let picture = PixelMap::with_gaps(frame, values)?;
        let bytes = fringe::encode(&picture, fringe::Format::Png, Depth::Eight)?;
        let letter = ["u", "v"][axis];
        std::fs::write(folder.join(format!("{name}-{letter}.png")), bytes)?;
    }
    Ok(())
}

/// A standard normal number, to the fourth moment within 3 %.
fn normal(random: &mut StdRng) -> f64 {
    const TERMS: usize = 12;
    (0..TERMS).map(|_| random.random::<f64>()).sum::<f64>() - 0.5 * TERMS as f64
}
