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
mod tests {
    use super::*;
    use crate::devices::Device;
    use crate::page::{Class, DotMedium, Figure, Overview, Print, PrintText};
    use crate::units::Size;

    fn parts() -> Parts {
        let at = MmPoint::new(50.0, 50.0);
        let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(80.0, 80.0));
        let line = || Line { strength: 20.0, runs: vec![Run::stroke(1.0, vec![at, MmPoint::new(60.0, 50.0)])] };
        let rhombus = Glyph { at, shape: Shape::Rhombus { length: 3.0, thickness: 1.0, degrees: 45.0 } };
        let dot = Glyph { at, shape: Shape::Dot { diameter: 1.0 } };
        let texture = Texture {
            class: Class::Green,
            sign: Sign::Rhombus { degrees: 45.0 },
            colour: [0, 200, 0],
            area: 100.0,
            glyphs: vec![rhombus, dot],
        };
        let figure = Figure { place, source: Size::new(60, 60), textures: vec![texture], lines: vec![line()] };
        let dots = || Dots { diameter: 1.0, at: vec![at] };
        Parts {
            frame: dots(),
            orientation_mark: Some(Run::stroke(1.0, vec![at])),
            registration: vec![Run::stroke(1.0, vec![at])],
            overview: Some(Overview { place, frame: dots(), lines: vec![line()] }),
            labels: vec![dots()],
            print: vec![PrintText { string: "cup".into(), at, size: 3.0 }],
            ..Parts::of([100.0, 100.0], figure)
        }
    }

    /// A number of a page: its name, and where it is.
    type Number = (&'static str, fn(&mut Parts) -> &mut f32);

    /// Every number of a page, each by itself.
    fn numbers() -> Vec<Number> {
        fn rhombus(parts: &mut Parts) -> [&mut f32; 3] {
            match &mut parts.figure.textures[0].glyphs[0].shape {
                Shape::Rhombus { length, thickness, degrees } => [length, thickness, degrees],
                Shape::Dot { .. } => unreachable!("the first is a rhombus"),
            }
        }
        fn print(parts: &mut Parts) -> &mut Print {
            match &mut parts.medium {
                Medium::Print(print) => print,
                Medium::Dots(_) => unreachable!("it is printed"),
            }
        }
        vec![
            ("sheet", |parts| &mut parts.sheet[1]),
            ("frame", |parts| &mut parts.frame.diameter),
            ("frame's dot", |parts| &mut parts.frame.at[0].x),
            ("mark", |parts| &mut parts.orientation_mark.as_mut().expect("there is one").width),
            ("tick", |parts| &mut parts.registration[0].points[0].y),
            ("place", |parts| &mut parts.figure.place.max.x),
            ("line", |parts| &mut parts.figure.lines[0].runs[0].width),
            ("strength", |parts| &mut parts.figure.lines[0].strength),
            ("area", |parts| &mut parts.figure.textures[0].area),
            ("sign", |parts| match &mut parts.figure.textures[0].sign {
                Sign::Rhombus { degrees } => degrees,
                Sign::Dot => unreachable!("it is one of rhombuses"),
            }),
            ("glyph", |parts| &mut parts.figure.textures[0].glyphs[0].at.x),
            ("length", |parts| rhombus(parts).into_iter().next().expect("three")),
            ("thickness", |parts| rhombus(parts).into_iter().nth(1).expect("three")),
            ("degrees", |parts| rhombus(parts).into_iter().nth(2).expect("three")),
            ("diameter", |parts| match &mut parts.figure.textures[0].glyphs[1].shape {
                Shape::Dot { diameter } => diameter,
                Shape::Rhombus { .. } => unreachable!("the second is a dot"),
            }),
            ("overview", |parts| &mut parts.overview.as_mut().expect("there is one").place.min.y),
            ("overview's frame", |parts| &mut parts.overview.as_mut().expect("there is one").frame.diameter),
            ("overview's line", |parts| &mut parts.overview.as_mut().expect("there is one").lines[0].runs[0].width),
            ("label", |parts| &mut parts.labels[0].diameter),
            ("size of print", |parts| &mut parts.print[0].size),
            ("place of print", |parts| &mut parts.print[0].at.y),
            ("swell", |parts| &mut print(parts).swell),
            ("black", |parts| &mut print(parts).max_black),
        ]
    }

    #[test]
    fn a_number_that_is_not_finite_is_refused_wherever_it_stands() {
        assert!(Page::new(parts()).is_ok());
        for (name, number) in numbers() {
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let mut parts = parts();
                *number(&mut parts) = bad;
                let refused = Page::new(parts);
                assert!(matches!(refused, Err(Error::NoMeasure { .. } | Error::OffSheet(_))), "{name} of {bad}");
            }
        }
    }

    #[test]
    fn a_length_below_zero_is_refused() {
        for name in ["sheet", "frame", "mark", "line", "area", "sign", "length", "thickness", "diameter", "label"] {
            let (_, number) = numbers().into_iter().find(|(known, _)| *known == name).expect("in the list");
            let mut parts = parts();
            *number(&mut parts) = -1.0;
            let refused = Page::new(parts).expect_err(name);
            assert!(matches!(refused, Error::NoMeasure { value: -1.0, .. }), "{name}: {refused}");
        }
    }

    #[test]
    fn dots_lie_on_columns_that_ascend() {
        let device = Device::named("graphiti").expect("in the table");
        let field = device.field().expect("a display has a field");
        let medium = DotMedium::on(device, 2.5, field).expect("its own sheet and pitch");
        for bad in [f32::NAN, 0.0, f32::INFINITY] {
            let of_pitch = Medium::Dots(DotMedium { pitch: bad, ..medium.clone() });
            let mut turned = medium.clone();
            let DotArea::Grid(grid) = &mut turned.area else { unreachable!("pins are a grid") };
            grid.columns[3] = bad;
            for medium in [of_pitch, Medium::Dots(turned)] {
                let place = MmRect::new(MmPoint::zero(), MmPoint::new(10.0, 10.0));
                let figure = Figure { place, source: Size::new(9, 9), textures: vec![], lines: vec![] };
                let refused = Page::new(Parts { medium, ..Parts::of(field, figure) });
                assert!(matches!(refused, Err(Error::NoMeasure { .. })), "{bad}: {refused:?}");
            }
        }
    }
}
