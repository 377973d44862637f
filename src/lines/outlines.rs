//! Outlines of regions among the lines: drawn before others, after long strokes only.

use super::params::Params;
use super::vertex::{FoundIn, Vertex};
use crate::geom::polyline::Polyline;
use crate::regions::{RegionOutline, TracePoint};
use crate::units::{MmVector, PageTransform};

/// What is drawn before, and in place of, ordinary lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// The outlines, in pixels of the picture.
    pub outlines: Vec<RegionOutline>,
    /// How many of the first regions are what the picture is about.
    pub subjects: usize,
    /// How many shapes they are; neighbours share a border.
    pub shapes: usize,
    /// How many other lines are drawn, and the least length of each, mm; all if none.
    pub others: Option<(usize, f32)>,
}

/// When a line is drawn: the greatest first, then by saliency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// A stroke that is much thinner and paler than the others of its drawing.
    Faint,
    /// Any line.
    Ordinary,
    /// An outline of a region, or what is left of one.
    Outline,
    /// A long stroke, which no such outline may displace: it is thin, so that no region could have its shape.
    Stroke,
    /// An outline of what the picture is about.
    Subject,
    /// A line of an overview that a person drew.
    Person,
}

/// Least length of a stroke that goes before outlines, mm.
const LONG: f32 = 20.0;
/// Least straightness of such a stroke, chord to length: the rim of a cup is a stroke too, and as good an outline.
const STRAIGHTNESS: f32 = 0.97;
/// Share of its vertices that lie in the middle of a stroke.
const MOSTLY: f32 = 0.7;

impl Rank {
    /// Whether it is that of an outline of a region.
    pub(super) fn is_outline(self) -> bool {
        matches!(self, Self::Outline | Self::Subject)
    }

    /// That of a line that is no outline.
    pub(super) fn of(polyline: &Polyline<Vertex>) -> Self {
        // in the middle of a stroke there is no step
        let in_stroke = polyline.vertices.iter().filter(|v| v.contrast.iter().all(|c| c.abs() <= 0.0)).count();
        let is_stroke = in_stroke as f32 >= MOSTLY * polyline.vertices.len() as f32;
        let chord = polyline.chord();
        let is_straight = chord >= LONG && chord >= STRAIGHTNESS * polyline.length();
        if is_stroke && is_straight { Self::Stroke } else { Self::Ordinary }
    }
}

impl Outlines {
    /// Those outlines on the sheet that are long enough for lines.
    pub(super) fn on_the_sheet(&self, transform: &PageTransform, params: &Params) -> Vec<(Polyline<Vertex>, Rank)> {
        let line = |RegionOutline { contour, region }: &RegionOutline| {
            let vertex = |point: &TracePoint| Vertex {
                at: transform.to_mm(point.at),
                strength: point.strength.max(params.least_strength),
                contrast: [0.0; 3],
                width: 0.0,
                source: FoundIn::Pixels,
                displaced: MmVector::zero(),
            };
            let mut line = Polyline { vertices: contour.vertices.iter().map(vertex).collect(), closed: contour.closed };
            line = line.evened();
            line.fill();
            (line, if *region < self.subjects { Rank::Subject } else { Rank::Outline })
        };
        self.outlines.iter().map(line).filter(|(line, _)| line.length() >= params.min_length).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;

    /// A line through these places, mm, a vertex every half millimetre, with this difference of colour.
    fn line(places: &[(f32, f32)], closed: bool, contrast: f32) -> Polyline<Vertex> {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: 50.0,
            contrast: [contrast, 0.0, 0.0],
            width: 1.0,
            source: FoundIn::Pixels,
            displaced: MmVector::zero(),
        };
        Polyline { vertices: places.iter().map(vertex).collect(), closed }.resampled(0.5)
    }

    #[test]
    fn only_a_long_straight_open_stroke_goes_before_outlines() {
        let long = [(0.0, 0.0), (LONG + 1.0, 0.0)];
        assert_eq!(Rank::of(&line(&long, false, 0.0)), Rank::Stroke);
        assert_eq!(Rank::of(&line(&long, false, 30.0)), Rank::Ordinary, "an edge, with a colour on each side");
        assert_eq!(Rank::of(&line(&[(0.0, 0.0), (LONG - 1.0, 0.0)], false, 0.0)), Rank::Ordinary, "short");
        assert_eq!(Rank::of(&line(&[(0.0, 0.0), (15.0, 10.0), (30.0, 0.0)], false, 0.0)), Rank::Ordinary, "bent");
        assert_eq!(Rank::of(&line(&[(0.0, 0.0), (30.0, 0.0), (30.0, 9.0)], true, 0.0)), Rank::Ordinary, "closed");
        assert_eq!(Rank::of(&line(&[], false, 0.0)), Rank::Ordinary);
    }

    #[test]
    fn a_line_that_is_partly_an_edge_is_a_stroke_if_most_of_it_is() {
        let mixed = |stroke: f32| {
            let mut all = line(&[(0.0, 0.0), (30.0 * stroke, 0.0)], false, 0.0);
            all.vertices.extend(line(&[(30.0 * stroke + 0.5, 0.0), (30.0, 0.0)], false, 30.0).vertices);
            Rank::of(&all)
        };
        assert_eq!([mixed(0.8), mixed(0.6)], [Rank::Stroke, Rank::Ordinary]);
    }

    #[test]
    fn what_comes_first_is_greater() {
        let order = [Rank::Faint, Rank::Ordinary, Rank::Outline, Rank::Stroke, Rank::Subject, Rank::Person];
        assert!(order.is_sorted());
        assert_eq!(order.map(Rank::is_outline), [false, false, true, false, true, false]);
    }
}
