//! Which of the areas that the lines of a drawing enclose in the figure are areas in the overview too: a bar, a sector
//! or a field of a map may run into its neighbour there, or be open, though hardly any line is missing.

use std::collections::BTreeMap;

use super::overview::{DrawnOverview, Rings};
use super::told_bars::Bars;
use crate::edges::Edges;
use crate::geom::cells::{COVERS, set_along};
use crate::geom::components::{Components, Connectivity, of_labels};
use crate::geom::distance::squared_distances;
use crate::lines::{Line, Pen, which_are_weak};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, Size};
use crate::{About, Note, Reason};

/// Side of the cells in which areas are compared, mm in the overview: half a line's width.
const CELL: f32 = 0.5;
/// An area counts if a circle of this radius, mm, has room in it in the figure, beyond what its lines close: a smaller
/// one is no place for a fingertip. Chosen by us.
const ROOM: f32 = 1.5;
/// How far the dots of a line close, in pitches: a row that ends on another ends a dot before it, and both reach half
/// way, and a little more.
const CLOSES_DOTS: f32 = 0.6;
/// Dots no farther apart than this, in pitches, follow one another: a diagonal step is 1.41. In the middle of a hollow
/// point two are farther apart.
const NEXT_DOT: f32 = 1.7;
/// An area of the overview stands for one of the figure of which it has at least this share, but for what is under
/// lines. Chosen by us: less is a part of it.
const STANDS: f32 = 0.5;

/// What the maker of a drawing's page is told of areas of the figure that are no areas in the overview, if they are
/// more than the closed shapes that are told to be missing there.
pub(super) fn told(
    edges: &Edges,
    figure: &[Line],
    overview: &DrawnOverview,
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    // bars that touch, or have one outline, are told as that
    let are_told = overview.instead.is_some_and(|style| matches!(style.bars, Bars::Touching | Bars::Outline));
    let (place, lines) = overview.marks.as_ref().filter(|_| edges.of_drawing() && !are_told)?;
    let open = if overview.rings == Rings::Whole { overview.lost.gaps.len() } else { 0 };
    let told = overview.lost.rings.max(open);
    let weak = which_are_weak(figure, plan.lines().least_strength);
    let strong = figure.iter().zip(weak).filter(|(_, is_weak)| !is_weak).map(|(line, _)| line);
    let cells = Cells::of(*place);
    let pitch = layout.medium.pitch();
    let of_figure = cells.areas(strong, layout.figure, pitch);
    let of_overview = cells.areas(lines.iter(), *place, pitch);
    let enclosed: Vec<&[usize]> = of_figure.enclosed(ROOM / cells.side_in(layout.figure)).collect();
    let missing: Vec<&[usize]> = of_figure.missing(&of_overview, &enclosed);
    let first = missing.first().map(|area| cells.middle(area[area.len() / 2], layout.figure))?;
    let (they, runs, at) = match (enclosed.len(), missing.len()) {
        (1, _) => ("the area that is closed in the figure is".to_owned(), "runs into another", "it is"),
        (all, 1) => (format!("1 of the {all} areas that are closed in the figure is"), "runs into another", "it is"),
        (all, count) => {
            (format!("{count} of the {all} areas that are closed in the figure are"), "run into others", "the first is")
        }
    };
    let at = format!("{at} around {} in the figure", layout.place_in_words(first));
    let what = format!("in the overview {they} open, or {runs}, as there is no room ({at})");
    (missing.len() > told).then_some(Note::TakenAs(About::Overview, Reason::AreaNotInOverview, what.into()))
}

/// The same cells over the figure and over the overview.
struct Cells {
    size: Size,
    of_overview: MmRect,
}

/// Cells that are blank, in connected parts, and those under lines.
struct Areas {
    parts: Components,
    is_line: Vec<bool>,
    size: Size,
}

impl Cells {
    fn of(overview: MmRect) -> Self {
        let count = |length: f32| (length / CELL).ceil().max(1.0) as u32;
        Self { size: Size::new(count(overview.width()), count(overview.height())), of_overview: overview }
    }

    /// Side of a cell in a part of the page, mm.
    fn side_in(&self, part: MmRect) -> f32 {
        CELL * part.width() / self.of_overview.width()
    }

    /// The middle of a cell in a part of the page.
    fn middle(&self, cell: usize, part: MmRect) -> MmPoint {
        let (width, side) = (self.size.width as usize, self.side_in(part));
        let at = |number: usize, from: f32| from + (number as f32 + 0.5) * side;
        MmPoint::new(at(cell % width, part.min.x), at(cell / width, part.min.y))
    }

    /// The areas between lines in a part of the page; dots lie so many mm apart.
    fn areas<'l>(&self, lines: impl Iterator<Item = &'l Line>, part: MmRect, pitch: f32) -> Areas {
        let side = self.side_in(part);
        let mut is_line = vec![false; self.size.len()];
        for run in lines.flat_map(|line| &line.runs) {
            let is_stroke = run.pen == Pen::Stroke;
            let half = if is_stroke { 0.5 * run.width + COVERS * side } else { CLOSES_DOTS * pitch };
            let reach = half / side;
            let to_cells = |at: MmPoint| ((at - part.min) / side).to_point();
            let mut path: Vec<MmPoint> = run.path().collect();
            if !is_stroke && let (Some(first), true) = (path.first().copied(), path.len() > 2) {
                // a ring of dots does not repeat its first one, and where its ends are far apart it is open
                path.push(first);
            }
            let single = path.first().map(|&only| [only, only]).filter(|_| path.len() == 1);
            for [a, b] in path.windows(2).map(|pair| [pair[0], pair[1]]).chain(single) {
                // a row of dots is interrupted where a point is hollow
                if !is_stroke && (b - a).length() > NEXT_DOT * pitch {
                    continue;
                }
                set_along(&mut is_line, self.size, [to_cells(a), to_cells(b)], reach);
            }
        }
        Areas { parts: of_labels(&is_line, self.size, Connectivity::Four), is_line, size: self.size }
    }
}

impl Areas {
    /// The enclosed areas in which a circle of this radius, in cells, has room.
    fn enclosed(&self, room: f32) -> impl Iterator<Item = &[usize]> {
        let to_line = squared_distances(&self.is_line, self.size);
        let has_room = move |cells: &&[usize]| cells.iter().any(|cell| to_line[*cell] as f32 >= room * room);
        self.parts.iter().filter(|cells| self.is_enclosed(cells)).filter(has_room)
    }

    /// Whether cells of one part are an area that lines enclose.
    fn is_enclosed(&self, cells: &[usize]) -> bool {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let is_edge = |cell: &usize| {
            let (x, y) = (cell % width, cell / width);
            x == 0 || y == 0 || x + 1 == width || y + 1 == height
        };
        !self.is_line[cells[0]] && !cells.iter().any(is_edge)
    }

    /// Those of these areas for which there is none of their own among `others`: each of these stands for the one of
    /// which it has most.
    fn missing<'a>(&self, others: &Self, areas: &[&'a [usize]]) -> Vec<&'a [usize]> {
        let mut shared = BTreeMap::<(usize, usize), usize>::new();
        let both = |cell: &usize| !self.is_line[*cell] && !others.is_line[*cell];
        for cell in (0..self.is_line.len()).filter(both) {
            *shared.entry((self.parts.of(cell), others.parts.of(cell))).or_default() += 1;
        }
        shared.retain(|(_, other), _| others.is_enclosed(&others.parts[*other]));
        // with which area of this page each of the others has most in common
        let mut stands_for = BTreeMap::<usize, (usize, usize)>::new();
        for (&(own, other), &count) in &shared {
            let most = stands_for.entry(other).or_insert((own, count));
            *most = if count > most.1 { (own, count) } else { *most };
        }
        let is_there = |cells: &[usize]| {
            let own = self.parts.of(cells[0]);
            let blank = cells.iter().filter(|cell| both(cell)).count();
            let mut of_own = shared.range((own, 0)..(own + 1, 0));
            let stands = |(&(_, other), &count): (&(usize, usize), &usize)| {
                stands_for.get(&other).is_some_and(|(of, _)| *of == own) && count as f32 >= STANDS * blank as f32
            };
            of_own.any(stands)
        };
        areas.iter().copied().filter(|cells| !is_there(cells)).collect()
    }
}

#[cfg(test)]
mod tests;
