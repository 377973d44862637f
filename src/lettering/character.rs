//! Which digits and capitals a shape looks like. A digit alone is told from other small shapes by what it is.
//!
//! A character is a few strokes, which are stretched to the box of the shape: the shape looks like it if its pixels lie
//! on them, if they lie on its pixels, and if it encloses no more.

use super::glyph::LetterShape;
use crate::geom::components::{self, Connectivity};
use crate::geom::distance::distances;
use crate::geom::nearest_on_segment;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, Size};

/// The strokes of digits and capitals, as most fonts have them: column and row of points of a lattice that fills the
/// box of the middles of the strokes, and `|` between two strokes. I, which is a bar, and J are none of them. Chosen by
/// us: in 16 fonts of Debian 95 in 100 characters 24 px high look like themselves, and 90 more than like any other.
const CHARACTERS: [(char, &str); 41] = [
    ('0', "40 71 84 77 48 17 04 11 40"),
    ('1', "02 80 88"),
    ('1', "01 40 48|08 88"),
    ('2', "01 20 50 71 82 73 64 08 88"),
    ('2', "02 11 40 71 82 73 54 08 88"),
    ('3', "01 20 50 71 82 73 44 24|44 74 86 77 58 28 07"),
    ('4', "60 05 85|60 68"),
    ('5', "70 10 04 33 63 75 86 77 58 28 07"),
    ('6', "71 50 31 13 05 06 17 48 77 86 75 53 33 15"),
    ('7', "00 80 28"),
    ('7', "00 80 43 28"),
    ('8', "40 61 72 63 44 23 12 21 40|44 75 86 77 48 17 06 15 44"),
    ('9', "17 38 57 75 83 82 71 40 11 02 13 35 55 73"),
    ('A', "08 40 88|25 65"),
    ('B', "00 08 58 77 86 75 54 04|00 50 71 72 63 54"),
    ('C', "81 60 40 11 04 17 48 68 87"),
    ('D', "00 08 38 67 84 61 30 00"),
    ('E', "80 00 08 88|04 74"),
    ('F', "80 00 08|04 74"),
    ('G', "81 60 40 11 04 17 48 68 87 84 54"),
    ('H', "00 08|80 88|04 84"),
    ('K', "00 08|80 04 88"),
    ('K', "00 08|80 05|33 88"),
    ('L', "00 08 88"),
    ('M', "08 00 45 80 88"),
    ('M', "08 00 48 80 88"),
    ('N', "08 00 88 80"),
    ('O', "40 71 84 77 48 17 04 11 40"),
    ('P', "08 00 50 71 82 73 54 04"),
    ('Q', "40 71 84 77 48 17 04 11 40|55 88"),
    ('Q', "40 71 83 76 47 16 03 11 40|57 78"),
    ('R', "08 00 50 71 82 73 54 04|44 88"),
    ('S', "71 50 30 11 02 13 54 75 86 77 58 38 07"),
    ('T', "00 80|40 48"),
    ('U', "00 05 17 38 58 77 85 80"),
    ('V', "00 48 80"),
    ('W', "00 28 40 68 80"),
    ('W', "00 28 42 68 80"),
    ('X', "00 88|80 08"),
    ('Y', "00 44 80|44 48"),
    ('Z', "00 80 08 88"),
];
/// Steps of the lattice along a side of the box.
const STEPS: f32 = 8.0;
/// How far pixels are off the strokes and strokes off the pixels, both on average, together at most, in heights of the
/// shape; and how far one of them is at most. Chosen by us: of those characters nine in ten are within them, of zodiac
/// signs, chess pieces, notes and other small signs one in ten.
const OFF: f32 = 0.025;
const FARTHEST: f32 = 0.16;
/// What is less unlike than this beyond the character that is most alike may be meant as well; of a shape that may be
/// more than so many digits, or more than so many capitals, none is: the strokes of a blob are anywhere. Chosen by us:
/// of those characters 10 to 18 px high 99 in 100 are known by them, of bold ones 95.
const UNSURE: f32 = 0.005;
const MOST: usize = 3;
/// Points of a stroke are looked at so far apart, in heights.
const APART: f32 = 1.0 / 24.0;
/// A point of a stroke lies on a pixel if it is no further from the middle of one, px: half a diagonal.
const ON_PIXEL: f32 = 0.71;

/// A character that a shape looks like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Likeness {
    pub(super) character: char,
    /// How unlike they are, in heights.
    pub(super) off: f32,
}

/// The digits and capitals that a shape looks like, in a picture so many columns wide: of the digits the one that is
/// most alike and those that are hardly less so, and so of the capitals.
pub(super) fn likenesses(of: &LetterShape, width: usize) -> Vec<Likeness> {
    let shape = Shape::of(of, width);
    let mut all: Vec<Likeness> = Vec::new();
    for &(character, strokes) in &CHARACTERS {
        let Some(off) = (if shape.holes > holes(character) { None } else { shape.off(strokes) }) else { continue };
        match all.last_mut().filter(|last| last.character == character) {
            Some(last) => last.off = last.off.min(off),
            None => all.push(Likeness { character, off }),
        }
    }
    all.sort_by(|a, b| a.off.total_cmp(&b.off));
    let (mut digits, mut capitals): (Vec<Likeness>, Vec<Likeness>) =
        all.into_iter().partition(|like| like.character.is_ascii_digit());
    for of_kind in [&mut digits, &mut capitals] {
        let best = of_kind.first().map_or(0.0, |like| like.off);
        of_kind.retain(|like| like.off <= best + UNSURE);
        if of_kind.len() > MOST {
            of_kind.clear();
        }
    }
    [digits, capitals].concat()
}

/// How many parts of the ground a character encloses.
fn holes(of: char) -> usize {
    match of {
        '8' | 'B' => 2,
        '0' | '4' | '6' | '9' | 'A' | 'D' | 'O' | 'P' | 'Q' | 'R' => 1,
        _ => 0,
    }
}

/// A shape in its box.
struct Shape {
    /// How many parts of the ground it encloses.
    holes: usize,
    /// The middles of its pixels.
    pixels: Vec<PxPoint>,
    size: Size,
    /// For each pixel of the box, how far that of the shape is which is nearest, px.
    distances: Vec<f32>,
    /// Half the width of its stroke, px.
    half: f32,
}

impl Shape {
    fn of(glyph: &LetterShape, width: usize) -> Self {
        let [columns, rows] = [0, 1].map(|axis| glyph.max[axis] + 1 - glyph.min[axis]);
        let size = Size::new(columns as u32, rows as u32);
        let mut is_set = vec![false; size.len()];
        let mut pixels = Vec::with_capacity(glyph.cells.len());
        for &cell in &glyph.cells {
            let (x, y) = (cell % width - glyph.min[0], cell / width - glyph.min[1]);
            is_set[y * columns + x] = true;
            pixels.push(PxPoint::new(x as f32 + 0.5, y as f32 + 0.5));
        }
        let is_ground: Vec<bool> = is_set.iter().map(|is_set| !is_set).collect();
        let is_side = |cell: &usize| {
            let (x, y) = (cell % columns, cell / columns);
            x == 0 || y == 0 || x + 1 == columns || y + 1 == rows
        };
        let parts = components::of_set(&is_ground, size, Connectivity::Four);
        // where broad strokes meet, a few pixels in the middle are not thin
        let is_large = |part: &&Vec<usize>| part.len() as f32 >= glyph.stroke * glyph.stroke;
        let holes = parts.iter().filter(is_large).filter(|part| !part.iter().any(is_side)).count();
        Self { holes, pixels, size, distances: distances(&is_set, size), half: 0.5 * glyph.stroke }
    }

    /// How unlike a character with these strokes it is, in heights; none if it does not look like it.
    fn off(&self, strokes: &str) -> Option<f32> {
        let segments = self.stretched(strokes);
        let height = self.size.height as f32;
        let mean = |distances: &mut dyn Iterator<Item = f32>| {
            let (mut sum, mut count) = (0.0, 0);
            for distance in distances {
                if distance > FARTHEST * height {
                    return None;
                }
                (sum, count) = (sum + distance, count + 1);
            }
            Some(sum / count.max(1) as f32 / height)
        };
        let points = segments.iter().flat_map(|&[a, b]| {
            let steps = ((b - a).length() / (APART * height)).ceil().max(1.0) as usize;
            (0..=steps).map(move |step| a.lerp(b, step as f32 / steps as f32))
        });
        let unset = mean(&mut points.map(|at| (self.distance(at) - ON_PIXEL).max(0.0)))?;
        let beside = |at: &PxPoint| {
            let distances = segments.iter().map(|&[a, b]| nearest_on_segment(*at, a, b).0);
            (distances.fold(f32::INFINITY, f32::min) - self.half).max(0.0)
        };
        let off = unset + mean(&mut self.pixels.iter().map(beside))?;
        (off <= OFF).then_some(off)
    }

    /// How far the nearest pixel of the shape is from a place in its box.
    fn distance(&self, at: PxPoint) -> f32 {
        Plane::look_up(&self.distances, self.size, at.x, at.y)
    }

    /// The pieces of strokes, stretched to the box.
    fn stretched(&self, strokes: &str) -> Vec<[PxPoint; 2]> {
        let at = |step: u8, side: u32| {
            let room = (side as f32 - 2.0 * self.half).max(0.0);
            self.half + f32::from(step - b'0') / STEPS * room
        };
        let mut pieces = Vec::new();
        for stroke in strokes.split('|') {
            let points: Vec<PxPoint> = stroke
                .split(' ')
                .filter_map(|point| point.as_bytes().first_chunk())
                .map(|&[x, y]| PxPoint::new(at(x, self.size.width), at(y, self.size.height)))
                .collect();
            pieces.extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
        }
        pieces
    }
}

#[cfg(test)]
mod tests;
