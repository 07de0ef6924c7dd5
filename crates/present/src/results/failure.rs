//! Failure of laminates as a reader wants it: names, places and loads in display units, and what is made of them.

pub(super) mod csv_files;
pub(super) mod figures;
mod maps;
pub(super) mod summary;
pub(super) mod tables;

pub(super) use maps::index_map;

use stickslip_laminate::failure::criterion_named;
use stickslip_results::LoadScale;
use stickslip_results::{BodyFailure, FailurePoint, FirstPly, Results};
use stickslip_scene::schema::EnvelopePlane;
use stickslip_text::significant;

/// A body's failure with what a reader needs around it.
#[derive(Clone, Copy)]
pub(super) struct FailureView<'a> {
    pub(super) failure: &'a BodyFailure,
    pub(super) results: &'a Results,
}

impl<'a> FailureView<'a> {
    /// All bodies for which the scene requests it.
    pub(super) fn all(results: &'a Results) -> Vec<Self> {
        let view = |failure| Self { failure, results };
        results.failure.iter().map(view).collect()
    }

    pub(super) fn body(&self) -> &'a str {
        &self.results.bodies[self.failure.body].name
    }

    /// What its steps are counted by.
    pub(super) fn load(&self) -> LoadScale {
        LoadScale::of_body(self.results, self.failure.body)
    }

    pub(super) fn stress(&self, stress: f64) -> f64 {
        self.results.units.stress.from_base(stress)
    }

    pub(super) fn stress_unit(&self) -> &'static str {
        self.results.units.stress.name
    }

    pub(super) fn length(&self, length: f64) -> f64 {
        self.results.units.length.from_base(length)
    }

    /// Names and units of the two coordinates of a place: φ or θ and r about a hole, otherwise x and y.
    pub(super) fn place_columns(&self) -> [(&'static str, &'static str); 2] {
        let length = self.results.units.length.name;
        match self.failure.centre {
            Some(_) => [(self.failure.frame.symbol(), "deg"), ("r", length)],
            None => [("x", length), ("y", length)],
        }
    }

    /// The two coordinates of a place in display units.
    pub(super) fn place(&self, point: &FailurePoint) -> [f64; 2] {
        match self.failure.polar(point.position) {
            Some((angle, radius)) => [angle.to_degrees(), self.length(radius)],
            None => point.position.map(|x| self.length(x)),
        }
    }
}

/// "812 lbf", or "1.35 × step 3" where steps have no load of their own.
pub(super) fn load_text(first: &FirstPly) -> String {
    match &first.load {
        Some(load) if load.unit == "1" => format!("factor {}", significant(load.value, 4)),
        Some(load) => format!("{} {}", significant(load.value, 4), load.unit),
        None => how(first),
    }
}

/// A ply's name for a heading that programs read: "-60 deg".
pub(super) fn plain_name(name: &str) -> String {
    name.replace('−', "-").replace('°', " deg")
}

/// "in step 7", or "step 10 × 1.35".
pub(super) fn how(first: &FirstPly) -> String {
    let step = first.step + 1;
    if first.reached {
        format!("in step {step}")
    } else {
        format!("step {step} × {}", significant(first.factor, 4))
    }
}

/// "plies 3–4, 9–10", counted from 1 from the bottom.
pub(super) fn layers(layers: &[usize]) -> String {
    let runs = layers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [] => String::new(),
        [only] => (only + 1).to_string(),
        [first, .., last] => format!("{}–{}", first + 1, last + 1),
    });
    runs.collect::<Vec<_>>().join(", ")
}

/// A criterion's name for a reader.
pub(super) fn criterion_name(name: &str) -> String {
    let criterion = criterion_named(name);
    criterion.map_or_else(|_| name.replace('_', " "), |own| own.title())
}

/// Symbols of the mean stresses that span the plane of an envelope.
pub(super) fn plane_symbols(plane: EnvelopePlane) -> [&'static str; 2] {
    match plane {
        EnvelopePlane::Normal => ["σ_x", "σ_y"],
        EnvelopePlane::Shear => ["σ_x", "τ_xy"],
    }
}

#[cfg(test)]
mod tests {
    use super::layers;

    #[test]
    fn runs_of_layers_are_shortened() {
        assert_eq!(layers(&[0, 1, 10, 11]), "1–2, 11–12");
        assert_eq!(layers(&[4, 5, 6, 7]), "5–8");
        assert_eq!(layers(&[3]), "4");
        assert_eq!(layers(&[]), "");
    }
}
