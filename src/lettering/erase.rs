//! Letters taken out of a picture: what lies around them grows in.

use crate::raster::{Planes, Raster};
use crate::units::Size;

/// The pixels of letters with those around them that are smoothed into the ground, `reach` px far; not what belongs to
/// something else that is thin, such as a line that passes by.
pub(super) fn with_margin(letters: &[usize], others: &[bool], size: Size, reach: usize) -> Vec<usize> {
    let width = size.width as usize;
    // the part of the picture around them: there are many texts, and each is small
    let side = |of: fn(usize, usize) -> usize, axis: fn(usize, usize) -> usize| {
        letters.iter().map(|&cell| axis(cell, width)).reduce(of).unwrap_or(0)
    };
    let (column, row) = (|cell: usize, width: usize| cell % width, |cell: usize, width: usize| cell / width);
    let first = [side(usize::min, column), side(usize::min, row)].map(|at| at.saturating_sub(reach));
    let columns = side(usize::max, column) + reach + 1 - first[0];
    let rows = side(usize::max, row) + reach + 1 - first[1];
    let at = |cell: usize| (cell / width - first[1]) * columns + cell % width - first[0];
    let mut is_in = vec![false; columns * rows];
    letters.iter().for_each(|&cell| is_in[at(cell)] = true);
    let mut all = letters.to_vec();
    let mut from = 0;
    for _ in 0..reach {
        let to = all.len();
        for i in from..to {
            for (neighbour, _) in neighbours(all[i], size) {
                if !is_in[at(neighbour)] && !others[neighbour] {
                    is_in[at(neighbour)] = true;
                    all.push(neighbour);
                }
            }
        }
        from = to;
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
