//! The middle of a stroke to a fraction of a pixel, its width and its contrast.

use super::arms::Strand;
use super::ends::{self, STEP, UNSURE};
use super::tint::{self, Tint};
use crate::edges::contour::{Contour, ContourPoint};
use crate::edges::corner;
use crate::edges::params::Params;
use crate::geom::order::{median, quantile, sorted};
use crate::geom::polyline::{Polyline, smooth};
use crate::geom::right_of;
use crate::geom::walk::runs;
use crate::raster::contrast::{less, square};
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector, Size};

/// A stroke.
#[derive(Debug, Clone)]
pub(in crate::edges) struct Stroke {
    /// Its middle.
    pub(in crate::edges) contour: Contour,
    /// Its width, px.
    pub(in crate::edges) width: f32,
    /// Length of the stroke that was found, of which this may be a part, px.
    pub(in crate::edges) whole: f32,
    /// Whether it is so short that it is a stroke only in a row of such, as a dash.
    pub(in crate::edges) is_dash: bool,
    /// Its tint, where that can be told: the ground beside it is the same on both sides.
    pub(in crate::edges) tint: Option<Tint>,
}

/// Sigma of the Gaussian that takes the steps of pixels out of a line before it is centred, px; then, of what noise is
/// left.
const SMOOTHING: [f32; 3] = [1.5, 1.0, 1.0];
/// Of a junction, the half width of the stroke and this much more, px, are drawn aside by what joins there.
const JOINING: f32 = 2.0;
/// A line goes straight through a junction if the cosine of its turns there is at least this (26 degrees).
const STRAIGHT_ON: f32 = 0.9;
/// A cross section ends where less than this share of its largest value is left.
const END: f32 = 0.25;
/// Beyond this much more than half its width, px, what is read is no longer the stroke.
const BEYOND: f32 = 1.5;
/// A stroke is at least this many least lengths of a contour long; shorter ones, such as those of letters, could not be
/// lines anyway.
const SHORTEST: f32 = 3.0;
/// A stroke with the same ground on both sides is at least so many least lengths long: the end of an axis beyond a bar
/// is part of a longer line. Between two areas there is an edge that is longer.
pub(super) const SHORTEST_APART: f32 = 1.5;
/// The ground on both sides is the same if the step between them is at most this share of the contrast with it.
const SAME_GROUND: f32 = 0.25;
/// The lower quartile of a stroke's widths is at least this share of the upper one: of a wedge it is a third.
const EVEN: f32 = 0.5;
/// A tint is told on one ground only: its colours differ by at most this, a step that is hardly worth a line.
const ONE_GROUND: f32 = 10.0;
/// A stroke is at least this many times as long as wide; what is shorter is an area.
pub(super) const LONG: f32 = 5.0;
/// A stroke is lighter or darker than both its sides, or otherwise beyond both, by at least this share of the step
/// between them. One that shows less leaves the edge where it is; and beside a sharpened edge there is a rim that is no
/// stroke.
const OF_STEP: f32 = 0.2;
/// On a part of a line that ends at a junction, and is no longer than so many widths of the stroke and this much more,
/// px, contrast cannot be measured: what joins the line there lies beside it.
const PASSED_WIDTHS: f32 = 3.0;
const PASSED: f32 = 8.0;
/// Whether there is contrast at a vertex is decided with so many vertices before it and behind it.
const NEAR_VERTICES: usize = 4;
/// How far it moves, with so many.
const NEAR_SHIFTS: usize = 2;
/// Colours beside a stroke are read this far outside it, px.
const OUTSIDE: f32 = 2.0;
/// How far vertices lie from the middle by chance, px.
const OFF: f32 = 0.2;
/// A line along the border of the picture, nearer to it than this, px, is the border.
const BORDER: f32 = 2.0;

/// The profile of a residue across a line.
#[derive(Debug, Clone, Copy, Default)]
struct CrossSection {
    /// Where its middle is, px to the right of the line.
    shift: f32,
    /// Its sum over its largest value, px.
    width: f32,
    /// Whether it goes on beyond what was read.
    is_cut: bool,
}

/// The width of what is thin across a line of pixels at one of its vertices, px. Its residue is that of a square of
/// this half side, px.
pub(super) fn width_at(line: &Polyline<PxPoint>, i: usize, residue: &Plane, radius: usize) -> f32 {
    profile(line, i, residue, radius as f32 + 0.5 + BEYOND).width
}

/// The strokes along a line of pixels.
pub(super) fn strokes(
    strand: Strand,
    residue: &Plane,
    planes: &[Plane],
    radius: usize,
    params: &Params,
) -> Vec<Stroke> {
    let Strand { mut line, free, junctions } = strand;
    let length = line.length();
    let is_dash = length < SHORTEST_APART * params.min_length;
    let is_lone = !line.closed && free == [true; 2] && junctions.is_empty();
    if is_dash {
        let straight = (is_lone && length >= ends::SHORTEST_DASH).then(|| ends::straight_dash(&line, residue));
        let Some(straight) = straight.flatten() else { return Vec::new() };
        line = straight;
    }
    let widest = params.widest_of_bitmap().min(2.0 * radius as f32 - 1.0);
    let mut width = 2.0 * radius as f32 + 1.0;
    let farthest = 0.5 * width + BEYOND;
    for (round, sigma) in (1..).zip(SMOOTHING) {
        line = if is_dash { line } else { smoothed(&line, sigma) };
        let profiles: Vec<CrossSection> =
            (0..line.vertices.len()).map(|i| profile(&line, i, residue, 0.5 * width + BEYOND)).collect();
        width = quantile(&sorted(profiles.iter().map(|profile| profile.width)), 0.5).max(1.0);
        // most are none: what the last round tells of them is enough
        if round == SMOOTHING.len() && (width > widest || !is_even(&line, &profiles, residue, farthest)) {
            return Vec::new();
        }
        line = through_junctions(&centred(&line, &profiles, 0.5 * width), &junctions, 0.5 * width + JOINING);
    }
    match is_dash {
        true => ends::extend_dash(&mut line, residue),
        false => ends::extend_ends(&mut line, free, residue, width),
    }
    let contrasts: Vec<StrokeContrast> = (0..line.vertices.len()).map(|i| contrast(&line, i, width, planes)).collect();
    let is_apart = || 2 * contrasts.iter().filter(|contrast| contrast.is_apart).count() > contrasts.len();
    if length < SHORTEST * params.min_length && !is_apart() {
        return Vec::new();
    }
    let passed = PASSED_WIDTHS * width + PASSED;
    let stretches = with_contrast(&line, &junctions, &contrasts, (passed, params.low)).into_iter();
    let parts =
        stretches.flat_map(|stretch| if is_dash { vec![stretch] } else { of_one_tint(stretch, passed, params.high) });
    let long = if is_dash { ends::LONG_DASH } else { LONG };
    let strokes = parts.filter(|(line, contrasts)| {
        line.length() >= long * width
            && contrasts.iter().any(|contrast| contrast.of_stroke() >= params.high)
            && !is_border(line, residue)
    });
    let found = strokes.map(|(line, contrasts)| stroke(&line, &contrasts, width, residue.size, params));
    found.map(|found| Stroke { is_dash, ..found }).collect()
}

/// A line of this width as a stroke, if most of it is clearly one on the same ground on both sides.
pub(super) fn on_one_ground(line: &Polyline<PxPoint>, width: f32, planes: &[Plane], params: &Params) -> Option<Stroke> {
    let contrasts: Vec<StrokeContrast> = (0..line.vertices.len()).map(|i| contrast(line, i, width, planes)).collect();
    let is_clear = |contrast: &&StrokeContrast| contrast.is_apart && contrast.of_stroke() >= params.high;
    let is_stroke = 2 * contrasts.iter().filter(is_clear).count() > contrasts.len();
    is_stroke.then(|| stroke(line, &contrasts, width, planes[0].size, params))
}

/// Whether a line is about as wide here as there. Where cross sections were cut off, they are read anew as far as
/// `farthest`: cut off at the width of its middle, the tip of a filled triangle seems even.
fn is_even(line: &Polyline<PxPoint>, profiles: &[CrossSection], residue: &Plane, farthest: f32) -> bool {
    let whole = |(i, cross): (usize, &CrossSection)| {
        if cross.is_cut { profile(line, i, residue, farthest).width } else { cross.width }
    };
    let widths = sorted(profiles.iter().enumerate().map(whole));
    quantile(&widths, 0.25) >= EVEN * quantile(&widths, 0.75)
}

fn stroke(
    line: &Polyline<PxPoint>,
    contrasts: &[StrokeContrast],
    width: f32,
    picture: Size,
    params: &Params,
) -> Stroke {
    let strength = smooth(&line.arc_lengths(), line.closed, 0.5 * params.strength_window, |i| [contrasts[i].height]);
    let vertices = line.vertices.iter().zip(strength).map(|(&at, [strength])| ContourPoint {
        at,
        strength,
        contrast: [0.0; 3],
        blur: 0.5 * width + UNSURE,
        position_sigma: OFF,
    });
    let mut contour = Polyline { vertices: vertices.collect(), closed: line.closed };
    corner::sharpen(&mut contour, picture, false);
    let whole = contour.length();
    let tints: Vec<Tint> = tints(contrasts, params.high).into_iter().flatten().collect();
    Stroke { contour, width, whole, is_dash: false, tint: Tint::most_common(&tints) }
}

/// The parts of a stretch of a line that have one tint each, told where its contrast is at least `least`; all of it if
/// it has one. What has another one over less than `passed` px crosses it.
fn of_one_tint(
    (line, contrasts): (Polyline<PxPoint>, Vec<StrokeContrast>),
    passed: f32,
    least: f32,
) -> Vec<(Polyline<PxPoint>, Vec<StrokeContrast>)> {
    let Some(parts) = tint::parts(&line, &tints(&contrasts, least), passed) else {
        return vec![(line, contrasts)];
    };
    let part = |vertices: Vec<usize>| {
        let line = Polyline::open(vertices.iter().map(|&i| line.vertices[i]).collect());
        (line, vertices.iter().map(|&i| contrasts[i]).collect())
    };
    parts.into_iter().map(part).collect()
}

/// The tints along a line where its contrast is at least `least` and the ground on both sides is that of most of it. On
/// another ground the same stroke has another tint.
fn tints(contrasts: &[StrokeContrast], least: f32) -> Vec<Option<Tint>> {
    let is_clear = |contrast: &StrokeContrast| contrast.is_apart && contrast.of_stroke() >= least;
    let clear: Vec<&StrokeContrast> = contrasts.iter().filter(|&contrast| is_clear(contrast)).collect();
    let ground = [0, 1, 2].map(|plane| median(clear.iter().map(|contrast| contrast.ground[plane])));
    let is_ground = |here: [f32; 3]| square(less(here, ground)) <= ONE_GROUND * ONE_GROUND;
    let of = |contrast: &StrokeContrast| {
        if is_clear(contrast) && is_ground(contrast.ground) { Tint::of(contrast.excess) } else { None }
    };
    contrasts.iter().map(of).collect()
}

/// The stretches of a line that have a contrast of at least `least`, or that are no longer than `passed` px and beside
/// such a one, each with its contrasts: all of it, or what lies between some of its junctions, where a stroke may go on
/// along the border of an area, which is none.
fn with_contrast(
    line: &Polyline<PxPoint>,
    junctions: &[PxPoint],
    contrasts: &[StrokeContrast],
    (passed, least): (f32, f32),
) -> Vec<(Polyline<PxPoint>, Vec<StrokeContrast>)> {
    let n = contrasts.len();
    let mut breaks: Vec<usize> = junctions.iter().filter_map(|junction| nearest_vertex(line, *junction)).collect();
    breaks.extend(changes(line, contrasts, passed, least));
    breaks.sort_unstable();
    breaks.dedup();
    // each as the indices of its vertices, with both junctions
    let mut parts: Vec<Vec<usize>> = breaks.windows(2).map(|pair| (pair[0]..=pair[1]).collect()).collect();
    match (breaks.first(), breaks.last()) {
        (Some(&first), Some(&last)) if line.closed => parts.push((last..n).chain(0..=first).collect()),
        (Some(&first), Some(&last)) => {
            parts.insert(0, (0..=first).collect());
            parts.push((last..n).collect());
        }
        _ => parts.push((0..n).collect()),
    }
    let has_contrast: Vec<bool> =
        parts.iter().map(|part| median(part.iter().map(|&i| contrasts[i].of_stroke())) >= least).collect();
    let is_short = |part: &[usize]| {
        let steps = part.windows(2).map(|pair| (line.vertices[pair[1]] - line.vertices[pair[0]]).length());
        steps.sum::<f32>() <= passed
    };
    let count = parts.len();
    let beside = |k: usize| has_contrast[(k + 1) % count] || has_contrast[(k + count - 1) % count];
    let shown: Vec<bool> = (0..count).map(|k| has_contrast[k] || is_short(&parts[k]) && beside(k)).collect();
    if shown.iter().all(|shown| *shown) {
        return vec![(line.clone(), contrasts.to_vec())];
    }
    let stretch = |run: &[usize]| {
        let mut indices: Vec<usize> = run.iter().flat_map(|&part| parts[part].iter().copied()).collect();
        indices.dedup();
        let line = Polyline::open(indices.iter().map(|&i| line.vertices[i]).collect());
        (line, indices.iter().map(|&i| contrasts[i]).collect())
    };
    let runs = runs(count, line.closed, |a, b| shown[a] == shown[b]).into_iter();
    runs.filter(|run| shown[run[0]]).map(|run| stretch(&run)).collect()
}

/// Where a line has contrast on one side and none on the other, both for at least `apart` px.
fn changes(line: &Polyline<PxPoint>, contrasts: &[StrokeContrast], apart: f32, least: f32) -> Vec<usize> {
    let n = contrasts.len();
    let near = |i: usize| median(around(line, i, NEAR_VERTICES).map(|k| contrasts[k].of_stroke()));
    let has: Vec<bool> = (0..n).map(|i| near(i) >= least).collect();
    let length = |run: &Vec<usize>| -> f32 {
        run.windows(2).map(|pair| (line.vertices[pair[1]] - line.vertices[pair[0]]).length()).sum()
    };
    // runs that are too short belong to those before them
    let mut runs = runs(n, line.closed, |a, b| has[a] == has[b]);
    runs.retain(|run| length(run) >= apart);
    let before = runs.last().filter(|_| line.closed).into_iter().chain(&runs);
    let pairs = before.zip(runs.iter().skip(usize::from(!line.closed)));
    pairs.filter(|(before, run)| has[before[0]] != has[run[0]]).map(|(_, run)| run[0]).collect()
}

/// A vertex of a line with up to so many before it and behind it, in order; fewer at the ends of an open one.
fn around(line: &Polyline<PxPoint>, i: usize, count: usize) -> impl Iterator<Item = usize> {
    let view = line.view();
    let most = if line.closed { line.vertices.len().saturating_sub(1) / 2 } else { count };
    let count = count.min(most) as isize;
    (-count..=count).filter_map(move |step| view.next(i, step))
}

fn smoothed(line: &Polyline<PxPoint>, sigma: f32) -> Polyline<PxPoint> {
    let at = smooth(&line.arc_lengths(), line.closed, sigma, |i| [line.vertices[i].x, line.vertices[i].y]);
    Polyline { vertices: at.into_iter().map(|[x, y]| PxPoint::new(x, y)).collect(), closed: line.closed }
}

/// Each vertex moved to the middle of its profile; the shifts are smoothed, so that a crossing stroke moves nothing.
fn centred(line: &Polyline<PxPoint>, profiles: &[CrossSection], most: f32) -> Polyline<PxPoint> {
    let arcs = line.arc_lengths();
    let shift = |i: usize| {
        let shift = median(around(line, i, NEAR_SHIFTS).map(|k| profiles[k].shift));
        [shift.clamp(-most.max(1.0), most.max(1.0))]
    };
    let shifts = smooth(&arcs, line.closed, 1.0, shift);
    let vertices = line.vertices.iter().zip(shifts).enumerate().map(|(i, (&at, [shift]))| at + right(line, i) * shift);
    Polyline { vertices: vertices.collect(), closed: line.closed }
}

fn nearest_vertex(line: &Polyline<PxPoint>, at: PxPoint) -> Option<usize> {
    let distance = |i: &usize| (line.vertices[*i] - at).square_length();
    (0..line.vertices.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Goes straight through the junctions at which a line does not turn: what joins it there draws it aside.
fn through_junctions(line: &Polyline<PxPoint>, junctions: &[PxPoint], reach: f32) -> Polyline<PxPoint> {
    let mut straight = line.clone();
    let view = line.view();
    let count = line.vertices.len() as isize;
    for junction in junctions {
        let Some(nearest) = nearest_vertex(line, *junction) else { continue };
        // the first vertex outside, and one as far again
        let outside = |step: isize, reach: f32| {
            let walk = (1..count).map_while(|k| view.next(nearest, k * step).map(|i| (k, i)));
            walk.into_iter().find(|(_, i)| (line.vertices[*i] - *junction).length() > reach)
        };
        let sides = [-1, 1].map(|step| outside(step, reach).zip(outside(step, 2.0 * reach)));
        let [Some(((back, before), (_, far_before))), Some(((on, after), (_, far_after)))] = sides else { continue };
        let (a, b) = (line.vertices[before], line.vertices[after]);
        let [into, through, out] = [a - line.vertices[far_before], b - a, line.vertices[far_after] - b]
            .map(|chord| chord.try_normalize().unwrap_or_default());
        if into.dot(through) < STRAIGHT_ON || through.dot(out) < STRAIGHT_ON {
            continue;
        }
        for k in 1 - back..on {
            if let Some(i) = view.next(nearest, k) {
                straight.vertices[i] = a.lerp(b, (k + back) as f32 / (on + back) as f32);
            }
        }
    }
    straight
}

/// Unit vector to the right of a line at a vertex, with y down.
fn right(line: &Polyline<PxPoint>, i: usize) -> PxVector {
    let view = line.view();
    let [before, after] = [-2, 2].map(|step| view.next(i, step).or(view.next(i, step / 2)).unwrap_or(i));
    let along = (line.vertices[after] - line.vertices[before]).try_normalize().unwrap_or(PxVector::zero());
    right_of(along)
}

/// The profile of the residue across the line at a vertex, as far as `reach`.
fn profile(line: &Polyline<PxPoint>, i: usize, residue: &Plane, reach: f32) -> CrossSection {
    let mut steps_across = StepsAcross::new(residue, line.vertices[i], right(line, i));
    let steps = (reach / STEP).ceil() as i32;
    // the largest value near the line is the stroke's
    let near = (1.0 / STEP) as i32;
    let (peak, top) = (-near..=near)
        .map(|k| (steps_across.value(k), k))
        .fold((0.0_f32, 0), |best, here| if here.0 > best.0 { here } else { best });
    if peak <= 0.0 {
        return CrossSection::default();
    }
    let (mut sum, mut weights, mut moment) = (peak, (1.0 - END) * peak, (1.0 - END) * peak * top as f32 * STEP);
    let mut ended = 0;
    for direction in [1, -1] {
        for k in 1..=steps {
            let step = top + direction * k;
            let here = steps_across.value(step);
            if here < END * peak {
                ended += 1;
                break;
            }
            sum += here;
            // a weight without a jump, so that the middle does not depend on where the steps lie
            weights += here - END * peak;
            moment += (here - END * peak) * (step as f32 * STEP);
        }
    }
    CrossSection { shift: moment / weights, width: sum * STEP / peak, is_cut: ended < 2 }
}

/// So many values of a profile are read at once: a processor works out their places side by side.
const AT_ONCE: usize = 8;
/// The first step of those to the left of the point.
const FIRST_LEFT: i32 = -(AT_ONCE as i32);

/// The values of a plane across a line at one of its points, numbered by the steps to its right. Each is read once.
struct StepsAcross<'a> {
    plane: &'a Plane,
    at: PxPoint,
    across: PxVector,
    /// Those to the left of the point, and those from it on to the right.
    near: [[f32; AT_ONCE]; 2],
    /// Those read last farther away, and the first of their steps.
    far: (i32, [f32; AT_ONCE]),
}

impl<'a> StepsAcross<'a> {
    fn new(plane: &'a Plane, at: PxPoint, across: PxVector) -> Self {
        let near = [FIRST_LEFT, 0].map(|first| values_across(plane, at, across, first));
        Self { plane, at, across, near, far: (0, near[1]) }
    }

    fn value(&mut self, step: i32) -> f32 {
        let place = step.rem_euclid(AT_ONCE as i32);
        let first = step - place;
        let values = match first {
            FIRST_LEFT => &self.near[0],
            0 => &self.near[1],
            _ => {
                if self.far.0 != first {
                    self.far = (first, values_across(self.plane, self.at, self.across, first));
                }
                &self.far.1
            }
        };
        values[place as usize]
    }
}

/// The values across a line at one of its points, from a step on.
fn values_across(plane: &Plane, at: PxPoint, across: PxVector, first: i32) -> [f32; AT_ONCE] {
    let (mut x, mut y) = ([0.0; AT_ONCE], [0.0; AT_ONCE]);
    for i in 0..AT_ONCE {
        let place = at + across * ((first + i as i32) as f32 * STEP);
        (x[i], y[i]) = (place.x, place.y);
    }
    plane.at_each(x, y)
}

/// The contrast at a vertex of a line.
#[derive(Debug, Clone, Copy)]
struct StrokeContrast {
    /// How far the colour of the line is from those beside it, and these from one another.
    height: f32,
    /// Whether it is a stroke's, or only the border's of two areas.
    is_stroke: bool,
    /// Whether the colours on both sides of the stroke are the same.
    is_apart: bool,
    /// The mean of these, and what the colour of the line has more; 0 in planes that there are not.
    ground: [f32; 3],
    excess: [f32; 3],
}

impl StrokeContrast {
    /// The height, if it is a stroke's.
    fn of_stroke(&self) -> f32 {
        if self.is_stroke { self.height } else { 0.0 }
    }
}

/// How far the colour of a place is from those beside it, and these from one another, across a direction.
pub(super) fn contrast_across(at: PxPoint, across: PxVector, width: f32, planes: &[Plane]) -> f32 {
    contrast_at(at, across, width, planes).height
}

/// Contrast at a vertex with the ground on both sides, in all planes.
fn contrast(line: &Polyline<PxPoint>, i: usize, width: f32, planes: &[Plane]) -> StrokeContrast {
    contrast_at(line.vertices[i], right(line, i), width, planes)
}

fn contrast_at(at: PxPoint, across: PxVector, width: f32, planes: &[Plane]) -> StrokeContrast {
    let outside = 0.5 * width + OUTSIDE;
    let places = [outside, -outside, 0.0].map(|distance| at + across * distance);
    let (x, y) = (places.map(|place| place.x), places.map(|place| place.y));
    let (mut step, mut height, mut beyond) = (0.0, 0.0, 0.0);
    let (mut ground, mut excess) = ([0.0; 3], [0.0; 3]);
    for (plane, (ground, excess)) in planes.iter().zip(ground.iter_mut().zip(&mut excess)) {
        let [a, b, here] = plane.at_each(x, y);
        let add = |sum: &mut f32, difference: f32| *sum += difference * difference;
        *ground = 0.5 * (a + b);
        *excess = here - *ground;
        add(&mut step, a - b);
        add(&mut height, *excess);
        add(&mut beyond, here - here.clamp(a.min(b), a.max(b)));
    }
    let [step, height, beyond] = [step, height, beyond].map(f32::sqrt);
    let (is_stroke, is_apart) = (beyond >= OF_STEP * step, step <= SAME_GROUND * height);
    StrokeContrast { height: height.max(step), is_stroke, is_apart, ground, excess }
}

/// Whether a line runs along the border of the picture.
fn is_border(line: &Polyline<PxPoint>, plane: &Plane) -> bool {
    let (width, height) = (plane.size.width as f32, plane.size.height as f32);
    let near = |at: &PxPoint| at.x.min(at.y).min(width - at.x).min(height - at.y) <= BORDER;
    2 * line.vertices.iter().filter(|at| near(at)).count() > line.vertices.len()
}

#[cfg(test)]
mod tests;
