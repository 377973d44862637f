use super::*;
use crate::mat::Matrix;

/// Pixels of a picture; `#` is set.
fn bits(rows: &[&str]) -> Bits {
    let set = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
    Bits { width: rows[0].len(), height: rows.len(), set }
}

/// A person who outlined the columns of a picture of 200 x 100 px that are given.
fn person(columns: &[usize]) -> Outlined {
    let values: Vec<u16> = (0..200 * 100).map(|at| u16::from(columns.contains(&(at % 200)))).collect();
    let matrix = Matrix { width: 200, height: 100, values };
    Outlined { boundaries: matrix.clone(), segments: matrix }
}

/// Columns of strength in a picture of 200 x 100 px.
fn map(columns: &[(usize, f32)]) -> StrengthMap {
    let of = |x: usize| columns.iter().find(|(column, _)| *column == x).map_or(0.0, |(_, strength)| *strength);
    StrengthMap { width: 200, height: 100, strengths: (0..200 * 100).map(|at| of(at % 200)).collect() }
}

fn scores_of(map: &StrengthMap, people: &[Outlined]) -> Scores {
    let thresholds = thresholds(&[map]);
    scores(&[counts(map, people, &thresholds)])
}

#[test]
fn what_all_outlined_is_worth_one_and_what_nobody_did_costs_by_its_strength() {
    let people = [person(&[100]), person(&[100])];
    let right_first = scores_of(&map(&[(100, 20.0), (40, 5.0)]), &people);
    assert!((right_first.ods - 1.0).abs() < 1e-9 && (right_first.ois - 1.0).abs() < 1e-9, "{right_first:?}");
    let wrong_first = scores_of(&map(&[(100, 5.0), (40, 20.0)]), &people);
    assert!((wrong_first.ods - 2.0 / 3.0).abs() < 0.01, "half of what is drawn is right: {wrong_first:?}");
    let missed = scores_of(&map(&[(40, 20.0), (60, 5.0)]), &people);
    assert!([missed.ods, missed.ois, missed.ap].iter().all(|score| *score < 1e-9), "{missed:?}");
}

#[test]
fn a_pixel_that_somebody_outlined_makes_one_drawn_pixel_right() {
    let thresholds = [1.0];
    let counted = counts(&map(&[(99, 20.0), (101, 20.0)]), &[person(&[100])], &thresholds);
    assert_eq!(counted, [Counts { drawn: 200, right: 100, wanted: 100, found: 100 }]);
}

#[test]
fn partners_change_so_that_more_pixels_have_one() {
    // the first outlined pixel takes the only drawn one that the second reaches, as that is the nearer of its two
    let drawn = bits(&[".......", "#..#..."]);
    let outlined = bits(&["..#..#.", "......."]);
    let mut offsets = disc(2.3);
    offsets.sort_by_key(|(x, y)| x * x + y * y);
    assert_eq!(matched(&drawn, &outlined, &offsets), [7, 10]);
    assert_eq!(matched(&drawn, &bits(&["..#....", "......."]), &offsets), [10]);
}

#[test]
fn a_bar_is_thinned_to_a_line_of_one_pixel() {
    let bar = bits(&[".........", ".#######.", ".#######.", ".#######.", "........."]);
    let thin = thinned(bar);
    let columns = |x: i64| thin.pixels().filter(|(column, _)| *column == x).count();
    assert!((3..6).all(|x| columns(x) == 1), "{thin:?}");
    assert!(thin.pixels().all(|(_, y)| y == 2), "{thin:?}");
    let line = bits(&[".....", ".###.", "....."]);
    assert_eq!(thinned(line.clone()), line);
}

#[test]
fn contours_are_drawn_by_their_greatest_strength() {
    let mut map = StrengthMap { width: 6, height: 3, strengths: vec![0.0; 18] };
    map.draw((PxPoint::new(0.5, 1.5), 10.0), (PxPoint::new(5.5, 1.5), 10.0));
    map.draw((PxPoint::new(2.5, 0.5), 30.0), (PxPoint::new(2.5, 2.5), 30.0));
    let row: Vec<i32> = map.strengths[6..12].iter().map(|strength| strength.round() as i32).collect();
    assert_eq!(row, [10, 10, 30, 10, 10, 10]);
    assert_eq!(map.above(20.0), bits(&["..#...", "..#...", "..#..."]));
}
