//! One file after the other in a process of its own, which may die of it.

use std::io::{BufRead, Write};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use tactograph::{Error, Fonts, Label, Options, Profile, RenderOptions};
use tactograph_tools::fuzz::LONGEST_LINE;

use crate::Fault;
use crate::seeds::Input;

/// Panics that happened, with the place of the last, whoever caught them.
static PANICS: AtomicUsize = AtomicUsize::new(0);
static LAST: Mutex<String> = Mutex::new(String::new());

/// Reads kinds of input and paths of files from standard input, and writes a line on each: outcome, milliseconds, peak of
/// memory in kB, and what was said, parted by tabs.
pub(crate) fn run() -> Result<(), Fault> {
    std::panic::set_hook(Box::new(|panic| {
        PANICS.fetch_add(1, Ordering::Relaxed);
        let text = panic.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        *LAST.lock().unwrap_or_else(PoisonError::into_inner) = text;
    }));
    let with = With::new()?;
    let mut out = std::io::stdout().lock();
    writeln!(out, "ready")?;
    out.flush()?;
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let (input, path) = line.split_once('\t').ok_or("a line without a file")?;
        let input = Input::of_name(input).ok_or_else(|| format!("{input}: no such input"))?;
        let bytes = std::fs::read(path)?;
        forget_peak();
        PANICS.store(0, Ordering::Relaxed);
        let start = Instant::now();
        let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| with.give(input, &bytes)));
        let ms = start.elapsed().as_millis();
        let last = || LAST.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let (outcome, said) = match result {
            Err(_) => ("panic", last()),
            Ok(_) if PANICS.load(Ordering::Relaxed) > 0 => ("caught", last()),
            Ok(Ok(())) => ("page", String::new()),
            Ok(Err(fault))
                if fault.trim().is_empty() || fault.lines().any(|line| line.chars().count() > LONGEST_LINE) =>
            {
                ("unclear", fault)
            }
            Ok(Err(fault)) => ("refused", fault),
        };
        let said: String = said.split_whitespace().collect::<Vec<_>>().join(" ").chars().take(300).collect();
        writeln!(out, "{outcome}\t{ms}\t{}\t{said}", peak_kb())?;
        out.flush()?;
    }
    Ok(())
}

/// What a file is given together with.
struct With {
    options: Options,
    picture: Vec<u8>,
}

impl With {
    fn new() -> Result<Self, Fault> {
        let options = Options::new(Profile::named("swell-a4")?).fonts(Fonts::system());
        Ok(Self { options, picture: std::fs::read(Path::new("tests/pictures/rgb.png"))? })
    }

    /// Does with a file what the program would do with it. A fault is given as the program would say it.
    fn give(&self, input: Input, bytes: &[u8]) -> Result<(), String> {
        let said = |fault: Error| match fault {
            Error::Profile(faults) => faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"),
            other => other.to_string(),
        };
        let text = || std::str::from_utf8(bytes).map_err(|fault| fault.to_string());
        let convert = |picture: &[u8], options: &Options| {
            let drawing = tactograph::convert(picture, options).map_err(said)?;
            std::hint::black_box(drawing.page.to_svg());
            Ok(())
        };
        match input {
            Input::Picture => convert(bytes, &self.options),
            Input::Lettered => convert(bytes, &self.options.clone().label_texts(true)),
            Input::Page => {
                let drawing = tactograph::render(bytes, &RenderOptions::new()).map_err(said)?;
                std::hint::black_box(drawing.page.to_pdf());
                std::hint::black_box(tactograph::check(bytes, &tactograph::PageOptions::new()).map_err(said)?);
                std::hint::black_box(tactograph::describe(bytes, &tactograph::PageOptions::new()).map_err(said)?);
                Ok(())
            }
            Input::Lines => convert(&self.picture, &self.options.clone().lines(bytes).map_err(said)?),
            Input::Areas => convert(&self.picture, &self.options.clone().areas(bytes).map_err(said)?),
            Input::Labels => {
                let labels = Label::from_csv(text()?).map_err(said)?;
                convert(&self.picture, &self.options.clone().labels(labels))
            }
            Input::Profile => {
                let profile = Profile::from_toml(text()?, "own.toml").map_err(said)?;
                let drawing = tactograph::convert(&self.picture, &Options::new(profile)).map_err(said)?;
                std::hint::black_box(drawing.page.to_svg());
                Ok(())
            }
        }
    }
}

/// From here on the peak of memory counts anew (Linux, proc(5)).
fn forget_peak() {
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// The most memory that this process held since then, kB.
fn peak_kb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    peak.and_then(|peak| peak.split_whitespace().next()?.parse().ok()).unwrap_or(0)
}
