//! The constructor of a page and the check that it goes through: every number of every mark, and that all marks lie on
//! the sheet.

use super::medium::Medium;
use super::parts::{Dots, Glyph, Line, Page, Parts, Run, Shape, Sign, Texture};
use crate::Error;
use crate::devices::DotArea;
use crate::units::{MmPoint, MmRect};

impl Page {
    /// Makes a page of its parts.
    ///
    /// # Errors
    /// [`Error::NoMeasure`] if a number of a mark, of the sheet or of the medium is not finite, or a length is below 0;
    /// [`Error::OffSheet`] if a mark reaches beyond the sheet.
    pub fn new(parts: Parts) -> Result<Self, Error> {
        check(&parts)?;
        Ok(Self { parts })
    }
}

fn check(parts: &Parts) -> Result<(), Error> {
    let [width, height] = parts.sheet;
    above_zero("width of a sheet", width)?;
    above_zero("height of a sheet", height)?;
    medium(&parts.medium)?;
    let overview = parts.overview.iter();
    place("place of a figure", parts.figure.place)?;
    overview.clone().try_for_each(|overview| place("place of an overview", overview.place))?;
    let sheet = SheetBounds { width, height };
    let frames = [&parts.frame].into_iter().chain(overview.clone().map(|overview| &overview.frame));
    frames.into_iter().try_for_each(|dots| sheet.dots("a dot of a frame", dots))?;
    parts.labels.iter().try_for_each(|dots| sheet.dots("a dot of a label", dots))?;
    parts.braille.iter().try_for_each(|text| sheet.dots("a dot of braille", &text.dots))?;
    parts.print.iter().try_for_each(|text| {
        above_zero("size of letters", text.size)?;
        sheet.holds("a word in print", text.at, 0.0)
    })?;
    parts.braille.iter().filter_map(|text| text.leader.as_ref()).try_for_each(|run| sheet.run("a leader line", run))?;
    let mut lines = parts.figure.lines.iter().chain(overview.flat_map(|overview| &overview.lines));
    lines.try_for_each(|line| sheet.line(line))?;
    let mut marks = parts.orientation_mark.iter().chain(&parts.registration);
    marks.try_for_each(|run| sheet.run("a mark beside the picture", run))?;
    parts.figure.textures.iter().try_for_each(|texture| sheet.texture(texture))
}

struct SheetBounds {
    width: f32,
    height: f32,
}

impl SheetBounds {
    /// A mark that reaches `radius` mm around a point.
    fn holds(&self, what: &'static str, at: MmPoint, radius: f32) -> Result<(), Error> {
        let Self { width, height } = self;
        // NaN fails every comparison, so it is caught here as well.
        let inside =
            at.x - radius >= 0.0 && at.y - radius >= 0.0 && at.x + radius <= *width && at.y + radius <= *height;
        let off = || format!("{what} lies at {} mm, {} mm, off the sheet of {width} x {height} mm", at.x, at.y);
        if inside { Ok(()) } else { Err(Error::OffSheet(off())) }
    }

    fn dots(&self, what: &'static str, dots: &Dots) -> Result<(), Error> {
        not_below_zero("diameter of a dot", dots.diameter)?;
        dots.at.iter().try_for_each(|&at| self.holds(what, at, 0.5 * dots.diameter))
    }

    fn line(&self, line: &Line) -> Result<(), Error> {
        not_below_zero("strength of a line", line.strength)?;
        line.runs.iter().try_for_each(|run| self.run("a line", run))
    }

    fn run(&self, what: &'static str, run: &Run) -> Result<(), Error> {
        not_below_zero("width of a line", run.width)?;
        run.points.iter().try_for_each(|&at| self.holds(what, at, 0.5 * run.width))
    }

    fn texture(&self, texture: &Texture) -> Result<(), Error> {
        not_below_zero("area of a texture", texture.area)?;
        if let Sign::Rhombus { degrees } = texture.sign {
            need("direction of a sign in degrees", degrees, (0.0..180.0).contains(&degrees))?;
        }
        texture.glyphs.iter().try_for_each(|glyph| self.glyph(glyph))
    }

    fn glyph(&self, glyph: &Glyph) -> Result<(), Error> {
        match glyph.shape {
            Shape::Rhombus { length, thickness, degrees } => {
                not_below_zero("length of a rhombus", length)?;
                not_below_zero("thickness of a rhombus", thickness)?;
                need("direction of a rhombus in degrees", degrees, degrees.is_finite())?;
            }
            Shape::Dot { diameter } => not_below_zero("diameter of a dot", diameter)?,
        }
        self.holds("a glyph", glyph.at, glyph.radius())
    }
}

fn medium(medium: &Medium) -> Result<(), Error> {
    match medium {
        Medium::Print(print) => {
            need("swelling of marks", print.swell, print.swell.is_finite())?;
            not_below_zero("share that may be black", print.max_black)
        }
        Medium::Dots(dots) => {
            above_zero("pitch of dots", dots.pitch)?;
            match &dots.area {
                DotArea::Free(area) => place("area of dots", *area),
                DotArea::Grid(grid) => {
                    ascending("column of dots", &grid.columns)?;
                    ascending("row of dots", &grid.rows)
                }
            }
        }
    }
}

fn ascending(what: &'static str, centres: &[f32]) -> Result<(), Error> {
    centres.iter().try_for_each(|&centre| need(what, centre, centre.is_finite()))?;
    centres.windows(2).try_for_each(|pair| need(what, pair[1], pair[0] < pair[1]))
}

fn place(what: &'static str, place: MmRect) -> Result<(), Error> {
    [place.min.x, place.min.y, place.max.x, place.max.y]
        .into_iter()
        .try_for_each(|side| need(what, side, side.is_finite()))
}

fn above_zero(what: &'static str, value: f32) -> Result<(), Error> {
    need(what, value, value.is_finite() && value > 0.0)
}

fn not_below_zero(what: &'static str, value: f32) -> Result<(), Error> {
    need(what, value, value.is_finite() && value >= 0.0)
}

fn need(what: &'static str, value: f32, good: bool) -> Result<(), Error> {
    if good { Ok(()) } else { Err(Error::NoMeasure { what, value }) }
}

#[cfg(test)]
mod tests;
