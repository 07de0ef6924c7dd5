//! What the signs of quantities mean.

use stickslip_report::table::{Column, Table};

/// What each quantity's sign means, and what other programs do.
pub(crate) fn signs() -> Table {
    let columns = ["quantity", "meaning and sign", "elsewhere"];
    let mut table = Table::new(
        "Signs",
        columns.iter().map(|name| Column::new(*name, "")).collect(),
    );
    for row in SIGNS {
        table.push(row);
    }
    table
}

/// Quantity, its sign here, and where other programs or texts differ.
pub const SIGNS: [[&str; 3]; 14] = [
    [
        "θ",
        "angle about the centre of the contact's circle, from +x, counter-clockwise positive; the places of edge-NAME-step-NN.csv",
        "–",
    ],
    [
        "φ",
        "angle from the bearing point, φ = θ − θ_b, counter-clockwise positive; θ_b is the direction of the contact force on the first \
         body in the step in which it is largest. Half of a symmetric circle that bears at θ = 180° is read clockwise, as its mirror image",
        "some reports count angles from the net section, ±90° here",
    ],
    ["σ_r, σ_θ, σ_xx, …", "tension positive", "–"],
    [
        "τ_rθ, τ_xy",
        "positive on a positive face in the positive direction",
        "–",
    ],
    [
        "e_n, e_t",
        "e_n points from the second body into the first, e_t is e_n turned by +90°; \
         pin in a hole: e_r and e_θ; cylinder on a block: +y and −x",
        "Abaqus: local directions of the contact surface",
    ],
    [
        "CPRESS",
        "contact pressure, compression positive, never negative; −σ_r of the hole's edge, −σ_yy of a line",
        "Abaqus, Ansys (PRES): same",
    ],
    [
        "CSHEAR1",
        "friction traction on the first body along e_t; −τ_rθ of the hole's edge, +τ_xy of a line",
        "Abaqus: along its local 1-direction; check which body",
    ],
    [
        "COPEN",
        "gap, open positive, 0 in contact",
        "Abaqus: same; Ansys (GAP): open is negative",
    ],
    [
        "CSLIP1",
        "accumulated motion of the first body against the second along e_t",
        "Abaqus: along its local 1-direction; check which body",
    ],
    [
        "CSTATUS",
        "open, stick, slip+ (first body slips along +e_t, CSHEAR1 < 0), slip- (along −e_t, CSHEAR1 > 0)",
        "Abaqus: sticking or slipping, without direction",
    ],
    [
        "slip away, towards",
        "hole: the first body's edge slips against the second away from the bearing point of the step (q > 0) or towards it (q < 0), on either \
         side of it",
        "–",
    ],
    [
        "resultant",
        "force of the contact on the first body",
        "reactions of the second body are opposite",
    ],
    [
        "q, Q",
        "hole: q is positive where friction pulls the first body along the edge towards the bearing point of the step, \
         negative where it pulls away from it; line: Q is the tangential force on the first body along +x",
        "–",
    ],
    ["σ_b", "bearing stress |resultant| / (D t) of the step", "–"],
];
