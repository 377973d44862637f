//! Signs like what may be the head of an arrow. Those of a curve are many, and turned alike wherever it leads; heads
//! stand at the ends of shafts.

use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::filled::{FilledHead, PlaneColour};
use crate::geom::right_of;
use crate::raster::contrast::{dot, less, square};
use crate::raster::plane::Plane;
use crate::units::{PxPoint, Size};

/// The ground is compared so far beside a head, px.
const MARGIN: f32 = 2.0;
/// A copy differs by no more than this share of its ink.
const UNLIKE: f32 = 0.25;
/// There is ink of at least this share in a sign, and of the second in its shaft.
const INK: f32 = 0.6;
const SHAFT_INK: f32 = 0.3;
/// A shaft is looked for so far before a base, px, in steps: one that leads up to a sign has ink at the first places,
/// so many; another one in both halves.
const BEFORE: [f32; 2] = [2.0, 22.0];
const STEP: f32 = 0.5;
const LEADS: usize = 8;
/// A shaft of dashes has ink at this share of these places at least, with a gap in between.
const DASHES: f32 = 0.4;
/// A sign is compared by the place that lies so far along its length.
const MIDDLE: f32 = 1.0 / 3.0;
/// There is ink on all four sides of that place, this share of the way to the nearest side of the sign, if there is
/// some farther out in the sign itself: what is taken for a head may be thin strokes.
const AROUND: f32 = 0.6;
/// Heads are of one colour if neither that nor their grounds differ by more, in units of strength.
const ONE_COLOUR: f32 = 3.0;

/// Signs like a head that are no heads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Copies {
    /// But for those to which dashes lead, straight: heads, too, that are none of strokes.
    pub(super) all: usize,
    /// Those to which no shaft leads.
    pub(super) without_shaft: usize,
}

/// What leads to a sign, straight from behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shaft {
    None,
    Solid,
    Dashed,
}

/// How much of the ink of a colour there is in each pixel, from 0 to 1.
struct Ink {
    size: Size,
    values: Vec<f32>,
    /// The pixels that are ink.
    inked: Vec<[i32; 2]>,
}

/// A head as pixels.
struct Sign<'a> {
    head: &'a FilledHead,
    ink: &'a Ink,
    /// Pixels around that of its middle, with the ink in them.
    pixels: Vec<([i32; 2], f32)>,
    middle: [i32; 2],
    /// There is ink this far from its middle, px.
    around: i32,
    /// All its ink.
    sum: f32,
}

impl Copies {
    /// Those of each of all heads.
    pub(super) fn of_each(heads: &[FilledHead], planes: &[Plane]) -> Vec<Self> {
        let mut copies = vec![Self::default(); heads.len()];
        for group in of_one_colour(heads) {
            let ink = Ink::of(&heads[group[0]], planes);
            let found: Vec<Self> = group.par_iter().map(|k| Self::of(&heads[*k], heads, &ink)).collect();
            for (k, found) in group.into_iter().zip(found) {
                copies[k] = found;
            }
        }
        copies
    }

    /// Those of a head, where these are all `heads`.
    fn of(head: &FilledHead, heads: &[FilledHead], ink: &Ink) -> Self {
        let sign = Sign::of(head, ink);
        let near = (head.apex - head.base).length().max(head.half_width);
        let is_at_head = |[x, y]: [i32; 2]| {
            let at = PxPoint::new(x as f32 + 0.5, y as f32 + 0.5);
            heads.iter().any(|other| (other.base.lerp(other.apex, MIDDLE) - at).length() < near)
        };
        let inked = ink.inked.iter().copied().filter(|at| ink.is_around(*at, sign.around));
        let mut found: Vec<(f32, [i32; 2])> = inked
            .filter_map(|at| sign.unlike(at).map(|unlike| (unlike, at)))
            .filter(|(_, at)| !is_at_head(*at))
            .collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut copies: Vec<[i32; 2]> = Vec::new();
        for (_, [x, y]) in found {
            if !copies.iter().any(|other| ((other[0] - x) as f32).hypot((other[1] - y) as f32) < near) {
                copies.push([x, y]);
            }
        }
        let shafts: Vec<Shaft> = copies.into_iter().map(|at| sign.shaft_at(at)).collect();
        let count = |of: Shaft| shafts.iter().filter(|shaft| **shaft == of).count();
        let without_shaft = count(Shaft::None);
        Self { all: without_shaft + count(Shaft::Solid), without_shaft }
    }
}

/// The numbers of heads by their colours.
fn of_one_colour(heads: &[FilledHead]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (k, head) in heads.iter().enumerate() {
        let is_alike = |group: &&mut Vec<usize>| {
            let first = &heads[group[0]];
            let off = [less(first.ground, head.ground), less(first.ink, head.ink)];
            off.into_iter().all(|off| square(off) <= ONE_COLOUR * ONE_COLOUR)
        };
        match groups.iter_mut().find(is_alike) {
            Some(group) => group.push(k),
            None => groups.push(vec![k]),
        }
    }
    groups
}

impl Ink {
    /// That of the colour of a head.
    fn of(head: &FilledHead, planes: &[Plane]) -> Self {
        let size = planes.first().map_or(Size::new(0, 0), |plane| plane.size);
        let share = 1.0 / square(head.ink);
        let value = |cell: usize| {
            let at: PlaneColour =
                std::array::from_fn(|k| planes.get(k).map_or(head.ground[k], |plane| plane.values[cell]));
            (dot(less(at, head.ground), head.ink) * share).clamp(0.0, 1.0)
        };
        let values: Vec<f32> = (0..size.len()).into_par_iter().map(value).collect();
        let width = size.width as usize;
        let inked = values.iter().enumerate().filter(|(_, ink)| **ink >= INK);
        let inked = inked.map(|(cell, _)| [(cell % width) as i32, (cell / width) as i32]).collect();
        Self { size, values, inked }
    }

    /// That in a pixel; none outside of the picture.
    fn at(&self, [x, y]: [i32; 2]) -> f32 {
        let is_in = (0..self.size.width as i32).contains(&x) && (0..self.size.height as i32).contains(&y);
        if is_in { self.values[y as usize * self.size.width as usize + x as usize] } else { 0.0 }
    }

    /// Whether there is some this far away on all four sides of a place, px: there is none beside a thin line.
    fn is_around(&self, [x, y]: [i32; 2], by: i32) -> bool {
        [[by, 0], [-by, 0], [0, by], [0, -by]].iter().all(|[dx, dy]| self.at([x + dx, y + dy]) >= INK)
    }
}

impl<'a> Sign<'a> {
    fn of(head: &'a FilledHead, ink: &'a Ink) -> Self {
        let axis = head.apex - head.base;
        let (length, along) = (axis.length(), axis.normalize());
        let middle = head.base.lerp(head.apex, MIDDLE);
        let middle = [middle.x.floor() as i32, middle.y.floor() as i32];
        let to_side = (1.0 - MIDDLE) * head.half_width * length / length.hypot(head.half_width);
        let most = (AROUND * to_side.min(MIDDLE * length)) as i32;
        let around = (1..=most + 1).take_while(|by| ink.is_around(middle, *by)).count().saturating_sub(1) as i32;
        let mut sign = Self { head, ink, pixels: Vec::new(), middle, around, sum: 0.0 };
        let reach = (length + head.half_width + MARGIN).ceil() as i32;
        // the shaft, and what the tip may touch, are none of the sign
        let is_of_sign = |[x, y]: [i32; 2]| {
            let from_base = PxPoint::new(x as f32 + 0.5, y as f32 + 0.5) - head.base;
            let (u, v) = (from_base.dot(along), from_base.dot(right_of(along)).abs());
            let half = head.half_width * (1.0 - u.max(0.0) / length);
            let is_shaft = u < 0.0 && v < 0.5 * head.shaft + 1.0;
            (-MARGIN..=length - head.shaft - 1.0).contains(&u) && v <= half + MARGIN && !is_shaft
        };
        for by in (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| [x, y])) {
            let at = [middle[0] + by[0], middle[1] + by[1]];
            if is_of_sign(at) {
                sign.pixels.push((by, ink.at(at)));
            }
        }
        sign.sum = sign.pixels.iter().map(|(_, ink)| ink).sum();
        // ink and ground by turns, so that most places differ enough at once
        sign.pixels.sort_by(|a, b| b.1.total_cmp(&a.1));
        let (inked, mut ground) = (sign.pixels.len() / 2, sign.pixels.clone());
        let ground = ground.split_off(inked).into_iter().rev();
        let by_turns = sign.pixels[..inked].iter().zip(ground.clone()).flat_map(|(ink, ground)| [*ink, ground]);
        sign.pixels = by_turns.chain(ground.skip(inked)).collect();
        sign
    }

    /// By which share of its ink the sign differs from what is at a place, if it is a copy.
    fn unlike(&self, [x, y]: [i32; 2]) -> Option<f32> {
        let most = UNLIKE * self.sum;
        let mut sum = 0.0;
        for ([dx, dy], ink) in &self.pixels {
            sum += (self.ink.at([x + dx, y + dy]) - ink).abs();
            if sum > most {
                return None;
            }
        }
        Some(sum / self.sum)
    }

    /// The shaft that leads to a copy at a place.
    fn shaft_at(&self, [x, y]: [i32; 2]) -> Shaft {
        let along = (self.head.apex - self.head.base).normalize();
        let is_inked = |k: usize| {
            let at = self.head.base - along * (BEFORE[0] + k as f32 * STEP);
            let (at_x, at_y) = (at.x.floor() as i32 + x - self.middle[0], at.y.floor() as i32 + y - self.middle[1]);
            let mut beside = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [at_x + dx, at_y + dy]));
            beside.any(|at| self.ink.at(at) >= SHAFT_INK)
        };
        let count = ((BEFORE[1] - BEFORE[0]) / STEP) as usize;
        let inked: Vec<bool> = (0..count).map(is_inked).collect();
        let runs = inked.chunk_by(|a, b| a == b).filter(|run| run[0]).count();
        let share = inked.iter().filter(|is_inked| **is_inked).count() as f32 / count as f32;
        let has_ink = |half: &[bool]| half.contains(&true);
        let (first, second) = inked.split_at(count / 2);
        if runs > 1 && share >= DASHES {
            Shaft::Dashed
        } else if !inked[..LEADS].contains(&false) || has_ink(first) && has_ink(second) {
            Shaft::Solid
        } else {
            Shaft::None
        }
    }
}

#[cfg(test)]
mod tests;
