//! Pages of dots: what is done otherwise than for a printed page.

use super::finish::{PageSays, finished, origin, title_of_overview};
use super::kept_lines;
use super::lost_signs::{MOVED, extent, is_small_ring, kind};
use super::open_rings;
use super::request::Request;
use super::told_signs;
use super::torn_lines::torn;
use crate::Error;
use crate::classes::Classes;
use crate::dots;
use crate::dots::ShownScale;
use crate::edges::Edges;
use crate::geom::polygon::holds_box;
use crate::lines::{GONE, Line, Lines, LostLine, LostScale, LostSign, Run, SignKind, TickMark, lost_form};
use crate::page::layout::Layout;
use crate::page::{BrailleText, DotMedium, Dots, Figure, InSet, Medium, Page, Parts, Texture, frame, which_are_weak};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect};

/// Lines of these contours in `area` as the device presses them; on a printed page they stay.
pub(super) fn pressed(mut drawn: Lines, edges: &Edges, area: MmRect, layout: &Layout, plan: &Plan) -> Lines {
    let Medium::Dots(medium) = &layout.medium else {
        let heads = drawn.marks.heads.iter().filter(|head| !head.is_drawn);
        drawn.lost.signs.extend(heads.map(|head| LostSign { at: head.at, kind: SignKind::Arrowhead }));
        return drawn;
    };
    let params = dots::Params { whole_rows: edges.of_drawing(), ..plan.dots(medium) };
    let press = |drawn: &Lines| dots::with_marks(&drawn.lines, &drawn.marks, area, &medium.area, &params);
    let (mut lines, mut shown) = press(&drawn);
    let least_strength = plan.lines().least_strength;
    if let Some((others, alone)) = without_squared_grid(&drawn, &lines, press, area, least_strength) {
        (drawn, (lines, shown)) = (others, alone);
    }
    let (stand_for, mut shares) = kept_lines::matched(&drawn.lines, area, &lines, area);
    without_insides(&mut shares, &drawn, &shown.points, &lines);
    // the dots of a line through a small ring are near to all of it, and none of them is its own
    let around = |line: &Line| {
        let points = || line.runs.iter().flat_map(|run| run.points.iter());
        line.length() + points().next().zip(points().last()).map_or(0.0, |(first, last)| (*last - *first).length())
    };
    let has_own = |ring: &Line| {
        let reach = extent(ring).inflate(MOVED, MOVED);
        lines.iter().any(|line| holds_box(reach, extent(line)) && around(line) >= WHOLE * ring.length())
    };
    let is_lost_sign = |(line, share): &(&Line, &f32)| is_small_ring(line) && (**share < WHOLE || !has_own(line));
    let signs: Vec<LostSign> = drawn
        .lines
        .iter()
        .zip(&shares)
        .filter(is_lost_sign)
        .map(|(line, _)| LostSign { at: extent(line).center(), kind: kind(line, &lines) })
        .collect();
    let mut lost = drawn.lost.keeping(kept_of((&drawn.lines, &shares), &lines, area, medium.pitch));
    let gone = drawn.lines.iter().zip(&shares).filter(|(line, share)| **share < GONE && !is_small_ring(line));
    lost.gone.extend(gone.map(|(line, _)| gone_line(line)));
    let open = open_rings::gaps(&drawn.lines, &lines, &stand_for, [params.pitch, params.centres()]);
    // of a photograph a small gap says little
    let of_drawing = edges.of_drawing();
    if of_drawing {
        lost.torn.extend(torn((&drawn.lines, &shares), (&lines, &stand_for), area, params.pitch, least_strength));
    }
    let open = open.into_iter().map(|gap| gap.filter(|_| of_drawing));
    let rings = drawn.lines.iter().zip(&shares).zip(open).filter(|(of, _)| *of.1 >= GONE && !is_lost_sign(of));
    lost.gaps.extend(rings.filter_map(|(of, gap)| lost_of_ring(of).or(gap)));
    lost.signs.extend(signs);
    let points = drawn.marks.points.iter().zip(&shown.points).filter(|(_, is_drawn)| !**is_drawn);
    let signs = told_signs::places(edges, area);
    lost.signs.extend(points.map(|(point, _)| LostSign { at: point.at, kind: told_signs::kind_of(point.at, &signs) }));
    let heads = drawn.marks.heads.iter().zip(&shown.heads).filter(|(_, is_drawn)| !**is_drawn);
    lost.signs.extend(heads.map(|(head, _)| LostSign { at: head.at, kind: SignKind::Arrowhead }));
    // beside those whose ticks are lines, as on a page of few shapes
    lost.scales.extend(drawn.marks.scales.iter().zip(&shown.scales).filter_map(lost_ticks));
    Lines { lines, marks: drawn.marks, lost, beyond: drawn.beyond }
}

/// The end of a line lies no farther than this beyond the ring in which that line is, mm.
const BEYOND_RING: f32 = 1.0;
/// A ring of a point without dots in this share of its radius is hollow.
const HOLLOW: f32 = 0.5;

/// Takes the shares from lines that lie as a whole in the ring of a point which is hollow on the page, as the cross in
/// the sign of a lamp: the dots of the ring are near to them, and none is their own.
fn without_insides(shares: &mut [f32], drawn: &Lines, is_drawn: &[bool], pressed: &[Line]) {
    let rings = drawn.marks.points.iter().zip(is_drawn).filter(|(point, is_drawn)| !point.is_filled && **is_drawn);
    for (ring, _) in rings {
        let far = |at: &MmPoint| (*at - ring.at).length();
        let mut dots = pressed.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        if dots.any(|at| far(at) < HOLLOW * ring.radius) {
            continue;
        }
        for (line, share) in drawn.lines.iter().zip(shares.iter_mut()).filter(|(line, _)| !is_small_ring(line)) {
            let mut points = line.runs.iter().flat_map(|run| &run.points);
            if points.all(|at| far(at) <= ring.radius + BEYOND_RING) {
                *share = 0.0;
            }
        }
    }
}

/// A line of which hardly any dots are left.
fn gone_line(line: &Line) -> LostLine {
    let path = line.own_path();
    let (extent, length, form) = (extent(line), line.length(), lost_form(&path));
    LostLine { extent, length, closed: false, is_faint: false, form }
}

/// The lines without a squared grid, and how they are pressed, if there is one that is torn among those `pressed`, or
/// takes too much of the others.
fn without_squared_grid<P>(
    drawn: &Lines,
    pressed: &[Line],
    press: impl Fn(&Lines) -> (Vec<Line>, P),
    area: MmRect,
    least_strength: f32,
) -> Option<(Lines, (Vec<Line>, P))> {
    let grid = squared_grid(&drawn.lines, least_strength);
    let numbered = || drawn.lines.iter().cloned().enumerate();
    let of_grid: Vec<Line> = numbered().filter(|(number, _)| grid.contains(number)).map(|(_, line)| line).collect();
    if of_grid.is_empty() {
        return None;
    }
    let lines = numbered().filter(|(number, _)| !grid.contains(number)).map(|(_, line)| line).collect();
    let mut others = Lines { lines, ..drawn.clone() };
    let alone = press(&others);
    let length = |lines: &[Line]| lines.iter().map(Line::length).sum::<f32>();
    // what it lacked already, before any line became dots, is missing too
    let lacked = drawn.lost.of_gridlines.iter().sum::<f32>().max(0.0);
    let kept = kept_of_grid(&drawn.lines, &grid, pressed, area, least_strength);
    let is_torn = kept < GRID_WHOLE * (length(&of_grid) + lacked);
    // a line of the grid at the same place does not stand for another
    let strong = pressed.iter().zip(which_are_weak(pressed, least_strength)).filter(|(_, is_weak)| !is_weak);
    let strong: Vec<Line> = strong.map(|(line, _)| line.clone()).collect();
    let hidden = kept_length(&others.lines, &alone.0, area) - kept_length(&others.lines, &strong, area);
    if !is_torn && hidden <= HIDDEN * length(&others.lines) {
        return None;
    }
    others.lost.without_gridlines(grid.len(), length(&of_grid));
    Some((others, alone))
}

/// The share of lines that become dots, by length: what a grid has no room for counts as crowded out too. `shares` are
/// those of each line by its own dots. These are shorter than the line by a step of `pitch` mm where it ends at another
/// one, and cut its corners, which is no loss: there are dots no further from it than a step. Of a line that is gone
/// those of others do not count.
fn kept_of((lines, shares): (&[Line], &[f32]), pressed: &[Line], area: MmRect, pitch: f32) -> f32 {
    let whole: f32 = lines.iter().map(Line::length).sum();
    let covered = kept_lines::covered(lines, pressed, area, pitch);
    let of_line = |((line, own), covered): ((&Line, &f32), f32)| {
        let share = if *own < GONE { *own } else { own.max(covered).min(1.0) };
        share * line.length()
    };
    let kept: f32 = lines.iter().zip(shares).zip(covered).map(of_line).sum();
    if whole > 0.0 { kept / whole } else { 1.0 }
}

/// A squared grid of which less than this share becomes dots is left out as a whole: bits of it are felt as lines.
/// Chosen by us.
const GRID_WHOLE: f32 = 0.9;
/// It is also left out where the other lines lack more than this share of their length by it, such as the corner of a
/// triangle that lies on it: its dots are those of any line.
const HIDDEN: f32 = 0.01;
/// So many lines each way are a squared grid.
const GRID_LINES: usize = 4;

/// The numbers of the lines of a squared grid, thin and pale ones level and upright, and of their pieces; none if there
/// is no such grid.
fn squared_grid(lines: &[Line], least_strength: f32) -> Vec<usize> {
    let weak = which_are_weak(lines, least_strength);
    let weak: Vec<usize> = (0..lines.len()).filter(|&number| weak[number]).collect();
    let way = |line: &Line| {
        let size = extent(line).size();
        (size.width.min(size.height) < STRAIGHT).then_some(size.width > size.height)
    };
    let of_grid = |line: &Line| way(line).map(|is_level| (is_level, across(extent(line).center(), is_level)));
    let gridlines: Vec<(bool, f32)> = weak.iter().filter_map(|&number| of_grid(&lines[number])).collect();
    let count = |level: bool| gridlines.iter().filter(|(of, _)| *of == level).count();
    if count(true) < GRID_LINES || count(false) < GRID_LINES {
        return Vec::new();
    }
    let is_in_line = |line: &Line| gridlines.iter().any(|of| length_along(line, *of) >= MOSTLY * line.length());
    let is_of_grid = |line: &Line| way(line).is_some() || is_led_aside(line) || is_in_line(line);
    weak.into_iter().filter(|&number| is_of_grid(&lines[number])).collect()
}

/// Where a point is across a level or upright line.
fn across(at: MmPoint, is_level: bool) -> f32 {
    if is_level { at.y } else { at.x }
}

/// How much of a line lies where a level or upright one does, or would if it went on, mm: a piece of a gridline that is
/// led far aside, to the curve on which it ends, lies in line with the other pieces but there.
fn length_along(line: &Line, (is_level, place): (bool, f32)) -> f32 {
    let is_there = |at: MmPoint| (across(at, is_level) - place).abs() <= STRAIGHT;
    let sides = line.runs.iter().flat_map(|run| run.path().zip(run.path().skip(1)));
    sides.filter(|(a, b)| is_there(*a) && is_there(*b)).map(|(a, b)| (b - a).length()).sum()
}

/// Whether a line is level or upright but for where it is led aside: a piece of a gridline that ends at another line
/// beside its place.
fn is_led_aside(line: &Line) -> bool {
    let size = extent(line).size();
    let is_level = size.width > size.height;
    let sides = line.runs.iter().flat_map(|run| run.path().zip(run.path().skip(1)));
    let along = sides.map(|(a, b)| if is_level { (b.x - a.x, b.y - a.y) } else { (b.y - a.y, b.x - a.x) });
    let straight: f32 = along.filter(|(along, aside)| aside.abs() <= SLOPE * along.abs()).map(|(by, _)| by.abs()).sum();
    size.width.min(size.height) <= MOVED && straight >= MOSTLY * line.length()
}

/// How much of some lines is among those that are `pressed`, mm.
fn kept_length(lines: &[Line], pressed: &[Line], area: MmRect) -> f32 {
    let (_, shares) = kept_lines::matched(lines, area, pressed, area);
    lines.iter().zip(shares).map(|(line, share)| share.min(1.0) * line.length()).sum()
}

/// How much of a grid, of these of the lines, is among those that are `pressed`, mm. Its dots are those of weak rows to
/// which no other weak line is nearer: an axis beside it and points on it are strong or closed, and no part of it.
fn kept_of_grid(lines: &[Line], grid: &[usize], pressed: &[Line], area: MmRect, least_strength: f32) -> f32 {
    let weak_ones = |lines: &[Line]| -> Vec<(usize, Line)> {
        let weak = which_are_weak(lines, least_strength);
        lines.iter().cloned().enumerate().filter(|(number, _)| weak[*number]).collect()
    };
    let (numbers, weak): (Vec<usize>, Vec<Line>) = weak_ones(lines).into_iter().unzip();
    let is_sign = |line: &Line| line.is_block_of_dots() || line.is_ring_of_dots();
    let pieces = weak_ones(pressed).into_iter().flat_map(|(_, line)| pieces_of(&line));
    let rows: Vec<Line> = pieces.filter(|line| !is_sign(line)).collect();
    let (_, shares) = kept_lines::matched(&weak, area, &rows, area);
    let all = numbers.into_iter().zip(weak.iter().zip(shares));
    let of_grid = all.filter(|(number, _)| grid.contains(number));
    of_grid.map(|(_, (line, share))| share.min(1.0) * line.length()).sum()
}

/// A line of dots as its pieces, where points interrupt its row.
fn pieces_of(line: &Line) -> Vec<Line> {
    let Some(row) = line.row() else { return vec![line.clone()] };
    let step = row.points.windows(2).map(|pair| (pair[1] - pair[0]).length()).fold(f32::INFINITY, f32::min);
    let pieces = row.points.chunk_by(|a, b| (*b - *a).length() <= WIDER_THAN_CROSSED * step);
    let piece = |points: &[MmPoint]| Run { points: points.to_vec(), ..row.clone() };
    pieces.map(|points| Line { strength: line.strength, runs: vec![piece(points)] }).collect()
}
/// A step that is more than so many times the least of a row parts it: where it crosses another line one dot is
/// missing.
const WIDER_THAN_CROSSED: f32 = 2.1;

/// A level or upright line is no farther from being so, mm.
const STRAIGHT: f32 = 0.3;
/// A side of a line is level or upright if it rises by no more than this share: a gridline of 60 mm by 0.6 mm.
const SLOPE: f32 = 0.01;
/// A piece of a gridline that is led aside keeps its direction for at least this share of its length: the shortest
/// line of an embosser is 12.5 mm long, and is led on by 4 mm at most (`lines.join_gap`).
const MOSTLY: f32 = 0.6;

/// What of a scale is not drawn.
fn lost_ticks((scale, shown): (&Vec<TickMark>, &ShownScale)) -> Option<LostScale> {
    let mut lost = scale.iter().zip(&shown.ticks).filter(|(_, is_drawn)| !**is_drawn).map(|(tick, _)| tick);
    let first = lost.next()?.at;
    Some(LostScale { ticks: scale.len(), lost: 1 + lost.count(), every: shown.every, first })
}

/// What a closed line lacks of which this share becomes dots, if that is more than a little.
fn lost_of_ring((line, share): (&Line, &f32)) -> Option<LostLine> {
    let is_small = is_small_ring(line);
    let is_closed = is_small || line.runs.iter().any(|run| run.closed);
    let least = if is_small { WHOLE } else { WHOLE_RING };
    let length = (1.0 - share) * line.length();
    (is_closed && *share < least).then(|| {
        let extent = extent(line);
        LostLine { extent, length, closed: true, is_faint: false, form: None }
    })
}

/// A closed line of which less than this share becomes dots is open: less is lost where lines meet.
const WHOLE_RING: f32 = 0.9;

/// A ring of which less than this share is there is none any more: between two dots a step is missing at most.
const WHOLE: f32 = 0.7;

/// The lines of the overview: all of one width and, where there are heights, high.
pub(super) fn of_overview(mut drawn: Lines, area: MmRect, layout: &Layout, plan: &Plan) -> Lines {
    let Medium::Dots(medium) = &layout.medium else { return drawn };
    let heavy_from = if medium.device.has_heights() { 0.0 } else { f32::INFINITY };
    let params = dots::Params { heavy_from, ..plan.dots(medium) };
    let (lines, shown) = dots::with_marks(&drawn.lines, &drawn.marks, area, &medium.area, &params);
    let (stand_for, shares) = kept_lines::matched(&drawn.lines, area, &lines, area);
    let open = open_rings::gaps(&drawn.lines, &lines, &stand_for, [params.pitch, params.centres()]);
    let rings = drawn.lines.iter().zip(&shares).zip(open);
    drawn.lost.gaps = rings.filter_map(|(of, gap)| lost_of_ring(of).or(gap)).collect();
    drawn.lost.rings += shown.points.iter().filter(|is_drawn| !**is_drawn).count();
    Lines { lines, ..drawn }
}

/// Textures of dots.
pub(super) fn textures(
    classes: &Classes,
    area: MmRect,
    lines: &[Line],
    medium: &DotMedium,
    plan: &Plan,
) -> Vec<Texture> {
    dots::textures::fill(classes, area, lines, &medium.area, &plan.dot_textures(medium))
}

/// The page of a figure, and that of its overview, which has a sheet to itself: one of dots has no room for both.
pub(super) fn assemble(
    figure: Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    said: PageSays,
    [braille, above_overview]: [Vec<BrailleText>; 2],
    layout: &Layout,
    medium: &DotMedium,
    request: &Request<'_>,
) -> Result<(Page, Option<Page>), Error> {
    let source = figure.source;
    let overview = overview
        .map(|(place, lines)| {
            let own = Figure { place, source, textures: Vec::new(), lines };
            let title = title_of_overview(request.title, request.language);
            let mut parts = parts(title, own, above_overview, (layout, place, medium), request);
            parts.origin.push(InSet::Overview.to_origin());
            finished(parts, request)
        })
        .transpose()?;
    let mut parts = parts(request.title.to_owned(), figure, braille, (layout, layout.room, medium), request);
    parts.origin.extend(overview.is_some().then(|| InSet::Followed.to_origin()));
    parts.origin.extend(said.to_origin());
    parts.labels.extend(said.label);
    let page = finished(parts, request)?;
    Ok((page, overview))
}

fn parts(
    title: String,
    figure: Figure,
    braille: Vec<BrailleText>,
    (layout, room, medium): (&Layout, MmRect, &DotMedium),
    request: &Request<'_>,
) -> Parts {
    let params = request.plan.dots(medium);
    let mark = |run: &Run| dots::mark(&run.points, &medium.area, &params);
    let around = |params| frame::dotted(room, &params, medium);
    Parts {
        title,
        origin: origin(request, figure.source, &braille),
        frame: request.plan.layout().frame.map_or_else(Dots::default, around),
        orientation_mark: layout.mark.as_ref().map(mark),
        braille,
        medium: layout.medium.clone(),
        ..Parts::of(layout.sheet, figure)
    }
}

#[cfg(test)]
mod tests;
