//! An edge as a projection sees it: nodes by ascending parameter.

use stickslip_fem_core::element::{EdgeValues, edge_nodes, edge_shape, edge_slope};

use super::MortarError;

/// The nodes of a chain of edges along a contact, by ascending parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeSide {
    nodes: Vec<usize>,
    parameter: Vec<f64>,
    order: usize,
    period: Option<f64>,
}

impl EdgeSide {
    /// A chain with two ends: `nodes` among the body's contact points in walk order, inner nodes of edges included, their
    /// `parameter` (`[length]` or `[rad]`), and the polynomial `order` of the edges.
    ///
    /// # Errors
    /// [`MortarError`] for an order that does not exist, lists that do not fit, a parameter that does not ascend strictly,
    /// a mid-side node outside the middle half of its edge, or an edge that folds back on itself.
    pub fn open(nodes: Vec<usize>, parameter: Vec<f64>, order: usize) -> Result<Self, MortarError> {
        Self::new(nodes, parameter, order, None)
    }

    /// A chain whose last edge ends at the first node, one `period` of the parameter after it, in the unit of `parameter`.
    ///
    /// # Errors
    /// As [`EdgeSide::open`]; [`MortarError::Period`] if the nodes span the period or more.
    pub fn closed(
        nodes: Vec<usize>,
        parameter: Vec<f64>,
        order: usize,
        period: f64,
    ) -> Result<Self, MortarError> {
        Self::new(nodes, parameter, order, Some(period))
    }

    fn new(
        nodes: Vec<usize>,
        parameter: Vec<f64>,
        order: usize,
        period: Option<f64>,
    ) -> Result<Self, MortarError> {
        if edge_nodes(order).is_none() {
            return Err(MortarError::Order(order));
        }
        if parameter.len() != nodes.len() {
            return Err(MortarError::Parameters {
                parameters: parameter.len(),
                nodes: nodes.len(),
            });
        }
        let steps = nodes.len().saturating_sub(usize::from(period.is_none()));
        if steps == 0 || !steps.is_multiple_of(order) {
            return Err(MortarError::Nodes {
                nodes: nodes.len(),
                order,
            });
        }
        for (node, pair) in parameter.windows(2).enumerate() {
            if !(pair[0] < pair[1] && pair[0].is_finite() && pair[1].is_finite()) {
                let (from, to) = (pair[0], pair[1]);
                return Err(MortarError::NotAscending { node, from, to });
            }
        }
        if let Some(period) = period {
            let span = parameter[parameter.len() - 1] - parameter[0];
            if !(span < period && period.is_finite()) {
                return Err(MortarError::Period { span, period });
            }
        }
        let side = Self {
            nodes,
            parameter,
            order,
            period,
        };
        side.check_inner_nodes()?;
        Ok(side)
    }

    fn check_inner_nodes(&self) -> Result<(), MortarError> {
        for k in 0..self.edges() {
            let span = self.span(k);
            if let [start, middle, end] = span[..] {
                let fraction = (middle - start) / (end - start);
                if !(0.25..=0.75).contains(&fraction) {
                    let node = 2 * k + 1;
                    return Err(MortarError::MidSide { node, fraction });
                }
            } else if !self.ascends(&span) {
                return Err(MortarError::Folded { edge: k });
            }
        }
        Ok(())
    }

    /// Whether the parameter ascends along the edge with the nodes `span`, sampled eight times between nodes.
    fn ascends(&self, span: &[f64]) -> bool {
        let samples = 8 * self.order;
        (0..=samples).all(|k| {
            let xi = 2.0 * k as f64 / samples as f64 - 1.0;
            sum(edge_slope(self.order, xi), span) > 0.0
        })
    }

    /// Nodes among the body's contact points, in walk order.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Parameter of each node, ascending: an arc length `[length]` or an angle `[rad]`, as the side was given.
    pub fn parameter(&self) -> &[f64] {
        &self.parameter
    }

    /// Period of the parameter of a closed chain, in its unit.
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// Polynomial order of the edges.
    pub fn order(&self) -> usize {
        self.order
    }

    pub(super) fn edges(&self) -> usize {
        (self.nodes.len() - usize::from(self.period.is_none())) / self.order
    }

    /// Places in the walk of the nodes of edge `k`.
    pub(super) fn places(&self, k: usize) -> impl Iterator<Item = usize> + Clone + use<> {
        let (start, count) = (self.order * k, self.nodes.len());
        (0..=self.order).map(move |step| (start + step) % count)
    }

    /// Parameter at the nodes of edge `k`, ascending also where a closed chain returns to its start.
    pub(super) fn span(&self, k: usize) -> Vec<f64> {
        let mut span: Vec<f64> = self.places(k).map(|place| self.parameter[place]).collect();
        let last = span.len() - 1;
        if span[last] <= span[0] {
            span[last] += self.period.unwrap_or(0.0);
        }
        span
    }

    /// Shape functions of edge `k` at parameter `at`.
    pub(super) fn shape(&self, k: usize, at: f64) -> EdgeValues {
        edge_shape(self.order, reference(&self.span(k), at))
    }
}

/// The reference coordinate ξ at which an edge with the parameters `span` has the parameter `at`.
fn reference(span: &[f64], at: f64) -> f64 {
    let (start, end) = (span[0], span[span.len() - 1]);
    let middle = match span {
        [_, middle, _] => *middle,
        _ => f64::midpoint(start, end),
    };
    // p = p_m + b ξ + a ξ², by the form that keeps its digits for a → 0; b > 2 |a| since the middle was checked.
    let (a, b) = (f64::midpoint(start, end) - middle, (end - start) / 2.0);
    let root = (b * b + 4.0 * a * (at - middle)).max(0.0).sqrt();
    let mut xi = 2.0 * (at - middle) / (b + root);
    if span.len() > 3 {
        // Newton's method on a polynomial that ascends; at evenly moving parameters the start is the answer.
        let order = span.len() - 1;
        let from_start: Vec<f64> = span.iter().map(|node| node - start).collect();
        for _ in 0..NEWTON_STEPS {
            let miss = (at - start) - sum(edge_shape(order, xi), &from_start);
            let step = miss / sum(edge_slope(order, xi), &from_start);
            xi = (xi + step).clamp(-1.0, 1.0);
            if step.abs() < 1e-15 {
                break;
            }
        }
    }
    xi
}

/// Most steps of Newton's method, which doubles its digits in each.
const NEWTON_STEPS: usize = 20;

/// Σ values × parameters.
fn sum(values: EdgeValues, span: &[f64]) -> f64 {
    values.iter().zip(span).map(|(value, at)| value * at).sum()
}

/// The period of two edges on one closed curve.
pub(super) fn common_period(
    first: &EdgeSide,
    second: &EdgeSide,
) -> Result<Option<f64>, MortarError> {
    let period = first.period.or(second.period);
    if let Some(period) = period {
        for side in [first, second] {
            let span = side.parameter[side.parameter.len() - 1] - side.parameter[0];
            let other = side.period.unwrap_or(period);
            if span > period * (1.0 + 1e-12) || (other - period).abs() > 1e-12 * period {
                return Err(MortarError::Period { span, period });
            }
        }
    }
    Ok(period)
}
