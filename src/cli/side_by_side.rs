//! Several jobs at once, their results in the order of the jobs.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// What the main thread has on most systems (Rust gives others 2 MB), so that a picture that can be converted alone can
/// also be converted beside others.
const STACK_BYTES: usize = 8 << 20;

/// The job stopped through an error in the program itself; `panics` knows the details.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Panicked;

/// How many jobs to run at once: as many as the machine does side by side, but not more than there are jobs.
pub(super) fn workers(jobs: usize) -> usize {
    available().min(jobs)
}

fn available() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// Its share of the cores for one of so many workers, to which the calling thread belongs: with one core a worker,
/// nothing is handed from thread to thread. `None` (the cores are shared as rayon likes) where the system gives no
/// thread.
fn cores(workers: usize) -> Option<ThreadPool> {
    // of one worker as many as there are, or as RAYON_NUM_THREADS says
    let threads = if workers > 1 { (available() / workers).max(1) } else { 0 };
    ThreadPoolBuilder::new().num_threads(threads).use_current_thread().build().ok()
}

/// Runs `job(0)` to `job(count - 1)` on up to `workers` threads, which take the jobs in order from a shared counter.
///
/// On the calling thread, `finished` is called for each job as it ends, in any order, and `result` with each job's
/// result as soon as all before it are in: 0, 1, 2 and so on. A job that panics becomes [`Panicked`]; the others are
/// not touched.
pub(super) fn run<T: Send>(
    count: usize,
    workers: usize,
    job: impl Fn(usize) -> T + Sync,
    mut finished: impl FnMut(),
    result: impl FnMut(usize, Result<T, Panicked>),
) {
    // A job shares with others only what it cannot leave half-changed (settings, a font list made once), so going on
    // after a panic is safe.
    let guarded = |index: usize| catch_unwind(AssertUnwindSafe(|| job(index))).map_err(|_| Panicked);
    let next = AtomicUsize::new(0);
    let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < count);
    let mut in_order = InOrder { waiting: BTreeMap::new(), next: 0, result };
    let mut collect = |(index, outcome)| {
        finished();
        in_order.add(index, outcome);
    };
    thread::scope(|scope| {
        let (send, receive) = mpsc::channel();
        let mut started = 0;
        for _ in 0..if workers > 1 { workers } else { 0 } {
            let (send, take, guarded) = (send.clone(), &take, &guarded);
            let work = move || {
                let _cores = cores(workers);
                while let Some(index) = take() {
                    if send.send((index, guarded(index))).is_err() {
                        return; // the receiver is gone
                    }
                }
            };
            let builder = thread::Builder::new().name("picture".into()).stack_size(STACK_BYTES);
            started += usize::from(builder.spawn_scoped(scope, work).is_ok());
        }
        drop(send);
        if started == 0 {
            // One worker, or a system that gives no thread: do it here.
            let _cores = cores(1);
            while let Some(index) = take() {
                collect((index, guarded(index)));
            }
        }
        receive.into_iter().for_each(collect);
    });
}

/// Results that come in any order, handed on in the order of their jobs.
struct InOrder<T, F> {
    /// Results of jobs after one that is not in yet.
    waiting: BTreeMap<usize, T>,
    /// The job whose result is handed on next.
    next: usize,
    result: F,
}

impl<T, F: FnMut(usize, T)> InOrder<T, F> {
    /// Takes the result of a job, and hands on all results whose turn it is.
    fn add(&mut self, index: usize, outcome: T) {
        self.waiting.insert(index, outcome);
        while let Some(outcome) = self.waiting.remove(&self.next) {
            (self.result)(self.next, outcome);
            self.next += 1;
        }
    }
}

#[cfg(test)]
mod tests;
