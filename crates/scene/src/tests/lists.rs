//! No list stands for a table, in which it would fill the keys in their order.

use super::*;

#[test]
fn a_list_is_no_table() {
    for (from, to, list) in [
        (
            "shape.disk = { radius = \"4.99 mm\" }",
            "shape.disk = [\"4.99 mm\"]",
            "[\"4.99 mm\"]",
        ),
        ("[mesh]\nspacing = \"2 deg\"", "mesh = [\"Q8\"]", "[\"Q8\"]"),
        (
            "[materials.steel.isotropic]\nyoung = \"210 GPa\"\npoisson = 0.3",
            "[materials.steel]\nisotropic = [\"210 GPa\", 0.3]",
            "[\"210 GPa\", 0.3]",
        ),
        (
            "[[supports]]\non = \"pin.centre\"\nfix = [\"x\", \"y\"]",
            "[[supports]]\non = \"pin.centre\"\nfix = [[\"x\"], \"y\"]",
            "[\"x\"]",
        ),
    ] {
        let finding = refused(from, to);
        assert_eq!(shown(&finding), list, "{finding}");
        let wanted = if from.contains("fix") {
            "one of x, y"
        } else {
            "a table"
        };
        assert!(
            matches!(&finding.problem, SceneProblem::WrongKind { expected, found } if expected.starts_with(wanted) && found == "a list"),
            "{to}: {finding}"
        );
    }
}
