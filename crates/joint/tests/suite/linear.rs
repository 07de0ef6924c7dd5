//! Points that never leave linearity: the answer of the ordinary path.

use std::sync::Arc;

use stickslip_contact::{Chain, InterfaceProblem, LoadHistory, Ramp};
use stickslip_fem_core::InterfaceOperator;
use stickslip_joint::{Ending, Joint};

use crate::models::unbreakable;
use crate::plate::{End, Plate};

/// With loads and with a driven end, over loading and unloading with friction: contact forces and displacements as the
/// ordinary path has them, from one factorisation and one linearisation per increment.
#[test]
fn a_linear_model_gives_the_linear_answer() {
    for (end, size) in [(End::Loaded, 2000.0), (End::Driven, 0.1)] {
        let plate = Plate::default();
        let model = unbreakable("[0/45/-45/90]s");
        let mut options = *plate.joint(&model, end).options();
        options.increments = 1;
        let joint: Joint = plate.joint(&model, end).with_options(options).unwrap();
        let steps: Vec<Vec<f64>> = [0.3, 0.7, 1.0, 0.6, 0.2]
            .iter()
            .map(|part| vec![part * size])
            .collect();
        let mut fields = Vec::new();
        let history = joint
            .follow(&steps, &Chain::newton_first(), |_, state| {
                fields.push(state.bodies[0].displacements.clone());
            })
            .unwrap();
        assert!(matches!(history.ending, Ending::Completed));
        assert_eq!(history.factorisations, 1);
        assert!(history.strength().is_none());

        let mesh = plate.mesh();
        let laminate = model.laminate();
        let material = Arc::new(laminate.membrane_material().unwrap());
        let body = plate.body(&mesh, material, laminate.thickness(), end);
        let condensed = body.condense(&Plate::hole(&mesh)).unwrap();
        let (pair, pin) = plate.pair(&mesh, laminate.thickness());
        let faces: [&dyn InterfaceOperator; 2] = [&condensed, &pin];
        let problem = InterfaceProblem::new(&faces, vec![pair]).unwrap();
        let records = LoadHistory::new(steps, 1, Ramp::Linear)
            .unwrap()
            .follow(&problem, &Chain::newton_first(), |_| {})
            .unwrap();
        let (mut worst_force, mut worst_field) = (0.0_f64, 0.0_f64);
        for ((ours, theirs), field) in history.records.iter().zip(&records).zip(&fields) {
            assert_eq!(ours.residuals.len(), 1);
            let (a, b) = (&ours.contact.state, &theirs.state);
            worst_force = worst_force.max((&a.forces - &b.forces).amax() / b.forces.amax());
            let count = Plate::hole(&mesh).len();
            let forces = problem.forces_on_body(0, count, &b.forces);
            let motions = b.rigid.rows_range(problem.body_modes(0));
            let u =
                condensed.displacements(&forces, &b.multipliers, motions.clone_owned().as_slice());
            let scale = u.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let off = u.iter().zip(field).map(|(p, q)| (p - q).abs());
            worst_field = worst_field.max(off.fold(0.0, f64::max) / scale);
            assert!(
                (ours.contact.dissipation() - theirs.dissipation()).abs()
                    <= 1e-10 * theirs.dissipation().abs()
            );
        }
        println!("{end:?}: forces {worst_force:.1e}, displacements {worst_field:.1e}");
        assert!(
            worst_force < 1e-12 && worst_field < 1e-12,
            "{worst_force:e} {worst_field:e}"
        );
    }
}
