//! What can be wrong with a scene, each with its remedy.

use miette::Diagnostic;
use stickslip_fem_core::material::MaterialError;
use thiserror::Error;

use super::laminate::LaminateProblem;
use super::remedy::{coded, counted, elsewhere, listed, material_remedy, meant, of_file, on_lines};
use stickslip_units::UnitError;

/// One thing wrong with a scene. Every variant carries the numbers and names that its message and remedy show.
#[derive(Debug, Clone, PartialEq, Error, Diagnostic)]
#[non_exhaustive]
pub enum SceneProblem {
    /// There is no such file.
    #[error("the scene file '{path}' does not exist")]
    #[diagnostic(
        code(scene::missing_file),
        help(
            "check the path, or write a first scene with `stickslip init pin-loaded-plate {path}`"
        )
    )]
    MissingFile {
        /// Path as given.
        path: String,
    },
    /// The file cannot be read.
    #[error("the file '{path}' cannot be read: {cause}")]
    #[diagnostic(
        code(scene::unreadable),
        help("a scene is a text file (UTF-8) that ends in .toml or .json")
    )]
    Unreadable {
        /// Path as given.
        path: String,
        /// What the system says.
        cause: String,
    },
    /// A mesh or a geometry of another program.
    #[error("'{path}' is {what}, not a scene")]
    #[diagnostic(code(scene::foreign), help("{remedy}"))]
    Foreign {
        /// Path as given.
        path: String,
        /// What it is, with its article.
        what: &'static str,
        /// A scene that names it.
        remedy: String,
    },
    /// The text is not TOML or JSON.
    #[error("this is not valid {format}: {cause}")]
    #[diagnostic(
        code(scene::syntax),
        help("texts and quantities stand in double quotes: thickness = \"0.06 in\"")
    )]
    Syntax {
        /// TOML or JSON.
        format: &'static str,
        /// What the parser says.
        cause: String,
    },
    /// A text with a character that steers rather than shows.
    #[error("the text holds the control character U+{:04X}", u32::from(*letter))]
    #[diagnostic(
        code(scene::control_character),
        help("remove it; line breaks and tabs may stand in a description only")
    )]
    ControlCharacter {
        /// The character.
        letter: char,
    },
    /// The same key twice in one table.
    #[error("the key '{key}' is given twice")]
    #[diagnostic(code(scene::duplicate_key), help("keep one of the two{}", on_lines(*lines)))]
    DuplicateKey {
        /// The key.
        key: String,
        /// The lines of both, from 1, where they are known.
        lines: Option<(usize, usize)>,
    },
    /// An override is not `key=value`.
    #[error("'{argument}' is not of the form key=value")]
    #[diagnostic(
        code(scene::override_form),
        help(
            "write for example --set mesh.spacing=\"2.25 deg\" or --set contacts.0.friction.coulomb.mu=0.15"
        )
    )]
    OverrideForm {
        /// The argument as given.
        argument: String,
    },
    /// The key of an override leads through something that is not a table.
    #[error("'{key}' cannot be set: '{parent}' is {found}, which holds no keys")]
    #[diagnostic(
        code(scene::override_path),
        help("`stickslip check` prints every key that a scene has")
    )]
    OverridePath {
        /// The whole key.
        key: String,
        /// Its part that is not a table.
        parent: String,
        /// What that is.
        found: String,
    },
    /// The index of an override is not in its list.
    #[error("'{key}' cannot be set: '{list}' has {length} {} and '{index}' is not one of them", counted(*length, "entry", "entries"))]
    #[diagnostic(
        code(scene::override_index),
        help("entries are counted from 0; the number {length} adds one")
    )]
    OverrideIndex {
        /// The whole key.
        key: String,
        /// The list.
        list: String,
        /// Its length.
        length: usize,
        /// The index given.
        index: String,
    },
    /// No version.
    #[error("the scene does not say which version of the format it is written in")]
    #[diagnostic(
        code(scene::missing_version),
        help("add the line `version = {supported}` at the top")
    )]
    MissingVersion {
        /// Version that this program reads.
        supported: u64,
    },
    /// A version that this program does not know.
    #[error("version {found} of the scene format is not supported")]
    #[diagnostic(
        code(scene::unsupported_version),
        help("this program reads `version = {supported}`")
    )]
    UnsupportedVersion {
        /// As written.
        found: String,
        /// Version that this program reads.
        supported: u64,
    },
    /// A key that means nothing here.
    #[error("unknown key '{key}'")]
    #[diagnostic(code(scene::unknown_key), help("{}{}known keys here: {}", meant(nearest.as_deref()), elsewhere(key), known.join(", ")))]
    UnknownKey {
        /// The key.
        key: String,
        /// The known key most like it.
        nearest: Option<String>,
        /// All known keys.
        known: Vec<String>,
    },
    /// A value that is not among the choices.
    #[error("'{found}' is not {what}")]
    #[diagnostic(code(scene::unknown_name), help("{}choices: {}", meant(nearest.as_deref()), known.join(", ")))]
    UnknownName {
        /// What is wanted, with its article.
        what: String,
        /// The word.
        found: String,
        /// The choice most like it.
        nearest: Option<String>,
        /// All choices.
        known: Vec<String>,
    },
    /// A required key is not there.
    #[error("'{key}' is missing in '{table}'")]
    #[diagnostic(code(scene::missing_key), help("add for example {}", coded(example)))]
    MissingKey {
        /// The key.
        key: String,
        /// The table that lacks it.
        table: String,
        /// A line that would do; in backticks where words follow it.
        example: String,
    },
    /// A number where a text belongs, and the like.
    #[error("expected {expected}, found {found}")]
    #[diagnostic(code(scene::wrong_kind), help("give {expected}"))]
    WrongKind {
        /// What belongs here.
        expected: String,
        /// What is there.
        found: String,
    },
    /// A list with too many or too few values.
    #[error("{wanted} {} wanted, found {found}", counted(*wanted, "value is", "values are"))]
    #[diagnostic(
        code(scene::wrong_length),
        help("give a list of {wanted} {}", counted(*wanted, "value", "values"))
    )]
    WrongLength {
        /// How many belong here.
        wanted: usize,
        /// How many are there.
        found: usize,
    },
    /// A quantity is not one, or not of the right dimension.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Unit(#[from] UnitError),
    /// NaN or infinity.
    #[error("{value} is not a finite number")]
    #[diagnostic(code(scene::not_finite), help("give a finite number"))]
    NotFinite {
        /// As written.
        value: String,
    },
    /// A number outside its range.
    #[error("{key} = {value} is outside its range: {allowed}")]
    #[diagnostic(code(scene::out_of_range), help("{key} must be {allowed}"))]
    OutOfRange {
        /// The key.
        key: String,
        /// As written.
        value: String,
        /// What is allowed, as text.
        allowed: String,
    },
    /// A value that its reader refuses for another reason.
    #[error("{message}")]
    #[diagnostic(
        code(scene::refused),
        help("`stickslip list` shows what can be written")
    )]
    Refused {
        /// The reason.
        message: String,
    },
    /// A material that cannot exist.
    #[error("material '{material}': {cause}")]
    #[diagnostic(code(scene::material), help("{}", material_remedy(cause)))]
    Material {
        /// Its name in the scene.
        material: String,
        /// What is wrong.
        cause: MaterialError,
    },
    /// A laminate, or what is asked about its failure.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Laminate(#[from] LaminateProblem),
    /// Parameters that a friction law refuses.
    #[error("{message}")]
    #[diagnostic(
        code(scene::friction),
        help("`stickslip list` shows the parameters of '{law}' and their ranges")
    )]
    Friction {
        /// The law.
        law: String,
        /// The law's own words.
        message: String,
    },
    /// A contact without friction law.
    #[error("contact '{contact}' has no friction law")]
    #[diagnostic(
        code(scene::missing_friction),
        help(
            "add one, for example friction.coulomb = {{ mu = 0.3 }}; a frictionless contact says friction.coulomb = {{ mu = 0 }}"
        )
    )]
    MissingFriction {
        /// Name of the contact.
        contact: String,
    },
    /// A name that is not defined in the scene.
    #[error("there is no {what} '{name}'")]
    #[diagnostic(
        code(scene::undefined),
        help("{}{what} names in this scene: {}", meant(nearest.as_deref()), listed(known))
    )]
    Undefined {
        /// Body or material.
        what: &'static str,
        /// The name.
        name: String,
        /// The defined name most like it.
        nearest: Option<String>,
        /// The names defined.
        known: Vec<String>,
    },
    /// A set that a body's shape does not have.
    #[error("'{body}' ({shape}) has no {what} '{set}'")]
    #[diagnostic(code(scene::missing_set), help("{}sets of '{body}' that fit here: {}{}", meant(nearest.as_deref()), listed(known), of_file(notes)))]
    MissingSet {
        /// The body.
        body: String,
        /// Its shape.
        shape: &'static str,
        /// Edge, or edge or point.
        what: &'static str,
        /// The requested set.
        set: String,
        /// The set most like it.
        nearest: Option<String>,
        /// The sets that would do, with the body's name.
        known: Vec<String>,
        /// What was passed over in the file that the sets are from.
        notes: Vec<String>,
    },
    /// Two edges that cannot touch in this version.
    #[error("'{first}' and '{second}' cannot be in contact")]
    #[diagnostic(code(scene::contact_pair), help("{remedy}"))]
    ContactPair {
        /// First edge.
        first: String,
        /// Second edge.
        second: String,
        /// What would do.
        remedy: String,
    },
    /// What a hole holds does not fit.
    #[error(
        "the {part} (radius {pin}) is larger than the hole (radius {hole}): they overlap by {overlap}"
    )]
    #[diagnostic(
        code(scene::pin_too_large),
        help("make the {part} smaller than {hole}, or say interference = true for a press fit")
    )]
    PinTooLarge {
        /// Pin or bushing.
        part: &'static str,
        /// Its radius as written.
        pin: String,
        /// Radius of the hole as written.
        hole: String,
        /// The difference with its unit.
        overlap: String,
    },
    /// Bodies that nothing holds.
    #[error(
        "nothing holds {bodies}: no support, no platen, and no contact with a body that has one"
    )]
    #[diagnostic(
        code(scene::unsupported_body),
        help("add a support, for example [[supports]] on = \"{example}\", fix = [\"x\", \"y\"]")
    )]
    UnsupportedBody {
        /// The bodies, quoted.
        bodies: String,
        /// A set that could be held.
        example: String,
    },
    /// Loads with different numbers of steps.
    #[error("load '{load}' has {steps} {}, but load '{other}' has {other_steps}", counted(*steps, "step", "steps"))]
    #[diagnostic(
        code(scene::unequal_steps),
        help("give both the same number of steps; repeat a value to hold a load constant")
    )]
    UnequalSteps {
        /// The load.
        load: String,
        /// Its steps.
        steps: usize,
        /// The first load.
        other: String,
        /// Its steps.
        other_steps: usize,
    },
    /// Two keys that exclude each other, or none of the keys of which one is needed.
    #[error("{table}: exactly one of {choices} is needed, found {found}")]
    #[diagnostic(code(scene::one_of), help("keep one of {choices}"))]
    OneOf {
        /// The table.
        table: String,
        /// The keys.
        choices: String,
        /// Those that are there.
        found: String,
    },
    /// Two settings that contradict each other.
    #[error("{message}")]
    #[diagnostic(code(scene::conflict), help("{remedy}"))]
    Conflict {
        /// The contradiction.
        message: String,
        /// How to resolve it.
        remedy: String,
    },
    /// A data file of the scene cannot be used.
    #[error("data file '{path}': {cause}")]
    #[diagnostic(code(scene::data_file), help("{remedy}"))]
    DataFile {
        /// Path, resolved against the scene's folder.
        path: String,
        /// What is wrong, with the line.
        cause: String,
        /// What would do.
        remedy: String,
    },
    /// An experiment that reads well but whose data cannot be used.
    #[error("{message}")]
    #[diagnostic(code(experiment::data), help("{remedy}"))]
    Experiment {
        /// What is wrong, with its numbers.
        message: String,
        /// How to correct it.
        remedy: String,
    },
    /// A scene that reads well but cannot be modelled.
    #[error("{message}")]
    #[diagnostic(code(scene::model), help("{remedy}"))]
    Model {
        /// The model builder's words, with their numbers.
        message: String,
        /// How to correct it.
        remedy: String,
    },
}

#[cfg(test)]
mod tests;
