//! The fingertip: what would be felt on a page, from the page alone.
//!
//! ```text
//! SVG -> Ink (resvg, 8 px/mm) -> measure (blur, structure tensor) -> Felt (class meant and class felt, place by place)
//!                                                                    `-> Report (shares, ink, density), map (a picture)
//! ```
//!
//! It sees what is drawn, and the ids of the layers with the sign that each stands for, no record of how the page was made: so
//! it says the same of a page that somebody changed in an editor as of a new one, and it can judge the textures of this
//! program as a stranger would.
//!
//! [`measure`] gives the measure exactly. It is a model, not a finger: it knows lumps and slopes, not skin. What it says is
//! good for comparing textures and for finding areas where nothing could be told.

mod count;
mod distance;
mod ink;
mod letters;
pub mod map;
pub mod measure;
pub mod report;
mod signs;

pub use distance::distances;
pub use ink::Ink;
pub use measure::{CELLS_PER_MM, Feel};
pub use report::Report;
pub use signs::Signs;

use crate::page::Class;
use crate::raster::plane::Plane;
use crate::units::{MmPoint, MmRect, Size};

/// Sizes of fingertips that can be asked for, mm: beyond the largest, the window is no wider than the fingertip.
pub const FINGERS: std::ops::RangeInclusive<f32> = 0.3..=2.5;

/// Textures are judged this far inside their area, mm: nearer to a border, the window sees the other side as well.
pub const JUDGED_FROM: f32 = 7.0;

/// A texture has no holes wider than twice this, mm: what lies between its glyphs belongs to it. The rows of the sparsest
/// texture of the built-in profiles are 8.0 mm apart.
const REACH: f32 = 5.0;

/// Ink in a cell from which it counts as inked, 0..=1: a fifth of the smallest glyph.
const INKED: f32 = 0.1;

/// Why a page cannot be felt.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text is no SVG that can be drawn.
    #[error("this is not an SVG page that can be read: {0}; give a page that tactograph made")]
    NotSvg(String),
    /// None of the ids of a page is there.
    #[error(
        "this is no page of tactograph: it has no group with the id figure or texture-blue (-green, -yellow, -red, -grey); give a page that tactograph made"
    )]
    NotAPage,
    /// More than there is room for.
    #[error(
        "the figure is {width} x {height} mm, and at most {longest} x {longest} mm can be felt; check the page's size in mm"
    )]
    TooLarge {
        /// Width of all that is drawn, mm.
        width: f32,
        /// Its height, mm.
        height: f32,
        /// The limit, mm.
        longest: f32,
    },
    /// There is no such fingertip.
    #[error("a fingertip of {0} mm is not known; give one from {low} to {high} mm", low = FINGERS.start(), high = FINGERS.end())]
    Finger(f32),
}

/// What is meant and what is felt at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The class of the texture that lies here; `None` where there is none.
    pub meant: Option<Class>,
    /// The class that is felt; `None` is blank.
    pub felt: Option<Class>,
    /// Whether the feeling is far from that of another class.
    pub clear: bool,
    /// Whether the place is far enough from borders and lines to be judged: [`JUDGED_FROM`].
    pub judged: bool,
    /// The measure itself.
    pub feel: Feel,
}

/// A page as a fingertip feels it.
#[derive(Debug, Clone, PartialEq)]
pub struct Felt {
    /// Size of the fingertip, mm.
    pub finger: f32,
    /// The part of the sheet that was felt.
    pub area: MmRect,
    /// The signs that the classes were told by.
    pub signs: Signs,
    /// Places from left to right and from top to bottom, [`CELLS_PER_MM`] to a millimetre.
    pub size: Size,
    /// All places, row by row.
    pub places: Vec<Place>,
}

/// Feels the textures of a page with a fingertip of `finger` mm.
///
/// # Errors
/// If the text is no page, is too large, or there is no such fingertip; see [`Error`].
pub fn feel(svg: &str, finger: f32) -> Result<Felt, Error> {
    check(finger)?;
    Ink::of(svg)?.felt(finger)
}

fn check(finger: f32) -> Result<(), Error> {
    if FINGERS.contains(&finger) { Ok(()) } else { Err(Error::Finger(finger)) }
}

impl Ink {
    /// Feels the textures with a fingertip of `finger` mm.
    ///
    /// # Errors
    /// If there is no such fingertip.
    pub fn felt(&self, finger: f32) -> Result<Felt, Error> {
        check(finger)?;
        let feels = measure::feel(&self.all_textures(), finger);
        let size = feels.size;
        let meant = self.meant(size);
        let border = self.borders(&meant, size);
        let place = |((feel, meant), far): ((Feel, Option<Class>), f32)| {
            let (felt, clear) = self.signs.read(&feel, finger);
            Place { meant, felt, clear, judged: far >= JUDGED_FROM * CELLS_PER_MM as f32, feel }
        };
        let places = feels.cells.into_iter().zip(meant).zip(border).map(place).collect();
        Ok(Felt { finger, area: self.area, signs: self.signs, size, places })
    }

    /// The class of the texture that each cell belongs to: that of the nearest ink, unless a hole or the outside lies here.
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
        // Back by the same reach, so that the area ends where its glyphs end.
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

impl Felt {
    /// What is meant and felt at a place on the sheet; `None` outside of the felt area, where all is blank.
    pub fn at(&self, at: MmPoint) -> Option<&Place> {
        let cell = (at - self.area.min) * CELLS_PER_MM as f32;
        let (x, y) = (cell.x.floor(), cell.y.floor());
        let inside = x >= 0.0 && y >= 0.0 && x < self.size.width as f32 && y < self.size.height as f32;
        if inside { self.places.get(y as usize * self.size.width as usize + x as usize) } else { None }
    }
}
