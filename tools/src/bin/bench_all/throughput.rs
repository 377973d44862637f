//! Many photographs in one call: how many a second, and how much memory that takes, beside what single runs promise.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::measured::Job;
use crate::ours::Ours;
use crate::rounds::{Outcome, rounds};
use crate::table::{Table, number};
use crate::targets::Bench;

/// How many photographs one call converts.
const MANY: usize = 24;
/// A call is to reach at least this share of what single runs promise.
const WANTED: f64 = 0.95;

/// Photographs a second on one core and on all, beside a shell loop over potrace.
pub(crate) fn throughput(bench: &Bench<'_>) -> Table {
    let about = format!(
        "{MANY} photographs of 12 megapixels in one call, each with a core to itself. *Promised* is what a single run on \
         one core makes in a second, times the cores; *reached* is the share of it that the call makes, wanted {WANTED} at \
         least. As many photographs are in work at once as there are cores: a machine of 4 or 8 holds two or four times the \
         memory that one of two does."
    );
    let head = ["work", "cores", "ms", "CPU ms", "MB", "photographs a second", "promised", "reached", "met"];
    let mut table = Table::new("Throughput", about, &head);
    let picture = bench.inputs.file("photo-12.jpg");
    let pictures = match copies(bench.ours, &picture) {
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
    for (cores, one_core) in [(1, true), (all_cores, false)] {
        let outcomes = rounds(&jobs, bench.setting(one_core));
        // working time of one photograph: the same for the promise on all cores
        alone = alone.or_else(|| outcomes.first().and_then(Outcome::wall));
        for outcome in outcomes.iter().skip(1) {
            let a_second = outcome.median(|run| Some(MANY as f64 * 1e3 / run.wall));
            let promised = alone.filter(|_| outcome.name == CALL).map(|ms| cores as f64 * 1e3 / ms);
            let reached = a_second.zip(promised).map(|(is, promised)| is / promised);
            let met = reached.map_or("", |share| if share >= WANTED { "yes" } else { "no" });
            let mut cells = vec![outcome.name.clone(), cores.to_string()];
            let numbers = [outcome.wall(), outcome.cpu(), outcome.peak(), a_second, promised, reached];
            cells.extend(numbers.map(number));
            cells.push(met.into());
            table.rows.push(cells);
        }
    }
    table
}

const CALL: &str = "tactograph convert, all in one call";

/// The photograph under as many names.
fn copies(ours: &Ours, picture: &PathBuf) -> Result<Vec<PathBuf>, String> {
    let folder = ours.page("many");
    std::fs::create_dir_all(&folder).map_err(|fault| format!("{}: {fault}", folder.display()))?;
    let copy = |number: usize| {
        let file = folder.join(format!("photo-{number}.jpg"));
        if !file.is_file() {
            std::fs::copy(picture, &file).map_err(|fault| format!("{}: {fault}", file.display()))?;
        }
        Ok(file)
    };
    (1..=MANY).map(copy).collect()
}

fn call(ours: &Ours, pictures: &[PathBuf]) -> Job {
    let words = ["convert", "--quiet", "--force", "--out-dir"].map(OsString::from).into_iter();
    let pages = [ours.page("many-pages").into_os_string()];
    ours.command(CALL, words.chain(pages).chain(pictures.iter().map(|file| file.clone().into_os_string())))
}
