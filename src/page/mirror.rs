//! A page as seen from its back.

use super::{Dots, Glyph, Line, Page, Run, Shape};
use crate::units::{MmPoint, MmRect};

impl Page {
    /// The same page with left and right exchanged, marks and frames included: for a machine that presses the dots of a sheet
    /// up from its back.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        // On a grid, columns change places.
        let width = match &self.parts.press {
            Some(press) => press.room.bounds().min.x + press.room.bounds().max.x,
            None => self.parts.sheet[0],
        };
        let parts = &mut self.parts;
        let runs = parts.orientation_mark.iter_mut().chain(&mut parts.registration);
        runs.for_each(|run| mirror_run(run, width));
        parts.labels.iter_mut().for_each(|dots| mirror_dots(dots, width));
        mirror_dots(&mut parts.frame, width);
        mirror_rect(&mut parts.figure.place, width);
        mirror_lines(&mut parts.figure.lines, width);
        for texture in &mut parts.figure.textures {
            texture.sign = texture.sign.mirrored();
            texture.glyphs.iter_mut().for_each(|glyph| mirror_glyph(glyph, width));
        }
        if let Some(overview) = &mut parts.overview {
            mirror_rect(&mut overview.place, width);
            mirror_dots(&mut overview.frame, width);
            mirror_lines(&mut overview.lines, width);
        }
        self
    }
}

fn mirror(at: &mut MmPoint, width: f32) {
    at.x = width - at.x;
}

fn mirror_rect(rect: &mut MmRect, width: f32) {
    (rect.min.x, rect.max.x) = (width - rect.max.x, width - rect.min.x);
}

fn mirror_dots(dots: &mut Dots, width: f32) {
    dots.at.iter_mut().for_each(|at| mirror(at, width));
}

fn mirror_run(run: &mut Run, width: f32) {
    run.points.iter_mut().for_each(|at| mirror(at, width));
}

fn mirror_lines(lines: &mut [Line], width: f32) {
    lines.iter_mut().flat_map(|line| &mut line.runs).for_each(|run| mirror_run(run, width));
}

fn mirror_glyph(glyph: &mut Glyph, width: f32) {
    mirror(&mut glyph.at, width);
    if let Shape::Rhombus { degrees, .. } = &mut glyph.shape {
        *degrees = 180.0 - *degrees;
    }
}
