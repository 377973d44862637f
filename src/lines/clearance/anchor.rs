//! Anchors: where lines end on others, so that simplification leaves them joined.

use super::drawn::DrawnLines;
use super::passage::TOUCH;
use super::queue::Cleared;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// Puts a vertex into a line where another one ends on it, or in a drawing the corner of a ring lies on it, so that
/// they still join after simplification.
pub(super) fn anchor(cleared: &mut [Cleared], drawn: &DrawnLines<'_>) {
    // line, vertex before, distance from it, position
    let mut anchors: Vec<(usize, usize, f32, MmPoint)> = Vec::new();
    for (number, line) in cleared.iter().enumerate().filter(|(_, line)| !line.polyline.closed) {
        let vertices = &line.polyline.vertices;
        for (at, inner) in [(vertices.first(), 1), (vertices.last(), vertices.len().saturating_sub(2))] {
            let Some(at) = at.map(|vertex| vertex.at) else { continue };
            drawn.segments().around(at, at, TOUCH, |segment| {
                let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
                let (line, index) = (segment.line as usize, segment.index as usize);
                let itself = line == number && index.abs_diff(inner) <= 2;
                if distance <= TOUCH && !itself && !is_end_beside(&cleared[line].polyline, index, at) {
                    anchors.push((line, index, (at - segment.a).length(), at));
                }
            });
        }
    }
    let corners = if drawn.params.of_drawing { corners_of_rings(cleared) } else { Vec::new() };
    for &(number, at) in &corners {
        // of two corners in one place that of the later ring goes to the other
        let is_earlier_corner = |line: usize| {
            let from = corners.partition_point(|(of, _)| *of < line);
            let own = corners[from..].iter().take_while(|(of, _)| *of == line);
            line < number && own.into_iter().any(|(_, near)| (*near - at).length() <= TOUCH)
        };
        drawn.segments().around(at, at, TOUCH, |segment| {
            let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
            let (line, index) = (segment.line as usize, segment.index as usize);
            let is_end = is_end_beside(&cleared[line].polyline, index, at);
            if distance <= TOUCH && line != number && !is_end && !is_earlier_corner(line) {
                anchors.push((line, index, (at - segment.a).length(), at));
            }
        });
    }
    // from the last vertex back, so that the numbers before stay right
    anchors.sort_by(|a, b| (b.0, b.1).cmp(&(a.0, a.1)).then(b.2.total_cmp(&a.2)));
    anchors.dedup_by(|a, b| a.0 == b.0 && a.1.abs_diff(b.1) <= 1 && a.3 == b.3);
    for (line, index, _, at) in anchors {
        let Cleared { polyline, anchored, .. } = &mut cleared[line];
        let near = |i: usize| {
            let vertex = polyline.vertices[i].at;
            let is_end = !polyline.closed && (i == 0 || i + 1 == polyline.vertices.len());
            vertex == at || (!anchored[i] && !is_end && (vertex - at).length() <= TOUCH)
        };
        let next = (index + 1) % polyline.vertices.len();
        if near(index) || near(next) {
            let vertex = if near(index) { index } else { next };
            polyline.vertices[vertex].at = at;
            anchored[vertex] = true;
        } else {
            let (before, after) = (polyline.vertices[index], polyline.vertices[next]);
            // as wide as the piece of line that it parts
            let width = before.width.min(after.width);
            polyline.vertices.insert(index + 1, Vertex { at, width, ..before });
            anchored.insert(index + 1, true);
        }
    }
}

/// The corners of rings, with the numbers of these, in their order.
fn corners_of_rings(cleared: &[Cleared]) -> Vec<(usize, MmPoint)> {
    let of_ring = |(number, line): (usize, &Cleared)| {
        let polyline = &line.polyline;
        let corners = if polyline.closed { polyline.view().corners_of_ring() } else { Vec::new() };
        corners.into_iter().map(|corner| (number, polyline.vertices[corner].at)).collect::<Vec<_>>()
    };
    cleared.iter().enumerate().flat_map(of_ring).collect()
}

/// Whether `at` is the end of a line that lies within [`TOUCH`] along it from the segment that begins at vertex
/// `index`: the line has a vertex there already.
fn is_end_beside(polyline: &Polyline<Vertex>, index: usize, at: MmPoint) -> bool {
    let vertices = &polyline.vertices;
    let last = vertices.len() - 1;
    let beside = |end: usize, vertex: usize| {
        let (from, to) = (end.min(vertex), end.max(vertex));
        vertices[end].at == at && vertices[from..=to].iter().all(|vertex| (vertex.at - at).length() <= 2.0 * TOUCH)
    };
    !polyline.closed && (beside(0, index) || beside(last, (index + 1).min(last)))
}

#[cfg(test)]
mod tests {
    use super::super::tests::{drawn, polyline};
    use super::*;
    use crate::lines::outlines::Rank;
    use crate::lines::params::Params;
    use crate::units::MmRect;

    const DRAWING: Params = Params { of_drawing: true, ..Params::TEST };

    fn cleared(points: &[(f32, f32)], closed: bool) -> Cleared {
        let polyline = polyline(points, closed);
        Cleared { saliency: 0.0, rank: Rank::Ordinary, anchored: vec![false; polyline.vertices.len()], polyline }
    }

    #[test]
    fn a_line_has_an_anchor_where_another_ends_on_it() {
        let (bar, stem) = ([(10.0, 50.0), (90.0, 50.0)], [(50.07, 80.0), (50.07, 50.0)]);
        let mut lines = [cleared(&bar, false), cleared(&stem, false)];
        anchor(&mut lines, &drawn(&[&bar, &stem]));
        let anchors = |line: &Cleared| line.anchored.iter().filter(|anchored| **anchored).count();
        assert_eq!((anchors(&lines[0]), anchors(&lines[1])), (1, 0));
        let index = lines[0].anchored.iter().position(|anchored| *anchored).expect("an anchor");
        assert_eq!(Some(lines[0].polyline.vertices[index].at), lines[1].polyline.vertices.last().map(|v| v.at));
    }

    #[test]
    fn a_line_has_an_anchor_where_a_corner_of_a_ring_lies_on_it() {
        let (bar, ring) = ([(10.0, 50.0), (90.0, 50.0)], [(50.0, 50.06), (60.0, 80.0), (40.0, 80.0)]);
        let mut lines = [cleared(&bar, false), cleared(&ring, true)];
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let mut drawn = DrawnLines::new(area, &DRAWING);
        lines.iter().for_each(|line| {
            drawn.begin(&line.polyline);
        });
        anchor(&mut lines, &drawn);
        let is_corner = |vertex: &Vertex| lines[1].polyline.vertices.iter().any(|corner| corner.at == vertex.at);
        assert!(lines[0].polyline.vertices.iter().any(is_corner), "{:?}", lines[0].polyline);
    }

    #[test]
    fn a_line_needs_no_anchor_beside_its_end_where_another_ends_too() {
        let (bar, mut next) = ([(10.0, 50.0), (50.0, 50.0)], polyline(&[(50.0, 50.0), (90.0, 50.0)], false));
        // a vertex nearer to the end than the two lines have to be
        next.vertices.insert(1, Vertex { at: MmPoint::new(50.03, 50.02), ..next.vertices[0] });
        let next =
            Cleared { saliency: 0.0, rank: Rank::Ordinary, anchored: vec![false; next.vertices.len()], polyline: next };
        let mut lines = [cleared(&bar, false), next];
        let before: Vec<MmPoint> = lines[1].polyline.vertices.iter().map(|vertex| vertex.at).collect();
        anchor(&mut lines, &drawn(&[&bar, &[(50.0, 50.0), (50.03, 50.02), (90.0, 50.0)]]));
        let after: Vec<MmPoint> = lines[1].polyline.vertices.iter().map(|vertex| vertex.at).collect();
        assert_eq!(after, before);
    }
}
