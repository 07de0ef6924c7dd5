//! Load steps on some of the contact nodes: many where contact changes in the step, few elsewhere.
//!
//! Of the nodes j of an edge a step takes those named K, with hats φ_K between them. With areas A_j and frames F_j = (e_n, e_t) of the nodes,
//!
//! ```text
//! A_K = Σ_j φ_K(j) A_j,   w_Kj = φ_K(j) A_j/A_K,      U_K = F_Kᵀ Σ_j w_Kj F_j u_j,      f_j = Σ_K w_Kj F_jᵀ F_K f_K,      g_K = Σ_j w_Kj g_j
//! ```
//!
//! Displacements are means in the frames that turn along the edge, and forces do the same work on the nodes as on the means. So pressure and shear are linear between the
//! chosen nodes in the frames of the nodes, friction holds its cone there, bodies stay in balance, and what a mean over a bent edge leaves out is only what the
//! nodes themselves leave out. The operator of a step is the congruence transform W C Wᵀ of that of the nodes.
//!
//! From step to step displacements of all nodes are carried over, which forces on the chosen nodes make exactly; those of the next step are means of them. Where nodes of a second edge stand elsewhere in the
//! next step, displacements there are read between them by cubics. What points remember is interpolated.

mod hats;
mod operator;

use stickslip_fem_core::InterfaceOperator;

use crate::deformed::{DeformedGaps, Facing, Geometry, Kinematics, is_free_to_turn};
use crate::error::ContactError;
use crate::interface::Interface;
use crate::problem::{ContactPair, ContactPoint};

pub use hats::EdgeNodes;
use hats::Hats;
pub(crate) use operator::ThinnedBody;

/// Bodies and contacts with all their nodes.
#[derive(Clone, Debug)]
pub struct Whole<'a> {
    pub(crate) bodies: Vec<&'a dyn InterfaceOperator>,
    pub(crate) interface: &'a Interface,
    edges: Vec<EdgeNodes>,
    pub(crate) facings: Vec<&'a Facing>,
    /// Gaps of all points between the undeformed edges, where gaps follow the displacement.
    gaps: Vec<f64>,
}

impl<'a> Whole<'a> {
    /// Those of `interface` between `bodies`, with contact as `kinematics` says; `edges` are those of its pairs. `None` where a contact point is not a single node of
    /// either body, springs link bodies, or `edges` do not fit the pairs.
    pub fn new(
        bodies: &[&'a dyn InterfaceOperator],
        interface: &'a Interface,
        kinematics: &Kinematics<'a>,
        edges: Vec<EdgeNodes>,
    ) -> Option<Self> {
        if interface.is_linked() {
            return None;
        }
        let pairs = interface.contacts().pairs();
        let (facings, gaps) = match kinematics {
            Kinematics::Small => Default::default(),
            Kinematics::DeformedGaps(gaps) => (gaps.facings().to_vec(), undeformed(gaps, pairs)?),
        };
        let is_single =
            |point: &ContactPoint| point.first.node().is_some() && point.second.node().is_some();
        let fits = |(pair, edge): (&ContactPair, &EdgeNodes)| {
            pair.points.len() == edge.parameter.len() && pair.points.iter().all(is_single)
        };
        let all = edges.len() == pairs.len() && pairs.iter().zip(&edges).all(fits);
        all.then(|| Self {
            bodies: bodies.to_vec(),
            interface,
            edges,
            facings,
            gaps,
        })
    }
}

/// The bodies and contacts of a load step on chosen nodes.
#[derive(Clone, Debug)]
pub struct Thinned {
    pub(crate) bodies: Vec<ThinnedBody>,
    /// Hats of each pair.
    pub(crate) hats: Vec<Hats>,
    pub(crate) interface: Interface,
    /// The edges of each pair, where gaps follow the displacement.
    facings: Vec<Facing>,
    /// Whether each body is free to turn.
    turning: Vec<bool>,
}

impl Thinned {
    /// Those of the points `chosen` of each pair of `whole`, ascending.
    ///
    /// # Errors
    /// [`ContactError::InvalidPair`] for a choice of fewer than three points, one that does not ascend or that is out of range.
    pub fn new(whole: &Whole<'_>, chosen: &[Vec<usize>]) -> Result<Self, ContactError> {
        let pairs = whole.interface.contacts().pairs();
        let mut hats = Vec::with_capacity(pairs.len());
        for (index, (pair, edge)) in pairs.iter().zip(&whole.edges).enumerate() {
            let chosen = chosen.get(index).map_or(&[][..], Vec::as_slice);
            hats.push(Hats::new(pair, edge, chosen)?);
        }
        let body = |(index, body): (usize, &&dyn InterfaceOperator)| {
            ThinnedBody::new(index, *body, pairs, &hats, &whole.facings)
        };
        let bodies: Vec<ThinnedBody> = whole.bodies.iter().enumerate().map(body).collect();
        let thin = |(index, pair): (usize, &ContactPair)| {
            let offsets = [pair.first, pair.second]
                .map(|body| bodies[body].offset(index, body == pair.first));
            hats[index].pair(pair, offsets)
        };
        let thinned: Vec<ContactPair> = pairs.iter().enumerate().map(thin).collect();
        let facing =
            |(index, facing): (usize, &&Facing)| hats[index].facing(facing, &thinned[index]);
        let facings = whole.facings.iter().enumerate().map(facing);
        let mut facings: Vec<Facing> = facings.collect::<Result<_, _>>()?;
        let faces: Vec<&dyn InterfaceOperator> = faces(&bodies);
        if !facings.is_empty() {
            let mut gaps = Vec::with_capacity(whole.gaps.len());
            for (pair, hats) in hats.iter().enumerate() {
                let first = whole.interface.contacts().pair_points(pair).start;
                let mean = |hat: &hats::Hat| hat.mean(|k| whole.gaps[first + k]);
                gaps.extend(hats.all().iter().map(mean));
            }
            shift(&faces, &thinned, &mut facings, &gaps)?;
        }
        let interface = Interface::new(&faces, thinned)?;
        drop(faces);
        Ok(Self {
            bodies,
            hats,
            interface,
            facings,
            turning: (whole.bodies.iter())
                .map(|body| is_free_to_turn(*body))
                .collect(),
        })
    }

    /// Its contacts.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    /// The chosen points of pair `pair`.
    pub fn chosen(&self, pair: usize) -> &[usize] {
        self.hats[pair].chosen()
    }

    /// On which geometry its contact is found.
    ///
    /// # Errors
    /// As [`DeformedGaps::new`].
    pub(crate) fn kinematics(&self) -> Result<Kinematics<'_>, ContactError> {
        if self.facings.is_empty() {
            return Ok(Kinematics::Small);
        }
        let pairs = self.interface.contacts().pairs();
        let gaps = DeformedGaps::new(&faces(&self.bodies), pairs, &self.facings)?;
        let translated = self.bodies.iter().map(ThinnedBody::translated).collect();
        let gaps = gaps.of_means(&self.turning, translated);
        Ok(Kinematics::DeformedGaps(gaps))
    }
}

fn faces(bodies: &[ThinnedBody]) -> Vec<&dyn InterfaceOperator> {
    let each = bodies.iter();
    each.map(|body| body as &dyn InterfaceOperator).collect()
}

/// Gaps of the points of `pairs` between undeformed edges; `None` where a point faces no place.
fn undeformed(gaps: &DeformedGaps<'_>, pairs: &[ContactPair]) -> Option<Vec<f64>> {
    let still = |count: usize| nalgebra::DVector::zeros(2 * count);
    let still: Vec<_> = (gaps.bodies().iter())
        .map(|body| still(body.points().len()))
        .collect();
    Some(Geometry::at(gaps, pairs, &still).ok()?.gaps())
}

/// Shifts the places of the first edges along their normals until gaps between undeformed edges are `wanted`, means over hats.
fn shift(
    faces: &[&dyn InterfaceOperator],
    pairs: &[ContactPair],
    facings: &mut [Facing],
    wanted: &[f64],
) -> Result<(), ContactError> {
    let there = undeformed(&DeformedGaps::new(faces, pairs, facings)?, pairs);
    let there = there.ok_or_else(|| ContactError::InvalidPair {
        pair: pairs
            .first()
            .map_or_else(String::new, |pair| pair.name.clone()),
        point: 0,
        what: "a chosen node faces no place of the second edge".to_owned(),
    })?;
    let mut apart = there.into_iter().zip(wanted);
    for (pair, facing) in pairs.iter().zip(facings) {
        for ((point, place), (gap, wanted)) in
            pair.points.iter().zip(&mut facing.first).zip(&mut apart)
        {
            *place = [0, 1].map(|i| place[i] + (wanted - gap) * point.normal[i]);
        }
    }
    Ok(())
}
