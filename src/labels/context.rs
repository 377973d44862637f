//! What labels in rows and columns are placed in, and whether a place in it is free.

use super::attached::{is_at_kept_leader, is_at_lost_tip};
use super::candidates::Candidate;
use super::forms::Forms;
use super::placed::{Params, PlacedAs, Unplaced, Wanted};
use super::room::Room;
use super::surroundings::{AT_END, Surroundings};
use crate::page::cells::CellGrid;

/// How far a row may lie from its texts, mm: so near a label names something without a leader line.
pub(super) const REACH: f32 = 12.0;
/// How far a label may be moved along its row, as a share of the distance to its neighbour's anchor: its middle is then
/// still much nearer to its own.
pub(super) const ALONG: f32 = 0.3;

/// What groups of labels are placed in.
pub(super) struct Context<'a> {
    pub(super) wanted: &'a [Wanted],
    pub(super) forms: &'a [Result<Forms, Unplaced>],
    pub(super) around: &'a [Surroundings<'a>],
    pub(super) room: &'a Room,
    pub(super) params: &'a Params,
    pub(super) cells: &'a CellGrid<'a>,
}

/// Whether a label of a row can lie in its place: free, and with a free segment for its leader line; without one on its
/// own side of all lines, and nearer to its own anchor than to that of another label.
pub(super) fn is_free(label: usize, candidate: &Candidate, context: &Context<'_>) -> bool {
    let (around, place) = (&context.around[label], candidate.place);
    let anchor = around.anchor;
    let nearest = anchor.clamp(place.min, place.max);
    let is_told = || match candidate.leader() {
        // what stands in a cell of a table is of its row and its column
        _ if candidate.stands == PlacedAs::InMargin => around.cell.is_none(),
        Some([from, to]) => {
            context.room.is_free_segment(from, to, around.end.max(AT_END)) && around.leads_to_own(place, [from, to])
        }
        None => {
            let wanted = &context.wanted[label];
            let is_found = is_at_kept_leader(wanted, place) && is_at_lost_tip(wanted, place, around);
            is_found && !context.room.is_parted(nearest, anchor, around.end.max(AT_END)) && around.is_own(place)
        }
    };
    context.params.holds(&place) && context.room.is_free(place) && around.is_in_cell_or_open(place) && is_told()
}

/// Steps in both directions, the nearest first.
pub(super) fn both_ways(nearest: i32, furthest: i32) -> impl Iterator<Item = i32> {
    (nearest..=furthest).flat_map(|step| [step, -step].into_iter().take(if step == 0 { 1 } else { 2 }))
}
