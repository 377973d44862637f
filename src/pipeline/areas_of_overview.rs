//! Which of the areas that the lines of a drawing enclose in the figure are areas in the overview too: a bar, a sector
//! or a field of a map may be one with its neighbour there, or open, though hardly any line is missing.

use std::collections::BTreeMap;

use super::overview::DrawnOverview;
use crate::edges::Edges;
use crate::geom::components::{Components, Connectivity, of_labels};
use crate::geom::distance::squared_distances;
use crate::geom::nearest_on_segment;
use crate::lines::{Line, Pen, which_are_weak};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, Size};
use crate::{About, Note, Reason};

/// Side of the cells in which areas are compared, mm in the overview: half a line's width.
const CELL: f32 = 0.5;
/// An area counts if a circle of this radius, mm, has room in it in the figure: half of what a fingertip needs to feel
/// two lines as two.
const ROOM: f32 = 1.5;
/// So much more than its half width a line closes, in cells, where it ends on another and what rounding takes off.
const CLOSES: f32 = 0.75;
/// The same of lines of dots, in pitches: a row that ends on another ends a dot before it.
const CLOSES_DOTS: f32 = 0.6;
/// An area of the overview stands for one of the figure of which it has at least this share, but for what is under
/// lines.
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
    let (place, lines) = overview.marks.as_ref().filter(|_| edges.of_drawing())?;
    let told = overview.lost.rings.max(overview.lost.gaps.len());
    let weak = which_are_weak(figure, plan.lines().least_strength);
    let strong = figure.iter().zip(weak).filter(|(_, is_weak)| !is_weak).map(|(line, _)| line);
    let cells = Cells::of(*place);
    let pitch = layout.medium.pitch();
    let of_figure = cells.areas(strong, layout.figure, pitch);
    let of_overview = cells.areas(lines.iter(), *place, pitch);
    let enclosed: Vec<&[usize]> = of_figure.enclosed(ROOM / cells.side_in(layout.figure)).collect();
    let missing: Vec<&[usize]> = of_figure.missing(&of_overview, &enclosed);
    let first = missing.first().map(|area| cells.middle(area[area.len() / 2], layout.figure))?;
    let (it, is) = match (enclosed.len(), missing.len()) {
        (1, _) => ("the area that lines enclose in the figure".to_owned(), "is"),
        (all, 1) => (format!("1 of the {all} areas that lines enclose in the figure"), "is"),
        (all, count) => (format!("{count} of the {all} areas that lines enclose in the figure"), "are"),
    };
    let at = format!("around {:.0}, {:.0} mm", first.x, first.y);
    let what = format!("{it} {is} open in the overview, or one with another ({at}), for want of room");
    (missing.len() > told).then_some(Note::TakenAs(About::Overview, Reason::AreaNotInOverview, what))
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
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let mut is_line = vec![false; width * height];
        for run in lines.flat_map(|line| &line.runs) {
            let is_stroke = run.pen == Pen::Stroke;
            let half = if is_stroke { 0.5 * run.width + CLOSES * side } else { CLOSES_DOTS * pitch };
            let reach = half / side;
            let to_cells = |at: MmPoint| ((at - part.min) / side).to_point();
            let path: Vec<MmPoint> = run.path().collect();
            let single = path.first().map(|&only| [only, only]).filter(|_| path.len() == 1);
            for [a, b] in path.windows(2).map(|pair| [pair[0], pair[1]]).chain(single) {
                // a row of dots is interrupted where a point is hollow
                if !is_stroke && (b - a).length() > 2.0 * pitch {
                    continue;
                }
                let (a, b) = (to_cells(a), to_cells(b));
                let columns = (a.x.min(b.x) - reach).floor().max(0.0) as usize
                    ..((a.x.max(b.x) + reach).ceil().max(0.0) as usize).min(width);
                let rows = (a.y.min(b.y) - reach).floor().max(0.0) as usize
                    ..((a.y.max(b.y) + reach).ceil().max(0.0) as usize).min(height);
                for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
                    let middle = MmPoint::new(x as f32 + 0.5, y as f32 + 0.5);
                    is_line[y * width + x] |= nearest_on_segment(middle, a, b).0 <= reach;
                }
            }
        }
        Areas { parts: of_labels(&is_line, self.size, Connectivity::Four), is_line, size: self.size }
    }
}

impl Areas {
    /// The enclosed areas in which a circle of this radius, in cells, has room.
    fn enclosed(&self, room: f32) -> impl Iterator<Item = &[usize]> {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let to_line = squared_distances(&self.is_line, self.size);
        let is_edge = move |cell: &usize| {
            let (x, y) = (cell % width, cell / width);
            x == 0 || y == 0 || x + 1 == width || y + 1 == height
        };
        let is_enclosed = move |cells: &&[usize]| {
            !self.is_line[cells[0]]
                && !cells.iter().any(is_edge)
                && cells.iter().any(|cell| to_line[*cell] as f32 >= room * room)
        };
        self.parts.iter().filter(is_enclosed)
    }

    /// Those of these areas for which there is none of their own among `others`: each of these stands for the one of
    /// which it has most.
    fn missing<'a>(&self, others: &Self, areas: &[&'a [usize]]) -> Vec<&'a [usize]> {
        let mut shared = BTreeMap::<(usize, usize), usize>::new();
        let both = |cell: &usize| !self.is_line[*cell] && !others.is_line[*cell];
        for cell in (0..self.is_line.len()).filter(both) {
            *shared.entry((self.parts.of(cell), others.parts.of(cell))).or_default() += 1;
        }
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
