//! Files and meshes that are larger than the machine: refused before they are read or made.
#![cfg(target_os = "linux")]

use std::fs;
use std::process::Command;

use tempfile::TempDir;

use super::{SCENE, fails, folder_with, text};

const EXPERIMENT: &str = r#"version = 1
[specimen]
material.isotropic = { young = "70 GPa", poisson = 0.33 }
thickness = "5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "5 mm" }
[grating]
frequency = "2400 1/mm"
[[states]]
name = "up"
"#;

/// The check value at the end of a PNG's chunk.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 * (crc & 1))
        })
    })
}

/// A grey picture of `size` × `size` pixels by its header, without the pixels.
fn picture(size: u32) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let header = [
        &size.to_be_bytes()[..],
        &size.to_be_bytes(),
        &[8, 0, 0, 0, 0],
    ]
    .concat();
    for (kind, data) in [
        (b"IHDR", header),
        (b"IDAT", vec![0x78, 0x9c]),
        (b"IEND", Vec::new()),
    ] {
        file.extend((data.len() as u32).to_be_bytes());
        let chunk = [&kind[..], &data].concat();
        file.extend(&chunk);
        file.extend(crc(&chunk).to_be_bytes());
    }
    file
}

#[test]
fn pictures_of_too_many_pixels_are_refused_by_their_header() {
    let pictures = r#"pictures = { u = "u.png", v = "u.png", pixel = "0.02 mm", top_left = ["-15 mm", "15 mm"], y_axis = "up", carrier = { u = ["6 1/mm", "0 1/mm"], v = ["0 1/mm", "6 1/mm"] } }"#;
    let folder = folder_with("e.toml", &format!("{EXPERIMENT}{pictures}\n"));
    fs::write(folder.path().join("u.png"), picture(900_000)).unwrap();
    let message = fails(folder.path(), &["reduce", "e.toml"]);
    for part in [
        "u.png",
        "900000 x 900000 pixels",
        "of memory",
        "e.toml:",
        "GB are free",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
}

#[test]
fn devices_are_no_tables() {
    let table = r#"table = { file = "/dev/full", scale = "1 mm", y_axis = "up" }"#;
    let folder = folder_with("e.toml", &format!("{EXPERIMENT}{table}\n"));
    let message = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(
        message.contains("'/dev/full'")
            && message.contains("it is a device or a pipe")
            && message.contains("e.toml:"),
        "{message}"
    );
    let message = fails(folder.path(), &["check", "/dev/zero"]);
    assert!(message.contains("it is a device"), "{message}");
    let load = SCENE.replace(
        "force = { direction = [-1, 0], steps = [\"1 kN\", \"2 kN\"] }",
        "",
    ) + "polar_traction = { file = \"/dev/zero\", theta = \"t\", radial = \"r\", shear = \"s\", stress = \"MPa\", steps = [1] }\n";
    let load = load.replace("on = \"plate.left\"", "on = \"plate.hole\"");
    fs::write(folder.path().join("s.toml"), load).unwrap();
    let message = fails(folder.path(), &["check", "s.toml"]);
    assert!(message.contains("it is a device"), "{message}");
}

/// A limit of the shell, so that the machine's own memory does not matter.
#[test]
fn meshes_beyond_the_memory_are_refused() {
    let folder: TempDir = folder_with("pin.toml", SCENE);
    let command = format!(
        "ulimit -v 1500000; exec '{}' check pin.toml --set mesh.spacing='0.2 deg'",
        env!("CARGO_BIN_EXE_stickslip")
    );
    let output = Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", &command])
        .output()
        .unwrap();
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    for part in ["nodes", "of memory", "are free", "mesh.spacing"] {
        assert!(message.contains(part), "{part}: {message}");
    }
}
