//! Where lines end on others, so that simplification leaves them joined.

use super::Cleared;
use super::field::{Field, TOUCH};
use crate::geom::nearest_on_segment;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// Puts a vertex into a line where another one ends on it, so that they still meet after simplification.
pub(super) fn pin(cleared: &mut [Cleared], field: &Field<'_>) {
    // line, vertex before, way from it, place
    let mut pins: Vec<(usize, usize, f32, MmPoint)> = Vec::new();
    for (number, line) in cleared.iter().enumerate().filter(|(_, line)| !line.polyline.closed) {
        let vertices = &line.polyline.vertices;
        for (at, inner) in [(vertices.first(), 1), (vertices.last(), vertices.len().saturating_sub(2))] {
            let Some(at) = at.map(|vertex| vertex.at) else { continue };
            field.segments().around(at, at, TOUCH, |segment| {
                let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
                let itself = segment.line as usize == number && (segment.index as usize).abs_diff(inner) <= 2;
                if distance <= TOUCH && !itself {
                    let pin = (segment.line as usize, segment.index as usize, (at - segment.a).length(), at);
                    pins.push(pin);
                }
            });
        }
    }
    // from the last vertex back, so that the numbers before stay right
    pins.sort_by(|a, b| (b.0, b.1).cmp(&(a.0, a.1)).then(b.2.total_cmp(&a.2)));
    pins.dedup_by(|a, b| a.0 == b.0 && a.1.abs_diff(b.1) <= 1 && a.3 == b.3);
    for (line, index, _, at) in pins {
        let Cleared { polyline, pinned, .. } = &mut cleared[line];
        let near = |i: usize| {
            let vertex = polyline.vertices[i].at;
            let is_end = !polyline.closed && (i == 0 || i + 1 == polyline.vertices.len());
            vertex == at || (!pinned[i] && !is_end && (vertex - at).length() <= TOUCH)
        };
        let next = (index + 1) % polyline.vertices.len();
        if near(index) || near(next) {
            let vertex = if near(index) { index } else { next };
            polyline.vertices[vertex].at = at;
            pinned[vertex] = true;
        } else {
            let (before, after) = (polyline.vertices[index], polyline.vertices[next]);
            // as wide as the piece of line that it parts
            let width = before.width.min(after.width);
            polyline.vertices.insert(index + 1, Vertex { at, width, ..before });
            pinned.insert(index + 1, true);
        }
    }
}
