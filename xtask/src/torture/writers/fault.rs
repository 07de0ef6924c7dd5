//! Faults that `strace` injects at system calls, and the calls that a command makes.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use super::command::{Writer, program, started};
use crate::torture::draw::Draw;

/// Calls on files and their descriptors at which a fault may be.
const CALLS: &str = "openat,read,write,fsync,fdatasync,ftruncate,lseek,mkdir,rename,renameat,renameat2,link,linkat,unlink,unlinkat,\
                     rmdir,flock,getdents64,statx,newfstatat,fstat,readlink,readlinkat,fcntl,access,faccessat2";
const KILL: &str = "signal=SIGKILL";
const FAULTS: [&str; 4] = ["error=ENOSPC", "error=EIO", "error=EACCES", KILL];

/// A system call of a process: the `number`th of its name on its thread.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Call {
    pub(super) name: String,
    number: usize,
}

/// A fault at a call.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    pub(super) call: Call,
    pub(super) kind: &'static str,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Call { name, number } = &self.call;
        write!(f, "{} at {name} {number}", self.kind)
    }
}

/// What keeps faults from being injected here.
pub(super) fn lacks() -> Option<String> {
    let tried = Command::new("strace")
        .args(["-f", "-o", "/dev/null", "-e", "trace=openat"])
        .args(["-e", "inject=openat:error=EIO", "true"])
        .stdin(Stdio::null())
        .output();
    match tried {
        // The loader of `true` cannot go on.
        Ok(output) if output.status.code() == Some(127) => None,
        Ok(output) => Some(format!(
            "`strace` cannot inject faults here: {}",
            String::from_utf8_lossy(&output.stderr)
        )),
        Err(cause) => Some(format!(
            "`strace` cannot be started ({cause}); install it, such as by `apt-get install strace`"
        )),
    }
}

/// The calls that `writer` makes in `folder` from the one on that opens the file it reads.
pub(super) fn calls(writer: &Writer, folder: &Path, log: &Path) -> io::Result<Vec<Call>> {
    let output = started(
        Command::new("strace")
            .arg("-f")
            .arg("-o")
            .arg(log)
            .args(["-e", &format!("trace={CALLS}")])
            .arg(program()?)
            .args(writer.arguments()),
        folder,
    )?;
    if !output.status.success() {
        return Err(io::Error::other(super::said(&output)));
    }
    Ok(listed(&fs::read_to_string(log)?, writer.reads()))
}

/// The calls in what `strace -f` wrote, from the first on that names `file`.
fn listed(log: &str, file: &str) -> Vec<Call> {
    let mut numbers: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut calls: Vec<Call> = Vec::new();
    let mut earlier = None;
    for line in log.lines() {
        let Some((thread, rest)) = line.split_once(' ') else {
            continue;
        };
        let Some((name, arguments)) = rest.trim_start().split_once('(') else {
            continue;
        };
        // Others are signals, ends, and the second halves of calls.
        if !name.bytes().all(|byte| byte.is_ascii_alphanumeric()) {
            continue;
        }
        let number = numbers.entry((thread, name)).or_default();
        *number += 1;
        let call = Call {
            name: name.to_owned(),
            number: *number,
        };
        if earlier.is_none() && arguments.contains(&format!("\"{file}")) {
            earlier = Some(std::mem::take(&mut calls));
        }
        if !calls.contains(&call) {
            calls.push(call);
        }
    }
    // A fault is injected on every thread, and must not be at a call of the loader.
    let earlier = earlier.unwrap_or_default();
    calls.retain(|call| !earlier.contains(call));
    calls
}

impl Fault {
    /// The fault of a seed: names of calls are equally likely, and then the calls of that name.
    pub(super) fn of(seed: u64, calls: &[Call]) -> Self {
        let mut draw = Draw::seeded(seed);
        let mut names: Vec<&str> = calls.iter().map(|call| call.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        let name = names[draw.below(names.len())];
        let own: Vec<&Call> = calls.iter().filter(|call| call.name == name).collect();
        Self {
            call: own[draw.below(own.len())].clone(),
            kind: FAULTS[draw.below(FAULTS.len())],
        }
    }

    pub(super) fn is_kill(&self) -> bool {
        self.kind == KILL
    }

    /// Runs the command with the fault.
    pub(super) fn injected(&self, writer: &Writer, folder: &Path) -> io::Result<Output> {
        let Call { name, number } = &self.call;
        started(
            Command::new("strace")
                .args(["-f", "-o", "/dev/null", "-e", &format!("trace={name}")])
                .args(["-e", &format!("inject={name}:{}:when={number}", self.kind)])
                .arg(program()?)
                .args(writer.arguments()),
            folder,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_are_numbered_by_name_and_thread() {
        let log = "7 openat(AT_FDCWD, \"lib.so\", O_RDONLY) = 3\n\
                   8  read(3, \"\"..., 8) = 8\n\
                   7  openat(AT_FDCWD, \"scene.toml\", O_RDONLY <unfinished ...>\n\
                   8  read(3, \"\"..., 8) = 8\n\
                   7  <... openat resumed>) = 4\n\
                   7  +++ exited with 0 +++\n";
        let found = listed(log, "scene.toml");
        let shown: Vec<_> = found
            .iter()
            .map(|call| (call.name.as_str(), call.number))
            .collect();
        assert_eq!(shown, [("openat", 2), ("read", 2)]);
        let late = "7 openat(AT_FDCWD, \"lib.so\") = 3\n7 openat(AT_FDCWD, \"scene.toml\") = 3\n8 openat(AT_FDCWD, \"a\") = 4\n";
        assert_eq!(listed(late, "scene.toml").len(), 1);
    }
}
