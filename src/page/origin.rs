//! What a page says of itself among the entries of how it was made, so that whoever checks or describes it later can
//! tell: what was left out of it, which of several sheets it is, and what its key tells.

use super::parts::{Class, Page, Parts, TextRole};
use crate::geom::ninths::most_of;
use crate::units::Size;

impl Page {
    /// How it was made, with what it is made for: a page that a program made of its parts need not say so itself.
    pub(crate) fn whole_origin(&self) -> Vec<(String, String)> {
        let said = |name: &str| self.origin.iter().any(|(known, _)| known == name);
        let of_medium = self.medium.to_origin(self.sheet).into_iter().filter(|(name, _)| !said(name));
        let of_medium = of_medium.map(|(name, value)| (name.to_owned(), value));
        self.origin.iter().cloned().chain(of_medium).collect()
    }
}

const CONTOURS: &str = "contours left out in mm";
const PLACES: &str = "contours left out in mm by ninths";
const SHAPES: &str = "closed shapes not in the overview";
const KIND: &str = "contours are those of";
const TEXTS: &str = "texts left out";
const LABELS: &str = "labels left out";
const AREAS: &str = "areas too small for a texture";
const PHOTOGRAPH: &str = "a photograph";

/// What was not drawn when a page was made: contours that were worth a line, areas, and words.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    /// Their length, whole mm.
    pub millimetres: u32,
    /// Length of all that was worth a line, whole mm.
    pub of: u32,
    /// Their length in each of nine parts of the figure, row by row from the top left, whole mm.
    pub by_place: Option<[u32; 9]>,
    /// Closed shapes of a drawing that are not in its overview.
    pub shapes: u32,
    /// Whether the picture is a photograph, and no drawing in which every line is meant.
    pub of_photograph: bool,
    /// Areas of a drawing that are too small for a texture.
    pub areas: u32,
    /// Texts of the picture that are neither drawn nor written.
    pub texts: u32,
    /// Labels that are not written.
    pub labels: u32,
}

impl LeftOut {
    /// Of a photograph the maker is told of contours that are not drawn from this share on. Less is what joins,
    /// corners, the middles of strokes and leaves or waves cost: of pages that are told from 0.1 on, 76 of 100 were.
    pub const TOLD: f32 = 0.2;
    /// From this share on a page of a photograph has a fault; who makes or checks it is told from less on. Photographs
    /// of many things leave out 0.2 to 0.3 and lose little by it.
    pub const CROWDED: f32 = 0.35;

    /// As entries of a page's origin; nothing of nothing.
    pub fn to_origin(self) -> Vec<(String, String)> {
        let Self { millimetres, of, by_place, shapes, of_photograph, areas, texts, labels } = self;
        let mut origin = Vec::new();
        if millimetres > 0 {
            origin.push((CONTOURS.to_owned(), format!("{millimetres} of {of}")));
            let list = |places: [u32; 9]| places.map(|mm| mm.to_string()).join(" ");
            origin.extend(by_place.map(|places| (PLACES.to_owned(), list(places))));
        }
        // also of one that lacks nothing, or of few shapes: whoever reads the page must know what it is of
        if of > 0 {
            origin.extend(of_photograph.then(|| (KIND.to_owned(), PHOTOGRAPH.to_owned())));
        }
        if shapes > 0 {
            origin.push((SHAPES.to_owned(), shapes.to_string()));
        }
        let counts = [(AREAS, areas), (TEXTS, texts), (LABELS, labels)].into_iter().filter(|(_, count)| *count > 0);
        origin.extend(counts.map(|(name, count)| (name.to_owned(), count.to_string())));
        origin
    }

    /// What a page says of itself.
    pub fn of(page: &Page) -> Self {
        let value = |name: &str| page.origin.iter().find(|(of, _)| of == name).map(|(_, value)| value.as_str());
        let whole = |text: &str| text.trim().parse::<u32>().ok();
        let contours = value(CONTOURS).and_then(|text| text.split_once(" of "));
        let (millimetres, of) = contours.and_then(|(a, b)| Some((whole(a)?, whole(b)?))).unwrap_or_default();
        let places = value(PLACES).and_then(|text| text.split(' ').map(whole).collect::<Option<Vec<u32>>>());
        let by_place = places.and_then(|places| places.try_into().ok());
        let count = |name: &str| value(name).and_then(whole).unwrap_or_default();
        let [shapes, areas, texts, labels] = [SHAPES, AREAS, TEXTS, LABELS].map(count);
        let of_photograph = value(KIND) == Some(PHOTOGRAPH);
        Self { millimetres, of, by_place, shapes, of_photograph, areas, texts, labels }
    }

    /// Share of what was worth a line, 0..=1.
    pub fn share(&self) -> f32 {
        if self.of > 0 { (self.millimetres as f32 / self.of as f32).min(1.0) } else { 0.0 }
    }

    /// The ninth of the figure in which most of it is, if there is one and that is known.
    pub fn most_in(&self) -> Option<usize> {
        most_of(self.by_place?.map(|mm| mm as f32))
    }
}

/// The entry of a sheet of samples, which says its number and that of all.
pub const SAMPLES: &str = "calibration sheet";

impl Parts {
    /// Whether it is a sheet of samples, which are as they are on purpose.
    pub(crate) fn has_samples(&self) -> bool {
        self.origin.iter().any(|(name, _)| name == SAMPLES)
    }
}

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

const PART: &str = "part of the picture";
const DOCUMENT_PAGE: &str = "page of the document";

/// How much of a picture a page shows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PartShown {
    /// The part, as it was asked for; without one all of it.
    pub crop: Option<String>,
    /// The page of a document; without one the first.
    pub page: Option<u32>,
    /// The name of the sheet, where the part lies on several.
    pub sheet: Option<String>,
    /// Size of the picture, px, where it is known.
    pub source: Option<Size>,
}

impl PartShown {
    /// As entries of a page's origin; nothing of all of a picture. The sheet has an entry of its own.
    pub fn to_origin(&self) -> Vec<(String, String)> {
        let page = self.page.map(|page| (DOCUMENT_PAGE.to_owned(), page.to_string()));
        let part = self.crop.clone().map(|crop| (PART.to_owned(), crop));
        page.into_iter().chain(part).collect()
    }

    /// What a page says of itself; nothing of one that says nothing of how it was made.
    pub fn of(page: &Page) -> Option<Self> {
        let value = |name: &str| page.origin.iter().find(|(of, _)| of == name).map(|(_, value)| value.as_str());
        let sheet = match InSet::of(page) {
            Some(InSet::One(name, _)) => Some(name),
            Some(InSet::Followed | InSet::Overview | InSet::OverviewOf(_)) | None => None,
        };
        let crop = value(PART).map(str::to_owned);
        let page_number = value(DOCUMENT_PAGE).and_then(|number| number.parse().ok());
        let source = Some(page.figure.source);
        (!page.origin.is_empty()).then_some(Self { crop, page: page_number, sheet, source })
    }

    /// In words.
    pub fn in_words(&self) -> String {
        let part = self.crop.as_ref().map_or_else(|| "all of it".to_owned(), |crop| format!("the part {crop} of it"));
        let page = self.page.map_or_else(String::new, |page| format!(", page {page}"));
        let sheet = self.sheet.as_ref().map_or_else(String::new, |name| format!(", of which sheet {name} has a piece"));
        format!("{part}{page}{sheet}")
    }
}

const COLOURS: &str = "colour in the key";
const ABBREVIATIONS: &str = "abbreviation in the key";
const BLANK: &str = "blank in the key";
const TITLE: &str = "title in the key";
/// Between a colour or an abbreviation and what it stands for.
const MEANS: &str = ": ";

/// What the key of a page tells, which has sheets to itself.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ToldInKey {
    /// Its colours, each with what it means by the legend of the drawing, if it does; one that means several things
    /// is there several times.
    pub colours: Vec<(Class, Option<String>)>,
    /// Abbreviations and what they stand for.
    pub abbreviations: Vec<(String, String)>,
    /// The colours that areas without a texture have in the drawing, each with what it means by the legend, if it does.
    pub blank: Vec<(Class, Option<String>)>,
    /// The title of the page, where it has no room above the figure and stands in the key alone.
    pub title: Option<String>,
}

impl ToldInKey {
    /// As entries of a page's origin; nothing of nothing.
    pub fn to_origin(&self) -> Vec<(String, String)> {
        // each is one line of the file
        let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let colour = |(class, means): &(Class, Option<String>)| match means {
            Some(means) => format!("{}{MEANS}{}", class.name(), line(means)),
            None => class.name().to_owned(),
        };
        let colours = self.colours.iter().map(|of| (COLOURS.to_owned(), colour(of)));
        let blank = self.blank.iter().map(|of| (BLANK.to_owned(), colour(of)));
        let abbreviation = |(short, text): &(String, String)| {
            (ABBREVIATIONS.to_owned(), format!("{}{MEANS}{}", line(short), line(text)))
        };
        let title = self.title.iter().map(|title| (TITLE.to_owned(), line(title)));
        let colours = title.chain(colours).chain(blank);
        colours.chain(self.abbreviations.iter().map(abbreviation)).collect()
    }

    /// What a page says of its key; nothing of one without a key.
    pub fn of(page: &Page) -> Option<Self> {
        let values =
            |name: &'static str| page.origin.iter().filter(move |(of, _)| of == name).map(|(_, value)| value.as_str());
        let colour = |value: &str| {
            let (name, means) = value.split_once(MEANS).map_or((value, None), |(name, means)| (name, Some(means)));
            let class = Class::ALL.into_iter().find(|class| class.name() == name.trim())?;
            Some((class, means.map(str::to_owned)))
        };
        let pair = |value: &str| value.split_once(MEANS).map(|(short, text)| (short.to_owned(), text.to_owned()));
        let told = Self {
            colours: values(COLOURS).filter_map(colour).collect(),
            blank: values(BLANK).filter_map(colour).collect(),
            abbreviations: values(ABBREVIATIONS).filter_map(pair).collect(),
            title: Self::title_of(page).map(str::to_owned),
        };
        (told != Self::default()).then_some(told)
    }

    /// The title of a page whose key alone has it.
    pub fn title_of(page: &Page) -> Option<&str> {
        page.origin.iter().find(|(of, _)| of == TITLE).map(|(_, title)| title.as_str())
    }

    /// What the colours mean.
    pub fn meanings(&self) -> impl Iterator<Item = (Class, &str)> {
        self.colours.iter().filter_map(|(class, means)| Some((*class, means.as_deref()?)))
    }
}

impl Page {
    /// The same page, whose key tells this.
    #[must_use]
    pub(crate) fn with_key(mut self, told: &ToldInKey) -> Self {
        self.parts.origin.retain(|(name, _)| ![COLOURS, ABBREVIATIONS, BLANK, TITLE].contains(&name.as_str()));
        self.parts.origin.extend(told.to_origin());
        self
    }

    /// Whether this sheet is one of those on which a picture lies, or an overview that has a sheet to itself.
    pub(crate) fn is_sheet_of_set(&self) -> bool {
        InSet::of(self).is_some_and(|in_set| in_set != InSet::Followed)
    }

    /// Whether this sheet is one of a key.
    pub(crate) fn is_key(&self) -> bool {
        self.braille.iter().any(|text| text.role == TextRole::Key)
    }

    /// What this sheet is among those of its picture, in a word: `figure`, `overview`, `key`, or the name of one of the
    /// sheets on which a picture lies, its row as a letter from `a` and its column as a number from 1.
    pub fn part_of_set(&self) -> String {
        match InSet::of(self) {
            Some(InSet::Overview | InSet::OverviewOf(_)) => "overview".to_owned(),
            Some(InSet::One(name, _)) => name,
            _ if self.is_key() => "key".to_owned(),
            _ => "figure".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests;
