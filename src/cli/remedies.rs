//! What the library says, with the options of this program that help: it does not know them.

use tactograph::{Error, Note, Reason};

/// What went wrong, and with which option that can be mended.
pub(super) fn of_error(error: &Error) -> String {
    match error {
        Error::TooManyPixels { .. } => format!("{error} with --max-megapixels"),
        Error::TooMuchMemory { .. } | Error::UnpacksTooFar { .. } => format!("{error} with --max-memory"),
        Error::TooFine { .. } => format!("{error} with --dpi"),
        Error::TooWide { wanted, most, without_overview: Some(without) } => format!(
            "a figure {wanted} mm wide does not fit; {most:.1} mm is the most for this picture on this sheet, or \
             {without:.1} mm with --no-overview, so take one of these or a larger sheet"
        ),
        Error::TooWide { .. } => format!("{error}, or spread it over more sheets (--sheets ACROSSxDOWN)"),
        Error::IsAPage => format!("{error} (tactograph render)"),
        _ => error.to_string(),
    }
}

/// What is remarked, with the option that helps.
pub(super) fn of_note(note: &Note) -> String {
    match note {
        Note::FirstPageOnly { pages } => {
            format!("this is page 1 of {pages}; take another with --page 2, or all with --page 1-{pages}")
        }
        Note::LetteringLeftOut { .. } => format!("{note} (--keep-text)"),
        Note::GroundAsPaper { .. } | Note::RimLeftOut(..) => format!("{note} (--keep-ground)"),
        Note::TooDense { .. } => format!("{note} (--sheets 2x2, --crop)"),
        Note::NoRoomForOverview => format!("{note} (--sheets 2x2)"),
        Note::FewContours(_) => format!("{note} (--subject X,Y)"),
        Note::LinesNotInOverview { .. } => format!("{note} (--no-overview, --sheets 2x2)"),
        Note::EmptyPage => format!("{note} (--crop)"),
        Note::AllErased => format!("{note} (--erase, --keep)"),
        Note::TextsLeftOut(_) => format!("{note}; write them in braille with --labels texts"),
        Note::LinesLeftOut { is_larger_turned: true, .. } => {
            format!("{note} (--set page.orientation=landscape)")
        }
        Note::LabelsLeftOut { reason: Reason::NoRoomForLabel, .. } => {
            format!("{note}; a larger figure has more (--no-overview, --sheets 2x2, --profile swell-a3)")
        }
        Note::NoKey(Reason::KeyInOtherFile, _) => {
            format!("{note}: render that file too, or have the key written here again (--key always)")
        }
        Note::NoTexts => format!("{note} (--labels FILE)"),
        Note::NotInBraille { .. } | Note::InOtherCells(..) => {
            format!("{note} (--braille-table TABLE)")
        }
        _ => note.to_string(),
    }
}
