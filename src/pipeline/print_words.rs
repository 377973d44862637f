//! Print beside the braille, for those who see: small, above its braille, within the blank that braille has around it.

use std::collections::BTreeSet;

use super::label::CLEARANCE;
use crate::geom::polygon::distance_to_box;
use crate::page::{BrailleText, Medium, Page, Parts, PrintText, TextRole};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason};

/// Sizes of letters that are tried, mm: 3 is 8.5 points, as captions are printed; 2.5 is 7.
const SIZES: [f32; 2] = [3.0, 2.5];
/// Sizes of letters that are tried above a label, mm, whose blank of 3 mm has room for no more.
const OF_LABELS: [f32; 1] = [2.5];
/// From the letters' line to the dots below, mm: tails of letters take a fifth of their size, 0.6 mm, and as much is
/// left blank, so that ink that rises a little does not touch a dot.
const ABOVE: f32 = 1.1;
/// Width of a letter as a share of the size: broader than the mean of Helvetica (0.5), since other fonts may be there.
const LETTER: f32 = 0.56;
/// Print keeps this far from the edge of the sheet, mm: many printers leave 4 mm blank.
const EDGE: f32 = 4.5;

/// The print beside the braille of a page; none unless the profile asks for it and the page is printed.
pub(super) fn beside_braille(parts: &Parts, plan: &Plan) -> Vec<PrintText> {
    let wanted = plan.profile().braille.print && matches!(parts.medium, Medium::Print(_));
    if wanted { parts.braille.iter().filter_map(|text| beside(text, parts.sheet)).collect() } else { Vec::new() }
}

/// What of the pages has no words in print though the profile asks for them, and why; none if all has.
pub(super) fn left_out<'p>(pages: impl Iterator<Item = &'p Page>, plan: &Plan) -> Vec<Note> {
    let (mut lost, mut mirrored) = (Vec::new(), false);
    for page in pages.filter(|page| plan.profile().braille.print && matches!(page.medium, Medium::Print(_))) {
        let text = |text: &BrailleText| format!("\"{}\"", text.text);
        match page.is_mirrored() {
            true => mirrored |= !page.braille.is_empty(),
            false => lost.extend(page.braille.iter().filter(|text| beside(text, page.sheet).is_none()).map(text)),
        }
    }
    // a title stands on each of several sheets
    let mut seen = BTreeSet::new();
    lost.retain(|text| seen.insert(text.clone()));
    let no_room = (!lost.is_empty()).then(|| (Reason::NoRoomForPrint, no_room_for(&lost)));
    let mirrored = mirrored.then(|| {
        let told = "words in print (braille.print), as the page is mirrored: it is pressed from its back, where they \
                    would be read in a mirror";
        (Reason::Mirrored, told.to_owned())
    });
    no_room
        .into_iter()
        .chain(mirrored)
        .map(|(reason, told)| Note::NotOnPage(About::Print, reason, told.into()))
        .collect()
}

/// What is told of these words, in quotation marks.
fn no_room_for(words: &[String]) -> String {
    format!("{} in print, as there is no room in print beside their braille (braille.print)", words.join(", "))
}

/// Brings the words in print of a page that somebody changed beside their braille again, where that was moved, and adds
/// those of labels from the `new` one on, which were written just now. Words without braille stay where they are.
pub(super) fn follow(parts: &mut Parts, new: usize, plan: &Plan) -> Vec<Note> {
    if !plan.profile().braille.print || !matches!(parts.medium, Medium::Print(_)) {
        return Vec::new();
    }
    let mut is_free = vec![true; parts.print.len()];
    let (mut moved, mut lost) = (Vec::new(), Vec::new());
    let (mut added, mut homeless) = (Vec::new(), Vec::new());
    for (number, text) in parts.braille.iter().enumerate() {
        let wanted = beside(text, parts.sheet);
        let is_of_text = |word: &PrintText| {
            let is = |words: &str| words.split_whitespace().eq(word.string.split_whitespace());
            is(&text.text) || text.abbreviation.as_deref().is_some_and(is)
        };
        let place = text.dots.bounds().unwrap_or(MmRect::zero());
        let far = |word: &PrintText| distance_to_box(word.at, place);
        let of_text = (0..parts.print.len()).filter(|&at| is_free[at] && is_of_text(&parts.print[at]));
        let nearest = of_text.min_by(|&a, &b| far(&parts.print[a]).total_cmp(&far(&parts.print[b])));
        let Some(at) = nearest else {
            // what a person deleted stays away
            if number >= new {
                if wanted.is_none() {
                    lost.push(format!("\"{}\"", text.text));
                }
                added.extend(wanted);
            }
            continue;
        };
        is_free[at] = false;
        if far(&parts.print[at]) > CLEARANCE {
            match wanted {
                Some(wanted) => {
                    moved.push(format!("\"{}\"", wanted.string));
                    parts.print[at] = wanted;
                }
                // beside other braille it would name the wrong thing
                None => {
                    lost.push(format!("\"{}\"", text.text));
                    homeless.push(at);
                }
            }
        }
    }
    let mut number = 0..;
    parts.print.retain(|_| number.next().is_some_and(|number| !homeless.contains(&number)));
    parts.print.extend(added);
    let moved = (!moved.is_empty()).then(|| {
        let told = format!("the words in print {} follow their braille, which was moved", moved.join(", "));
        Note::TakenAs(About::Print, Reason::PrintFollows, told.into())
    });
    let lost =
        (!lost.is_empty()).then(|| Note::NotOnPage(About::Print, Reason::NoRoomForPrint, no_room_for(&lost).into()));
    moved.into_iter().chain(lost).collect()
}

/// Print above the first line of a text's braille, from where it begins: all of it, or its abbreviation. A title may be
/// as long as the sheet is wide.
fn beside(text: &BrailleText, sheet: [f32; 2]) -> Option<PrintText> {
    let place = text.dots.bounds()?;
    let (room, sizes) = match text.role {
        TextRole::Title | TextRole::Key => (sheet[0] - EDGE - place.min.x, &SIZES[..]),
        TextRole::Label | TextRole::Number => (place.width() + CLEARANCE, &OF_LABELS[..]),
    };
    let at = MmPoint::new(place.min.x, place.min.y - ABOVE);
    let is_on_sheet = |size: f32| at.y - size >= EDGE;
    let words = [Some(&text.text), text.abbreviation.as_ref()];
    let tried = words.into_iter().flatten().flat_map(|words| sizes.iter().map(move |size| (words, *size)));
    let fits =
        |(words, size): &(&String, f32)| words.chars().count() as f32 * LETTER * size <= room && is_on_sheet(*size);
    let (words, size) = tried.into_iter().find(fits)?;
    let string = words.split_whitespace().collect::<Vec<_>>().join(" ");
    (!string.is_empty()).then_some(PrintText { string, at, size })
}

#[cfg(test)]
mod tests;
