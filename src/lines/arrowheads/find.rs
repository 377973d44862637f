//! Heads of arrows among the contours of a drawing.

use super::shapes::{HeadTip, end, is_leg, tips};
use crate::geom::nearby::Index;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::lead_on::heading;
use crate::lines::params::HEADING;
use crate::lines::vertex::{Tip, Vertex};
use crate::units::{Mm, MmPoint, MmRect, MmVector};

/// The end of a shaft is no farther from its head than this, mm, nor are its strokes from its tip.
const NEAR_HEAD: f32 = 1.0;
/// A head points as its shaft leads, but for 32 degrees: the cosine.
const ALONG: f32 = 0.85;
/// The tip lies no farther from the line of the shaft than this share of half its width, and this more, mm: a pixel or
/// so of a small head.
const ASIDE: f32 = 0.5;
const OFF_LINE: f32 = 0.2;
/// A shaft is at least so many times as long as its head.
const SHAFT: f32 = 1.5;
/// The ends of strokes of a head are free: no other line is so near, mm.
const FREE: f32 = 0.5;
/// Strokes of a head lean back along the shaft: the cosine, 65 degrees.
const LEANS: f32 = 0.42;
/// Side of the cells in which parts are looked for, mm.
const CELL: f32 = 5.0;

/// The end of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineEnd {
    pub(super) line: usize,
    pub(super) which: Tip,
    pub(super) at: MmPoint,
    /// Which way its line leads there.
    pub(super) heading: MmVector,
}

/// A head that was found.
pub(super) struct FoundHead {
    pub(super) tip: HeadTip,
    pub(super) shaft: LineEnd,
    /// The contours that it is.
    pub(super) lines: Vec<usize>,
}

/// Contours, and which of them may be parts of heads.
pub(super) struct Contours<'a> {
    polylines: &'a [Polyline<Vertex>],
    /// By place: the tips of a contour, with its number.
    tips: Index<(usize, HeadTip), Mm>,
    /// By place: the ends of open contours.
    ends: Index<LineEnd, Mm>,
    /// Which may be heads, and which strokes of them.
    is_head: Vec<bool>,
    is_leg: Vec<bool>,
}

impl<'a> Contours<'a> {
    pub(super) fn of(polylines: &'a [Polyline<Vertex>], area: MmRect) -> Self {
        let mut all = Self {
            polylines,
            tips: Index::new(area, CELL),
            ends: Index::new(area, CELL),
            is_head: vec![false; polylines.len()],
            is_leg: polylines.iter().map(is_leg).collect(),
        };
        for (line, polyline) in polylines.iter().enumerate() {
            for tip in tips(polyline) {
                all.is_head[line] = true;
                all.tips.put_over(tip.apex.min(tip.base()), tip.apex.max(tip.base()), (line, tip));
            }
            for which in Tip::BOTH.into_iter().filter(|_| !polyline.closed) {
                if let (Some(at), Some(heading)) = (end(polyline, which), heading(polyline, which, HEADING)) {
                    all.ends.put_at(at, LineEnd { line, which, at, heading });
                }
            }
        }
        all
    }

    /// The heads of arrows; no contour is part of two.
    pub(super) fn heads(&self) -> Vec<FoundHead> {
        let mut heads: Vec<FoundHead> = Vec::new();
        if self.is_leg.iter().chain(&self.is_head).all(|is_part| !is_part) {
            return heads;
        }
        let mut taken = vec![false; self.polylines.len()];
        let mut whole: Vec<(f32, FoundHead)> = self.shafts().flat_map(|shaft| self.whole(&shaft)).collect();
        // where arrows meet, each head is that of the shaft which it points along best; a border of areas that it hides
        // in part ends there too
        let is_stroke = |head: &FoundHead| {
            let FoundHead { shaft, .. } = head;
            shaft.which.of(&self.polylines[shaft.line]).is_some_and(Vertex::is_in_stroke)
        };
        whole.sort_by(|(a, one), (b, other)| is_stroke(other).cmp(&is_stroke(one)).then(b.total_cmp(a)));
        let mut keep = |head: FoundHead, taken: &mut [bool]| {
            let FoundHead { tip, shaft, lines } = &head;
            let is_long = self.polylines[shaft.line].length() >= SHAFT * tip.axis().length();
            let is_other = !heads.iter().any(|of| (of.shaft.line, of.shaft.which) == (shaft.line, shaft.which));
            let are_free = lines.iter().chain([&shaft.line]).all(|line| !taken[*line]);
            if is_long && is_other && are_free && !self.goes_on(tip, shaft) {
                lines.iter().for_each(|line| taken[*line] = true);
                heads.push(head);
            }
        };
        whole.into_iter().for_each(|(_, head)| keep(head, &mut taken));
        let along = |head: &FoundHead| head.tip.axis().normalize().dot(head.shaft.heading);
        let mut of_legs: Vec<FoundHead> = self.shafts().filter_map(|shaft| self.of_legs(&shaft, &taken)).collect();
        of_legs.sort_by(|a, b| along(b).total_cmp(&along(a)));
        of_legs.into_iter().for_each(|head| keep(head, &mut taken));
        heads
    }

    /// The ends of lines at which heads may be.
    fn shafts(&self) -> impl Iterator<Item = LineEnd> + '_ {
        let open = self.polylines.iter().enumerate().filter(|(_, line)| !line.closed);
        let ends = open.flat_map(|(line, polyline)| Tip::BOTH.map(|which| (line, polyline, which)));
        ends.filter_map(|(line, polyline, which)| {
            let (at, heading) = end(polyline, which).zip(heading(polyline, which, HEADING))?;
            Some(LineEnd { line, which, at, heading })
        })
    }

    /// The heads of one contour that may be that of a shaft, each with the cosine between the two.
    fn whole(&self, shaft: &LineEnd) -> Vec<(f32, FoundHead)> {
        let mut found: Vec<(f32, FoundHead)> = Vec::new();
        self.tips.around(shaft.at, shaft.at, NEAR_HEAD, |&(line, tip)| {
            if line != shaft.line
                && fits(&tip, shaft)
                && self.is_free(&tip, line)
                && self.is_whole(&tip, [line, shaft.line])
            {
                let along = tip.axis().normalize().dot(shaft.heading);
                found.push((along, FoundHead { tip, shaft: *shaft, lines: vec![line] }));
            }
        });
        // a tip lies in several cells, and comes several times
        found.sort_by(|(a, head), (b, other)| b.total_cmp(a).then(head.lines.cmp(&other.lines)));
        found
    }

    /// A head of two strokes that begin at the end of a shaft.
    fn of_legs(&self, shaft: &LineEnd, taken: &[bool]) -> Option<FoundHead> {
        let mut sides: [Option<(f32, usize, MmPoint)>; 2] = [None; 2];
        self.ends.around(shaft.at, shaft.at, NEAR_HEAD, |leg| {
            let far = (leg.at - shaft.at).length();
            if leg.line == shaft.line || taken[leg.line] || !self.is_leg[leg.line] || far > NEAR_HEAD {
                return;
            }
            let Some(wing) = end(&self.polylines[leg.line], leg.which.other()) else { return };
            // a tick beside the end of an axis stands across it
            if (leg.at - wing).dot(shaft.heading) < LEANS * (leg.at - wing).length() {
                return;
            }
            let side = &mut sides[usize::from(shaft.heading.cross(wing - shaft.at) > 0.0)];
            if side.is_none_or(|(least, line, _)| far.total_cmp(&least).then(leg.line.cmp(&line)).is_lt()) {
                *side = Some((far, leg.line, wing));
            }
        });
        let [Some((_, left, one)), Some((_, right, other))] = sides else { return None };
        let tip = HeadTip::of(shaft.at, [one, other])?;
        let are_free = [(one, left), (other, right)].iter().all(|&(wing, of)| self.is_free_end(wing, of));
        (fits(&tip, shaft) && are_free).then(|| FoundHead { tip, shaft: *shaft, lines: vec![left, right] })
    }

    /// Whether the ends of an open contour touch nothing: those of a roof stand on walls.
    fn is_free(&self, tip: &HeadTip, line: usize) -> bool {
        let is_outline = self.polylines[line].closed;
        is_outline || tip.wings.iter().all(|wing| self.is_free_end(*wing, line))
    }

    /// Whether another line runs along the side that the contour of a head lacks, if there is one; none of these two.
    fn is_whole(&self, tip: &HeadTip, own: [usize; 2]) -> bool {
        let Some([first, last]) = tip.lacks else { return true };
        let length = (last - first).length();
        let is_at = |line: &Polyline<Vertex>, at: MmPoint| {
            line.segments().any(|(a, b)| nearest_on_segment(at, a.at, b.at).0 <= NEAR_HEAD)
        };
        let runs_along = |line: &Polyline<Vertex>| {
            line.length() >= length && [0.0, 0.5, 1.0].iter().all(|share| is_at(line, first.lerp(last, *share)))
        };
        self.polylines.iter().enumerate().any(|(number, line)| !own.contains(&number) && runs_along(line))
    }

    fn is_free_end(&self, wing: MmPoint, line: usize) -> bool {
        let mut is_free = true;
        self.ends.around(wing, wing, FREE, |end| {
            is_free &= end.line == line || self.is_leg[end.line] || (end.at - wing).length() > FREE;
        });
        is_free
    }

    /// Whether another line goes on at a tip where the shaft ends: then the triangle is a sign within a line.
    fn goes_on(&self, tip: &HeadTip, shaft: &LineEnd) -> bool {
        let Some(axis) = tip.axis().try_normalize() else { return true };
        if self.is_of_measure(tip, axis, shaft) {
            return false;
        }
        let mut goes_on = false;
        self.ends.around(tip.apex, tip.apex, NEAR_HEAD, |end| {
            let is_line = end.line != shaft.line && !self.is_leg[end.line] && !self.is_head[end.line];
            let is_line = is_line && self.polylines[end.line].length() > tip.axis().length();
            let is_at = (end.at - tip.apex).length() <= NEAR_HEAD;
            goes_on |= is_line && is_at && end.heading.dot(axis) <= -ALONG;
        });
        goes_on
    }

    /// Whether a head meets another one tip to tip, and its shaft has one at its other end too: lines that say how long
    /// parts are which follow one another.
    fn is_of_measure(&self, tip: &HeadTip, axis: MmVector, shaft: &LineEnd) -> bool {
        let points_back_at = |at: MmPoint| {
            let mut points_back = false;
            self.tips.around(at, at, NEAR_HEAD, |(_, other)| {
                let is_at = (other.apex - at).length() <= NEAR_HEAD;
                points_back |= is_at && other.axis().dot(axis) <= -ALONG * other.axis().length();
            });
            points_back
        };
        let other_end = end(&self.polylines[shaft.line], shaft.which.other());
        points_back_at(tip.apex) && other_end.is_some_and(points_back_at)
    }
}

/// Whether a head is that of a shaft: it points as that leads, and lies before it.
fn fits(tip: &HeadTip, shaft: &LineEnd) -> bool {
    let Some(axis) = tip.axis().try_normalize() else { return false };
    let length = tip.axis().length();
    let along = (shaft.at - tip.base()).dot(axis);
    let line = (shaft.at - shaft.heading * length, shaft.at + shaft.heading * (length + NEAR_HEAD));
    axis.dot(shaft.heading) >= ALONG
        && (-NEAR_HEAD..=length + NEAR_HEAD).contains(&along)
        && nearest_on_segment(tip.apex, line.0, line.1).0 <= ASIDE * tip.half_width() + OFF_LINE
}
