//! What is mutated: small files that are read without complaint.

use std::fmt::Write as _;
use std::path::Path;

use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_hybrid::fringe::{Depth, Format, Frame, PixelMap, encode};
use stickslip_hybrid::region::sector::ArcSector;

/// A reader, the files that it reads, and which of them is mutated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    SceneText,
    SceneTree,
    SweepText,
    SweepTree,
    ExperimentText,
    ExperimentTree,
    Table,
    Lines,
    Png,
    Tiff,
    Gmsh,
    GmshBinary,
    Curve,
    Cases,
    List,
}

/// Which command reads the main file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reader {
    Scene,
    Sweep,
    Experiment,
    /// Rows of a sweep that goes on.
    Rows,
    /// The list of the files of a folder.
    Owned,
}

const SCENES: [&str; 4] = [
    "pin-quasi-isotropic.toml",
    "bushed-pin.toml",
    "open-hole.toml",
    "joint-bearing.toml",
];

const HEAD: &str = r#"version = 1
[specimen]
material.isotropic = { young = "70 GPa", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "5 mm" }
[grating]
frequency = "2000 1/mm"
"#;
const TABLE: &str =
    r#"table = { file = "data.csv", scale = "1 mm", y_axis = "up", deviation = "1e-4 mm" }"#;
const LINES: &str = r#"lines = { u = "data.csv", v = "v.csv", scale = "0.1 mm", y_axis = "up" }"#;
const SECTOR: &str = r#"[region]
sector = { angles = ["-60 deg", "60 deg"], outer = "8 mm", cells = [8, 3] }
"#;

const CURVE: &str = "data/open-hole-orthotropic-ring5R.csv";
const SWEEP: &str = r#"version = 1
scene = "pinned-joint.toml"
[[axes]]
key = "mu"
values = [0.1, 0.2, 0.3]
"#;
const ROWS: &str = "\
case,mu,load [N],peak_pressure [MPa],contact_half_angle [deg],peak_hoop [MPa],peak_hoop_angle [deg],first_ply_load [N],first_ply,\
first_ply_criterion,first_ply_mode,first_ply_angle [deg],first_ply_found,joint_load [N],joint_bearing_stress [MPa],joint_mode,\
joint_angle [deg],joint_found,seconds,outcome
0,0.1,1000,90.2608621726,40.2589815037,83.1204914768,60,,,,,,,,,,,,0.0045,solved
1,0.2,1000,88.5108300566,40.3480676261,85.4096438907,52.5,700,1,yamada_sun,fibre,80,reached,900,150,bearing,0,reached,0.0006,solved
";
const LISTED: &str = "# stickslip results: `--force` replaces this folder if it holds no files but these\n\
     deep/edge-pin-step-01.csv\nfigures/stresses-pin.svg\nsteps.csv\nsummary.json\n";

fn pictures(name: &str) -> String {
    format!(
        "pictures = {{ u = \"{name}\", pixel = \"0.2 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\", \
         carrier = {{ u = [\"1.2 1/mm\", \"0 1/mm\"], v = [\"0 1/mm\", \"1.2 1/mm\"] }} }}"
    )
}

fn experiment(source: &str, rest: &str) -> Vec<u8> {
    format!("{HEAD}[[states]]\nname = \"up\"\n{source}\n{rest}").into_bytes()
}

/// A file of `scenes/`; nothing where the sources are not there.
fn scene(name: &str) -> Vec<u8> {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    std::fs::read(scenes.join(name)).unwrap_or_default()
}

impl Target {
    pub(super) const ALL: [Self; 15] = [
        Self::SceneText,
        Self::SceneTree,
        Self::SweepText,
        Self::SweepTree,
        Self::ExperimentText,
        Self::ExperimentTree,
        Self::Table,
        Self::Lines,
        Self::Png,
        Self::Tiff,
        Self::Gmsh,
        Self::GmshBinary,
        Self::Curve,
        Self::Cases,
        Self::List,
    ];

    /// The target of a seed: each in its turn.
    pub(super) fn of(seed: u64) -> Self {
        Self::ALL[(seed % Self::ALL.len() as u64) as usize]
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::SceneText => "scenes, bytes",
            Self::SceneTree => "scenes, structure",
            Self::SweepText => "sweeps, bytes",
            Self::SweepTree => "sweeps, structure",
            Self::ExperimentText => "experiments, bytes",
            Self::ExperimentTree => "experiments, structure",
            Self::Table => "tables",
            Self::Lines => "fringe lines",
            Self::Png => "pictures, PNG",
            Self::Tiff => "pictures, TIFF",
            Self::Gmsh => "meshes of Gmsh, text",
            Self::GmshBinary => "meshes of Gmsh, binary",
            Self::Curve => "curves of tractions",
            Self::Cases => "rows of sweeps",
            Self::List => "lists of files",
        }
    }

    pub(super) fn reader(self) -> Reader {
        match self {
            Self::SceneText | Self::SceneTree | Self::Curve => Reader::Scene,
            Self::Cases => Reader::Rows,
            Self::List => Reader::Owned,
            Self::SweepText | Self::SweepTree => Reader::Sweep,
            _ => Reader::Experiment,
        }
    }

    /// Whether values of a tree are mutated, and not bytes.
    pub(super) fn is_tree(self) -> bool {
        matches!(
            self,
            Self::SceneTree | Self::SweepTree | Self::ExperimentTree
        )
    }

    /// The file that the command is given.
    pub(super) fn main(self) -> &'static str {
        if self.is_tree() {
            "main.json"
        } else {
            "main.toml"
        }
    }

    /// The file that is mutated.
    pub(super) fn mutated(self) -> &'static str {
        match self {
            Self::Table | Self::Lines | Self::Curve => "data.csv",
            Self::Png => "u.png",
            Self::Tiff => "u.tiff",
            Self::Gmsh | Self::GmshBinary => "region.msh",
            Self::Cases => "cases.csv",
            Self::List => "list",
            _ => self.main(),
        }
    }

    pub(super) fn extension(self) -> &'static str {
        let (_, extension) = self.mutated().split_once('.').unwrap_or(("", "txt"));
        extension
    }

    /// The files beside the mutated one.
    pub(super) fn files(self) -> Vec<(&'static str, Vec<u8>)> {
        match self {
            Self::SceneText | Self::SceneTree | Self::List => Vec::new(),
            Self::SweepText | Self::SweepTree => {
                vec![("pinned-joint.toml", scene("sweeps/pinned-joint.toml"))]
            }
            Self::ExperimentText | Self::ExperimentTree => vec![("data.csv", table())],
            Self::Table => vec![("main.toml", experiment(TABLE, SECTOR))],
            Self::Lines => vec![("main.toml", experiment(LINES, "")), ("v.csv", lines())],
            Self::Png => vec![("main.toml", experiment(&pictures("u.png"), ""))],
            Self::Tiff => vec![("main.toml", experiment(&pictures("u.tiff"), ""))],
            Self::Gmsh | Self::GmshBinary => {
                let region = "[region]\nmesh = { file = \"region.msh\", scale = \"1 mm\" }\n";
                let main = experiment(TABLE, region);
                vec![("main.toml", main), ("data.csv", table())]
            }
            Self::Curve => vec![("main.toml", curved())],
            Self::Cases => vec![
                ("main.toml", SWEEP.into()),
                ("pinned-joint.toml", scene("sweeps/pinned-joint.toml")),
            ],
        }
    }

    /// What is mutated, of which there may be several.
    pub(super) fn original(self, choice: usize) -> Vec<u8> {
        match self {
            Self::SceneText | Self::SceneTree => scene(SCENES[choice % SCENES.len()]),
            Self::SweepText | Self::SweepTree => scene("sweeps/mode-map.toml"),
            Self::ExperimentText | Self::ExperimentTree => experiment(TABLE, SECTOR),
            Self::Table => table(),
            Self::Lines => lines(),
            Self::Png => picture(Format::Png),
            Self::Tiff => picture(Format::Tiff),
            Self::Gmsh => gmsh(),
            Self::GmshBinary => gmsh_binary(),
            Self::Curve => scene(CURVE),
            Self::Cases => ROWS.into(),
            Self::List => LISTED.into(),
        }
    }
}

/// The scene whose loads are a curve.
fn curved() -> Vec<u8> {
    let text = String::from_utf8_lossy(&scene("validation/open-hole-orthotropic.toml"))
        .replace(&format!("../{CURVE}"), "data.csv");
    text.into_bytes()
}

/// A smooth field on a grid around the hole.
fn table() -> Vec<u8> {
    let mut text = "x,y,u,v\n".to_owned();
    for row in -9..=9 {
        for column in -9..=9 {
            let (x, y) = (f64::from(column), f64::from(row));
            if x.hypot(y) > 5.0 {
                // Writing into a string does not fail.
                let _ = writeln!(text, "{x},{y},{:.6},{:.6}", 1e-3 * x, -3e-4 * y);
            }
        }
    }
    text.into_bytes()
}

fn lines() -> Vec<u8> {
    let mut text = "line,x,y,order\n".to_owned();
    for k in 0..=5 {
        let _ = writeln!(text, "axis,{},0,{k}", 60 + 5 * k);
        let _ = writeln!(text, "other,{},10,{k}", 60 + 5 * k);
    }
    text.into_bytes()
}

fn picture(format: Format) -> Vec<u8> {
    let frame = Frame::over([[6.0, -5.0], [16.0, 5.0]], 0.2);
    let fringes =
        |place: [f64; 2]| Some(0.5 + 0.4 * (std::f64::consts::TAU * 1.2 * place[0]).cos());
    let encoded = frame
        .and_then(|frame| PixelMap::of(frame, fringes))
        .and_then(|picture| encode(&picture, format, Depth::Eight));
    encoded.unwrap_or_default()
}

/// A part of a ring of quadrilaterals as Gmsh writes it.
fn gmsh() -> Vec<u8> {
    let sector = ArcSector {
        centre: [0.0; 2],
        hole: 5.0,
        stand_off: 0.0,
        outer: 8.0,
        angles: [-1.0, 1.0],
        cells: [8, 3],
        growth: 1.0,
        kind: ElementKind::Q4,
    };
    sector
        .mesh()
        .map_or_else(|_| Vec::new(), |mesh| written(&mesh))
}

fn written(mesh: &Mesh) -> Vec<u8> {
    let (nodes, cells) = (mesh.nodes(), mesh.element_count());
    let count = nodes.len();
    let mut text = format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n"
    );
    for tag in 1..=count {
        let _ = writeln!(text, "{tag}");
    }
    for [x, y] in nodes {
        let _ = writeln!(text, "{x} {y} 0");
    }
    let _ = write!(
        text,
        "$EndNodes\n$Elements\n1 {cells} 1 {cells}\n2 1 3 {cells}\n"
    );
    for cell in 0..cells {
        let tags = mesh.element(cell).1.iter();
        let tags: Vec<String> = tags.map(|node| (node + 1).to_string()).collect();
        let _ = writeln!(text, "{} {}", cell + 1, tags.join(" "));
    }
    (text + "$EndElements\n").into_bytes()
}

/// The same in Gmsh's binary form: one square.
fn gmsh_binary() -> Vec<u8> {
    const CORNERS: [[f64; 2]; 4] = [[5.0, 0.0], [8.0, 0.0], [0.0, 8.0], [0.0, 5.0]];
    let mut bytes = b"$MeshFormat\n4.1 1 8\n".to_vec();
    let integers = |bytes: &mut Vec<u8>, values: &[i32]| {
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    };
    let sizes = |bytes: &mut Vec<u8>, values: &[u64]| {
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    };
    integers(&mut bytes, &[1]);
    bytes.extend(b"\n$EndMeshFormat\n$Nodes\n");
    sizes(&mut bytes, &[1, 4, 1, 4]);
    integers(&mut bytes, &[2, 1, 0]);
    sizes(&mut bytes, &[4, 1, 2, 3, 4]);
    for [x, y] in CORNERS {
        bytes.extend([x, y, 0.0].iter().flat_map(|value| value.to_le_bytes()));
    }
    bytes.extend(b"\n$EndNodes\n$Elements\n");
    sizes(&mut bytes, &[1, 1, 1, 1]);
    integers(&mut bytes, &[2, 1, 3]);
    sizes(&mut bytes, &[1, 1, 1, 2, 3, 4]);
    bytes.extend(b"\n$EndElements\n");
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_target_has_something_to_mutate() {
        for target in Target::ALL {
            assert!(target.original(0).len() > 100, "{}", target.name());
        }
    }
}
