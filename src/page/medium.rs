//! What a page is made for: ink on paper, or dots that a device raises. Decided once, when the page is laid out.

use crate::Error;
use crate::devices::{Device, DotArea, Grid};
use crate::units::MmRect;

/// What a page is made for, with everything that only this medium needs.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Medium {
    /// It is printed.
    Print(Print),
    /// A device raises it as dots; then every mark is a dot that the device can raise.
    Dots(DotMedium),
}

/// The same before the sheet is laid out: where a device can put dots depends on how the sheet lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MediumParams {
    /// It is printed.
    Print(Print),
    /// A device raises it as dots.
    Dots {
        /// The device.
        device: &'static Device,
        /// Distance of its dots, mm, as the device has it ([`Device::pitches`]).
        pitch: f32,
    },
}

/// How ink behaves on the paper.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Print {
    /// How much wider marks become when they rise, mm: they are printed narrower by as much.
    pub swell: f32,
    /// Share of the figure that may be black without a note, 0..=1.
    pub max_black: f32,
}

/// The dots of a device on one sheet.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DotMedium {
    /// The device.
    pub device: &'static Device,
    /// Distance of its dots, mm.
    pub pitch: f32,
    /// Where on the sheet dots can be.
    pub area: DotArea,
}

impl Medium {
    /// The distance of the dots that marks stand on, mm; on paper 0, as marks stand anywhere.
    pub(crate) fn pitch(&self) -> f32 {
        match self {
            Self::Print(_) => 0.0,
            Self::Dots(dots) => dots.pitch,
        }
    }

    /// What its marks are on, in words.
    pub(crate) fn name_of_sheet(&self) -> &'static str {
        match self {
            Self::Dots(dots) if !dots.device.takes_paper() => "display",
            Self::Print(_) | Self::Dots(_) => "sheet",
        }
    }

    /// What a page for it on a sheet of this width and length, mm, says of it, as entries of its origin: by them it is
    /// read again.
    pub(super) fn to_origin(&self, sheet: [f32; 2]) -> Vec<(&'static str, String)> {
        let number = |value: f32| value.to_string();
        match self {
            Self::Print(print) => {
                vec![("print.swell", number(print.swell)), ("print.max_black", number(print.max_black))]
            }
            Self::Dots(dots) => vec![
                ("page.width", number(sheet[0])),
                ("page.height", number(sheet[1])),
                ("dots.device", format!("\"{}\"", dots.device.id)),
                ("dots.pitch", number(dots.pitch)),
            ],
        }
    }

    /// Whether there are dots of different heights.
    pub fn has_heights(&self) -> bool {
        match self {
            Self::Print(_) => false,
            Self::Dots(dots) => dots.device.has_heights(),
        }
    }
}

impl DotMedium {
    /// The dots of a device on a sheet of this width and length, mm.
    ///
    /// # Errors
    /// As [`Device::dot_area`]: if the device does not take the sheet or has no such pitch.
    pub fn on(device: &'static Device, pitch: f32, sheet: [f32; 2]) -> Result<Self, Error> {
        let area = device.dot_area(sheet, pitch)?;
        Ok(Self { device, pitch, area })
    }

    /// No dot at all, for a sheet that the device does not take.
    pub(super) fn without_dots(device: &'static Device, pitch: f32) -> Self {
        Self { device, pitch, area: DotArea::Grid(Grid { columns: Vec::new(), rows: Vec::new() }) }
    }

    /// Diameter of a dot as it is felt, mm.
    pub fn diameter(&self) -> f32 {
        self.device.diameter()
    }

    /// The part of the sheet that dots stand for: on a grid a dot stands for what is half a pitch around it,
    /// elsewhere the bounds are those of the centres of dots.
    pub(super) fn usable(&self) -> MmRect {
        let half = match self.area {
            DotArea::Grid(_) => 0.5 * self.pitch,
            DotArea::Free(_) => 0.0,
        };
        self.area.bounds().inflate(half, half)
    }
}
