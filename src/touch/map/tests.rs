//! Tests of `map`.

use super::*;

#[test]
fn no_two_looks_are_alike_without_colour() {
    let signs = Signs::of_layers(&[]);
    let looks: Vec<CellLook> = legend(&signs).into_iter().map(|(_, look)| look).collect();
    let patterns: Vec<Vec<bool>> = looks
        .iter()
        .map(|look| {
            let dark = |k: u32| colour(*look, &signs, (k % 24) as f32 + 0.5, (k / 24) as f32 + 0.5)[1];
            let lightest = (0..576).map(dark).fold(0.0, f32::max);
            (0..576).map(|k| dark(k) < 0.8 * lightest).collect()
        })
        .collect();
    for (a, pattern) in patterns.iter().enumerate() {
        // what is not judged is its pattern, paler
        for (b, other) in patterns.iter().enumerate().skip(a + 1).filter(|(b, _)| !looks[*b].pale) {
            let differ = pattern.iter().zip(other).filter(|(p, q)| p != q).count();
            assert!(differ > 50, "{:?} and {:?} differ in {differ} pixels", looks[a], looks[b]);
        }
    }
}

#[test]
fn patterns_run_as_the_signs_of_the_page() {
    let rhombus = |degrees| Some(Sign::Rhombus { degrees });
    let swapped = Signs::of_layers(&[(Class::Blue, rhombus(90.0)), (Class::Yellow, rhombus(0.0))]);
    for (class, upright) in [(Class::Blue, true), (Class::Yellow, false)] {
        let look = CellLook { felt: Some(class), mark: Symbol::None, pale: false };
        let at = |x: u32, y: u32| colour(look, &swapped, x as f32 + 0.5, y as f32 + 0.5).map(f32::to_bits);
        let same = |k: u32| if upright { at(k, 0) == at(k, 7) } else { at(0, k) == at(7, k) };
        let differs = |k: u32| if upright { at(k, 0) != at(0, 0) } else { at(0, k) != at(0, 0) };
        assert!((0..24).all(same) && (0..24).any(differs), "{class:?}");
    }
}
