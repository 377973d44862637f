//! A page in plain sentences, the most important first: what somebody who does not see it needs to decide about it.
//!
//! Lengths are those of the marks as they are written, in steps of 0.01 mm, so that a page is told alike before it is
//! written and after it is read.

mod shapes;
mod shares;

use std::collections::BTreeSet;
use std::fmt;

use serde_json::json;

use crate::legibility::Verdict;
use crate::lines::arrows;
use crate::page::{Class, InSet, LeftOut, Line, Page, TextRole};
use crate::units::{MmPoint, MmRect, MmVector};
use crate::wording::{Value, Wording};
use shapes::part_of;

/// Most lines that are told one by one; a listener keeps no more.
const MOST_LINES: usize = 8;

/// A page in sentences. Its `Display` is one sentence a line.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Description {
    /// What each sentence is about, and the sentence: `title`, `sheet`, `shape`, `lines`, `area`, `text`, `overview`,
    /// `left-out`, `verdict`.
    pub sentences: Vec<(&'static str, String)>,
}

impl Description {
    /// The languages that [`describe`](crate::describe) speaks, as tags of BCP 47.
    pub fn languages() -> impl Iterator<Item = &'static str> {
        Wording::languages()
    }

    /// The same as JSON: a list of `about` and `text`.
    pub fn to_json(&self) -> String {
        let list: Vec<_> = self.sentences.iter().map(|(about, text)| json!({ "about": about, "text": text })).collect();
        format!("{:#}\n", json!(list))
    }
}

impl fmt::Display for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.sentences.iter().try_for_each(|(_, text)| writeln!(f, "{text}"))
    }
}

/// Describes a page with its title, and the verdict on it.
pub(crate) fn describe(page: &Page, verdict: &Verdict, wording: &Wording) -> Description {
    let title = wording.say("title", &[("title", page.title.as_str().into())]);
    let title = (!page.title.is_empty()).then_some(("title", title));
    let verdict = ("verdict", verdict.told(wording));
    Description { sentences: title.into_iter().chain(marks(page, wording)).chain([verdict]).collect() }
}

/// The marks of a page in one text: what stands in its files for screen readers.
pub(crate) fn of_marks(page: &Page, wording: &Wording) -> String {
    marks(page, wording).into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(" ")
}

fn marks(page: &Page, wording: &Wording) -> Vec<(&'static str, String)> {
    // one for the back of the sheet is felt the other way round
    let felt = if page.is_mirrored() { &page.clone().mirrored() } else { page };
    let mut sentences: Vec<_> = before(page, wording).map(|text| ("sheet", text)).into_iter().collect();
    // a disc that is printed narrower is no disc by its width
    let risen = felt.risen();
    let lines = &risen.figure.lines;
    // its figure is nothing but patches, of which its texts tell
    let is_key = lines.is_empty() && felt.is_key();
    sentences.push(("sheet", sheet(&risen, is_key, wording)));
    let told = shapes::told(lines, felt.figure.place, MOST_LINES, wording);
    let shorter = shapes::count(lines) - told.len();
    sentences.extend(told.into_iter().map(|text| ("shape", text)));
    if shorter > 0 {
        let more = if shapes::others_are_shorter(lines, MOST_LINES) { "lines-more" } else { "lines-more-as-long" };
        sentences.push(("lines", wording.say(more, &[("lines", shorter.into())])));
    }
    let points = shapes::points(lines, felt.figure.place, wording);
    sentences.extend(points.into_iter().map(|text| ("shape", text)));
    sentences.extend(marks_on_lines(&risen, wording).map(|text| ("lines", text)));
    let areas = if is_key { Vec::new() } else { areas(felt, wording) };
    sentences.extend(areas.into_iter().map(|text| ("area", text)));
    sentences.extend(texts(felt, wording).into_iter().map(|text| ("text", text)));
    if let Some(overview) = &risen.overview {
        let [width, height] = size(overview.place);
        let values = [("width", width), ("height", height), ("lines", shapes::count(&overview.lines).into())];
        sentences.push(("overview", wording.say("overview", &values)));
    }
    if InSet::of(page) == Some(InSet::Followed) {
        sentences.push(("overview", wording.say("overview-follows", &[])));
    }
    sentences.extend(left_out(felt, wording).map(|text| ("left-out", text)));
    sentences.extend(counts_left_out(felt, wording).into_iter().map(|text| ("left-out", text)));
    sentences
}

/// The heads of arrows, and the ticks and points on lines of dots, of a page as it is felt.
fn marks_on_lines<'a>(page: &'a Page, wording: &'a Wording) -> impl Iterator<Item = String> + 'a {
    let lines = &page.figure.lines;
    let points = || lines.iter().flat_map(Line::row_points);
    let filled = points().filter(|point| point.is_filled).count();
    let ticks = lines.iter().map(ticks_on).sum::<usize>();
    // where every line is told, so is every arrow
    let arrows = if shapes::count(lines) > MOST_LINES { arrows(lines) } else { Vec::new() };
    let shafts: BTreeSet<usize> = arrows.iter().map(|arrow| arrow.line).collect();
    let all = [
        ("arrows", shafts.len()),
        ("ticks", ticks),
        ("points-filled", filled),
        ("points-hollow", points().count() - filled),
    ];
    all.into_iter().filter(|(_, count)| *count > 0).map(|(what, count)| wording.say(what, &[("count", count.into())]))
}

/// The rows of one tick stand so near to one another, in diameters of a dot: on a slanting line not in one place.
const SAME_TICK: f32 = 1.5;

/// How many ticks a line of dots has: those that cross it have a row on each side.
fn ticks_on(line: &Line) -> usize {
    let mut places: Vec<MmPoint> = Vec::new();
    for (run, at) in line.row_ticks() {
        if !places.iter().any(|place| (*place - at).length() < SAME_TICK * run.width) {
            places.push(at);
        }
    }
    places.len()
}

/// What the sheet is among those that belong together.
fn before(page: &Page, wording: &Wording) -> Option<String> {
    let sheets = |names: &[String]| ("sheets", names.len().into());
    match InSet::of(page)? {
        InSet::Followed => None,
        InSet::Overview => Some(wording.say("overview-alone", &[])),
        InSet::OverviewOf(names) => Some(wording.say("overview-of-sheets", &[sheets(&names)])),
        InSet::One(name, names) => {
            let values = [("name", name.into()), sheets(&names), ("names", names.join(", ").into())];
            Some(wording.say("sheet-of-sheets", &values))
        }
    }
}

/// The sheet and how much is on it, of a page as it is felt; of one of a key, how many patches.
fn sheet(page: &Page, is_key: bool, wording: &Wording) -> String {
    let [width, height] = page.sheet.map(|side| side.round());
    let orientation = if width > height { "across" } else { "upright" };
    if is_key {
        let (width, height) = (("width", width.into()), ("height", height.into()));
        let patches = ("patches", page.figure.textures.len().into());
        return wording.say("sheet-of-key", &[("orientation", orientation.into()), width, height, patches]);
    }
    let [across, down] = size(page.figure.place);
    let values = [
        ("orientation", orientation.into()),
        ("width", width.into()),
        ("height", height.into()),
        ("across", across),
        ("down", down),
        ("lines", shapes::count(&page.figure.lines).into()),
        ("areas", page.figure.textures.len().into()),
    ];
    wording.say("sheet", &values)
}

/// Width and height in whole mm, of what is written: 135.496 mm are written as 135.5, and told as 136 before and after.
fn size(place: MmRect) -> [Value<'static>; 2] {
    [place.width(), place.height()].map(|side| ((100.0 * side).round() / 100.0).round().into())
}

/// A smaller share of a figure without texture is not told: it may be the rounding of numbers in a file.
const LEAST_BLANK: f32 = 1e-3;

/// Shares of the figure that differ by less are one.
const SAME_SHARE: f32 = 1e-4;

/// The colours, the one with the largest area first, and how much has none.
fn areas(page: &Page, wording: &Wording) -> Vec<String> {
    let place = page.figure.place;
    let of_class = |class: Class| {
        let own: Vec<_> = page.figure.textures.iter().filter(|texture| texture.class == class).collect();
        let largest = own.iter().max_by(|a, b| a.area.total_cmp(&b.area))?;
        let middle = middle(largest.glyphs.iter().map(|glyph| glyph.at))?;
        Some((page.figure.share(class), class, own.len(), part_of(middle, place)))
    };
    let mut all: Vec<_> = Class::ALL.into_iter().filter_map(of_class).collect();
    // those of one size stay in the order of the colours, whatever their numbers in a file are rounded to
    let size = |share: f32| (share / SAME_SHARE).round() as u32;
    all.sort_by_key(|(share, ..)| std::cmp::Reverse(size(*share)));
    let blank = 1.0 - page.figure.textured_share();
    let blank = (!all.is_empty() && blank >= LEAST_BLANK).then_some(blank);
    let mut told = shares::told(&all.iter().map(|(share, ..)| *share).chain(blank).collect::<Vec<_>>());
    let blank = blank.and_then(|_| told.pop());
    let blank = blank.map(|share| wording.say("blank", &[("share", wording.percent(share).into())]));
    let sentence = |((_, class, areas, ninth), share): ((f32, Class, usize, usize), f32)| {
        let values = [
            ("colour", wording.colour(class.name()).into()),
            ("share", wording.percent(share).into()),
            ("areas", areas.into()),
            ("place", wording.place(ninth).into()),
        ];
        wording.say("area", &values)
    };
    all.into_iter().zip(told).map(sentence).chain(blank).collect()
}

fn middle(points: impl Iterator<Item = MmPoint>) -> Option<MmPoint> {
    let (mut sum, mut count) = (MmVector::zero(), 0_u32);
    for at in points {
        (sum, count) = (sum + at.to_vector(), count + 1);
    }
    (count > 0).then(|| (sum / count as f32).to_point())
}

fn texts(page: &Page, wording: &Wording) -> Vec<String> {
    let of_role = |role: TextRole| page.braille.iter().filter(move |text| text.role == role);
    let place = page.figure.place;
    let plain = |message: &str, text: &str| wording.say(message, &[("text", text.into())]);
    let title = of_role(TextRole::Title).map(|text| plain("braille-title", &text.text));
    let label = of_role(TextRole::Label).filter_map(|text| {
        let at = middle(text.dots.at.iter().copied())?;
        let values = [("place", wording.place(part_of(at, place)).into()), ("text", text.spoken().into())];
        Some(wording.say("braille-label", &values))
    });
    let key = of_role(TextRole::Key).map(|text| plain("braille-key", &text.text));
    let number = of_role(TextRole::Number).map(|text| plain("braille-number", &text.text));
    title.chain(number).chain(label).chain(key).collect()
}

fn left_out(page: &Page, wording: &Wording) -> Option<String> {
    let left = LeftOut::of(page);
    let [length, share] = [("length", left.millimetres.into()), ("share", wording.percent(left.share()).into())];
    (left.millimetres > 0).then(|| match (InSet::of(page), left.most_in()) {
        // each sheet has the same sum
        (Some(InSet::One(_, names)), _) => {
            wording.say("left-out-of-sheets", &[length, share, ("sheets", names.len().into())])
        }
        (_, Some(ninth)) => wording.say("left-out-most", &[length, share, ("place", wording.place(ninth).into())]),
        (_, None) => wording.say("left-out", &[length, share]),
    })
}

/// The areas and words that were left out when the page was made.
fn counts_left_out(page: &Page, wording: &Wording) -> Vec<String> {
    let LeftOut { areas, texts, labels, .. } = LeftOut::of(page);
    let all = [("areas-left-out", areas), ("texts-left-out", texts), ("labels-left-out", labels)];
    let told = all.into_iter().filter(|(_, count)| *count > 0);
    told.map(|(what, count)| wording.say(what, &[("count", count.into())])).collect()
}

#[cfg(test)]
mod tests;
