//! Tests of `hysteresis`.

use super::*;

/// The pieces of a chain with the given strengths; low is 3, high is 6.
fn pieces_of(strengths: &[u8], closed: bool) -> Vec<(Vec<usize>, bool)> {
    let strengths: Vec<f32> = strengths.iter().map(|&s| f32::from(s)).collect();
    pieces(&strengths, closed, 3.0, 6.0).into_iter().map(|piece| (piece.vertices, piece.closed)).collect()
}

#[test]
fn a_run_above_low_is_kept_whole_if_it_reaches_high() {
    assert_eq!(pieces_of(&[4, 3, 6, 4, 1, 5, 5, 2, 7], false), [(vec![0, 1, 2, 3], false), (vec![8], false)]);
    assert_eq!(pieces_of(&[3, 4, 5], false), [], "high is never reached");
    assert_eq!(pieces_of(&[1, 2, 1], false), [], "low is never reached");
}

#[test]
fn a_closed_chain_stays_closed_if_it_is_strong_all_round_and_has_no_seam() {
    assert_eq!(pieces_of(&[4, 6, 4, 5], true), [(vec![0, 1, 2, 3], true)]);
    assert_eq!(pieces_of(&[4, 6, 1, 5, 3], true), [(vec![3, 4, 0, 1], false)]);
    assert_eq!(pieces_of(&[7, 1, 1, 1], true), [(vec![0], false)], "a run of one point at the seam");
}

#[test]
fn the_position_error_grows_with_noise_and_blur_and_falls_with_height() {
    let point = |height, blur| {
        let profile =
            crate::edges::ridge::EdgeProfile { maximum: 1.0, curvature: 1.0, pedestal: [0.0; 2], distance: 4.5 };
        RidgePoint { at: PxPoint::zero(), normal: PxVector::new(1.0, 0.0), profile, height, blur, column: 0, row: 0 }
    };
    let sigma = position_sigma(1.0, &point(20.0, 1.5), 1.5);
    assert!((sigma - 0.0306).abs() < 1e-4, "{sigma}");
    for (other, factor) in [
        (position_sigma(2.0, &point(20.0, 1.5), 1.5), 2.0),
        (position_sigma(1.0, &point(40.0, 1.5), 1.5), 0.5),
        (position_sigma(1.0, &point(20.0, 3.0), 1.5), 8.0),
    ] {
        assert!((other / sigma - factor).abs() < 1e-4, "{other} is not {factor} times {sigma}");
    }
}
