//! CalculiX: writes an input deck, runs `ccx`, reads the displacements.

use std::fmt::Write as _;
use std::process::Command;

use stickslip_fem_core::mesh::ElementKind;

use super::PeerRun;
use super::job::{Cost, Job, POISSON, PSI, Part, Steps, YOUNG, wait};
use crate::publish::TaskError;

/// How contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contact {
    SurfaceToSurface,
    NodeToSurface,
}

impl Contact {
    fn name(self) -> &'static str {
        match self {
            Self::SurfaceToSurface => "surface-to-surface penalty",
            Self::NodeToSurface => "node-to-surface penalty",
        }
    }

    /// Contact stiffness on which its results have converged without oscillating `[MPa/mm]`: 1e9 and 1e10 psi/in.
    fn stiffness(self) -> f64 {
        match self {
            Self::SurfaceToSurface => 1e9 * PSI / 25.4,
            Self::NodeToSurface => 1e10 * PSI / 25.4,
        }
    }
}

/// Nodes that are apart by less than this `[mm]` feel each other in node-to-surface contact.
const REACH: f64 = 2.54e-6;
/// Contact, element of CalculiX, the mesh's, its name in the table, and the spacings `[deg]`.
const FAMILIES: [(Contact, &str, ElementKind, &str, &[f64]); 3] = [
    (
        Contact::SurfaceToSurface,
        "CPS4",
        ElementKind::Q4,
        "Q4",
        &[9.0, 4.5, 2.25, 1.125],
    ),
    (
        Contact::SurfaceToSurface,
        "CPS8R",
        ElementKind::Q8,
        "Q8R",
        &[9.0, 4.5],
    ),
    (
        Contact::NodeToSurface,
        "CPS4",
        ElementKind::Q4,
        "Q4",
        &[9.0, 4.5, 2.25],
    ),
];

/// What `ccx -v` says, if it is installed.
pub(super) fn version() -> Option<String> {
    let output = Command::new("ccx").arg("-v").output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let number = text.split_whitespace().last()?;
    Some(format!("CalculiX {number}"))
}

/// Runs all families without and with friction.
pub(super) fn runs(version: &str) -> Result<Vec<PeerRun>, TaskError> {
    let mut runs = Vec::new();
    for mu in [0.0, 0.25] {
        for (contact, cell, kind, element, spacings) in FAMILIES {
            for &spacing in spacings {
                let job = Job::new(mu, kind, spacing)?;
                let (cost, steps) = follow(&deck(&job, contact, cell)?, &job)?;
                let [contact, element] = [contact.name(), element].map(str::to_owned);
                runs.push(job.peer_run(version, contact, element, cost, &steps)?);
            }
        }
    }
    Ok(runs)
}

/// Runs `deck`: what it took, and the plate's displacements at the end of each step.
fn follow(deck: &str, job: &Job) -> Result<(Cost, Steps), TaskError> {
    let folder = tempfile::tempdir()?;
    let input = folder.path().join("pin.inp");
    std::fs::write(&input, deck)?;
    let cost = wait(
        Command::new("ccx")
            .arg("pin")
            .current_dir(folder.path())
            .env("OMP_NUM_THREADS", "1"),
    )?;
    // A run that stopped early has the steps up to there.
    let text = std::fs::read_to_string(folder.path().join("pin.frd")).unwrap_or_default();
    let count = job.body(Part::Plate).mesh().nodes().len();
    Ok((cost, displacements(&text, count)))
}

/// The input deck: meshes, contact pair with the hole as slave, supports, and one step for each load.
fn deck(job: &Job, contact: Contact, cell: &str) -> Result<String, TaskError> {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    let (points, cells) = job.mesh();
    // Writing into a string does not fail.
    for (k, [x, y]) in points.iter().enumerate() {
        let _ = writeln!(deck, "{},{x:.12e},{y:.12e},0", k + 1);
    }
    let [_, first_pin] = job.offsets(Part::Pin);
    for (name, range) in [("PLATE", 0..first_pin), ("PIN", first_pin..cells.len())] {
        let _ = writeln!(deck, "*ELEMENT, TYPE={cell}, ELSET={name}");
        for k in range {
            let nodes: Vec<String> = cells[k].iter().map(|n| (n + 1).to_string()).collect();
            let _ = writeln!(deck, "{},{}", k + 1, nodes.join(","));
        }
    }
    let _ = writeln!(deck, "*MATERIAL, NAME=AL\n*ELASTIC\n{YOUNG:.12e},{POISSON}");
    let thickness = job.body(Part::Plate).thickness();
    for name in ["PLATE", "PIN"] {
        let _ = writeln!(
            deck,
            "*SOLID SECTION, ELSET={name}, MATERIAL=AL\n{thickness:.12e}"
        );
    }
    deck += &contact_pair(job, contact)?;
    deck += "*BOUNDARY\n";
    for part in [Part::Plate, Part::Pin] {
        for node in job.nodes(part, "symmetry")? {
            let _ = writeln!(deck, "{},2,2", node + 1);
        }
    }
    for node in job.nodes(Part::Pin, "centre")? {
        let _ = writeln!(deck, "{},1,1", node + 1);
    }
    let left = job.edges(Part::Plate, "left")?;
    for traction in job.tractions() {
        deck += "*STEP, INC=2000\n*STATIC\n1.,1.\n*DLOAD\n";
        for edge in &left {
            let _ = writeln!(
                deck,
                "{},P{},{:.10e}",
                edge.element + 1,
                edge.edge + 1,
                -traction
            );
        }
        deck += "*NODE FILE, FREQUENCY=1000, OUTPUT=2D\nU\n*END STEP\n";
    }
    Ok(deck)
}

/// The contact pair with the hole as slave, and its surfaces.
fn contact_pair(job: &Job, contact: Contact) -> Result<String, TaskError> {
    let mut deck = String::new();
    for (name, part, set) in [("SHOLE", Part::Plate, "hole"), ("SRIM", Part::Pin, "rim")] {
        if contact == Contact::NodeToSurface && part == Part::Plate {
            let _ = writeln!(deck, "*SURFACE, NAME={name}, TYPE=NODE");
            for node in job.nodes(part, set)? {
                let _ = writeln!(deck, "{},", node + 1);
            }
            continue;
        }
        let _ = writeln!(deck, "*SURFACE, NAME={name}, TYPE=ELEMENT");
        for edge in job.edges(part, set)? {
            let _ = writeln!(deck, "{},S{}", edge.element + 1, edge.edge + 1);
        }
    }
    let stiffness = contact.stiffness();
    deck += "*SURFACE INTERACTION, NAME=SI\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n";
    let _ = match contact {
        Contact::SurfaceToSurface => writeln!(deck, "{stiffness:.6e}"),
        Contact::NodeToSurface => writeln!(deck, "{stiffness:.6e},0.,{REACH:.6e}"),
    };
    if job.mu > 0.0 {
        let _ = writeln!(deck, "*FRICTION\n{},{:.6e}", job.mu, 0.1 * stiffness);
    }
    deck += match contact {
        Contact::SurfaceToSurface => "*CONTACT PAIR, INTERACTION=SI, TYPE=SURFACE TO SURFACE\n",
        Contact::NodeToSurface => "*CONTACT PAIR, INTERACTION=SI, TYPE=NODE TO SURFACE\n",
    };
    deck += "SHOLE,SRIM\n";
    Ok(deck)
}

/// Displacements of the first `count` nodes at the end of each step that a result file has.
fn displacements(text: &str, count: usize) -> Steps {
    let mut steps = Steps::new();
    let mut inside = false;
    for line in text.lines() {
        if line.starts_with(" -4") {
            inside = line.split_whitespace().nth(1) == Some("DISP");
            if inside {
                steps.push(vec![[0.0; 2]; count]);
            }
        } else if line.starts_with(" -3") {
            inside = false;
        } else if inside && line.starts_with(" -1") {
            // Columns of fixed width: node 10, values 12 each.
            let number = |from: usize, to: usize| line.get(from..to).map(str::trim);
            let node = number(3, 13).and_then(|text| text.parse::<usize>().ok());
            let value = |from| number(from, from + 12).and_then(|text| text.parse::<f64>().ok());
            if let (Some(node), Some(x), Some(y), Some(last)) =
                (node, value(13), value(25), steps.last_mut())
                && (1..=count).contains(&node)
            {
                last[node - 1] = [x, y];
            }
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::super::LOAD_STEPS;
    use super::*;

    #[test]
    fn the_deck_names_every_node_cell_and_step() {
        let job = Job::new(0.25, ElementKind::Q4, 9.0).unwrap();
        let deck = deck(&job, Contact::SurfaceToSurface, "CPS4").unwrap();
        let (points, cells) = job.mesh();
        let lines: Vec<&str> = deck.lines().collect();
        let first_cells = lines
            .iter()
            .position(|l| l.starts_with("*ELEMENT"))
            .unwrap();
        assert_eq!(first_cells, points.len() + 1);
        let material = lines
            .iter()
            .position(|l| l.starts_with("*MATERIAL"))
            .unwrap();
        assert_eq!(material - first_cells, cells.len() + 2);
        assert_eq!(deck.matches("*END STEP").count(), LOAD_STEPS);
        // 20 edges of 9° on each half circle.
        let of = |name: &str| {
            let start = lines.iter().position(|l| l.contains(name)).unwrap() + 1;
            lines[start..]
                .iter()
                .take_while(|l| !l.starts_with('*'))
                .count()
        };
        assert_eq!([of("NAME=SHOLE"), of("NAME=SRIM")], [20, 20]);
    }

    #[test]
    fn displacements_are_read_by_columns() {
        let text = "  100CL  101 1.0\n -4  DISP        4    1\n -5  D1          1    2    1    0\n \
                    -1         1 1.00000E-03-2.00000E-03 0.00000E+00\n \
                    -1         3 4.00000E-03 5.00000E-03 0.00000E+00\n -3\n -4  STRESS      6    1\n \
                    -1         1 9.00000E+00 9.00000E+00 9.00000E+00\n -3\n";
        assert_eq!(displacements(text, 2), [[[1e-3, -2e-3], [0.0, 0.0]]]);
    }
}
