//! What a sheet is among those that belong together, kept in the page among how it was made, so that whoever describes
//! the page later can tell.

use super::parts::{Page, TextRole};

const NAME: &str = "this sheet";
const OVERVIEW: &str = "overview";
const FOLLOWED: &str = "figure, its overview on the next sheet";
const OVERVIEW_OF: &str = "overview of ";
const AMONG: &str = " of ";

/// A sheet among those of one picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum InSet {
    /// The figure, whose overview has the next sheet to itself.
    Followed,
    /// The overview of the figure on the sheet before.
    Overview,
    /// The overview of a picture on sheets of these names.
    OverviewOf(Vec<String>),
    /// One of the sheets on which a picture lies: its name, and those of all.
    One(String, Vec<String>),
}

impl InSet {
    /// As an entry of a page's origin.
    pub fn to_origin(&self) -> (String, String) {
        let value = match self {
            Self::Followed => FOLLOWED.to_owned(),
            Self::Overview => OVERVIEW.to_owned(),
            Self::OverviewOf(names) => format!("{OVERVIEW_OF}{}", names.join(" ")),
            Self::One(name, names) => format!("{name}{AMONG}{}", names.join(" ")),
        };
        (NAME.to_owned(), value)
    }

    /// What a page says of itself; nothing of a page that stands alone.
    pub fn of(page: &Page) -> Option<Self> {
        let value = page.origin.iter().find(|(name, _)| name == NAME).map(|(_, value)| value.as_str())?;
        let names = |text: &str| text.split_whitespace().map(str::to_owned).collect();
        match value {
            OVERVIEW => Some(Self::Overview),
            FOLLOWED => Some(Self::Followed),
            _ => match (value.strip_prefix(OVERVIEW_OF), value.split_once(AMONG)) {
                (Some(all), _) => Some(Self::OverviewOf(names(all))),
                (None, Some((name, all))) => Some(Self::One(name.to_owned(), names(all))),
                (None, None) => None,
            },
        }
    }
}

impl Page {
    /// What this sheet is among those of its picture, in a word: the figure, its overview, its key, or the name of
    /// one of the sheets on which a picture lies.
    pub fn part_of_set(&self) -> String {
        match InSet::of(self) {
            Some(InSet::Overview | InSet::OverviewOf(_)) => "overview".to_owned(),
            Some(InSet::One(name, _)) => name,
            _ if self.braille.iter().any(|text| text.role == TextRole::Key) => "key".to_owned(),
            _ => "figure".to_owned(),
        }
    }
}
