//! The colours of lines that have no room. Whoever makes a page knows the curves of a chart by their colours, so it is
//! told where much of one colour is not drawn.

use super::legend::places_along;
use super::on_sheet::on_sheet;
use crate::classes::{Class, class_at};
use crate::edges::{ChainRange, Edges};
use crate::geom::polyline;
use crate::lines::{Lines, LostLine};
use crate::listing::list;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason, Told};

/// Share of the lines of a colour from which on it is told that they are missing.
const TOLD: f32 = 0.2;
/// Lines of a colour are at most so many times as long as its strokes, as both are rounded: where more is missing, some
/// strokes are not known by their colour, and how large the share is nobody knows.
const AS_LONG: f32 = 1.1;
/// A line has the colour of a stroke if the box around what of the stroke is in its own, and so far around it, mm, has
/// the same sides: off by so much together, mm, and by this share of them.
const AROUND: f32 = 1.0;
const OFF: f32 = 4.0;
const OFF_SHARE: f32 = 0.2;

/// A stroke of the picture, and its colour.
#[derive(Debug, Clone)]
struct ColouredStroke {
    class: Class,
    points: Vec<MmPoint>,
    extent: MmRect,
}

impl ColouredStroke {
    fn new(class: Class, points: Vec<MmPoint>) -> Self {
        Self { class, extent: MmRect::from_points(&points), points }
    }
}

/// What the maker of a drawing is told of the colours of lines of which much is not on the page.
pub(super) fn told(drawn: &Lines, edges: &Edges, raster: &Raster, layout: &Layout, plan: &Plan) -> Option<Note> {
    let all = drawn.lost.gone.iter().chain(&drawn.lost.torn).copied();
    let lost: Vec<LostLine> = all.filter(|line| !line.is_faint && !line.closed).collect();
    if lost.is_empty() || raster.is_grey() || !edges.of_drawing() {
        return None;
    }
    let transform = PageTransform::new(edges.size, layout.figure);
    let params = plan.classes(transform.px_per_mm());
    let stroke = |chain: &ChainRange| {
        let places = places_along(edges, chain, chain.kind.stroke?, raster).into_iter();
        let on_ground = places.filter(|(_, ground)| ground.is_some());
        let class = most_common(&on_ground.filter_map(|(at, _)| class_at(raster, at, &params)).collect::<Vec<_>>())?;
        Some(ColouredStroke::new(class, on_sheet(edges, chain, &transform).collect()))
    };
    let strokes: Vec<ColouredStroke> = edges.chains.iter().filter_map(stroke).collect();
    told_of(&lost, &strokes)
}

/// The class of most; none of none.
fn most_common(classes: &[Class]) -> Option<Class> {
    let count = |class: &Class| classes.iter().filter(|other| *other == class).count();
    Class::ALL.into_iter().max_by_key(count).filter(|class| count(class) > 0)
}

fn told_of(lost: &[LostLine], strokes: &[ColouredStroke]) -> Option<Note> {
    // where all are of one colour, how much is missing is told without it
    let is_of_several = strokes.iter().any(|stroke| stroke.class != strokes[0].class);
    if !is_of_several {
        return None;
    }
    let missing: Vec<(Class, f32)> =
        lost.iter().filter_map(|line| Some((class_of(line.extent, strokes)?, line.length))).collect();
    let of_colour = |class: Class| {
        let missing: f32 = missing.iter().filter(|(of, _)| *of == class).map(|(_, length)| length).sum();
        let own = strokes.iter().filter(|stroke| stroke.class == class);
        let own: f32 = own.map(|stroke| polyline::length(&stroke.points)).sum();
        let name = class.name();
        (missing > 0.0 && missing >= TOLD * own).then(|| {
            if missing > AS_LONG * own {
                return format!("{missing:.0} mm of the {name} lines");
            }
            let percent = (100.0 * missing / own).round().min(100.0);
            format!("{percent} percent of the {name} lines ({missing:.0} mm)")
        })
    };
    let colours = Class::ALL.into_iter().filter(|class| *class != Class::Grey);
    let each: Vec<String> = colours.filter_map(of_colour).collect();
    (!each.is_empty()).then(|| {
        let told = format!("{}: there is no room for them beside other lines", list(&each, "and"));
        let helped = Told::from(told).or_larger().or("say in a label how these go on");
        Note::NotOnPage(About::Lines, Reason::NoRoomForLine, helped)
    })
}

/// The colour of the stroke that a lost line, with this box around it, is or is a piece of; none where it may be one of
/// two.
fn class_of(extent: MmRect, strokes: &[ColouredStroke]) -> Option<Class> {
    let around = extent.inflate(AROUND, AROUND);
    let off = |stroke: &ColouredStroke| {
        if !around.intersects(&stroke.extent) {
            return None;
        }
        let inside: Vec<MmPoint> = stroke.points.iter().copied().filter(|at| around.contains(*at)).collect();
        let own = MmRect::from_points(&inside);
        let (low, high) = (own.min - extent.min, own.max - extent.max);
        (!inside.is_empty()).then(|| low.x.abs() + low.y.abs() + high.x.abs() + high.y.abs())
    };
    let most = OFF + OFF_SHARE * (extent.width() + extent.height());
    let all = strokes.iter().filter_map(|stroke| Some((off(stroke)?, stroke.class)));
    let mut near: Vec<(f32, Class)> = all.filter(|(off, _)| *off <= most).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let &(least, class) = near.first()?;
    // two that cross from corner to corner have one box
    near.iter().all(|(off, of)| *of == class || *off > least + OFF).then_some(class)
}

#[cfg(test)]
mod tests;
