//! Tests of `signs`.

use super::*;
use crate::raster::lab;

const SIZE: Size = Size::new(400, 300);
const PX_PER_MM: f32 = 4.0;
/// Nowhere in rows or columns, and 20 px and more apart.
const PLACES: [[f32; 2]; 8] = [
    [61.0, 47.5],
    [103.5, 202.0],
    [148.0, 91.0],
    [190.3, 251.0],
    [233.0, 33.0],
    [287.5, 160.7],
    [322.0, 222.0],
    [350.0, 75.0],
];

/// A white picture with what is inside of some shape in black, and lines of a pale grid below it.
fn picture(is_inside: impl Fn(f32, f32) -> bool, has_grid: bool) -> Raster {
    let width = SIZE.width as usize;
    let pixel = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        let within = |at: usize, k: usize| at as f32 + 0.125 + 0.25 * k as f32;
        let places = (0..16).map(|k| (within(x, k % 4), within(y, k / 4)));
        let ink = places.filter(|(x, y)| is_inside(*x, *y)).count() as f32 / 16.0;
        let ground = if has_grid && (x % 60 == 30 || y % 60 == 30) { 0.6 } else { 1.0 };
        (1.0 - ink) * ground
    };
    Raster::grey(SIZE, (0..SIZE.len()).map(pixel).collect())
}

fn found(raster: &Raster) -> Signs {
    Signs::find(&lab::whole(raster), raster.size(), PX_PER_MM)
}

/// How many of each kind there are, all of them at these places.
fn counts(signs: &Signs, places: &[[f32; 2]]) -> Vec<usize> {
    for sign in signs.kinds.iter().flatten() {
        let is_there = |at: &[f32; 2]| distance(*at, [sign.at.x, sign.at.y]) < 1.1;
        assert!(places.iter().any(is_there), "{sign:?}");
    }
    signs.kinds.iter().map(Vec::len).collect()
}

fn is_disc(x: f32, y: f32) -> bool {
    x.hypot(y) < 4.5
}

fn at_places(places: &[[f32; 2]], shape: impl Fn(f32, f32) -> bool) -> impl Fn(f32, f32) -> bool {
    move |x, y| places.iter().any(|[px, py]| shape(x - px, y - py))
}

#[test]
fn discs_on_gridlines_and_on_one_another_are_found_and_taken_out() {
    let places = [&PLACES[..], &[[210.0, 130.0], [216.5, 132.0]]].concat();
    let raster = picture(at_places(&places, is_disc), true);
    let signs = found(&raster);
    assert_eq!(counts(&signs, &places), [10]);
    let erased = signs.erased_from(&raster);
    let at = |x: usize, y: usize| erased.planes().as_slice()[0][y * SIZE.width as usize + x];
    assert!((at(61, 47) - 1.0).abs() < 0.02, "the ground");
    assert!((at(210, 132) - 0.6).abs() < 0.02, "a gridline");
    let mut edges = Edges::none(SIZE);
    signs.add_to(&mut edges);
    assert!(edges.chains.len() == 10 && edges.chains.iter().all(|chain| chain.closed && chain.kind.sign == Some(0)));
}

/// A shape around its middle.
type Named<'a> = (&'a str, &'a dyn Fn(f32, f32) -> bool);

#[test]
fn all_shapes_that_mark_places_are_signs() {
    let triangle = |x: f32, y: f32| y < 4.5 && y > -4.5 && x.abs() < 0.5 * (y + 4.5);
    let square = |x: f32, y: f32| x.abs().max(y.abs()) < 4.0 && x.abs().max(y.abs()) > 2.4;
    let ring = |x: f32, y: f32| x.hypot(y) < 5.0 && x.hypot(y) > 3.4;
    let cross = |x: f32, y: f32| x.abs().max(y.abs()) < 4.5 && (x - y).abs().min((x + y).abs()) < 1.0;
    let plus = |x: f32, y: f32| x.abs().max(y.abs()) < 5.0 && x.abs().min(y.abs()) < 0.7;
    let shapes: [Named<'_>; 6] = [
        ("disc", &is_disc),
        ("triangle", &triangle),
        ("square", &square),
        ("ring", &ring),
        ("cross", &cross),
        ("plus", &plus),
    ];
    for (name, shape) in shapes {
        assert_eq!(counts(&found(&picture(at_places(&PLACES, shape), false)), &PLACES), [8], "{name}");
    }
}

#[test]
fn of_two_kinds_the_filled_one_is_first() {
    let ring = |x: f32, y: f32| x.hypot(y) < 5.0 && x.hypot(y) > 3.4;
    // scattered, each four by themselves; outlines thinner than 1.6 px are in pieces at some places among the pixels
    let [of_discs, of_rings] = [[0, 2, 4, 7], [1, 3, 5, 6]].map(|of| of.map(|place| PLACES[place]));
    let (rings, discs) = (at_places(&of_rings, ring), at_places(&of_discs, is_disc));
    let signs = found(&picture(|x, y| rings(x, y) || discs(x, y), false));
    assert_eq!(counts(&signs, &PLACES), [4, 4]);
    let is_first = |sign: &Sign| of_discs.iter().any(|at| distance(*at, [sign.at.x, sign.at.y]) < 1.1);
    assert!(signs.kinds[0].iter().all(is_first));
}

#[test]
fn letters_rows_leaves_and_other_shapes_are_no_signs() {
    let none = |places: &[[f32; 2]], shape: &dyn Fn(f32, f32) -> bool, name: &str| {
        assert!(found(&picture(at_places(places, shape), false)).is_empty(), "{name}");
    };
    let ring = |x: f32, y: f32| x.hypot(y) < 5.0 && x.hypot(y) > 3.5;
    none(&PLACES, &|x, y| ring(x, y) || (x - 10.0).abs() < 1.0 && y.abs() < 8.0, "ol");
    none(&PLACES, &|x, y| ring(x, y) && !(x > 0.0 && y.abs() < 1.5), "c");
    none(&PLACES, &|x, y| (x - 0.5 * y).abs() < 2.0 && y.abs() < 5.0 && x + y < 4.0, "a leaf");
    none(&PLACES[..3], &is_disc, "three");
    let row: Vec<[f32; 2]> = (0..9).map(|k| [40.0 + 35.0 * k as f32, 150.0]).collect();
    none(&row, &is_disc, "a row");
    let window = |k: usize| [80.0 + 41.0 * (k % 4) as f32, 60.0 + 57.0 * (k / 4) as f32];
    none(&(0..12).map(window).collect::<Vec<_>>(), &|x, y| x.abs().max(y.abs()) < 4.5, "windows");
    let dotted: Vec<[f32; 2]> = (0..20).map(|k| [30.0 + 16.0 * k as f32, 60.0 + 9.5 * k as f32]).collect();
    none(&dotted, &is_disc, "a dotted line");
}
