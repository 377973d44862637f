//! Short strokes that stand on another one and end freely, several of one kind: the hour marks of a clock, the ticks of
//! a ruler. One alone may be an area, as a tooth or a battlement; so many that are alike are marks, and each is a
//! stroke however short and broad it is.

use lyon::geom::euclid::Box2D;

use super::arms::Strand;
use super::centre::{SHORTEST_APART, Stroke, on_one_ground, width_at};
use super::cover::StrokeCover;
use super::ends;
use crate::edges::params::Params;
use crate::geom::nearby::Index;
use crate::geom::order::{median, sorted};
use crate::geom::polyline::Polyline;
use crate::raster::plane::Plane;
use crate::units::{Px, PxPoint};

/// A stub is at least so many times as long as wide, and what thinning left of it at most so many times.
const LEAST_LONG: f32 = 2.0;
const LONGEST: f32 = 8.0;
/// Where a line is so many times as wide as over its outer half, it is in the stroke that it stands on.
const IN_BASE: f32 = 1.5;
/// A stub stands on a stroke if its foot is no farther beyond half of that one's width than this, px.
const STANDS: f32 = 3.0;
/// So many on one stroke are a scale, of which none is so many times as long or as wide as another.
const SCALE: usize = 4;
const ALIKE: f32 = 1.5;
/// So many that are too short are told.
const MANY: usize = 8;
/// Widths differ by this by chance, px.
const ROUNDING: f32 = 1.0;
/// What thinning leaves of one is at least this long, px, so that it has a direction.
const SHORTEST: f32 = 4.0;
/// This share of those of a scale are as far from the next one, but for that share: all but the gaps where longer ones
/// stand, as those of the hours among those of the minutes, or at the corners of a square dial (4 of 12).
const MOST: f32 = 0.65;
const EVEN: f32 = 0.25;
/// Side of the cells of the index of strokes, px.
const CELL: f32 = 16.0;

/// Whether a line of pixels has one free end, and is no part of a longer one.
pub(super) fn is_stub(strand: &Strand) -> bool {
    !strand.line.closed && strand.free[0] != strand.free[1] && strand.junctions.is_empty()
}

/// What may be a stub along such a line of pixels, from its foot on. Its residue is that of a square of this half side,
/// px.
pub(super) fn stub(
    Strand { line, free, .. }: &Strand,
    residue: &Plane,
    planes: &[Plane],
    radius: usize,
    params: &Params,
) -> Option<Stroke> {
    let mut vertices = line.vertices.clone();
    if free[0] {
        vertices.reverse();
    }
    let outwards = Polyline::open(vertices);
    let count = outwards.vertices.len();
    let widths: Vec<f32> = (0..count).map(|i| width_at(&outwards, i, residue, radius)).collect();
    let width = median(widths[count / 2..].iter().copied()).max(1.0);
    let inside = widths.iter().take_while(|here| **here > IN_BASE * width).count();
    if width > params.widest_of_bitmap().min(2.0 * radius as f32 - 1.0) || outwards.length() >= LONGEST * width {
        return None;
    }
    let foot = *outwards.vertices.first()?;
    let outer = Polyline::open(outwards.vertices[inside.min(count - 1)..].to_vec());
    if outer.length() < SHORTEST {
        return None;
    }
    let mut straight = ends::straight_dash(&outer, residue)?;
    let (first, last) = (*straight.vertices.first()?, *straight.vertices.last()?);
    if (last - first).dot(*outer.vertices.last()? - foot) < 0.0 {
        straight.vertices.reverse();
    }
    ends::extend_dash(&mut straight, residue);
    let (first, last) = (*straight.vertices.first()?, *straight.vertices.last()?);
    let along = (last - first).try_normalize()?;
    let from = last + along * (foot - last).dot(along);
    let length = (last - from).length();
    let steps = length.ceil().max(1.0) as usize;
    let line = Polyline::open((0..=steps).map(|k| from.lerp(last, k as f32 / steps as f32)).collect());
    let is_long = length >= (LEAST_LONG * width).max(params.min_length) && (last - from).dot(along) > 0.0;
    is_long.then(|| on_one_ground(&line, width, planes, params)).flatten()
}

/// Those of these stubs that are of scales on strokes, each once; and the tip of one of many that are too short: of
/// those not all are found. `taken` has the strokes.
pub(super) fn of_scales(
    stubs: Vec<Stroke>,
    strokes: &[Stroke],
    taken: &mut StrokeCover,
    params: &Params,
) -> (Vec<Stroke>, Option<PxPoint>) {
    let is_long = |stub: &Stroke| stub.whole >= SHORTEST_APART * params.min_length;
    let (long, short): (Vec<Stroke>, Vec<Stroke>) = stubs.into_iter().partition(is_long);
    let (long, short) = (own(long, taken, params), own(short, taken, params));
    if long.len().max(short.len()) < SCALE {
        return (Vec::new(), None);
    }
    let bases = Bases::of(strokes, taken);
    let places = |stubs: &[Stroke]| -> Vec<Option<Foot>> { stubs.iter().map(|stub| bases.below(stub)).collect() };
    let (of_long, of_short) = (places(&long), places(&short));
    let is_many = |i: &usize| beside(*i, &short, &of_short).len() >= MANY;
    let told = (0..short.len()).find(is_many).and_then(|i| short[i].contour.vertices.last()).map(|tip| tip.at);
    let is_of_scale = |i: usize| {
        let feet = beside(i, &long, &of_long);
        feet.len() >= SCALE && are_even(&feet, &strokes[feet[0].base])
    };
    let are_of_scales: Vec<bool> = (0..long.len()).map(is_of_scale).collect();
    let of_scales = long.into_iter().zip(are_of_scales).filter(|(_, is_of_scale)| *is_of_scale);
    (of_scales.map(|(stub, _)| stub).collect(), told)
}

/// Where those stubs stand that are like one of them, and on the same stroke, with itself; none if it stands on none.
fn beside(number: usize, stubs: &[Stroke], feet: &[Option<Foot>]) -> Vec<Foot> {
    let Some(own) = feet[number] else { return Vec::new() };
    let alike = (0..stubs.len()).filter(|&other| are_alike(&stubs[number], &stubs[other]));
    alike.filter_map(|other| feet[other].filter(|foot| foot.base == own.base)).collect()
}

/// Those of these stubs that do not lie on what was taken before, each of which is taken.
fn own(stubs: Vec<Stroke>, taken: &mut StrokeCover, params: &Params) -> Vec<Stroke> {
    let mut own: Vec<Stroke> = Vec::new();
    for stub in stubs {
        let vertices = &stub.contour.vertices;
        let is_taken = |at: usize| vertices.get(at).is_none_or(|vertex| taken.has(vertex.at));
        if !is_taken(2 * vertices.len() / 3) && !is_taken(vertices.len() - 1) {
            taken.add(&stub, params.sigma);
            own.push(stub);
        }
    }
    own
}

/// Whether two stubs may be of one scale.
fn are_alike(a: &Stroke, b: &Stroke) -> bool {
    let [long, short] = [a.whole.max(b.whole), a.whole.min(b.whole)];
    let [wide, narrow] = [a.width.max(b.width), a.width.min(b.width)];
    long <= ALIKE * short && wide <= ALIKE * narrow + ROUNDING
}

/// Whether most stubs on a stroke are as far from the next one.
fn are_even(feet: &[Foot], base: &Stroke) -> bool {
    let places = sorted(feet.iter().map(|foot| foot.arc));
    let mut steps: Vec<f32> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    if base.contour.closed {
        steps.push(places[0] + base.contour.length() - places[places.len() - 1]);
    }
    let step = median(steps.iter().copied());
    let even = steps.iter().filter(|other| (*other - step).abs() <= EVEN * step).count();
    even as f32 >= MOST * steps.len() as f32
}

/// Where a stub stands.
#[derive(Debug, Clone, Copy)]
struct Foot {
    /// The number of the stroke.
    base: usize,
    /// How far along it, px.
    arc: f32,
}

/// The strokes that stubs may stand on.
struct Bases<'a> {
    strokes: &'a [Stroke],
    /// Their vertices.
    places: Index<(Foot, PxPoint), Px>,
    widest: f32,
}

impl<'a> Bases<'a> {
    fn of(strokes: &'a [Stroke], cover: &StrokeCover) -> Self {
        let corner = PxPoint::new(cover.size.width as f32, cover.size.height as f32);
        let mut places = Index::new(Box2D::new(PxPoint::zero(), corner), CELL);
        for (number, stroke) in strokes.iter().enumerate() {
            for (vertex, arc) in stroke.contour.vertices.iter().zip(stroke.contour.arc_lengths()) {
                places.put_at(vertex.at, (Foot { base: number, arc }, vertex.at));
            }
        }
        Self { strokes, places, widest: strokes.iter().map(|stroke| stroke.width).fold(0.0, f32::max) }
    }

    /// Where a stub stands on a stroke.
    fn below(&self, stub: &Stroke) -> Option<Foot> {
        let tip = stub.contour.vertices.first()?.at;
        let mut nearest: Option<(f32, Foot)> = None;
        self.places.around(tip, tip, 0.5 * self.widest + STANDS, |&(foot, at)| {
            let distance = (at - tip).length();
            let order = |known: &Foot| foot.base.cmp(&known.base).then(foot.arc.total_cmp(&known.arc));
            let is_nearer =
                nearest.as_ref().is_none_or(|(least, known)| distance.total_cmp(least).then(order(known)).is_lt());
            if distance <= 0.5 * self.strokes[foot.base].width + STANDS && is_nearer {
                nearest = Some((distance, foot));
            }
        });
        nearest.map(|(_, foot)| foot)
    }
}
