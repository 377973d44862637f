//! Tests of `lab`.

use super::*;
use crate::units::Size;

#[test]
fn the_cube_root_is_as_exact_as_documented() {
    for i in 1..=100_000 {
        let x = i as f32 / 50_000.0;
        let exact = f64::from(x).cbrt();
        assert!((f64::from(cube_root(x)) - exact).abs() < 3e-5 * exact, "{x}");
    }
}

#[test]
fn known_colours_have_their_known_lab_values() {
    let one = Size::new(1, 1);
    let lab = |r, g, b| {
        let mut lab = [(); 3].map(|()| vec![0.0]);
        row(Arch::new(), &Raster::colour(one, [vec![r], vec![g], vec![b]]), 0, &mut lab);
        [lab[0][0], lab[1][0] / CHROMA, lab[2][0] / CHROMA]
    };
    // a and b as printed in textbooks for D65; lightness is the code value of the luminance
    for (got, want) in [
        (lab(1.0, 1.0, 1.0), [100.0, 0.0, 0.0]),
        (lab(1.0, 0.0, 0.0), [49.85, 80.09, 67.20]),
        (lab(0.0, 1.0, 0.0), [86.25, -86.18, 83.18]),
        (lab(0.0, 0.0, 1.0), [29.79, 79.19, -107.86]),
    ] {
        for (got, want) in got.iter().zip(want) {
            assert!((got - want).abs() < 0.05, "{got} is not {want}");
        }
    }
}
