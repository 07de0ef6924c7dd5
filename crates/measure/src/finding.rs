//! What a reader of an experiment must know, or may want to: findings as data. Whoever shows them makes the sentences.
//!
//! Lengths are in mm, forces in N and stresses in MPa, whatever units results are shown in.

mod data;
mod edge;
mod friction;

use serde::{Serialize, Serializer};
use stickslip_experiment::Experiment;

pub use data::{
    Apart, BackFinding, FieldFinding, FileFinding, LineFinding, PictureFinding, TableFinding, Worst,
};
pub use edge::{BearingFails, Check, FitFinding, ForceFinding, LoadFails, NotCompared};
pub use friction::{FrictionFinding, LeftOut, LeftOutReason, ModelFinding};

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Level {
    /// A choice, a default, or what was left out.
    Remark,
    /// What a reader must know before trusting the numbers.
    Warning,
}

/// What was found, by its subject.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Finding {
    /// The experiment file.
    File(FileFinding),
    /// Tables of displacements.
    Table(TableFinding),
    /// Displacements of any source.
    Field(FieldFinding),
    /// Fringe pictures.
    Picture(PictureFinding),
    /// Tables of fringe centres.
    Line(LineFinding),
    /// Front against back.
    Back(BackFinding),
    /// What the bands and checks of a region hold.
    Fit(FitFinding),
    /// Forces on the edge of a region.
    Force(ForceFinding),
    /// Slip zones and their coefficient.
    Friction(FrictionFinding),
    /// The scene as a model: fitted laws and the whole plate.
    Model(ModelFinding),
}

impl Finding {
    /// How much it matters.
    pub const fn level(&self) -> Level {
        let warns = match self {
            Self::File(FileFinding::IgnoredKey { .. }) => true,
            Self::Table(own) => own.warns(),
            Self::Field(own) => own.warns(),
            Self::Picture(own) => own.warns(),
            Self::Line(own) => own.warns(),
            Self::Back(own) => own.warns(),
            Self::Fit(own) => own.warns(),
            Self::Force(own) => own.warns(),
            Self::Friction(own) => own.warns(),
            Self::Model(own) => own.warns(),
        };
        if warns { Level::Warning } else { Level::Remark }
    }
}

/// Which data of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Its own.
    #[default]
    State,
    /// Those of its null field.
    NullField,
    /// Those of the back of the specimen.
    Back,
}

/// A finding and what it is of.
#[derive(Clone, Debug, PartialEq)]
pub struct Located {
    /// Name of the state; `None` for findings of several states or of the experiment as a whole.
    pub state: Option<String>,
    /// Which of its data.
    pub part: Part,
    /// What was found.
    pub finding: Finding,
}

impl Located {
    /// A finding of a state, or of its null field or back.
    pub fn of_state(state: &str, part: Part, finding: Finding) -> Self {
        Self {
            state: Some(state.to_owned()),
            part,
            finding,
        }
    }

    /// A finding that is of no single state, or that names its states itself.
    pub fn of_all(finding: Finding) -> Self {
        Self {
            state: None,
            part: Part::State,
            finding,
        }
    }
}

/// The ignored keys of `experiment`.
pub fn ignored_keys(experiment: &Experiment) -> Vec<Located> {
    let keys = experiment.without_effect.iter();
    let found = keys.map(|own| FileFinding::IgnoredKey {
        file: own.file.clone(),
        line: own.line,
        key: own.key,
        why: own.why,
    });
    found
        .map(|own| Located::of_all(Finding::File(own)))
        .collect()
}

impl Serialize for Located {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Entry<'a> {
            level: Level,
            #[serde(skip_serializing_if = "Option::is_none")]
            state: Option<&'a str>,
            #[serde(skip_serializing_if = "Option::is_none")]
            part: Option<Part>,
            #[serde(flatten)]
            finding: &'a Finding,
        }
        let entry = Entry {
            level: self.finding.level(),
            state: self.state.as_deref(),
            part: (self.part != Part::State).then_some(self.part),
            finding: &self.finding,
        };
        entry.serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn findings_are_flat_objects_with_their_level_and_kind() {
        let count = Finding::Picture(PictureFinding::PixelsApart {
            field: "U",
            pixels: 12,
        });
        assert_eq!(
            json!(Located::of_state("up", Part::NullField, count)),
            json!({ "level": "remark", "state": "up", "part": "null_field", "kind": "pixels_apart", "field": "U", "pixels": 12 })
        );
        let left_out = LeftOut {
            state: "up".to_owned(),
            reason: LeftOutReason::OutsideOfScene,
        };
        let left_out = Finding::Model(ModelFinding::LeftOutOfLaws(left_out));
        assert_eq!(
            json!(Located::of_all(left_out)),
            json!({ "level": "warning", "kind": "left_out_of_laws", "state": "up", "reason": "outside_of_scene" })
        );
    }
}
