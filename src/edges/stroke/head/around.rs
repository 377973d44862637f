//! Which strokes leave from what may be the head of an arrow. From a head none does but its shaft, or two do, which are
//! those of what it points at; from a sign where a curve bends it is one.

use std::f32::consts::PI;

/// Strokes are looked at so far beyond the corners of a head, px.
const BEYOND: f32 = 4.0;
/// Ink of at least this share holds together.
const TOGETHER: f32 = 0.4;
/// Strokes are two where there is no ink between them for this long, px.
const APART: f32 = 2.5;
/// The shaft leaves straight back, but for this, radians.
const SHAFT: f32 = 0.45;
/// What is wider than so many times the shaft and this much more, px, is no stroke.
const WIDE_TIMES: f32 = 3.0;
const WIDE: f32 = 4.0;

/// The measures of a head, px.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measures {
    pub(super) length: f32,
    pub(super) half_width: f32,
    pub(super) shaft: f32,
}

/// Whether just one stroke leaves from a head beside its shaft. The share of ink is that at a place so far along the
/// head from its middle, and to the right, px.
pub(super) fn one_stroke_leaves(ink_at: impl Fn(f32, f32) -> f32, head: Measures) -> bool {
    let half = 0.5 * head.length;
    let reach = (half + head.shaft).max(half.hypot(head.half_width)) + BEYOND;
    let is_wide = |[first, last]: [f32; 2]| (last - first) * reach > WIDE_TIMES * head.shaft + WIDE;
    let is_of_shaft = |[first, last]: [f32; 2]| PI - first.abs() < SHAFT || PI - last.abs() < SHAFT;
    let mut others = arcs(reached(ink_at, reach), APART / reach);
    others.retain(|arc| !is_of_shaft(*arc));
    matches!(others[..], [arc] if !is_wide(arc))
}

/// The directions in which ink that holds together with the middle comes farther away from it than a reach, px.
fn reached(ink_at: impl Fn(f32, f32) -> f32, reach: f32) -> Vec<f32> {
    let half = reach.ceil() as usize + 2;
    let side = 2 * half + 1;
    let mut seen = vec![false; side * side];
    let mut open = vec![(half, half)];
    seen[half * side + half] = true;
    let mut directions = Vec::new();
    while let Some((x, y)) = open.pop() {
        let place = |at: usize| at as f32 - half as f32;
        if place(x).hypot(place(y)) > reach {
            directions.push(place(y).atan2(place(x)));
            continue;
        }
        // the margin of two cells is never left
        for (to_x, to_y) in (y - 1..=y + 1).flat_map(|to_y| (x - 1..=x + 1).map(move |to_x| (to_x, to_y))) {
            let is_seen = &mut seen[to_y * side + to_x];
            if !*is_seen && ink_at(place(to_x), place(to_y)) >= TOGETHER {
                *is_seen = true;
                open.push((to_x, to_y));
            }
        }
    }
    directions
}

/// Directions in runs, each from its first to its last, in which none is farther from the next than a gap.
fn arcs(mut directions: Vec<f32>, gap: f32) -> Vec<[f32; 2]> {
    directions.sort_by(f32::total_cmp);
    let mut arcs: Vec<[f32; 2]> = Vec::new();
    for direction in directions {
        match arcs.last_mut() {
            Some([_, last]) if direction - *last <= gap => *last = direction,
            _ => arcs.push([direction, direction]),
        }
    }
    arcs
}

#[cfg(test)]
mod tests;
