//! Room beside a drawing for its own words: braille is wider and higher than print, so numbers left of an axis and
//! words below it do not fit into the margins that the drawing has. Then the drawing is made a little smaller in its
//! frame.

use super::label::CLEARANCE;
use super::texts::{self, Text};
use super::words::{Words, Written, own_texts};
use crate::Error;
use crate::braille::CellSize;
use crate::labels::{self, Lies};
use crate::page::Medium;
use crate::page::cells::CellGrid;
use crate::page::layout::Layout;
use crate::raster::vector::DrawnText;
use crate::units::{MmPoint, MmRect, MmVector, PageTransform, Size};

/// Most room on one side, as a share of the drawing's width or height: beyond it the drawing would lose more than
/// abbreviations cost. Words that need more get none.
const MOST: f32 = 0.2;
/// Least distance of a word below the drawing's lowest line to the middle of the print that it stands for, mm: print
/// is set about as near to a line as braille, but half as high.
const LOWER: f32 = 2.0;
/// How many steps of a grid of dots a row lies lower: its line may be one lower and have a second row, and its braille
/// is brought on to the grid, too.
const OF_DOTS: f32 = 3.0;
/// How much further than print the braille of a column stands from the line beside it, mm.
const ASIDE: f32 = 3.0;
/// Cells of an abbreviation, as which a row is written that has no room for whole words.
const SHORT: usize = 2;
/// How often the room is computed: a smaller drawing has its words elsewhere. Three rounds leave less than 0.1 mm.
const ROUNDS: usize = 4;
/// What is no lack of room, mm.
const SLACK: f32 = 0.1;

/// A text that needs room, in millimetres of the sheet.
struct Need {
    /// The box of its print, as a share of the drawing.
    print: MmRect,
    /// Size of its braille, with that of other rows.
    braille: MmVector,
    /// Which of their edges are in line: 0 the left ones, 1 the right ones.
    side: f32,
}

/// The layout of a drawing with room beside it for the braille of its own texts in rows and columns; `layout_of` gives
/// that of a size. The drawing's shorter side stays at least `min_side`, mm. `raster` is the size in which the texts
/// have their places, `source` that of the drawing.
pub(super) fn with_room(
    texts: &[DrawnText],
    [raster, source]: [Size; 2],
    (words, written, cell): (&Words<'_>, &Written<'_>, CellSize),
    layout: Layout,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
    min_side: f32,
) -> Layout {
    let placed = texts::placed(texts, &PageTransform::new(raster, layout.figure));
    let cells = CellGrid::of(&layout.medium, cell);
    let needs = needs(&placed, words, written, &cells, (&layout.medium, layout.figure));
    if needs.is_empty() {
        return layout;
    }
    let (own, mut best) = (layout.clone(), layout);
    let mut room = [0.0_f32; 4];
    let most = [source.width, source.height].map(|side| MOST * side as f32);
    for _ in 0..ROUNDS {
        let px_per_mm = source.width as f32 / best.figure.width();
        // on a side where a text lacks more than there may be, it is abbreviated anyhow
        let more = lacks(&needs, best.figure, best.room).map(|lacks| lacks * px_per_mm);
        let mut is_more = false;
        for (side, lacks) in more.into_iter().enumerate() {
            let wanted = room[side] + lacks;
            if lacks > SLACK * px_per_mm && wanted <= most[side % 2] {
                room[side] = wanted;
                is_more = true;
            }
        }
        if !is_more {
            break;
        }
        let whole = |px: f32| px.ceil() as u32;
        let [left, top, right, bottom] = room;
        let size = Size::new(source.width + whole(left + right), source.height + whole(top + bottom));
        let Ok(outer) = layout_of(size) else { break };
        let smaller = within(outer, &own, [left, top], size, source);
        if smaller.figure.width().min(smaller.figure.height()) < min_side {
            break;
        }
        best = smaller;
    }
    best
}

/// The drawing in a layout of a larger size, so many pixels from its left and upper edge.
fn within(outer: Layout, own: &Layout, [left, top]: [f32; 2], size: Size, source: Size) -> Layout {
    let mm_per_px = outer.figure.width() / size.width as f32;
    // on a grid of dots in whole steps, as the larger one lies on it
    let step = match &outer.medium {
        Medium::Print(_) => 0.0,
        Medium::Dots(dots) => dots.pitch,
    };
    let on_grid = |mm: f32| if step > 0.0 { (mm / step).round() * step } else { mm };
    let corner = outer.figure.min + MmVector::new(on_grid(left * mm_per_px), on_grid(top * mm_per_px));
    let extent = MmVector::new(source.width as f32, source.height as f32) * mm_per_px;
    let figure = MmRect::new(corner, (corner + extent).min(outer.figure.max));
    // an overview has no words: on its own sheet it stays as it was, else in its place at the same share
    let overview = match &outer.medium {
        Medium::Print(_) => outer.overview.map(|place| {
            let extent = figure.size() * (place.width() / outer.figure.width());
            let corner = MmPoint::new(place.center().x - 0.5 * extent.width, place.min.y);
            MmRect::from_origin_and_size(corner, extent)
        }),
        Medium::Dots(_) => own.overview,
    };
    Layout { figure, overview, room: outer.figure, ..outer }
}

/// The texts of a drawing that stand in rows and columns, and the room that their braille takes.
fn needs(
    texts: &[Text],
    words: &Words<'_>,
    written: &Written<'_>,
    cells: &CellGrid<'_>,
    (medium, figure): (&Medium, MmRect),
) -> Vec<Need> {
    let Some(translator) = written.translator() else { return Vec::new() };
    let own: Vec<&Text> = own_texts(texts, words).collect();
    if own.len() > labels::MOST {
        return Vec::new();
    }
    let boxes: Vec<(usize, MmRect)> = own.iter().map(|text| text.anchor()).enumerate().collect();
    let size = |text: &Text| Some(cells.extent(translator.translate(&text.string).ok()?.cells.len(), 1));
    let share = |at: MmPoint| {
        let from = at - figure.min;
        MmPoint::new(from.x / figure.width(), from.y / figure.height())
    };
    let [aside, above] = labels::least_blank();
    let step = if let Medium::Dots(dots) = medium { dots.pitch } else { 0.0 };
    let of_short = cells.extent(SHORT, 1).x;
    // a text without letters has no abbreviation
    let short = |member: usize, whole: f32| {
        let letters = own[member].string.chars().filter(|letter| letter.is_alphabetic());
        if letters.take(SHORT).count() == SHORT { whole.min(of_short) } else { whole }
    };
    let mut needs = Vec::new();
    let mut is_alone = vec![true; own.len()];
    for group in labels::of_texts(&boxes) {
        let mut members = group.members;
        members.iter().for_each(|&member| is_alone[member] = false);
        members.sort_by(|&a, &b| boxes[a].1.center().x.total_cmp(&boxes[b].1.center().x));
        let wholes: Vec<MmVector> = members.iter().map(|&member| size(own[member]).unwrap_or_default()).collect();
        let shorts: Vec<f32> = members.iter().zip(&wholes).map(|(&member, whole)| short(member, whole.x)).collect();
        let is_row = group.lies == Lies::Row;
        // a row whose words do not fit side by side is abbreviated, and where that does not fit either, in two
        let fits = |width: &dyn Fn(usize) -> f32| {
            let middle = |at: usize| boxes[members[at]].1.center().x;
            (1..members.len()).all(|at| middle(at) - middle(at - 1) >= 0.5 * (width(at) + width(at - 1)) + aside)
        };
        let side = if let Lies::Column(side) = group.lies { side } else { 0.5 };
        // and so is a column of which a word is too long for any room
        let is_whole = match group.lies {
            Lies::Column(_) => members.iter().zip(&wholes).all(|(&member, whole)| {
                let place = boxes[member].1;
                let left = place.min.x + side * (place.width() - whole.x) - figure.min.x;
                left.min(figure.width() - left - whole.x) > -MOST * figure.width()
            }),
            _ => fits(&|at| wholes[at].x),
        };
        let is_in_two = is_row && !is_whole && !fits(&|at| shorts[at]);
        for ((&member, whole), short) in members.iter().zip(&wholes).zip(&shorts) {
            let mut braille = MmVector::new(if is_whole { whole.x } else { *short }, whole.y);
            if is_row {
                braille.y += LOWER + OF_DOTS * step + if is_in_two { braille.y + above } else { 0.0 };
            } else {
                braille.x += ASIDE + step;
            }
            let place = boxes[member].1;
            needs.push(Need { print: MmRect::new(share(place.min), share(place.max)), braille, side });
        }
    }
    // a word by itself above all else, such as a heading, is higher than its print
    for (text, _) in own.iter().zip(is_alone).filter(|(text, alone)| *alone && text.angle.abs() < 1.0) {
        let (place, height) = (text.place, cells.extent(1, 1).y + step);
        if share(place.center()).y < AT_EDGE {
            let raised = MmVector::new(0.0, 0.5 * height + LOWER);
            let print = MmRect::new(share(place.center() - raised), share(place.center() - raised));
            needs.push(Need { print, braille: MmVector::zero(), side: 0.5 });
        }
    }
    needs
}

/// Share of the drawing's height in which a heading stands.
const AT_EDGE: f32 = 0.15;

/// How much room the texts lack on the left, above, on the right and below, mm: the most that any of them lacks
/// which is not more than it may be.
fn lacks(needs: &[Need], figure: MmRect, room: MmRect) -> [f32; 4] {
    let most = [figure.width(), figure.height()].map(|side| MOST * side);
    let mut lacks = [0.0_f32; 4];
    for Need { print, braille, side } in needs {
        let at = |share: MmPoint| figure.min + MmVector::new(share.x * figure.width(), share.y * figure.height());
        let (low, high) = (at(print.min), at(print.max));
        let left = low.x + side * (high.x - low.x - braille.x);
        // the first line is in place of the print, others are below it
        let top = 0.5 * (low.y + high.y) - 0.5 * CLEARANCE;
        let of_one = [room.min.x - left, room.min.y - top, left + braille.x - room.max.x, top + braille.y - room.max.y];
        for (lacks, (lack, most)) in lacks.iter_mut().zip(of_one.into_iter().zip([most, most].concat())) {
            if lack <= most {
                *lacks = lacks.max(lack);
            }
        }
    }
    lacks
}
