//! How the two edges of a reference problem's contact are tied to each other.

use super::Problem;

/// Which points of the edges face each other, and how their initial gaps are computed.
///
/// On meshes *apart* the second body's nodes are 1.5 times as far from each other as the first one's, so that two of three have no
/// partner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pairing {
    /// Pairs of nodes, with the gap as the problem states it: of the true circles, or linearised where the known answer is.
    #[default]
    NodePairs,
    /// Pairs of nodes, with the gap between the straight facets of the meshes.
    FacetedNodePairs,
    /// Dual mortar projection on meshes apart, with the gap between the straight facets.
    FacetedApart,
    /// Mortar projection with standard multipliers.
    Mortar {
        /// Whether the meshes are apart.
        apart: bool,
    },
    /// Mortar projection with dual (biorthogonal) multipliers.
    DualMortar {
        /// Whether the meshes are apart.
        apart: bool,
    },
}

/// Spacing of the second body's nodes over that of the first one's on meshes apart.
const APART: f64 = 1.5;
const FACETED: &str = "contacts.0.gap=\"faceted\"";

impl Pairing {
    /// Name for tables and captions.
    pub fn name(self) -> &'static str {
        match self {
            Self::NodePairs => "node pairs, true gap",
            Self::FacetedNodePairs => "node pairs, faceted gap",
            Self::FacetedApart => "dual mortar, meshes apart, faceted gap",
            Self::Mortar { apart: false } => "mortar",
            Self::Mortar { apart: true } => "mortar, meshes apart",
            Self::DualMortar { apart: false } => "dual mortar",
            Self::DualMortar { apart: true } => "dual mortar, meshes apart",
        }
    }

    /// Whether the meshes are apart.
    pub fn apart(self) -> bool {
        matches!(
            self,
            Self::FacetedApart | Self::Mortar { apart: true } | Self::DualMortar { apart: true }
        )
    }

    /// Settings of the scene that make it so.
    pub(super) fn settings(self, problem: Problem, spacing: f64) -> Vec<String> {
        let projection = |name: &str, apart: bool| {
            let mut settings = vec![format!("contacts.0.projection=\"{name}\"")];
            if apart {
                let (body, unit) = (problem.second_body(), problem.unit());
                let spacing = APART * spacing;
                settings.push(format!("bodies.{body}.mesh.spacing=\"{spacing} {unit}\""));
            }
            settings
        };
        match self {
            Self::NodePairs => Vec::new(),
            Self::FacetedNodePairs => vec![FACETED.to_owned()],
            Self::FacetedApart => {
                let mut settings = projection("dual-mortar", true);
                settings.push(FACETED.to_owned());
                settings
            }
            Self::Mortar { apart } => projection("mortar", apart),
            Self::DualMortar { apart } => projection("dual-mortar", apart),
        }
    }
}
