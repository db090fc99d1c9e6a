//! Memory that the control groups of Linux leave to this process, as containers set it.

use std::fs;
use std::path::{Path, PathBuf};

/// Names of the files of one version of control groups.
struct Files {
    limit: &'static str,
    used: &'static str,
    /// Lines of `memory.stat` with what is used for files and given back when memory is short.
    cache: [&'static str; 2],
}

const VERSION_1: Files = Files {
    limit: "memory.limit_in_bytes",
    used: "memory.usage_in_bytes",
    cache: ["total_active_file", "total_inactive_file"],
};

const VERSION_2: Files =
    Files { limit: "memory.max", used: "memory.current", cache: ["active_file", "inactive_file"] };

/// Version 1 states no limit as the largest multiple of a page; no machine has so much.
const NO_LIMIT: u64 = 1 << 62;

/// Bytes that the groups of this process leave it, the least of all levels above it; `None`
/// where none sets a limit. Swapping is not counted on.
pub(crate) fn memory_left() -> Option<u64> {
    left_below(Path::new("/"))
}

/// Memory left to the groups of a system whose files lie in `root`.
fn left_below(root: &Path) -> Option<u64> {
    let groups = fs::read_to_string(root.join("proc/self/cgroup")).ok()?;
    let mounts = fs::read_to_string(root.join("proc/self/mountinfo")).ok()?;
    let mut least = None;
    for (files, group) in groups.lines().filter_map(group_of_memory) {
        let Some((mount, folder)) = mounts.lines().find_map(|line| mounted(line, files, group))
        else {
            continue;
        };
        let mount = root.join(mount);
        let top = mount.as_path();
        let folder = top.join(folder);
        let levels = folder.ancestors().take_while(|level| level.starts_with(top));
        least = least.into_iter().chain(levels.filter_map(|level| left(level, files))).min();
    }
    least
}

/// The group's path in a line of `/proc/self/cgroup` like `4:memory:/a/b`, or `0::/a/b` for
/// version 2; `None` for lines of other controllers.
fn group_of_memory(line: &str) -> Option<(&'static Files, &str)> {
    let mut parts = line.splitn(3, ':');
    let (number, controllers, group) = (parts.next()?, parts.next()?, parts.next()?);
    if number == "0" && controllers.is_empty() {
        return Some((&VERSION_2, group));
    }
    controllers.split(',').any(|controller| controller == "memory").then_some((&VERSION_1, group))
}

/// The place where a line of `/proc/self/mountinfo` mounts the hierarchy of a group, and the
/// group's folder in it, both relative; `None` if it mounts something else.
///
/// A container may see no more than a part of the hierarchy, its own group at the top.
fn mounted<'a>(line: &'a str, files: &Files, group: &'a str) -> Option<(&'a str, PathBuf)> {
    let (mount, kind) = line.split_once(" - ")?;
    let mut mount = mount.split(' ').skip(3);
    let (part, at) = (mount.next()?, mount.next()?);
    let mut kind = kind.split(' ');
    let (name, options) = (kind.next()?, kind.nth(1)?);
    let fits = match files.limit == VERSION_1.limit {
        true => name == "cgroup" && options.split(',').any(|option| option == "memory"),
        false => name == "cgroup2",
    };
    let folder = Path::new(group).strip_prefix(part).unwrap_or(Path::new(""));
    fits.then(|| (at.trim_start_matches('/'), folder.to_owned()))
}

/// Bytes that one group leaves; `None` if it sets no limit.
fn left(group: &Path, files: &Files) -> Option<u64> {
    let number = |name: &str| {
        let text = fs::read_to_string(group.join(name)).ok()?;
        text.trim().parse::<u64>().ok()
    };
    let limit = number(files.limit).filter(|&limit| limit < NO_LIMIT)?;
    let stat = fs::read_to_string(group.join("memory.stat")).unwrap_or_default();
    let cache = stat.lines().filter_map(|line| line.split_once(' '));
    let cache = cache.filter(|(name, _)| files.cache.contains(name));
    let cache: u64 = cache.filter_map(|(_, bytes)| bytes.parse::<u64>().ok()).sum();
    let used = number(files.used).unwrap_or(0).saturating_sub(cache);
    Some(limit.saturating_sub(used))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use tempfile::TempDir;

    use super::left_below;

    /// A system's files: paths and what they hold.
    fn system(files: &[(&str, &str)]) -> TempDir {
        let root = TempDir::new().expect("a temporary folder");
        for (path, text) in files {
            let path = root.path().join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, text).expect("a file");
        }
        root
    }

    const V2: &str = "29 23 0:26 / /sys/fs/cgroup rw,nosuid - cgroup2 cgroup2 rw,nsdelegate\n";

    const V1: &str = "31 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n\
        32 31 0:29 / /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n\
        35 31 0:32 / /sys/fs/cgroup/memory rw shared:9 - cgroup cgroup rw,memory\n\
        41 31 0:38 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n";

    #[test]
    fn version_2_takes_the_least_of_all_levels() {
        let group = "sys/fs/cgroup/user.slice/job";
        let files = [
            ("proc/self/cgroup", "0::/user.slice/job\n"),
            ("proc/self/mountinfo", V2),
            ("sys/fs/cgroup/user.slice/memory.max", "max\n"),
            (&format!("{group}/memory.max"), "1000000\n"),
            (&format!("{group}/memory.current"), "600000\n"),
            (&format!("{group}/memory.stat"), "anon 1\nactive_file 70000\ninactive_file 30000\n"),
        ];
        assert_eq!(left_below(system(&files).path()), Some(500_000));
        let above = [&files[..], &[("sys/fs/cgroup/user.slice/memory.max", "300000\n")]].concat();
        assert_eq!(left_below(system(&above).path()), Some(300_000));
        let used = format!("{group}/memory.current");
        let full = [&files[..], &[(&*used, "9000000\n")]].concat();
        assert_eq!(left_below(system(&full).path()), Some(0));
    }

    #[test]
    fn version_1_is_the_controller_of_memory() {
        let files = [
            ("proc/self/cgroup", "4:memory:/docker/ab\n3:cpu,cpuacct:/\n0::/\n"),
            ("proc/self/mountinfo", V1),
            ("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n"),
            ("sys/fs/cgroup/memory/docker/ab/memory.limit_in_bytes", "1000000\n"),
            ("sys/fs/cgroup/memory/docker/ab/memory.usage_in_bytes", "400000\n"),
            (
                "sys/fs/cgroup/memory/docker/ab/memory.stat",
                "active_file 9\ntotal_active_file 100000\ntotal_inactive_file 50000\n",
            ),
        ];
        assert_eq!(left_below(system(&files).path()), Some(750_000));
    }

    /// The group is the top of what is mounted, and its path is not there.
    #[test]
    fn a_container_sees_its_own_group_at_the_top() {
        let mount = V1.replace("0:32 / ", "0:32 /docker/ab ");
        let files = [
            ("proc/self/cgroup", "4:memory:/docker/ab/inner\n"),
            ("proc/self/mountinfo", &mount),
            ("sys/fs/cgroup/memory/memory.limit_in_bytes", "1000000\n"),
            ("sys/fs/cgroup/memory/inner/memory.limit_in_bytes", "800000\n"),
        ];
        assert_eq!(left_below(system(&files).path()), Some(800_000));
        let outside = [&files[..], &[("proc/self/cgroup", "4:memory:/elsewhere\n")]].concat();
        assert_eq!(left_below(system(&outside).path()), Some(1_000_000));
    }

    #[test]
    fn without_limits_or_groups_nothing_is_known() {
        let none = [("proc/self/cgroup", "0::/\n"), ("proc/self/mountinfo", V2)];
        assert_eq!(left_below(system(&none).path()), None);
        let no_limit = "9223372036854771712\n";
        let most = [
            ("proc/self/cgroup", "4:memory:/\n"),
            ("proc/self/mountinfo", V1),
            ("sys/fs/cgroup/memory/memory.limit_in_bytes", no_limit),
        ];
        assert_eq!(left_below(system(&most).path()), None);
        assert_eq!(left_below(system(&[]).path()), None);
        let broken = [("proc/self/cgroup", "x\n::\n4:memory\n"), ("proc/self/mountinfo", " - \n-")];
        assert_eq!(left_below(system(&broken).path()), None);
    }
}
