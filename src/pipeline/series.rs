//! Bars of one colour are a series of a chart, which its legend names by that colour. So all of them have its texture
//! or none: of a series of which only the high bars have one, the low ones would be taken for another series.

use std::collections::BTreeSet;

use super::bars::Chart;
use super::given::blank_cells;
use super::legend::LegendEntry;
use super::progress::Watch;
use super::textures::{cell_at, draw_textures, take_unlearned, without_unlearned};
use crate::classes::{Class, Classes, Region};
use crate::edges::Edges;
use crate::geom::components::{Connectivity, of_labels};
use crate::lines::Line;
use crate::listing::list;
use crate::page::layout::Layout;
use crate::page::{Glyph, Medium, Texture};
use crate::profile::Plan;
use crate::textures::{leave_out_cells, leave_out_crumbs};
use crate::units::{MmPoint, MmRect, MmVector, PageTransform};
use crate::{About, Note, Reason, Told};

/// The colour of a bar is looked for so far inside of its outline, mm: there no stroke lies.
const INSIDE: f32 = 0.8;
/// A bar has the colour of at least this share of its cells; the parts of a stacked bar have several.
const MOSTLY: f32 = 0.6;
/// An area with more cells than so many of the largest bar is no bar.
const AS_BARS: usize = 2;

/// A bar of a chart that has one colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ColouredBar {
    place: MmRect,
    class: Class,
}

/// The bars of a drawing's chart by the colours of these areas, of which the smallest are smaller than bars are.
pub(super) fn of(edges: &Edges, fine: &Classes, figure: MmRect) -> Vec<ColouredBar> {
    let Some(chart) = Chart::of(edges) else { return Vec::new() };
    let transform = PageTransform::new(edges.size, figure);
    let bar = |bar| {
        let place = MmRect::from_points(chart.outline(bar).into_iter().map(|at| transform.to_mm(at)));
        let cells: Vec<usize> = cells_in(place.inflate(-INSIDE, -INSIDE), fine, figure).collect();
        let count = |class: Class| cells.iter().filter(|cell| class_of(fine, **cell) == Some(class)).count();
        let (class, own) = Class::ALL.into_iter().map(|class| (class, count(class))).max_by_key(|(_, count)| *count)?;
        (own > 0 && own as f32 >= MOSTLY * cells.len() as f32).then_some(ColouredBar { place, class })
    };
    chart.bars.iter().filter_map(bar).collect()
}

/// Gives bars their colour in areas that are larger than the smallest bars.
pub(super) fn colour(classes: &mut Classes, fine: &Classes, bars: &[ColouredBar], figure: MmRect) {
    for bar in bars {
        let number = classes.regions.len() as u32;
        let is_own = |cell: &usize| class_of(fine, *cell) == Some(bar.class);
        let cells: Vec<usize> = cells_in(bar.place, fine, figure).filter(is_own).collect();
        let Some(colour) = cells.first().and_then(|&cell| Some(fine.regions[fine.region[cell]? as usize].colour))
        else {
            continue;
        };
        let lacks = |cell: &&usize| class_of(classes, **cell) != Some(bar.class);
        let lacking: Vec<usize> = cells.iter().filter(lacks).copied().collect();
        // the rim of an area is smoothed
        if (lacking.len() as f32) < (1.0 - MOSTLY) * cells.len() as f32 {
            continue;
        }
        for cell in lacking {
            if let Some(region) = classes.region[cell].replace(number) {
                classes.regions[region as usize].cells -= 1;
            }
        }
        let cells = classes.region.iter().filter(|region| **region == Some(number)).count() as u32;
        classes.regions.push(Region { class: bar.class, colour, cells });
    }
}

fn class_of(classes: &Classes, cell: usize) -> Option<Class> {
    classes.region[cell].map(|number| classes.regions[number as usize].class)
}

/// The cells of a figure with their middle in a box.
fn cells_in(place: MmRect, classes: &Classes, figure: MmRect) -> impl Iterator<Item = usize> + use<> {
    let (width, height) = (classes.size.width, classes.size.height);
    let range = |from: f32, to: f32, count: u32| {
        let at = |share: f32| (share * count as f32).round().clamp(0.0, count as f32) as usize;
        at(from)..at(to).max(at(from))
    };
    let share = |at: MmPoint| (at - figure.min).component_div(figure.size().to_vector());
    let (low, high): (MmVector, MmVector) = (share(place.min), share(place.max));
    let columns = range(low.x, high.x, width);
    range(low.y, high.y, height).flat_map(move |y| columns.clone().map(move |x| y * width as usize + x))
}

/// A series whose bars have no texture, or some of them.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Lacking {
    class: Class,
    /// How many bars it has, and how many of them have none.
    bars: usize,
    bare: usize,
}

/// What textures are laid in.
#[derive(Debug, Clone, Copy)]
pub(super) struct TexturedPicture {
    /// Whether it is a drawing, and no photograph.
    pub(super) is_drawing: bool,
    /// Whether it has labels.
    pub(super) has_labels: bool,
}

/// The textures of the figure, those of bars alike in each series, and what is told of areas without any. Entries of
/// the legend whose series have bars without one are marked; without one, colours without any texture are added.
pub(super) fn textured(
    areas: Option<(Classes, Vec<ColouredBar>)>,
    (legend, picture): (&mut Vec<LegendEntry>, TexturedPicture),
    layout: &Layout,
    lines: &[Line],
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> (Vec<Texture>, Vec<Note>) {
    let (mut classes, bars) = areas.unzip();
    let mut textures = draw_textures(classes.as_ref(), layout, lines, plan, watch);
    // on a grid of dots they are looked at where labels stand
    if matches!(layout.medium, Medium::Print(_)) {
        if !picture.is_drawing {
            leave_out_crumbs(&mut textures, &plan.textures());
        }
        if picture.has_labels {
            leave_out_cells(&mut textures, &plan.textures());
        }
    }
    let mut notes = Vec::new();
    if let (Some(classes), Some(bars)) = (&mut classes, bars) {
        let is_of_bars = |class: Class| bars.iter().any(|bar| bar.class == class);
        take_unlearned(&mut textures, plan.profile().colours.min_area, is_of_bars);
        notes.extend(made_alike(&bars, classes, &mut textures, legend, layout.figure));
    }
    // where outlined areas became one colour each, little may be left of another
    notes.extend(without_unlearned(&mut textures, classes.as_ref(), lines, layout, picture.is_drawing, plan));
    (textures, notes)
}

/// Makes the bars of a series alike where one series lacks textures, or one has hardly any: no bar of it has one. A
/// series by itself has none where most of its bars have none. Where several lack some, nobody could tell these apart
/// then, so that they stay as they are. Tells of both.
fn made_alike(
    bars: &[ColouredBar],
    classes: &mut Classes,
    textures: &mut Vec<Texture>,
    legend: &mut Vec<LegendEntry>,
    figure: MmRect,
) -> Option<Note> {
    let has_sign = |bar: &ColouredBar| {
        let own = textures.iter().filter(|texture| texture.class == bar.class);
        own.flat_map(|texture| &texture.glyphs).any(|glyph| bar.place.contains(glyph.at))
    };
    let is_bare: Vec<bool> = bars.iter().map(|bar| !has_sign(bar)).collect();
    let count = |class: Class, is: &dyn Fn(usize) -> bool| {
        (0..bars.len()).filter(|&bar| bars[bar].class == class && is(bar)).count()
    };
    let series =
        |class: Class| Lacking { class, bars: count(class, &|_| true), bare: count(class, &|bar| is_bare[bar]) };
    let series: Vec<Lacking> = Class::ALL.into_iter().map(series).filter(|series| series.bars > 0).collect();
    let lacking: Vec<Lacking> = series.iter().copied().filter(|series| series.bare > 0).collect();
    // of one colour alone, the few bars that have a sign would seem to be others; that low ones have none says nothing
    let is_of_few = |of: &Lacking| of.bare < of.bars && 2 * of.bare >= of.bars;
    if lacking.is_empty() || series.len() < 2 && !lacking.iter().all(is_of_few) {
        return None;
    }
    let is_lacking = |class: Class| lacking.iter().any(|series| series.class == class);
    legend.iter_mut().for_each(|entry| entry.has_blank |= is_lacking(entry.class));
    let becomes_blank = |of: &Lacking| lacking.len() == 1 || 2 * of.bare >= of.bars;
    let (blanked, partly): (Vec<Lacking>, Vec<Lacking>) = lacking.iter().partition(|of| becomes_blank(of));
    let is_blanked = |class: Class| blanked.iter().any(|of| of.class == class);
    let own: Vec<MmRect> = bars.iter().filter(|bar| is_blanked(bar.class)).map(|bar| bar.place).collect();
    let areas = areas_of_chart(bars, classes, is_blanked, figure);
    let is_own = |glyph: &Glyph| {
        let [x, y] = cell_at(glyph.at, classes.size, figure);
        areas[y * classes.size.width as usize + x] || own.iter().any(|place| place.contains(glyph.at))
    };
    for texture in textures.iter_mut().filter(|texture| is_blanked(texture.class)) {
        texture.glyphs.retain(|glyph| !is_own(glyph));
    }
    textures.retain(|texture| !texture.glyphs.is_empty());
    if legend.is_empty() && series.len() > 1 {
        let is_gone = |class: &Class| !textures.iter().any(|texture| texture.class == *class);
        legend.extend(blanked.iter().map(|of| of.class).filter(is_gone).map(LegendEntry::of_blank));
    }
    let bare = bars.iter().zip(&is_bare).filter(|(_, is_bare)| **is_bare).map(|(bar, _)| bar.place);
    let blank: Vec<MmRect> = own.into_iter().chain(bare).collect();
    let cells: BTreeSet<usize> = blank.iter().flat_map(|place| cells_in(*place, classes, figure)).collect();
    let numbers: Vec<bool> = classes.regions.iter().map(|region| is_lacking(region.class)).collect();
    blank_cells(classes, |cell, region| numbers[region as usize] && (areas[cell] || cells.contains(&cell)));
    Some(told(&blanked, &partly))
}

/// Which cells lie in areas of some classes that reach into the chart of these bars, or are as near to it as a bar is
/// broad. Where a legend lies on a bar, only a part of that is found as one, or nothing.
fn areas_of_chart(bars: &[ColouredBar], classes: &Classes, is_of: impl Fn(Class) -> bool, figure: MmRect) -> Vec<bool> {
    let breadth = bars.iter().map(|bar| bar.place.width().min(bar.place.height())).fold(0.0, f32::max);
    let chart = MmRect::from_points(bars.iter().flat_map(|bar| [bar.place.min, bar.place.max]));
    let mut is_near = vec![false; classes.region.len()];
    cells_in(chart.inflate(breadth, breadth), classes, figure).for_each(|cell| is_near[cell] = true);
    let largest = bars.iter().map(|bar| cells_in(bar.place, classes, figure).count()).max().unwrap_or(0);
    let labels: Vec<Option<Class>> =
        (0..classes.region.len()).map(|cell| class_of(classes, cell).filter(|class| is_of(*class))).collect();
    let areas = of_labels(&labels, classes.size, Connectivity::Four);
    let is_bar = |area: &&[usize]| {
        labels[area[0]].is_some() && area.len() <= AS_BARS * largest && area.iter().any(|&cell| is_near[cell])
    };
    let mut is_in = vec![false; classes.region.len()];
    areas.iter().filter(is_bar).flatten().for_each(|&cell| is_in[cell] = true);
    is_in
}

/// What is told of series without textures, and of those of which some bars have none. Whether a key names them is told
/// where that is known (`Key::tell_of_blank`).
fn told(blanked: &[Lacking], partly: &[Lacking]) -> Note {
    let all = |of: &Lacking| match of.bars - of.bare {
        0 if of.bars == 1 => format!("the {} bar", of.class.name()),
        0 => format!("all {} {} bars", of.bars, of.class.name()),
        _ => format!(
            "all {} {} bars ({} for want of room, and the others so that all are alike)",
            of.bars,
            of.class.name(),
            of.bare
        ),
    };
    let some = |of: &Lacking| format!("{} of {} {} bars", of.bare, of.bars, of.class.name());
    let each: Vec<String> = blanked.iter().map(all).chain(partly.iter().map(some)).collect();
    let (so, label) = match blanked.len() {
        0 | 1 => ("", "say in labels which these are"),
        _ => ("; fingers cannot tell these series apart", "write labels at the bars"),
    };
    let (each, why) = (list(&each, "and"), "too small or too narrow for signs clear of lines");
    let told = format!("the textures of bars of the chart, {each}, as they are {why}{so}");
    let helped = Told::from(told).or_larger().or(label);
    Note::NotOnPage(About::Areas, Reason::BarsTooSmall, helped)
}

#[cfg(test)]
mod tests;
