//! What is compared: around the default (Q8, node pairs with their true gap, the default chain) one choice at a time.

use stickslip_contact::InterfaceSolver;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::problems::{Pairing, Problem};

use crate::stability::methods as table;

/// How the contact conditions are met.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Enforcement {
    /// On the condensed interface, by the solver of this name in the table of methods.
    Condensed(&'static str),
    /// Newton on the whole finite-element system, refactorised at every contact iteration.
    Conventional,
}

impl Enforcement {
    /// The chain of solvers that a user gets who chooses none.
    pub(super) const DEFAULT: Self = Self::Condensed(table::CHAIN);

    /// The solver of the condensed interface problem; none for the path that does not condense.
    pub(super) fn solver(self) -> Option<Box<dyn InterfaceSolver>> {
        let Self::Condensed(name) = self else {
            return None;
        };
        let mut methods = table::methods().into_iter();
        methods
            .find(|method| method.name == name)
            .map(|method| method.solver)
    }

    fn name(self) -> &'static str {
        match self {
            Self::Condensed(name) => name,
            Self::Conventional => "conventional Newton",
        }
    }
}

/// One way to discretise and solve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Method {
    pub(super) element: ElementKind,
    pub(super) pairing: Pairing,
    pub(super) enforcement: Enforcement,
}

impl Method {
    /// What a user gets who chooses nothing.
    pub(super) const DEFAULT: Self = Self {
        element: ElementKind::Q8,
        pairing: Pairing::NodePairs,
        enforcement: Enforcement::DEFAULT,
    };

    /// Element and contact discretisation, and enforcement, for the data.
    pub(super) fn columns(self) -> [String; 3] {
        [
            format!("{:?}", self.element),
            self.pairing.name().to_owned(),
            self.enforcement.name().to_owned(),
        ]
    }

    /// Element and contact discretisation, for a reader.
    pub(super) fn discretisation(self) -> String {
        match self.pairing {
            Pairing::NodePairs => format!("{:?}", self.element),
            pairing => format!("{:?}, {}", self.element, pairing.name()),
        }
    }

    fn element(element: ElementKind) -> Self {
        Self {
            element,
            ..Self::DEFAULT
        }
    }

    fn paired(element: ElementKind, pairing: Pairing) -> Self {
        Self {
            pairing,
            ..Self::element(element)
        }
    }

    /// Whether `problem` can be discretised so: a body without a mesh has nothing to be apart from.
    pub(super) fn suits(self, problem: Problem) -> bool {
        problem.two_meshes() || !self.pairing.apart()
    }

    fn enforced(enforcement: Enforcement) -> Self {
        Self {
            enforcement,
            ..Self::DEFAULT
        }
    }
}

/// Methods that differ in one choice, and stand in one picture.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Part of file names.
    pub(super) key: &'static str,
    /// What differs.
    pub(super) title: &'static str,
    /// Label of each curve, and its method.
    pub(super) methods: Vec<(String, Method)>,
}

/// Elements, at the default contact discretisation and solver.
pub(super) fn elements() -> Group {
    use ElementKind::{P3, P4, P6, Q4, Q8, Q9, T3, T6};
    Group {
        key: "elements",
        title: "Elements",
        methods: [T3, Q4, T6, Q8, Q9, P3, P4, P6]
            .map(|element| (format!("{element:?}"), Method::element(element)))
            .into(),
    }
}

/// The gap of the true shapes against that between facets, for a linear and a quadratic element.
pub(super) fn gaps() -> Group {
    let mut methods = Vec::new();
    for element in [ElementKind::Q8, ElementKind::Q4] {
        for (name, pairing) in [
            ("true gap", Pairing::NodePairs),
            ("gap between facets", Pairing::FacetedNodePairs),
            (
                "meshes apart, true gap",
                Pairing::DualMortar { apart: true },
            ),
            ("meshes apart, gap between facets", Pairing::FacetedApart),
        ] {
            methods.push((
                format!("{element:?}, {name}"),
                Method::paired(element, pairing),
            ));
        }
    }
    Group {
        key: "gaps",
        title: "Initial gap",
        methods,
    }
}

/// Node pairs against mortar projections, on matching meshes and on meshes apart.
pub(super) fn projections(element: ElementKind) -> Group {
    let (key, title) = if element == ElementKind::Q4 {
        ("mortar-linear", "Node pairs and mortar, linear edges (Q4)")
    } else {
        ("mortar", "Node pairs and mortar, quadratic edges (Q8)")
    };
    let pairings = [
        Pairing::NodePairs,
        Pairing::Mortar { apart: false },
        Pairing::DualMortar { apart: false },
        Pairing::Mortar { apart: true },
        Pairing::DualMortar { apart: true },
    ];
    Group {
        key,
        title,
        methods: pairings
            .map(|pairing| {
                let label = pairing.name().to_owned();
                (label, Method::paired(element, pairing))
            })
            .into(),
    }
}

/// All contact discretisations: gaps, and projections on quadratic and on linear edges.
pub(super) fn discretisations() -> [Group; 3] {
    [
        gaps(),
        projections(ElementKind::Q8),
        projections(ElementKind::Q4),
    ]
}

/// Solvers of the table that end with the exact answer of the discrete problem, beside the default.
const DIRECT: &[&str] = &[
    "status iteration",
    "Lemke pivoting",
    "principal pivoting",
    "continuation",
];
/// Those that the charts leave out: the default's first member, and one for a handful of points.
const LEFT_OUT: &[&str] = &["semismooth Newton", "enumeration"];

/// Solvers that end with the exact answer of the discrete problem, and the conventional path.
pub(super) fn direct_solvers() -> Group {
    let condensed = DIRECT.iter().copied().map(Enforcement::Condensed);
    solvers(
        "solvers-direct",
        "Solvers that end with the discrete problem's exact answer",
        condensed.chain(std::iter::once(Enforcement::Conventional)),
    )
}

/// All other solvers of the table: they approach the answer.
pub(super) fn iterative_solvers() -> Group {
    let others = table::methods().into_iter().map(|method| method.name);
    let iterative = others
        .filter(|name| *name != table::CHAIN && !DIRECT.contains(name) && !LEFT_OUT.contains(name));
    solvers(
        "solvers-iterative",
        "Solvers that approach the answer",
        iterative.map(Enforcement::Condensed),
    )
}

/// The default first, then `others`.
fn solvers(
    key: &'static str,
    title: &'static str,
    others: impl Iterator<Item = Enforcement>,
) -> Group {
    Group {
        key,
        title,
        methods: std::iter::once(Enforcement::DEFAULT)
            .chain(others)
            .map(|enforcement| (enforcement.name().to_owned(), Method::enforced(enforcement)))
            .collect(),
    }
}
