//! One contour to a scene: straight, round, wavy, with corners, fading, of equal lightness.

use super::{FAINT_STEPS, STEPS, greys, middle, start};
use crate::scene::{Curve, Family, Fill, P, Scene};
use crate::shapes::{self, direction, half_plane, moved, sides, whole_line};
use tactograph_tools::rng::Rng;

/// One of 36 angles, 5 degrees apart.
pub(super) fn straight(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Straight, number);
    let size = [160, 160];
    let [paper, ink] = greys(&mut rng, FAINT_STEPS, number);
    let (at, along) = (middle(&mut rng, size), direction(5.0 * number as f64));
    Scene::new(name, Family::Straight, size, Fill::grey(paper)).paint(half_plane(at, along), Fill::grey(ink)).contour(
        whole_line(at, along, size),
        false,
        (ink - paper).abs(),
    )
}

pub(super) fn disc(number: usize, radius: f64) -> Scene {
    let family = if radius <= 30.0 { Family::SmallDisc } else { Family::LargeDisc };
    let (mut rng, name) = start(family, number);
    let size = [2 * radius.ceil() as usize + 40; 2];
    let [paper, ink] = greys(&mut rng, STEPS, number);
    let (outline, truth) = shapes::ellipse(middle(&mut rng, size), radius, radius, [1.0, 0.0]);
    Scene::new(format!("{name}-r{radius}"), family, size, Fill::grey(paper)).paint(outline, Fill::grey(ink)).contour(
        truth,
        true,
        (ink - paper).abs(),
    )
}

/// Half axes 15 to 79 px, up to 3 to 1.
pub(super) fn ellipse(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Ellipse, number);
    let long = 30.0 + 7.0 * number as f64;
    let short = long / [1.5, 2.0, 1.2, 3.0][number % 4];
    let size = [2 * long as usize + 40; 2];
    let [paper, ink] = greys(&mut rng, STEPS, number / 2);
    let along = direction(rng.between(0.0, 180.0));
    let (outline, truth) = shapes::ellipse(middle(&mut rng, size), long, short, along);
    Scene::new(name, Family::Ellipse, size, Fill::grey(paper)).paint(outline, Fill::grey(ink)).contour(
        truth,
        true,
        (ink - paper).abs(),
    )
}

/// Waves whose sharpest bends have radii of 6 to 26 px.
pub(super) fn sine(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Sine, number);
    let size = [200, 160];
    let [paper, ink] = greys(&mut rng, STEPS, number);
    let wavelength = [40.0, 50.0, 60.0, 80.0, 64.0, 100.0][number];
    let amplitude = [5.0, 7.0, 12.0, 14.0, 4.0, 30.0][number];
    let along = direction(rng.between(-15.0, 15.0));
    let (outline, truth) = shapes::sine(middle(&mut rng, size), along, amplitude, wavelength, size);
    Scene::new(name, Family::Sine, size, Fill::grey(paper)).paint(outline, Fill::grey(ink)).contour(
        truth,
        false,
        (ink - paper).abs(),
    )
}

/// Rhombuses with corners of 30 to 150 degrees, turned by any angle.
pub(super) fn polygon(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Polygon, number);
    let size = [180, 180];
    let [paper, ink] = greys(&mut rng, STEPS, number);
    let sharp = [30.0, 40.0, 50.0, 60.0, 75.0, 90.0][number % 6];
    let (centre, turn) = (middle(&mut rng, size), rng.between(0.0, 180.0));
    let half = 0.5 * f64::to_radians(sharp);
    let (long, short) = (70.0 * half.cos(), 70.0 * half.sin());
    let along = direction(turn);
    let corners = vec![
        moved(centre, along, long, 0.0),
        moved(centre, along, 0.0, short),
        moved(centre, along, -long, 0.0),
        moved(centre, along, 0.0, -short),
    ];
    let mut scene = Scene::new(format!("{name}-{sharp}deg"), Family::Polygon, size, Fill::grey(paper))
        .paint(corners.clone(), Fill::grey(ink))
        .contour(sides(&corners), true, (ink - paper).abs());
    scene.corners = corners;
    scene
}

/// An edge whose step grows from nothing to 80 along it, lying, standing or as a wave.
pub(super) fn ramp(number: usize) -> Scene {
    const HIGHEST: f64 = 80.0;
    let (mut rng, name) = start(Family::Ramp, number);
    let standing = number % 2 == 1;
    let size = if standing { [110, 380] } else { [380, 110] };
    let at = middle(&mut rng, size);
    let along = direction(rng.between(-4.0, 4.0) + if standing { 90.0 } else { 0.0 });
    let (outline, truth) = if number < 4 {
        (half_plane(at, along), whole_line(at, along, size))
    } else {
        shapes::sine(at, along, 10.0, 100.0, size)
    };
    let (axis, length) = (usize::from(standing), 380.0);
    let paper = rng.between(40.0, 130.0);
    let step = move |p: P| HIGHEST * (p[axis] / length).clamp(0.0, 1.0);
    let contrast = truth.iter().map(|&p| step(p)).collect();
    let fill = Fill::Varying(Box::new(move |p| [paper + step(p); 3]));
    let mut scene = Scene::new(name, Family::Ramp, size, Fill::grey(paper)).paint(outline, fill);
    scene.curves.push(Curve { points: truth, closed: false, contrast });
    scene
}

/// Two colours of equal luma (0.299, 0.587, 0.114 of the code values), so that a grey picture of them is flat.
pub(super) fn iso_colour(number: usize) -> Scene {
    const RED_TO_GREEN: [f64; 3] = [1.0, -0.299 / 0.587, 0.0];
    const BLUE_TO_GREEN: [f64; 3] = [0.0, -0.114 / 0.587, 1.0];
    let (mut rng, name) = start(Family::IsoColour, number);
    let size = [140, 140];
    let (towards, step) = [
        (RED_TO_GREEN, 60.0),
        (BLUE_TO_GREEN, 120.0),
        (RED_TO_GREEN, 100.0),
        (BLUE_TO_GREEN, 160.0),
        (RED_TO_GREEN, 140.0),
        (BLUE_TO_GREEN, 80.0),
    ][number];
    let grey = rng.between(110.0, 145.0).round();
    let [one, other] = [-0.5, 0.5].map(|side| towards.map(|t| grey + side * step * t));
    let scene = Scene::new(name, Family::IsoColour, size, Fill::Flat(one));
    let mut scene = outline_of(scene, number, size, &mut rng, Fill::Flat(other), step);
    scene.colour = true;
    scene
}

/// A straight edge or a disc.
fn outline_of(scene: Scene, number: usize, size: [usize; 2], rng: &mut Rng, fill: Fill, step: f64) -> Scene {
    let at = middle(rng, size);
    if number < 4 {
        let along = direction(rng.between(0.0, 180.0));
        scene.paint(half_plane(at, along), fill).contour(whole_line(at, along, size), false, step)
    } else {
        let (outline, truth) = shapes::ellipse(at, 40.0, 40.0, [1.0, 0.0]);
        scene.paint(outline, fill).contour(truth, true, step)
    }
}
