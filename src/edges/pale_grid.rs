//! The pale grid behind a chart in a bitmap: its lines are faint, as those of a vector drawing are.
//!
//! In pixels a gridline and the top of a bar that ends on it are one straight stroke. It is parted where the contrast
//! changes, so that the bar keeps its top, and no line as broad as that leads on from it to the next bar. Where the
//! side of a shape lies on squared paper, one gridline turns into another at its corner: such a contour is parted
//! there. Where a gridline leads to a corner of a shape, the two are one thick spot, and its end was found on the way
//! into that: a gridline is led straight on from where most of it is.

use super::contour::{Contour, ContourPoint};
use super::faint::{BLACK, SEEN, STRONG};
use crate::geom::gridlines::{GridUnit, straight_ends, which_are_gridlines};
use crate::geom::order::median;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::simplify::simplify;
use crate::geom::walk::{first_beyond, runs};
use crate::units::{Px, PxPoint, PxVector, Size};

/// A stroke is pale up to this share of the contrast of the strong ones. Grey (`#aaa`) on white paper has a third of
/// that of black, a grey axis (`#888`) half; the blue lines of squared paper have from a quarter to two fifths, as they
/// lie on pixels.
const PALE: f32 = 0.45;
/// What is shorter than this, px, is no change of contrast: a line that crosses another.
const CROSSED: f32 = 8.0;
/// A stroke is parted where another contour ends within this distance of the change, px: at the corner of a bar.
const AT_CORNER: f32 = 4.0;
/// The sides of a contour are straight to this distance, px: a corner is rounded by it at most.
const ROUNDED: f32 = 1.5;
/// A contour has a corner where it turns by more than 45 degrees (cosine).
const TURNED: f32 = 0.7;
/// A line is level, or upright, if this share of its places at least is at one height, and none farther aside than
/// this, px: beside a corner of 10 degrees, it is led into the thick spot there over as much.
const LEVEL: f32 = 0.8;
const LED_ASIDE: f32 = 24.0;

/// A contour, the width of its stroke, px, if it is one, and whether it is a line of a pale grid.
pub(super) type Weighed = (Contour, Option<f32>, bool);

/// The contours of a drawing of this size, each with the width of its stroke; those that are in part lines of a pale
/// grid are parted. Others are no longer among them, of which strengths and lengths are given.
pub(super) fn parted(
    contours: Vec<Contour>,
    widths: &[Option<f32>],
    size: Size,
    others: Vec<(f32, f32)>,
) -> Vec<Weighed> {
    let mut most = PALE * strong(&contours, size, others).min(BLACK);
    let (divided, of_grid) = loop {
        let (divided, of_grid) = grid_lines(&contours, widths, most);
        let lines = stretches_of(&divided).zip(&of_grid).filter(|(_, is_line)| **is_line);
        let weight = median(lines.map(|((contour, line), _)| line.strength(contour)));
        if SEEN * weight <= most {
            break (divided, of_grid);
        }
        // at other places among pixels more is seen of its lines
        most = SEEN * weight;
    };
    let mut of_grid = of_grid.into_iter();
    let corners: Vec<PxPoint> = contours.iter().filter(|contour| !contour.closed).flat_map(tips).collect();
    let mut all = Vec::with_capacity(contours.len());
    for ((contour, &width), divided) in contours.into_iter().zip(widths).zip(divided) {
        let Some(Divided { contour: open, stretches }) = divided else {
            all.push((contour, width, false));
            continue;
        };
        let faint: Vec<bool> = of_grid.by_ref().take(stretches.len()).collect();
        if !faint.contains(&true) {
            all.push((contour, width, false));
            continue;
        }
        let mut from = 0;
        let kinds: Vec<(Stretch, bool)> = stretches.into_iter().zip(faint).collect();
        for same in kinds.chunk_by(|a, b| a.1 == b.1 && (!a.1 || a.0.side == b.0.side)) {
            let (Stretch { to, ends_side, .. }, faint) = same[same.len() - 1];
            let to = if ends_side { to } else { at_corner(&open, to, &corners) };
            if to > from {
                let mut part = Polyline::open(open.vertices[from..=to].to_vec());
                if faint {
                    straighten(&mut part);
                }
                all.push((part, width, faint));
                from = to;
            }
        }
    }
    all
}

/// The strokes that are pale in part, with a contrast up to `most`, and which of all their stretches are of a grid.
fn grid_lines(contours: &[Contour], widths: &[Option<f32>], most: f32) -> (Vec<Option<Divided>>, Vec<bool>) {
    let divided: Vec<Option<Divided>> =
        contours.iter().zip(widths).map(|(contour, width)| width.and_then(|_| divided(contour, most))).collect();
    let ends: Vec<Option<[PxPoint; 2]>> = stretches_of(&divided).map(|(all, stretch)| stretch.ends(all)).collect();
    let of_grid = which_are_gridlines(&ends);
    (divided, of_grid)
}

/// All stretches, each with its contour.
fn stretches_of(divided: &[Option<Divided>]) -> impl Iterator<Item = (&Contour, &Stretch)> {
    divided.iter().flatten().flat_map(|of| of.stretches.iter().map(|stretch| (&of.contour, stretch)))
}

/// The height of a line of which most is level, or the place of an upright one, and whether it is level.
fn place(vertices: &[ContourPoint]) -> Option<(bool, f32)> {
    [true, false].into_iter().find_map(|is_level| {
        let across = || vertices.iter().map(|vertex| if is_level { vertex.at.y } else { vertex.at.x });
        let place = median(across());
        let within = |most: f32| across().filter(|at| (at - place).abs() <= most).count();
        let is_along = within(Px::OFF) as f32 >= LEVEL * vertices.len() as f32;
        (is_along && within(LED_ASIDE) == vertices.len()).then_some((is_level, place))
    })
}

/// A point moved to the place of a line.
fn moved(at: PxPoint, (is_level, place): (bool, f32)) -> PxPoint {
    if is_level { PxPoint::new(at.x, place) } else { PxPoint::new(place, at.y) }
}

/// Leads a line of which most is level or upright straight on to its ends.
fn straighten(line: &mut Contour) {
    if let Some(place) = place(&line.vertices) {
        line.vertices.iter_mut().for_each(|vertex| vertex.at = moved(vertex.at, place));
    }
}

/// A contour, opened at a corner if it is a ring, and what of it is pale.
struct Divided {
    contour: Contour,
    stretches: Vec<Stretch>,
}

/// A contour of which something is pale as its straight sides: a ring of the paper's edge, and lines of which one turns
/// into another where they meet.
fn divided(contour: &Contour, most: f32) -> Option<Divided> {
    if contour.vertices.iter().all(|point| point.strength > most) {
        return None;
    }
    let contour = if contour.closed { opened(contour)? } else { contour.clone() };
    let sides = sides(&contour);
    let stretches = sides.iter().enumerate().flat_map(|(side, ends)| stretches(&contour, side, *ends, most)).collect();
    Some(Divided { contour, stretches })
}

/// The straight pieces of a contour that are long enough to have a direction, from vertex to vertex.
fn pieces(contour: &Contour) -> Vec<[usize; 2]> {
    let points: Vec<PxPoint> = contour.vertices.iter().map(|point| point.at).collect();
    let kept = simplify(PolylineRef { vertices: &points, closed: contour.closed }, ROUNDED);
    let closing = kept.last().zip(kept.first()).filter(|_| contour.closed).map(|(last, first)| [*last, *first]);
    let pieces = kept.windows(2).map(|pair| [pair[0], pair[1]]).chain(closing);
    pieces.filter(|piece| along(contour, *piece).length() >= CROSSED).collect()
}

fn along(contour: &Contour, [from, to]: [usize; 2]) -> PxVector {
    contour.vertices[to].at - contour.vertices[from].at
}

/// Whether a contour turns sharply from one piece into the next.
fn is_corner(contour: &Contour, before: [usize; 2], after: [usize; 2]) -> bool {
    along(contour, before).normalize().dot(along(contour, after).normalize()) <= TURNED
}

/// A ring as an open contour that begins at the corner before its longest piece, if it has corners.
fn opened(ring: &Contour) -> Option<Contour> {
    let pieces = pieces(ring);
    let before = |i: usize| pieces[(i + pieces.len() - 1) % pieces.len()];
    let length = |i: &usize| along(ring, pieces[*i]).length();
    let at_corners = (0..pieces.len()).filter(|&i| is_corner(ring, before(i), pieces[i]));
    at_corners.max_by(|a, b| length(a).total_cmp(&length(b))).map(|i| ring.opened_at(pieces[i][0]))
}

/// The sides of an open contour from corner to corner, from vertex to vertex; each begins where the one before ends.
fn sides(contour: &Contour) -> Vec<[usize; 2]> {
    let last = contour.vertices.len().saturating_sub(1);
    if straight_ends(contour.view()).is_some() {
        return vec![[0, last]];
    }
    let corners = pieces(contour);
    let corners = corners.windows(2).filter(|pair| is_corner(contour, pair[0], pair[1]));
    let mut from = 0;
    let mut sides = Vec::new();
    for to in corners.map(|pair| usize::midpoint(pair[0][1], pair[1][0])).chain([last]) {
        sides.push([from, to]);
        from = to;
    }
    sides
}

/// A part of a contour, from vertex to vertex, that is pale or not.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    from: usize,
    to: usize,
    is_pale: bool,
    /// Number of the side that it is of.
    side: usize,
    /// Whether it ends where that side does.
    ends_side: bool,
}

impl Stretch {
    /// The contrast of most of it.
    fn strength(&self, contour: &Contour) -> f32 {
        median(contour.vertices[self.from..=self.to].iter().map(|point| point.strength))
    }

    /// Where one that is pale begins and ends, but for the rounding of corners and where it was led aside.
    fn ends(&self, contour: &Contour) -> Option<[PxPoint; 2]> {
        let places = || contour.vertices[self.from..=self.to].iter().map(|point| point.at);
        let rounding = AT_CORNER.min(0.25 * along(contour, [self.from, self.to]).length());
        let first = first_beyond(places(), contour.vertices[self.from].at, rounding)?;
        let last = first_beyond(places().rev(), contour.vertices[self.to].at, rounding)?;
        let place = place(&contour.vertices[self.from..=self.to]);
        let straightened = |at: PxPoint| place.map_or(at, |place| moved(at, place));
        self.is_pale.then_some([first, last].map(straightened))
    }
}

/// The contrast of the strong contours: a share of all by length, but no longer than the picture, as the lines of a
/// grid are long beside a curve. A line of squared paper may be strong for a part only, where the side of a shape is on
/// it.
fn strong(contours: &[Contour], size: Size, others: Vec<(f32, f32)>) -> f32 {
    let places = contours.iter().flat_map(|contour| contour.segments());
    let mut all = others;
    all.extend(places.map(|(a, b)| (a.strength.min(b.strength), (b.at - a.at).length())));
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

/// The stretches of a side of an open contour that are pale, with a contrast up to `most`, and those that are not. The
/// shortest go to what is around them until none is too short for a change of contrast. None that is bent is pale; but
/// what is strong may turn off from a gridline, as where the side of a triangle crosses it.
fn stretches(contour: &Contour, side: usize, [first, last]: [usize; 2], most: f32) -> Vec<Stretch> {
    let vertices = &contour.vertices[first..=last];
    let is_straight = straight_ends(PolylineRef { vertices, closed: false }).is_some();
    let is_pale: Vec<bool> = vertices.iter().map(|point| point.strength <= most).collect();
    let runs = runs(is_pale.len(), false, |a, b| is_pale[a] == is_pale[b]);
    let stretch = |from: usize, to: usize, is_pale: bool| Stretch { from, to, is_pale, side, ends_side: to == last };
    let mut all: Vec<Stretch> =
        runs.iter().map(|run| stretch(first + run[0], first + run[run.len() - 1], is_pale[run[0]])).collect();
    let length = |of: &Stretch| along(contour, [of.from, of.to]).length();
    while all.len() > 1
        && let Some(shortest) = (0..all.len()).min_by(|&a, &b| length(&all[a]).total_cmp(&length(&all[b])))
        && length(&all[shortest]) < CROSSED
    {
        let (from, to) = (shortest.saturating_sub(1), (shortest + 1).min(all.len() - 1));
        let is_pale = !all[shortest].is_pale;
        all.splice(from..=to, [stretch(all[from].from, all[to].to, is_pale)]);
    }
    // each ends where the next begins
    for next in 1..all.len() {
        all[next].from = all[next - 1].to;
    }
    for of in &mut all {
        let own = PolylineRef { vertices: &contour.vertices[of.from..=of.to], closed: false };
        of.is_pale &= is_straight || straight_ends(own).is_some() || place(own.vertices).is_some();
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
