//! The meshes of bodies for other programs: `meshes/BODY.msh` of Gmsh and `meshes/BODY.inp` of Abaqus and CalculiX, in the unit of lengths of
//! the results, with edges and points as sets.

use stickslip_mesh_files::{write_inp, write_msh};

use super::names::FileNames;
use super::vtk_files::in_display_units;
use super::{File, FileNote, OutputError};
use stickslip_results::Results;

/// All meshes, and a line about them; nothing unless the scene asks.
///
/// # Errors
/// [`OutputError::Mesh`], [`OutputError::MeshFile`] for cells that neither format has.
pub(super) fn files(results: &Results) -> Result<(Vec<File>, Option<FileNote>), OutputError> {
    let mut files = Vec::new();
    if !results.meshes {
        return Ok((files, None));
    }
    let mut names = FileNames::default();
    for body in &results.bodies {
        let stem = names.unique(&body.name);
        let Some(mesh) = &body.mesh else { continue };
        let shown = in_display_units(mesh, results).map_err(|cause| OutputError::Mesh {
            body: body.name.clone(),
            cause,
        })?;
        let refused = |cause| OutputError::MeshFile {
            body: body.name.clone(),
            cause,
        };
        let unit = results.units.length.name;
        // The format begins with its own section.
        let gmsh = write_msh(&shown).map_err(refused)?.replacen(
            "$EndMeshFormat\n",
            &format!("$EndMeshFormat\n$Comments\ncoordinates in {unit}\n$EndComments\n"),
            1,
        );
        files.push((format!("meshes/{stem}.msh"), gmsh.into_bytes()));
        // Cells with nodes inside exist in Gmsh only.
        if let Ok(abaqus) = write_inp(&shown, results.problem.plane) {
            let text = format!("** coordinates in {unit}\n{abaqus}");
            files.push((format!("meshes/{stem}.inp"), text.into_bytes()));
        }
    }
    let note = FileNote::new(
        "meshes/*.msh, meshes/*.inp",
        format!(
            "meshes with their sets for Gmsh, Abaqus and CalculiX, in {}; an .inp is left out where Abaqus has no such cells",
            results.units.length.name
        ),
    );
    Ok((files, Some(note)))
}
