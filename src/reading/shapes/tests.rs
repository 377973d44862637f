//! Tests of `shapes`.

use super::*;

fn polygon(corners: &[(f32, f32)]) -> Subpath {
    let points: Vec<_> = corners.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    Subpath { named: points.clone(), points, closed: true, curved: false }
}

#[test]
fn a_rhombus_is_read_with_its_direction() {
    let glyph = glyph(&polygon(&[(10.78, 9.22), (9.58, 9.58), (9.22, 10.78), (10.42, 10.42)])).expect("a rhombus");
    let Shape::Rhombus { length, thickness, degrees } = glyph.shape else { unreachable!("it has corners") };
    assert!((length - 2.206).abs() < 0.001 && (thickness - 1.188).abs() < 0.001 && (degrees - 45.0).abs() < 1e-6);
    assert_eq!(glyph.at, MmPoint::new(10.0, 10.0));
}

#[test]
fn what_is_no_glyph_is_none() {
    for corners in [&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)][..], &[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0)]] {
        assert_eq!(glyph(&polygon(corners)), None);
    }
    let ring: Vec<(f32, f32)> = (0..12).map(|i| (i as f32 * std::f32::consts::FRAC_PI_6).sin_cos()).collect();
    assert_eq!(disc(&polygon(&ring)).map(|(_, diameter)| diameter.round()), Some(2.0));
    let oval: Vec<(f32, f32)> = ring.iter().map(|(x, y)| (2.0 * x, *y)).collect();
    assert_eq!(disc(&polygon(&oval)), None);
}
