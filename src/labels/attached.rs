//! How a label in a place is joined to what it names: it stands beside that, or a leader line leads there.

use super::placed::{Attachment, Wanted};
use super::room::Room;
use super::surroundings::{AT_END, NEAR, Surroundings};
use crate::geom::polygon::{circle_points, corners, distance_to_box};
use crate::units::{MmPoint, MmRect, MmVector};

/// Blank between a label and its own leader line, mm.
pub(super) const BEFORE_LEADER: f32 = 3.0;
/// A leader line that begins at a corner leads away from its label if it begins at least this far from the label, as a
/// share of that blank, and no nearer than `Params::least_before_leader`: another runs along it.
const LEAVES_LABEL: f32 = 0.7;
/// Least distance to what a leader line leads to, mm: less than half of it would be the line itself, which is felt as
/// a dot then.
const SHORTEST_LEADER: f32 = 2.0 * BEFORE_LEADER;

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
pub(super) fn attachment(label: &Wanted, place: MmRect, around: &Surroundings<'_>) -> Option<Attachment> {
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
    // ways are looked at last: of the corners behind the label none leads away from it
    let segments = starts
        .filter_map(|from| Some((from, leader_from(from, tip, around.leader_off())?)))
        .filter(|(_, [from, _])| distance_to_box(*from, place) >= least)
        .filter(|(from, _)| !room.is_parted(*from, tip, end))
        .filter(|(from, _)| side.is_none_or(|side| !room.is_parted_from_text(*from, side, 0.0)))
        .map(|(_, segment)| segment);
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

/// What it costs, mm, that a leader line ends where borders of several shapes meet and there is room elsewhere.
pub(super) fn cost_of_corner(attachment: Attachment, around: &Surroundings<'_>) -> f32 {
    match attachment {
        Attachment::Leader([_, to]) if to != around.tip && is_at_corner(to, WELL_OFF_CORNERS, around.room) => {
            NEAR_CORNER
        }
        _ => 0.0,
    }
}
