//! No list stands for a table, in which it would fill the keys in their order.

use super::*;

#[test]
fn a_list_is_no_table() {
    let expected = "expected a table, such as { key = value }, found a list";
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
        let (message, _, _, shown) = refused(from, to);
        let wanted = if from.contains("fix") {
            "expected one of x, y, found a list"
        } else {
            expected
        };
        assert_eq!((message.as_str(), shown.as_str()), (wanted, list), "{to}");
    }
}
