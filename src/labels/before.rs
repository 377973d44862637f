//! Before which shapes texts stand, as those around a pie stand each before its sector. A label is longer than its
//! print and would soon stand before the next shape: it stands before its own, or has a leader line to it.

use super::placed::Wanted;
use super::room::{FURTHEST_OUTLINE, Room};
use super::scale;
use super::shape::Shape;
use super::surroundings::{NEAR, Surroundings};
use crate::units::MmPoint;

/// Fewest texts that stand each before another shape: one alone may be a heading above it.
const FEWEST: usize = 2;

/// Finds the shapes before which those texts stand that are in no row or column: each is the only one of its shape, or
/// the nearest. What has a name in it is not named beside it. `reach` of each is how long its labels may be, mm.
pub(super) fn look(
    around: &mut [Surroundings<'_>],
    wanted: &[Wanted],
    is_alone: impl Fn(usize) -> bool,
    reach: &[f32],
) {
    let Some(room) = around.first().map(|first| first.room).filter(|room| room.is_drawn()) else { return };
    let names = names_inside(wanted, room);
    let is_led = |label: usize| wanted[label].lost_leader.is_some() || wanted[label].kept_leader.is_some();
    let found: Vec<(usize, Shape)> = (0..wanted.len())
        .filter(|&label| is_alone(label) && !is_led(label) && !wanted[label].is_nameless)
        .filter(|&label| around[label].is_text_in_open() && around[label].is_in_blank(wanted[label].anchor))
        .filter_map(|label| Some((label, Shape::before(wanted[label].anchor, NEAR, room)?)))
        .filter(|(_, shape)| !names.iter().any(|name| shape.holds(*name, room)))
        .collect();
    let is_nearest_of_its = |(label, shape): &&(usize, Shape)| {
        let is_nearer = |(other, of): &(usize, Shape)| {
            other != label && (of.gap, *other) < (shape.gap, *label) && shape.holds(of.inside, room)
        };
        !found.iter().any(is_nearer)
    };
    let mut kept: Vec<(usize, Shape)> = found.iter().filter(is_nearest_of_its).cloned().collect();
    if kept.len() < FEWEST {
        return;
    }
    for (label, shape) in &mut kept {
        shape.look_around(wanted[*label].anchor.center(), NEAR + reach[*label], room);
    }
    for (label, shape) in kept {
        around[label].stands_before(shape);
    }
}

/// Where texts stand that lines shut in, but for numbers: those are shares, and no names.
fn names_inside(wanted: &[Wanted], room: &Room) -> Vec<MmPoint> {
    let names = wanted.iter().filter(|label| !label.anchor.is_empty() && !scale::is_number(&label.text));
    names.map(|label| label.anchor.center()).filter(|at| room.is_in_room(*at, FURTHEST_OUTLINE)).collect()
}
