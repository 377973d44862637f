//! Small closed shapes of a drawing that are not on the page, such as a town on a river or a sample of a colour in a
//! legend: a label may stand beside them, so they are told by its name.

use super::label::Label;
use super::texts::Text;
use super::words::{Words, named};
use crate::edges::Edges;
use crate::labels::NEAR;
use crate::lines::Line;
use crate::page::Figure;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note};

/// Longest side of a ring that is felt as one sign, such as a town on a map, mm: two fingertips. Larger ones are
/// followed, and where they are cut is felt.
const SIGN: f32 = 25.0;
/// A ring is drawn if one of about its size lies so near, mm: lines are moved apart by less, and two contours around
/// one stroke are drawn as one line.
const MOVED: f32 = 3.0;

/// The middles of small rings among the contours of a drawing of which there is none among its lines. One that is no
/// broader than `widest_stroke`, mm, may be drawn as its centreline.
pub(super) fn of(edges: &Edges, lines: &[Line], transform: &PageTransform, widest_stroke: f32) -> Vec<MmPoint> {
    if !edges.of_drawing() {
        return Vec::new();
    }
    let drawn: Vec<MmRect> = lines.iter().filter(|line| is_small_ring(line)).map(extent).collect();
    let mut lost: Vec<MmPoint> = Vec::new();
    for chain in edges.chains.iter().filter(|chain| chain.closed) {
        let points = edges.edgels[chain.edgels.clone()].iter().map(|edgel| transform.to_mm(edgel.at));
        let ring = MmRect::from_points(points);
        let near = |at: MmPoint| (at - ring.center()).length() < MOVED;
        let alike = |other: &MmRect| {
            let more = (other.size() - ring.size()) * 0.5;
            near(other.center()) && more.width.abs().max(more.height.abs()) < MOVED
        };
        let side = |extent: &MmRect| extent.width().max(extent.height());
        let is_centreline = |line: &Line| {
            let line = extent(line);
            ring.inflate(MOVED, MOVED).contains_box(&line) && side(&line) >= 0.5 * side(&ring)
        };
        let is_narrow = ring.width().min(ring.height()) <= widest_stroke;
        let is_drawn = || drawn.iter().any(alike) || is_narrow && lines.iter().any(is_centreline);
        if is_small(ring) && !is_drawn() && !lost.iter().any(|&at| near(at)) {
            lost.push(ring.center());
        }
    }
    lost
}

/// Whether a line is a small ring.
pub(super) fn is_small_ring(line: &Line) -> bool {
    let mut ends = line.runs.iter().flat_map(|run| [run.path().next(), run.path().last()]).flatten();
    let ends = (ends.next(), ends.last());
    let is_closed = matches!(ends, (Some(first), Some(last)) if (last - first).length() < 0.05);
    is_closed && is_small(extent(line))
}

fn is_small(extent: MmRect) -> bool {
    extent.width().max(extent.height()) <= SIGN
}

/// The box around a line.
pub(super) fn extent(line: &Line) -> MmRect {
    MmRect::from_points(line.runs.iter().flat_map(|run| &run.points))
}

/// What is told of small rings that are not on a page, or not whole, by the labels and texts beside them.
pub(super) fn told(lost: &[MmPoint], texts: &[Text], words: &Words<'_>, figure: &Figure) -> Option<Note> {
    let first = lost.first()?;
    let texts = texts.iter().filter(|text| text.is_read()).map(|text| (text.string.as_str(), text.place));
    let on = |label: &Label| label.on(figure.place, figure.source);
    let labels = words.labels.iter().filter_map(|label| on(label).map(|at| (label.text.as_str(), MmRect::new(at, at))));
    let all: Vec<(&str, MmRect)> = labels.chain(texts).collect();
    let name = |at: MmPoint| {
        let far = |place: &MmRect| (at - at.clamp(place.min, place.max)).length();
        let nearest = all.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
        nearest.filter(|(_, place)| far(place) < NEAR).map(|(text, _)| *text)
    };
    let mut names: Vec<&str> = lost.iter().filter_map(|&at| name(at)).collect();
    names.dedup();
    let (shapes, them, which, at) = match lost.len() {
        1 => ("1 small closed shape".to_owned(), "it", "that", "at"),
        count => (format!("{count} small closed shapes"), "them", "those", "the first at"),
    };
    let at = format!("{at} {:.0}, {:.0} mm", first.x, first.y);
    let beside = if names.is_empty() { at } else { format!("{which} beside {}; {at}", named(&names)) };
    let labelled = if (words.own_texts || !words.labels.is_empty()) && !names.is_empty() {
        ", so a label may name what is not felt"
    } else {
        ""
    };
    let what = format!("{shapes} ({beside}), in part or as a whole");
    let why = format!("there is no room for {them} beside other lines{labelled}; make the figure larger");
    Some(Note::NotOnPage(About::Lines, format!("{what}: {why}")))
}
