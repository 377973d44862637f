//! Places where a label could lie, the best first.

use super::attached::{BEFORE_LEADER, attachment, cost_of_corner, is_at_kept_leader};
use super::cost::cost;
use super::forms::Form;
use super::interrupted::SCRAP;
use super::placed::{Attachment, Params, PlacedAs, Wanted};
use super::room::Room;
use super::scale;
use super::spacing::Spacing;
use super::surroundings::{Surroundings, TO_LEADER};
use crate::geom::polygon::{corners, distance_to_box};
use crate::geom::segment_distance;
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect, MmVector};

/// A place for a label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Candidate {
    /// Which of its forms it has.
    pub(super) form: usize,
    /// The box around its dots.
    pub(super) place: MmRect,
    pub(super) attachment: Attachment,
    pub(super) cost: f32,
    pub(super) stands: PlacedAs,
    /// Where the leader line begins that the drawing has to what it names, if that is on the page.
    kept_leader: Option<MmPoint>,
    /// Whether it blanks the texture by which the shape of its text is told from those beside it.
    blanks: bool,
}

/// Furthest that a label lies from what it names, mm: the longest lead line that BANA is quoted with is 37.5 mm.
const FAR: f32 = 37.5;
/// How much further than the line by which the drawing leads to it a label may lie where that is longer, mm.
const BEYOND: f32 = 10.0;
/// Least blank between a label and the point that it names, mm; lines around it are kept clear by themselves.
const FROM_POINT: f32 = 2.0;
/// The beginning of a leader line is so much nearer to its own label than to another, mm: a dot of braille or two.
const CLEARLY_NEARER: f32 = 2.0;
/// What rounding may add to a distance, mm.
const EPSILON_MM: f32 = 0.01;
/// Least blank between two leader lines, mm: nearer a finger slips from one to the other. As much as the blank that
/// tells a leader line from its own label.
const BETWEEN_LEADERS: f32 = BEFORE_LEADER;
/// Most places that are kept for a form, and how far apart they are, mm: enough to choose from, and not all in one
/// spot. Of those with a leader line some are kept beside, further apart: where others take all places near by, these
/// are left.
const MOST: usize = 48;
const MOST_LED: usize = 36;
const APART_LED: f32 = 8.0;
const APART: f32 = 4.0;

impl Candidate {
    /// One that is placed together with its row.
    pub(super) fn of_row(form: usize, place: MmRect, attachment: Attachment, cost: f32, stands: PlacedAs) -> Self {
        Self { form, place, attachment, cost, stands, kept_leader: None, blanks: false }
    }

    /// The line that leads from it to what it names, if it does not stand beside that.
    pub(super) fn leader(&self) -> Option<[MmPoint; 2]> {
        self.attachment.leader()
    }

    /// Whether it is placed with others, in a row or at one, and stays there.
    pub(super) fn is_fixed(&self) -> bool {
        self.stands != PlacedAs::Alone
    }

    /// Whether two labels cannot both be there; leader lines lie up to `off` mm off their straight segment. Without a
    /// room they may stand near to each other at one height, as two numbers do: each begins with its sign.
    pub(super) fn conflicts(&self, other: &Self, spacing: Spacing, off: f32, room: Option<&Room>) -> bool {
        let is_read_on = || room.is_some_and(|room| self.is_read_on(other, spacing, room));
        let is_wrong = || self.takes_leader(other) || other.takes_leader(self) || is_read_on();
        !(self.is_fixed() && other.is_fixed()) && (self.is_too_near(other, spacing, off) || is_wrong())
    }

    /// Whether two labels stand at one height so near to each other that a finger reads on from one to the other: they
    /// are then one text. A line between them parts them, but no gridline does.
    pub(super) fn is_read_on(&self, other: &Self, spacing: Spacing, room: &Room) -> bool {
        let (low, high) = (self.place.min.max(other.place.min), self.place.max.min(other.place.max));
        let gap = low.x - high.x;
        let is_parted = || {
            let y = 0.5 * (low.y + high.y);
            room.is_parted_from_text(MmPoint::new(high.x, y), MmPoint::new(low.x, y), 0.0)
        };
        low.y < high.y && gap < spacing.in_line && !is_parted()
    }

    /// Whether a leader line of the drawing begins nearer to this label than to the other, whose it is, or about as
    /// near: it would be taken for that of this one.
    fn takes_leader(&self, other: &Self) -> bool {
        let own = other.kept_leader.filter(|_| other.leader().is_none());
        own.is_some_and(|at| distance_to_box(at, self.place) < distance_to_box(at, other.place) + CLEARLY_NEARER)
    }

    /// The box around it and its leader line.
    fn extent(&self) -> MmRect {
        self.leader().map_or(self.place, |[a, b]| MmRect::from_points([self.place.min, self.place.max, a, b]))
    }

    /// Whether labels or their leader lines have less blank between them than this.
    pub(super) fn is_too_near(&self, other: &Self, spacing: Spacing, off: f32) -> bool {
        let Spacing { aside, above, .. } = spacing;
        // nearly all pairs are far apart, and their distances need not be known
        let far = aside.max(above).max(TO_LEADER + off).max(BETWEEN_LEADERS) + EPSILON_MM;
        if !self.extent().inflate(far, far).intersects(&other.extent()) {
            return false;
        }
        let near = self.place.inflate(aside, above).intersects(&other.place);
        let over = |leader: Option<[MmPoint; 2]>, place: MmRect| {
            leader.is_some_and(|[a, b]| {
                let far = TO_LEADER + off + EPSILON_MM;
                if !MmRect::from_points([a, b]).inflate(far, far).intersects(&place) {
                    return false;
                }
                let corners = corners(place);
                let to_side = |i: usize| segment_distance((a, b), (corners[i], corners[(i + 1) % 4]));
                place.contains(a) || place.contains(b) || (0..4).any(|side| to_side(side) < TO_LEADER + off)
            })
        };
        let leaders = || match (self.leader(), other.leader()) {
            (Some([a, b]), Some([c, d])) => segment_distance((a, b), (c, d)) < BETWEEN_LEADERS,
            _ => false,
        };
        near || over(self.leader(), other.place) || over(other.leader(), self.place) || leaders()
    }
}

/// Up to so many labels are looked for in every step: a sheet of A3 has no room for more. The places of one label take
/// 25 ms of one core at most, all of them no more than four seconds.
const MOST_IN_FINE_STEPS: usize = 150;

/// In which steps places of so many labels are looked for, mm: in twice the step there are a quarter as many.
pub(super) fn step(labels: usize, params: &Params) -> f32 {
    if labels > MOST_IN_FINE_STEPS { 2.0 * params.step } else { params.step }
}

/// Places for a label in its forms, looked for in steps of so many mm.
pub(super) fn of(
    label: &Wanted,
    forms: &[Form],
    around: &Surroundings<'_>,
    cells: &CellGrid<'_>,
    step: f32,
) -> Vec<Candidate> {
    let mut candidates: Vec<Candidate> = forms
        .iter()
        .enumerate()
        .filter(|(_, form)| form.kind.is_of_one())
        .flat_map(|(number, form)| apart(of_form(label, (number, form), around, cells, step)))
        .collect();
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates
}

/// All free places of a form within reach.
fn of_form(
    label: &Wanted,
    (number, form): (usize, &Form),
    around: &Surroundings<'_>,
    cells: &CellGrid<'_>,
    step: f32,
) -> Vec<Candidate> {
    let Surroundings { room, params, .. } = around;
    let size = form.extent(cells);
    let anchor = around.anchor;
    // one that is longer than all the room is not looked for: the work would grow with its length
    if size.x > params.area.width() || size.y > params.area.height() {
        return Vec::new();
    }
    // steps from the place in the middle of the anchor, so that it is among them
    let middle = anchor - size * 0.5;
    let steps = |half: f32| (((half + reach(label)) / step).ceil()) as i32;
    let (across, down) = (steps(0.5 * size.x), steps(0.5 * size.y));
    let mut found = Vec::new();
    for y in -down..=down {
        for x in -across..=across {
            let corner = middle + MmVector::new(x as f32, y as f32) * step;
            let place = cells.snapped(MmRect::new(corner, corner + size));
            if params.holds(&place) && room.is_free(place) {
                found.extend(candidate(label, number, form, place, around));
            }
        }
    }
    found
}

/// How far a label may lie from what it names, mm.
fn reach(label: &Wanted) -> f32 {
    label.lost_leader.map_or(FAR, |from| FAR.max((from - label.anchor.center()).length() + BEYOND))
}

/// A label in a place; none if it cannot be joined to what it names from there.
fn candidate(
    label: &Wanted,
    number: usize,
    form: &Form,
    place: MmRect,
    around: &Surroundings<'_>,
) -> Option<Candidate> {
    let gap = distance_to_box(around.anchor, place);
    if gap > reach(label) || around.is_point() && gap < FROM_POINT || !around.is_in_cell_or_open(place) {
        return None;
    }
    let attachment = if label.is_nameless { Attachment::Beside } else { attachment(label, place, around)? };
    if attachment == Attachment::Beside && !is_at_kept_leader(label, place) {
        return None;
    }
    // beside another place of its axis a number says something else, and its leader line would be felt as a tick
    if around.scale.is_some() && !(attachment == Attachment::Beside && around.is_at_tick(place)) {
        return None;
    }
    // and at the end of a gridline one that is of no axis is taken for that of the line
    let is_other_number = || around.scale.is_none() && scale::is_number(&label.text);
    if is_other_number() && around.room.ends_gridline(place, around.params.clearance, SCRAP) {
        return None;
    }
    let cost = cost(form.kind.cost(), label, place, attachment, around) + cost_of_corner(attachment, around);
    let (stands, kept_leader) = (PlacedAs::Alone, label.kept_leader);
    let blank = around.params.texture_clearance;
    let blanks = around.is_blanked_by(around.room.glyphs(place.inflate(blank, blank)));
    Some(Candidate { form: number, place, attachment, cost, stands, kept_leader, blanks })
}

/// What it costs to blank the texture of a sector of a pie: more than any place outside within reach, also beside the
/// text, where a mm counts three times, and less than an abbreviation.
const BLANKED: f32 = 200.0;

/// The same candidates with what it costs to blank such a texture; none where no candidate does.
pub(super) fn sparing(candidates: &[Vec<Candidate>]) -> Option<Vec<Vec<Candidate>>> {
    if !candidates.iter().flatten().any(|candidate| candidate.blanks) {
        return None;
    }
    let mut sparing = candidates.to_vec();
    for of in &mut sparing {
        of.iter_mut().filter(|candidate| candidate.blanks).for_each(|candidate| candidate.cost += BLANKED);
        of.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    }
    Some(sparing)
}

/// A better place of a label near to the one that it has, by the steps between those that were kept; none if there is
/// none that is `free` of other labels.
pub(super) fn better(
    label: &Wanted,
    form: &Form,
    now: &Candidate,
    around: &Surroundings<'_>,
    cells: &CellGrid<'_>,
    free: impl Fn(&Candidate) -> bool,
) -> Option<Candidate> {
    let step = around.params.step;
    let steps = (APART / step).ceil() as i32;
    let mut best: Option<Candidate> = None;
    for (x, y) in (-steps..=steps).flat_map(|y| (-steps..=steps).map(move |x| (x, y))) {
        let place = cells.snapped(now.place.translate(MmVector::new(x as f32, y as f32) * step));
        if !around.params.holds(&place) || !around.room.is_free(place) {
            continue;
        }
        let least = best.as_ref().map_or(now.cost - WORTH_A_MOVE, |best| best.cost);
        let found = candidate(label, now.form, form, place, around);
        let is_better = |found: &Candidate| found.cost < least && (now.blanks || !found.blanks) && free(found);
        if let Some(found) = found.filter(is_better) {
            best = Some(found);
        }
    }
    best
}

/// By how much a place has to be better for a label to be moved to it, mm.
const WORTH_A_MOVE: f32 = 0.1;

/// The best of the places, some distance apart.
fn apart(mut all: Vec<Candidate>) -> Vec<Candidate> {
    all.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let (mut kept, mut led): (Vec<Candidate>, usize) = (Vec::new(), 0);
    for candidate in all {
        let is_led = candidate.leader().is_some();
        // far from what they name another row is more of a choice than the next place in it
        let is_more = kept.len() >= MOST;
        let least = if is_more { APART_LED } else { APART };
        let is_new = |other: &Candidate| (other.place.min - candidate.place.min).length() >= least;
        if (!is_more || is_led && led < MOST_LED) && kept.iter().all(is_new) {
            led += usize::from(is_led);
            kept.push(candidate);
        }
    }
    kept
}

#[cfg(test)]
mod tests;
