//! The command line.

use std::path::PathBuf;

use tactograph_tools::words::Words;

/// What is asked for.
#[derive(Debug)]
pub(crate) struct Args {
    /// Rounds in which everything runs once.
    pub(crate) runs: usize,
    /// Only work whose name has this in it, in small letters.
    pub(crate) only: Option<String>,
    /// Fewer rounds and less patience with slow programs; nothing of 50 megapixels, no vtracer, fewer photographs in one call.
    pub(crate) quick: bool,
    /// The tables go into docs/speed.md and README.md too.
    pub(crate) write: bool,
    /// Another program than the one that is built here.
    pub(crate) program: Option<PathBuf>,
}

impl Args {
    /// Reads the words after the program's name.
    ///
    /// # Errors
    /// A word that is not known or lacks its value.
    pub(crate) fn read(mut words: Words) -> Result<Self, String> {
        let mut args = Self { runs: 9, only: None, quick: false, write: false, program: None };
        let mut runs = None;
        while let Some(word) = words.next() {
            match word.as_str() {
                "--runs" => runs = Some(words.whole_number(&word)?),
                "--only" => args.only = Some(words.value(&word)?.to_lowercase()),
                "--quick" => args.quick = true,
                "--write" => args.write = true,
                "--program" => args.program = Some(words.value(&word)?.into()),
                _ => return Err(words.unknown(&word)),
            }
        }
        if args.write && (args.quick || args.only.is_some()) {
            return Err("--write is for whole tables: without --quick and --only".into());
        }
        args.runs = runs.unwrap_or(if args.quick { 3 } else { args.runs });
        Ok(args)
    }

    /// Is this work asked for?
    pub(crate) fn wants(&self, work: &str) -> bool {
        self.only.as_ref().is_none_or(|part| work.to_lowercase().contains(part))
    }
}
