//! Loads.

use crate::declaration::numbers;
use crate::declaration::{
    REQUIRED, Range, Table, forces, stresses, table, temperatures, text, words,
};

const PUSHES: Range = numbers(
    " ≥ 0",
    "0 or more: a pin pushes; turn the direction to push the other way",
    |value| value >= 0.0,
);

const KINDS: &[&[&str]] = &[
    &["force"],
    &["bearing"],
    &["pressure"],
    &["polar_traction"],
    &["temperature"],
];

#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("loads", &[
        text("name", "`load1`, `load2`, …", r#""pull""#, "name in the results"),
        words("on", "`body.set`, or the body of a temperature", REQUIRED, r#""plate.left""#, "the edge that is loaded; a force also on an area, such as `pin.section`, over which it is spread evenly, or on a point"),
        table("force", "one of the five", "a total force, spread evenly over an edge"),
        table("bearing", "one of the five", "a force on a hole without a pin, as pressure by an assumed law: cosine, uniform"),
        table("pressure", "one of the five", "a pressure on an edge"),
        table("polar_traction", "one of the five", "stresses on a circle, from a file"),
        table("temperature", "one of the five", "a temperature change of a body"),
    ]).one_of(KINDS, "force, bearing, pressure, polar_traction, temperature"),
    Table::new("loads.force", &[
        words("direction", "two numbers", REQUIRED, "[-1, 0]", "vector (x, y), of any length but zero"),
        forces("steps", REQUIRED, r#"["1 kN"]"#,
            "magnitudes of the force on the whole body, also in a half model, spread evenly over the edge"),
    ]),
    Table::new("loads.bearing", &[
        words("direction", "two numbers", REQUIRED, "[-1, 0]",
            "vector (x, y) of the force on the body, of any length but zero"),
        words("law", r#"`"cosine"`, `"uniform"`"#, REQUIRED, r#""cosine""#, "how the pressure is spread"),
        forces("steps", REQUIRED, r#"["2 kN", "4 kN"]"#,
            "magnitudes of the force on the whole hole, also in a half model").range(PUSHES),
    ]),
    Table::new("loads.pressure", &[
        stresses("steps", REQUIRED, r#"["1 MPa"]"#, "positive pushes on the body, negative pulls"),
    ]),
    Table::new("loads.polar_traction", &[
        words("file", "path", REQUIRED, r#""data/persson-ring5R-65deg.csv""#, "table, relative to the folder of the scene"),
        words("stress", "unit of stress", REQUIRED, r#""MPa""#, "unit of its stresses"),
        text("theta", r#"`"theta_deg"`"#, r#""theta_deg""#, "its column of angles in degrees"),
        text("radial", r#"`"sigma_r"`"#, r#""sigma_r""#, "its column of σ_r"),
        text("shear", r#"`"tau_rtheta"`"#, r#""tau_rtheta""#, "its column of τ_rθ"),
        words("steps", "list of numbers", REQUIRED, "[1.0]", "factors of its stresses"),
    ]),
    Table::new("loads.temperature", &[
        temperatures("steps", REQUIRED, r#"["-100 K"]"#,
            "change of the whole body's temperature since the stress-free state; its material needs an expansion"),
    ]),
];
