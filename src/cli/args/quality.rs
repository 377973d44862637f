//! `--quality`: how finely pictures are looked at.

use clap::ValueEnum;

/// Three points of the curve of run time against error that `tools/src/bin/knee` measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Quality {
    /// To see quickly what a page will be like
    Draft,
    /// What the profile says
    Standard,
    /// For pictures of many pixels that are worth the wait
    Fine,
}

impl Quality {
    /// As it is typed.
    pub(super) fn option(self) -> &'static str {
        match self {
            Self::Draft => "--quality draft",
            Self::Standard => "--quality standard",
            Self::Fine => "--quality fine",
        }
    }

    /// What it changes in the profile, as `KEY=VALUE`.
    pub(super) fn changes(self) -> &'static [&'static str] {
        match self {
            // A Gaussian derivative is no narrower than a pixel, so that at 2 px/mm 0.45 mm is 0.5; at 0.6 mm half as
            // much is missing and extra, in the same time.
            Self::Draft => &["figure.resolution=2", "edges.scale=0.6"],
            Self::Standard => &[],
            Self::Fine => &["figure.resolution=8"],
        }
    }
}
