//! The scene itself, and its tables without names.

use stickslip_contact::solver::SOLVERS;

use super::{coded, quoted};
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Table, angle, bed_stiffness, counts, filled, flag, integer, length,
    lists, names, set, spring_stiffness, table, tables_of, text, words,
};

#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("", &[
        integer("version", REQUIRED, "1", "version of this format; 1 is the only one"),
        text("title", "name of the file", r#""Pin-loaded plate""#, "headline of the results"),
        text("description", NONE, r#""Clearance 0.01 mm.""#, "what the scene shows"),
        table("units", "mm, N, MPa", "units of the results"),
        table("analysis", "all its defaults", "how the scene is solved"),
        tables_of("plies", NONE, "plies of laminates by name"),
        tables_of("materials", NONE, "elastic constants by name"),
        tables_of("bodies", REQUIRED, "bodies by name, at least one"),
        table("mesh", "chosen by the accuracy", "how finely the bodies are divided"),
        lists("contacts", NONE, "edges that may touch"),
        tables_of("fasteners", NONE, "fasteners through several plates by name"),
        lists("supports", NONE, "given displacements"),
        lists("platens", NONE, "rigid plates glued to edges"),
        lists("loads", NONE, "loads and their history"),
        lists("edges", NONE, "further edges to report"),
        table("failure", NONE, "failure of the plies of laminates"),
        table("output", "all its defaults", "what is written beside the tables"),
    ]),
    Table::new("units", &[
        words("length", "unit of length", r#"`"mm"`"#, r#""in""#, "lengths, gaps, slips"),
        words("force", "unit of force", r#"`"N"`"#, r#""lbf""#, "forces"),
        words("stress", "unit of stress", r#"`"MPa"`"#, r#""psi""#, "stresses, pressures"),
    ]),
    Table::new("analysis", &[
        words("plane", r#"`"stress"`, `"strain"`"#, r#"`"stress"`"#, r#""strain""#, "plane stress or plane strain"),
        words("model", r#"`"auto"`, `"half"`, `"whole"`"#, r#"`"auto"`"#, r#""whole""#,
            "half: y ≥ 0 of round shapes, x ≥ 0 of a line contact; auto takes it where shapes, materials, supports, platens, \
            loads and friction laws are symmetric and it has all `edges`; half is refused where they are not; a rectangle has \
            no half"),
        words("kinematics", r#"`"small"`, `"deformed-gaps"`, `"auto"`"#, r#"`"small"` with a mesh or fasteners, `"auto"` without"#, r#""deformed-gaps""#,
            "small: contact is found on the undeformed geometry; deformed-gaps: gaps, normals and closest points follow the displacement, \
            between linear bodies, for exact gaps and matching meshes; not for progressive failure and experiments; auto: deformed-gaps where it \
            changes more than three tenths of the accuracy, otherwise small with the change among the errors"),
        words("compliance", r#"`"auto"`, `"matrix"`, `"blocks"`"#, r#"`"auto"`"#, r#""blocks""#,
            "how the compliance of a body with contact on several edges is held: matrix: as one; blocks: as a matrix for each edge and few shapes \
            of forces, harmonics on a hole, by which edges act on each other, with the error in tractions among the choices; auto: blocks beyond \
            4000 components where solver and kinematics allow them"),
        names("solver", solvers,
            r#"`"auto"`"#, r#""pivoting""#,
            "auto and newton: semismooth Newton, then pivoting where it fails; status: iteration of statuses before these \
            two; the others alone. All but experimental ones ask first for a proof that the load cannot be balanced, and stop \
            at stated work"),
        flag("experimental", "`false`", "true",
            "allows solvers whose answers may be inexact (penalty) or that are limited to few points or to small friction \
            (enumeration, Tresca)"),
        integer("substeps", "`1`; by the accuracy where one is sought", "4",
            "equal sub-steps of every load step; one that fails is halved by itself").range(counts(1, 100_000)),
        words("ramp", r#"`"linear"`, `"quadratic"`"#, r#"`"linear"`, `"quadratic"` where the program chooses sub-steps"#, r#""quadratic""#,
            "load at sub-step k of n in the first load step, from nothing to its value P: P k/n, or P (k/n)², finer where \
            contact spreads fastest; the same of what a later step adds if it begins with all points open; others are linear"),
        words("accuracy", "percentage or number, 1e-8 to 0.5, or a table of these", "`\"1 %\"` without a mesh", r#"{ peak_pressure = "0.1 %" }"#,
            "largest relative error that is asked for; bodies and steps are divided until the estimated errors of peak pressure, peak \
            tangential stress, extent of contact and friction force, or of displacements in a scene without edges, are below it; or those of the numbers that a table names, each \
            with its own: `peak_pressure`, `peak_hoop`, `contact_extent`, `stick_extent`, `friction_force`, `normal_force`, \
            `hoop_at_bearing`, `displacement` and `stiffness` of what is loaded, `tangent_stiffness`, `reaction`"),
        words("budget", "time", r#"`"60 s"` without `accuracy`, no limit with it"#, r#""10 s""#,
            "time after which no finer model is tried, and one that is not ready is given up; the result then states the error that it has; needs `accuracy`"),
        words("memory", "memory", r#"`"4 GB"`"#, r#""16 GB""#,
            "estimated memory above which no finer model of elements is tried; the result then states the error that it has; for scenes whose mesh is left to the program"),
        integer("contact_nodes", "by the accuracy", "61",
            "nodes on half of each contact circle of bodies by series; pins them").range(counts(9, 2049)),
    ]),
    Table::new("contacts", &[
        text("name", "name of the second body", r#""pin""#, "name in the results, a different one for each contact"),
        set("first", REQUIRED, r#""plate.hole""#,
            "a hole, the `contact` edge of a cylinder, or an open edge; of an elastic body"),
        set("second", REQUIRED, r#""pin.rim""#,
            "the rim of a disk or the `outer` edge of a ring in the hole, the `contact` edge of a block under the cylinder, or another open edge"),
        words("gap", r#"`"exact"`, `"linearised"`, `"faceted"`"#, r#"`"exact"`"#, r#""linearised""#,
            "initial gap: of the true circles; to first order, c (1 − cos θ) with clearance c or x²/2R, as closed forms have \
            it; between the nodes of the mesh"),
        words("projection", r#"`"auto"`, `"nodes"`, `"mortar"`, `"dual-mortar"`"#, r#"`"auto"`"#, r#""dual-mortar""#,
            "how the edges are tied: by pairs of nodes, which the meshes must have; by a mortar projection with the shape \
            functions of the first edge, or with functions dual to them; auto pairs nodes where the meshes match and takes \
            dual mortar where they do not"),
        flag("interference", "`false`", "true",
            "allows a pin or bushing larger than its hole, by at most 10 % of the radius; it starts concentric, and the whole \
            overlap acts from the first sub-step"),
        names("friction", laws, REQUIRED, ".static_dynamic = { static = 0.35, dynamic = 0.25 }",
            "the friction law by name, with its parameters; those of other crates too"),
    ]),
    Table::new("supports", &[
        set("on", REQUIRED, r#""plate.left""#, "edge, point, or area, whose mean displacement is held by a reaction that is spread evenly over it"),
        words("fix", r#"list of `"x"`, `"y"`"#, "required, or `normal`", r#"["x"]"#,
            "axes along which the nodes are held").range(filled(r#"["x"], ["y"] or ["x", "y"]"#)),
        angle("normal", NONE, r#""30 deg""#, "one direction, from +x, along which the nodes are held; across it they slide"),
        length("displacement", "0", r#""0.01 mm""#,
            "displacement along that one axis or direction, reached at the end of the first load step and kept"),
        spring_stiffness("stiffness", NONE, r#""500 N/mm""#,
            "springs to the ground instead, along each axis or direction: of the whole edge, over which it is spread evenly, or of a point").range(POSITIVE),
        bed_stiffness("bed", NONE, r#""20 MPa/mm""#, "the same of an edge, per area").range(POSITIVE),
    ]).one_of(&[&["fix"], &["normal"]], r#"fix = ["x", "y"], normal = "30 deg""#),
    Table::new("platens", &[
        set("on", REQUIRED, r#""plate.left""#, "the edge"),
        words("free", r#"list of `"x"`, `"y"`"#, REQUIRED, r#"["x", "y"]"#,
            "axes along which it moves freely; along the others it is held, `[]` holds it"),
    ]),
    Table::new("edges", &[
        set("on", REQUIRED, r#""plate.left""#,
            "an edge of an elastic body: a circle, reported over θ, an edge along x, reported over x, or any other open edge of \
            outlines, rectangles and meshes whose curve is known, reported over the arc length s; not the second edge of a \
            contact; one that a half model lacks makes auto choose the whole"),
    ]),
    Table::new("output", &[
        words("fields", r#"`"none"`, `"peak"`, `"last"`, `"all"`"#, r#"`"peak"`"#, r#""all""#,
            "load steps whose displacements and stresses are written as VTU, and drawn: none, that of the largest load in \
            magnitude (the earliest of equals), of each load by which joints of their own are counted, the last, every one"),
        flag("figures", "`true`", "false", "whether figures are drawn, as SVG, as PNG and in `report.html`"),
        flag("meshes", "`false`", "true", "whether the meshes of bodies are written as `meshes/BODY.msh` and `.inp`, which `shape.mesh` reads"),
    ]),
];

/// The names of the contact solvers.
fn solvers() -> String {
    let of = |experimental: bool| {
        let own = SOLVERS
            .iter()
            .filter(|own| own.experimental == experimental);
        quoted(own.map(|own| own.name))
    };
    format!("{}; experimental {}", of(false), of(true))
}

/// The friction laws, each a table.
fn laws() -> String {
    format!(
        "table {}",
        coded(stickslip_friction::laws().map(|law| law.name))
    )
}
