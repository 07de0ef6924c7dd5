//! Independent pieces of work, side by side with the feature `parallel`, one after the other without it.
//!
//! The only module of the libraries that knows threads, beside the yardstick of the benches. Each function returns results in the order
//! of its input and sums nothing, so the answer has the same bits with any number of threads and without the feature. Threads are those
//! of the rayon pool in which the caller runs.

use std::ops::Range;

#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Computes `f(item)` for each of `items`, in their order. Each item may go to another thread, so that few large ones keep all busy.
///
/// ```
/// let squares = stickslip_fem_core::parallel::map(&[1, 2, 3], |x| x * x);
/// assert_eq!(squares, [1, 4, 9]);
/// ```
pub fn map<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 {
        return items.par_iter().with_max_len(1).map(f).collect();
    }
    items.iter().map(f).collect()
}

/// Computes `f(k)` for each k of `range`, in their order. A single k is computed on the calling thread.
pub fn map_range<R: Send>(range: Range<usize>, f: impl Fn(usize) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if range.len() > 1 {
        return range.into_par_iter().map(f).collect();
    }
    range.map(f).collect()
}

/// Computes `f(chunk)` for each run of `size` > 0 items, in their order; the last run may be shorter.
pub fn map_chunks<T: Sync, R: Send>(
    items: &[T],
    size: usize,
    f: impl Fn(&[T]) -> R + Sync + Send,
) -> Vec<R> {
    map_range(0..items.len().div_ceil(size), |k| {
        f(&items[k * size..items.len().min((k + 1) * size)])
    })
}

/// Calls `f(k, chunk)` for the k-th run of `size` > 0 items of `items`; the last run may be shorter.
pub fn for_each_chunk<T: Send>(
    items: &mut [T],
    size: usize,
    f: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    #[cfg(feature = "parallel")]
    items
        .par_chunks_mut(size)
        .enumerate()
        .for_each(|(k, chunk)| f(k, chunk));
    #[cfg(not(feature = "parallel"))]
    items
        .chunks_mut(size)
        .enumerate()
        .for_each(|(k, chunk)| f(k, chunk));
}

/// Computes `first()` and `second()`.
pub fn join<A: Send, B: Send>(
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "parallel")]
    return rayon::join(first, second);
    #[cfg(not(feature = "parallel"))]
    (first(), second())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_have_the_order_of_the_input() {
        let items: Vec<usize> = (0..1003).collect();
        assert_eq!(map(&items, |k| k + 1), (1..1004).collect::<Vec<_>>());
        assert_eq!(map_range(5..8, |k| 2 * k), [10, 12, 14]);
        assert_eq!(map_range(5..6, |k| k), [5]);
        assert!(map_range(3..3, |k| k).is_empty());
        assert_eq!(map_chunks(&items[..7], 3, <[usize]>::len), [3, 3, 1]);
        assert_eq!(map_chunks(&items, 10, |chunk| chunk[0]).len(), 101);
        let mut numbers = vec![0; 8];
        for_each_chunk(&mut numbers, 3, |k, chunk| chunk.fill(k));
        assert_eq!(numbers, [0, 0, 0, 1, 1, 1, 2, 2]);
        assert_eq!(join(|| 1, || "two"), (1, "two"));
    }
}
