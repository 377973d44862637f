//! The paths of a drawing, as they are painted: what its outlines and strokes propose as contours.

use resvg::tiny_skia::{Path, PathSegment, Point, Rect, Transform};
use usvg::{Group, Node, Paint, Tree};

use crate::raster::vector::{PaintedPath, PixelArea, VectorDrawing};
use crate::units::{PxPoint, Size};

/// Most paths. A drawing of more is a picture in disguise (a traced photograph, a plot of a million points): its
/// contours are found in its pixels.
pub(super) const MOST_PATHS: usize = 20_000;

/// The paths of a drawing that is rendered with `transform`; none if there are more than [`MOST_PATHS`].
pub(super) fn of_tree(tree: &Tree, transform: Transform) -> Option<VectorDrawing> {
    let mut found = VectorDrawing::default();
    add_group(tree.root(), transform, &mut None, &mut found);
    (found.paths.len() <= MOST_PATHS).then_some(found)
}

/// Longest paths together, in longest sides of the canvas. resvg sorts the edges of a path anew in each row of pixels:
/// a filled path of a million random corners (200 000 sides) takes a minute. On a figure of 200 mm this is 4 km of
/// line; an ink drawing of 5000 strokes across the whole sheet has a quarter of it.
const MOST_SIDES: f64 = 20_000.0;

/// # Errors
/// The paths of a drawing are longer than can be drawn in some seconds.
pub(super) fn check_length(tree: &Tree, transform: Transform, target: Size) -> Result<(), String> {
    let canvas = [target.width as f32, target.height as f32];
    let side = canvas[0].max(canvas[1]);
    let sides = length(tree.root(), transform, canvas) / f64::from(side);
    if sides > MOST_SIDES {
        return Err(format!(
            "its lines and outlines are {sides:.0} times as long as its longest side, and more than {MOST_SIDES} are \
             not drawn"
        ));
    }
    Ok(())
}

/// Length of all paths of a group on a canvas, px, measured on control polygons. A segment beside the canvas counts
/// nothing, one that crosses its border at most the sum of its two sides.
fn length(group: &Group, transform: Transform, canvas: [f32; 2]) -> f64 {
    let of_leg = |[a, b]: [Point; 2]| {
        let beside = |a: f32, b: f32, side: f32| a.max(b) < 0.0 || a.min(b) > side;
        if beside(a.x, b.x, canvas[0]) || beside(a.y, b.y, canvas[1]) {
            return 0.0;
        }
        f64::from((b.x - a.x).hypot(b.y - a.y).min(canvas[0] + canvas[1]))
    };
    let of_path = |path: &usvg::Path| {
        let to_pixels = transform.pre_concat(path.abs_transform());
        let outline = path.data().clone().transform(to_pixels);
        outline.iter().flat_map(Path::segments).scan([Point::zero(); 2], legs).flatten().map(of_leg).sum::<f64>()
    };
    let of_node = |node: &Node| match node {
        Node::Group(group) => length(group, transform, canvas),
        Node::Path(path) => of_path(path),
        Node::Text(text) => length(text.flattened(), transform, canvas),
        Node::Image(_) => 0.0,
    };
    group.children().iter().map(of_node).sum()
}

/// The legs of the control polygon of a segment. `ends` are where its part of the path begins and where the segment
/// does; it moves the second one to its end.
#[allow(clippy::unnecessary_wraps, reason = "scan asks for it")]
fn legs(ends: &mut [Point; 2], segment: PathSegment) -> Option<impl Iterator<Item = [Point; 2]> + use<>> {
    let [start, from] = *ends;
    let points = match segment {
        PathSegment::MoveTo(to) => [to; 4],
        PathSegment::LineTo(to) => [from, to, to, to],
        PathSegment::QuadTo(a, to) => [from, a, to, to],
        PathSegment::CubicTo(a, b, to) => [from, a, b, to],
        PathSegment::Close => [from, start, start, start],
    };
    *ends = [if let PathSegment::MoveTo(to) = segment { to } else { start }, points[3]];
    Some([[points[0], points[1]], [points[1], points[2]], [points[2], points[3]]].into_iter())
}

/// Adds what is painted by the children of a group; `last` is the path that was painted last.
fn add_group<'t>(group: &'t Group, transform: Transform, last: &mut Option<&'t usvg::Path>, found: &mut VectorDrawing) {
    if group.mask().is_some() || !group.filters().is_empty() {
        let area = group.abs_layer_bounding_box().to_rect();
        found.pixel_areas.extend(pixel_area(area, transform));
    }
    if let Some(clip) = group.clip_path().filter(|clip| paints(group) && cuts_off(clip, group)) {
        // its edge is seen wherever it cuts something off
        let to_pixels = transform.pre_concat(group.abs_transform()).pre_concat(clip.transform());
        add_clip(clip.root(), to_pixels, found);
    }
    for node in group.children() {
        if found.paths.len() > MOST_PATHS {
            return;
        }
        match node {
            Node::Group(group) => add_group(group, transform, last, found),
            Node::Path(path) => {
                add_path(path, transform, *last, found);
                *last = Some(path);
            }
            Node::Image(image) => {
                let area = image.abs_bounding_box();
                found.pixel_areas.extend(pixel_area(area, transform));
                let border = resvg::tiny_skia::PathBuilder::from_rect(area).transform(transform);
                found.paths.extend(border.map(PaintedPath::filled));
            }
            Node::Text(text) => add_group(text.flattened(), transform, last, found),
        }
    }
}

/// Whether there is something in a group; letters that were taken out may leave nothing.
fn paints(group: &Group) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => paints(group),
        Node::Path(_) | Node::Image(_) | Node::Text(_) => true,
    })
}

fn add_path(path: &usvg::Path, transform: Transform, last: Option<&usvg::Path>, found: &mut VectorDrawing) {
    if !path.is_visible() {
        return;
    }
    let paints = [path.fill().map(usvg::Fill::paint), path.stroke().map(usvg::Stroke::paint)];
    if paints.iter().flatten().any(|paint| !matches!(paint, Paint::Color(_))) {
        found.pixel_areas.extend(pixel_area(path.abs_stroke_bounding_box(), transform));
    }
    let to_pixels = transform.pre_concat(path.abs_transform());
    let Some(outline) = path.data().clone().transform(to_pixels) else { return };
    let stroke = path.stroke().map(|stroke| {
        let mut stroke = stroke.to_tiny_skia();
        stroke.width *= mean_scale(to_pixels);
        // the line says where it runs; its dashes would be shorter than a line may be
        stroke.dash = None;
        stroke
    });
    let dashed = path.stroke().is_some_and(|stroke| has_dashes(stroke, path.data().bounds()));
    let is_last = |painted: &PaintedPath| painted.stroke.is_none() && painted.path == outline;
    let is_seen = stroke.as_ref().is_some_and(|stroke| stroke.width >= HAIRLINE);
    let is_filled_before = |fill: &&usvg::Path| is_stroke_of(path, fill) && found.paths.last().is_some_and(is_last);
    let fill = last.filter(|_| is_seen).filter(is_filled_before);
    if fill.is_some() {
        found.paths.pop();
    }
    let area = fill.unwrap_or(path).fill();
    let filled_alike = are_alike(area, path.stroke());
    let of_area = area.and_then(|fill| colour(fill.paint(), fill.opacity().get()));
    let of_stroke = path.stroke().and_then(|stroke| colour(stroke.paint(), stroke.opacity().get()));
    if path.fill().is_some() && stroke.as_ref().is_some_and(|stroke| stroke.width < HAIRLINE) {
        found.paths.push(PaintedPath { colours: [of_area, None], ..PaintedPath::filled(outline) });
    } else {
        found.paths.push(PaintedPath { path: outline, stroke, dashed, filled_alike, colours: [of_area, of_stroke] });
    }
}

/// The colour of a paint with this opacity, if it is one.
fn colour(paint: &Paint, opacity: f32) -> Option<[u8; 4]> {
    let Paint::Color(of) = paint else { return None };
    Some([of.red, of.green, of.blue, (255.0 * opacity).round() as u8])
}

/// Whether an area and the stroke around it are of one colour, and nothing shows through either.
fn are_alike(fill: Option<&usvg::Fill>, stroke: Option<&usvg::Stroke>) -> bool {
    let Some((fill, stroke)) = fill.zip(stroke) else { return false };
    let is_one_colour = matches!((fill.paint(), stroke.paint()), (Paint::Color(a), Paint::Color(b)) if a == b);
    is_one_colour && [fill.opacity(), stroke.opacity()].iter().all(|opacity| opacity.get() >= 1.0)
}

/// Whether a path is the stroke of one that was filled before, as documents paint the two. They count as one path, of
/// which the stroke is the contour: beside a thin, pale one the area would have an outline of its own.
fn is_stroke_of(path: &usvg::Path, fill: &usvg::Path) -> bool {
    let are_two = path.fill().is_none() && fill.fill().is_some() && fill.stroke().is_none() && fill.is_visible();
    are_two && path.data() == fill.data() && path.abs_transform() == fill.abs_transform()
}

/// Whether a stroke shows dashes: at least two on a path of this extent. An array longer than the path is a way to draw
/// a part of it.
fn has_dashes(stroke: &usvg::Stroke, extent: Rect) -> bool {
    stroke.dasharray().is_some_and(|dashes| 2.0 * dashes.iter().sum::<f32>() <= extent.width().hypot(extent.height()))
}

/// A stroke around a filled area that is thinner than this share of a pixel does not show beside it.
const HAIRLINE: f32 = 0.02;

/// What a clip path holds may reach beyond its sides by this share of its size, by rounding.
const ROUNDING: f32 = 1e-3;

/// Whether a clip path may cut something off a group: the box of a marker mostly cuts nothing off, and where a line of
/// the drawing crosses a side of it the pixels show a step.
fn cuts_off(clip: &usvg::ClipPath, group: &Group) -> bool {
    let [Node::Path(path)] = clip.root().children() else { return true };
    if clip.clip_path().is_some() || clip.transform().has_skew() || !path.is_visible() || !is_rectangle(path.data()) {
        return true;
    }
    let Some(sides) = path.data().bounds().transform(clip.transform()) else { return true };
    if holds(sides, group.stroke_bounding_box()) && holds(sides, group.layer_bounding_box().to_rect()) {
        return false;
    }
    let to_drawing = group.abs_transform();
    let of_ends = |sides: Rect| cuts_only_ends(group, sides);
    to_drawing.has_skew() || !sides.transform(to_drawing).is_some_and(of_ends)
}

/// Whether a box lies within these sides.
fn holds(sides: Rect, of: Rect) -> bool {
    let spare = ROUNDING * sides.width().max(sides.height());
    of.left() >= sides.left() - spare
        && of.top() >= sides.top() - spare
        && of.right() <= sides.right() + spare
        && of.bottom() <= sides.bottom() + spare
}

/// Whether a group is nothing but strokes, each level or upright, that reach beyond these sides only with the caps of
/// their ends, as gridlines beyond their plot. Where those are cut off nothing shows; and where each line has a clip
/// path of its own, as in documents that Cairo writes, the long sides of that lie beside a stroke, whose step would
/// confirm them.
fn cuts_only_ends(group: &Group, sides: Rect) -> bool {
    group.children().iter().all(|node| match node {
        Node::Group(inner) => {
            let is_plain = inner.clip_path().is_none() && inner.mask().is_none() && inner.filters().is_empty();
            is_plain && cuts_only_ends(inner, sides)
        }
        Node::Path(path) => {
            let (line, stroke) = (path.abs_bounding_box(), path.abs_stroke_bounding_box());
            let without_caps = if line.height() <= ROUNDING * line.width() {
                Rect::from_ltrb(line.left(), stroke.top(), line.right(), stroke.bottom())
            } else if line.width() <= ROUNDING * line.height() {
                Rect::from_ltrb(stroke.left(), line.top(), stroke.right(), line.bottom())
            } else {
                None
            };
            path.fill().is_none() && without_caps.is_some_and(|of| holds(sides, of))
        }
        Node::Image(_) | Node::Text(_) => false,
    })
}

/// Whether a path is one rectangle with level and upright sides.
fn is_rectangle(path: &Path) -> bool {
    let (points, bounds) = (path.points(), path.bounds());
    let is_level_or_upright = |pair: &[Point]| ((pair[1].x - pair[0].x) * (pair[1].y - pair[0].y)).abs() <= 0.0;
    let is_corner =
        |at: &Point| [bounds.left(), bounds.right()].contains(&at.x) && [bounds.top(), bounds.bottom()].contains(&at.y);
    (4..=5).contains(&points.len()) && points.windows(2).all(is_level_or_upright) && points.iter().all(is_corner)
}

fn add_clip(group: &Group, to_pixels: Transform, found: &mut VectorDrawing) {
    for node in group.children() {
        match node {
            Node::Group(group) => add_clip(group, to_pixels.pre_concat(group.transform()), found),
            Node::Path(path) => {
                let path: Option<Path> = path.data().clone().transform(to_pixels);
                found.paths.extend(path.map(PaintedPath::filled));
            }
            Node::Image(_) | Node::Text(_) => {}
        }
    }
}

/// The factor by which a transform scales lengths, on average over all directions.
fn mean_scale(transform: Transform) -> f32 {
    (transform.sx * transform.sy - transform.kx * transform.ky).abs().sqrt()
}

fn pixel_area(area: Rect, transform: Transform) -> Option<PixelArea> {
    let area = area.transform(transform)?;
    Some(PixelArea { min: PxPoint::new(area.left(), area.top()), max: PxPoint::new(area.right(), area.bottom()) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_of_a_marker_is_a_contour_only_where_it_cuts_something_off() {
        let count = |head: &str| {
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><marker id='m' viewBox='0 0 10 10' \
                 refX='10' refY='5' markerWidth='7' markerHeight='7' orient='auto'><path d='{head}'/></marker>\
                 <path d='M20 80L70 40' fill='none' stroke='#000' marker-end='url(#m)'/></svg>"
            );
            let tree = Tree::from_str(&svg, &usvg::Options::default()).expect("a drawing");
            of_tree(&tree, Transform::identity()).expect("it has few paths").paths.len()
        };
        assert_eq!(count("M0 0L10 5L0 10Z"), 2, "the line and its head");
        assert_eq!(count("M-9 0L10 5L-9 10Z"), 3, "a part of the head is cut off");
    }

    #[test]
    fn the_clip_of_nothing_is_no_contour() {
        let count = |inside: &str| {
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><clipPath id='c'>\
                 <path d='M50 50H60V60H50z'/></clipPath><g clip-path='url(#c)'><g>{inside}</g></g></svg>"
            );
            let tree = Tree::from_str(&svg, &usvg::Options::default()).expect("a drawing");
            of_tree(&tree, Transform::identity()).expect("it has few paths").paths.len()
        };
        assert_eq!([count(""), count("<path d='M0 0H99V99z'/>")], [0, 2]);
    }

    #[test]
    fn an_area_that_is_filled_and_then_drawn_around_is_one_path() {
        let paths = |stroke: &str| {
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><path d='M20 20H80V60H20Z' \
                 fill='#eee'/><path d='M20 20H80V60H20Z' fill='none' {stroke}/></svg>"
            );
            let tree = Tree::from_str(&svg, &usvg::Options::default()).expect("a drawing");
            let found = of_tree(&tree, Transform::identity()).expect("it has few paths").paths;
            found.iter().map(|path| (path.stroke.is_some(), path.filled_alike)).collect::<Vec<_>>()
        };
        assert_eq!(paths("stroke='#333' stroke-width='1.5'"), [(true, false)]);
        assert_eq!(paths("stroke='#eee' stroke-width='1.5'"), [(true, true)]);
        assert_eq!(paths("stroke='#333' transform='translate(1 0)'"), [(false, false), (true, false)]);
        assert_eq!(paths("stroke='#333' stroke-width='0.01'"), [(false, false), (true, false)], "it is not seen");
    }

    #[test]
    fn the_clip_of_a_gridline_that_cuts_off_its_caps_is_no_contour() {
        let count = |line: &str| {
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><clipPath id='c'><rect x='49' y='10' \
                 width='3' height='80'/></clipPath><g clip-path='url(#c)'><path transform='translate(50 0)' d='{line}' \
                 fill='none' stroke='#aaa' stroke-width='0.8' stroke-linecap='square'/></g></svg>"
            );
            let tree = Tree::from_str(&svg, &usvg::Options::default()).expect("a drawing");
            of_tree(&tree, Transform::identity()).expect("it has few paths").paths.len()
        };
        assert_eq!(count("M0 10V90"), 1);
        assert_eq!(count("M0 10V99"), 2, "a piece of the line is cut off");
        assert_eq!(count("M-0.9 10V90"), 2, "a side of it is");
        assert_eq!(count("M0 10L1 90"), 2, "it is neither level nor upright");
    }
}
