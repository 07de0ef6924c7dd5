//! A friction law with free parameters.

use serde_json::Value;
use stickslip_friction::{Dimension, FrictionLaw, History, Mirror, Place, PointStatus, registry};
use stickslip_hybrid::calibrate::Parameter;
use thiserror::Error;

use crate::LawPlan;
use stickslip_scene::diagnostic::SceneProblem;
use stickslip_scene::read::quantity;
use stickslip_scene::units::{self, Expected};

/// Ranges with ends so far apart are divided evenly in the logarithm.
const DECADES: f64 = 20.0;

/// A law refuses the values of its free parameters; its reason.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{0}")]
pub struct RefusedLaw(pub String);

/// A friction law of any registered kind, some of whose parameters are free.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Its name in results.
    pub name: String,
    /// Kind of the law: its name in files.
    pub kind: String,
    /// Free parameters.
    pub parameters: Vec<Parameter>,
    /// Dimension of each.
    pub dimensions: Vec<Dimension>,
    /// The law in plain numbers, as it is read.
    table: Value,
    /// Where the free parameters stand in it (RFC 6901).
    pointers: Vec<String>,
}

impl Candidate {
    /// The law of a plan.
    ///
    /// # Errors
    /// The key below the law's table in the file, and what is wrong with it: a parameter that the law does not have.
    pub fn new(plan: &LawPlan) -> Result<Self, (String, Box<SceneProblem>)> {
        let free = plan
            .free
            .iter()
            .map(|free| (free.name.as_str(), free.bounds));
        Self::of_law(&plan.name, plan.law.as_ref(), &free.collect::<Vec<_>>())
            .map_err(|(name, problem)| (format!("free.{name}"), problem))
    }

    /// `law` with the parameters `free`, which keep its values nowhere: their names, with dots into tables, and ranges in base units.
    ///
    /// # Errors
    /// The name that the law does not have, and the names that it has.
    pub fn of_law(
        name: &str,
        law: &dyn FrictionLaw,
        free: &[(&str, [f64; 2])],
    ) -> Result<Self, (String, Box<SceneProblem>)> {
        let refused = |what: &str, message: String| {
            let law = law.name().to_owned();
            let problem = SceneProblem::Friction { law, message };
            (what.to_owned(), Box::new(problem))
        };
        let table = serde_json::to_value(law).map_err(|error| refused("", error.to_string()))?;
        let own = table.get(law.name()).unwrap_or(&Value::Null);
        let known = numbers_in(own, "");
        let mut pointers = Vec::new();
        let mut parameters = Vec::new();
        let mut dimensions = Vec::new();
        for &(path, range) in free {
            if !known.iter().any(|own| own == path) {
                let problem = SceneProblem::unknown_key(path, known.iter().map(String::as_str));
                return Err((path.to_owned(), Box::new(problem)));
            }
            pointers.push(format!("/{}/{}", law.name(), path.replace('.', "/")));
            dimensions.push(dimension(law.name(), path));
            let parameter = Parameter::new(path, range);
            let [low, high] = range;
            parameters.push(if low > 0.0 && high / low >= DECADES {
                parameter.logarithmic()
            } else {
                parameter
            });
        }
        Ok(Self {
            name: name.to_owned(),
            kind: law.name().to_owned(),
            parameters,
            dimensions,
            table,
            pointers,
        })
    }

    /// Whether one end of the range of the free parameter `path` is spelled as the parameter itself is: with a unit of its dimension, or as a
    /// bare number. A name that the law does not have is refused by [`Self::of_law`].
    ///
    /// # Errors
    /// No unit, an unknown one or one of another dimension; anything but a number for a parameter without dimension.
    pub fn check_end(
        law: &dyn FrictionLaw,
        path: &str,
        end: &Value,
    ) -> Result<(), Box<SceneProblem>> {
        let table = serde_json::to_value(law).unwrap_or_default();
        let own = table.get(law.name()).unwrap_or(&Value::Null);
        if !numbers_in(own, "").iter().any(|known| known == path) {
            return Ok(());
        }
        let expected = match dimension(law.name(), path) {
            Dimension::Length => Expected::one(units::Dimension::Length),
            Dimension::Stress => Expected::one(units::Dimension::Stress),
            Dimension::Angle => Expected::one(units::Dimension::Angle),
            _ if end.is_number() => return Ok(()),
            _ => {
                let wanted = "a number without unit or quotes";
                return Err(Box::new(SceneProblem::wrong_kind(wanted, end.to_string())));
            }
        };
        quantity(end, &expected).map(|_| ())
    }

    /// The law with these values of the free parameters, in base units.
    ///
    /// # Errors
    /// [`RefusedLaw`] where the law refuses them, such as a dynamic coefficient above the static one.
    pub fn law(&self, values: &[f64]) -> Result<Box<dyn FrictionLaw>, RefusedLaw> {
        let mut table = self.table.clone();
        for (pointer, &value) in self.pointers.iter().zip(values) {
            if let Some(entry) = table.pointer_mut(pointer) {
                *entry = value.into();
            }
        }
        serde_json::from_value(table).map_err(|error| RefusedLaw(error.to_string()))
    }

    /// Whether the law claims the symmetry about `mirror` at points of the ranges of its free parameters, those aside that it refuses.
    pub fn is_symmetric(&self, mirror: &Mirror) -> bool {
        self.in_the_ranges().all(|law| law.is_symmetric(mirror))
    }

    /// Whether friction drops where slip begins without a length over which it does, with the values `fitted` of the free parameters, in
    /// base units, or at points of their ranges.
    ///
    /// What such a law does depends on the spacing of contact nodes. Its bounds say so, whatever its kind and whatever it is made of.
    pub fn drops_without_length(&self, fitted: &[f64]) -> bool {
        let fitted = self.law(fitted).ok();
        let mut laws = fitted.into_iter().chain(self.in_the_ranges());
        laws.any(|law| drops_without_length(law.as_ref()))
    }

    /// The law at points of the ranges of its free parameters, those aside that it refuses.
    fn in_the_ranges(&self) -> impl Iterator<Item = Box<dyn FrictionLaw>> {
        // Parts of the ranges without a pattern: multiples of an irrational number for each parameter (Weyl 1916).
        let value = |point: u32, (index, parameter): (usize, &Parameter)| {
            let [low, high] = parameter.range;
            let step = (index as f64 + 0.5).sqrt();
            low + (f64::from(point) * step).fract() * (high - low)
        };
        let at = move |point: u32| {
            let parameters = self.parameters.iter().enumerate();
            let values: Vec<f64> = parameters.map(|own| value(point, own)).collect();
            self.law(&values)
        };
        (1..=ASKED).filter_map(move |point| at(point).ok())
    }
}

/// Points of the ranges at which a law is asked for what must hold in all of them.
const ASKED: u32 = 8;

/// Whether a point that has slipped by nothing bears less than one that never has.
fn drops_without_length(law: &dyn FrictionLaw) -> bool {
    /// Pressures in base units, and angles of the tangent from the fibres `[deg]`.
    const PRESSURES: [f64; 2] = [1.0, 100.0];
    const ANGLES: [f64; 4] = [0.0, 30.0, 60.0, 90.0];
    const ROUNDING: f64 = 1e-9;
    let at_rest = History::default();
    let slips = at_rest.commit(PointStatus::Slip, 0.0);
    let drops = |pressure: f64, angle: f64| {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let place = Place {
            position: [sine, -cosine],
            tangent: [cosine, sine],
            material_angle: 0.0,
        };
        let holds = law.bound(pressure, 0.0, &place, &at_rest).stick;
        let rubs = law.bound(pressure, 0.0, &place, &slips).slip;
        rubs < (1.0 - ROUNDING) * holds
    };
    let mut asked = PRESSURES
        .iter()
        .flat_map(|&pressure| ANGLES.map(|angle| (pressure, angle)));
    asked.any(|(pressure, angle)| drops(pressure, angle))
}

/// Dimension of the parameter `path` of the law `kind`, which may lie in a law inside of it; a bare number where the registry does not
/// say.
fn dimension(kind: &str, path: &str) -> Dimension {
    let Some(info) = registry::find(kind) else {
        return Dimension::Dimensionless;
    };
    let mut own = String::new();
    let mut segments = path.split('.');
    while let Some(segment) = segments.next() {
        if segment.parse::<usize>().is_ok() {
            own.push_str("[]");
        } else {
            own = if own.is_empty() {
                segment.to_owned()
            } else {
                format!("{own}.{segment}")
            };
        }
        match info.parameters.iter().find(|known| known.path == own) {
            Some(known) if known.dimension == Dimension::Law => {
                let rest: Vec<&str> = segments.collect();
                let (inner, below) = rest.split_first().map_or(("", &[][..]), |(a, b)| (*a, b));
                return dimension(inner, &below.join("."));
            }
            Some(known) => return known.dimension,
            None => {}
        }
    }
    Dimension::Dimensionless
}

/// Paths of all numbers below `value`.
fn numbers_in(value: &Value, path: &str) -> Vec<String> {
    let below = |name: &str| match path {
        "" => name.to_owned(),
        path => format!("{path}.{name}"),
    };
    match value {
        Value::Number(_) => vec![path.to_owned()],
        Value::Object(map) => (map.iter())
            .flat_map(|(name, value)| numbers_in(value, &below(name)))
            .collect(),
        Value::Array(list) => (list.iter().enumerate())
            .flat_map(|(index, value)| numbers_in(value, &below(&index.to_string())))
            .collect(),
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use stickslip_friction::{
        Coulomb, FibreCoverage, Kernel, PlyFraction, SlipPath, SlipPower, StaticDynamic, Transition,
    };

    use super::*;

    fn drops(law: &dyn FrictionLaw, free: &str, fitted: f64) -> bool {
        let candidate = Candidate::of_law("own name", law, &[(free, [0.1, 0.5])]).unwrap();
        candidate.drops_without_length(&[fitted])
    }

    #[test]
    fn a_drop_without_length_is_known_by_what_a_law_does() {
        let constant = Coulomb::new(0.3).unwrap();
        assert!(!drops(&constant, "mu", 0.3));
        let transition = SlipPower::new(0.4, 0.2, 1e-3, 2.0, SlipPath::Committed).unwrap();
        assert!(!drops(&transition, "static", 0.4));
        for transition in [Transition::Drop, Transition::Lagged] {
            let law = StaticDynamic::new(0.4, 0.2, transition).unwrap();
            assert!(drops(&law, "static", 0.4), "{transition:?}");
            let ply = PlyFraction {
                angle: 0.0,
                fraction: 1.0,
            };
            let kernel = Kernel::Swept { kappa: 0.5 };
            let matrix = Box::new(constant.clone());
            // Of another kind, and with the drop in a part of it.
            let mixed = FibreCoverage::new(vec![ply], 0.6, kernel, law.box_clone(), matrix);
            let free = "fibre.static_dynamic.static";
            assert!(drops(&mixed.unwrap(), free, 0.4), "{transition:?}");
        }
    }

    #[test]
    fn a_drop_is_seen_where_a_law_refuses_most_of_the_range() {
        let law = StaticDynamic::new(0.4999, 0.4998, Transition::Drop).unwrap();
        assert!(drops(&law, "static", 0.4999));
        assert!(!drops(&law, "static", 0.4998));
    }
}
