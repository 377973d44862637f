//! The language of Index embossers, generations 3 to 5, byte by byte what the drivers of CUPS (cups-filters 1.28, V3
//! and V4) send for the same dots.
//!
//! ```text
//! ESC D TM0,BI0,FO0,[MCn,]MIn,DP1,TD0,GDn,PN0,<paper>,LSn,BT0;   for this document only: no margins, no page numbers
//! ESC 07                                                          bands of four rows of dots
//!   a band    a byte a column, 0x40 + the top dot in bit 0 ... the bottom one in bit 3; blank ends left out; CR LF
//!   FF        before the first byte of the next page, and after the last page
//! ESC 06                                                          as before
//! 1A                                                              the end
//! ```
//!
//! A V3 is told the paper in inches or millimetres, a V4 or V5 how many cells of text have room on it.

use crate::Error;
use crate::devices::{Device, Family, INDEX_MARGIN_V4, Paper, SHORTEST_SIDE, hundredths};

use super::dot_matrix::DotMatrix;

/// What an Index embosser is told beside the dots; other formats have no place for it, and leave it unsaid. Default:
/// one copy, struck as usual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Embossing {
    copies: u16,
    impact: u8,
}

/// Most copies of a document: three digits, and a day's work.
const MOST_COPIES: u16 = 999;
/// How often a dot can be struck, from soft paper to hard.
const MOST_IMPACT: u8 = 3;

impl Embossing {
    /// How many copies the embosser makes, 1 to 999, and how hard it strikes: 1, as usual, to 3, for hard paper.
    ///
    /// ```
    /// use tactograph::Embossing;
    /// let twice = Embossing::new(2, 1)?;
    /// assert_eq!((twice.copies(), twice.impact()), (2, 1));
    /// assert_eq!(Embossing::new(0, 1).map_err(|error| error.id()), Err("no-such-embossing"));
    /// # Ok::<(), tactograph::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoSuchEmbossing`] if a number is out of its range.
    pub fn new(copies: u16, impact: u8) -> Result<Self, Error> {
        if (1..=MOST_COPIES).contains(&copies) && (1..=MOST_IMPACT).contains(&impact) {
            Ok(Self { copies, impact })
        } else {
            Err(Error::NoSuchEmbossing { copies, most_copies: MOST_COPIES, impact, most_impact: MOST_IMPACT })
        }
    }

    /// How many copies the embosser makes.
    pub fn copies(self) -> u16 {
        self.copies
    }

    /// How hard it strikes.
    pub fn impact(self) -> u8 {
        self.impact
    }
}

impl Default for Embossing {
    fn default() -> Self {
        Self { copies: 1, impact: 1 }
    }
}

/// Which language an embosser speaks.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Generation {
    /// V3, which is told the size of the paper so.
    V3(Paper),
    /// V4 and V5.
    V4,
}

/// What the header of a document says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    generation: Generation,
    /// Width and length, hundredths of a millimetre.
    sheet: [i64; 2],
    /// The number of the pitch.
    graphic_distance: u8,
    embossing: Embossing,
}

impl Params {
    /// For a sheet of this width and length, mm, and dots this far apart, mm.
    ///
    /// Whether the device takes the sheet is not asked here: [`Device::dot_area`] tells.
    ///
    /// # Errors
    /// All faults at once, each a line that says what can be.
    pub fn new(device: &Device, sheet: [f32; 2], pitch: f32, embossing: Embossing) -> Result<Self, Vec<String>> {
        let name = device.name;
        let generation = match device.family {
            Family::IndexV3 { paper } => Some(Generation::V3(paper)),
            Family::IndexV4 => Some(Generation::V4),
            Family::BrailleRap { .. } | Family::ViewPlus | Family::Pins { .. } | Family::Cells => None,
        };
        let graphic_distance = device.pitches().find(pitch).and_then(graphic_distance);
        let faults: Vec<String> = [
            generation.is_none().then(|| format!("{name} does not speak the language of Index embossers")),
            (generation.is_some() && graphic_distance.is_none()).then(|| device.pitch_fault(pitch)),
            (!sheet.iter().all(|side| (SHORTEST_SIDE..=LONGEST).contains(side))).then(|| {
                format!("the sheet is {} x {} mm; sides can be {SHORTEST_SIDE} to {LONGEST} mm", sheet[0], sheet[1])
            }),
        ]
        .into_iter()
        .flatten()
        .collect();
        match (generation, graphic_distance) {
            (Some(generation), Some(graphic_distance)) if faults.is_empty() => {
                Ok(Self { generation, sheet: sheet.map(hundredths), graphic_distance, embossing })
            }
            _ => Err(faults),
        }
    }

    /// The header, as text between ESC and the dots.
    fn header(&self) -> String {
        let Self { generation, sheet: [width, length], graphic_distance, embossing: Embossing { copies, impact } } =
            *self;
        let copies = if copies == 1 { String::new() } else { format!(",MC{copies}") };
        let paper = match generation {
            Generation::V3(Paper::Inches) => format!("PW{},PL{},LS4", inches(width), inches(length)),
            Generation::V3(Paper::Millimetres) => format!("PW{},PL{},LS4", width / 100, length / 100),
            Generation::V3(Paper::Unsaid) => "LS4".into(),
            Generation::V4 => format!(
                "CH{},LP{},LS50",
                (width - 2 * INDEX_MARGIN_V4 + CELL_GAP) / (TEXT_DOT + CELL_GAP),
                (length - 2 * INDEX_MARGIN_V4 + LINE_GAP) / (2 * TEXT_DOT + LINE_GAP)
            ),
        };
        format!("DTM0,BI0,FO0{copies},MI{impact},DP1,TD0,GD{graphic_distance},PN0,{paper},BT0;")
    }
}

/// Longest side of a sheet, mm: the 10 m of the driver.
const LONGEST: f32 = 10_000.0;

// Text, which the driver counts in hundredths of a millimetre even where there is none: dots 2.5 mm apart (TD0),
// cells 3.5 mm and lines 5 mm from each other (LS4 or LS50), six dots a cell, on the sheet without the margins of a
// V4.
const TEXT_DOT: i64 = 250;
const CELL_GAP: i64 = 350;
const LINE_GAP: i64 = 500;

/// The embosser's number for a pitch in mm.
fn graphic_distance(pitch: f32) -> Option<u8> {
    match (pitch * 10.0).round() as u8 {
        20 => Some(0),
        25 => Some(1),
        16 => Some(2),
        _ => None,
    }
}

/// Whole inches and a digit for the fraction, rounded down: 0 none, 1 a quarter, 2 a third, 3 a half, 4 two thirds, 5
/// three quarters.
fn inches(hundredths: i64) -> String {
    // The driver's arithmetic: 120ths of an inch.
    let of_120 = hundredths * 12 / 254;
    let fraction = match of_120 % 120 {
        ..30 => 0,
        30..40 => 1,
        40..60 => 2,
        60..80 => 3,
        80..90 => 4,
        _ => 5,
    };
    format!("{}{fraction}", of_120 / 120)
}

const ESC: u8 = 0x1b;

/// The document as the embosser takes it.
pub fn write(pages: &[DotMatrix], params: &Params) -> Vec<u8> {
    let mut bytes = vec![ESC];
    bytes.extend(params.header().bytes());
    bytes.extend([ESC, 0x07]);
    for page in pages {
        for band in 0..page.rows().div_ceil(4) {
            let start = bytes.len();
            // Whole cells, as CUPS has them: an odd last column brings a blank one.
            bytes.extend((0..page.columns()).map(|x| column(page, x, 4 * band)));
            while bytes.len() > start && bytes.last() == Some(&BLANK) {
                bytes.pop();
            }
            bytes.extend(b"\r\n");
        }
        bytes.push(0x0c);
    }
    if !pages.is_empty() {
        bytes.push(b'\r'); // The driver ends the line that holds the last form feed.
    }
    bytes.extend([ESC, 0x06, 0x1a]);
    bytes
}

/// A column of four blank dots.
const BLANK: u8 = 0x40;

fn column(page: &DotMatrix, x: usize, top: usize) -> u8 {
    (0..4).fold(BLANK, |byte, bit| byte | u8::from(page.is_raised(x, top + bit)) << bit)
}
