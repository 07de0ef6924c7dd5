//! Settings of the failure analysis of laminates.

use super::{coded, quoted};
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Range, Table, counts, energy, filled, integer, length, names, number,
    numbers, set, table, table_as, words,
};

const NOT_NEGATIVE: Range = numbers(" ≥ 0", "at least 0 mm", |value| value >= 0.0);
const NOT_ZERO: Range = numbers(", not 0", "not 0; its sign is the direction", |value| {
    value != 0.0
});
const PART: Range = numbers(" in (0, 1]", "greater than 0, at most 1", |value| {
    value > 0.0 && value <= 1.0
});

#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("failure", &[
        names("criteria", criteria, REQUIRED, r#"["tsai_wu", "hashin"]"#,
            "one or more; the first one is drawn").range(filled(r#"at least one, such as ["max_stress"]"#)),
        words("bodies", "list of bodies", "all of a laminate", r#"["coupon"]"#,
            "bodies whose plies are checked").range(filled("at least one body; leave it out for all bodies of a laminate")),
        length("clear_of_supports", "5 % of the body's smaller outer dimension", r#""2 mm""#,
            "distance from the ends of supported edges and platens, and from points that are held, within which no ply is checked").range(NOT_NEGATIVE),
        number("tsai_wu_interaction", "`-0.5`", "0.0",
            "F12 of `tsai_wu` as a multiple of √(F11 F22)").noted(" between −1 and 1"),
        number("hashin_shear_weight", "`1.0`", "0.0", "weight of shear in fibre tension of `hashin`").noted(" from 0 to 1"),
        table("characteristic", NONE, "failure at a distance from the hole"),
        table("envelopes", NONE, "failure envelopes of the bodies' laminates"),
        table("progressive", NONE, "a pinned joint followed beyond the failure of its plies"),
    ]),
    Table::new("failure.characteristic", &[
        length("tension", REQUIRED, r#""1.8 mm""#, "R_t, at the net section").range(POSITIVE),
        length("compression", REQUIRED, r#""1.8 mm""#, "R_c, at the bearing point").range(POSITIVE),
    ]),
    Table::new("failure.envelopes", &[
        words("planes", r#"list of `"normal"`, `"shear"`"#, r#"`["normal","shear"]`"#, r#"["normal"]"#,
            "(σ_x, σ_y) and (σ_x, τ_xy)").range(filled(r#"at least one of "normal" and "shear""#)),
        integer("directions", "`180`", "360", "directions of load in each plane").range(counts(3, 100_000)),
        table("last_ply", NONE, "the last ply's failure as well, by ply discount"),
    ]),
    Table::new("failure.envelopes.last_ply", &[
        number("fibre", REQUIRED, "0.1", "on E1, after fibre failure; on E2 and G12 the smaller of both"),
        number("matrix", REQUIRED, "0.1", "on E2 and G12, after failure of the matrix"),
    ]),
    Table::new("failure.progressive", &[
        words("body", "body", "the only one of `failure.bodies`", r#""coupon""#,
            "the body whose plies fail; one contact touches its hole"),
        names("model", models, REQUIRED, ".ply_discount = { fibre = 0.01, matrix = 0.1 }",
            "how plies lose stiffness: the point model by name, with its parameters; those of other crates too"),
        table("crack_band", NONE, "fracture energies that scale strengths with the cells, by ply discount only"),
        table_as("control", "the loads, in 10 increments each", ".loads = {}", "what is raised"),
    ]),
    Table::new("failure.progressive.crack_band", &[
        energy("fibre_tension", NONE, r#""90 kJ/m2""#, "fibres in tension").range(POSITIVE),
        energy("fibre_compression", NONE, r#""80 kJ/m2""#, "fibres in compression").range(POSITIVE),
        energy("matrix_tension", NONE, r#""0.25 kJ/m2""#, "matrix in tension across the fibres").range(POSITIVE),
        energy("matrix_compression", NONE, r#""0.8 kJ/m2""#, "matrix in compression across the fibres").range(POSITIVE),
        energy("shear", NONE, r#""0.8 kJ/m2""#, "matrix in shear").range(POSITIVE),
    ]),
    Table::new("failure.progressive.control", &[
        table("loads", NONE, "the scene's loads, step by step, to the strength"),
        table("displacement", NONE, "an edge or point is driven in place of the load on it, past the peak"),
    ]),
    Table::new("failure.progressive.control.loads", &[
        integer("increments", "`10`", "20", "increments of each load step").range(counts(1, 10_000)),
    ]),
    Table::new("failure.progressive.control.displacement", &[
        set("on", REQUIRED, r#""plate.left""#,
            "the edge or point that is driven, of an elastic body; a support or platen there gives way along the axis"),
        words("axis", r#"`"x"`, `"y"`"#, r#"`"x"`"#, r#""y""#, "axis of the drive"),
        length("end", REQUIRED, r#""-0.4 mm""#, "displacement at the end").range(NOT_ZERO),
        integer("increments", "`40`", "60",
            "increments of the history, cut where many plies fail at once").range(counts(1, 10_000)),
        number("drop", "`0.3`", "0.5",
            "part of the peak load by which the load falls before the history ends, as in bearing tests (ASTM D5961)").range(PART),
    ]),
];

/// The registered failure criteria.
fn criteria() -> String {
    let names = stickslip_laminate::failure::criteria().map(|own| own.name);
    format!("list of {}", quoted(names))
}

/// The registered point models, each a table.
fn models() -> String {
    let names = stickslip_laminate::progressive::point_models().map(|own| own.name);
    format!("table {}", coded(names))
}
