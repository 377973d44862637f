//! Filled heads of arrows in the pixels. A head that touches the box at which it points is one dark thing with the
//! outline of the box and with its own shaft: no contour shows it, and the middle of that thing wavers.
//!
//! ```text
//!                 base        apex       Along a straight stroke, and straight on from there, the width is taken that
//!                  |\_         |         ink has across. Before a head it is that of the shaft, at its base it is much
//!     ------shaft--|  \_______ |         more within a pixel or two, and from there on it falls evenly, by as much on
//!     -------------|   _/      |         both sides. Open heads, rays that meet, discs and diamonds do something else,
//!                  |_/         |         or have ink beside the shaft before the base.
//! ```
//!
//! A head with barbs is followed back from the notch in its base to their ends. Signs on a curve of a chart can be
//! triangles, too: of these the curve goes on (`around`), or the picture has others like them, to which no shaft leads
//! (`copies`).

mod around;
mod copies;
mod filled;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use self::around::{Measures, one_stroke_leaves};
use self::copies::Copies;
use self::filled::colour;
pub(in crate::edges) use self::filled::{FilledHead, PlaneColour};
use super::Stroke;
use crate::edges::contour::LineFit;
use crate::geom::order::median;
use crate::geom::{mix, right_of};
use crate::raster::contrast::{dot, less, square};
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

// All values here were chosen by us, on flow charts, food webs, cycles, forces and axes that were drawn with heads of
// seven shapes, and on charts, trees, maps and circuits in which nothing is a head. First the shaft and what is ahead.

/// The direction of a shaft is taken over so many of its vertices, which are about 1 px apart.
const WINDOW: usize = 12;
/// They lie on a straight line but for this, root mean square, px.
const STRAIGHT: f32 = 0.4;
/// Widths are taken from this far before a place, px, to this far behind it, in steps, from so far behind the vertices
/// that tell the direction.
const FROM: f32 = -6.0;
const TO: f32 = 45.0;
const STEP: f32 = 0.5;
const AHEAD: f32 = 3.0;
/// So many of them are those of the shaft.
const OF_SHAFT: usize = 7;
/// A base is looked for among these of them, from 2 px before the place to 12 px behind it.
const OF_BASE: std::ops::Range<usize> = 8..37;
/// Half of a width is at most this, px.
const REACH: f32 = 16.0;
/// Ink ends where less than this share of it is left.
const END: f32 = 0.3;
/// Where a head may be there is ink at one of these places, px behind the place, and beside it, so many widths of the
/// shaft and this much more, px.
const LOOK: [f32; 2] = [2.0, 6.0];
const BESIDE_WIDTHS: f32 = 0.5;
const BESIDE: f32 = 0.8;
/// Ink beside the middle is at least this share of that in the middle.
const MOSTLY: f32 = 0.8;
/// The colours of the two differ by no more than this, in units of strength, as far as can be told without the ground.
const ALIKE: f32 = 50.0;
/// The ground is read at these places, px before the place, this far beside the shaft, px.
const BEFORE: [f32; 3] = [4.0, 5.0, 6.0];
const GROUND: f32 = 3.0;
/// A shaft has the colour of its head: the least cosine between the two, as seen from the ground, and the least share
/// of it, which a thin one has in its middle; a pale gridline has less.
const ONE_COLOUR: f32 = 0.9;
const SHAFT_INK: f32 = 0.35;
/// The least width of a shaft, px.
const THINNEST: f32 = 0.5;

// How the width grows and falls.

/// A shaft is nowhere wider than so many times its median width and this much more, px.
const EVEN_TIMES: f32 = 1.5;
const EVEN: f32 = 1.0;
/// A head is so many times as wide as its shaft, and by this wider, px.
const WIDER_TIMES: f32 = 2.2;
const WIDER: f32 = 3.0;
/// From the first share of the way from the width of the shaft to that of the head on, it comes to this share of the
/// latter in at most so many steps.
const RISE_FROM: f32 = 0.25;
const RISE_TO: f32 = 0.85;
const RISE_STEPS: usize = 4;
/// It rises over at most this share of the way over which it falls: that of a disc, a square or a diamond rises as it
/// falls.
const RISE: f32 = 0.4;
/// It falls from there on, but for this, px, and is followed down to a share of itself, over so many steps at least.
const NO_FALL: f32 = 0.25;
const FOLLOWED: f32 = 0.25;
const FALLEN: f32 = 0.55;
const FALL_STEPS: usize = 4;
/// It does so on a straight line, but for this, px, or this share of the width.
const OFF_LINE: f32 = 0.7;
const OFF_LINE_SHARE: f32 = 0.08;
/// The two halves of a width differ by at most this share of it, and this, px.
const UNLIKE_SHARE: f32 = 0.25;
const UNLIKE: f32 = 1.5;
/// Half the width of a head, as a share of its length; and its least length, px.
const SHAPES: std::ops::RangeInclusive<f32> = 0.2..=1.2;
const SHORTEST: f32 = 6.0;

// What is behind the base and before it, and beyond the tip.

/// Barbs go on along the sides of a head for at most this, px, and for so many steps at least, where there is ink of
/// this share at one of these places, px inside of a side, and none so far outside of it, px.
const BARBS: f32 = 30.0;
const BARB_STEPS: usize = 3;
const BARB_INK: f32 = 0.3;
const INSIDE: [f32; 3] = [0.5, 1.0, 1.5];
const OUTSIDE: f32 = 2.0;
/// On one side of the shaft at least there is nothing before the base: from the first of these places to the second,
/// px, no more ink than this share, from this far beside the shaft, px, to this far beyond the half width of the head.
const CLEAR: [f32; 2] = [4.0, 1.5];
const CLEAR_INK: f32 = 0.35;
const CLEAR_FROM: f32 = 1.5;
const CLEAR_TO: f32 = 1.0;
/// The middle of a line there is looked for up to so far beyond the half width of the head, px.
const LINE_TO: f32 = 4.0;
/// How far before the base that is done, px.
pub(in crate::edges) const LINE_AT: f32 = 2.5;
/// A line goes on behind the apex if there is ink up to so far beyond that, px, no wider than so many times the shaft
/// and this much more, px: then the head is a sign within a line.
const GOES_ON: f32 = 7.0;
const GOES_ON_WIDTHS: f32 = 2.0;

// Heads among others.

/// Two heads whose tips are nearer than this, px, and that point the same way, are one.
const SAME: f32 = 4.0;
const SAME_WAY: f32 = 0.7;
/// Heads of a picture point alike within 18 degrees: the cosine.
const ALIKE_WAY: f32 = 0.95;
/// A head is a sign on a curve if there are at least so many signs like it, and more of them than heads that point as
/// it does, or as many without a shaft as those: a loose triangle beside several arrows is the sign of an item.
const SIGNS: usize = 2;

/// The filled heads at the ends of strokes, or where a stroke goes on in what its arrow points at. Their colour is at
/// least so far from the ground.
pub(in crate::edges) fn filled_heads(strokes: &[Stroke], planes: &[Plane], least: f32) -> Vec<FilledHead> {
    let open: Vec<&Stroke> = strokes.iter().filter(|stroke| !stroke.is_dash && !stroke.contour.closed).collect();
    let mut found: Vec<(f32, FilledHead)> =
        open.par_iter().flat_map_iter(|stroke| along(stroke, planes, least)).collect();
    // the evenest first: near a head, many places of its shaft show it
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut heads: Vec<FilledHead> = Vec::new();
    for (_, head) in found {
        let is_same = |other: &FilledHead| (head.apex - other.apex).length() < SAME && head.points_as(other, SAME_WAY);
        if !heads.iter().any(is_same) {
            heads.push(head);
        }
    }
    let copies = Copies::of_each(&heads, planes);
    let is_sign = |head: &FilledHead, copies: Copies| {
        let alike = heads.iter().filter(|other| head.points_as(other, ALIKE_WAY)).count();
        copies.without_shaft >= alike || copies.all >= SIGNS && copies.all > alike
    };
    heads.iter().zip(copies).filter(|(head, copies)| !is_sign(head, *copies)).map(|(head, _)| *head).collect()
}

/// The heads along a stroke, both ways, each with how far it is off a straight taper, px.
fn along(stroke: &Stroke, planes: &[Plane], least: f32) -> Vec<(f32, FilledHead)> {
    let mut points: Vec<PxPoint> = stroke.contour.vertices.iter().map(|vertex| vertex.at).collect();
    let mut found = Vec::new();
    for _ in 0..2 {
        found.extend(points.windows(WINDOW).filter_map(|shaft| ahead_of(shaft, stroke.width, planes, least)));
        points.reverse();
    }
    found
}

/// The head to which the vertices of a shaft lead, with how far it is off a straight taper, px.
fn ahead_of(shaft: &[PxPoint], width: f32, planes: &[Plane], least: f32) -> Option<(f32, FilledHead)> {
    let (&first, &last) = shaft.first().zip(shaft.last())?;
    let chord = (last - first).try_normalize()?;
    // a cheap look, before a line is fitted: most places of most strokes have no wide spot ahead
    Ray::of(last + chord * AHEAD, chord, width, planes, least)?;
    let line = LineFit::through(shaft.iter().copied()).filter(|line| line.rms <= STRAIGHT)?;
    let from = line.nearest(last) + line.direction * AHEAD;
    Ray::of(from, line.direction, width, planes, least)?.head()
}

/// A straight line along which ink is looked at.
struct Ray<'a> {
    planes: &'a [Plane],
    from: PxPoint,
    along: PxVector,
    ground: PlaneColour,
    /// How far the colour of the ink is from the ground, and the square of that.
    ink: PlaneColour,
    square: f32,
}

impl<'a> Ray<'a> {
    /// From a place on, if there is a wide spot shortly behind it.
    fn of(from: PxPoint, along: PxVector, width: f32, planes: &'a [Plane], least: f32) -> Option<Self> {
        let across = right_of(along);
        let beside = across * (BESIDE_WIDTHS * width + BESIDE);
        let spots = LOOK.map(|ahead| {
            let at = from + along * ahead;
            [at, at + beside, at - beside].map(|at| colour(planes, at))
        });
        let is_alike = |[middle, right, left]: &[PlaneColour; 3]| {
            [right, left].into_iter().all(|side| square(less(*side, *middle)) <= ALIKE * ALIKE)
        };
        // most places are on a stroke, with its ground beside it
        if !spots.iter().any(is_alike) {
            return None;
        }
        let aside = across * (0.5 * width + GROUND);
        let grounds: Vec<PlaneColour> = BEFORE
            .iter()
            .flat_map(|before| [aside, -aside].map(|aside| colour(planes, from - along * *before + aside)))
            .collect();
        let ground: PlaneColour = std::array::from_fn(|k| median(grounds.iter().map(|ground| ground[k])));
        let ink = spots.iter().find_map(|[middle, right, left]| {
            let ink = less(*middle, ground);
            let is_ink = |side: PlaneColour| dot(less(side, ground), ink) >= MOSTLY * square(ink);
            (square(ink) >= least * least && is_ink(*right) && is_ink(*left)).then_some(ink)
        })?;
        Some(Self { planes, from, along, ground, ink, square: square(ink) })
    }

    /// The place so far along the ray and to its right, px.
    fn at(&self, along: f32, right: f32) -> PxPoint {
        self.from + self.along * along + right_of(self.along) * right
    }

    /// How much ink there is at a place: 0 none, 1 as much as in the head.
    fn ink_at(&self, along: f32, right: f32) -> f32 {
        dot(less(colour(self.planes, self.at(along, right)), self.ground), self.ink) / self.square
    }

    /// How wide the ink is to the right and to the left, px; none if it is wider than any head.
    fn halves(&self, along: f32) -> Option<[f32; 2]> {
        let half = |side: f32| {
            let mut sum = 0.0;
            for k in 0..(REACH / STEP) as usize {
                let ink = self.ink_at(along, side * (k as f32 + 0.5) * STEP);
                if ink < END {
                    return Some(sum);
                }
                sum += ink.min(1.0) * STEP;
            }
            None
        };
        Some([half(1.0)?, half(-1.0)?])
    }

    /// The head on the ray, with how far it is off a straight taper, px.
    fn head(&self) -> Option<(f32, FilledHead)> {
        let of_shaft = less(colour(self.planes, self.at(FROM + AHEAD, 0.0)), self.ground);
        let least = ONE_COLOUR * (square(of_shaft) * self.square).sqrt();
        if dot(of_shaft, self.ink) < least.max(SHAFT_INK * self.square) {
            return None;
        }
        let count = ((TO - FROM) / STEP) as usize;
        let halves: Vec<[f32; 2]> = (0..count).map_while(|k| self.halves(place(k))).collect();
        let taper = self.with_barbs(Taper::of(&halves)?)?;
        let line = self.line_before(&taper)?;
        if self.goes_on(&taper) || self.is_sign(&taper) {
            return None;
        }
        let head = FilledHead {
            apex: self.at(taper.apex, 0.0),
            base: self.at(taper.base, 0.0),
            half_width: taper.half_width,
            shaft: taper.shaft,
            ground: self.ground,
            ink: self.ink,
            line,
        };
        Some((taper.off, head))
    }

    /// A head whose barbs lie behind the notch in its base, with these; none if they have no end.
    fn with_barbs(&self, taper: Taper) -> Option<Taper> {
        let slope = taper.half_width / (taper.apex - taper.base);
        let most = (BARBS / STEP) as usize;
        let is_barb = |along: &f32| {
            let side = slope * (taper.apex - along);
            [1.0, -1.0].iter().all(|way| {
                let is_inside = INSIDE.iter().any(|by| self.ink_at(*along, way * (side - by)) >= BARB_INK);
                is_inside && self.ink_at(*along, way * (side + OUTSIDE)) <= CLEAR_INK
            })
        };
        let barbs = (1..=most).map(|k| taper.base - k as f32 * STEP).take_while(is_barb).count();
        if barbs < BARB_STEPS {
            return Some(taper);
        }
        let base = taper.base - barbs as f32 * STEP;
        (barbs < most).then_some(Taper { base, half_width: slope * (taper.apex - base), ..taper })
    }

    /// Whether a curve goes on from what may be a head, in another direction than its shaft.
    fn is_sign(&self, taper: &Taper) -> bool {
        let length = taper.apex - taper.base;
        let middle = taper.base + 0.5 * length;
        let measures = Measures { length, half_width: taper.half_width, shaft: taper.shaft };
        one_stroke_leaves(|u, v| self.ink_at(middle + u, v), measures)
    }

    /// The line beside the shaft before the base of a head, if there is one; none at all if there is ink on both sides.
    fn line_before(&self, taper: &Taper) -> Option<Option<f32>> {
        let [from, to] = CLEAR.map(|before| taper.base - before);
        let first = 0.5 * taper.shaft + CLEAR_FROM;
        let is_clear = |side: f32| {
            steps(from, to).all(|along| {
                let mut places = steps(first, taper.half_width + CLEAR_TO);
                places.all(|right| self.ink_at(along, side * right) <= CLEAR_INK)
            })
        };
        let side = match [1.0, -1.0].map(is_clear) {
            [true, true] => return Some(None),
            [false, true] => 1.0,
            [true, false] => -1.0,
            [false, false] => return None,
        };
        let (mut sum, mut moment) = (0.0, 0.0);
        for right in steps(first, taper.half_width + LINE_TO) {
            let ink = self.ink_at(taper.base - LINE_AT, side * right).clamp(0.0, 1.0);
            sum += ink;
            moment += ink * right;
        }
        Some((sum > 0.0).then(|| side * moment / sum))
    }

    /// Whether a line goes on straight behind a head.
    fn goes_on(&self, taper: &Taper) -> bool {
        let from = taper.apex + taper.shaft + 1.0;
        let to = from + GOES_ON;
        let is_wide = |[right, left]: [f32; 2]| right + left > GOES_ON_WIDTHS * taper.shaft + EVEN;
        steps(from, to).all(|along| self.ink_at(along, 0.0) >= END) && !self.halves(to).is_none_or(is_wide)
    }
}

/// How the width of a shaft grows to that of a head and falls from there on. Places are px along its ray.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Taper {
    base: f32,
    apex: f32,
    half_width: f32,
    shaft: f32,
    /// How far the widths are off a straight line at most, px.
    off: f32,
}

impl Taper {
    /// Of widths, given by their halves, if it is that of a head.
    fn of(halves: &[[f32; 2]]) -> Option<Self> {
        let widths: Vec<f32> = halves.iter().map(|[right, left]| right + left).collect();
        let of_shaft = widths.get(..OF_SHAFT)?;
        let shaft = median(of_shaft.iter().copied());
        if shaft < THINNEST || of_shaft.iter().any(|width| *width > EVEN_TIMES * shaft + EVEN) {
            return None;
        }
        let of_base = OF_BASE.start..OF_BASE.end.min(widths.len());
        let widest = of_base.rev().max_by(|a, b| widths[*a].total_cmp(&widths[*b]))?;
        let most = widths[widest];
        if most < (WIDER_TIMES * shaft).max(shaft + WIDER) {
            return None;
        }
        let narrow = (0..widest).rev().find(|k| widths[*k] <= mix(shaft, most, RISE_FROM))?;
        let first_from = |least: f32| (narrow..=widest).find(|k| widths[*k] >= least);
        let (wide, middle) = (first_from(RISE_TO * most)?, first_from(mix(shaft, most, 0.5))?);
        let falls = |k: &usize| widths[*k] <= widths[*k - 1] + NO_FALL && widths[*k] >= FOLLOWED * most;
        let end = widest + (widest + 1..widths.len()).take_while(falls).count();
        let rise = (wide - narrow) as f32 / (RISE_TO - RISE_FROM);
        let fall = (end - widest) as f32 / (1.0 - widths[end] / most).max(f32::EPSILON);
        if rise > RISE * fall || wide - narrow > RISE_STEPS {
            return None;
        }
        if widths[end] > FALLEN * most || end - widest < FALL_STEPS {
            return None;
        }
        let differs = |[right, left]: &[f32; 2]| (right - left).abs() > UNLIKE_SHARE * (right + left) + UNLIKE;
        if halves[widest..=end].iter().any(differs) {
            return None;
        }
        let (at, slope, off) = fitted(&widths, widest + 1..end + 1)?;
        let base = place(middle) - 0.5 * STEP;
        let apex = at - widths_at(&widths, widest + 1..end + 1) / slope;
        let half_width = 0.5 * slope * (base - apex);
        let length = apex - base;
        let is_head =
            off <= OFF_LINE.max(OFF_LINE_SHARE * most) && length >= SHORTEST && SHAPES.contains(&(half_width / length));
        is_head.then_some(Self { base, apex, half_width, shaft, off })
    }
}

/// Where the width of this number is taken, px along its ray.
fn place(number: usize) -> f32 {
    FROM + number as f32 * STEP
}

/// The mean of some widths.
fn widths_at(widths: &[f32], range: std::ops::Range<usize>) -> f32 {
    let count = range.len() as f32;
    widths[range].iter().sum::<f32>() / count
}

/// The straight line through some widths: the mean of their places, its slope, which is less than 0, and how far the
/// widths are off it at most, px.
fn fitted(widths: &[f32], range: std::ops::Range<usize>) -> Option<(f32, f32, f32)> {
    let mean_width = widths_at(widths, range.clone());
    let middle = 0.5 * (place(range.start) + place(range.end - 1));
    let (mut squares, mut products) = (0.0, 0.0);
    for k in range.clone() {
        let along = place(k) - middle;
        squares += along * along;
        products += along * (widths[k] - mean_width);
    }
    let slope = products / squares;
    let off = |k: usize| (widths[k] - mean_width - slope * (place(k) - middle)).abs();
    let most = range.map(off).fold(0.0, f32::max);
    (slope < 0.0).then_some((middle, slope, most))
}

/// Places from one to another, in steps.
fn steps(from: f32, to: f32) -> impl Iterator<Item = f32> {
    let count = ((to - from) / STEP).floor().max(0.0) as usize;
    (0..=count).map(move |k| from + k as f32 * STEP)
}

#[cfg(test)]
mod tests;
