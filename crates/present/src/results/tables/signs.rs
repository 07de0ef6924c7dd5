//! What the signs of quantities mean.

use stickslip_report::table::Table;

/// Quantities, their signs here, and where other programs or texts differ.
pub fn signs() -> impl Iterator<Item = [&'static str; 3]> {
    let lines = include_str!("signs.txt").lines();
    lines.map(|line| {
        let mut cells = line.splitn(3, " | ");
        std::array::from_fn(|_| cells.next().unwrap_or_default())
    })
}

/// What each quantity's sign means, and what other programs do.
pub(crate) fn signs_table() -> Table {
    Table::headed("Signs", "quantity | meaning and sign | elsewhere").with_rows(signs())
}

#[cfg(test)]
mod tests {
    use super::signs;

    #[test]
    fn every_sign_has_three_cells() {
        assert_eq!(signs().count(), 14);
        assert!(
            signs()
                .flatten()
                .all(|cell| !cell.is_empty() && !cell.contains(" | "))
        );
    }
}
