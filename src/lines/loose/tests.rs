//! Tests of `loose`.

use super::super::vertex::FoundIn;
use super::*;
use crate::units::MmPoint;

fn line(points: &[(f32, f32)]) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), width: 1.0, ..Vertex::TEST };
    let mut line = Polyline::open(points.iter().map(vertex).collect());
    line.fill();
    line
}

/// How much is missing of the ends of lines that met others, in whole millimetres, where the first are the lines of the
/// drawing and the others what is drawn of them.
fn missing(lines: &[Polyline<Vertex>], drawn: &[Polyline<Vertex>]) -> Vec<f32> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let lines: Vec<&Polyline<Vertex>> = lines.iter().collect();
    let loose = loose_ends(&lines, drawn.iter(), &[], area, &Params::TEST);
    loose.iter().map(|end| end.length.round()).collect()
}

#[test]
fn a_line_that_ends_before_the_line_that_it_met_is_found() {
    let base = line(&[(10.0, 20.0), (90.0, 20.0)]);
    let stem = |from: f32| line(&[(50.0, from), (50.0, 80.0)]);
    let whole = [base.clone(), stem(20.0)];
    assert_eq!(missing(&whole, &[base.clone(), stem(25.0)]), [5.0]);
    let reversed = [base.clone(), stem(25.0).reversed()];
    assert_eq!(missing(&whole, &reversed), [5.0], "whichever way they run");
    assert!(missing(&whole, &whole).is_empty(), "it is whole");
    assert!(missing(&whole, &[base.clone(), stem(23.0)]).is_empty(), "a finger slips over three millimetres");
    assert!(missing(&whole, &[base.clone(), stem(45.0)]).is_empty(), "it is in pieces");
    assert!(missing(&whole, &[stem(25.0)]).is_empty(), "the line that it met is gone, which is told");
    assert!(missing(&[base.clone(), stem(26.0)], &[base.clone(), stem(27.0)]).is_empty(), "it met none");
    let mut gridline = base.clone();
    gridline.vertices.iter_mut().for_each(|vertex| vertex.source = FoundIn::FaintStroke);
    assert!(missing(&[gridline, stem(20.0)], &[base, stem(25.0)]).is_empty(), "it met a gridline");
}
