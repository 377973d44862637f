//! A shape before which a text stands in the blank, such as the sector of a pie that it names.

use super::room::{FURTHEST_OUTLINE, Room};
use crate::geom::polygon::distance_to_box;
use crate::units::{MmPoint, MmRect};

/// So far behind an outline is the inside of its shape, mm: behind the widest line, and off the corner of a sector.
const INSIDE: f32 = 4.5;

/// Of two shapes as near as this, mm, neither is nearer to a label that reaches before both: its middle tells. Outlines
/// are met at places up to 2 mm apart at 40 mm from the text, and farther apart beyond.
const AS_NEAR: f32 = 1.0;

/// A shape that lines shut in, as it is seen from a text before it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    /// The place on its outline that is nearest to the text.
    pub(super) outline: MmPoint,
    /// How far that is, mm.
    pub(super) gap: f32,
    /// A place inside of it, behind that.
    pub(super) inside: MmPoint,
    /// Places on its outline, and on those of other shapes.
    own: Vec<MmPoint>,
    others: Vec<MmPoint>,
}

impl Shape {
    /// The nearest shape to a text in the open within `near` mm, if that is not beyond another line.
    pub(super) fn before(text: MmRect, near: f32, room: &Room) -> Option<Self> {
        let outline = room.line_beside(text, near, near)?;
        let from = outline.clamp(text.min, text.max);
        let gap = (outline - from).length();
        let inside = (gap > 0.0).then(|| outline + (outline - from) * (INSIDE / gap))?;
        let is_shape = !room.is_ink(inside) && room.is_in_room(inside, FURTHEST_OUTLINE);
        let is_before = is_shape && !room.is_in_room(text.center(), FURTHEST_OUTLINE);
        is_before.then(|| Self { outline, gap, inside, own: vec![outline], others: Vec::new() })
    }

    /// Whether a place is inside of it: no line lies between. In one that is not convex that may not be seen, and a
    /// label has a leader line that it would not need.
    pub(super) fn holds(&self, place: MmPoint, room: &Room) -> bool {
        !room.is_parted_from_text(self.inside, place, 0.0)
    }

    /// Looks at the outlines that are seen from a text within `reach` mm.
    pub(super) fn look_around(&mut self, text: MmPoint, reach: f32, room: &Room) {
        for [outline, inside] in room.lines_around(text, reach, INSIDE) {
            if self.holds(inside, room) {
                self.own.push(outline);
            } else if room.is_in_room(inside, FURTHEST_OUTLINE) {
                self.others.push(outline);
            }
        }
    }

    /// Whether a label in a place stands before this shape: it is the nearest to the label, and to the middle of that.
    pub(super) fn is_nearest(&self, place: MmRect) -> bool {
        let middle = place.center();
        let far = |of: &[MmPoint]| {
            of.iter().fold([f32::INFINITY; 2], |[gap, off], &at| {
                [gap.min(distance_to_box(at, place)), off.min((at - middle).length())]
            })
        };
        let (own, others) = (far(&self.own), far(&self.others));
        own[0] <= others[0] + AS_NEAR && own[1] <= others[1]
    }
}

#[cfg(test)]
mod tests;
