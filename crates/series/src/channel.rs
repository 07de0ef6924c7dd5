//! Modes of tractions and displacements on a circle, as real numbers.
//!
//! ```text
//! u(θ) = Σ_c u_c e_c(θ),   e_c = e^{iKθ} or i e^{iKθ}     V_ic = ⟨e_c⟩_i
//! u_i = Σ_c V_ic u_c,      q_c = (s/2πRt) Σ_i V_ic · λ_i,  s = 1, or 2 for forces on the half of a half model
//! ```

use nalgebra::{Complex, DMatrix};

use crate::nodes::Nodes;

/// A mode of a vector x + iy on the circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Channel {
    /// K.
    pub(crate) order: i64,
    /// Its unit.
    pub(crate) unit: Unit,
}

/// The two real units of a complex coefficient. With the outline and the loads symmetric about x, coefficients of the symmetric part of a state are
/// real, those of the antisymmetric part imaginary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    /// 1.
    Real,
    /// i.
    Imaginary,
}

impl Unit {
    pub(crate) fn value(self) -> Complex<f64> {
        match self {
            Self::Real => Complex::new(1.0, 0.0),
            Self::Imaginary => Complex::new(0.0, 1.0),
        }
    }

    /// The units that states of `nodes` have.
    pub(crate) fn of(nodes: &Nodes) -> &'static [Self] {
        if nodes.is_mirrored() {
            &[Self::Real]
        } else {
            &[Self::Real, Self::Imaginary]
        }
    }
}

/// The modes of `orders` with all units that `nodes` have.
pub(crate) fn channels(nodes: &Nodes, orders: impl IntoIterator<Item = i64>) -> Vec<Channel> {
    let all = |order| {
        Unit::of(nodes)
            .iter()
            .map(move |&unit| Channel { order, unit })
    };
    orders.into_iter().flat_map(all).collect()
}

/// V, 2n × c.
pub(crate) fn hat_means(nodes: &Nodes, channels: &[Channel]) -> DMatrix<f64> {
    let mut means = DMatrix::zeros(2 * nodes.len(), channels.len());
    let mut last: Option<(i64, Vec<Complex<f64>>)> = None;
    for (column, channel) in channels.iter().enumerate() {
        let of_order = match last.take() {
            Some((order, values)) if order == channel.order => values,
            Some((order, values)) if order == -channel.order => {
                values.iter().map(Complex::conj).collect()
            }
            _ => nodes.mode_means(channel.order),
        };
        for (node, mean) in of_order.iter().enumerate() {
            let value = channel.unit.value() * mean;
            means[(2 * node, column)] = value.re;
            means[(2 * node + 1, column)] = if nodes.on_axis(node) { 0.0 } else { value.im };
        }
        last = Some((channel.order, of_order));
    }
    means
}

/// s of the module's equation.
pub(crate) fn sides(nodes: &Nodes) -> f64 {
    if nodes.is_mirrored() { 2.0 } else { 1.0 }
}
