//! Text in the pixels of a picture: where it is, and the picture without it. What it says is not known.
//!
//! ```text
//! Lab planes -> glyph (thin connected parts, darker or lighter) -> chain (alike, side by side, at an angle)
//!            -> line (is it text?), or succession (1, 2, 3) of single ones that look like a character
//!            -> short labels in the style of others, and steps of them -> Lettering -> erase
//! ```
//!
//! A classical method: letters are connected components of a stroke's width, and text is a row of them that are alike
//! in height, stroke and colour (as in Epshtein, Ofek and Wexler 2010, with a top-hat transform in place of pairs of
//! edges).
//! Everything in it is a few pixels high, so text has to be large enough to be seen: from about 8 px on.

mod chain;
mod character;
mod erase;
mod glyph;
mod levels;
mod limits;
mod line;
mod look;
mod shape;
mod steps;
mod straight;
mod succession;

use self::erase::with_margin;
use self::levels::{Colours, Levels};
use self::limits::Strictness;
use self::line::{TextLine, corners, each_cell};
use self::look::Look;
pub use self::straight::{FoundLine, LinePicture};
use crate::raster::Raster;
use crate::raster::residue::Polarity;
use crate::units::{PxPoint, PxVector, Size};

/// Text that was found in a picture.
#[derive(Debug, Clone, Default)]
pub struct Lettering {
    /// Its lines, those that are clearest first.
    pub lines: Vec<FoundLine>,
    /// The pixels of the letters of each, with a margin.
    letters: Vec<Vec<usize>>,
}

/// Lines that overlap by more than this share are one, found twice.
const SAME: f32 = 0.3;
/// How often short labels are looked for, each time in the style of those found before too.
const ROUNDS: usize = 4;
/// Margin around letters that is erased with them, px, and in heights of letters.
const MARGIN: usize = 2;
const MARGIN_OF_HEIGHT: f32 = 0.04;

/// Whether something whose box has these sides, px, may be a letter, or a word whose letters touch one another.
pub fn may_be_letters(sides: PxVector) -> bool {
    let [longer, shorter] = [sides.x.max(sides.y), sides.x.min(sides.y)];
    longer <= (glyph::LONGEST + 1) as f32 && shorter <= (glyph::LARGEST + 1) as f32
}

impl Lettering {
    /// The text in a picture; of a drawing also where it differs from its ground in colour alone, and short labels.
    pub fn find(raster: &Raster, is_drawing: bool) -> Self {
        let size = raster.size();
        let colours = Colours::new(raster, is_drawing);
        let strict = if is_drawing { Strictness::Drawing } else { Strictness::Photograph };
        let mut found = Self::default();
        let mut taken = TextCover { size, cells: vec![false; size.len()] };
        let mut all: Vec<TextLine> = Vec::new();
        for plane in &colours.planes {
            let levels = Levels::of(plane);
            let look = |polarity| {
                let look = Look::new((plane, &levels), polarity, &colours, strict)?;
                let mut lines = look.lines(&colours);
                lines.extend(look.in_succession(&colours, &lines));
                Some((look, lines))
            };
            let (below, above) = rayon::join(|| look(Polarity::Below), || look(Polarity::Above));
            let (looks, found_by): (Vec<Look>, Vec<Vec<TextLine>>) = below.into_iter().chain(above).unzip();
            let numbered = found_by.into_iter().enumerate();
            let mut lines: Vec<(usize, TextLine)> =
                numbered.flat_map(|(of, lines)| lines.into_iter().map(move |line| (of, line))).collect();
            lines.sort_by(|a, b| b.1.score.total_cmp(&a.1.score));
            for _ in 0..=ROUNDS {
                let before = all.len();
                for (of, line) in lines {
                    if taken.add(&line) {
                        found.add(&looks[of], &line);
                        all.push(line);
                    }
                }
                if all.len() == before {
                    break;
                }
                let more = looks.iter().enumerate();
                lines = more
                    .flat_map(|(of, look)| look.in_style(&colours, &all).into_iter().map(move |line| (of, line)))
                    .collect();
            }
        }
        found
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// The picture in which this was found, without it: the ground closes over the letters.
    pub fn erased_from(&self, raster: &Raster) -> Raster {
        let mut mask = vec![false; raster.size().len()];
        self.letters.iter().flatten().for_each(|&pixel| mask[pixel] = true);
        erase::erased(raster, &mask)
    }

    /// Those lines of text that are kept.
    #[must_use]
    pub fn keeping(self, is_kept: impl Fn(&FoundLine) -> bool) -> Self {
        let (lines, letters) = self.lines.into_iter().zip(self.letters).filter(|(line, _)| is_kept(line)).unzip();
        Self { lines, letters }
    }

    /// Each line as a picture of its own, for somebody who reads it. `raster` is the picture in which it was found.
    pub fn pictures(&self, raster: &Raster) -> Vec<LinePicture> {
        self.lines.iter().map(|line| LinePicture::of(line, raster)).collect()
    }

    fn add(&mut self, look: &Look, line: &TextLine) {
        let size = look.thin.contrast.size;
        let reach = MARGIN + (MARGIN_OF_HEIGHT * line.height) as usize;
        self.letters.push(with_margin(&look.cells(line), &look.thin.set, size, reach));
        let corners = corners(line).map(|[x, y]| PxPoint::new(x, y));
        self.lines.push(FoundLine { corners, angle: line.angle, height: line.height });
    }
}

/// Where there are lines already.
struct TextCover {
    size: Size,
    cells: Vec<bool>,
}

impl TextCover {
    /// Adds a line, unless one is there already.
    fn add(&mut self, line: &TextLine) -> bool {
        let (mut all, mut before) = (0, 0);
        each_cell(self.size, line, |cell| {
            all += 1;
            before += usize::from(self.cells[cell]);
        });
        let is_new = before as f32 <= SAME * all as f32;
        if is_new {
            each_cell(self.size, line, |cell| self.cells[cell] = true);
        }
        is_new
    }
}
