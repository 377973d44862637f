//! On dots the walls of a plan go before what stands beside them: a bed 4 mm from a wall gives way to it. As a closed
//! outline it is more salient than a short piece of a wall, of which it would take what lies beside it. On paper both
//! have room, moved apart. Of an edge in pixels no breadth is known.
//!
//! Walls are level and upright, and much broader than whatever is not:
//!
//! ```text
//!   ###############      # wall
//!   #   ,-----,   #      , - | bed
//!   #   |     |   #
//!   #   '-----'   #
//!   #########   ###
//! ```

use crate::geom::polyline::Polyline;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::vertex::{FoundIn, Vertex};
use crate::units::MmRect;

/// A wall is at least this broad, mm: thinner than what most people draw curves and outlines with, on any paper.
const BROAD: f32 = 0.8;
/// Walls inside a house may be thinner than those around it: they have at least this share of their breadth.
const OF_BROADEST: f32 = 0.5;
/// They are so many times as broad as any stroke that is neither level nor upright, and the broadest of them as some
/// other stroke: in a drawing all of whose strokes are as broad none is a wall.
const BROADER: f32 = 2.0;
/// Share of a wall's length that is level or upright, as the arc of a door may be one line with it, and share of which
/// a stroke that is no part of a building has less.
const MOSTLY: f32 = 0.75;
const HARDLY: f32 = 0.5;
/// What is level or upright is off that by no more than this sine: 11 degrees, as strokes in pixels sway.
const OFF: f32 = 0.2;
/// A wall of a bitmap that is shorter than so many least lengths has no rank of its own: on a grid of dots it loses the
/// dot that it shares with another wall, and is long enough only where the leaf of a door, drawn later, ends on it.
const SHORT: f32 = 1.5;
/// The level ones together are at least this share of the drawing's width long, and the upright ones of its height: the
/// bars of a chart lie one way. Chosen by us, as the numbers above.
const ALONG: f32 = 0.5;

/// A stroke, or a thin area that is drawn as its middle, mm.
struct Stroke {
    /// Which of the lines it is.
    number: usize,
    breadth: f32,
    length: f32,
    /// How much of it is level, and how much upright.
    level: f32,
    upright: f32,
}

impl Stroke {
    /// None of an edge, nor of what only counts as a broad stroke, as the outline of bars that touch.
    fn of(number: usize, line: &Polyline<Vertex>, params: &Params) -> Option<Self> {
        let breadth = line.breadth().filter(|breadth| *breadth <= params.max_spacing())?;
        let (mut length, mut level, mut upright) = (0.0, 0.0, 0.0);
        for (a, b) in line.segments() {
            let way = (b.at - a.at).abs();
            let step = way.length();
            length += step;
            level += if way.y <= OFF * step { step } else { 0.0 };
            upright += if way.x <= OFF * step { step } else { 0.0 };
        }
        Some(Self { number, breadth, length, level, upright })
    }

    /// Share of it that is level or upright.
    fn straight(&self) -> f32 {
        (self.level + self.upright) / self.length.max(f32::EPSILON)
    }
}

/// The numbers of those lines of a drawing that are the walls of a plan; none on paper.
pub(super) fn walls(lines: &[(Polyline<Vertex>, Rank)], params: &Params) -> Vec<usize> {
    if !params.on_dots() {
        return Vec::new();
    }
    let has_breadth = |vertex: &Vertex| vertex.source.is_exact() || vertex.source == FoundIn::Stroke;
    let is_stroke = |line: &Polyline<Vertex>| line.vertices.iter().all(has_breadth);
    let drawn = lines.iter().enumerate().filter(|(_, (line, rank))| *rank != Rank::Faint && is_stroke(line));
    let strokes: Vec<Stroke> = drawn.filter_map(|(number, (line, _))| Stroke::of(number, line, params)).collect();
    let is_straight = |stroke: &&Stroke| stroke.straight() >= MOSTLY;
    let is_slanted = |stroke: &&Stroke| stroke.straight() < HARDLY && stroke.length >= params.min_length;
    let of_straight = broadest(strokes.iter().filter(is_straight));
    let of_slanted = broadest(strokes.iter().filter(is_slanted));
    let least = BROAD.max(OF_BROADEST * of_straight).max(BROADER * of_slanted);
    let is_thin = |stroke: &Stroke| stroke.length >= params.min_length && BROADER * stroke.breadth <= of_straight;
    let walls: Vec<&Stroke> = strokes.iter().filter(is_straight).filter(|stroke| stroke.breadth >= least).collect();
    let extent = MmRect::from_points(lines.iter().flat_map(|(line, _)| line.path().map(|vertex| vertex.at)));
    let level: f32 = walls.iter().map(|wall| wall.level).sum();
    let upright: f32 = walls.iter().map(|wall| wall.upright).sum();
    let are_around = level >= ALONG * extent.width() && upright >= ALONG * extent.height();
    if !are_around || !strokes.iter().any(is_thin) {
        return Vec::new();
    }
    let is_exact = |wall: &Stroke| lines[wall.number].0.vertices.iter().all(|vertex| vertex.source.is_exact());
    let is_long = |wall: &&&Stroke| wall.length >= SHORT * params.min_length || is_exact(wall);
    walls.iter().filter(is_long).map(|wall| wall.number).collect()
}

fn broadest<'s>(strokes: impl Iterator<Item = &'s Stroke>) -> f32 {
    strokes.map(|stroke| stroke.breadth).fold(0.0, f32::max)
}

#[cfg(test)]
mod tests;
