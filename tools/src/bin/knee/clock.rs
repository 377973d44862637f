//! The time that this thread works, not what it waits for others.

/// Counts from its start.
pub(crate) struct Clock(f64);

impl Clock {
    pub(crate) fn start() -> Self {
        Self(now())
    }

    /// Milliseconds since the start or the last call.
    pub(crate) fn lap(&mut self) -> f64 {
        let now = now();
        let lap = 1e3 * (now - self.0);
        self.0 = now;
        lap
    }
}

/// Seconds that this thread has been on a processor.
#[cfg(target_os = "linux")]
fn now() -> f64 {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_THREAD_CPUTIME_ID)
        .map_or(f64::NAN, |time| time.tv_sec() as f64 + 1e-9 * time.tv_nsec() as f64)
}

/// Seconds on the wall.
#[cfg(not(target_os = "linux"))]
fn now() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}
