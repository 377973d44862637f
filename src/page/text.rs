//! All marks of a page as plain text, so that a diff shows in what two pages differ.

use std::fmt::{Display, Formatter, Result};

use super::medium::{DotMedium, Medium};
use super::parts::{Dots, Line, Page, Pen, Run, Shape};
use crate::devices::DotArea;

impl Display for Page {
    /// Writes all marks, one a row, in millimetres with two decimals.
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "sheet {} x {}", self.sheet[0], self.sheet[1])?;
        match &self.medium {
            // the sheet says all
            Medium::Print(_) => {}
            Medium::Dots(DotMedium { area: DotArea::Grid(grid), .. }) => {
                writeln!(f, "grid of {} x {} dots", grid.columns.len(), grid.rows.len())?;
            }
            Medium::Dots(DotMedium { area: DotArea::Free(_), .. }) => writeln!(f, "dots anywhere")?,
        }
        writeln!(f, "title {}", self.title)?;
        writeln!(f, "description {}", self.description)?;
        write_dots(f, "frame", &self.frame)?;
        if let Some(mark) = &self.orientation_mark {
            write!(f, "orientation mark")?;
            write_run(f, mark)?;
        }
        for tick in &self.registration {
            write!(f, "tick")?;
            write_run(f, tick)?;
        }
        let place = self.figure.place;
        writeln!(f, "figure {:.2} {:.2} to {:.2} {:.2}", place.min.x, place.min.y, place.max.x, place.max.y)?;
        for texture in &self.figure.textures {
            writeln!(f, "texture {}: {} glyphs", texture.class.name(), texture.glyphs.len())?;
            for glyph in &texture.glyphs {
                match glyph.shape {
                    Shape::Rhombus { length, thickness, .. } => {
                        writeln!(f, "  {:.2} {:.2} rhombus {length:.2} x {thickness:.2}", glyph.at.x, glyph.at.y)?;
                    }
                    Shape::Dot { diameter } => writeln!(f, "  {:.2} {:.2} dot {diameter:.2}", glyph.at.x, glyph.at.y)?,
                }
            }
        }
        self.figure.lines.iter().try_for_each(|line| write_line(f, line))?;
        if let Some(overview) = &self.overview {
            let place = overview.place;
            write_dots(f, "overview frame", &overview.frame)?;
            writeln!(f, "overview {:.2} {:.2} to {:.2} {:.2}", place.min.x, place.min.y, place.max.x, place.max.y)?;
            overview.lines.iter().try_for_each(|line| write_line(f, line))?;
        }
        self.labels.iter().try_for_each(|label| write_dots(f, "label", label))?;
        self.braille.iter().try_for_each(|text| {
            writeln!(f, "braille {} {}", text.role.name(), text.lines.join(" "))?;
            write_dots(f, "braille", &text.dots)?;
            text.leader.iter().try_for_each(|run| {
                write!(f, "leader line")?;
                write_run(f, run)
            })
        })
    }
}

fn write_dots(f: &mut Formatter<'_>, name: &str, dots: &Dots) -> Result {
    if dots.at.is_empty() {
        return Ok(());
    }
    let range = |values: Vec<f32>| values.into_iter().fold((f32::MAX, f32::MIN), |(a, b), v| (a.min(v), b.max(v)));
    let (left, right) = range(dots.at.iter().map(|at| at.x).collect());
    let (top, bottom) = range(dots.at.iter().map(|at| at.y).collect());
    let (count, diameter) = (dots.at.len(), dots.diameter);
    writeln!(f, "{name} of {count} dots {diameter:.2}: {left:.2} {top:.2} to {right:.2} {bottom:.2}")
}

fn write_line(f: &mut Formatter<'_>, line: &Line) -> Result {
    writeln!(f, "line of strength {:.1}, length {:.1}", line.strength, line.length())?;
    for run in &line.runs {
        write_run(f, run)?;
    }
    Ok(())
}

fn write_run(f: &mut Formatter<'_>, run: &Run) -> Result {
    match run.pen {
        Pen::Stroke => write!(f, "  {:.2} wide:", run.width)?,
        Pen::Dots(height) => write!(f, "  dots {:.2} wide, {}:", run.width, height.name())?,
    }
    for at in run.polyline().path() {
        write!(f, " {:.2},{:.2}", at.x, at.y)?;
    }
    writeln!(f)
}
