//! What single points that are held or loaded do to displacements.

use super::quoted;

pub(super) fn supports(bodies: &[String]) -> String {
    format!(
        "Elastic bodies held at a single point: {}. Other supports share the load, and the displacement of a point grows with every \
         finer mesh, so load shares depend on the mesh. {}",
        quoted(bodies),
        remedy(bodies)
    )
}

pub(super) fn displacements(bodies: &[String], loads: &[String]) -> String {
    format!(
        "Displacement and stiffness of {} depend on the mesh: they hang on the single point at which elements hold {}, whose displacement grows with \
         every finer mesh. {}",
        quoted(loads),
        quoted(bodies),
        remedy(bodies)
    )
}

pub(super) fn loads(loads: &[String]) -> String {
    format!(
        "Forces on a single point: {}. Displacement and stress there grow without limit with every finer mesh, and those that are shown are of this \
         division. Put the force on an edge, or on the body's section.",
        quoted(loads)
    )
}

fn remedy(bodies: &[String]) -> String {
    let body = bodies.first().map_or("pin", String::as_str);
    format!("Hold a pin over its section (on = \"{body}.section\").")
}
