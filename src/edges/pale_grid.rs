//! The pale grid behind a chart in a bitmap: its lines are faint, as those of a vector drawing are.
//!
//! In pixels a gridline and the top of a bar that ends on it are one straight stroke. It is parted where the contrast
//! changes, so that the bar keeps its top, and no line as broad as that leads on from it to the next bar.

use super::contour::Contour;
use super::faint::{BLACK, STRONG};
use crate::geom::gridlines::{straight_ends, which_are_gridlines};
use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::units::{PxPoint, Size};

/// A stroke is pale up to this share of the contrast of the strong ones. Grey (`#aaa`) on white paper has a third of
/// that of black, a grey axis (`#888`) half.
const PALE: f32 = 0.4;
/// What is shorter than this, px, is no change of contrast: a line that crosses another.
const CROSSED: f32 = 8.0;
/// A stroke is parted where another contour ends within this distance of the change, px: at the corner of a bar.
const AT_CORNER: f32 = 4.0;

/// A contour, the width of its stroke, px, if it is one, and whether it is a line of a pale grid.
pub(super) type Weighed = (Contour, Option<f32>, bool);

/// The contours of a drawing of this size, each with the width of its stroke; those that are in part lines of a pale
/// grid are parted.
pub(super) fn parted(contours: Vec<Contour>, widths: &[Option<f32>], size: Size) -> Vec<Weighed> {
    let most = PALE * strong(&contours, size).min(BLACK);
    let stretches: Vec<Vec<Stretch>> = contours
        .iter()
        .zip(widths)
        .map(|(contour, width)| match width.and(straight_ends(contour.view())) {
            Some(_) => stretches(contour, most),
            None => Vec::new(),
        })
        .collect();
    let ends: Vec<Option<[PxPoint; 2]>> = contours
        .iter()
        .zip(&stretches)
        .flat_map(|(contour, stretches)| stretches.iter().map(|stretch| stretch.ends(contour)))
        .collect();
    let mut of_grid = which_are_gridlines(&ends).into_iter();
    let corners: Vec<PxPoint> = contours.iter().filter(|contour| !contour.closed).flat_map(tips).collect();
    let mut all = Vec::with_capacity(contours.len());
    for ((contour, &width), stretches) in contours.into_iter().zip(widths).zip(stretches) {
        let faint: Vec<bool> = of_grid.by_ref().take(stretches.len()).collect();
        if !faint.contains(&true) {
            all.push((contour, width, false));
            continue;
        }
        let mut from = 0;
        let kinds: Vec<(usize, bool)> =
            stretches.iter().zip(faint).map(|(stretch, faint)| (stretch.to, faint)).collect();
        for same in kinds.chunk_by(|a, b| a.1 == b.1) {
            let (to, faint) = same[same.len() - 1];
            let to = if to + 1 == contour.vertices.len() { to } else { at_corner(&contour, to, &corners) };
            if to > from {
                all.push((Polyline::open(contour.vertices[from..=to].to_vec()), width, faint));
                from = to;
            }
        }
    }
    all
}

/// A part of a contour, from vertex to vertex, that is pale or not.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    from: usize,
    to: usize,
    is_pale: bool,
}

impl Stretch {
    /// Where one that is pale begins and ends.
    fn ends(&self, contour: &Contour) -> Option<[PxPoint; 2]> {
        self.is_pale.then(|| [self.from, self.to].map(|i| contour.vertices[i].at))
    }
}

/// The contrast of the strong contours: a share of all by length, but no longer than the picture, as the lines of a
/// grid are long beside a curve. A line of squared paper may be strong for a part only, where the side of a shape is on
/// it.
fn strong(contours: &[Contour], size: Size) -> f32 {
    let places = contours.iter().flat_map(|contour| contour.segments());
    let mut all: Vec<(f32, f32)> = places.map(|(a, b)| (a.strength.min(b.strength), (b.at - a.at).length())).collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let whole: f32 = all.iter().map(|(_, length)| length).sum();
    let wanted = (STRONG * whole).min(size.width.max(size.height) as f32);
    let mut sum = 0.0;
    let reached = all.iter().find(|(_, length)| {
        sum += length;
        sum >= wanted
    });
    reached.map_or(0.0, |(strength, _)| *strength)
}

/// The stretches of an open contour that are pale, with a contrast up to `most`, and those that are not. The shortest
/// go to what is around them until none is too short for a change of contrast.
fn stretches(contour: &Contour, most: f32) -> Vec<Stretch> {
    let is_pale: Vec<bool> = contour.vertices.iter().map(|point| point.strength <= most).collect();
    let runs = runs(is_pale.len(), false, |a, b| is_pale[a] == is_pale[b]);
    let mut all: Vec<Stretch> =
        runs.iter().map(|run| Stretch { from: run[0], to: run[run.len() - 1], is_pale: is_pale[run[0]] }).collect();
    let length = |of: &Stretch| (contour.vertices[of.to].at - contour.vertices[of.from].at).length();
    while all.len() > 1
        && let Some(shortest) = (0..all.len()).min_by(|&a, &b| length(&all[a]).total_cmp(&length(&all[b])))
        && length(&all[shortest]) < CROSSED
    {
        let (from, to) = (shortest.saturating_sub(1), (shortest + 1).min(all.len() - 1));
        let is_pale = !all[shortest].is_pale;
        all.splice(from..=to, [Stretch { from: all[from].from, to: all[to].to, is_pale }]);
    }
    // each ends where the next begins
    for next in 1..all.len() {
        all[next].from = all[next - 1].to;
    }
    all
}

/// The vertex at which a contour is parted: the one nearest to the end of another if there is one about vertex `i`.
fn at_corner(contour: &Contour, i: usize, corners: &[PxPoint]) -> usize {
    let at = contour.vertices[i].at;
    let distance = |from: PxPoint, to: PxPoint| (from - to).length();
    let near = corners.iter().filter(|corner| distance(**corner, at) <= AT_CORNER);
    let nearest = near.min_by(|a, b| distance(**a, at).total_cmp(&distance(**b, at)));
    nearest
        .and_then(|corner| {
            let to_corner = |j: &usize| distance(contour.vertices[*j].at, *corner);
            (0..contour.vertices.len()).min_by(|a, b| to_corner(a).total_cmp(&to_corner(b)))
        })
        .unwrap_or(i)
}

fn tips(contour: &Contour) -> impl Iterator<Item = PxPoint> {
    [contour.vertices.first(), contour.vertices.last()].into_iter().flatten().map(|point| point.at)
}

#[cfg(test)]
mod tests;
