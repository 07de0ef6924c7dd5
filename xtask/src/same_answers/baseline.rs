//! The command of an earlier revision.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::publish::{TaskError, cargo_build};

/// Builds the command of `revision` in a worktree below `work`, with build products of its own, and returns its path.
pub(super) fn build(root: &Path, work: &Path, revision: &str) -> Result<PathBuf, TaskError> {
    let commit = format!("{revision}^{{commit}}");
    let commit = asked(git(root).args(["rev-parse", "--verify", &commit]))
        .map_err(|cause| format!("{cause}the history may be shallow: fetch {revision}"))?;
    let tree = work.join("tree");
    if !tree.join("Cargo.toml").is_file() {
        // The worktree may be known still, though its folder was deleted with others.
        asked(
            git(root)
                .args(["worktree", "add", "--force", "--detach"])
                .arg(&tree)
                .arg(commit.trim()),
        )?;
    }
    asked(git(&tree).args(["checkout", "--force", "--detach", commit.trim()]))?;
    let products = work.join("build");
    let status = cargo_build(&tree, &products, &["--package", crate::COMMAND])?;
    if !status.success() {
        return Err(format!("the command of {revision} cannot be built: {status}").into());
    }
    Ok(products.join("release").join(crate::COMMAND))
}

fn git(folder: &Path) -> Command {
    let mut git = Command::new("git");
    git.current_dir(folder);
    git
}

/// What a command prints; its complaint if it fails.
fn asked(command: &mut Command) -> Result<String, TaskError> {
    let output = command.output()?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned().into())
    }
}
