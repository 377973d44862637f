//! A line of a drawing that leaves another at a flat angle, as one hand of a clock beside the other, has no room until
//! the two are apart. Where little would be left of it, it branches off the other a little later and more steeply:
//!
//! ```text
//!   o------------------------------------      o----------___-----------------------
//!    ``````------______                                      ``--__________
//! ```

use super::drawn::{DrawnLines, LineState};
use super::passage::TOUCH;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::lines::junction;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// What is taken off the way from the other line, mm, so that rounding does not make it too long.
const MARGIN: f32 = 0.1;

/// A line that ends on another, is too near to that up to some place and free of all beyond, as a branch of the other;
/// none if it is no such line.
pub(super) fn branch(
    polyline: &Polyline<Vertex>,
    states: &[LineState],
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    if polyline.closed || !drawn.params.of_drawing {
        return None;
    }
    from_first(&polyline.vertices, states, drawn).or_else(|| {
        let reversed: Vec<Vertex> = polyline.vertices.iter().rev().copied().collect();
        let states: Vec<LineState> = states.iter().rev().copied().collect();
        from_first(&reversed, &states, drawn)
    })
}

/// [`branch`] of a line whose first vertex is on the other.
fn from_first(vertices: &[Vertex], states: &[LineState], drawn: &DrawnLines<'_>) -> Option<Polyline<Vertex>> {
    let (_, _, joined) = drawn.segments().nearest(vertices.first()?.at, TOUCH, |_| true)?;
    let line = joined.line;
    let apart = vertices.iter().position(|vertex| !drawn.is_near(vertex, line))?;
    if states[apart..].contains(&LineState::TooNear) {
        return None;
    }
    let start = &vertices[apart];
    // as far back on the other line as the way from there to the place where the two are apart may be long
    let mut foot: Option<MmPoint> = None;
    for vertex in vertices[..apart].iter().rev() {
        let Some((_, at, segment)) = drawn.segments().nearest_of_line(vertex.at, drawn.params.max_clearance(), line)
        else {
            break;
        };
        // dots are apart where lines leave one another more steeply
        let longest = match drawn.params.hands_marks_on {
            true => drawn.params.max_stub(),
            false => drawn.params.approach(0.5 * start.width, segment.half_width),
        };
        if (at - start.at).length() > longest - MARGIN {
            break;
        }
        foot = Some(at);
    }
    let foot = foot?;
    let first = Vertex { at: foot, ..*start };
    let way = junction::straight(&first, start.at);
    let vertices: Vec<Vertex> = [first].into_iter().chain(way).chain(vertices[apart + 1..].iter().copied()).collect();
    let length = PolylineRef { vertices: &vertices, closed: false }.length();
    (length >= drawn.params.min_length).then(|| Polyline::open(vertices))
}

#[cfg(test)]
mod tests {
    use super::super::tests::{clear_all, polyline};
    use super::*;
    use crate::lines::outlines::Rank;
    use crate::lines::params::Params;
    use crate::lines::tests::area;

    /// The lengths of two hands of a clock with so many degrees between them that are drawn, the longer one first, and
    /// how far the end of the shorter one is from where it should be.
    fn hands(degrees: f32, of_drawing: bool) -> (Vec<f32>, f32) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let end = (50.0 + 33.0 * cos, 50.0 + 33.0 * sin);
        let long = polyline(&[(50.0, 50.0), (99.0, 50.0)], false);
        let short = polyline(&[(50.0, 50.0), end], false);
        let params = Params { of_drawing, ..Params::TEST };
        let drawn = clear_all([long, short].map(|line| (line, Rank::Ordinary)).to_vec(), area(), &params);
        let ends = drawn.iter().flat_map(|line| [line.polyline.vertices.first(), line.polyline.vertices.last()]);
        let off = ends.flatten().map(|vertex| (vertex.at - MmPoint::from(end)).length()).fold(f32::INFINITY, f32::min);
        (drawn.iter().map(|line| line.polyline.length()).collect(), off)
    }

    #[test]
    fn the_hour_hand_beside_the_minute_hand_branches_off_it_and_is_drawn_to_its_end() {
        let (lengths, off) = hands(10.0, true);
        assert!(matches!(lengths[..], [long, short] if (long - 49.0).abs() < 0.1 && short > 17.0), "{lengths:?}");
        assert!(off < 0.1, "{off}");
        assert_eq!(hands(10.0, false).0.len(), 1, "in a photograph it is no line");
        let (lengths, off) = hands(40.0, true);
        assert!(lengths[1] > 32.5 && off < 0.1, "with room it is whole: {lengths:?}");
    }
}
