//! Which areas of a figure an overview has.

use super::*;
use crate::lines::{Height, Run};
use crate::units::MmVector;

const FIGURE: MmRect = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(120.0, 80.0));
const OVERVIEW: MmRect = MmRect::new(MmPoint::new(50.0, 100.0), MmPoint::new(100.0, 130.0));

/// Lines in a part of the page, whose points are shares of it.
fn lines(part: MmRect, paths: &[&[(f32, f32)]]) -> Vec<Line> {
    let at = |&(x, y): &(f32, f32)| part.min + MmVector::new(x * part.width(), y * part.height());
    let line =
        |path: &&[(f32, f32)]| Line { strength: 90.0, runs: vec![Run::stroke(1.0, path.iter().map(at).collect())] };
    paths.iter().map(line).collect()
}

/// How many areas the figure has, and how many of them the overview has not.
fn missing(figure: &[&[(f32, f32)]], overview: &[Line]) -> (usize, usize) {
    let cells = Cells::of(OVERVIEW);
    let of_figure = cells.areas(lines(FIGURE, figure).iter(), FIGURE, 0.0);
    let of_overview = cells.areas(overview.iter(), OVERVIEW, 2.5);
    let enclosed: Vec<&[usize]> = of_figure.enclosed(ROOM / cells.side_in(FIGURE)).collect();
    (enclosed.len(), of_figure.missing(&of_overview, &enclosed).len())
}

const BOX: &[(f32, f32)] = &[(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.1, 0.9), (0.1, 0.1)];
const LEFT: &[(f32, f32)] = &[(0.35, 0.1), (0.35, 0.9)];
const RIGHT: &[(f32, f32)] = &[(0.65, 0.1), (0.65, 0.9)];

#[test]
fn an_area_that_is_one_with_its_neighbour_or_open_is_missing() {
    let figure = [BOX, LEFT, RIGHT];
    let with = |paths: &[&[(f32, f32)]]| missing(&figure, &lines(OVERVIEW, paths));
    assert_eq!(with(&figure), (3, 0));
    assert_eq!(with(&[BOX, LEFT]), (3, 1));
    assert_eq!(with(&[BOX]), (3, 2));
    // moved by two millimetres of the overview
    assert_eq!(with(&[BOX, &[(0.39, 0.1), (0.39, 0.9)], RIGHT]), (3, 0));
    let open: &[(f32, f32)] = &[(0.1, 0.2), (0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.1, 0.9), (0.1, 0.4)];
    assert_eq!(with(&[open, LEFT, RIGHT]), (3, 1));
    assert_eq!(with(&[]), (3, 3));
    // one that has most of the figure
    assert_eq!(missing(&[BOX], &lines(OVERVIEW, &[])), (1, 1));
    assert_eq!(missing(&[BOX], &lines(OVERVIEW, &[open])), (1, 1));
    assert_eq!(missing(&[BOX], &lines(OVERVIEW, &[BOX])), (1, 0));
}

#[test]
fn lines_of_dots_close_areas() {
    let dots = |path: &[(f32, f32)]| {
        let at = |(x, y): (f32, f32)| OVERVIEW.min + MmVector::new(x * 50.0, y * 30.0);
        let sides = path.windows(2).flat_map(|pair| {
            let (a, b) = (at(pair[0]), at(pair[1]));
            let steps = ((b - a).length() / 2.5).round() as u32;
            (0..steps).map(move |step| a.lerp(b, step as f32 / steps as f32))
        });
        let mut points: Vec<MmPoint> = sides.collect();
        points.push(at(path[path.len() - 1]));
        Line { strength: 90.0, runs: vec![Run::dots(1.6, points, Height::High)] }
    };
    assert_eq!(missing(&[BOX, LEFT, RIGHT], &[dots(BOX), dots(LEFT), dots(RIGHT)]), (3, 0));
    assert_eq!(missing(&[BOX, LEFT, RIGHT], &[dots(BOX), dots(RIGHT)]), (3, 1));
    // the dots of a ring end where it begins, a diagonal step from its first one
    let mut ring = dots(BOX);
    ring.runs[0].points.pop();
    ring.runs[0].points.remove(0);
    assert_eq!(missing(&[BOX], &[ring.clone()]), (1, 0));
    ring.runs[0].points.truncate(20);
    assert_eq!(missing(&[BOX], &[ring]), (1, 1));
}
