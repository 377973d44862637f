//! Pictures on which detectors of edges go wrong unseen: checkerboards of every period at every phase, rings up to
//! where pixels can show none, and noise. What is looked at are points before they are linked, as the rules after them
//! look at the whole picture.

use tactograph::internals::edges::{Params, ridge_points};
use tactograph::internals::raster::Raster;
use tactograph::internals::units::Size;
use tactograph_tools::rng::Rng;

use crate::common::families;

/// Positions nearer to the border than this see what is beyond it, px.
const MARGIN: f32 = 12.0;

fn params() -> Params {
    families::plan(families::DEFAULT).edges(4.0)
}

/// A grey picture of `lightness(column, row)`, 20 to 100.
fn picture([width, height]: [u32; 2], mut lightness: impl FnMut(u32, u32) -> f32) -> Raster {
    let light = |l: f32| ((l / 100.0 + 0.055) / 1.055).powf(2.4);
    let values = (0..width * height).map(|i| light(lightness(i % width, i / width))).collect();
    Raster::grey(Size::new(width, height), values)
}

/// Where points are, px.
fn places(raster: &Raster) -> Vec<[f32; 2]> {
    ridge_points(raster, &params()).into_iter().map(|(_, at, _)| [at.x, at.y]).collect()
}

/// Those that see nothing beyond the border.
fn inner(raster: &Raster) -> Vec<[f32; 2]> {
    let sides = [raster.size().width, raster.size().height].map(|side| side as f32 - MARGIN);
    let is_inner = |at: &[f32; 2]| (0..2).all(|i| (MARGIN..sides[i]).contains(&at[i]));
    places(raster).into_iter().filter(is_inner).collect()
}

/// How many of the places `of` have none `among` others within 0.02 px.
fn alone(of: &[[f32; 2]], among: &[[f32; 2]]) -> usize {
    let mut sorted = among.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let is_alone = |at: &&[f32; 2]| {
        let first = sorted.partition_point(|other| other[0] < at[0] - 0.02);
        let mut near = sorted[first..].iter().take_while(|other| other[0] <= at[0] + 0.02);
        !near.any(|other| (other[1] - at[1]).abs() <= 0.02)
    };
    of.iter().filter(is_alone).count()
}

#[test]
fn checkerboards_of_every_period_have_the_same_points_at_every_phase() {
    for side in 1..=8_u32 {
        let period = 2.0 * side as f32;
        let points = |phase: [u32; 2]| -> Vec<[f32; 2]> {
            let is_dark = |x: u32, y: u32| ((x + phase[0]) / side + (y + phase[1]) / side).is_multiple_of(2);
            let board = picture([72, 64], |x, y| if is_dark(x, y) { 20.0 } else { 80.0 });
            let at = |at: [f32; 2]| [0, 1].map(|i| (at[i] + phase[i] as f32).rem_euclid(period));
            inner(&board).into_iter().map(at).collect()
        };
        // a period to all sides, so that places beside its border have those beyond it
        let around = |points: &[[f32; 2]]| -> Vec<[f32; 2]> {
            let by = [-period, 0.0, period];
            let shifted = |at: &[f32; 2]| by.map(|x| by.map(|y| [at[0] + x, at[1] + y]));
            points.iter().flat_map(shifted).flatten().collect()
        };
        let first = points([0, 0]);
        // squares of one or two pixels are a grey to the detector, those of six to eight are seen
        assert!(side > 2 || first.is_empty(), "squares of {side} px: {} points", first.len());
        assert!(side < 6 || first.len() > 100, "squares of {side} px: {} points", first.len());
        for phase in (0..side).flat_map(|y| (0..2 * side).map(move |x| [x, y])) {
            let there = points(phase);
            let (lost, new) = (alone(&first, &around(&there)), alone(&there, &around(&first)));
            let most = first.len() / 100;
            assert!(lost <= most && new <= most, "squares of {side} px at {phase:?}: {lost} lost, {new} new");
        }
    }
}

/// Rings that become narrower outwards: from 3.3 px for a dark and a light one on, the detector sees a grey. It sees no
/// false rings there, as those do who look at every second pixel.
#[test]
fn a_zone_plate_has_points_only_where_its_rings_can_be_seen() {
    for phase in [0.0, 0.25, 0.5, 0.75_f32] {
        let plate = picture([300, 300], |x, y| {
            let (dx, dy) = (x as f32 + 0.5 - 150.0, y as f32 + 0.5 - 150.0);
            55.0 + 30.0 * (std::f32::consts::TAU * ((dx * dx + dy * dy) / 900.0 + phase)).cos()
        });
        let from_middle: Vec<f32> = inner(&plate).iter().map(|at| (at[0] - 150.0).hypot(at[1] - 150.0)).collect();
        let rings = |from: f32, to: f32| from_middle.iter().filter(|r| (from..to).contains(*r)).count();
        assert!(rings(20.0, 110.0) > 5000, "{} points on rings of 4 px and more", rings(20.0, 110.0));
        assert_eq!(rings(145.0, 300.0), 0, "false rings");
    }
}

#[test]
fn points_of_noise_follow_flips_and_turns() {
    for percent in [0_u32, 25, 50, 75, 100] {
        let mut rng = Rng::new(u64::from(percent));
        let reach = 0.4 * percent as f32;
        let noise: Vec<f32> = (0..120 * 120).map(|_| 60.0 + rng.between_f32(-reach, reach)).collect();
        let at = |x: u32, y: u32| noise[(y * 120 + x) as usize];
        let before = places(&picture([120, 120], at));
        assert_eq!(before.is_empty(), percent == 0, "noise of {percent} %: {} points", before.len());
        let flipped = places(&picture([120, 120], |x, y| at(119 - x, y)));
        let turned = places(&picture([120, 120], |x, y| at(y, 119 - x)));
        let want_flipped: Vec<_> = before.iter().map(|[x, y]| [120.0 - x, *y]).collect();
        // where (y, 119 - x) went is (x, y)
        let want_turned: Vec<_> = before.iter().map(|[x, y]| [120.0 - y, *x]).collect();
        for (name, want, found) in [("flipped", want_flipped, flipped), ("turned", want_turned, turned)] {
            let (lost, new, most) = (alone(&want, &found), alone(&found, &want), before.len() / 300);
            assert!(lost <= most && new <= most, "noise of {percent} %, {name}: {lost} lost, {new} new");
        }
    }
}
