//! A few dots that stand apart say nothing, and a single row of dots is felt as a line.

use std::collections::BTreeMap;

use crate::textures::{Sign, unit};
use crate::units::MmPoint;

/// Fewer dots than this together are no texture: two rows of three.
const LEAST_GROUP: usize = 6;
/// Two rows lie further apart than this, in pitches; the two halves of a thick row lie nearer.
const ONE_ROW: f32 = 1.5;

/// Leaves out groups of dots that are no texture: fewer than [`LEAST_GROUP`], or all in one row. Dots no further apart than
/// `reach` mm belong together.
pub(super) fn leave_out(dots: &mut Vec<MmPoint>, sign: Sign, reach: f32, pitch: f32) {
    let reach = 1.01 * reach;
    let across: &[f32] = match sign {
        Sign::Rhombus { degrees } => &[degrees + 90.0],
        Sign::Dot => &[0.0, 90.0],
    };
    let is_wide = |group: &[usize]| {
        across.iter().all(|degrees| {
            let way = unit(*degrees);
            let along = group.iter().map(|&dot| dots[dot].to_vector().dot(way));
            let (low, high) = along.fold((f32::MAX, f32::MIN), |(low, high), at| (low.min(at), high.max(at)));
            high - low >= ONE_ROW * pitch
        })
    };
    let mut stays = vec![false; dots.len()];
    for group in groups(dots, reach) {
        if group.len() >= LEAST_GROUP && is_wide(&group) {
            group.into_iter().for_each(|dot| stays[dot] = true);
        }
    }
    let mut stays = stays.into_iter();
    dots.retain(|_| stays.next() == Some(true));
}

/// The dots that belong together, as numbers.
fn groups(dots: &[MmPoint], reach: f32) -> Vec<Vec<usize>> {
    let square = |at: MmPoint| ((at.y / reach).floor() as i32, (at.x / reach).floor() as i32);
    let mut by_square: BTreeMap<(i32, i32), Vec<usize>> = BTreeMap::new();
    for (number, &at) in dots.iter().enumerate() {
        by_square.entry(square(at)).or_default().push(number);
    }
    let mut seen = vec![false; dots.len()];
    let mut groups = Vec::new();
    for start in 0..dots.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut group = vec![start];
        let mut next = 0;
        while next < group.len() {
            let here = dots[group[next]];
            let (row, column) = square(here);
            for near in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (row + dy, column + dx))) {
                for &other in by_square.get(&near).into_iter().flatten() {
                    if !seen[other] && (dots[other] - here).length() <= reach {
                        seen[other] = true;
                        group.push(other);
                    }
                }
            }
            next += 1;
        }
        groups.push(group);
    }
    groups
}
