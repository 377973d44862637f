//! Points where the colour steps: colours as in `raster::lab`, the tensor as in `edges::gradient`, maxima as in
//! `edges::maxima`, heights as in `edges::ridge`.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use tactograph::internals::edges::{Params, ridge_points};
use tactograph::internals::raster::Raster;

/// Linear sRGB to XYZ relative to the white point D65 (IEC 61966-2-1), each row divided by the value of white.
const TO_XYZ: [[f64; 3]; 3] = [
    [0.412_390_8 / 0.950_455_9, 0.357_584_3 / 0.950_455_9, 0.180_480_8 / 0.950_455_9],
    [0.212_639, 0.715_168_7, 0.072_192_3],
    [0.019_330_8 / 1.089_057_8, 0.119_194_8 / 1.089_057_8, 0.950_532_2 / 1.089_057_8],
];
/// The widest step that is measured, in scales of the derivative.
const MAX_BLUR: f64 = 2.5;
/// A pedestal of up to this share of the maximum is ignored.
const FREE_PEDESTAL: f64 = 0.1;
/// Where logarithms and curvatures are cut off.
const TINY: f64 = 1e-6;

/// A point where the colour steps.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// Its position, px.
    pub at: [f64; 2],
    /// Unit vector across the edge.
    pub normal: [f64; 2],
    /// Height of the step.
    pub height: f64,
}

/// How far the two computations are from one another.
#[derive(Debug, Clone, Default)]
pub struct Difference {
    /// Points that both have, by the pixels of their maxima, and measure along the same axis.
    pub both: usize,
    /// Points that both have and measure along different axes: the edge runs at 45 degrees to the last digits.
    pub other_axis: usize,
    /// Points of one of them only, though clear of the threshold, whose edge is not that of any point of the other
    /// within 2 px: farther than 0.01 px across it. Of equal neighbours either may be the maximum.
    pub single: usize,
    /// Distances across the edge, px, sorted.
    pub px: Vec<f64>,
    /// Differences of height, in units of strength, sorted.
    pub height: Vec<f64>,
    /// The same as a share of the height, sorted.
    pub share: Vec<f64>,
}

/// The value that a share of sorted values does not exceed; 0 of none.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f64).ceil() as usize).copied().unwrap_or(0.0)
}

/// All points of a picture, by column and row of their pixels.
pub fn points(raster: &Raster, params: &Params) -> BTreeMap<[u32; 2], Point> {
    let size = [raster.size().width as usize, raster.size().height as usize];
    let [width, height] = size;
    let sigma = f64::from(params.sigma);
    let planes = colours(raster);
    let tensor = tensor(&planes, size, sigma);
    let length = |x: usize, y: usize| {
        let [xx, xy, yy] = tensor[y * width + x];
        let (half, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        (half + difference.hypot(xy)).sqrt()
    };
    let lengths: Vec<f64> = (0..width * height).map(|i| length(i % width, i / width)).collect();
    let reach = (3.0 * params.sigma).round() as isize;
    let least = 0.5 * f64::from(params.low);
    let mut points = BTreeMap::new();
    for (x, y) in (1..height.max(1) - 1).flat_map(|y| (1..width.max(1) - 1).map(move |x| (x, y))) {
        let [xx, xy, yy] = tensor[y * width + x];
        let upright = xx >= yy;
        let across = |distance: isize| {
            let (x, y) =
                if upright { (x as isize + distance, y as isize) } else { (x as isize, y as isize + distance) };
            let inside = (0..width as isize).contains(&x) && (0..height as isize).contains(&y);
            inside.then(|| lengths[y as usize * width + x as usize])
        };
        let (Some(before), here, Some(after)) = (across(-1), lengths[y * width + x], across(1)) else { continue };
        if !(here > before && here >= after) {
            continue;
        }
        let (left, right) = ((before / here).max(TINY).ln(), (after / here).max(TINY).ln());
        let curvature = left + right;
        if curvature > -TINY {
            continue;
        }
        let slope = 0.5 * (right - left);
        let offset = (-slope / curvature).clamp(-0.5, 0.5);
        let maximum = here * (0.5 * slope * offset).exp();
        let normal = eigenvector([xx, xy, yy]);
        let along_axis = if upright { normal[0].abs() } else { normal[1].abs() };
        let curvature = -curvature / (along_axis * along_axis);
        let beyond = match [across(-reach), across(reach)] {
            [Some(a), Some(b)] => [a, b],
            [a, b] => [a.or(b).unwrap_or(0.0); 2],
        };
        let step = step(maximum, curvature, beyond.map(|gradient| gradient / here), reach as f64 * along_axis, sigma);
        let (at_x, at_y) = (x as f64 + 0.5, y as f64 + 0.5);
        let at = if upright { [at_x + offset, at_y] } else { [at_x, at_y + offset] };
        if step >= least {
            points.insert([x as u32, y as u32], Point { at, normal, height: step });
        }
    }
    points
}

/// L, 2a and 2b of every pixel, plane by plane; of a grey picture L only.
fn colours(raster: &Raster) -> Vec<Vec<f64>> {
    let lightness = |y: f64| if y > 0.003_130_8 { 105.5 * y.powf(1.0 / 2.4) - 5.5 } else { 1292.0 * y };
    let f = |t: f64| {
        let delta: f64 = 6.0 / 29.0;
        if t > delta.powi(3) { t.cbrt() } else { t / (3.0 * delta * delta) + 4.0 / 29.0 }
    };
    match raster.planes().as_slice() {
        [red, green, blue] => {
            let mut planes = vec![Vec::new(); 3];
            for ((r, g), b) in red.iter().zip(green).zip(blue) {
                let rgb = [*r, *g, *b].map(f64::from);
                let [x, y, z] = TO_XYZ.map(|row| row.iter().zip(rgb).map(|(k, value)| k * value).sum::<f64>());
                let lab = [lightness(y), 1000.0 * (f(x) - f(y)), 400.0 * (f(y) - f(z))];
                planes.iter_mut().zip(lab).for_each(|(plane, value)| plane.push(value));
            }
            planes
        }
        grey => grey.iter().map(|plane| plane.iter().map(|value| lightness(f64::from(*value))).collect()).collect(),
    }
}

/// The colour structure tensor of every pixel (Di Zenzo 1986), from Gaussian derivatives; beyond the border the nearest
/// pixel counts.
fn tensor(planes: &[Vec<f64>], [width, height]: [usize; 2], sigma: f64) -> Vec<[f64; 3]> {
    let radius = (3.0 * sigma).ceil() as isize;
    let gauss: Vec<f64> = (-radius..=radius).map(|k| (-0.5 * (k as f64 / sigma).powi(2)).exp()).collect();
    let sum: f64 = gauss.iter().sum();
    let smooth: Vec<f64> = gauss.iter().map(|weight| weight / sum).collect();
    let moment: f64 = (-radius..=radius).zip(&smooth).map(|(k, weight)| (k * k) as f64 * weight).sum();
    let slope: Vec<f64> = (-radius..=radius).zip(&smooth).map(|(k, weight)| k as f64 * weight / moment).collect();
    let near =
        |at: usize, k: usize, end: usize| (at as isize + k as isize - radius).clamp(0, end as isize - 1) as usize;
    let down = |plane: &[f64], kernel: &[f64]| -> Vec<f64> {
        let at = |i: usize| (i % width, i / width);
        let sum = |(x, y): (usize, usize)| {
            kernel.iter().enumerate().map(|(k, weight)| weight * plane[near(y, k, height) * width + x]).sum()
        };
        (0..width * height).map(|i| sum(at(i))).collect()
    };
    let along = |plane: &[f64], kernel: &[f64]| -> Vec<f64> {
        let sum = |x: usize, y: usize| {
            kernel.iter().enumerate().map(|(k, weight)| weight * plane[y * width + near(x, k, width)]).sum()
        };
        (0..width * height).map(|i| sum(i % width, i / width)).collect()
    };
    let mut tensor = vec![[0.0; 3]; width * height];
    for plane in planes {
        let (gx, gy) = (along(&down(plane, &smooth), &slope), along(&down(plane, &slope), &smooth));
        for ((to, x), y) in tensor.iter_mut().zip(gx).zip(gy) {
            *to = [to[0] + x * x, to[1] + x * y, to[2] + y * y];
        }
    }
    tensor
}

/// Unit vector of the direction in which the colour changes most.
fn eigenvector([xx, xy, yy]: [f64; 3]) -> [f64; 2] {
    let difference = 0.5 * (xx - yy);
    let root = difference.hypot(xy);
    let [x, y] = if difference >= 0.0 { [difference + root, xy] } else { [xy, root - difference] };
    let length = x.hypot(y);
    if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
}

/// The height of a step from the gradient across it.
fn step(maximum: f64, curvature: f64, pedestal: [f64; 2], distance: f64, sigma: f64) -> f64 {
    let wide = curvature.max(TINY).sqrt().recip();
    let no_shading = (3.0 - 2.0 * wide / (MAX_BLUR * sigma)).clamp(0.0, 1.0);
    let blur = wide.clamp(sigma, MAX_BLUR * sigma);
    let lower = pedestal[0].min(pedestal[1]);
    let above = if lower <= FREE_PEDESTAL {
        1.0
    } else {
        let own = (-0.5 * (distance / blur).powi(2)).exp();
        let pedestal = ((lower - own) / (1.0 - own)).clamp(0.0, 1.0);
        ((1.0 - pedestal) / (1.0 - FREE_PEDESTAL)).min(1.0)
    };
    TAU.sqrt() * blur * maximum * no_shading * above
}

/// Holds the program's points against these.
pub fn compare(raster: &Raster, params: &Params) -> Difference {
    let exact = points(raster, params);
    let fast: BTreeMap<[u32; 2], ([f64; 2], f64)> = ridge_points(raster, params)
        .into_iter()
        .map(|(pixel, at, height)| (pixel, ([at.x, at.y].map(f64::from), f64::from(height))))
        .collect();
    let mut found = Difference::default();
    let least = 0.5 * f64::from(params.low);
    // nearer to the threshold than this, either may drop a point
    let clear = |height: f64| height > 1.01 * least;
    let around = |pixel: [u32; 2]| {
        let by = (-2..=2).flat_map(|y: i32| (-2..=2).map(move |x: i32| [x, y]));
        by.map(move |by| [0, 1].map(|i| pixel[i].wrapping_add_signed(by[i])))
    };
    let across = |point: &Point, at: [f64; 2]| {
        ((at[0] - point.at[0]) * point.normal[0] + (at[1] - point.at[1]) * point.normal[1]).abs()
    };
    for (pixel, point) in &exact {
        match fast.get(pixel) {
            Some((at, height)) => {
                // along the axis on which a point was not sought it stands in the middle of its pixel
                let axis = |at: [f64; 2]| at.map(|place| (place - place.floor() - 0.5).abs() < 1e-9);
                let [one, other] = [axis(point.at), axis(*at)];
                if one != other && one != [true; 2] && other != [true; 2] {
                    found.other_axis += 1;
                    continue;
                }
                found.both += 1;
                found.px.push(across(point, *at));
                let error = (height - point.height).abs();
                found.height.push(error);
                found.share.push(error / point.height);
            }
            None => {
                let is_there =
                    around(*pixel).filter_map(|pixel| fast.get(&pixel)).any(|(at, _)| across(point, *at) <= 0.01);
                found.single += usize::from(clear(point.height) && !is_there);
            }
        }
    }
    for (pixel, (at, height)) in &fast {
        if !exact.contains_key(pixel) && clear(*height) {
            let is_there = around(*pixel).filter_map(|pixel| exact.get(&pixel)).any(|point| across(point, *at) <= 0.01);
            found.single += usize::from(!is_there);
        }
    }
    for values in [&mut found.px, &mut found.height, &mut found.share] {
        values.sort_by(f64::total_cmp);
    }
    found
}
