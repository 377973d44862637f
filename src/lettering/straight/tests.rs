//! Tests of `straight`.

use super::*;

/// Two bars of 3 x 10 px, 4 px apart, along a line that rises by 45 degrees, light on a dark ground.
#[test]
fn light_bars_aslant_become_black_bars_that_stand() {
    let size = Size::new(60, 60);
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let place = |x: f32, y: f32| {
        let (dx, dy) = (x - 20.0, y - 40.0);
        (half * dx - half * dy, half * dx + half * dy)
    };
    let value = |cell: usize| {
        let (along, across) = place((cell % 60) as f32 + 0.5, (cell / 60) as f32 + 0.5);
        let is_bar = (0.0..3.0).contains(&along) || (7.0..10.0).contains(&along);
        if is_bar && (0.0..10.0).contains(&across) { 0.8 } else { 0.1 }
    };
    let raster = Raster::grey(size, (0..size.len()).map(value).collect());
    let at = |along: f32, across: f32| PxPoint::new(20.0 + half * (along + across), 40.0 + half * (across - along));
    let corners = [at(0.0, 0.0), at(10.0, 0.0), at(10.0, 10.0), at(0.0, 10.0)];
    let picture = LinePicture::of(&FoundLine { corners, angle: 45.0, height: 10.0 }, &raster);
    let width = picture.size.width as usize;
    // the row through the middle: white, bar, white, bar, white
    let row = &picture.pixels[picture.size.height as usize / 2 * width..][..width];
    let runs: Vec<bool> = row.iter().map(|grey| *grey < 128).collect();
    let runs: Vec<usize> = runs.chunk_by(|a, b| a == b).map(<[bool]>::len).collect();
    assert_eq!(runs.len(), 5, "{row:?}");
    let near = |length: usize, wanted: f32| (length as f32 - 3.4 * wanted).abs() < 4.0;
    assert!(near(runs[1], 3.0) && near(runs[2], 4.0) && near(runs[3], 3.0), "{runs:?}");
    assert!(row[0] == 255 && row[WHITE + 10] < 40, "{row:?}");
}
