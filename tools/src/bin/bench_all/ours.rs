//! Our own program: built, run, and what it says of its stages.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::measured::{Job, Run};

/// The program and where its pages go.
pub(crate) struct Ours {
    program: PathBuf,
    pages: PathBuf,
}

impl Ours {
    /// Builds the program as it is shipped, so that it is never older than its sources.
    ///
    /// # Errors
    /// It cannot be built, or this is no release build.
    pub(crate) fn build(target: &Path, profile: &Path, given: Option<PathBuf>) -> Result<Self, String> {
        let pages = target.join("bench/pages");
        std::fs::create_dir_all(&pages).map_err(|fault| format!("{}: {fault}", pages.display()))?;
        if let Some(program) = given {
            if !program.is_file() {
                return Err(format!("{}: there is no such program", program.display()));
            }
            return Ok(Self { program, pages });
        }
        if !profile.ends_with("release") {
            return Err("this measures release builds: cargo run --release -p tactograph-tools --bin bench_all".into());
        }
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let ended = Command::new(cargo)
            .args(["build", "--release", "--package", "tactograph", "--bin", "tactograph", "--target-dir"])
            .arg(target)
            .status()
            .map_err(|fault| format!("cargo does not run: {fault}; name a program with --program"))?;
        let program = profile.join("tactograph");
        if !ended.success() || !program.is_file() {
            return Err("the program could not be built; cargo has said why".into());
        }
        Ok(Self { program, pages })
    }

    /// Makes a page of a picture; `page` is its name and with it the format.
    pub(crate) fn job(&self, name: &str, picture: &Path, page: &str, options: &[&str]) -> Job {
        let page = self.pages.join(page);
        let words =
            [self.program.as_os_str(), "convert".as_ref(), picture.as_os_str(), "-o".as_ref(), page.as_os_str()];
        let command = words.into_iter().map(OsString::from).chain(options.iter().map(OsString::from));
        Job::new(name, command.chain(["--timings".into()])).writes(page)
    }

    /// Any other command of the program.
    pub(crate) fn command(&self, name: &str, words: impl IntoIterator<Item = OsString>) -> Job {
        Job::new(name, std::iter::once(self.program.clone().into_os_string()).chain(words))
    }

    /// A place for what is written on the way, by us or a peer.
    pub(crate) fn page(&self, name: &str) -> PathBuf {
        self.pages.join(name)
    }
}

/// Stages in their order, as `--timings` lists them.
pub(crate) const STAGES: [&str; 11] =
    ["read", "decode", "text", "edges", "regions", "lines", "overview", "classes", "textures", "page", "write"];

/// How long a stage took, ms; nothing where it was skipped.
pub(crate) fn stage(run: &Run, name: &str) -> Option<f64> {
    run.said.lines().find_map(|line| {
        let mut words = line.split_whitespace();
        let time = words.next().filter(|word| *word == name).and(words.next())?;
        (words.next() == Some("ms")).then(|| time.parse().ok())?
    })
}

/// Names of the stages that were skipped.
pub(crate) fn skipped(run: &Run) -> Vec<&str> {
    run.said.lines().filter_map(|line| line.split_once(" skipped: ")).map(|(name, _)| name.trim()).collect()
}

/// Everything from the decoded pixels to the page in its file, ms.
pub(crate) fn after_decoding(run: &Run) -> Option<f64> {
    Some(stage(run, "total")? - stage(run, "read")? - stage(run, "decode")?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_timings_are_read_as_the_program_writes_them() {
        let said = "timings of a picture 9.9 ms.jpg:\n  read            0.1 ms\n  decode          6.5 ms\n  \
                    edges     skipped: the picture is of one colour\n  total          10.0 ms\n";
        let run = Run { round: 1, wall: 0.0, cpu: 0.0, peak: 0.0, said: said.into() };
        assert_eq!(stage(&run, "decode"), Some(6.5));
        assert_eq!(stage(&run, "edges"), None);
        assert_eq!(skipped(&run), ["edges"]);
        assert!((after_decoding(&run).unwrap() - 3.4).abs() < 1e-9);
    }
}
