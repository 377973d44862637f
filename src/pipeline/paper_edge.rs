//! The edges of the paper of a scanned drawing, where the scanner saw what lies beside it: long lines along the sides
//! of the picture, which are no part of the drawing.

use super::given::Given;
use crate::edges::{ChainRange, Edgel, Edges};
use crate::geom::{nearest_on_segment, right_of};
use crate::units::PxPoint;
use crate::{About, Note, Reason};

/// Farthest that the middle of such an edge lies from its side of the picture, as a share of the picture's width or
/// height. Chosen by us, as the next ones are: a sheet that fills less of a scan than this is cut out by its maker.
const FARTHEST: f32 = 0.15;
/// Least length of one, as a share of its side: of an edge that fades along its way pieces are found.
const LONG: f32 = 0.25;
/// Most that a sheet is turned on the scanner, as the tangent of 10 degrees.
const TURNED: f32 = 0.176;
/// How far one lies off the straight between its ends at most, as a share of its length.
const BOWED: f32 = 0.01;
/// What is no farther beyond it is itself, px: the same edge may be found as two contours.
const BESIDE: f32 = 4.0;

/// Takes the edges of the paper out of the contours of a picture whose ground was taken for paper, if it is on one.
/// Tells of it.
///
/// They are borders without a stroke, straight, light on the side of the drawing and darker outside, and nothing lies
/// beyond them. A sheet on a scanner shows two neighbouring sides at least: a strip of ground at one side of a drawing
/// is a part of that.
pub(super) fn taken_out(edges: &mut Edges, given: &Given, is_on_paper: bool) -> Option<Note> {
    if !is_on_paper || given.lines.is_some() {
        return None;
    }
    let of_paper = found(edges);
    let count = of_paper.iter().flatten().count();
    let has = |level: bool| of_paper.contains(&Some(level));
    if !has(true) || !has(false) {
        return None;
    }
    let mut numbers = 0..;
    edges.chains.retain(|_| numbers.next().is_none_or(|number: usize| of_paper[number].is_none()));
    let told = format!(
        "the edges of the paper along the sides of the scan ({count} lines), as they are no part of the drawing; crop \
         the picture to its paper and the figure is larger, or keep the ground to draw them"
    );
    Some(Note::NotOnPage(About::Lines, Reason::PaperEdge, told.into()))
}

/// Which contours are edges of the paper: of each, whether it is a level one; none of other contours.
fn found(edges: &Edges) -> Vec<Option<bool>> {
    let straight: Vec<Option<PaperEdge>> = edges.chains.iter().map(|chain| PaperEdge::of(chain, edges)).collect();
    let is_beyond = |edge: &PaperEdge, number: usize| {
        let others = edges.chains.iter().zip(&straight).enumerate();
        let others = others.filter(|(other, (_, straight))| *other != number && straight.is_none());
        others.flat_map(|(_, (chain, _))| points(chain, edges)).any(|edgel| edge.is_beyond(edgel.at))
    };
    let numbered = straight.iter().enumerate();
    numbered.map(|(number, edge)| edge.filter(|edge| !is_beyond(edge, number)).map(|edge| edge.is_level)).collect()
}

fn points<'e>(chain: &ChainRange, edges: &'e Edges) -> &'e [Edgel] {
    &edges.edgels[chain.edgels.clone()]
}

/// What may be an edge of the paper.
#[derive(Debug, Clone, Copy)]
struct PaperEdge {
    ends: [PxPoint; 2],
    /// Whether it runs along the upper or lower side of the picture.
    is_level: bool,
    /// Whether the picture goes on to its right, as seen from its first end.
    is_left_of_picture: bool,
}

impl PaperEdge {
    fn of(chain: &ChainRange, edges: &Edges) -> Option<Self> {
        let points = points(chain, edges);
        let (from, to) = (points.first()?.at, points.last()?.at);
        let way = to - from;
        let [width, height] = [edges.size.width, edges.size.height].map(|side| side as f32);
        let (middle, centre) = (from.lerp(to, 0.5), PxPoint::new(0.5 * width, 0.5 * height));
        let is_level = way.x.abs() > way.y.abs();
        let (along, off, side) = match is_level {
            true => (way.x.abs(), way.y.abs(), width),
            false => (way.y.abs(), way.x.abs(), height),
        };
        let depth = match is_level {
            true => middle.y.min(height - middle.y) / height,
            false => middle.x.min(width - middle.x) / width,
        };
        let is_border = !chain.closed && chain.kind.stroke.is_none() && !chain.kind.added && !chain.kind.exact;
        let is_along_side = along >= LONG * side && off <= TURNED * along && depth <= FARTHEST;
        if !is_border || !is_along_side {
            return None;
        }
        let bow = points.iter().map(|edgel| nearest_on_segment(edgel.at, from, to).0).fold(0.0, f32::max);
        let is_left_of_picture = right_of(way).dot(centre - middle) > 0.0;
        let to_right: f32 = points.iter().map(|edgel| edgel.contrast[0]).sum();
        let lighter_inside = if is_left_of_picture { to_right } else { -to_right };
        let is_edge = bow <= BOWED * way.length() && lighter_inside > 0.0;
        is_edge.then_some(Self { ends: [from, to], is_level, is_left_of_picture })
    }

    /// Whether a place lies between it and its side of the picture.
    fn is_beyond(&self, at: PxPoint) -> bool {
        let ([from, to], to_right) = (self.ends, if self.is_left_of_picture { 1.0 } else { -1.0 });
        let Some(way) = (to - from).try_normalize() else { return false };
        let (along, inside) = ((at - from).dot(way), to_right * (at - from).dot(right_of(way)));
        inside < -BESIDE && (0.0..=(to - from).length()).contains(&along)
    }
}

#[cfg(test)]
mod tests;
