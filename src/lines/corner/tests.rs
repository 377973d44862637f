//! Tests of `corner`.

use super::*;
use crate::lines::vertex::SPACING;

/// A star with six tips of some 26 degrees.
fn star(closed: bool) -> Polyline<Vertex> {
    let at = |k: u16| {
        let (sin, cos) = (f32::from(k) * std::f32::consts::PI / 6.0).sin_cos();
        let radius = if k.is_multiple_of(2) { 30.0 } else { 10.0 };
        MmPoint::new(50.0 + radius * cos, 50.0 + radius * sin)
    };
    let vertices = (0..12).map(|k| Vertex { at: at(k), ..Vertex::TEST }).collect();
    let mut star = Polyline { vertices, closed };
    star.subdivide(SPACING);
    star
}

/// Whether the whole path says the same of two places as the vertices between them, over the start of a ring too.
#[test]
fn a_corner_is_what_all_vertices_between_two_places_say() {
    for closed in [false, true] {
        let line = star(closed);
        let arcs = line.arc_lengths();
        let path: Vec<MmPoint> = line.path().map(|vertex| vertex.at).collect();
        let total = arcs[arcs.len() - 1];
        let by_all = |i: usize, j: usize| {
            let (a, b, from, to) = (path[i], path[j], arcs[i.min(j)], arcs[i.max(j)]);
            let over_start = closed && total - (to - from) < to - from;
            let length = if over_start { total - (to - from) } else { to - from };
            let between = path.iter().zip(&arcs).filter(|(_, arc)| (from..to).contains(*arc) != over_start);
            let height = |at: MmPoint| (at - a).cross(b - a).abs();
            let tip = between.map(|(at, _)| *at).max_by(|p, q| height(*p).total_cmp(&height(*q)));
            let is_straight = |tip: MmPoint| (tip - a).length() + (tip - b).length() >= STRAIGHTNESS * length;
            length <= SHARPEST * (b - a).length() + ROUNDED && tip.is_some_and(is_straight)
        };
        let (mut corners, mut others) = (0, 0);
        for (i, j) in (0..path.len()).step_by(5).flat_map(|i| (0..path.len()).step_by(3).map(move |j| (i, j))) {
            let found = is_corner(&line, &arcs, closed, [(arcs[i], path[i]), (arcs[j], path[j])]);
            assert_eq!(found, by_all(i, j), "{i} and {j}, closed: {closed}");
            if found { corners += 1 } else { others += 1 }
        }
        assert!(corners > 100 && others > 100, "{corners} corners, {others} others");
    }
}
