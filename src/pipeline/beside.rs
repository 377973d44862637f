//! Two parts of the way at once, where the machine has a core for each.

use std::sync::Mutex;

use super::{Event, Watch};

/// Runs two parts that do not need one another: side by side if `is_worth_it`, else the first and then the second. Each may
/// tell `watch` of its stages.
pub(super) fn both<A: Send, B: Send>(
    is_worth_it: bool,
    watch: &mut Watch<'_>,
    first: impl FnOnce(&mut Watch<'_>) -> A + Send,
    second: impl FnOnce(&mut Watch<'_>) -> B + Send,
) -> (A, B) {
    if !is_worth_it || rayon::current_num_threads() < 2 {
        return (first(watch), second(watch));
    }
    let ear = Mutex::new(watch);
    // A watch that panicked is asked no more; its panic goes on when both are done.
    let tell = |event: Event| {
        if let Ok(mut watch) = ear.lock() {
            watch(event);
        }
    };
    rayon::join(|| first(&mut |event| tell(event)), || second(&mut |event| tell(event)))
}
