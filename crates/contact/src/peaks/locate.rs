//! Where contact or stick ends, to a fraction of the node spacing.

/// A place with its estimated error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Located {
    /// The place `[length]`.
    pub place: f64,
    /// Estimated error `[length]`.
    pub error: f64,
}

/// Part of a spacing that the first node's gap puts the end too far inside, measured on discrete solutions.
const SMEARED: f64 = 0.15;
/// Estimated errors in spacings: by gaps without the first, with it, by pressures, and without either.
const ERRORS: [f64; 4] = [0.08, 0.15, 0.3, 0.3];

/// Locates the end of contact between the last touching and the first open node.
///
/// ```text
/// p ~ √(distance) on the held side:  p² linear;      g ~ distance^{3/2} on the free side:  g^{2/3} linear
/// ```
///
/// `held` are the touching nodes and `free` the open ones, from the end outwards, as (place `[length]`, p) and (place, g); values of any unit. For the end of stick they are
/// what friction holds in reserve, |q − q_s|, and the slip since it turned.
///
/// The gap of the first open node is smeared by the discretisation, and pressures oscillate from node to node; so the place is that of the second and third gap if there are as
/// many, otherwise of the first two, of the last three p² or half-way, always between the two nodes at the end. `None` if one side has no node.
///
/// Measured on discrete solutions, in spacings: the second and third gap are off by 0.04 in the median and 0.16 at most, three values of p² by 0.1 and 5.
pub fn locate_end(held: &[[f64; 2]], free: &[[f64; 2]]) -> Option<Located> {
    let (&[last, _], &[first, _]) = (held.first()?, free.first()?);
    let spacing = first - last;
    let opening = |nodes: &[[f64; 2]]| root(nodes, |value| value.max(0.0).cbrt().powi(2));
    let by_gaps = match free {
        [_, second, third, ..] => opening(&[*second, *third]).map(|place| (place, ERRORS[0])),
        [first, second] => {
            opening(&[*first, *second]).map(|place| (place + SMEARED * spacing, ERRORS[1]))
        }
        _ => None,
    };
    let by_pressures = || {
        let few = &held[..held.len().min(3)];
        root(few, |value| value * value).map(|place| (place, ERRORS[2]))
    };
    let (place, error) = by_gaps
        .or_else(by_pressures)
        .unwrap_or((last + 0.5 * spacing, ERRORS[3]));
    let part = (place - last) / spacing;
    // A fit that contradicts what touches knows no better than that.
    let error = if (0.0..=1.0).contains(&part) {
        error
    } else {
        error.max(ERRORS[3])
    };
    Some(Located {
        place: last + part.clamp(0.0, 1.0) * spacing,
        error: error * spacing.abs(),
    })
}

/// Root of the straight line through `nodes` of `value`, by least squares; `None` unless the values grow away from the first.
fn root(nodes: &[[f64; 2]], value: impl Fn(f64) -> f64) -> Option<f64> {
    let count = nodes.len() as f64;
    let [from, _] = *nodes.first()?;
    let sums = nodes.iter().fold([0.0; 4], |[x, y, xx, xy], node| {
        let (dx, dy) = (node[0] - from, value(node[1]));
        [x + dx, y + dy, xx + dx * dx, xy + dx * dy]
    });
    let [x, y, xx, xy] = sums;
    let slope = (count * xy - x * y) / (count * xx - x * x);
    let away = nodes.last()?[0] - from;
    let grows = slope * away > 0.0;
    grows.then(|| from + (x - y / slope) / count)
}
