//! Outlines to paint and the same curves as truth.

use crate::scene::P;

/// Distance of points along a true curve, px.
pub(crate) const SPACING: f64 = 0.25;
/// Distance of points along an outline that is painted, px: a chord of a circle of radius 5 then strays 1e-4 px.
const CHORD: f64 = 0.06;

/// Unit vector at an angle in degrees (counted from x towards y).
pub(crate) fn direction(degrees: f64) -> P {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos, sin]
}

/// `from` moved by `by` along `along` and by `across` to its right as seen (y runs down).
pub(crate) fn moved(from: P, along: P, by: f64, across: f64) -> P {
    [from[0] + by * along[0] - across * along[1], from[1] + by * along[1] + across * along[0]]
}

/// All that lies on the positive side (`moved` with `across > 0`) of the line through `at` along `along`.
pub(crate) fn half_plane(at: P, along: P) -> Vec<P> {
    strip(at, along, FAR)
}

/// From the line through `at` along `along` to the parallel line `width` to its positive side.
pub(crate) fn strip(at: P, along: P, width: f64) -> Vec<P> {
    vec![
        moved(at, along, -FAR, 0.0),
        moved(at, along, FAR, 0.0),
        moved(at, along, FAR, width),
        moved(at, along, -FAR, width),
    ]
}

/// All between two rays from `at`.
pub(crate) fn wedge(at: P, first: P, second: P) -> Vec<P> {
    vec![at, moved(at, first, FAR, 0.0), moved(at, second, FAR, 0.0)]
}

/// Far outside every scene, px.
const FAR: f64 = 4000.0;

/// True points of the line through `at` from `from` to `to` along it, as far as they lie in the scene.
pub(crate) fn line(at: P, along: P, from: f64, to: f64, size: [usize; 2]) -> Vec<P> {
    let inside = |p: &P| (0.0..=size[0] as f64).contains(&p[0]) && (0.0..=size[1] as f64).contains(&p[1]);
    let steps = ((to - from) / SPACING).ceil();
    (0..=steps as usize).map(|i| moved(at, along, from + (to - from) * i as f64 / steps, 0.0)).filter(inside).collect()
}

/// True points of a whole line through a scene.
pub(crate) fn whole_line(at: P, along: P, size: [usize; 2]) -> Vec<P> {
    let reach = (size[0] + size[1]) as f64;
    line(at, along, -reach, reach, size)
}

/// An ellipse with half axes `a` along `along` and `b` across: the outline and the true points.
pub(crate) fn ellipse(centre: P, a: f64, b: f64, along: P) -> (Vec<P>, Vec<P>) {
    let at = |spacing: f64| {
        let n = (std::f64::consts::TAU * a.max(b) / spacing).ceil();
        let angles = (0..n as usize).map(|i| std::f64::consts::TAU * i as f64 / n);
        angles.map(|t| moved(centre, along, a * t.cos(), b * t.sin())).collect()
    };
    (at(CHORD), at(SPACING))
}

/// All on the positive side of a sine around the line through `at` along `along`; its true points within the scene.
pub(crate) fn sine(at: P, along: P, amplitude: f64, wavelength: f64, size: [usize; 2]) -> (Vec<P>, Vec<P>) {
    let reach = 0.8 * (size[0] + size[1]) as f64;
    let wave = |spacing: f64| -> Vec<P> {
        let n = (2.0 * reach / spacing) as usize;
        let places = (0..=n).map(|i| -reach + 2.0 * reach * i as f64 / n as f64);
        places.map(|t| moved(at, along, t, amplitude * (std::f64::consts::TAU * t / wavelength).sin())).collect()
    };
    let mut outline = wave(CHORD);
    outline.extend([moved(at, along, reach, FAR), moved(at, along, -reach, FAR)]);
    // along the slopes of a steep wave points lie farther apart than across it
    let inside = |p: &P| (0.0..=size[0] as f64).contains(&p[0]) && (0.0..=size[1] as f64).contains(&p[1]);
    (outline, wave(0.5 * SPACING).into_iter().filter(inside).collect())
}

/// The sides of a polygon as true points.
pub(crate) fn sides(corners: &[P]) -> Vec<P> {
    let next = corners.iter().skip(1).chain(&corners[..1]);
    let mut points = Vec::new();
    for (a, b) in corners.iter().zip(next) {
        let steps = ((b[0] - a[0]).hypot(b[1] - a[1]) / SPACING).ceil();
        points.extend((0..steps as usize).map(|i| {
            let t = i as f64 / steps;
            [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
        }));
    }
    points
}
