//! Paper in uneven light, tinted, and what is none.

use super::*;

const SIZE: Size = Size { width: 240, height: 160 };
const SCAN: Capture = Capture { noise: 0.5, lossy: true };

/// A grey picture of what lies at each pixel, in linear light, with a little noise.
fn grey(at: impl Fn(f32, f32) -> f32) -> Raster {
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        1.0 + 0.02 * ((state >> 16) as f32 / 65_536.0 - 0.5)
    };
    let width = SIZE.width as usize;
    let value = |i: usize| at((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
    Raster::grey(SIZE, (0..SIZE.len()).map(|i| (value(i) * noise()).min(1.0)).collect())
}

/// The same in three channels, each darker by a factor.
fn tinted(raster: &Raster, factors: [f32; 3]) -> Raster {
    let [grey, ..] = raster.planes().as_slice() else { panic!("a plane") };
    Raster::colour(SIZE, factors.map(|factor| grey.iter().map(|value| factor * value).collect()))
}

/// Paper with a bar and some strokes on it: what it reflects.
fn drawing(x: f32, y: f32) -> f32 {
    let is_stroke =
        (x - 30.0).abs() < 1.0 || (y - 140.0).abs() < 1.0 || ((x - 70.0).hypot(y - 60.0) - 30.0).abs() < 1.5;
    let is_bar = (130.0..200.0).contains(&x) && (30.0..110.0).contains(&y);
    if is_stroke {
        0.05
    } else if is_bar {
        0.5
    } else {
        1.0
    }
}

fn mean(raster: &Raster, plane: usize, [left, top]: [usize; 2]) -> f32 {
    let values = &raster.planes().as_slice()[plane];
    let row = |y: usize| &values[y * raster.size().width as usize + left..][..12];
    (top..top + 12).flat_map(row).sum::<f32>() / 144.0
}

/// Places of the drawing: paper at the left and at the right, paper in the ring, the bar.
const PLACES: [([usize; 2], f32); 5] =
    [([8, 20], 1.0), ([220, 120], 1.0), ([64, 54], 1.0), ([140, 40], 0.5), ([180, 90], 0.5)];

#[test]
fn light_that_falls_off_is_divided_out_and_a_bar_keeps_its_grey() {
    for light in [
        |x: f32, _: f32| 1.0 - 0.6 * x / 240.0,
        |x: f32, y: f32| 0.95 - 0.4 * ((x - 100.0).powi(2) + (y - 60.0).powi(2)) / 30_000.0,
        // the soft shadow of a hand
        |x: f32, y: f32| 1.0 - 0.4 * ((x + 0.3 * y - 110.0) / 60.0).clamp(0.0, 1.0),
    ] {
        let scan = grey(|x, y| light(x, y) * drawing(x, y));
        let paper = Paper::of(&scan, SCAN).expect("paper");
        let white = paper.divided(&scan);
        for (place, wanted) in PLACES {
            let found = mean(&white, 0, place);
            assert!((found - wanted).abs() < 0.1 * wanted, "{place:?}: {found} is not {wanted}");
        }
        assert!((0.3..0.8).contains(&paper.darkest), "{}", paper.darkest);
        // a finer picture of the same
        let finer = Size::new(2 * SIZE.width, 2 * SIZE.height);
        let twice = |at: usize, width: usize| (at / width / 2) * (width / 2) + at % width / 2;
        let values = &scan.planes().as_slice()[0];
        let fine = Raster::grey(finer, (0..finer.len()).map(|at| values[twice(at, finer.width as usize)]).collect());
        let (fine, coarse) = (mean(&paper.divided(&fine), 0, [440, 240]), mean(&white, 0, [220, 120]));
        assert!((fine - coarse).abs() < 0.02, "{fine} is not {coarse}");
    }
}

#[test]
fn cream_paper_is_white_and_a_tint_on_it_keeps_its_hue() {
    let cream = [0.9, 0.82, 0.65];
    let grounded = tinted(&grey(|x, _| 1.0 - 0.3 * x / 240.0), cream);
    let is_tint = |i: usize| (60..170).contains(&(i % 240)) && (20..140).contains(&(i / 240));
    let mut planes = grounded.planes().clone().as_colour();
    // light yellow ink over nearly half of the paper takes blue
    planes[2].iter_mut().enumerate().filter(|(i, _)| is_tint(*i)).for_each(|(_, blue)| *blue *= 0.45);
    let scan = Raster::colour(SIZE, planes);
    let paper = Paper::of(&scan, SCAN).expect("paper");
    let white = paper.divided(&scan);
    for (place, wanted) in [([20, 70], [1.0; 3]), ([210, 70], [1.0; 3]), ([110, 70], [1.0, 1.0, 0.45])] {
        for (plane, wanted) in wanted.into_iter().enumerate() {
            let found = mean(&white, plane, place);
            assert!((found - wanted).abs() < 0.05, "{place:?}, plane {plane}: {found} is not {wanted}");
        }
    }
    let [red, green, blue] = paper.colour.map(i32::from);
    assert!(red > green && green > blue && (red - 243).abs() < 8, "{:?}", paper.colour);
}

#[test]
fn nothing_is_done_where_paper_is_white_or_the_ground_is_painted() {
    assert!(Paper::of(&grey(|x, y| 0.99 * drawing(x, y)), SCAN).is_none(), "white paper");
    let ground = grey(|x, y| 0.6 * drawing(x, y));
    assert!(Paper::of(&ground, SCAN).is_some(), "grey paper");
    assert!(Paper::of(&ground, Capture { noise: 0.0, lossy: true }).is_none(), "a grey that a program painted");
    let falling = grey(|x, y| (1.0 - 0.4 * x / 240.0) * drawing(x, y));
    assert!(Paper::of(&falling, Capture { noise: 0.0, lossy: true }).is_some(), "light seems to fall off");
    assert!(Paper::of(&falling, Capture { noise: 0.0, lossy: false }).is_none(), "no scan at all");
    assert!(Paper::of(&Raster::grey(Size::new(20, 9), vec![0.5; 180]), SCAN).is_none(), "too small");
}

#[test]
fn what_has_something_lighter_on_it_or_is_coloured_or_dark_is_no_paper() {
    let lighter = |x: f32, y: f32| if (x - 120.0).hypot(y - 80.0) < 30.0 { 0.95 } else { 0.6 };
    assert!(Paper::of(&grey(lighter), SCAN).is_none(), "white on grey");
    assert!(Paper::of(&grey(|x, y| 0.15 * drawing(x, y)), SCAN).is_none(), "a blackboard");
    let poster = tinted(&grey(drawing), [0.35, 0.6, 0.8]);
    assert!(Paper::of(&poster, SCAN).is_none(), "a blue ground");
}

#[test]
fn a_step_parts_cells_and_a_slope_does_not() {
    let slope = grey(|x, _| 1.0 - 0.5 * x / 240.0);
    assert_eq!(Cells::of(&slope, 0.5).expect("cells").parts().len(), 1);
    let step = grey(|x, _| if x < 121.5 { 1.0 } else { 0.8 });
    let mut parts = Cells::of(&step, 0.5).expect("cells").parts();
    parts.retain(|part| part.len() > 100);
    assert_eq!(parts.len(), 2);
}

#[test]
fn a_surface_goes_on_bending_below_what_is_not_known() {
    let cells = Cells::of(&grey(|x, y| (-((x - 120.0).powi(2) + (y - 80.0).powi(2)) / 20_000.0).exp()), 0.5);
    let cells = cells.expect("cells");
    let (width, height) = (cells.size.width as usize, cells.size.height as usize);
    let is_known: Vec<bool> = (0..cells.size.len())
        .map(|cell| !(10..50).contains(&(cell % width)) || !(8..height - 8).contains(&(cell / width)))
        .collect();
    let surface = &surface::through(&cells, &is_known)[0];
    for (cell, &is_known) in is_known.iter().enumerate() {
        let off = surface.values[cell] - cells.logs[0].values[cell];
        assert!(off.abs() < 0.02, "cell {cell}, known: {is_known}: {off}");
    }
}
