//! What lies around what a label names, by which its places are judged.

use super::angles::{self, Angle};
use super::groups::GroupDirection;
use super::placed::{Params, Wanted};
use super::room::{FURTHEST_OUTLINE, Room};
use super::scale;
use super::sentence;
use super::shape::Shape;
use crate::geom::polygon::{corners, distance_to_box};
use crate::geom::{nearest_on_segment, segment_distance};
use crate::units::{MmPoint, MmRect, MmVector};

/// From this distance on a label has a leader line, mm. BANA is quoted with lead lines for labels that do not lie
/// beside what they name; chosen by us, because two cells on a line are a fingertip's width apart.
pub const NEAR: f32 = 12.0;
/// A leader line may come near to lines where it ends, over this length, mm.
pub(super) const AT_END: f32 = 4.0;
/// Blank between a leader line and what another label names, mm: nearer it would lead there.
const TO_OTHERS: f32 = 4.0;
/// Blank between a label and the leader line of another, mm, beside what that lies off its straight segment.
pub(super) const TO_LEADER: f32 = 3.5;
/// A text that stands so near to a line is led to that, mm: a leader line that ends in the blank where print stood
/// names nothing. Further away it names the area that it stands in.
const BESIDE_LINE: f32 = 6.0;
/// How far from a text a line ends that leads to what the text names, mm: print stands up to 4 mm beside it.
const BESIDE_TEXT: f32 = 5.0;
/// A ring that reaches no further than this around a point is what the point names, mm: then a label beside it needs
/// no leader line either.
const LARGEST_RING: f32 = 9.0;
/// How far the ink of such a ring reaches beyond its inner edge, mm: the widest line.
pub(super) const AROUND_RING: f32 = 2.0;
/// Nearer to the place where two lines meet, mm, a point names that and no angle between them.
const AT_VERTEX: f32 = 6.0;
/// Breadth of the arc of an angle across it, at most, mm: twice the widest line, for a slanted way.
const THICKEST_ARC: f32 = 3.0;
/// Farthest that an arc lies from where the legs of its angle meet, mm: lines beyond are others.
const FARTHEST_ARC: f32 = 25.0;
/// A shape that reaches no further than this around the end of a leader line is what that names, mm: broader than a
/// fingertip, so that the end is found in it. Chosen by us.
const FURTHEST_SIDE: f32 = 20.0;
/// So far from its middle one is beside a line, mm: more than half of the widest.
const OFF_LINE: f32 = 2.5;
/// So far behind the side of a line is its other side, mm: more than the widest.
const BEHIND_LINE: f32 = 4.0;
/// Places along the side of a label from which the shapes before it are looked for.
const PLACES_OF_SIDE: u32 = 9;
/// Print in a cell of a table reaches beyond its lines by at most this, mm: lines are moved, and are broader.
const AROUND_CELL: f32 = 2.0;
/// Most of the texture of a sector that a label may take: what leaves less than two thirds of one is told of.
const MOST_OF_TEXTURE: f32 = 1.0 / 3.0;
/// The same of dots, where what it leaves in strips and short rows beside it goes as well: seen on pies of an Index.
const MOST_OF_DOTS: f32 = 0.2;
/// Points nearer than this are one, mm: a point that is given seldom lies exactly in the middle of its ring.
const SAME: f32 = 3.0;
/// A point is at the lower side of a shape up to this far below its line, mm: a point in a picture is seldom given
/// more exactly.
const BELOW: f32 = 6.0;

/// Labels with what each names.
#[derive(Debug, Clone, Copy)]
pub(super) struct LabelsAt<'a> {
    pub(super) wanted: &'a [Wanted],
    /// As many: a point as an empty box, or the box of a text.
    pub(super) anchors: &'a [MmRect],
}

/// What a label names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Named {
    /// A point: one that is given, or a small ring that it stands beside as a text.
    Point {
        /// Whether a point that is given lies at the lower side of a shape, such as a bar of a chart.
        is_at_lower_side: bool,
    },
    /// Something at a text of the drawing, for which the label stands.
    Text {
        /// The side on which a line comes up to the text: -1 on the left, 1 on the right.
        line_on: Option<f32>,
        /// Where lines shut the text in: it may name what they surround.
        shut_in: Option<ShutIn>,
    },
}

/// A text that lines shut in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShutIn {
    /// The place on its own side from which the line is reached on which its leader line ends, where it is not that
    /// line's own.
    side: Option<MmPoint>,
    /// Whether it is seen from the text that they surround no plain shape, such as a box or a sector, but one in which
    /// things stand, or with corners that lead inwards: a room of a plan, or a land.
    is_room: bool,
}
/// A number of an upright axis stands no further above or below its tick or gridline, mm: the middle row of its dots is
/// then the nearest to that, and a finger that follows the line comes to it.
pub(super) const OFF_LEVEL: f32 = 1.25;
/// One of a level axis stands no further beside its tick, mm: half of a cell, so that a finger comes to one of its
/// cells, and not between two numbers.
pub(super) const OFF_TICK: f32 = 3.0;
/// What rounding may add to a distance, mm.
const EPSILON: f32 = 0.01;

/// What lies around what a label names.
pub(super) struct Surroundings<'a> {
    pub(super) room: &'a Room,
    pub(super) params: &'a Params,
    /// A leader line may come near to lines so far before its end, mm: there is what it leads to. None of a text in the
    /// blank, which names that.
    pub(super) end: f32,
    /// A line so near to what a label names does not part the label from it, mm: a point may lie on it. A text in the
    /// blank stands on one side of all lines.
    pub(super) beside: f32,
    /// The box of lines in which a text stands, such as a cell of a table: in another one it would say something else.
    pub(super) cell: Option<MmRect>,
    /// Whether that is one of several in a row or column: then the label stands in it or nowhere, as beside the table
    /// it would be the heading of a row or column.
    pub(super) is_in_table: bool,
    /// What kind of thing the label names.
    pub(super) names: Named,
    /// What the label names.
    pub(super) anchor: MmPoint,
    /// Where its leader line ends: there, or of a text that stands in the blank beside a line, on that.
    pub(super) tip: MmPoint,
    /// The angle between two lines that it names: a label on the other side of one of these names nothing.
    pub(super) angle: Option<Angle>,
    /// Of a text in the open, the shape before which it stands.
    pub(super) before: Option<Shape>,
    /// Of a number of an axis, whether that is a row or a column.
    pub(super) scale: Option<GroupDirection>,
    /// Whether it is a sentence in the open, such as an instruction: it names nothing, and has no leader line.
    pub(super) is_sentence: bool,
    /// Of a name in a shape that has others beside it, such as the sector of a pie, how many glyphs its texture has.
    pub(super) texture: Option<f32>,
    /// What labels beside it name.
    others: Vec<MmPoint>,
    /// Which of that are points.
    points: Vec<MmPoint>,
}

impl<'a> Surroundings<'a> {
    /// Of one of the labels; `longest` is the length of its longest form, mm.
    pub(super) fn of(number: usize, labels: LabelsAt<'_>, longest: f32, room: &'a Room, params: &'a Params) -> Self {
        let LabelsAt { wanted, anchors } = labels;
        let (label, anchor) = (&wanted[number], anchors[number]);
        let (at, is_point) = (anchor.center(), anchor.is_empty());
        // a label without a leader line, and what lies no further from it than what it names
        let reach = 2.0 * NEAR + longest;
        let others = anchors.iter().enumerate().filter(|(other, _)| *other != number).map(|(_, of)| of.center());
        // a ring without a name is one for which readers take the name beside it
        let rings = room.rings().iter().map(|ring| ring.at).filter(|ring| is_point && (*ring - at).length() > SAME);
        let near = |other: &MmPoint| (*other - at).length() < reach;
        let is_point_of_other = |(other, of): (usize, &MmRect)| (other != number && of.is_empty()).then(|| of.center());
        let points =
            anchors.iter().enumerate().filter_map(is_point_of_other).chain(rings.clone()).filter(near).collect();
        let mut others: Vec<MmPoint> = others.chain(rings).filter(near).collect();
        // of labels of one place one is enough
        others.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        others.dedup();
        let names_angle = label.lost_leader.is_none() && angles::is_name(&label.text);
        let angle = if names_angle { room.angle_around(at) } else { None };
        let angle = angle.filter(|angle| !is_point || (angle.vertex - at).length() > AT_VERTEX);
        // a small ring around a point, such as a town on a map, is what it names
        let ring = if is_point && angle.is_none() { room.shut_in(at, LARGEST_RING) } else { None };
        let tip = if is_point || angle.is_some() { at } else { line_beside(label, anchor, room).unwrap_or(at) };
        let end = ring.map_or(AT_END, |reach| AT_END.max(reach + AROUND_RING));
        let is_blank = |place: MmPoint| !is_point && !room.is_ink(place);
        let is_text = !is_point && label.lost_leader.is_none();
        let cell = if is_text { cell_of(anchor, wanted, room) } else { None };
        // the length of a side is none of the shape that it stands in; in a rectangle it may be the value of a bar
        let is_of_side = tip != at && cell.is_none() && scale::is_length(&label.text);
        let is_shut_in = is_text && !is_of_side && room.is_in_room(at, FURTHEST_OUTLINE);
        let is_room = is_shut_in && room.hides_a_part(at, FURTHEST_OUTLINE);
        let tip = if is_room && is_of_other(tip, anchor, &others, room) { at } else { tip };
        let side =
            (tip != at && is_blank(at)).then(|| tip + (at - tip).normalize() * (at - tip).length().min(OFF_LINE));
        let names = if is_point {
            Named::Point { is_at_lower_side: label.anchor.is_empty() && room.is_at_lower_side(at, BELOW, NEAR) }
        } else {
            let shut_in = is_shut_in.then_some(ShutIn { side, is_room });
            Named::Text { line_on: room.comes_up_to(anchor, BESIDE_TEXT), shut_in }
        };
        let is_in_open = is_text && !is_shut_in && cell.is_none() && angle.is_none() && label.kept_leader.is_none();
        Self {
            room,
            params,
            end: if is_blank(tip) { 0.0 } else { end },
            beside: if is_blank(at) { 0.0 } else { end },
            cell,
            is_in_table: false,
            names,
            anchor: at,
            tip,
            angle,
            before: None,
            scale: None,
            is_sentence: is_in_open && sentence::is_sentence(&label.text, tip != at),
            texture: None,
            others,
            points,
        }
    }

    /// Whether a label names a point.
    pub(super) fn is_point(&self) -> bool {
        matches!(self.names, Named::Point { .. })
    }

    /// Whether a label names a point at the lower side of a shape.
    pub(super) fn is_at_lower_side(&self) -> bool {
        self.names == Named::Point { is_at_lower_side: true }
    }

    /// Whether it stands for a text that lines shut in.
    pub(super) fn is_shut_in(&self) -> bool {
        matches!(self.names, Named::Text { shut_in: Some(_), .. })
    }

    /// Whether it stands for a text in the open that is no sentence, and neither in an angle nor at an axis.
    pub(super) fn is_text_in_open(&self) -> bool {
        let is_in_open = matches!(self.names, Named::Text { shut_in: None, .. }) && !self.is_sentence;
        is_in_open && self.angle.is_none() && self.cell.is_none() && self.scale.is_none()
    }

    /// Whether it stands for a text that lines shut in, but for the angles between lines, boxes and numbers of axes.
    pub(super) fn is_text_in_shape(&self) -> bool {
        let is_shut_in = matches!(self.names, Named::Text { shut_in: Some(_), .. });
        is_shut_in && self.angle.is_none() && self.cell.is_none() && self.scale.is_none()
    }

    /// Whether a label that takes so many glyphs leaves too little of the texture by which its shape is told from those
    /// beside it.
    pub(super) fn is_blanked_by(&self, glyphs: f32) -> bool {
        let most = if self.params.dot_pitch > 0.0 { MOST_OF_DOTS } else { MOST_OF_TEXTURE };
        self.texture.is_some_and(|all| glyphs > most * all)
    }

    /// The text stands before a shape and names that, also from a little further away than others name a line.
    pub(super) fn stands_before(&mut self, shape: Shape) {
        if self.tip == self.anchor {
            (self.tip, self.end) = (shape.outline, AT_END);
        }
        self.before = Some(shape);
    }

    /// Whether a label in a place stands before the shape before which its text stands, if there is one, and not before
    /// another.
    pub(super) fn is_before_own(&self, place: MmRect) -> bool {
        self.before.as_ref().is_none_or(|shape| shape.is_nearest(place))
    }

    /// Whether it stands for a text in the open that no line is beside.
    pub(super) fn names_blank(&self) -> bool {
        let is_in_open = matches!(self.names, Named::Text { shut_in: None, .. });
        is_in_open && self.angle.is_none() && self.tip == self.anchor && !self.room.is_ink(self.anchor)
    }

    /// Whether a line parts what this label names from what each other label near it names, on the straight way.
    pub(super) fn is_alone_in_shape(&self) -> bool {
        self.others.iter().all(|other| self.room.is_parted(self.anchor, *other, 0.0))
    }

    /// Of such a text, the place on its own side from which its leader line has to reach its end.
    pub(super) fn own_side(&self) -> Option<MmPoint> {
        match self.names {
            Named::Text { shut_in: Some(ShutIn { side, .. }), .. } => side,
            Named::Text { shut_in: None, .. } | Named::Point { .. } => None,
        }
    }

    /// Whether a label in a place stands in the angle that it names; `nearest` is its nearest point. The arc of the
    /// angle may lie between.
    pub(super) fn is_in_angle(&self, angle: &Angle, nearest: MmPoint, place: MmRect) -> bool {
        let is_beyond_arc = || {
            let to_arc = self.room.only_line(nearest, self.anchor, THICKEST_ARC);
            to_arc.is_some_and(|to_arc| {
                let arc = nearest + (self.anchor - nearest).normalize() * to_arc;
                to_arc <= NEAR && (arc - angle.vertex).length() <= FARTHEST_ARC
            })
        };
        let is_near = distance_to_box(self.anchor, place) <= NEAR;
        let is_open = || is_near && !self.room.is_parted(nearest, self.anchor, AT_END);
        angle.holds_box(place) && self.is_own(place) && (is_open() || is_beyond_arc())
    }

    /// Whether a place is not shut in by lines.
    pub(super) fn is_open(&self, place: MmRect) -> bool {
        !self.room.is_in_room(place.center(), FURTHEST_OUTLINE)
    }

    /// Whether a place in the open is on no area that could have a name of its own: neither it nor the blank around it
    /// lies on a texture, of which rows may be as far apart as a label is high.
    pub(super) fn is_in_blank(&self, place: MmRect) -> bool {
        let blank = self.params.texture_clearance;
        !self.params.has_coloured_ground && self.room.glyphs(place.inflate(blank, blank)) == 0.0
    }

    /// Whether the text stands in a room of a plan.
    pub(super) fn is_in_room(&self) -> bool {
        matches!(self.names, Named::Text { shut_in: Some(ShutIn { is_room: true, .. }), .. })
    }

    /// Whether a place lies in the open beyond the walls of the room in which the text stands.
    pub(super) fn is_out_of_room(&self, place: MmRect) -> bool {
        let is_of_room = self.is_in_room();
        let nearest = self.anchor.clamp(place.min, place.max);
        is_of_room && self.room.is_parted_from_text(nearest, self.anchor, self.beside) && self.is_open(place)
    }

    /// Whether a label that stands outside beside its shape, which is in this straight direction, reaches before other
    /// shapes by more than half as much as before its own: above two lands of a map it would be the name of both. The
    /// textures of a pie tell its sectors apart.
    pub(super) fn is_before_others(&self, place: MmRect, towards: MmVector) -> bool {
        let (low, high) = (place.min, place.max);
        let (from, to) = match (towards.x > 0.0, towards.x < 0.0, towards.y > 0.0) {
            (true, ..) => (MmPoint::new(high.x, low.y), high),
            (_, true, _) => (low, MmPoint::new(low.x, high.y)),
            (.., true) => (MmPoint::new(low.x, high.y), high),
            _ => (low, MmPoint::new(high.x, low.y)),
        };
        let Some(direction) = towards.try_normalize().filter(|_| self.texture.is_none()) else { return false };
        let places = (0..PLACES_OF_SIDE).map(|place| from.lerp(to, (place as f32 + 0.5) / PLACES_OF_SIDE as f32));
        let inside: Vec<MmPoint> =
            places.filter_map(|at| self.room.entry_of_shape(at, direction, [NEAR, BEHIND_LINE])).collect();
        let others = inside.iter().filter(|at| self.room.is_parted_from_text(**at, self.anchor, 0.0)).count();
        3 * others > inside.len()
    }

    /// Whether the way from a label in a place to its text, which lines shut in, leads through a door, or the label
    /// lies in one: it would be the name of the next room. A text whose print lies in one names that, or a line that
    /// ends there.
    pub(super) fn is_beyond_door(&self, print: MmRect, place: MmRect, leader: Option<[MmPoint; 2]>) -> bool {
        let [from, to] = leader.unwrap_or([self.anchor, self.anchor]);
        let from = from.clamp(place.min, place.max);
        let is_of_room = self.is_shut_in() && self.angle.is_none() && self.scale.is_none();
        let is_beyond = || self.room.leads_through_door(from, to) || self.room.is_in_door(place);
        is_of_room && is_beyond() && !self.room.is_in_door(print)
    }

    /// Whether a place lies in the cell of lines in which the text stands, or in no cell at all; any does for a text
    /// that stands in none.
    pub(super) fn is_in_cell_or_open(&self, place: MmRect) -> bool {
        // a row of a table may be so long that it seems open
        let is_open = || self.is_open(place) && self.room.cell_around(place.center()).is_none();
        self.cell.is_none_or(|cell| cell.contains_box(&place) || !self.is_in_table && is_open())
    }

    /// Whether a place is at the tick or gridline of a number of an axis, or the label is none.
    pub(super) fn is_at_tick(&self, place: MmRect) -> bool {
        let off = place.center() - self.anchor;
        let (off, most) = match self.scale {
            None => return true,
            Some(GroupDirection::Column(_)) => (off.y, OFF_LEVEL),
            Some(GroupDirection::Row | GroupDirection::BelowPoints) => (off.x, OFF_TICK),
        };
        off.abs() <= most.max(0.5 * self.params.step) + EPSILON
    }

    /// Whether a label and its leader line keep clear of what other labels name.
    pub(super) fn leads_to_own(&self, place: MmRect, [from, to]: [MmPoint; 2]) -> bool {
        let is_clear =
            |&other: &MmPoint| nearest_on_segment(other, from, to).0 >= TO_OTHERS || (other - to).length() < TO_OTHERS;
        self.is_off_others(place) && self.others.iter().all(is_clear) && self.is_clear_of_blocked([from, to])
    }

    /// Whether a label of a point stands in a shape in which lies what another one names, and not its own, to which its
    /// leader line comes through a gap of the outline: a finger takes the label for the name of that shape.
    pub(super) fn is_in_shape_of_other(&self, place: MmRect, [from, to]: [MmPoint; 2]) -> bool {
        let middle = place.center();
        let is_seen = |at: MmPoint| !self.room.is_parted_from_text(middle, at, 0.0);
        self.is_point()
            && !is_seen(self.anchor)
            && self.others.iter().any(|&other| is_seen(other))
            && !self.room.is_parted(from, to, 0.0)
            && self.room.is_in_room(middle, FURTHEST_OUTLINE)
    }

    /// Whether a label in a place, without its leader line, keeps clear of what other labels name.
    pub(super) fn is_off_others(&self, place: MmRect) -> bool {
        self.others.iter().all(|&other| distance_to_box(other, place) >= TO_OTHERS)
    }

    /// Whether a leader line keeps clear of the boxes of what is on the page already: through the blank around braille
    /// it would be felt as a part of that.
    pub(super) fn is_clear_of_blocked(&self, [from, to]: [MmPoint; 2]) -> bool {
        let far = TO_LEADER + self.params.leader_off;
        let reach = MmRect::from_points([from, to]).inflate(far, far);
        self.params.blocked.iter().filter(|place| reach.intersects(place)).all(|place| {
            let corners = corners(*place);
            let to_side = |i: usize| segment_distance((from, to), (corners[i], corners[(i + 1) % 4]));
            !place.contains(from) && (0..4).all(|side| to_side(side) >= far)
        })
    }

    /// Whether a leader line from a place leads into a small shape in which that of the drawing ended, as into the lens
    /// of an eye, and crosses the outline of that and nothing else: so it may lead there too where lines are not to be
    /// crossed.
    pub(super) fn leads_into_shape(&self, label: &Wanted, from: MmPoint) -> bool {
        label.lost_leader.is_some()
            && self.room.only_line(from, self.tip, self.params.widest_outline).is_some()
            && self.room.shut_in(self.tip, FURTHEST_SIDE).is_some()
    }

    /// Over or under how many points of others a label of a point stands that lies above or below its own: as near to
    /// them, so that a finger that comes from one of them takes it for theirs.
    pub(super) fn over_others(&self, place: MmRect) -> usize {
        let is_in_columns = |at: MmPoint| (place.min.x..=place.max.x).contains(&at.x);
        let gap = |at: MmPoint| distance_to_box(at, place);
        let own = gap(self.anchor) + TO_OTHERS;
        let is_over =
            |other: &&MmPoint| (**other - self.anchor).length() > SAME && is_in_columns(**other) && gap(**other) <= own;
        if !self.is_point() || !is_in_columns(self.anchor) {
            return 0;
        }
        // two names of one point are one
        let mut over: Vec<&MmPoint> = self.points.iter().filter(is_over).collect();
        over.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        over.dedup_by(|a, b| (**a - **b).length() <= SAME);
        over.len()
    }

    /// How far the marks of a leader line lie off its straight segment, mm.
    pub(super) fn leader_off(&self) -> f32 {
        self.params.leader_off
    }

    /// Whether a label in a place is nearer to what it names than to what any other label names, so that no finger
    /// takes it for that one's. Of those that it lies over, its own must be nearest to its middle.
    pub(super) fn is_own(&self, place: MmRect) -> bool {
        let far = |at: MmPoint| (distance_to_box(at, place), (at - place.center()).length());
        let (own, from_middle) = far(self.anchor);
        self.others.iter().all(|&other| {
            let (gap, middle) = far(other);
            gap > own || gap >= own && middle >= from_middle
        })
    }
}

/// The place of the line to which a text belongs that stands beside it: that of a length may be a thin one, such as the
/// height of a triangle, but no gridline.
fn line_beside(label: &Wanted, anchor: MmRect, room: &Room) -> Option<MmPoint> {
    let is_on_grid = || room.interrupts_grid(anchor.inflate(BESIDE_LINE, BESIDE_LINE));
    let is_of_any = scale::is_length(&label.text) && !is_on_grid();
    room.line_beside(anchor, BESIDE_LINE, if is_of_any { 0.0 } else { NEAR })
}

/// Whether the line beside a text in a room is that of a thing which another text names, such as a table: right behind
/// it is what that names, which is not seen from the text.
fn is_of_other(tip: MmPoint, anchor: MmRect, others: &[MmPoint], room: &Room) -> bool {
    let Some(away) = (tip - tip.clamp(anchor.min, anchor.max)).try_normalize() else { return false };
    let behind = tip + away * BEHIND_LINE;
    let is_parted = |from: MmPoint, other: MmPoint| room.is_parted_from_text(from, other, 0.0);
    others.iter().any(|&other| !is_parted(behind, other) && is_parted(anchor.center(), other))
}

/// The box of lines in which a text stands, such as a cell of a table. What is written across the lines of a grid
/// stands in none of its squares.
fn cell_of(anchor: MmRect, wanted: &[Wanted], room: &Room) -> Option<MmRect> {
    let is_around = |cell: &MmRect| cell.inflate(AROUND_CELL, AROUND_CELL).contains_box(&anchor);
    room.cell_around(anchor.center()).filter(|cell| is_around(cell) && !is_squared_paper(*cell, wanted, room))
}

/// Whether a box of lines with a text is a square of squared paper, on which letters stand beside what is drawn over
/// it: there are boxes right beside it, and all of these are empty.
fn is_squared_paper(cell: MmRect, wanted: &[Wanted], room: &Room) -> bool {
    let (across, down) = (MmVector::new(cell.width(), 0.0), MmVector::new(0.0, cell.height()));
    let beside = [across, -across, down, -down].map(|to| cell.center() + to);
    let boxes: Vec<MmRect> = beside.into_iter().filter_map(|at| room.cell_around(at)).collect();
    let has_text = |of: &MmRect| wanted.iter().any(|label| of.contains(label.anchor.center()));
    !boxes.is_empty() && !boxes.iter().any(has_text)
}

#[cfg(test)]
mod tests;
