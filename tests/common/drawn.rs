//! How lines are drawn in the tests: as on a page of A4 swell paper, but from fainter steps on.

use tactograph::internals::lines;

pub(crate) const LINES: lines::Params = lines::Params {
    width_min: 0.75,
    width_max: 1.5,
    least_strength: 5.0,
    full_strength: 30.0,
    min_length: 8.0,
    min_gap: 3.2,
    join_gap: 3.0,
    gap_scale: 1.0,
    smoothing: 0.6,
    tolerance: 0.05,
    detail: 0.5,
    most_shapes: None,
    part: lines::PagePart::Figure,
    whole_rings: false,
    of_drawing: false,
    widen_bars: false,
    medium: lines::LineMedium::Print,
    takes_points: true,
};
