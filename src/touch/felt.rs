//! A page as a fingertip feels it: which class is meant and which is felt, cell by cell.

use super::ink::Ink;
use super::measure::{self, CELLS_PER_MM, FINGERS, Feel};
use super::signs::Signs;
use crate::Error;
use crate::geom::distance::distances;
use crate::page::Class;
use crate::raster::plane::Plane;
use crate::units::{MmPoint, MmRect, Size};

/// Textures are judged this far inside their area, mm: nearer to a border, the window sees the other side as well.
pub const JUDGED_FROM: f32 = 7.0;

/// A texture has no holes wider than twice this, mm: what lies between its glyphs belongs to it. The rows of the
/// sparsest texture of the built-in profiles are 8.0 mm apart.
const REACH: f32 = 5.0;

/// Ink in a cell from which it counts as inked, 0..=1: a fifth of the smallest glyph.
const INKED: f32 = 0.1;

/// What is meant and what is felt in one cell of half a millimetre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// The class of the texture that lies here; `None` where there is none.
    pub meant: Option<Class>,
    /// The class that is felt; `None` is blank.
    pub felt: Option<Class>,
    /// Whether the reading is far from that of another class.
    pub clear: bool,
    /// Whether the cell is far enough from borders and lines to be judged: [`JUDGED_FROM`].
    pub judged: bool,
    /// The measure itself.
    pub feel: Feel,
}

/// A page as a fingertip feels it.
#[derive(Debug, Clone, PartialEq)]
pub struct FeltCells {
    /// Size of the fingertip, mm.
    pub finger: f32,
    /// The part of the sheet that was felt.
    pub area: MmRect,
    /// The sign of each class.
    pub signs: Signs,
    /// Number of cells from left to right and from top to bottom, [`CELLS_PER_MM`] to a millimetre.
    pub size: Size,
    /// All cells, row by row.
    pub cells: Vec<Cell>,
}

/// Feels the textures of a page with a fingertip of `finger` mm.
///
/// # Errors
/// If the text is no page, is too large, or there is no such fingertip; see [`Error`].
pub fn feel(svg: &str, finger: f32) -> Result<FeltCells, Error> {
    check(finger)?;
    Ink::of(svg)?.felt(finger)
}

fn check(finger: f32) -> Result<(), Error> {
    if FINGERS.contains(&finger) { Ok(()) } else { Err(Error::NoSuchFinger(finger)) }
}

impl Ink {
    /// Feels the textures with a fingertip of `finger` mm.
    ///
    /// # Errors
    /// If there is no such fingertip.
    pub fn felt(&self, finger: f32) -> Result<FeltCells, Error> {
        check(finger)?;
        let feels = measure::feel(&self.all_textures(), finger);
        let size = feels.size;
        let meant = self.meant(size);
        let border = self.borders(&meant, size);
        let cell = |((feel, meant), far): ((Feel, Option<Class>), f32)| {
            let (felt, clear) = self.signs.read(&feel, finger);
            Cell { meant, felt, clear, judged: far >= JUDGED_FROM * CELLS_PER_MM as f32, feel }
        };
        let cells = feels.cells.into_iter().zip(meant).zip(border).map(cell).collect();
        Ok(FeltCells { finger, area: self.area, signs: self.signs, size, cells })
    }

    /// The class of the texture that each cell belongs to: that of the nearest ink within [`REACH`], as a morphological
    /// closing (dilation, then erosion by the same distance).
    fn meant(&self, size: Size) -> Vec<Option<Class>> {
        let reach = REACH * CELLS_PER_MM as f32;
        let mut nearest = vec![(f32::INFINITY, None); size.len()];
        for (class, plane) in &self.textures {
            for (best, distance) in nearest.iter_mut().zip(distances(&inked(plane, size), size)) {
                if distance <= reach && distance < best.0 {
                    *best = (distance, Some(*class));
                }
            }
        }
        // The erosion: the area ends where its glyphs end.
        let outside: Vec<bool> = nearest.iter().map(|(_, class)| class.is_none()).collect();
        let inside = distances(&outside, size);
        nearest.into_iter().zip(inside).map(|((_, class), far)| class.filter(|_| far > reach)).collect()
    }

    /// How far each cell is from a line, or from where another class is meant, in cells.
    fn borders(&self, meant: &[Option<Class>], size: Size) -> Vec<f32> {
        let (width, height) = (size.width as usize, size.height as usize);
        let mut border = inked(&self.lines, size);
        for y in 0..height {
            for x in 0..width {
                let here = y * width + x;
                let differs = |there: usize| meant[there] != meant[here];
                border[here] |= (x + 1 < width && differs(here + 1)) || (y + 1 < height && differs(here + width));
            }
        }
        distances(&border, size)
    }
}

fn inked(plane: &Plane, size: Size) -> Vec<bool> {
    plane.shrunk(size).values.iter().map(|&ink| ink >= INKED).collect()
}

impl FeltCells {
    /// What is meant and felt at a point of the sheet; `None` outside the felt area, where all is blank.
    pub fn at(&self, at: MmPoint) -> Option<&Cell> {
        let from_corner = (at - self.area.min) * CELLS_PER_MM as f32;
        let (x, y) = (from_corner.x.floor(), from_corner.y.floor());
        let inside = x >= 0.0 && y >= 0.0 && x < self.size.width as f32 && y < self.size.height as f32;
        if inside { self.cells.get(y as usize * self.size.width as usize + x as usize) } else { None }
    }
}
