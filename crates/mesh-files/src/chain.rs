//! Directed edges joined to one chain.

use std::collections::BTreeMap;

/// Edges in walk order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Chain {
    /// Positions of the edges.
    pub(crate) order: Vec<usize>,
    /// Whether the last one ends where the first one starts.
    pub(crate) closed: bool,
}

/// Joins edges, each from its first to its second node, to one chain without branches; none if they do not form one.
pub(crate) fn join(ends: &[[usize; 2]]) -> Option<Chain> {
    let mut leaving = BTreeMap::new();
    let mut arriving = BTreeMap::new();
    for (k, &[start, end]) in ends.iter().enumerate() {
        if leaving.insert(start, k).is_some() || arriving.insert(end, k).is_some() {
            return None;
        }
    }
    let loose = leaving.keys().find(|start| !arriving.contains_key(start));
    let first = *loose.or(ends.first().map(|[start, _]| start))?;
    let mut order = Vec::with_capacity(ends.len());
    let mut at = first;
    // Each node is left by one edge and reached by one, so the walk ends at a loose end or at its beginning.
    while let Some(&k) = leaving.get(&at) {
        order.push(k);
        at = ends[k][1];
        if at == first {
            break;
        }
    }
    (order.len() == ends.len()).then_some(Chain {
        order,
        closed: at == first,
    })
}
