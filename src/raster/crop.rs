//! A part of a picture, given in pixels, in percent or in mm of the figure.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::Error;
use crate::units::{Length, Size};

/// A part of a picture: where it begins, from the left and from the top, its width and its height. The picture counts
/// upright, after the turn that EXIF asks for. Each is in pixels (of SVG and PDF CSS px, 1/96 inch),
/// in percent or, for what is [erased](crate::Options::erase) or [kept](crate::Options::keep), in mm of the figure on
/// the sheet, from its top left corner; these may be mixed.
///
/// ```
/// use tactograph::{Crop, Length};
/// let crop = Crop::percent(10.0, 25.0, 50.0, 50.0)?;
/// assert_eq!(crop.to_string(), "10%,25%,50%,50%");
/// assert_eq!(crop, "10%,25%,50%,50%".parse()?);
/// let mixed: Crop = "320,200,50%,50%".parse()?;
/// assert_eq!([mixed.left(), mixed.width()], [Length::Pixels(320.0), Length::Percent(50.0)]);
/// assert_eq!(mixed, Crop::new(mixed.left(), mixed.top(), mixed.width(), mixed.height())?);
/// # Ok::<(), tactograph::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crop([Length; 4]);

/// A part of a picture in whole pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct PixelPart {
    /// Pixels to the left of it.
    pub(crate) left: u32,
    /// Pixels above it.
    pub(crate) top: u32,
    /// Width and height.
    pub(crate) size: Size,
}

impl PixelPart {
    /// All of a picture.
    pub(crate) fn whole(size: Size) -> Self {
        Self { left: 0, top: 0, size }
    }
}

impl Crop {
    /// A part whose numbers may each have a unit of its own.
    ///
    /// # Errors
    /// [`Error::NotACrop`] if it is empty, pixels are no whole number, or a number is out of the range that
    /// [`Crop::percent`] and [`Crop::mm`] say.
    pub fn new(left: Length, top: Length, width: Length, height: Length) -> Result<Self, Error> {
        Self::of([left, top, width, height])
    }

    /// A part in pixels.
    ///
    /// # Errors
    /// [`Error::NotACrop`] if it is empty.
    pub fn pixels(left: u32, top: u32, width: u32, height: u32) -> Result<Self, Error> {
        Self::of([left, top, width, height].map(|pixels| Length::Pixels(pixels.into())))
    }

    /// A part in percent of the picture's width and height, 0 to 100.
    ///
    /// # Errors
    /// [`Error::NotACrop`] if a number is out of its range, or the part is empty.
    pub fn percent(left: f64, top: f64, width: f64, height: f64) -> Result<Self, Error> {
        Self::of([left, top, width, height].map(Length::Percent))
    }

    /// A part in millimetres of the figure on the sheet, 0 to 10 000, for [`Options::erase`](crate::Options::erase) and
    /// [`Options::keep`](crate::Options::keep). Where a picture is cropped it is refused with [`Error::PartInMm`], as
    /// the figure is laid out later.
    ///
    /// # Errors
    /// [`Error::NotACrop`] if a number is out of its range, or the part is empty.
    pub fn mm(left: f64, top: f64, width: f64, height: f64) -> Result<Self, Error> {
        Self::of([left, top, width, height].map(Length::Mm))
    }

    /// How far from the left it begins, as it was given.
    pub fn left(&self) -> Length {
        self.0[0]
    }

    /// How far from the top it begins, as it was given.
    pub fn top(&self) -> Length {
        self.0[1]
    }

    /// How wide it is, as it was given.
    pub fn width(&self) -> Length {
        self.0[2]
    }

    /// How high it is, as it was given.
    pub fn height(&self) -> Length {
        self.0[3]
    }

    /// Whether any of it is in mm of the figure, so that it can be erased or kept and not be the part that is drawn.
    pub fn is_in_mm(&self) -> bool {
        self.0.iter().any(|length| matches!(length, Length::Mm(_)))
    }

    fn of(lengths: [Length; 4]) -> Result<Self, Error> {
        let is_fine = lengths.iter().all(is_in_range) && !lengths[2..].iter().any(is_nothing);
        if is_fine { Ok(Self(lengths)) } else { Err(Error::NotACrop) }
    }

    /// Whether it is all of a picture, by what it says.
    pub(crate) fn is_all(&self) -> bool {
        let whole = Length::Percent(100.0);
        self.0[..2].iter().all(is_nothing) && self.0[2..] == [whole, whole]
    }

    /// Whether two parts are the same, as far as that can be said without the size of the picture: lengths in different
    /// units may be the same.
    pub(crate) fn may_be_same(&self, other: &Self) -> bool {
        let may_be = |(a, b): (&Length, &Length)| {
            let is_other_unit = std::mem::discriminant(a) != std::mem::discriminant(b);
            a == b || is_nothing(a) && is_nothing(b) || is_other_unit && !is_nothing(a) && !is_nothing(b)
        };
        self.0.iter().zip(&other.0).all(may_be)
    }

    /// The part of a picture of `size` pixels; what is in percent is rounded to whole pixels, its edges one by one, so
    /// that parts that touch in percent touch in pixels.
    ///
    /// # Errors
    /// If it is not wholly in the picture, or empty.
    pub(crate) fn part(&self, size: Size) -> Result<PixelPart, Error> {
        let [x, y, width, height] = self.0;
        let along = |from: Length, length: Length, side: u32| {
            let whole = f64::from(side);
            let exact = |length: Length| match length {
                Length::Pixels(pixels) => Some(pixels),
                Length::Percent(percent) => Some(0.01 * percent * whole),
                Length::Mm(_) => None,
            };
            let (start, length) = (exact(from)?, exact(length)?);
            let (start, end) = (start.round(), (start + length).round());
            (end > start && end <= whole).then_some((start as u32, (end - start) as u32))
        };
        if self.is_in_mm() {
            return Err(Error::PartInMm { part: self.to_string() });
        }
        match (along(x, width, size.width), along(y, height, size.height)) {
            (Some((left, width)), Some((top, height))) => Ok(PixelPart { left, top, size: Size::new(width, height) }),
            _ => Err(Error::NotInPicture { part: self.to_string(), size }),
        }
    }
}

impl Crop {
    /// Left, top, right and bottom as shares of a picture of `size` pixels, whose figure is so wide and high, mm.
    ///
    /// # Errors
    /// If it reaches beyond the picture.
    pub(crate) fn shares(&self, size: Size, figure: [f32; 2]) -> Result<[f32; 4], Error> {
        let [x, y, width, height] = self.0;
        let along = |from: Length, length: Length, pixels: u32, mm: f32| {
            let share = |length: Length| match length {
                Length::Pixels(count) => count / f64::from(pixels),
                Length::Percent(percent) => 0.01 * percent,
                Length::Mm(length) => length / f64::from(mm),
            };
            let (start, end) = (share(from), share(from) + share(length));
            // what is measured on the sheet may be a little off, and so may be what is rounded
            let slack = f64::from(MM_SLACK / mm);
            (start < 1.0 && end <= 1.0 + slack).then_some([start as f32, end.min(1.0) as f32])
        };
        match (along(x, width, size.width, figure[0]), along(y, height, size.height, figure[1])) {
            (Some([left, right]), Some([top, bottom])) => Ok([left, top, right, bottom]),
            _ => {
                let part = self.to_string();
                Err(Error::NotInFigure { part, size, width: figure[0], height: figure[1] })
            }
        }
    }
}

/// How far a part in mm may reach beyond the figure, mm: less than a ruler shows.
const MM_SLACK: f32 = 0.25;

impl FromStr for Crop {
    type Err = Error;

    /// Four numbers with commas between them: left, top, width and height, in pixels (`20,30,400,300`), percent
    /// (`10%,0%,50%,100%`) or millimetres of the figure (`12mm,0mm,60mm,40mm`); blanks around them do not matter.
    ///
    /// # Errors
    /// [`Error::NotACrop`] for a text that says no part of a picture, or one that is empty.
    fn from_str(text: &str) -> Result<Self, Error> {
        let lengths: Vec<Length> =
            text.split(',').map(Length::of_text).collect::<Option<_>>().ok_or(Error::NotACrop)?;
        Self::of(lengths.try_into().map_err(|_| Error::NotACrop)?)
    }
}

/// No sheet is longer, mm.
const LONGEST_MM: f64 = 10_000.0;

fn is_in_range(length: &Length) -> bool {
    match length {
        Length::Pixels(pixels) => pixels.fract().abs() <= 0.0 && (0.0..=f64::from(u32::MAX)).contains(pixels),
        Length::Percent(percent) => (0.0..=100.0).contains(percent),
        Length::Mm(mm) => (0.0..=LONGEST_MM).contains(mm),
    }
}

fn is_nothing(length: &Length) -> bool {
    [Length::Pixels(0.0), Length::Percent(0.0), Length::Mm(0.0)].contains(length)
}

impl Display for Crop {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        for (i, length) in self.0.iter().enumerate() {
            write!(f, "{}{length}", if i == 0 { "" } else { "," })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
