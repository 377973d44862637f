//! A drawing that is no page of this program, judged as ink: it is drawn at [`PX_PER_MM`], and what a disc of the least
//! width does not fit into is too narrow, be it black or white.
//!
//! Opening and closing by a disc (Serra 1982), through exact Euclidean distances (Felzenszwalb and Huttenlocher 2012).

use resvg::tiny_skia::{Color, Path, PathSegment, Pixmap, Transform};
use usvg::{Group, Node, Paint, Stroke, Tree};

use super::finding::FoundBreach;
use super::limits::{MediumLimits, RuleLimits};
use super::rules::{BLACK, FILLED, LINE_GAP, LINE_WIDTH, Rule};
use crate::geom::components::{self, Connectivity};
use crate::geom::distance::squared_distances;
use crate::reading::is_black;
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect, Size};

/// Pixels for a millimetre.
const PX_PER_MM: f32 = 8.0;
const SCALE: f32 = MM_PER_CSS_PX * PX_PER_MM;
/// What pixels may take off a width, mm.
const BLUR: f32 = 0.2;
/// Smaller places, in mm^2, are tips of ink, and corners between lines that meet.
const LEAST_THIN: f32 = 1.0;
const LEAST_NARROW: f32 = 6.0;
/// Ink is a block from this width on, mm, and from this area on, mm^2: APH has 1/4 inch as the least symbol.
const BLOCK: f32 = 6.4;
const LEAST_BLOCK: f32 = 60.0;
/// Longest side that is looked at, mm, as of what is felt.
const LONGEST: f32 = 700.0;
/// Most places of one rule that are told one by one.
const MOST: usize = 12;

/// Black pixels.
struct DrawnInk {
    size: Size,
    black: Vec<bool>,
}

/// What leads to the canvas on which a drawing is looked at.
pub fn to_canvas() -> Transform {
    Transform::from_scale(SCALE, SCALE)
}

/// The size of the canvas on which a drawing is looked at; none if that is too large.
pub fn canvas_of(tree: &Tree) -> Option<Size> {
    let [width, height] = [tree.size().width(), tree.size().height()].map(|side| (side * SCALE).ceil());
    (width.max(height) <= LONGEST * PX_PER_MM).then(|| Size::new(width as u32, height as u32))
}

/// What is wrong with a drawing, or nothing if it is too large to be drawn.
pub(super) fn findings(tree: &Tree, limits: &RuleLimits) -> Vec<FoundBreach> {
    let Some(ink) = DrawnInk::of(tree, is_dark) else { return Vec::new() };
    let (width, gap) = match limits.medium {
        MediumLimits::Print { line_width, line_gap, .. } => (line_width, line_gap),
        MediumLimits::Dots { pitch, line_gap, .. } => (0.5 * pitch, line_gap as f32 * pitch),
    };
    let mut found = ink.places(LINE_WIDTH, LEAST_THIN, ink.narrow(true, width), |area| {
        format!("{area:.0} square mm of ink are thinner than {width} mm")
    });
    found.extend(ink.places(LINE_GAP, LEAST_NARROW, ink.narrow(false, gap), |area| {
        format!("{area:.0} square mm of blank between black parts are narrower than {gap} mm")
    }));
    found.extend(ink.blocks());
    if let MediumLimits::Print { max_black, .. } = limits.medium {
        let share = ink.black.iter().filter(|black| **black).count() as f32 / ink.black.len() as f32;
        let what = || format!("{:.0} % of the sheet is black; {:.0} % is the most", 100.0 * share, 100.0 * max_black);
        found.extend((share > max_black).then(|| FoundBreach::of_page(BLACK, Some(100.0 * share), what())));
    }
    found
}

/// Large areas of a page that are all black. The page is only drawn if one of its shapes may be one: of its own marks
/// none is.
pub(super) fn blocks(tree: &Tree) -> Vec<FoundBreach> {
    if !may_have_block(tree.root()) {
        return Vec::new();
    }
    DrawnInk::of(tree, is_black_pixel).map_or_else(Vec::new, |ink| ink.blocks())
}

/// Whether a path could be a block: it has a black stroke as broad as one, or is filled black and has a contour whose
/// area and length are those of a square of its side, or of something broader.
fn may_have_block(group: &Group) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => may_have_block(group),
        Node::Path(path) if path.is_visible() => {
            let to_mm = path.abs_transform().post_scale(MM_PER_CSS_PX, MM_PER_CSS_PX);
            let scale = (to_mm.sx * to_mm.sy - to_mm.kx * to_mm.ky).abs().sqrt();
            let is_broad = |stroke: &Stroke| is_painted_black(stroke.paint()) && stroke.width().get() * scale >= BLOCK;
            let is_filled = path.fill().is_some_and(|fill| is_painted_black(fill.paint()));
            let geometry = || path.data().clone().transform(to_mm).is_some_and(|geometry| has_block(&geometry));
            path.stroke().is_some_and(is_broad) || is_filled && geometry()
        }
        Node::Path(_) | Node::Image(_) | Node::Text(_) => false,
    })
}

fn is_painted_black(paint: &Paint) -> bool {
    matches!(paint, Paint::Color(colour) if is_black([colour.red, colour.green, colour.blue]))
}

/// Whether a contour of a path, in mm, is as broad as a block. Curves count as their chords.
fn has_block(path: &Path) -> bool {
    let (mut contours, mut points) = (Vec::new(), Vec::new());
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(at) => contours.push(std::mem::replace(&mut points, vec![at])),
            PathSegment::LineTo(at) | PathSegment::QuadTo(_, at) | PathSegment::CubicTo(_, _, at) => points.push(at),
            PathSegment::Close => {}
        }
    }
    contours.push(points);
    contours.iter().any(|points| {
        let sides = points.iter().zip(points.iter().cycle().skip(1));
        let (twice_area, length) = sides.fold((0.0_f32, 0.0_f32), |(area, length), (a, b)| {
            (area + a.x * b.y - b.x * a.y, length + (b.x - a.x).hypot(b.y - a.y))
        });
        // chords take a third off the area of a circle of four curves
        0.5 * twice_area.abs() >= 0.6 * LEAST_BLOCK && twice_area.abs() >= 0.3 * BLOCK * length
    })
}

/// A pixel that prints rather black than white.
fn is_dark(pixel: &[u8]) -> bool {
    pixel[..3].iter().map(|&channel| u32::from(channel)).sum::<u32>() < 3 * 128
}

/// A pixel that is black, also on the antialiased rim of an area: what a person filled with a colour is to have its
/// texture.
fn is_black_pixel(pixel: &[u8]) -> bool {
    pixel[..3].iter().all(|&channel| channel < 64)
}

impl DrawnInk {
    /// Areas that are all black and broader than a symbol.
    fn blocks(&self) -> Vec<FoundBreach> {
        let narrow = self.narrow(true, BLOCK);
        let block = self.black.iter().zip(narrow).map(|(black, narrow)| *black && !narrow).collect();
        self.places(FILLED, LEAST_BLOCK, block, |area| {
            format!("a block of {area:.0} square mm is all black, of which only the edge is felt")
        })
    }

    /// The pixels that `is_ink`; none if the drawing is too large.
    fn of(tree: &Tree, is_ink: fn(&[u8]) -> bool) -> Option<Self> {
        let size = canvas_of(tree)?;
        let mut canvas = Pixmap::new(size.width, size.height)?;
        canvas.fill(Color::WHITE);
        resvg::render(tree, to_canvas(), &mut canvas.as_mut());
        let black = canvas.data().chunks_exact(4).map(is_ink).collect();
        Some(Self { size, black })
    }

    /// The black pixels (or the white ones) that no disc of this diameter, mm, covers that is all black (or white).
    /// Beyond the sheet all is white.
    fn narrow(&self, black: bool, diameter: f32) -> Vec<bool> {
        let radius = 0.5 * (diameter - BLUR).max(0.0) * PX_PER_MM;
        let outside = self.black.iter().map(|pixel| *pixel != black).collect::<Vec<_>>();
        let inner: Vec<bool> =
            squared_distances(&outside, self.size).into_iter().map(|to| to as f32 > radius * radius).collect();
        let reach = (radius + 1.0) * (radius + 1.0);
        let to_inner = squared_distances(&inner, self.size);
        outside.iter().zip(to_inner).map(|(outside, square)| !outside && square as f32 > reach).collect()
    }

    /// A finding for each connected place that is large enough; of many, the largest and the sum of the others.
    fn places(&self, rule: Rule, least: f32, marked: Vec<bool>, what: impl Fn(f32) -> String) -> Vec<FoundBreach> {
        let components = components::of_labels(&marked, self.size, Connectivity::Eight);
        let area = |count: usize| count as f32 / (PX_PER_MM * PX_PER_MM);
        let mut places: Vec<(f32, MmRect)> = components
            .iter()
            .filter(|nodes| marked[nodes[0]] && area(nodes.len()) >= least)
            .map(|nodes| (area(nodes.len()), self.extent(nodes)))
            .collect();
        places.sort_by(|a, b| b.0.total_cmp(&a.0));
        let rest = places.split_off(places.len().min(MOST));
        let more = (!rest.is_empty()).then(|| {
            let area: f32 = rest.iter().map(|place| place.0).sum();
            let extent = rest.iter().fold(rest[0].1, |all, place| all.union(&place.1));
            FoundBreach::at(
                rule,
                extent.center(),
                extent,
                area,
                format!("in {} more places, {}", rest.len(), what(area)),
            )
        });
        let told =
            places.into_iter().map(|(area, extent)| FoundBreach::at(rule, extent.center(), extent, area, what(area)));
        told.chain(more).collect()
    }

    fn extent(&self, nodes: &[usize]) -> MmRect {
        let width = self.size.width as usize;
        let corner =
            |node: usize, by: f32| MmPoint::new((node % width) as f32 + by, (node / width) as f32 + by) / PX_PER_MM;
        let first = MmRect::new(corner(nodes[0], 0.0), corner(nodes[0], 1.0));
        nodes.iter().fold(first, |all, &node| all.union(&MmRect::new(corner(node, 0.0), corner(node, 1.0))))
    }
}
