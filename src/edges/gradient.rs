//! The colour structure tensor (Di Zenzo 1986) from Gaussian derivatives, row by row.
//!
//! Only as many rows as the kernel is high are in memory. Sums run over mirrored pairs from the centre outwards, so that a
//! flipped picture gives exactly the flipped tensor.

use crate::raster::plane::{filter_row, gauss, pad};
use crate::units::Size;

/// One row of the tensor `[[xx, xy], [xy, yy]]`, summed over the colour planes: gradients per pixel, squared.
#[derive(Debug, Clone, Default)]
pub(super) struct TensorRow {
    pub(super) xx: Vec<f32>,
    pub(super) xy: Vec<f32>,
    pub(super) yy: Vec<f32>,
}

/// Computes the tensor of `planes` at scale `sigma` and hands it out row after row.
pub(super) fn each_row(planes: &[Vec<f32>], size: Size, sigma: f32, mut take: impl FnMut(&TensorRow)) {
    let (width, height) = (size.width as usize, size.height as usize);
    let smooth = gauss(sigma);
    let slope = derivative(&smooth);
    let radius = smooth.len() - 1;
    // For each colour plane a ring of rows, already filtered along x: smoothed and differentiated.
    let ring_len = 2 * radius + 1;
    let mut rings =
        vec![Ring { smooth: vec![0.0; width * ring_len], slope: vec![0.0; width * ring_len] }; planes.len()];
    let mut padded = Vec::with_capacity(width + 2 * radius);
    let mut filled = 0;
    let mut tensor = TensorRow { xx: vec![0.0; width], xy: vec![0.0; width], yy: vec![0.0; width] };
    let (mut gx, mut gy) = (vec![0.0; width], vec![0.0; width]);
    for y in 0..height {
        while filled < height && filled <= y + radius {
            let slot = filled % ring_len * width;
            for (ring, plane) in rings.iter_mut().zip(planes) {
                pad(&plane[filled * width..][..width], radius, &mut padded);
                filter_row(&padded, &smooth, &mut ring.smooth[slot..][..width]);
                slope_row(&padded, &slope, &mut ring.slope[slot..][..width]);
            }
            filled += 1;
        }
        let slot = |at: isize| at.clamp(0, height as isize - 1) as usize % ring_len * width;
        tensor.xx.fill(0.0);
        tensor.xy.fill(0.0);
        tensor.yy.fill(0.0);
        for ring in &rings {
            let centre = slot(y as isize);
            gx.iter_mut().zip(&ring.slope[centre..][..width]).for_each(|(to, v)| *to = smooth[0] * v);
            gy.fill(0.0);
            for step in 1..=radius {
                let (up, down) = (slot(y as isize - step as isize), slot(y as isize + step as isize));
                let (above, below) = (&ring.slope[up..][..width], &ring.slope[down..][..width]);
                let k = smooth[step];
                gx.iter_mut().zip(above).zip(below).for_each(|((to, a), b)| *to += k * (a + b));
                let (above, below) = (&ring.smooth[up..][..width], &ring.smooth[down..][..width]);
                let k = slope[step];
                gy.iter_mut().zip(above).zip(below).for_each(|((to, a), b)| *to += k * (b - a));
            }
            let sums = tensor.xx.iter_mut().zip(&mut tensor.xy).zip(&mut tensor.yy);
            for (((xx, xy), yy), (gx, gy)) in sums.zip(gx.iter().zip(&gy)) {
                *xx += gx * gx;
                *xy += gx * gy;
                *yy += gy * gy;
            }
        }
        take(&tensor);
    }
}

#[derive(Clone)]
struct Ring {
    smooth: Vec<f32>,
    slope: Vec<f32>,
}

/// Half of the odd kernel that belongs to half of a Gaussian, scaled so that a ramp of 1 per pixel gives 1.
fn derivative(smooth: &[f32]) -> Vec<f32> {
    let moment: f32 = smooth.iter().enumerate().map(|(i, k)| 2.0 * (i * i) as f32 * k).sum();
    smooth.iter().enumerate().map(|(i, k)| i as f32 * k / moment).collect()
}

fn slope_row(padded: &[f32], kernel: &[f32], to: &mut [f32]) {
    let radius = kernel.len() - 1;
    let n = to.len();
    to.fill(0.0);
    for (step, k) in kernel.iter().enumerate().skip(1) {
        let (left, right) = (&padded[radius - step..][..n], &padded[radius + step..][..n]);
        to.iter_mut().zip(left).zip(right).for_each(|((to, a), b)| *to += k * (b - a));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_has_its_own_slope_everywhere_inside() {
        let size = Size::new(40, 30);
        let plane: Vec<f32> = (0..30).flat_map(|y| (0..40).map(move |x| 3.0 * x as f32 - 2.0 * y as f32)).collect();
        let mut rows = 0;
        each_row(&[plane], size, 1.5, |tensor| {
            if (6..24).contains(&rows) {
                for x in 6..34 {
                    assert!((tensor.xx[x] - 9.0).abs() < 1e-2);
                    assert!((tensor.xy[x] + 6.0).abs() < 1e-2);
                    assert!((tensor.yy[x] - 4.0).abs() < 1e-2);
                }
            }
            rows += 1;
        });
        assert_eq!(rows, 30);
    }
}
