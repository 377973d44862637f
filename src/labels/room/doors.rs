//! The doors of a plan: a wall that went on behind its end would soon come to another one, or to its other piece.

use super::Room;
use super::squares::SQUARE;
use crate::geom::polygon::corners;
use crate::geom::{nearest_on_segment, segment_distance};
use crate::page::{Line, which_are_weak};
use crate::units::{MmPoint, MmRect, MmVector};

/// Widest door, mm: those of a flat that fills a sheet of A4 have 8 to 16. Chosen by us.
const WIDEST: f32 = 20.0;
/// A wall is straight for so much before its end, mm, but for the steps of a grid of dots: what is shorter, or bent, is
/// furniture.
const STRAIGHT: f32 = 8.0;
const BENT: f32 = 1.3;
/// It runs across or down, but for so much of its length: a line that slants is none of a house, such as a curve.
const ASKEW: f32 = 0.06;
/// A line that lies so near to the end on either side, mm, is met by it there.
const BESIDE: f32 = 2.5;

impl Room {
    /// The doors among lines, each as the way from the end of a wall to what that comes to.
    pub(super) fn doors_of(&self, lines: &[Line], least_strength: f32) -> Vec<[MmPoint; 2]> {
        let weak = which_are_weak(lines, least_strength);
        let walls = lines.iter().zip(weak).filter(|(_, is_weak)| !is_weak).map(|(line, _)| line);
        let runs = walls.flat_map(|line| &line.runs).filter(|run| !run.closed);
        let ends = runs.flat_map(|run| [end_of(run.points.iter()), end_of(run.points.iter().rev())]).flatten();
        ends.filter_map(|(end, onwards)| self.door(end, onwards)).collect()
    }

    /// The door at the end of a wall; none if it ends at another line, or comes to none.
    fn door(&self, end: MmPoint, onwards: MmVector) -> Option<[MmPoint; 2]> {
        // behind the ink of the wall itself
        let beyond = 0.5 * self.widest + 2.0 * SQUARE;
        let aside = MmVector::new(-onwards.y, onwards.x) * BESIDE;
        let ends_at_another = [onwards * beyond, aside, -aside].into_iter().any(|to| self.is_ink(end + to));
        if ends_at_another {
            return None;
        }
        let far = self.first_ink(end + onwards * beyond, onwards, WIDEST - beyond)?;
        Some([end, end + onwards * (beyond + far)])
    }

    /// Whether a straight way leads through a door.
    pub(in crate::labels) fn leads_through_door(&self, from: MmPoint, to: MmPoint) -> bool {
        self.doors.iter().any(|&[a, b]| segment_distance((from, to), (a, b)) <= 0.0)
    }

    /// Whether a box lies in a door.
    pub(in crate::labels) fn is_in_door(&self, place: MmRect) -> bool {
        let corners = corners(place);
        (0..4).any(|side| self.leads_through_door(corners[side], corners[(side + 1) % 4]))
    }
}

/// The first of the points of a line, and the direction in which it would go on there; none if it is no wall's.
fn end_of<'a>(mut points: impl Iterator<Item = &'a MmPoint> + Clone) -> Option<(MmPoint, MmVector)> {
    let end = *points.next()?;
    let is_near = |at: &MmPoint| (*at - end).length() < STRAIGHT;
    let back = *points.clone().find(|&at| !is_near(at))?;
    let is_straight = points.take_while(|&at| is_near(at)).all(|at| nearest_on_segment(*at, end, back).0 <= BENT);
    let onwards = (end - back).try_normalize().filter(|_| is_straight)?;
    (onwards.x.abs().min(onwards.y.abs()) <= ASKEW).then_some((end, onwards))
}
