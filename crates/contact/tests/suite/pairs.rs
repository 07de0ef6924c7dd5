//! Pairs named by their index.

use stickslip_contact::ContactError;

use crate::coulomb;
use crate::scaling::disk;

/// A law is given to the pair that it names, and to no other problem's.
#[test]
fn a_law_for_a_pair_that_does_not_exist_is_refused() {
    let problem = disk(1.0, 1.0);
    let changed = problem.clone().with_law(0, coulomb(0.7)).unwrap();
    let named = |problem: &stickslip_contact::InterfaceProblem| format!("{:?}", problem.law(0));
    assert_ne!(named(&problem), named(&changed));
    let refused = problem.with_law(1, coulomb(0.7)).unwrap_err();
    assert!(matches!(
        refused,
        ContactError::UnknownPair { pair: 1, pairs: 1 }
    ));
    assert_eq!(
        refused.to_string(),
        "pair 1 does not exist: the problem has 1"
    );
}
