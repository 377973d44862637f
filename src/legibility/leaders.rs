//! Lines that lead from labels: whether a finger that follows one finds anything at its end.

use std::f32::consts::TAU;

use super::finding::{FoundBreach, around};
use super::limits::LEADER_END;
use super::marks::name_in;
use super::paths::{PathKind, Paths};
use super::rules::LABEL_LINE;
use crate::geom::nearby::Nearby;
use crate::geom::polygon::distance_to_box;
use crate::geom::{crossing, nearest_on_segment};
use crate::page::{BrailleText, Line, Names, Page, Run, TextRole, text_name, which_are_weak};
use crate::units::{MmPoint, MmRect, MmVector};

/// Directions in which it is looked for the sides of a shape around the end of a line.
const DIRECTIONS: u32 = 16;

/// A leader line that is a line of the figure begins so near to its label, mm: braille may be as high as the line below
/// it and keeps its clearance.
pub(crate) const LEADER_FROM_BRAILLE: f32 = 8.0;
/// Its label lies before its end but for 60 degrees: the cosine. One along it, as at a scale, names the line.
const BEFORE: f32 = 0.5;
/// Nothing else is so near to where it begins, mm: there sides of shapes meet.
pub(crate) const LEADER_FREE: f32 = 1.5;
/// The shortest, mm: what is shorter beside a word may be a tick, and is no further from it than a label.
pub(crate) const SHORTEST_LEADER: f32 = 8.0;
/// The longest, as a share of the longer side of the figure: what is longer, such as an axis, is a line by itself.
pub(crate) const LONGEST_LEADER: f32 = 0.4;
/// It is straight: its chord is at least this share of it.
pub(crate) const LEADER_STRAIGHT: f32 = 0.95;

/// Of each label whose line ends in the blank, where that is; `index` has the lines of the figure, whose paths these
/// are.
pub(super) fn findings(
    page: &Page,
    names: &Names,
    paths: &Paths,
    index: &Nearby,
    least_strength: f32,
) -> Vec<FoundBreach> {
    let of = |text: &BrailleText| {
        let (at, leader) = (tip(text)?, text.leader.as_ref()?);
        if index.nearest(at, LEADER_END, |_| true).is_some() || is_in_something(at, page) {
            return None;
        }
        let extent = around(leader.points.iter().copied())?;
        let name = text_name(text);
        let what = format!("the line that leads from {name} ends where nothing is within {LEADER_END} mm");
        Some(FoundBreach::at(LABEL_LINE, at, extent, 0.0, what).unmeasured().of(&name))
    };
    let of_labels = page.braille.iter().filter_map(of);
    let weak = which_are_weak(&page.figure.lines, least_strength);
    let of_figure = |path| of_line(path, page, names, paths, index, &weak);
    of_labels.chain((0..paths.paths.len()).filter_map(of_figure)).collect()
}

/// So many lines of a grid end beside one another.
const GRID: usize = 3;
/// A line of a grid is level or upright, and ends where others do, within this, mm.
const LEVEL: f32 = 0.5;

/// Whether a line that ends here is one of a grid, or a piece of one that a label interrupts: a thin and pale, level or
/// upright one that ends where others of its kind do.
fn is_of_grid(line: usize, at: MmPoint, page: &Page, weak: &[bool]) -> bool {
    let extent = |line: &Line| around(line.runs.iter().flat_map(|run| run.points.iter().copied()));
    let is_level = |extent: MmRect| (extent.height() < LEVEL).then_some(true);
    let is_upright = |extent: MmRect| (extent.width() < LEVEL).then_some(false);
    let way = |line: &Line| extent(line).and_then(|extent| Some((extent, is_level(extent).or(is_upright(extent))?)));
    let lines = &page.figure.lines;
    let Some((_, own)) = lines.get(line).filter(|_| weak.get(line) == Some(&true)).and_then(way) else { return false };
    let ends_there = |of: MmRect| match own {
        true => (of.min.x - at.x).abs() < LEVEL || (of.max.x - at.x).abs() < LEVEL,
        false => (of.min.y - at.y).abs() < LEVEL || (of.max.y - at.y).abs() < LEVEL,
    };
    let of_grid = lines.iter().zip(weak).filter(|(_, is_weak)| **is_weak).filter_map(|(line, _)| way(line));
    of_grid.filter(|(extent, way)| *way == own && ends_there(*extent)).count() >= GRID
}

/// The same of a leader line that is a line of the figure, as drawings have them: a straight one, from a label on.
fn of_line(
    path: usize,
    page: &Page,
    names: &Names,
    paths: &Paths,
    index: &Nearby,
    weak: &[bool],
) -> Option<FoundBreach> {
    let of = &paths.paths[path];
    let place = page.figure.place;
    let lengths = SHORTEST_LEADER..LONGEST_LEADER * place.width().max(place.height());
    let [(_, a, _), (_, b, _)] = paths.tips(path).try_into().ok()?;
    let is_line = of.kind != PathKind::BesideRow && lengths.contains(&of.length);
    if !is_line || (b - a).length() < LEADER_STRAIGHT * of.length {
        return None;
    }
    let labels = || page.braille.iter().filter(|text| text.role == TextRole::Label);
    let boxes = || labels().filter_map(|text| Some((text, around(text.dots.at.iter().copied())?)));
    let label_at = |at: MmPoint| {
        let far = |cells: MmRect| distance_to_box(at, cells);
        boxes().min_by(|p, q| far(p.1).total_cmp(&far(q.1))).filter(|(_, cells)| far(*cells) < LEADER_FROM_BRAILLE)
    };
    let ((label, cells), from, at) = match (label_at(a), label_at(b)) {
        (Some(label), None) => (label, a, b),
        (None, Some(label)) => (label, b, a),
        _ => return None,
    };
    let ahead = (from.clamp(cells.min, cells.max) - from).try_normalize().unwrap_or_default();
    let way = (from - at).try_normalize()?;
    let is_other = |line: u32| paths.paths[line as usize].line != of.line;
    let is_near = |at: MmPoint, reach: f32| index.nearest(at, reach, |other| is_other(other.line)).is_some();
    // or another has an end or a corner on it, as a wire on the plate of a battery
    let mut crosses = false;
    index.around(a.min(b), a.max(b), LEADER_FREE, |other| {
        let ends_on = || [other.a, other.b].iter().any(|end| nearest_on_segment(*end, a, b).0 < LEADER_FREE);
        crosses |= is_other(other.line) && (crossing((a, b), (other.a, other.b)).is_some() || ends_on());
    });
    let is_own = label.leader.is_none() && way.dot(ahead) >= BEFORE && !is_near(from, LEADER_FREE);
    let is_something = is_near(at, LEADER_END) || is_in_something(at, page) || is_of_grid(of.line, at, page, weak);
    if !is_own || crosses || is_something {
        return None;
    }
    let (name, text) = (name_in(&names.lines, of.line), text_name(label));
    let what = format!("{name}, which leads from {text}, ends where nothing is within {LEADER_END} mm");
    Some(FoundBreach::at(LABEL_LINE, at, MmRect::new(a.min(b), a.max(b)), 0.0, what).unmeasured().of(name))
}

/// Whether a mark of a texture is near, or lines of the figure are on all sides.
fn is_in_something(at: MmPoint, page: &Page) -> bool {
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let to_glyph = glyphs.map(|glyph| (glyph.at - at).length()).fold(f32::MAX, f32::min);
    to_glyph <= LEADER_END || is_shut_in(at, &page.figure.lines, page.figure.place)
}

/// The end of the line of a label that is farther from its cells.
fn tip(text: &BrailleText) -> Option<MmPoint> {
    let cells = around(text.dots.at.iter().copied())?;
    let points = &text.leader.as_ref()?.points;
    let far = |at: &MmPoint| distance_to_box(*at, cells);
    [*points.first()?, *points.last()?].into_iter().max_by(|a, b| far(a).total_cmp(&far(b)))
}

/// Whether lines of a figure in this box lie around a point on all sides, as it may name the area in which it stands.
pub(crate) fn is_shut_in(at: MmPoint, lines: &[Line], place: MmRect) -> bool {
    let reach = place.width() + place.height();
    let runs = || lines.iter().flat_map(|line| &line.runs);
    let meets = |(from, to): (MmPoint, MmPoint)| {
        let along = |run: &Run| run.polyline().segments().any(|(a, b)| crossing((from, to), (*a, *b)).is_some());
        runs().any(along)
    };
    (0..DIRECTIONS).all(|k| {
        let (sin, cos) = (TAU * (k as f32 + 0.5) / DIRECTIONS as f32).sin_cos();
        meets((at, at + MmVector::new(cos, sin) * reach))
    })
}

#[cfg(test)]
mod tests;
