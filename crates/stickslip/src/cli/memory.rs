//! The memory that there is for a command.

use std::fs;
use std::path::Path;

use stickslip_scene::host::Host;
use stickslip_scene::limits::Limits;

use crate::host::HOST;

/// The machine with the memory that is free now: of the machine, of the control groups that the process is in, and below its own limit of address space.
/// No limit on systems that do not say.
pub(super) fn host() -> Host {
    let text = |path: &str| fs::read_to_string(path).unwrap_or_default();
    let machine = of_machine(&text("/proc/meminfo"));
    let own = of_process(&text("/proc/self/limits"), &text("/proc/self/statm"));
    let groups = of_groups(&text("/proc/self/cgroup"), Path::new("/sys/fs/cgroup"));
    let memory = [machine, own, groups].into_iter().flatten().min();
    Host {
        limits: memory.map_or(Limits::NONE, |memory| Limits { memory }),
        ..HOST
    }
}

/// `MemAvailable` and free swap `[byte]`.
fn of_machine(meminfo: &str) -> Option<u64> {
    let entry = |name: &str| {
        let line = meminfo.lines().find_map(|line| line.strip_prefix(name))?;
        let kilobytes: u64 = line.split_whitespace().next()?.parse().ok()?;
        Some(1024 * kilobytes)
    };
    Some(entry("MemAvailable:")? + entry("SwapFree:").unwrap_or(0))
}

/// What `ulimit -v` leaves `[byte]`.
fn of_process(limits: &str, pages: &str) -> Option<u64> {
    const PAGE: u64 = 4096;
    let line = limits
        .lines()
        .find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    let used: u64 = pages.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(PAGE * used))
}

/// The least that a control group around the process leaves `[byte]`, of either version.
fn of_groups(groups: &str, root: &Path) -> Option<u64> {
    let left = |folder: &Path, most: &str, used: &str, given_back: &str| {
        let number = |name: &str| {
            let text = fs::read_to_string(folder.join(name)).ok()?;
            text.trim().parse::<u64>().ok()
        };
        // Pages of files that are read count as used, and are given back.
        let statistics = fs::read_to_string(folder.join("memory.stat")).unwrap_or_default();
        let cached = statistics.lines().find_map(|line| {
            let number = line.strip_prefix(given_back)?.strip_prefix(' ')?;
            number.parse::<u64>().ok()
        });
        let free = number(most)?.saturating_sub(number(used)?);
        Some(free + cached.unwrap_or(0))
    };
    let mut least = None;
    for line in groups.lines() {
        let mut parts = line.splitn(3, ':').skip(1);
        let (Some(controllers), Some(path)) = (parts.next(), parts.next()) else {
            continue;
        };
        let first = controllers.is_empty();
        if !first && !controllers.split(',').any(|one| one == "memory") {
            continue;
        }
        let base = if first {
            root.to_owned()
        } else {
            root.join("memory")
        };
        // Inside of a container the path may be one of the host, and the root is the container's own.
        let own = path.trim_start_matches('/');
        for folder in Path::new(own).ancestors() {
            let folder = base.join(folder);
            let found = if first {
                left(&folder, "memory.max", "memory.current", "inactive_file")
            } else {
                left(
                    &folder,
                    "memory.limit_in_bytes",
                    "memory.usage_in_bytes",
                    "total_inactive_file",
                )
            };
            least = [least, found].into_iter().flatten().min();
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_system_says_what_is_free() {
        let meminfo = "MemTotal:  16 kB\nMemAvailable:    8 kB\nSwapFree:  1 kB\n";
        assert_eq!(of_machine(meminfo), Some(9216));
        assert_eq!(of_machine(""), None);
        let limits = "Limit  Soft Limit\nMax address space         409600  unlimited  bytes\n";
        assert_eq!(of_process(limits, "40 3 1"), Some(409_600 - 40 * 4096));
        assert_eq!(
            of_process("Max address space  unlimited unlimited bytes", "40"),
            None
        );
    }

    #[test]
    fn the_tightest_control_group_counts() {
        let root = tempfile::tempdir().unwrap();
        let inner = root.path().join("a/b");
        fs::create_dir_all(&inner).unwrap();
        let put = |folder: &Path, most: &str, used: &str| {
            fs::write(folder.join("memory.max"), most).unwrap();
            fs::write(folder.join("memory.current"), used).unwrap();
        };
        put(&inner, "max\n", "10\n");
        assert_eq!(of_groups("0::/a/b\n", root.path()), None);
        put(&root.path().join("a"), "1000\n", "400\n");
        fs::write(root.path().join("a/memory.stat"), "inactive_file 50\n").unwrap();
        assert_eq!(of_groups("0::/a/b\n", root.path()), Some(650));
    }
}
