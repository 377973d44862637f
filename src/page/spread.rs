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
//!
//! For a device of dots all sheets together have one large grid, of which every sheet has a part: windows are whole
//! dots apart, so that each dot of the picture is a dot of its sheet.

use super::cells::CellGrid;
use super::dot_spread;
use super::heading::Heading;
use super::medium::{Medium, MediumParams, Print};
use super::parts::{BrailleText, Dots, Figure, Glyph, Line, Pen, Run, Texture};
use super::sheet::{self, Layout, Orientation, Params, beside};
use super::sheet_windows::{SheetWindows, sheet_name};
use super::spread_layout::{GAP, SpreadPicture, TICK, above};
use crate::braille::{self, CellSize};
use crate::devices::DotArea;
use crate::geom::polyline::PolylineRef;
use crate::units::{MmPoint, MmRect, MmVector, Size};

pub use super::spread_layout::{LABEL_CELLS, SheetGrid, Spread};

/// Width of a tick, mm. Chosen by us: the width of most lines of a picture.
const TICK_WIDTH: f32 = 1.5;
/// Width of the band of ticks on each side of a window, mm.
const BAND: f32 = TICK + GAP;

/// Lays out a picture whose width is `aspect` times its height over a grid of sheets, as large as they allow but not
/// wider than `widest`, in their middle. None where the sheets are too small.
pub fn fit(aspect: f32, widest: f32, grid: SheetGrid, overlap: f32, params: &Params) -> Option<Spread> {
    let [a, b] = params.sheet;
    let (short, long) = (a.min(b), a.max(b));
    let on = |sheet: [f32; 2]| {
        let picture = SpreadPicture { aspect, widest, grid, overlap };
        match params.medium {
            MediumParams::Print(print) => fit_printed(sheet, picture, params, print),
            MediumParams::Dots { device, pitch } => dot_spread::fit(sheet, picture, params, (device, pitch)),
        }
    };
    let upright = || on([short, long]);
    let across = || on([long, short]);
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

fn fit_printed(sheet: [f32; 2], picture: SpreadPicture, params: &Params, print: Print) -> Option<Spread> {
    let heading = params.heading.and_then(|heading| {
        let cells = CellGrid::printed(heading.cell);
        let heading = Heading::on(&heading, &cells, sheet, params.margin, beside(params.mark, &cells))?;
        Some(heading.after_label(&cells))
    });
    let label = CellSize::MARBURG.extent(1, braille::PRINTED).y;
    let down = above(params, label, heading.as_ref());
    let corner = MmPoint::new(params.margin + BAND, params.margin + down + BAND);
    let window = MmVector::new(sheet[0] - 2.0 * corner.x, sheet[1] - corner.y - params.margin - BAND);
    let overlap = picture.overlap;
    // In windows of at most two overlaps, three neighbouring sheets would show the same part.
    if window.x <= 2.0 * overlap || window.y <= 2.0 * overlap {
        return None;
    }
    let step = window - MmVector::new(overlap, overlap);
    let first = MmRect::new(MmPoint::zero(), window.to_point());
    let border = params.border();
    let medium = Medium::Print(print);
    Some(Spread {
        grid: picture.grid,
        sheet,
        figure: picture.within(picture.total(first, step), border)?,
        mark: params.mark.map(|mark| sheet::bar(MmPoint::new(sheet[0] - params.margin, params.margin), mark)),
        heading,
        together: medium.clone(),
        medium,
        first,
        corner,
        step,
        half: MmVector::new(0.5 * overlap, 0.5 * overlap),
        tick: [GAP + 0.5 * TICK_WIDTH, GAP + TICK - 0.5 * TICK_WIDTH],
        label: MmPoint::new(params.margin, params.margin),
    })
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
    /// The labels of the figure that lie wholly in the window.
    pub braille: Vec<BrailleText>,
    /// The same in print: `a1`.
    pub name: String,
}

impl Spread {
    /// What every sheet shows of a figure with its frame and its labels, row by row. Sheets on which nothing of the
    /// picture lies are left out.
    pub fn cut(&self, figure: &Figure, frame: &Dots, braille: &[BrailleText]) -> Vec<Cut> {
        let shown = self.grid.sheets().filter(|&(column, row)| self.shows(column, row, figure.place));
        shown.map(|(column, row)| self.cut_sheet(column, row, figure, frame, braille)).collect()
    }

    /// Where labels can lie so that each is whole on a sheet, also where sheets are cut in the middle of their
    /// overlaps.
    pub fn tiles(&self) -> Vec<MmRect> {
        let last = (self.grid.across - 1, self.grid.down - 1);
        let tile = |(column, row): (u32, u32)| {
            let window = self.window(column, row);
            let half = |is_inner: bool, half: f32| if is_inner { half } else { 0.0 };
            let low = MmVector::new(half(column > 0, self.half.x), half(row > 0, self.half.y));
            let next = window.min + self.step + self.half;
            let end = |is_inner: bool, next: f32, edge: f32| if is_inner { next } else { edge };
            let max = MmPoint::new(end(column < last.0, next.x, window.max.x), end(row < last.1, next.y, window.max.y));
            MmRect::new(window.min + low, max)
        };
        self.grid.sheets().map(tile).collect()
    }

    /// A sheet by itself, for its title and its page number.
    pub fn layout_of_sheet(&self) -> Layout {
        let (mark, heading, medium) = (self.mark.clone(), self.heading, self.medium.clone());
        let (figure, room) = (self.first, self.first);
        Layout { sheet: self.sheet, figure, room, overview: None, mark, heading, medium, sheets: None }
    }

    /// Which sheet shows what.
    pub fn windows(&self) -> SheetWindows {
        let Self { step, half, corner, .. } = *self;
        SheetWindows { counts: [self.grid.across, self.grid.down], first: self.first.min, step, half, corner }
    }

    /// Whether something of the picture lies on a sheet.
    fn shows(&self, column: u32, row: u32, picture: MmRect) -> bool {
        self.window(column, row).intersects(&picture)
    }

    /// A sheet's window in the space of all sheets.
    fn window(&self, column: u32, row: u32) -> MmRect {
        self.first.translate(MmVector::new(column as f32, row as f32).component_mul(self.step))
    }

    /// What the sheet at this column and row shows.
    fn cut_sheet(&self, column: u32, row: u32, figure: &Figure, frame: &Dots, braille: &[BrailleText]) -> Cut {
        let window = self.window(column, row);
        let by = self.corner - window.min;
        let onto_sheet = |at: MmPoint| self.on_dots(at + by);
        // of a device each dot is in a window or not
        let is_print = matches!(self.medium, Medium::Print(_));
        let inside = |at: MmPoint, radius: f32| {
            let radius = if is_print { radius } else { 0.0 };
            window.inflate(-radius, -radius).contains_inclusive(at)
        };
        let place = window.intersection_unchecked(&figure.place);
        let share = |part: f32, whole: f32, pixels: u32| ((part / whole * pixels as f32).round() as u32).max(1);
        let source = Size::new(
            share(place.width(), figure.place.width(), figure.source.width),
            share(place.height(), figure.place.height(), figure.source.height),
        );
        let on_sheet = |glyph: &Glyph| Glyph { at: onto_sheet(glyph.at), ..*glyph };
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
            *at = onto_sheet(*at);
        }
        let whole = |dots: &Dots| dots.at.iter().all(|&at| inside(at, 0.5 * dots.diameter));
        let moved = |dots: &Dots| Dots { at: dots.at.iter().map(|&at| onto_sheet(at)).collect(), ..dots.clone() };
        let of_label = |text: &BrailleText| {
            let leader = text.leader.as_ref().and_then(|run| pieces(run, window).into_iter().next());
            let leader = leader.map(|mut run| {
                run.points.iter_mut().for_each(|at| *at = onto_sheet(*at));
                run
            });
            BrailleText { dots: moved(&text.dots), leader, ..text.clone() }
        };
        let of_frame = frame.at.iter().copied().filter(|&at| inside(at, 0.5 * frame.diameter)).collect();
        Cut {
            figure: Figure {
                place: MmRect::new(place.min + by, place.max + by),
                source,
                textures: figure.textures.iter().map(glyphs).filter(|texture| !texture.glyphs.is_empty()).collect(),
                lines,
            },
            frame: moved(&Dots { diameter: frame.diameter, at: of_frame }),
            ticks: self.ticks(column, row, figure.place),
            label: label_at(self.label, [row, column].map(|number| number as usize), &self.medium),
            braille: braille.iter().filter(|text| whole(&text.dots)).map(of_label).collect(),
            name: sheet_name(column, row),
        }
    }

    /// A place on a sheet of a device with a grid as the dot that it is: numbers are rounded on the way.
    fn on_dots(&self, at: MmPoint) -> MmPoint {
        let Medium::Dots(medium) = &self.medium else { return at };
        let DotArea::Grid(grid) = &medium.area else { return at };
        grid.nearest(at).and_then(|[column, row]| grid.at(column, row)).unwrap_or(at)
    }

    /// The ticks of a sheet. Each lies at the same point of the picture as one of the neighbouring sheet.
    fn ticks(&self, column: u32, row: u32, picture: MmRect) -> Vec<Run> {
        let (near, far) = (self.corner, self.corner + self.first.size().to_vector());
        let middles = [near + self.half, near + self.step + self.half];
        let mut ticks = Vec::new();
        // The two ends of a tick outside one side of the window, at `edge`; `out` is -1 or 1.
        let reach = |edge: f32, out: f32| self.tick.map(|away| edge + out * away);
        let mut tick = |a: MmPoint, b: MmPoint| ticks.push(Run::stroke(TICK_WIDTH, vec![a, b]));
        let left = column > 0 && self.shows(column - 1, row, picture);
        let right = column + 1 < self.grid.across && self.shows(column + 1, row, picture);
        for (there, MmPoint { x, .. }) in [left, right].into_iter().zip(middles) {
            for [a, b] in [reach(near.y, -1.0), reach(far.y, 1.0)] {
                if there {
                    tick(MmPoint::new(x, a), MmPoint::new(x, b));
                }
            }
        }
        let above = row > 0 && self.shows(column, row - 1, picture);
        let below = row + 1 < self.grid.down && self.shows(column, row + 1, picture);
        for (there, MmPoint { y, .. }) in [above, below].into_iter().zip(middles) {
            for [a, b] in [reach(near.x, -1.0), reach(far.x, 1.0)] {
                if there {
                    tick(MmPoint::new(a, y), MmPoint::new(b, y));
                }
            }
        }
        ticks
    }
}

/// The label of the sheet of this name, such as `a1`, in the top left corner of a page; none of what is no such name.
pub fn label(name: &str, medium: &Medium, margin: f32) -> Option<Dots> {
    let letter = name.chars().next().filter(char::is_ascii_lowercase)?;
    let column: usize = name[1..].parse().ok().filter(|number| (1..=SheetGrid::MOST as usize).contains(number))?;
    let corner = match medium {
        Medium::Print(_) => MmPoint::zero(),
        Medium::Dots(dots) => dots.usable().min,
    };
    let row = letter as usize - 'a' as usize;
    Some(label_at(corner + MmVector::new(margin, margin), [row, column - 1], medium))
}

/// The label of the sheet in this row and column: a letter and a number, in cells that begin in this corner.
fn label_at(corner: MmPoint, [row, column]: [usize; 2], medium: &Medium) -> Dots {
    let cells = CellGrid::of(medium, CellSize::MARBURG);
    let label = [braille::letter(row), braille::number(column + 1)].concat();
    Dots { diameter: cells.diameter, at: cells.dots(&[label], corner) }
}

/// The pieces of a line whose ink lies in a window. Pieces shorter than their width are left out: they would be blots
/// at the edge, and the neighbouring sheet shows that part as a line.
fn cut_line(line: &Line, window: MmRect) -> Vec<Line> {
    if line.row().is_some() {
        return cut_rows(line, window);
    }
    let mut found: Vec<Line> = Vec::new();
    for piece in line.runs.iter().flat_map(|run| pieces(run, window)) {
        let joins = |last: &Line| last.runs.last().and_then(|run| run.points.last()) == piece.points.first();
        match found.last_mut() {
            Some(last) if joins(last) => last.runs.push(piece),
            _ => found.push(Line { strength: line.strength, runs: vec![piece] }),
        }
    }
    let length = |line: &Line| -> f32 {
        let segments = line.runs.iter().flat_map(|run| run.polyline().segments());
        segments.map(|(a, b)| (*b - *a).length()).sum()
    };
    found.retain(|piece| length(piece) >= piece.runs.iter().map(|run| run.width).fold(0.0, f32::max));
    found
}

/// Least dots of a piece of a line: fewer have no direction.
const LEAST_DOTS: usize = 3;

/// The same of a line of dots: a heavy one has a second row of dots beside the first, which goes with the piece beside
/// which most of it lies, and so do ticks and points.
fn cut_rows(line: &Line, window: MmRect) -> Vec<Line> {
    let Some((first, others)) = line.runs.split_first() else { return Vec::new() };
    let mut found: Vec<Line> = pieces(first, window)
        .into_iter()
        .filter(|run| run.points.len() >= LEAST_DOTS)
        .map(|run| Line { strength: line.strength, runs: vec![run] })
        .collect();
    for row in others.iter().flat_map(|run| pieces(run, window)) {
        let distance = |line: &Line, at: MmPoint| {
            line.runs[0].points.iter().map(|other| (*other - at).length()).fold(f32::INFINITY, f32::min)
        };
        let middle = row.points[row.points.len() / 2];
        let nearest =
            (0..found.len()).min_by(|&a, &b| distance(&found[a], middle).total_cmp(&distance(&found[b], middle)));
        // beside a piece that is left out it would be a line of its own
        let is_beside = |&piece: &usize| {
            // a tick leads away from its line
            row.points.iter().any(|&at| distance(&found[piece], at) <= BESIDE_ROW * row.width)
        };
        let beside = nearest.filter(is_beside);
        beside.into_iter().for_each(|at| found[at].runs.push(row.clone()));
    }
    found
}

/// How far a second row lies from its line, as a share of the diameter of dots.
const BESIDE_ROW: f32 = 2.0;

/// The parts of a run in a window.
fn pieces(run: &Run, window: MmRect) -> Vec<Run> {
    match run.pen {
        Pen::Stroke => {
            let half = 0.5 * run.width;
            let paths = cut_polyline(run.polyline(), window.inflate(-half, -half));
            paths.into_iter().map(|path| Run::stroke(run.width, path)).collect()
        }
        Pen::Dots(_) => {
            let is_in = |at: &MmPoint| window.contains_inclusive(*at);
            let parts = run.points.chunk_by(|a, b| is_in(a) == is_in(b)).filter(|part| is_in(&part[0]));
            parts.map(|part| Run { points: part.to_vec(), ..run.clone() }).collect()
        }
    }
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
mod tests;
