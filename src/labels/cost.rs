//! What a place for a label costs, by which the places of a label are compared.
//!
//! A cost is in millimetres: those by which another place may lie further from what the label names and be as good. So
//! every number says what a reader would rather put up with:
//!
//! ```text
//!  0.1 to 0.5  for each mm off the middle or the level of a point: sets the order of places that are as near
//!  0.3         for each glyph of a texture that goes: a few are not missed, a patch of 30 is as bad as a leader line
//!  3 to 5      the worse side of a point, a second line or row, or a line so near beside a label that its dots are
//!              read as a letter: more than a step of a grid of dots (2 to 2.5 mm)
//!  8           a gridline that is interrupted: a value above its bar stands there rather than with a leader line
//!  10 to 15    a leader line, a place that is not below a bar, a divided word: read, but with more effort
//!  10          for each mm that a leader line of dots lacks to be felt as a line
//!  30          for each point of another over or under which a label of a point stands: rather in two lines, or with a
//!              leader line
//!  50          for each mm of a leader line beside a line, of which it is felt as a part, beyond the first few
//!  60          a line of cells right beside a label, which is read as a letter of it
//!  150         each line but the first that a leader line across lines crosses
//!  200         a label that blanks the texture of its sector (`candidates`)
//!  300         a leader line across others that the drawing itself led across them: rather than an abbreviation
//!  1000        an abbreviation, which has to be looked up in the key (`forms`)
//!  1200        a place outside of the room of a plan in which the text stands: rather the abbreviation
//!  1500        a leader line from a sentence, such as an instruction: rather the abbreviation
//!  2000        any other leader line across lines: rather the abbreviation
//! ```
//!
//! From 300 on no distance counts any more, as no label lies further than about 40 mm from what it names.

use super::forms::ABBREVIATED;
use super::placed::{Attachment, Wanted};
use super::surroundings::{AT_END, Named, Surroundings};
use crate::geom::polygon::distance_to_box;
use crate::units::{MmPoint, MmRect};

/// For each mm that the middle of a label of a point at the lower side of a shape is off the point: half of its
/// distance, so that it stands in the middle below the shape where there is room, and not below the next one.
const OFF_MIDDLE: f32 = 0.5;
/// For a label of such a point elsewhere than below it: what stands beside a bar is taken for a name of its side, so
/// that a label below it with a leader line is a little better.
const NOT_BELOW: f32 = LEADER + 2.0;
/// For each point of another over or under which the label of a point stands as well: more than a leader line and a
/// divided word together.
const OVER_ANOTHER: f32 = 30.0;
/// For a label of a point that is left of it, next to one on the right, where reading goes on: more than a step of a
/// grid of dots, so that the grid does not decide.
const ON_THE_LEFT: f32 = 3.0;
/// The same of one above or below it, where a finger has to leave the row: rather on the left.
const ABOVE_OR_BELOW: f32 = 4.0;
/// For each mm that the middle of a label beside a point is above or below the point: a third of its distance, as a
/// finger goes on along the row.
const OFF_LEVEL: f32 = 0.3;
/// For each mm that the middle of a label above or below a point is left or right of the point: only the order of what
/// is as near, as a label is wider than high and touches the point's column anyhow.
const OFF_CENTRE: f32 = 0.1;
/// How many times a mm counts to the left or right of the text that a label stands for, next to one above or below: in
/// a row of texts, such as those under the bars of a chart, two lines of labels are clearer than labels between the
/// bars.
const ALONG: f32 = 3.0;
/// The same where a line leads to the text, on the side on which it comes: a label there stands over that line.
const BACK_OVER_LINE: f32 = ALONG;
/// How many times a mm counts above or below the row of the line that leads to a label: a word that is whole just above
/// that line is better than one that is divided beside it. Less than [`ALONG`], as it stands over nothing.
const OFF_THE_ROW: f32 = 1.8;
/// For a leader line: a label may lie so much further away if it needs none, nearly as far as labels without one lie
/// ([`NEAR`](super::surroundings::NEAR)).
const LEADER: f32 = 10.0;
/// For a leader line from a sentence, which names nothing: rather an abbreviation in its place.
const FROM_SENTENCE: f32 = 1.5 * ABBREVIATED;
/// For a label outside of the room of a plan in which its text stands: there it names what lies around the house, or
/// the next room, so rather an abbreviation in the room.
const OUT_OF_ROOM: f32 = 1.2 * ABBREVIATED;
/// For a leader line across other lines, along which a finger may go astray: more than an abbreviation, which is only
/// slower.
const ACROSS: f32 = 2.0 * ABBREVIATED;
/// The same where the drawing's own leader line crossed them too, as its maker found it clear: less than an
/// abbreviation.
const ACROSS_AS_DRAWN: f32 = 0.3 * ABBREVIATED;
/// How many times a mm counts from where such a leader line began, beside its text: on the other side the label would
/// stand among other things. Twice, so that it stays on that side even where it then lies further from its tip.
const FROM_PRINT: f32 = 2.0;
/// For each mm of a leader line across others that runs along a line, of which it would be felt as a part: 15 mm of it
/// are as bad as crossing as the drawing does ([`ACROSS_AS_DRAWN`]).
const ALONG_A_LINE: f32 = 20.0;
/// For each line but the first that such a line crosses, which the drawing has not: more than any distance.
const ANOTHER_CROSSED: f32 = 150.0;
/// For each mm over which a leader line that crosses no other runs beside one, as along a wire of a circuit, beyond
/// those which it needs to pass the end of a line or to come up to a slanted one: with 30 mm it is worse than an
/// abbreviation. Chosen by us.
const BESIDE_A_LINE: f32 = 50.0;
const PAST_A_LINE: f32 = 8.0;
/// A leader line across others is felt as a line by itself before it meets the first, over so much of it, mm: three or
/// four dots of a grid. Chosen by us.
const FELT_BEFORE_LINE: f32 = 6.0;
/// So is any leader line of dots, with so many of them before the line in which its last one lies.
const FEWEST_DOTS: f32 = 3.0;
/// For each mm of that which it lacks: more than what the label loses by standing further from its tip and from where
/// its print stood.
const TOO_SHORT: f32 = 10.0;
/// For a line that stands beside a label where a next cell would be.
pub(super) const LIKE_A_CELL: f32 = 3.0;
/// The same where lines are cells themselves: the label is read with a letter more, so rather with a leader line, or in
/// two lines. Less than an abbreviation.
const A_CELL: f32 = 60.0;
/// For gridlines that are interrupted: a title stands above them where there is room.
const ON_A_GRID: f32 = 8.0;
/// For a glyph that has to go: so little that a label moves by less than a mm to keep two or three of a texture.
const GLYPH: f32 = 0.3;

/// What a place costs, in mm that another place may lie further away; `of_form` is what the label's form costs.
pub(super) fn cost(
    of_form: f32,
    label: &Wanted,
    place: MmRect,
    attachment: Attachment,
    around: &Surroundings<'_>,
) -> f32 {
    let &Surroundings { room, params, end, anchor, .. } = around;
    let distance = distance(label, place, around);
    let elsewhere = if around.is_at_lower_side() && place.min.y < anchor.y { NOT_BELOW } else { 0.0 };
    let over_others = match attachment {
        Attachment::Beside => OVER_ANOTHER * around.over_others(place) as f32,
        Attachment::Leader(_) | Attachment::LeaderAcross(_) => 0.0,
    };
    let glyphs = room.glyphs(place.inflate(params.texture_clearance, params.texture_clearance));
    let leader = match attachment {
        Attachment::Beside => 0.0,
        Attachment::Leader(segment) => LEADER + beside_lines(segment, around) + of_few_dots(segment, around),
        Attachment::LeaderAcross([from, to]) => {
            let across = if label.lost_leader.is_some() { ACROSS_AS_DRAWN } else { ACROSS };
            let lacking = (FELT_BEFORE_LINE - room.before_first_line(from, to)).max(0.0);
            let others = if label.lost_leader.is_none() { room.crossed(from, to, end).saturating_sub(1) } else { 0 };
            across + ALONG_A_LINE * room.along(from, to, end) + TOO_SHORT * lacking + ANOTHER_CROSSED * others as f32
        }
    };
    let from_sentence = if around.is_sentence && attachment.leader().is_some() { FROM_SENTENCE } else { 0.0 };
    let is_out = || around.is_out_of_room(place) || around.is_beyond_door(label.anchor, place, attachment.leader());
    let out_of_room = if !attachment.crosses() && is_out() { OUT_OF_ROOM } else { 0.0 };
    let leader = leader + from_sentence + out_of_room;
    let grid = if room.interrupts_grid(place) { ON_A_GRID } else { 0.0 };
    // on the side where its text stood
    let aside = label.lost_leader.map_or(0.0, |from| FROM_PRINT * distance_to_box(from, place));
    // the end of the line that leads to it is no letter
    let is_read_alone = label.kept_leader.is_some() || room.is_free_aside(place, params.more_aside);
    let beside = match is_read_alone {
        true => 0.0,
        false if params.among_cells => A_CELL,
        false => LIKE_A_CELL,
    };
    of_form + distance + aside + elsewhere + over_others + GLYPH * glyphs + grid + leader + beside
}

/// What it costs that a leader line runs beside lines; where it ends it may. On dots it lies off its segment, so that a
/// line that it only comes by is beside more of it.
fn beside_lines([from, to]: [MmPoint; 2], around: &Surroundings<'_>) -> f32 {
    let off = around.leader_off();
    let beside = around.room.beside_lines(from, to, around.end.max(AT_END), off);
    BESIDE_A_LINE * (beside - PAST_A_LINE - 2.0 * off).max(0.0)
}

/// What it costs that a leader line of dots has too few to be felt as a line.
fn of_few_dots([from, to]: [MmPoint; 2], around: &Surroundings<'_>) -> f32 {
    let pitch = around.params.dot_pitch;
    let least = if pitch > 0.0 { FELT_BEFORE_LINE.max(FEWEST_DOTS * pitch) } else { 0.0 };
    TOO_SHORT * (least - (to - from).length()).max(0.0)
}

/// How far a place is from what a label names, mm: more in directions in which it reads worse.
fn distance(label: &Wanted, place: MmRect, around: &Surroundings<'_>) -> f32 {
    let anchor = around.anchor;
    let gap = distance_to_box(anchor, place);
    let away = place.center() - anchor;
    let is_beside = (place.min.y..=place.max.y).contains(&anchor.y);
    match around.names {
        Named::Point { is_at_lower_side: true } if place.min.y >= anchor.y => gap + OFF_MIDDLE * away.x.abs(),
        Named::Point { .. } if is_beside => {
            gap + OFF_LEVEL * away.y.abs() + if away.x < 0.0 { ON_THE_LEFT } else { 0.0 }
        }
        Named::Point { .. } => gap + OFF_CENTRE * away.x.abs() + ABOVE_OR_BELOW,
        // in the row of the line's end, and rather away from it than back over it
        Named::Text { line_on: Some(side), .. } => {
            let is_back = side * away.x > 0.0;
            let along = if is_back { BACK_OVER_LINE * away.x } else { onwards(label.kept_leader, side, place, away.x) };
            along.hypot(OFF_THE_ROW * away.y)
        }
        // in place of the text
        Named::Text { line_on: None, .. } => (ALONG * away.x).hypot(away.y),
    }
}

/// How far a label is from its text, from which its middle is `away` mm, onwards from the line that comes up to that on
/// this side. Where that is the drawing's leader line, it counts from the end of it, at which a finger goes on: braille
/// is wider than print, so that its middle is further off though it begins right there.
fn onwards(leader: Option<MmPoint>, side: f32, place: MmRect, away: f32) -> f32 {
    let begins = if side < 0.0 { place.min.x } else { place.max.x };
    let from_end = leader.map(|end| side * (end.x - begins)).filter(|gap| *gap >= 0.0);
    from_end.map_or(away.abs(), |gap| gap.min(away.abs()))
}

#[cfg(test)]
mod tests;
