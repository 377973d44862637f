//! Labels as the maker of a page gives them: where on the picture, and what they say.

use std::str::FromStr;

use crate::Error;
use crate::units::{Length, MmPoint, MmRect, Size};

/// Blank between labels and lines or textures, mm: as other programs leave around braille on graphics.
pub(super) const CLEARANCE: f32 = 3.0;

/// A label at a point of the picture, or of the part of it that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// How far from the left.
    pub x: Position,
    /// How far from the top.
    pub y: Position,
    /// What it says.
    pub text: String,
}

/// A place along a side of the picture: a number that is finite, of pixels or of percent. What is off the picture is
/// told by a note.
///
/// ```
/// use tactograph::{Length, Position};
/// let place = Position::percent(30.0)?;
/// assert_eq!((place, place.length()), ("30%".parse()?, Length::Percent(30.0)));
/// # Ok::<(), tactograph::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position(Place);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Percent(f64),
    Pixels(f64),
}

impl Position {
    /// A place in percent of the side: 0 is the left or upper edge, 100 the other.
    ///
    /// # Errors
    /// [`Error::NotAPosition`] if the number is not finite.
    pub fn percent(percent: f64) -> Result<Self, Error> {
        Self::of(Length::Percent(percent))
    }

    /// A place in pixels of the upright picture from its left or upper edge; of SVG and PDF in CSS px (1/96 inch).
    ///
    /// # Errors
    /// [`Error::NotAPosition`] if the number is not finite.
    pub fn pixels(pixels: f64) -> Result<Self, Error> {
        Self::of(Length::Pixels(pixels))
    }

    fn of(length: Length) -> Result<Self, Error> {
        match length {
            Length::Percent(percent) if percent.is_finite() => Ok(Self(Place::Percent(percent))),
            Length::Pixels(pixels) if pixels.is_finite() => Ok(Self(Place::Pixels(pixels))),
            _ => Err(Error::NotAPosition),
        }
    }

    /// How far it is from the left or upper edge, as it was given.
    pub fn length(self) -> Length {
        match self.0 {
            Place::Percent(percent) => Length::Percent(percent),
            Place::Pixels(pixels) => Length::Pixels(pixels),
        }
    }
}

impl FromStr for Position {
    type Err = Error;

    /// From "30%", "412.5" or "412.5px".
    ///
    /// # Errors
    /// [`Error::NotAPosition`] if it is no number that is finite, or one of mm.
    fn from_str(text: &str) -> Result<Self, Error> {
        Length::of_text(text).ok_or(Error::NotAPosition).and_then(Self::of)
    }
}

/// As it is parsed: `30%`, `412.5`.
impl std::fmt::Display for Position {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.length().fmt(f)
    }
}

impl Position {
    /// Where a place on the sheet is in a figure, across and down; one outside is at its edge.
    pub(super) fn in_figure(at: MmPoint, figure: MmRect) -> [Self; 2] {
        let percent = |at: f32, low: f32, side: f32| {
            let percent = (100.0 * (at - low) / side).clamp(0.0, 100.0);
            // of a figure without extent, its edge
            Self::percent(percent.into()).unwrap_or(Self(Place::Percent(0.0)))
        };
        [percent(at.x, figure.min.x, figure.width()), percent(at.y, figure.min.y, figure.height())]
    }

    /// Share of the side, 0 to 1 within the picture.
    pub(super) fn share(self, pixels: u32) -> f32 {
        match self.0 {
            Place::Percent(percent) => 0.01 * percent as f32,
            Place::Pixels(at) => at as f32 / pixels as f32,
        }
    }
}

/// The first column of a row, without its quotation marks, and the columns behind it.
fn part(row: &str, parting: char) -> Option<(&str, &str)> {
    match row.trim_start_matches(' ').strip_prefix('"') {
        Some(quoted) => {
            let (field, rest) = quoted.split_once('"')?;
            Some((field.trim(), rest.trim_start_matches(' ').strip_prefix(parting)?))
        }
        None => row.split_once(parting).map(|(field, rest)| (field.trim(), rest)),
    }
}

/// What may part the columns of a list of labels.
const PARTING: [char; 3] = [',', ';', '\t'];

impl Label {
    /// Labels from text with one in a row: x, y and what it says, parted by commas, semicolons or tabs. Empty
    /// rows and a first row of headings (`x,y,text`) are passed over. Numbers may have a decimal comma where columns
    /// are parted by semicolons or tabs; a text may stand in quotation marks, with two for one.
    ///
    /// # Errors
    /// [`Error::NotLabels`] with everything that is wrong, each with its line.
    pub fn from_csv(text: &str) -> Result<Vec<Self>, Error> {
        let (mut labels, mut faults) = (Vec::new(), Vec::new());
        let rows = (1..).zip(text.trim_start_matches('\u{feff}').lines()).filter(|(_, row)| !row.trim().is_empty());
        for (i, (line, row)) in rows.enumerate() {
            let is_heading = i == 0 && row.trim_start().trim_start_matches('"').starts_with(['x', 'X']);
            match Self::of_row(row) {
                Ok(label) => labels.push(label),
                Err(_) if is_heading => {}
                Err(what) => faults.push(format!("line {line}: {what}")),
            }
        }
        if faults.is_empty() { Ok(labels) } else { Err(Error::NotLabels(faults)) }
    }

    /// A row is parted by the first letter that can part it. Where that gives no numbers, it may have been a decimal
    /// comma, as spreadsheets write it in many countries.
    fn of_row(row: &str) -> Result<Self, String> {
        let mut is_quoted = false;
        let is_parting = |letter: &char| {
            is_quoted ^= *letter == '"';
            !is_quoted && PARTING.contains(letter)
        };
        let first = row.chars().find(is_parting).unwrap_or(',');
        let label = Self::of_parts(row, first);
        let others = PARTING.into_iter().filter(|parting| *parting != first && *parting != ',');
        label.or_else(|fault| others.map(|parting| Self::of_parts(row, parting)).find_map(Result::ok).ok_or(fault))
    }

    fn of_parts(row: &str, parting: char) -> Result<Self, String> {
        let parts = part(row, parting).and_then(|(x, rest)| Some((x, part(rest, parting)?)));
        let Some((x, (y, text))) = parts else {
            return Err("write x, y and the text, such as 30%,45%,apple".to_owned());
        };
        let text = text.trim();
        let is_percent = |number: &str| number.trim().ends_with('%') && number.parse::<Position>().is_ok();
        let is_more = text.split_once(parting).is_some_and(|(first, _)| is_percent(first));
        // 12,5%,20,5%,text: both numbers are divided at their commas
        let is_divided = parting == ','
            && x.ends_with('%') != y.ends_with('%')
            && text.split_once(parting).is_some_and(|(whole, _)| whole.trim().parse::<Position>().is_ok());
        if is_more || is_divided {
            return Err("there are more columns than x, y and the text; put a number with a decimal comma, or a text \
                        with a comma, in quotation marks"
                .to_owned());
        }
        let position = |text: &str, name: char| {
            let number = text.replace(',', ".");
            number.parse().map_err(|_| {
                let text: String = text.chars().take(20).collect();
                format!("{name} must be a number of pixels or a percentage such as 30%, not \"{text}\"")
            })
        };
        let (x, y) = (position(x, 'x')?, position(y, 'y')?);
        if text.strip_prefix('"').is_some_and(|rest| !rest.replace("\"\"", "").contains('"')) {
            return Err("the quotation mark before the text is not closed; a text stands on one line".to_owned());
        }
        let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        let text = quoted.map_or_else(|| text.to_owned(), |text| text.replace("\"\"", "\""));
        if text.trim().is_empty() {
            return Err("the text is empty".to_owned());
        }
        Ok(Self { x, y, text })
    }

    /// Where it belongs on the sheet, for a picture of this size that is drawn there; `None` outside of the picture.
    pub(super) fn on(&self, place: MmRect, source: Size) -> Option<MmPoint> {
        let (x, y) = (self.x.share(source.width), self.y.share(source.height));
        let inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
        inside.then(|| MmPoint::new(place.min.x + x * place.width(), place.min.y + y * place.height()))
    }
}

#[cfg(test)]
mod tests;
