//! The command line.

use std::path::PathBuf;

use tactograph::internals::edges::Params;

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
    pub(crate) fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
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
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            let number = |text: String| text.parse().map_err(|_| format!("{word} needs a number, not {text}"));
            match word.as_str() {
                "--sigma" => args.params.sigma = number(value()?)?,
                "--low" => args.params.low = number(value()?)?,
                "--high" => args.params.high = number(value()?)?,
                "--suppression" => args.params.suppression = number(value()?)?,
                "--quick" => args.quick = true,
                "--all" => args.all = true,
                "--family" => args.families = true,
                "--scenes" => args.scenes = true,
                "--colour-noise" => args.colour_noise = true,
                "--export" => args.export = Some(value()?.into()),
                "--peers" => args.peers = Some(value()?.into()),
                "--sweep" => args.sweep = Some("docs/accuracy".into()),
                "--csv" => args.csv = Some(value()?.into()),
                _ => return Err(format!("{word} is not known; see the head of tools/src/bin/accuracy/main.rs")),
            }
        }
        Ok(args)
    }
}
