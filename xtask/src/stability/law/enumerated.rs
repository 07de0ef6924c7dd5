//! The same laws on a punch of so few points that all statuses can be tried: is the answer taken the nearest one?

use std::sync::Arc;

use stickslip_contact::solver::InterfaceSolver;
use stickslip_contact::{Chain, ContactState, Enumeration};
use stickslip_friction::FrictionLaw;
use stickslip_laboratory::discrete::{self, Discrete, commit};

use crate::stability::Trouble;
use crate::stability::methods::{CHAIN, Method, methods};
use crate::stability::outcome::{Outcome, judge};

/// Nodes of the punch.
const NODES: usize = 5;
/// Pushes after pressing, in units of the punch's own.
const PUSHES: [f64; 6] = [0.0, 0.5, 1.0, 0.0, -1.0, 0.0];

/// How many steps had several solutions, and how often each method took the nearest to the committed state.
#[derive(Default)]
pub(super) struct Shares {
    steps: usize,
    several: usize,
    /// Name, nearest solutions taken, and steps solved of those with several.
    taken: Vec<(&'static str, usize, usize)>,
}

impl Shares {
    /// Adds the steps of the punch under `law`.
    pub(super) fn add(&mut self, law: &Arc<dyn FrictionLaw>) -> Result<(), Trouble> {
        let punch = discrete::flat_punch_under(NODES, Arc::clone(law))?;
        let push = punch.multipliers[1];
        let methods = methods();
        let mut given = Discrete {
            committed: ContactState::unloaded(&punch.problem),
            ..punch
        };
        for share in PUSHES {
            given.multipliers = vec![1.0, share * push];
            if let Ok(nearest) = Enumeration::default().solve(&given.step()) {
                self.steps += 1;
                if nearest.solutions > Some(1) {
                    self.several += 1;
                    self.count(&given, &nearest.trial, &methods);
                }
            }
            let taken = Chain::default().solve(&given.step())?;
            given.committed = commit(&given.committed, &taken.trial, &given.multipliers);
        }
        Ok(())
    }

    fn count(
        &mut self,
        given: &Discrete,
        nearest: &stickslip_contact::state::TrialState,
        methods: &[Method],
    ) {
        for method in methods {
            let outcome = judge(method, given, Some(nearest)).outcome;
            let found = usize::from(outcome.is_answer());
            let same = usize::from(outcome == Outcome::Solved);
            match self
                .taken
                .iter_mut()
                .find(|(name, _, _)| *name == method.name)
            {
                Some((_, taken, solved)) => (*taken, *solved) = (*taken + same, *solved + found),
                None => self.taken.push((method.name, same, found)),
            }
        }
    }

    /// In words.
    pub(super) fn text(&self) -> String {
        let start = format!(
            "On a flat punch of {NODES} nodes under the same laws enumeration finds several solutions in {} of {} steps",
            self.several, self.steps
        );
        let own = self.taken.iter().find(|(name, _, _)| *name == CHAIN);
        let Some((_, taken, solved)) = own else {
            return format!("{start}.");
        };
        let others: Vec<String> = (self.taken.iter())
            .filter(|(name, _, solved)| *name != CHAIN && *solved > 0)
            .map(|(name, taken, solved)| format!("{name} {taken} of {solved}"))
            .collect();
        format!(
            "{start}; the default chain takes the nearest to the committed state in {taken} of {solved}, the others in these shares of \
             what they solve: {}.",
            others.join(", ")
        )
    }
}
