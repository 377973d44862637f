//! The command line.

use std::path::PathBuf;

use tactograph::internals::edges::Params;
use tactograph_tools::words::Words;

/// What is asked for.
pub(crate) struct Args {
    pub(crate) params: Params,
    pub(crate) quick: bool,
    pub(crate) all: bool,
    pub(crate) families: bool,
    pub(crate) scenes: bool,
    pub(crate) colour_noise: bool,
    pub(crate) csv: Option<PathBuf>,
    pub(crate) export: Option<PathBuf>,
    pub(crate) peers: Option<PathBuf>,
    pub(crate) sweep: Option<PathBuf>,
}

impl Args {
    /// Reads the words after the program's name.
    ///
    /// # Errors
    /// A word that is not known or lacks its value.
    pub(crate) fn read(mut words: Words) -> Result<Self, String> {
        let mut args = Self {
            params: Params::default(),
            quick: false,
            all: false,
            families: false,
            scenes: false,
            colour_noise: false,
            csv: None,
            export: None,
            peers: None,
            sweep: None,
        };
        while let Some(word) = words.next() {
            match word.as_str() {
                "--sigma" => args.params.sigma = words.number(&word)?,
                "--low" => args.params.low = words.number(&word)?,
                "--high" => args.params.high = words.number(&word)?,
                "--suppression" => args.params.suppression = words.number(&word)?,
                "--quick" => args.quick = true,
                "--all" => args.all = true,
                "--family" => args.families = true,
                "--scenes" => args.scenes = true,
                "--colour-noise" => args.colour_noise = true,
                "--export" => args.export = Some(words.value(&word)?.into()),
                "--peers" => args.peers = Some(words.value(&word)?.into()),
                "--sweep" => args.sweep = Some("docs/accuracy".into()),
                "--csv" => args.csv = Some(words.value(&word)?.into()),
                _ => return Err(words.unknown(&word)),
            }
        }
        Ok(args)
    }
}
