//! `tactograph calibrate` on the command line.

use std::path::PathBuf;

use clap::Args;
use tactograph::Profile;

use super::writing::Writing;

pub(super) const LONG_ABOUT: &str = "\
Makes a sheet of samples to be printed once: lines of every width, gaps, braille, frames, the smallest glyphs, and all \
textures. For an embosser or a pin display: its pitch, empty dots between lines, weak and heavy lines or heights, \
frames, and its textures.

Print it on your paper, heat it as you always do, and feel it together with a blind reader: the thinnest line that can \
be followed, the narrowest gap that parts two lines, the smallest glyph that is felt. Write these numbers into a \
profile of your own; everything else stays.

Above every group stand, in braille, its letter and the keys of the profile that it decides, such as lines.min_gap; \
every sample has its number below it. What they are is told here and in the file's own description. Samples that do \
not find room on one sheet go on on another: as PDF or for most embossers in the same file, as SVG or PNG in files \
with numbers, sheet-1.svg, sheet-2.svg.

A sheet of dots has one pitch. For a device with several, such as an Index embosser, there is a file for each, \
named by it in mm: sheet-1.6.idx, sheet-2.0.idx. With --set dots.pitch=1.6 there is that one alone, called as you \
say, and to standard output goes the one of the profile. Where dots can be anywhere, lines and textures of several \
pitches stand on the same sheets.";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph calibrate -o sheet.pdf
        for A4 swell paper
  tactograph calibrate --profile my.toml -o sheet.pdf
        with the numbers of your own profile, to see what it makes of them
  tactograph calibrate --profile swell-a3 -o sheet.svg
        on larger paper, as a drawing
  tactograph calibrate --profile index-basic-d -o sheet.idx --preview png
        for an embosser, and as pictures to look at

Exit codes:
  0  the sheets are written
  1  a sheet could not be written, or has no room for a sample
  2  wrong usage: an option, a profile or a value is wrong; nothing is written";

/// `tactograph calibrate`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Calibrate {
    /// Where the sheets go; - for standard output
    ///
    /// The name ends in .svg, .pdf or .png, or in that of a format of dots, which says the format, or has no ending.
    /// Existing files are replaced.
    #[arg(short, long, value_name = "SHEET")]
    pub(in crate::cli) output: PathBuf,

    #[command(flatten)]
    pub(in crate::cli) writing: Writing,

    /// Paper and settings: a name from "tactograph profiles" or a .toml file of your own
    #[arg(long, value_name = "NAME|FILE.toml", default_value = Profile::built_in()[0].name)]
    pub(in crate::cli) profile: String,

    /// Changes one value of the profile; can be given several times
    ///
    /// Such as --set textures.across=4.0. Units, ranges and defaults of all keys: "tactograph profiles show NAME".
    #[arg(long, value_name = "KEY=VALUE")]
    pub(in crate::cli) set: Vec<String>,

    /// Replaces numbered files and previews that are there already, whoever wrote them
    #[arg(long, visible_alias = "overwrite")]
    pub(in crate::cli) force: bool,

    /// Says nothing but errors
    #[arg(short, long)]
    pub(in crate::cli) quiet: bool,
}
