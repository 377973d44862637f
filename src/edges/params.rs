//! Parameters of the edge detector.

/// The direction of a stroke or a contour is taken over this much of it, px: a position that is off by half a pixel, as
/// on a skeleton, turns it by less than 4 degrees.
pub(super) const HEADING: f32 = 8.0;

/// A stroke of a bitmap is at most this share as wide as two lines are apart: wider, its two sides are found well by
/// themselves.
const WIDEST: f32 = 0.55;

/// Parameters of the edge detector. Lengths are in pixels of the working picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Scale of the detector: sigma of the Gaussian whose derivatives are taken, px.
    pub sigma: f32,
    /// Lower threshold of the hysteresis: a contour continues as long as its strength is at least this.
    pub low: f32,
    /// Upper threshold of the hysteresis: a contour is kept if its strength reaches this at some point.
    pub high: f32,
    /// Contours shorter than this are dropped, px.
    pub min_length: f32,
    /// The same of a drawing, where ticks are meant.
    pub min_length_of_drawing: f32,
    /// Half length of the window in which the strength is averaged along a contour, px. Averaging keeps one weak point
    /// from cutting a contour.
    pub strength_window: f32,
    /// How far surrounding texture lowers the strength of an edge: 0 not at all, 1 fully.
    pub suppression: f32,
    /// Side of the cells in which colours are averaged before the two sides of an edge are compared, px.
    pub side_cell: f32,
    /// Distance from the edge at which the two sides are compared, px.
    pub side_offset: f32,
    /// The widest stroke of a vector drawing that has one contour, along its middle, px; a wider one has two. Of a
    /// bitmap only strokes of up to 0.55 of it are looked for, unless `dark_lines` is given: the sides of wider ones
    /// are found well by themselves, and become one line later where they have no room (`lines::centreline`).
    pub widest_stroke: f32,
    /// Of a picture of dark lines on light ground the width up to which strokes have one contour, px; between them
    /// nothing is a stroke. None of any other picture.
    pub dark_lines: Option<f32>,
}

impl Params {
    /// The widest stroke of a bitmap that has one contour, px.
    pub(super) fn widest_of_bitmap(&self) -> f32 {
        self.dark_lines.unwrap_or(WIDEST * self.widest_stroke)
    }

    /// The same for a drawing.
    pub(super) fn of_drawing(self) -> Self {
        Self { min_length: self.min_length_of_drawing, ..self }
    }
}

impl Default for Params {
    /// For a picture that is analysed in its own pixels, whatever its size on a sheet: for tracing and for measuring.
    /// Cell size and offset are those that scored best on photographs of 481 x 321 pixels.
    fn default() -> Self {
        Self {
            sigma: 1.5,
            low: 3.5,
            high: 5.0,
            min_length: 6.0,
            min_length_of_drawing: 6.0,
            strength_window: 10.0,
            suppression: 1.0,
            side_cell: 5.0,
            side_offset: 8.0,
            widest_stroke: 6.0,
            dark_lines: None,
        }
    }
}
