//! The tests, run with one change on at a time.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use crate::scratch::{Mutant, PARTS};

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// A run with a change on may take so many times as long as without.
const PATIENCE: u32 = 3;
/// At least this long, as short runs are more uneven.
const LEAST: Duration = Duration::from_secs(10);
/// Address space of a run, kB: a change may gather without end.
const MOST_MEMORY: u64 = 8_000_000;

/// What noticed a change.
const BY_UNIT_TESTS: &str = "unit";
const BY_SUITE: &str = "suite";
const NOT_NOTICED: &str = "survived";

/// A program of tests, or a part of it, as it is without a change.
struct Tests {
    program: PathBuf,
    /// Begin of the names of its tests.
    part: String,
    takes: Duration,
    /// The tests that reach each change. A name of nothing: a thread that tests share.
    reached: BTreeMap<usize, BTreeSet<String>>,
}

/// Runs the tests on each mutant and writes what noticed it to `results.tsv` in the folder, where those that are there
/// already are not run again.
pub(crate) fn run(folder: &Path, mutants: &[Mutant]) -> Result<()> {
    let [unit, suite] = programs(folder)?;
    let unit = Tests::of(folder, unit, "")?;
    let path = folder.join("results.tsv");
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    let known: BTreeSet<usize> = known.lines().filter_map(|line| line.split('\t').next()?.parse().ok()).collect();
    let mut results = std::fs::OpenOptions::new().create(true).append(true).open(&path)?;
    let mut tell = |mutant: &Mutant, by: &str, who: &str| {
        let (number, stage, told) = (mutant.number, mutant.stage(), mutant.told());
        writeln!(results, "{number}\t{stage}\t{by}\t{who}\t{told}")
    };
    // the tests that take no time first, for all of them
    let mut rest = Vec::new();
    for mutant in mutants.iter().filter(|mutant| !known.contains(&mutant.number)) {
        match unit.notice(folder, mutant.number)? {
            Some(who) => tell(mutant, BY_UNIT_TESTS, &who)?,
            None => rest.push(mutant),
        }
    }
    let parts = PARTS.map(|part| Tests::of(folder, suite.clone(), &format!("{part}::")));
    let parts = parts.into_iter().collect::<Result<Vec<_>>>()?;
    for mutant in rest {
        let noticed = parts.iter().find_map(|part| part.notice(folder, mutant.number).transpose()).transpose()?;
        match noticed {
            Some(who) => tell(mutant, BY_SUITE, &who)?,
            None => tell(mutant, NOT_NOTICED, &reach(mutant.number, &unit, &parts))?,
        }
    }
    Ok(())
}

/// Who comes to a change that nobody notices.
fn reach(number: usize, unit: &Tests, parts: &[Tests]) -> String {
    let tests = unit.reached.get(&number).map_or(0, BTreeSet::len);
    let parts: Vec<&str> =
        parts.iter().filter(|part| part.reached.contains_key(&number)).map(|part| &*part.part).collect();
    format!("reached by {tests} unit tests, {}", parts.join(" "))
}

/// What is in `results.tsv`, as a table of the stages.
pub(crate) fn table(folder: &Path) -> Result<String> {
    let results = std::fs::read_to_string(folder.join("results.tsv"))?;
    let mut stages: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    for line in results.lines() {
        let mut words = line.split('\t').skip(1);
        let (stage, by) = words.next().zip(words.next()).ok_or("a line of results.tsv is no result")?;
        let column = [BY_UNIT_TESTS, BY_SUITE, NOT_NOTICED].iter().position(|column| *column == by);
        let column = column.ok_or("a line of results.tsv is no result")?;
        stages.entry(stage).or_default()[column] += 1;
        stages.entry("~all").or_default()[column] += 1;
    }
    let mut table =
        "| stage | faults | noticed by unit tests | by the suite | by none |\n|---|---|---|---|---|\n".to_string();
    for (stage, [unit, suite, none]) in stages {
        let stage = stage.trim_start_matches('~');
        writeln!(table, "| {stage} | {} | {unit} | {suite} | {none} |", unit + suite + none)?;
    }
    Ok(table)
}

/// Builds the tests of the library and the suite.
fn programs(folder: &Path) -> Result<[PathBuf; 2]> {
    let build = ["test", "--no-run", "--lib", "--test", "suite"];
    let output = Command::new("cargo").args(build).current_dir(folder).output()?;
    let told = String::from_utf8_lossy(&output.stderr);
    let program =
        |line: &str| Some(folder.join(line.trim().strip_prefix("Executable ")?.split_once('(')?.1.strip_suffix(')')?));
    let programs: Vec<PathBuf> = told.lines().filter_map(program).collect();
    programs.try_into().map_err(|_| told.into_owned().into())
}

impl Tests {
    /// Runs them once without a change and writes down which come to which.
    fn of(folder: &Path, program: PathBuf, part: &str) -> Result<Self> {
        let path = folder.join("reached.tsv");
        std::fs::write(&path, "")?;
        let mut tests = Self { program, part: part.to_string(), takes: Duration::ZERO, reached: BTreeMap::new() };
        let start = Instant::now();
        if let Some(failed) = tests.failed(folder, "record", &[part], Duration::from_secs(3600))? {
            return Err(format!("{failed} fails without a change").into());
        }
        tests.takes = start.elapsed();
        for line in std::fs::read_to_string(path)?.lines() {
            let (number, test) = line.split_once('\t').ok_or("a line of reached.tsv is none")?;
            tests.reached.entry(number.parse()?).or_default().insert(test.to_string());
        }
        println!("{} takes {:.0} s", if part.is_empty() { "unit tests" } else { part }, tests.takes.as_secs_f32());
        Ok(tests)
    }

    /// The first test that notices a change, if one does.
    fn notice(&self, folder: &Path, number: usize) -> Result<Option<String>> {
        let Some(reached) = self.reached.get(&number) else { return Ok(None) };
        let (number, patience) = (number.to_string(), (self.takes * PATIENCE).max(LEAST));
        if !self.part.is_empty() {
            return self.failed(folder, &number, &[&self.part], patience);
        }
        // those that are known to reach it, then all if threads do that any of them may have asked for work
        let named: Vec<&str> = reached.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
        let exact: Vec<&str> = ["--exact"].into_iter().chain(named.iter().copied()).collect();
        let failed = if named.is_empty() { None } else { self.failed(folder, &number, &exact, patience)? };
        if failed.is_none() && named.len() < reached.len() {
            return self.failed(folder, &number, &[], patience);
        }
        Ok(failed)
    }

    /// The first test that fails, or what else happens, with `mutant` on.
    fn failed(&self, folder: &Path, mutant: &str, filter: &[&str], patience: Duration) -> Result<Option<String>> {
        let mut child = Command::new("sh")
            .args(["-c", &format!("ulimit -v {MOST_MEMORY}; exec \"$0\" \"$@\"")])
            .arg(&self.program)
            .args(["--test-threads", "2"])
            .args(filter.iter().filter(|word| !word.is_empty()))
            .env("TACTOGRAPH_MUTANT", mutant)
            .env("TACTOGRAPH_REACHED", folder.join("reached.tsv"))
            .env("PROPTEST_FAILURE_PERSISTENCE", "off")
            .current_dir(folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let failed = watch(&mut child, patience);
        child.kill()?;
        child.wait()?;
        Ok(failed)
    }
}

/// The first test that a run tells as failed, or how else it went wrong.
fn watch(child: &mut Child, patience: Duration) -> Option<String> {
    let end = Instant::now() + patience;
    let lines = BufReader::new(child.stdout.take()?).lines();
    let (tell, told) = channel();
    std::thread::spawn(move || lines.map_while(std::result::Result::ok).try_for_each(|line| tell.send(line)));
    loop {
        match told.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(line) if line.ends_with("... FAILED") => return Some(line.split(' ').nth(1)?.to_string()),
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout) => return Some("no end".into()),
            Err(RecvTimeoutError::Disconnected) => {
                let ended_well = child.wait().is_ok_and(|status| status.success());
                return (!ended_well).then(|| "it ended".into());
            }
        }
    }
}
