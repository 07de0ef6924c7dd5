//! The same laws on a punch of so few points that all statuses can be tried: is the answer taken the nearest one?

use std::sync::Arc;

use stickslip_contact::solver::InterfaceSolver;
use stickslip_contact::{Chain, ContactState, Enumeration};
use stickslip_friction::FrictionLaw;
use stickslip_laboratory::discrete::{self, Discrete, commit};
use toml::Table;

use crate::publish::TaskError;
use crate::stability::judge::judge;
use crate::stability::methods::{Method, methods};
use crate::stability::outcome::Outcome;
use crate::study::record::fields;

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
    pub(super) fn add(&mut self, law: &Arc<dyn FrictionLaw>) -> Result<(), TaskError> {
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

    /// A row for each method that solves any of the steps with several solutions.
    pub(super) fn records(&self) -> Vec<Table> {
        let record = |&(method, taken, solved): &(&str, usize, usize)| {
            Table::from_iter(fields([
                ("method", method.into()),
                ("nearest_taken", (taken as i64).into()),
                ("solved", (solved as i64).into()),
                ("steps_with_several", (self.several as i64).into()),
                ("steps", (self.steps as i64).into()),
            ]))
        };
        let solving = self.taken.iter().filter(|(_, _, solved)| *solved > 0);
        solving.map(record).collect()
    }
}
