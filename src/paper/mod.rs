//! The paper under a drawing that was scanned or photographed: what it would be without the drawing is found and
//! divided out, so that paper is white wherever it lies, in a shadow too, and ink keeps its colour.
//!
//! ```text
//! Raster -> cells (means, what is flat) -> parts (flat, without steps) -> one of them is paper
//!   -> surface (of its light, across all else) <-> more paper (what is as light as the surface) -> Paper -> divided
//! ```
//!
//! Correction of the background, as document imaging has it, takes for paper whatever is brightest around each
//! place: by a closing, or by a mode of each tile, or by a polynomial that darker pixels hardly pull. There a bar or a
//! map that is wider than the tool becomes paper itself. Here paper is what is connected: light falls off and shadows
//! of hands have soft edges, a tint that somebody printed has a step. What is found so is interpolated below the rest.
//! On scans of maps, charts and worksheets (the program `scans`, one of each kind and variant, a first version of each
//! way):
//!
//! | | blank paper with a texture | areas of the right class |
//! |---|---|---|
//! | as it is | 0.575 | 0.845 |
//! | closing, a sixth and a third of the width | 0.001, 0.013 | 0.432, 0.636 |
//! | tiles, 12 and 6 across | 0.002, 0.015 | 0.524, 0.780 |
//! | robust polynomial, of order 2 and 3 | 0.165, 0.096 | 0.770, 0.731 |
//! | this, on no slope, a plane and a quadratic surface | 0.035, 0.027, 0.014 | 0.947, 0.949, 0.965 |
//!
//! **What is no paper.** No ink is lighter than its paper: what has something lighter beside it, in any channel, is an
//! area (the sea of a map, the ground of a poster with white on it). Paper is light and hardly coloured, and alike in
//! hue all over. A drawing without noise came from no scanner: its ground is as its maker painted it, unless light
//! seems to fall off across it.

mod cells;
mod surface;

use cells::Cells;

use crate::raster::Raster;
use crate::raster::plane::Plane;
use crate::units::Size;

/// What is known of the picture before paper is looked for.
#[derive(Debug, Clone, Copy)]
pub struct Capture {
    /// Standard deviation of the noise of a pixel in lightness, 0..=100.
    pub noise: f32,
    /// Whether it was compressed with loss.
    pub lossy: bool,
}

/// The paper under a drawing.
#[derive(Debug, Clone)]
pub struct Paper {
    /// Its linear light on a grid of cells, across all of the picture.
    light: Raster,
    /// Its colour where it is lightest, as sRGB.
    pub colour: [u8; 3],
    /// The light of its darkest part, as a share of that of its lightest.
    pub darkest: f32,
}

/// Up to this noise, of 100, a picture was made by a program: a scanner has more even after shrinking, in a picture
/// without loss.
const PAINTED: f32 = 0.05;
/// Light that falls by less than this is even, as a share of linear light.
const EVEN: f32 = 0.07;
/// Paper as light as this everywhere, in HSL lightness of its cells, is blank already (`colours.white_from` is 0.92).
const WHITE: f32 = 0.935;
/// Greatest share of the cells of blank paper that are darker.
const NOT_WHITE: f32 = 0.02;
/// Least share of the picture that one part of the paper has. Maps with a narrow margin have a tenth.
const LEAST_SHARE: f32 = 0.06;
/// So many of the largest parts are looked at: a map may have several that are larger than its margin.
const MOST_PARTS: usize = 6;
/// Most saturation (HSV) of paper and light together. Cream paper in the light of a lamp has 0.23, light yellow ink on
/// white paper 0.31; what is lighter, as a pale blue sea, is told from paper by what is lighter still.
const MOST_SATURATION: f32 = 0.28;
/// Least sRGB value of paper where it is lightest. Grey recycled paper has 0.8.
const LEAST_VALUE: f32 = 0.5;
/// Most that the ratio of two channels differs from its median on the paper, in logarithms: two lights differ by it.
const SAME_HUE: f32 = 0.12;
/// Most that paper that lies apart, as within a ring, differs from the light around it, in logarithms of linear light.
/// An ink as light as this is white on the page in any case.
const SAME_LIGHT: f32 = 0.10;
/// Rounds in which paper that lies apart is found: one beside the other, or ring in ring.
const ROUNDS: usize = 4;
/// What is lighter than paper by this, in logarithms of linear light, is no ink on it.
const LIGHTER: f32 = 0.15;
/// This share of the picture that is so much lighter shows that the paper was none: a spot of glare is smaller.
const LIGHTER_SHARE: f32 = 0.02;

impl Paper {
    /// The paper of a drawing; none where there is none to be seen, and none that is white and evenly lit.
    pub fn of(raster: &Raster, capture: Capture) -> Option<Self> {
        if capture.noise <= PAINTED && !capture.lossy {
            return None;
        }
        let cells = Cells::of(raster, capture.noise)?;
        let least = LEAST_SHARE * cells.size.area() as f32;
        let mut parts = cells.parts();
        parts.retain(|part| part.len() as f32 >= least);
        // those that begin first stay first among equals
        parts.sort_by_key(|part| std::cmp::Reverse(part.len()));
        parts.truncate(MOST_PARTS);
        // where most is clean, nothing is to be found
        let white: usize = parts.iter().filter(|part| is_white(&cells, part)).map(Vec::len).sum();
        if 2 * white > parts.iter().map(Vec::len).sum() {
            return None;
        }
        let paper = parts.iter().find_map(|part| Self::with(&cells, part))?;
        let is_painted = capture.noise <= PAINTED && paper.darkest >= 1.0 - EVEN;
        (!is_painted).then_some(paper)
    }

    /// The paper to which a part of the cells belongs, if that can be paper.
    fn with(cells: &Cells, part: &[usize]) -> Option<Self> {
        let hue = cells.hue(part);
        let is_near: Vec<bool> = (0..cells.size.len()).map(|cell| cells.has_hue(cell, &hue, SAME_HUE)).collect();
        let mut is_paper = vec![false; cells.size.len()];
        part.iter().filter(|&&cell| is_near[cell]).for_each(|&cell| is_paper[cell] = true);
        let lightest = cells.colour(&is_paper, 0.95)?;
        let [least, most] = [f32::min, f32::max].map(|of| lightest.into_iter().reduce(of).unwrap_or(0.0));
        if most < LEAST_VALUE || least < (1.0 - MOST_SATURATION) * most {
            return None;
        }
        let mut surface = surface::through(cells, &is_paper);
        for _ in 0..ROUNDS {
            let is_like = |cell: usize| {
                let off = |(plane, surface): (&Plane, &Plane)| (plane.values[cell] - surface.values[cell]).abs();
                cells.flat[cell]
                    && is_near[cell]
                    && cells.logs.iter().zip(&surface).map(off).all(|off| off <= SAME_LIGHT)
            };
            let more: Vec<usize> = (0..is_paper.len()).filter(|&cell| !is_paper[cell] && is_like(cell)).collect();
            if more.is_empty() {
                break;
            }
            more.into_iter().for_each(|cell| is_paper[cell] = true);
            surface = surface::through(cells, &is_paper);
        }
        let is_lighter = |cell: usize| {
            let by = |(plane, surface): (&Plane, &Plane)| plane.values[cell] - surface.values[cell];
            cells.flat[cell] && cells.logs.iter().zip(&surface).map(by).any(|by| by > LIGHTER)
        };
        let lighter = (0..is_paper.len()).filter(|&cell| is_lighter(cell)).count();
        if lighter as f32 > LIGHTER_SHARE * cells.size.area() as f32 {
            return None;
        }
        let all: Vec<usize> = (0..is_paper.len()).filter(|&cell| is_paper[cell]).collect();
        if is_white(cells, &all) {
            return None;
        }
        let dark = cells.luminance(&is_paper, 0.02)?;
        let light = cells.luminance(&is_paper, 0.98)?;
        let colour = lightest.map(|value| (255.0 * value).round() as u8);
        Some(Self { light: cells.raster_of(&surface), colour, darkest: dark / light })
    }

    /// The picture as it would be on white paper in even light. It may be finer than the one that the paper was found
    /// in.
    pub fn divided(&self, raster: &Raster) -> Raster {
        let size = raster.size();
        let mut planes = raster.planes().clone();
        for (plane, light) in planes.as_mut_slice().iter_mut().zip(self.light.planes().iter()) {
            divide(plane, size, light, self.light.size());
        }
        Raster::new(size, planes)
    }
}

/// Whether a part of the paper is white in even light.
fn is_white(cells: &Cells, part: &[usize]) -> bool {
    let darker = part.iter().filter(|&&cell| cells.lightness(cell) < WHITE).count();
    darker as f32 <= NOT_WHITE * part.len() as f32
}

/// Divides a plane by light on a coarser grid, between whose points it is linear. No pixel is lighter than 1.
fn divide(plane: &mut [f32], size: Size, light: &[f32], cells: Size) {
    let (width, columns) = (size.width as usize, cells.width as usize);
    let between = |at: usize, count: u32, cells: u32| {
        let at = (at as f32 + 0.5) / count as f32 * cells as f32 - 0.5;
        let at = at.clamp(0.0, cells as f32 - 1.0);
        let first = at as usize;
        (first, (first + 1).min(cells as usize - 1), at - first as f32)
    };
    let across: Vec<(usize, usize, f32)> = (0..width).map(|x| between(x, size.width, cells.width)).collect();
    let mut row_of_light = vec![0.0; columns];
    for (y, row) in plane.chunks_exact_mut(width).enumerate() {
        let (above, below, share) = between(y, size.height, cells.height);
        let (above, below) = (&light[above * columns..][..columns], &light[below * columns..][..columns]);
        for ((light, above), below) in row_of_light.iter_mut().zip(above).zip(below) {
            *light = above * (1.0 - share) + below * share;
        }
        for (value, &(left, right, share)) in row.iter_mut().zip(&across) {
            let light = row_of_light[left] * (1.0 - share) + row_of_light[right] * share;
            *value = (*value / light).min(1.0);
        }
    }
}

#[cfg(test)]
mod tests;
