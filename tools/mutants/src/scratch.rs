//! A copy of the project with the drawn changes in it, each under a number.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::places::{Place, places};
use crate::rng::Rng;

/// The stages; each is a folder of `src`.
const STAGES: [&str; 6] = ["edges", "lines", "classes", "textures", "page", "dots"];

/// A change that was drawn.
#[derive(Debug, Clone)]
pub(crate) struct Mutant {
    pub(crate) number: usize,
    /// Relative to the project.
    pub(crate) file: String,
    pub(crate) place: Place,
    /// Which of its ways.
    pub(crate) way: usize,
}

impl Mutant {
    pub(crate) fn stage(&self) -> &str {
        self.file.split('/').nth(1).unwrap_or_default()
    }

    pub(crate) fn told(&self) -> String {
        format!("{}:{}\t{}", self.file, self.place.lines.0, self.place.ways[self.way].told)
    }
}

/// The question whether a change is on, as it is written beside the copy's `lib.rs`. The number comes from the
/// environment; `record` in its place has each number that is asked for written down with the name of its thread, which
/// is that of the test.
const QUESTION: &str = r#"//! Which mutant is on.
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io::Write;
use std::sync::atomic::{AtomicUsize, Ordering};
const UNREAD: usize = usize::MAX;
const RECORD: usize = usize::MAX - 1;
static ON: AtomicUsize = AtomicUsize::new(UNREAD);
#[inline]
pub(crate) fn mutant(number: usize) -> bool {
    let on = ON.load(Ordering::Relaxed);
    on == number || on >= RECORD && asked(number)
}
#[cold]
fn asked(number: usize) -> bool {
    let word = std::env::var("TACTOGRAPH_MUTANT").unwrap_or_default();
    let on = if word == "record" { RECORD } else { word.parse().unwrap_or(0) };
    ON.store(on, Ordering::Relaxed);
    thread_local!(static SEEN: RefCell<BTreeSet<usize>> = const { RefCell::new(BTreeSet::new()) });
    if on == RECORD && SEEN.with(|seen| seen.borrow_mut().insert(number)) {
        let thread = std::thread::current();
        let line = format!("{number}\t{}\n", thread.name().unwrap_or_default());
        let path = std::env::var_os("TACTOGRAPH_REACHED").unwrap_or_default();
        let file = std::fs::OpenOptions::new().create(true).append(true).open(path);
        file.and_then(|mut file| file.write_all(line.as_bytes())).expect("it can be written down");
    }
    on == number
}
"#;

/// The program, which takes long to build, and is not what is tested.
const PROGRAM: &str = "[[bin]]
name = \"tactograph\"
path = \"src/main.rs\"
required-features = [\"cli\"]
";

/// Parts of the suite that look at what the stages make, those first that take the least time for what they notice.
pub(crate) const PARTS: [&str; 7] = ["golden", "points", "arrows", "gridlines", "scenes", "few", "crowded"];

/// Copies the project to `into`, draws `count` changes, leaves out those that the compiler refuses, and gives the rest
/// in the order in which they were drawn.
pub(crate) fn make(
    root: &Path,
    into: &Path,
    count: usize,
    seed: u64,
) -> Result<Vec<Mutant>, Box<dyn std::error::Error>> {
    let mut texts = BTreeMap::new();
    for stage in STAGES {
        sources(root, &root.join("src").join(stage), &mut texts)?;
    }
    let mut mutants = draw(&texts, count, seed)?;
    // what the compiler refused in an earlier run
    let known = std::fs::read_to_string(into.join("refused.tsv")).unwrap_or_default();
    let known: BTreeSet<&str> = known.lines().collect();
    mutants.retain(|mutant| !known.contains(&*mutant.told()));
    let mut frame = frame(root)?;
    loop {
        for (file, text) in &texts {
            let of_file: Vec<&Mutant> = mutants.iter().filter(|mutant| mutant.file == *file).collect();
            frame.insert(file.clone(), written(text, &of_file));
        }
        copy(root, into, &frame)?;
        let refused = refused(into)?;
        if refused.is_empty() {
            return Ok(mutants);
        }
        let is_refused = |mutant: &Mutant| {
            let (first, last) = mutant.place.lines;
            refused.range((mutant.file.clone(), first)..=(mutant.file.clone(), last)).next().is_some()
        };
        let (out, rest): (Vec<Mutant>, Vec<Mutant>) = mutants.into_iter().partition(is_refused);
        println!("the compiler refuses {}", out.len());
        if out.is_empty() {
            return Err(format!("these faults are of no mutant: {refused:?}").into());
        }
        let mut list = std::fs::OpenOptions::new().create(true).append(true).open(into.join("refused.tsv"))?;
        out.iter().try_for_each(|mutant| writeln!(list, "{}", mutant.told()))?;
        mutants = rest;
    }
}

/// Draws so many changes, no two of them at one place.
fn draw(texts: &BTreeMap<String, String>, count: usize, seed: u64) -> Result<Vec<Mutant>, String> {
    let mut all = Vec::new();
    for (file, text) in texts {
        let found = places(text).map_err(|error| format!("{file}: {error}"))?;
        all.extend(found.into_iter().map(|place| (file.clone(), place)));
    }
    println!("{} places in {} files", all.len(), texts.len());
    let mut rng = Rng::new(seed);
    let drawn = (1..=count.min(all.len())).map(|number| {
        let (file, place) = all.swap_remove(rng.below(all.len()));
        let way = rng.below(place.ways.len());
        Mutant { number, file, place, way }
    });
    Ok(drawn.collect())
}

/// A file with its changes, each beside what it stands for.
fn written(text: &str, mutants: &[&Mutant]) -> String {
    // at one byte first what ends there, the inner before the outer, then what begins there, the outer before the inner
    let mut pieces: Vec<((usize, bool, isize), String)> = Vec::new();
    for mutant in mutants {
        let [before, after] = &mutant.place.ways[mutant.way].around;
        let range = &mutant.place.range;
        let question = |text: &str| text.replace("MUTANT", &format!("crate::mutant({})", mutant.number));
        pieces.push(((range.start, true, -(range.end as isize)), question(before)));
        pieces.push(((range.end, range.is_empty(), -(range.start as isize)), question(after)));
    }
    pieces.sort();
    let mut written = String::new();
    let mut done = 0;
    for ((at, ..), piece) in pieces {
        written.push_str(&text[done..at]);
        written.push_str(&piece);
        done = at;
    }
    written + &text[done..]
}

/// Files and lines at which the compiler finds a fault.
fn refused(folder: &Path) -> Result<BTreeSet<(String, usize)>, Box<dyn std::error::Error>> {
    let check = ["check", "--lib", "--message-format", "short"];
    let output = Command::new("cargo").args(check).current_dir(folder).stdout(Stdio::null()).output()?;
    let told = String::from_utf8_lossy(&output.stderr);
    let place = |line: &str| {
        let mut parts = line.split(':');
        let (file, number) = (parts.next()?, parts.next()?.parse().ok()?);
        line.contains(": error").then(|| (file.to_string(), number))
    };
    let places: BTreeSet<_> = told.lines().filter_map(place).collect();
    if places.is_empty() && !output.status.success() {
        return Err(told.into_owned().into());
    }
    Ok(places)
}

/// The files of a stage that are not tests, with their text.
fn sources(root: &Path, folder: &Path, texts: &mut BTreeMap<String, String>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path: PathBuf = entry?.path();
        let name = path.file_stem().unwrap_or_default();
        if name == "tests" {
            continue;
        }
        if path.is_dir() {
            sources(root, &path, texts)?;
        } else if path.extension().is_some_and(|end| end == "rs") {
            texts.insert(name_of(root, &path), std::fs::read_to_string(&path)?);
        }
    }
    Ok(())
}

/// What is not as in the project whatever was drawn: the library has the question, and tests are only those that are
/// run.
fn frame(root: &Path) -> std::io::Result<BTreeMap<String, String>> {
    let lib = std::fs::read_to_string(root.join("src/lib.rs"))?;
    let question = "\n#![allow(warnings, clippy::all)]\nmod mutation;\nuse mutation::mutant;\nmod api;";
    let manifest = std::fs::read_to_string(root.join("Cargo.toml"))?;
    let manifest = manifest.replacen(PROGRAM, "", 1).replacen("default-run = \"tactograph\"", "autobins = false", 1);
    let files = [
        ("src/lib.rs", lib.replacen("\nmod api;", question, 1)),
        ("src/mutation.rs", QUESTION.to_string()),
        ("tests/main.rs", ["common"].iter().chain(&PARTS).map(|part| format!("mod {part};\n")).collect()),
        ("Cargo.toml", manifest),
    ];
    Ok(files.map(|(file, text)| (file.to_string(), text)).into())
}

/// Copies all but what is built and the history, with these files in place of those that are there. What is the same
/// already is left, so that little is compiled again.
fn copy(root: &Path, into: &Path, other: &BTreeMap<String, String>) -> std::io::Result<()> {
    let mut folders = vec![root.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            let file = name_of(root, &path);
            if path.is_dir() {
                folders.extend((!["target", ".git"].contains(&&*file) && !file.ends_with("/target")).then_some(path));
            } else if file != ".git" && !other.contains_key(&file) {
                write(&into.join(file), &std::fs::read(path)?)?;
            }
        }
    }
    other.iter().try_for_each(|(file, text)| write(&into.join(file), text.as_bytes()))
}

/// Writes a file unless it is there as it is.
fn write(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if std::fs::read(path).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    path.parent().map_or(Ok(()), std::fs::create_dir_all)?;
    std::fs::write(path, bytes)
}

/// A file's name within the project.
fn name_of(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/")
}
