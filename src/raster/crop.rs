//! A part of a picture, given in pixels or in percent.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::Error;
use crate::units::Size;

/// A part of a picture: where it begins, from the left and from the top, its width and its height.
///
/// ```
/// use tactograph::Crop;
/// let crop: Crop = "10%,25%,50%,50%".parse()?;
/// assert_eq!(crop.to_string(), "10%,25%,50%,50%");
/// # Ok::<(), tactograph::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crop([Length; 4]);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Length {
    Pixels(u32),
    Percent(f64),
}

/// A part of a picture in whole pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Part {
    /// Pixels to the left of it.
    pub(crate) left: u32,
    /// Pixels above it.
    pub(crate) top: u32,
    /// Width and height.
    pub(crate) size: Size,
}

impl Part {
    /// All of a picture.
    pub(crate) fn whole(size: Size) -> Self {
        Self { left: 0, top: 0, size }
    }
}

impl Crop {
    /// The part of a picture of `size` pixels; what is in percent is rounded to whole pixels, its edges one by one, so
    /// that parts that touch in percent touch in pixels.
    ///
    /// # Errors
    /// If it is not wholly in the picture, or empty.
    pub(crate) fn part(&self, size: Size) -> Result<Part, Error> {
        let [x, y, width, height] = self.0;
        let along = |from: Length, length: Length, side: u32| {
            let whole = f64::from(side);
            let exact = |length: Length| match length {
                Length::Pixels(pixels) => f64::from(pixels),
                Length::Percent(percent) => 0.01 * percent * whole,
            };
            let (start, end) = (exact(from).round(), (exact(from) + exact(length)).round());
            (end > start && end <= whole).then_some((start as u32, (end - start) as u32))
        };
        match (along(x, width, size.width), along(y, height, size.height)) {
            (Some((left, width)), Some((top, height))) => Ok(Part { left, top, size: Size::new(width, height) }),
            _ => Err(Error::NotInPicture { part: self.to_string(), size }),
        }
    }
}

impl FromStr for Crop {
    type Err = Error;

    /// # Errors
    /// [`Error::NotACrop`] for a text that says no part of a picture, or one that is empty.
    fn from_str(text: &str) -> Result<Self, Error> {
        let lengths: Vec<Length> =
            text.split(',').map(|text| length(text.trim())).collect::<Option<_>>().ok_or(Error::NotACrop)?;
        let lengths: [Length; 4] = lengths.try_into().map_err(|_| Error::NotACrop)?;
        let is_empty = |length: &Length| matches!(length, Length::Pixels(0)) || *length == Length::Percent(0.0);
        if lengths[2..].iter().any(is_empty) { Err(Error::NotACrop) } else { Ok(Self(lengths)) }
    }
}

fn length(text: &str) -> Option<Length> {
    match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse().ok().filter(|p| (0.0..=100.0).contains(p)).map(Length::Percent),
        None => text.strip_suffix("px").unwrap_or(text).trim().parse().ok().map(Length::Pixels),
    }
}

impl Display for Crop {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        for (i, length) in self.0.iter().enumerate() {
            f.write_str(if i == 0 { "" } else { "," })?;
            match length {
                Length::Pixels(pixels) => write!(f, "{pixels}")?,
                Length::Percent(percent) => write!(f, "{percent}%")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(text: &str) -> Option<[u32; 4]> {
        let part = text.parse::<Crop>().ok()?.part(Size::new(601, 400)).ok()?;
        Some([part.left, part.top, part.size.width, part.size.height])
    }

    #[test]
    fn parts_are_in_pixels_or_percent() {
        for (text, want) in [
            ("0,0,601,400", [0, 0, 601, 400]),
            ("0%,0%,100%,100%", [0, 0, 601, 400]),
            ("10, 20px ,50%, 12.5%", [10, 20, 301, 50]),
            ("50%,0,50%,1", [301, 0, 300, 1]),
            ("0,0,50%,1", [0, 0, 301, 1]),
        ] {
            assert_eq!(part(text), Some(want), "{text}");
        }
    }

    #[test]
    fn what_is_no_part_of_the_picture_is_refused() {
        for text in
            ["", "1,2,3", "1,2,3,4,5", "0,0,0,5", "0,0,5,0%", "-1,0,5,5", "0,0,101%,5", "0,0,nan%,5", "0,0,1.5,2"]
        {
            assert!(text.parse::<Crop>().is_err(), "{text}");
        }
        for text in ["1,0,601,400", "50%,0,51%,5", "601,0,1,1", "0,400,1,1", "4294967295,0,4294967295,1", "0,0,0.01%,5"]
        {
            assert!(text.parse::<Crop>().is_ok() && part(text).is_none(), "{text}");
        }
    }
}
