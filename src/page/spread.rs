//! A picture that is spread over several sheets.
//!
//! ```text
//!  +------------------+ +------------------+     The picture with its frame is drawn once, in the space of all sheets
//!  | a1       |     \ | |  |  a2         \ |     together, and every sheet shows what is in its
//!  |  ::::::::::::::  | | :::::::::::::::  |     window. Windows overlap: both sheets show the same there.
//!  | -::  window     -| |-    window   :: -|
//!  |  ::          |   | |  |           ::  |     Ticks lie beside the windows in the middle of each
//!  +------------------+ +------------------+     overlap: sheets lie right when their ticks do.
//! ```

use std::str::FromStr;

use super::frame;
use super::parts::{Dots, Figure, Glyph, Line, Run, Texture};
use super::sheet::{self, FrameParams, MarkParams, Orientation, Params};
use crate::Error;
use crate::braille::{self, CellSize};
use crate::geom::polyline::PolylineRef;
use crate::units::{MmPoint, MmRect, MmVector, Size};

/// How many sheets there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Grid {
    across: u32,
    down: u32,
}

impl Grid {
    /// Most sheets across or down: the label of a row is a letter, that of a column a digit.
    pub const MOST: u32 = 9;

    /// `across` sheets by `down` sheets; none unless both are from 1 to [`Grid::MOST`] and there are at least two
    /// sheets.
    pub fn new(across: u32, down: u32) -> Option<Self> {
        let good = |count| (1..=Self::MOST).contains(&count);
        (good(across) && good(down) && across * down > 1).then_some(Self { across, down })
    }

    /// All grids, those of fewer sheets first; of as many sheets, the nearer to a square.
    pub fn by_number() -> impl Iterator<Item = Self> {
        let all = (1..=Self::MOST).flat_map(|across| (1..=Self::MOST).filter_map(move |down| Self::new(across, down)));
        let mut all: Vec<Self> = all.collect();
        all.sort_by_key(|grid| (grid.across * grid.down, grid.across.abs_diff(grid.down)));
        all.into_iter()
    }

    /// Every sheet as (column, row), row by row from the top left.
    pub fn sheets(self) -> impl Iterator<Item = (u32, u32)> {
        (0..self.down).flat_map(move |row| (0..self.across).map(move |column| (column, row)))
    }
}

impl FromStr for Grid {
    type Err = Error;

    /// # Errors
    /// [`Error::NotASheetGrid`] for a text that says no number of sheets.
    fn from_str(text: &str) -> Result<Self, Error> {
        let counts =
            text.split_once(['x', 'X']).and_then(|(a, b)| Some((a.trim().parse().ok()?, b.trim().parse().ok()?)));
        counts.and_then(|(across, down)| Self::new(across, down)).ok_or(Error::NotASheetGrid)
    }
}

impl std::fmt::Display for Grid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}", self.across, self.down)
    }
}

/// Length of a tick, mm. Chosen by us: a fingertip covers all of it, so that it is not followed as a line.
const TICK: f32 = 5.0;
/// Width of a tick, mm. Chosen by us: the width of most lines of a picture.
const TICK_WIDTH: f32 = 1.5;
/// Blank between ticks and the window, and between them and what lies above, mm: the 1/8 inch rule (L. Hasty), the
/// least between any two things.
const GAP: f32 = 3.2;
/// Width of the band of ticks on each side of a window, mm.
const BAND: f32 = TICK + GAP;

/// Where a picture lies on its sheets.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    grid: Grid,
    /// Width and height of every sheet as it lies.
    pub sheet: [f32; 2],
    /// The picture in the space of all sheets together.
    pub figure: MmRect,
    /// The orientation mark of every sheet.
    pub mark: Option<Run>,
    /// Size of a window.
    window: MmVector,
    /// The top left corner of a window on its sheet.
    corner: MmPoint,
    overlap: f32,
}

/// Lays out a picture whose width is `aspect` times its height over a grid of sheets, as large as they allow but not
/// wider than `widest`, in their middle. None where the sheets are too small.
pub fn fit(aspect: f32, widest: f32, grid: Grid, overlap: f32, params: &Params) -> Option<Spread> {
    let [a, b] = params.sheet;
    let (short, long) = (a.min(b), a.max(b));
    let upright = || fit_on([short, long], aspect, widest, grid, overlap, params);
    let across = || fit_on([long, short], aspect, widest, grid, overlap, params);
    match params.orientation {
        Orientation::Portrait => upright(),
        Orientation::Landscape => across(),
        Orientation::Auto => {
            let width = |spread: &Option<Spread>| spread.as_ref().map_or(0.0, |spread| spread.figure.width());
            let (upright, across) = (upright(), across());
            if width(&across) > width(&upright) { across } else { upright }
        }
    }
}

fn fit_on(sheet: [f32; 2], aspect: f32, widest: f32, grid: Grid, overlap: f32, params: &Params) -> Option<Spread> {
    let mark = |mark: MarkParams| (sheet::reach(mark), mark.gap.max(GAP));
    let (mark_height, gap) = params.mark.map_or((0.0, GAP), mark);
    let row = mark_height.max(CellSize::MARBURG.extent(1, braille::PRINTED).y);
    let corner = MmPoint::new(params.margin + BAND, params.margin + row + gap + BAND);
    let window = MmVector::new(sheet[0] - 2.0 * corner.x, sheet[1] - corner.y - params.margin - BAND);
    // In windows of at most two overlaps, three neighbouring sheets would show the same part.
    if window.x <= 2.0 * overlap || window.y <= 2.0 * overlap {
        return None;
    }
    let extent = |count: u32, window: f32| count as f32 * (window - overlap) + overlap;
    let total = MmVector::new(extent(grid.across, window.x), extent(grid.down, window.y));
    let border = params.frame.map_or(0.0, |frame| frame.width + frame.gap);
    let width = (total.x - 2.0 * border).min((total.y - 2.0 * border) * aspect).min(widest);
    if width <= 0.0 {
        return None;
    }
    let half = MmVector::new(0.5 * width, 0.5 * width / aspect);
    let middle = MmPoint::new(0.5 * total.x, 0.5 * total.y);
    let figure = MmRect::new(middle - half, middle + half);
    let mark = params.mark.map(|mark| sheet::bar(MmPoint::new(sheet[0] - params.margin, params.margin), mark));
    Some(Spread { grid, sheet, figure, mark, window, corner, overlap })
}

/// What one sheet shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Cut {
    /// The part of the figure in the window.
    pub figure: Figure,
    /// The part of its frame.
    pub frame: Dots,
    /// Ticks in the middle of each overlap.
    pub ticks: Vec<Run>,
    /// Which sheet it is, in braille: the row as a letter, the column as a number.
    pub label: Dots,
    /// The same in print: `a1`.
    pub name: String,
}

impl Spread {
    /// What every sheet shows of a figure, row by row. Sheets on which nothing of the picture lies are left out.
    pub fn cut(&self, figure: &Figure, params: Option<&FrameParams>, margin: f32) -> Vec<Cut> {
        let dots = params.map_or_else(Dots::default, |params| frame::printed(figure.place, params));
        let shown = self.grid.sheets().filter(|&(column, row)| self.shows(column, row, figure.place));
        shown.map(|(column, row)| self.cut_sheet(column, row, figure, &dots, margin)).collect()
    }

    /// Whether something of the picture lies on a sheet.
    fn shows(&self, column: u32, row: u32, picture: MmRect) -> bool {
        self.window(column, row).intersects(&picture)
    }

    /// A sheet's window in the space of all sheets.
    fn window(&self, column: u32, row: u32) -> MmRect {
        let step = |number: u32, side: f32| number as f32 * (side - self.overlap);
        let from = MmPoint::new(step(column, self.window.x), step(row, self.window.y));
        MmRect::new(from, from + self.window)
    }

    /// What the sheet at this column and row shows.
    fn cut_sheet(&self, column: u32, row: u32, figure: &Figure, frame: &Dots, margin: f32) -> Cut {
        let window = self.window(column, row);
        let onto_sheet = self.corner - window.min;
        let inside = |at: MmPoint, radius: f32| window.inflate(-radius, -radius).contains_inclusive(at);
        let place = window.intersection_unchecked(&figure.place);
        let share = |part: f32, whole: f32, pixels: u32| ((part / whole * pixels as f32).round() as u32).max(1);
        let source = Size::new(
            share(place.width(), figure.place.width(), figure.source.width),
            share(place.height(), figure.place.height(), figure.source.height),
        );
        let on_sheet = |glyph: &Glyph| Glyph { at: glyph.at + onto_sheet, ..*glyph };
        // Of the area of a region a sheet has as much as it has of its glyphs.
        let glyphs = |texture: &Texture| {
            let glyphs: Vec<Glyph> =
                texture.glyphs.iter().filter(|glyph| inside(glyph.at, glyph.radius())).map(on_sheet).collect();
            let share = glyphs.len() as f32 / texture.glyphs.len().max(1) as f32;
            let Texture { class, sign, colour, area, .. } = *texture;
            Texture { class, sign, colour, area: area * share, glyphs }
        };
        let mut lines: Vec<Line> = figure.lines.iter().flat_map(|line| cut_line(line, window)).collect();
        for at in lines.iter_mut().flat_map(|line| &mut line.runs).flat_map(|run| &mut run.points) {
            *at += onto_sheet;
        }
        let radius = 0.5 * frame.diameter;
        let at = frame.at.iter().filter(|&&at| inside(at, radius)).map(|&at| at + onto_sheet).collect();
        let label = [braille::letter(row as usize), braille::number(column as usize + 1)].concat();
        let from = MmVector::new(margin, margin);
        Cut {
            figure: Figure {
                place: MmRect::new(place.min + onto_sheet, place.max + onto_sheet),
                source,
                textures: figure.textures.iter().map(glyphs).filter(|texture| !texture.glyphs.is_empty()).collect(),
                lines,
            },
            frame: Dots { diameter: frame.diameter, at },
            ticks: self.ticks(column, row, figure.place),
            label: Dots {
                diameter: braille::PRINTED,
                at: CellSize::MARBURG.dots(&label, braille::PRINTED).into_iter().map(|at| at + from).collect(),
            },
            name: format!("{}{}", char::from(b'a' + row as u8), column + 1),
        }
    }

    /// The ticks of a sheet. Each lies at the same point of the picture as one of the neighbouring sheet.
    fn ticks(&self, column: u32, row: u32, picture: MmRect) -> Vec<Run> {
        let (near, far) = (self.corner, self.corner + self.window);
        let half = 0.5 * self.overlap;
        let mut ticks = Vec::new();
        // The two ends of a tick outside one side of the window, at `edge`; `out` is -1 or 1.
        let reach = |edge: f32, out: f32| [edge + out * GAP, edge + out * (GAP + TICK)];
        let mut tick = |a: MmPoint, b: MmPoint| ticks.push(Run::stroke(TICK_WIDTH, vec![a, b]));
        let left = column > 0 && self.shows(column - 1, row, picture);
        let right = column + 1 < self.grid.across && self.shows(column + 1, row, picture);
        for (there, x) in [(left, near.x + half), (right, far.x - half)] {
            for [a, b] in [reach(near.y, -1.0), reach(far.y, 1.0)] {
                if there {
                    tick(MmPoint::new(x, a), MmPoint::new(x, b));
                }
            }
        }
        let above = row > 0 && self.shows(column, row - 1, picture);
        let below = row + 1 < self.grid.down && self.shows(column, row + 1, picture);
        for (there, y) in [(above, near.y + half), (below, far.y - half)] {
            for [a, b] in [reach(near.x, -1.0), reach(far.x, 1.0)] {
                if there {
                    tick(MmPoint::new(a, y), MmPoint::new(b, y));
                }
            }
        }
        // round ends reach further by half a width
        for run in &mut ticks {
            let (a, b) = (run.points[0], run.points[1]);
            let inwards = (b - a).normalize() * (0.5 * TICK_WIDTH);
            run.points = vec![a + inwards, b - inwards];
        }
        ticks
    }
}

/// The pieces of a line whose ink lies in a window. Pieces shorter than their width are left out: they would be blots
/// at the edge, and the neighbouring sheet shows that part as a line.
fn cut_line(line: &Line, window: MmRect) -> Vec<Line> {
    let mut pieces: Vec<Line> = Vec::new();
    for run in &line.runs {
        let half = 0.5 * run.width;
        for path in cut_polyline(run.polyline(), window.inflate(-half, -half)) {
            let piece = Run { pen: run.pen, ..Run::stroke(run.width, path) };
            let joins = |last: &Line| last.runs.last().and_then(|run| run.points.last()) == piece.points.first();
            match pieces.last_mut() {
                Some(last) if joins(last) => last.runs.push(piece),
                _ => pieces.push(Line { strength: line.strength, runs: vec![piece] }),
            }
        }
    }
    let length = |line: &Line| -> f32 {
        let segments = line.runs.iter().flat_map(|run| run.polyline().segments());
        segments.map(|(a, b)| (*b - *a).length()).sum()
    };
    pieces.retain(|piece| length(piece) >= piece.runs.iter().map(|run| run.width).fold(0.0, f32::max));
    pieces
}

/// The parts of a polyline in a rectangle, as paths. The path of a ring that lies within ends where it begins.
fn cut_polyline(polyline: PolylineRef<'_, MmPoint>, rect: MmRect) -> Vec<Vec<MmPoint>> {
    let mut pieces: Vec<Vec<MmPoint>> = Vec::new();
    for (a, b) in polyline.segments() {
        let Some((a, b)) = cut_segment(*a, *b, rect) else { continue };
        match pieces.last_mut() {
            Some(last) if last.last() == Some(&a) => last.push(b),
            _ => pieces.push(vec![a, b]),
        }
    }
    pieces
}

/// The part of a segment in a rectangle (Liang and Barsky, 1984); an end that lies within stays as it is, to the last
/// bit.
fn cut_segment(a: MmPoint, b: MmPoint, rect: MmRect) -> Option<(MmPoint, MmPoint)> {
    let d = b - a;
    let (mut from, mut to) = (0.0_f32, 1.0_f32);
    // for each side of the rectangle: the segment's component towards it, and the distance from `a` to it
    let sides = [(-d.x, a.x - rect.min.x), (d.x, rect.max.x - a.x), (-d.y, a.y - rect.min.y), (d.y, rect.max.y - a.y)];
    for (towards, distance) in sides {
        if towards < 0.0 {
            from = from.max(distance / towards);
        } else if towards > 0.0 {
            to = to.min(distance / towards);
        } else if distance < 0.0 {
            return None;
        }
    }
    let at = |share: f32| {
        if share <= 0.0 {
            a
        } else if share >= 1.0 {
            b
        } else {
            a + d * share
        }
    };
    (from < to).then(|| (at(from), at(to)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect() -> MmRect {
        MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(10.0, 10.0))
    }

    #[test]
    fn a_line_is_cut_into_what_lies_in_the_window() {
        let at = |x, y| MmPoint::new(x, y);
        let zigzag = [at(-5.0, 5.0), at(5.0, 5.0), at(15.0, 5.0), at(15.0, 8.0), at(5.0, 8.0)];
        let cut = |vertices: &[MmPoint], closed| cut_polyline(PolylineRef { vertices, closed }, rect());
        let pieces = cut(&zigzag, false);
        assert_eq!(pieces, [vec![at(0.0, 5.0), at(5.0, 5.0), at(10.0, 5.0)], vec![at(10.0, 8.0), at(5.0, 8.0)]]);
        assert!(cut(&[at(-1.0, 11.0), at(12.0, 10.5)], false).is_empty());
        let ring = [at(2.0, 2.0), at(8.0, 2.0), at(8.0, 8.0)];
        assert_eq!(cut(&ring, true), [vec![ring[0], ring[1], ring[2], ring[0]]], "what lies within stays as it is");
    }

    #[test]
    fn grids_are_read_and_written() {
        for text in ["2x2", "1x9", "3X1", " 2 x 4 "] {
            let grid: Grid = text.parse().expect(text);
            assert_eq!(grid.to_string(), text.replace(' ', "").to_lowercase());
        }
        for text in ["1x1", "0x3", "10x2", "2", "x", "2x", "2x2x2", "-1x2"] {
            assert_eq!(text.parse::<Grid>(), Err(Error::NotASheetGrid), "{text}");
        }
    }
}
