//! Lines of dots that come too near to one another: counted in empty dots between them.

use std::collections::HashMap;

use super::finding::around;
use super::gaps::{Near, ONE, all_too_near_of_dots};
use super::limits::NEXT_DOT;
use crate::devices::{DotArea, Grid};
use crate::geom::nearby::Index;
use crate::page::{DotMedium, Line};
use crate::units::{Mm, MmPoint, MmRect};

/// Most dots beside its end on which a line that meets another may be near it, with a gap of so many dots
/// (`profile/plan` ties it to how lines are drawn).
pub(crate) const fn longest_approach(gap: u32) -> u32 {
    2 * gap + 4
}

/// From how many dots along a row on it comes back to itself: at a right angle both arms are near each other for so
/// long (`profile/plan` ties it, too).
pub(crate) const fn least_arc(gap: u32) -> u32 {
    4 * gap + 4
}

/// What is looked at beyond a gap, in dots.
const REACH: f32 = 0.5;

/// Where dots can be anywhere, one that falls on a dot of another line is left out: a line that ends on another ends so
/// much before it, in pitches.
const TOUCH: f32 = 1.75;

/// A dot of a line.
#[derive(Debug, Clone, Copy)]
struct Dot {
    /// Its column and row, as a point.
    cell: MmPoint,
    at: MmPoint,
    line: u32,
    /// Its place in the first row of its line; none beside that.
    along: Option<u32>,
}

/// Steps from dot to dot, diagonal ones included.
fn steps(a: MmPoint, b: MmPoint) -> u32 {
    (a.x - b.x).abs().max((a.y - b.y).abs()).round() as u32
}

/// Empty dots between two dots: on a grid those of a row, column or diagonal, elsewhere as many as there is room for.
pub(super) fn empty_between(a: MmPoint, b: MmPoint, medium: &DotMedium) -> f32 {
    match &medium.area {
        DotArea::Grid(grid) => {
            let (a, b) = (cell(grid, a), cell(grid, b));
            (a.x - b.x).abs().max((a.y - b.y).abs()) - 1.0
        }
        DotArea::Free(_) => (a - b).length() / medium.pitch - 1.0,
    }
}

/// The column and row of a dot as a point.
fn cell(grid: &Grid, at: MmPoint) -> MmPoint {
    grid.nearest(at).map_or(at, |[column, row]| MmPoint::new(column as f32, row as f32))
}

/// All places where lines of dots have fewer than `gap` empty dots between them; the blank of a place is in dots.
/// Also whether these are all.
pub(super) fn too_near(lines: &[Line], gap: u32, medium: &DotMedium) -> (Vec<Near>, bool) {
    match &medium.area {
        DotArea::Grid(grid) => (on_grid(lines, gap, grid, medium.pitch), true),
        DotArea::Free(_) => {
            // so many dots are empty, rounded
            let clearance = (gap as f32 + 0.5) * medium.pitch;
            let (least, touch) = (clearance - medium.diameter(), TOUCH * medium.pitch);
            let (near, are_all) = all_too_near_of_dots(lines, least, touch, NEXT_DOT * medium.pitch);
            let empty =
                |near: Near| Near { gap: ((near.gap + medium.diameter()) / medium.pitch - 1.0).max(0.0), ..near };
            (near.into_iter().map(empty).collect(), are_all)
        }
    }
}

fn on_grid(lines: &[Line], gap: u32, grid: &Grid, pitch: f32) -> Vec<Near> {
    let rows = Rows::of(lines, gap, grid);
    let mut found = Stretches::default();
    for dot in &rows.dots {
        let Some((apart, other)) = rows.nearest_before(dot) else { continue };
        if rows.arrives(dot, &other) || rows.arrives(&other, dot) {
            continue;
        }
        let near = Near {
            lines: (dot.line as usize, other.line as usize),
            gap: apart.saturating_sub(1) as f32,
            at: dot.at,
            length: pitch,
            extent: around([dot.at, other.at]).unwrap_or_else(MmRect::zero),
        };
        found.add(near, ONE + pitch);
    }
    found.all
}

/// Stretches where two lines are near, by their lines.
#[derive(Default)]
struct Stretches {
    all: Vec<Near>,
    of_lines: HashMap<(usize, usize), Vec<usize>>,
}

impl Stretches {
    /// Adds a place where two lines are near, to the last stretch that is no farther than `reach` from it if there is
    /// one.
    fn add(&mut self, near: Near, reach: f32) {
        let own = self.of_lines.entry(near.lines).or_default();
        let is_on_it = |of: &Near| of.extent.inflate(reach, reach).contains_inclusive(near.at);
        let Some(&on) = own.iter().rev().find(|of| is_on_it(&self.all[**of])) else {
            own.push(self.all.len());
            return self.all.push(near);
        };
        let of = &mut self.all[on];
        of.length += near.length;
        of.extent = of.extent.union(&near.extent);
        if near.gap < of.gap {
            (of.gap, of.at) = (near.gap, near.at);
        }
    }
}

/// The first row of a line.
struct Row {
    /// How many dots it has.
    count: u32,
    is_ring: bool,
    /// Its ends, and those where it is broken, as at a hollow point of another line.
    ends: Vec<Dot>,
    last: Option<Dot>,
}

/// The dots of lines on a grid, by their places.
struct Rows {
    gap: u32,
    dots: Vec<Dot>,
    index: Index<Dot, Mm>,
    rows: Vec<Row>,
}

impl Rows {
    fn of(lines: &[Line], gap: u32, grid: &Grid) -> Self {
        let dots_of = |(line, of): (u32, &Line)| {
            let runs =
                of.runs.iter().enumerate().flat_map(|(run, of)| of.points.iter().enumerate().map(move |at| (run, at)));
            let dot = |(run, (i, &at)): (usize, (usize, &MmPoint))| Dot {
                cell: cell(grid, at),
                at,
                line,
                along: (run == 0).then_some(i as u32),
            };
            runs.map(dot).collect::<Vec<Dot>>()
        };
        let dots: Vec<Dot> = (0..).zip(lines).flat_map(dots_of).collect();
        let area = around(dots.iter().map(|dot| dot.cell)).unwrap_or_else(MmRect::zero);
        let mut index: Index<Dot, Mm> = Index::new(area, gap as f32 + REACH);
        dots.iter().for_each(|dot| index.put_at(dot.cell, *dot));
        let mut rows: Vec<Row> = lines
            .iter()
            .map(|line| Row { count: 0, is_ring: line.is_ring_of_dots(), ends: Vec::new(), last: None })
            .collect();
        for dot in dots.iter().filter(|dot| dot.along.is_some()) {
            let Row { count, ends, last, .. } = &mut rows[dot.line as usize];
            *count += 1;
            match last.replace(*dot) {
                None => ends.push(*dot),
                Some(before) if steps(before.cell, dot.cell) > 1 => ends.extend([before, *dot]),
                Some(_) => {}
            }
        }
        rows.iter_mut().for_each(|row| row.ends.extend(row.last));
        Self { gap, dots, index, rows }
    }

    /// The nearest dot that is too near to a dot, and comes before it: one of a line before its own, or of its own row
    /// where that comes back to itself.
    fn nearest_before(&self, dot: &Dot) -> Option<(u32, Dot)> {
        let mut nearest: Option<(u32, Dot)> = None;
        self.index.around(dot.cell, dot.cell, self.gap as f32 + REACH, |other| {
            let apart = steps(dot.cell, other.cell);
            let nearer = nearest.is_none_or(|(least, of)| (apart, of.line) < (least, other.line));
            if apart <= self.gap && nearer && (other.line < dot.line || self.comes_back(other, dot)) {
                nearest = Some((apart, *other));
            }
        });
        nearest
    }

    /// Whether the second of two dots lies far beyond the first along the row of one line, both ways round if it is a
    /// ring.
    fn comes_back(&self, first: &Dot, second: &Dot) -> bool {
        let (Some(from), Some(to), true) = (first.along, second.along, first.line == second.line) else { return false };
        let Row { count, is_ring, .. } = self.rows[first.line as usize];
        let least = least_arc(self.gap);
        to > from + least && (!is_ring || count - (to - from) > least)
    }

    /// Whether an end of the line of a dot is near to it and meets the line of the other: of its own line, a part far
    /// along it.
    fn arrives(&self, dot: &Dot, other: &Dot) -> bool {
        let meets = |tip: &Dot| {
            let is_met = |near: &Dot| {
                let is_far = near.line != tip.line || self.comes_back(near, tip) || self.comes_back(tip, near);
                near.line == other.line && steps(tip.cell, near.cell) <= self.gap && is_far
            };
            let mut meets = false;
            self.index.around(tip.cell, tip.cell, self.gap as f32 + REACH, |near| meets |= is_met(near));
            meets
        };
        let mut ends = self.rows[dot.line as usize].ends.iter();
        ends.any(|tip| steps(tip.cell, dot.cell) <= longest_approach(self.gap) && meets(tip))
    }
}
