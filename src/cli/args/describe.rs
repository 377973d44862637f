//! `tactograph describe` on the command line.

use std::path::PathBuf;

use clap::Args;

pub(super) const LONG_ABOUT: &str = "\
Tells in plain sentences what is on a page, the most important first: the sheet and the figure, the longest \
lines with form, place and size, the colours by their areas, words in braille, what was left out, and the verdict of \
tactograph check. One sentence a line. It looks at the page as it is drawn, so it can also be asked about a page that \
you changed in an editor.\n\n\
The sentences are in the language of the page, or in that of --lang: en, de, es, fr or pl.";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph describe coffee.svg
  tactograph describe coffee.svg --lang de
  tactograph describe coffee.svg --json
        the same as data: what each sentence is about, and its text

Exit codes:
  0  the page is described
  1  the page could not be read
  2  wrong usage: an option or a value is wrong";

/// `tactograph describe`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Describe {
    /// Page to describe, an SVG file that "tactograph convert" made; - for standard input
    #[arg(value_name = "PAGE.svg", required = true)]
    pub(in crate::cli) page: PathBuf,

    /// Language of the sentences: en, de, es, fr or pl [default: that of the page]
    #[arg(long, value_name = "TAG")]
    pub(in crate::cli) lang: Option<String>,

    /// Writes the sentences as data
    #[arg(long)]
    pub(in crate::cli) json: bool,
}
