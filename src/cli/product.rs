//! What a command makes, in words and file names.

pub(super) use tactograph::{DotFormat, DrawingFormat, Format};

use tactograph::internals::output::dots::{gcode, pef};
use tactograph::internals::output::{json, pdf, png, svg};

/// What a command makes of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Product {
    /// A tactile page.
    Page(Format),
    /// Its contours as data, as JSON.
    Trace,
}

/// How much of a trace is looked at: its mark stands at its top.
const HEAD_BYTES: u64 = 64 << 10;
/// Largest file that can be a page of ours, which is far smaller.
const MOST_BYTES: u64 = 256 << 20;

impl Product {
    /// What it is called in messages.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Page(_) => "page",
            Self::Trace => "trace",
        }
    }

    /// The command that makes it.
    pub(super) fn verb(self) -> &'static str {
        match self {
            Self::Page(_) => "convert",
            Self::Trace => "trace",
        }
    }

    /// What has happened to a picture of which it was made.
    pub(super) fn done(self) -> &'static str {
        match self {
            Self::Page(_) => "converted",
            Self::Trace => "traced",
        }
    }

    /// How the names of its files end.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Page(format) => format.extension(),
            Self::Trace => "json",
        }
    }

    /// All endings that a name for it can have, in words.
    pub(super) fn endings(self) -> &'static str {
        match self {
            Self::Page(_) => ".svg, .pdf or .png, or for dots .ubrl, .brf, .pef, .idx, .gcode or .txt",
            Self::Trace => ".json",
        }
    }

    /// Whether there is no room in it for a note of who wrote it: every byte is a dot.
    pub(super) fn has_no_seal(self) -> bool {
        matches!(self, Self::Page(Format::Dots(DotFormat::Ubrl | DotFormat::Brf | DotFormat::Idx | DotFormat::Txt)))
    }

    /// How many bytes from its beginning [`Product::is_own`] needs of a file.
    pub(super) fn needs_of_file(self) -> u64 {
        match self {
            Self::Page(_) => MOST_BYTES,
            Self::Trace => HEAD_BYTES,
        }
    }

    /// Whether a file that begins with `head` is one as this program wrote it, with no work of a person in it.
    pub(super) fn is_own(self, head: &[u8]) -> bool {
        match self {
            // Pages carry a number that fits their bytes only as long as nobody changes them.
            Self::Page(Format::Drawing(DrawingFormat::Svg)) => svg::is_as_written(head),
            Self::Page(Format::Drawing(DrawingFormat::Pdf)) => pdf::is_as_written(head),
            Self::Page(Format::Drawing(DrawingFormat::Png) | Format::Dots(DotFormat::Pixels)) => {
                png::is_as_written(head)
            }
            Self::Page(Format::Dots(DotFormat::Pef)) => pef::is_as_written(head),
            Self::Page(Format::Dots(DotFormat::Gcode)) => gcode::is_as_written(head),
            // never taken for ours
            Self::Page(Format::Dots(DotFormat::Ubrl | DotFormat::Brf | DotFormat::Idx | DotFormat::Txt)) => false,
            // Whatever reads JSON and writes it again sets its spaces otherwise.
            Self::Trace => head.starts_with(json::MARK.as_bytes()),
        }
    }
}
