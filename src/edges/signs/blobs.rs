//! Small things by themselves in the pixels, and those of them that are alike.

use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::geom::components::{self, Connectivity};
use crate::raster::plane::Plane;
use crate::raster::residue::{Polarity, residue, square_max};

/// Least contrast of a sign with its ground, in units of strength.
const CONTRAST: f32 = 15.0;
/// A pixel belongs to a thing if its residue is at least this share of the largest within [`LOCAL`] px: of a gridline
/// that leads to a sign there is less.
const SHARE: f32 = 0.6;
const LOCAL: usize = 3;
/// Least side of a sign, px: smaller ones have no shape.
const SMALLEST: i32 = 4;
/// The shorter side of a sign is at least this share of the longer one.
const AS_WIDE: f32 = 0.8;
/// More small things than this are a texture, or noise.
const MOST: usize = 1500;
/// Signs are alike if their sides differ by no more than this, px, and this share of them.
const SIDE: f32 = 1.0;
const SIDE_SHARE: f32 = 0.08;
/// A sign is hollow if its middle has less than this share of its greatest contrast.
const HOLLOW: f32 = 0.5;
/// The colours of signs of a kind are no farther apart than this.
const COLOUR: f32 = 12.0;

/// A connected part of the picture that is small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blob {
    /// Its first column and row.
    pub(super) min: [i32; 2],
    /// Columns and rows.
    pub(super) sides: [i32; 2],
    /// Where it differs most from its ground.
    pub(super) colour: [f32; 3],
    pub(super) contrast: f32,
    /// Whether its middle has the colour of its ground, as that of a ring.
    is_hollow: bool,
}

impl Blob {
    /// Twice its middle: a number of pixels.
    fn twice_middle(&self) -> [i32; 2] {
        [0, 1].map(|axis| 2 * self.min[axis] + self.sides[axis])
    }

    pub(super) fn middle(&self) -> [f32; 2] {
        self.twice_middle().map(|at| 0.5 * at as f32)
    }

    pub(super) fn side(&self) -> i32 {
        self.sides[0].max(self.sides[1])
    }

    fn is_compact(&self) -> bool {
        self.sides[0].min(self.sides[1]) as f32 >= AS_WIDE * self.side() as f32
    }

    /// Whether two are the same thing in two planes.
    fn is_same(&self, other: &Self) -> bool {
        let (own, of) = (self.twice_middle(), other.twice_middle());
        let side = self.side().max(other.side());
        (0..2).all(|axis| (own[axis] - of[axis]).abs() <= side)
    }

    fn is_like(&self, other: &Self) -> bool {
        let near = |axis: usize| {
            let (own, of) = (self.sides[axis] as f32, other.sides[axis] as f32);
            (own - of).abs() <= SIDE + SIDE_SHARE * own.max(of)
        };
        self.is_hollow == other.is_hollow && near(0) && near(1) && apart(self.colour, other.colour) <= COLOUR
    }
}

/// How far two colours are apart.
pub(super) fn apart(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f32>().sqrt()
}

/// The small things of a picture: those as wide as high that are no larger than `most`, px, each once, and all that
/// are dark and up to three times as large. None if they are too many.
pub(super) fn find(planes: &[Plane], most: usize) -> Option<(Vec<Blob>, Vec<Blob>)> {
    let dark = [(0, Polarity::Below)].into_iter();
    let coloured = (1..planes.len()).flat_map(|k| [(k, Polarity::Below), (k, Polarity::Above)]);
    let kinds: Vec<(usize, Polarity)> = dark.chain(coloured).collect();
    let found: Vec<Vec<Blob>> =
        kinds.into_par_iter().map(|(k, polarity)| in_plane(planes, k, polarity, most)).collect();
    let all: Vec<Blob> = found.first()?.clone();
    let is_sign = |blob: &Blob| blob.is_compact() && (SMALLEST..=most as i32).contains(&blob.side());
    let mut signs: Vec<Blob> = found.into_iter().flatten().filter(is_sign).collect();
    if signs.len() > MOST {
        return None;
    }
    signs.sort_by(|a, b| b.side().cmp(&a.side()).then(b.contrast.total_cmp(&a.contrast)));
    let mut once: Vec<Blob> = Vec::new();
    for sign in signs {
        if !once.iter().any(|other| other.is_same(&sign)) {
            once.push(sign);
        }
    }
    Some((once, all))
}

/// The small things that differ from their ground in one plane.
fn in_plane(planes: &[Plane], k: usize, polarity: Polarity, most: usize) -> Vec<Blob> {
    let Plane { size, values } = &planes[k];
    let residue = residue(values, *size, most / 2 + 1, polarity);
    if residue.iter().all(|value| *value < CONTRAST) {
        return Vec::new();
    }
    let around = square_max(&residue, *size, LOCAL, false);
    let set: Vec<bool> = residue.iter().zip(&around).map(|(own, most)| *own >= CONTRAST.max(SHARE * most)).collect();
    let things = components::of_set(&set, *size, Connectivity::Eight);
    let width = size.width as usize;
    let blob = |cells: &Vec<usize>| -> Option<Blob> {
        let (mut min, mut max) = ([i32::MAX; 2], [0; 2]);
        let mut strongest = cells[0];
        for &cell in cells {
            for (axis, at) in [(cell % width) as i32, (cell / width) as i32].into_iter().enumerate() {
                (min[axis], max[axis]) = (min[axis].min(at), max[axis].max(at));
            }
            strongest = if residue[cell] > residue[strongest] { cell } else { strongest };
        }
        let sides = [0, 1].map(|axis| max[axis] - min[axis] + 1);
        let colour = std::array::from_fn(|k| planes.get(k).map_or(0.0, |plane| plane.values[strongest]));
        let is_small = sides[0].max(sides[1]) <= 3 * most as i32;
        // of an even number of pixels the middle lies between two
        let [columns, rows] = [0, 1].map(|axis| [min[axis] + (sides[axis] - 1) / 2, min[axis] + sides[axis] / 2]);
        let places = columns.into_iter().flat_map(|x| rows.map(|y| y as usize * width + x as usize));
        let middle = places.map(|cell| residue[cell]).sum::<f32>() / 4.0;
        let contrast = residue[strongest];
        is_small.then_some(Blob { min, sides, colour, contrast, is_hollow: middle < HOLLOW * contrast })
    };
    things.par_iter().filter_map(blob).collect()
}

/// Those that are alike, the largest kinds first; of each at least `least`.
pub(super) fn kinds(mut blobs: Vec<Blob>, least: usize) -> Vec<Vec<Blob>> {
    let mut kinds = Vec::new();
    loop {
        let like = |of: &Blob| blobs.iter().filter(|other| of.is_like(other)).count();
        let counts: Vec<usize> = blobs.par_iter().map(like).collect();
        let Some(first) = (0..blobs.len()).max_by_key(|&i| (counts[i], std::cmp::Reverse(i))) else { break };
        if counts[first] < least {
            break;
        }
        let of = blobs[first];
        let (own, others) = blobs.into_iter().partition(|other| of.is_like(other));
        kinds.push(own);
        blobs = others;
    }
    kinds
}
