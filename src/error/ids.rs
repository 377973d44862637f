//! By which words programs tell errors apart.

use super::Error;

/// `id` and `ids` from one table of what can be, so that the list of ids is whole.
macro_rules! id_table {
    ($($case:pat => $id:literal,)+) => {
        /// Its kind as a word for programs, one of those that `ids` gives. It stays the same when the sentence changes.
        pub fn id(&self) -> &'static str {
            match self {
                $($case => $id,)+
            }
        }

        /// Every id that there is, each once. A later release may have more.
        pub fn ids() -> &'static [&'static str] {
            &[$($id),+]
        }
    };
}
pub(crate) use id_table;

impl Error {
    id_table! {
        Self::Empty => "empty",
        Self::UnknownFormat { .. } => "unknown-format",
        Self::Undecodable { .. } => "undecodable",
        Self::TooComplex { .. } => "too-complex",
        Self::Locked { .. } => "locked",
        Self::TooManyPixels { .. } => "too-many-pixels",
        Self::TooMuchMemory { .. } => "too-much-memory",
        Self::UnpacksTooFar { .. } => "unpacks-too-far",
        Self::TooFewPixels { .. } => "too-few-pixels",
        Self::TooNarrow { .. } => "too-narrow",
        Self::NotWideEnough { .. } => "not-wide-enough",
        Self::NotInPicture { .. } => "not-in-picture",
        Self::NotInFigure { .. } => "not-in-figure",
        Self::PartInMm { .. } => "part-in-mm",
        Self::NoSuchPage { .. } => "no-such-page",
        Self::TooWide { .. } => "too-wide",
        Self::NoWidth { .. } => "no-width",
        Self::NoRoomOnSheets { .. } => "no-room-on-sheets",
        Self::OffSheet(..) => "off-sheet",
        Self::NoMeasure { .. } => "no-measure",
        Self::NoPages => "no-pages",
        Self::NoRoom { .. } => "no-room",
        Self::CannotPress(..) => "cannot-press",
        Self::NotOfDots { .. } => "not-of-dots",
        Self::NotAllDots => "not-all-dots",
        Self::NotItsFormat { .. } => "not-its-format",
        Self::NotItsDots(..) => "not-its-dots",
        Self::NotTogether(..) => "not-together",
        Self::NoSuchEmbossing { .. } => "no-such-embossing",
        Self::NotAFont { .. } => "not-a-font",
        Self::TooFine { .. } => "too-fine",
        Self::WrongPixels { .. } => "wrong-pixels",
        Self::NoSuchDpi { .. } => "no-such-dpi",
        Self::NoSuchThresholds { .. } => "no-such-thresholds",
        Self::NotACrop => "not-a-crop",
        Self::NotASheetGrid => "not-a-sheet-grid",
        Self::NotASign => "not-a-sign",
        Self::NotAPosition => "not-a-position",
        Self::NotLabels(..) => "not-labels",
        Self::TooLargeToFeel { .. } => "too-large-to-feel",
        Self::NoSuchFinger(..) => "no-such-finger",
        Self::NotAPage { .. } => "not-a-page",
        Self::IsAPage => "is-a-page",
        Self::IsAPageIn { .. } => "is-a-page-in",
        Self::NoSuchName { .. } => "no-such-name",
        Self::OtherShape { .. } => "other-shape",
        Self::OtherPart { .. } => "other-part",
        Self::NoMemory { .. } => "no-memory",
        Self::Cancelled => "cancelled",
        Self::Profile(..) => "profile",
    }
}
