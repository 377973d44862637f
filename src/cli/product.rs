//! What a command makes, in words and file names.

pub(super) use tactograph::{DrawingFormat, Format};

use tactograph::{DotFormat, Trace};

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

    /// What its format is called.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Page(format) => format.name(),
            Self::Trace => "json",
        }
    }

    /// All endings that a name for it can have, in words.
    pub(super) fn endings(self) -> String {
        let drawings: Vec<&str> = DrawingFormat::ALL.iter().map(|format| format.name()).collect();
        let of_dots = DotFormat::ALL.iter().map(|format| format.extension());
        let dots: Vec<&str> = of_dots.filter(|ending| !drawings.contains(ending)).collect();
        match self {
            Self::Page(_) => format!("{}, or for dots {}", either(&drawings), either(&dots)),
            Self::Trace => ".json".into(),
        }
    }

    /// Whether there is no room in it for a note of who wrote it: every byte is a dot.
    pub(super) fn has_no_seal(self) -> bool {
        match self {
            Self::Page(format) => format.is_as_written(&[]).is_none(),
            Self::Trace => false,
        }
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
            Self::Page(format) => format.is_as_written(head) == Some(true),
            Self::Trace => Trace::is_json_as_written(head),
        }
    }
}

/// As in ".svg, .pdf or .png".
fn either(endings: &[&str]) -> String {
    let endings: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    match &endings[..] {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        all => all.concat(),
    }
}
