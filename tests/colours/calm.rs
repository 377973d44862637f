//! Skies and other smooth passages stay in one piece; what is clearly another colour stays another.

use tactograph::internals::classes::{self, Class, Classes};
use tactograph::internals::raster::Raster;
use tactograph::internals::units::Size;

use crate::colours::scenes::{self, Dice, PX_PER_MM, decoded};

/// A picture of 120 by 80 mm whose colour (sRGB) is given for a place (0..1), with slow noise on saturation and hue, as haze has
/// it, and grain.
fn picture(seed: u64, colour: impl Fn(f32, f32) -> [f32; 3], haze: f32) -> Raster {
    let size = Size::new((120.0 * PX_PER_MM) as u32, (80.0 * PX_PER_MM) as u32);
    let mut dice = Dice::new(seed);
    let waves: Vec<[f32; 6]> = (0..24).map(|_| std::array::from_fn(|_| dice.roll())).collect();
    let mut planes = [Vec::new(), Vec::new(), Vec::new()];
    for i in 0..size.area() as usize {
        let (x, y) = (i % size.width as usize, i / size.width as usize);
        let (x, y) = ((x as f32 + 0.5) / size.width as f32, (y as f32 + 0.5) / size.height as f32);
        let rgb = colour(x, y);
        for (channel, plane) in planes.iter_mut().enumerate() {
            // Waves 8 to 40 mm long, of each channel for itself: the hue of a grey sky flips to and fro.
            let slow: f32 = waves[8 * channel..][..8]
                .iter()
                .map(|w| (std::f32::consts::TAU * ((3.0 + 9.0 * w[0]) * x + (2.0 + 6.0 * w[1]) * y + w[2])).sin())
                .sum();
            let value = rgb[channel] + haze * slow + 0.02 * (dice.roll() - 0.5);
            plane.push(decoded(value.clamp(0.0, 1.0)));
        }
    }
    Raster::colour(size, planes)
}

fn sort(raster: &Raster) -> Classes {
    classes::sort(raster, &scenes::contours(raster), &scenes::params())
}

fn mix(a: [f32; 3], b: [f32; 3], share: f32) -> [f32; 3] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

const BLUE: [f32; 3] = [0.35, 0.55, 0.85];
const HAZE: [f32; 3] = [0.72, 0.73, 0.74];

#[test]
fn a_sky_that_fades_into_haze_has_one_border_at_most() {
    for seed in 1..=8 {
        let sky = sort(&picture(seed, |_, y| mix(BLUE, HAZE, y), 0.012));
        let names: Vec<(&str, u32)> = sky.regions.iter().map(|r| (r.class.name(), r.cells)).collect();
        assert!(names.len() <= 2, "seed {seed}: {names:?}");
        let top = sky.region[0].map(|region| sky.regions[region as usize].class);
        assert_eq!(top, Some(Class::Blue), "seed {seed}: the top is blue for sure: {names:?}");
    }
}

#[test]
fn haze_is_one_area() {
    for seed in 1..=8 {
        // At the border of grey and blue everywhere: 0.18 to 0.22 of saturation.
        let haze = sort(&picture(seed, |x, _| [0.58 + 0.02 * x, 0.64, 0.73], 0.007));
        let names: Vec<(&str, u32)> = haze.regions.iter().map(|r| (r.class.name(), r.cells)).collect();
        assert!(names.len() <= 2, "seed {seed}: {names:?}");
        assert!(haze.regions.iter().all(|r| matches!(r.class, Class::Blue | Class::Grey)), "seed {seed}: {names:?}");
    }
}

#[test]
fn true_colours_stay() {
    // A rainbow without any contour: all four hues are found, in their order.
    let rainbow = sort(&picture(1, |x, _| scenes::rgb_of(360.0 * x, 0.8, 0.9), 0.0));
    let row = 40 * rainbow.size.width as usize;
    let mut found: Vec<&str> = (0..rainbow.size.width as usize)
        .filter_map(|x| rainbow.region[row + x].map(|region| rainbow.regions[region as usize].class.name()))
        .collect();
    found.dedup();
    assert_eq!(found, ["red", "yellow", "green", "blue", "red"]);
    // A patch of 16 mm, clearly blue on a grey sky, without a hard edge.
    let patch = sort(&picture(
        2,
        |x, y| {
            let distance = ((x - 0.5) * 120.0).hypot((y - 0.5) * 80.0);
            mix(BLUE, HAZE, ((distance - 8.0) / 6.0).clamp(0.0, 1.0))
        },
        0.012,
    ));
    let names: Vec<&str> = patch.regions.iter().map(|region| region.class.name()).collect();
    assert_eq!(names, ["grey", "blue"]);
}

#[test]
fn a_grey_picture_has_no_hue() {
    let size = Size::new(300, 200);
    let ramp: Vec<f32> = (0..size.area()).map(|i| (i % 300) as f32 / 300.0).collect();
    let params = classes::Params { fringe: true, min_saturation: 0.0, min_value: 0.0, ..scenes::params() };
    for raster in [Raster::grey(size, ramp.clone()), Raster::colour(size, [ramp.clone(), ramp.clone(), ramp])] {
        let sorted = classes::sort(&raster, &[], &params);
        assert!(sorted.regions.iter().all(|region| region.class == Class::Grey), "{:?}", sorted.regions);
        assert!(sorted.fringe.iter().all(Option::is_none));
    }
}
