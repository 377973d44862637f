//! Tests of `path_order`.

use super::*;

/// Dots of a picture in characters, 1 mm apart; letters give the order.
fn dots(picture: &str) -> Vec<DotPosition> {
    let rows = picture.split_whitespace().enumerate();
    let mut dots: Vec<_> = rows
        .flat_map(|(y, row)| row.bytes().enumerate().map(move |(x, letter)| (letter, [x as i32 * 100, y as i32 * 100])))
        .filter(|(letter, _)| *letter != b'.')
        .collect();
    dots.sort_unstable();
    dots.into_iter().map(|(_, position)| position).collect()
}

/// The largest drop of the second coordinate from any dot to any later one.
fn pulled_back(path: &[DotPosition]) -> i32 {
    let drop = |(i, dot): (usize, &DotPosition)| path[i..].iter().map(|later| dot[1] - later[1]).max();
    path.iter().enumerate().filter_map(drop).max().unwrap_or(0)
}

#[test]
fn the_nearest_comes_next_unless_it_leaves_another_too_far_behind() {
    for (picture, most_back) in [("a..c b... ....", i32::MAX), ("a..b c... ....", 0)] {
        let sorted = sorted(&dots(picture));
        let path = nearest_neighbour(&sorted, [0, 0], most_back);
        assert_eq!(path.iter().map(|&dot| sorted[dot as usize]).collect::<Vec<_>>(), dots(picture));
    }
}

#[test]
fn paper_is_pulled_back_as_far_as_is_allowed_and_no_farther() {
    let picture = "a.f b.e c.d";
    let ends = [[0, 0], [200, 0]];
    assert_eq!(order(&dots(picture), ends, 200), dots(picture));
    assert_eq!(pulled_back(&dots(picture)), 200);
    for back in [0, 50, 199] {
        assert!(pulled_back(&order(&dots(picture), ends, back)) <= back);
    }
}

#[test]
fn the_farthest_positions_there_are() {
    let far = [[i32::MIN, i32::MIN], [i32::MAX, i32::MAX], [i32::MIN, i32::MAX], [0, 0], [i32::MAX, i32::MIN]];
    for back in [i32::MIN, 0, i32::MAX - 1, i32::MAX] {
        let path = order(&far, [[i32::MIN, 0], [i32::MAX, 0]], back);
        assert_eq!(sorted(&path), sorted(&far));
    }
}
