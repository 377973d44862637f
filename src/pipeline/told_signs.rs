//! Signs that mark places, such as the points of a scatter plot: what is told of those of several kinds.

use super::lost_signs::{MOVED, extent};
use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use crate::edges::{ChainRange, Edges};
use crate::lines::{Line, Lines, SignKind};
use crate::page::layout::Layout;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason};

/// A point is that of a sign if it lies so near to its place, mm.
const AT_PLACE: f32 = 0.5;
/// What is drawn for a hollow sign is no larger than this, mm.
const LARGEST: f32 = 8.0;

/// Where the middles of signs are in a figure, and whether they are filled.
pub(super) fn places(edges: &Edges, figure: MmRect) -> Vec<(MmPoint, bool)> {
    let transform = PageTransform::new(edges.size, figure);
    let middle = |range: &ChainRange| MmRect::from_points(on_sheet(edges, range, &transform)).center();
    let signs = edges.chains.iter().filter(|range| range.kind.sign.is_some());
    signs.map(|range| (middle(range), range.kind.stroke.is_none())).collect()
}

/// Whether there are signs of several kinds, of which `told` tells: hollow ones, beside filled ones or alone.
pub(super) fn are_of_kinds(edges: &Edges) -> bool {
    edges.chains.iter().any(|range| range.kind.sign.is_some() && range.kind.stroke.is_some())
}

/// What a point at a place is that is not on the page.
pub(super) fn kind_of(at: MmPoint, signs: &[(MmPoint, bool)]) -> SignKind {
    match signs.iter().any(|(of, _)| (*of - at).length() < AT_PLACE) {
        true => SignKind::Point,
        false => SignKind::Ring,
    }
}

/// What the maker is told of signs of several kinds: how they are told apart on the page, if they are, with the words
/// of their legend. Those that are not on the page are told as lost, and do not count.
pub(super) fn told(drawn: &Lines, edges: &Edges, texts: &[Text], layout: &Layout) -> Option<Note> {
    if !are_of_kinds(edges) {
        return None;
    }
    let mut signs = places(edges, layout.figure);
    signs.retain(|(at, _)| drawn.lost.signs.iter().all(|sign| (sign.at - *at).length() >= AT_PLACE));
    let lines = &drawn.lines;
    let filled = signs.iter().filter(|(_, is_filled)| *is_filled).count();
    let hollow = signs.len() - filled;
    let is_ring = |line: &&Line| {
        let of = extent(line);
        !line.is_disc() && line.goes_round() && of.width().max(of.height()) <= LARGEST
    };
    let rings: Vec<MmPoint> = lines.iter().filter(is_ring).map(|line| extent(line).center()).collect();
    let is_drawn = |at: MmPoint| rings.iter().any(|ring| (*ring - at).length() < MOVED);
    let of = |is_filled: bool| {
        let words = texts.iter().filter(|text| text.of_sign == Some(is_filled)).map(|text| text.string.as_str());
        let words: Vec<&str> = words.collect();
        if words.is_empty() { String::new() } else { format!(" ({})", named(&words)) }
    };
    let apart = match signs.iter().any(|(at, is_filled)| !is_filled && is_drawn(*at)) {
        true => format!("{filled}{} are filled points on the page, and {hollow}{} are rings", of(true), of(false)),
        false => "all are discs on the page, as there is no room for rings".to_owned(),
    };
    let told = format!("signs of several kinds mark places: {apart}; say in the title or a label what they stand for");
    Some(Note::TakenAs(About::Lines, Reason::SignsOfKinds, told.into()))
}
