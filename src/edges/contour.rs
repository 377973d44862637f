//! Contours while they are refined, and lines fitted to parts of them.

use crate::geom::polyline::{Blend, Located, Polyline};
use crate::geom::{first_eigenvector, line_crossing, mix};
use crate::units::{Px, PxPoint, PxVector};

/// A point of a contour with the properties of its edge there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContourPoint {
    pub(super) at: PxPoint,
    /// Height of the step, reduced where there is texture (see [`super::Edgel`]).
    pub(super) strength: f32,
    /// Colour on the right minus colour on the left.
    pub(super) contrast: [f32; 3],
    /// Blur of the step including the scale of the derivative, px.
    pub(super) blur: f32,
    /// Position error: standard deviation of the position across the edge that the noise of the picture causes, px.
    pub(super) position_sigma: f32,
}

/// A contour that is being refined.
pub(super) type Contour = Polyline<ContourPoint>;

/// A straight line fitted to points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LineFit {
    /// The mean of the points.
    pub(super) centre: PxPoint,
    /// Unit direction, from the first point towards the last.
    pub(super) direction: PxVector,
    /// Root mean square distance of the points from the line, px.
    pub(super) rms: f32,
}

/// Lines whose angle has a smaller sine (3 degrees) are nearly parallel.
const PARALLEL: f32 = 0.05;

/// Where two lines cross, each given by a point and its direction, as signed distances from those points; none if they
/// are nearly parallel.
pub(super) fn crossing(a: (PxPoint, PxVector), b: (PxPoint, PxVector)) -> Option<(f32, f32)> {
    line_crossing(a, b, PARALLEL)
}

impl Located for ContourPoint {
    type Unit = Px;

    fn at(&self) -> PxPoint {
        self.at
    }
}

impl Blend for ContourPoint {
    fn between(&self, other: &Self, share: f32) -> Self {
        Self {
            at: self.at.lerp(other.at, share),
            strength: mix(self.strength, other.strength, share),
            contrast: std::array::from_fn(|i| mix(self.contrast[i], other.contrast[i], share)),
            blur: mix(self.blur, other.blur, share),
            position_sigma: mix(self.position_sigma, other.position_sigma, share),
        }
    }

    fn reversed(self) -> Self {
        Self { contrast: self.contrast.map(|v| -v), ..self }
    }
}

impl Contour {
    /// The index of the point `steps` after point `i`, or before it if negative; none beyond the ends of an open
    /// contour.
    pub(super) fn next(&self, i: usize, steps: isize) -> Option<usize> {
        self.view().next(i, steps)
    }

    /// Leads the end straight on to a place, with a point every pixel that is like the last one.
    pub(super) fn lead_to(&mut self, place: PxPoint) {
        if let Some(&last) = self.vertices.last() {
            let steps = (place - last.at).length().ceil().max(1.0) as usize;
            let at = |k: usize| ContourPoint { at: last.at.lerp(place, k as f32 / steps as f32), ..last };
            self.vertices.extend((1..=steps).map(at));
        }
    }

    /// The line through the points at arc lengths between `from` and `to` from point `i`, directed away from it; none
    /// if they are fewer than three.
    pub(super) fn line_fit(&self, i: usize, forwards: bool, from: f32, to: f32) -> Option<LineFit> {
        let points = self.walk(i, forwards).skip_while(|(_, arc)| *arc < from).take_while(|(_, arc)| *arc <= to);
        LineFit::through(points.map(|(index, _)| self.vertices[index].at))
    }
}

impl LineFit {
    /// The line through points with the least sum of squared distances; none through fewer than three points.
    pub(super) fn through(points: impl Iterator<Item = PxPoint>) -> Option<Self> {
        let (mut n, mut sum) = (0.0, PxVector::zero());
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        let mut ends = None;
        for point in points {
            let (first, _) = *ends.get_or_insert((point, point));
            ends = Some((first, point));
            let v = point - first; // small numbers lose fewer digits
            n += 1.0;
            sum += v;
            (xx, xy, yy) = (xx + v.x * v.x, xy + v.x * v.y, yy + v.y * v.y);
        }
        let (first, last) = ends?;
        if n < 3.0 {
            return None;
        }
        let mean = sum / n;
        let (xx, xy, yy) = (xx / n - mean.x * mean.x, xy / n - mean.x * mean.y, yy / n - mean.y * mean.y);
        let direction: PxVector = first_eigenvector(xx, xy, yy)?;
        let direction = if direction.dot(last - first) < 0.0 { -direction } else { direction };
        // the second eigenvalue is the mean squared distance from the line
        let (half, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let square = half - (difference * difference + xy * xy).sqrt();
        Some(Self { centre: first + mean, direction, rms: square.max(0.0).sqrt() })
    }

    /// Where two lines cross, as signed distances from the centre of each along it; none if they are nearly parallel.
    pub(super) fn crossing(&self, other: &Self) -> Option<(f32, f32)> {
        crossing((self.centre, self.direction), (other.centre, other.direction))
    }

    /// The point at a signed distance from the centre along the line.
    pub(super) fn point_at(&self, distance: f32) -> PxPoint {
        self.centre + self.direction * distance
    }

    /// The point of the line nearest to `point`.
    pub(super) fn nearest(&self, point: PxPoint) -> PxPoint {
        self.point_at(self.direction.dot(point - self.centre))
    }
}

/// Contours for tests.
#[cfg(test)]
pub(super) mod testing {
    use super::*;

    /// A point of strength 20 and blur 1.5 px with light on its right.
    pub(in crate::edges) fn point(x: f32, y: f32) -> ContourPoint {
        let contrast = [20.0, 0.0, 0.0];
        ContourPoint { at: PxPoint::new(x, y), strength: 20.0, contrast, blur: 1.5, position_sigma: 0.02 }
    }

    /// An open contour of points a pixel apart along the straight pieces between corners.
    pub(in crate::edges) fn polyline(corners: &[(f32, f32)]) -> Contour {
        let corner = |&(x, y): &(f32, f32)| point(x, y);
        let mut vertices: Vec<ContourPoint> = corners.first().map(corner).into_iter().collect();
        for pair in corners.windows(2) {
            let (a, b) = (corner(&pair[0]), corner(&pair[1]));
            let steps = (b.at - a.at).length().round() as usize;
            vertices.extend((1..=steps).map(|k| a.between(&b, k as f32 / steps as f32)));
        }
        Contour::open(vertices)
    }

    /// A closed contour of points about a pixel apart on a circle around (50, 50).
    pub(in crate::edges) fn circle(radius: f32) -> Contour {
        let n = (std::f32::consts::TAU * radius).round() as usize;
        let angle = |k: usize| k as f32 * std::f32::consts::TAU / n as f32;
        let on = |k: usize| point(50.0 + radius * angle(k).cos(), 50.0 + radius * angle(k).sin());
        Contour { vertices: (0..n).map(on).collect(), closed: true }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_fit_has_the_direction_of_its_points_and_their_distance() {
        let points = [(0.0, 0.1), (1.0, -0.1), (2.0, -0.1), (3.0, 0.1)].map(|(x, y)| PxPoint::new(x, y));
        let line = LineFit::through(points.into_iter().rev()).expect("four points");
        assert!((line.direction - PxVector::new(-1.0, 0.0)).length() < 1e-5, "{line:?}");
        assert!((line.centre - PxPoint::new(1.5, 0.0)).length() < 1e-5 && (line.rms - 0.1).abs() < 1e-3, "{line:?}");
        assert_eq!(LineFit::through(points[..2].iter().copied()), None);
    }
}
