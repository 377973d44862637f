//! Texts that a person typed into a page, written in braille beside their places.

use super::label::{Label, Position};
use super::words::{Words, Written};
use crate::Note;
use crate::lines::{Line, Run};
use crate::page::layout::Layout;
use crate::page::{Parts, TextRole};
use crate::profile::Plan;
use crate::reading::TypedText;
use crate::units::{MmPoint, MmRect};

/// Adds the texts to a page as labels, in the code of its language: apart from lines and from the braille that is
/// there, nearest to where they were typed. Tells what has no room, and what its code cannot write.
pub(super) fn write(parts: &mut Parts, texts: &[TypedText], plan: &Plan) -> Vec<Note> {
    if texts.is_empty() {
        return Vec::new();
    }
    let place = parts.figure.place;
    let percent = |at: f32, low: f32, side: f32| Position::Percent((100.0 * (at - low) / side).clamp(0.0, 100.0));
    let label = |text: &TypedText| Label {
        x: percent(text.at.x, place.min.x, place.width()),
        y: percent(text.at.y, place.min.y, place.height()),
        text: text.string.clone(),
    };
    let labels: Vec<Label> = texts.iter().map(label).collect();
    let language = parts.language.clone();
    let words = Words { language: Some(&language), labels: &labels, ..Words::default() };
    let written = Written::new(&words, plan);
    let (sheet, medium) = (parts.sheet, parts.medium.clone());
    let layout = Layout { sheet, figure: place, overview: None, mark: None, heading: None, medium };
    let count = parts.figure.lines.len();
    parts.figure.lines.extend(taken(parts));
    let (mut braille, notes) = written.on(&layout, &mut parts.figure, &[], &words, plan);
    parts.figure.lines.truncate(count);
    braille.retain(|text| text.role == TextRole::Label);
    let written = braille.len();
    parts.braille.extend(braille);
    let told = (written > 0).then(|| {
        Note::TakenAs(match written {
            1 => "1 text that was typed is written in braille beside its place".to_owned(),
            _ => format!("{written} texts that were typed are written in braille beside their places"),
        })
    });
    told.into_iter().chain(notes).collect()
}

/// Boxes around braille that is on the page, as lines: what labels keep away from.
fn taken(parts: &Parts) -> Vec<Line> {
    let dots = parts.braille.iter().map(|text| &text.dots).chain(&parts.labels).filter(|dots| !dots.at.is_empty());
    let of_box = |place: MmRect| {
        let corners =
            [place.min, MmPoint::new(place.max.x, place.min.y), place.max, MmPoint::new(place.min.x, place.max.y)];
        let points = corners.into_iter().chain([place.min]).collect();
        Line { strength: 0.0, runs: vec![Run::stroke(0.1, points)] }
    };
    dots.map(|dots| of_box(MmRect::from_points(&dots.at))).collect()
}
