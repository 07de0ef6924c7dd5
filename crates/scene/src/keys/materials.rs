//! Plies and materials.

use crate::declaration::{
    POSITIVE, REQUIRED, Table, angle, expansion, flag, length, number, stress, table, temperature,
    text, words,
};

#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("plies.NAME", &[
        stress("e1", REQUIRED, r#""140 GPa""#, "E1, along the fibres").noted(" > 0"),
        stress("e2", REQUIRED, r#""9 GPa""#, "E2, across them").noted(" > 0"),
        stress("g12", REQUIRED, r#""5 GPa""#, "shear modulus G12").noted(" > 0"),
        number("nu12", REQUIRED, "0.3", "ν12, |ν12| < √(E1/E2)"),
        length("thickness", REQUIRED, r#""0.125 mm""#, "thickness of the cured ply").noted(" > 0"),
        expansion("expansion1", "0", r#""0.02e-6 1/K""#, "along the fibres"),
        expansion("expansion2", "0", r#""22.5e-6 1/K""#, "across them"),
        table("strengths", "none known", "strengths, as far as they are known"),
    ]),
    Table::new("plies.NAME.strengths", &[
        stress("xt", "not known", r#""1500 MPa""#, "tension along the fibres").noted(" > 0"),
        stress("xc", "not known", r#""1200 MPa""#, "compression along the fibres").noted(" > 0"),
        stress("yt", "not known", r#""50 MPa""#, "tension across the fibres").noted(" > 0"),
        stress("yc", "not known", r#""200 MPa""#, "compression across the fibres").noted(" > 0"),
        stress("s12", "not known", r#""70 MPa""#, "shear in the plane").noted(" > 0"),
        stress("zt", "not known", r#""50 MPa""#, "tension through the thickness").noted(" > 0"),
        stress("zc", "not known", r#""200 MPa""#, "compression through the thickness").noted(" > 0"),
        stress("s13", "not known", r#""70 MPa""#, "shear in the 1–3 plane").noted(" > 0"),
        stress("s23", "not known", r#""100 MPa""#, "shear in the 2–3 plane, often taken as yc/2").noted(" > 0"),
        number("strain_1t", "not known", "0.0105", "strain in tension along the fibres").noted(" > 0"),
        number("strain_1c", "not known", "0.0085", "strain in compression along the fibres").noted(" > 0"),
        number("strain_2t", "not known", "0.005", "strain in tension across the fibres").noted(" > 0"),
        number("strain_2c", "not known", "0.02", "strain in compression across the fibres").noted(" > 0"),
        number("strain_12", "not known", "0.014", "engineering shear strain in the plane").noted(" > 0"),
        flag("linear_strain_limits", "`false`", "true", "strain limits that are not given are strength over modulus"),
    ]),
    Table::new("materials.NAME", &[
        table("isotropic", "one of the three", "the same in all directions"),
        table("orthotropic", "one of the three", "three planes of symmetry, such as a ply, or a laminate as a whole"),
        table("laminate", "one of the three", "a stack of plies"),
    ]).choice(),
    Table::new("materials.NAME.isotropic", &[
        stress("young", REQUIRED, r#""70 GPa""#, "Young's modulus E").range(POSITIVE),
        number("poisson", REQUIRED, "0.3", "Poisson's ratio ν, −1 < ν ≤ 0.5, in plane strain < 0.5"),
        expansion("expansion", "0", r#""2.3e-5 1/K""#, "coefficient of thermal expansion"),
        stress("yield", "not known", r#""350 MPa""#,
            "von Mises stress at which it yields: results say where and in which step a body reaches it, and stay elastic beyond").range(POSITIVE),
    ]),
    Table::new("materials.NAME.orthotropic", &[
        stress("e1", REQUIRED, r#""140 GPa""#, "E1").range(POSITIVE),
        stress("e2", REQUIRED, r#""9 GPa""#, "E2").range(POSITIVE),
        stress("g12", REQUIRED, r#""5 GPa""#, "shear modulus G12").range(POSITIVE),
        number("nu12", REQUIRED, "0.3", "ν12, |ν12| < √(E1/E2)"),
        angle("angle", "0 deg", r#""45 deg""#, "direction of the 1-axis from +x"),
        expansion("expansion1", "0", r#""-0.9e-6 1/K""#, "along the 1-axis"),
        expansion("expansion2", "0", r#""27e-6 1/K""#, "along the 2-axis"),
        stress("e3", "required in plane strain", r#""9 GPa""#, "E3, through the thickness").range(POSITIVE),
        number("nu13", "required in plane strain", "0.3", "ν13"),
        number("nu23", "required in plane strain", "0.4", "ν23"),
        expansion("expansion3", "0", r#""27e-6 1/K""#, "along the 3-axis; matters in plane strain"),
    ]),
    Table::new("materials.NAME.laminate", &[
        text("layup", REQUIRED, r#""[0/±45/90]s""#,
            "the stack; one that is not symmetric bends when it is stretched and is refused with the size of that coupling"),
        words("ply", "name of a ply", "required, unless the lay-up names all, as in `[0:carbon/90:glass]s`", r#""carbon""#,
            "the ply wherever the lay-up names none"),
        angle("angle", "0 deg", r#""30 deg""#, "direction of the lay-up's 0° from +x"),
        temperature("cure", "0 K", r#""-150 K""#,
            "temperature since the plies were free of stress, usually since the cure and negative; what stays in the plies is \
            held while loads grow"),
        flag("held_flat", "`false`", "true", "accepts a lay-up that is not symmetric, because something holds the plate flat"),
    ]),
];
