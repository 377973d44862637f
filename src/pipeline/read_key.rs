//! The key of a page that was read: whether it still fits the page, and a sheet of a key laid out for another device.

use super::key::{self, Entries, Key, KeySheets};
use super::legend;
use super::redraw;
use super::request::Request;
use super::unwritten::named;
use super::words::{Words, WrittenWords};
use crate::braille::Translate;
use crate::listing::first_few;
use crate::page::layout::Layout;
use crate::page::{BrailleText, Class, InSet, Page, TextRole, ToldInKey};
use crate::units::MmRect;
use crate::{About, Error, Note, Reason};

/// When a page that was read has a key.
#[derive(Debug, Clone, Copy)]
pub struct KeyWanted {
    /// As its maker says.
    pub key: KeySheets,
    /// Whether words are abbreviated that were not before.
    pub abbreviates: bool,
    /// Whether somebody has changed the page.
    pub is_changed: bool,
}

/// Whether a page is a sheet of a key, or has one that its maker asked for, though nothing is abbreviated.
pub(super) fn has_own_key(page: &Page) -> bool {
    page.is_key()
        || ToldInKey::of(page).is_some_and(|told| {
            let has_meaning = told.blank.iter().any(|(_, means)| means.is_some()) || told.meanings().count() > 0;
            told.abbreviations.is_empty() && told.title.is_none() && !has_meaning
        })
}

/// The key of a page on its own paper or device. Left to the program, there is one where words are abbreviated that
/// were not before, and where the one that was made with the page fits it no longer.
///
/// # Errors
/// If a mark is off its sheet.
pub fn key_of_page(
    page: &Page,
    wanted: KeyWanted,
    translate: Option<&Translate>,
    request: &Request<'_>,
) -> Result<Key, Error> {
    if page.is_key() {
        let told = (wanted.key == KeySheets::Always)
            .then_some(Note::NoKey(Reason::IsAKey, "this sheet is one of a key itself"));
        return Ok(Key { notes: told.into_iter().collect(), ..Key::default() });
    }
    let told = ToldInKey::of(page);
    let outdated = told.as_ref().filter(|_| wanted.is_changed).and_then(|told| outdated(told, page));
    let when = match wanted.key {
        KeySheets::Auto if outdated.is_some() => KeySheets::Always,
        // what was abbreviated before has its key already
        KeySheets::Auto if !wanted.abbreviates => KeySheets::Never,
        key => key,
    };
    let legend = if when == KeySheets::Never { Vec::new() } else { legend::of_page(page) };
    let words = Words { key: when, translate, ..redraw::words(page, &legend) };
    let written = WrittenWords::new(&words, request.plan);
    let layout = Layout::of_figure(page.sheet, page.figure.place, page.medium.clone());
    // an overview has the next sheet to itself
    let before = 1 + u32::from(InSet::of(page) == Some(InSet::Followed));
    let mut key = written.key(&words, &page.braille, &page.figure, before, &layout, request)?;
    if wanted.key == KeySheets::Auto && when == KeySheets::Never && told.is_some() {
        key.notes.push(Note::NoKey(Reason::KeyInOtherFile, "the one that was made with the page is a file of its own"));
    }
    key.notes.extend(outdated.map(|what| {
        let told = format!("the key that was made with the page no longer fits it: {what}");
        match key.sheets.is_empty() {
            true => Note::Faulty(
                About::Braille,
                Reason::KeyOutdated,
                format!("{told}; take it away, or have it written anew"),
            ),
            false => Note::TakenAs(
                About::Braille,
                Reason::KeyOutdated,
                format!("{told}; the one that follows takes its place").into(),
            ),
        }
    }));
    Ok(key)
}

/// Most differences that are told one by one.
const MOST_TOLD: usize = 4;

/// What a key that was told has too much or lacks, in words; none if it fits the page.
fn outdated(told: &ToldInKey, page: &Page) -> Option<String> {
    if matches!(InSet::of(page), Some(InSet::One(..))) {
        return None; // it is of all sheets
    }
    let occurs = |class: Class| page.figure.textures.iter().any(|texture| texture.class == class);
    let is_told = |class: Class| told.colours.iter().any(|(of, _)| *of == class);
    let of_classes = Class::ALL.into_iter().filter_map(|class| match (is_told(class), occurs(class)) {
        (true, false) => Some(format!("{} is not on the page", class.name())),
        (false, true) => Some(format!("it does not tell {}", class.name())),
        _ => None,
    });
    let now = key::abbreviations(&page.braille);
    // as a page says it
    let [before, now] = [&told.abbreviations, &now].map(|of| {
        ToldInKey { abbreviations: of.clone(), ..ToldInKey::default() }.to_origin().into_iter().map(|(_, said)| said)
    });
    let (before, now): (Vec<String>, Vec<String>) = (before.collect(), now.collect());
    let gone = before.iter().filter(|of| !now.contains(of)).map(|of| format!("\"{of}\" is not on the page"));
    let new = now.iter().filter(|of| !before.contains(of)).map(|of| format!("it does not tell \"{of}\""));
    let all: Vec<String> = of_classes.chain(gone).chain(new).collect();
    (!all.is_empty()).then(|| first_few(&all, MOST_TOLD, String::clone))
}

/// What a sheet of a key says, and what of its texts is neither a colour nor an abbreviation; none of another page, or
/// where nothing can be written.
fn entries<'a>(page: &'a Page, written: &'a WrittenWords<'_>) -> Option<(Entries<'a>, Vec<&'a str>)> {
    let translator = written.translator().filter(|_| page.is_key())?;
    let after = |text: &'a str, word: &str| text.strip_prefix(word).map(|rest| rest.strip_prefix(": "));
    let number = page.braille.iter().find(|text| text.role == TextRole::Number);
    let mut entries = Entries {
        translator,
        language: &page.language,
        title: None,
        has_title_alone: false,
        classes: Class::ALL.into_iter().filter(|of| page.figure.textures.iter().any(|t| t.class == *of)).collect(),
        meanings: Vec::new(),
        blank: Vec::new(),
        abbreviations: Vec::new(),
        number: number.and_then(|text| text.text.parse().ok()),
    };
    let mut others = Vec::new();
    let texts = page.braille.iter().filter(|text| text.role == TextRole::Key);
    for (at, text) in texts.enumerate() {
        let said = text.text.as_str();
        if let Some(class) = class_beside(text, page) {
            match after(said, translator.word(class.name())) {
                Some(meaning) => entries.meanings.extend(meaning.map(|of| (class, of.to_owned()))),
                None => entries.meanings.push((class, said.to_owned())),
            }
        } else if let Some(title) = after(said, translator.word("key")).filter(|_| at == 0) {
            entries.title = title;
        } else if let Some(Some(of)) = after(said, translator.word("blank")) {
            // of which colour they are in the drawing is not told there
            entries.blank.push((Class::Grey, Some(of.to_owned())));
        } else if let Some((short, of)) = said.split_once(": ") {
            let pair = (short.to_owned(), of.to_owned());
            entries.abbreviations.extend((!entries.abbreviations.contains(&pair)).then_some(pair));
        } else {
            others.push(said);
        }
    }
    // a sheet may have nothing but the title
    entries.has_title_alone = entries.title.is_some();
    Some((entries, others))
}

/// The colour whose patch lies left of a text.
fn class_beside(text: &BrailleText, page: &Page) -> Option<Class> {
    let place = text.dots.bounds()?;
    let is_beside = |patch: MmRect| {
        let middle = place.center();
        patch.max.x <= place.min.x && (patch.min.y..=patch.max.y).contains(&middle.y)
    };
    let patch = |glyphs: &[crate::page::Glyph]| MmRect::from_points(glyphs.iter().map(|glyph| glyph.at));
    let mut patches = page.figure.textures.iter().filter(|texture| !texture.glyphs.is_empty());
    patches.find(|texture| is_beside(patch(&texture.glyphs))).map(|texture| texture.class)
}

/// A sheet of a key anew for another paper or device, where it may take several, with what is told of it; none of
/// another page, or if there is nothing to tell.
///
/// # Errors
/// If a mark is off its sheet.
pub(super) fn redrawn(
    page: &Page,
    written: &WrittenWords<'_>,
    layout: &Layout,
    request: &Request<'_>,
) -> Result<Option<Key>, Error> {
    let Some((entries, others)) = entries(page, written) else { return Ok(None) };
    let Key { sheets, told, notes } = key::of_entries(&entries, layout, page.figure.source, request)?;
    let sheets: Vec<Page> = sheets.into_iter().map(|sheet| sheet.called(Some(request.title), None, None)).collect();
    if sheets.is_empty() {
        return Ok(None);
    }
    let others = (!others.is_empty()).then(|| {
        let what = format!("of the key {}, as it is neither a colour nor an abbreviation", named(&others));
        Note::NotOnPage(About::Braille, Reason::NotOfKey, what.into())
    });
    let notes = written.notes().iter().cloned().chain(notes).chain(others).collect();
    Ok(Some(Key { sheets, told, notes }))
}
