//! Which shapes mark places: outlines with some corners whose halves are alike, and crosses.

use resvg::tiny_skia::{Path, PathSegment};

use crate::geom::nearest_on_segment;
use crate::raster::vector::PaintedPath;
use crate::units::{PxPoint, PxVector};

/// A sign has at most so many straight sides, as a broad cross has; more is a picture. A circle is drawn of so many
/// pieces at most: they are as many as its size asks for in the units of its file.
const MOST_SIDES: usize = 12;
const MOST_PIECES: usize = 64;
/// Two halves of an outline are alike but for this share of its side.
const MIRRORED: f32 = 0.06;
/// The strokes of a cross lead through its middle, but for this share of its side.
const THROUGH: f32 = 0.1;
/// Two points nearer to one another than this, px, are one.
const ONE: f32 = 1e-3;

/// A part of a path, from where its pen is set down to where it is lifted.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// Where its pieces meet, and its ends; of a closed one the first is not repeated.
    pub(super) corners: Vec<PxPoint>,
    pub(super) closed: bool,
}

/// The parts of a path.
pub(super) fn parts(path: &Path) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for segment in path.segments() {
        let at = match segment {
            PathSegment::MoveTo(at) => {
                parts.push(Part { corners: Vec::new(), closed: false });
                at
            }
            PathSegment::LineTo(at) | PathSegment::QuadTo(_, at) | PathSegment::CubicTo(_, _, at) => at,
            PathSegment::Close => {
                if let Some(part) = parts.last_mut() {
                    part.closed = true;
                }
                continue;
            }
        };
        if let Some(part) = parts.last_mut() {
            part.corners.push(PxPoint::new(at.x, at.y));
        }
    }
    for part in &mut parts {
        if let [first, _, .., last] = part.corners[..]
            && (last - first).length() < ONE
        {
            part.corners.pop();
            part.closed = true;
        }
    }
    parts
}

/// Whether a path is one closed outline around a middle, with this side, that has some corners and is mirrored in a
/// level or an upright line.
pub(super) fn is_outline(painted: &PaintedPath, middle: PxPoint, side: f32) -> bool {
    let parts = parts(&painted.path);
    let [Part { corners, closed }] = &parts[..] else { return false };
    let is_closed = *closed || painted.stroke.is_none();
    let has_image = |image: PxPoint| corners.iter().any(|other| (*other - image).length() <= MIRRORED * side);
    let is_mirrored = |[x, y]: [f32; 2]| {
        let image = |at: &PxPoint| middle + PxVector::new(x * (at.x - middle.x), y * (at.y - middle.y));
        corners.iter().all(|at| has_image(image(at)))
    };
    let is_straight = |segment: &PathSegment| matches!(segment, PathSegment::LineTo(_));
    let sides = painted.path.segments().filter(is_straight).count();
    let is_simple = sides <= MOST_SIDES && (3..=MOST_PIECES).contains(&corners.len());
    is_closed && is_simple && (is_mirrored([-1.0, 1.0]) || is_mirrored([1.0, -1.0]))
}

/// Whether paths are straight strokes, two and more, that lead through one middle.
pub(super) fn is_cross(painted: &[PaintedPath], middle: PxPoint, side: f32) -> bool {
    let strokes: Vec<Part> = painted.iter().flat_map(|of| parts(&of.path)).collect();
    let leads_through = |stroke: &Part| match stroke.corners[..] {
        [from, to] => nearest_on_segment(middle, from, to).0 <= THROUGH * side,
        _ => false,
    };
    strokes.len() > 1 && painted.iter().all(PaintedPath::is_of_straight_strokes) && strokes.iter().all(leads_through)
}

#[cfg(test)]
mod tests {
    use resvg::tiny_skia::{PathBuilder, Rect, Stroke};

    use super::*;

    const MIDDLE: PxPoint = PxPoint::new(50.0, 50.0);

    /// A path of parts through points around [`MIDDLE`], filled and closed or else drawn.
    fn path(parts: &[&[(f32, f32)]], is_filled: bool) -> PaintedPath {
        let mut path = PathBuilder::new();
        for part in parts {
            for (number, &(x, y)) in part.iter().enumerate() {
                let (x, y) = (x + MIDDLE.x, y + MIDDLE.y);
                if number == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            if is_filled {
                path.close();
            }
        }
        let stroke = (!is_filled).then(Stroke::default);
        PaintedPath { stroke, ..PaintedPath::filled(path.finish().expect("a path")) }
    }

    #[test]
    fn outlines_with_alike_halves_mark_places() {
        let is = |points: &[(f32, f32)]| is_outline(&path(&[points], true), MIDDLE, 10.0);
        assert!(is(&[(0.0, -5.0), (-5.0, 5.0), (5.0, 5.0)]), "a triangle");
        assert!(is(&[(-5.0, 0.0), (5.0, -5.0), (5.0, 5.0)]), "one that points to the left");
        assert!(is(&[(0.0, -5.0), (-5.0, 0.0), (0.0, 5.0), (5.0, 0.0)]), "a diamond");
        assert!(!is(&[(-5.0, -5.0), (-5.0, 5.0), (5.0, 5.0)]), "a corner of a square");
        assert!(!is(&[(-5.0, -5.0), (-5.0, 5.0), (4.0, 5.0), (4.0, 3.0), (-3.0, 3.0), (-3.0, -5.0)]), "an L");
        assert!(!is_outline(&path(&[&[(-5.0, 5.0), (0.0, -5.0), (5.0, 5.0)]], false), MIDDLE, 10.0), "a roof is open");
        for radius in [2.0, 5.0, 40.0] {
            let circle = PathBuilder::from_circle(50.0, 50.0, radius).expect("a circle");
            assert!(is_outline(&PaintedPath::filled(circle), MIDDLE, 2.0 * radius), "a circle of {radius}");
        }
        let square = PathBuilder::from_rect(Rect::from_xywh(45.0, 45.0, 10.0, 10.0).expect("it has sides"));
        assert!(is_outline(&PaintedPath::filled(square), MIDDLE, 10.0));
    }

    #[test]
    fn strokes_through_one_middle_are_a_cross() {
        let is = |parts: &[&[(f32, f32)]]| is_cross(&[path(parts, false)], MIDDLE, 10.0);
        let (down, up) = ([(-5.0, -5.0), (5.0, 5.0)], [(-5.0, 5.0), (5.0, -5.0)]);
        assert!(is(&[&down, &up]));
        assert!(is_cross(&[path(&[&down], false), path(&[&up], false)], MIDDLE, 10.0), "of two paths");
        assert!(!is(&[&down]), "one stroke");
        assert!(!is(&[&[(-5.0, -3.0), (5.0, -3.0)], &[(-5.0, 3.0), (5.0, 3.0)]]), "as an equals sign");
        assert!(!is(&[&[(-5.0, -5.0), (0.0, 0.0), (5.0, -5.0)], &up]), "it has a corner");
    }
}
