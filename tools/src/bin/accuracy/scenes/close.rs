//! Contours that meet or lie near one another.

use super::{STEPS, greys, middle, start};
use crate::scene::{Family, Fill, Junction, Scene};
use crate::shapes::{direction, half_plane, line, moved, strip, wedge, whole_line};

/// One area behind which the border of two others ends, at any angle from 45 to 90 degrees.
pub(super) fn t_junction(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Junction, number);
    let size = [140, 140];
    let at = middle(&mut rng, size);
    let turn = rng.between(0.0, 360.0);
    let (along, stem) = (direction(turn), direction(turn - rng.between(45.0, 135.0)));
    // the front against both others, and these against each other, by at least 40
    let [front, left, right] =
        [[60.0, 120.0, 200.0], [200.0, 60.0, 110.0], [120.0, 40.0, 200.0], [90.0, 180.0, 230.0]][number % 4];
    let back = [-along[0], -along[1]];
    let mut scene = Scene::new(format!("{name}-t"), Family::Junction, size, Fill::grey(left))
        .paint(half_plane(at, stem), Fill::grey(right)) // goes on under the front
        .paint(half_plane(at, along), Fill::grey(front))
        .contour(whole_line(at, along, size), false, 0.5 * (front - left).abs() + 0.5 * (front - right).abs())
        .contour(line(at, stem, 0.0, 400.0, size), false, (left - right).abs());
    scene.junctions = vec![Junction { at, branches: vec![along, back, stem] }];
    scene
}

/// Two lines that cross; four greys.
pub(super) fn x_junction(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Junction, 100 + number);
    let size = [140, 140];
    let at = middle(&mut rng, size);
    let turn = rng.between(0.0, 180.0);
    let (one, other) = (direction(turn), direction(turn + [90.0, 60.0][number % 2]));
    let back = |v: [f64; 2]| [-v[0], -v[1]];
    let [a, b, c, d] =
        [[40.0, 100.0, 160.0, 220.0], [60.0, 160.0, 110.0, 210.0], [40.0, 200.0, 200.0, 90.0]][number % 3];
    let mut scene = Scene::new(format!("{name}-x"), Family::Junction, size, Fill::grey(a))
        .paint(wedge(at, one, other), Fill::grey(b))
        .paint(wedge(at, other, back(one)), Fill::grey(d))
        .paint(wedge(at, back(one), back(other)), Fill::grey(c))
        .contour(whole_line(at, one, size), false, 0.5 * ((a - b).abs() + (c - d).abs()))
        .contour(whole_line(at, other, size), false, 0.5 * ((b - d).abs() + (a - c).abs()));
    scene.side_by_side = true;
    scene.junctions = vec![Junction { at, branches: vec![one, back(one), other, back(other)] }];
    scene
}

/// Bars 1 to 6 px wide, dark and light.
pub(super) fn bar(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Bar, number);
    let size = [140, 140];
    let width = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0][number % 7];
    let [paper, ink] = greys(&mut rng, STEPS, number / 2 + 1);
    let (at, along) = (middle(&mut rng, size), direction(rng.between(0.0, 180.0)));
    let first = moved(at, along, 0.0, -0.5 * width);
    let second = moved(at, along, 0.0, 0.5 * width);
    Scene::new(format!("{name}-{width}px"), Family::Bar, size, Fill::grey(paper))
        .paint(strip(first, along, width), Fill::grey(ink))
        .contour(whole_line(first, along, size), false, (ink - paper).abs())
        .contour(whole_line(second, along, size), false, (ink - paper).abs())
}

/// Two edges 2 to 20 px apart: two steps up, or one up and one down.
pub(super) fn parallel(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Parallel, number);
    let size = [140, 140];
    let apart = [2.0, 3.0, 4.0, 6.0, 10.0, 20.0][number % 6];
    let (at, along) = (middle(&mut rng, size), direction(rng.between(0.0, 180.0)));
    let (paper, step) = (50.0, [50.0, 80.0][number % 2]);
    let last = if number < 6 { paper + 2.0 * step } else { paper };
    let (first, second) = (moved(at, along, 0.0, -0.5 * apart), moved(at, along, 0.0, 0.5 * apart));
    let mut scene = Scene::new(format!("{name}-{apart}px"), Family::Parallel, size, Fill::grey(paper))
        .paint(half_plane(first, along), Fill::grey(paper + step))
        .paint(half_plane(second, along), Fill::grey(last))
        .contour(whole_line(first, along, size), false, step)
        .contour(whole_line(second, along, size), false, step);
    scene.tolerance = tolerance(apart);
    scene
}

/// Six steps up, 4 to 12 px apart.
pub(super) fn stair(number: usize) -> Scene {
    const STEP: f64 = 30.0;
    let (mut rng, name) = start(Family::Stair, number);
    let size = [140, 140];
    let apart = [4.0, 6.0, 8.0, 12.0][number];
    let (at, along) = (middle(&mut rng, size), direction(rng.between(0.0, 180.0)));
    let mut scene = Scene::new(format!("{name}-{apart}px"), Family::Stair, size, Fill::grey(30.0));
    for step in 0..6 {
        let at = moved(at, along, 0.0, (f64::from(step) - 2.5) * apart);
        scene = scene.paint(half_plane(at, along), Fill::grey(30.0 + STEP * f64::from(step + 1))).contour(
            whole_line(at, along, size),
            false,
            STEP,
        );
    }
    scene.tolerance = tolerance(apart);
    scene
}

/// How near to an edge that is `apart` from the next a traced line must be: one line in the middle finds neither.
fn tolerance(apart: f64) -> f64 {
    f64::min(1.0, 0.4 * apart)
}
