//! Anchors: where lines end on others, so that simplification leaves them joined.

use super::drawn::DrawnLines;
use super::passage::TOUCH;
use super::queue::Cleared;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// A place of a line on which an end of another lies, or a corner of a ring.
struct Anchor {
    line: usize,
    /// The number of the vertex before it.
    before: usize,
    /// How far behind that vertex, mm.
    behind: f32,
    at: MmPoint,
}

/// Puts a vertex into a line where another one ends on it, or in a drawing the corner of a ring lies on it, so that
/// they still join after simplification.
pub(super) fn anchor(cleared: &mut [Cleared], drawn: &DrawnLines<'_>) {
    let mut anchors = at_ends(cleared, drawn);
    if drawn.params.of_drawing {
        anchors.extend(at_corners(cleared, drawn));
    }
    // from the last vertex back, so that the numbers before stay right
    anchors.sort_by(|a, b| (b.line, b.before).cmp(&(a.line, a.before)).then(b.behind.total_cmp(&a.behind)));
    anchors.dedup_by(|a, b| a.line == b.line && a.before.abs_diff(b.before) <= 1 && a.at == b.at);
    anchors.into_iter().for_each(|anchor| put(anchor, cleared));
}

/// Where ends of lines lie on lines; where one lies beside its own last segments that is none.
fn at_ends(cleared: &[Cleared], drawn: &DrawnLines<'_>) -> Vec<Anchor> {
    let mut anchors = Vec::new();
    for (number, line) in cleared.iter().enumerate().filter(|(_, line)| !line.polyline.closed) {
        let vertices = &line.polyline.vertices;
        for (end, inner) in [(vertices.first(), 1), (vertices.last(), vertices.len().saturating_sub(2))] {
            let Some(end) = end else { continue };
            let is_other = |line: usize, before: usize| line != number || before.abs_diff(inner) > 2;
            anchors.extend(on_lines(end.at, cleared, drawn, is_other));
        }
    }
    anchors
}

/// Where corners of rings lie on other lines: of two corners in one place that of the later ring on the earlier ring.
fn at_corners(cleared: &[Cleared], drawn: &DrawnLines<'_>) -> Vec<Anchor> {
    let corners = corners_of_rings(cleared);
    let has_corner = |line: usize, at: MmPoint| {
        let from = corners.partition_point(|(of, _)| *of < line);
        let own = corners[from..].iter().take_while(|(of, _)| *of == line);
        own.into_iter().any(|(_, corner)| (*corner - at).length() <= TOUCH)
    };
    let of_corner = |&(number, at): &(usize, MmPoint)| {
        let is_other = |line: usize, _| line != number && !(line < number && has_corner(line, at));
        on_lines(at, cleared, drawn, is_other)
    };
    corners.iter().flat_map(of_corner).collect()
}

/// The places where `at` lies on lines, of those segments whose line and first vertex `is_other` accepts.
fn on_lines(
    at: MmPoint,
    cleared: &[Cleared],
    drawn: &DrawnLines<'_>,
    is_other: impl Fn(usize, usize) -> bool,
) -> Vec<Anchor> {
    let mut anchors = Vec::new();
    drawn.segments.around_point(at, TOUCH, |segment| {
        let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
        let (line, before) = (segment.line as usize, segment.index as usize);
        if distance <= TOUCH && is_other(line, before) && !is_end_beside(&cleared[line].polyline, before, at) {
            anchors.push(Anchor { line, before, behind: (at - segment.a).length(), at });
        }
    });
    anchors
}

/// Anchors a line at a place: a vertex beside it is moved there, if it is no end of the line and no anchor yet, or else
/// a new one is put in.
fn put(Anchor { line, before, at, .. }: Anchor, cleared: &mut [Cleared]) {
    let Cleared { polyline, anchored, .. } = &mut cleared[line];
    let can_be_moved = |i: usize| {
        let vertex = polyline.vertices[i].at;
        let is_end = !polyline.closed && (i == 0 || i + 1 == polyline.vertices.len());
        vertex == at || (!anchored[i] && !is_end && (vertex - at).length() <= TOUCH)
    };
    let after = (before + 1) % polyline.vertices.len();
    if let Some(vertex) = [before, after].into_iter().find(|&i| can_be_moved(i)) {
        polyline.vertices[vertex].at = at;
        anchored[vertex] = true;
        return;
    }
    let [first, second] = [before, after].map(|i| polyline.vertices[i]);
    // as wide as the piece of line that it parts
    let width = first.width.min(second.width);
    polyline.vertices.insert(before + 1, Vertex { at, width, ..first });
    anchored.insert(before + 1, true);
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
mod tests;
