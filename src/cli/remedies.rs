//! What the library says, with the options of this program that help: it does not know them.

use tactograph::{Error, Note, Profile, Reason};

/// What there is that makes the figure of a picture larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Larger {
    /// Whether it is larger without the overview, which is on the same sheet.
    without_overview: bool,
    /// Whether it is larger on the same sheet lying across.
    turned: bool,
    /// Whether it is on one sheet.
    is_on_one_sheet: bool,
    /// Whether it is as wide as was asked for, on whatever paper and however many sheets.
    is_of_width_asked: bool,
    /// The profile of the next larger paper; none of a profile of one's own, whose settings that would not have.
    profile: Option<&'static str>,
    /// Whether all that was told of this page already.
    is_told: bool,
}

/// Profiles of paper, and those of the next larger one.
const NEXT_LARGER: [(&str, &str); 3] =
    [("swell-a4", "swell-a3"), ("swell-letter", "swell-11x17"), ("swell-11x11.5", "swell-11x17")];

impl Larger {
    fn than(profile: &Profile, is_spread: bool) -> Self {
        let next = NEXT_LARGER.into_iter().find(|(name, _)| profile.name == *name);
        let profile = next.map(|(_, larger)| larger);
        let is_on_one_sheet = !is_spread;
        Self {
            without_overview: false,
            turned: false,
            is_on_one_sheet,
            is_of_width_asked: false,
            profile,
            is_told: false,
        }
    }

    /// The options for it, in parentheses, first what helps most; none where there are none.
    fn options(self) -> Option<String> {
        let overview = self.without_overview.then(|| "--no-overview".to_owned());
        let turned = self.turned.then(|| TURNED.to_owned());
        let sheets = self.is_on_one_sheet.then(|| SHEETS.to_owned());
        let profile = self.profile.map(|name| format!("--profile {name}"));
        let all: Vec<String> = [overview, turned, sheets, profile].into_iter().flatten().collect();
        (!all.is_empty() && !self.is_of_width_asked && !self.is_told).then(|| format!("({})", all.join(", ")))
    }
}

const SHEETS: &str = "--sheets 2x2";
const TURNED: &str = "--set page.orientation=landscape";

/// What is made, which says what options there are that help.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Making {
    /// A page of a picture, for print.
    Print(Larger),
    /// A page of a picture, for an embosser.
    Embossing(Larger),
    /// A page of a picture for a pin display, which has one sheet of one size.
    Pins,
    /// A page that was read, laid out anew for another paper or device.
    PageAnew,
    /// Anything else: a page that was read as it is, what is found on it, or contours.
    #[default]
    Other,
}

impl Making {
    /// That of a page of a picture with a profile, which is on one sheet or spread over several.
    pub(super) fn of_picture(profile: &Profile, is_spread: bool) -> Self {
        let larger = Larger::than(profile, is_spread);
        match profile.dots.device {
            None => Self::Print(larger),
            Some(device) if device.field().is_some() => Self::Pins,
            Some(_) => Self::Embossing(larger),
        }
    }

    /// The same where the figure would be larger without the overview, or would not.
    pub(super) fn beside_overview(self, is_larger_without: bool) -> Self {
        match self {
            Self::Print(larger) => Self::Print(Larger { without_overview: is_larger_without, ..larger }),
            // there it has a sheet of its own
            other => other,
        }
    }

    /// The same where the figure would be larger on a sheet that lies across, or would not.
    pub(super) fn turned(self, is_larger_turned: bool) -> Self {
        match self {
            Self::Embossing(larger) => Self::Embossing(Larger { turned: is_larger_turned, ..larger }),
            // the library says so of devices only
            other => other,
        }
    }

    /// The same where the width of the figure is asked for, or is not.
    pub(super) fn of_width(self, is_asked: bool) -> Self {
        match self {
            Self::Print(larger) => Self::Print(Larger { is_of_width_asked: is_asked, ..larger }),
            Self::Embossing(larger) => Self::Embossing(Larger { is_of_width_asked: is_asked, ..larger }),
            other => other,
        }
    }

    /// The same where what makes its figure larger was told already.
    fn told(self) -> Self {
        match self {
            Self::Print(larger) => Self::Print(Larger { is_told: true, ..larger }),
            Self::Embossing(larger) => Self::Embossing(Larger { is_told: true, ..larger }),
            other => other,
        }
    }

    /// The options that make its figure larger, in parentheses; none where there are none.
    fn larger(self) -> Option<String> {
        match self {
            Self::Print(larger) | Self::Embossing(larger) => larger.options(),
            Self::Pins | Self::PageAnew | Self::Other => None,
        }
    }

    /// Whether it is made of a picture, of which a part can be taken.
    fn is_of_picture(self) -> bool {
        matches!(self, Self::Print(_) | Self::Embossing(_) | Self::Pins)
    }

    /// Whether its figure would be larger without the overview.
    fn is_larger_without_overview(self) -> bool {
        matches!(self, Self::Print(larger) if larger.without_overview)
    }

    /// Whether a picture can be spread over several sheets, and is not yet.
    fn has_sheets(self) -> bool {
        matches!(self, Self::Print(larger) | Self::Embossing(larger) if larger.is_on_one_sheet)
    }
}

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

/// What is remarked of a page, with the options that help where this is made. Those that make the figure larger are
/// told once.
pub(super) fn of_notes(notes: &[Note], making: Making) -> Vec<String> {
    let mut making = making;
    let of_next = |note: &Note| {
        let told = of_note(note, making);
        let has_options = |options: &String| told.contains(options.as_str());
        // a drawing that is too dense and on one sheet has options of its own for it
        let is_dense = matches!(note, Note::TooDense { .. }) && making.has_sheets();
        if is_dense || making.larger().as_ref().is_some_and(has_options) {
            making = making.told();
        }
        told
    };
    notes.iter().map(of_next).collect()
}

/// What is remarked, with the option that helps where this is made.
pub(super) fn of_note(note: &Note, making: Making) -> String {
    match note {
        Note::FirstPageOnly { pages } => {
            format!("this is page 1 of {pages}; take another with --page 2, or all with --page 1-{pages}")
        }
        Note::LetteringLeftOut { .. } => format!("{note} (--keep-text)"),
        Note::GroundAsPaper { .. } | Note::RimLeftOut(..) => format!("{note} (--keep-ground)"),
        Note::NotOnPage(_, Reason::GroundBlank, _) if making.is_of_picture() => {
            format!("{note} (--set figure.ground=true)")
        }
        Note::NotOnPage(_, Reason::PaperEdge, _) => format!("{note} (--crop, --keep-ground)"),
        Note::NotOnPage(_, Reason::FirstNotInOverview, _) => {
            format!("{note} (--subject with this place, or --simplify 5)")
        }
        Note::NotOnPage(_, Reason::ThingNotInOverview, _) => format!("{note} (--subject X,Y, or --simplify 5)"),
        Note::TooDense { .. } if making.has_sheets() => match making.larger() {
            Some(_) if making.is_larger_without_overview() => format!("{note} (--no-overview, {SHEETS}, --crop)"),
            Some(_) => format!("{note} ({SHEETS}, --crop)"),
            None => format!("{note} (--crop)"),
        },
        Note::NoRoomForOverview if making.has_sheets() => format!("{note} ({SHEETS})"),
        Note::FewContours(_) => format!("{note} (--subject X,Y)"),
        Note::LinesNotInOverview { .. } => match making {
            Making::Print(_) | Making::Embossing(_) if making.has_sheets() => {
                format!("{note} (--no-overview, {SHEETS})")
            }
            Making::Print(_) | Making::Embossing(_) | Making::Pins => format!("{note} (--no-overview)"),
            Making::PageAnew => format!("{note} (--set overview.on=false)"),
            Making::Other => note.to_string(),
        },
        Note::Faulty(_, reason, _) => of_fault(note, *reason, making),
        Note::EmptyPage if making.is_of_picture() => format!("{note} (--crop)"),
        Note::AllErased => format!("{note} (--erase, --keep)"),
        Note::TextsLeftOut(_) => format!("{note}; write them in braille with --labels texts"),
        Note::LinesLeftOut { is_larger_turned, .. } => match (making.larger(), making) {
            (Some(options), _) => format!("{note} {options}"),
            (None, Making::PageAnew) if *is_larger_turned => format!("{note} ({TURNED})"),
            (None, _) => note.to_string(),
        },
        Note::LabelsLeftOut { reason: Reason::NoRoomForLabel, .. } => with_larger(note, HAS_MORE, making),
        // the sheet has room for them as it is, without larger paper
        Note::Abbreviated(_) if making.larger().is_some() && making.is_larger_without_overview() => {
            format!("{note}; without the overview there is more room for them (--no-overview)")
        }
        Note::TakenAs(_, Reason::OverviewForWords, _) => with_larger(note, "", making),
        Note::NoKey(Reason::KeyInOtherFile, _) => {
            format!("{note}: render that file too, or have the key written here again (--key always)")
        }
        Note::NoTexts { are_unread: true } => format!("{note} (--ocr, --labels FILE)"),
        Note::NoTexts { are_unread: false } => format!("{note} (--labels FILE)"),
        Note::NotOnPage(_, Reason::HeadingNotInFull, _) => format!("{note} (--title TEXT)"),
        Note::TakenAs(_, Reason::NoMetadata, _) => format!("{note} (--profile NAME)"),
        Note::NotInBraille { .. } | Note::InOtherCells(..) => format!("{note} (--braille-table TABLE)"),
        _ => match making.larger().and_then(|options| note.with_how_larger(&options)) {
            Some(with_options) => with_options.to_string(),
            None => note.to_string(),
        },
    }
}

const HAS_MORE: &str = "; a larger figure has more";

/// What is remarked, with what a larger figure is good for and the options for it where there are some.
fn with_larger(note: &Note, what: &str, making: Making) -> String {
    making.larger().map_or_else(|| note.to_string(), |options| format!("{note}{what} {options}"))
}

/// What is remarked of a page as a whole that is hard to read.
fn of_fault(note: &Note, reason: Reason, making: Making) -> String {
    match (reason, making) {
        (Reason::AmongRows, Making::Embossing(_) | Making::Pins | Making::Print(_)) => {
            format!("{note} (--outlines, --subject X,Y --calm-background)")
        }
        (Reason::AmongRows, Making::PageAnew) => format!("{note} (--set figure.textures=false)"),
        (Reason::LooseEnds, making) if making.is_of_picture() => {
            format!("{note} (--detail 0.2, --simplify 5, --subject X,Y --calm-background)")
        }
        _ => note.to_string(),
    }
}

#[cfg(test)]
mod tests;
