//! All marks of a page as strokes and rhombuses, with the part of the page that each belongs to, and the exact blank
//! between any two.

use crate::geom::nearby::Index;
use crate::geom::polygon::{exit, is_in_convex};
use crate::geom::{crossing, nearest_on_segment, segment_distance};
use crate::page::{Dots, Glyph, Line, Names, Page, Pen, Run, Shape, text_name};
use crate::units::{Mm, MmPoint, MmRect};

/// What a mark is a part of; numbers count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum PageObject {
    OrientationMark,
    Tick,
    Frame,
    Texture(u32),
    Line(u32),
    OverviewFrame,
    OverviewLine(u32),
    /// Numbers of samples and sheets.
    Numbers(u32),
    Braille(u32),
    Leader(u32),
}

/// A stroke with round ends (a dot is one of no length), or a rhombus.
#[derive(Debug, Clone, Copy)]
pub(super) enum MarkOutline {
    Stroke { a: MmPoint, b: MmPoint, radius: f32 },
    Rhombus { corners: [MmPoint; 4] },
}

/// One mark.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    pub(super) outline: MarkOutline,
    pub(super) part: PageObject,
    /// Its middle and how far it reaches from there, mm.
    pub(super) middle: MmPoint,
    pub(super) reach: f32,
}

impl Mark {
    pub(super) fn stroke(a: MmPoint, b: MmPoint, radius: f32, part: PageObject) -> Self {
        let reach = 0.5 * (b - a).length() + radius;
        Self { outline: MarkOutline::Stroke { a, b, radius }, part, middle: a.lerp(b, 0.5), reach }
    }

    fn glyph(glyph: &Glyph, part: PageObject) -> Self {
        match glyph.shape {
            Shape::Dot { diameter } => Self::stroke(glyph.at, glyph.at, 0.5 * diameter, part),
            Shape::Rhombus { .. } => {
                let outline = MarkOutline::Rhombus { corners: glyph.corners() };
                Self { outline, part, middle: glyph.at, reach: glyph.radius() }
            }
        }
    }

    /// The box around it.
    pub(super) fn extent(&self) -> MmRect {
        match self.outline {
            MarkOutline::Stroke { a, b, radius } => MmRect::new(a.min(b), a.max(b)).inflate(radius, radius),
            MarkOutline::Rhombus { corners: [a, b, c, d] } => {
                MmRect::new(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
            }
        }
    }

    /// The middle line; of a rhombus, which is small, its middle.
    fn middle_line(&self) -> (MmPoint, MmPoint) {
        match self.outline {
            MarkOutline::Stroke { a, b, .. } => (a, b),
            MarkOutline::Rhombus { .. } => (self.middle, self.middle),
        }
    }

    /// Where it lies on another mark, and the box around that.
    pub(super) fn meeting(&self, other: &Self) -> (MmPoint, MmRect) {
        let ((a, b), (c, d)) = (self.middle_line(), other.middle_line());
        let ends = [(a, c, d), (b, c, d), (c, a, b), (d, a, b)].map(|(end, from, to)| {
            let (distance, nearest) = nearest_on_segment(end, from, to);
            (distance, end.lerp(nearest, 0.5))
        });
        let nearest = ends.into_iter().min_by(|one, two| one.0.total_cmp(&two.0)).map_or(a, |(_, at)| at);
        let at = crossing((a, b), (c, d)).unwrap_or(nearest);
        (at, self.extent().intersection(&other.extent()).unwrap_or_else(|| MmRect::new(at, at)))
    }

    /// Where it leaves a box, and the box around what is outside; its middle where no part of it is inside.
    pub(super) fn outside(&self, place: MmRect) -> (MmPoint, MmRect) {
        let MarkOutline::Stroke { a, b, radius } = self.outline else { return (self.middle, self.extent()) };
        let inner = place.inflate(-radius, -radius);
        let Some(at) = exit(a, b, inner) else { return (self.middle, self.extent()) };
        let tip = if inner.contains_inclusive(a) { b } else { a };
        (at, MmRect::new(at.min(tip), at.max(tip)).inflate(radius, radius))
    }

    /// The blank between two marks, mm; 0 or less where they touch.
    pub(super) fn blank(&self, other: &Self) -> f32 {
        match (self.outline, other.outline) {
            (MarkOutline::Stroke { a, b, radius }, MarkOutline::Stroke { a: c, b: d, radius: other }) => {
                segment_distance((a, b), (c, d)) - radius - other
            }
            (MarkOutline::Rhombus { corners }, MarkOutline::Stroke { a, b, radius })
            | (MarkOutline::Stroke { a, b, radius }, MarkOutline::Rhombus { corners }) => {
                to_segment(&corners, (a, b)) - radius
            }
            (MarkOutline::Rhombus { corners }, MarkOutline::Rhombus { corners: other }) => {
                let sides = (0..4).map(|i| to_segment(&corners, (other[i], other[(i + 1) % 4])));
                if is_in_convex(corners[0], &other) { 0.0 } else { sides.fold(f32::MAX, f32::min) }
            }
        }
    }

    /// Whether the blank between two marks can be less than `least` at all; a quick look.
    pub(super) fn may_be_within(&self, other: &Self, least: f32) -> bool {
        let reach = self.reach + other.reach + least;
        if (self.middle - other.middle).square_length() >= reach * reach {
            return false;
        }
        // a segment is much longer than it is broad: the circle around it says little
        match (self.outline, other.outline) {
            (MarkOutline::Rhombus { .. }, MarkOutline::Stroke { a, b, radius }) => {
                nearest_on_segment(self.middle, a, b).0 < self.reach + radius + least
            }
            (MarkOutline::Stroke { a, b, radius }, MarkOutline::Rhombus { .. }) => {
                nearest_on_segment(other.middle, a, b).0 < other.reach + radius + least
            }
            (MarkOutline::Stroke { .. }, MarkOutline::Stroke { .. })
            | (MarkOutline::Rhombus { .. }, MarkOutline::Rhombus { .. }) => true,
        }
    }
}

/// The distance of a rhombus to a segment; 0 where they touch.
fn to_segment(corners: &[MmPoint; 4], (a, b): (MmPoint, MmPoint)) -> f32 {
    if is_in_convex(a, corners) {
        return 0.0;
    }
    if a == b {
        let sides = (0..4).map(|i| nearest_on_segment(a, corners[i], corners[(i + 1) % 4]).0);
        return sides.fold(f32::MAX, f32::min);
    }
    let sides = (0..4).map(|i| segment_distance((corners[i], corners[(i + 1) % 4]), (a, b)));
    sides.fold(f32::MAX, f32::min)
}

/// All marks of a page.
pub(super) fn marks_of(page: &Page) -> Vec<Mark> {
    let mut marks = Vec::new();
    let runs = |marks: &mut Vec<Mark>, run: &Run, part: PageObject| match run.pen {
        Pen::Stroke => {
            let segments = run.polyline().segments();
            marks.extend(segments.map(|(a, b)| Mark::stroke(*a, *b, 0.5 * run.width, part)));
        }
        Pen::Dots(_) => marks.extend(run.points.iter().map(|&at| Mark::stroke(at, at, 0.5 * run.width, part))),
    };
    let dots = |marks: &mut Vec<Mark>, dots: &Dots, part: PageObject| {
        marks.extend(dots.at.iter().map(|&at| Mark::stroke(at, at, 0.5 * dots.diameter, part)));
    };
    let lines = |marks: &mut Vec<Mark>, lines: &[Line], part: fn(u32) -> PageObject| {
        for (number, line) in (0..).zip(lines) {
            line.runs.iter().for_each(|run| runs(marks, run, part(number)));
        }
    };
    page.orientation_mark.iter().for_each(|run| runs(&mut marks, run, PageObject::OrientationMark));
    page.registration.iter().for_each(|run| runs(&mut marks, run, PageObject::Tick));
    dots(&mut marks, &page.frame, PageObject::Frame);
    for (number, texture) in (0..).zip(&page.figure.textures) {
        marks.extend(texture.glyphs.iter().map(|glyph| Mark::glyph(glyph, PageObject::Texture(number))));
    }
    lines(&mut marks, &page.figure.lines, PageObject::Line);
    if let Some(overview) = &page.overview {
        dots(&mut marks, &overview.frame, PageObject::OverviewFrame);
        lines(&mut marks, &overview.lines, PageObject::OverviewLine);
    }
    (0..).zip(&page.labels).for_each(|(number, label)| dots(&mut marks, label, PageObject::Numbers(number)));
    for (number, text) in (0..).zip(&page.braille) {
        dots(&mut marks, &text.dots, PageObject::Braille(number));
        text.leader.iter().for_each(|run| runs(&mut marks, run, PageObject::Leader(number)));
    }
    marks
}

/// Numbers of marks, to be found by place.
pub(super) fn index(marks: &[Mark], cell: f32) -> Index<u32, Mm> {
    let area = super::finding::around(marks.iter().map(|mark| mark.middle)).unwrap_or_else(MmRect::zero);
    let mut index = Index::new(area, cell);
    for (number, mark) in (0..).zip(marks) {
        let extent = mark.extent();
        index.put_over(extent.min, extent.max, number);
    }
    index
}

impl PageObject {
    /// What it is called in a message.
    pub(super) fn name(self, page: &Page, names: &Names) -> String {
        match self {
            Self::OrientationMark => "the orientation mark".into(),
            Self::Tick => "a tick".into(),
            Self::Frame => "the frame".into(),
            Self::Texture(number) => name_in(&names.areas, number as usize).to_owned(),
            Self::Line(number) => name_in(&names.lines, number as usize).to_owned(),
            Self::OverviewFrame => "the frame of the overview".into(),
            Self::OverviewLine(number) => name_in(&names.overview_lines, number as usize).to_owned(),
            Self::Numbers(_) => "a number in braille, or a dot that was drawn".into(),
            Self::Braille(number) => page.braille.get(number as usize).map_or_else(String::new, text_name),
            Self::Leader(number) => {
                format!("the line that leads from {}", Self::Braille(number).name(page, names))
            }
        }
    }
}

/// The name of an object, as far as there is one.
pub(super) fn name_in(names: &[String], number: usize) -> &str {
    names.get(number).map_or("a mark without a name", String::as_str)
}
