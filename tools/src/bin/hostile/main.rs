//! Is hostile input survived? Damages whole files of every format at random, adds files that are small and ask for much,
//! gives each to the library in a process of its own, and counts what became of it.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin hostile          20 000 damaged files and all bombs (about 20 minutes)
//!   --files N          so many damaged files
//!   --seed N           other damage (default 1)
//!   --from N           the files from this number on, without bombs: goes on where another run has ended
//!   --bombs            the bombs only
//!   --keep DIR         writes the files that went wrong into a folder
//! ```
//!
//! **Wanted** of each file: a page, or a fault in one clear line; no panic, whoever catches it; at most 5 s of one core and
//! 1.5 GB (1 GB is the stated limit of decoding).
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

mod bombs;
mod dense;
mod mutate;
mod seeds;
mod worker;

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use seeds::{Input, Seed};
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::rng::Rng;
use tactograph_tools::words::Words;

/// What went wrong with this program itself.
pub(crate) type Fault = Box<dyn std::error::Error>;

/// Most working time for one file, s.
const SECONDS: f64 = 5.0;
/// Most memory, kB.
const MEMORY_KB: u64 = 1_500_000;

/// All files that are tried: first the damaged ones, then the bombs.
pub(crate) struct Cases {
    seeds: Vec<Seed>,
    bombs: Vec<Seed>,
    files: usize,
    /// Number of the first.
    from: usize,
    seed: u64,
}

/// One of them.
pub(crate) struct Case<'a> {
    pub(crate) seed: &'a Seed,
    pub(crate) bytes: Vec<u8>,
}

impl Cases {
    fn count(&self) -> usize {
        self.files + self.bombs.len()
    }

    /// The file of a number: the same in every process.
    pub(crate) fn case(&self, number: usize) -> Case<'_> {
        if let Some(bomb) = number.checked_sub(self.files) {
            return Case { seed: &self.bombs[bomb], bytes: self.bombs[bomb].bytes.clone() };
        }
        let number = self.from + number;
        let mut rng = Rng::new(self.seed ^ (number as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        // every row of the table as often as any other, whatever the number of its seeds
        let row = self.row(number);
        let of_row: Vec<&Seed> = self.seeds.iter().filter(|seed| seed.row == row).collect();
        let seed = of_row[rng.below(of_row.len())];
        let other =
            if rng.below(4) > 0 { of_row[rng.below(of_row.len())] } else { &self.seeds[rng.below(self.seeds.len())] };
        Case { seed, bytes: mutate::mutate(&seed.bytes, &other.bytes, seed.is_text, &mut rng) }
    }

    /// The row of a damaged file.
    fn row(&self, number: usize) -> &str {
        let rows = self.rows();
        rows[number % rows.len()]
    }

    fn rows(&self) -> Vec<&str> {
        let mut rows: Vec<&str> = Vec::new();
        for seed in &self.seeds {
            if !rows.contains(&seed.row.as_str()) {
                rows.push(&seed.row);
            }
        }
        rows
    }
}

/// What became of a file.
struct Outcome {
    kind: String,
    ms: u64,
    peak_kb: u64,
    said: String,
}

impl Outcome {
    /// From a line of a worker: kind, milliseconds, kB and what was said.
    fn read(line: &str) -> Self {
        let mut fields = line.splitn(4, '\t').chain(std::iter::repeat(""));
        let mut next = || fields.next().unwrap_or_default();
        let (kind, ms, peak_kb) = (next(), next().parse().unwrap_or(0), next().parse().unwrap_or(0));
        let is_large = matches!(kind, "page" | "refused") && peak_kb > MEMORY_KB;
        Self { kind: if is_large { "large" } else { kind }.into(), ms, peak_kb, said: next().to_owned() }
    }
}

struct Args {
    files: usize,
    from: usize,
    seed: u64,
    keep: Option<PathBuf>,
    is_worker: bool,
}

impl Args {
    fn read() -> Result<Self, Fault> {
        let mut args = Self { files: 20_000, from: 0, seed: 1, keep: None, is_worker: false };
        let mut words = Words::of_program("tools/src/bin/hostile/main.rs");
        while let Some(word) = words.next() {
            match word.as_str() {
                "--files" => args.files = words.number(&word)?,
                "--from" => args.from = words.number(&word)?,
                "--seed" => args.seed = words.number(&word)?,
                "--keep" => args.keep = Some(words.value(&word)?.into()),
                "--bombs" => args.files = 0,
                "--worker" => args.is_worker = true,
                _ => return Err(words.unknown(&word).into()),
            }
        }
        Ok(args)
    }
}

fn main() -> Result<(), Fault> {
    let args = Args::read()?;
    if args.is_worker {
        return worker::run();
    }
    let Args { files, from, seed, .. } = args;
    let bombs = if from == 0 { bombs::all()? } else { Vec::new() };
    let cases = Cases { seeds: seeds::all(Path::new("."))?, bombs, files, from, seed };
    // a process for so many cases, so that what one leaves behind is seen by few others
    let stretches: Vec<Vec<usize>> = (0..cases.count()).collect::<Vec<_>>().chunks(50).map(<[usize]>::to_vec).collect();
    let outcomes: Vec<Outcome> = on_all_cores(&stretches, |stretch| try_all(&cases, stretch))
        .into_iter()
        .collect::<Result<Vec<_>, String>>()?
        .into_iter()
        .flatten()
        .collect();
    table(&cases, &outcomes);
    let wrong = faults(&cases, &outcomes, args.keep.as_deref())?;
    if wrong > 0 { Err(format!("{wrong} files went wrong").into()) } else { Ok(()) }
}

/// A child at work, and the lines it writes.
struct Worker {
    child: Child,
    files: ChildStdin,
    lines: Receiver<String>,
}

impl Worker {
    fn start() -> Result<Self, String> {
        let told = |fault: std::io::Error| format!("the worker does not start: {fault}");
        let mut child = Command::new(std::env::current_exe().map_err(told)?)
            .arg("--worker")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(told)?;
        let (Some(files), Some(out)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("the worker has no pipes".into());
        };
        let (tell, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(out).lines().map_while(Result::ok) {
                if tell.send(line).is_err() {
                    break;
                }
            }
        });
        // what it needs to begin is no part of any case
        lines.recv().map_err(|_| "the worker ends before it begins".to_owned())?;
        Ok(Self { child, files, lines })
    }

    /// Working time so far, s (proc(5): fields 14 and 15, in hundredths of a second).
    fn seconds(&self) -> f64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id())).unwrap_or_default();
        let after_name = stat.rsplit(')').next().unwrap_or_default();
        let ticks = after_name.split_whitespace().skip(11).take(2).filter_map(|field| field.parse::<f64>().ok());
        ticks.sum::<f64>() / 100.0
    }

    /// Gives it a file and waits until it is done, has taken too long or has died.
    fn give(&mut self, input: Input, file: &Path) -> Outcome {
        let gone = |kind: &str, said: String| Outcome { kind: kind.into(), ms: 0, peak_kb: 0, said };
        let start = self.seconds();
        if writeln!(self.files, "{}\t{}", input.name(), file.display()).and_then(|()| self.files.flush()).is_err() {
            return gone("died", "before it was asked".into());
        }
        loop {
            match self.lines.recv_timeout(Duration::from_millis(200)) {
                Ok(line) => return Outcome::read(&line),
                Err(RecvTimeoutError::Timeout) if self.seconds() - start <= SECONDS => {}
                Err(RecvTimeoutError::Timeout) => return gone("slow", format!("over {SECONDS} s")),
                Err(RecvTimeoutError::Disconnected) => {
                    let how = self.child.wait().map_or_else(|fault| fault.to_string(), |status| status.to_string());
                    return gone("died", how);
                }
            }
        }
    }

    fn stop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn try_all(cases: &Cases, numbers: &[usize]) -> Result<Vec<Outcome>, String> {
    let file = tempfile::NamedTempFile::new().map_err(|fault| format!("no temporary file: {fault}"))?;
    let mut worker: Option<Worker> = None;
    let mut outcomes = Vec::new();
    for number in numbers {
        let mut at_work = match worker.take() {
            Some(worker) => worker,
            None => Worker::start()?,
        };
        let case = cases.case(*number);
        std::fs::write(file.path(), &case.bytes).map_err(|fault| format!("{}: {fault}", file.path().display()))?;
        let outcome = at_work.give(case.seed.input, file.path());
        if matches!(outcome.kind.as_str(), "slow" | "died") {
            at_work.stop();
        } else {
            worker = Some(at_work);
        }
        outcomes.push(outcome);
    }
    if let Some(mut worker) = worker {
        worker.stop();
    }
    Ok(outcomes)
}

/// The columns of the table: kinds of outcomes.
const KINDS: [(&str, &str); 8] = [
    ("page", "pages"),
    ("refused", "refused"),
    ("unclear", "not in one clear line"),
    ("caught", "panics told as faults"),
    ("panic", "panics"),
    ("slow", "over 5 s"),
    ("large", "over 1.5 GB"),
    ("died", "died"),
];

fn table(cases: &Cases, outcomes: &[Outcome]) {
    let mut rows: BTreeMap<&str, Vec<&Outcome>> = BTreeMap::new();
    for (number, outcome) in outcomes.iter().enumerate() {
        let row = number.checked_sub(cases.files).map_or_else(|| cases.row(cases.from + number), |_| "bombs");
        rows.entry(row).or_default().push(outcome);
    }
    let heads: Vec<&str> = KINDS.iter().map(|(_, head)| *head).collect();
    println!("| input | files | {} | slowest, ms | most memory, MB |", heads.join(" | "));
    println!("|---|{}", "---|".repeat(KINDS.len() + 3));
    for (row, outcomes) in rows {
        let counts: Vec<String> = KINDS
            .iter()
            .map(|(kind, _)| outcomes.iter().filter(|outcome| outcome.kind == *kind).count().to_string())
            .collect();
        let slowest = outcomes.iter().map(|outcome| outcome.ms).max().unwrap_or(0);
        let most = outcomes.iter().map(|outcome| outcome.peak_kb).max().unwrap_or(0) / 1000;
        println!("| {row} | {} | {} | {slowest} | {most} |", outcomes.len(), counts.join(" | "));
    }
}

/// Names each file that went wrong and keeps it where that is wanted.
fn faults(cases: &Cases, outcomes: &[Outcome], keep: Option<&Path>) -> Result<usize, Fault> {
    let mut wrong = 0;
    for (number, outcome) in outcomes.iter().enumerate() {
        if matches!(outcome.kind.as_str(), "page" | "refused") {
            continue;
        }
        wrong += 1;
        let case = cases.case(number);
        println!("{number} {} ({}): {} {}", case.seed.name, case.seed.row, outcome.kind, outcome.said);
        if let Some(folder) = keep {
            std::fs::create_dir_all(folder)?;
            let name: String =
                case.seed.name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '.' { c } else { '-' }).collect();
            std::fs::write(folder.join(format!("{number}-{}-{name}", outcome.kind)), case.bytes)?;
        }
    }
    Ok(wrong)
}
