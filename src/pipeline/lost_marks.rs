//! Ticks, marks of angles and other strokes that are too short for a line and not on the page. A reader who expects
//! them is misled, and only a larger figure has them, so they are told by what they are.

use std::cell::LazyCell;
use std::f32::consts::FRAC_1_SQRT_2;

use super::lost_signs::{beads, extent, is_nearly_closed, is_small_ring};
use super::on_sheet::on_sheet;
use crate::edges::{ChainKind, ChainRange, Edges};
use crate::geom::gridlines::{straight_ends, which_are_gridlines};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::PolylineRef;
use crate::geom::simplify::simplify;
use crate::lines::{
    LONGEST_TICK, Line, LineMarks, Lines, Lost, LostLine, LostMarks, LostScale, SHORTEST_TICK, index_of_lines, is_cross,
};
use crate::listing::list;
use crate::page::sheet_windows::{SheetWindows, place_in_words};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, MmVector, PageTransform};
use crate::{About, Note, Reason, Told};

/// A mark ends on a line that is so near to its end, mm: most lines are moved by less (see
/// `lines::Params::farthest_moved`).
const ENDS_ON: f32 = 2.5;
/// A place of a mark is drawn if a line is so near, mm: the ends of a tick are on its axis.
const DRAWN: f32 = 1.2;
/// A line by which a place of a mark is drawn differs in its direction from the mark by at most 45 degrees: the cosine.
const ALONG: f32 = FRAC_1_SQRT_2;
/// Within a ring that is no broader than this, mm, nothing else is felt: it is a hollow point on a line.
const HIDES: f32 = 7.0;
/// A mark is drawn if at least this share of it is.
const MOSTLY: f32 = 0.5;
/// Places of a mark at which is looked.
const PLACES: usize = 12;
/// What is straight lies no farther from the segment between its ends than this share of its length: an arc of 30
/// degrees lies 0.07 off.
const STRAIGHT: f32 = 0.05;
/// A mark of a right angle has one corner, and is straight otherwise but for this share of its length.
const OFF_CORNER: f32 = 0.08;
/// With both arms as straight as this it is one, and else a bend, told as a short line: the arc of a ring with such a
/// corner in its middle has 139 degrees or more, and lies 0.073 off.
const OFF_ARMS: f32 = 0.065;
/// The corner of a mark of a right angle has at most this cosine (70 to 110 degrees).
const RIGHT: f32 = 0.35;
/// The legs of an angle differ in their direction by at least 10 degrees: the sine.
const LEG: f32 = 0.17;
/// The ends of an arc of an angle and its middle are as far from where the legs meet, but for this share: a drawing is
/// not exact, and lines are moved.
const ROUND: f32 = 0.7;
/// Two arcs are pieces of one ring if their ends are no farther apart than this, mm: a broad stroke lies between.
const PIECES_APART: f32 = 4.0;
/// A tick crosses its line at 60 degrees at least: the sine.
const ACROSS: f32 = 0.87;
/// A tick stands on a line if its ends are at distances from it that differ by this share of its length.
const STANDS: f32 = 0.5;

/// Fewer strokes than this that stand on lines are no ticks, as one may be a plate of a battery or a switch, unless
/// each has so many fellows, drawn or not, in a row across all of them. Two batteries side by side have four plates.
const SCALE: usize = 3;
const FELLOWS: usize = 4;
/// Fellows differ in their direction by at most 3 degrees: the sine.
const PARALLEL: f32 = 0.05;

/// What a mark is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MarkKind {
    Tick,
    Arc,
    Corner,
    /// Bent as a mark of a right angle, and none.
    Bend,
    Stroke,
}

/// An end of a mark on a line: how far it is from that, mm, and the direction of the line there.
type OnLine = (f32, MmVector);

/// The marks of a drawing that are shorter than `least`, mm, and not among its lines, which lie in `area`; and the
/// boxes around them.
pub(super) fn find(
    edges: &Edges,
    drawn: &Lines,
    area: MmRect,
    transform: &PageTransform,
    least: f32,
) -> (LostMarks, Vec<MmRect>) {
    let (mut marks, mut ticks, mut boxes) = (LostMarks::default(), Vec::new(), Vec::new());
    if !edges.of_drawing() {
        return (marks, boxes);
    }
    let Lines { lines, marks: handed_on, .. } = drawn;
    let index = index_of_lines(lines, area, ENDS_ON);
    let line_at = |at: MmPoint, reach: f32| -> Option<OnLine> {
        let (distance, _, Segment { a, b, .. }) = index.nearest(at, reach, |_| true)?;
        Some((distance, (b - a).try_normalize().unwrap_or_default()))
    };
    let cover = PointCover::of(lines);
    let gridlines = LazyCell::new(|| gridlines_of(edges, transform));
    let pieces = LazyCell::new(|| undrawn(edges, transform, &index));
    let crosses = LazyCell::new(|| strokes_of_crosses(short_strokes(edges, transform, least), lines));
    for chain in edges.chains.iter().filter(|chain| !chain.closed && !chain.kind.added) {
        let points: Vec<MmPoint> = on_sheet(edges, chain, transform).collect();
        let length = PolylineRef { vertices: &points, closed: false }.length();
        let (Some(&first), Some(&last), true) = (points.first(), points.last(), length < least) else { continue };
        let middle = first.lerp(last, 0.5);
        if is_handed_on(middle, handed_on) {
            continue;
        }
        let is_of_cross = chain.kind.exact && crosses.contains(&[first, last]);
        if !is_of_cross && cover.hides(&points, chain.kind) {
            boxes.push(MmRect::from_points(&points));
            continue;
        }
        let looked = (0..PLACES).map(|i| i * (points.len() - 1) / (PLACES - 1));
        let drawn = looked.filter(|&i| is_along(&index, points[i], direction_at(&points, i))).count();
        if drawn as f32 >= MOSTLY * PLACES as f32 {
            continue;
        }
        let ends = [first, last].map(|end| line_at(end, ENDS_ON));
        let crossed = line_at(points[points.len() / 2], DRAWN);
        let other = || (is_of_cross || is_other(&points, chain.kind, (ends, crossed))).then_some(MarkKind::Stroke);
        let Some(kind) = kind(&points, length, (ends, crossed)).or_else(other) else { continue };
        let is_behind = kind == MarkKind::Tick && cover.has_ring_on([first, last]);
        match kind {
            MarkKind::Tick if chain.kind.faint && is_piece([first, last], &gridlines, least) => continue,
            MarkKind::Tick if is_behind => {}
            MarkKind::Tick => ticks.push([first, last]),
            MarkKind::Arc | MarkKind::Corner | MarkKind::Bend if has_rest(&points, &pieces) => marks.pieces += 1,
            MarkKind::Arc => marks.arcs += 1,
            MarkKind::Corner => marks.corners += 1,
            MarkKind::Bend | MarkKind::Stroke => marks.strokes += 1,
        }
        marks.length += length;
        marks.first = marks.first.or((!is_behind).then_some(middle));
        boxes.push(MmRect::from_points(&points));
    }
    (with_ticks(marks, &ticks, || short_strokes(edges, transform, LONGEST_TICK * least)), boxes)
}

/// Marks, and those found that stand on lines: they are ticks only if they are enough for a scale, or each is of one
/// among all short strokes.
fn with_ticks(marks: LostMarks, found: &[[MmPoint; 2]], strokes: impl FnOnce() -> Vec<[MmPoint; 2]>) -> LostMarks {
    let ticks = if found.is_empty() || found.len() >= SCALE {
        found.len()
    } else {
        let strokes = strokes();
        found.iter().filter(|tick| is_of_scale(**tick, &strokes) || is_of_dial(**tick, &strokes)).count()
    };
    LostMarks { ticks, strokes: marks.strokes + found.len() - ticks, ..marks }
}

/// The ends of the straight strokes of a drawing that are shorter than this, mm, and no crumbs.
fn short_strokes(edges: &Edges, transform: &PageTransform, longest: f32) -> Vec<[MmPoint; 2]> {
    let ends = |chain: &ChainRange| Some(straight_ends(edges.chain(chain))?.map(|end| transform.to_mm(end)));
    let all = edges.chains.iter().filter_map(ends);
    all.filter(|[from, to]| (SHORTEST_TICK..longest).contains(&(*to - *from).length())).collect()
}

/// The middle of a cross lies so near to that of its ring, mm: a ring may be moved a little.
const IN_MIDDLE: f32 = 2.0;
/// A stroke of a cross is as long as its ring is broad, but for this share: a small ring may be drawn larger.
const LONG_IN_RING: f32 = 0.5;

/// Those of these strokes that are a cross in a small ring among `lines`, as in the sign of a lamp: two of about one
/// middle. One alone is a tick behind a hollow point.
fn strokes_of_crosses(strokes: Vec<[MmPoint; 2]>, lines: &[Line]) -> Vec<[MmPoint; 2]> {
    let rings: Vec<MmRect> = lines.iter().filter(|line| is_small_ring(line)).map(extent).collect();
    let is_in_ring = |[from, to]: &[MmPoint; 2]| {
        let (middle, length) = (from.lerp(*to, 0.5), (*to - *from).length());
        let holds = |ring: &MmRect| {
            let is_long = length >= LONG_IN_RING * ring.width() && length <= ring.width() + 2.0 * DRAWN;
            is_long && (ring.center() - middle).length() <= IN_MIDDLE
        };
        rings.iter().any(holds)
    };
    let strokes: Vec<[MmPoint; 2]> = strokes.into_iter().filter(is_in_ring).collect();
    let is_crossed = |stroke: &&[MmPoint; 2]| strokes.iter().any(|other| is_cross(**stroke, *other));
    strokes.iter().filter(is_crossed).copied().collect()
}

/// Whether a tick has enough fellows for a scale among these strokes.
fn is_of_scale([from, to]: [MmPoint; 2], strokes: &[[MmPoint; 2]]) -> bool {
    let (along, middle) = (to - from, from.lerp(to, 0.5));
    let is_fellow = |[a, b]: &&[MmPoint; 2]| {
        let (way, apart) = (*b - *a, a.lerp(*b, 0.5) - middle);
        let is_parallel = way.cross(along).abs() <= PARALLEL * way.length() * along.length();
        let is_in_row = apart.dot(along).abs() <= 0.5 * along.length() * along.length().max(way.length());
        is_parallel && is_in_row && apart.length() > DRAWN
    };
    strokes.iter().filter(is_fellow).count() >= FELLOWS
}

/// Whether a tick has enough fellows for a scale that goes round among these strokes: all point at one middle, from
/// which their outer or their inner ends are as far.
fn is_of_dial([from, to]: [MmPoint; 2], strokes: &[[MmPoint; 2]]) -> bool {
    let Some(along) = (to - from).try_normalize() else { return false };
    // how far along the tick the middle is
    let middle_with = |[a, b]: &[MmPoint; 2]| {
        let way = (*b - *a).try_normalize()?;
        let turn = along.cross(way);
        let to_middle = (*a - from).cross(way) / turn;
        let far = |end: &MmPoint| (*end - (from + along * to_middle)).length();
        let [own, other] = [[far(&from), far(&to)], [far(a), far(b)]].map(|[one, two]| [one.min(two), one.max(two)]);
        let are_as_far = own.iter().zip(other).any(|(own, other)| (own - other).abs() <= DRAWN);
        let are_apart = own[0].min(other[0]) > (to - from).length();
        (turn.abs() > PARALLEL && are_as_far && are_apart).then_some(to_middle)
    };
    let mut middles: Vec<f32> = strokes.iter().filter_map(middle_with).collect();
    middles.sort_by(f32::total_cmp);
    middles.windows(FELLOWS).any(|of| of[FELLOWS - 1] - of[0] <= DRAWN)
}

/// What points on lines cover, as the ticks behind them: nobody misses that.
struct PointCover {
    rings: Vec<MmRect>,
    beads: Vec<MmRect>,
}

impl PointCover {
    fn of(lines: &[Line]) -> Self {
        let rings = lines.iter().filter(|line| is_small_ring(line)).map(extent).filter(|ring| ring.width() <= HIDES);
        Self { rings: rings.collect(), beads: lines.iter().flat_map(beads).collect() }
    }

    /// Whether they hide a mark. In a vector drawing, whose strokes are whole, a tick beside a point is one by itself.
    fn hides(&self, points: &[MmPoint], of: ChainKind) -> bool {
        let [Some(first), Some(last)] = [points.first().copied(), points.last().copied()] else { return false };
        let middle = first.lerp(last, 0.5);
        let line = PolylineRef { vertices: points, closed: false };
        let is_straight = || simplify(line, STRAIGHT * line.length()).len() == 2;
        let is_past = |at: MmPoint| (last - first).cross(at - first).abs() > DRAWN * (last - first).length();
        let is_behind = |bead: &MmRect| !(of.exact && is_past(bead.center()) && is_straight());
        self.rings.iter().any(|ring| ring.contains(middle))
            || self.beads.iter().any(|bead| bead.inflate(DRAWN, DRAWN).contains(middle) && is_behind(bead))
    }

    /// Whether a ring is on a straight stroke that goes on through its middle: what is seen of a tick beside the hollow
    /// point before it.
    fn has_ring_on(&self, [from, to]: [MmPoint; 2]) -> bool {
        let (along, middle) = (to - from, from.lerp(to, 0.5));
        let is_through = |at: MmPoint| along.cross(at - from).abs() <= DRAWN * along.length();
        self.rings.iter().any(|ring| ring.inflate(DRAWN, DRAWN).contains(middle) && is_through(ring.center()))
    }
}

/// Whether at a place is one of the marks that are drawn otherwise than as lines.
fn is_handed_on(at: MmPoint, marks: &LineMarks) -> bool {
    let mut ticks = marks.scales.iter().flatten().chain(&marks.left_out);
    let is_tick = |(from, to): (MmPoint, MmPoint)| nearest_on_segment(at, from, to).0 < DRAWN;
    marks.points.iter().any(|point| (at - point.at).length() < point.radius + DRAWN)
        || marks.heads.iter().any(|head| head.extent.inflate(DRAWN, DRAWN).contains(at))
        || ticks.any(|tick| is_tick(tick.segment()))
}

/// Whether a line that is gone is one of the marks with these `boxes` around them, which are told by what they are. It
/// may be longer by what leads it on to its axis.
pub(super) fn is_one_of(line: &LostLine, boxes: &[MmRect]) -> bool {
    let is_same = |a: MmPoint, b: MmPoint| (a - b).length() <= DRAWN;
    let is_of = |mark: &MmRect| is_same(mark.min, line.extent.min) && is_same(mark.max, line.extent.max);
    !line.closed && boxes.iter().any(is_of)
}

/// Whether an arc and another line, which is not drawn either, are a ring in two pieces: they end beside one another
/// and lie on both sides of the straight between their ends. Two arcs of one angle lie on one side.
fn has_rest(arc: &[MmPoint], undrawn: &[[MmPoint; 3]]) -> bool {
    let [Some(from), Some(to)] = [arc.first().copied(), arc.last().copied()] else { return false };
    let middle = arc[arc.len() / 2];
    let side = |at: MmPoint| (to - from).cross(at - from);
    let near = |a: MmPoint, b: MmPoint| (a - b).length() <= PIECES_APART;
    let is_rest = |[a, at, b]: &[MmPoint; 3]| {
        let meets = near(*a, from) && near(*b, to) || near(*a, to) && near(*b, from);
        meets && side(*at) * side(middle) < 0.0
    };
    undrawn.iter().any(is_rest)
}

/// The first, the middle and the last place of each open contour in whose middle no line is drawn.
fn undrawn(edges: &Edges, transform: &PageTransform, index: &Nearby) -> Vec<[MmPoint; 3]> {
    let places = |chain: &ChainRange| {
        let own = &edges.edgels[chain.edgels.clone()];
        let at = |edgel: usize| own.get(edgel).map(|edgel| transform.to_mm(edgel.at));
        Some([at(0)?, at(own.len() / 2)?, at(own.len().checked_sub(1)?)?])
    };
    let open = edges.chains.iter().filter(|chain| !chain.closed).filter_map(places);
    open.filter(|[_, middle, _]| index.nearest(*middle, DRAWN, |_| true).is_none()).collect()
}

/// A gridline has at least so many pieces, or a long one: ticks at two axes are two.
const PIECES: usize = 3;

/// The ends of the faint lines of a drawing that are a grid, and of their pieces.
fn gridlines_of(edges: &Edges, transform: &PageTransform) -> Vec<[MmPoint; 2]> {
    let faint = edges.chains.iter().filter(|chain| chain.kind.faint);
    let ends = faint.map(|chain| Some(straight_ends(edges.chain(chain))?.map(|end| transform.to_mm(end))));
    let ends: Vec<Option<[MmPoint; 2]>> = ends.collect();
    which_are_gridlines(&ends).into_iter().zip(ends).filter_map(|(is, ends)| ends.filter(|_| is)).collect()
}

/// Whether a line between these ends is a piece of a gridline, shorter than `least`, mm: what is left of one between
/// two bars is no tick.
fn is_piece(line: [MmPoint; 2], gridlines: &[[MmPoint; 2]], least: f32) -> bool {
    let Some(along) = (line[1] - line[0]).try_normalize() else { return false };
    let on_line = |at: MmPoint| along.cross(at - line[0]).abs() <= DRAWN;
    let of_it = || gridlines.iter().filter(|other| other.iter().all(|at| on_line(*at)));
    let is_long = |[a, b]: &[MmPoint; 2]| (*b - *a).length() >= least;
    gridlines.contains(&line) && (of_it().count() >= PIECES || of_it().any(is_long))
}

/// The direction of a mark at one of its points.
fn direction_at(points: &[MmPoint], at: usize) -> MmVector {
    (points[(at + 1).min(points.len() - 1)] - points[at.saturating_sub(1)]).try_normalize().unwrap_or_default()
}

/// Whether a line is drawn at a place that has this direction there: half of a short tick lies near the axis that it
/// crosses.
fn is_along(index: &Nearby, at: MmPoint, direction: MmVector) -> bool {
    let along = |segment: &Segment| {
        let other = (segment.b - segment.a).try_normalize().unwrap_or_default();
        direction.dot(other).abs() >= ALONG
    };
    index.nearest(at, DRAWN, along).is_some()
}

/// What a mark of this length is of which these ends are on lines, or that is crossed by one in its middle.
fn kind(points: &[MmPoint], length: f32, (ends, crossed): ([Option<OnLine>; 2], Option<OnLine>)) -> Option<MarkKind> {
    let line = PolylineRef { vertices: points, closed: false };
    let is_straight = simplify(line, STRAIGHT * length).len() == 2;
    let chord = points.last().zip(points.first()).map_or(MmVector::zero(), |(last, first)| *last - *first);
    if is_straight && crossed.is_some_and(|(_, across)| chord.cross(across).abs() >= ACROSS * length) {
        return Some(MarkKind::Tick);
    }
    let ([Some((from, one)), Some((to, other))], true) = (ends, points.len() > 1) else {
        return (is_straight && ends.iter().any(Option::is_some)).then_some(MarkKind::Tick);
    };
    if one.cross(other).abs() < LEG {
        // so short that both its ends are near the one line that it stands on; a bitmap may bend it there
        return ((from - to).abs() >= STANDS * length).then_some(MarkKind::Tick);
    }
    if is_straight {
        // what lies between two lines is a piece of a longer one, such as a gridline
        return None;
    }
    let corners = simplify(line, OFF_CORNER * length);
    let is_right = match corners[..] {
        [a, b, c] => {
            let arm = |to: usize| (points[to] - points[b]).normalize();
            arm(a).dot(arm(c)).abs() <= RIGHT
        }
        _ => false,
    };
    if is_right {
        let is_square = one.dot(other).abs() <= RIGHT && simplify(line, OFF_ARMS * length).len() == corners.len();
        return Some(if is_square { MarkKind::Corner } else { MarkKind::Bend });
    }
    is_around_vertex(points, [one, other]).then_some(MarkKind::Arc)
}

/// Whether a path that is none of these marks is a short stroke of a vector drawing, such as a ray of the sun: it has a
/// free end, or crosses the line in its middle as an open arrowhead. What lies between two lines may be a piece of a
/// longer one, and in a bitmap a crumb.
fn is_other(points: &[MmPoint], of: ChainKind, (ends, crossed): ([Option<OnLine>; 2], Option<OnLine>)) -> bool {
    let is_stroke = of.exact && of.stroke.is_some() && !of.faint;
    let is_pointed = || crossed.is_some() && ends.iter().flatten().all(|(distance, _)| *distance > DRAWN);
    is_stroke && (ends.iter().any(Option::is_none) || is_pointed()) && !is_nearly_closed(points)
}

/// Whether an arc lies around the place where the lines of these directions meet on which it ends, as that of an angle
/// does: a petal of a flower does not.
fn is_around_vertex(points: &[MmPoint], [one, other]: [MmVector; 2]) -> bool {
    let (first, last, middle) = (points[0], points[points.len() - 1], points[points.len() / 2]);
    let vertex = first + one * ((last - first).cross(other) / one.cross(other));
    let radii = [first, middle, last].map(|at| (at - vertex).length());
    let (least, most) = (radii.into_iter().fold(f32::INFINITY, f32::min), radii.into_iter().fold(0.0, f32::max));
    least >= ROUND * most
}

/// What the maker is told of them.
pub(super) fn told(lost: &Lost, sheets: Option<&SheetWindows>, plan: &Plan) -> Vec<Note> {
    let is_gone = |scale: &&LostScale| scale.every == 1 && scale.lost == scale.ticks;
    let gone: Vec<&LostScale> = lost.scales.iter().filter(is_gone).collect();
    // those of which nothing is drawn are told together
    let are_several = gone.len() > 1;
    let together = are_several.then(|| told_of_gone_scales(&gone, sheets));
    let each = lost.scales.iter().filter(|scale| !(are_several && is_gone(scale)));
    let each = each.map(|scale| told_of_scale(scale, sheets));
    told_of_marks(&lost.marks, sheets, plan).into_iter().chain(together.flatten()).chain(each).collect()
}

/// What the maker is told of several scales of which no tick is drawn.
fn told_of_gone_scales(scales: &[&LostScale], sheets: Option<&SheetWindows>) -> Option<Note> {
    let (first, count) = (scales.first()?.first, scales.len());
    let ticks: usize = scales.iter().map(|scale| scale.ticks).sum();
    let told = format!(
        "all {ticks} short lines on {count} lines, such as the ticks of scales (the first at {}): there is no room for \
         fingers between them",
        place_in_words(first, sheets)
    );
    let helped = Told::from(told).or_larger();
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForTicks, helped))
}

/// What the maker is told of a scale of which some ticks are not drawn.
fn told_of_scale(scale: &LostScale, sheets: Option<&SheetWindows>) -> Note {
    let LostScale { ticks, lost, every, first } = *scale;
    let at = first_at(lost, first, sheets);
    let told = match (every, ticks - lost) {
        (1, 0) => format!(
            "all {ticks} short lines on one line, such as the ticks of a scale ({at}): there is no room for fingers \
             between them"
        ),
        (1, _) => format!(
            "{lost} of the {ticks} short lines on one line, such as the ticks of a scale ({at}): there is no room \
             beside other lines"
        ),
        _ => format!(
            "{lost} of the {ticks} ticks of a scale ({at}): there is no room for fingers between them, and every \
             {} one that has room is drawn",
            ordinal(every)
        ),
    };
    let told = Told::from(told).or_larger();
    let helped = if every > 1 { told.or("say so in a label") } else { told };
    Note::NotOnPage(About::Lines, Reason::NoRoomForTicks, helped)
}

fn ordinal(number: usize) -> String {
    let ending = match (number % 100, number % 10) {
        (11..=13, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    format!("{number}{ending}")
}

/// What the maker is told of marks of angles that the figure has and the overview has not, where a reader may think
/// that the angle has none. Ticks say little in an overview, and of a ring the figure may have no more.
pub(super) fn told_not_in_overview(in_overview: &LostMarks, in_figure: &LostMarks) -> Option<Note> {
    // what is too short in the figure is so in the overview too
    let arcs = in_overview.arcs.saturating_sub(in_figure.arcs);
    let corners = in_overview.corners.saturating_sub(in_figure.corners);
    let told = listed(&LostMarks { arcs, corners, ..LostMarks::default() })?;
    let (are, they_are) = if arcs + corners == 1 { ("is", "it is") } else { ("are", "they are") };
    let told = format!("{told} {are} in the figure only, as {they_are} too short for fingers in the overview");
    Some(Note::TakenAs(About::Overview, Reason::MarksNotInOverview, told.into()))
}

/// Marks by their kinds, such as "2 short ticks, 1 arc of an angle and 1 piece of a small ring"; none where there are
/// none.
fn listed(marks: &LostMarks) -> Option<String> {
    let count = |count: usize, one: &str, more: &str| match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{count} {more}")),
    };
    let all = [
        count(marks.ticks, "short tick", "short ticks"),
        count(marks.arcs, "arc of an angle", "arcs of angles"),
        count(marks.corners, "mark of a right angle", "marks of right angles"),
        count(marks.pieces, "piece of a small ring", "pieces of small rings"),
    ];
    let mut all: Vec<String> = all.into_iter().flatten().collect();
    let [one, more] = match all.is_empty() {
        true => ["short line", "short lines"],
        false => ["other short line", "other short lines"],
    };
    all.extend(count(marks.strokes, one, more));
    (!all.is_empty()).then(|| list(&all, "and"))
}

/// Where the only one of marks is, or the first of several.
fn first_at(count: usize, first: MmPoint, sheets: Option<&SheetWindows>) -> String {
    let place = place_in_words(first, sheets);
    if count == 1 { format!("at {place}") } else { format!("the first at {place}") }
}

fn told_of_marks(marks: &LostMarks, sheets: Option<&SheetWindows>, plan: &Plan) -> Option<Note> {
    let (first, all) = (marks.first?, listed(marks)?);
    let count = marks.ticks + marks.arcs + marks.corners + marks.pieces + marks.strokes;
    let (at, least) = (first_at(count, first, sheets), plan.lines().min_length);
    let told = format!("{all} ({at}): marks shorter than {least:.0} mm are too short for fingers");
    let helped = Told::from(told).or_larger().or("draw them longer").or("say in a label what they mean");
    Some(Note::NotOnPage(About::Lines, Reason::MarksTooShort, helped))
}

#[cfg(test)]
mod tests;
