//! Sets of dots to travel through, in hundredths of a millimetre; always the same.

use tactograph::internals::output::dots::path_order::DotPosition;

/// Each set with its name.
pub fn all() -> Vec<(&'static str, Vec<DotPosition>)> {
    vec![
        ("random, few", random(150, [19_000, 25_000], 1)),
        ("random", random(2_000, [19_000, 25_000], 2)),
        ("rings", rings()),
        ("waves", waves()),
        ("text", text()),
        ("texture", texture()),
        ("figure", figure()),
    ]
}

/// As many dots as a machine presses in half an hour, on A3.
pub fn large() -> Vec<DotPosition> {
    random(20_000, [29_700, 37_300], 3)
}

/// Numbers that look random: Knuth's linear congruence, upper bits.
pub fn numbers(seed: u64) -> impl FnMut(usize) -> usize {
    let mut state = seed;
    move |below| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) as usize) % below.max(1)
    }
}

fn random(count: usize, size: [i32; 2], seed: u64) -> Vec<DotPosition> {
    let mut next = numbers(seed);
    (0..count).map(|_| size.map(|most| next(most as usize + 1) as i32)).collect()
}

/// Circles about one middle, dots 2.4 mm apart.
fn rings() -> Vec<DotPosition> {
    let circle = |radius: i32| circle([9_500, 12_500], f64::from(radius));
    (600..9_400).step_by(800).flat_map(circle).collect()
}

fn circle([x, y]: DotPosition, radius: f64) -> Vec<DotPosition> {
    let count = (radius * std::f64::consts::TAU / 240.0).floor();
    let at = |number: i32| f64::from(number) * std::f64::consts::TAU / count;
    (0..count as i32).map(|n| [x + (radius * at(n).cos()) as i32, y + (radius * at(n).sin()) as i32]).collect()
}

/// Lines that wind down the sheet, far more down than across.
fn waves() -> Vec<DotPosition> {
    let line =
        |x: i32| (500..24_500).step_by(240).map(move |y| [x + (400.0 * (f64::from(y) / 1_500.0).sin()) as i32, y]);
    (1_000..18_500).step_by(1_400).flat_map(line).collect()
}

/// Lines of braille: cells of six dots, 2.5 mm apart, a cell each 6.2 mm, a line each 10 mm.
fn text() -> Vec<DotPosition> {
    let mut next = numbers(4);
    let mut dots = Vec::new();
    for (line, cell) in (0..24).flat_map(|line| (0..30).map(move |cell| (line, cell))) {
        let letter = if next(6) == 0 { 0 } else { next(64) };
        let set = (0..6).filter(|dot| letter >> dot & 1 == 1);
        dots.extend(set.map(|dot| [200 + cell * 620 + dot / 3 * 250, 500 + line * 1_000 + dot % 3 * 250]));
    }
    dots
}

/// Rows of dots at 45 degrees over the whole sheet.
fn texture() -> Vec<DotPosition> {
    let row = |row: i32| (0..37).map(move |dot| [dot * 500 + row % 2 * 250, row * 250]);
    (0..100).flat_map(row).collect()
}

/// A drawing as it comes: a frame, circles, an area of texture, two lines of text.
fn figure() -> Vec<DotPosition> {
    let mut dots: Vec<DotPosition> = (0..=18_000).step_by(240).flat_map(|x| [[x, 500], [x, 24_500]]).collect();
    dots.extend((740..24_500).step_by(240).flat_map(|y| [[0, y], [18_000, y]]));
    dots.extend([[5_000, 6_000], [12_000, 8_000], [9_000, 16_000]].into_iter().flat_map(|at| circle(at, 3_500.0)));
    dots.extend(circle([9_000, 16_000], 5_000.0));
    dots.extend(texture().into_iter().filter(|[x, y]| (3_000..15_000).contains(x) && (21_500..24_000).contains(y)));
    dots.extend(text().into_iter().filter(|[x, y]| (1_000..17_000).contains(x) && (900..2_400).contains(y)));
    dots
}
