//! Options that all commands on pictures have.

use clap::{Args, ValueEnum};
use tactograph::{Limits, Profile};

use super::pages::Pages;
use crate::cli::settings::Change;

/// Largest value for a limit: a million megapixels or megabytes is beyond any machine, and far from overflow in bytes.
const MOST: u64 = 1_000_000;

/// Options that all commands on pictures have.
#[derive(Debug, Args)]
pub(in crate::cli) struct Shared {
    /// Paper and settings: a name from "tactograph profiles" or a .toml file of your own
    ///
    /// A value that ends in .toml or has a directory in it is a file. Begin your own with a line such as
    /// inherits = "swell-a4" and write down only what differs; "tactograph profiles show swell-a4" prints every key
    /// with its unit, range and reason.
    #[arg(long, value_name = "NAME|FILE.toml", default_value = Profile::built_in()[0].name)]
    pub(in crate::cli) profile: String,

    /// Changes one value of the profile; can be given several times
    ///
    /// Such as --set lines.width_max=1.2. Units, ranges and defaults of all keys: "tactograph profiles show NAME".
    /// If a key is set twice, the last one counts.
    #[arg(long, value_name = "KEY=VALUE")]
    pub(in crate::cli) set: Vec<String>,

    /// How many lines the page has: 0 the most important outlines only, 1 all that fingers can tell apart
    ///
    /// The longest, strongest, closed and smooth lines come first; those of less detail are all on the page of more.
    /// The same as --set lines.detail=D given after every other --set. Range: 0 to 1.
    ///
    /// [default: the profile's, 0.5 in those that come with the program]
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    pub(in crate::cli) detail: Option<String>,

    /// How closely to look: draft, standard or fine
    ///
    /// A draft shows quickly what a page will be like; fine is for pictures of many pixels that are worth the wait,
    /// and is hardly to be felt. Measured on A4 pages of pictures of 9 to 12 megapixels ("within" holds for 95 % of
    /// the length of lines; a fingertip notices about 1 mm): draft takes a fifth to a quarter less time than
    /// standard, lines lie within 0.3 mm of where they should be, and in a photo 4 % of their length is missing or
    /// other; standard: within 0.14 mm, 1.5 %; fine takes nearly twice the time: within 0.07 mm. A picture is never
    /// worked on at more pixels than it has, so that for small ones fine is the same as standard; of a small photo a
    /// draft draws a tenth or more of the lines otherwise.
    ///
    /// The same as --set figure.resolution=2 --set edges.scale=0.6 (draft) and --set figure.resolution=8 (fine) given
    /// before every other --set; standard changes nothing. It does nothing for trace --full-resolution.
    #[arg(long, value_enum, default_value_t = Quality::Standard, hide_possible_values = true)]
    quality: Quality,

    /// Page of a PDF document, or several such as 1-4
    ///
    /// The first is 1. With one page, the result is called as the document is; with several, each is a file with the
    /// number of its page, such as worksheet-1.svg to worksheet-4.svg. Any other picture is one page.
    ///
    /// [default: the first page; if there are more, that is told]
    #[arg(long, value_name = "N|N-M", allow_hyphen_values = true)]
    pub(in crate::cli) page: Option<Pages>,

    /// Tells how long each stage took, by the clock and in working time (CPU), in milliseconds
    ///
    /// Written to standard error for each picture, also under --quiet. Stages that are not needed are listed as
    /// "skipped" with the reason; "other" is what is part of no stage.
    #[arg(long, hide_short_help = true)]
    pub(in crate::cli) timings: bool,

    /// Says nothing but errors
    #[arg(short, long)]
    pub(in crate::cli) quiet: bool,

    /// Replaces files that are there already
    ///
    /// Without it, a file whose name the program makes up is replaced only if it is as this program wrote it. Where a
    /// format cannot tell that (ubrl, brf, idx, txt), only if the new one has the same bytes. A picture is never
    /// overwritten.
    #[arg(long, visible_alias = "overwrite")]
    pub(in crate::cli) force: bool,

    /// Refuses pictures with more pixels than this, in millions of pixels
    ///
    /// Checked before decoding. A guard against files that claim to be huge. Range: 1 to 1000000.
    #[arg(long, value_name = "N", default_value_t = Limits::default().megapixels)]
    #[arg(value_parser = limit, hide_short_help = true)]
    max_megapixels: u64,

    /// Refuses pictures that take more memory than this, in megabytes
    ///
    /// Counts what one picture needs for its file and, apart from that, for decoding it; pictures that are worked on
    /// side by side each have this much. Range: 1 to 1000000.
    #[arg(long, value_name = "MB", default_value_t = Limits::default().memory_mb)]
    #[arg(value_parser = limit, hide_short_help = true)]
    max_memory: u64,
}

impl Shared {
    /// All changes to the profile, in the order in which they count.
    pub(in crate::cli) fn changes(&self) -> Vec<Change> {
        let quality = self.quality.changes().iter().map(|set| Change::of_option(self.quality.option(), set));
        let sets = self.set.iter().map(|set| Change::set(set));
        let of_detail = |detail: &String| {
            Change::of_option(&format!("--detail {}", detail.trim()), &format!("lines.detail={}", detail.trim()))
        };
        quality.chain(sets).chain(self.detail.iter().map(of_detail)).collect()
    }

    /// What a picture may cost.
    pub(in crate::cli) fn limits(&self) -> Limits {
        Limits { megapixels: self.max_megapixels, memory_mb: self.max_memory }
    }
}

fn limit(text: &str) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (1..=MOST).contains(number));
    number.ok_or_else(|| format!("give a whole number from 1 to {MOST}"))
}

/// `--quality`, how finely pictures are looked at: three points of the curve of run time against error that
/// `tools/src/bin/knee` measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Quality {
    /// To see quickly what a page will be like
    Draft,
    /// What the profile says
    Standard,
    /// For pictures of many pixels that are worth the wait
    Fine,
}

impl Quality {
    /// As it is typed.
    fn option(self) -> &'static str {
        match self {
            Self::Draft => "--quality draft",
            Self::Standard => "--quality standard",
            Self::Fine => "--quality fine",
        }
    }

    /// What it changes in the profile, as `KEY=VALUE`.
    fn changes(self) -> &'static [&'static str] {
        match self {
            // A Gaussian derivative is no narrower than a pixel, so that at 2 px/mm 0.45 mm is 0.5. At 0.6 mm a seventh
            // less is missing and extra in the sample photographs, in the same time; lines of a large one lie a fifth
            // farther off.
            Self::Draft => &["figure.resolution=2", "edges.scale=0.6"],
            Self::Standard => &[],
            Self::Fine => &["figure.resolution=8"],
        }
    }
}
