//! Junctions of contours, in all their forms.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::super::contour::testing::{circle, polyline};
use super::*;

const SIZE: Size = Size { width: 100, height: 100 };

/// The contours with their ends extended.
fn extended(contours: &[Contour]) -> Vec<Contour> {
    let mut contours = contours.to_vec();
    extend(&mut contours, SIZE, &|_, _, _| true);
    contours
}

/// Two strokes that meet at 24 degrees, as they are found: through the middle of the thick spot where they meet.
fn connector() -> [Contour; 2] {
    let base = polyline(&[(5.0, 50.0), (42.0, 50.0), (48.0, 52.0), (49.0, 52.0), (55.0, 50.0), (95.0, 50.0)]);
    [base, polyline(&[(49.0, 52.5), (90.0, 70.8)])]
}

#[test]
fn a_straight_line_stays_straight_where_another_ends_on_it() {
    for turn in 0..2 {
        let mut contours = connector();
        if turn == 1 {
            contours[1].reverse();
        }
        straighten(&mut contours, SIZE);
        let off = contours[0].vertices.iter().map(|point| (point.at.y - 50.0).abs()).fold(0.0, f32::max);
        assert!(off < 0.1, "{off} px off");
        let in_order = |contour: &Contour| contour.vertices.windows(2).all(|pair| pair[1].at.x > pair[0].at.x);
        assert!(in_order(&contours[0]), "its vertices stay in order");
    }
    // a corner of its own is none that another made, nor is what no other one comes near
    let corner = polyline(&[(5.0, 50.0), (50.0, 50.0), (80.0, 80.0)]);
    let mut contours = [corner.clone(), polyline(&[(50.0, 48.0), (50.0, 10.0)])];
    straighten(&mut contours, SIZE);
    assert_eq!(contours[0], corner);
    let mut alone = [connector()[0].clone(), polyline(&[(49.0, 70.0), (90.0, 90.0)])];
    straighten(&mut alone, SIZE);
    assert_eq!(alone[0], connector()[0]);
}

#[test]
fn an_end_that_runs_along_another_contour_is_cut_off_where_it_comes_onto_it() {
    let base = polyline(&[(5.0, 50.0), (95.0, 50.0)]);
    let hook = polyline(&[(90.0, 70.8), (46.0, 50.6), (46.0, 50.3), (62.0, 50.3)]);
    for reversed in [false, true] {
        let mut contours = [base.clone(), hook.clone()];
        if reversed {
            contours[1].reverse();
        }
        trim(&mut contours, SIZE);
        assert_eq!(contours[0], base, "the other one stays");
        let most = contours[1].vertices.iter().filter(|point| point.at.y < 51.0).map(|point| point.at.x);
        assert!(most.fold(0.0, f32::max) < 48.0, "the hook is gone");
        assert!((contours[1].length() - 48.4).abs() < 1.0, "and no more: {}", contours[1].length());
    }
    // one that ends on it, and one that lies along it as a whole, are left
    for other in [polyline(&[(50.0, 90.0), (50.0, 50.2)]), polyline(&[(20.0, 50.5), (60.0, 50.5)])] {
        let mut contours = [base.clone(), other];
        let before = contours.clone();
        trim(&mut contours, SIZE);
        assert_eq!(contours, before);
    }
}

#[test]
fn of_two_ends_that_overlap_one_stays() {
    let mut contours = [polyline(&[(5.0, 50.0), (60.0, 50.0)]), polyline(&[(45.0, 50.4), (95.0, 50.4)])];
    trim(&mut contours, SIZE);
    let covered = |x: f32| {
        contours
            .iter()
            .any(|contour| contour.vertices.windows(2).any(|pair| (pair[0].at.x..=pair[1].at.x).contains(&x)))
    };
    assert!((6..95).all(|x| covered(x as f32)), "no gap is left between them");
}

#[test]
fn an_end_before_another_contour_is_extended_to_it() {
    let bar = polyline(&[(50.0, 20.0), (50.0, 80.0)]);
    let stem = polyline(&[(20.0, 50.3), (47.0, 50.3)]);
    for stem in [stem.clone(), stem.clone().reversed()] {
        let found = extended(&[bar.clone(), stem.clone()]);
        assert_eq!(found[0], bar, "the other contour stays");
        let ends = [0, found[1].vertices.len() - 1].map(|k| found[1].vertices[k]);
        let tip = if ends[0].at.x > ends[1].at.x { ends[0] } else { ends[1] };
        assert!((tip.at - PxPoint::new(50.0, 50.3)).length() < 1e-3, "{:?}", tip.at);
        let unchanged = tip.contrast.iter().zip(stem.vertices[0].contrast).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(unchanged, "{:?}", tip.contrast);
        assert!((found[1].length() - 30.0).abs() < 1e-3, "{}", found[1].length());
    }
}

#[test]
fn an_end_that_may_not_be_led_to_another_contour_stays() {
    let wall = |x: f32| polyline(&[(x, 20.0), (x, 80.0)]);
    // through the first of two it is not led to the other
    let contours = [wall(50.0), polyline(&[(20.0, 50.3), (47.0, 50.3)]), wall(50.5)];
    let (mut left, asked) = (contours.clone(), AtomicUsize::new(0));
    extend(&mut left, SIZE, &|number, other, [from, to]| {
        assert!((number, other) == (1, 0) && (to - from).length() < 3.1, "{number} to {other}: {from:?} to {to:?}");
        asked.fetch_add(1, Ordering::Relaxed);
        false
    });
    assert_eq!((left, asked.into_inner()), (contours, 1));
}

#[test]
fn a_bent_end_is_straightened_first() {
    let mut stem = polyline(&[(20.0, 50.0), (48.0, 50.0)]);
    let n = stem.vertices.len();
    stem.vertices[n - 1].at.y = 51.0;
    let found = extended(&[polyline(&[(50.0, 20.0), (50.0, 80.0)]), stem]);
    assert!(found[1].vertices.iter().all(|point| (point.at.y - 50.0).abs() < 1e-3), "{:?}", found[1].vertices);
    assert!((found[1].length() - 30.0).abs() < 1e-3);
}

#[test]
fn ends_that_are_far_away_or_parallel_and_closed_contours_stay() {
    let bar = polyline(&[(50.0, 20.0), (50.0, 80.0)]);
    let far = polyline(&[(10.0, 50.0), (40.0, 50.0)]);
    let parallel = polyline(&[(47.0, 10.0), (47.0, 40.0)]);
    let away = polyline(&[(52.0, 50.0), (53.0, 50.0), (53.0, 90.0)]);
    for other in [far, parallel, circle(2.0)] {
        let contours = [bar.clone(), other];
        assert_eq!(extended(&contours), contours);
    }
    let found = extended(&[bar.clone(), away.clone()]);
    let last = away.vertices.len() - 1;
    assert_eq!(found[1].vertices[found[1].vertices.len() - 1], away.vertices[last], "it points at nothing");
}
