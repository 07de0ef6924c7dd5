//! From the file's numbers to positions.

/// No position.
const NONE: usize = usize::MAX;

/// Positions of ascending numbers.
#[derive(Debug)]
pub(crate) struct Numbers {
    sorted: Vec<u64>,
    /// Position of number `sorted[0] + k`, if the numbers are dense enough for a table.
    table: Vec<usize>,
}

impl Numbers {
    /// Takes strictly ascending numbers.
    pub(crate) fn new(sorted: Vec<u64>) -> Self {
        let mut table = Vec::new();
        if let (Some(first), Some(last)) = (sorted.first(), sorted.last()) {
            let span = last - first;
            if span < 4 * sorted.len() as u64 + 64 {
                table.resize(span as usize + 1, NONE);
                for (k, number) in sorted.iter().enumerate() {
                    // Ascending numbers lie between the first and the last.
                    table[(number - first) as usize] = k;
                }
            }
        }
        Self { sorted, table }
    }

    /// Position of `number`.
    pub(crate) fn get(&self, number: u64) -> Option<usize> {
        if self.table.is_empty() {
            return self.sorted.binary_search(&number).ok();
        }
        let step = number.checked_sub(*self.sorted.first()?)?;
        let step = usize::try_from(step).ok()?;
        self.table.get(step).copied().filter(|&k| k != NONE)
    }

    /// Positions of the numbers that exist among `first`, `first + step`, … up to `last`; `step` is at least 1.
    pub(crate) fn range(&self, first: u64, last: u64, step: u64) -> impl Iterator<Item = usize> {
        let start = self.sorted.partition_point(|&number| number < first);
        let rest = self.sorted.iter().enumerate().skip(start);
        rest.take_while(move |&(_, &number)| number <= last)
            .filter(move |&(_, &number)| (number - first).is_multiple_of(step))
            .map(|(k, _)| k)
    }
}
