//! Tests of `params`.

use super::*;

#[test]
fn a_line_of_sure_length_has_a_long_enough_row_wherever_it_lies() {
    assert!((Params::TEST.sure_length() - 8.0).abs() < 1e-6);
    for pitch in [2.0_f32, 2.5, 1.6] {
        let medium = LineMedium::Dots(HeavyStrokes { from: 50.0, width: pitch });
        let params = Params { min_length: 12.5, medium, ..Params::TEST };
        let row = |from: f32, length: f32| ((from + length) / pitch).round() * pitch - (from / pitch).round() * pitch;
        let shortest = |length: f32| (0..20).map(|k| row(0.1 * k as f32, length)).fold(f32::MAX, f32::min);
        assert!(shortest(params.sure_length() + 0.1) >= params.min_length - 1e-3, "{pitch}");
        assert!(shortest(params.sure_length() - 0.5) < params.min_length, "{pitch}");
    }
}

#[test]
fn distances_follow_from_gap_and_widths() {
    let params = Params::TEST;
    assert!((params.max_spacing() - 4.7).abs() < 1e-6 && (params.max_offset() - 2.35).abs() < 1e-6);
    // two lines that are drawn a tolerance nearer each still keep the gap
    assert!(params.clearance(1.0) - 2.0 * params.tolerance >= params.min_gap + 1.0);
    assert!(params.max_clearance() >= params.clearance(0.5 * (params.width_min + params.width_max)));
    // whatever is let through at the least width is let through at any
    assert!(params.min_approach() < params.approach(0.5 * params.width_min, 0.5 * params.width_min));
    assert!(params.approach(0.75, 0.75) < params.max_stub());
    assert!(params.is_dot(14.0) && !params.is_dot(15.0));
}
