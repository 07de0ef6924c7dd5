//! `mesh`: a body whose mesh is in a file of another program.
//!
//! Its sets name its edges and points. An edge whose nodes lie on a line, on a circle, or on lines and arcs one after another is that curve; others are splines where the scene says so.

mod edges;
mod placed;
mod splines;

use std::borrow::Cow;
use std::cell::RefCell;
use std::error::Error;
use std::fmt;
use std::io::{self, ErrorKind};
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate::{Generate, GenerateError, MeshEstimate, unit_vector};
use stickslip_fem_core::mesh::{ElementKind, Mesh, MeshError, Point};
use stickslip_mesh_files::{Coincident, Format, read_with};

use self::edges::{edges, uneven};
use self::placed::{on_circles, placed};
use super::Shape;
use super::note::FileNote;
use super::outline::{CircleFit, Divided, DivisionError, Edge, Meshing, Outline, Sizes};
use crate::declaration::{Key, NONE, POSITIVE, REQUIRED, described, lengths, text};
use crate::digest::sha256;
use crate::document::child;
use crate::units::{Length, Quantity, UnitName};

const NAME: &str = "mesh";

/// None: no setting divides it.
pub(super) const MESH_KEYS: &[&str] = &[];

pub(super) const MEANING: &str = "a mesh of Gmsh (`.msh`, text), Abaqus or CalculiX (`.inp`), or VTK (`.vtu`); edges and points as its sets are named";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    text("file", REQUIRED, r#""data/lug.inp""#, "the file, relative to the folder of the scene"),
    described("unit", "unit of length", REQUIRED, r#""mm""#, "unit of its coordinates"),
    text("elements", NONE, r#""body""#, "the element set or physical surface that is the body, of a file with several; all cells otherwise"),
    described("circles", "list of edges", NONE, r#"["bolt"]"#, "closed edges that are circles, although their nodes are off them by up to 5 % of the radius: they are put onto them"),
    lengths("radii", NONE, r#"["10 mm"]"#, "radii of `circles`, in their order; those of the fits through their nodes otherwise").range(POSITIVE),
    described("splines", "list of edges", NONE, r#"["end"]"#, "open edges that are smooth curves, neither lines nor circles nor some of these: splines through their nodes"),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    file: String,
    unit: UnitName<Length>,
    #[serde(skip_serializing_if = "Option::is_none")]
    elements: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    circles: Vec<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    radii: Vec<Quantity<Length>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    splines: Vec<String>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str = r#"mesh = { file = "ring.inp", unit = "mm" }"#;

impl Keys {
    pub(super) fn read(&self, table: &str, sizes: &mut dyn Sizes) -> GivenMesh {
        let refused = match self.given(sizes) {
            Ok(made) => return made,
            Err(refused) => refused,
        };
        let [key, cause, remedy] = refused;
        sizes.bad_file(&child(table, key), &self.file, cause, remedy);
        GivenMesh {
            file: self.file.clone(),
            digest: String::new(),
            mesh: None,
            edges: Vec::new(),
            points: Vec::new(),
            uneven: Vec::new(),
            fitted: Vec::new(),
            notes: Vec::new(),
            splines: Vec::new(),
            turn: 0.0,
        }
    }

    /// The mesh, otherwise key, cause and remedy.
    fn given(&self, sizes: &dyn Sizes) -> Result<GivenMesh, [String; 3]> {
        const MEND: &str = "correct the mesh in the program that made it, and export it again";
        let refused =
            |key: &str, cause: String, remedy: &str| [key.to_owned(), cause, remedy.to_owned()];
        let format = Format::of_name(&self.file).ok_or_else(|| {
            let cause = "its name ends in none of .msh, .inp and .vtu".to_owned();
            let remedy =
                "export the mesh from Gmsh as .msh (text), from Abaqus or CalculiX as .inp, or as a .vtu of VTK";
            refused("file", cause, remedy)
        })?;
        let path = Path::new(&self.file);
        let content = sizes.file(path, None);
        let content =
            content.map_err(|cause| refused("file", cause.to_string(), readable(&cause)))?;
        // Files that it includes count in the checksum as well.
        let whole = RefCell::new(content.clone());
        let include = |name: &str| {
            let text = sizes.file(path, Some(name))?;
            whole.borrow_mut().push_str(&text);
            Ok(text)
        };
        // Bodies that touch in one file have nodes at the same places.
        let coincident = match self.elements {
            Some(_) => Coincident::Allow,
            None => Coincident::Refuse,
        };
        let all = read_with(&content, format, &include, coincident);
        let all = all.map_err(|cause| refused("file", cause.to_string(), MEND))?;
        let own = match &self.elements {
            None => all,
            Some(set) => all.only(set).ok_or_else(|| {
                let known = all.parts.element_sets.keys().map(String::as_str);
                let known: Vec<&str> = known.collect();
                let remedy = format!("sets of the file: {}", known.join(", "));
                refused(
                    "elements",
                    format!("it has no element set '{set}'"),
                    &remedy,
                )
            })?,
        };
        if let Some(both) = self.circles.iter().find(|own| self.splines.contains(own)) {
            let cause = format!("'{both}' is named in `circles` too");
            return Err(refused("splines", cause, "name it in one of them"));
        }
        let radii: Vec<f64> = self.radii.iter().map(Quantity::value).collect();
        let circles = match (self.circles.as_slice(), radii.as_slice()) {
            ([], []) => String::new(),
            (named, []) => format!("circles {named:?} "),
            (named, radii) => format!("circles {named:?} {radii:?} "),
        };
        let digest = sha256(format!(
            "{:e} {:?} {:?} {circles}{}",
            self.unit.unit().in_base,
            self.elements,
            self.splines,
            whole.into_inner()
        ));
        let invalid = |cause: &dyn Error| refused("file", cause.to_string(), MEND);
        let mut notes: Vec<FileNote> = own.notes.into_iter().map(FileNote::Read).collect();
        let (mut parts, scale) = (own.parts, self.unit.unit().in_base);
        for node in &mut parts.nodes {
            *node = node.map(|x| scale * x);
        }
        let fitted = on_circles(&mut parts, &self.circles, &radii, &mut notes)?;
        let plain = placed(parts, &self.splines, &mut notes).map_err(|cause| invalid(&cause))?;
        let plain = splines::put_on(plain, &self.splines, &mut notes)
            .map_err(|[cause, remedy]| refused("splines", cause, &remedy))?;
        let given = GivenMesh {
            file: self.file.clone(),
            digest,
            mesh: None,
            edges: Vec::new(),
            points: Vec::new(),
            uneven: Vec::new(),
            fitted,
            notes,
            splines: self.splines.clone(),
            turn: 0.0,
        };
        given.with(plain).map_err(|cause| invalid(&cause))
    }
}

/// What makes a file readable that was not, by `cause`.
fn readable(cause: &io::Error) -> &'static str {
    match cause.kind() {
        ErrorKind::NotFound => "check the name; the path is relative to the folder of the scene",
        ErrorKind::FileTooLarge => {
            "export the plane elements of this body and its sets only, mesh it with fewer elements, or free memory"
        }
        ErrorKind::InvalidData => "save the mesh as text (Gmsh: Mesh.Binary = 0; ParaView: Ascii)",
        ErrorKind::IsADirectory | ErrorKind::InvalidInput => "name the file that holds the mesh",
        ErrorKind::PermissionDenied => "allow reading the file, or copy it",
        _ => "check that the file can be read",
    }
}

/// A mesh from a file.
#[derive(Clone, PartialEq)]
pub struct GivenMesh {
    /// The file as the scene names it.
    pub file: String,
    /// SHA-256 of its text, and of what the scene takes of it.
    pub digest: String,
    /// Its cells, coordinates in `[mm]`; `None` of a file that was refused.
    mesh: Option<Arc<Mesh>>,
    edges: Vec<Edge>,
    points: Vec<(String, Point)>,
    /// Closed edges that are nearly circles, and by how much they are none.
    uneven: Vec<(String, String)>,
    /// Circles that were declared, and how they were fitted.
    fitted: Vec<(String, CircleFit)>,
    /// What of the file was passed over or changed.
    pub notes: Vec<FileNote>,
    /// Names of edges that are splines.
    splines: Vec<String>,
    /// By what it is turned from where the file has it `[rad]`.
    turn: f64,
}

impl fmt::Debug for GivenMesh {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let nodes = self.mesh.as_ref().map_or(0, |mesh| mesh.nodes().len());
        write!(
            formatter,
            "GivenMesh({}, {nodes} nodes, {}, turned by {})",
            self.file, self.digest, self.turn
        )
    }
}

impl GivenMesh {
    /// The same file with its mesh.
    fn with(self, plain: Mesh) -> Result<Self, MeshError> {
        let names: Vec<String> = plain.edge_set_names().map(str::to_owned).collect();
        let points = (plain.node_set_names())
            .filter(|name| plain.edge_set(name).is_err())
            .filter_map(|name| {
                let node = plain.node_set(name).ok()?.first()?;
                Some((name.to_owned(), plain.nodes()[*node]))
            });
        let points = points.collect();
        let edges = edges(&plain, names.iter().map(String::as_str), &self.splines);
        let uneven = (names.iter()).filter_map(|name| {
            let path = plain.edge_path(name).ok().filter(|path| path.closed)?;
            Some((name.clone(), uneven(&plain, name, &path)?))
        });
        let uneven = uneven.collect();
        let mut sets = Vec::new();
        for name in &names {
            let set = plain.edge_set(name)?;
            let mut nodes: Vec<usize> = (set.edges.iter())
                .flat_map(|&own| plain.edge_nodes(own).walk().collect::<Vec<_>>())
                .collect();
            nodes.sort_unstable();
            nodes.dedup();
            sets.push((name.clone(), nodes));
        }
        let mut parts = plain.into_parts();
        parts.node_sets.extend(sets);
        let mesh = Mesh::new(parts)?;
        Ok(Self {
            mesh: Some(Arc::new(mesh)),
            edges,
            points,
            uneven,
            ..self
        })
    }
}

impl Outline for GivenMesh {
    fn name(&self) -> &'static str {
        NAME
    }

    fn edges(&self) -> Vec<Edge> {
        self.edges.clone()
    }

    fn points(&self) -> Vec<(Cow<'static, str>, Point)> {
        let own = self.points.iter();
        own.map(|(name, at)| (Cow::Owned(name.clone()), *at))
            .collect()
    }

    fn areas(&self) -> &'static [&'static str] {
        &["section"]
    }

    fn bounds(&self) -> [Point; 2] {
        let mesh = self.mesh.as_ref();
        mesh.map_or([[0.0; 2], [1.0; 2]], |mesh| mesh.bounding_box())
    }

    fn mirror(&self) -> Option<usize> {
        None
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        MESH_KEYS
    }

    fn digest(&self) -> Option<&str> {
        Some(&self.digest)
    }

    fn reentrant_corners(&self) -> Vec<(Point, f64)> {
        let mesh = self.mesh.iter();
        let corners = mesh.flat_map(|mesh| {
            let own = mesh.reentrant_corners().into_iter();
            own.map(|(node, angle)| (mesh.nodes()[node], angle))
        });
        corners.collect()
    }

    fn nodes_of_point(&self, name: &str) -> usize {
        let nodes = self.mesh.as_ref().map(|mesh| mesh.node_set(name));
        nodes.and_then(Result::ok).map_or(1, <[_]>::len)
    }

    fn why_not_round(&self, edge: &str) -> Option<&str> {
        let own = self.uneven.iter().find(|(name, _)| name == edge)?;
        Some(&own.1)
    }

    fn fit(&self, edge: &str) -> Option<CircleFit> {
        let own = self.fitted.iter().find(|(name, _)| name == edge)?;
        Some(own.1)
    }

    fn notes(&self) -> &[FileNote] {
        &self.notes
    }

    fn cells(&self, asked: ElementKind) -> Option<ElementKind> {
        let own = self.mesh.as_ref().and_then(|mesh| mesh.blocks().first());
        Some(own.map_or(asked, |block| block.kind))
    }

    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let mesh = self.mesh.as_ref().ok_or(DivisionError::NoFile)?;
        let generator = Moved {
            mesh: Arc::clone(mesh),
            by: divided.centre,
        };
        Ok(Meshing {
            generator: Box::new(generator),
            layers: None,
        })
    }

    fn is_placed(&self) -> bool {
        true
    }

    fn moved(&self, by: Point) -> Option<Shape> {
        if by == [0.0; 2] {
            return Some(Shape::GivenMesh(self.clone()));
        }
        let mesh = Mesh::clone(self.mesh.as_ref()?).translated(by).ok()?;
        let shifted = |[x, y]: Point| [x + by[0], y + by[1]];
        let edge = |own: &Edge| Edge {
            curve: own.curve.moved(by),
            ..own.clone()
        };
        let point = |(name, at): &(String, Point)| (name.clone(), shifted(*at));
        Some(Shape::GivenMesh(Self {
            mesh: Some(Arc::new(mesh)),
            edges: self.edges.iter().map(edge).collect(),
            points: self.points.iter().map(point).collect(),
            ..self.clone()
        }))
    }

    fn turn(&self) -> f64 {
        self.turn
    }

    fn turned(&self, angle: f64) -> Option<Shape> {
        let Some(mesh) = self.mesh.as_deref() else {
            // The file was refused.
            return Some(Shape::GivenMesh(self.clone()));
        };
        let [cos, sin] = unit_vector(angle);
        let mesh = mesh.clone().turned([cos, sin]).ok()?;
        let point = |(name, [x, y]): &(String, Point)| {
            (name.clone(), [cos * x - sin * y, sin * x + cos * y])
        };
        let names = self.edges.iter().map(|edge| edge.name.as_ref());
        Some(Shape::GivenMesh(Self {
            edges: edges(&mesh, names, &self.splines),
            points: self.points.iter().map(point).collect(),
            mesh: Some(Arc::new(mesh)),
            turn: self.turn + angle,
            ..self.clone()
        }))
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        let [low, high] = self.bounds();
        let [width, height] = [0, 1].map(|axis| show(high[axis] - low[axis]));
        let nodes = self.mesh.as_ref().map_or(0, |mesh| mesh.nodes().len());
        format!(
            "mesh of {nodes} nodes from '{}', {width} by {height}",
            self.file
        )
    }
}

/// A mesh that stands somewhere else than its file says.
struct Moved {
    mesh: Arc<Mesh>,
    by: Point,
}

impl Generate for Moved {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        Ok(MeshEstimate {
            nodes: self.mesh.nodes().len(),
            elements: self.mesh.element_count(),
        })
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        let nodes = self.mesh.nodes().len();
        if nodes > limit {
            let bytes = nodes * 64;
            return Err(GenerateError::TooLarge {
                nodes,
                bytes,
                limit,
            });
        }
        let own = Mesh::clone(&self.mesh);
        if self.by == [0.0; 2] {
            return Ok(own);
        }
        Ok(own.translated(self.by)?)
    }
}
