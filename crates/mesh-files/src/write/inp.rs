//! Input files of Abaqus and CalculiX.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use stickslip_fem_core::material::PlaneState;
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use super::{check_names, names};
use crate::error::WriteError;

/// Entries of a line of a set.
const ENTRIES: usize = 16;

/// Longest number that Abaqus reads.
const LONGEST_NUMBER: usize = 20;

/// Longest name that Abaqus reads.
const LONGEST_NAME: usize = 80;

/// Writes a mesh as `*NODE`, `*ELEMENT`, `*NSET`, `*ELSET` and `*SURFACE, TYPE=ELEMENT` of Abaqus and CalculiX, without an analysis.
///
/// Nodes and elements are numbered from 1 in the order of the mesh. Element types are CPS3, CPS4, CPS6 and CPS8 in plane stress, CPE3 to CPE8
/// in plane strain; each block is an element set of its name. Coordinates are exact where they fit into the 20 characters that Abaqus
/// reads, otherwise rounded to 13 digits. Curves of edge sets are not written.
///
/// # Errors
/// [`WriteError::Kind`] for cells with nodes inside (Q9, P2 and above), [`WriteError::Name`] for names that the format cannot hold, among
/// them two sets of one kind that differ only in case.
pub fn write_inp(mesh: &Mesh, state: PlaneState) -> Result<String, WriteError> {
    check_names(mesh)?;
    check_labels(mesh)?;
    let mut out = String::from("*NODE\n");
    for (k, [x, y]) in mesh.nodes().iter().enumerate() {
        line(
            &mut out,
            format_args!("{}, {}, {}", k + 1, number(*x), number(*y)),
        );
    }
    elements(&mut out, mesh, state)?;
    for name in mesh.node_set_names() {
        let nodes = mesh.node_set(name).unwrap_or_default();
        line(&mut out, format_args!("*NSET, NSET={}", label(name)));
        members(&mut out, nodes);
    }
    for name in mesh.element_set_names() {
        let cells = mesh.element_set(name).unwrap_or_default();
        line(&mut out, format_args!("*ELSET, ELSET={}", label(name)));
        members(&mut out, cells);
    }
    for name in mesh.edge_set_names() {
        line(
            &mut out,
            format_args!("*SURFACE, TYPE=ELEMENT, NAME={}", label(name)),
        );
        let set = mesh.edge_set(name).into_iter();
        for edge in set.flat_map(|set| &set.edges) {
            line(
                &mut out,
                format_args!("{}, S{}", edge.element + 1, edge.edge + 1),
            );
        }
    }
    Ok(out)
}

/// Appends a line; text always takes it.
fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    let _ = out.write_fmt(text);
    out.push('\n');
}

fn elements(out: &mut String, mesh: &Mesh, state: PlaneState) -> Result<(), WriteError> {
    let family = match state {
        PlaneState::Stress => "CPS",
        PlaneState::Strain => "CPE",
    };
    for (b, block) in mesh.blocks().iter().enumerate() {
        let kind = block.kind;
        if !is_known(kind) {
            return Err(WriteError::Kind {
                format: "Abaqus",
                kind,
                block: block.name.clone(),
                instead: "T3, T6, Q4 or Q8",
            });
        }
        let name = block_name(mesh, b);
        let size = kind.nodes();
        line(
            out,
            format_args!("*ELEMENT, TYPE={family}{size}, ELSET={}", label(&name)),
        );
        for (k, cell) in block.connectivity.chunks_exact(size).enumerate() {
            let _ = write!(out, "{}", mesh.first_element(b) + k + 1);
            for node in cell {
                let _ = write!(out, ", {}", node + 1);
            }
            out.push('\n');
        }
    }
    Ok(())
}

fn is_known(kind: ElementKind) -> bool {
    use ElementKind::{P1, Q4, Q8, T3, T6};
    matches!(kind, T3 | T6 | Q4 | Q8 | P1)
}

/// The name of a block's element set, which must not be that of a set with other members.
fn block_name(mesh: &Mesh, b: usize) -> String {
    // `b` is the index of a block.
    let name = &mesh.blocks()[b].name;
    let clash = |name: &str| {
        let mut names = mesh.element_set_names();
        names.any(|other| other.eq_ignore_ascii_case(name))
    };
    let mut free = name.clone();
    while clash(&free) {
        free.push_str("-block");
    }
    free
}

fn members(out: &mut String, members: &[usize]) {
    for row in members.chunks(ENTRIES) {
        let row: Vec<String> = row.iter().map(|k| (k + 1).to_string()).collect();
        line(out, format_args!("{}", row.join(", ")));
    }
}

/// A coordinate in at most 20 characters.
fn number(value: f64) -> String {
    let exact = format!("{value:?}");
    if exact.len() <= LONGEST_NUMBER {
        return exact;
    }
    let rounded = (12..=13).rev().map(|digits| format!("{value:.digits$e}"));
    let mut fitting = rounded.filter(|text| text.len() <= LONGEST_NUMBER);
    fitting.next().unwrap_or_else(|| format!("{value:.11e}"))
}

fn label(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if begins && name.chars().all(is_plain) {
        name.to_owned()
    } else {
        format!("\"{name}\"")
    }
}

fn check_labels(mesh: &Mesh) -> Result<(), WriteError> {
    let refuse = |name: &str, why| {
        let name = name.to_owned();
        Err(WriteError::Name { name, why })
    };
    for name in names(mesh) {
        if name.chars().count() > LONGEST_NAME {
            return refuse(name, "is longer than 80 characters");
        }
        if name.bytes().all(|byte| byte.is_ascii_digit()) {
            return refuse(name, "is a number");
        }
    }
    let families: [Vec<&str>; 3] = [
        mesh.node_set_names().collect(),
        mesh.edge_set_names().collect(),
        mesh.element_set_names().collect(),
    ];
    for family in families {
        let mut seen = BTreeSet::new();
        for name in family {
            if !seen.insert(name.to_uppercase()) {
                return refuse(name, "differs from another one only in case");
            }
        }
    }
    Ok(())
}
