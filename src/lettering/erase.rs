//! Letters taken out of a picture: what lies around them grows in.

use crate::raster::{Planes, Raster};
use crate::units::Size;

/// The letters with the pixels around them that are smoothed into the ground, `reach` px far; not what belongs to
/// something else that is thin, such as a line that passes by.
pub(super) fn with_margin(letters: &[bool], others: &[bool], size: Size, reach: usize) -> Vec<bool> {
    let mut all = letters.to_vec();
    let mut last: Vec<usize> = (0..all.len()).filter(|&cell| all[cell]).collect();
    for _ in 0..reach {
        let mut next = Vec::new();
        for &cell in &last {
            for (neighbour, _) in neighbours(cell, size) {
                if !all[neighbour] && !others[neighbour] {
                    all[neighbour] = true;
                    next.push(neighbour);
                }
            }
        }
        last = next;
    }
    all
}

/// A picture in which the pixels of a mask take the mean colour of their neighbours, from the border of the mask
/// inwards. Of a mask without a border, nothing is changed.
pub(super) fn erased(raster: &Raster, mask: &[bool]) -> Raster {
    let size = raster.size();
    let mut known: Vec<bool> = mask.iter().map(|masked| !masked).collect();
    let mut planes = raster.planes().clone();
    let mut left: Vec<usize> = (0..mask.len()).filter(|&cell| mask[cell]).collect();
    loop {
        let is_next = |cell: &usize| neighbours(*cell, size).any(|(neighbour, _)| known[neighbour]);
        let (layer, rest): (Vec<usize>, Vec<usize>) = left.into_iter().partition(is_next);
        if layer.is_empty() {
            break;
        }
        for plane in planes.as_mut_slice() {
            let means: Vec<f32> = layer.iter().map(|&cell| mean(plane, &known, cell, size)).collect();
            layer.iter().zip(means).for_each(|(&cell, mean)| plane[cell] = mean);
        }
        layer.iter().for_each(|&cell| known[cell] = true);
        left = rest;
    }
    match planes {
        Planes::Grey(plane) => Raster::grey(size, plane),
        Planes::Colour(planes) => Raster::colour(size, planes),
    }
}

/// The mean of the neighbours that are known; those at a corner count by their distance.
fn mean(plane: &[f32], known: &[bool], cell: usize, size: Size) -> f32 {
    let near = neighbours(cell, size).filter(|&(neighbour, _)| known[neighbour]);
    let (sum, weights) = near.fold((0.0_f64, 0.0_f64), |(sum, weights), (neighbour, weight)| {
        (sum + weight * f64::from(plane[neighbour]), weights + weight)
    });
    (sum / weights) as f32
}

/// The up to eight neighbours of a pixel, and their weights.
fn neighbours(cell: usize, size: Size) -> impl Iterator<Item = (usize, f64)> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    (0..9).filter(|&i| i != 4).filter_map(move |i| {
        let (nx, ny) = ((x + i % 3).checked_sub(1)?, (y + i / 3).checked_sub(1)?);
        let weight = if i % 2 == 1 { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
        (nx < width && ny < height).then_some((ny * width + nx, weight))
    })
}

#[cfg(test)]
mod tests;
