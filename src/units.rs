//! Two spaces and the one transform from the first to the second.
//!
//! *Picture space* is in pixels, x right, y down, pixel centres at +0.5. *Page space* is in millimetres, x right, y
//! down, (0, 0) the sheet's top-left corner. The types keep them apart: a point in pixels does not fit where a point in
//! millimetres is asked for. [`PageTransform`] takes pixels to millimetres, and nothing else does.

use lyon::geom::euclid;

/// Marks a value in pixels of a picture: of the working picture in the stages, of the source in a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Px;

/// Marks a value in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Mm;

/// A point in a picture, in its pixels.
pub type PxPoint = euclid::Point2D<f32, Px>;
/// A direction and distance in a picture, in its pixels.
pub type PxVector = euclid::Vector2D<f32, Px>;
/// A point on the sheet, in millimetres.
pub type MmPoint = euclid::Point2D<f32, Mm>;
/// A direction and distance on the sheet, in millimetres.
pub type MmVector = euclid::Vector2D<f32, Mm>;
/// A rectangle on the sheet, in millimetres.
pub type MmRect = euclid::Box2D<f32, Mm>;

/// Millimetres of a CSS pixel, in which SVG is computed.
pub(crate) const MM_PER_CSS_PX: f32 = 25.4 / 96.0;

/// A place or a length on a picture, as a person gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Length {
    /// In pixels of the picture.
    Pixels(f64),
    /// In percent of a side of the picture.
    Percent(f64),
    /// In mm of the figure on the sheet.
    Mm(f64),
}

impl Length {
    /// From `412.5`, `412px`, `30%` or `12 mm`; none if it is no number that is finite. Blanks around number and unit
    /// do not matter.
    pub(crate) fn of_text(text: &str) -> Option<Self> {
        type OfNumber = fn(f64) -> Length;
        const UNITS: [(&str, OfNumber); 3] = [("mm", Length::Mm), ("%", Length::Percent), ("px", Length::Pixels)];
        let text = text.trim();
        let written = UNITS.into_iter().find_map(|(ending, unit)| Some((text.strip_suffix(ending)?.trim_end(), unit)));
        let (number, unit) = written.unwrap_or((text, Self::Pixels));
        number.parse().ok().filter(|number: &f64| number.is_finite()).map(unit)
    }
}

/// As it is parsed: `412.5`, `30%`, `12mm`.
impl std::fmt::Display for Length {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Pixels(pixels) => write!(f, "{pixels}"),
            Self::Percent(percent) => write!(f, "{percent}%"),
            Self::Mm(mm) => write!(f, "{mm}mm"),
        }
    }
}

/// Width and height in whole pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Size {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
}

impl Size {
    /// A size of `width` by `height` pixels.
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    /// How many pixels there are in all.
    pub const fn area(self) -> u64 {
        self.width as u64 * self.height as u64
    }

    /// Width and height exchanged, as after a quarter turn.
    pub const fn turned(self) -> Self {
        Self::new(self.height, self.width)
    }

    /// [`Size::area`] as a length for a plane in memory.
    pub(crate) const fn len(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} x {}", self.width, self.height)
    }
}

/// Where the working picture lies on the sheet: a scale for each axis and an offset. The scales differ by less than a
/// pixel over the whole side: the sides of a working picture are whole pixels, and those of its rectangle are not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PageTransform {
    origin: MmPoint,
    across: f32,
    down: f32,
    mm_per_px: f32,
}

impl PageTransform {
    /// Lays a picture of `size` pixels into the rectangle `place`, corner on corner.
    pub fn new(size: Size, place: MmRect) -> Self {
        let (across, down) = (place.width() / size.width as f32, place.height() / size.height as f32);
        let mm_per_px = if size.width >= size.height { across } else { down };
        Self { origin: place.min, across, down, mm_per_px }
    }

    /// Millimetres on the sheet for one pixel of the picture, for lengths without a direction: the scale of the longer
    /// side, where rounding to whole pixels matters least.
    pub fn mm_per_px(&self) -> f32 {
        self.mm_per_px
    }

    /// Pixels of the picture for one millimetre on the sheet, likewise.
    pub fn px_per_mm(&self) -> f32 {
        1.0 / self.mm_per_px
    }

    /// The point on the sheet of a point in the picture.
    pub fn to_mm(&self, at: PxPoint) -> MmPoint {
        MmPoint::new(self.origin.x + at.x * self.across, self.origin.y + at.y * self.down)
    }

    /// The point in the picture of a point on the sheet.
    pub fn to_px(&self, at: MmPoint) -> PxPoint {
        PxPoint::new((at.x - self.origin.x) / self.across, (at.y - self.origin.y) / self.down)
    }
}

#[cfg(test)]
mod tests;
