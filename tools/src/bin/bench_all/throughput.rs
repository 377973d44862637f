//! Many photographs in one call: how many a second, and how much memory that takes, beside what single runs promise.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::measured::Job;
use crate::ours::Ours;
use crate::rounds::{Outcome, rounds};
use crate::table::{Table, number};
use crate::targets::Bench;

/// How many photographs one call converts; in a hurry fewer.
const MANY: usize = 200;
const MANY_QUICK: usize = 24;
/// Photographs in work at once whose memory is measured, whatever the cores.
const AT_ONCE: [usize; 4] = [1, 2, 4, 8];
/// A call is to reach at least this share of what single runs promise.
const WANTED: f64 = 0.95;

/// Photographs a second on one core and on all, beside a shell loop over potrace and vtracer.
pub(crate) fn throughput(bench: &Bench<'_>) -> Table {
    let many = if bench.args.quick { MANY_QUICK } else { MANY };
    let about = format!(
        "{many} photographs of 12 megapixels in one call, each with a core to itself. *Promised* is what a single run on \
         one core makes in a second, times the cores; *reached* is the share of it that the call makes, wanted {WANTED} at \
         least. It may be above 1, as one call starts once and reuses its memory. Of vtracer one photograph is measured. The \
         last rows are memory: one process in which so many threads make two pages each at once, as a call does on a \
         machine of so many cores."
    );
    let head = [
        "work",
        "cores",
        "ms",
        "CPU ms",
        "MB",
        "photographs a second",
        "a second and core",
        "promised",
        "reached",
        "met",
    ];
    let mut table = Table::new("Throughput", about, &head);
    let picture = bench.inputs.file("photo-12.jpg");
    let pictures = match copies(bench.ours, &picture, many) {
        Ok(pictures) => pictures,
        Err(fault) => {
            eprintln!("throughput: {fault}");
            return table;
        }
    };
    let all_cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let single = bench.ours.job("one photograph", &picture, "page.svg", &[]);
    let call = call(bench.ours, &pictures);
    let potrace = bench.peers.potrace_loop(&pictures, bench.ours);
    let jobs: Vec<Job> = [single, call].into_iter().chain(potrace).collect();
    let mut alone = None;
    let mut row = |outcome: &Outcome, cores: usize, photographs: usize, promised: Option<f64>| {
        let a_second = outcome.median(|run| Some(photographs as f64 * 1e3 / run.wall));
        let of_core = a_second.map(|a_second| a_second / cores as f64);
        let reached = a_second.zip(promised).map(|(is, promised)| is / promised);
        let met = reached.map_or("", |share| if share >= WANTED { "yes" } else { "no" });
        let mut cells = vec![outcome.name.clone(), cores.to_string()];
        let numbers = [outcome.wall(), outcome.cpu(), outcome.peak(), a_second, of_core, promised, reached];
        cells.extend(numbers.map(number));
        cells.push(met.into());
        table.rows.push(cells);
    };
    for (cores, one_core) in [(1, true), (all_cores, false)] {
        let outcomes = rounds(&jobs, bench.setting(one_core));
        // on one core: the same for the promise on all cores
        alone = alone.or_else(|| outcomes.first().and_then(Outcome::wall));
        for outcome in outcomes.iter().skip(1) {
            let promised = alone.filter(|_| outcome.name == CALL).map(|ms| cores as f64 * 1e3 / ms);
            row(outcome, cores, many, promised);
        }
    }
    // It takes a minute, and one core in any case.
    let vtracer: Vec<Job> =
        bench.peers.vtracer(&picture, bench.ours).filter(|_| !bench.args.quick).into_iter().collect();
    rounds(&vtracer, bench.setting(true)).iter().for_each(|outcome| row(outcome, 1, 1, None));
    let at_once = AT_ONCE.map(|count| Job::new(&format!("{count} at once"), crate::at_once::command(&picture, count)));
    for (outcome, count) in rounds(&at_once, bench.setting(false)).iter().zip(AT_ONCE) {
        row(outcome, all_cores.min(count), count * crate::at_once::EACH, None);
    }
    table
}

/// What one call with all photographs is called.
pub(crate) const CALL: &str = "tactograph convert, all in one call";

/// The photograph under so many names.
fn copies(ours: &Ours, picture: &PathBuf, many: usize) -> Result<Vec<PathBuf>, String> {
    let folder = ours.page("many");
    std::fs::create_dir_all(&folder).map_err(|fault| format!("{}: {fault}", folder.display()))?;
    let copy = |number: usize| {
        let file = folder.join(format!("photo-{number}.jpg"));
        if !file.is_file() {
            std::fs::hard_link(picture, &file)
                .or_else(|_| std::fs::copy(picture, &file).map(drop))
                .map_err(|fault| format!("{}: {fault}", file.display()))?;
        }
        Ok(file)
    };
    (1..=many).map(copy).collect()
}

fn call(ours: &Ours, pictures: &[PathBuf]) -> Job {
    let words = ["convert", "--quiet", "--force", "--out-dir"].map(OsString::from).into_iter();
    let pages = [ours.page("many-pages").into_os_string()];
    ours.command(CALL, words.chain(pages).chain(pictures.iter().map(|file| file.clone().into_os_string())))
}
