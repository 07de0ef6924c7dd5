//! Arguments that several commands share.

use std::path::PathBuf;

use clap::Args;
use stickslip_scene::Scene;
use stickslip_scene::diagnostic::SceneError;

use super::memory;

/// A scene file and overrides.
#[derive(Debug, Args)]
pub(super) struct SceneArguments {
    /// Scene file: TOML, or JSON if the name ends in .json
    pub(super) scene: PathBuf,
    /// Set any key of the scene, for example --set mesh.spacing="2.25 deg" or --set contacts.0.friction.coulomb.mu=0.15
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) overrides: Vec<String>,
}

impl SceneArguments {
    pub(super) fn read(&self) -> Result<Scene, SceneError> {
        Scene::from_file(&self.scene, &self.overrides, memory::host())
    }
}
