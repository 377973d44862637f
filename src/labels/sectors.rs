//! Texts in shapes that have others beside them, such as the sectors of a pie. Their textures tell them apart, so that
//! a label blanks most of one only where it has no place outside of the shape.

use super::placed::Wanted;
use super::room::{FINE_RAYS, Room};
use super::scale;
use super::surroundings::{NEAR, Surroundings};
use crate::units::{MmPoint, MmRect};

/// Shapes beside that of a text are looked for as far from the text as this, mm: the radius of a pie.
const REACH: f32 = 60.0;
/// So far behind its outline is a place in another shape, mm; signs of a texture are no farther around that.
const BEHIND: f32 = 5.0;
const AROUND: f32 = 4.0;
/// In so many directions there are others with a texture: of half a pie, in a third of all. And in so many there is
/// none, as there a label may stand.
const OTHERS: usize = FINE_RAYS as usize / 5;
const BLANK: usize = FINE_RAYS as usize / 10;

/// Finds the textures around names and shares in percent that stand in such shapes. Another number may be a value that
/// is looked for where it is, as a text is in a box, such as the bar of a chart. On an area of its own colour, as a map
/// in the sea, nothing has a place outside.
pub(super) fn look(around: &mut [Surroundings<'_>], wanted: &[Wanted]) {
    for (of, label) in around.iter_mut().zip(wanted) {
        let is_share = label.text.trim_end().ends_with('%');
        let is_told_outside = (is_share || !scale::is_number(&label.text)) && !of.params.has_coloured_ground;
        if is_told_outside && of.is_text_in_shape() && is_one_of_several(of.anchor, of.room) {
            of.texture = of.room.texture_around(of.anchor, NEAR, of.params);
        }
    }
}

/// Whether the shape around a place has others with a texture on some of its sides, and none on others.
fn is_one_of_several(at: MmPoint, room: &Room) -> bool {
    let seen = room.lines_around(at, REACH, BEHIND);
    let has_signs = |place: MmPoint| room.glyphs(MmRect::new(place, place).inflate(AROUND, AROUND)) > 0.0;
    let others = seen.iter().filter(|[_, behind]| has_signs(*behind)).count();
    others >= OTHERS && seen.len() - others >= BLANK
}

#[cfg(test)]
mod tests;
