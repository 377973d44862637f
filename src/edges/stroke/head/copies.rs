//! Signs like what may be the head of an arrow. Those of a curve are many, and turned alike wherever it leads; heads
//! stand at the ends of shafts.

use super::filled::{FilledHead, PlaneColour, dot, minus, square};
use crate::geom::right_of;
use crate::raster::plane::Plane;
use crate::units::PxPoint;

/// The ground is compared so far beside a head, px.
const MARGIN: f32 = 2.0;
/// A copy differs by no more than this share of its ink.
const UNLIKE: f32 = 0.25;
/// There is ink of at least this share in a sign, and of the second in its shaft.
const INK: f32 = 0.6;
const SHAFT_INK: f32 = 0.3;
/// A shaft is looked for at these places before a base, px.
const BEFORE: [f32; 3] = [2.5, 4.0, 5.5];
/// A sign is compared by the place that lies so far along its length.
const MIDDLE: f32 = 1.0 / 3.0;

/// Signs like a head that are no heads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Copies {
    pub(super) all: usize,
    /// Those to which no shaft leads.
    pub(super) without_shaft: usize,
}

/// A head as pixels.
struct Sign<'a> {
    head: &'a FilledHead,
    planes: &'a [Plane],
    /// Pixels around that of its middle, with the ink in them.
    pixels: Vec<([i32; 2], f32)>,
    middle: [i32; 2],
    /// All its ink.
    ink: f32,
}

impl Copies {
    /// Those of a head, where these are all `heads`.
    pub(super) fn of(head: &FilledHead, heads: &[FilledHead], planes: &[Plane]) -> Self {
        let Some(size) = planes.first().map(|plane| plane.size) else { return Self::default() };
        let sign = Sign::of(head, planes);
        let near = (head.apex - head.base).length().max(head.half_width);
        let is_head = |[x, y]: [i32; 2]| {
            let at = PxPoint::new(x as f32 + 0.5, y as f32 + 0.5);
            heads.iter().any(|head| (head.base.lerp(head.apex, MIDDLE) - at).length() < near)
        };
        let places = (0..size.height as i32).flat_map(|y| (0..size.width as i32).map(move |x| [x, y]));
        let inked = places.filter(|at| sign.ink_at(*at) >= INK);
        let mut found: Vec<(f32, [i32; 2])> =
            inked.filter_map(|at| sign.unlike(at).map(|unlike| (unlike, at))).filter(|(_, at)| !is_head(*at)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut copies: Vec<[i32; 2]> = Vec::new();
        for (_, [x, y]) in found {
            if !copies.iter().any(|other| ((other[0] - x) as f32).hypot((other[1] - y) as f32) < near) {
                copies.push([x, y]);
            }
        }
        let without_shaft = copies.iter().filter(|at| !sign.has_shaft(**at)).count();
        Self { all: copies.len(), without_shaft }
    }
}

impl<'a> Sign<'a> {
    fn of(head: &'a FilledHead, planes: &'a [Plane]) -> Self {
        let axis = head.apex - head.base;
        let (length, along) = (axis.length(), axis.normalize());
        let middle = head.base.lerp(head.apex, MIDDLE);
        let middle = [middle.x.floor() as i32, middle.y.floor() as i32];
        let mut sign = Self { head, planes, pixels: Vec::new(), middle, ink: 0.0 };
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
                sign.pixels.push((by, sign.ink_at(at)));
            }
        }
        sign.ink = sign.pixels.iter().map(|(_, ink)| ink).sum();
        // ink and ground by turns, so that most places differ enough at once
        sign.pixels.sort_by(|a, b| b.1.total_cmp(&a.1));
        let (inked, mut ground) = (sign.pixels.len() / 2, sign.pixels.clone());
        let ground = ground.split_off(inked).into_iter().rev();
        let by_turns = sign.pixels[..inked].iter().zip(ground.clone()).flat_map(|(ink, ground)| [*ink, ground]);
        sign.pixels = by_turns.chain(ground.skip(inked)).collect();
        sign
    }

    /// How much ink there is in a pixel.
    fn ink_at(&self, [x, y]: [i32; 2]) -> f32 {
        let value = |plane: &Plane| {
            let is_in = (0..plane.size.width as i32).contains(&x) && (0..plane.size.height as i32).contains(&y);
            is_in.then(|| plane.values[y as usize * plane.size.width as usize + x as usize])
        };
        let at: PlaneColour =
            std::array::from_fn(|k| self.planes.get(k).and_then(value).unwrap_or(self.head.ground[k]));
        (dot(minus(at, self.head.ground), self.head.ink) / square(self.head.ink)).clamp(0.0, 1.0)
    }

    /// By which share of its ink the sign differs from what is at a place, if it is a copy.
    fn unlike(&self, [x, y]: [i32; 2]) -> Option<f32> {
        let most = UNLIKE * self.ink;
        let mut sum = 0.0;
        for ([dx, dy], ink) in &self.pixels {
            sum += (self.ink_at([x + dx, y + dy]) - ink).abs();
            if sum > most {
                return None;
            }
        }
        Some(sum / self.ink)
    }

    /// Whether a shaft leads to a copy at a place, straight from behind.
    fn has_shaft(&self, [x, y]: [i32; 2]) -> bool {
        let along = (self.head.apex - self.head.base).normalize();
        BEFORE.iter().all(|before| {
            let at = self.head.base - along * *before;
            let (at_x, at_y) = (at.x.floor() as i32 + x - self.middle[0], at.y.floor() as i32 + y - self.middle[1]);
            let mut beside = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [at_x + dx, at_y + dy]));
            beside.any(|at| self.ink_at(at) >= SHAFT_INK)
        })
    }
}

#[cfg(test)]
mod tests;
