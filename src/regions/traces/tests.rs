//! Tests of `traces`.

use std::ops::Range;

use super::super::trace::TracePoint;
use super::*;
use crate::units::Size;

/// A straight trace to the right, through the middles of some columns of cells.
fn trace(columns: Range<u32>, y: f32, strength: f32) -> TracedContour {
    TracedContour::open(columns.map(|x| TracePoint { at: PxPoint::new(x as f32 + 0.5, y), strength }).collect())
}

/// What passes the cells of a picture of 20 x 10 pixels.
fn map(traces: &[TracedContour]) -> TraceMap {
    TraceMap::of(traces, RegionGrid::new(Size::new(20, 10)))
}

/// What passes a cell.
fn sample_of(map: &TraceMap, cell: u32) -> Option<TraceSample> {
    let [from, to] = [0, 1].map(|i| map.before[cell as usize + i] as usize);
    map.samples[from..to].first().copied()
}

#[test]
fn all_that_is_near_is_found_row_by_row() {
    for width in [5_u32, 64, 65, 150] {
        let starts = (0..width).step_by(9);
        let pieces = starts.flat_map(|x| [2.3, 4.5, 5.7].map(|y| trace(x..(x + 7).min(width), y, 10.0)));
        let map = TraceMap::of(&pieces.collect::<Vec<_>>(), RegionGrid::new(Size::new(width, 10)));
        let has_sample = |x: u32| sample_of(&map, 4 * width + x).is_some();
        assert!(width < 70 || [63, 64, 65].into_iter().all(has_sample) && !has_sample(62), "{width}");
        for half in 0..2 * width + 12 {
            for y in 0..12 {
                let at = PxPoint::new(0.5 * half as f32 - 3.0, y as f32 - 0.75);
                let mut found = Vec::new();
                map.around(at, |sample, square| found.push((*sample, square)));
                let all = map.samples.iter().map(|sample| (*sample, (sample.at - at).square_length()));
                let near: Vec<(TraceSample, f32)> = all.filter(|(_, square)| *square <= REACH * REACH).collect();
                assert_eq!(found, near, "at {at:?} of {width} columns");
            }
        }
    }
}

#[test]
fn the_strongest_trace_of_a_cell_is_kept_whichever_comes_first() {
    let [weak, strong] = [trace(0..20, 5.3, 4.0), trace(0..20, 5.6, 9.0)];
    for traces in [[weak.clone(), strong.clone()], [strong, weak]] {
        let sample = sample_of(&map(&traces), 5 * 20 + 10);
        assert_eq!(sample.map(|sample| (sample.at, sample.strength)), Some((PxPoint::new(10.5, 5.6), 9.0)));
    }
}

#[test]
fn a_trace_is_seen_along_its_direction_and_less_from_further_away() {
    let map = map(&[trace(0..20, 5.5, 10.0)]);
    let [along, across] = [PxVector::new(1.0, 0.0), PxVector::new(0.0, 1.0)];
    let on_it = PxPoint::new(10.5, 5.5);
    let is_strength = |at, tangent, wanted: f32| (map.strength(at, tangent) - wanted).abs() < 1e-4;
    assert!(is_strength(on_it, along, 10.0) && is_strength(on_it, across, 0.0));
    let aside = PxPoint::new(10.5, 7.0);
    assert!(is_strength(aside, along, 10.0 * (-1.5_f32 * 1.5 / FALL).exp()));
    let places = |all: Vec<Seen>| all.iter().map(|seen| seen.at).collect::<Vec<PxPoint>>();
    assert!(places(map.all_seen(aside, along)).contains(&on_it));
    let beyond = PxPoint::new(10.5, 8.5);
    assert!(is_strength(beyond, along, 0.0));
    assert_eq!(places(map.all_seen(beyond, along)), [beyond]);
}

#[test]
fn a_trace_between_two_rows_of_cells_counts_for_both() {
    let strengths = map(&[trace(0..20, 5.0, 10.0)]).strengths();
    let column: Vec<f32> = (3..7).map(|y| strengths.values[y * 20 + 10]).collect();
    assert_eq!(column, [0.0, 5.0, 5.0, 0.0]);
    let in_a_row = map(&[trace(0..20, 5.5, 10.0)]).strengths();
    let column: Vec<f32> = (3..7).map(|y| in_a_row.values[y * 20 + 10]).collect();
    assert_eq!(column, [0.0, 0.0, 10.0, 0.0]);
}
