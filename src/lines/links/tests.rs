//! Tests of `links`.

use super::*;
use crate::lines::clearance::tests::polyline;
use crate::lines::outlines::Rank;
use crate::lines::tests::area;

#[test]
fn a_link_is_straight_and_has_a_least_length() {
    let params = Params { of_drawing: true, ..Params::TEST };
    let can_be = |points: &[(f32, f32)]| can_be(&polyline(points, false), &params);
    let lengths = [3.9, 4.1, 7.9, 8.1].map(|length| can_be(&[(10.0, 50.0), (10.0 + length, 50.0)]));
    assert_eq!(lengths, [false, true, true, false]);
    assert!(!can_be(&[(10.0, 50.0), (13.0, 50.0), (13.0, 53.0)]), "bent");
    let of_photograph = Params { of_drawing: false, ..params };
    assert!(!super::can_be(&polyline(&[(10.0, 50.0), (16.0, 50.0)], false), &of_photograph));
    let bond = polyline(&[(40.0, 50.0), (40.0, 44.0)], false);
    let overview = Params { part: PagePart::Overview, ..params };
    let is_piece = [&params, &overview].map(|params| is_piece(&bond, params, |_| true));
    assert_eq!(is_piece, [true, false]);
    assert!(!super::is_piece(&bond, &params, |at| at.y > 45.0), "one end is free");
}

#[test]
fn what_leads_from_line_to_line_is_taken_unless_it_is_a_remnant() {
    let params = Params { of_drawing: true, ..Params::TEST };
    let lines = [polyline(&[(10.0, 50.0), (90.0, 50.0)], false), polyline(&[(10.0, 44.0), (90.0, 44.0)], false)];
    let bond = polyline(&[(40.0, 49.0), (40.0, 44.0)], false);
    let loose = polyline(&[(60.0, 50.0), (60.0, 56.0)], false);
    let remnant = polyline(&[(80.0, 50.0), (80.0, 44.0)], false);
    let whole = short_ones(&[bond.clone(), loose.clone(), lines[0].clone()], area(), &params).expect("there are two");
    let mut short = vec![bond.clone(), loose.clone(), remnant.clone()];
    assert_eq!(take(&mut short, &lines, &whole, area(), &params), [bond]);
    assert_eq!(short, [loose, remnant]);
    assert!(short_ones(&lines, area(), &params).is_none());
}

#[test]
fn a_link_goes_with_the_line_that_it_led_to() {
    let params = Params { of_drawing: true, ..Params::TEST };
    let cleared = |points: &[(f32, f32)]| {
        let polyline = polyline(points, false);
        let anchored = vec![false; polyline.vertices.len()];
        Cleared { polyline, saliency: 1.0, rank: Rank::Ordinary, anchored }
    };
    let one = cleared(&[(10.0, 50.0), (90.0, 50.0)]);
    let (other, bond) = (cleared(&[(10.0, 44.0), (90.0, 44.0)]), cleared(&[(40.0, 50.0), (40.0, 44.0)]));
    let mut all = vec![&one, &other, &bond];
    drop_loose(&mut all, area(), &params);
    assert_eq!(all.len(), 3);
    let mut rest = vec![&one, &bond];
    drop_loose(&mut rest, area(), &params);
    assert_eq!(rest.len(), 1);
}
