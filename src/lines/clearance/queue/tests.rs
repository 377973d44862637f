//! Tests of `queue`.

use super::super::tests::polyline;
use super::*;

#[test]
fn the_most_salient_comes_first_and_what_is_short_or_often_judged_not_at_all() {
    let mut queue = Queue::new(4, Params::TEST.min_length, &Params::TEST);
    let lengths = [12.0, 30.0, 7.0, 30.0];
    let line = |x: f32, round: u8| QueuedLine {
        polyline: polyline(&[(0.0, 0.0), (x, 0.0)], false),
        rank: Rank::Ordinary,
        round,
        is_part: false,
    };
    lengths.iter().zip(0..).for_each(|(&x, round)| queue.push(line(x, round)));
    queue.push(line(90.0, MOST_ROUNDS + 1));
    let order: Vec<(u32, u8)> =
        std::iter::from_fn(|| queue.pop()).map(|line| (line.polyline.length().round() as u32, line.round)).collect();
    assert_eq!(order, [(30, 1), (30, 3), (12, 0)]);
}
