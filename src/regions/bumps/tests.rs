//! Bumps whose sides nobody sees go; other shapes stay.

use super::*;

/// Steps right, up or down along a border of so many cells each, and what is seen there.
fn border(steps: &[(char, usize, f32)]) -> (Vec<PxPoint>, Vec<f32>) {
    let mut at = PxPoint::new(0.0, 50.0);
    let (mut points, mut strengths) = (Vec::new(), Vec::new());
    for &(direction, count, strength) in steps {
        for _ in 0..count {
            points.push(at);
            strengths.push(strength);
            match direction {
                'r' => at.x += 1.0,
                'l' => at.x -= 1.0,
                'u' => at.y -= 1.0,
                _ => at.y += 1.0,
            }
        }
    }
    (points, strengths)
}

/// Heights of the vertices above the line at 50 once bumps are out, with a third of a millimetre for a cell.
fn heights(steps: &[(char, usize, f32)]) -> Vec<i32> {
    let (points, strengths) = border(steps);
    let places = Places { points: &points, strengths: &strengths, closed: false, mm: 0.333 };
    places.without_bumps().iter().map(|at| (50.0 - at.y).round() as i32).collect()
}

#[test]
fn a_bump_without_seen_sides_becomes_straight() {
    let up = [('r', 20, 20.0), ('u', 5, 3.0), ('r', 10, 18.0), ('d', 5, 3.0), ('r', 20, 20.0)];
    assert!(heights(&up).iter().all(|height| *height == 0), "{:?}", heights(&up));
    let down = [('r', 20, 20.0), ('d', 5, 3.0), ('r', 10, 18.0), ('u', 5, 3.0), ('r', 20, 20.0)];
    assert!(heights(&down).iter().all(|height| *height == 0), "{:?}", heights(&down));
}

#[test]
fn what_has_sides_or_is_large_or_leads_elsewhere_stays() {
    let highest = |steps: &[(char, usize, f32)]| heights(steps).into_iter().max();
    let tower = [('r', 20, 20.0), ('u', 5, 20.0), ('r', 10, 20.0), ('d', 5, 20.0), ('r', 20, 20.0)];
    assert_eq!(highest(&tower), Some(5), "its sides are seen");
    let long = [('r', 40, 20.0), ('u', 5, 3.0), ('r', 50, 20.0), ('d', 5, 3.0), ('r', 40, 20.0)];
    assert_eq!(highest(&long), Some(5), "17 mm long");
    let high = [('r', 20, 20.0), ('u', 9, 3.0), ('r', 10, 20.0), ('d', 9, 3.0), ('r', 20, 20.0)];
    assert_eq!(highest(&high), Some(9), "3 mm high");
    let stair = [('r', 20, 20.0), ('u', 5, 3.0), ('r', 20, 20.0)];
    assert_eq!(highest(&stair), Some(5), "it does not come back");
    let stairs = [('r', 20, 20.0), ('u', 5, 3.0), ('r', 10, 20.0), ('u', 5, 3.0), ('r', 20, 20.0)];
    assert_eq!(highest(&stairs), Some(10), "two stairs are no bump");
}

#[test]
fn of_battlements_those_that_are_shorter_than_the_gaps_go() {
    let mut steps = vec![('r', 20, 20.0)];
    for _ in 0..2 {
        steps.extend([('u', 5, 3.0), ('r', 10, 18.0), ('d', 5, 3.0), ('r', 20, 20.0)]);
    }
    assert!(heights(&steps).iter().all(|height| *height == 0), "{:?}", heights(&steps));
}

#[test]
fn it_is_the_same_wherever_a_ring_begins() {
    let mut steps = vec![('r', 20, 20.0), ('u', 5, 3.0), ('r', 10, 18.0), ('d', 5, 3.0), ('r', 20, 20.0)];
    steps.extend([('d', 40, 20.0), ('l', 50, 20.0), ('u', 40, 20.0)]);
    let (points, strengths) = border(&steps);
    let n = points.len();
    let from = |start: usize| {
        let turned = |i: usize| (i + start) % n;
        let points: Vec<PxPoint> = (0..n).map(|i| points[turned(i)]).collect();
        let strengths: Vec<f32> = (0..n).map(|i| strengths[turned(i)]).collect();
        let places = Places { points: &points, strengths: &strengths, closed: true, mm: 0.333 };
        places.without_bumps().iter().map(|at| at.y).fold(f32::MAX, f32::min)
    };
    for start in [0, 18, 22, 30, 38, 60, 100] {
        assert!((from(start) - 50.0).abs() < 0.01, "from vertex {start} on the ring goes up to {}", from(start));
    }
}
