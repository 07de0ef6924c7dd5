//! A sector around a hole under known tractions: its displacements on a fine mesh, and what a camera would measure of them.
//!
//! ```text
//! p(θ) = p₀ (1 − (θ/θ₀)²)²,   τ_rθ(θ) = μ p(θ) sin(5θ/2)   for |θ| < θ₀
//! ```

use std::f64::consts::TAU;
use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_hybrid::data::{Field, FringeLine, FringeLines, Measurement, Track};
use stickslip_hybrid::region::outputs::displacement_rows;
use stickslip_hybrid::region::sector::ArcSector;

use crate::study::TaskError;

/// Radius of the hole, 0.375 in `[mm]`.
pub(crate) const RADIUS: f64 = 9.525;
/// Half the angle of the analysed sector `[rad]`.
const HALF: f64 = 1.0;
/// The fine mesh and the data reach farther than the analysed sector, by these factors of angle and of outer radius.
const BEYOND: [f64; 2] = [1.25, 1.15];
/// Greatest pressure p₀ `[MPa]` and where it ends, θ₀ `[rad]`.
const PRESSURE: f64 = 200.0;
const CONTACT: f64 = 0.8;
const FRICTION: f64 = 0.25;
const THICKNESS: f64 = 1.524;
/// Lines of the grating `[1/mm]`, and errors of orders, uniform in ± this `[fringes]`.
pub(crate) const FREQUENCY: f64 = 2400.0;
pub(crate) const ERROR: f64 = 0.25;
/// Standard deviation of such an error `[mm]`.
pub(crate) const DEVIATION: f64 = ERROR / FREQUENCY / 1.732_050_807_568_877_2;
/// Places are moved by up to this part of their spacing, so that they do not follow the mesh.
const JITTER: f64 = 0.4;

/// Pressure and shear τ_rθ on the edge at an angle `[MPa]`.
pub(crate) fn tractions(theta: f64) -> [f64; 2] {
    let pressure = PRESSURE * (1.0 - (theta / CONTACT).powi(2)).max(0.0).powi(2);
    [pressure, FRICTION * pressure * (2.5 * theta).sin()]
}

/// An elastic body on the sector's mesh.
pub(crate) fn body(sector: &ArcSector) -> Result<Arc<ElasticBody>, TaskError> {
    let aluminium = Isotropic::new(70.3e3, 0.34, PlaneState::Stress)?;
    let materials: Vec<Arc<dyn Material>> = vec![Arc::new(aluminium)];
    let body = ElasticBody::new(Arc::new(sector.mesh()?), materials, THICKNESS)?;
    Ok(Arc::new(body))
}

/// The analysed sector with cells of about `size` `[mm]` along the edge.
pub(crate) fn analysed(size: f64) -> ArcSector {
    let around = (2.0 * HALF * RADIUS / size).round().max(3.0) as usize;
    ArcSector {
        centre: [0.0, 0.0],
        hole: RADIUS,
        stand_off: 0.0,
        outer: 2.0 * RADIUS,
        angles: [-HALF, HALF],
        cells: [around, (around / 2).max(3)],
        growth: 1.5,
        kind: ElementKind::Q8,
    }
}

/// Displacements x and y of the nodes of `body`, a sector's, in turn `[mm]`, under pressure and shear τ_rθ `[MPa]` on its inner edge that
/// are functions of the angle; its outer edge is held.
pub(crate) fn loaded(
    body: &Arc<ElasticBody>,
    tractions: impl Fn(f64) -> [f64; 2],
) -> Result<Vec<f64>, TaskError> {
    let mesh = body.mesh();
    let inner = &mesh.edge_set("inner")?.edges;
    let forces = edge_load(mesh, inner, THICKNESS, |point| {
        let theta = point.position[1].atan2(point.position[0]);
        let (s, c) = theta.sin_cos();
        let [p, tau] = tractions(theta);
        // n = −e_r, so that the traction is p e_r − τ_rθ e_θ.
        [p * c + tau * s, p * s - tau * c]
    });
    let outer = mesh.node_set("outer")?.to_vec();
    let held = |direction| Support {
        nodes: outer.clone(),
        direction,
        displacement: 0.0,
    };
    let load = LoadCase {
        forces,
        ..LoadCase::default()
    };
    let held = ElasticBody::clone(body)
        .with_supports([held(HeldDirection::X), held(HeldDirection::Y)])
        .with_load_cases(vec![load])?;
    let condensed = Arc::new(held).condense(&[])?;
    Ok(condensed.displacements(&[], &[1.0], &[]))
}

/// The specimen, solved on a mesh finer than any that analyses it.
pub(crate) struct Specimen {
    body: Arc<ElasticBody>,
    displacements: Vec<f64>,
}

impl Specimen {
    /// Solves it on `cells` around and outwards.
    pub(crate) fn new(cells: [usize; 2]) -> Result<Self, TaskError> {
        let half = BEYOND[0] * HALF;
        let body = body(&ArcSector {
            outer: BEYOND[1] * 2.0 * RADIUS,
            angles: [-half, half],
            cells,
            growth: 1.0,
            ..analysed(1.0)
        })?;
        let displacements = loaded(&body, tractions)?;
        Ok(Self {
            body,
            displacements,
        })
    }

    /// Displacements x and y of places in turn `[mm]`.
    pub(crate) fn displacements_at(&self, places: &[Point]) -> Result<Vec<f64>, TaskError> {
        let rows = displacement_rows(self.body.mesh(), places)?;
        let at = |row: &Vec<(usize, f64)>| -> f64 {
            (row.iter())
                .map(|&(dof, w)| w * self.displacements[dof])
                .sum()
        };
        Ok(rows.iter().map(at).collect())
    }

    /// Error-free orders of both fields along the four sides of the analysed sector with cells of `size`, at places about `spacing`
    /// `[mm]` apart from corner to corner.
    pub(crate) fn lines(&self, size: f64, spacing: f64) -> Result<[FringeLines; 2], TaskError> {
        let sector = analysed(size);
        let arc = |r: f64| {
            let track = Track::Circle {
                centre: sector.centre,
                closed: false,
            };
            (track, [[r, -HALF], [r, HALF]])
        };
        let ray = |theta: f64| {
            let ends = [sector.hole, sector.outer].map(|r| [r, theta]);
            (Track::Straight, ends)
        };
        let sides = [arc(sector.hole), arc(sector.outer), ray(-HALF), ray(HALF)];
        let mut fields = Field::BOTH.map(|field| FringeLines {
            field,
            lines: Vec::new(),
        });
        for (side, (track, [first, last])) in sides.into_iter().enumerate() {
            let length = (last[0] - first[0]).hypot(first[0] * (last[1] - first[1]));
            let steps = (length / spacing).round();
            let at = |k: usize| -> Point {
                let [r, theta] = [0, 1].map(|c| first[c] + (last[c] - first[c]) * k as f64 / steps);
                [r * theta.cos(), r * theta.sin()]
            };
            let places: Vec<Point> = (0..=steps as usize).map(at).collect();
            let found = self.displacements_at(&places)?;
            for (component, field) in fields.iter_mut().enumerate() {
                let orders = found.iter().skip(component).step_by(2);
                let centres: Vec<(Point, f64)> = (places.iter().copied())
                    .zip(orders.map(|u| FREQUENCY * u))
                    .collect();
                let name = side.to_string();
                let line = FringeLine::new("specimen", &name, track, &centres, 1e-9)?;
                field.lines.push(line);
            }
        }
        Ok(fields)
    }

    /// Error-free displacements on a jittered grid of `spacing` `[mm]` that begins `stand_off` `[mm]` from the edge; its first row lies
    /// there exactly.
    pub(crate) fn measure(&self, spacing: f64, stand_off: f64) -> Result<Measurement, TaskError> {
        let places = grid(spacing, stand_off);
        let found = self.displacements_at(&places)?;
        let component = |axis: usize| found.iter().skip(axis).step_by(2).copied().collect();
        let valid = vec![true; places.len()];
        Ok(Measurement {
            displacements: [component(0), component(1)],
            valid: [valid.clone(), valid],
            deviation: [DEVIATION; 2],
            places,
        })
    }
}

fn grid(spacing: f64, stand_off: f64) -> Vec<Point> {
    let mut random = StdRng::seed_from_u64(4);
    let half = BEYOND[0] * HALF;
    let inner = RADIUS + stand_off;
    let outer = BEYOND[1] * 2.0 * RADIUS;
    let rings = ((outer - inner) / spacing).floor() as usize;
    let mut places = Vec::new();
    for ring in 0..rings {
        let middle = inner + ring as f64 * spacing;
        let count = (2.0 * half * middle / spacing).floor() as usize;
        for k in 0..count {
            let mut jitter = || random.random_range(-JITTER..=JITTER);
            let r = if ring == 0 {
                middle
            } else {
                middle + spacing * jitter()
            };
            let theta = half * (2.0 * (k as f64 + 0.5 + jitter()) / count as f64 - 1.0);
            places.push([r * theta.cos(), r * theta.sin()]);
        }
    }
    places
}

/// Errors of both components, uniform in ±1/4 fringe and independent.
pub(crate) fn disturbed(exact: &Measurement, seed: u64) -> Measurement {
    let [u, v] = &exact.displacements;
    let both = shaken(&[u.as_slice(), v].concat(), seed);
    let (u, v) = both.split_at(u.len());
    Measurement {
        displacements: [u.to_vec(), v.to_vec()],
        ..exact.clone()
    }
}

/// Numbers with errors uniform in ±1/4 fringe.
pub(crate) fn shaken(exact: &[f64], seed: u64) -> Vec<f64> {
    let mut random = StdRng::seed_from_u64(seed);
    let half = DEVIATION * 3.0_f64.sqrt();
    let shake = |value: &f64| value + random.random_range(-half..=half);
    exact.iter().map(shake).collect()
}

/// Angle of an edge node at the arc length `parameter`, in (−π, π].
pub(crate) fn angle(parameter: f64) -> f64 {
    let turns = parameter / RADIUS / TAU;
    TAU * (turns - turns.round())
}
