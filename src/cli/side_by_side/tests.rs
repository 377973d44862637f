//! Tests of `side_by_side`.

use super::*;
use std::time::Duration;

fn squares(count: usize, workers: usize) -> Vec<(usize, Result<usize, Panicked>)> {
    let mut results = Vec::new();
    let mut ended = 0;
    let job = |index: usize| {
        // Late ones first, so that the order has to be restored.
        thread::sleep(Duration::from_millis(if index.is_multiple_of(3) { 5 } else { 0 }));
        assert!(index != 4, "job 4 fails on purpose");
        index * index
    };
    run(count, workers, job, || ended += 1, |index, result| results.push((index, result)));
    assert_eq!(ended, count);
    results
}

#[test]
fn results_come_in_order_and_a_panic_stops_only_its_own_job() {
    for workers in [1, 2, 5] {
        let expected = (0..9).map(|i| (i, if i == 4 { Err(Panicked) } else { Ok(i * i) })).collect::<Vec<_>>();
        assert_eq!(squares(9, workers), expected, "{workers} workers");
    }
}

#[test]
fn no_jobs_and_one_job() {
    assert_eq!(squares(0, 4), []);
    assert_eq!(squares(1, 4), [(0, Ok(0))]);
}

#[test]
fn never_more_workers_than_jobs() {
    assert_eq!(workers(1), 1);
    assert!((1..=2).contains(&workers(2)) && (1..=1000).contains(&workers(1000)));
}
