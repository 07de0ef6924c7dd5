//! From the coordinates of a model to those of its scene.

use super::{BodyFailure, EdgeGeometry, EdgeKind, FailurePoint, FirstPly, Results};

impl Results {
    /// Moves all places by `by` `[mm]`; what friction laws are given stands in its scene already, and meshes of bodies are left where they are.
    pub fn place(&mut self, by: [f64; 2]) {
        if by == [0.0; 2] {
            return;
        }
        for reach in self.sets.iter_mut().filter_map(|set| set.reach.as_mut()) {
            *reach = reach.map(|x| x + by[0]);
        }
        for step in &mut self.steps {
            for stresses in &mut step.stresses {
                let peaks = [
                    &mut stresses.von_mises,
                    &mut stresses.largest_principal,
                    &mut stresses.least_principal,
                ];
                for peak in peaks {
                    shift(&mut peak.at, by);
                }
            }
            for (edge, geometry) in step.edges.iter_mut().zip(&self.edges) {
                edge.place(geometry, by);
            }
        }
        for failure in &mut self.failure {
            failure.place(by, &self.edges);
        }
        for edge in &mut self.edges {
            match &mut edge.kind {
                EdgeKind::Circle { centre, .. } => shift(centre, by),
                EdgeKind::Line => {
                    let other = edge
                        .second
                        .iter_mut()
                        .flat_map(|second| &mut second.parameter);
                    let own = edge.parameter.iter_mut();
                    own.chain(other).for_each(|x| *x += by[0]);
                }
                EdgeKind::Path => {}
            }
        }
    }
}

impl BodyFailure {
    fn place(&mut self, by: [f64; 2], edges: &[EdgeGeometry]) {
        let points = self.steps.iter_mut().flatten();
        points.for_each(|point| point.place(by));
        let sooner = self.beside_supports.iter_mut();
        let sooner = sooner.flat_map(|beside| &mut beside.sooner);
        let firsts = self.first_ply.iter_mut().chain(sooner).flatten();
        firsts.for_each(|first| first.place(by));
        if let Some(centre) = &mut self.centre {
            shift(centre, by);
        }
        for edge in &mut self.edges {
            if edges[edge.edge].kind == EdgeKind::Line {
                edge.parameter.iter_mut().for_each(|x| *x += by[0]);
            }
        }
        if let Some(characteristic) = &mut self.characteristic {
            characteristic
                .places
                .iter_mut()
                .for_each(|at| shift(at, by));
            for joint in characteristic.curve.iter_mut().flatten() {
                joint.first.place(by);
            }
            let ends = [
                &mut characteristic.net_section,
                &mut characteristic.bearing_point,
            ];
            for first in ends.into_iter().flatten().flatten() {
                first.place(by);
            }
        }
        if let Some(progressive) = &mut self.progressive {
            for loss in &mut progressive.losses {
                shift(&mut loss.position, by);
            }
        }
    }
}

impl FirstPly {
    fn place(&mut self, by: [f64; 2]) {
        self.at.place(by);
    }
}

impl FailurePoint {
    fn place(&mut self, by: [f64; 2]) {
        shift(&mut self.position, by);
    }
}

fn shift(at: &mut [f64; 2], by: [f64; 2]) {
    *at = [at[0] + by[0], at[1] + by[1]];
}
