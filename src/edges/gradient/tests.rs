//! Tests of `gradient`.

use super::*;

#[test]
fn the_tensor_of_an_even_slope_is_exact_inside() {
    let size = Size::new(40, 30);
    let mut rows = 0;
    let mut look = |tensor: &mut TensorRow| {
        if (6..24).contains(&rows) {
            for x in 6..34 {
                assert!((tensor.xx[x] - 9.0).abs() < 1e-2);
                assert!((tensor.xy[x] + 6.0).abs() < 1e-2);
                assert!((tensor.yy[x] - 4.0).abs() < 1e-2);
                assert!((tensor.length[x] - 13_f32.sqrt()).abs() < 1e-2);
            }
        }
        rows += 1;
    };
    let mut gradient = Gradient::new(size, 1, 1.5, 0..30);
    for y in 0..30 {
        let row = (0..40).map(|x| 3.0 * x as f32 - 2.0 * y as f32).collect();
        gradient.push(&[row], &mut look);
    }
    gradient.finish(&mut look);
    assert_eq!(rows, 30);
}
