//! Tests of `dashes`.

use super::super::contour::testing::polyline;
use super::*;

const SIGMA: f32 = 1.8;
const LEAST: f32 = 7.0;

fn stroke(from: (f32, f32), to: (f32, f32)) -> FoundContour {
    FoundContour { stroke: Some(2.0), ..FoundContour::edge(polyline(&[from, to])) }
}

/// The ring around a dash from 0 to 10 px, as an edge detector finds it.
fn ring(x: f32, y: f32) -> FoundContour {
    let corners = [(x, y - 2.0), (x + 10.0, y - 2.0), (x + 10.0, y + 2.0), (x, y + 2.0), (x, y - 2.0)];
    let mut contour = polyline(&corners);
    contour.vertices.pop();
    contour.closed = true;
    FoundContour::edge(contour)
}

#[test]
fn dashes_in_a_row_become_one_line_from_the_first_to_the_last() {
    let rings: Vec<FoundContour> = (0..8).map(|k| ring(20.0 + 16.0 * k as f32, 50.0)).collect();
    let (merged, rows) = merged_dashes(rings, SIGMA, LEAST);
    assert_eq!((merged.len(), rows), (1, 1));
    let line = &merged[0].contour;
    let (first, last) = (line.vertices[0].at, line.vertices[line.vertices.len() - 1].at);
    assert!((first.x.min(last.x) - 20.0).abs() < 0.5 && (first.x.max(last.x) - 142.0).abs() < 0.5);
    assert!(line.vertices.iter().all(|vertex| (vertex.at.y - 50.0).abs() < 0.2));
    assert!(merged[0].stroke.is_some_and(|width| (1.0..3.0).contains(&width)));
}

#[test]
fn a_dashed_circle_is_closed() {
    let at = |degrees: f32| {
        let (y, x) = degrees.to_radians().sin_cos();
        (100.0 + 60.0 * x, 100.0 + 60.0 * y)
    };
    let dashes: Vec<FoundContour> = (0..24).map(|k| stroke(at(15.0 * k as f32), at(15.0 * k as f32 + 9.0))).collect();
    let (merged, rows) = merged_dashes(dashes, SIGMA, LEAST);
    assert_eq!((merged.len(), rows), (1, 1));
    let circle = &merged[0].contour;
    assert!(circle.closed && (circle.length() - 377.0).abs() < 4.0, "{}", circle.length());
}

#[test]
fn pieces_of_a_grid_line_between_bars_and_lines_in_a_row_are_no_dashes() {
    let pieces = |length: f32, gap: f32| -> Vec<FoundContour> {
        let piece = |k: i32| {
            let x = 20.0 + k as f32 * (length + gap);
            stroke((x, 50.0), (x + length, 50.0))
        };
        (0..5).map(piece).collect()
    };
    assert_eq!(merged_dashes(pieces(20.0, 14.0), SIGMA, LEAST).1, 1, "with nothing between them they are dashes");
    let bars = (0..5).flat_map(|k| {
        let x = 41.0 + k as f32 * 34.0;
        [stroke((x, 20.0), (x, 120.0)), stroke((x + 12.0, 20.0), (x + 12.0, 120.0))]
    });
    let (all, rows) = merged_dashes(pieces(20.0, 14.0).into_iter().chain(bars).collect(), SIGMA, LEAST);
    assert_eq!((all.len(), rows), (15, 0));
    assert_eq!(merged_dashes(pieces(60.0, 20.0), SIGMA, LEAST).1, 0, "too long");
    assert_eq!(merged_dashes(pieces(10.0, 30.0), SIGMA, LEAST).1, 0, "too far apart");
}

#[test]
fn a_dashed_line_ends_on_what_its_last_dash_touches() {
    let base = stroke((10.0, 20.0), (10.0, 80.0));
    let rings = (0..5).map(|k| ring(24.0 + 16.0 * k as f32, 50.0)).chain([base]).collect();
    let (merged, rows) = merged_dashes(rings, SIGMA, LEAST);
    assert_eq!((merged.len(), rows), (2, 1));
    let reach = |pick: fn(f32, f32) -> f32, from: f32| {
        merged[1].contour.vertices.iter().map(|vertex| vertex.at.x).fold(from, pick)
    };
    assert!((reach(f32::min, 200.0) - 10.0).abs() < 0.1, "it meets the base, 14 px before the first dash");
    assert!((reach(f32::max, 0.0) - 98.0).abs() < 0.5, "and ends where nothing is");
}

#[test]
fn dots_and_uneven_pieces_are_no_dashes() {
    let uneven = [(20.0, 30.0), (36.0, 60.0), (66.0, 76.0), (82.0, 118.0), (124.0, 134.0)];
    let pieces = uneven.iter().map(|&(from, to)| stroke((from, 50.0), (to, 50.0))).collect();
    assert_eq!(merged_dashes(pieces, SIGMA, LEAST).1, 0);
    let aside = (0..6).map(|k| ring(20.0, 20.0 + 14.0 * k as f32)).collect();
    assert_eq!(merged_dashes(aside, SIGMA, LEAST).1, 0, "beside one another, as steps of a ladder");
}

#[test]
fn what_is_too_short_for_a_stroke_stays_in_a_row_of_such() {
    let left = |count: usize, apart: f32| {
        let stroke = |[x, y, length]: [f32; 3], is_dash: bool| {
            let contour = polyline(&[(x, y), (x + length, y)]);
            Stroke { whole: contour.length(), contour, width: 1.6, is_dash, tint: None }
        };
        let dashes = (0..count).map(|k| stroke([20.0 + apart * k as f32, 50.0, 7.0], true));
        let strokes: Vec<Stroke> = dashes.chain([stroke([20.0, 80.0, 30.0], false)]).collect();
        without_loose(strokes, LEAST).len()
    };
    assert_eq!(left(6, 10.0), 7);
    assert_eq!(left(3, 10.0), 1, "too few");
    assert_eq!(left(6, 30.0), 1, "too far from one another");
}

#[test]
fn a_ring_of_dashes_has_as_many_gaps_as_dashes_and_an_open_row_one_less() {
    let at = |degrees: f32| {
        let (y, x) = degrees.to_radians().sin_cos();
        (100.0 + 60.0 * x, 100.0 + 60.0 * y)
    };
    let gaps = |count: usize| {
        let found: Vec<FoundContour> =
            (0..count).map(|k| stroke(at(15.0 * k as f32), at(15.0 * k as f32 + 9.0))).collect();
        let dashes: Vec<Dash> = (0..).zip(&found).filter_map(|(number, of)| dash(number, of, SIGMA, LEAST)).collect();
        let rows = rows(&dashes, LEAST);
        let [row] = &rows[..] else { panic!("{} rows", rows.len()) };
        let chord = |degrees: f32| 120.0 * (0.5 * degrees).to_radians().sin();
        assert!(row.gap_lengths().all(|length| (length - chord(6.0)).abs() < 0.05), "{:?}", row.gaps);
        assert!((row.period() - chord(6.0) - chord(9.0)).abs() < 0.1, "{}", row.period());
        (row.gaps.len(), row.closed)
    };
    assert_eq!(gaps(24), (24, true));
    assert_eq!(gaps(20), (19, false));
}

/// Dashes of 9 px with gaps of 5, by their numbers, to the right from here.
fn to_the_right(numbers: &[u32]) -> Vec<FoundContour> {
    let at = |k: u32| 20.0 + 14.0 * k as f32;
    numbers.iter().map(|&k| stroke((at(k), 100.0), (at(k) + 9.0, 100.0))).collect()
}

#[test]
fn a_row_goes_on_beyond_a_dash_that_is_one_with_a_line_across() {
    let with_line = |x: f32| {
        let mut found = to_the_right(&[0, 1, 2, 3, 4, 6, 7]);
        found.push(stroke((x, 50.0), (x, 150.0)));
        let (merged, rows) = merged_dashes(found, SIGMA, LEAST);
        (merged.len(), rows, merged.iter().map(|found| found.contour.length().round()).fold(0.0, f32::max))
    };
    assert_eq!(with_line(94.0), (2, 1, 107.0));
    assert_eq!(with_line(200.0).0, 4, "nothing is in place of the one that is missing");
}

#[test]
fn rows_that_make_a_corner_meet_there() {
    let mut found = to_the_right(&[0, 1, 2, 3, 4]);
    found.extend((0..5).map(|k| 108.0 + 14.0 * k as f32).map(|y| stroke((95.0, y), (95.0, y + 9.0))));
    let corners = |found: Vec<FoundContour>| {
        let (merged, rows) = merged_dashes(found, SIGMA, LEAST);
        assert_eq!((merged.len(), rows), (2, 2));
        let is_corner = |point: Option<&ContourPoint>| {
            point.is_some_and(|point| (point.at - PxPoint::new(95.0, 100.0)).length() < 0.1)
        };
        let vertices = merged.iter().map(|found| &found.contour.vertices);
        vertices.filter(|vertices| is_corner(vertices.first()) || is_corner(vertices.last())).count()
    };
    assert_eq!(corners(found.clone()), 2);
    // the dash that is bent there is theirs
    let bent = polyline(&[(91.0, 100.0), (95.0, 100.0), (95.0, 104.0)]);
    found.push(FoundContour { stroke: Some(2.0), ..FoundContour::edge(bent) });
    assert_eq!(corners(found), 2);
}
