//! Many photographs in one call: how many a second, and how much memory that takes, beside what single runs promise.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::measured::Job;
use crate::ours::Ours;
use crate::rounds::{Outcome, Setting, once, rounds};
use crate::table::{Table, number};
use crate::targets::Bench;

/// How many photographs one call converts, and how many the calls that run in rounds; in a hurry fewer.
const MANY: [usize; 2] = [200, 40];
const MANY_QUICK: [usize; 2] = [24, 8];
/// Photographs in work at once whose memory is measured, whatever the cores.
const AT_ONCE: [usize; 4] = [1, 2, 4, 8];
/// A call is to reach at least this share of what single runs promise.
const WANTED: f64 = 0.95;
/// What one call with all photographs is called.
pub(crate) const CALL: &str = "tactograph convert, all in one call";

/// Photographs a second on one core and on all, beside a shell loop over potrace and vtracer.
pub(crate) fn throughput(bench: &Bench<'_>) -> Table {
    let [many, few] = if bench.args.quick { MANY_QUICK } else { MANY };
    let about = format!(
        "Photographs of 12 megapixels, each with a core to itself. A call with {few} of them runs in rounds, and in each \
         round a single run on one core and one on as many as the call has. *Promised* is what the first makes in a \
         second, times the cores; *reached* is the share of it that the call makes in the same round, wanted {WANTED} at \
         least; *to a loop* is how many times as many it makes as the second would, one after the other. What follows \
         runs once: a call with all {many}, a shell loop over {few}, and vtracer with one. The last rows are memory: one \
         process in which so many threads make two pages each at once, as a call does on a machine of so many cores. A call with \
         many photographs takes up to a fifth more than that."
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
        "to a loop",
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
    for (cores, one_core) in [(1, true), (all_cores, false)] {
        table.rows.extend(in_rounds(bench, &pictures[..few], cores, one_core));
        let call = once(&call(bench.ours, CALL, &pictures), one_core);
        table.rows.push(row(&call, cores, many, Shares::default()));
        let potrace = bench.peers.potrace_loop(&pictures[..few], bench.ours).map(|job| once(&job, one_core));
        table.rows.extend(potrace.map(|outcome| row(&outcome, cores, few, Shares::default())));
    }
    // It takes a minute, and one core in any case.
    let vtracer = bench.peers.vtracer(&picture, bench.ours).filter(|_| !bench.args.quick);
    table.rows.extend(vtracer.map(|job| row(&once(&job, true), 1, 1, Shares::default())));
    let at_once = AT_ONCE.map(|count| Job::new(&format!("{count} at once"), crate::at_once::command(&picture, count)));
    for (outcome, count) in rounds(&at_once, bench.setting(false)).iter().zip(AT_ONCE) {
        table.rows.push(row(outcome, all_cores.min(count), count * crate::at_once::EACH, Shares::default()));
    }
    table
}

/// What a call makes beside single runs; nothing of others.
#[derive(Default)]
struct Shares {
    /// Photographs a second.
    promised: Option<f64>,
    /// The share of it.
    reached: Option<f64>,
    /// How many times as many as single runs one after the other.
    to_loop: Option<f64>,
}

/// A call with these photographs, round by round beside single runs of one.
fn in_rounds(bench: &Bench<'_>, pictures: &[PathBuf], cores: usize, one_core: bool) -> Option<Vec<String>> {
    let (of, many) = (cores as f64, pictures.len() as f64);
    let single = || Some(bench.ours.job("one photograph", pictures.first()?, "page.svg", &[]));
    let name = format!("tactograph convert, {many} in one call");
    let jobs = [single()?.on_one_core(), single()?, call(bench.ours, &name, pictures)];
    // all rounds, however long that takes
    let outcomes = rounds(&jobs, Setting { patience: f64::INFINITY, ..bench.setting(one_core) });
    let [alone, single, call] = &outcomes[..] else { return None };
    let shares = Shares {
        promised: alone.median(|run| Some(of * 1e3 / run.wall)),
        reached: call.beside(alone, |call, alone| Some(many * alone.wall / (of * call.wall))),
        to_loop: call.beside(single, |call, single| Some(many * single.wall / call.wall)),
    };
    Some(row(call, cores, pictures.len(), shares))
}

fn row(outcome: &Outcome, cores: usize, photographs: usize, shares: Shares) -> Vec<String> {
    let a_second = outcome.median(|run| Some(photographs as f64 * 1e3 / run.wall));
    let of_core = a_second.map(|a_second| a_second / cores as f64);
    let Shares { promised, reached, to_loop } = shares;
    let met = reached.map_or("", |share| if share >= WANTED { "yes" } else { "no" });
    let mut cells = vec![outcome.name.clone(), cores.to_string()];
    cells.extend([outcome.wall(), outcome.cpu(), outcome.peak(), a_second, of_core, promised, reached].map(number));
    cells.extend([met.to_owned(), number(to_loop)]);
    cells
}

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

fn call(ours: &Ours, name: &str, pictures: &[PathBuf]) -> Job {
    let words = ["convert", "--quiet", "--force", "--out-dir"].map(OsString::from).into_iter();
    let pages = [ours.page("many-pages").into_os_string()];
    ours.command(name, words.chain(pages).chain(pictures.iter().map(|file| file.clone().into_os_string())))
}
