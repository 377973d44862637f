//! Letters one after the other: chains of things that are alike in height, stroke and colour, along a direction.

use super::glyph::{LetterShape, PixelPoint};
use crate::geom::components::DisjointSets;
use crate::raster::contrast::distance;

/// Greatest ratio of the heights of two neighbouring letters (j beside x).
const HEIGHTS: f32 = 2.3;
/// Greatest ratio of the widths of their strokes, and what is added to it, px: at small sizes a width is uncertain by
/// about a pixel.
const STROKES: f32 = 1.7;
const STROKE_UNSURE: f32 = 0.8;
/// Least ratio of the contrasts of two letters, the fainter one by the other.
const CONTRASTS: f32 = 0.6;
/// Greatest distance between the colours of two letters, as a share of their contrast.
const COLOURS: f32 = 0.5;
/// Greatest gap between two neighbouring letters, in heights of the higher one.
const GAP: f32 = 1.0;
/// Greatest overlap of two neighbouring letters along the line, in heights of the higher one: slanted ones overlap.
const OVERLAP_ALONG: f32 = 0.5;
/// Least overlap of their extents across the line, as a share of the lower one's height.
const OVERLAP: f32 = 0.5;

/// A letter in the coordinates of a line of text: its extent along the line and across it.
#[derive(Debug, Clone, Copy)]
pub(super) struct RotatedLetter {
    /// Which of the glyphs it is.
    pub(super) of: usize,
    /// From where to where it reaches in the direction of the text, px.
    pub(super) along: [f32; 2],
    /// From where to where it reaches across the direction of the text, downwards, px.
    pub(super) across: [f32; 2],
}

impl RotatedLetter {
    pub(super) fn height(&self) -> f32 {
        self.across[1] - self.across[0]
    }

    pub(super) fn width(&self) -> f32 {
        self.along[1] - self.along[0]
    }
}

/// The direction at an angle, and the one across it, downwards for text that is read from left to right.
pub(super) fn axes(angle: f32) -> [PixelPoint; 2] {
    let (sin, cos) = angle.to_radians().sin_cos();
    [[cos, -sin], [sin, cos]]
}

/// Letters as they lie at an angle (degrees counter-clockwise), in the order along it.
pub(super) fn placed(glyphs: &[LetterShape], which: &[usize], angle: f32) -> Vec<RotatedLetter> {
    let [along, across] = axes(angle);
    let place = |&of: &usize| RotatedLetter { of, along: glyphs[of].reach(along), across: glyphs[of].reach(across) };
    let mut placed: Vec<RotatedLetter> = which.iter().map(place).collect();
    placed.sort_by(|a, b| a.along[0].total_cmp(&b.along[0]).then(a.across[0].total_cmp(&b.across[0])));
    placed
}

/// Whether two glyphs are alike enough for one text, but for their heights.
fn alike(a: &LetterShape, b: &LetterShape) -> bool {
    let (thin, wide) = (a.stroke.min(b.stroke), a.stroke.max(b.stroke));
    let (weak, strong) = (a.contrast.min(b.contrast), a.contrast.max(b.contrast));
    let distance = distance(a.colour, b.colour);
    wide <= STROKES * thin + STROKE_UNSURE && weak >= CONTRASTS * strong && distance <= COLOURS * strong
}

/// Whether `b` can follow `a` in a text.
fn follows(a: &RotatedLetter, b: &RotatedLetter) -> bool {
    let (low, high) = (a.height().min(b.height()), a.height().max(b.height()));
    let overlap = a.across[1].min(b.across[1]) - a.across[0].max(b.across[0]);
    let apart = b.along[0] - a.along[1];
    high <= HEIGHTS * low
        && overlap >= OVERLAP * low
        && apart <= GAP * high
        && apart >= -OVERLAP_ALONG * high
        && 0.5 * (b.along[0] + b.along[1]) > 0.5 * (a.along[0] + a.along[1])
}

/// Groups of letters that are alike and near one another: whatever the angle, those that follow one another are in one
/// group.
pub(super) fn groups(glyphs: &[LetterShape], which: &[usize]) -> Vec<Vec<usize>> {
    // the middle of each and half its diagonal: it reaches no further, whatever the angle
    let round = |&of: &usize| {
        let LetterShape { min, max, .. } = &glyphs[of];
        let side = |axis: usize| (max[axis] + 1 - min[axis]) as f32;
        let middle = |axis: usize| 0.5 * (min[axis] + max[axis] + 1) as f32;
        ([middle(0), middle(1)], 0.5 * side(0).hypot(side(1)), of)
    };
    let mut all: Vec<([f32; 2], f32, usize)> = which.iter().map(round).collect();
    // in the order in which they lie on the longer side of the picture: few are abreast
    let extent = |axis: usize| all.iter().map(|(middle, ..)| middle[axis]).fold(0.0, f32::max);
    let axis = usize::from(extent(1) > extent(0));
    all.sort_by(|a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.2.cmp(&b.2)));
    let reach = |a: f32, b: f32| a + b + 2.0 * GAP * a.max(b);
    let most = all.iter().map(|(_, radius, _)| *radius).fold(0.0, f32::max);
    let mut sets = DisjointSets::default();
    for (j, &(b, other_radius, other)) in all.iter().enumerate() {
        sets.add();
        for (i, &(a, radius, of)) in all.iter().enumerate().take(j).rev() {
            if b[axis] - a[axis] > reach(other_radius, most).hypot(other_radius + most) {
                break;
            }
            let along = reach(radius, other_radius);
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let across = radius + other_radius;
            if dx * dx + dy * dy <= along * along + across * across && alike(&glyphs[of], &glyphs[other]) {
                sets.join(i, j);
            }
        }
    }
    let mut groups: Vec<Vec<usize>> = vec![Vec::new(); all.len()];
    (0..all.len()).for_each(|i| groups[sets.lowest(i)].push(all[i].2));
    groups.retain(|group| !group.is_empty());
    groups
}

/// Chains at an angle, of at least two.
pub(super) fn chains(glyphs: &[LetterShape], which: &[usize], angle: f32) -> Vec<Vec<RotatedLetter>> {
    let placed = placed(glyphs, which, angle);
    let rows = Rows::of(&placed);
    // the nearest that can follow each, and the nearest that each can follow
    let mut next: Vec<Option<(f32, usize)>> = vec![None; placed.len()];
    let mut before = next.clone();
    for (i, a) in placed.iter().enumerate() {
        for j in rows.after(i, a) {
            let b = &placed[j];
            if follows(a, b) && alike(&glyphs[a.of], &glyphs[b.of]) {
                let off = 0.5 * ((b.across[0] + b.across[1]) - (a.across[0] + a.across[1])).abs();
                let apart = (b.along[0] - a.along[1]).max(0.0) + off;
                let is_nearer = |known: Option<(f32, usize)>, number: usize| {
                    known.is_none_or(|(least, of)| apart < least || apart <= least && number < of)
                };
                if is_nearer(next[i], j) {
                    next[i] = Some((apart, j));
                }
                if is_nearer(before[j], i) {
                    before[j] = Some((apart, i));
                }
            }
        }
    }
    let after = |i: usize| next[i].map(|(_, j)| j).filter(|&j| before[j].is_some_and(|(_, of)| of == i));
    let is_start = |i: usize| before[i].is_none_or(|(_, of)| after(of) != Some(i));
    let mut chains = Vec::new();
    for start in (0..placed.len()).filter(|&i| is_start(i) && after(i).is_some()) {
        chains.push(std::iter::successors(Some(start), |&i| after(i)).map(|i| placed[i]).collect());
    }
    chains
}

/// Letters by rows as high as the highest of them, so that only those in the same row and those beside it can overlap.
struct Rows<'a> {
    placed: &'a [RotatedLetter],
    /// The height of a row.
    height: f32,
    /// Where the first row begins.
    top: f32,
    /// The numbers of the letters whose middles lie in each row, in the order along it.
    rows: Vec<Vec<usize>>,
}

impl<'a> Rows<'a> {
    fn of(placed: &'a [RotatedLetter]) -> Self {
        let height = placed.iter().map(RotatedLetter::height).fold(1.0, f32::max);
        let top = placed.iter().map(|letter| letter.across[0]).fold(f32::INFINITY, f32::min);
        let mut all = Self { placed, height, top, rows: Vec::new() };
        for (number, letter) in placed.iter().enumerate() {
            let row = all.row(letter);
            if all.rows.len() <= row {
                all.rows.resize_with(row + 1, Vec::new);
            }
            all.rows[row].push(number);
        }
        all
    }

    fn row(&self, letter: &RotatedLetter) -> usize {
        ((0.5 * (letter.across[0] + letter.across[1]) - self.top) / self.height) as usize
    }

    /// The numbers of letters after the `i`-th, `a`, that may follow it.
    fn after(&self, i: usize, a: &RotatedLetter) -> impl Iterator<Item = usize> {
        let row = self.row(a);
        let last = a.along[1] + GAP * HEIGHTS * a.height();
        let near = self.rows.iter().skip(row.saturating_sub(1)).take(row + 2 - row.saturating_sub(1));
        near.flat_map(move |row| {
            let later = &row[row.partition_point(|number| *number <= i)..];
            later.iter().copied().take_while(move |number| self.placed[*number].along[0] <= last)
        })
    }
}
