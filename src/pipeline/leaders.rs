//! Leader lines that a drawing has from its texts to what they name. Cut at the lines that it crosses, the rest of one
//! leads from a word to the wrong thing or to nothing, so a leader line is on the page as a whole or not at all.

use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use crate::braille::CellSize;
use crate::edges::Edges;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polygon::distance_to_box;
use crate::geom::polyline::PolylineRef;
use crate::geom::spaced_row::{HOLE, every_second, has_every_second};
use crate::geom::{ALONG, crossing, nearest_on_segment};
use crate::legibility::{
    LEADER_END, LEADER_FREE, LEADER_FROM_BRAILLE, LEADER_STRAIGHT, LONGEST_LEADER, SHORTEST_LEADER, is_shut_in,
};
use crate::lines::{self, Line, Pen};
use crate::listing::counted;
use crate::page::cells::CellGrid;
use crate::page::layout::Layout;
use crate::page::{Medium, Page};
use crate::units::{MmPoint, MmRect, MmVector, PageTransform};
use crate::{About, Note, Reason, Told};

/// A leader line ends so near to its text, mm: print stands up to 4 mm beside it. Of braille it is [`reach`].
pub(super) const FROM_PRINT: f32 = 5.0;
/// A leader line is straight: its chord is at least this share of it. Lines of a page are moved, and may be less so.
const STRAIGHT: f32 = 0.98;
/// Led on backwards, it comes so near to its text, as a share of the farthest that it may end beside that.
const ASIDE: f32 = 0.5;
/// What it leads to is so near to its other end, mm.
const AT_TIP: f32 = 3.0;
/// What it leads to is drawn so near to it, mm, over so much of its end: lines are moved, and the tip may be within the
/// outline of what it names.
const ON_PAGE: f32 = LEADER_END;
const LAST: f32 = 15.0;
/// Two lines end at one joint if their ends are no farther apart, mm: the point of a hinge may lie between.
const AT_JOINT: f32 = 5.0;
/// Over so much of its end a line has its direction there, mm.
const TO_JOINT: f32 = 3.0;
/// A line goes on in another that turns by 60 degrees at most: the cosine.
const GOES_ON: f32 = 0.5;
/// A branch of a tree ends so many times as far from its word, at most, as a leader line does.
const BRANCH: f32 = 2.0;
/// Ticks on a line make it an axis: so many.
const TICKS: usize = 2;
/// A leader line is drawn at a place if a line is so near, mm; most lines are moved by less (see
/// `lines::Params::farthest_moved`).
const DRAWN: f32 = 3.0;
/// On a grid lines have steps of 45 degrees: their direction is that over so many.
const STEPS_OF_DOTS: usize = 4;
/// A line stands for a leader line no further before or behind it than this, mm.
const OFF_LEADER: f32 = 1.5;
/// Steps in which a leader line is followed, mm.
const STEP: f32 = 0.5;
/// Longest gap over which a finger follows a leader line, mm; on dots that of two that are missing.
const GAP: f32 = 4.0;
const DOTS_OF_GAP: f32 = 3.1;
/// How often leader lines are left out: without some, others are drawn otherwise.
const ROUNDS: usize = 3;

// What is a leader line here, and leads to something, does so for the check of the page.
const _: () = assert!(STRAIGHT >= LEADER_STRAIGHT && AT_TIP <= LEADER_END);

/// A leader line of a drawing.
#[derive(Debug, Clone, PartialEq)]
struct Leader {
    /// Its chain among the contours.
    chain: usize,
    /// Its text.
    text: usize,
    /// From the text to what it names.
    path: Vec<MmPoint>,
    /// Whether a line is at its tip in the drawing.
    ends_at_line: bool,
}

impl Leader {
    /// Where it begins, and its tip.
    fn ends(&self) -> Option<(MmPoint, MmPoint)> {
        self.path.first().copied().zip(self.path.last().copied())
    }
}

/// Takes the leader lines out of the contours of a drawing that `draw` does not draw as a whole. Their texts, which
/// stand up to `beside` mm beside them, are led to what they name by labels.
pub(super) fn whole_or_none(
    edges: &mut Edges,
    texts: &mut [Text],
    beside: f32,
    is_label: impl Fn(&Text) -> bool,
    layout: &Layout,
    draw: impl Fn(&Edges) -> Vec<Line>,
) -> Vec<Note> {
    let transform = PageTransform::new(edges.size, layout.figure);
    let gap = match &layout.medium {
        Medium::Print(_) => GAP,
        Medium::Dots(dots) => GAP.max(DOTS_OF_GAP * dots.pitch),
    };
    let mut to_nothing = Vec::new();
    for _ in 0..ROUNDS {
        let leaders = find(edges, (texts, beside), &is_label, layout.figure, &transform);
        if leaders.is_empty() {
            break;
        }
        let lines = draw(edges);
        let index = index_of_pieces(&lines, layout.figure);
        let leads = |leader: &Leader| is_whole(&leader.path, &index, gap) && !leads_to_other(&leader.path, &index);
        let (whole, torn): (Vec<Leader>, Vec<Leader>) = leaders.into_iter().partition(leads);
        let leads_to_nothing = |of: &&Leader| !leads_on_page(of, &lines, &index, layout.figure);
        to_nothing = whole.iter().filter(leads_to_nothing).map(|of| of.text).collect();
        texts.iter_mut().for_each(|text| text.kept_leader = None);
        whole.iter().for_each(|of| texts[of.text].kept_leader = of.ends());
        if torn.is_empty() {
            break;
        }
        for leader in &torn {
            let text = &mut texts[leader.text];
            // one that names two things still leads to the other
            if !whole.iter().any(|other| other.text == leader.text) && text.lost_leader.is_none() {
                text.lost_leader = leader.ends();
            }
        }
        let mut number = 0..;
        edges.chains.retain(|_| number.next().is_none_or(|number| !torn.iter().any(|leader| leader.chain == number)));
    }
    let names: Vec<&str> = to_nothing.iter().map(|&text| texts[text].string.as_str()).collect();
    told_lost(texts).into_iter().chain(told_to_nothing(&names)).collect()
}

/// Whether a leader line, from where it ends on the page, leads to another line that is drawn, or crosses one shortly
/// before that. One that leads to no line in the drawing may end in an area that these lines shut in.
fn leads_on_page(leader: &Leader, lines: &[Line], drawn: &Nearby, figure: MmRect) -> bool {
    let (from, tip) = (leader.path[0], leader.path[leader.path.len() - 1]);
    let is_own = |segment: &Segment| is_piece(segment, from, tip);
    let at_end = |beside: MmPoint| drawn.nearest(beside, OFF_LEADER, is_own);
    let Some((_, end, _)) = drawn_end(from, tip, drawn).and_then(at_end) else { return true };
    let last = end.lerp(from, (LAST / (end - from).length().max(STEP)).min(1.0));
    let steps = ((end - last).length() / STEP).ceil().max(1.0) as u32;
    let mut places = (0..=steps).map(|step| last.lerp(end, step as f32 / steps as f32));
    places.any(|at| drawn.nearest(at, ON_PAGE, |segment| !is_own(segment)).is_some())
        || !leader.ends_at_line && is_shut_in(end, lines, figure)
}

/// Whether a segment is a piece of a leader line with these ends: all pieces are, as others may cut it where they cross
/// it.
fn is_piece(segment: &Segment, from: MmPoint, tip: MmPoint) -> bool {
    [segment.a, segment.b].iter().all(|at| nearest_on_segment(*at, from, tip).0 <= OFF_LEADER)
}

/// About where a leader line with these ends stops on the page; none if no piece of it is drawn.
fn drawn_end(from: MmPoint, tip: MmPoint, drawn: &Nearby) -> Option<MmPoint> {
    let steps = ((tip - from).length() / STEP).ceil().max(1.0) as u32;
    let mut back = (0..=steps).map(|step| tip.lerp(from, step as f32 / steps as f32));
    back.find(|at| drawn.nearest(*at, OFF_LEADER, |segment| is_piece(segment, from, tip)).is_some())
}

/// Whether a leader line ends short of its tip on the page, and nearer to another line than to the one at its tip: a
/// finger that goes on from its end comes to that one.
fn leads_to_other(path: &[MmPoint], drawn: &Nearby) -> bool {
    let (from, tip) = (path[0], path[path.len() - 1]);
    let nearest = |at: MmPoint| drawn.nearest(at, LAST, |segment| !is_piece(segment, from, tip));
    let Some(end) = drawn_end(from, tip, drawn) else { return false };
    let is_short = (tip - end).length() > AT_TIP;
    let lines = nearest(end).zip(nearest(tip)).map(|((_, _, at_end), (_, _, at_tip))| (at_end.line, at_tip.line));
    is_short && lines.is_some_and(|(at_end, at_tip)| at_end != at_tip)
}

/// Where the leader lines on a page of dots run that lead from texts, which stand up to `beside` mm beside them, to
/// what these name; none on paper.
pub(super) fn on_page(edges: &Edges, (texts, beside): (&[Text], f32), layout: &Layout) -> Vec<[MmPoint; 2]> {
    let has_leader = |text: &Text| text.kept_leader.is_some();
    if matches!(layout.medium, Medium::Print(_)) || !texts.iter().any(has_leader) {
        return Vec::new();
    }
    let transform = PageTransform::new(edges.size, layout.figure);
    let leaders = find(edges, (texts, beside), has_leader, layout.figure, &transform);
    leaders.iter().map(|leader| [leader.path[0], leader.path[leader.path.len() - 1]]).collect()
}

/// The rows of a page of dots that have every second dot: leader lines, or parts of them beyond what they cross, which
/// lead to no text by themselves.
pub(super) fn of_dots(page: &Page) -> impl Iterator<Item = [MmPoint; 2]> + '_ {
    let step = match &page.medium {
        Medium::Print(_) => None,
        Medium::Dots(medium) => Some(HOLE * medium.pitch),
    };
    let rows = page.figure.lines.iter().filter_map(Line::row);
    let spaced = rows.filter(move |row| step.is_some_and(|step| has_every_second(&row.points, step)));
    spaced.filter_map(|row| Some([*row.points.first()?, *row.points.last()?]))
}

/// Lines, of which those along these leader lines have every second dot on a page of dots: rows of one step all feel
/// alike. What stands beside its row, such as a point, says enough.
pub(super) fn spaced(mut lines: Vec<Line>, leaders: &[[MmPoint; 2]], layout: &Layout) -> Vec<Line> {
    let Medium::Dots(medium) = &layout.medium else { return lines };
    for line in &mut lines {
        let Some([_, tip]) = along(line, leaders, medium.pitch) else { continue };
        let [run] = &mut line.runs[..] else { continue };
        let far = |at: Option<&MmPoint>| at.map_or(0.0, |at| (*tip - *at).length());
        let leads_back = far(run.points.first()) < far(run.points.last());
        if leads_back {
            run.points.reverse();
        }
        run.points = every_second(&run.points, medium.pitch);
        if leads_back {
            run.points.reverse();
        }
    }
    lines
}

/// How far from its label a leader line on a page begins, mm, at most: on a grid of letters beyond the cell beside it.
pub(super) fn reach(page: &Page, cell: CellSize) -> f32 {
    let cells = CellGrid::of(&page.medium, cell);
    let beyond = if cells.is_of_letters() { cells.size().cell + 2.0 * page.medium.pitch() } else { 0.0 };
    LEADER_FROM_BRAILLE.max(beyond)
}

/// The nearest of the leader lines along which a line lies: its ends are no farther off than others that stand for one,
/// or on a coarse grid than a step of `pitch` mm. A piece of an outline beside a leader line is farther off.
fn along<'a>(line: &Line, leaders: &'a [[MmPoint; 2]], pitch: f32) -> Option<&'a [MmPoint; 2]> {
    let off = |leader: &[MmPoint; 2]| off_leader(line, leader).unwrap_or(f32::INFINITY);
    let nearest = leaders.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
    (off(nearest) <= OFF_LEADER.max(pitch)).then_some(nearest)
}

/// How far the ends of a line lie off a leader line, mm, if it is a row of dots beside that and of its direction.
fn off_leader(line: &Line, [from, tip]: &[MmPoint; 2]) -> Option<f32> {
    let (first, last) = line.row().and_then(|row| row.points.first().zip(row.points.last()))?;
    let way = |from: MmPoint, to: MmPoint| (to - from).try_normalize().unwrap_or_default();
    let off = |at: &MmPoint| nearest_on_segment(*at, *from, *tip).0;
    let is_along = way(*from, *tip).dot(way(*first, *last)).abs() >= ALONG;
    let is_near = || line.runs.iter().flat_map(|run| &run.points).all(|at| off(at) <= DRAWN);
    (is_along && is_near()).then(|| off(first).max(off(last)))
}

/// What is told of leader lines that lead to nothing on the page.
fn told_to_nothing(names: &[&str]) -> Option<Note> {
    let (lines, ends) = match names.len() {
        0 => return None,
        1 => ("the leader line", "ends"),
        _ => ("the leader lines", "end"),
    };
    let told = format!(
        "{lines} of {} {ends} in the blank, as what is there in the drawing has no room on the page",
        named(names)
    );
    let helped = Told::from(told).or_larger();
    Some(Note::TakenAs(About::Leaders, Reason::LeadsToNothing, helped))
}

/// The contours of an overview: it has no words, and a leader line to nothing would be felt as a part of the drawing.
/// None where no leader line has to go.
pub(super) fn without_leaders(edges: &Edges, texts: &[Text], layout: &Layout) -> Option<Edges> {
    let transform = PageTransform::new(edges.size, layout.figure);
    let leaders = layout.overview.map(|_| find(edges, (texts, FROM_PRINT), |_| true, layout.figure, &transform))?;
    // a copy takes time: of a photograph also the tree of its regions is in it
    if leaders.is_empty() {
        return None;
    }
    let is_leader = |number: usize| leaders.iter().any(|leader| leader.chain == number);
    let mut without = edges.clone();
    let mut numbers = 0..;
    without.chains.retain(|_| numbers.next().is_none_or(|number| !is_leader(number)));
    Some(without)
}

/// What is told of them.
pub(super) fn told_without(overview: Option<&Edges>, figure: &Edges) -> Option<Note> {
    let lines = counted(figure.chains.len() - overview?.chains.len(), "leader line");
    let told = format!("{lines} of words in the figure only, as the overview has no words");
    Some(Note::TakenAs(About::Overview, Reason::LeadersNotInOverview, told.into()))
}

/// What the maker is told of those that are left out.
fn told_lost(texts: &[Text]) -> Option<Note> {
    let names: Vec<&str> =
        texts.iter().filter(|text| text.lost_leader.is_some()).map(|text| text.string.as_str()).collect();
    let (lines, they_have) = match names.len() {
        0 => return None,
        1 => ("the leader line", "it has"),
        _ => ("the leader lines", "they have"),
    };
    let why = "no room as a whole beside other lines, or would end nearer to something else; the label stands right at \
               what it names instead, has a leader line of its own, or is told as left out";
    Some(Note::NotOnPage(
        About::Leaders,
        Reason::NoRoomForLeader,
        format!("{lines} of {}: {they_have} {why}", named(&names)).into(),
    ))
}

/// The leader lines of texts that become labels.
fn find(
    edges: &Edges,
    (texts, beside): (&[Text], f32),
    is_label: impl Fn(&Text) -> bool,
    figure: MmRect,
    transform: &PageTransform,
) -> Vec<Leader> {
    let are_words = |text: &Text| is_label(text) && text.string.chars().any(char::is_alphabetic);
    let of_words: Vec<usize> = (0..texts.len()).filter(|&text| are_words(&texts[text])).collect();
    if !edges.of_drawing() || of_words.is_empty() {
        return Vec::new();
    }
    let chains: Vec<Vec<MmPoint>> =
        edges.chains.iter().map(|chain| on_sheet(edges, chain, transform).collect()).collect();
    let mut index = Nearby::new(figure, beside);
    for (line, (points, chain)) in (0..).zip(chains.iter().zip(&edges.chains)) {
        index.insert_line(line, PolylineRef { vertices: points, closed: chain.closed }, 0.0);
    }
    let longest = LONGEST_LEADER * figure.width().max(figure.height());
    let are_shafts = lines::are_shafts(edges, transform, figure);
    let is_leader = |number: usize| -> Option<Leader> {
        let (points, chain) = (&chains[number], &edges.chains[number]);
        let length = PolylineRef { vertices: points, closed: false }.length();
        let (first, last) = (*points.first()?, *points.last()?);
        // an arrow says which way something goes, whatever words stand at its ends
        let is_line = !chain.closed && !chain.kind.added && !are_shafts[number];
        let is_line = is_line && (SHORTEST_LEADER..longest).contains(&length);
        if !is_line || (last - first).length() < STRAIGHT * length {
            return None;
        }
        // beyond the cell beside a label only where no other is as near as usual
        let near = beside.min(LEADER_FROM_BRAILLE);
        let at_ends = |beside: f32| [first, last].map(|end| text_at(end, beside, texts, &of_words));
        let found = if at_ends(near) == [None, None] { at_ends(beside) } else { at_ends(near) };
        let (text, path) = match found {
            [Some(text), None] => (text, points.clone()),
            [None, Some(text)] => (text, points.iter().rev().copied().collect()),
            _ => return None,
        };
        // from a word to a number is a branch of a tree, as from word to word
        let (tip, is_other) = (path[path.len() - 1], |number: &usize| *number != text && !of_words.contains(number));
        if (0..texts.len()).filter(is_other).any(|number| distance_to_box(tip, texts[number].place) < near) {
            return None;
        }
        let place = texts[text].place;
        let leads = points_away(&path, place, beside)
            && is_free_end(path[0], place, number as u32, &index)
            && leads_to_something(&path, &index, |line| line != number as u32)
            && ticks_on(number, &chains, edges) < TICKS
            && !is_hinged(&path, number, &chains, edges);
        let ends_at_line = index.nearest(tip, AT_TIP, |segment| segment.line != number as u32).is_some();
        leads.then_some(Leader { chain: number, text, path, ends_at_line })
    };
    let is_beside_word = |end: MmPoint| text_at(end, BRANCH * beside, texts, &of_words).is_some();
    without_branches((0..chains.len()).filter_map(is_leader).collect(), &chains, is_beside_word, &index)
}

/// Those of some lines from words that lead to something else than to one another, or to the end of a line that comes
/// from beside a word, too: two that lead to one place where nothing else is are the branches of a tree.
fn without_branches(
    found: Vec<Leader>,
    chains: &[Vec<MmPoint>],
    is_beside_word: impl Fn(MmPoint) -> bool,
    index: &Nearby,
) -> Vec<Leader> {
    let mut are_found = vec![false; chains.len()];
    found.iter().for_each(|leader| are_found[leader.chain] = true);
    let leads_elsewhere = |leader: &Leader| {
        let tip = leader.path[leader.path.len() - 1];
        let is_branch = |line: u32| {
            let points = &chains[line as usize];
            let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return false };
            let comes_here = |near: MmPoint, far: MmPoint| (near - tip).length() <= AT_TIP && is_beside_word(far);
            let is_straight =
                || (last - first).length() >= STRAIGHT * PolylineRef { vertices: points, closed: false }.length();
            are_found[line as usize] || (comes_here(first, last) || comes_here(last, first)) && is_straight()
        };
        leads_to_something(&leader.path, index, |line| line as usize != leader.chain && !is_branch(line))
    };
    let leads: Vec<bool> = found.iter().map(leads_elsewhere).collect();
    found.into_iter().zip(leads).filter_map(|(leader, leads)| leads.then_some(leader)).collect()
}

/// The nearest of texts `of_words` to the end of a line, if it is nearer than `beside` mm.
fn text_at(end: MmPoint, beside: f32, texts: &[Text], of_words: &[usize]) -> Option<usize> {
    let far = |text: &usize| distance_to_box(end, texts[*text].place);
    let nearest = of_words.iter().copied().min_by(|a, b| far(a).total_cmp(&far(b)))?;
    (far(&nearest) < beside).then_some(nearest)
}

/// Whether a line leads away from a text, and not past it: led on backwards, it comes to the text, or beside it by half
/// of what may lie between the two.
fn points_away(path: &[MmPoint], text: MmRect, beside: f32) -> bool {
    let (from, tip) = (path[0], path[path.len() - 1]);
    let Some(back) = (from - tip).try_normalize() else { return false };
    let around = text.inflate(ASIDE * beside, ASIDE * beside);
    let reach = distance_to_box(from, text) + text.width().hypot(text.height());
    let steps = (reach / STEP).ceil() as u32;
    (0..=steps).any(|step| around.contains(from + back * (STEP * step as f32)))
        && (text.center() - from).dot(back) > 0.0
}

/// Whether nothing but the text is at an end of a line, and nothing lies between the two.
fn is_free_end(end: MmPoint, text: MmRect, line: u32, index: &Nearby) -> bool {
    let at_text = end.clamp(text.min, text.max);
    let mut parted = false;
    index.around(end.min(at_text), end.max(at_text), 0.0, |segment| {
        parted |= segment.line != line && crossing((end, at_text), (segment.a, segment.b)).is_some();
    });
    !parted && index.nearest(end, LEADER_FREE, |segment| segment.line != line).is_none()
}

/// Whether a line ends at another one which is a thing, or crosses one on its way.
fn leads_to_something(path: &[MmPoint], index: &Nearby, is_thing: impl Fn(u32) -> bool) -> bool {
    let (from, tip) = (path[0], path[path.len() - 1]);
    let is_other = |segment: &Segment| is_thing(segment.line);
    let mut crosses = false;
    index.around(from.min(tip), from.max(tip), 0.0, |segment| {
        crosses |= is_other(segment) && crossing((from, tip), (segment.a, segment.b)).is_some();
    });
    crosses || index.nearest(tip, AT_TIP, is_other).is_some()
}

/// Whether a line goes on at its tip from a single other one that ends there, as the lever of a switch from its wire: a
/// leader line ends at a thing, and where it parts the outline of one two lines end.
fn is_hinged(path: &[MmPoint], line: usize, chains: &[Vec<MmPoint>], edges: &Edges) -> bool {
    let (from, tip) = (path[0], path[path.len() - 1]);
    let Some(way) = (from - tip).try_normalize() else { return false };
    let others = (0..chains.len()).filter(|&other| other != line && !edges.chains[other].closed);
    let ends = others.flat_map(|other| [end_of(chains[other].iter()), end_of(chains[other].iter().rev())]).flatten();
    let at_joint: Vec<[MmPoint; 2]> = ends.filter(|[end, _]| (tip - *end).length() <= AT_JOINT).collect();
    let [[end, inner]] = at_joint[..] else { return false };
    let (heading, to_tip) = ((end - inner).try_normalize().unwrap_or_default(), tip - end);
    // the two may also end beside one another
    heading.dot(way) >= GOES_ON && heading.dot(to_tip) >= GOES_ON * to_tip.length() - LEADER_FREE
}

/// The end of a line with these points, the last first, and the place from which it leads there; none of a crumb.
fn end_of<'p>(mut back: impl Iterator<Item = &'p MmPoint>) -> Option<[MmPoint; 2]> {
    let end = *back.next()?;
    back.find(|inner| (**inner - end).length() >= TO_JOINT).map(|inner| [end, *inner])
}

/// How many short lines stand on a line or cross it with their middle, without its ends.
fn ticks_on(number: usize, chains: &[Vec<MmPoint>], edges: &Edges) -> usize {
    let points = &chains[number];
    let (Some(&from), Some(&to)) = (points.first(), points.last()) else { return 0 };
    let is_tick = |(other, points): (usize, &Vec<MmPoint>)| {
        let length = PolylineRef { vertices: points, closed: false }.length();
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return false };
        let stands = |at: MmPoint| {
            let (distance, foot) = nearest_on_segment(at, from, to);
            distance < LEADER_FREE && (foot - from).length().min((foot - to).length()) > LEADER_FREE
        };
        let is_short = other != number && !edges.chains[other].closed && length < SHORTEST_LEADER;
        is_short && [first, last, first.lerp(last, 0.5)].into_iter().any(stands)
    };
    chains.iter().enumerate().filter(|of| is_tick(*of)).count()
}

/// Lines in an area, to be found by their places; those of dots by pieces over several of them.
fn index_of_pieces(lines: &[Line], area: MmRect) -> Nearby {
    let mut index = Nearby::new(area, DRAWN);
    for (line, run) in (0..).zip(lines).flat_map(|(number, line)| line.runs.iter().map(move |run| (number, run))) {
        let points: Vec<MmPoint> = run.polyline().path().copied().collect();
        let over = if run.pen == Pen::Stroke { 1 } else { STEPS_OF_DOTS.min(points.len().saturating_sub(1)).max(1) };
        for (number, piece) in (0..).zip(points.windows(over + 1)) {
            let (a, b) = (piece[0], piece[over]);
            index.insert(Segment { a, b, half_width: 0.0, line, index: number, arc: 0.0 });
        }
    }
    index
}

/// Whether a line is drawn along a path as far as its tip, without gaps in which a finger would lose it.
fn is_whole(path: &[MmPoint], drawn: &Nearby, longest_gap: f32) -> bool {
    let (from, tip) = (path[0], path[path.len() - 1]);
    let direction: MmVector = (tip - from).try_normalize().unwrap_or_default();
    let steps = ((tip - from).length() / STEP).ceil().max(1.0) as u32;
    let is_drawn = |step: u32| {
        let at = from.lerp(tip, step as f32 / steps as f32);
        let along = |segment: &Segment| {
            let other = (segment.b - segment.a).try_normalize().unwrap_or_default();
            let beside = nearest_on_segment(at, segment.a, segment.b).1 - at;
            direction.dot(other).abs() >= ALONG && beside.dot(direction).abs() <= OFF_LEADER
        };
        drawn.nearest(at, DRAWN, along).is_some()
    };
    let mut gap = 0.0;
    let has_no_gap = (0..=steps).all(|step| {
        gap = if is_drawn(step) { 0.0 } else { gap + STEP };
        gap <= longest_gap
    });
    // a line that begins at the wall that it crosses leads to that
    let begins = (0..=steps.min(((longest_gap - GAP) / STEP) as u32)).any(is_drawn);
    has_no_gap && begins
}

#[cfg(test)]
mod tests;
