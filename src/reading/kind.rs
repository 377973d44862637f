//! What a painted path is taken as: by its layer, its paint and its shape.

use std::collections::BTreeMap;

use super::areas::{self, DrawnArea};
use super::marks::{PaintedShape, PaintedStroke};
use super::shapes::disc;
use super::subpath::Subpath;
use super::tally::What;
use super::tone::Tone;
use crate::geom::polyline;
use crate::output::layer::{self, Layer};
use crate::page::{Class, Height, Pen, Run};
use crate::units::MmPoint;

/// Width of a line where none is given and there are no others, mm.
const COMMON_WIDTH: f32 = 1.0;

/// A disc is a dot up to this diameter, mm, also where it has the stroke of the lines among which it lies: no dot of a
/// page or a device is larger, and no line as short as the way around it.
const LARGEST_DOT: f32 = 3.0;

/// What a path is taken as.
pub(super) enum Kind {
    /// It is not on the page, for this reason.
    LeftOut(What),
    /// It prints nothing, or no more than its area.
    Blank,
    /// Strokes.
    Strokes(Vec<Run>),
    /// Signs of a texture.
    Signs(Class),
    /// Dots, with their middles and diameters.
    Discs(Vec<(MmPoint, f32)>, Height),
    /// A filled shape: lines around it, in this layer.
    Around(Vec<Run>, Layer),
}

/// A path that was looked at.
pub(super) struct Sorted {
    pub(super) kind: Kind,
    /// The area that it is.
    pub(super) area: Option<DrawnArea>,
    /// In what it is taken otherwise than it looks.
    pub(super) told: Vec<What>,
}

/// What is known of the page to which paths belong.
pub(super) struct Sorter {
    /// Whether it is no page of ours but another drawing with a layer of ours: then nothing else of it counts.
    pub(super) is_foreign: bool,
    pub(super) sheet: [f32; 2],
    /// Whether greys are heights.
    pub(super) has_heights: bool,
    /// Whether it is a page of dots, which all have one size.
    pub(super) is_dotted: bool,
    /// Width of a line that is drawn where none is given, mm.
    pub(super) common_width: f32,
}

impl Sorter {
    pub(super) fn sort(&self, mark: &PaintedShape<'_>) -> Sorted {
        let left_out = |what: What| Sorted { kind: Kind::LeftOut(what), area: None, told: Vec::new() };
        if self.is_foreign && mark.layer.is_none() {
            return left_out(What::Foreign);
        }
        if mark.layer == Some(Layer::PrintWords) {
            return left_out(What::InPrint);
        }
        if mark.is_white() && !mark.covers(self.sheet) {
            return left_out(What::White);
        }
        let area = if self.is_foreign { None } else { areas::of(mark) };
        let (kind, told) = match mark.stroke.as_ref().filter(|stroke| stroke.is_seen()) {
            Some(stroke) => match self.dots_among_lines(mark, stroke) {
                Some(dots) => (dots, Vec::new()),
                None => self.stroke(mark, stroke),
            },
            None if area.is_some() => (Kind::Blank, Vec::new()),
            None => self.filled(mark),
        };
        Sorted { kind, area, told }
    }

    fn stroke(&self, mark: &PaintedShape<'_>, stroke: &PaintedStroke) -> (Kind, Vec<What>) {
        // a shape that is drawn in the overview, which has lines only, has the stroke of its layer
        let fill = mark.fill.filter(|tone| mark.layer == Some(Layer::Overview) && !tone.is_white);
        let is_shaded = stroke.tone.is_shaded() || fill.is_some_and(|tone| tone.is_shaded());
        let shaded = (is_shaded && !self.has_heights).then_some(What::Shaded);
        let dashed = stroke.is_dashed.then_some(What::Dashed);
        let outlined = fill.map(|tone| outlined(mark, tone));
        let runs = mark.subpaths.iter().map(|subpath| run(subpath, stroke.width)).collect();
        (Kind::Strokes(runs), shaded.into_iter().chain(dashed).chain(outlined).collect())
    }

    /// The dots that a person drew in the layer of lines, as which black discs with the stroke of that are meant.
    fn dots_among_lines(&self, mark: &PaintedShape<'_>, stroke: &PaintedStroke) -> Option<Kind> {
        let is_by_hand = !self.is_foreign && !mark.element.has_attribute("data-strength");
        let is_black = stroke.tone.is_black && mark.fill.is_some_and(|tone| tone.is_black);
        if mark.layer != Some(Layer::Lines) || !is_by_hand || !is_black {
            return None;
        }
        let rim = if self.is_dotted { 0.0 } else { stroke.width };
        let dot = |subpath: &Subpath| disc(subpath).map(|(at, diameter)| (at, diameter + rim));
        let dots: Vec<(MmPoint, f32)> = mark.subpaths.iter().map(dot).collect::<Option<_>>()?;
        dots.iter().all(|(_, diameter)| *diameter <= LARGEST_DOT).then(|| Kind::Discs(dots, Height::default()))
    }

    fn filled(&self, mark: &PaintedShape<'_>) -> (Kind, Vec<What>) {
        let Some(tone) = mark.fill.filter(|tone| !tone.is_white) else { return (Kind::Blank, Vec::new()) };
        let mut told: Vec<What> = (tone.is_shaded() && !self.has_heights).then_some(What::Shaded).into_iter().collect();
        if let Some(Layer::Texture(class)) = mark.layer {
            return (Kind::Signs(class), told);
        }
        if let Some(discs) = mark.subpaths.iter().map(disc).collect() {
            return (Kind::Discs(discs, layer::height(tone.grey)), told);
        }
        told.push(outlined(mark, tone));
        // what has but two points is a line there and back
        let closed = |subpath: &Subpath| Subpath { closed: subpath.points.len() > 2, ..subpath.clone() };
        let around = mark.subpaths.iter().map(|subpath| run(&closed(subpath), self.common_width)).collect();
        let layer = if mark.layer == Some(Layer::Overview) { Layer::Overview } else { Layer::Lines };
        (Kind::Around(around, layer), told)
    }
}

/// What is told of a filled shape that is no area, and so a line around it: why it is none.
fn outlined(mark: &PaintedShape<'_>, tone: Tone) -> What {
    match tone.is_shaded() {
        false => What::Outlined,
        true if areas::may_lie_in(mark.layer) => What::OutlinedSmall,
        true => What::OutlinedThere,
    }
}

fn run(subpath: &Subpath, width: f32) -> Run {
    Run { width, points: subpath.points.clone(), closed: subpath.closed, pen: Pen::Stroke }
}

/// The width of most strokes of lines, by their lengths, mm.
pub(super) fn common_width(marks: &[PaintedShape<'_>]) -> f32 {
    let mut lengths: BTreeMap<u32, f32> = BTreeMap::new();
    let is_line = |mark: &&PaintedShape<'_>| matches!(mark.layer, Some(Layer::Lines | Layer::Overview));
    for mark in marks.iter().filter(is_line) {
        if let Some(stroke) = mark.stroke.as_ref().filter(|stroke| stroke.is_seen()) {
            let length: f32 = mark.subpaths.iter().map(|subpath| polyline::length(&subpath.points)).sum();
            *lengths.entry((100.0 * stroke.width).round() as u32).or_default() += length;
        }
    }
    let most = lengths.into_iter().reduce(|most, of| if of.1 > most.1 { of } else { most });
    most.map_or(COMMON_WIDTH, |(hundredths, _)| hundredths as f32 / 100.0)
}
