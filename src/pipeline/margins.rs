//! Room beside a drawing for its own words: braille is wider and higher than print, so numbers left of an axis and
//! words below it do not fit into the margins that the drawing has. Then the drawing is made a little smaller in its
//! frame.

use std::cell::LazyCell;

use super::label::CLEARANCE;
use super::label_params;
use super::texts::{self, Text};
use super::words::{Words, WrittenWords, own_texts};
use crate::Error;
use crate::labels::{self, RowPrediction, Wanted, row_overhang};
use crate::page::Medium;
use crate::page::cells::CellGrid;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::raster::vector::DrawnText;
use crate::units::{MmPoint, MmRect, MmVector, PageTransform, PxPoint, Size};

/// How far words reach beyond the drawing at most on one side, as a share of its width or height: beyond it the drawing
/// would lose more than abbreviations cost. Words that reach farther get no room, and shorter forms of them are tried.
const MOST: f32 = 0.25;
/// By what share a drawing is hardly smaller: fingers do not tell 2 mm of 100.
const HARDLY_SMALLER: f32 = 0.02;
/// In steps of such a part of a drawing's width the blank beside it is looked for.
const STEPS_OF_BLANK: u32 = 64;
/// Two rows of labels have room above or below any drawing, as below the axis of a time line: a low drawing loses
/// little by it. The blank beside each, mm.
const BESIDE_ROW: f32 = CLEARANCE + MOVED;
/// Least distance of a heading to the middle of the print that it stands for, mm: print is set about as near to a line
/// as braille, but half as high.
const LOWER: f32 = 2.0;
/// How often the room is computed: a smaller drawing has its words elsewhere. After three of them less than 0.1 mm
/// is lacking; in one more, room that nothing stands in falls away.
const ROUNDS: usize = 4;
/// Most lines lie no farther than this beside where they are predicted, mm: they are moved apart, and labels with them
/// (see `lines::Params::farthest_moved`).
const MOVED: f32 = 2.0;
/// What is no lack of room, mm.
const SLACK: f32 = 0.1;
/// By how much two pixels side by side differ at least where a contour is, in a plane of square roots of linear light:
/// the grey of the palest gridlines (#eee) differs from white by 0.08.
const CONTOUR: f32 = 0.03;

/// A drawing with texts in it.
pub(super) struct Lettered<'a> {
    /// The texts, which have their places in `raster`.
    pub(super) texts: &'a [DrawnText],
    /// The drawing without them.
    pub(super) raster: &'a Raster,
    /// The size of the drawing.
    pub(super) source: Size,
}

/// How much room there may be.
#[derive(Clone, Copy)]
struct TextBounds {
    /// How far words may reach on the left or right, and above or below, mm.
    most: [f32; 2],
    /// The least width and height that are left to the drawing, mm.
    min_side: f32,
}

/// The layout of a drawing with room beside it for the braille of its own texts in rows and columns; `layout_of` gives
/// that of a size. The drawing's shorter side stays as long as the profile wants.
pub(super) fn with_room(
    &Lettered { texts, raster, source }: &Lettered<'_>,
    words: &Words<'_>,
    written: &WrittenWords<'_>,
    plan: &Plan,
    layout: Layout,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
) -> Layout {
    let transform = |layout: &Layout| PageTransform::new(raster.size(), layout.figure);
    let texts_at = |layout: &Layout| texts::placed(texts, &transform(layout));
    let found = LazyCell::new(|| contours(raster));
    let contours_at = |layout: &Layout| {
        let to_mm = transform(layout);
        found.iter().map(|&at| to_mm.to_mm(at)).collect()
    };
    with_room_for(
        &LetteredAt { source, texts_at: &texts_at, contours_at: &contours_at },
        words,
        written,
        plan,
        layout,
        layout_of,
    )
}

/// What is to have room: where a drawing's texts and contours lie in a layout.
pub(super) struct LetteredAt<'a> {
    /// The size of the drawing, px.
    pub(super) source: Size,
    /// Its texts.
    pub(super) texts_at: &'a dyn Fn(&Layout) -> Vec<Text>,
    /// Points of its contours.
    pub(super) contours_at: &'a dyn Fn(&Layout) -> Vec<MmPoint>,
}

/// As [`with_room`], of what is known in millimetres.
pub(super) fn with_room_for(
    drawing: &LetteredAt<'_>,
    words: &Words<'_>,
    written: &WrittenWords<'_>,
    plan: &Plan,
    layout: Layout,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
) -> Layout {
    let &LetteredAt { source, texts_at, contours_at } = drawing;
    let wants = |layout: &Layout| {
        let placed = texts_at(layout);
        own_texts(&placed, words).map(|text| (text.clone(), text.anchor())).collect::<Vec<(Text, MmRect)>>()
    };
    let own = wants(&layout);
    if own.is_empty() || own.len() > labels::MOST || written.translator().is_none() {
        return layout;
    }
    // in millimetres of the drawing as it would be without room, so that a word that has room once has it to the end
    let [across, down] = [layout.figure.width(), layout.figure.height()].map(|side| MOST * side);
    let row = CellGrid::of(&layout.medium, plan.profile().braille.cell).extent(1, 1).y;
    let down = down.max(2.0 * (row + BESIDE_ROW + layout.medium.pitch()));
    let with_reach = |across: f32| {
        let most = [across, down];
        let lacks = |layout: &Layout| lacks(&wants(layout), &contours_at(layout), written, layout, most, plan);
        let bounds = TextBounds { most, min_side: plan.profile().figure.min_side };
        widened(layout.clone(), source, bounds, lacks, layout_of)
    };
    let narrowed = with_reach(across);
    let blank = blank_beside(&layout, source, layout_of);
    if blank <= across {
        return narrowed;
    }
    let moved_aside = with_reach(blank);
    if is_as_large(moved_aside.figure.width(), narrowed.figure.width()) { moved_aside } else { narrowed }
}

/// How much wider a drawing can be with room beside it that costs it nothing, as the sheet is blank there, mm: it is
/// looked for up to two widths of the drawing.
fn blank_beside(own: &Layout, source: Size, layout_of: &dyn Fn(Size) -> Result<Layout, Error>) -> f32 {
    let mm_per_px = own.figure.width() / source.width as f32;
    let is_free = |more: u32| {
        let size = Size::new(source.width.saturating_add(more), source.height);
        layout_of(size).is_ok_and(|wider| is_as_large(wider.figure.width() / size.width as f32, mm_per_px))
    };
    let (mut free, mut step) = (0, source.width.saturating_mul(2));
    while step > source.width / STEPS_OF_BLANK {
        step /= 2;
        if is_free(free + step) {
            free += step;
        }
    }
    free as f32 * mm_per_px
}

/// Whether a drawing is as large as another, or hardly smaller.
fn is_as_large(width: f32, other: f32) -> bool {
    width >= (1.0 - HARDLY_SMALLER) * other
}

/// The layout with as much room on each side as lacks on it, found in rounds: more room makes the drawing smaller, and
/// then other words lack it. `lacks` is what lacks in a layout on each side, or is too much, mm.
fn widened(
    own: Layout,
    source: Size,
    TextBounds { most, min_side }: TextBounds,
    lacks: impl Fn(&Layout) -> [f32; 4],
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
) -> Layout {
    let mut best = own.clone();
    let mut room = [0.0_f32; 4];
    let mut is_settled = false;
    for round in 0..=ROUNDS {
        // the last round is another one
        if is_settled && round < ROUNDS {
            continue;
        }
        let px_per_mm = source.width as f32 / best.figure.width();
        // what words of the greatest reach lack, and the drawing itself may lie a step aside on the grid
        let widest = most.map(|reach| reach + moved(&best) + best.medium.pitch() + SLACK);
        let more = lacks(&best).map(|lack| lack * px_per_mm);
        let mut changes = false;
        for (side, lack) in more.into_iter().enumerate() {
            let wanted = room[side] + lack;
            // in the end room falls away that nothing stands in, as what it was for is abbreviated after all
            let is_needed = lack > 0.0 && round < ROUNDS && wanted <= widest[side % 2] * px_per_mm;
            if lack.abs() > SLACK * px_per_mm && (is_needed || lack < 0.0 && round == ROUNDS && room[side] > 0.0) {
                room[side] = wanted.max(0.0);
                changes = true;
            }
        }
        is_settled = !changes;
        if is_settled {
            continue;
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
    if room.iter().all(|px| *px <= 0.0) { own } else { best }
}

/// The drawing in a layout of a larger size, so many pixels from its left and upper edge.
fn within(outer: Layout, own: &Layout, [left, top]: [f32; 2], size: Size, source: Size) -> Layout {
    let mm_per_px = outer.figure.width() / size.width as f32;
    // on a grid of dots in whole steps, as the larger one lies on it
    let step = outer.medium.pitch();
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

/// Where the contours of a picture are seen, px: between two pixels that differ.
fn contours(raster: &Raster) -> Vec<PxPoint> {
    let (width, height) = (raster.size().width as usize, raster.size().height as usize);
    let mut at = Vec::new();
    for plane in raster.planes().iter() {
        let light: Vec<f32> = plane.iter().map(|value| value.max(0.0).sqrt()).collect();
        let differ = |i: usize, j: usize| (light[i] - light[j]).abs() >= CONTOUR;
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let (i, to) = (y * width + x, PxPoint::new(x as f32 + 1.0, y as f32 + 1.0));
            if x + 1 < width && differ(i, i + 1) {
                at.push(PxPoint::new(to.x, to.y - 0.5));
            }
            if y + 1 < height && differ(i, i + width) {
                at.push(PxPoint::new(to.x - 0.5, to.y));
            }
        }
    }
    at
}

/// How much room texts lack on the left, above, on the right and below, mm, or have too much: where they would stand if
/// there were as much as there may be at most, across and down, mm. What has no room there either is abbreviated.
fn lacks(
    texts: &[(Text, MmRect)],
    contours: &[MmPoint],
    written: &WrittenWords<'_>,
    layout: &Layout,
    [across, down]: [f32; 2],
    plan: &Plan,
) -> [f32; 4] {
    let Some(translator) = written.translator() else { return [0.0; 4] };
    let (figure, cells) = (layout.figure, CellGrid::of(&layout.medium, plan.profile().braille.cell));
    let within = label_params::params(layout, &[], plan);
    let params = labels::Params { area: layout.figure.inflate(across, down), ..within };
    let wanted: Vec<Wanted> = texts
        .iter()
        .map(|(text, anchor)| Wanted {
            text: text.string.clone(),
            anchor: *anchor,
            lost_leader: None,
            kept_leader: None,
            is_nameless: false,
        })
        .collect();
    // on a grid a line may lie a step aside and have a second row
    let line_width = match &layout.medium {
        Medium::Print(_) => plan.lines().width_max,
        Medium::Dots(dots) => dots.diameter() + 2.0 * dots.pitch,
    };
    let step = layout.medium.pitch();
    let longer_to = match &layout.medium {
        Medium::Print(_) => Some(plan.lines().min_length),
        Medium::Dots(_) => None,
    };
    let predicted = RowPrediction { wanted: &wanted, contours, line_width, longer_to, params: &params };
    let [left, top, right, bottom] = row_overhang(&predicted, &cells, translator, layout.room);
    let [left, top, right, bottom] = [left, top, right, bottom].map(|lack| lack + moved(layout));
    // a word above all else, such as a heading, is higher than its print
    let height = cells.extent(1, 1).y + step;
    let is_heading =
        |text: &&Text| text.angle.abs() < 1.0 && text.place.center().y - figure.min.y < AT_EDGE * figure.height();
    let headings = texts.iter().map(|(text, _)| text).filter(is_heading);
    let of_heading = |text: &Text| layout.room.min.y - (text.place.center().y - 0.5 * height - LOWER - 0.5 * CLEARANCE);
    let top = headings.map(of_heading).filter(|lack| *lack <= down).fold(top, f32::max);
    [left, top, right, bottom]
}

/// How far a label may stand beside where it is predicted, mm: lines are moved apart, and on a grid braille may move
/// by a step, to where its cells can stand.
fn moved(layout: &Layout) -> f32 {
    layout.medium.pitch() + MOVED
}

/// Share of the drawing's height in which a heading stands.
const AT_EDGE: f32 = 0.15;

#[cfg(test)]
mod tests;
