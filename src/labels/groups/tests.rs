//! Tests of `groups`.

use super::*;
use crate::units::{MmPoint, MmVector};

/// A text with its box: its left and upper edge, its width and height, mm.
fn text(text: &str, [x, y, width, height]: [f32; 4]) -> Wanted {
    let corner = MmPoint::new(x, y);
    let anchor = MmRect::new(corner, MmPoint::new(x + width, y + height));
    Wanted { text: text.to_owned(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }
}

fn groups(wanted: &[Wanted]) -> Vec<(GroupDirection, Vec<usize>)> {
    let groups = of(wanted, |_| true, |_| true, |_| true);
    groups.into_iter().map(|group| (group.lies, group.members)).collect()
}

#[test]
fn words_in_a_row_and_numbers_in_a_column_are_groups_in_their_order() {
    let mut wanted: Vec<Wanted> = ["Mon", "Tue", "Wed"]
        .into_iter()
        .zip([70.0, 30.0, 50.0])
        .map(|(day, x)| text(day, [x, 90.0, 8.0, 4.0]))
        .collect();
    // numbers end in line, whatever their lengths
    wanted.extend([(0, 80.0), (50, 60.0), (100, 40.0)].map(|(number, y)| {
        let number = number.to_string();
        let width = 2.0 * number.len() as f32;
        text(&number, [20.0 - width, y, width, 4.0])
    }));
    assert_eq!(
        groups(&wanted),
        [(GroupDirection::Row, vec![1, 2, 0]), (GroupDirection::Column(Edge::Right), vec![5, 4, 3])]
    );
    let all = of(&wanted, |_| true, |_| true, |_| true);
    assert!(all[0].is_beside_column && all[0].steps.is_none());
    assert_eq!(all[1].steps.as_deref(), Some(&[2, 1, 0][..]), "steps of 50, from the top down");
    assert_eq!(all[1].every(2).members, [5, 3]);
}

#[test]
fn two_texts_are_no_group_and_what_is_not_written_is_in_none() {
    let row = |count: usize| -> Vec<Wanted> {
        (0..count).map(|i| text("a", [10.0 * i as f32, 20.0 * i as f32 % 0.5, 3.0, 4.0])).collect()
    };
    assert_eq!(groups(&row(2)), []);
    assert_eq!(groups(&row(4)), [(GroupDirection::Row, vec![0, 1, 2, 3])]);
    let all = of(&row(4), |label| label != 2, |_| true, |_| true);
    assert_eq!(all[0].members, [0, 1, 3]);
}

#[test]
fn two_numbers_are_a_scale_where_both_stand_at_lines() {
    let wanted = [text("0", [14.0, 80.0, 3.0, 4.0]), text("20", [11.0, 20.0, 6.0, 4.0])];
    let scale = of(&wanted, |_| true, |_| true, |_| true);
    assert_eq!((scale.len(), scale[0].steps.as_deref()), (1, Some(&[1, 0][..])));
    assert!(of(&wanted, |_| true, |_| true, |label| label == 0).is_empty());
    let words = [text("oak", [11.0, 80.0, 6.0, 4.0]), text("ash", [11.0, 20.0, 6.0, 4.0])];
    assert!(of(&words, |_| true, |_| true, |_| true).is_empty());
}

#[test]
fn points_are_a_row_only_where_they_are_at_the_lower_side_of_shapes() {
    let points: Vec<Wanted> =
        [0.0, 1.5, 0.8].iter().zip([30.0, 10.0, 20.0]).map(|(y, x)| text("bar", [x, 50.0 + y, 0.0, 0.0])).collect();
    assert_eq!(groups(&points), [(GroupDirection::BelowPoints, vec![1, 2, 0])]);
    assert!(of(&points, |_| true, |_| false, |_| true).is_empty());
}

#[test]
fn numbers_in_even_steps_are_of_a_table_where_each_has_a_cell_with_another_text() {
    // a number in the upper left of each of three cells of 20 mm, with a sign below it
    let number = |i: u8| text(&(3 + i).to_string(), [20.0 * f32::from(i) + 2.0, 2.0, 3.0, 4.0]);
    let sign = |i: u8| text("X", [20.0 * f32::from(i) + 8.0, 10.0, 5.0, 7.0]);
    let cell = |wanted: &[Wanted], label: usize| {
        let left = 20.0 * (wanted[label].anchor.center().x / 20.0).floor();
        MmRect::new(MmPoint::new(left, 0.0), MmPoint::new(left + 20.0, 20.0))
    };
    let is_of_table = |wanted: &[Wanted]| {
        let all = of(wanted, |_| true, |_| true, |_| true);
        let scale = all.iter().find(|group| group.steps.is_some()).expect("numbers in even steps");
        scale.is_of_table(wanted, |label| Some(cell(wanted, label)))
    };
    let table: Vec<Wanted> = (0..3).map(number).chain((0..3).map(sign)).collect();
    assert!(is_of_table(&table));
    assert!(!is_of_table(&table[..5]), "the last one is alone in its square, as those of an axis are");
    let all = of(&table, |_| true, |_| true, |_| true);
    assert!(all.iter().all(|group| !group.is_of_table(&table, |_| None)), "they stand in no cells");
    let wide = MmRect::new(MmPoint::zero(), MmPoint::new(60.0, 20.0));
    let scale = all.iter().find(|group| group.steps.is_some()).expect("numbers in even steps");
    assert!(!scale.is_of_table(&table, |_| Some(wide)), "all are in one frame");
}

/// The boxes of a family tree have names in a row as the cells of a table have, but do not touch one another.
#[test]
fn boxes_that_stand_apart_are_no_cells_of_a_table() {
    let names: Vec<Wanted> =
        ["Otto", "Hilde", "Karl"].iter().zip([5.0, 45.0, 85.0]).map(|(of, x)| text(of, [x, 10.0, 10.0, 4.0])).collect();
    let all = of(&names, |_| true, |_| true, |_| true);
    let is_of_table = |width: f32| {
        let cell = |label: usize| {
            let middle = names[label].anchor.center();
            MmRect::from_points([middle - MmVector::new(0.5 * width, 6.0), middle + MmVector::new(0.5 * width, 6.0)])
        };
        all.iter().all(|group| group.is_of_table(&names, |label| Some(cell(label))))
    };
    assert_eq!(all.len(), 1);
    assert!(is_of_table(39.0), "a line lies between two cells");
    assert!(!is_of_table(28.0), "there is blank between two boxes");
}

#[test]
fn a_power_among_numbers_in_even_steps_is_by_itself() {
    let row = |texts: &[&str]| -> Vec<Wanted> {
        texts.iter().zip([10.0, 20.0, 30.0, 40.0, 50.0, 60.0]).map(|(of, x)| text(of, [x, 90.0, 4.0, 4.0])).collect()
    };
    let scale = |texts: &[&str]| -> Vec<(Vec<usize>, Option<Vec<i64>>)> {
        let groups = of(&row(texts), |_| true, |_| true, |_| true);
        groups.into_iter().map(|group| (group.members, group.steps)).collect()
    };
    let line = ["0", "1", "10\u{b2}", "10\u{b3}", "4", "5"];
    assert_eq!(scale(&line), [(vec![0, 1, 4, 5], Some(vec![0, 1, 4, 5]))]);
    let powers = ["10\u{2070}", "10\u{b9}", "10\u{b2}", "10\u{b3}"];
    assert_eq!(scale(&powers), [(vec![0, 1, 2, 3], Some(vec![0, 1, 2, 3]))]);
    let uneven = ["0", "1", "10\u{b2}", "7", "3"];
    assert_eq!(scale(&uneven), [(vec![0, 1, 2, 3, 4], None)], "without the power they are no scale either");
}
