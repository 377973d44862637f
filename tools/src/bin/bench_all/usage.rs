//! What the system tells of processes: the only file that asks it.

use std::time::Duration;

/// What the children that ended used.
pub(crate) struct Usage {
    /// Working time, in the program and in the system for it.
    pub(crate) cpu: Duration,
    /// The most memory that one of them held, kB.
    pub(crate) peak_kb: u64,
}

#[cfg(target_os = "linux")]
mod linux {
    use nix::sched::{CpuSet, sched_getaffinity, sched_setaffinity};
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    use nix::unistd::Pid;

    use super::{Duration, Usage};

    pub(crate) fn of_children() -> Result<Usage, String> {
        let usage = getrusage(UsageWho::RUSAGE_CHILDREN).map_err(|fault| format!("getrusage: {fault}"))?;
        let micros = usage.user_time().num_microseconds() + usage.system_time().num_microseconds();
        Ok(Usage { cpu: Duration::from_micros(micros.unsigned_abs()), peak_kb: usage.max_rss().unsigned_abs() })
    }

    pub(crate) fn keep_to_one_core() -> Result<(), String> {
        let told = |fault| format!("cannot keep to one core: {fault}");
        let this = Pid::from_raw(0);
        let allowed = sched_getaffinity(this).map_err(told)?;
        let mut one = CpuSet::new();
        for core in 0..CpuSet::count() {
            if allowed.is_set(core).map_err(told)? {
                one.set(core).map_err(told)?;
                return sched_setaffinity(this, &one).map_err(told);
            }
        }
        Err("there is no core to keep to".into())
    }
}

#[cfg(not(target_os = "linux"))]
mod linux {
    use super::Usage;

    pub(crate) fn of_children() -> Result<Usage, String> {
        Err("time and memory of other programs are only measured on Linux".into())
    }

    pub(crate) fn keep_to_one_core() -> Result<(), String> {
        Err("keeping to one core works only on Linux".into())
    }
}

pub(crate) use linux::{keep_to_one_core, of_children};
