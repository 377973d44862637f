//! Contours as data: polylines in the pixels of the source picture, whatever size the picture was worked on.
//!
//! Points are in *source space*: pixels of the upright source picture (after the turn that EXIF asks for), x right, y
//! down, pixel centres at +0.5; for an SVG drawing, its own CSS pixels. **Strength is the height of the colour step**
//! in units of lightness with the chroma axes of CIELAB counted twice (see `edges`): black against white is
//! 100.

use crate::edges::Edges;
use crate::geom::nearby::{Nearby, Segment};
use crate::lines::Line;
use crate::units::{MmPoint, MmRect, PageTransform, PxPoint, Size};

/// The contours of a picture.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Trace {
    /// Size of the picture, or of the part of it that was asked for with [`Options::crop`](crate::Options::crop), px.
    pub size: Size,
    /// The contours, in no promised order.
    pub polylines: Vec<Polyline>,
}

/// One contour: points and what is known of each as separate lists, for other programs.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Polyline {
    /// Whether the last point goes on to the first. The first point is not repeated.
    pub closed: bool,
    /// Its points, in pixels of the picture as it is upright (after the turn that EXIF asks for), or of the part of it
    /// that was asked for with [`Options::crop`](crate::Options::crop), from its upper left corner; the middle of the
    /// first pixel is (0.5, 0.5). In CSS pixels (1/96 inch) of an SVG drawing and of a page of PDF.
    pub points: Vec<PxPoint>,
    /// Strength at each point: the height of the colour step, in units of lightness with the chroma axes of CIELAB
    /// counted twice, less what speaks for texture around it; 0 and up. Black against white is 100, saturated colours
    /// beside one another have more, and of a step in a photograph a third to a half may be left.
    pub strength: Vec<f32>,
    /// For a line of the page, its width in mm from each point to the next; the last point of an open line has that of
    /// the piece before it.
    pub width_mm: Option<Vec<f32>>,
}

impl Trace {
    /// The contours as they were found in a working picture of the source picture of size `source`.
    pub(crate) fn of_edges(edges: &Edges, source: Size) -> Self {
        let scale = Scale::new(edges.size, source);
        let polylines = edges.chains().map(|chain| Polyline {
            closed: chain.closed,
            points: chain.vertices.iter().map(|edgel| scale.to_source(edgel.at)).collect(),
            strength: chain.vertices.iter().map(|edgel| edgel.strength).collect(),
            width_mm: None,
        });
        Self { size: source, polylines: polylines.collect() }
    }

    /// The lines of a page, which `transform` put into `area` of the sheet.
    ///
    /// A line says only how strong it is on the whole. The strength at a point is that of the nearest of the contours
    /// `edges` from which the lines were drawn; where none lies within `reach` mm, it is that of the whole line.
    pub(crate) fn of_lines(
        lines: &[Line],
        edges: &Edges,
        transform: &PageTransform,
        area: MmRect,
        reach: f32,
        source: Size,
    ) -> Self {
        let scale = Scale::new(edges.size, source);
        let strengths = Strengths::new(edges, transform, area, reach);
        let polylines = lines.iter().map(|line| {
            let mut points: Vec<MmPoint> = Vec::new();
            let mut width = Vec::new();
            for run in &line.runs {
                // Runs share the points where they meet; a point has the width of the run that it begins.
                points.truncate(width.len());
                points.extend(run.polyline().path());
                width.resize(points.len().saturating_sub(1), run.width);
            }
            let closed = points.len() > 3 && points.first() == points.last();
            if closed {
                points.pop();
            } else {
                width.extend(width.last().copied());
            }
            Polyline {
                closed,
                strength: points.iter().map(|&at| strengths.near(at).unwrap_or(line.strength)).collect(),
                points: points.iter().map(|&at| scale.to_source(transform.to_px(at))).collect(),
                width_mm: Some(width),
            }
        });
        Self { size: source, polylines: polylines.collect() }
    }
}

/// Contours on the sheet, to look up how strong they are somewhere.
struct Strengths<'a> {
    edges: &'a Edges,
    segments: Nearby,
    reach: f32,
}

impl<'a> Strengths<'a> {
    fn new(edges: &'a Edges, transform: &PageTransform, area: MmRect, reach: f32) -> Self {
        let mut segments = Nearby::new(area, reach);
        for (number, chain) in edges.chains().enumerate() {
            for (index, (a, b)) in chain.segments().enumerate() {
                let (a, b) = (transform.to_mm(a.at), transform.to_mm(b.at));
                segments.insert(Segment { a, b, half_width: 0.0, line: number as u32, index: index as u32, arc: 0.0 });
            }
        }
        Self { edges, segments, reach }
    }

    fn near(&self, at: MmPoint) -> Option<f32> {
        let (_, on, Segment { a, b, line, index, .. }) = self.segments.nearest(at, self.reach, |_| true)?;
        let chain = self.edges.chain(&self.edges.chains[line as usize]);
        let next = chain.next(index as usize, 1)?;
        let [from, to] = [index as usize, next].map(|i| chain.vertices[i].strength);
        let length = (b - a).length();
        let share = if length > 0.0 { (on - a).length() / length } else { 0.0 };
        Some(from + (to - from) * share)
    }
}

/// From the working picture to the source picture. Both axes have a scale of their own, as each side of the
/// working picture is rounded to whole pixels.
struct Scale {
    across: f64,
    down: f64,
}

impl Scale {
    fn new(working: Size, source: Size) -> Self {
        let scale = |source: u32, working: u32| f64::from(source) / f64::from(working.max(1));
        Self { across: scale(source.width, working.width), down: scale(source.height, working.height) }
    }

    fn to_source(&self, at: PxPoint) -> PxPoint {
        PxPoint::new((f64::from(at.x) * self.across) as f32, (f64::from(at.y) * self.down) as f32)
    }
}
