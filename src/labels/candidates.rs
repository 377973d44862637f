//! Places where a label could lie, the best first.

use super::cost::cost;
use super::forms::Form;
use super::interrupted::SCRAP;
use super::placed::{Attachment, Params, PlacedAs, Wanted};
use super::room::Room;
use super::scale;
use super::spacing::Spacing;
use super::surroundings::{AT_END, NEAR, Surroundings, TO_LEADER};
use crate::geom::polygon::{circle_points, corners, distance_to_box};
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
/// Blank between a label and its own leader line, mm.
pub(super) const BEFORE_LEADER: f32 = 3.0;
/// A leader line that begins at a corner leads away from its label if it begins at least this far from the label, as a
/// share of that blank, and no nearer than [`Params::least_before_leader`]: another runs along it.
const LEAVES_LABEL: f32 = 0.7;
/// Least blank between a label and the point that it names, mm; lines around it are kept clear by themselves.
const FROM_POINT: f32 = 2.0;
/// The beginning of a leader line is so much nearer to its own label than to another, mm: a dot of braille or two.
const CLEARLY_NEARER: f32 = 2.0;
/// What rounding may add to a distance, mm.
const EPSILON_MM: f32 = 0.01;
/// Least distance to what a leader line leads to, mm: less than half of it would be the line itself, which is felt as
/// a dot then.
const SHORTEST_LEADER: f32 = 2.0 * BEFORE_LEADER;
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
    let near_corner = match attachment {
        Attachment::Leader([_, to]) if to != around.tip && is_at_corner(to, WELL_OFF_CORNERS, around.room) => {
            NEAR_CORNER
        }
        _ => 0.0,
    };
    let cost = cost(form.kind.cost(), label, place, attachment, around) + near_corner;
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

/// A finger that comes from a leader line of the drawing finds its label no farther from where it begins, mm: as the
/// check takes such a line for that of the label.
pub(crate) const FROM_KEPT_LEADER: f32 = 8.0;

/// Whether a label in a place is found from where its leader line in the drawing begins, if it has one on the page.
pub(super) fn is_at_kept_leader(label: &Wanted, place: MmRect) -> bool {
    label.kept_leader.is_none_or(|from| distance_to_box(from, place) <= FROM_KEPT_LEADER)
}

/// Whether a label in a place, without a leader line, says to what the leader line leads that the drawing has and the
/// page lacks. At a line it stands right beside the tip, where it has no room for a leader line of its own, and in no
/// shape, of which it would be the name. A tip in the blank names the area around it.
pub(super) fn is_at_lost_tip(label: &Wanted, place: MmRect, around: &Surroundings<'_>) -> bool {
    let &Surroundings { room, anchor, .. } = around;
    let is_at_line = || room.line_beside(MmRect::new(anchor, anchor), AT_LOST_TIP, AT_LOST_TIP).is_some();
    let is_right_at = || distance_to_box(anchor, place) < SHORTEST_LEADER + around.leader_off();
    label.lost_leader.is_none() || !is_at_line() || is_right_at() && around.is_open(place)
}

/// A line so near to such a tip, mm, is what it leads to, or beside that: less than the check of a page takes for the
/// end of a leader line, as lines of dots lie off theirs.
const AT_LOST_TIP: f32 = 5.0;

/// How a label in a place is joined to what it names. Readers take a label for what is on its own side of a line,
/// unless a leader line crosses it, and for the nearest anchor.
fn attachment(label: &Wanted, place: MmRect, around: &Surroundings<'_>) -> Option<Attachment> {
    let &Surroundings { room, params, beside, anchor, .. } = around;
    let is_point = around.is_point();
    let nearest = anchor.clamp(place.min, place.max);
    let is_open = || {
        let parted = if is_point { Room::is_parted } else { Room::is_parted_from_text };
        !parted(room, nearest, anchor, beside)
    };
    if around.is_sentence && is_open() && around.is_own(place) {
        return Some(Attachment::Beside);
    }
    if around.is_in_room() && distance_to_box(anchor, place) <= IN_ROOM && is_open() && around.is_own(place) {
        return Some(Attachment::Beside);
    }
    let is_beside = match &around.angle {
        Some(angle) => around.is_in_angle(angle, nearest, place),
        None => {
            let is_near = distance_to_box(anchor, place) <= NEAR && is_open() && around.is_own(place);
            is_near && around.is_before_own(place) || !is_point && is_beside_outline(nearest, place, around)
        }
    };
    if is_beside && is_at_lost_tip(label, place, around) {
        return Some(Attachment::Beside);
    }
    // in the blank a leader line would lead to the place where print stood, such as a heading, and name that
    if label.lost_leader.is_none() && around.names_blank() {
        return None;
    }
    // from beyond the legs of an angle a leader line crosses one of them, though it need not lead far beyond
    if around.angle.is_none_or(|angle| angle.holds_box(place)) {
        let is_of_one =
            |to: MmPoint| !around.is_shut_in() || label.lost_leader.is_some() || !is_at_corner(to, OFF_CORNERS, room);
        let clear = clear_leader(place, around)
            .filter(|segment| is_of_one(segment[1]) && !around.is_in_shape_of_other(place, *segment));
        if let Some(segment) = clear.or_else(|| to_outline(nearest, place, around).filter(|_| !is_point)) {
            return Some(Attachment::Leader(segment));
        }
    }
    if is_open() || !params.may_cross && !around.leads_into_shape(label, nearest) {
        return None;
    }
    let segment = leader_from(nearest, around.tip, around.leader_off())?;
    // as the drawing leads to it, it may cross lines, and still names nothing else
    let is_clear =
        around.is_clear_of_blocked(segment) && (label.lost_leader.is_none() || around.leads_to_own(place, segment));
    let is_along = || label.lost_leader.is_none() && room.along(segment[0], segment[1], around.end) > MOST_ALONG;
    // across the lines of a table it would come into other cells first; within another shape, such as the next sector
    // of a pie, a label is taken for the name of that
    let is_in_other = || label.lost_leader.is_none() && around.is_shut_in() && !around.is_open(place);
    (is_clear && around.cell.is_none() && !is_in_other() && !is_along()).then_some(Attachment::LeaderAcross(segment))
}

/// So far from its text, mm, the name of a room needs no leader line where no wall and no furniture lies between: it
/// stands in the room. What is farther may lie beyond a door. Chosen by us.
const IN_ROOM: f32 = 25.0;

/// Of a leader line across others that the drawing has not, most that lies near to lines, mm: across two lines. One
/// that goes along them, or through a small shape, is felt as a part of that.
const MOST_ALONG: f32 = 12.0;

/// A leader line from a point of a label to its tip, whose marks lie up to `off` mm off it; none if it would be too
/// short to be felt as a line.
fn leader_from(from: MmPoint, tip: MmPoint, off: f32) -> Option<[MmPoint; 2]> {
    let chord = tip - from;
    (chord.length() > SHORTEST_LEADER + off).then(|| [from + chord.normalize() * (BEFORE_LEADER + off), tip])
}

/// The leader line of a label that crosses no line: from the nearest point of the label, or from a corner where lines
/// lie between.
fn clear_leader(place: MmRect, around: &Surroundings<'_>) -> Option<[MmPoint; 2]> {
    let &Surroundings { room, end, tip, .. } = around;
    // most places among many labels are beside what another names: the way need not be looked at then
    if !around.is_off_others(place) {
        return None;
    }
    let side = around.own_side();
    let least = (LEAVES_LABEL * BEFORE_LEADER).max(around.params.least_before_leader) + around.leader_off();
    let starts = std::iter::once(tip.clamp(place.min, place.max)).chain(corners(place));
    let segments = starts
        .filter(|from| !room.is_parted(*from, tip, end))
        .filter(|from| side.is_none_or(|side| !room.is_parted_from_text(*from, side, 0.0)))
        .filter_map(|from| leader_from(from, tip, around.leader_off()))
        .filter(|[from, _]| distance_to_box(*from, place) >= least);
    segments
        .into_iter()
        .find(|&[from, to]| room.is_free_segment(from, to, end) && around.leads_to_own(place, [from, to]))
}

/// Whether a label stands in the open right beside the outline of the shape in which the text stands that it stands
/// for, such as a box of a flow chart or a sector of a pie: level with the text, or above or below it. In an area of
/// another colour, such as the sea around a land, it would be the name of that.
fn is_beside_outline(nearest: MmPoint, place: MmRect, around: &Surroundings<'_>) -> bool {
    let chord = around.anchor - nearest;
    let is_straight = chord.x == 0.0 || chord.y == 0.0;
    let outline = || around.room.only_line(nearest, around.anchor, around.params.widest_outline);
    let leads_into_one = |blank: f32| is_outline_of_one(nearest + chord.normalize() * blank, chord.normalize(), around);
    // one of which the middle lies beside the next shape is taken for the name of that
    let has_middle = || around.room.only_line(place.center(), around.anchor, around.params.widest_outline).is_some();
    is_straight
        && around.is_in_blank(place)
        && outline().is_some_and(|blank| blank < SHORTEST_LEADER && leads_into_one(blank))
        && has_middle()
        && around.is_own(place)
        && (around.is_open(place) && !around.is_before_others(place, chord))
}

/// The leader line of a label in the open to such an outline: it ends there, and crosses nothing.
fn to_outline(nearest: MmPoint, place: MmRect, around: &Surroundings<'_>) -> Option<[MmPoint; 2]> {
    let &Surroundings { room, anchor, .. } = around;
    // from the area beside, such as the sea around a land, it would say where the name of that belongs
    if around.is_shut_in() && !around.is_in_blank(place) {
        return None;
    }
    let chord = anchor - nearest;
    let direction = (chord.length() > 0.0).then(|| chord.normalize())?;
    let off = around.leader_off();
    let blank = room
        .only_line(nearest, anchor, around.params.widest_outline)
        .filter(|blank| *blank >= SHORTEST_LEADER + off)?;
    let (from, outline) = (nearest + direction * (BEFORE_LEADER + off), nearest + direction * blank);
    // at a gridline it would be felt as a tick of that
    if room.is_gridline(outline) {
        return None;
    }
    // short of the outline nothing else is near; within another shape it would name that one
    let end = (outline - from).length().min(AT_END);
    let is_clear = room.is_free_segment(from, outline, end)
        && around.leads_to_own(place, [from, outline])
        && !is_at_corner(outline, OFF_CORNERS, room);
    (is_clear && is_outline_of_one(outline, direction, around) && around.is_open(place)).then_some([from, outline])
}

/// Whether a line that a way in this direction meets first is that of what the text names: of a text that lines shut in
/// it is, but where the border to the next shape meets it nobody can tell which of the two is meant. Of another text it
/// is the line beside that; one that lies between is another thing, such as the next route of a map.
fn is_outline_of_one(outline: MmPoint, direction: MmVector, around: &Surroundings<'_>) -> bool {
    if !around.is_shut_in() {
        return (outline - around.tip).length() <= BESIDE_TIP;
    }
    // what has several names in it, such as the towns of a country, is not what one of them names
    if !around.is_alone_in_shape() {
        return false;
    }
    let inside = outline + direction * INSIDE_OUTLINE;
    let aside = MmVector::new(-direction.y, direction.x) * OFF_BORDERS;
    [aside, -aside].into_iter().all(|to_side| !around.room.is_parted(inside, inside + to_side, 0.0))
}

/// Whether borders of several shapes meet so near to a place on an outline.
fn is_at_corner(outline: MmPoint, near: f32, room: &Room) -> bool {
    let is_met: Vec<bool> = circle_points(outline, near, RAYS).map(|at| room.is_ink(at)).collect();
    let lines = is_met.iter().zip(is_met.iter().cycle().skip(1)).filter(|(is_met, next)| !**is_met && **next).count();
    lines > 2
}

/// So far inside of the outline at which a leader line ends there is no other line for so much on either side, mm: a
/// finger that crosses the outline there is in the shape that is named, and not at the border to the next.
const INSIDE_OUTLINE: f32 = 4.5;
const OFF_BORDERS: f32 = 3.0;
/// At the end of such a leader line no more than the outline is so near, mm, looked at in so many directions: at a
/// corner of several shapes it would lead to all of them.
const OFF_CORNERS: f32 = 3.5;
const RAYS: usize = 32;
/// Where there is room it ends further off, mm: half a fingertip. What an end that is nearer costs beside that, mm.
const WELL_OFF_CORNERS: f32 = 6.0;
const NEAR_CORNER: f32 = 6.0;
/// The line beside a text is met so near to where its leader line would end, mm.
const BESIDE_TIP: f32 = 6.0;

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
