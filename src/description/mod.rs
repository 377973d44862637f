//! A page in plain sentences, the most important first: what somebody who does not see it needs to decide about it.

mod shapes;

use std::fmt;

use serde_json::json;

use crate::geom::ninths::{NAMES, ninth};
use crate::legibility::Verdict;
use crate::page::{Class, LeftOut, Page, TextRole};
use crate::units::{MmPoint, MmRect, MmVector};

/// Most lines that are told one by one; a listener keeps no more.
const MOST_LINES: usize = 8;

/// A page in sentences. Its `Display` is one sentence a line.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Description {
    /// What each sentence is about, and the sentence: `sheet`, `shape`, `lines`, `area`, `text`, `overview`,
    /// `left-out`, `verdict`.
    pub sentences: Vec<(&'static str, String)>,
}

impl Description {
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

/// Describes a page, in English.
pub(crate) fn describe(page: &Page, verdict: &Verdict) -> Description {
    let mut sentences = vec![("sheet", sheet(page))];
    let lines = &page.figure.lines;
    let told = shapes::told(lines, page.figure.place, MOST_LINES);
    let shorter = lines.len() - told.len();
    sentences.extend(told.into_iter().map(|text| ("shape", text)));
    if shorter > 0 {
        let (lines, are) = if shorter == 1 { ("line", "is") } else { ("lines", "are") };
        sentences.push(("lines", format!("{shorter} more {lines} {are} shorter than these.")));
    }
    sentences.extend(areas(page).into_iter().map(|text| ("area", text)));
    sentences.extend(texts(page).into_iter().map(|text| ("text", text)));
    if let Some(overview) = &page.overview {
        let [width, height] = size(overview.place);
        let lines = counted(overview.lines.len(), "line");
        sentences.push(("overview", format!("Below it is an overview of {width} by {height} mm, with {lines}.")));
    }
    sentences.extend(left_out(page).map(|text| ("left-out", text)));
    sentences.push(("verdict", verdict.to_string()));
    Description { sentences }
}

fn sheet(page: &Page) -> String {
    let [width, height] = page.sheet.map(|side| side.round());
    let way = if width > height { "that lies across" } else { "upright" };
    let place = page.figure.place;
    let [across, down] = size(place);
    let title = if page.title.is_empty() { "A page".to_owned() } else { format!("\"{}\"", page.title) };
    let lines = counted(page.figure.lines.len(), "line");
    let areas = counted(page.figure.textures.len(), "textured area");
    format!(
        "{title}: a sheet {way}, {width} by {height} mm, with a figure of {across} by {down} mm that has {lines} and \
         {areas}."
    )
}

fn size(place: MmRect) -> [f32; 2] {
    [place.width().round(), place.height().round()]
}

/// "1 line", "2 lines", "no lines".
fn counted(count: usize, noun: &str) -> String {
    match count {
        0 => format!("no {noun}s"),
        1 => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}

/// A share in whole percent; nothing is told as none that is some.
fn percent(share: f32) -> String {
    if share < 0.01 { "less than 1 percent".into() } else { format!("{:.0} percent", 100.0 * share) }
}

/// The colours, the one with the largest area first.
fn areas(page: &Page) -> Vec<String> {
    let place = page.figure.place;
    let whole = place.area().max(f32::MIN_POSITIVE);
    let of_class = |class: Class| {
        let own: Vec<_> = page.figure.textures.iter().filter(|texture| texture.class == class).collect();
        let largest = own.iter().max_by(|a, b| a.area.total_cmp(&b.area))?;
        let area: f32 = own.iter().map(|texture| texture.area).sum();
        let middle = middle(largest.glyphs.iter().map(|glyph| glyph.at))?;
        let (name, share, ninth) = (class.name(), percent(area / whole), NAMES[ninth(middle, place)]);
        let text = match own.len() {
            1 => format!("The colour {name} covers {share} of the figure, around its {ninth}."),
            count => format!(
                "The colour {name} covers {share} of the figure in {count} areas, the largest around its {ninth}."
            ),
        };
        Some((area, text))
    };
    let mut all: Vec<(f32, String)> = Class::ALL.into_iter().filter_map(of_class).collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.into_iter().map(|(_, text)| text).collect()
}

fn middle(points: impl Iterator<Item = MmPoint>) -> Option<MmPoint> {
    let (mut sum, mut count) = (MmVector::zero(), 0_u32);
    for at in points {
        (sum, count) = (sum + at.to_vector(), count + 1);
    }
    (count > 0).then(|| (sum / count as f32).to_point())
}

fn texts(page: &Page) -> Vec<String> {
    let of_role = |role: TextRole| page.braille.iter().filter(move |text| text.role == role);
    let place = page.figure.place;
    let title = of_role(TextRole::Title).map(|text| format!("The title in braille is \"{}\".", text.text));
    let label = of_role(TextRole::Label).filter_map(|text| {
        let at = middle(text.dots.at.iter().copied())?;
        Some(format!("A label in the {} of the figure says \"{}\".", NAMES[ninth(at, place)], text.spoken()))
    });
    let number = of_role(TextRole::Number).map(|text| format!("The page number in braille is {}.", text.text));
    title.chain(number).chain(label).collect()
}

fn left_out(page: &Page) -> Option<String> {
    let left = LeftOut::of(page);
    let most = left.most_in().map_or_else(String::new, |ninth| format!(", most of them in the {}", NAMES[ninth]));
    (left.millimetres > 0).then(|| {
        let share = percent(left.share());
        format!("{} mm of contours, {share}, had no room and are left out{most}.", left.millimetres)
    })
}
