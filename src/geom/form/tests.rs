//! Tests of `form`.

use super::*;

fn path(points: &[(f32, f32)]) -> Vec<MmPoint> {
    points.iter().map(|&at| MmPoint::from(at)).collect()
}

#[test]
fn an_open_line_has_a_form_and_a_way() {
    let of = |points: &[(f32, f32)]| {
        let path = path(points);
        (OpenForm::of(&path, polyline::length(&path), 1.0).form, from_to(&path))
    };
    assert_eq!(of(&[(10.0, 50.0), (90.0, 52.0)]), (Form::Level, "from left to right"));
    assert_eq!(of(&[(30.0, 90.0), (31.0, 10.0)]), (Form::Upright, "from top to bottom"));
    assert_eq!(of(&[(90.0, 10.0), (10.0, 60.0)]), (Form::Slanting, "from lower left to upper right"));
    // the curve of a chart that rises more and more, and one that falls, rises and falls
    let rises = [(10.0, 90.0), (40.0, 85.0), (70.0, 65.0), (90.0, 20.0)];
    assert_eq!(of(&rises), (Form::Bowed, "from lower left to upper right"));
    let winds = [(10.0, 20.0), (30.0, 50.0), (50.0, 40.0), (90.0, 70.0)];
    assert_eq!(of(&winds), (Form::Winding, "from upper left to lower right"));
    assert_eq!(of(&[(10.0, 10.0), (60.0, 10.0), (60.0, 20.0), (20.0, 20.0)]), (Form::Bent, ""));
    assert_eq!(of(&[]).1, "");
}

#[test]
fn it_is_known_where_a_line_lies_farthest_off() {
    let arc = path(&[(10.0, 50.0), (50.0, 38.0), (90.0, 50.0)]);
    let OpenForm { off, aside, .. } = OpenForm::of(&arc, polyline::length(&arc), 1.0);
    assert!((off - 12.0).abs() < 1e-3 && aside.x.abs() < 1e-3 && (aside.y + 12.0).abs() < 1e-3, "{off} {aside:?}");
}
