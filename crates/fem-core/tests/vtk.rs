//! VTK files, read back by an independent parser.

use std::io::{self, Write};

use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{ElementKind, Mesh, MeshParts};
use stickslip_fem_core::vtk::{Field, PvdEntry, VtkError, write_pvd, write_vtu};
use vtkio::model::{Attribute, CellType, DataSet, Piece, UnstructuredGridPiece, VertexNumbers};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn mesh(kind: ElementKind) -> Result<Mesh, Box<dyn std::error::Error>> {
    Ok(Rectangle::uniform([0.1, 1.0 / 3.0], [-2.0, 1.0], [3, 2], kind)?.generate()?)
}

fn read(file: &[u8]) -> Result<UnstructuredGridPiece, Box<dyn std::error::Error>> {
    let vtk = vtkio::Vtk::parse_xml(file).map_err(|error| format!("{error:?}"))?;
    let DataSet::UnstructuredGrid { mut pieces, .. } = vtk.data else {
        return Err("not an unstructured grid".into());
    };
    match pieces.pop() {
        Some(Piece::Inline(piece)) if pieces.is_empty() => Ok(*piece),
        other => Err(format!("not one inline piece: {other:?}").into()),
    }
}

fn values(attributes: &[Attribute], name: &str) -> Option<(usize, Vec<f64>)> {
    attributes.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => {
            let values: Option<Vec<f64>> = array.data.cast_into();
            Some((array.num_comp(), values?))
        }
        _ => None,
    })
}

/// Cells that VTK does not have are written as the quadrilaterals between their nodes, each with the cell's values.
#[test]
fn cells_of_high_order_are_written_in_parts() -> Outcome {
    for kind in [ElementKind::P3, ElementKind::P8] {
        let mesh = mesh(kind)?;
        let parts = kind.order().pow(2);
        let number: Vec<f64> = (0..mesh.element_count()).map(|cell| cell as f64).collect();
        let cell = Field {
            name: "cell",
            components: 1,
            values: &number,
        };
        let mut file = Vec::new();
        write_vtu(&mesh, &[], &[cell], &mut file)?;
        let piece = read(&file)?;
        assert_eq!(
            piece.cells.types,
            vec![CellType::Quad; parts * mesh.element_count()]
        );
        let expected = number
            .iter()
            .flat_map(|&value| vec![value; parts])
            .collect();
        assert_eq!(values(&piece.data.cell, "cell"), Some((1, expected)));
        let VertexNumbers::XML { connectivity, .. } = piece.cells.cell_verts else {
            return Err("connectivity is not in XML form".into());
        };
        // Twice the area of the polygon through the nodes: each part counter-clockwise, together the whole mesh.
        let place = |node: u64| mesh.nodes()[node as usize];
        let twice = |quad: &[u64]| -> f64 {
            let next = quad.iter().cycle().skip(1);
            (quad.iter().zip(next))
                .map(|(&a, &b)| place(a)[0] * place(b)[1] - place(b)[0] * place(a)[1])
                .sum()
        };
        let areas: Vec<f64> = connectivity.chunks(4).map(twice).collect();
        assert!(areas.iter().all(|&area| area > 0.0));
        let [low, high] = mesh.bounding_box();
        let whole = 2.0 * (high[0] - low[0]) * (high[1] - low[1]);
        assert!((areas.iter().sum::<f64>() / whole - 1.0).abs() < 1e-12);
    }
    Ok(())
}

/// The type of cell that VTK has for a kind; none for those that are written as grids of quadrilaterals.
fn whole(kind: ElementKind) -> Option<CellType> {
    match kind {
        ElementKind::T3 => Some(CellType::Triangle),
        ElementKind::T6 => Some(CellType::QuadraticTriangle),
        ElementKind::Q4 => Some(CellType::Quad),
        ElementKind::Q8 => Some(CellType::QuadraticQuad),
        ElementKind::Q9 => Some(CellType::BiquadraticQuad),
        ElementKind::P1
        | ElementKind::P2
        | ElementKind::P3
        | ElementKind::P4
        | ElementKind::P5
        | ElementKind::P6
        | ElementKind::P7
        | ElementKind::P8 => None,
    }
}

#[test]
fn every_kind_survives_the_round_trip_to_the_last_bit() -> Outcome {
    for kind in ElementKind::ALL {
        let Some(cell_type) = whole(kind) else {
            continue;
        };
        let mesh = mesh(kind)?;
        let mut file = Vec::new();
        write_vtu(&mesh, &[], &[], &mut file)?;
        let piece = read(&file)?;
        let points: Option<Vec<f64>> = piece.points.cast_into();
        let expected: Vec<f64> = mesh
            .nodes()
            .iter()
            .flat_map(|p| [p[0], p[1], 0.0])
            .collect();
        assert_eq!(points, Some(expected));
        assert_eq!(piece.cells.types, vec![cell_type; mesh.element_count()]);
        let VertexNumbers::XML {
            connectivity,
            offsets,
        } = piece.cells.cell_verts
        else {
            return Err("connectivity is not in XML form".into());
        };
        let nodes: Vec<u64> = mesh.blocks()[0]
            .connectivity
            .iter()
            .map(|&n| n as u64)
            .collect();
        assert_eq!(connectivity, nodes);
        let ends: Vec<u64> = (1..=mesh.element_count())
            .map(|n| (n * kind.nodes()) as u64)
            .collect();
        assert_eq!(offsets, ends);
    }
    Ok(())
}

#[test]
fn fields_of_one_to_nine_components_survive() -> Outcome {
    let mesh = mesh(ElementKind::T6)?;
    // Numbers whose decimal form is long, of both signs and of extreme size.
    let numbers = |count: usize| {
        (0..count)
            .map(|k| (k as f64 - 7.0).sinh() * 1e-3 / 3.0)
            .collect::<Vec<_>>()
    };
    for components in 1..=9 {
        let on_nodes = numbers(components * mesh.nodes().len());
        let on_cells = numbers(components * mesh.element_count());
        let point = Field {
            name: "σ <MPa> & \"more\"",
            components,
            values: &on_nodes,
        };
        let cell = Field {
            name: "cells",
            components,
            values: &on_cells,
        };
        let mut file = Vec::new();
        write_vtu(&mesh, &[point], &[cell], &mut file)?;
        let piece = read(&file)?;
        assert_eq!(
            values(&piece.data.point, point.name),
            Some((components, on_nodes))
        );
        assert_eq!(
            values(&piece.data.cell, "cells"),
            Some((components, on_cells))
        );
    }
    Ok(())
}

#[test]
fn blocks_of_several_kinds_share_one_grid() -> Outcome {
    let mut parts = mesh(ElementKind::Q4)?.into_parts();
    let mut triangles = mesh(ElementKind::T3)?.into_parts();
    let shift = parts.nodes.len();
    parts.nodes.extend(triangles.nodes);
    for block in &mut triangles.blocks {
        block
            .connectivity
            .iter_mut()
            .for_each(|node| *node += shift);
    }
    parts.blocks.extend(triangles.blocks);
    let mesh = Mesh::new(MeshParts {
        nodes: parts.nodes,
        blocks: parts.blocks,
        ..MeshParts::default()
    })?;
    let mut file = Vec::new();
    write_vtu(&mesh, &[], &[], &mut file)?;
    let piece = read(&file)?;
    let mut expected = vec![CellType::Quad; 6];
    expected.extend([CellType::Triangle; 12]);
    assert_eq!(piece.cells.types, expected);
    let VertexNumbers::XML { offsets, .. } = piece.cells.cell_verts else {
        return Err("connectivity is not in XML form".into());
    };
    assert_eq!((offsets[5], offsets[6], offsets[17]), (24, 27, 60));
    Ok(())
}

#[test]
fn fields_that_do_not_fit_are_refused() -> Outcome {
    let mesh = mesh(ElementKind::Q4)?;
    let zeros = vec![0.0; 12];
    let write = |fields: &[Field]| write_vtu(&mesh, fields, &[], io::sink());
    let field = |name, components| Field {
        name,
        components,
        values: &zeros,
    };
    assert!(write(&[field("u", 1)]).is_ok());
    let short = write(&[field("u", 2)]);
    assert!(matches!(
        short,
        Err(VtkError::Length {
            found: 12,
            entities: 12,
            expected: 24,
            ..
        })
    ));
    for components in [0, 10] {
        assert!(matches!(
            write(&[field("u", components)]),
            Err(VtkError::Components { .. })
        ));
    }
    assert!(matches!(
        write(&[field("u", 1), field("u", 1)]),
        Err(VtkError::Duplicate { .. })
    ));
    for name in ["", "a\nb", "\0"] {
        assert!(matches!(
            write(&[field(name, 1)]),
            Err(VtkError::Name { .. })
        ));
    }
    Ok(())
}

#[test]
fn a_full_disk_is_reported() -> Outcome {
    struct Full;
    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    assert!(matches!(
        write_vtu(&mesh(ElementKind::Q4)?, &[], &[], Full),
        Err(VtkError::Io(_))
    ));
    Ok(())
}

#[test]
fn collections_list_files_with_times() -> Outcome {
    let entry = |time, part, file: &str| PvdEntry {
        time,
        part,
        file: file.to_owned(),
    };
    let mut file = Vec::new();
    write_pvd(
        &[entry(0.0, 0, "a.vtu"), entry(0.1, 1, "b&c.vtu")],
        &mut file,
    )?;
    let text = String::from_utf8(file)?;
    assert!(text.contains("<DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"a.vtu\"/>"));
    assert!(
        text.contains("<DataSet timestep=\"0.1\" group=\"\" part=\"1\" file=\"b&amp;c.vtu\"/>")
    );
    assert!(matches!(
        write_pvd(&[entry(f64::NAN, 0, "a")], io::sink()),
        Err(VtkError::Time { .. })
    ));
    assert!(matches!(
        write_pvd(&[entry(0.0, 0, "a\tb")], io::sink()),
        Err(VtkError::Name { .. })
    ));
    Ok(())
}
