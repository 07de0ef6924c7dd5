//! Random bodies of general outlines: holes anywhere, lugs, open edges, several fasteners.

mod holes;
mod open;
mod parts;
mod several;
mod shape;

use parts::{along, contact, fixed, friction, head, history, isotropic};
use rand::rngs::StdRng;

use super::draw::Draw;

/// One of the four families in turn.
pub(super) fn draw(case: usize, rng: &mut StdRng) -> Draw {
    match case % 4 {
        0 => holes::plate(rng),
        1 => holes::lug(rng),
        2 => open::contact(rng),
        _ => several::fasteners(rng),
    }
}
