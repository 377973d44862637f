//! From outlines to a camera's file: exact area coverage, the blur of a lens, noise, whole code values.
//!
//! Outlines are painted on a grid of [`FINE`] x [`FINE`] cells per pixel, each cell by the exact share of its area that the
//! outline covers. A lens of Gaussian blur and square pixels then weigh the cells; the weights are integrals of the
//! continuous blur over each cell, so no edge is moved by sampling. Everything is in code values 0..=255.

use crate::scene::{Fill, P, Scene};
use tactograph_tools::rng::Rng;

/// Cells along the side of a pixel. With 4, the value of a pixel on a step of 100 differs from the exact integral by less
/// than half a code value (tested), evenly on both sides of the edge, so that the edge stays in place.
const FINE: usize = 4;

/// A scene through the lens, not yet noisy or rounded: one plane for grey, three for red, green and blue.
#[derive(Debug, Clone)]
pub(crate) struct Clean {
    pub(crate) size: [usize; 2],
    pub(crate) planes: Vec<Vec<f32>>,
}

/// What the camera writes: red, green and blue bytes, pixel after pixel, rows from the top.
#[derive(Debug, Clone)]
pub(crate) struct Picture {
    pub(crate) size: [usize; 2],
    pub(crate) rgb: Vec<u8>,
}

/// Paints a scene and looks at it through a lens whose point spread is a Gaussian of `psf` pixels.
pub(crate) fn render(scene: &Scene, psf: f64) -> Clean {
    let lens = Lens::new(psf);
    let fine = scene.size.map(|n| (n + 2 * lens.margin) * FINE);
    let to_fine = |p: P| p.map(|v| (v + lens.margin as f64) * FINE as f64);
    let from_fine = |cell: usize| (cell as f64 + 0.5) / FINE as f64 - lens.margin as f64;
    let channels = if scene.colour { 3 } else { 1 };
    let mut planes = vec![vec![0.0f32; fine[0] * fine[1]]; channels];

    let colour_at = |fill: &Fill, at: usize| match fill {
        Fill::Flat(colour) => *colour,
        Fill::Varying(colour) => colour([from_fine(at % fine[0]), from_fine(at / fine[0])]),
    };
    for at in 0..fine[0] * fine[1] {
        planes.iter_mut().zip(colour_at(&scene.paper, at)).for_each(|(plane, value)| plane[at] = value as f32);
    }
    for layer in &scene.layers {
        let outline: Vec<P> = layer.outline.iter().map(|&p| to_fine(p)).collect();
        each_covered_cell(&outline, fine, |at, share| {
            let paper = colour_at(&scene.paper, at);
            for ((plane, value), paper) in planes.iter_mut().zip(colour_at(&layer.fill, at)).zip(paper) {
                let below = if scene.side_by_side { paper as f32 } else { plane[at] };
                plane[at] += share * (value as f32 - below);
            }
        });
    }
    Clean { size: scene.size, planes: planes.iter().map(|plane| lens.apply(plane, fine, scene.size)).collect() }
}

impl Clean {
    /// Adds Gaussian noise of `noise` code values and rounds. Grey pictures get the same noise in all three channels, as of
    /// a grey camera, unless `per_channel`; colours get their own in each.
    pub(crate) fn shot(&self, noise: f64, per_channel: bool, seed: u64) -> Picture {
        let mut rng = Rng::new(seed);
        let mut rgb = Vec::with_capacity(3 * self.planes[0].len());
        for at in 0..self.planes[0].len() {
            let common = if self.planes.len() == 1 && !per_channel { Some(noise * rng.normal()) } else { None };
            for channel in 0..3 {
                let value = f64::from(self.planes[channel % self.planes.len()][at]);
                let noise = common.unwrap_or_else(|| noise * rng.normal());
                rgb.push((value + noise).round().clamp(0.0, 255.0) as u8);
            }
        }
        Picture { size: self.size, rgb }
    }
}

/// Calls `paint` with each cell that the outline covers and the share of its area.
///
/// Each side of the outline adds, to every cell of its row from itself to the right, the area between them; sides
/// going up add it, sides going down take it away.
fn each_covered_cell(outline: &[P], size: [usize; 2], mut paint: impl FnMut(usize, f32)) {
    let [width, height] = size;
    let rows = outline.iter().fold([f64::MAX, f64::MIN], |[low, high], p| [low.min(p[1]), high.max(p[1])]);
    let top = rows[0].clamp(0.0, height as f64).floor() as usize;
    let bottom = rows[1].clamp(0.0, height as f64).ceil() as usize;
    if top >= bottom {
        return;
    }
    let mut areas = vec![0.0f64; (bottom - top) * (width + 1)];
    let next = outline.iter().skip(1).chain(&outline[..1]);
    for (&a, &b) in outline.iter().zip(next) {
        let (upper, lower, sign) = if a[1] <= b[1] { (a, b, 1.0) } else { (b, a, -1.0) };
        if upper[1] >= lower[1] {
            continue; // level: no area to its right
        }
        let slope = (lower[0] - upper[0]) / (lower[1] - upper[1]);
        let (first, last) = (upper[1].max(top as f64), lower[1].min(bottom as f64));
        for y in first.floor() as usize..(last.ceil().max(0.0) as usize) {
            let (from, to) = (first.max(y as f64), last.min((y + 1) as f64));
            let xs = [from, to].map(|y| (upper[0] + slope * (y - upper[1])).clamp(0.0, width as f64));
            let row = &mut areas[(y - top) * (width + 1)..][..width + 1];
            add_side(row, xs[0].min(xs[1]), xs[0].max(xs[1]), sign * (to - from));
        }
    }
    for (y, row) in (top..bottom).zip(areas.chunks_exact(width + 1)) {
        let mut sum = 0.0;
        for (x, area) in row[..width].iter().enumerate() {
            sum += area;
            let share = sum.abs().min(1.0);
            if share > 1e-9 {
                paint(y * width + x, share as f32);
            }
        }
    }
}

/// A side that crosses `height` of a row while it goes from `left` to `right`.
fn add_side(row: &mut [f64], left: f64, right: f64, height: f64) {
    let last = row.len() - 1;
    for x in left as usize..=(right as usize).min(last) {
        let (from, to) = (left.max(x as f64), right.min((x + 1) as f64));
        let part = if right > left { height * (to - from) / (right - left) } else { height };
        if x == last {
            continue; // at the right border: nothing lies beyond
        }
        let inside = part * ((x + 1) as f64 - 0.5 * (from + to));
        row[x] += inside;
        row[x + 1] += part - inside;
    }
}

/// Weights of the cells around a pixel.
struct Lens {
    /// Pixels beyond the picture that its border still sees.
    margin: usize,
    weights: Vec<f32>,
}

impl Lens {
    fn new(psf: f64) -> Self {
        let margin = (4.0 * psf + 0.5).ceil() as usize;
        let cells = (2 * margin + 1) * FINE;
        // A pixel sees a point at distance x with the Gaussian's integral over the pixel; its integral over a cell by
        // Simpson's rule on four parts, far more exact than a code value.
        let seen = |x: f64| 0.5 * (erf((x + 0.5) / psf / 2f64.sqrt()) - erf((x - 0.5) / psf / 2f64.sqrt()));
        let step = 1.0 / FINE as f64;
        let weights: Vec<f64> = (0..cells)
            .map(|cell| {
                let left = cell as f64 * step - margin as f64 - 0.5;
                let at = |part: f64| seen(left + part * step);
                step / 12.0 * (at(0.0) + 4.0 * at(0.25) + 2.0 * at(0.5) + 4.0 * at(0.75) + at(1.0))
            })
            .collect();
        let sum: f64 = weights.iter().sum();
        Self { margin, weights: weights.iter().map(|w| (w / sum) as f32).collect() }
    }

    fn apply(&self, plane: &[f32], fine: [usize; 2], size: [usize; 2]) -> Vec<f32> {
        let [width, height] = size;
        let weigh = |cells: &[f32]| cells.iter().zip(&self.weights).map(|(cell, weight)| cell * weight).sum::<f32>();
        let mut across = Vec::with_capacity(width * fine[1]);
        for row in plane.chunks_exact(fine[0]) {
            across.extend((0..width).map(|x| weigh(&row[x * FINE..][..self.weights.len()])));
        }
        let mut out = vec![0.0; width * height];
        for (y, row) in out.chunks_exact_mut(width).enumerate() {
            for (weight, from) in self.weights.iter().zip(across[y * FINE * width..].chunks_exact(width)) {
                row.iter_mut().zip(from).for_each(|(to, value)| *to += weight * value);
            }
        }
        out
    }
}

/// The error function to 1.2e-7 (Numerical Recipes' rational Chebyshev fit of erfc).
pub(crate) fn erf(x: f64) -> f64 {
    const FIT: [f64; 10] = [
        -1.265_512_23,
        1.000_023_68,
        0.374_091_96,
        0.096_784_18,
        -0.186_288_06,
        0.278_868_07,
        -1.135_203_98,
        1.488_515_87,
        -0.822_152_23,
        0.170_872_77,
    ];
    let t = 1.0 / (1.0 + 0.5 * x.abs());
    let fit = FIT.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let tail = t * (fit - x * x).exp();
    if x >= 0.0 { 1.0 - tail } else { tail - 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Family;
    use crate::shapes;

    fn sheet(size: [usize; 2]) -> Scene {
        Scene::new(String::new(), Family::Flat, size, Fill::grey(50.0))
    }

    #[test]
    fn a_covered_area_is_exact() {
        let (outline, _) = shapes::ellipse([20.3, 19.1], 11.0, 7.0, shapes::direction(33.0));
        let mut area = 0.0;
        each_covered_cell(&outline, [40, 40], |_, share| area += f64::from(share));
        let want = std::f64::consts::PI * 11.0 * 7.0;
        assert!((area - want).abs() < 1e-3 * want, "{area} is not {want}");
        // a disc's light survives the lens
        let scene = sheet([60, 60]).paint(shapes::ellipse([29.6, 30.2], 12.5, 12.5, [1.0, 0.0]).0, Fill::grey(150.0));
        let light: f64 = render(&scene, 1.0).planes[0].iter().map(|&v| f64::from(v) - 50.0).sum();
        let want = 100.0 * std::f64::consts::PI * 12.5 * 12.5;
        assert!((light - want).abs() < 1e-4 * want, "{light} is not {want}");
    }

    #[test]
    fn outlines_that_leave_the_sheet_are_cut_off_at_its_border() {
        let mut area = 0.0;
        each_covered_cell(&[[-5.0, -3.0], [4.0, -3.0], [4.0, 2.5], [-5.0, 2.5]], [10, 10], |_, s| area += s);
        assert!((area - 10.0).abs() < 1e-5);
        area = 0.0;
        each_covered_cell(&[[7.0, -9.0], [70.0, -9.0], [70.0, 90.0], [7.0, 90.0]], [10, 10], |_, s| area += s);
        assert!((area - 30.0).abs() < 1e-5);
        each_covered_cell(&[[1.0, 12.0], [5.0, 12.0], [5.0, 19.0]], [10, 10], |_, _| panic!("below the sheet"));
    }

    #[test]
    fn a_straight_step_has_the_values_of_the_exact_integral() {
        for (degrees, at) in [(0.0, [20.0, 20.13]), (90.0, [19.77, 20.0]), (27.0, [20.4, 19.9]), (135.0, [20.1, 20.2])]
        {
            for psf in [0.7, 1.0, 2.0] {
                let along = shapes::direction(degrees);
                let scene = sheet([40, 40]).paint(shapes::half_plane(at, along), Fill::grey(150.0));
                let clean = render(&scene, psf);
                for (i, &value) in clean.planes[0].iter().enumerate() {
                    let want = 50.0 + 100.0 * share(i, at, along, psf);
                    let off = (f64::from(value) - want).abs();
                    assert!(off < 0.5, "{degrees} degrees, psf {psf}, pixel {i}: {value} is not {want}");
                }
            }
        }
    }

    /// The share of a pixel beyond a line, by adding up points of a pixel under the Gaussian's integral.
    fn share(pixel: usize, at: P, along: P, psf: f64) -> f64 {
        let mut sum = 0.0;
        for i in 0..256 {
            let x = (pixel % 40) as f64 + (f64::from(i % 16) + 0.5) / 16.0;
            let y = (pixel / 40) as f64 + (f64::from(i / 16) + 0.5) / 16.0;
            let across = -(x - at[0]) * along[1] + (y - at[1]) * along[0];
            sum += 0.5 + 0.5 * erf(across / psf / 2f64.sqrt());
        }
        sum / 256.0
    }

    #[test]
    fn noise_has_the_deviation_it_is_asked_for() {
        let clean = Clean { size: [200, 200], planes: vec![vec![128.0; 40_000]] };
        for (per_channel, seed) in [(false, 1), (true, 2)] {
            let shot = clean.shot(10.0, per_channel, seed);
            let spread = shot.rgb.iter().map(|&v| (f64::from(v) - 128.0).powi(2)).sum::<f64>() / 120_000.0;
            assert!((spread.sqrt() - 10.0).abs() < 0.15, "{}", spread.sqrt());
            let alike = shot.rgb.chunks_exact(3).filter(|rgb| rgb[0] == rgb[1]).count();
            assert_eq!(alike == 40_000, !per_channel);
        }
    }
}
