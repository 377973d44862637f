//! The command line.

use std::path::PathBuf;

/// What is asked for.
#[derive(Debug)]
pub(crate) struct Args {
    /// Rounds in which everything runs once.
    pub(crate) runs: usize,
    /// Only work whose name has this in it, in small letters.
    pub(crate) only: Option<String>,
    /// Slow programs run once; nothing of 50 megapixels.
    pub(crate) quick: bool,
    /// The tables go into docs/speed.md too.
    pub(crate) write: bool,
    /// Another program than the one that is built here.
    pub(crate) program: Option<PathBuf>,
}

impl Args {
    /// Reads the words after the program's name.
    ///
    /// # Errors
    /// A word that is not known or lacks its value.
    pub(crate) fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut args = Self { runs: 9, only: None, quick: false, write: false, program: None };
        let mut runs = None;
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--runs" => {
                    let text = value()?;
                    let number = text.parse().ok().filter(|&runs| runs > 0);
                    runs = Some(number.ok_or(format!("--runs needs a whole number from 1 on, not {text}"))?);
                }
                "--only" => args.only = Some(value()?.to_lowercase()),
                "--quick" => args.quick = true,
                "--write" => args.write = true,
                "--program" => args.program = Some(value()?.into()),
                _ => return Err(format!("{word} is not known; see the head of tools/src/bin/bench_all/main.rs")),
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
