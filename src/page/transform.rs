//! Changes of every mark of a page: narrower, for paper on which ink swells, and mirrored, for the back of the sheet.

use super::medium::Medium;
use super::parts::{Dots, Glyph, Line, MIRRORED, Page, Parts, Run, Shape};
use crate::units::{MmPoint, MmRect};

/// The narrowest that a tick is printed, mm: ticks are aligned by eye as well as by touch.
const LEAST_TICK: f32 = 0.5;

impl Parts {
    /// Makes all marks narrower by `swell` mm, half of it on each side, so that they have the size that they have now
    /// once they have risen (of a `swell` below 0, wider). Labels and braille stay: their dots already have the size to
    /// be printed. A mark that is no wider than `swell` would vanish; a profile that is taken has none.
    pub fn narrowed(&mut self, swell: f32) {
        if swell == 0.0 {
            return;
        }
        self.orientation_mark.iter_mut().for_each(|run| narrow_run(run, swell));
        // No key says how wide ticks are, so no plan is refused for them.
        self.braille.iter_mut().filter_map(|text| text.leader.as_mut()).for_each(|run| narrow_run(run, swell));
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

impl Page {
    /// The page with its marks as wide as they are felt, once they have risen by as much as they were narrowed.
    #[must_use]
    pub fn risen(&self) -> Self {
        let mut page = self.clone();
        if let Medium::Print(print) = page.parts.medium {
            page.parts.narrowed(-print.swell);
        }
        page
    }
}

impl Shape {
    /// The shape whose outline lies half of `swell` mm within this one's.
    #[must_use]
    pub fn narrowed(self, swell: f32) -> Self {
        match self {
            Self::Dot { diameter } => Self::Dot { diameter: (diameter - swell).max(0.0) },
            Self::Rhombus { length, thickness, degrees } => {
                // All four sides lie as far from the middle as the radius of the circle that touches them, and sides
                // moved inwards make a smaller rhombus of the same shape.
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
    /// What the x of a mark and that of its mirror image add up to, mm. Dots change places with each other, even where
    /// they do not lie in the middle of the sheet.
    pub(crate) fn mirror_sum(&self) -> f32 {
        match &self.parts.medium {
            Medium::Print(_) => self.parts.sheet[0],
            Medium::Dots(dots) => dots.area.bounds().min.x + dots.area.bounds().max.x,
        }
    }

    /// The same page with left and right exchanged, marks and frames included, for a machine that embosses a sheet
    /// from its back; of such a page the one that fingers meet. Words in print are left out, as letters have no other
    /// side. Its description stays, as it tells what fingers meet.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        let (width, was_mirrored) = (self.mirror_sum(), self.is_mirrored());
        let parts = &mut self.parts;
        parts.print.clear();
        match was_mirrored {
            true => parts.origin.retain(|(name, _)| name != MIRRORED),
            false => parts.origin.push((MIRRORED.to_owned(), "true".to_owned())),
        }
        let leaders = parts.braille.iter_mut().filter_map(|text| text.leader.as_mut());
        let runs = parts.orientation_mark.iter_mut().chain(&mut parts.registration).chain(leaders);
        runs.for_each(|run| mirror_run(run, width));
        let braille = parts.braille.iter_mut().map(|text| &mut text.dots);
        parts.labels.iter_mut().chain(braille).for_each(|dots| mirror_dots(dots, width));
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
        *degrees = (180.0 - *degrees).rem_euclid(180.0);
    }
}

#[cfg(test)]
mod tests;
