//! An edge as a projection sees it: nodes by ascending parameter.

use stickslip_fem_core::element::edge_shape;

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
    /// A chain with two ends: `nodes` among the body's contact points in walk order, mid-side nodes included, their
    /// `parameter`, and the polynomial `order` of the edges.
    ///
    /// # Errors
    /// [`MortarError`] for an order that does not exist, lists that do not fit, a parameter that does not ascend strictly,
    /// or a mid-side node outside the middle half of its edge.
    pub fn open(nodes: Vec<usize>, parameter: Vec<f64>, order: usize) -> Result<Self, MortarError> {
        Self::new(nodes, parameter, order, None)
    }

    /// A chain whose last edge ends at the first node, one `period` of the parameter after it.
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
        if ![1, 2].contains(&order) {
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
        side.check_middles()?;
        Ok(side)
    }

    fn check_middles(&self) -> Result<(), MortarError> {
        for k in 0..self.edges() {
            let [start, middle, end] = self.span(k);
            let fraction = (middle - start) / (end - start);
            if self.order == 2 && !(0.25..=0.75).contains(&fraction) {
                let node = 2 * k + 1;
                return Err(MortarError::MidSide { node, fraction });
            }
        }
        Ok(())
    }

    /// Nodes among the body's contact points, in walk order.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Parameter of each node, ascending.
    pub fn parameter(&self) -> &[f64] {
        &self.parameter
    }

    /// Period of the parameter of a closed chain.
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

    /// Places in the walk of the start, middle (the start again on a linear edge) and end of edge `k`.
    pub(super) fn places(&self, k: usize) -> [usize; 3] {
        let start = self.order * k;
        [0, self.order - 1, self.order].map(|step| (start + step) % self.nodes.len())
    }

    /// Parameter at the start, middle and end of edge `k`, ascending also where a closed chain returns to its start.
    pub(super) fn span(&self, k: usize) -> [f64; 3] {
        let [start, middle, end] = self.places(k).map(|place| self.parameter[place]);
        let end = if end > start {
            end
        } else {
            end + self.period.unwrap_or(0.0)
        };
        if self.order == 2 {
            [start, middle, end]
        } else {
            [start, f64::midpoint(start, end), end]
        }
    }

    /// Shape functions of edge `k` at parameter `at`.
    pub(super) fn shape(&self, k: usize, at: f64) -> [f64; 3] {
        let [start, middle, end] = self.span(k);
        // p = p_m + b ξ + a ξ², by the form that keeps its digits for a → 0; b > 2 |a| since the middle was checked.
        let (a, b) = (f64::midpoint(start, end) - middle, (end - start) / 2.0);
        let root = (b * b + 4.0 * a * (at - middle)).max(0.0).sqrt();
        edge_shape(self.order, 2.0 * (at - middle) / (b + root))
    }
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
