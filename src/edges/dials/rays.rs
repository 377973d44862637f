//! Which rays the ink at the middle of a dial consists of.

use super::face::Ink;
use crate::geom::order::median;
use crate::geom::right_of;
use crate::units::PxVector;

/// A hand is at least this long, in radii of the dial, and so many times as long as wide; and no wider than this.
const SHORTEST: f32 = 0.25;
const LONG: f32 = 2.5;
const WIDEST: f32 = 0.17;
/// It is nowhere wider than so many of the widest strokes that are drawn as one line: what is has room as an outline,
/// as the needle of a compass.
const BROADEST: f32 = 1.6;
/// A dial has so many hands.
const HANDS: std::ops::RangeInclusive<usize> = 1..=3;
/// So many rays are looked for: what is left of a tip is one, too.
const MOST_ROUNDS: usize = 12;
/// A ray is found before if the cosine between the two is more than this (2 degrees).
const SAME_WAY: f32 = 0.9994;
/// What is at least this share as far as the tip tells where that is.
const OF_TIP: f32 = 0.93;
/// The hub is no farther from the middle than this, and tails of hands no farther than that, in radii.
const HUB: f32 = 0.15;
const TAIL: f32 = 0.32;
/// Ink is part of a ray up to this far beyond its half width, px, or this share of the radius.
const BEYOND: f32 = 1.5;
const BEYOND_SHARE: f32 = 0.012;
/// Along a ray there is ink at this share of it, at least.
const INKED: f32 = 0.93;
/// The direction of a ray is taken over this part of it.
const OUTER: [f32; 2] = [0.55, 0.95];
/// What is no part of a ray is at most this share of the ink beyond the hub and the tails.
const REST: f32 = 0.12;

/// A hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ray {
    /// Away from the middle: of length 1.
    pub(super) way: PxVector,
    pub(super) length: f32,
    /// That of most of it, px.
    pub(super) width: f32,
}

/// The hands that the ink consists of; none if it is something else. `widest` is the width of the widest stroke that is
/// drawn as one line, px.
pub(super) fn hands(ink: &Ink, widest: f32) -> Option<Vec<Ray>> {
    let mut left: Vec<PxVector> = ink.places().filter(|way| way.length() > HUB * ink.radius).collect();
    let beyond = |left: &[PxVector]| left.iter().filter(|way| way.length() > TAIL * ink.radius).count() as f32;
    let all = beyond(&left);
    let mut rays: Vec<Ray> = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let Some((ray, tip)) = longest(ink, &left) else { break };
        let halves = ray.halves(ink);
        let is_of = |way: &PxVector| {
            let (along, aside) = (way.dot(ray.way), way.cross(ray.way).abs());
            let is_along = along > 0.0 && halves.get(along as usize).is_some_and(|half| aside <= *half);
            is_along || (*way - tip).length() <= 2.0 * beside(ink)
        };
        left.retain(|way| !is_of(way));
        // corners of a tip point the same way once more
        let is_new = rays.iter().all(|other| other.way.dot(ray.way) <= SAME_WAY);
        if is_new && ray.is_hand(ink, BROADEST * widest) {
            rays.push(ray);
        } else if rays.is_empty() {
            // the longest hand is no hand, as what is bent
            return None;
        }
    }
    (HANDS.contains(&rays.len()) && beyond(&left) <= REST * all).then_some(rays)
}

/// How far beyond the half width of a ray ink is part of it, px.
fn beside(ink: &Ink) -> f32 {
    BEYOND.max(BEYOND_SHARE * ink.radius)
}

/// The ray to the farthest of some ink that is far enough for a hand, and where that is.
fn longest(ink: &Ink, left: &[PxVector]) -> Option<(Ray, PxVector)> {
    let tip = *left.iter().max_by(|a, b| a.square_length().total_cmp(&b.square_length()))?;
    let length = tip.length();
    if length < SHORTEST * ink.radius {
        return None;
    }
    let most = left.iter().filter(|way| way.length() >= OF_TIP * length);
    // the middle of what is there
    let near = most.filter(|way| (**way - tip).length() <= WIDEST * ink.radius);
    let way = near.fold(PxVector::zero(), |sum, way| sum + *way).try_normalize()?;
    let mut ray = Ray { way, length, width: 0.0 };
    for _ in 0..2 {
        let [from, to] = OUTER.map(|share| (share * length) as usize);
        let aside = median((from..to).filter_map(|along| ray.middle_at(ink, along as f32)));
        let along = 0.5 * (from + to) as f32;
        ray.way = (ray.way * along + right_of(ray.way) * aside).try_normalize()?;
    }
    let near = left.iter().filter(|way| way.cross(ray.way).abs() <= BEYOND + 1.0);
    ray.length = near.map(|way| way.dot(ray.way)).fold(0.0, f32::max);
    let from = (HUB * ink.radius) as usize;
    ray.width = 2.0 * median((from..ray.length as usize).map(|along| ray.half_at(ink, along as f32)));
    Some((ray, tip))
}

impl Ray {
    /// How far ink goes from its middle to the left and to the right, px; 0 where there is none.
    fn sides_at(&self, ink: &Ink, along: f32) -> [f32; 2] {
        let most = (WIDEST * ink.radius) as i32;
        let at = self.way * along;
        [-1, 1].map(|side| {
            let is_ink = |k: &i32| ink.is_at(at + right_of(self.way) * (side * k) as f32 * 0.5);
            (0..2 * most).take_while(is_ink).count() as f32 * 0.5
        })
    }

    /// Half its width so far from the middle, px: what is there on both sides.
    fn half_at(&self, ink: &Ink, along: f32) -> f32 {
        let [left, right] = self.sides_at(ink, along);
        left.min(right)
    }

    /// How far from its middle ink is part of it, in steps of a pixel: what is there on both sides, with the corners of
    /// its end.
    fn halves(&self, ink: &Ink) -> Vec<f32> {
        let beside = beside(ink);
        let halves: Vec<f32> = (0..=self.length as usize).map(|along| self.half_at(ink, along as f32)).collect();
        let around = (0.5 * self.width + beside) as usize + 1;
        let widest = |k: usize| {
            let range = k.saturating_sub(around).min(halves.len() - 1)..(k + around + 1).min(halves.len());
            halves[range].iter().copied().fold(0.0, f32::max) + beside
        };
        (0..(self.length + beside) as usize + 2).map(widest).collect()
    }

    /// How far to the right the middle of the ink lies there, px; none if there is none.
    fn middle_at(&self, ink: &Ink, along: f32) -> Option<f32> {
        let [left, right] = self.sides_at(ink, along);
        (left.max(right) > 0.0).then_some(0.5 * (right - left))
    }

    /// Whether it is a hand: long, nowhere wider than this, px, and of ink all along.
    fn is_hand(&self, ink: &Ink, broadest: f32) -> bool {
        let from = (HUB * ink.radius) as usize;
        let steps = from..(0.97 * self.length) as usize;
        let inked = steps.clone().filter(|&along| ink.is_at(self.way * along as f32)).count();
        let half = steps.clone().map(|along| self.half_at(ink, along as f32)).fold(0.0, f32::max);
        2.0 * half <= broadest
            && self.width <= WIDEST * ink.radius
            && self.length >= LONG * self.width
            && self.length >= SHORTEST * ink.radius
            && inked as f32 >= INKED * steps.len() as f32
    }
}
