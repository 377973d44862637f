//! A line of a drawing on which others end goes before them: an axis before the bars that stand on it. They end on it
//! whenever it is drawn, but where they come first, it has no room between two that are near to one another. What is
//! left of a line that had to be cut has its own saliency again.

use super::passage::TOUCH;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::vertex::{FoundIn, Vertex};
use crate::units::MmRect;

/// Longest stack of lines standing on one another that is followed; following a cycle of such lines stops there too.
const DEPTH: usize = 8;
/// A straight line on which so many others end is the axis of a chart or a wall: it goes before all lines.
const AXIS: usize = 4;
/// A line is straight if the distance of its ends is at least this share of its length.
const STRAIGHT: f32 = 0.99;
/// A base is more salient than what stands on it by this share.
const MORE: f32 = 1e-4;

/// The saliency of each line, raised for those of a drawing to at least that of the lines that end on it.
pub(super) fn raised(
    saliencies: &[f32],
    lines: &[(Polyline<Vertex>, Rank)],
    area: MmRect,
    params: &Params,
) -> Vec<f32> {
    let mut all = saliencies.to_vec();
    let on_bases = lines_on_bases(lines, area, params);
    let most = saliencies.iter().copied().fold(0.0, f32::max);
    let mut count = vec![0; lines.len()];
    on_bases.iter().for_each(|&(_, base)| count[base] += 1);
    for ((line, _), (own, count)) in lines.iter().zip(all.iter_mut().zip(count)) {
        if params.of_drawing && count >= AXIS && line.chord() >= STRAIGHT * line.length() {
            *own = own.max(most);
        }
    }
    for _ in 0..DEPTH {
        let before = all.clone();
        for &(stem, base) in &on_bases {
            if before[base] <= before[stem] {
                all[base] = all[base].max((1.0 + MORE) * before[stem]);
            }
        }
        if all == before {
            break;
        }
    }
    all
}

/// Which lines end on which strokes and paths of drawings, away from their ends.
fn lines_on_bases(lines: &[(Polyline<Vertex>, Rank)], area: MmRect, params: &Params) -> Vec<(usize, usize)> {
    let drawn = |line: &Polyline<Vertex>| line.vertices.iter().filter(|at| at.source != FoundIn::Pixels).count();
    let is_base = |line: &Polyline<Vertex>| 2 * drawn(line) > line.vertices.len();
    if !lines.iter().any(|(line, _)| is_base(line)) {
        return Vec::new();
    }
    let mut segments = Nearby::new(area, params.max_spacing());
    for (number, (line, _)) in lines.iter().enumerate().filter(|(_, (line, _))| is_base(line)) {
        let arcs = line.arc_lengths();
        let length = arcs.last().copied().unwrap_or(0.0);
        for (i, (a, b)) in line.segments().enumerate() {
            // near its own end it may as well be the other one that stands on it
            if line.closed || (arcs[i] > params.max_stub() && arcs[i + 1] < length - params.max_stub()) {
                let (line, index, arc) = (number as u32, i as u32, arcs[i]);
                segments.insert(Segment { a: a.at, b: b.at, half_width: 0.0, line, index, arc });
            }
        }
    }
    let mut on_bases = Vec::new();
    for (number, (line, _)) in lines.iter().enumerate() {
        line.each_that_it_ends_on(&segments, TOUCH, |base| {
            if base != number {
                on_bases.push((number, base));
            }
        });
    }
    on_bases.sort_unstable();
    on_bases.dedup();
    on_bases
}

#[cfg(test)]
mod tests {
    use super::super::tests::{clear_all, polyline};
    use super::*;
    use crate::lines::saliency::saliency;
    use crate::lines::tests::area;

    fn stroke(points: &[(f32, f32)], strength: f32) -> (Polyline<Vertex>, Rank) {
        let mut line = polyline(points, false);
        for vertex in &mut line.vertices {
            (vertex.source, vertex.contrast, vertex.strength) = (FoundIn::Stroke, [0.0; 3], strength);
        }
        (line, Rank::Ordinary)
    }

    fn own(lines: &[(Polyline<Vertex>, Rank)]) -> Vec<f32> {
        lines.iter().map(|(line, _)| saliency(line, &Params::TEST)).collect()
    }

    /// An axis and bars on it, 7 mm wide and 7 mm apart, that are stronger.
    fn chart() -> Vec<(Polyline<Vertex>, Rank)> {
        let bar = |x: f32| stroke(&[(x, 70.0), (x, 20.0), (x + 7.0, 20.0), (x + 7.0, 70.0)], 90.0);
        let axis = stroke(&[(10.0, 10.0), (10.0, 70.02), (90.0, 70.02)], 30.0);
        [20.0, 34.0, 48.0, 62.0].map(bar).into_iter().chain([axis]).collect()
    }

    #[test]
    fn an_axis_goes_before_stronger_bars_and_is_whole() {
        let own = own(&chart());
        let saliencies = raised(&own, &chart(), area(), &Params::TEST);
        assert!(saliencies[..4].iter().all(|bar| *bar < saliencies[4]), "{saliencies:?}");
        let cleared = clear_all(chart(), area(), &Params::TEST);
        let length: f32 = cleared.iter().map(|line| line.polyline.length()).sum();
        let all: f32 = chart().iter().map(|(line, _)| line.length()).sum();
        assert!((length - all).abs() < 1.0, "{length} of {all}");
    }

    #[test]
    fn a_line_on_which_nothing_ends_keeps_its_saliency_and_a_circle_of_lines_comes_to_an_end() {
        let alone = [stroke(&[(10.0, 10.0), (90.0, 10.0)], 30.0), stroke(&[(10.0, 50.0), (90.0, 50.0)], 90.0)];
        assert_eq!(raised(&own(&alone), &alone, area(), &Params::TEST), own(&alone));
        // each ends in the middle of the next
        let circle = [
            stroke(&[(10.0, 30.0), (70.0, 30.0)], 30.0),
            stroke(&[(70.0, 10.0), (70.0, 70.0)], 40.0),
            stroke(&[(90.0, 70.0), (30.0, 70.0)], 50.0),
            stroke(&[(30.0, 90.0), (30.0, 30.0)], 60.0),
        ];
        let own = own(&circle);
        let most = own.iter().copied().fold(0.0, f32::max) * (1.0 + MORE).powi(DEPTH as i32 + 1);
        let raised = raised(&own, &circle, area(), &Params::TEST);
        assert!(raised.iter().zip(&own).all(|(raised, own)| (*own..most).contains(raised)), "{own:?} {raised:?}");
        assert!(raised[0] > own[0], "something stands on it");
    }

    #[test]
    fn an_axis_is_whole_where_a_curve_begins_close_beside_it() {
        let mut lines = vec![stroke(&[(20.0, 10.0), (20.0, 90.0)], 30.0)];
        lines.extend([20.0, 40.0, 60.0, 80.0].map(|y| stroke(&[(20.0, y), (32.0, y)], 30.0)));
        lines.push(stroke(&[(22.0, 52.0), (60.0, 30.0), (95.0, 70.0)], 90.0));
        let params = Params { of_drawing: true, ..Params::TEST };
        let is_axis = |line: &Polyline<Vertex>| line.vertices.iter().all(|vertex| (vertex.at.x - 20.0).abs() < 0.1);
        let cleared = clear_all(lines, area(), &params);
        let axis: f32 =
            cleared.iter().map(|line| &line.polyline).filter(|line| is_axis(line)).map(Polyline::length).sum();
        assert!((axis - 80.0).abs() < 0.5, "{axis}");
        assert!(cleared.iter().any(|line| line.polyline.length() > 60.0), "and most of the curve");
    }
}
