//! Whether the parts of results fit together, which tables, files and figures count on.

use stickslip_results::{BodyFailure, EdgePlies, FirstPly, PlyMap, Results, StepResults};

use super::OutputError;

/// Checks that all lists have the lengths, and all indices the range, that those of the other parts give them.
pub(super) fn check(results: &Results) -> Result<(), OutputError> {
    for edge in &results.edges {
        same(edge.corner.len(), edge.parameter.len(), || {
            format!("edge '{}': corner", edge.name)
        })?;
    }
    for (number, step) in (1..).zip(&results.steps) {
        of_step(results, number, step)?;
    }
    for fastener in &results.fasteners {
        let bodies: Vec<usize> = (fastener.layers.iter())
            .flat_map(|layer| [layer.slice, layer.plate])
            .collect();
        let of = || format!("fastener '{}': bodies", fastener.name);
        all_below(&bodies, results.bodies.len(), of)?;
    }
    let loads = results.steps.first().map_or(0, |step| step.loads.len());
    for part in &results.parts {
        let what = |list: &str| format!("a part: {list}");
        all_below(&part.bodies, results.bodies.len(), || what("bodies"))?;
        all_below(&part.edges, results.edges.len(), || what("edges"))?;
        if loads > 0 {
            all_below(&part.loads, loads, || what("loads"))?;
        }
    }
    let mut failures = results.failure.iter();
    failures.try_for_each(|failure| of_failure(results, failure))
}

fn same(found: usize, expected: usize, what: impl Fn() -> String) -> Result<(), OutputError> {
    if found == expected {
        return Ok(());
    }
    Err(OutputError::Inconsistent {
        what: what(),
        found,
        expected,
    })
}

fn below(index: usize, entries: usize, what: impl Fn() -> String) -> Result<(), OutputError> {
    all_below(&[index], entries, what)
}

fn all_below(
    indices: &[usize],
    entries: usize,
    what: impl Fn() -> String,
) -> Result<(), OutputError> {
    match indices.iter().find(|index| **index >= entries) {
        None => Ok(()),
        Some(&index) => Err(OutputError::NoEntry {
            what: what(),
            index,
            entries,
        }),
    }
}

fn of_step(results: &Results, number: usize, step: &StepResults) -> Result<(), OutputError> {
    same(step.edges.len(), results.edges.len(), || {
        format!("step {number}: edges")
    })?;
    let fasteners = step.fasteners.len();
    same(fasteners, results.fasteners.len(), || {
        format!("step {number}: fasteners")
    })?;
    for (own, fastener) in step.fasteners.iter().zip(&results.fasteners) {
        same(own.layers.len(), fastener.layers.len(), || {
            format!("step {number}, fastener '{}': layers", fastener.name)
        })?;
    }
    let loads = results.steps[0].loads.len();
    same(step.loads.len(), loads, || format!("step {number}: loads"))?;
    same(step.sets.len(), results.sets.len(), || {
        format!("step {number}: sets")
    })?;
    for (edge, geometry) in step.edges.iter().zip(&results.edges) {
        same(edge.rows.len(), geometry.parameter.len(), || {
            format!("step {number}, edge '{}': rows", geometry.name)
        })?;
    }
    for fields in &step.fields {
        let nodes = nodes_of(results, fields.body).ok_or(OutputError::NoBody {
            step: number,
            body: fields.body,
        })?;
        let of = |what: &str| format!("step {number}, body {}: {what}", fields.body);
        same(fields.displacement.len(), 2 * nodes, || of("displacement"))?;
        same(fields.stress.len(), nodes, || of("stress"))?;
        let thickness = fields.thickness_stress.len();
        same(thickness, nodes, || of("thickness_stress"))?;
    }
    Ok(())
}

/// Number of nodes of the elastic body with the index `body`.
fn nodes_of(results: &Results, body: usize) -> Option<usize> {
    let mesh = results.bodies.get(body)?.mesh.as_ref()?;
    Some(mesh.nodes().len())
}

fn of_failure(results: &Results, failure: &BodyFailure) -> Result<(), OutputError> {
    below(failure.body, results.bodies.len(), || {
        "failure: body".into()
    })?;
    let of = |what: &str| format!("failure of body {}: {what}", failure.body);
    let criteria = failure.criteria.len();
    same(failure.steps.len(), results.steps.len(), || of("steps"))?;
    for points in &failure.steps {
        same(points.len(), criteria, || of("criteria of a step"))?;
        let plies: Vec<usize> = points.iter().map(|point| point.ply).collect();
        all_below(&plies, failure.plies.len(), || of("ply of a step"))?;
    }
    of_first_plies(results, failure, &failure.first_ply, || of("first_ply"))?;
    if let Some(beside) = &failure.beside_supports {
        of_first_plies(results, failure, &beside.sooner, || of("beside_supports"))?;
    }
    for edge in &failure.edges {
        of_edge(results, failure, edge, || of("edges"))?;
    }
    for map in &failure.maps {
        of_map(results, failure, map, || of("maps"))?;
    }
    if let Some(own) = &failure.characteristic {
        same(own.curve.len(), criteria, || of("characteristic curve"))?;
        of_first_plies(results, failure, &own.net_section, || of("net_section"))?;
        of_first_plies(results, failure, &own.bearing_point, || of("bearing_point"))?;
        same(own.places.len(), own.angles.len(), || of("places"))?;
        same(own.index.len(), results.steps.len(), || of("curve's steps"))?;
        for index in &own.index {
            same(index.len(), own.angles.len(), || of("curve's indices"))?;
        }
    }
    Ok(())
}

/// First-ply failure by each criterion.
fn of_first_plies(
    results: &Results,
    failure: &BodyFailure,
    found: &[Option<FirstPly>],
    what: impl Fn() -> String,
) -> Result<(), OutputError> {
    same(found.len(), failure.criteria.len(), &what)?;
    for first in found.iter().flatten() {
        below(first.step, results.steps.len(), &what)?;
        below(first.at.ply, failure.plies.len(), &what)?;
    }
    Ok(())
}

fn of_edge(
    results: &Results,
    failure: &BodyFailure,
    edge: &EdgePlies,
    what: impl Fn() -> String,
) -> Result<(), OutputError> {
    below(edge.edge, results.edges.len(), &what)?;
    same(edge.steps.len(), results.steps.len(), &what)?;
    for plies in &edge.steps {
        same(plies.len(), failure.plies.len(), &what)?;
        for points in plies {
            same(points.len(), edge.parameter.len(), &what)?;
        }
    }
    Ok(())
}

/// A value per node, and in a half model another one for its mirror image.
fn of_map(
    results: &Results,
    failure: &BodyFailure,
    map: &PlyMap,
    what: impl Fn() -> String,
) -> Result<(), OutputError> {
    below(map.step, results.steps.len(), &what)?;
    let nodes = nodes_of(results, failure.body).unwrap_or(0);
    for index in &map.index {
        let expected = if index.len() > nodes {
            2 * nodes
        } else {
            nodes
        };
        same(index.len(), expected, &what)?;
    }
    Ok(())
}
