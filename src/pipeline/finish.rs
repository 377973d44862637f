//! What every page ends with: its words of how it was made, the check that it goes through, and what stands in its
//! files for screen readers: its marks in sentences, unless its maker has described it.

use super::print_words;
use super::request::Request;
use crate::description;
use crate::legibility::{LooseEnds, rows_beside_lines};
use crate::output::seal;
use crate::page::{BrailleText, DotMedium, Dots, InSet, LeftOut, Medium, Page, Parts, Print};
use crate::profile::Plan;
use crate::units::Size;
use crate::wording::Wording;
use crate::{About, Error, Note, Reason};

/// The page of these marks, as it is printed, and described.
pub(super) fn finished(mut parts: Parts, request: &Request<'_>) -> Result<Page, Error> {
    // Up to here every mark has the size that fingers meet.
    if let Medium::Print(print) = parts.medium {
        parts.narrowed(print.swell);
    }
    parts.print = print_words::beside_braille(&parts, request.plan);
    let page = Page::new(parts)?;
    let page = if request.fit.mirrored { page.mirrored() } else { page };
    Ok(described(page, Wording::nearest(request.language)))
}

/// What is known of a picture beside its marks.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PictureFacts {
    /// Whether no contours were looked for, as it is of one colour or a person gave its lines.
    pub(super) none_sought: bool,
    /// Whether all its contours were erased.
    pub(super) all_erased: bool,
    /// Whether its ground has a colour that has no texture on the page.
    pub(super) coloured_ground: bool,
    /// Whether the words of a legend became labels of its lines, which tell them apart on the page.
    pub(super) has_named_lines: bool,
    /// How many of its texts are neither drawn nor to be written.
    pub(super) texts_left_out: u32,
}

/// What a page says of itself, beside how it was made.
#[derive(Debug, Clone)]
pub(super) struct PageSays {
    /// Contours that are not drawn.
    pub(super) left_out: LeftOut,
    /// Which sheet of a set it was before it was drawn anew.
    pub(super) in_set: Option<InSet>,
    /// That in braille.
    pub(super) label: Option<Dots>,
}

impl PageSays {
    /// That these contours are not drawn.
    pub(super) fn of(left_out: LeftOut) -> Self {
        Self { left_out, in_set: None, label: None }
    }

    /// The same, with so many more labels that are left out.
    pub(super) fn with_labels(self, left_out: usize) -> Self {
        let before = self.left_out;
        Self { left_out: LeftOut { labels: before.labels + left_out as u32, ..before }, ..self }
    }

    /// As entries of its origin.
    pub(super) fn to_origin(&self) -> Vec<(String, String)> {
        let in_set = self.in_set.iter().map(InSet::to_origin);
        in_set.chain(self.left_out.to_origin()).collect()
    }
}

/// What the maker is told when more of the figure is black than the profile allows.
fn too_black(share: f32, print: &Print) -> Option<Note> {
    let most = print.max_black;
    let percent = |share: f32| (100.0 * share).round() as u32;
    (share > most).then(|| Note::TooBlack { percent: percent(share), most: percent(most) })
}

/// What the maker is told of these pages of a picture: whether they are too black for swell paper, what there is to say
/// of dots, and whether they are all scraps of contours.
pub(super) fn told_of_pages<'a>(
    pages: impl Iterator<Item = &'a Page> + Clone,
    medium: &Medium,
    plan: &Plan,
) -> Vec<Note> {
    let scraps = told_of_scraps(pages.clone(), plan);
    let of_medium: Vec<Note> = match medium {
        Medium::Print(print) => {
            let blackest = pages.map(Page::black_share).fold(0.0, f32::max);
            too_black(blackest, print).into_iter().collect()
        }
        Medium::Dots(medium) => told_of_dots(pages, medium, plan).collect(),
    };
    of_medium.into_iter().chain(scraps).collect()
}

/// What the maker is told where too many ends of the lines of a photograph lead to nothing: how many on all of its
/// sheets that have too many.
fn told_of_scraps<'a>(pages: impl Iterator<Item = &'a Page>, plan: &Plan) -> Option<Note> {
    let limits = plan.limits();
    let count: usize = pages.filter_map(|page| LooseEnds::of(page, &limits)).map(|ends| ends.count).sum();
    let what = || {
        format!(
            "the photograph is many open scraps of contours: {count} ends of lines lead to nothing, so that a finger \
             meets one end after the other and can hardly follow what the picture shows; draw it with less detail or \
             with few shapes, or say what it is about (a place on it)"
        )
    };
    (count > 0).then(|| Note::Faulty(About::Lines, Reason::LooseEnds, what()))
}

/// What the maker is told of these pages of dots: where these are those of text cells, and where rows of textures lie
/// close on both sides of too many of the lines, by the worst of the pages.
fn told_of_dots<'a>(
    pages: impl Iterator<Item = &'a Page>,
    medium: &DotMedium,
    plan: &Plan,
) -> impl Iterator<Item = Note> {
    let limits = plan.limits();
    let worst = pages.filter_map(|page| rows_beside_lines(page, &limits)).max_by(f32::total_cmp);
    let among_rows = worst.map(|share| {
        let what = format!(
            "{:.0} percent of the length of the lines can hardly be followed, as rows of textures lie close on both \
             sides, and both are rows of the same dots; draw the lines alone, or leave out the textures around what \
             the picture is about",
            100.0 * share
        );
        Note::Faulty(About::Lines, Reason::AmongRows, what)
    });
    medium.device.cell_dots().map(|_| Note::UnevenDots).into_iter().chain(among_rows)
}

/// How the page was made, so that it can be made again. Keys that do not count on it are left out: those of braille
/// where nothing is written.
pub(super) fn origin(request: &Request<'_>, source: Size, braille: &[BrailleText]) -> Vec<(String, String)> {
    let profile = request.plan.profile();
    let own = |name: &str, value: String| (name.to_owned(), value);
    let mut origin = vec![
        own("program", concat!("tactograph ", env!("CARGO_PKG_VERSION")).to_owned()),
        own("picture", request.title.to_owned()),
        own("source size in pixels", source.to_string()),
        own("profile", profile.name.clone()),
    ];
    origin.extend(request.fit.origin());
    let counts = |key: &str| !braille.is_empty() || !key.starts_with("braille.");
    let parameters = profile.counting_parameters().filter(|(key, _)| counts(key));
    origin.extend(parameters.map(|(key, value)| (key.to_owned(), value)));
    origin
}

/// What the key of a page is called in a language (BCP 47), which has sheets to itself.
pub fn title_of_key(title: &str, language: &str) -> String {
    Wording::nearest(language).say("title-of-key", &[("title", title.into())])
}

/// What the overview of a page is called in a language (BCP 47), which has a sheet to itself.
pub fn title_of_overview(title: &str, language: &str) -> String {
    Wording::nearest(language).say("title-of-overview", &[("title", title.into())])
}

/// What one of several sheets of a page is called in a language (BCP 47).
pub(super) fn title_of_sheet(title: &str, sheet: &str, language: &str) -> String {
    Wording::nearest(language).say("title-of-sheet", &[("title", title.into()), ("sheet", sheet.into())])
}

/// The entry of a page's origin by which a description that was made is told from a person's: the seal of its text.
const MADE: &str = "seal of the description";

/// A page with a description of its marks, in the words of `wording`.
pub(super) fn described(page: Page, wording: &Wording) -> Page {
    let description = description::of_marks(&page, wording);
    let made = (MADE.to_owned(), seal::of(description.as_bytes()));
    page.described(description, wording.language(), made)
}

/// Whether a page's description is as it was made: no person has changed it.
pub fn is_made(page: &Parts) -> bool {
    let seal = seal::of(page.description.as_bytes());
    page.origin.iter().any(|(name, value)| name == MADE && *value == seal)
}

#[cfg(test)]
mod tests;
