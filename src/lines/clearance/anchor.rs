//! Anchors: where lines end on others, so that simplification leaves them joined.

use super::drawn::{DrawnLines, TOUCH};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// A line that is drawn.
pub(in crate::lines) struct Cleared {
    pub(in crate::lines) polyline: Polyline<Vertex>,
    pub(in crate::lines) saliency: f32,
    /// For each vertex whether another line ends there.
    pub(in crate::lines) anchored: Vec<bool>,
}

/// Puts a vertex into a line where another one ends on it, so that they still join after simplification.
pub(super) fn anchor(cleared: &mut [Cleared], drawn: &DrawnLines<'_>) {
    // line, vertex before, distance from it, position
    let mut anchors: Vec<(usize, usize, f32, MmPoint)> = Vec::new();
    for (number, line) in cleared.iter().enumerate().filter(|(_, line)| !line.polyline.closed) {
        let vertices = &line.polyline.vertices;
        for (at, inner) in [(vertices.first(), 1), (vertices.last(), vertices.len().saturating_sub(2))] {
            let Some(at) = at.map(|vertex| vertex.at) else { continue };
            drawn.segments().around(at, at, TOUCH, |segment| {
                let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
                let itself = segment.line as usize == number && (segment.index as usize).abs_diff(inner) <= 2;
                if distance <= TOUCH && !itself {
                    let anchor = (segment.line as usize, segment.index as usize, (at - segment.a).length(), at);
                    anchors.push(anchor);
                }
            });
        }
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

#[cfg(test)]
mod tests {
    use super::super::tests::{drawn, polyline};
    use super::*;

    fn cleared(points: &[(f32, f32)], closed: bool) -> Cleared {
        let polyline = polyline(points, closed);
        Cleared { saliency: 0.0, anchored: vec![false; polyline.vertices.len()], polyline }
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
}
