//! Parts of the sentences of remarks.

use super::reason::Reason;
use crate::listing::{counted, first_few, list};

/// Where most of something is, within a sentence.
pub(super) fn most_in(place: Option<&str>, whole: &str) -> String {
    place.map_or_else(|| format!("all over the {whole}"), |place| format!("most of them in the {place}"))
}

/// A share of something that there is.
pub(super) fn share_of(percent: u32) -> String {
    if percent == 0 { "under 1 percent".to_owned() } else { format!("{percent} percent") }
}

/// What a sheet that lies across is better for, as the rest of a sentence.
pub(super) fn turned(is_larger: bool) -> &'static str {
    if is_larger { "; on the same sheet lying across (page.orientation) it is larger" } else { "" }
}

/// Most texts that a note shows; it is read aloud.
pub(super) const MOST_TEXTS: usize = 12;

/// Texts in quotation marks, as many as a note shows.
pub(super) fn listed(texts: &[String]) -> String {
    first_few(texts, MOST_TEXTS, |text| format!("\"{}\"", short(text)))
}

/// A character and where in its text it stands, of several texts with that which has it there.
pub(super) fn character_at(character: char, at: usize, texts: &[String]) -> String {
    let has_it = |text: &&String| at.checked_sub(1).and_then(|before| text.chars().nth(before)) == Some(character);
    match (texts, texts.iter().find(has_it)) {
        ([_], _) => format!("{character:?} (character {at})"),
        (_, Some(text)) => format!("{character:?} (character {at} of \"{}\")", short(text)),
        (_, None) => format!("{character:?}"),
    }
}

pub(super) fn hexadecimal([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// How dark paper is where light falls off, as the rest of a sentence.
pub(super) fn shade(darkest: u32) -> String {
    /// Nobody sees less, percent.
    const SEEN: u32 = 95;
    if darkest > SEEN {
        return String::new();
    }
    format!(", as if light were even: its darkest part has {darkest} percent of the light of its lightest")
}

pub(super) fn sides(of: &[(&str, u32)]) -> String {
    let each: Vec<String> =
        of.iter().map(|(side, percent)| format!("{percent} percent along the {side} side")).collect();
    list(&each, "and")
}

/// That what was taken for so few texts may be none, such as the arm of a person, as the rest of a sentence: what is no
/// text seldom has many parts like it.
pub(super) fn or_if_none(texts: usize) -> &'static str {
    match texts {
        1 => ", or if it is none",
        2 => ", or if one of them is none",
        _ => "",
    }
}

/// Why there are no texts for labels, and what to do, as the rest of a sentence.
pub(super) fn no_texts(are_unread: bool) -> &'static str {
    if are_unread {
        ", as the letters of this picture are pixels or shapes that nobody has read; have Tesseract read them, or \
         write a list of labels"
    } else {
        ": none was found in this picture, or there is no font for them; write a list of labels"
    }
}

/// What is better than letters that are drawn, where they are shapes of a drawing, as the beginning of a sentence: a
/// program that draws charts can write them as text, which becomes braille.
pub(super) fn rather_as_text(are_shapes: bool) -> &'static str {
    if are_shapes {
        "for braille save the drawing with its text as text, not as shapes (in matplotlib as SVG, with svg.fonttype \
         none), or "
    } else {
        ""
    }
}

pub(super) fn it_or_them(count: usize) -> &'static str {
    if count == 1 { "it" } else { "them" }
}

/// Below so many percent most of the outline of a subject is not drawn, which is told as what is left out, too.
pub(crate) const LEAST_DRAWN: u32 = 40;

/// What becomes of the outline of a subject, as the rest of a sentence. `is_first` is a region's, `drawn` how many
/// percent of its border have a line, if the page has lines.
pub(super) fn outline_of_subject(is_first: bool, drawn: Option<u32>) -> String {
    /// From so many percent on it is drawn, but for thin parts and where it is smoothed.
    const WHOLE: u32 = 90;
    match drawn {
        None => ", and has no outline, as the page has no lines".to_owned(),
        Some(_) if !is_first => ", inside closed lines".to_owned(),
        Some(WHOLE..) => ", and its outline is drawn before other lines".to_owned(),
        Some(percent @ LEAST_DRAWN..) => {
            format!(", and about {percent} percent of its outline is drawn, before other lines")
        }
        Some(_) => ", and most of its outline is not drawn".to_owned(),
    }
}

/// The colour of most of a thing, as the rest of a sentence.
pub(super) fn mostly(colour: Option<&str>) -> String {
    colour.map_or_else(String::new, |name| format!(", mostly {name}"))
}

/// What to do if a subject is not what was meant.
pub(super) fn what_if_not_meant(fills: bool) -> &'static str {
    if fills {
        "it fills most of the figure, or reaches three of its sides, as the ground of a thing does: if a thing was \
         meant, name a place on the thing itself, or crop the picture around it"
    } else {
        "if that is not what was meant, name another place on it, or crop the picture around it"
    }
}

/// Why no subject is found at a place, which is as it was given.
pub(super) fn no_subject(reason: Reason, place: &str) -> String {
    match reason {
        Reason::OutsidePart => format!(
            "{place} is outside of the part that is drawn, so that nothing comes first there; name a place on it, from \
             its left and from its top: from 0 to 100 percent, or within its pixels"
        ),
        Reason::RegionsOff => format!(
            "at {place} nothing can be named, as the regions of the picture are off (lines.regions = false) and no \
             closed line surrounds that place; turn them on to name a thing"
        ),
        _ => format!(
            "at {place} of the part that is drawn there is nothing with a clear outline, so that nothing comes first \
             there; name a place in the middle of a thing that stands out from what is around it"
        ),
    }
}

pub(super) fn mixed_areas(count: usize, places: &[&str]) -> String {
    let (have, each) = if count == 1 { ("has", "") } else { ("have", " each") };
    let (areas, places) = (counted(count, "outlined area"), list(places, "and"));
    format!(
        "{areas}, in the {places} of the figure, {have} textures of several colours{each}; say in a label what is \
         there: type a word in the layer labels-text of the page, or give a list of labels"
    )
}

pub(super) fn simplified(shapes: usize, lines: usize, most: usize) -> String {
    let all = [(shapes, "shape"), (lines, "other line")].into_iter().filter(|(count, _)| *count > 0);
    let all: Vec<String> = all.map(|(count, noun)| counted(count, noun)).collect();
    if all.is_empty() {
        return format!(
            "nothing is left out for few shapes (lines.shapes = {most}), as no more have room; where shapes meet, the \
             outline of one is several lines; ask for fewer to have less"
        );
    }
    format!("left out, as few shapes are asked for (lines.shapes = {most}): {}", all.join(" and "))
}

/// The beginning of a text.
pub(super) fn short(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests;
