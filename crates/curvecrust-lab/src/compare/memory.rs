//! How much memory a computation takes beyond what its process already holds, where the system
//! tells.

use std::fs;

/// What the process holds at the start of a computation.
pub(super) struct Before(u64);

impl Before {
    /// Starts to watch; `None` where the system does not tell.
    pub(super) fn now() -> Option<Self> {
        // Sets the peak back to what is held now: see proc(5), /proc/pid/clear_refs.
        fs::write("/proc/self/clear_refs", "5").ok()?;
        resident("VmRSS:").map(Self)
    }

    /// The most that was held since then beyond that, in bytes.
    pub(super) fn beyond(&self) -> Option<u64> {
        Some(resident("VmHWM:")?.saturating_sub(self.0))
    }
}

/// Resident memory in bytes, now or at the peak.
fn resident(which: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(which))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_held_in_between_is_told() {
        let held = |bytes: usize| std::hint::black_box(vec![1u8; bytes]).len();
        held(1 << 29);
        let Some(before) = Before::now() else {
            eprintln!("skipped: this system does not tell the memory of a process");
            return;
        };
        held(1 << 28);
        // Other tests in this process may let go of some, or take some.
        let mebibytes = before.beyond().unwrap() >> 20;
        assert!((192..512).contains(&mebibytes), "{mebibytes} MiB");
    }
}
