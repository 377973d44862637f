//! Tests of `choose`.

use super::*;

/// The greatest number of labels that have places together, by trying all.
fn most(costs: &[Vec<f32>], conflict: &dyn Fn(Choice, Choice) -> bool, chosen: &mut Vec<Option<usize>>) -> usize {
    let label = chosen.len();
    if label == costs.len() {
        return chosen.iter().flatten().count();
    }
    chosen.push(None);
    let mut best = most(costs, conflict, chosen);
    for candidate in 0..costs[label].len() {
        let choice = Choice { label, candidate };
        let free = (0..label)
            .all(|other| chosen[other].is_none_or(|candidate| !conflict(choice, Choice { label: other, candidate })));
        if free {
            chosen[label] = Some(candidate);
            best = best.max(most(costs, conflict, chosen));
        }
    }
    chosen.pop();
    best
}

/// On 400 crowded small cases it places 99 % of what could be placed at all, and never puts two in one place.
#[test]
fn nearly_as_many_are_placed_as_can_be() {
    let mut state = 7_u32;
    let mut random = move |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) % below
    };
    let (mut placed, mut possible) = (0, 0);
    for _ in 0..400 {
        let labels = 3 + random(4) as usize;
        let places: Vec<Vec<(i64, i64)>> = (0..labels)
            .map(|_| (0..1 + random(4)).map(|_| (i64::from(random(6)), i64::from(random(6)))).collect())
            .collect();
        let costs: Vec<Vec<f32>> = places.iter().map(|of| (0..of.len()).map(|i| i as f32).collect()).collect();
        let conflict = |a: Choice, b: Choice| {
            let (p, q) = (places[a.label][a.candidate], places[b.label][b.candidate]);
            (p.0 - q.0).abs() < 3 && (p.1 - q.1).abs() < 2
        };
        let chosen = choose(&costs, &conflict);
        let taken = |label: usize| chosen[label].map(|candidate| Choice { label, candidate });
        for (a, b) in (0..labels).flat_map(|a| (0..a).map(move |b| (a, b))) {
            assert!(taken(a).zip(taken(b)).is_none_or(|(a, b)| !conflict(a, b)));
        }
        placed += chosen.iter().flatten().count();
        possible += most(&costs, &conflict, &mut Vec::new());
    }
    assert!(placed * 100 >= possible * 99, "{placed} of {possible}");
}

/// Most of the time of a crowded page went into asking which of all labels stand in the way, where one does.
#[test]
fn of_a_place_that_is_taken_no_more_is_asked_than_which_labels_have_to_move() {
    const PLACED: usize = 80;
    let mut costs = vec![vec![0.0]; PLACED];
    costs.push((0..100_u8).map(f32::from).collect());
    let asked = std::cell::Cell::new(0);
    let chosen = choose(&costs, &|a, b| {
        asked.set(asked.get() + 1);
        a.label == PLACED || b.label == PLACED
    });
    assert_eq!(chosen.iter().flatten().count(), PLACED);
    // each of the first with those before it, and each place of the last: one, three and one once more
    let first = PLACED * (PLACED - 1) / 2;
    assert_eq!(asked.get(), first + 100 * (1 + MOST_MOVED + 1 + 1));
}
