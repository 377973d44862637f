//! Tests of `faint`.

use super::*;
use crate::edges::{ChainKind, Edgel, Edges};
use crate::lines::{Lines, draw};
use crate::units::{MmRect, PageTransform, PxPoint, Size};

/// A stroke with whether it is faint, its strength and its corners, in px.
type TestStroke<'a> = (bool, f32, &'a [(f32, f32)]);

/// A drawing of strokes; two px are a millimetre.
fn drawn(strokes: &[TestStroke<'_>]) -> Lines {
    let size = Size::new(300, 200);
    let mut edges = Edges::none(size);
    for &(faint, strength, corners) in strokes {
        let kind = ChainKind { exact: true, of_drawing: true, stroke: Some(2.0), faint, ..ChainKind::default() };
        let edgel = |&(x, y): &(f32, f32)| Edgel { at: PxPoint::new(x, y), strength, contrast: [0.0; 3] };
        edges.push_as(kind, corners.iter().map(edgel), false);
    }
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 100.0));
    draw(&edges, &PageTransform::new(size, area), area, &Params { of_drawing: true, ..Params::TEST })
}

const CURVE: &[(f32, f32)] = &[(20.0, 120.0), (100.0, 60.0), (180.0, 104.0), (280.0, 20.0)];
const GRID: &[(f32, f32)] = &[(20.0, 110.0), (280.0, 110.0)];

fn longest(lines: &Lines, is_thin: bool) -> Vec<f32> {
    let width = if is_thin { Params::TEST.width_min } else { Params::TEST.width_max };
    let is_so = |of: f32| (of - width).abs() < 0.01;
    let lines = lines.lines.iter().filter(|line| line.runs.iter().all(|run| is_so(run.width)));
    lines.map(crate::lines::Line::length).collect()
}

#[test]
fn lines_as_weak_as_contours_may_be_are_weak_whatever_the_strongest_is() {
    let line = |strength: f32| Line { strength, runs: Vec::new() };
    let weak = |strongest: f32| which_are_weak(&[line(strongest), line(7.0), line(7.1), line(12.0)], 7.0);
    assert_eq!(weak(100.0), [false, true, true, false]);
    assert_eq!(weak(30.0), [false, true, false, false]);
}

#[test]
fn a_pale_thin_grid_is_thin_and_gives_way_to_the_curve() {
    let whole: f32 = CURVE.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1) / 2.0).sum();
    let grid_first = drawn(&[(true, 25.0, GRID), (false, 90.0, CURVE)]);
    let [curve] = longest(&grid_first, false)[..] else { panic!("{grid_first:?}") };
    assert!((curve - whole).abs() < 0.5, "{curve} of {whole} mm");
    let grid = longest(&grid_first, true);
    // the piece below the dip of the curve is gone, and no scrap is left
    assert!(!grid.is_empty() && grid.iter().all(|length| *length >= 12.0), "{grid:?}");
    assert!(grid_first.lost.lost > 5.0, "and told");
}

#[test]
fn short_pieces_of_cut_faint_lines_are_left_out_and_whole_ones_and_others_stay() {
    let vertex = |x: f32| Vertex { at: MmPoint::new(x, 50.0), ..Vertex::TEST };
    let line = |from: f32, to: f32| Polyline::open(vec![vertex(from), vertex(to)]);
    let least = SCRAP * Params::TEST.min_length;
    // one of 80 mm, and one of half the least length
    let lines = [(line(10.0, 90.0), Rank::Faint), (line(110.0, 110.0 + 0.5 * least), Rank::Faint)];
    let stays = |from: f32, to: f32, rank: Rank| {
        let polyline = line(from, to);
        let anchored = vec![false; polyline.vertices.len()];
        let mut cleared = vec![Cleared { polyline, saliency: 1.0, rank, anchored }];
        drop_short_faint(&mut cleared, &lines, &Params::TEST);
        cleared.len() == 1
    };
    assert!(stays(30.0, 30.0 + 1.1 * least, Rank::Faint));
    assert!(!stays(30.0, 30.0 + 0.9 * least, Rank::Faint), "a piece between two cuts");
    assert!(!stays(10.0, 10.0 + 0.9 * least, Rank::Faint), "one at an end of its line");
    assert!(stays(110.0, 110.0 + 0.5 * least, Rank::Faint), "a whole line");
    assert!(stays(30.0, 30.0 + 0.5 * least, Rank::Ordinary));
}
