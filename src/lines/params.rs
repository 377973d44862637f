//! How lines are drawn, and the distances that follow from it. They are computed here.

use super::line::HeavyStrokes;

/// A ring is displaced by at most this, mm, and other lines by half of it: that a ring closes says more than where
/// exactly its side runs. The two sides of a narrow bar can so become farther apart by as much, with room to spare.
pub(super) const RING_FARTHEST: f32 = 1.6;

/// The direction of an end is taken over this much of its line, mm: a little more than the widest line is wide.
pub(super) const HEADING: f32 = 2.0;

/// A part of the page that has lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PagePart {
    /// The figure.
    Figure,
    /// The overview, which is felt for its shapes.
    Overview,
}

/// What lines are drawn on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LineMedium {
    /// Paper: they are printed as they are, and how heavy one is its width says.
    Print,
    /// They become dots, and so do points and ticks on them: these are handed on as [`LineMarks`](super::LineMarks).
    /// Which strokes are heavy is said here.
    Dots(HeavyStrokes),
}

/// How lines are drawn. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Width of the weakest line.
    pub width_min: f32,
    /// Width of every line from `full_strength` on.
    pub width_max: f32,
    /// Strength of an edge (see `edges`) that gets `width_min`.
    pub least_strength: f32,
    /// Strength from which a line has `width_max`; low, so that most lines share one width.
    pub full_strength: f32,
    /// A line shorter than this is left out.
    pub min_length: f32,
    /// Least blank between the edges of two lines.
    pub min_gap: f32,
    /// Farthest distance of two ends that are joined when they continue one another. As far is an end led on to a line
    /// ahead of it (`lead_on`, and what is left of a cut line in `clearance::extend`), and so far from other lines may
    /// the ends of a link be (`links`).
    pub join_gap: f32,
    /// In an overview of a drawing, how large that is beside the figure, at most 1: contours that are apart in the
    /// figure stay apart. In a figure 1.
    pub gap_scale: f32,
    /// Sigma of the Gaussian that smooths a line along itself.
    pub smoothing: f32,
    /// Farthest that a simplified line may lie from the smooth one.
    pub tolerance: f32,
    /// How many of the lines are drawn, 0..=1: from the longest, strongest, closed and smooth ones only to all. Those
    /// drawn at one detail are drawn, the same, at every higher one.
    pub detail: f32,
    /// At most so many closed shapes, and as many other lines, the most salient ones; all if none.
    pub most_shapes: Option<usize>,
    /// What of the page they are drawn for.
    pub part: PagePart,
    /// Whether a ring that has no room as a whole is left out, and not opened or drawn in parts.
    pub whole_rings: bool,
    /// Whether they are those of a drawing.
    pub of_drawing: bool,
    /// Whether the sides of a bar that is a little too narrow for two lines are both drawn, and move apart.
    pub widen_bars: bool,
    /// What they are drawn on.
    pub medium: LineMedium,
    /// Whether small round shapes on lines are points; otherwise they are shapes as all others.
    pub takes_points: bool,
}

/// The greatest length from a junction until two lines are apart, in clearances: at 36 degrees a straight line needs as
/// much. Contours of photographs that meet at a flatter angle seldom do so in the picture.
const APPROACH: f32 = 1.7;
/// The same of drawings, where every crossing is meant: the curves of a chart, a connector between boxes. A straight
/// line needs as much at 19.5 degrees.
pub(crate) const APPROACH_OF_DRAWINGS: f32 = 3.0;
/// The same of lines that meet a third one at nearly one place, where three are near one another: at 36 degrees.
pub(crate) const CLUSTER_APPROACH: f32 = 1.7;
/// What is taken off an approach, mm: a line may be drawn by a step of width thinner than its vertices say.
const APPROACH_MARGIN: f32 = 0.2;
/// What rounding, and the vertices where lines meet, may take from a distance, mm.
const ROUNDING: f32 = 0.08;

/// [`Params::farthest_moved`] of lines whose middles are so far apart at least, mm.
pub fn farthest_moved(spacing: f32) -> f32 {
    (0.5 * spacing).max(2.0 * RING_FARTHEST)
}

impl Params {
    /// Widths and gaps as for swell paper, and all detail.
    #[cfg(test)]
    pub(super) const TEST: Self = Self {
        width_min: 0.75,
        width_max: 1.5,
        least_strength: 7.0,
        full_strength: 30.0,
        min_length: 8.0,
        min_gap: 3.2,
        join_gap: 3.0,
        gap_scale: 1.0,
        smoothing: 0.6,
        tolerance: 0.05,
        detail: 1.0,
        most_shapes: None,
        part: PagePart::Figure,
        whole_rings: false,
        of_drawing: false,
        widen_bars: false,
        medium: LineMedium::Print,
        takes_points: true,
    };

    /// Whether lines become dots.
    pub(super) fn on_dots(&self) -> bool {
        matches!(self.medium, LineMedium::Dots(_))
    }

    /// How far dots of a row are apart, mm; 0 on paper.
    pub(super) fn dot_pitch(&self) -> f32 {
        match self.medium {
            LineMedium::Print => 0.0,
            // a broad stroke is one from the width of a step on
            LineMedium::Dots(HeavyStrokes { width: pitch, .. }) => pitch,
        }
    }

    /// The same with lines no wider than needed, so that more of them have room.
    pub(super) fn thin(self) -> Self {
        Self { width_max: 0.5 * (self.width_min + self.width_max), ..self }
    }

    /// The same for the overview of a drawing, which is felt for its shapes: each whole or not at all, and lines
    /// no wider than needed.
    #[must_use]
    pub fn of_overview(self) -> Self {
        Self { part: PagePart::Overview, whole_rings: true, ..self.thin() }
    }

    /// The longest gap between contours that is bridged, mm.
    pub(super) fn bridged_gap(&self) -> f32 {
        self.gap_scale * self.join_gap
    }

    /// Distance of the centre lines of two lines of the greatest width with the least blank between them, mm. Lines
    /// that are not yet simplified need a little more ([`Params::max_clearance`]).
    pub fn max_spacing(&self) -> f32 {
        self.min_gap + self.width_max
    }

    /// The widest stroke of which the centreline is drawn and not its two sides, mm.
    pub(super) fn widest_stroke(&self) -> f32 {
        if self.widen_bars { self.too_narrow() } else { self.max_spacing() }
    }

    /// The widest stroke, or gap between two areas, whose sides cannot move apart until there is room for both, mm.
    pub(super) fn too_narrow(&self) -> f32 {
        (self.max_spacing() - RING_FARTHEST).max(0.0)
    }

    /// How far a line may be from the contours that it stands for, mm: it may be moved twice, together with others and
    /// alone, or lie in the middle of its stroke.
    pub fn farthest_moved(&self) -> f32 {
        farthest_moved(self.max_spacing())
    }

    /// The farthest that a centre line is from the contours that it stands for, mm: in the middle of a stroke whose
    /// sides are just too near for two lines.
    pub fn max_offset(&self) -> f32 {
        0.5 * self.max_spacing()
    }

    /// How far apart the centre lines of two lines must be whose widths have this half sum, mm. Simplification may move
    /// both.
    pub(super) fn clearance(&self, half_widths: f32) -> f32 {
        self.min_gap + half_widths + self.play()
    }

    /// By how much simplification and rounding may bring two lines nearer, mm.
    pub(super) fn play(&self) -> f32 {
        2.0 * self.tolerance + ROUNDING
    }

    /// The clearance of a line from the widest, mm, whatever its own width.
    pub(super) fn max_clearance(&self) -> f32 {
        self.clearance(self.width_max)
    }

    /// How near the centre line of another line may come to the middle of a disc of this radius, mm.
    pub(super) fn beside_disc(&self, radius: f32) -> f32 {
        radius + self.min_gap + 0.5 * self.width_max
    }

    fn longest_approach(&self) -> f32 {
        if self.of_drawing { APPROACH_OF_DRAWINGS } else { APPROACH }
    }

    /// Whether they are those of the overview of a drawing.
    pub(super) fn in_overview_of_drawing(&self) -> bool {
        self.of_drawing && self.part == PagePart::Overview
    }

    /// The greatest length from a junction until two lines of these half widths must be apart, mm.
    pub(super) fn approach(&self, half_width: f32, other: f32) -> f32 {
        self.longest_approach() * (self.min_gap + half_width + other) - APPROACH_MARGIN
    }

    /// The same of two lines of a drawing that meet a third one at nearly one place.
    pub(super) fn cluster_approach(&self, half_width: f32, other: f32) -> f32 {
        CLUSTER_APPROACH * (self.min_gap + half_width + other) - APPROACH_MARGIN
    }

    /// Places where lines end on a third one are nearly one if they are no farther apart than this, mm: the distance of
    /// two lines of the least width.
    pub(super) fn cluster_spacing(&self) -> f32 {
        self.min_gap + self.width_min
    }

    /// The greatest length from a junction until two lines of the least width must be apart, mm, with a margin for
    /// each.
    pub(super) fn min_approach(&self) -> f32 {
        self.longest_approach() * (self.min_gap + self.width_min) - 2.0 * APPROACH_MARGIN
    }

    /// The greatest length beyond a crossing that does not count as a line of its own, mm.
    pub(super) fn max_stub(&self) -> f32 {
        APPROACH * self.max_spacing()
    }

    /// Length from which a straight line is long enough wherever its ends lie, mm: the row of a grid that stands for it
    /// has whole steps, and may be shorter than it by nearly one.
    pub(super) fn sure_length(&self) -> f32 {
        match self.medium {
            LineMedium::Print => self.min_length,
            // a broad stroke is one from the width of a step on
            LineMedium::Dots(HeavyStrokes { width: pitch, .. }) => (self.min_length / pitch).ceil() * pitch,
        }
    }

    /// Whether a ring of this length, mm, is felt as a dot: it is no longer than a circle as wide as two lines are
    /// apart.
    pub(super) fn is_dot(&self, length: f32) -> bool {
        length < std::f32::consts::PI * self.max_spacing()
    }
}

#[cfg(test)]
mod tests;
