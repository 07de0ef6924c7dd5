//! Results as a reader wants them: places in degrees or lengths, stresses and loads in the scene's units, short numbers.

use stickslip_results::LoadScale;
use stickslip_results::{EdgeGeometry, EdgeKind, EdgeResults, Results, Stated};
use stickslip_scene::schema::DisplayUnits;
use stickslip_text::short;

/// Resultant of balanced pressures relative to their sum: rounding of a sum of some thousand terms, with a margin.
const ROUNDING: f64 = 1e-9;
/// Part of its length by which a range may be off its middle and still be said to lie evenly.
const EVEN: f64 = 1e-6;

/// An edge with its results of all steps, in display units.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeView<'a> {
    pub(super) geometry: &'a EdgeGeometry,
    results: &'a Results,
    index: usize,
}

impl<'a> EdgeView<'a> {
    /// All edges in their order. The results are consistent: every step has every edge.
    pub(super) fn all(results: &'a Results) -> Vec<Self> {
        let view = |(index, geometry)| Self {
            geometry,
            results,
            index,
        };
        results.edges.iter().enumerate().map(view).collect()
    }

    /// The edge that tables show: the first contact edge, or the first edge without contact.
    pub(super) fn main(results: &'a Results) -> Option<Self> {
        Some(Self::all(results)[results.main_edge()?])
    }

    pub(super) fn step(&self, step: usize) -> &'a EdgeResults {
        &self.results.steps[step].edges[self.index]
    }

    /// Whether `other` is the same edge of the same results.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.index == other.index && std::ptr::eq(self.results, other.results)
    }

    /// Its index in the results.
    pub(super) fn index(&self) -> usize {
        self.index
    }

    pub(super) fn results(&self) -> &'a Results {
        self.results
    }

    /// Name of the body whose stresses are given.
    pub(super) fn body(&self) -> &'a str {
        &self.results.bodies[self.geometry.body].name
    }

    /// What its steps are counted by.
    pub(super) fn load(&self) -> LoadScale {
        LoadScale::of_edge(self.results, self.index)
    }

    pub(super) fn units(&self) -> DisplayUnits {
        self.results.units
    }

    pub(super) fn is_circle(&self) -> bool {
        matches!(self.geometry.kind, EdgeKind::Circle { .. })
    }

    /// A length along the edge `[rad or mm]`, in degrees or the display unit.
    pub(super) fn length(&self, length: f64) -> f64 {
        if self.is_circle() {
            length.to_degrees()
        } else {
            self.units().length.from_base(length)
        }
    }

    /// A place of the edge's `parameter` as a reader sees it: its angle from the bearing point, or x or s, in display units.
    pub(super) fn place(&self, parameter: f64) -> f64 {
        self.length(self.geometry.seen(parameter))
    }

    /// "deg" or the unit of lengths.
    pub(super) fn place_unit(&self) -> &'static str {
        if self.is_circle() {
            "deg"
        } else {
            self.units().length.name
        }
    }

    /// "φ" from a bearing point, "θ" from +x where there is none, "x", or "s" from the middle of the edge.
    pub(super) fn place_symbol(&self) -> &'static str {
        match self.geometry.kind {
            EdgeKind::Circle { .. } => self.geometry.frame.symbol(),
            EdgeKind::Line => "x",
            EdgeKind::Path => "s",
        }
    }

    /// What an axis of places is called.
    pub(super) fn place_name(&self) -> &'static str {
        match self.place_symbol() {
            "φ" => "Angle φ from the bearing point",
            "θ" => "Angle θ from +x",
            "s" => "Place s along the edge, from its middle",
            _ => "Place x along the edge",
        }
    }

    /// "φ = 12.3°" or "x = 1.23 mm".
    pub(super) fn at(&self, parameter: f64) -> String {
        format!(
            "{} = {}",
            self.place_symbol(),
            self.extent(self.geometry.seen(parameter))
        )
    }

    /// A length along the edge `[rad or mm]`: "12.3°" or "1.23 mm".
    pub(super) fn extent(&self, length: f64) -> String {
        self.shown(self.length(length))
    }

    /// A value in display units: "12.3°" or "1.23 mm".
    pub(super) fn shown(&self, value: f64) -> String {
        let value = short(value);
        if self.is_circle() {
            format!("{value}°")
        } else {
            format!("{value} {}", self.place_unit())
        }
    }

    /// Places in display units as "±12.3°" where they lie evenly about the bearing point or x = 0, otherwise as "φ = −10° to 14.6°".
    pub(super) fn range(&self, [start, end]: [f64; 2]) -> String {
        if even([start, end]) {
            format!("±{}", self.shown(0.5 * (end - start)))
        } else {
            let (start, end) = (self.shown(start), self.shown(end));
            format!("{} = {start} to {end}", self.place_symbol())
        }
    }

    /// All of `ranges`: "φ = −40° to −20° and 20° to 40°"; "all around" where one is the whole circle.
    pub(super) fn ranges(&self, ranges: &[[f64; 2]]) -> Option<String> {
        let (first, rest) = ranges.split_first()?;
        if self.is_whole(*first) {
            return Some("all around".into());
        }
        let further = rest
            .iter()
            .map(|&[start, end]| format!(" and {} to {}", self.shown(start), self.shown(end)));
        let first = if rest.is_empty() {
            self.range(*first)
        } else {
            let [start, end] = first.map(|at| self.shown(at));
            format!("{} = {start} to {end}", self.place_symbol())
        };
        Some(first + &further.collect::<String>())
    }

    /// Whether a range in display units is the whole circle.
    pub(super) fn is_whole(&self, [start, end]: [f64; 2]) -> bool {
        self.is_circle() && end - start > 360.0 * (1.0 - ROUNDING)
    }

    /// Whether one range in display units is the mirror image of another on the bearing point, or on x = 0.
    pub(super) fn are_images(&self, one: [f64; 2], other: [f64; 2]) -> bool {
        let turn = if self.is_circle() { 360.0 } else { 0.0 };
        (0..2).all(|k| {
            let apart = (one[k] + other[1 - k]).abs();
            apart.min((apart - turn).abs()) <= EVEN * (one[1] - one[0]).max(turn)
        })
    }

    /// Place of the bearing point of a step in display units, from the frame's bearing point or x.
    pub(super) fn bearing_point(&self, step: usize) -> Option<f64> {
        self.step(step).bearing.map(|at| self.place(at))
    }

    /// The point from which slip and friction of a step are judged: its own bearing point, or that of the frame.
    pub(super) fn judged_from(&self, step: usize) -> Option<f64> {
        self.step(step).judged_from(self.geometry)
    }

    /// Whether slip goes away from a bearing point and towards it, and not along +e_t and −e_t.
    pub(super) fn slips_about_bearing(&self) -> bool {
        self.is_circle() && self.geometry.frame.bearing.is_some()
    }

    /// What the two directions of slip are called: about a bearing point, away from it and towards it; otherwise along +e_t and −e_t.
    pub(super) fn slip_names(&self) -> [&'static str; 2] {
        if self.slips_about_bearing() {
            ["slip away", "slip towards"]
        } else {
            ["slip +", "slip −"]
        }
    }

    /// A stress `[MPa]` in the display unit.
    pub(super) fn stress(&self, stress: f64) -> f64 {
        self.units().stress.from_base(stress)
    }

    /// A work `[N·mm]` in display units.
    pub(super) fn work(&self, work: f64) -> f64 {
        energy(self.units(), work)
    }

    /// Bearing stress `[MPa]` in a step; `None` where the pressures balance each other, as around an unloaded pin with interference.
    pub(super) fn bearing(&self, step: usize) -> Option<f64> {
        let edge = self.step(step);
        let [x, y] = edge.resultant;
        let balanced = x.hypot(y) <= ROUNDING * edge.normal_force;
        edge.bearing_stress(self.geometry).filter(|_| !balanced)
    }

    /// The estimated error of [`Self::bearing`] `[MPa]`.
    pub(super) fn bearing_error(&self, step: usize) -> Option<f64> {
        Some(self.step(step).resultant_error()? / self.geometry.bearing_area?)
    }

    /// Whether any step has a bearing stress; a press fit without a pull has none.
    pub(super) fn bears(&self) -> bool {
        (0..self.results().steps.len()).any(|step| self.bearing(step).is_some())
    }

    /// Names of the normal, the tangential and the shear stress.
    pub(super) fn stress_symbols(&self) -> [&'static str; 3] {
        match self.geometry.kind {
            EdgeKind::Circle { .. } => ["σ_r", "σ_θ", "τ_rθ"],
            EdgeKind::Line => ["σ_yy", "σ_xx", "τ_xy"],
            EdgeKind::Path => ["σ_n", "σ_s", "τ_ns"],
        }
    }

    /// Signed friction force `[N]`; `None` without contact, and on a circle without a bearing point.
    pub(super) fn friction_force(&self, step: usize) -> Option<f64> {
        let reported = !self.is_circle() || self.judged_from(step).is_some();
        (self.geometry.contact && reported).then(|| self.step(step).friction_force)
    }

    /// Friction over pressure, ∫q dA / ∫p dA; `None` without pressure.
    pub(super) fn friction_ratio(&self, step: usize) -> Option<f64> {
        let normal = self.step(step).normal_force;
        (self.friction_force(step).filter(|_| normal > 0.0)).map(|friction| friction / normal)
    }

    /// The estimated error of [`Self::friction_ratio`].
    pub(super) fn friction_ratio_error(&self, step: usize) -> Option<f64> {
        let edge = self.step(step);
        let ratio = self.friction_ratio(step)?.abs();
        let friction = edge.errors.get(Stated::FrictionForce)?;
        let normal = edge.errors.get(Stated::NormalForce)?;
        Some((friction + ratio * normal) / edge.normal_force)
    }

    /// What [`Self::friction_ratio`] is called.
    pub(super) fn friction_symbol(&self) -> &'static str {
        if self.is_circle() {
            "∫q dA / ∫p dA"
        } else {
            "Q/N"
        }
    }
}

/// What works are given in.
pub(super) fn energy_unit(units: DisplayUnits) -> String {
    format!("{} {}", units.force.name, units.length.name)
}

/// A work `[N·mm]` in [`energy_unit`].
pub(super) fn energy(units: DisplayUnits, work: f64) -> f64 {
    units.length.from_base(units.force.from_base(work))
}

/// Whether a range lies evenly about zero.
pub(super) fn even([start, end]: [f64; 2]) -> bool {
    (start + end).abs() <= EVEN * (end - start)
}

/// Different measures, each with the names, in quotes, of the edges whose steps are counted by it.
pub(super) fn shared(results: &Results) -> Vec<(LoadScale, Vec<String>)> {
    let mut all: Vec<(LoadScale, Vec<String>)> = Vec::new();
    for edge in EdgeView::all(results) {
        let (load, name) = (edge.load(), format!("'{}'", edge.geometry.name));
        match all.iter_mut().find(|(other, _)| *other == load) {
            Some((_, names)) => names.push(name),
            None => all.push((load, vec![name])),
        }
    }
    all
}
