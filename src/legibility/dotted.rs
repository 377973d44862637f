//! Lines of dots that come too near to one another: counted in empty dots between them.

use super::finding::around;
use super::gaps::{Near, too_near_joined};
use crate::devices::{DotArea, Grid};
use crate::geom::nearby::Index;
use crate::page::{DotMedium, Line};
use crate::units::{Mm, MmPoint, MmRect};

/// A line that meets another may be near it on so many dots beside its end, in gaps and dots.
const APPROACH: (u32, u32) = (2, 4);

/// Where dots can be anywhere, one that falls on a dot of another line is left out: a line that ends on another ends so
/// much before it, in pitches.
const TOUCH: f32 = 1.75;
/// A line that another crosses has a hole there: a step longer than this, in pitches, is one.
const BROKEN: f32 = 1.5;

/// A dot of a line.
#[derive(Debug, Clone, Copy)]
struct Dot {
    /// Its column and row, as a point.
    cell: MmPoint,
    at: MmPoint,
    line: u32,
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
            let (near, are_all) = too_near_joined(lines, least, touch, BROKEN * medium.pitch);
            let empty =
                |near: Near| Near { gap: ((near.gap + medium.diameter()) / medium.pitch - 1.0).max(0.0), ..near };
            (near.into_iter().map(empty).collect(), are_all)
        }
    }
}

fn on_grid(lines: &[Line], gap: u32, grid: &Grid, pitch: f32) -> Vec<Near> {
    let dot = |at: MmPoint, line: u32| Dot { cell: cell(grid, at), at, line };
    let dots: Vec<Dot> = (0..)
        .zip(lines)
        .flat_map(|(line, of)| of.runs.iter().flat_map(move |run| run.points.iter().map(move |&at| dot(at, line))))
        .collect();
    let area = around(dots.iter().map(|dot| dot.cell)).unwrap_or_else(MmRect::zero);
    let reach = gap as f32 + 0.5;
    let mut index: Index<Dot, Mm> = Index::new(area, reach);
    dots.iter().for_each(|dot| index.put_at(dot.cell, *dot));
    let steps = |a: MmPoint, b: MmPoint| (a.x - b.x).abs().max((a.y - b.y).abs()).round() as u32;
    let tips = |line: u32| {
        let run = lines[line as usize].runs.first();
        run.into_iter().flat_map(|run| [run.points.first(), run.points.last()]).flatten().map(|&at| cell(grid, at))
    };
    // an end of `line` that meets `other`, near to a place
    let arrives = |line: u32, other: u32, at: MmPoint| {
        let meets = |tip: MmPoint| {
            let mut meets = false;
            index.around(tip, tip, reach, |dot| meets |= dot.line == other && steps(tip, dot.cell) <= gap);
            meets
        };
        tips(line).any(|tip| steps(tip, at) <= APPROACH.0 * gap + APPROACH.1 && meets(tip))
    };
    let mut found: Vec<Near> = Vec::new();
    for dot in &dots {
        let mut nearest: Option<(u32, Dot)> = None;
        index.around(dot.cell, dot.cell, reach, |other| {
            let apart = steps(dot.cell, other.cell);
            let nearer = nearest.is_none_or(|(least, of)| (apart, of.line) < (least, other.line));
            if other.line < dot.line && apart <= gap && nearer {
                nearest = Some((apart, *other));
            }
        });
        let Some((apart, other)) = nearest else { continue };
        if arrives(dot.line, other.line, dot.cell) || arrives(other.line, dot.line, dot.cell) {
            continue;
        }
        let lines = (dot.line as usize, other.line as usize);
        let near = Near {
            lines,
            gap: apart.saturating_sub(1) as f32,
            at: dot.at,
            length: pitch,
            extent: around([dot.at, other.at]).unwrap_or_else(MmRect::zero),
        };
        match found.iter_mut().rev().find(|of| of.lines == lines) {
            Some(of) => {
                of.length += pitch;
                of.extent = of.extent.union(&near.extent);
                if near.gap < of.gap {
                    (of.gap, of.at) = (near.gap, near.at);
                }
            }
            None => found.push(near),
        }
    }
    found
}
