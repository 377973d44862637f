//! How much of a drawing's page changes when its picture changes a little: what `docs/stability.md` says of drawings.
//! The table of all changes and of photographs, which nothing is promised of, is printed by
//! `tools/src/bin/stability/main.rs`.

use tactograph::internals::page::Figure;
use tactograph_tools::drawn::share_within;
use tactograph_tools::rng::Rng;

use crate::relations::{Bitmap, DRAWINGS, bitmap};

/// Width of figures, mm.
const WIDTH: f32 = 150.0;
/// A line is where it was when it is this near, mm.
const NEAR: f64 = 1.0;
/// Share of the length of lines that may be lost or gained. The most is 0.8 %, of landscape.svg a millimetre wider.
const MOST: f64 = 0.01;

/// The lines of a figure laid on a rectangle of [`WIDTH`], mm from its corner.
fn laid(figure: &Figure) -> Vec<Vec<[f64; 2]>> {
    let place = figure.place;
    let scale = f64::from(WIDTH / place.width());
    let runs = figure.lines.iter().flat_map(|line| &line.runs);
    let points = runs.map(|run| {
        run.path().map(|at| [scale * f64::from(at.x - place.min.x), scale * f64::from(at.y - place.min.y)]).collect()
    });
    points.collect()
}

/// Share of the length of all lines without a line near to them in the other figure, the mean of both ways.
fn changed(one: &Figure, other: &Figure) -> f64 {
    let (one, other) = (laid(one), laid(other));
    assert!(one.len() > 1 && other.len() > 1, "{} and {} lines", one.len(), other.len());
    let missing = |these: &[Vec<[f64; 2]>], those: &[Vec<[f64; 2]>]| {
        share_within(these, those, NEAR).map_or(0.0, |near| 1.0 - near)
    };
    0.5 * (missing(&one, &other) + missing(&other, &one))
}

#[test]
fn drawings_change_little_with_one_in_255_or_a_millimetre_of_width() {
    for name in DRAWINGS {
        let picture = bitmap(name);
        let before = picture.figure(WIDTH);
        let wider = changed(&before, &picture.figure(WIDTH + 1.0));
        assert!(wider <= MOST, "{name}, a millimetre wider: {wider} of the lines");
        let noisy = changed(&before, &stirred(&picture).figure(WIDTH));
        assert!(noisy <= MOST, "{name}, 1/255: {noisy} of the lines");
    }
}

/// Each sample one step of 8 bits up or down, at random.
fn stirred(picture: &Bitmap) -> Bitmap {
    let [width, height] = picture.size();
    let mut rng = Rng::new(5);
    let up: Vec<[bool; 3]> = (0..width * height).map(|_| [0; 3].map(|_| rng.coin())).collect();
    picture.changed(|x, y, sample| {
        let up = up[y * width + x];
        [0, 1, 2].map(|i| if up[i] { sample[i].saturating_add(1) } else { sample[i].saturating_sub(1) })
    })
}

/// What is measured notices a line that is elsewhere.
#[test]
fn a_shape_that_moves_is_noticed() {
    let square = |left: usize| {
        Bitmap::of("square", [600, 400], move |x, y| {
            let is_inside = (left..left + 150).contains(&x) && (100..300).contains(&y);
            let is_beside = (420..560).contains(&x) && ((60..180).contains(&y) || (220..340).contains(&y));
            if is_inside || is_beside { [200, 30, 30] } else { [255; 3] }
        })
    };
    let before = square(100).figure(WIDTH);
    assert!(changed(&before, &square(140).figure(WIDTH)) > MOST);
    assert!(changed(&before, &before) < 1e-9);
}
