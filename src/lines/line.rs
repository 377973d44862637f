//! Finished lines: what they are drawn with, run by run.

use crate::geom::nearby::Nearby;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::units::{MmPoint, MmRect};

/// A finished line: one contour in pieces of equal width.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Mean height of the colour step of its contour, in units of lightness with the chroma axes of CIELAB counted
    /// twice: 0 and up. Black against white is 100; saturated colours beside one another have more.
    pub strength: f32,
    /// Of strokes, pieces in order; each begins where the one before it ends. Of dots, first the row along the line,
    /// then what stands beside it: its second row, and dots of its points, ticks and arrowheads.
    pub runs: Vec<Run>,
}

/// Which strokes of drawings become heavy lines where lines become dots: the broad ones, each as a whole. Of a line
/// that is no stroke its strength says whether it is heavy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeavyStrokes {
    /// From this strength on a line is heavy.
    pub from: f32,
    /// From this width on a stroke is broad, mm on the page.
    pub width: f32,
}

/// Strength of black beside white.
const BLACK: f32 = 100.0;
/// A line of this share of the strength of heavy ones is none, whatever rounding does.
const LIGHT: f32 = 0.99;

impl HeavyStrokes {
    /// The strength that a stroke of this width counts with, of so much by itself: a broad one as black beside white
    /// would.
    pub fn strength(&self, width: f32, own: f32) -> f32 {
        match width < self.width {
            true => own.min(LIGHT * self.from),
            false if self.from <= BLACK => own.max(self.from),
            false => own,
        }
    }
}

/// A piece of a line of one width.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Width, mm.
    pub width: f32,
    /// The vertices of its polyline; of a row of dots, their centres. A ring does not repeat its first point.
    pub points: Vec<MmPoint>,
    /// Whether it is a stroke that goes on from its last point to its first.
    pub closed: bool,
    /// How it is drawn.
    pub pen: Pen,
}

/// How a piece of a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pen {
    /// A stroke through its points.
    #[default]
    Stroke,
    /// A dot on each of its points, pressed this high.
    Dots(Height),
}

/// How high a dot is pressed. Readers tell three of the eight heights of an embosser apart best (Kouroupetroglou et al.
/// 2016), so there are no more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Height {
    /// Textures.
    Low,
    /// Frames and weak lines.
    Middle,
    /// Lines, and everything where a device has one height only.
    #[default]
    High,
}

impl Height {
    /// All of them, the lowest first.
    pub const ALL: [Self; 3] = [Self::Low, Self::Middle, Self::High];

    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::Middle => "middle",
            Self::High => "high",
        }
    }
}

impl Run {
    /// A stroke along a path, a ring if the path comes back to where it began.
    pub fn stroke(width: f32, path: Vec<MmPoint>) -> Self {
        let Polyline { vertices, closed } = Polyline::from_path(path);
        Self { width, points: vertices, closed, pen: Pen::Stroke }
    }

    /// Dots on these points.
    pub fn dots(diameter: f32, points: Vec<MmPoint>, height: Height) -> Self {
        Self { width: diameter, points, closed: false, pen: Pen::Dots(height) }
    }

    /// Length, mm; of a row of dots, from the first centre to the last.
    pub fn length(&self) -> f32 {
        self.polyline().length()
    }

    /// Its points in order; of a ring the first comes again at the end.
    pub fn path(&self) -> impl Iterator<Item = MmPoint> + '_ {
        self.polyline().path().copied()
    }

    /// Its points as a polyline: for the stages, and this project's own tests.
    #[doc(hidden)]
    pub fn polyline(&self) -> PolylineRef<'_, MmPoint> {
        PolylineRef { vertices: &self.points, closed: self.closed }
    }
}

/// Lines to be found by their places, mostly within `reach`, mm: the number of each segment is that of its run among
/// those of all lines.
pub(crate) fn index_of_lines(lines: &[Line], area: MmRect, reach: f32) -> Nearby {
    let mut index = Nearby::new(area, reach);
    for (number, run) in (0..).zip(lines.iter().flat_map(|line| &line.runs)) {
        index.insert_line(number, run.polyline(), 0.5 * run.width);
    }
    index
}

/// The smallest ring of dots around an empty one has eight, and one of them may be missing.
const SMALLEST_RING: usize = 7;
/// Where a dot is missing two are no farther apart than so many steps.
const MISSING: f32 = 2.1;

/// The sides of a square of dots differ by this factor at most: columns and rows may be uneven.
const SQUARE: f32 = 1.5;
/// A line whose ends are nearer to one another than this, mm, is a ring; nobody feels such a gap.
const CLOSED: f32 = 0.05;

/// A filled point is at least this many times as broad as its line: it is drawn three times as broad.
const BROADER: f32 = 1.6;

impl Line {
    /// The least blank beside a disc that stands for a point, in least blanks of two lines: it is felt as one thing at
    /// once, and no line has to be followed between it and another. Half of it is 1.6 mm on swell paper; dots of
    /// braille have 1 mm between them, and acuity is 0.94 mm (Van Boven and Johnson 1994).
    pub(crate) const DISC_GAP: f32 = 0.5;

    /// Whether it is a disc: a ring of strokes that is so small that its own stroke fills it.
    pub(crate) fn is_disc(&self) -> bool {
        let [run] = &self.runs[..] else { return false };
        let extent = MmRect::from_points(&run.points);
        run.pen == Pen::Stroke && run.closed && extent.width().max(extent.height()) <= run.width
    }

    /// The row of dots along it; none of strokes.
    pub(crate) fn row(&self) -> Option<&Run> {
        self.runs.first().filter(|run| run.pen != Pen::Stroke)
    }

    /// Whether its last run ends where its first begins.
    pub(crate) fn ends_meet(&self) -> bool {
        let ends = || self.runs.iter().flat_map(|run| [run.path().next(), run.path().last()]).flatten();
        ends().next().zip(ends().last()).is_some_and(|(first, last)| (last - first).length() < CLOSED)
    }

    /// Whether it is a ring, of strokes of whatever widths or of dots.
    pub(crate) fn goes_round(&self) -> bool {
        let is_ring_of_strokes = || self.row().is_none() && self.ends_meet() && self.length() > 2.0 * CLOSED;
        self.is_ring_of_dots() || is_ring_of_strokes()
    }

    /// Whether it is a row of dots that comes back to where it began; a single dot may be missing there, where it
    /// touches another line.
    pub(crate) fn is_ring_of_dots(&self) -> bool {
        let points = self.row().map_or(&[][..], |row| &row.points[..]);
        let steps = points.windows(2).map(|pair| (pair[1] - pair[0]).length());
        let (longest, ends) = (steps.fold(0.0, f32::max), points.first().zip(points.last()));
        points.len() >= SMALLEST_RING && ends.is_some_and(|(a, b)| (*b - *a).length() <= MISSING * longest)
    }

    /// Whether it is a point that has no room for a ring: four dots in a square.
    pub(crate) fn is_block_of_dots(&self) -> bool {
        let [a, b, c, d] = self.row().map_or(&[][..], |row| &row.points[..]) else { return false };
        let sides = [*b - *a, *c - *b, *d - *c, *a - *d].map(|side| side.length());
        let (least, most) = sides.iter().fold((f32::MAX, 0.0_f32), |(least, most), at| (least.min(*at), most.max(*at)));
        self.runs.len() == 1 && most <= SQUARE * least && (*c - *a).length() > most
    }

    /// The pieces along which it runs: of a heavy line of dots not the second row, which is a part of the first.
    pub(crate) fn own_runs(&self) -> &[Run] {
        self.row().map_or(&self.runs[..], std::slice::from_ref)
    }

    /// The points of [`Line::own_runs`] in order; where two runs of strokes meet their point comes twice.
    pub(crate) fn own_path(&self) -> Vec<MmPoint> {
        self.own_runs().iter().flat_map(|run| run.path()).collect()
    }

    /// Length, mm.
    pub fn length(&self) -> f32 {
        self.runs.iter().map(Run::length).sum()
    }

    /// The filled points on a printed line: pieces that are broader than long, and than the line.
    #[doc(hidden)]
    pub fn beads(&self) -> impl Iterator<Item = &Run> {
        self.runs.iter().filter(|run| self.is_bead(run))
    }

    /// Whether a piece of it is a filled point.
    pub(crate) fn is_bead(&self, run: &Run) -> bool {
        let is_short = |run: &Run| run.width > 2.0 * run.length();
        let others = self.runs.iter().filter(|run| !is_short(run)).map(|run| run.width);
        let broadest = others.fold(0.0, f32::max);
        run.pen == Pen::Stroke && is_short(run) && broadest > 0.0 && run.width > BROADER * broadest
    }
}

#[cfg(test)]
mod tests;
