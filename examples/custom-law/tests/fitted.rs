//! The law's parameters can be fitted like those of any other.

use std::path::Path;
use std::sync::Arc;

use custom_law as _;
use stickslip::experiment::SpecimenScene;
use stickslip::experiment::laws::{Candidate, ContactModel};
use stickslip::host::HOST;
use stickslip::scene::Scene;

#[test]
fn its_parameters_are_free_by_name_and_change_what_is_seen() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("coated-pin.toml");
    let scene = Scene::from_file(&path, &["mesh.spacing=\"6 deg\""], HOST).unwrap();
    let contact = &scene.contacts[0].first;
    let own = SpecimenScene {
        body: contact.body.clone(),
        edge: contact.set.clone(),
        scene: Arc::new(scene.clone()),
    };
    let model = ContactModel::new(&own).unwrap();
    let free = [("worn", [0.0, 1.0]), ("slip_scale", [1e-3, 1.0])];
    let law = Candidate::of_law("wear", model.own_law().as_ref(), &free).unwrap();
    assert!(law.parameters[1].logarithmic && !law.parameters[0].logarithmic);
    let places: Vec<_> = model.edge().iter().map(|(_, place)| *place).collect();
    let view = model.view(&places).unwrap();
    let last = |values: &[f64]| {
        let states = model
            .states(Arc::from(law.law(values).unwrap()), model.steps())
            .unwrap();
        view.displacements(&states[states.len() - 1])
    };
    let change = last(&[0.5, 0.01]) - last(&[0.1, 0.01]);
    assert!(change.amax() > 1e-6, "{}", change.amax());
    // What the law refuses is no place of a fit.
    assert!(law.law(&[-0.1, 0.01]).is_err());
}
