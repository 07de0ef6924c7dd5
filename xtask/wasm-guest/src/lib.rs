//! One scene inside a WebAssembly module: what `cargo xtask wasm` runs there, and natively beside it.
//!
//! | export | result |
//! | --- | --- |
//! | [`initialise`] | to be called once, before all others |
//! | [`text_start`], [`text_length`] | names of the friction laws, one a line, as UTF-8 in the module's memory |
//! | [`solve`] | how many numbers the answer of the scene has; 0 if it has none |
//! | [`number`] | one of them |

#![allow(
    unsafe_code,
    reason = "exports need no_mangle, which is unsafe because two symbols of one name would be one; these names occur once"
)]

use std::path::Path;
use std::sync::OnceLock;

use stickslip_ladder::run;
use stickslip_scene::{Format, Scene};

const SCENE: &str = include_str!("../../../scenes/pin-loaded-aluminium-mesh-a.toml");

static LAWS: OnceLock<String> = OnceLock::new();
static NUMBERS: OnceLock<Vec<f64>> = OnceLock::new();

/// Lists the names of the registered friction laws, one a line, in alphabetical order.
pub fn laws() -> &'static str {
    LAWS.get_or_init(|| {
        let mut names: Vec<&str> = stickslip_friction::laws().map(|law| law.name).collect();
        names.sort_unstable();
        names.join("\n")
    })
}

/// Solves the scene: pressure, shear and hoop stress `[MPa]` at each node of each edge, step after step; nothing if it has no answer.
pub fn numbers() -> &'static [f64] {
    NUMBERS.get_or_init(|| {
        let overrides: [&str; 0] = [];
        let scene = Scene::from_text(SCENE, Format::Toml, "scene", Path::new(""), &overrides);
        let results = scene.ok().and_then(|scene| run(&scene, &mut |_| {}).ok());
        let steps = results.into_iter().flat_map(|results| results.steps);
        let rows = steps.flat_map(|step| step.edges).flat_map(|edge| edge.rows);
        rows.flat_map(|row| [row.pressure, row.shear, row.sigma_tangential])
            .collect()
    })
}

#[cfg(target_family = "wasm")]
unsafe extern "C" {
    /// Made by the linker. A module that does not name it runs all constructors again at every call of an export.
    fn __wasm_call_ctors();
}

/// Runs the constructors, in which laws register themselves; elsewhere they have run before `main`.
#[unsafe(no_mangle)]
pub extern "C" fn initialise() {
    #[cfg(target_family = "wasm")]
    // SAFETY: the function takes and returns nothing, and the host calls it once, before all other exports.
    unsafe {
        __wasm_call_ctors();
    }
}

/// Where the names of the laws begin in memory.
#[unsafe(no_mangle)]
pub extern "C" fn text_start() -> *const u8 {
    laws().as_ptr()
}

/// How many bytes the names of the laws have.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    laws().len()
}

/// Solves the scene, and returns how many numbers its answer has.
#[unsafe(no_mangle)]
pub extern "C" fn solve() -> usize {
    numbers().len()
}

/// Returns the number at `index`, not-a-number beyond the last.
#[unsafe(no_mangle)]
pub extern "C" fn number(index: usize) -> f64 {
    numbers().get(index).copied().unwrap_or(f64::NAN)
}
