//! Models that are fitted: another mesh or other constants, never other loads.

use super::{FRINGES, SCENE, fails, folder_with, succeeds};

#[test]
fn a_model_under_other_loads_is_refused_at_its_line() {
    let folder = folder_with(&[("scene.toml", SCENE)]);
    let path = folder.path();
    let with = |model: &str| {
        let own = format!("scene = \"scene.toml\"\nmodel_overrides = ['{model}']");
        let text = FRINGES.replace("scene = \"scene.toml\"", &own);
        std::fs::write(path.join("e.toml"), text).unwrap();
    };
    for (model, part) in [
        (
            "loads.0.force.steps=[\"0.1 kN\", \"2 kN\", \"0.5 kN\"]",
            "in step 2",
        ),
        (
            "loads.0.force.steps=[\"0.1 kN\", \"1 kN\"]",
            "has 2 steps, and that of the scene 3",
        ),
        ("loads.0.force.direction=[0, 1]", "is another one"),
    ] {
        with(model);
        let error = fails(path, &["check", "e.toml"]);
        for part in [
            part,
            "is not loaded as the scene",
            "e.toml:5",
            "model_overrides",
            "leave its loads alone",
        ] {
            assert!(error.contains(part), "{part}: {error}");
        }
    }
    // The same loads in another unit are the same, and a mesh is the model's own.
    for model in [
        "loads.0.force.steps=[\"100 N\", \"1000 N\", \"500 N\"]",
        "mesh.spacing=9 deg",
    ] {
        with(model);
        succeeds(path, &["check", "e.toml"]);
    }
}
