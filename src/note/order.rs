//! In which order remarks are told: by the harm to the reader, as a long list is not heard to its end.

use super::harm::Harm;
use super::repeats::{leave_out, share_origin, share_remedy};
use super::{About, Note, Reason};

/// So much of the contours of a drawing is more than a few places where lines meet, percent.
const MUCH: u32 = 5;

impl Note {
    /// Brings remarks into the order in which they are told; those that weigh as much stay in theirs. What several
    /// would say is said once.
    pub(crate) fn sort(notes: &mut Vec<Self>) {
        leave_out(notes);
        notes.sort_by_key(Self::harm);
        share_remedy(notes);
        share_origin(notes);
    }

    /// What it means for the reader. Whoever adds a kind says it here, and of a reason in the table of all.
    fn harm(&self) -> Harm {
        match self {
            Self::OfFile(_, note) => note.harm(),
            Self::EmptyPage
            | Self::AllErased
            | Self::NoLines
            | Self::NoContours
            | Self::LinesOff
            | Self::NoBrailleCode(_)
            | Self::FirstPageOnly { .. } => Harm::Empty,
            Self::Faulty(..) | Self::TooDense { .. } | Self::InOtherCells(_) | Self::TooBlack { .. } => Harm::Wrong,
            Self::LetteringLeftOut { .. }
            | Self::TextsLeftOut(_)
            | Self::TextsNotRead(_)
            | Self::NoTexts { .. }
            | Self::NotTranslated { .. }
            | Self::NoRoomForTitle { .. }
            | Self::NothingCalmed
            | Self::FewContours(_) => Harm::ThingsMissing,
            Self::NotInBraille { .. } | Self::NoRoomForNumber => Harm::PartsMissing,
            Self::LinesLeftOut { percent, .. } if *percent >= MUCH => Harm::PartsMissing,
            Self::LinesLeftOut { .. } => Harm::Little,
            Self::ColourProfileIgnored(_)
            | Self::GroundAsPaper { .. }
            | Self::RimLeftOut(_)
            | Self::NotContracted
            | Self::Subject { .. }
            | Self::BackgroundCalmed(_)
            | Self::Abbreviated(_)
            | Self::MixedAreas { .. }
            | Self::Simplified { .. }
            | Self::UnevenDots => Harm::Changed,
            Self::NotOnPage(About::Overview, ..)
            | Self::TakenAs(About::Overview, ..)
            | Self::ShapesNotInOverview(_)
            | Self::LinesNotInOverview { .. }
            | Self::NoRoomForOverview => Harm::InOverview,
            // these are beside what is felt
            Self::NotOnPage(About::Widths | About::Print, ..) => Harm::Little,
            // there it is not left out
            Self::TakenAs(_, Reason::OutsideLayers | Reason::AreaTooSmall, _) => Harm::Changed,
            Self::LeftOut(reason, _)
            | Self::NotOnPage(_, reason, _)
            | Self::TakenAs(_, reason, _)
            | Self::LabelsLeftOut { reason, .. }
            | Self::NoKey(reason, _)
            | Self::NoSubject(reason, _) => reason.harm(),
            Self::NotInPng(..) => Harm::Otherwise,
        }
    }
}

#[cfg(test)]
mod tests;
