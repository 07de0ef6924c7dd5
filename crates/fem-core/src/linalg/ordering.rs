//! Fill-reducing order of a graph's vertices, some of them kept for the end.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::FactorError;

/// Orders the vertices of an undirected graph for elimination by approximate minimum degree (Amestoy, Davis & Duff 1996),
/// the vertices of `last` at the end in the order given.
///
/// `adjacency[v]` lists the neighbours of `v`, without `v`. Returns the vertices in their new order.
///
/// # Errors
/// [`FactorError::TooLarge`] if the work space does not fit in memory.
pub fn minimum_degree(adjacency: &[Vec<u32>], last: &[usize]) -> Result<Vec<usize>, FactorError> {
    let total = adjacency.len();
    let mut compact = vec![u32::MAX; total];
    for &v in last {
        compact[v] = u32::MAX - 1;
    }
    let interior: Vec<usize> = (0..total).filter(|&v| compact[v] == u32::MAX).collect();
    for (k, &v) in interior.iter().enumerate() {
        compact[v] = k as u32;
    }
    let n = interior.len();
    let too_large = || FactorError::TooLarge { unknowns: total };
    let mut column_start = Vec::with_capacity(n + 1);
    let mut rows: Vec<u32> = Vec::new();
    column_start.push(0_u32);
    for &v in &interior {
        rows.extend(
            adjacency[v]
                .iter()
                .map(|&w| compact[w as usize])
                .filter(|&w| (w as usize) < n),
        );
        column_start.push(u32::try_from(rows.len()).map_err(|_| too_large())?);
    }
    let graph = SymbolicSparseColMatRef::new_unsorted_checked(n, n, &column_start, None, &rows);
    let mut memory = MemBuffer::try_new(amd::order_maybe_unsorted_scratch::<u32>(n, rows.len()))
        .map_err(|_| too_large())?;
    let (mut order, mut inverse) = (vec![0_u32; n], vec![0_u32; n]);
    amd::order_maybe_unsorted(
        &mut order,
        &mut inverse,
        graph,
        amd::Control::default(),
        MemStack::new(&mut memory),
    )
    .map_err(|_| too_large())?;
    Ok(order
        .iter()
        .map(|&k| interior[k as usize])
        .chain(last.iter().copied())
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_the_last_vertices_last() {
        let n = 30_usize;
        let ring: Vec<Vec<u32>> = (0..n)
            .map(|v| vec![((v + 1) % n) as u32, ((v + n - 1) % n) as u32])
            .collect();
        let order = minimum_degree(&ring, &[7, 3, 20]).unwrap();
        assert_eq!(order[n - 3..], [7, 3, 20]);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..n).collect::<Vec<_>>());
    }
}
