//! How wide marks are printed, and how much of a page is black.

use std::f32::consts::FRAC_PI_4;

use super::{Dots, Glyph, Line, Page, Parts, Pen, Run, Shape};

/// The narrowest that a tick is printed, mm: to be found by looking as well.
const LEAST_TICK: f32 = 0.5;

impl Parts {
    /// Makes all marks but labels, whose dots are those to be printed, narrower by `swell` mm, half of it on each side: what is printed so that, risen, it has the size that
    /// it has now. A mark that is no wider than that would vanish; a [`Plan`](crate::profile::Plan) has none.
    pub fn narrowed(&mut self, swell: f32) {
        if swell <= 0.0 {
            return;
        }
        self.orientation_mark.iter_mut().for_each(|run| narrow_run(run, swell));
        // no key says how wide ticks are, so no plan is refused for them
        self.registration.iter_mut().for_each(|run| narrow_run(run, swell.min(run.width - LEAST_TICK)));
        narrow_dots(&mut self.frame, swell);
        narrow_lines(&mut self.figure.lines, swell);
        for glyph in self.figure.textures.iter_mut().flat_map(|texture| &mut texture.glyphs) {
            glyph.shape = glyph.shape.narrowed(swell);
        }
        if let Some(overview) = &mut self.overview {
            narrow_dots(&mut overview.frame, swell);
            narrow_lines(&mut overview.lines, swell);
        }
    }
}

impl Shape {
    /// The shape whose outline lies half of `swell` mm within this one's.
    #[must_use]
    pub fn narrowed(self, swell: f32) -> Self {
        match self {
            Self::Dot { diameter } => Self::Dot { diameter: (diameter - swell).max(0.0) },
            Self::Rhombus { length, thickness, degrees } => {
                // All four sides lie as far from the middle as the radius of the circle that touches them, and sides moved
                // inwards make a smaller rhombus of the same shape.
                let radius = 0.5 * length * thickness / length.hypot(thickness);
                let share = (1.0 - 0.5 * swell / radius).max(0.0);
                Self::Rhombus { length: length * share, thickness: thickness * share, degrees }
            }
        }
    }
}

fn narrow_run(run: &mut Run, swell: f32) {
    run.width = (run.width - swell).max(0.0);
}

fn narrow_lines(lines: &mut [Line], swell: f32) {
    lines.iter_mut().flat_map(|line| &mut line.runs).for_each(|run| narrow_run(run, swell));
}

fn narrow_dots(dots: &mut Dots, swell: f32) {
    dots.diameter = (dots.diameter - swell).max(0.0);
}

impl Page {
    /// Share of the figure that is black, 0..=1: the ink of its lines and glyphs by its area. Where lines meet, ink that lies
    /// on ink counts twice, which is a thousandth or two.
    pub fn black_share(&self) -> f32 {
        let of_run = |run: &Run| match run.pen {
            Pen::Stroke => run.width * crate::geom::polyline::length(&run.points),
            Pen::Dots(_) => run.points.len() as f32 * FRAC_PI_4 * run.width * run.width,
        };
        let lines: f32 = self.figure.lines.iter().flat_map(|line| &line.runs).map(of_run).sum();
        let glyphs: f32 = self.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(Glyph::area).sum();
        (lines + glyphs) / self.figure.place.area().max(f32::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::nearest_on_segment;
    use crate::units::MmPoint;

    /// Every corner of the narrow rhombus lies half of the swelling from the sides of the wide one, so that swelling by that
    /// much on each side gives the wide one.
    #[test]
    fn a_rhombus_is_narrowed_evenly_on_its_four_sides() {
        for (length, thickness, degrees) in [(2.2, 1.2, 0.0), (1.65, 0.6, 45.0), (3.0, 3.0, 135.0)] {
            let glyph = |shape| Glyph { at: MmPoint::new(10.0, 10.0), shape };
            let wide = Shape::Rhombus { length, thickness, degrees };
            let (outer, inner) = (glyph(wide).corners(), glyph(wide.narrowed(0.2)).corners());
            for i in 0..4 {
                let middle = inner[i].lerp(inner[(i + 1) % 4], 0.5);
                let (distance, _) = nearest_on_segment(middle, outer[i], outer[(i + 1) % 4]);
                assert!((distance - 0.1).abs() < 1e-5, "{length} x {thickness}: {distance}");
            }
        }
    }
}
