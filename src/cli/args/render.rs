//! `tactograph render` on the command line.

use std::path::PathBuf;

use clap::Args;

use super::labels::WithKey;
use super::writing::{EmbossingOptions, Writing};

pub(super) const LONG_ABOUT: &str = "\
Writes a page that \"tactograph convert\" made as SVG, changed in an editor or not, in any format.

Everything counts that lies in the layers of the page as it is now: what was deleted, moved, bent or drawn. What \
lies outside of them is taken by its kind: a stroke is a line, a disc a dot, any other filled shape a line around it. \
What is taken otherwise than it looks, or left out, is told. Hidden layers are not on the page.

The page stays on its paper or device, and widths of lines are brought into the range of its profile. With --profile \
it is laid out anew for another one: lines and areas keep their places in the figure, and textures, overview, frame \
and braille are made for the new paper or device.

Where words are abbreviated that were not so before, a key follows on sheets of its own, as after
\"tactograph convert\".";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph render cup.svg -o cup.pdf
        for the printer, in pure black and true size
  tactograph render cup.svg --profile index-basic-d -o cup.idx
        for an embosser: lines and areas become dots
  tactograph render cup.svg --profile swell-a4 --title \"My cup\" -o cup.pdf
        with another title, in braille too
  tactograph render dots.svg -o dots.brf
        a page of dots that was changed

Exit codes:
  0  the page is written
  1  it could not be read, or not be written
  2  wrong usage: an option, a profile or a value is wrong; nothing is written";

/// `tactograph render`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Render {
    /// Page to write, an SVG file that "tactograph convert" made; - for standard input
    #[arg(value_name = "PAGE.svg", required = true)]
    pub(in crate::cli) page: PathBuf,

    /// Where the page goes; - for standard output
    ///
    /// The name ends in .svg, .pdf or .png, or in that of a format of dots, which says the format, or has no ending. An
    /// existing file is replaced.
    #[arg(short, long, value_name = "PAGE")]
    pub(in crate::cli) output: PathBuf,

    #[command(flatten)]
    pub(in crate::cli) writing: Writing,

    #[command(flatten)]
    pub(in crate::cli) embossing: EmbossingOptions,

    /// Lays the page out anew for another paper or device: a name from "tactograph profiles" or a .toml file
    ///
    /// [default: the page stays as it is]
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(in crate::cli) profile: Option<String>,

    /// Gives the page another title
    ///
    /// With --profile it is written in braille above the figure as well, also with the page's own profile; without, a
    /// title in braille stays as it is, and you are told.
    #[arg(long, value_name = "TEXT")]
    pub(in crate::cli) title: Option<String>,

    /// Changes one value of the profile that --profile names; can be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    pub(in crate::cli) set: Vec<String>,

    #[command(flatten)]
    pub(in crate::cli) key: WithKey,

    /// Writes braille by a table of an installed liblouis, as the one that the page was made with
    ///
    /// As in "tactograph convert": the name of a table, or "contracted". Without it, words that are written anew are
    /// contracted only where the profile says braille.grade = 2.
    #[arg(long, value_name = "TABLE|contracted")]
    pub(in crate::cli) braille_table: Option<String>,

    /// Replaces numbered files that are there already, whoever wrote them
    #[arg(long, visible_alias = "overwrite")]
    pub(in crate::cli) force: bool,

    /// Says nothing but errors
    #[arg(short, long)]
    pub(in crate::cli) quiet: bool,
}
