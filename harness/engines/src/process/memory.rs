//! How much memory a group of processes holds.
//!
//! A limit of the system would count address space, of which some run-time systems reserve far more than they use; what
//! counts here is what is resident, of the whole group.

/// The resident size of a group of processes in bytes; `None` where the system does not tell.
///
/// Basis: linux: proc_pid_stat(5), fields 5 (process group) and 24 (resident set size in pages).
#[cfg(target_os = "linux")]
pub(super) fn resident(group: u32) -> Option<u64> {
    let processes = std::fs::read_dir("/proc").ok()?;
    let mut total = 0;
    for process in processes.flatten() {
        // One that has ended meanwhile holds nothing.
        if !process.file_name().as_encoded_bytes()[0].is_ascii_digit() {
            continue;
        }
        if let Ok(status) = std::fs::read_to_string(process.path().join("stat")) {
            total += pages(&status, group).unwrap_or(0) * PAGE;
        }
    }
    Some(total)
}

/// As above; other systems are not asked.
#[cfg(not(target_os = "linux"))]
pub(super) fn resident(_group: u32) -> Option<u64> {
    None
}

/// The smallest page that Linux has; where pages are larger, the limit is looser than it says.
#[cfg(target_os = "linux")]
const PAGE: u64 = 4096;

/// The resident pages of a process, if it belongs to this group.
#[cfg(target_os = "linux")]
fn pages(status: &str, group: u32) -> Option<u64> {
    // The name of the program stands in parentheses and may hold anything.
    let (_, fields) = status.rsplit_once(')')?;
    let mut fields = fields.split_ascii_whitespace();
    let own: u32 = fields.nth(2)?.parse().ok()?;
    if own != group {
        return None;
    }
    fields.nth(18)?.parse().ok()
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::{pages, resident};

    #[test]
    fn the_pages_of_a_group_are_counted_whatever_its_program_is_called() {
        let status = "17 (a) 1 (b) S 1 42 42 0 -1 4194560 100 0 0 0 1 2 0 0 20 0 1 0 500 1000000 321 18446744073709551615";
        assert_eq!(pages(status, 42), Some(321));
        assert_eq!(pages(status, 43), None);
        assert_eq!(pages("", 42), None);
    }

    #[test]
    fn a_group_that_nobody_belongs_to_holds_nothing() {
        assert_eq!(resident(u32::MAX), Some(0));
    }
}
