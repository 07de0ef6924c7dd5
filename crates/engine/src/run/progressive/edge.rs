//! Strains at the hole's edge: of the followed joint at its largest load, and of the linear one under the same load.
//!
//! Where the two differ, plies have failed or flow. Strains are those of the quadrature points next to the edge, in polar components
//! about the hole's centre.
//!
//! Source: Post & Reddy (1988), part II, 4.4, who distinguish modes of failure by where the two differ.

use stickslip_contact::InterfaceSolver;
use stickslip_fem_core::QuadraturePoints;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::points::strains;
use stickslip_joint::{Gauge, Hole, Joint, JointError};

use crate::results::{EdgeStrain, LinearJoint};

/// Distance from the edge to which quadrature points count, as a multiple of that of the cell's nearest.
const ROW: f64 = 1.5;

/// The quadrature points next to a hole's edge, by angle.
pub(super) struct EdgePoints<'a> {
    mesh: &'a Mesh,
    /// Index and angle `[rad]`.
    points: Vec<(usize, f64)>,
}

impl<'a> EdgePoints<'a> {
    pub(super) fn new(mesh: &'a Mesh, hole: &Hole) -> Self {
        let quadrature = QuadraturePoints::of(mesh);
        let height = |place: &Point| {
            (place[0] - hole.centre[0]).hypot(place[1] - hole.centre[1]) - hole.radius
        };
        let on_edge = |node: &&usize| height(&mesh.nodes()[**node]).abs() < 1e-6 * hole.radius;
        let mut points = Vec::new();
        for cell in 0..mesh.element_count() {
            let (_, nodes, _) = mesh.element(cell);
            if nodes.iter().filter(on_edge).count() < 2 {
                continue;
            }
            let own = quadrature.of_cell(cell);
            let places = &quadrature.positions()[own.clone()];
            let nearest = places.iter().map(height).fold(f64::INFINITY, f64::min);
            let row = own.zip(places).filter(|(_, p)| height(p) <= ROW * nearest);
            points.extend(row.map(|(index, place)| {
                let [x, y] = [0, 1].map(|i| place[i] - hole.centre[i]);
                (index, y.atan2(x))
            }));
        }
        points.sort_by(|a, b| a.1.total_cmp(&b.1));
        Self { mesh, points }
    }

    /// Radial and circumferential strains under the nodal displacements `u` `[mm]`.
    fn polar(&self, u: &[f64]) -> Vec<[f64; 2]> {
        let strains = strains(self.mesh, u);
        let turned = self.points.iter().map(|&(index, angle)| {
            let [x, y, shear] = strains[index];
            let (s, c) = angle.sin_cos();
            [
                x * c * c + y * s * s + shear * c * s,
                x * s * s + y * c * c - shear * c * s,
            ]
        });
        turned.collect()
    }

    /// The strains under `followed`, beside those of `linear`.
    pub(super) fn beside(&self, followed: &[f64], linear: &[f64]) -> Vec<EdgeStrain> {
        let both = self.polar(followed).into_iter().zip(self.polar(linear));
        let angles = self.points.iter().map(|&(_, angle)| angle);
        let listed = angles
            .zip(both)
            .map(|(angle, (followed, linear))| EdgeStrain {
                angle,
                followed,
                linear,
            });
        listed.collect()
    }
}

/// The joint without failure, read by `gauge`, followed by the same steps to the load `target` `[N]`: its curve as far, and the
/// displacements of body `body` there. `None` if it does not get so far.
pub(super) fn linear(
    joint: &Joint,
    gauge: &Gauge,
    body: usize,
    steps: &[Vec<f64>],
    solver: &dyn InterfaceSolver,
    target: f64,
) -> Result<Option<(LinearJoint, Vec<f64>)>, JointError> {
    let mut curve = vec![[-gauge.free_travel, 0.0]];
    let mut last: Vec<f64> = Vec::new();
    let mut found = None;
    joint.follow(steps, solver, |record, state| {
        if found.is_some() {
            return;
        }
        let now = &state.bodies[body].displacements;
        let before = curve[curve.len() - 1];
        let after = [record.displacement, record.load];
        if record.load >= target * (1.0 - 1e-9) {
            let part = ((target - before[1]) / (after[1] - before[1])).min(1.0);
            let between = |from: f64, to: f64| from + part * (to - from);
            last.resize(now.len(), 0.0);
            found = Some(last.iter().zip(now).map(|(a, b)| between(*a, *b)).collect());
            curve.push([0, 1].map(|i| between(before[i], after[i])));
        } else {
            curve.push(after);
            last.clone_from(now);
        }
    })?;
    Ok(found.map(|displacements| (LinearJoint { curve }, displacements)))
}
