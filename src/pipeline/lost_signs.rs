//! Small closed shapes of a drawing that are not on the page, such as a town on a river or a sample of a colour in a
//! legend: a label may stand beside them, so they are told by its name.

use std::collections::BTreeSet;

use super::label::Label;
use super::legend::LegendEntry;
use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use super::words::Words;
use crate::edges::Edges;
use crate::geom::polygon::{area, distance_to_box, holds_box, roundness};
use crate::geom::{nearest_on_segment, polyline};
use crate::labels::NEAR;
use crate::lines::{Line, Lines, LostSign, Run, SignKind, is_triangle};
use crate::page::Figure;
use crate::page::sheet_windows::{SheetWindows, place_in_words};
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason, Told};

/// Longest side of a ring that is felt as one sign, such as a town on a map, mm: two fingertips. Larger ones are
/// followed, and where they are cut is felt.
const SIGN: f32 = 25.0;
/// A ring is drawn if one of about its size lies so near, mm: lines are seldom moved by more (see
/// `lines::Params::farthest_moved`), and two contours around one stroke are drawn as one line.
pub(super) const MOVED: f32 = 3.0;

/// The leader line of a text ends so near to the middle of a ring that it names, mm: within one of twice that width, or
/// at its outline.
const AT_TIP: f32 = 6.0;

/// Small rings among the contours of a drawing of which there is none among its lines. One that is no
/// broader than `widest_stroke`, mm, may be drawn as its centreline.
pub(super) fn find(edges: &Edges, drawn_lines: &Lines, transform: &PageTransform, widest_stroke: f32) -> Vec<LostSign> {
    if !edges.of_drawing() {
        return Vec::new();
    }
    let lines = &drawn_lines.lines;
    let rings = lines.iter().filter(|line| is_small_ring(line)).map(extent);
    // what becomes of points that are handed on is told where they are drawn
    let points = drawn_lines
        .marks
        .points
        .iter()
        .map(|point| MmRect::new(point.at, point.at).inflate(point.radius, point.radius));
    let drawn: Vec<MmRect> = rings.chain(lines.iter().flat_map(beads)).chain(points).collect();
    let heads = &drawn_lines.marks.heads;
    // points of a cloud are known already: each is drawn at its place or not at all
    let is_point = |sign: &LostSign| sign.kind == SignKind::Point;
    let mut lost: Vec<LostSign> = drawn_lines.lost.signs.iter().copied().filter(is_point).collect();
    let mut small: Vec<SmallShape> = Vec::new();
    for chain in &edges.chains {
        let points: Vec<MmPoint> = on_sheet(edges, chain, transform).collect();
        if !(chain.closed || chain.kind.exact && is_nearly_closed(&points)) {
            continue;
        }
        let ring = MmRect::from_points(&points);
        let near = |at: MmPoint| (at - ring.center()).length() < MOVED;
        let alike = |other: &MmRect| {
            let more = (other.size() - ring.size()) * 0.5;
            near(other.center()) && more.width.abs().max(more.height.abs()) < MOVED
        };
        let side = |extent: &MmRect| extent.width().max(extent.height());
        let is_centreline = |line: &Line| {
            let line = extent(line);
            holds_box(ring.inflate(MOVED, MOVED), line) && side(&line) >= 0.5 * side(&ring)
        };
        let is_narrow = ring.width().min(ring.height()) <= widest_stroke;
        // the line that an arrowhead ends is no centreline of it
        let is_arrowhead = is_tip(&points, lines);
        let is_head = heads.iter().any(|head| head.extent.inflate(HEAD, HEAD).contains(ring.center()));
        let is_own_line = |line: &Line| !chain.closed && alike(&extent(line));
        let is_drawn = || {
            is_head
                || drawn.iter().any(alike)
                || lines.iter().any(is_own_line)
                || is_narrow && !is_arrowhead && lines.iter().any(is_centreline)
        };
        if is_small(ring) {
            let shape = SmallShape { ring, area: area(&points), is_drawn: is_drawn() };
            if !shape.is_drawn && !lost.iter().any(|sign| near(sign.at)) {
                lost.push(LostSign { at: ring.center(), kind: kind_of(is_arrowhead) });
            }
            small.push(shape);
        }
    }
    name_series(&mut lost, &small);
    lost
}

/// So many small shapes that are alike are a series. Among more than so many of a drawing, as those of a texture, none
/// is looked for.
const SERIES: usize = 4;
const MOST_SMALL: usize = 5000;
/// Sides and areas of shapes that are alike differ by at most this share.
const ALIKE: f32 = 0.05;
/// Longest side of a sign that marks a place, mm: a larger shape is a thing by itself, as a window.
const MARK: f32 = 7.0;
/// A round shape has this share of its box, but for [`ALIKE`].
const OF_BOX: f32 = std::f32::consts::FRAC_PI_4;

/// A small closed shape of a drawing.
#[derive(Debug, Clone, Copy)]
struct SmallShape {
    ring: MmRect,
    area: f32,
    is_drawn: bool,
}

impl SmallShape {
    /// Whether they are of one size and about one shape: a disc, a square and a triangle may have one box.
    fn is_like(&self, other: &Self) -> bool {
        let is_as = |a: f32, b: f32| (a - b).abs() <= ALIKE * a.max(b);
        let (a, b) = (self.ring, other.ring);
        is_as(a.width(), b.width()) && is_as(a.height(), b.height()) && is_as(self.area, other.area)
    }

    /// Whether it may be a sign that marks a place, and is no disc, which is drawn as a point where there is room.
    fn may_mark(&self) -> bool {
        let is_round = (self.area / self.ring.area() - OF_BOX).abs() <= ALIKE;
        !is_round && self.ring.width().max(self.ring.height()) <= MARK
    }
}

/// Finds the series among lost shapes: many that are alike and no discs, of which none is drawn.
fn name_series(lost: &mut [LostSign], small: &[SmallShape]) {
    if small.len() > MOST_SMALL {
        return;
    }
    let shape_of = |sign: &LostSign| {
        let is_its = |shape: &&SmallShape| sign.kind == SignKind::Ring && shape.ring.center() == sign.at;
        small.iter().find(is_its)
    };
    let shapes = lost.iter().map(|sign| shape_of(sign).filter(|shape| shape.may_mark()));
    let shapes: Vec<Option<&SmallShape>> = shapes.collect();
    for (sign, own) in lost.iter_mut().zip(&shapes) {
        let Some(own) = own else { continue };
        let count = shapes.iter().flatten().filter(|other| other.is_like(own)).count();
        if count >= SERIES && !small.iter().any(|other| other.is_drawn && other.is_like(own)) {
            sign.kind = SignKind::Series;
        }
    }
}

/// The ends of a ring of which another line covers a piece, as the river or the road through a town, are no farther
/// apart than this share of its longest side: those of a letter C, which is open, are about half of it.
const COVERED: f32 = 0.4;
/// What lies within such a ring is at least so round: a square has 0.79, a triangle 0.60, a line that turns back beside
/// itself less.
const ROUND: f32 = 0.5;

/// Whether an open path is a ring of which a piece is covered.
pub(super) fn is_nearly_closed(points: &[MmPoint]) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
    let size = MmRect::from_points(points).size();
    let length = polyline::length(points) + (*last - *first).length();
    (*last - *first).length() <= COVERED * size.width.max(size.height) && roundness(area(points), length) >= ROUND
}

/// The boxes around the filled points on a line.
pub(super) fn beads(line: &Line) -> impl Iterator<Item = MmRect> {
    line.beads().map(|run| MmRect::from_points(&run.points).inflate(0.5 * run.width, 0.5 * run.width))
}

/// The places of those that are neither arrowheads nor patches of a legend.
pub(super) fn points(lost: &[LostSign], legend: &[LegendEntry]) -> Vec<MmPoint> {
    let is_patch = |at: MmPoint| legend.iter().filter_map(|entry| entry.place).any(|patch| patch.contains(at));
    lost.iter().filter(|sign| sign.kind != SignKind::Arrowhead && !is_patch(sign.at)).map(|sign| sign.at).collect()
}

/// What is so near to the head of an arrow is part of it, mm.
const HEAD: f32 = 0.6;
/// Longest side of an arrowhead, mm: a larger triangle, such as a mountain on a map, is a shape by itself.
const ARROWHEAD: f32 = 7.0;

/// Whether a drawn ring is an arrowhead of one of the lines, or a ring.
pub(super) fn kind(ring: &Line, lines: &[Line]) -> SignKind {
    let points: Vec<MmPoint> = ring.runs.iter().flat_map(|run| run.points.iter().copied()).collect();
    kind_of(is_tip(&points, lines))
}

fn kind_of(is_arrowhead: bool) -> SignKind {
    if is_arrowhead { SignKind::Arrowhead } else { SignKind::Ring }
}

/// Whether a ring is a small triangle at the end of a line.
fn is_tip(points: &[MmPoint], lines: &[Line]) -> bool {
    let extent = MmRect::from_points(points);
    let size = extent.width().max(extent.height());
    size <= ARROWHEAD && is_triangle(points, size) && is_at_end(lines, extent)
}

/// Whether a line ends in a box or close beside it.
fn is_at_end(lines: &[Line], ring: MmRect) -> bool {
    let reach = ring.inflate(MOVED, MOVED);
    let ends = |line: &Line| {
        let mut runs = line.runs.iter().filter(|run| !run.closed);
        let first = runs.clone().next().and_then(|run| run.path().next());
        let last = runs.next_back().and_then(|run| run.path().last());
        [first, last]
    };
    lines.iter().flat_map(ends).flatten().any(|end| reach.contains(end))
}

/// Whether a line of strokes is a small ring.
pub(super) fn is_small_ring(line: &Line) -> bool {
    line.ends_meet() && is_small(extent(line))
}

pub(super) fn is_small(extent: MmRect) -> bool {
    extent.width().max(extent.height()) <= SIGN
}

/// The box around a line.
pub(super) fn extent(line: &Line) -> MmRect {
    MmRect::from_points(line.runs.iter().flat_map(|run| &run.points))
}

/// What is told of small rings that are not on a page, or not whole, by the texts whose leader lines end there and the
/// labels and texts beside them, and of arrowheads by themselves.
pub(super) fn told(
    lost: &[LostSign],
    texts: &[Text],
    words: &Words<'_>,
    figure: &Figure,
    sheets: Option<&SheetWindows>,
) -> Vec<Note> {
    let read = || texts.iter().filter(|text| text.is_read());
    let tips: Vec<(&str, MmPoint)> = read().filter_map(|text| Some((text.string.as_str(), text.tip()?))).collect();
    let texts = read().map(|text| (text.string.as_str(), text.place));
    let on = |label: &Label| label.on(figure.place, figure.source);
    let labels = words.labels.iter().filter_map(|label| on(label).map(|at| (label.text.as_str(), MmRect::new(at, at))));
    let all: Vec<(&str, MmRect)> = labels.chain(texts).collect();
    let are_labels = words.own_texts || !words.labels.is_empty();
    let of = |kind: SignKind| lost.iter().copied().filter(|sign| sign.kind == kind).collect::<Vec<_>>();
    let (heads_lost, rings) = (of(SignKind::Arrowhead), [of(SignKind::Series), of(SignKind::Ring)].concat());
    let (of_lines, others): (Vec<LostSign>, Vec<LostSign>) = points_of_lines(rings, &figure.lines);
    let (series, others): (Vec<LostSign>, Vec<LostSign>) =
        others.into_iter().partition(|sign| sign.kind == SignKind::Series);
    let arrows = (!heads_lost.is_empty()).then(|| {
        let count = heads_lost.len();
        let (heads, them, line_leads) = match count {
            1 => ("1 arrowhead at the end of a line".to_owned(), "it", "the line leads"),
            _ => (format!("{count} arrowheads at ends of lines"), "them", "the lines lead"),
        };
        let why = format!("there is no room for {them} beside other lines");
        let told = Told::from(format!("{heads} ({}): {why}", places(&heads_lost, sheets)));
        let helped = told.or_larger().or(format!("say in the title or a label which way {line_leads}"));
        Note::NotOnPage(About::Lines, Reason::NoRoomForArrowhead, helped)
    });
    let points = told_of_points(&of(SignKind::Point), &figure.lines, sheets);
    let series = told_of_shapes(&series, (&all, &tips), are_labels, sheets);
    let shapes = told_of_shapes(&others, (&all, &tips), are_labels, sheets);
    series.into_iter().chain(shapes).chain(told_of_line_points(&of_lines, sheets)).chain(points).chain(arrows).collect()
}

/// So many rings on one line are the points of a curve.
const CURVE: usize = 3;
/// The middle of a point lies so near to its line, mm: lines are moved a little.
const ON_LINE: f32 = 1.5;

/// Rings that are the points of a curve, which is drawn without them, and the others.
fn points_of_lines(rings: Vec<LostSign>, lines: &[Line]) -> (Vec<LostSign>, Vec<LostSign>) {
    let mut are = vec![false; rings.len()];
    for line in lines.iter().filter(|line| rings.len() >= CURVE && !line.ends_meet()) {
        let around = extent(line).inflate(ON_LINE, ON_LINE);
        let is_at = |run: &Run, at: MmPoint| {
            let points: Vec<MmPoint> = run.path().collect();
            points.windows(2).any(|pair| nearest_on_segment(at, pair[0], pair[1]).0 <= ON_LINE)
        };
        let is_on = |at: MmPoint| around.contains(at) && line.runs.iter().any(|run| is_at(run, at));
        let on: Vec<usize> = (0..rings.len()).filter(|&ring| is_on(rings[ring].at)).collect();
        if on.len() >= CURVE {
            on.into_iter().for_each(|ring| are[ring] = true);
        }
    }
    let mut are = are.into_iter();
    rings.into_iter().partition(|_| are.next().unwrap_or(false))
}

/// What is told of the points of curves that are drawn without them.
fn told_of_line_points(lost: &[LostSign], sheets: Option<&SheetWindows>) -> Option<Note> {
    let first = place_in_words(lost.first()?.at, sheets);
    let count = lost.len();
    let why = "there is no room for all points of a line beside other lines, and it is drawn without them";
    let told = Told::from(format!("{count} points of lines (the first at {first}): {why}"));
    let helped = told.or_larger().or("say in a label that it has points");
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForShape, helped))
}

/// What is told of points of a cloud that have no room.
fn told_of_points(lost: &[LostSign], lines: &[Line], sheets: Option<&SheetWindows>) -> Option<Note> {
    let drawn = lines.iter().filter(|line| is_point(line)).count();
    let all = if drawn == 0 { String::new() } else { format!(" of {}", drawn + lost.len()) };
    let (points, they_are) = match (lost.len(), drawn) {
        (0, _) => return None,
        (1, 0) => ("1 point".to_owned(), "it is"),
        (1, _) => (format!("1{all} points"), "it is"),
        (count, _) => (format!("{count}{all} points"), "they are"),
    };
    let why = format!("{they_are} too near to other points or lines for fingers to tell apart");
    let told = Told::from(format!("{points} ({}): {why}", places(lost, sheets)));
    let helped = told.or_larger().or("say in a label how many lie there");
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForShape, helped))
}

/// What is drawn for a point is no larger than this, mm.
const POINT: f32 = 6.5;

/// Whether a line is what is drawn for a point beside all lines.
fn is_point(line: &Line) -> bool {
    let size = extent(line);
    line.is_disc() || line.is_block_of_dots() || line.goes_round() && size.width().max(size.height()) <= POINT
}

/// So many places of signs are told.
const PLACES: usize = 6;

/// The places of signs, the first of them if they are many.
fn places(signs: &[LostSign], sheets: Option<&SheetWindows>) -> String {
    let place = |sign: &LostSign| match sheets {
        Some(_) => place_in_words(sign.at, sheets),
        None => format!("{:.0}, {:.0}", sign.at.x, sign.at.y),
    };
    let places: Vec<String> = signs.iter().take(PLACES).map(place).collect();
    let unit = if sheets.is_some() { "" } else { " mm" };
    let more = if signs.len() > PLACES { "; and others" } else { "" };
    format!("at {}{unit}{more}", places.join("; "))
}

/// A text, and where the leader line ends that leads from it.
type LeaderTip<'t> = (&'t str, MmPoint);

/// What is told of rings by `all` texts and labels beside them, and by the `tips` of leader lines that end there.
fn told_of_shapes(
    lost: &[LostSign],
    (all, tips): (&[(&str, MmRect)], &[LeaderTip<'_>]),
    are_labels: bool,
    sheets: Option<&SheetWindows>,
) -> Option<Note> {
    let LostSign { at: first, kind } = *lost.first()?;
    let led = |at: MmPoint| {
        let far = |tip: &MmPoint| (*tip - at).length();
        let nearest = tips.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
        nearest.filter(|(_, tip)| far(tip) < AT_TIP).map(|(text, _)| *text)
    };
    let beside = |at: MmPoint| {
        let far = |place: &MmRect| distance_to_box(at, *place);
        let nearest = all.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
        nearest.filter(|(_, place)| far(place) < NEAR).map(|(text, _)| *text)
    };
    let mut of: Vec<&str> = lost.iter().filter_map(|sign| led(sign.at)).collect();
    let without = lost.iter().filter(|sign| led(sign.at).is_none());
    let mut beside: Vec<&str> = without.filter_map(|sign| beside(sign.at)).collect();
    each_once(&mut of);
    each_once(&mut beside);
    let (shapes, them, which, at) = match lost.len() {
        1 => ("1 small shape".to_owned(), "it", "that", "at"),
        // some may lie on others
        count if kind == SignKind::Series => {
            (format!("all small shapes of a series, {count} or more"), "them", "those", "the first at")
        }
        count => (format!("{count} small shapes"), "them", "those", "the first at"),
    };
    let by = |how: &str, names: &[&str]| (!names.is_empty()).then(|| format!("{which} {how} {}; ", named(names)));
    let names: String = [by("of", &of), by("beside", &beside)].into_iter().flatten().collect();
    let labelled = if are_labels && !names.is_empty() { ", so a label may name what is not felt" } else { "" };
    // round ones become points, however small they are
    let (part, or_else) = match kind {
        SignKind::Series => ("", Some("draw them as round points if they mark places")),
        _ => (", in part or as a whole", None),
    };
    let what = format!("{shapes} ({names}{at} {}){part}", place_in_words(first, sheets));
    let why = format!("there is no room for {them} beside other lines{labelled}");
    let told = Told::from(format!("{what}: {why}")).or_larger();
    let helped = match or_else {
        Some(other) => told.or(other),
        None => told,
    };
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForShape, helped))
}

/// Keeps the first of names that are equal.
fn each_once(names: &mut Vec<&str>) {
    let mut known = BTreeSet::new();
    names.retain(|name| known.insert(*name));
}

#[cfg(test)]
mod tests;
