//! The formats that pages are written in: drawings of the marks, and files that hold dots and nothing else.

use crate::devices::{Device, Family};
use crate::error::{self, Error};

/// A format of pages. There are these two kinds and no more: it is matched to choose the writer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// A drawing of all marks at their true size; any page can be drawn.
    Drawing(DrawingFormat),
    /// Where dots are and nothing else, for pages of dots.
    Dots(DotFormat),
}

/// A format of drawings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DrawingFormat {
    /// A drawing, to be changed.
    Svg,
    /// A document, to be printed.
    Pdf,
    /// A picture.
    Png,
}

/// A format of dots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DotFormat {
    /// Unicode braille, for CUPS.
    Ubrl,
    /// ASCII braille, for any embosser of text.
    Brf,
    /// The Portable Embosser Format.
    Pef,
    /// The language of Index embossers.
    Idx,
    /// G-code for BrailleRAP.
    Gcode,
    /// A PNG picture of a pixel a dot.
    Pixels,
    /// Plain text.
    Txt,
}

impl DrawingFormat {
    /// All of them, the usual one first.
    pub const ALL: &'static [Self] = &[Self::Svg, Self::Pdf, Self::Png];

    /// Its name in lower case, which is also how the names of its files end.
    pub fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Png => "png",
        }
    }

    /// The format of this name in lower case.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "format of drawings", Self::ALL.iter().copied(), Self::name)
    }
}

impl DotFormat {
    /// All of them.
    pub const ALL: &'static [Self] =
        &[Self::Ubrl, Self::Brf, Self::Pef, Self::Idx, Self::Gcode, Self::Pixels, Self::Txt];

    /// Its name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ubrl => "ubrl",
            Self::Brf => "brf",
            Self::Pef => "pef",
            Self::Idx => "idx",
            Self::Gcode => "gcode",
            Self::Pixels => "pixels",
            Self::Txt => "txt",
        }
    }

    /// The format of this name in lower case.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "format of dots", Self::ALL.iter().copied(), Self::name)
    }

    /// How the names of its files end, without the point.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Pixels => "png",
            other => other.name(),
        }
    }

    /// The formats that a device takes, the best one first.
    pub fn of(device: &Device) -> &'static [Self] {
        match device.family {
            Family::IndexV3 { .. } | Family::IndexV4 => &[Self::Idx, Self::Ubrl, Self::Pef, Self::Pixels, Self::Txt],
            Family::BrailleRap { .. } => &[Self::Gcode],
            Family::ViewPlus | Family::Pins { .. } => &[Self::Pixels, Self::Ubrl, Self::Pef, Self::Txt],
            Family::Cells => &[Self::Brf, Self::Txt],
        }
    }

    /// Whether a device takes it.
    ///
    /// # Errors
    /// [`Error::NotItsFormat`], with what it takes instead.
    pub fn check(self, device: &Device) -> Result<(), Error> {
        let all = Self::of(device);
        if all.contains(&self) {
            return Ok(());
        }
        let takes = all.iter().map(|format| format.name()).collect();
        Err(Error::NotItsFormat { format: self.name(), device: device.name, takes })
    }

    /// Whether its files say what an embosser is told beside the dots: copies and impact, and a sheet and a pitch that
    /// hold for all of their pages.
    #[doc(hidden)]
    pub fn tells_embosser(self) -> bool {
        match self {
            Self::Idx => true,
            Self::Ubrl | Self::Brf | Self::Pef | Self::Gcode | Self::Pixels | Self::Txt => false,
        }
    }

    /// A built-in profile whose pages can be written in it.
    pub fn example_profile(self) -> &'static str {
        match self {
            Self::Brf => "braille-cells",
            Self::Gcode => "braillerap",
            Self::Pixels => "viewplus-columbia",
            Self::Txt => "dot-pad",
            Self::Ubrl | Self::Pef | Self::Idx => "index-basic-d",
        }
    }
}

impl Format {
    /// All of them, the usual one first.
    pub const ALL: &'static [Self] = &[
        Self::Drawing(DrawingFormat::Svg),
        Self::Drawing(DrawingFormat::Pdf),
        Self::Drawing(DrawingFormat::Png),
        Self::Dots(DotFormat::Ubrl),
        Self::Dots(DotFormat::Brf),
        Self::Dots(DotFormat::Pef),
        Self::Dots(DotFormat::Idx),
        Self::Dots(DotFormat::Gcode),
        Self::Dots(DotFormat::Pixels),
        Self::Dots(DotFormat::Txt),
    ];

    /// Its name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drawing(format) => format.name(),
            Self::Dots(format) => format.name(),
        }
    }

    /// The format of this name in lower case.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "format of pages", Self::ALL.iter().copied(), Self::name)
    }

    /// How the names of its files end, without the point.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Drawing(format) => format.name(),
            Self::Dots(format) => format.extension(),
        }
    }

    /// The format of files whose names end so, in any case; `png` is the drawing.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

#[cfg(test)]
mod tests;
