//! Strokes of a vector drawing that are much thinner and paler than its others, such as the grid behind a curve. How a
//! stroke is painted says how much it matters. The outline of an area is none of them, however thin: the area is seen.
//! Nor is a dark closed one: it is a thing, as furniture beside the thick walls of a floor plan.

use super::edgel::Edgel;
use crate::geom::gridlines::{straight_ends, which_are_gridlines};
use crate::geom::polyline::PolylineRef;
use crate::units::PxPoint;

/// A stroke is faint if its width times its contrast is at most this share of that of the drawing's strong ones: one of
/// a third of their width and three quarters of their contrast, but not a black hairline beside lines of three pixels.
const FAINT: f32 = 0.25;
/// The contrast of black on white. Colours may reach more than twice as much, and are no stronger for that: an axis of
/// two black pixels is not faint beside a curve of four coloured ones.
pub(super) const BLACK: f32 = 100.0;
/// The strong ones are this share of all strokes by length, of which a grid counts as one line: the curve of a chart is
/// short beside its grid.
pub(super) const STRONG: f32 = 0.1;
/// Strokes are of one width if they differ by less than this, px: drawings give it exactly.
pub(super) const ONE_WIDTH: f32 = 0.01;
/// A line of a grid that lies under another stroke for most of its length is as pale as the grid at this share of its
/// places at least; less is where another line hides a black one. Chosen by us.
const PALEST: f32 = 0.25;
/// A stroke that is on the border of an area at this share of its places is an outline. Chosen by us.
const OUTLINE: f32 = 0.5;
/// A closed stroke of at least this contrast is a thing: the rings of a polar grid are paler. Chosen by us.
const DARK: f32 = 0.5 * BLACK;
/// What the place of a line among pixels makes of its contrast: on the border of two it is seen in both. Chosen by us.
pub(super) const SEEN: f32 = 1.5;

/// A stroke among others.
pub(super) struct WeighedStroke {
    /// Its width, px, and that times its contrast.
    width: f32,
    weight: f32,
    /// Its width times its contrast where it is palest.
    palest: f32,
    /// At which share of its places it is on the border of an area.
    on_borders: f32,
    /// Whether it is closed and dark.
    is_thing: bool,
    length: f32,
    /// Where a straight one begins and ends.
    ends: Option<[PxPoint; 2]>,
}

impl WeighedStroke {
    pub(super) fn of(width: f32, on_borders: f32, line: PolylineRef<'_, Edgel>) -> Self {
        let [weight, palest] = [0.5, PALEST].map(|share| width * contrast(line, share).min(BLACK));
        let is_thing = line.closed && weight >= DARK * width;
        Self { width, weight, palest, on_borders, is_thing, length: line.length(), ends: straight_ends(line) }
    }
}

/// The lines of a grid, which are of one width.
#[derive(Debug, Clone, Copy)]
struct Grid {
    width: f32,
    weight: f32,
    /// Of all its lines together, px.
    length: f32,
}

/// Which strokes of a vector drawing are faint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FaintStrokes {
    /// The weight of the strong ones; 0 if no stroke is.
    strong: f32,
    /// The longest grid.
    grid: Option<Grid>,
}

impl FaintStrokes {
    /// Among these strokes.
    pub(super) fn among(mut all: Vec<&mut WeighedStroke>) -> Self {
        all.sort_by(|a, b| a.width.total_cmp(&b.width));
        let mut grid: Option<Grid> = None;
        for of_width in all.chunk_by_mut(|a, b| b.width - a.width < ONE_WIDTH) {
            of_width.sort_by(|a, b| a.weight.total_cmp(&b.weight));
            let grids = of_width.chunk_by_mut(|a, b| b.weight <= SEEN * a.weight).filter_map(grid_counted_once);
            grid = grids.chain(grid).max_by(|a, b| a.length.total_cmp(&b.length));
        }
        all.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        let whole: f32 = all.iter().map(|stroke| stroke.length).sum();
        let mut sum = 0.0;
        let strong = all.iter().find(|stroke| {
            sum += stroke.length;
            sum >= STRONG * whole
        });
        Self { strong: strong.map_or(0.0, |stroke| stroke.weight), grid }
    }

    /// Whether a stroke is one of them.
    pub(super) fn holds(self, stroke: &WeighedStroke) -> bool {
        let is_of = |grid: &Grid| {
            (grid.width - stroke.width).abs() < ONE_WIDTH
                && stroke.ends.is_some()
                && stroke.palest <= SEEN * grid.weight
                && stroke.on_borders <= 1.0 - PALEST
        };
        let weight = match self.grid.filter(is_of) {
            Some(grid) => grid.weight,
            None if stroke.on_borders < OUTLINE && !stroke.is_thing => stroke.weight,
            None => return false,
        };
        weight <= FAINT * self.strong
    }
}

/// The contrast of a stroke: that at this share of its places is less. Where it lies on the border of an area it is
/// seen with the step of that.
fn contrast(line: PolylineRef<'_, Edgel>, share: f32) -> f32 {
    let mut strengths: Vec<f32> = line.vertices.iter().map(|edgel| edgel.strength).collect();
    let place = (strengths.len() as f32 * share) as usize;
    if strengths.is_empty() {
        return 0.0;
    }
    *strengths.select_nth_unstable_by(place, f32::total_cmp).1
}

/// The grid among strokes of one width and about one weight, of which only the longest line then has a length.
fn grid_counted_once(strokes: &mut [&mut WeighedStroke]) -> Option<Grid> {
    let ends: Vec<Option<[PxPoint; 2]>> = strokes.iter().map(|stroke| stroke.ends).collect();
    let are_gridlines = which_are_gridlines(&ends);
    let mut of_grid: Vec<&mut &mut WeighedStroke> =
        strokes.iter_mut().zip(are_gridlines).filter(|(_, is)| *is).map(|(stroke, _)| stroke).collect();
    of_grid.sort_by(|a, b| a.weight.total_cmp(&b.weight));
    let middle = of_grid.get(of_grid.len() / 2)?;
    let length = of_grid.iter().map(|stroke| stroke.length).sum();
    let grid = Grid { width: middle.width, weight: middle.weight, length };
    of_grid.sort_by(|a, b| b.length.total_cmp(&a.length));
    of_grid.iter_mut().skip(1).for_each(|stroke| stroke.length = 0.0);
    Some(grid)
}

#[cfg(test)]
mod tests;
