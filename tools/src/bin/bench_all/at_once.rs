//! Several photographs in work at once in one process, as many as are asked for: how much memory a call takes on a
//! machine of as many cores, on whatever machine this is.

use std::ffi::OsString;
use std::path::Path;

use rayon::ThreadPoolBuilder;
use tactograph::{Options, Profile};

/// First argument of that process; how many at once and the picture follow.
pub(crate) const MODE: &str = "--at-once";
/// How many pages each thread makes, one after the other.
pub(crate) const EACH: usize = 2;
/// As the program gives to each of its threads.
const STACK_BYTES: usize = 8 << 20;

/// What to run.
pub(crate) fn command(picture: &Path, count: usize) -> Vec<OsString> {
    let this = std::env::current_exe().map_or_else(|_| "bench_all".into(), OsString::from);
    vec![this, MODE.into(), count.to_string().into(), picture.into()]
}

/// Makes pages in so many threads, each with a pool of its own for itself alone.
///
/// # Errors
/// A thread cannot be had, or a page cannot be made.
pub(crate) fn convert(picture: &Path, count: usize) -> Result<(), String> {
    let options = Options::new(Profile::named("swell-a4").map_err(|fault| fault.to_string())?);
    let work = || -> Result<(), String> {
        let pool = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
        let _alone = pool.map_err(|fault| fault.to_string())?;
        for _ in 0..EACH {
            let bytes = std::fs::read(picture).map_err(|fault| format!("{}: {fault}", picture.display()))?;
            let drawing = tactograph::convert(&bytes, &options).map_err(|fault| fault.to_string())?;
            std::hint::black_box(drawing.page.to_svg());
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let spawn = |_| std::thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work);
        let threads: Result<Vec<_>, _> = (0..count).map(spawn).collect();
        let threads = threads.map_err(|fault| fault.to_string())?;
        threads.into_iter().try_for_each(|thread| thread.join().map_err(|_| "a thread panicked".to_owned())?)
    })
}
