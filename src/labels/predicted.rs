//! Where the rows and columns of labels of a drawing would stand before the drawing is laid out: how much room they
//! lack beside it.

use super::placed::{Params, Wanted};
use super::room::Room;
use super::{levels, longer_ticks, place_rows_first, titles};
use crate::braille::Translator;
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect};

/// A drawing that is not drawn yet, and its texts.
#[derive(Debug)]
pub struct RowPrediction<'a> {
    /// Its texts, where they stand.
    pub wanted: &'a [Wanted],
    /// Points on its contours, no further apart than half a millimetre.
    pub contours: &'a [MmPoint],
    /// How wide the lines on them will be at most, mm.
    pub line_width: f32,
    /// How long ticks will be at least, if shorter ones are drawn longer, mm.
    pub longer_to: Option<f32>,
    /// As labels will be placed, but in all the area that they may take.
    pub params: &'a Params,
}

/// How far labels in rows and columns reach out of a box on the left, above, on the right and below, mm; less than 0
/// where they keep within it.
pub fn row_overhang(
    of: &RowPrediction<'_>,
    cells: &CellGrid<'_>,
    translator: &Translator<'_>,
    within: MmRect,
) -> [f32; 4] {
    let RowPrediction { wanted, contours, line_width, longer_to, params } = of;
    // the grid of a device may end at the box
    let cells = &cells.anywhere();
    let room = |contours: &[MmPoint]| Room::of_contours(params.area, contours, *line_width, params.clearance);
    let as_drawn = room(contours);
    let longer = |least| longer_ticks(wanted, translator, cells, &as_drawn, params, least);
    let longer = longer_to.map(longer).unwrap_or_default();
    let room = if longer.is_empty() { as_drawn } else { room(&[contours, &longer[..]].concat()) };
    let wanted = levels::at_their_lines(wanted, &room);
    let rows = place_rows_first(&wanted, translator, cells, &room, params);
    let placed = &rows.placed;
    let [left, top, right, bottom] =
        placed.iter().flatten().fold([f32::NEG_INFINITY; 4], |[left, top, right, bottom], candidate| {
            let place = candidate.place;
            [
                left.max(within.min.x - place.min.x),
                top.max(within.min.y - place.min.y),
                right.max(place.max.x - within.max.x),
                bottom.max(place.max.y - within.max.y),
            ]
        });
    let above_titles = titles::top_of_headings(&rows.context(), placed).map_or(top, |above| within.min.y - above);
    [left, top.max(above_titles), right, bottom]
}
