//! Edge detection: where the colour of the picture steps, how high the steps are, and which edgels form a contour.
//!
//! ```text
//! Raster -> noise (of a pixel; adapts the parameters)
//!        -> lab (perceptual rows) -> gradient (structure tensor, row by row) -> maxima (ridge points)
//!                 `-> side_statistics (colours on both sides) ----v                  |
//!                                  edge_stopping (filter) -> strength                |
//!   Edges <- junction <- corner <- refine <- bridge <---------- hysteresis <- step_height <- chain
//!                                                      ^---- grouping (regions, where asked for) <-'
//! ```
//!
//! All colour planes exist for a few rows only. From `maxima` on there are points, and the time grows with their
//! number. Bitmaps that are drawings are also searched for strokes (`stroke`), with whole planes: each gives a contour
//! along its middle, and the points at its sides are taken out. Then what belongs together is put together, in this
//! order, as each step needs what the one before has made:
//!
//! ```text
//! [bitmaps: signs that mark places (taken out of the picture first; in the end rings among the contours)]
//! [bitmaps: filled heads of arrows (taken out, and the strokes found once more)]
//! strokes, edges -> dials (hands of clocks and the marks at their rims: one stroke each)
//!                -> windows (in the walls of a plan: one stroke each)
//!                -> dashes (rows of short pieces are one line, before any end of them is taken for that of a line)
//!                -> tips (ends that make a corner or go on in one another meet)
//!                -> straight (what goes straight on through a corner gets the side behind it, with its final ends)
//!                -> rings (those that touch are parted) -> discs (small ones, and the lines that end at them)
//!                -> heads (what leads through one into a box is parted at its tip)
//!                -> junction (ends reach the contours before them)
//! ```
//!
//! **Strength is the height of the colour step** in units of lightness, with double weight for the chroma axes of
//! CIELAB (`lab`), whatever the working resolution and the blur of the edge. Black against white is 100, a step that
//! is barely worth a line about 10. A grey step of N of 255 code values is N / 2.55. Where there is texture, strength
//! is less (`strength`).

mod bands;
mod bridge;
mod chain;
mod contour;
mod corner;
mod dashes;
mod dials;
mod discs;
mod drawing;
mod edge_stopping;
mod edgel;
mod faint;
mod gradient;
mod grouping;
mod heads;
mod hysteresis;
mod junction;
mod maxima;
mod noise;
mod pale_grid;
mod params;
mod refine;
mod ridge;
mod rings;
mod side_statistics;
mod signs;
mod step_height;
mod straight;
mod strength;
mod stroke;
mod tips;
mod windows;

use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

use chain::Chain;
use contour::ContourPoint;
use discs::Disc;
pub use drawing::{find_in_vector, find_in_vector_with_signs};
pub use edgel::{ChainKind, ChainRange, Edgel, Edges};
use heads::EdgesOfHeads;
use hysteresis::Selection;
use noise::Noise;
pub use params::Params;
use ridge::RidgePoint;
use side_statistics::SideStatistics;
use signs::Signs;
use strength::Evidence;
use stroke::{FilledHead, FoundStrokes, PixelNoise, Stroke, Tint};
use tips::FoundContour;

use crate::raster::Raster;
use crate::raster::lab;
use crate::raster::plane::Plane;
use crate::regions::{Detail, Heights, Tree};
use crate::units::{PxPoint, Size};

/// What kind of picture it is. Contours and letters are looked for by it.
#[derive(Debug, Clone)]
pub struct PictureKind {
    noise: Noise,
    /// Whether it is a drawing: mostly of flat areas, with little noise.
    pub is_drawing: bool,
    /// Of a picture with lossy compression, by which factor it was shrunk.
    lossy: Option<f32>,
}

impl PictureKind {
    /// Of a picture; of one with lossy compression with the factor, at most 1, by which it was shrunk.
    pub fn of(raster: &Raster, lossy: Option<f32>) -> Self {
        let noise = Noise::of(raster);
        Self { is_drawing: stroke::is_drawing(raster, noise.pixel, lossy.is_some()), noise, lossy }
    }

    /// The same of pixels that no vector drawing was rendered to: a photograph of a thing on an even ground, as one
    /// that was cut out, is none of a drawing.
    pub fn of_bitmap(raster: &Raster, lossy: Option<f32>) -> Self {
        let kind = Self::of(raster, lossy);
        Self { is_drawing: kind.is_drawing && !stroke::is_cut_out(raster), ..kind }
    }

    /// The same kind with the noise of what the picture has become.
    pub fn again_of(&self, raster: &Raster) -> Self {
        Self { noise: Noise::of(raster), ..self.clone() }
    }
}

/// Standard deviation of a pixel of a drawing with lossy compression, at least, in units of strength, before it is
/// shrunk: where blocks are flat they show no noise, and beside contours they ring.
const LOSSY: f32 = 0.3;
/// Weight of chroma in such a drawing, beside that in other pictures: it is kept at half resolution and in coarse
/// steps, so that its edges lie up to a block beside those of lightness. Measured on drawings of quality 80: with 1,
/// 0.5 and 0.25, shares of 0.034, 0.008 and 0.001 of the lines lie beside all contours.
const LOSSY_CHROMA: f32 = 0.25;

impl PictureKind {
    /// Standard deviation of a pixel in lightness, 0..=100.
    pub fn noise_of_lightness(&self) -> f32 {
        self.noise.lightness
    }

    /// That of a pixel.
    fn noise_of_pixel(&self) -> PixelNoise {
        let deviation = self.lossy.map_or(self.noise.pixel, |shrunk| self.noise.pixel.max(LOSSY * shrunk));
        PixelNoise { deviation, is_lossy: self.lossy.is_some() }
    }

    /// The weight of each colour plane in a drawing.
    fn weights(&self) -> Vec<f32> {
        let chroma = if self.is_drawing && self.lossy.is_some() { LOSSY_CHROMA } else { 1.0 };
        let weight = |(plane, weight): (usize, &f32)| if plane == 0 { *weight } else { chroma * weight };
        self.noise.weights.iter().enumerate().map(weight).collect()
    }

    /// The colour planes in which the strokes of a drawing are looked for.
    fn planes_of_drawing(&self, raster: &Raster) -> Vec<Plane> {
        let mut planes = lab::whole(raster);
        if self.lossy.is_some() {
            let chroma = planes.iter_mut().skip(1).flat_map(|plane| &mut plane.values);
            chroma.for_each(|value| *value *= LOSSY_CHROMA);
        }
        planes
    }
}

/// Where a stroke is led on, the picture shows at least this share of the least strength of an edge ([`Params::low`]).
/// Chosen by us.
const LED_ON: f32 = 0.5;

/// Finds the contours of a picture.
pub fn find(raster: &Raster, params: &Params) -> Edges {
    find_of_kind(raster, &PictureKind::of(raster, None), params, None)
}

/// Finds the contours of a picture and, unless it is a drawing, the regions between them, by which they are weighted.
pub fn find_with_regions(raster: &Raster, params: &Params) -> Edges {
    find_of_kind(raster, &PictureKind::of(raster, None), params, Some(Detail::OUTLINES))
}

/// The points where the colour steps, before any are linked or dropped, of a picture without noise: the pixel of each
/// (column, row), its position and the height of its step. For measuring how exact they are.
pub fn ridge_points(raster: &Raster, params: &Params) -> Vec<([u32; 2], PxPoint, f32)> {
    let (points, _) = bands::scan(raster, &[1.0; 3], params);
    points.iter().map(|point| ([point.column, point.row], point.at, point.height)).collect()
}

/// [`find`], or with regions of some detail [`find_with_regions`], where it is known what kind of picture it is.
pub fn find_of_kind(raster: &Raster, kind: &PictureKind, params: &Params, regions: Option<Detail>) -> Edges {
    let Some(ridges) = Ridges::of(raster, kind, params) else { return Edges::none(raster.size()) };
    let grouped = regions.and_then(|detail| ridges.grouped(detail));
    ridges.contours(grouped)
}

/// [`find_of_kind`] of a bitmap of a drawing, with its signs that mark places as rings, and what is found without them.
pub fn find_with_signs(raster: &Raster, kind: &PictureKind, params: &Params, px_per_mm: f32) -> Edges {
    if !kind.is_drawing || kind.lossy.is_some() {
        return find_of_kind(raster, kind, params, None);
    }
    let planes = kind.planes_of_drawing(raster);
    let signs = Signs::find(&planes, raster.size(), px_per_mm);
    let none = || Edges::none(raster.size());
    if signs.is_empty() {
        return Ridges::in_planes(planes, raster, kind, params).map_or_else(none, |ridges| ridges.contours(None));
    }
    drop(planes);
    let rest = signs.erased_from(raster);
    let ridges = Ridges::of(&rest, kind, params).map(|ridges| Ridges { taken_out: signs.outlines(), ..ridges });
    let mut edges = ridges.map_or_else(none, |ridges| ridges.contours(None));
    signs.add_to(&mut edges);
    edges
}

/// All ridge points and their chains, before any is dropped: [`find_of_kind`] in parts, for those who tell how long
/// each takes.
pub struct Ridges<'a> {
    raster: &'a Raster,
    kind: &'a PictureKind,
    /// Adapted to the noise.
    params: Params,
    /// Of a drawing.
    planes: Vec<Plane>,
    heads: Vec<FilledHead>,
    strokes: Vec<Stroke>,
    /// See [`Edges::short_marks`].
    short_marks: Option<PxPoint>,
    points: Vec<RidgePoint>,
    chains: Vec<Chain>,
    sides: SideStatistics,
    discs: Vec<Disc>,
    /// Strength and length of the outlines of what was taken out of the picture before.
    taken_out: Vec<(f32, f32)>,
}

/// The regions between all chains, and what follows for those.
pub struct Grouped {
    heights: Heights,
    strengths: Vec<Vec<f32>>,
    tree: Tree,
}

impl<'a> Ridges<'a> {
    /// Of a picture; none if there is nothing in it.
    pub fn of(raster: &'a Raster, kind: &'a PictureKind, params: &Params) -> Option<Self> {
        let planes = if kind.is_drawing { kind.planes_of_drawing(raster) } else { Vec::new() };
        Self::in_planes(planes, raster, kind, params)
    }

    /// The same of a picture of which the planes of a drawing are known; it has none if it is no drawing.
    fn in_planes(mut planes: Vec<Plane>, raster: &'a Raster, kind: &'a PictureKind, params: &Params) -> Option<Self> {
        let size = raster.size();
        let (noise, drawn) = (&kind.noise, kind.is_drawing);
        let params = noise.adapted(&if drawn { params.of_drawing() } else { *params });
        let find = |planes: &[Plane]| stroke::find(planes, kind.noise_of_pixel(), &params);
        let none = FoundStrokes::default;
        let FoundStrokes { mut strokes, mut short_marks } = if drawn { find(&planes) } else { none() };
        let heads = stroke::filled_heads(&strokes, &planes, params.high);
        if !heads.is_empty() {
            heads::take_out(&heads, &mut planes);
            FoundStrokes { strokes, short_marks } = find(&planes);
        }
        let strokes = dashes::without_loose(strokes, params.min_length);
        let (mut points, sides) = bands::scan(raster, &kind.weights(), &params);
        if drawn {
            points.retain(|point| !is_border(point, size));
            let of_heads = EdgesOfHeads::of(&heads, params.sigma);
            points.retain(|point| !of_heads.has(point.at));
        }
        let discs = if drawn { discs::find(&points, size, &params) } else { Vec::new() };
        if !strokes.is_empty() {
            // their sides are no contours
            let taken = stroke::StrokeCover::by(&strokes, size, params.sigma);
            points.retain(|point| !taken.has(point.at));
        }
        if points.is_empty() && strokes.is_empty() {
            return None;
        }
        let chains = chain::link(&points, size, params.min_length);
        step_height::average(&mut points, &chains, params.strength_window.round() as usize, params.sigma);
        let sides = sides.finish(&points, &chains, noise.height_sigma(params.sigma));
        let taken_out = Vec::new();
        Some(Self {
            raster,
            kind,
            params,
            planes,
            heads,
            strokes,
            short_marks,
            points,
            chains,
            sides,
            discs,
            taken_out,
        })
    }

    /// The regions between all chains; none of a drawing, whose lines say enough.
    pub fn grouped(&self, detail: Detail) -> Option<Grouped> {
        let Self { raster, points, chains, sides, params, .. } = self;
        (!self.kind.is_drawing).then(|| {
            let strengths = strength::of_all(points, chains, sides, params);
            let tree = grouping::tree(raster, points, chains, &strengths, detail);
            Grouped { heights: Heights::of(&tree), strengths, tree }
        })
    }

    /// The contours among the chains, weighted by regions where those are known.
    pub fn contours(self, grouped: Option<Grouped>) -> Edges {
        let Self { raster, kind, params, planes, mut heads, strokes, points, chains, sides, .. } = self;
        let (mut discs, taken_out, short_marks) = (self.discs, self.taken_out, self.short_marks);
        let (size, params, of_drawing) = (raster.size(), &params, kind.is_drawing);
        let by_regions = grouped.as_ref().map(|grouped| (&grouped.heights, &grouped.strengths[..]));
        let evidence = Evidence { sides: &sides, regions: by_regions };
        let selection = Selection { points: &points, raster, evidence, noise: kind.noise.pixel, params };
        let mut contours = bridge::join(selection.contours(&chains), params.sigma, of_drawing);
        contours.par_iter_mut().for_each(|contour| {
            refine::refine(contour, params.sigma);
            corner::sharpen(contour, size, of_drawing);
        });
        let edges = contours.into_iter().map(FoundContour::edge);
        let strokes = strokes.into_iter().map(FoundContour::stroke);
        let mut found: Vec<FoundContour> = edges.chain(strokes).collect();
        let mut dashed = 0;
        if of_drawing {
            found = dials::with_hands(found, &mut discs, &heads, &planes, params);
            found = windows::merged(found);
            (found, dashed) = dashes::merged_dashes(found, params.sigma, params.min_length);
            let is_seen = |from: PxPoint, to: PxPoint, width: f32, least: f32| {
                stroke::is_seen([from, to], width, least.max(LED_ON * params.low), &planes)
            };
            let met = tips::join_corners(found, params.sigma, size, &is_seen);
            let reassigned = straight::reassign_sides(met, params.sigma, params.min_length);
            let parted = rings::split_at_contact(reassigned, params.min_length);
            found = discs::split_at_discs(parted, &discs, params, &is_seen);
            found = heads::parted(found, &heads);
            heads.retain(|head| found.iter().any(|found| head.has_end(&found.contour)));
        }
        let strokes: Vec<Option<(f32, Tint)>> = found.iter().map(|found| found.stroke.zip(found.tint)).collect();
        let (mut contours, widths): (Vec<_>, Vec<_>) =
            found.into_iter().map(|found| (found.contour, found.stroke)).unzip();
        if of_drawing {
            junction::straighten(&mut contours, size);
            junction::trim(&mut contours, size);
        }
        junction::extend(&mut contours, size, &|number, other, way| {
            let pair = strokes[number].zip(strokes[other]);
            pair.is_none_or(|(own, other)| stroke::may_lead([own, other], way, LED_ON * params.low, &planes))
        });
        heads::shorten(&mut contours, &heads);
        let mut edges = Edges { short_marks, ..Edges::none(size) };
        heads::add(&heads, &mut edges);
        let weighed = match of_drawing {
            true => pale_grid::parted(contours, &widths, size, taken_out),
            false => contours.into_iter().zip(widths).map(|(contour, width)| (contour, width, false)).collect(),
        };
        for (contour, stroke, faint) in weighed {
            let edgel = |&ContourPoint { at, strength, contrast, .. }: &ContourPoint| Edgel { at, strength, contrast };
            edges.push_as(
                ChainKind { exact: false, of_drawing, stroke, faint, ..ChainKind::default() },
                contour.vertices.iter().map(edgel),
                contour.closed,
            );
        }
        edges.regions = grouped.map(|grouped| grouped.tree);
        edges.dashed = dashed;
        edges
    }
}

/// An edge this near to the border of the picture and along it, px, is the border: bitmaps that were exported end in
/// rows that are half transparent or black.
const BORDER: f32 = 2.0;
/// An edge runs along the border if the cosine between the two is at least this (18 degrees).
const ALONG_BORDER: f32 = 0.95;

/// Whether a point belongs to the border of the picture.
fn is_border(point: &RidgePoint, size: Size) -> bool {
    let near = |at: f32, count: u32| at <= BORDER || at >= count as f32 - BORDER;
    (near(point.at.x, size.width) && point.normal.x.abs() >= ALONG_BORDER)
        || (near(point.at.y, size.height) && point.normal.y.abs() >= ALONG_BORDER)
}

#[cfg(test)]
mod tests;
