//! What acts where, by the nodes of meshes: for pictures of a problem and for files of its meshes.

use stickslip_fem_core::material::PlaneState;

/// What acts where on the bodies of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// What happens across the thickness.
    pub plane: PlaneState,
    /// Whether the scene gives the cells of any body.
    pub is_divided: bool,
    /// Both edges of every contact, but those of rigid bodies.
    pub contacts: Vec<Site>,
    /// What supports hold.
    pub held: Vec<Site>,
    /// What stands on springs.
    pub springs: Vec<Site>,
    /// What platens hold.
    pub platens: Vec<Site>,
    /// Forces and pressures; other loads have no direction.
    pub loads: Vec<Acting>,
}

/// A part of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Index of the body, which has a mesh.
    pub body: usize,
    /// The part.
    pub part: SitePart,
}

/// Which part of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum SitePart {
    /// Nodes of an edge in walk order, the body on the left; of a closed one the first again at the end.
    Edge(Vec<usize>),
    /// Nodes apart from each other.
    Points(Vec<usize>),
    /// The area of the body.
    Area,
}

/// A load on a part of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Acting {
    /// Where it acts.
    pub site: Site,
    /// Unit vector `[1]` of its force; `None` of a pressure, against the outward normal.
    pub direction: Option<[f64; 2]>,
}

impl Default for Problem {
    /// Nothing, in plane stress.
    fn default() -> Self {
        Self {
            plane: PlaneState::Stress,
            is_divided: false,
            contacts: Vec::new(),
            held: Vec::new(),
            springs: Vec::new(),
            platens: Vec::new(),
            loads: Vec::new(),
        }
    }
}
