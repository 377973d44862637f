//! The program killed (SIGKILL) at random moments: is every file that stands whole, and does the next run tidy up?
//!
//! Each round begins with old pages, starts a run that replaces them, and kills it: half of the rounds at any moment of
//! the time that a run takes, half as soon as a temporary file is seen, which is when files are written.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::rng::Rng;

/// What became of all rounds.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tally {
    /// Runs that were killed.
    pub killed: usize,
    /// Runs that had ended before.
    pub ended: usize,
    /// Runs that left a temporary file, which the next run removed.
    pub left_over: usize,
    /// Files that stood as they were, and as they were to become, when a run was killed.
    pub old: usize,
    /// As above.
    pub new: usize,
}

/// A way in which the program is run.
#[derive(Debug, Clone, Copy)]
struct Way {
    name: &'static str,
    args: &'static [&'static str],
    /// Whether it waits for pictures to be saved.
    watches: bool,
}

const WAYS: [Way; 4] = [
    Way {
        name: "several files",
        args: &["convert", "a.png", "b.png", "c.png", "d.png", "--out-dir", "out"],
        watches: false,
    },
    Way {
        name: "several sheets",
        args: &["convert", "a.png", "--sheets", "2x2", "--preview", "png", "-o", "out/a.svg"],
        watches: false,
    },
    Way {
        name: "dots",
        args: &["convert", "a.png", "b.png", "--profile", "index-basic-d", "--format", "pef", "--out-dir", "out"],
        watches: false,
    },
    Way { name: "--watch", args: &["convert", "--watch", "in", "--out-dir", "out"], watches: true },
];

/// How long the program may take in all.
const PATIENCE: Duration = Duration::from_secs(120);

/// Most rounds for each run that is to be killed, and some more: a quarter of the runs have ended before.
const MOST_ROUNDS: usize = 10;

/// Kills `program` until it was killed so many times; runs that had ended before do not count. `seed` gives other
/// moments.
///
/// # Errors
/// A file that is neither the old one nor the new one, what the next run leaves, or that nearly all runs had ended.
pub fn kill(program: &Path, kills: usize, seed: u64) -> Result<Tally, String> {
    let mut rng = Rng::new(seed);
    let mut tally = Tally::default();
    let grounds: Vec<Ground> =
        WAYS.iter().map(|way| Ground::new(program, *way).map_err(told)?.proven()).collect::<Result<_, _>>()?;
    for round in 0.. {
        if tally.killed >= kills {
            break;
        }
        if round >= MOST_ROUNDS * (kills + 10) {
            return Err(format!("of {round} runs only {} could be killed before they ended", tally.killed));
        }
        let ground = &grounds[round % grounds.len()];
        let at_sight = round / grounds.len() % 2 == 1;
        ground
            .round(at_sight, &mut rng, &mut tally)
            .map_err(|what| format!("round {round}, {}: {what}", ground.way.name))?;
    }
    Ok(tally)
}

fn told(fault: std::io::Error) -> String {
    fault.to_string()
}

/// A directory for one way, and what the program makes there.
struct Ground {
    way: Way,
    program: PathBuf,
    place: tempfile::TempDir,
    /// The pages, by their names: with the old title and with the new one.
    old: BTreeMap<String, Vec<u8>>,
    new: BTreeMap<String, Vec<u8>>,
    /// How long a run takes.
    takes: Duration,
}

impl Ground {
    fn new(program: &Path, way: Way) -> std::io::Result<Self> {
        let place = tempfile::tempdir()?;
        for folder in ["in", "out"] {
            fs::create_dir(place.path().join(folder))?;
        }
        for (number, name) in (0..).zip(["a", "b", "c", "d"]) {
            fs::write(place.path().join(format!("{name}.png")), picture(number)?)?;
        }
        let program = program.to_path_buf();
        Ok(Self { way, program, place, old: BTreeMap::new(), new: BTreeMap::new(), takes: Duration::ZERO })
    }

    /// The same with what the program makes when it is not killed.
    fn proven(mut self) -> Result<Self, String> {
        self.whole("old")?;
        self.old = self.pages()?;
        let start = Instant::now();
        self.whole("new")?;
        self.takes = start.elapsed();
        self.new = self.pages()?;
        let differ = self.old.iter().all(|(name, bytes)| self.new.get(name).is_some_and(|new| new != bytes));
        if self.old.is_empty() || self.old.len() != self.new.len() || !differ {
            return Err(format!("{}: old and new pages are not told apart", self.way.name));
        }
        Ok(self)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.place.path().join(name)
    }

    /// Starts a run that makes pages of this title.
    fn start(&self, title: &str) -> Result<Child, String> {
        let table = ["a", "b", "c", "d"].map(|name| format!("{name}.png,{title} {name}\n")).concat();
        fs::write(self.path("titles.csv"), format!("file,title\n{table}")).map_err(told)?;
        let mut command = Command::new(&self.program);
        command.current_dir(self.place.path()).args(self.way.args).args(["--titles", "titles.csv", "--force"]);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command.spawn().map_err(told)
    }

    /// Saves pictures into the directory that is watched.
    fn save(&self) -> Result<(), String> {
        for name in ["a.png", "b.png"] {
            let hidden = self.path("in/.saving.part");
            fs::copy(self.path(name), &hidden).map_err(told)?;
            fs::rename(hidden, self.path("in").join(name)).map_err(told)?;
        }
        Ok(())
    }

    /// Runs the program to its end; one that watches, until the pages are there.
    fn whole(&self, title: &str) -> Result<(), String> {
        let mut child = self.start(title)?;
        let start = Instant::now();
        let before = self.pages()?;
        let mut saved = Instant::now();
        if self.way.watches {
            self.save()?;
        }
        loop {
            if let Some(status) = child.try_wait().map_err(told)? {
                return if status.success() { Ok(()) } else { Err(format!("the program ends with {status}")) };
            }
            if self.way.watches {
                let pages = self.pages()?;
                let are_new = |name: &str| pages.get(name).is_some_and(|page| before.get(name) != Some(page));
                if are_new("a.svg") && are_new("b.svg") {
                    break stop(&mut child);
                }
                if saved.elapsed() > Duration::from_secs(3) {
                    // it may not have watched yet
                    self.save()?;
                    saved = Instant::now();
                }
            }
            if start.elapsed() > PATIENCE {
                stop(&mut child)?;
                return Err("the program does not end".into());
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// All files of the output, also hidden ones.
    fn pages(&self) -> Result<BTreeMap<String, Vec<u8>>, String> {
        let mut pages = BTreeMap::new();
        for entry in fs::read_dir(self.path("out")).map_err(told)? {
            let entry = entry.map_err(told)?;
            // a temporary file may take its name just now
            if let Ok(bytes) = fs::read(entry.path()) {
                pages.insert(entry.file_name().to_string_lossy().into_owned(), bytes);
            }
        }
        Ok(pages)
    }

    /// The old pages again.
    fn restore(&self) -> Result<(), String> {
        let mut pages = self.old.iter();
        pages.try_for_each(|(name, bytes)| fs::write(self.path("out").join(name), bytes).map_err(told))
    }

    fn has_temporary(&self) -> bool {
        let names = fs::read_dir(self.path("out")).into_iter().flatten().flatten();
        names.into_iter().any(|entry| entry.file_name().to_string_lossy().starts_with('.'))
    }

    fn round(&self, at_sight: bool, rng: &mut Rng, tally: &mut Tally) -> Result<(), String> {
        self.restore()?;
        let after = self.takes.mul_f64(rng.between(0.0, 1.0));
        // how many temporary files of this run are seen before it is killed
        let mut sights = 1 + rng.below(self.old.len());
        let mut child = self.start("new")?;
        let start = Instant::now();
        let mut saved = self.way.watches.then(Instant::now);
        let mut saw = false;
        loop {
            if child.try_wait().map_err(told)?.is_some() {
                tally.ended += 1;
                break;
            }
            let sees = self.has_temporary();
            sights = sights.saturating_sub(usize::from(sees && !saw));
            saw = sees;
            let is_late = start.elapsed() > self.takes * 3;
            if (at_sight && sights == 0) || (!at_sight && start.elapsed() >= after) || is_late {
                stop(&mut child)?;
                tally.killed += 1;
                break;
            }
            if saved.is_some_and(|saved| saved.elapsed() > self.takes / 4) {
                self.save()?;
                saved = None;
            }
        }
        let mut left_over = false;
        for (name, bytes) in self.pages()? {
            if name.starts_with('.') {
                left_over = true;
            } else if self.old.get(&name) == Some(&bytes) {
                tally.old += 1;
            } else if self.new.get(&name) == Some(&bytes) {
                tally.new += 1;
            } else {
                return Err(format!("{name} is neither the old file nor the new one ({} bytes)", bytes.len()));
            }
        }
        let missing = self.old.keys().find(|name| !self.path("out").join(name).exists());
        if let Some(missing) = missing {
            return Err(format!("{missing} is gone"));
        }
        tally.left_over += usize::from(left_over);
        if left_over {
            // so that it is seen when the next run has replaced all of them
            self.restore()?;
            self.whole("new")?;
            if self.pages()? != self.new {
                return Err("the next run does not leave the new pages alone".into());
            }
        }
        Ok(())
    }
}

/// Ends a run at once.
fn stop(child: &mut Child) -> Result<(), String> {
    child.kill().and_then(|()| child.wait()).map(drop).map_err(told)
}

/// A square of another colour and size for each number, 60 x 45 px, as PNG.
fn picture(number: u8) -> std::io::Result<Vec<u8>> {
    let far = 40 + u32::from(number);
    let inside = |x: u32, y: u32| (10..far).contains(&x) && (8..36).contains(&y);
    let colour = [40 * number, 200 - 50 * number, 30];
    let pixels = (0..45).flat_map(|y| (0..60).flat_map(move |x| if inside(x, y) { colour } else { [255; 3] }));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 60, 45);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels.collect::<Vec<_>>())?;
    writer.finish()?;
    Ok(bytes)
}
