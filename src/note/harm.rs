//! How much harm it does to a reader what is remarked.

/// What a remark means for those who read the page, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Harm {
    /// There is nothing on the page, or hardly anything, or it may be another page than is wanted.
    Empty,
    /// The page says what the picture does not, or can hardly be read.
    Wrong,
    /// Whole things are missing: curves, shapes, bars, words.
    ThingsMissing,
    /// Parts of things are missing, or what tells them apart.
    PartsMissing,
    /// Textures of areas are missing, whose outlines are there.
    TexturesMissing,
    /// All is there, otherwise than in the picture: merged, moved, shorter, calmer.
    Changed,
    /// It is about the overview only, which a reader has beside the figure.
    InOverview,
    /// It rarely matters.
    Little,
    /// How to do it otherwise.
    Otherwise,
}
