//! Signs of a vector drawing that mark places, such as the points of a scatter plot: small paths that are alike and
//! scattered. As contours they are too small for lines; so each becomes a ring, as a sign of a bitmap does
//! (`edges/signs`), by nearly the same rules: they may be a little larger, and nearer to one another:
//!
//! ```text
//! paths -> small things (a path, or several around one middle) -> kinds (one outline in the same colours)
//!       -> those of a shape that marks places, which are scattered, on no curve, and no letters -> Signs
//! ```
//!
//! Paths say where each is and what it looks like, also where others hide it in part. The picture says whether anything
//! of it is seen, and whether it is filled.

mod shape;

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::Range;

use lyon::geom::euclid::Box2D;

use super::confirm::{Lab, confirmed};
use super::flatten::proposals;
use crate::edges::params::Params;
use crate::edges::signs::{LEAST, Neighbour, SMALLEST, Sign, Signs, are_letters, are_scattered};
use crate::geom::nearby::Index;
use crate::raster::contrast::distance;
use crate::raster::vector::PaintedPath;
use crate::units::{Px, PxPoint, PxVector, Size};
use shape::{Part, is_cross, is_outline, parts};

/// The largest sign, mm, with its stroke: a larger one has room as it is. Of points in the figure of a page discs are
/// drawn up to 5.9 mm.
const LARGEST: f32 = 5.5;
/// Two things stand around one middle if these are no farther apart than this share of the larger side.
const ONE_MIDDLE: f32 = 0.1;
/// A sign has at most so many paths: an outline and what is in it, the strokes of a star.
const MOST_PATHS: usize = 4;
/// Things are alike if no point of them is farther aside than this, px, and this share of their side: in files
/// coordinates have two decimals.
const ALIKE: f32 = 0.15;
const ALIKE_SHARE: f32 = 0.03;
/// The shorter side of a sign is at least this share of the longer one: the diamond of some programs is 0.58 times as
/// wide as it is high.
const AS_WIDE: f32 = 0.55;
/// A line leads through the middle of a sign but for this share of the sign's side; it ends at the sign if no farther
/// from its middle than this share.
const AT_MIDDLE: f32 = 0.15;
const AT_SIDE: f32 = 0.75;
/// A line of a grid is level or upright but for this sine (1.1 degrees), and so many are alike and begin and end
/// together.
const SLANTED: f32 = 0.02;
const OF_GRID: usize = 3;
/// From most of them the next one of their kind is as far as so many of their sides: they lie beside one another, and
/// are no texture.
const APART: f32 = 1.0;
/// Least contrast of a filled sign with its ground, in units of strength, as of signs in pixels; the ground is looked
/// at so far beside it, px.
const CONTRAST: f32 = 15.0;
const BESIDE: f32 = 2.0;
/// More small things than this are letters, or a texture.
const MOST: usize = 5000;
/// Side of the cells of the index, px.
const CELL: f32 = 16.0;

/// The signs among paths, and which of the paths are theirs; none where there are no signs.
pub(super) fn find(
    paths: &[PaintedPath],
    picture: &Lab,
    params: &Params,
    px_per_mm: f32,
    size: Size,
) -> Option<(Signs, Vec<bool>)> {
    let things = small_things(paths, LARGEST * px_per_mm);
    if things.len() > MOST {
        return None;
    }
    let may_be =
        |kind: &Vec<Thing>| kind.len() >= LEAST && kind[0].side() >= SMALLEST * px_per_mm && kind[0].may_mark(paths);
    let (marks, others): (Vec<Vec<Thing>>, Vec<Vec<Thing>>) = kinds(things, paths).into_iter().partition(may_be);
    if marks.is_empty() {
        return None;
    }
    let are_led_to = LedTo::among(paths, &marks, params.widest_stroke, size).kinds();
    let mut others: Vec<Neighbour> = others.iter().flatten().map(Thing::as_neighbour).collect();
    let mut found: Vec<Kind> = Vec::new();
    for (kind, is_led_to) in marks.into_iter().zip(are_led_to) {
        match Kind::of(&kind, paths, picture, params, size).filter(|_| !is_led_to) {
            Some(of) => found.push(of),
            None => others.extend(kind.iter().map(Thing::as_neighbour)),
        }
    }
    found.retain(|kind| !are_letters(&kind.middles(), kind.side, &others));
    // of kinds that are as many, the one that is painted first comes first
    found.sort_by_key(|kind| (!kind.is_filled, Reverse(kind.signs.len())));
    let mut are_signs = vec![false; paths.len()];
    found.iter().flat_map(|kind| kind.paths.iter().cloned().flatten()).for_each(|path| are_signs[path] = true);
    (!found.is_empty()).then(|| (Signs::of_kinds(found.into_iter().map(|kind| kind.signs).collect()), are_signs))
}

/// A small thing that one path paints, or several one after the other.
#[derive(Debug, Clone, PartialEq)]
struct Thing {
    /// The numbers of its paths.
    paths: Range<usize>,
    /// The box around it, with its strokes.
    min: PxPoint,
    max: PxPoint,
}

impl Thing {
    fn of(number: usize, painted: &PaintedPath) -> Self {
        let bounds = painted.path.bounds();
        let half = 0.5 * painted.stroke.as_ref().map_or(0.0, |stroke| stroke.width);
        let min = PxPoint::new(bounds.left() - half, bounds.top() - half);
        let max = PxPoint::new(bounds.right() + half, bounds.bottom() + half);
        Self { paths: number..number + 1, min, max }
    }

    fn middle(&self) -> PxPoint {
        self.min.lerp(self.max, 0.5)
    }

    fn sides(&self) -> [f32; 2] {
        (self.max - self.min).to_array()
    }

    fn side(&self) -> f32 {
        let [width, height] = self.sides();
        width.max(height)
    }

    fn as_neighbour(&self) -> Neighbour {
        Neighbour { middle: self.middle().to_array(), sides: self.sides() }
    }

    /// Whether what is painted next stands around the same middle, as the second stroke of a cross.
    fn is_one_with(&self, next: &Self, paths: &[PaintedPath]) -> bool {
        self.paths.end == next.paths.start
            && self.paths.len() < MOST_PATHS
            && (self.middle() - next.middle()).length() <= ONE_MIDDLE * self.side().max(next.side())
            && !self.is_like(next, paths)
    }

    /// Whether another one is the same at another place.
    fn is_like(&self, other: &Self, paths: &[PaintedPath]) -> bool {
        let away = other.middle() - self.middle();
        let most = ALIKE.max(ALIKE_SHARE * self.side());
        let mut pairs = paths[self.paths.clone()].iter().zip(&paths[other.paths.clone()]);
        self.paths.len() == other.paths.len() && pairs.all(|(own, of)| are_alike(own, of, away, most))
    }

    /// Whether its shape is one that marks places: about as wide as high, and round, or with some corners, or a cross.
    fn may_mark(&self, paths: &[PaintedPath]) -> bool {
        let [width, height] = self.sides();
        let own = &paths[self.paths.clone()];
        let is_of_outlines = || own.iter().all(|of| is_outline(of, self.middle(), self.side()));
        let is_as_wide = width.min(height) >= AS_WIDE * width.max(height);
        is_as_wide && (is_of_outlines() || is_cross(own, self.middle(), self.side()))
    }

    /// The strength of what the picture shows of it; 0 where it is hidden.
    fn strength(&self, paths: &[PaintedPath], picture: &Lab, params: &Params, size: Size) -> f32 {
        let own = proposals(&paths[self.paths.clone()], params.widest_stroke, size);
        let seen = own.iter().flat_map(|proposal| confirmed(proposal, picture, params));
        seen.flat_map(|of| of.line.vertices).map(|vertex| vertex.strength).fold(0.0, f32::max)
    }

    /// Whether its middle has another colour than its ground.
    fn is_filled(&self, picture: &Lab) -> bool {
        let (middle, reach) = (self.middle(), 0.5 * self.side() + BESIDE);
        let own = picture.colour(middle);
        let around = [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)];
        let is_other =
            |(x, y): (f32, f32)| distance(picture.colour(middle + PxVector::new(x, y) * reach), own) >= CONTRAST;
        // another sign may lie on one of its sides
        around.into_iter().filter(|way| is_other(*way)).count() > 2
    }
}

/// Whether two paths are one but for where they are: the second lies so far `away`, but for `most`, px.
fn are_alike(own: &PaintedPath, of: &PaintedPath, away: PxVector, most: f32) -> bool {
    let widths = [own, of].map(|painted| painted.stroke.as_ref().map(|stroke| stroke.width));
    let is_as_wide = match widths {
        [Some(own), Some(of)] => (own - of).abs() <= most,
        [own, of] => own.is_none() && of.is_none(),
    };
    let mut points = own.path.points().iter().zip(of.path.points());
    is_as_wide
        && own.colours == of.colours
        && own.path.verbs() == of.path.verbs()
        && points.all(|(own, of)| (PxVector::new(of.x - own.x, of.y - own.y) - away).length() <= most)
}

/// All small things that are painted, none larger than `most`, px.
fn small_things(paths: &[PaintedPath], most: f32) -> Vec<Thing> {
    let mut all: Vec<Thing> = Vec::new();
    for (number, painted) in paths.iter().enumerate() {
        let next = Thing::of(number, painted);
        if next.side() > most {
            continue;
        }
        match all.last_mut().filter(|last| last.is_one_with(&next, paths)) {
            Some(last) => {
                last.paths.end = next.paths.end;
                (last.min, last.max) = (last.min.min(next.min), last.max.max(next.max));
            }
            None => all.push(next),
        }
    }
    all
}

/// Things that are alike, kind by kind, in the order in which the first of each is painted.
fn kinds(things: Vec<Thing>, paths: &[PaintedPath]) -> Vec<Vec<Thing>> {
    let mut kinds: Vec<Vec<Thing>> = Vec::new();
    // only what has as many pieces is compared
    let mut of_pieces: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for thing in things {
        let pieces = paths[thing.paths.clone()].iter().map(|painted| painted.path.len()).sum::<usize>();
        let same = of_pieces.entry(pieces).or_default();
        let own = same.iter().copied().find(|&kind| kinds[kind][0].is_like(&thing, paths));
        match own {
            Some(kind) => kinds[kind].push(thing),
            None => {
                same.push(kinds.len());
                kinds.push(vec![thing]);
            }
        }
    }
    kinds
}

/// Signs of one kind.
struct Kind {
    signs: Vec<Sign>,
    /// The paths of all of them, also of those that are hidden.
    paths: Vec<Range<usize>>,
    side: f32,
    is_filled: bool,
}

impl Kind {
    /// Those of things that are alike, as far as they are seen, if they are scattered.
    fn of(kind: &[Thing], paths: &[PaintedPath], picture: &Lab, params: &Params, size: Size) -> Option<Self> {
        let [width, height] = kind.first()?.sides();
        let side = 0.5 * (width + height);
        let sign = |thing: &Thing| Sign {
            at: thing.middle(),
            radius: 0.5 * side,
            strength: thing.strength(paths, picture, params, size),
        };
        let signs: Vec<Sign> = kind.iter().map(sign).filter(|sign| sign.strength > 0.0).collect();
        if signs.len() < LEAST {
            return None;
        }
        let own = &paths[kind[0].paths.clone()];
        let filled = kind.iter().filter(|thing| thing.is_filled(picture)).count();
        let is_filled = 2 * filled > kind.len() && !is_cross(own, kind[0].middle(), kind[0].side());
        let of = Self { signs, paths: kind.iter().map(|thing| thing.paths.clone()).collect(), side, is_filled };
        are_scattered(&of.middles(), APART * side).then_some(of)
    }

    fn middles(&self) -> Vec<[f32; 2]> {
        self.signs.iter().map(|sign| sign.at.to_array()).collect()
    }
}

/// Which things lines lead to: those through whose middles lines are led, and those at which lines end. Such are the
/// points of a curve or of a figure, the stops of a route, the nodes of a graph, the values of bars of errors, and the
/// heads of arrows. The lines of a grid may lie below any point.
struct LedTo<'t> {
    things: &'t [Vec<Thing>],
    /// The kind and the number of each, by place.
    index: Index<(usize, usize), Px>,
    /// The largest side of them, px.
    largest: f32,
    led: Vec<Vec<bool>>,
}

impl<'t> LedTo<'t> {
    /// Those to which the strokes lead that are no parts of things.
    fn among(paths: &[PaintedPath], things: &'t [Vec<Thing>], widest_stroke: f32, size: Size) -> Self {
        let area = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
        let led = things.iter().map(|kind| vec![false; kind.len()]).collect();
        let mut found = Self { things, index: Index::new(area, CELL), largest: 0.0, led };
        let mut is_of_thing = vec![false; paths.len()];
        for (kind, of) in things.iter().enumerate() {
            for (number, thing) in of.iter().enumerate() {
                found.index.put_at(thing.middle(), (kind, number));
                found.largest = found.largest.max(thing.side());
                thing.paths.clone().for_each(|path| is_of_thing[path] = true);
            }
        }
        let strokes = paths.iter().zip(is_of_thing).filter(|(painted, of_thing)| !of_thing && painted.stroke.is_some());
        let strokes: Vec<(&PaintedPath, Vec<Part>)> =
            strokes.map(|(painted, _)| (painted, parts(&painted.path))).collect();
        let lanes = |(painted, parts): &(&PaintedPath, Vec<Part>)| -> Vec<Option<Lane>> {
            parts.iter().map(|part| lane(part, painted.colours[1])).collect()
        };
        let mut alike: BTreeMap<Lane, usize> = BTreeMap::new();
        strokes.iter().flat_map(lanes).flatten().for_each(|lane| *alike.entry(lane).or_default() += 1);
        let is_of_grid = |lane: &Option<Lane>| lane.as_ref().is_some_and(|lane| alike[lane] >= OF_GRID);
        for stroke in &strokes {
            found.mark_ends(&stroke.1);
            if !lanes(stroke).iter().all(is_of_grid) {
                found.follow(stroke.0, &stroke.1, widest_stroke, size);
            }
        }
        found
    }

    /// Marks that at which a stroke ends, which has these parts. Lines as alike as those of a grid may be shafts of
    /// arrows, which end at their heads; of points few lie at the ends of a grid's lines.
    fn mark_ends(&mut self, parts: &[Part]) {
        let open = parts.iter().filter(|part| !part.closed);
        let ends = open.filter_map(|part| Some([*part.corners.first()?, *part.corners.last()?]));
        ends.flatten().for_each(|at| self.mark(at, AT_SIDE));
    }

    /// Marks that through whose middle a stroke leads, which has these parts.
    fn follow(&mut self, painted: &PaintedPath, parts: &[Part], widest_stroke: f32, size: Size) {
        parts.iter().flat_map(|part| &part.corners).for_each(|at| self.mark(*at, AT_MIDDLE));
        for proposal in proposals([painted], widest_stroke, size) {
            for (from, to) in proposal.line.segments() {
                self.mark(from.lerp(*to, 0.5), AT_MIDDLE);
            }
        }
    }

    /// Marks the things whose middles are no farther from a place of a line than this share of their sides.
    fn mark(&mut self, at: PxPoint, share: f32) {
        let Self { things, index, largest, led } = self;
        index.around(at, at, share * *largest, |&(kind, number)| {
            let thing = &things[kind][number];
            led[kind][number] |= (at - thing.middle()).length() <= share * thing.side();
        });
    }

    /// Of each kind, whether lines lead to half of its things or more.
    fn kinds(&self) -> Vec<bool> {
        let is_led = |led: &Vec<bool>| 2 * led.iter().filter(|is_led| **is_led).count() >= led.len();
        self.led.iter().map(is_led).collect()
    }
}

/// A level or upright line of one piece: which of both, its colour, and from where to where it leads, px.
type Lane = (bool, Option<[u8; 4]>, [i32; 2]);

/// A part of a stroke of some colour as such a line, if it is one.
fn lane(part: &Part, colour: Option<[u8; 4]>) -> Option<Lane> {
    let [a, b] = part.corners[..] else { return None };
    let way = b - a;
    let is_level = way.y.abs() <= SLANTED * way.length();
    let is_upright = way.x.abs() <= SLANTED * way.length();
    let [from, to] = if is_level { [a.x, b.x] } else { [a.y, b.y] };
    let ends = [from.min(to), from.max(to)].map(|end| end.round() as i32);
    (is_level || is_upright).then_some((is_level, colour, ends))
}

#[cfg(test)]
mod tests;
