//! Tests of `edge_stopping`.

use super::*;

const SIDE: usize = 12;

/// Light in the left half and dark in the right, with a barrier between them from the top down to the row `end`.
fn scene(end: usize) -> (Barriers, Vec<WeightedColour>) {
    let mut barriers = Barriers { width: SIDE, right: vec![1.0; SIDE * SIDE], down: vec![1.0; SIDE * SIDE] };
    (0..end).for_each(|y| barriers.right[y * SIDE + SIDE / 2 - 1] = 0.01);
    let light = |i: usize| if i % SIDE < SIDE / 2 { 80.0 } else { 20.0 };
    (barriers, (0..SIDE * SIDE).map(|i| [light(i), 0.0, 0.0, 1.0]).collect())
}

fn difference(end: usize, row: usize) -> f32 {
    let (barriers, cells) = scene(end);
    let filtered = barriers.filter(&cells);
    filtered[row * SIDE + SIDE / 2 - 1][0] - filtered[row * SIDE + SIDE / 2][0]
}

#[test]
fn closed_barriers_keep_colours_apart_and_short_ones_do_not() {
    let (closed, short, open) = (difference(SIDE, 2), difference(4, 2), difference(0, 2));
    assert!(closed > 0.9 * 60.0, "{closed} of 60 is left beside a barrier without a gap");
    assert!(short < 0.7 * closed, "{short} beside a short barrier, {closed} beside a whole one");
    assert!(open.abs() < 1e-3, "{open} without a barrier");
}

#[test]
fn mirrored_and_transposed_cells_give_the_mirrored_and_transposed_result() {
    let value = |i: usize| ((i * 7919 + i * i * 31) % 97) as f32;
    let cells: Vec<WeightedColour> = (0..SIDE * SIDE).map(|i| [value(i), value(i + 5), value(i + 9), 1.0]).collect();
    let pass = |i: usize| (-value(i) / 30.0).exp();
    let barriers = Barriers {
        width: SIDE,
        right: (0..SIDE * SIDE).map(|i| pass(i + 1)).collect(),
        down: (0..SIDE * SIDE).map(|i| pass(i + 3)).collect(),
    };
    let filtered = barriers.filter(&cells);
    let map = |to: &dyn Fn(usize, usize) -> usize| -> Vec<usize> {
        (0..SIDE * SIDE).map(|i| to(i % SIDE, i / SIDE)).collect()
    };
    let mirror = map(&|x, y| y * SIDE + SIDE - 1 - x);
    // the barrier between two cells is stored with the left one, which is the other one in the mirrored grid
    let mirrored = Barriers {
        width: SIDE,
        right: map(&|x, y| y * SIDE + (2 * SIDE - 2 - x) % SIDE).iter().map(|&i| barriers.right[i]).collect(),
        down: mirror.iter().map(|&i| barriers.down[i]).collect(),
    };
    let seen: Vec<WeightedColour> = mirrored.filter(&mirror.iter().map(|&i| cells[i]).collect::<Vec<_>>());
    assert_eq!(seen, mirror.iter().map(|&i| filtered[i]).collect::<Vec<_>>(), "mirrored");
    let turn = map(&|x, y| x * SIDE + y);
    let turned = Barriers {
        width: SIDE,
        right: turn.iter().map(|&i| barriers.down[i]).collect(),
        down: turn.iter().map(|&i| barriers.right[i]).collect(),
    };
    let seen: Vec<WeightedColour> = turned.filter(&turn.iter().map(|&i| cells[i]).collect::<Vec<_>>());
    assert_eq!(seen, turn.iter().map(|&i| filtered[i]).collect::<Vec<_>>(), "transposed");
}
