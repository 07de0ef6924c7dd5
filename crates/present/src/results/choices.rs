//! What the program chose, with what it found about a choice.

use stickslip_results::{BlockError, Choice, Results};
use stickslip_text::short;

/// The choices of a run; the error of compliances in blocks follows the solver whose answers have it.
pub(super) fn choices(results: &Results) -> Vec<Choice> {
    let mut all = results.choices.clone();
    if let Some(error) = &results.blocks {
        let solver = all.iter().position(|own| own.what == Choice::SOLVER);
        all.insert(solver.map_or(all.len(), |at| at + 1), of_blocks(error));
    }
    all
}

fn of_blocks(error: &BlockError) -> Choice {
    Choice {
        what: "compliance in blocks".into(),
        value: format!(
            "at most {} shapes an edge, tractions to {} of the peak pressure",
            error.rank,
            short(error.tractions)
        ),
        reason: format!(
            "displacements of contact points to {} mm of those by the whole factor",
            short(error.displacement)
        ),
    }
}
