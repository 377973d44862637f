//! From a broad ridge of gradient to single points between the pixels.

use super::Params;
use super::gradient::TensorRow;
use crate::units::{PxPoint, Size};

/// A place where the gradient is greatest across the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ridge {
    pub(super) at: PxPoint,
    /// Unit vector across the edge; its sign has no meaning (a colour step has no up).
    pub(super) normal: [f32; 2],
    /// Height of the step.
    pub(super) step: f32,
    /// The pixel it was found at.
    pub(super) column: u32,
    /// The pixel row.
    pub(super) row: u32,
}

/// Takes tensor rows and keeps the ridge points, in reading order.
pub(super) struct Thinner {
    size: Size,
    sigma: f32,
    least_gradient: f32,
    least_step: f32,
    rows: [Option<Row>; 3],
    next: u32,
    points: Vec<Ridge>,
}

struct Row {
    tensor: TensorRow,
    gradient: Vec<f32>,
}

/// Ridges are kept down to this share of the lower threshold, so that smoothing along a chain still sees the weak points.
const BELOW_LOW: f32 = 0.5;

/// The widest edge whose height is measured, in sigmas: a step blurred more than this counts as shading and is taken for
/// lower than it is.
const WIDEST: f32 = 2.5;

impl Thinner {
    pub(super) fn new(size: Size, params: &Params) -> Self {
        let least_step = BELOW_LOW * params.low;
        // the gradient of that step when it is blurred as far as is measured
        let least_gradient = least_step / (std::f32::consts::TAU.sqrt() * params.sigma * WIDEST);
        Self {
            size,
            sigma: params.sigma,
            least_gradient,
            least_step,
            rows: [const { None }; 3],
            next: 0,
            points: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, tensor: &TensorRow) {
        let gradient = tensor.xx.iter().zip(&tensor.xy).zip(&tensor.yy).map(|((&xx, &xy), &yy)| {
            let (half, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
            (half + (difference * difference + xy * xy).sqrt()).sqrt()
        });
        self.rows.rotate_left(1);
        match &mut self.rows[2] {
            Some(row) => {
                row.gradient.clear();
                row.gradient.extend(gradient);
                row.tensor.clone_from(tensor);
            }
            empty => *empty = Some(Row { gradient: gradient.collect(), tensor: tensor.clone() }),
        }
        self.next += 1;
        if self.next >= 3 {
            self.thin_middle();
        }
    }

    pub(super) fn finish(self) -> Vec<Ridge> {
        self.points
    }

    /// Looks at the middle one of the three rows. The outermost pixels of the picture have no neighbours to compare with.
    fn thin_middle(&mut self) {
        let [Some(above), Some(middle), Some(below)] = &self.rows else { return };
        let row = self.next - 2;
        for column in 1..self.size.width.saturating_sub(1) as usize {
            let here = middle.gradient[column];
            if here < self.least_gradient {
                continue;
            }
            let (xx, xy, yy) = (middle.tensor.xx[column], middle.tensor.xy[column], middle.tensor.yy[column]);
            let upright = xx >= yy; // the edge runs up and down, compare left and right
            let (before, after) = if upright {
                (middle.gradient[column - 1], middle.gradient[column + 1])
            } else {
                (above.gradient[column], below.gradient[column])
            };
            if !(here > before && here >= after) {
                continue;
            }
            let normal = direction(xx, xy, yy);
            let along_axis = if upright { normal[0].abs() } else { normal[1].abs() };
            let Some((offset, step)) = peak(before, here, after, along_axis, self.sigma) else { continue };
            if step < self.least_step {
                continue;
            }
            let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
            let at = if upright { PxPoint::new(x + offset, y) } else { PxPoint::new(x, y + offset) };
            self.points.push(Ridge { at, normal, step, column: column as u32, row });
        }
    }
}

/// First eigenvector of the tensor: the direction across the edge.
fn direction(xx: f32, xy: f32, yy: f32) -> [f32; 2] {
    let difference = 0.5 * (xx - yy);
    let root = (difference * difference + xy * xy).sqrt();
    // Of the two ways to write the eigenvector, the one without cancellation.
    let (x, y) = if difference >= 0.0 { (difference + root, xy) } else { (xy, root - difference) };
    let length = (x * x + y * y).sqrt();
    if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
}

/// Where between the neighbours the gradient is greatest (pixels from the middle, -0.5..=0.5) and how high the step is.
///
/// Devernay (1995) lays a parabola through the three gradients. The gradient across a blurred step is a Gaussian, whose
/// logarithm *is* a parabola: so through the logarithms the place is free of bias, and the parabola's curvature tells
/// the total blur `t`, from which the height follows as `sqrt(tau) * t * peak`, however soft the edge was in the picture.
fn peak(before: f32, here: f32, after: f32, along_axis: f32, sigma: f32) -> Option<(f32, f32)> {
    const TINY: f32 = 1e-6;
    let (left, mid, right) = (before.max(TINY).ln(), here.max(TINY).ln(), after.max(TINY).ln());
    let curvature = left + right - 2.0 * mid;
    if curvature > -TINY {
        return None;
    }
    let slope = 0.5 * (right - left);
    let offset = (-slope / curvature).clamp(-0.5, 0.5);
    let top = (mid + 0.5 * slope * offset).exp();
    let blur = (along_axis / (-curvature).sqrt()).clamp(sigma, WIDEST * sigma);
    Some((offset, std::f32::consts::TAU.sqrt() * blur * top))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gaussian_profile_gives_its_own_place_and_height() {
        for shift in [-0.5_f32, -0.3, 0.0, 0.2, 0.49] {
            for blur in [1.5_f32, 2.0, 3.0] {
                let g =
                    |x: f32| 40.0 / (std::f32::consts::TAU.sqrt() * blur) * (-0.5 * ((x - shift) / blur).powi(2)).exp();
                let (offset, step) = peak(g(-1.0), g(0.0), g(1.0), 1.0, 1.5).unwrap();
                assert!((offset - shift).abs() < 1e-3, "{offset} is not {shift}");
                assert!((step - 40.0).abs() < 0.1, "{step} at blur {blur}");
            }
        }
    }

    #[test]
    fn the_direction_is_across_the_edge() {
        for degrees in 0..180 {
            let (y, x) = (degrees as f32).to_radians().sin_cos();
            let [nx, ny] = direction(9.0 * x * x, 9.0 * x * y, 9.0 * y * y);
            assert!((nx * x + ny * y).abs() > 0.9999, "{degrees} degrees: {nx} {ny}");
        }
    }
}
