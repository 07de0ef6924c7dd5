//! What single points that are held or loaded do to displacements, and corners to stress.

use stickslip_text::significant;

/// `quoted` are the bodies `bodies`.
pub(super) fn supports(quoted: &str, bodies: &[String]) -> String {
    format!(
        "Elastic bodies held at a single point: {quoted}. Other supports share the load, and the displacement of a point grows with every \
         finer mesh, so load shares depend on the mesh. {}",
        remedy(bodies)
    )
}

/// `quoted` are the loads and the bodies `bodies`.
pub(super) fn displacements(quoted: [&str; 2], bodies: &[String]) -> String {
    format!(
        "Displacement and stiffness of {} depend on the mesh: they hang on the single point at which elements hold {}, whose displacement grows with \
         every finer mesh. {}",
        quoted[0],
        quoted[1],
        remedy(bodies)
    )
}

/// `quoted` are the bodies.
pub(super) fn without_errors(quoted: &str) -> String {
    format!(
        "No error is stated for displacements, stiffness and reactions beside {quoted}: finer models have smaller cells near contact alone, and what cells \
         far from there change is not known. Compare with a scene that has a finer mesh."
    )
}

/// `quoted` are the loads.
pub(super) fn loads(quoted: &str) -> String {
    format!(
        "Forces on a single point: {quoted}. Displacement and stress there grow without limit with every finer mesh, and those that are shown are of this \
         division. Put the force on an edge, or on the body's section."
    )
}

fn remedy(bodies: &[String]) -> String {
    let body = bodies.first().map_or("pin", String::as_str);
    format!("Hold an edge instead; a pin, over its section (on = \"{body}.section\").")
}

/// Stresses along `edge` where a support ends.
pub(super) fn support_end(edge: &str, steps: &str) -> String {
    format!(
        "No error is stated for tangential stresses along {edge} in {steps} (the peak, or that at the bearing point or x = 0): towards the end of a support stress grows without limit with \
         every finer mesh, and the value is that of this division. Report an edge that the support does not end at, or spread the hold over the body's section."
    )
}

/// The stress along `edge` where a traction along an edge ends.
pub(super) fn load_end(edge: &str, steps: &str) -> String {
    format!(
        "No error is stated for tangential stresses along {edge} in {steps}: where a force or springs along an edge end, or where a pressure ends within an edge, stress depends on the \
         side from which one comes, or has no limit; the value is that of this division. Let the load end elsewhere, or act across the edge up to its corner."
    )
}

/// The largest stress along `edge` at a corner of `angle` inside the body `[degree]`.
pub(super) fn reentrant(edge: &str, steps: &str, angle: f64, exponent: Option<f64>) -> String {
    let power = exponent.map_or_else(String::new, |power| {
        format!(
            " like r^{}, r being the distance from it",
            significant(power, 3)
        )
    });
    format!(
        "The peak tangential stress along {edge} in {steps} is at a re-entrant corner of {}°, towards which stress grows without limit{power}: the value is that of \
         this division, without an error. Round the corner to get a limit.",
        significant(angle, 4)
    )
}
