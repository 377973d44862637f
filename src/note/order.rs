//! In which order remarks are told: what makes a page wrong first, as a long list is not read to its end.

use super::{About, Note, Reason};

/// So much of the contours of a drawing is more than a few places where lines meet, percent.
const MUCH: u32 = 5;

impl Note {
    /// Remarks in the order in which they are told; those that weigh as much stay in theirs.
    pub(crate) fn sort(notes: &mut [Self]) {
        notes.sort_by_key(Self::rank);
    }

    /// How far down it is told.
    fn rank(&self) -> u8 {
        match self {
            Self::OfFile(_, note) => note.rank(),
            // there is nothing on the page, or hardly anything
            Self::EmptyPage | Self::AllErased | Self::NoLines | Self::NoContours | Self::LinesOff => 0,
            Self::NoBrailleCode(_) => 0,
            // it may be another page than is wanted
            Self::FirstPageOnly { .. } => 0,
            Self::TakenAs(_, Reason::NoLinesGiven | Reason::NoDrawing, _) => 0,
            Self::Faulty(..) | Self::TooDense { .. } => 1,
            // of an overview only, which a reader has beside the figure
            Self::NotOnPage(About::Overview, ..)
            | Self::TakenAs(About::Overview, ..)
            | Self::ShapesNotInOverview(_)
            | Self::LinesNotInOverview { .. }
            | Self::NoRoomForOverview => 5,
            // all of it is there
            Self::TakenAs(_, Reason::InMargin | Reason::OneUnit, _) => 4,
            // the page says something else
            Self::TakenAs(About::Leaders | About::Braille, ..) | Self::InOtherCells(_) | Self::MixedAreas { .. } => 2,
            Self::NotOnPage(About::Widths | About::Print, ..) => 4,
            // it lacks something
            Self::NotOnPage(..)
            | Self::LabelsLeftOut { .. }
            | Self::LetteringLeftOut { .. }
            | Self::LeftOut(..)
            | Self::NotInBraille { .. }
            | Self::NotTranslated { .. }
            | Self::NoRoomForTitle { .. }
            | Self::NoRoomForNumber
            | Self::NoSubject(..)
            | Self::NothingCalmed
            | Self::FewContours(_)
            | Self::NoTexts
            | Self::TextsLeftOut(_)
            | Self::TextsNotRead(_)
            | Self::TooBlack { .. } => 3,
            Self::LinesLeftOut { percent, .. } if *percent >= MUCH => 3,
            // how it is drawn
            _ => 4,
        }
    }
}

#[cfg(test)]
mod tests;
