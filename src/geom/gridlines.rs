//! Which lines are those of a grid, as behind the bars of a chart or on squared paper: level or upright ones at even
//! distances that end together.

use lyon::geom::euclid::{Box2D, Point2D};

use super::nearest_on_segment;
use super::polyline::{Located, PolylineRef};
use crate::units::{Mm, MmPoint, MmVector, Px};

/// So many lines of one direction are a grid.
const LEAST: usize = 3;
/// A unit in which gridlines are looked for.
pub trait GridUnit {
    /// How far from level or upright they are, and how far pieces of one of them lie from its place.
    const OFF: f32;
}

/// On the sheet: numbers of a page are rounded, and lines keep apart.
impl GridUnit for Mm {
    const OFF: f32 = 0.5;
}

/// In a picture: a stroke is found to a fraction of a pixel.
impl GridUnit for Px {
    const OFF: f32 = 0.5;
}

/// Least straightness of one, chord to length: drawn by hand, too.
const STRAIGHTNESS: f32 = 0.99;
/// How far they lie from even distances, as a share of these: lines keep apart, and on a grid of dots they lie up to
/// half a step beside their places.
const UNEVEN: f32 = 0.25;
/// Ends count as together within this share of the longest line's length: bars hide the ends of some.
const APART: f32 = 0.1;
/// Share of them that end together on one side.
const TOGETHER: f32 = 0.6;

/// A piece is short beside the others if it is shorter than this share of the longest.
const SHORT: f32 = 0.25;

/// A level or upright piece: where it is across, and from where to where along.
#[derive(Debug, Clone, Copy)]
struct Piece {
    at: f32,
    from: f32,
    to: f32,
}

/// The two ends of a line, if it is open and straight enough for one of a grid.
pub fn straight_ends<V: Located>(line: PolylineRef<'_, V>) -> Option<[Point2D<f32, V::Unit>; 2]> {
    let is_straight = !line.closed && line.chord() >= STRAIGHTNESS * line.length();
    let (first, last) = line.vertices.first().zip(line.vertices.last()).filter(|_| is_straight)?;
    Some([first.at(), last.at()])
}

/// Which of some lines are those of a grid; of each that may be one, the two ends. Pieces that are short beside the
/// others are asked last: they are of the grid if they lie where it has or could have a line, and hinder none.
pub fn which_are_gridlines<U: GridUnit>(ends: &[Option<[Point2D<f32, U>; 2]>]) -> Vec<bool> {
    let mut found = vec![false; ends.len()];
    for is_level in [true, false] {
        let piece = |[a, b]: [Point2D<f32, U>; 2]| {
            let [a, b] = [a, b].map(|at| if is_level { (at.x, at.y) } else { (at.y, at.x) });
            let piece = Piece { at: 0.5 * (a.1 + b.1), from: a.0.min(b.0), to: a.0.max(b.0) };
            ((a.1 - b.1).abs() <= U::OFF).then_some(piece)
        };
        let pieces: Vec<Option<Piece>> = ends.iter().map(|ends| ends.and_then(piece)).collect();
        let all = || pieces.iter().flatten().copied();
        if grid_step(all().collect(), U::OFF).is_some() {
            found.iter_mut().zip(&pieces).for_each(|(found, piece)| *found |= piece.is_some());
            continue;
        }
        let longest = all().map(|piece| piece.to - piece.from).fold(0.0, f32::max);
        let long: Vec<Piece> = all().filter(|piece| piece.to - piece.from >= SHORT * longest).collect();
        if let Some(step) = grid_step(long.clone(), U::OFF) {
            // pieces of one line are at one place
            let mut places: Vec<f32> = long.iter().map(|line| line.at).collect();
            places.sort_by(f32::total_cmp);
            places.dedup_by(|next, place| *next - *place <= U::OFF);
            let is_in_place = |piece: &Piece| {
                places.iter().any(|place| {
                    let steps = (place - piece.at).abs() / step;
                    (steps - steps.round()).abs() * step <= U::OFF
                })
            };
            found.iter_mut().zip(&pieces).for_each(|(found, piece)| *found |= piece.as_ref().is_some_and(is_in_place));
        }
    }
    found
}

/// The least distance between lines if pieces of one direction are a grid; those of one line lie no farther than `off`
/// from its place.
fn grid_step(mut pieces: Vec<Piece>, off: f32) -> Option<f32> {
    pieces.sort_by(|a, b| a.at.total_cmp(&b.at));
    let lines: Vec<Piece> = pieces
        .chunk_by(|a, b| b.at - a.at <= off)
        .map(|of| {
            let (from, to) = of.iter().fold((f32::MAX, f32::MIN), |(from, to), of| (from.min(of.from), to.max(of.to)));
            Piece { at: of[0].at, from, to }
        })
        .collect();
    let distances: Vec<f32> = lines.windows(2).map(|pair| pair[1].at - pair[0].at).collect();
    let step = distances.iter().copied().fold(f32::MAX, f32::min);
    // one may be missing between two, as where the top of a bar is
    let is_even = distances.iter().all(|distance| (distance / step - (distance / step).round()).abs() <= UNEVEN);
    let longest = lines.iter().map(|line| line.to - line.from).fold(0.0, f32::max);
    let end_together = |ends: Vec<f32>| {
        let near = |at: f32| ends.iter().filter(|end| (**end - at).abs() <= APART * longest).count();
        ends.iter().any(|end| near(*end) as f32 >= TOGETHER * ends.len() as f32)
    };
    let is_grid = lines.len() >= LEAST
        && is_even
        && (end_together(lines.iter().map(|line| line.from).collect())
            || end_together(lines.iter().map(|line| line.to).collect()));
    is_grid.then_some(step)
}

/// Treads end on rails that are so near, mm: on a grid of dots lines end a step or so before one another.
const AT_RAIL: f32 = 3.0;
/// What is no larger lies on stairs as the head of an arrow does, mm.
const SMALL: f32 = 12.0;
/// Step in which lines between rails are looked for, mm.
const STEP: f32 = 1.0;

/// Takes those out of the gridlines among some lines that are treads of stairs, rungs of a ladder or boards of a fence:
/// both ends of each lie on other lines, and nothing lies on them that a grid would be behind, but one line across all,
/// such as the arrow that says which way is up. `lines` are the points of all lines, of as many as there are `found`.
pub fn without_treads(found: &mut [bool], ends: &[Option<[MmPoint; 2]>], lines: &[impl AsRef<[MmPoint]>]) {
    for is_level in [true, false] {
        let turned = |at: MmPoint| if is_level { at } else { MmPoint::new(at.y, at.x) };
        let is_member = |number: &usize| {
            let is_along = |[a, b]: [MmPoint; 2]| (turned(a).y - turned(b).y).abs() <= Mm::OFF;
            found[*number] && ends[*number].is_some_and(is_along)
        };
        let members: Vec<usize> = (0..found.len()).filter(is_member).collect();
        let treads: Vec<[MmPoint; 2]> = members.iter().filter_map(|&number| ends[number]).collect();
        if treads.is_empty() {
            continue;
        }
        let others: Vec<&[MmPoint]> =
            (0..lines.len()).filter(|number| !members.contains(number)).map(|number| lines[number].as_ref()).collect();
        let sides = || others.iter().flat_map(|line| line.windows(2));
        let is_on_rail = |end: &MmPoint| sides().any(|side| nearest_on_segment(*end, side[0], side[1]).0 <= AT_RAIL);
        if !treads.iter().flatten().all(is_on_rail) {
            continue;
        }
        let all = Box2D::from_points(treads.iter().flatten().map(|end| turned(*end)));
        // short of the rails
        let between =
            Box2D::new(all.min + MmVector::new(2.0 * AT_RAIL, 0.0), all.max - MmVector::new(2.0 * AT_RAIL, 0.0));
        let lies_on = |line: &&&[MmPoint]| {
            line.windows(2).any(|side| {
                let steps = ((side[1] - side[0]).length() / STEP).ceil().max(1.0);
                (0..=steps as u32).any(|step| {
                    let at = turned(side[0].lerp(side[1], step as f32 / steps));
                    (between.min.x..=between.max.x).contains(&at.x)
                        && at.y > all.min.y + Mm::OFF
                        && at.y < all.max.y - Mm::OFF
                })
            })
        };
        let on_them = others.iter().filter(lies_on).map(|line| Box2D::from_points(line.iter().map(|at| turned(*at))));
        let large: Vec<Box2D<f32, _>> = on_them.filter(|of| of.width().max(of.height()) > SMALL).collect();
        // across, and straight
        let is_arrow = |of: &Box2D<f32, _>| of.width() <= Mm::OFF;
        if large.len() <= 1 && large.iter().all(is_arrow) {
            members.into_iter().for_each(|number| found[number] = false);
        }
    }
}

#[cfg(test)]
mod tests;
