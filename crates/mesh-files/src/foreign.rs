//! Files of other programs that are easily taken for something else: what they are, by name or first lines.

use crate::Format;
use crate::imported::Imported;
use crate::names::listed;

/// What a file of another program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Foreign {
    /// As text, with its article.
    pub what: &'static str,
    /// Its format, if meshes of it are read.
    pub format: Option<Format>,
}

/// How a grid of VTK begins, wherever its first element has this attribute.
const GRID: &str = "<VTKFile type=\"UnstructuredGrid\"";

/// Extensions, what such files are, and how their first line begins where that is no beginning of another text.
const KINDS: &[(&[&str], Foreign, &[&str])] = &[
    (
        &["inp"],
        kind("a mesh of Abaqus or CalculiX", Some(Format::Abaqus)),
        &["*"],
    ),
    (
        &["msh"],
        kind("a mesh of Gmsh", Some(Format::Gmsh)),
        &["$MeshFormat", "$NOD"],
    ),
    (&["vtu"], kind("a mesh of VTK", Some(Format::Vtk)), &[GRID]),
    (
        &["vtk", "vtp", "pvtu", "pvd"],
        kind("a file of VTK", None),
        &["<VTKFile", "# vtk DataFile"],
    ),
    (
        &["stl"],
        kind("a surface of triangles (STL)", None),
        &["solid"],
    ),
    (
        &["step", "stp"],
        kind("a geometry (STEP)", None),
        &["ISO-10303-21"],
    ),
    (&["iges", "igs"], kind("a geometry (IGES)", None), &[]),
    (
        &["geo", "geo_unrolled"],
        kind("a geometry of Gmsh", None),
        &[],
    ),
    (
        &["brep"],
        kind("a geometry (BREP)", None),
        &["DBRep_DrawableShape"],
    ),
    (&["dxf"], kind("a drawing (DXF)", None), &[]),
    (&["bdf", "nas"], kind("a mesh of Nastran", None), &[]),
    (&["cdb"], kind("a mesh of Ansys", None), &[]),
    (&["unv", "med"], kind("a mesh of Salome", None), &[]),
];

const fn kind(what: &'static str, format: Option<Format>) -> Foreign {
    Foreign { what, format }
}

impl Foreign {
    /// What a file of this name is, by its extension in either case.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, own) = name.rsplit_once('.')?;
        let is_own = |extension: &&str| own.eq_ignore_ascii_case(extension);
        let found = KINDS.iter().find(|(all, ..)| all.iter().any(is_own));
        found.map(|&(_, kind, _)| kind)
    }

    /// How to make a file of it that is read, as the beginning of a sentence.
    pub fn export(self) -> &'static str {
        "mesh the plane part, name its edges, and save it as .msh of Gmsh (text; physical curves are edges), as .inp of Abaqus or CalculiX, or as .vtu of VTK; then"
    }

    /// What a text is, by its first lines.
    pub fn of_text(text: &str) -> Option<Self> {
        let mut lines = text
            .trim_start_matches('\u{feff}')
            .lines()
            .map(str::trim_start);
        let begins_file = |line: &&str| !line.is_empty() && !line.starts_with("<?xml");
        let first = match lines.by_ref().find(begins_file)? {
            line if line.starts_with("<VTKFile") && line.contains("\"UnstructuredGrid\"") => GRID,
            line => line,
        };
        let begins =
            |line: &str, beginnings: &[&str]| beginnings.iter().any(|own| line.starts_with(own));
        let found = KINDS
            .iter()
            .find(|(.., beginnings)| begins(first, beginnings));
        let &(_, kind, beginnings) = found?;
        // The name of a solid may be any text: its first facet stands below.
        let is_sure = beginnings != ["solid"] || lines.next()?.starts_with("facet");
        is_sure.then_some(kind)
    }
}

impl Imported {
    /// Names of its edge sets, ascending.
    pub fn edge_names(&self) -> Vec<&str> {
        self.parts.edge_sets.keys().map(String::as_str).collect()
    }

    /// The names of its edges and of its other node sets, as sentences for a reader.
    pub fn describe_sets(&self) -> String {
        let edges = self.edge_names();
        let points = self.parts.node_sets.keys().map(String::as_str);
        let points: Vec<&str> = points.filter(|name| !edges.contains(name)).collect();
        let edges = if edges.is_empty() {
            "The file names no edge: export node sets or surfaces (in Gmsh physical curves, in VTK integers on points or lines) for supports, loads and contacts".to_owned()
        } else {
            format!("Edges of the file: {}", listed(&edges))
        };
        format!("{edges}. Its points: {}.", listed(&points))
    }
}
