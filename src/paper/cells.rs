//! A picture on cells of a few pixels, in logarithms of light, where a share of light is a difference.

use std::collections::VecDeque;

use crate::geom::components::four_neighbours;
use crate::raster::lab;
use crate::raster::plane::Plane;
use crate::raster::shrink::shrink;
use crate::raster::{Planes, Raster};
use crate::units::Size;

/// Side of a cell, px.
const CELL: u32 = 4;
/// Cells along the shorter side at least.
const LEAST_CELLS: u32 = 8;
/// A cell is flat up to this standard deviation of its lightness, of 100: the edge of a shadow that is ten cells wide
/// gives 1, that of a tint of 0.84 (#d6d6d6) across a cell 8.
const FLAT: f32 = 1.4;
/// With noise, a cell is flat up to this many standard deviations of the noise more.
const FLAT_NOISE: f32 = 1.8;
/// Two flat cells are of one part up to this step, in logarithms of linear light.
const STEP: f32 = 0.10;
/// With noise, they are so up to this much more for each unit of it.
const STEP_NOISE: f32 = 0.02;
/// What is darker, in linear light, is as dark as this.
const BLACK: f32 = 1e-4;

/// The cells of a picture.
pub(super) struct Cells {
    pub(super) size: Size,
    /// Logarithms of the mean of each plane in linear light.
    pub(super) logs: Vec<Plane>,
    /// Whether there is no contour and no stroke in it.
    pub(super) flat: Vec<bool>,
    /// Most step between two cells of one part.
    step: f32,
}

impl Cells {
    /// Of a picture with this noise; none if it is too small.
    pub(super) fn of(raster: &Raster, noise: f32) -> Option<Self> {
        let from = raster.size();
        let size = Size::new(from.width / CELL, from.height / CELL);
        if size.width.min(size.height) < LEAST_CELLS {
            return None;
        }
        let log = |plane: &Vec<f32>| {
            let mut plane = shrink(plane, from, size);
            plane.values.iter_mut().for_each(|value| *value = value.max(BLACK).ln());
            plane
        };
        let logs = raster.planes().as_ref().par_map(log).iter().cloned().collect();
        // about 50, so that squares keep their digits
        let mut lightness = lab::whole_lightness(raster).values;
        lightness.iter_mut().for_each(|value| *value -= 50.0);
        let mean = shrink(&lightness, from, size).values;
        lightness.iter_mut().for_each(|value| *value *= *value);
        let square = shrink(&lightness, from, size).values;
        let most = (FLAT + FLAT_NOISE * noise).powi(2);
        let flat = mean.iter().zip(&square).map(|(mean, square)| square - mean * mean <= most).collect();
        Some(Self { size, logs, flat, step: STEP + STEP_NOISE * noise })
    }

    /// The parts that are flat and have no step in them.
    pub(super) fn parts(&self) -> Vec<Vec<usize>> {
        let is_alike =
            |a: usize, b: usize| self.logs.iter().all(|plane| (plane.values[a] - plane.values[b]).abs() <= self.step);
        let mut is_taken: Vec<bool> = self.flat.iter().map(|flat| !flat).collect();
        let mut parts = Vec::new();
        for first in 0..is_taken.len() {
            if std::mem::replace(&mut is_taken[first], true) {
                continue;
            }
            let (mut part, mut waiting) = (Vec::new(), VecDeque::from([first]));
            while let Some(cell) = waiting.pop_front() {
                part.push(cell);
                for other in four_neighbours(cell, self.size) {
                    if !is_taken[other] && is_alike(cell, other) {
                        is_taken[other] = true;
                        waiting.push_back(other);
                    }
                }
            }
            parts.push(part);
        }
        parts
    }

    /// The median over some cells of each plane against the first, in logarithms.
    pub(super) fn hue(&self, cells: &[usize]) -> Vec<f32> {
        let Some((first, others)) = self.logs.split_first() else { return Vec::new() };
        let against = |plane: &Plane| {
            let mut values: Vec<f32> = cells.iter().map(|&cell| plane.values[cell] - first.values[cell]).collect();
            quantile(&mut values, 0.5).unwrap_or(0.0)
        };
        others.iter().map(against).collect()
    }

    /// Whether a cell has a hue, to a tolerance.
    pub(super) fn has_hue(&self, cell: usize, hue: &[f32], tolerance: f32) -> bool {
        let Some((first, others)) = self.logs.split_first() else { return true };
        let off = |(plane, hue): (&Plane, &f32)| (plane.values[cell] - first.values[cell] - hue).abs();
        others.iter().zip(hue).map(off).all(|off| off <= tolerance)
    }

    /// A quantile over some cells of each plane, as sRGB values 0..=1.
    pub(super) fn colour(&self, is_in: &[bool], share: f32) -> Option<[f32; 3]> {
        let of = |plane: &Plane| {
            let mut values: Vec<f32> = plane.values.iter().zip(is_in).filter(|(_, is)| **is).map(|(v, _)| *v).collect();
            quantile(&mut values, share).map(|log| encoded(log.exp()))
        };
        match &self.logs[..] {
            [red, green, blue] => Some([of(red)?, of(green)?, of(blue)?]),
            [grey, ..] => of(grey).map(|grey| [grey; 3]),
            [] => None,
        }
    }

    /// A quantile of the mean of all planes over some cells, in linear light.
    pub(super) fn luminance(&self, is_in: &[bool], share: f32) -> Option<f32> {
        let mean = |cell: usize| self.logs.iter().map(|plane| plane.values[cell]).sum::<f32>() / self.logs.len() as f32;
        let mut values: Vec<f32> = (0..is_in.len()).filter(|&cell| is_in[cell]).map(mean).collect();
        quantile(&mut values, share).map(f32::exp)
    }

    /// HSL lightness of a cell.
    pub(super) fn lightness(&self, cell: usize) -> f32 {
        let values = || self.logs.iter().map(|plane| plane.values[cell]);
        let [least, most] = [f32::min, f32::max].map(|of| values().reduce(of).unwrap_or(0.0));
        0.5 * (encoded(least.exp()) + encoded(most.exp()))
    }

    /// Planes of logarithms as linear light.
    pub(super) fn raster_of(&self, logs: &[Plane]) -> Raster {
        let light = |plane: &Plane| plane.values.iter().map(|log| log.exp()).collect::<Vec<f32>>();
        match logs {
            [red, green, blue] => Raster::new(self.size, Planes::Colour([red, green, blue].map(light))),
            _ => Raster::new(self.size, Planes::Grey(logs.first().map_or_else(Vec::new, light))),
        }
    }
}

/// Linear light as an sRGB value.
fn encoded(value: f32) -> f32 {
    0.01 * lab::colour([value; 3])[0]
}

/// The value below which a share of all lies.
fn quantile(values: &mut [f32], share: f32) -> Option<f32> {
    let last = values.len().checked_sub(1)?;
    let at = (share * last as f32).round() as usize;
    Some(*values.select_nth_unstable_by(at.min(last), f32::total_cmp).1)
}
