//! What a command makes of a picture, in words and file names.

/// What a command makes of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Product {
    /// A tactile page, as SVG.
    Page,
    /// Its contours as data, as JSON.
    Trace,
}

impl Product {
    /// What it is called in messages.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Page => "page",
            Self::Trace => "trace",
        }
    }

    /// The command that makes it.
    pub(super) fn verb(self) -> &'static str {
        match self {
            Self::Page => "convert",
            Self::Trace => "trace",
        }
    }

    /// What has happened to a picture of which it was made.
    pub(super) fn done(self) -> &'static str {
        match self {
            Self::Page => "converted",
            Self::Trace => "traced",
        }
    }

    /// How the names of its files end.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Page => "svg",
            Self::Trace => "json",
        }
    }

    /// Whether a file that begins with `head` is one as this program wrote it, with no work of a person in it.
    pub(super) fn is_own(self, head: &[u8]) -> bool {
        let has = |mark: &str| head.windows(mark.len()).any(|part| part == mark.as_bytes());
        match self {
            Self::Page => {
                // Editors leave their own marks in what they save: Inkscape its version and its window, Illustrator a comment.
                let edited = has("sodipodi:") || has("inkscape:version") || has("Illustrator");
                has("<metadata>program = tactograph ") && !edited
            }
            // Whatever reads JSON and writes it again sets its spaces otherwise.
            Self::Trace => head.starts_with(tactograph::output::json::MARK.as_bytes()),
        }
    }
}
