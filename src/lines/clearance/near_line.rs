//! Whether a line may be as near to a drawn one as it is.

use super::cluster::Cluster;
use super::passage::{Junction, Meeting, Passage};
use crate::geom::nearby::Segment;
use crate::geom::walk::arc_between;
use crate::units::{MmPoint, MmVector};

/// A segment that is near to a vertex.
pub(super) struct NearLine<'a> {
    pub(super) segment: &'a Segment,
    /// Its nearest point.
    pub(super) at: MmPoint,
    /// From the nearest point of the segment to the vertex.
    pub(super) away: MmVector,
    /// From centre line to centre line, mm.
    pub(super) distance: f32,
    /// What the distance should be, mm.
    pub(super) clearance: f32,
    /// What the distance falls short by, mm.
    pub(super) missing: f32,
    /// Where on the other line it is nearest, mm along that.
    pub(super) line_arc: f32,
    /// How far along either line a junction is close by, mm.
    pub(super) approach: f32,
    /// The same of a junction by a third line, mm.
    pub(super) cluster_approach: f32,
    /// How far along its polyline the vertex is, mm.
    pub(super) arc: f32,
    pub(super) passage: &'a Passage,
    /// The whole length of the line if it is closed, mm.
    pub(super) line_ring_length: Option<f32>,
    pub(super) of_drawing: bool,
}

impl NearLine<'_> {
    /// Whether the two lines have a junction close by.
    pub(super) fn joins(&self) -> bool {
        // it is the line that ends there, or both of two that cross, that must have come from far enough: one that
        // crosses and comes back, as a ring on a short stem, does not join where it is near again
        let of_polyline = |j: &Junction| self.passage.between(j.arc, self.arc);
        let of_line = |j: &Junction| arc_between(j.line_arc, self.line_arc, self.line_ring_length);
        let from_junction = |j: &Junction| match j.meeting {
            Meeting::LineEnds => of_line(j),
            Meeting::PolylineEnds => of_polyline(j),
            Meeting::Cross(_) => of_polyline(j).max(of_line(j)),
        };
        let least = |length: f32| length * approach_sine(self.approach, self.clearance) - FLAT;
        let comes_away = |length: f32| !self.of_drawing || self.distance >= least(length);
        let is_close = |length: f32| length <= self.approach && comes_away(length);
        // nor does one that ends on a line join what is near to it farther on, round a bend; a ring is one shape
        let are_open = self.line_ring_length.is_none() && self.passage.ring_length.is_none();
        let is_beside = |j: &Junction| {
            !self.of_drawing || !are_open || of_polyline(j).max(of_line(j)) <= ROUND_A_BEND * self.approach
        };
        let joins = |j: &Junction| j.line == self.segment.line && is_close(from_junction(j)) && is_beside(j);
        self.passage.junctions.iter().any(joins) || self.meets_in_cluster()
    }

    /// Whether the two lines meet a third one close by, at nearly one place, and this one leaves the other steeply.
    fn meets_in_cluster(&self) -> bool {
        let sine = approach_sine(self.cluster_approach, self.clearance);
        let leaves = |cluster: &Cluster, length: f32| {
            length + cluster.apart <= self.cluster_approach && self.distance >= cluster.apart + length * sine - FLAT
        };
        // along the one that ends there, as the check has it
        let joins = |cluster: &Cluster| {
            let own = self.passage.between(cluster.arc, self.arc);
            let of_line = arc_between(cluster.line_arc, self.line_arc, self.line_ring_length);
            cluster.ends && leaves(cluster, own) || cluster.line_ends && leaves(cluster, of_line)
        };
        self.passage.clusters.iter().any(|cluster| cluster.line == self.segment.line && joins(cluster))
    }
}

/// What a line of a drawing that leaves a junction may lie nearer than a straight one at the flattest angle, mm: it may
/// bend. What keeps beside the line for longer, as the first bar of a chart beside its axis, does not leave it.
const FLAT: f32 = 1.0;

/// Of two open lines of a drawing that join, places farther than this from there along either do not belong to the
/// junction, in approaches: beside a straight line they are no farther than one.
const ROUND_A_BEND: f32 = 2.0;

/// The sine of the flattest angle at which a straight line has its clearance after an approach.
fn approach_sine(approach: f32, clearance: f32) -> f32 {
    (clearance / approach).min(1.0)
}

#[cfg(test)]
mod tests;
