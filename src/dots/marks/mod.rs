//! Points, ticks and heads of arrows on lines of dots. They are dots of the line on which they are:
//!
//! ```text
//!   #     #     #        a tick: a row of dots across the line, two of them or more
//!   #     #     #
//!   # # # # # # # # # # # # # # #
//!                   . # # # .  # # #
//!   a disc: # # # # # # # # #  # . #  a ring: where the line is interrupted
//!                   . # # # .  # # #
//! ```
//!
//! Points come first, then heads, then ticks. A line that ends beside a point on another ends before it. A line with
//! any has one row of dots, so that they stand out from it. Points beside all lines, such as those of a scatter plot,
//! come last, where they have room; gridlines, and other weak lines that go on on both sides, are interrupted there. A
//! weak line that ends at a point on another, as the one that leads to its name, begins at its dots.

mod alone;
mod head;
mod interrupt;
mod lattice;
mod order;

#[cfg(test)]
mod tests;

use self::lattice::{DotDisc, MarkField, Owner};
use super::grid_dot::GridPoint;
use super::params::{LEAST_DOTS, LEAST_STEP, Params};
use crate::geom::right_of;
use crate::lines::{Line, LineMarks, MOST_BLOCKED, PointMark, TickMark, tick_selections, whole_series};
use crate::units::{MmPoint, MmRect, MmVector};

pub(super) use self::lattice::Lattice;

/// The hollow of a ring is at least this wide, mm, from dot to dot: twice as wide as a groove that a fingertip just
/// feels (0.94 mm: Van Boven and Johnson 1994). Chosen by us.
const HOLLOW: f32 = 2.0;
/// A tick reaches so far beyond its line, mm, and at least two dots. Chosen by us: two dots of braille.
const TICK: f32 = 4.0;
const TICK_DOTS: usize = 2;
/// The blank between two ticks, mm: the least between any two marks (1/8 inch: Hasty).
const BETWEEN: f32 = 3.2;
/// Of two dots as near the one with the greater column and row is taken, as lines are: so much nearer, in steps.
const MIDWAY: f32 = 1e-3;
/// The direction of a row is taken over so many dots to both sides.
const DIRECTION_SPAN: usize = 2;
/// A row is that of a tick if it leads as its line does but for 30 degrees: the cosine.
const ALONG: f32 = 0.87;
/// A row is that of a tick if it lies no farther than this beside the tick, in pitches.
const ASIDE: f32 = 0.75;
/// A side of a tick that is so much longer than the shortest of its scale is longer on the page.
const LONGER: f32 = 1.3;

/// A row of dots: a line, or a part of one.
#[derive(Debug, Clone)]
pub(super) struct Row {
    pub(super) dots: Vec<MmPoint>,
    pub(super) closed: bool,
    /// Whether it is to have a second row.
    pub(super) is_heavy: bool,
    /// Whether its line is weak beside the others of the figure, as gridlines are: a tenth of the strongest or less.
    pub(super) is_weak: bool,
}

/// The dots of a level or upright row lie less than this apart across it, in steps: rounding may move some by one.
const LEVEL: f32 = 1.5;
/// What is no farther ahead of the foot of a tick than this share of a pitch is on its row, or behind that.
const ON_ROW: f32 = 0.25;

impl Row {
    /// Whether it is level or upright, with dots so many mm apart.
    fn is_level_or_upright(&self, pitch: f32) -> bool {
        let size = MmRect::from_points(&self.dots).size();
        size.width.min(size.height) < LEVEL * pitch
    }
}

/// What is drawn for marks.
pub(super) struct Placed {
    /// The dots of the marks on each row, mark by mark.
    pub(super) runs: Vec<Vec<Vec<MmPoint>>>,
    /// The dots of rows that are left out, as a ring is hollow.
    pub(super) hidden: Vec<Vec<MmPoint>>,
    /// Which rows have points or heads.
    pub(super) has_points: Vec<bool>,
    pub(super) alone: Vec<PointAlone>,
    pub(super) shown: Shown,
}

/// A point beside all rows.
pub(super) struct PointAlone {
    runs: Vec<Vec<MmPoint>>,
    strength: f32,
}

impl PointAlone {
    /// As a line of its own.
    pub(super) fn line(self, params: &Params) -> Line {
        let Self { runs, strength } = self;
        let line = Line { strength, runs: Vec::new() };
        let height = params.height(&line);
        Line { runs: runs.into_iter().map(|dots| params.run(dots, height)).collect(), ..line }
    }
}

/// Which marks are drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shown {
    /// Which points.
    pub points: Vec<bool>,
    /// Which heads of arrows.
    pub heads: Vec<bool>,
    /// Which ticks of each scale.
    pub scales: Vec<ShownScale>,
}

impl Shown {
    /// Nothing of these marks.
    pub(super) fn none_of(marks: &LineMarks) -> Self {
        let none = |scale: &Vec<TickMark>| ShownScale { ticks: vec![false; scale.len()], every: 1 };
        let [points, heads] = [marks.points.len(), marks.heads.len()].map(|count| vec![false; count]);
        Self { points, heads, scales: marks.scales.iter().map(none).collect() }
    }
}

/// What is drawn of a scale.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownScale {
    /// Which ticks.
    pub ticks: Vec<bool>,
    /// Every how many-th there is room for.
    pub every: usize,
}

/// A dot of a row.
#[derive(Clone, Copy)]
struct RowDot {
    row: usize,
    /// Which of its row's dots it is.
    number: usize,
    at: GridPoint,
}

/// A point that is drawn.
#[derive(Clone, Copy)]
struct DrawnPoint {
    middle: GridPoint,
    /// In steps.
    radius: f32,
}

/// A tick in dots.
struct Tick {
    /// Its number in its scale.
    number: usize,
    row: usize,
    /// The dots to each side of its row.
    sides: [Vec<GridPoint>; 2],
}

struct Places<'a> {
    rows: &'a [Row],
    /// Which rows are level or upright, as gridlines are.
    level: Vec<bool>,
    params: &'a Params,
    field: MarkField<'a>,
    points: Vec<DrawnPoint>,
    placed: Placed,
}

/// Finds room for marks on rows of dots.
pub(super) fn place(marks: &LineMarks, rows: &[Row], lattice: Lattice<'_>, params: &Params) -> Placed {
    let placed = place_with(marks, &vec![true; marks.points.len()], rows, lattice, params);
    let series: Vec<Option<usize>> = marks.points.iter().map(|point| point.series).collect();
    let whole = whole_series(&series, &placed.shown.points);
    if whole == placed.shown.points { placed } else { place_with(marks, &whole, rows, lattice, params) }
}

/// The same with those of the points that are wanted.
fn place_with(marks: &LineMarks, wanted: &[bool], rows: &[Row], lattice: Lattice<'_>, params: &Params) -> Placed {
    let mut field = MarkField::new(lattice);
    for (number, row) in rows.iter().enumerate() {
        let dots = row.dots.iter().enumerate();
        dots.for_each(|(place, at)| field.put(lattice.to_steps(*at), Owner::Row(number, place)));
    }
    let placed = Placed {
        runs: vec![Vec::new(); rows.len()],
        hidden: vec![Vec::new(); rows.len()],
        has_points: vec![false; rows.len()],
        alone: Vec::new(),
        shown: Shown::default(),
    };
    let level = rows.iter().map(|row| row.is_level_or_upright(params.pitch)).collect();
    let mut places = Places { rows, level, params, field, points: Vec::new(), placed };
    places.placed.shown.points = places.points_on_rows(&marks.points, wanted);
    for head in &marks.heads {
        let is_drawn = places.head(head);
        places.placed.shown.heads.push(is_drawn);
    }
    for (number, scale) in marks.scales.iter().enumerate() {
        let shown = places.scale(number, scale);
        places.placed.shown.scales.push(shown);
    }
    places.alone(marks.points.iter().enumerate().filter(|(number, point)| point.is_alone && wanted[*number]).collect());
    places.drop_scraps();
    places.placed
}

impl Places<'_> {
    /// The dot of a row, among those that count, nearest to a place of its line.
    fn nearest(&self, at: MmPoint, counts: impl Fn(RowDot) -> bool) -> Option<RowDot> {
        // of two dots as near the same as of lines
        let at = self.field.lattice.to_steps(at).map(|at| at + MIDWAY);
        // lines are moved, and their marks go with them
        let reach = self.params.farthest_moved() / self.params.pitch + 1.0;
        let far = |dot: GridPoint| (dot[0] - at[0]).hypot(dot[1] - at[1]);
        let dots = self.field.around(at, reach).filter_map(|(_, dot, owner)| {
            let Owner::Row(row, number) = owner else { return None };
            Some(RowDot { row, number, at: dot }).filter(|dot| counts(*dot))
        });
        let place = |dot: &RowDot| (dot.row, dot.number);
        dots.min_by(|a, b| far(a.at).total_cmp(&far(b.at)).then(place(a).cmp(&place(b))))
    }

    /// Draws a point if there is room for it.
    fn point(&mut self, point: &PointMark) -> bool {
        let lattice = self.field.lattice;
        let Some(of_row) = self.nearest(point.at, |_| true) else { return false };
        let RowDot { row, number, at: middle } = of_row;
        let radius = self.radius(point);
        let DotDisc { around, inside } = lattice.disc(middle, self.along(of_row), radius);
        let leads = self.leads_to(middle, radius);
        if !around.iter().all(|dot| lattice.holds(*dot)) || !self.has_room(&leads, &around) {
            return false;
        }
        let hidden: Vec<(GridPoint, Owner)> = {
            let dots = self.field.around(middle, radius as f32 + 1.0);
            let is_hidden = |dot: GridPoint| match lattice {
                Lattice::Grid { .. } => !point.is_filled && inside.contains(&dot),
                // between the dots of the row those of the point would be uneven
                Lattice::Free { .. } => lattice.steps(dot, middle) < radius as f32 + LEAST_STEP,
            };
            dots.filter(|(_, dot, _)| is_hidden(*dot)).map(|(_, dot, owner)| (dot, owner)).collect()
        };
        if !self.rows_stay(&hidden) {
            return false;
        }
        for (_, owner) in hidden {
            if let Owner::Row(row, number) = owner {
                self.hide(row, number);
            }
        }
        self.shorten(&around, &leads);
        let stays: Vec<usize> = std::iter::once(row).chain(self.stem(&leads, row, (middle, radius))).collect();
        self.interrupt_weak(&around, &stays);
        let wanted = around.into_iter().chain(inside.into_iter().filter(|_| point.is_filled));
        let mut run = Vec::new();
        for dot in wanted {
            if !self.field.around(dot, 1.0).any(|(_, other, _)| lattice.are_one(dot, other)) {
                self.field.put(dot, Owner::Row(row, number));
                run.push(lattice.to_mm(dot));
            }
        }
        self.placed.runs[row].push(run);
        self.placed.has_points[row] = true;
        self.points.push(DrawnPoint { middle, radius: radius as f32 });
        true
    }

    /// Leaves a dot of a row out.
    fn hide(&mut self, row: usize, number: usize) {
        let lattice = self.field.lattice;
        let at = self.rows[row].dots[number];
        if !self.placed.hidden[row].contains(&at) {
            let dot = lattice.to_steps(at);
            let is_it = |other: GridPoint, of: Owner| lattice.are_one(other, dot) && of == Owner::Row(row, number);
            self.field.take_out(is_it, dot, 1.0);
            self.placed.hidden[row].push(at);
        }
    }

    /// The radius of a point, in steps: the side of a disc is that of its outermost dots, and a ring is drawn along its
    /// middle.
    fn radius(&self, point: &PointMark) -> i32 {
        let Params { pitch, diameter, .. } = *self.params;
        let own = point.radius - if point.is_filled { 0.5 * diameter } else { 0.0 };
        self.smallest_radius().max((own / pitch).round() as i32)
    }

    /// The least radius of a point, in steps.
    fn smallest_radius(&self) -> i32 {
        let Params { pitch, diameter, .. } = *self.params;
        (((HOLLOW + diameter) / (2.0 * pitch)).ceil() as i32).max(1)
    }

    /// Which way a row runs at one of its dots.
    fn along(&self, RowDot { row, number, .. }: RowDot) -> MmVector {
        let dots = &self.rows[row].dots;
        let way = dots[(number + DIRECTION_SPAN).min(dots.len() - 1)] - dots[number.saturating_sub(DIRECTION_SPAN)];
        way.try_normalize().unwrap_or(MmVector::new(1.0, 0.0))
    }

    /// Whether there is less than the least blank between a dot and a point.
    fn is_close_to(&self, dot: GridPoint, point: &DrawnPoint) -> bool {
        let lattice = self.field.lattice;
        let apart = (lattice.to_mm(dot) - lattice.to_mm(point.middle)).length();
        apart < point.radius * self.params.pitch + BETWEEN + self.params.diameter
    }

    /// Whether a disc is apart from other points, and from the rows that do not lead to it, give way or end before it.
    fn has_room(&self, leads: &[usize], around: &[GridPoint]) -> bool {
        let is_near_point = |other: &DrawnPoint| around.iter().any(|dot| self.is_close_to(*dot, other));
        if self.points.iter().any(is_near_point) {
            return false;
        }
        let gives_way = |row, number| self.gives_way(row, number) || self.free_end(row, number).is_some();
        let stays = |owner: Owner| match owner {
            Owner::Row(row, number) => !leads.contains(&row) && !gives_way(row, number),
            Owner::Tick(..) => false,
        };
        !around.iter().flat_map(|dot| self.near(*dot)).any(|(_, owner)| stays(owner))
    }

    /// Whether rows are lines without these dots.
    fn rows_stay(&self, hidden: &[(GridPoint, Owner)]) -> bool {
        let rows = || hidden.iter().filter_map(|(_, owner)| row_of(*owner));
        rows().all(|row| {
            let count = self.rows[row].dots.len().saturating_sub(self.placed.hidden[row].len());
            count >= LEAST_DOTS + rows().filter(|other| *other == row).count()
        })
    }

    /// Whether there is less than the least blank between two dots of two marks.
    fn are_close(&self, a: GridPoint, b: GridPoint) -> bool {
        let lattice = self.field.lattice;
        let apart = (lattice.to_mm(a) - lattice.to_mm(b)).length();
        apart < BETWEEN + self.params.diameter
    }

    /// In how many steps around a dot there may be dots that are so close.
    fn reach(&self) -> f32 {
        (BETWEEN + self.params.diameter) / self.params.pitch + 1.0
    }

    /// Draws the ticks of a scale for which there is room.
    fn scale(&mut self, number: usize, scale: &[TickMark]) -> ShownScale {
        let are_both = scale.iter().any(|tick| tick.ends.iter().all(Option::is_some));
        let sides: &[[bool; 2]] = if are_both { &[[true; 2], [true, false], [false, true]] } else { &[[true; 2]] };
        let shortest = scale.iter().flat_map(TickMark::sides).flatten().fold(f32::INFINITY, f32::min);
        for (every, members) in tick_selections(scale) {
            for sides in sides {
                let ticks: Vec<Tick> =
                    members.iter().filter_map(|&member| self.tick(member, &scale[member], shortest, *sides)).collect();
                let count = members.len() as f32;
                if ticks.is_empty() || ticks.len() as f32 + MOST_BLOCKED * count < count {
                    continue;
                }
                if self.are_apart(&ticks) {
                    return self.draw(number, scale.len(), every, ticks);
                }
            }
        }
        ShownScale { ticks: vec![false; scale.len()], every: 1 }
    }

    fn draw(&mut self, scale: usize, count: usize, every: usize, ticks: Vec<Tick>) -> ShownScale {
        let lattice = self.field.lattice;
        let mut shown = ShownScale { ticks: vec![false; count], every };
        for Tick { number, row, sides } in ticks {
            shown.ticks[number] = true;
            for side in sides.into_iter().filter(|side| !side.is_empty()) {
                side.iter().for_each(|dot| self.field.put(*dot, Owner::Tick(scale, row)));
                self.placed.runs[row].push(side.into_iter().map(|dot| lattice.to_mm(dot)).collect());
            }
        }
        shown
    }

    /// A tick in dots, on those sides that have room; none if no side has.
    fn tick(&self, number: usize, tick: &TickMark, shortest: f32, sides: [bool; 2]) -> Option<Tick> {
        let lattice = self.field.lattice;
        let is_own = |dot: RowDot| {
            let aside = (lattice.to_mm(dot.at) - tick.at).dot(tick.along).abs();
            aside <= ASIDE * self.params.pitch && self.along(dot).dot(tick.along).abs() >= ALONG
        };
        let foot = self.nearest(tick.at, is_own)?;
        // behind a point it goes on from that
        let is_at = |point: &DrawnPoint| lattice.steps(point.middle, foot.at) <= point.radius + 0.5;
        let behind = self.points.iter().position(is_at);
        let point = behind.map(|number| &self.points[number]);
        let from = point.map_or(foot.at, |point| point.middle);
        let mut drawn = Tick { number, row: foot.row, sides: [Vec::new(), Vec::new()] };
        let mut is_covered = false;
        for (side, end) in tick.ends.iter().enumerate() {
            let Some(end) = end.filter(|_| sides[side]) else { continue };
            let Some(way) = (end - tick.at).try_normalize() else { continue };
            let count = self.dots_of((end - tick.at).length(), shortest);
            let mut dots = lattice.outward(from, way, 2 * count + 2);
            dots.truncate(count + self.second_row(foot, way));
            let own = |dot: GridPoint| self.field.around(dot, 1.0).any(|(_, other, _)| lattice.are_one(dot, other));
            let is_inside =
                |dot: GridPoint| point.is_some_and(|point| lattice.steps(point.middle, dot) <= point.radius + 0.25);
            dots.retain(|dot| !own(*dot) && !is_inside(*dot));
            if dots.is_empty() {
                is_covered |= point.is_some();
            } else if dots.iter().all(|dot| self.is_free(*dot, (foot, Some(way)), count, behind)) {
                drawn.sides[side] = dots;
            }
        }
        (is_covered || drawn.sides.iter().any(|side| !side.is_empty())).then_some(drawn)
    }

    /// How many dots a side of a tick has: all of a scale are longer by the same.
    fn dots_of(&self, length: f32, shortest: f32) -> usize {
        let pitch = self.params.pitch;
        let least = TICK_DOTS.max((TICK / pitch).round() as usize);
        let more = (least as f32 * pitch - shortest).max(0.0);
        let longer = usize::from(length >= LONGER * shortest);
        (((length + more) / pitch).round() as usize).max(least + longer)
    }

    /// How many dots a second row puts before the free ones of a tick that leads this way from a dot of its row.
    fn second_row(&self, foot: RowDot, way: MmVector) -> usize {
        let row = foot.row;
        if !self.rows[row].is_heavy || self.placed.has_points[row] {
            return 0;
        }
        // it lies to the right of a line as it runs, and inside a ring
        let along = self.along(foot);
        let right = right_of(along).dot(way) > 0.0;
        let turn = self.rows[row].closed && area_of(&self.rows[row].dots) < 0.0;
        usize::from(right != turn)
    }

    /// Whether a dot of a tick of so many dots, which stands on its foot, or behind the point of this number there, is
    /// apart from all others. Which way it leads may be given: what ends on the other side of its row, as the side of a
    /// bar, does not count then.
    fn is_free(
        &self,
        dot: GridPoint,
        (foot, way): (RowDot, Option<MmVector>),
        count: usize,
        behind: Option<usize>,
    ) -> bool {
        let lattice = self.field.lattice;
        if !lattice.holds(dot) {
            return false;
        }
        let gap = self.params.line_gap as f32;
        let mut others = self.points.iter().enumerate().filter(|(number, _)| Some(*number) != behind);
        if others.any(|(_, point)| self.is_close_to(dot, point)) {
            return false;
        }
        let own = behind.map(|number| &self.points[number]);
        // the row beside its own place is as near as the tick is long
        let beside = 2 * (count + self.params.line_gap as usize) + 4;
        let row = &self.rows[foot.row];
        let ahead = |other: GridPoint, way| (lattice.to_mm(other) - lattice.to_mm(foot.at)).dot(way);
        let is_behind = |other: GridPoint| way.is_some_and(|way| ahead(other, way) < ON_ROW * self.params.pitch);
        let mut near = self.field.around(dot, gap + 1.0).filter(|(_, other, _)| lattice.are_near(dot, *other, gap));
        near.all(|(_, other, owner)| match owner {
            Owner::Row(of, number) if of == foot.row => {
                let apart = number.abs_diff(foot.number);
                apart <= beside || row.closed && row.dots.len() - apart <= beside
            }
            // what leads to the point behind which it is
            Owner::Row(..) => {
                is_behind(other) || own.is_some_and(|own| lattice.steps(own.middle, other) <= own.radius + gap)
            }
            Owner::Tick(..) => !self.are_close(dot, other),
        })
    }

    /// Whether ticks are apart from one another.
    fn are_apart(&self, ticks: &[Tick]) -> bool {
        let mut own = MarkField::new(self.field.lattice);
        ticks.iter().enumerate().all(|(number, tick)| {
            let dots = || tick.sides.iter().flatten();
            let is_near =
                |dot: &GridPoint| own.around(*dot, self.reach()).any(|(_, other, _)| self.are_close(*dot, other));
            let apart = !dots().any(is_near);
            let dots: Vec<GridPoint> = dots().copied().collect();
            dots.into_iter().for_each(|dot| own.put(dot, Owner::Tick(0, number)));
            apart
        })
    }
}

fn row_of(owner: Owner) -> Option<usize> {
    match owner {
        Owner::Row(row, _) => Some(row),
        Owner::Tick(..) => None,
    }
}

/// Twice the area of a ring; above 0 if it runs clockwise as a reader sees it.
fn area_of(ring: &[MmPoint]) -> f32 {
    let Some(&first) = ring.first() else { return 0.0 };
    ring.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum()
}
