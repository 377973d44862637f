//! Ticks and marks of angles that are too short for a line and not on the page. A reader who expects them is misled,
//! and a larger figure is the only way to have them, so they are told by what they are.

use crate::edges::{ChainRange, Edges};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::PolylineRef;
use crate::geom::simplify::simplify;
use crate::lines::{Line, LostMarks};
use crate::profile::Plan;
use crate::units::{MmPoint, PageTransform};
use crate::{About, Note};

/// A mark ends on a line that is so near to its end, mm: lines are moved apart by less.
const ENDS_ON: f32 = 2.5;
/// A place of a mark is drawn if a line is so near, mm: the ends of a tick are on its axis.
const DRAWN: f32 = 1.2;
/// A mark is drawn if at least this share of it is.
const MOSTLY: f32 = 0.5;
/// Places of a mark at which is looked.
const PLACES: usize = 12;
/// What is straight lies no farther from the way between its ends than this share of its length: an arc of 30 degrees
/// lies 0.07 off.
const STRAIGHT: f32 = 0.05;
/// A mark of a right angle has one corner, and is straight otherwise but for this share of its length.
const OFF_CORNER: f32 = 0.08;
/// ... and its corner has at most this cosine (70 to 110 degrees).
const RIGHT: f32 = 0.35;

/// What a mark is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Tick,
    Arc,
    Corner,
}

/// The marks of a drawing that are shorter than `least`, mm, and not among its lines.
pub(super) fn of(edges: &Edges, lines: &[Line], transform: &PageTransform, least: f32) -> LostMarks {
    let mut marks = LostMarks::default();
    if !edges.of_drawing() {
        return marks;
    }
    let far = |at: MmPoint| {
        let runs = lines.iter().flat_map(|line| &line.runs);
        let to_run = |run: &crate::lines::Run| {
            let path = || run.path();
            path().zip(path().skip(1)).map(|(a, b)| nearest_on_segment(at, a, b).0).fold(f32::INFINITY, f32::min)
        };
        runs.map(to_run).fold(f32::INFINITY, f32::min)
    };
    let points = |chain: &ChainRange| -> Vec<MmPoint> {
        edges.edgels[chain.edgels.clone()].iter().map(|edgel| transform.to_mm(edgel.at)).collect()
    };
    for chain in edges.chains.iter().filter(|chain| !chain.closed && !chain.kind.added) {
        let points = points(chain);
        let length = PolylineRef { vertices: &points, closed: false }.length();
        let (Some(&first), Some(&last), true) = (points.first(), points.last(), length < least) else { continue };
        let looked = (0..PLACES).map(|i| points[i * (points.len() - 1) / (PLACES - 1)]);
        let drawn = looked.filter(|at| far(*at) <= DRAWN).count();
        if drawn as f32 >= MOSTLY * PLACES as f32 {
            continue;
        }
        let ends = [first, last].map(|end| far(end) <= ENDS_ON);
        let Some(kind) = kind(&points, length, ends) else { continue };
        match kind {
            Kind::Tick => marks.ticks += 1,
            Kind::Arc => marks.arcs += 1,
            Kind::Corner => marks.corners += 1,
        }
        marks.length += length;
        marks.first.get_or_insert(first.lerp(last, 0.5));
    }
    marks
}

/// What a mark of this length is of which these ends are on lines.
fn kind(points: &[MmPoint], length: f32, ends: [bool; 2]) -> Option<Kind> {
    let line = PolylineRef { vertices: points, closed: false };
    let is_between = ends == [true, true];
    if simplify(line, STRAIGHT * length).len() == 2 {
        // what lies between two lines is a piece of a longer one, such as a gridline
        return (ends[0] != ends[1]).then_some(Kind::Tick);
    }
    let corners = simplify(line, OFF_CORNER * length);
    let is_right = match corners[..] {
        [a, b, c] => {
            let arm = |to: usize| (points[to] - points[b]).normalize();
            arm(a).dot(arm(c)).abs() <= RIGHT
        }
        _ => false,
    };
    is_between.then_some(if is_right { Kind::Corner } else { Kind::Arc })
}

/// What the maker is told of them.
pub(super) fn told(marks: &LostMarks, plan: &Plan) -> Option<Note> {
    let first = marks.first?;
    let count = |count: usize, one: &str, more: &str| match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{count} {more}")),
    };
    let all = [
        count(marks.ticks, "short tick", "short ticks"),
        count(marks.arcs, "arc of an angle", "arcs of angles"),
        count(marks.corners, "mark of a right angle", "marks of right angles"),
    ];
    let all: Vec<String> = all.into_iter().flatten().collect();
    let (at, least) = (format!("the first at {:.0}, {:.0} mm", first.x, first.y), plan.lines().min_length);
    let why = format!(
        "marks shorter than {least:.0} mm are too short for fingers; say in a label what they mean, draw them longer, \
         or make the figure larger"
    );
    Some(Note::NotOnPage(About::Lines, format!("{} ({at}): {why}", all.join(" and "))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_told_apart() {
        let arc = |degrees: f32| -> Vec<MmPoint> {
            let at = |i: u32| (degrees * i as f32 / 20.0).to_radians().sin_cos();
            (0..=20).map(at).map(|(y, x)| MmPoint::new(4.0 * x, 4.0 * y)).collect()
        };
        let line = |corners: &[(f32, f32)]| -> Vec<MmPoint> {
            let at = |i: usize| MmPoint::from(corners[i]);
            (1..corners.len()).flat_map(|i| (0..=8).map(move |k| at(i - 1).lerp(at(i), k as f32 / 8.0))).collect()
        };
        let is = |points: &[MmPoint], ends: [bool; 2]| {
            kind(points, PolylineRef { vertices: points, closed: false }.length(), ends)
        };
        assert_eq!(is(&line(&[(0.0, 0.0), (4.0, 0.0)]), [true, false]), Some(Kind::Tick));
        assert_eq!(is(&line(&[(0.0, 0.0), (4.0, 0.0)]), [false, false]), None, "a dash");
        assert_eq!(is(&line(&[(0.0, 0.0), (4.0, 0.0)]), [true, true]), None, "a piece of a gridline");
        assert_eq!(is(&line(&[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0)]), [true, true]), Some(Kind::Corner));
        assert_eq!(is(&arc(60.0), [true, true]), Some(Kind::Arc));
        assert_eq!(is(&arc(120.0), [true, true]), Some(Kind::Arc));
        assert_eq!(is(&arc(60.0), [true, false]), None, "a hook");
    }

    #[test]
    fn what_is_lost_is_counted() {
        let plan = Plan::new(&crate::profile::Profile::named("swell-a4").expect("it is built in")).expect("a plan");
        let marks = LostMarks { ticks: 60, arcs: 0, corners: 1, length: 200.0, first: Some(MmPoint::new(20.0, 30.2)) };
        let told = told(&marks, &plan).expect("a note").to_string();
        let wanted = "left out of the page: 60 short ticks and 1 mark of a right angle (the first at 20, 30 mm): marks \
                      shorter than 8 mm";
        assert!(told.starts_with(wanted), "{told}");
        assert_eq!(super::told(&LostMarks::default(), &plan), None);
    }
}
