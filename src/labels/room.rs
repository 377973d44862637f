//! Which places of a figure are free of lines, and how many glyphs of textures a place would cost.

mod doors;
mod leader_lines;
mod sight;
mod squares;

use std::f32::consts::TAU;

use self::squares::{MarkedSquares, SQUARE, SquareSums, Squares};
use super::angles::{self, Angle};
use super::interrupted;
use super::named_points::{self, SmallRing};
use super::placed::Params;
use crate::geom::polygon::{corners, distance_to_box};
use crate::page::{Line, Pen, Texture, which_are_weak};
use crate::units::{MmPoint, MmRect, MmVector};

/// What lines shut in that are nearer than this on nearly all sides, mm, is inside of a shape, and not in the open.
pub(super) const FURTHEST_OUTLINE: f32 = 90.0;
/// From the middle of a square to its corner, mm.
const CORNER: f32 = 0.354;
/// Directions in which a point is looked at from.
const RAYS: u32 = 32;
/// The same where outlines are looked for: at 40 mm they are met every 2 mm, and less often beyond, where only the
/// longest labels reach.
pub(super) const FINE_RAYS: u32 = 128;
/// A place is in the open if it is seen in so many of them, an eighth of the circle: a door of 16 mm is narrower from
/// 20 mm on. Chosen by us.
const OPEN: usize = 4;
/// How far the ink of a line reaches below a point on its middle, at most, mm: half of the widest line, and the corner
/// of a square.
const ON_A_LINE: f32 = 1.75;
/// The sides of a shape are looked for as far as this, mm: the width of A3.
const BROADEST: f32 = 420.0;
/// Height in which a line counts that comes up to the side of a text, mm: its letters' own, about.
const SIDE_OF_TEXT: f32 = 4.0;
/// Sides that are nearer than this to those above are the same ones, mm: a third of what labels keep from lines.
const SAME_SIDE: f32 = 1.0;
/// Lines run along a side of a box that are so near to it, mm, over so much of it: those between columns may stop short
/// of those between rows, by twice the least blank.
const OFF_SIDE: f32 = 1.0;
const MOST_OF_SIDE: f32 = 0.6;
/// Dots of a line that are no further apart are side by side, mm: across the diagonal of a grid of 2.5 mm.
const SIDE_BY_SIDE: f32 = 3.6;
/// Blank between a leader line and other lines, mm.
const LEADER_CLEARANCE: f32 = 1.5;

/// Rows of dots of a texture are so far apart, mm, or more.
const BETWEEN_ROWS: f32 = 4.0;
/// A whole glyph in the shares in which they are counted.
const WHOLE: u32 = 64;
/// Area that a glyph of a dense printed texture stands for, mm2: that of `swell-a4`.
const GLYPH_AREA: f32 = 11.2;

/// What is in the squares of a figure.
#[derive(Debug)]
pub(super) struct Room {
    squares: Squares,
    /// Squares nearer to a line than a label may lie, but for gridlines that give way to labels.
    taken: SquareSums,
    /// Squares too near to those.
    grid: SquareSums,
    /// Squares nearer to a line than a leader line may lie.
    for_leader: MarkedSquares,
    /// Squares that lines lie in.
    ink: MarkedSquares,
    /// Those that lines lie in which are not weak, where there are weak ones.
    strong: Option<MarkedSquares>,
    /// Glyphs, in shares of one.
    glyphs: SquareSums,
    /// Where those of each texture are.
    textures: Vec<Vec<MmPoint>>,
    /// Width of the widest line, mm.
    widest: f32,
    /// Whether its lines are those of a page, and not contours of a drawing.
    is_drawn: bool,
    /// The box around all lines.
    bounds: Option<MmRect>,
    /// Angles between straight lines.
    angles: Vec<Angle>,
    /// Small rings, which stand for points.
    rings: Vec<SmallRing>,
    /// Doors in walls, each from one side to the other.
    doors: Vec<[MmPoint; 2]>,
}

impl Room {
    /// The sides of blocked boxes are kept clear of as lines are.
    pub(super) fn new(lines: &[Line], textures: &[Texture], params: &Params) -> Self {
        let &Params { area, ref blocked, ref leaders, clearance, least_strength, .. } = params;
        let share = share_of_glyph(params);
        let glyphs = textures.iter().flat_map(|texture| &texture.glyphs).map(|glyph| (glyph.at, share));
        let sides = || blocked.iter().flat_map(|place| sides_of(*place)).map(|side| (side, 0.0));
        let room = Self::of_segments(area, segments(lines.iter()).chain(sides()), glyphs, clearance);
        let (of_grid, others): (Vec<_>, Vec<_>) = lines
            .iter()
            .zip(interrupted::giving_way(lines, least_strength, leaders))
            .partition(|(_, gives_way)| *gives_way);
        let near = |lines: Vec<(&Line, bool)>, blocked: bool| {
            let segments = segments(lines.into_iter().map(|(line, _)| line));
            let sides = sides().filter(|_| blocked);
            room.squares.near(segments.chain(sides), CORNER + clearance).sums(&room.squares)
        };
        let angles = angles::of(others.iter().map(|(line, _)| *line));
        let (taken, grid) = (near(others, true), near(of_grid, false));
        let (rings, strong) = (named_points::rings(lines), room.strong(lines, least_strength));
        let doors = room.doors_of(lines, least_strength);
        let textures = textures.iter().map(|of| of.glyphs.iter().map(|glyph| glyph.at).collect()).collect();
        Self { angles, rings, doors, strong, taken, grid, textures, is_drawn: true, ..room }
    }

    /// Of a drawing that is not drawn yet: with contours at these points, on which lines of this width will lie.
    pub(super) fn of_contours(area: MmRect, points: &[MmPoint], width: f32, clearance: f32) -> Self {
        let squares = Squares::of(area);
        let mut points: Vec<(usize, MmPoint)> =
            points.iter().filter_map(|&at| Some((squares.index(at)?, at))).collect();
        // one in each square
        points.sort_by_key(|(square, _)| *square);
        points.dedup_by_key(|(square, _)| *square);
        let segments = points.into_iter().map(|(_, at)| ([at, at], width));
        Self::of_segments(area, segments, std::iter::empty(), clearance)
    }

    /// Of segments, each with the width of its ink, and of glyphs.
    fn of_segments(
        area: MmRect,
        segments: impl Iterator<Item = ([MmPoint; 2], f32)>,
        glyphs: impl Iterator<Item = (MmPoint, u32)>,
        clearance: f32,
    ) -> Self {
        let squares = Squares::of(area);
        let none = || MarkedSquares::none_of(&squares);
        let (mut taken, mut for_leader, mut ink) = (none(), none(), none());
        let (mut bounds, mut widest): (Option<MmRect>, f32) = (None, 0.0);
        for ([a, b], width) in segments {
            let half = 0.5 * width + CORNER;
            widest = widest.max(width);
            squares.around(a, b, half + clearance, |index| taken.mark(index));
            squares.around(a, b, half + LEADER_CLEARANCE, |index| for_leader.mark(index));
            squares.around(a, b, half, |index| ink.mark(index));
            let own = MmRect::new(a.min(b), a.max(b)).inflate(0.5 * width, 0.5 * width);
            bounds = Some(bounds.map_or(own, |all| MmRect::new(all.min.min(own.min), all.max.max(own.max))));
        }
        let glyphs = SquareSums::of(&squares, glyphs.filter_map(|(at, share)| Some((squares.index(at)?, share))));
        let (taken, grid) = (taken.sums(&squares), none().sums(&squares));
        let (angles, rings) = (Vec::new(), Vec::new());
        Self {
            squares,
            taken,
            grid,
            for_leader,
            ink,
            glyphs,
            textures: Vec::new(),
            widest,
            bounds,
            strong: None,
            angles,
            rings,
            doors: Vec::new(),
            is_drawn: false,
        }
    }

    /// The box around the ink of all lines; none where there are none.
    pub(super) fn bounds(&self) -> Option<MmRect> {
        self.bounds
    }

    /// How wide the widest line is, mm.
    pub(super) fn widest(&self) -> f32 {
        self.widest
    }

    /// Whether its lines are those of a page, and not contours of a drawing.
    pub(super) fn is_drawn(&self) -> bool {
        self.is_drawn
    }

    /// The small rings among the lines.
    pub(super) fn rings(&self) -> &[SmallRing] {
        &self.rings
    }

    /// The angle between two lines in which a point stands near to where these meet.
    pub(super) fn angle_around(&self, at: MmPoint) -> Option<Angle> {
        Angle::around(at, &self.angles)
    }

    /// Whether a box lies in the area and as far from lines as labels must.
    pub(super) fn is_free(&self, place: MmRect) -> bool {
        self.squares.area.contains_box(&place) && self.taken.within(place, &self.squares) == 0
    }

    /// Whether there is so much more than the clearance between a box and the lines on its left and on its right.
    pub(super) fn is_free_aside(&self, place: MmRect, more: f32) -> bool {
        more <= 0.0 || self.taken.within(place.inflate(more, 0.0), &self.squares) == 0
    }

    /// How far a leader line is felt before it meets a line, mm.
    pub(super) fn before_first_line(&self, from: MmPoint, to: MmPoint) -> f32 {
        let chord = to - from;
        let direction = chord / chord.length().max(SQUARE);
        self.first_ink(from, direction, chord.length()).unwrap_or(chord.length())
    }

    /// Whether gridlines have to be interrupted for a label in this box.
    pub(super) fn interrupts_grid(&self, place: MmRect) -> bool {
        self.grid.within(place, &self.squares) > 0
    }

    /// Whether a gridline that gives way to a box would stay on one side of it only: so the number of a gridline stands
    /// at its end. One above or below the box has its number on the left. It stays where so much of it is left, mm,
    /// beyond the clearance and up to the next line.
    pub(super) fn ends_gridline(&self, place: MmRect, clearance: f32, least: f32) -> bool {
        if !self.interrupts_grid(place) {
            return false;
        }
        let far = clearance - SQUARE;
        let rows = (0..).map(|step| place.min.y - far + 0.5 * SQUARE * step as f32);
        // what lies in a box that is free of lines is a gridline
        let is_in_column = |y: &f32| self.is_ink(MmPoint::new(place.center().x, *y));
        let Some(y) = rows.take_while(|y| *y <= place.max.y + far).find(is_in_column) else { return false };
        let stays = |from: f32, direction: f32| {
            let steps = 0..=(least / (0.5 * SQUARE)).ceil() as u32;
            let far = steps.map(|step| direction * (clearance + 0.5 * SQUARE * step as f32));
            let is_at = |far: f32, down: f32| self.is_gridline(MmPoint::new(from + far, y + down));
            far.into_iter().all(|far| [0.0, SQUARE].iter().any(|&down| is_at(far, down)))
        };
        let (left, right) = (stays(place.min.x, -1.0), stays(place.max.x, 1.0));
        let goes_through = (place.min.y..=place.max.y).contains(&y);
        right && !left || goes_through && left && !right
    }

    /// Whether a weak line lies at a point, such as a gridline, and no other.
    pub(super) fn is_gridline(&self, at: MmPoint) -> bool {
        let is_weak = self.strong.as_ref().is_some_and(|strong| !strong.holds(at, &self.squares));
        is_weak && self.is_ink(at)
    }

    /// Whether a line lies at a point.
    pub(super) fn is_ink(&self, at: MmPoint) -> bool {
        self.ink.holds(at, &self.squares)
    }

    /// The squares of the lines that are not weak; none if all are like that.
    fn strong(&self, lines: &[Line], least_strength: f32) -> Option<MarkedSquares> {
        let weak = which_are_weak(lines, least_strength);
        let strong = lines.iter().zip(&weak).filter(|(_, is_weak)| !**is_weak).map(|(line, _)| line);
        weak.contains(&true).then(|| self.squares.near(segments(strong), CORNER))
    }

    /// The middle of the square of a line to which a text belongs that stands beside it: the nearest within `reach`, or
    /// where that is a weak one, such as a gridline, the nearest other within `beyond_weak`.
    pub(super) fn line_beside(&self, place: MmRect, reach: f32, beyond_weak: f32) -> Option<MmPoint> {
        let nearest = self.nearest(place, reach, &self.ink)?;
        let Some(strong) = &self.strong else { return Some(nearest) };
        if strong.holds(nearest, &self.squares) {
            Some(nearest)
        } else {
            self.nearest(place, beyond_weak, strong).or(Some(nearest))
        }
    }

    /// The middle of the square with ink that is nearest to a box, and within `reach` of it.
    fn nearest(&self, place: MmRect, reach: f32, ink: &MarkedSquares) -> Option<MmPoint> {
        let steps = |side: f32| (side / SQUARE).ceil() as u32;
        let around = place.inflate(reach, reach);
        let squares = (0..=steps(around.height())).flat_map(|y| (0..=steps(around.width())).map(move |x| (x, y)));
        let points = squares.map(|(x, y)| around.min + MmVector::new(x as f32, y as f32) * SQUARE);
        let far = |at: &MmPoint| distance_to_box(*at, place);
        points.filter(|at| far(at) <= reach && ink.holds(*at, &self.squares)).min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// How many glyphs lie in a box; the dots of a device count by what is printed in their place.
    pub(super) fn glyphs(&self, place: MmRect) -> f32 {
        self.glyphs.within(place, &self.squares) as f32 / WHOLE as f32
    }

    /// How many glyphs the texture has that lies around a point, counted likewise; none where none is within `reach`
    /// mm.
    pub(super) fn texture_around(&self, at: MmPoint, reach: f32, params: &Params) -> Option<f32> {
        let all = self.textures.iter().flat_map(|of| of.iter().map(move |glyph| (*glyph, of.len())));
        let far = |glyph: MmPoint| (glyph - at).length();
        let (nearest, count) = all.min_by(|a, b| far(a.0).total_cmp(&far(b.0)))?;
        let is_around = far(nearest) <= reach && !self.is_parted(at, nearest, 0.0);
        is_around.then(|| count as f32 * share_of_glyph(params) as f32 / WHOLE as f32)
    }

    /// Whether a straight leader line would keep clear of other lines; `end` mm before its end it need not, as there is
    /// what it leads to.
    pub(super) fn is_free_segment(&self, from: MmPoint, to: MmPoint, end: f32) -> bool {
        !self.meets(&self.for_leader, from, to, end)
    }

    /// Whether a line lies between two places; `end` mm before the second it does not count.
    pub(super) fn is_parted(&self, from: MmPoint, to: MmPoint, end: f32) -> bool {
        self.meets(&self.ink, from, to, end)
    }

    /// The same where a text stands at the second place: gridlines part it from nothing.
    pub(super) fn is_parted_from_text(&self, from: MmPoint, text: MmPoint, end: f32) -> bool {
        self.meets(self.strong.as_ref().unwrap_or(&self.ink), from, text, end)
    }

    /// How far from the first point the only line begins that lies between two, if it is no broader than this, mm; none
    /// where there is none, or more than one.
    pub(super) fn only_line(&self, from: MmPoint, to: MmPoint, broadest: f32) -> Option<f32> {
        let chord = to - from;
        let direction = chord / chord.length().max(SQUARE);
        let begin = self.first_ink(from, direction, chord.length())?;
        // the ink of the squares of one line is not interrupted
        let steps = (2.0 * chord.length() / SQUARE).ceil() as u32;
        let mut along = (0..=steps).map(|step| 0.5 * SQUARE * step as f32).filter(|along| *along <= chord.length());
        let last = along.rfind(|along| self.is_ink(from + direction * *along))?;
        (last - begin <= broadest).then_some(begin)
    }

    /// The box of lines around a point, such as a cell of a table: what lies nearest to the point on the left, on the
    /// right, above and below, if lines run along most of the sides of the box between. Where the page lacks the lines
    /// between the columns of a table, it is the whole row. Faint lines, as of a grid behind a curve, part nothing.
    pub(super) fn cell_around(&self, at: MmPoint) -> Option<MmRect> {
        let ink = self.strong.as_ref().unwrap_or(&self.ink);
        let to = |x: f32, y: f32| self.first_in(ink, at, MmVector::new(x, y), BROADEST);
        let (low, high) = (MmVector::new(to(-1.0, 0.0)?, to(0.0, -1.0)?), MmVector::new(to(1.0, 0.0)?, to(0.0, 1.0)?));
        let cell = MmRect::new(at - low, at + high);
        let corners = corners(cell);
        let is_side = |i: usize| {
            let (from, to) = (corners[i], corners[(i + 1) % 4]);
            let steps = ((to - from).length() / SQUARE).ceil().max(1.0);
            let places = (0..=steps as u32).map(|step| from.lerp(to, step as f32 / steps));
            places.filter(|at| self.nearest(MmRect::new(*at, *at), OFF_SIDE, ink).is_some()).count() as f32
                >= MOST_OF_SIDE * (steps + 1.0)
        };
        ((0..4).all(is_side)).then_some(cell)
    }

    /// How far the lines around a point reach that shut it in on all sides, mm; none if one side is open as far as
    /// `reach`.
    pub(super) fn shut_in(&self, at: MmPoint, reach: f32) -> Option<f32> {
        self.rays(at, reach).try_fold(0.0_f32, |most, hit| hit.map(|hit| most.max(hit)))
    }

    /// How far the first ink lies in directions all around a point, mm; none where there is none within `reach`.
    fn rays(&self, at: MmPoint, reach: f32) -> impl Iterator<Item = Option<f32>> {
        (0..RAYS).map(move |ray| {
            let (sin, cos) = (TAU * ray as f32 / RAYS as f32).sin_cos();
            self.first_ink(at, MmVector::new(cos, sin), reach)
        })
    }

    /// Where a line, but for gridlines, is met first in directions all around a point within `reach` mm, each with a
    /// place `behind` mm further on in which no line lies.
    pub(super) fn lines_around(&self, at: MmPoint, reach: f32, behind: f32) -> Vec<[MmPoint; 2]> {
        let ink = self.strong.as_ref().unwrap_or(&self.ink);
        let met = |ray: u32| {
            let (sin, cos) = (TAU * ray as f32 / FINE_RAYS as f32).sin_cos();
            let direction = MmVector::new(cos, sin);
            let far = self.first_in(ink, at, direction, reach)?;
            let place = at + direction * (far + behind);
            (!ink.holds(place, &self.squares)).then_some([at + direction * far, place])
        };
        (0..FINE_RAYS).filter_map(met).collect()
    }

    /// Where a way from a place in this direction leads into a shape behind the first line within `reach` mm, but for
    /// gridlines: a place `behind` mm further on, off all lines, which others shut in.
    pub(super) fn entry_of_shape(
        &self,
        at: MmPoint,
        direction: MmVector,
        [reach, behind]: [f32; 2],
    ) -> Option<MmPoint> {
        let ink = self.strong.as_ref().unwrap_or(&self.ink);
        let inside = at + direction * (self.first_in(ink, at, direction, reach)? + behind);
        (!ink.holds(inside, &self.squares) && self.is_in_room(inside, FURTHEST_OUTLINE)).then_some(inside)
    }

    /// Whether lines around a point shut it in: it is seen from beyond `reach` mm through narrow gaps at most, such as
    /// the doors of a room.
    pub(super) fn is_in_room(&self, at: MmPoint, reach: f32) -> bool {
        self.rays(at, reach).filter(Option::is_none).take(OPEN).count() < OPEN
    }

    /// Whether a point lies at the lower side of a shape: on a line or at most `above` mm below it, with an inside
    /// above that line, which has lines on both sides, and nothing for `below` mm under the point.
    pub(super) fn is_at_lower_side(&self, at: MmPoint, above: f32, below: f32) -> bool {
        let down = MmVector::new(0.0, 1.0);
        // a point on the line itself stands in its ink
        let Some(up) = self.first_ink(at + down * SQUARE, -down, above + SQUARE) else { return false };
        let start = at + down * ON_A_LINE;
        if self.first_ink(start, down, below).is_some() {
            return false;
        }
        let Some([left, right]) = self.sides(at - down * (up + ON_A_LINE)) else { return false };
        // of a line across a shape, or the top of one, the lines go on below it, or are nearer there
        let goes_on = |sides: [f32; 2]| sides[0] <= left + SAME_SIDE && sides[1] <= right + SAME_SIDE;
        !self.sides(start).is_some_and(goes_on)
    }

    /// On which side a line comes up to a box, when it is only one and none is above or below it: -1 on the left, 1 on
    /// the right. So a text stands at the end of the line that leads to what it names, or beside an axis.
    pub(super) fn comes_up_to(&self, place: MmRect, reach: f32) -> Option<f32> {
        let middle = place.center();
        let has = |direction: MmVector, half: f32| {
            // beside the middle too, as a line seldom ends exactly on it
            let across = MmVector::new(direction.y, direction.x) * (0.5 * SIDE_OF_TEXT);
            [-1.0, 0.0, 1.0].iter().any(|&k| self.first_ink(middle + across * k, direction, half + reach).is_some())
        };
        let [left, right] = [-1.0, 1.0].map(|x| has(MmVector::new(x, 0.0), 0.5 * place.width()));
        let [above, below] = [-1.0, 1.0].map(|y| has(MmVector::new(0.0, y), 0.5 * place.height()));
        match (left, right, above || below) {
            (true, false, false) => Some(-1.0),
            (false, true, false) => Some(1.0),
            _ => None,
        }
    }

    /// How far the first lines on the left and on the right lie, mm; none if there are not both.
    fn sides(&self, at: MmPoint) -> Option<[f32; 2]> {
        let side = |x: f32| self.first_ink(at, MmVector::new(x, 0.0), BROADEST);
        Some([side(-1.0)?, side(1.0)?])
    }

    /// How far the first ink lies in a direction, mm.
    fn first_ink(&self, at: MmPoint, direction: MmVector, reach: f32) -> Option<f32> {
        self.first_in(&self.ink, at, direction, reach)
    }

    /// How far the first of these squares lies in a direction, mm.
    fn first_in(&self, marked: &MarkedSquares, at: MmPoint, direction: MmVector, reach: f32) -> Option<f32> {
        marked.first_in(&self.squares, at, direction, reach)
    }

    fn meets(&self, marked: &MarkedSquares, from: MmPoint, to: MmPoint, end: f32) -> bool {
        marked.meets(&self.squares, from, to, end)
    }
}

/// What a glyph of a texture counts, in shares of a whole one: the dots of a row stand for little each.
fn share_of_glyph(params: &Params) -> u32 {
    let is_dots = params.dot_pitch > 0.0;
    let share = if is_dots { (params.dot_pitch * BETWEEN_ROWS / GLYPH_AREA).min(1.0) } else { 1.0 };
    (share * WHOLE as f32).round() as u32
}

fn sides_of(place: MmRect) -> [[MmPoint; 2]; 4] {
    let corners = corners(place);
    [0, 1, 2, 3].map(|side| [corners[side], corners[(side + 1) % 4]])
}

/// The segments of lines, each with the width of its ink.
fn segments<'a>(lines: impl Iterator<Item = &'a Line>) -> impl Iterator<Item = ([MmPoint; 2], f32)> {
    lines.flat_map(|line| &line.runs).flat_map(|run| {
        let points: Vec<MmPoint> = match run.pen {
            // between dots side by side there is no way through: they are felt as a line
            Pen::Dots(_) => {
                let links = run.points.windows(2).filter(|pair| (pair[1] - pair[0]).length() <= SIDE_BY_SIDE);
                let links = links.flat_map(|pair| [pair[0], pair[1]]);
                run.points.iter().flat_map(|&at| [at, at]).chain(links).collect()
            }
            Pen::Stroke => {
                let path: Vec<MmPoint> = run.polyline().path().copied().collect();
                path.windows(2).flat_map(|pair| [pair[0], pair[1]]).collect()
            }
        };
        let pairs: Vec<_> = points.chunks_exact(2).map(|ends| ([ends[0], ends[1]], run.width)).collect();
        pairs
    })
}

#[cfg(test)]
mod tests;
