//! How far a page lies from the truth: from what was drawn, or from the page of a higher resolution.

use tactograph::internals::classes::{Class, Classes};
use tactograph::internals::touch::{Ink, report};
use tactograph::internals::units::{MmPoint, MmRect, PageTransform, PxPoint, Size};

use crate::run::Outcome;
use tactograph_tools::P;
use tactograph_tools::camera_scene::Scene;
use tactograph_tools::near::Near;

/// A fingertip, mm.
pub(crate) const FINGER: f32 = 1.0;
/// A place with nothing within this distance has no counterpart, mm.
const GATE: f64 = 1.0;
/// Lines are looked at every so often, mm.
const STEP: f64 = 0.1;
/// What lies nearer to the border of the figure is not judged, mm.
const BORDER: f64 = 4.0;
/// Nearer to a true outline than this, the class is not judged, mm.
const BESIDE: f64 = 2.0;
/// Nearer to a true outline or to the border of the figure than this, what is felt is not judged, mm.
const INSIDE: f64 = 7.0;

/// What is held against one another.
pub(crate) struct Sight<'a> {
    place: MmRect,
    paths: Vec<(Vec<P>, f64)>,
    class: Box<dyn Fn(MmPoint) -> Option<Class> + 'a>,
    /// How far a place is from every true outline, mm, where that is known.
    clearance: Option<Box<dyn Fn(MmPoint) -> f64 + 'a>>,
}

/// All figures of one page; not a number where there is nothing to judge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Errors {
    pub(crate) rms: f64,
    pub(crate) p95: f64,
    pub(crate) missing: f64,
    pub(crate) extra: f64,
    pub(crate) strength: f64,
    pub(crate) class: f64,
    pub(crate) read: f64,
}

impl Errors {
    /// Names in their order.
    pub(crate) const NAMES: [&str; 7] = [
        "rms_mm",
        "p95_mm",
        "missing_share",
        "extra_share",
        "strength_rank_correlation",
        "other_class_share",
        "read_right",
    ];

    pub(crate) fn all(&self) -> [f64; 7] {
        [self.rms, self.p95, self.missing, self.extra, self.strength, self.class, self.read]
    }

    pub(crate) fn from(all: [f64; 7]) -> Self {
        let [rms, p95, missing, extra, strength, class, read] = all;
        Self { rms, p95, missing, extra, strength, class, read }
    }
}

impl<'a> Sight<'a> {
    /// What was drawn, as it lies on the page.
    pub(crate) fn of_scene(scene: &'a Scene, page: &Outcome) -> Self {
        let [width, height] = scene.size.map(|side| side as u32);
        let frame = PageTransform::new(Size::new(width, height), page.place);
        let to_mm = |p: &P| {
            let at = frame.to_mm(PxPoint::new(p[0] as f32, p[1] as f32));
            [f64::from(at.x), f64::from(at.y)]
        };
        let paths = scene.outlines().iter().map(|o| (o.points.iter().map(to_mm).collect(), o.step)).collect();
        let to_px = move |at: MmPoint| {
            let px = frame.to_px(at);
            [f64::from(px.x), f64::from(px.y)]
        };
        let class = move |at: MmPoint| Some(scene.class(to_px(at)));
        let clearance = move |at: MmPoint| scene.clearance(to_px(at)) * f64::from(frame.mm_per_px());
        Self { place: page.place, paths, class: Box::new(class), clearance: Some(Box::new(clearance)) }
    }

    /// A page, whose figure is thought to lie at `place`: a picture that counts as a drawing at one resolution and as a
    /// photograph at another is laid out in two ways.
    pub(crate) fn of_page(page: &'a Outcome, place: MmRect) -> Self {
        let own = page.place;
        let (across, down) = (place.width() / own.width(), place.height() / own.height());
        let at = |p: MmPoint| {
            let (x, y) = (place.min.x + across * (p.x - own.min.x), place.min.y + down * (p.y - own.min.y));
            [f64::from(x), f64::from(y)]
        };
        let path = |line: &tactograph::internals::lines::Line| {
            let points = line.runs.iter().flat_map(|run| run.polyline().path().map(|p| at(*p)));
            (points.collect(), f64::from(line.strength))
        };
        let class = move |at: MmPoint| class_at(page.classes.as_ref()?, place, at);
        Self { place, paths: page.lines.iter().map(path).collect(), class: Box::new(class), clearance: None }
    }

    /// Places along the lines, every [`STEP`], each with the number of its line.
    fn walk(&self) -> Vec<(P, usize)> {
        let mut places = Vec::new();
        for (number, (points, _)) in self.paths.iter().enumerate() {
            let mut ahead = 0.0;
            for pair in points.windows(2) {
                let [dx, dy] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
                let length = dx.hypot(dy);
                while ahead < length {
                    let t = ahead / length;
                    places.push(([pair[0][0] + t * dx, pair[0][1] + t * dy], number));
                    ahead += STEP;
                }
                ahead -= length;
            }
        }
        places
    }

    /// Places a millimetre apart all over the figure, so far from its border.
    fn places(&self, inside: f32) -> impl Iterator<Item = MmPoint> {
        let place = self.place.inflate(-inside, -inside);
        let (columns, rows) = (place.width() as u32, place.height() as u32);
        let at =
            move |column: u32, row: u32| MmPoint::new(column as f32 + 0.5, row as f32 + 0.5) + place.min.to_vector();
        (0..rows).flat_map(move |row| (0..columns).map(move |column| at(column, row)))
    }

    fn judges(&self, p: P) -> bool {
        let (min, max) = (self.place.min, self.place.max);
        let inside = |v: f64, low: f32, high: f32| v > f64::from(low) + BORDER && v < f64::from(high) - BORDER;
        inside(p[0], min.x, max.x) && inside(p[1], min.y, max.y)
    }
}

fn class_at(classes: &Classes, place: MmRect, at: MmPoint) -> Option<Class> {
    let Size { width, height } = classes.size;
    let cell = |share: f32, cells: u32| ((share * cells as f32).max(0.0) as u32).min(cells - 1) as usize;
    let column = cell((at.x - place.min.x) / place.width(), width);
    let row = cell((at.y - place.min.y) / place.height(), height);
    let region = classes.region[row * width as usize + column]?;
    classes.regions.get(region as usize).map(|region| region.class)
}

/// Holds a page against the truth about it. Whether it is also felt is asked for, as it takes long.
pub(crate) fn compare(truth: &Sight<'_>, page: &Outcome, feel: bool) -> Result<Errors, String> {
    let seen = Sight::of_page(page, page.place);
    let (wanted, found) = (truth.walk(), seen.walk());
    let (to_found, pairs) = ways(&wanted, &found, truth);
    let (to_wanted, _) = ways(&found, &wanted, truth);
    let near = |all: &[f64]| all.iter().copied().filter(|d| *d <= GATE).collect::<Vec<f64>>();
    let lost = |all: &[f64]| all.iter().filter(|d| **d > GATE).count() as f64 / all.len() as f64;
    let mut errors = [near(&to_found), near(&to_wanted)].concat();
    errors.sort_by(f64::total_cmp);
    let rms = (errors.iter().map(|d| d * d).sum::<f64>() / errors.len() as f64).sqrt();
    let p95 = errors.get(errors.len() * 95 / 100).copied().unwrap_or(f64::NAN);
    let strengths = pairs.iter().map(|&(t, s)| (truth.paths[t].1, seen.paths[s].1)).collect::<Vec<_>>();
    Ok(Errors {
        rms,
        p95,
        missing: lost(&to_found),
        extra: lost(&to_wanted),
        strength: rank_correlation(&strengths),
        class: if page.classes.is_some() { other_class(truth, &seen) } else { f64::NAN },
        read: if feel { read(truth, &page.svg)? } else { f64::NAN },
    })
}

/// The distance of each judged place to the nearest of the others' lines, and which lines those are; infinite beyond the gate.
fn ways(from: &[(P, usize)], to: &[(P, usize)], truth: &Sight<'_>) -> (Vec<f64>, Vec<(usize, usize)>) {
    let size = [truth.place.max.x, truth.place.max.y].map(|mm| mm as usize + 10);
    let near = Near::new(to.iter().map(|(p, _)| *p).collect(), size, GATE + STEP);
    let mut pairs = Vec::new();
    let judged = from.iter().filter(|(p, _)| truth.judges(*p));
    let distances = judged.map(|&(p, number)| {
        let Some((nearest, distance)) = near.nearest(p) else { return f64::INFINITY };
        let beside = [nearest.wrapping_sub(1), nearest + 1].into_iter().filter_map(|i| to.get(i));
        let beside = beside.filter(|(q, line)| *line == to[nearest].1 && gap(*q, to[nearest].0) < 3.0 * STEP);
        let distance = beside.map(|(q, _)| to_segment(p, to[nearest].0, *q)).fold(distance, f64::min);
        if distance <= GATE {
            pairs.push((number, to[nearest].1));
        }
        distance
    });
    (distances.collect(), pairs)
}

fn gap(a: P, b: P) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn to_segment(p: P, a: P, b: P) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy).max(1e-12);
    let t = t.clamp(0.0, 1.0);
    gap(p, [a[0] + t * dx, a[1] + t * dy])
}

/// The share of places, every millimetre, whose class differs.
fn other_class(truth: &Sight<'_>, seen: &Sight<'_>) -> f64 {
    let is_judged = |at: &MmPoint| truth.clearance.as_ref().is_none_or(|clearance| clearance(*at) > BESIDE);
    share(truth.places(0.0).filter(is_judged), |at| (seen.class)(at) != (truth.class)(at))
}

/// The share of places that are felt as what they are; where that is not known, as what is meant.
fn read(truth: &Sight<'_>, svg: &str) -> Result<f64, String> {
    let ink = Ink::of(svg).map_err(|fault| fault.to_string())?;
    let felt = ink.felt(FINGER).map_err(|fault| fault.to_string())?;
    Ok(match &truth.clearance {
        Some(clearance) => share(truth.places(INSIDE as f32).filter(|at| clearance(*at) > INSIDE), |at| {
            felt.at(at).and_then(|place| place.felt) == (truth.class)(at)
        }),
        None => f64::from(report(&ink, &felt).total().right_of_judged()),
    })
}

fn share(places: impl Iterator<Item = MmPoint>, holds: impl Fn(MmPoint) -> bool) -> f64 {
    let (mut judged, mut held) = (0, 0);
    for at in places {
        judged += 1;
        held += u32::from(holds(at));
    }
    f64::from(held) / f64::from(judged)
}

/// Spearman's; equal values share their mean rank.
fn rank_correlation(pairs: &[(f64, f64)]) -> f64 {
    let ranks = |values: Vec<f64>| {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        let mut ranks = vec![0.0; values.len()];
        for equal in order.chunk_by(|&a, &b| values[a].total_cmp(&values[b]).is_eq()) {
            let first = order.partition_point(|&i| values[i] < values[equal[0]]);
            let rank = first as f64 + 0.5 * (equal.len() - 1) as f64;
            equal.iter().for_each(|&i| ranks[i] = rank);
        }
        ranks
    };
    let (a, b) = (ranks(pairs.iter().map(|p| p.0).collect()), ranks(pairs.iter().map(|p| p.1).collect()));
    let mean = 0.5 * (pairs.len() as f64 - 1.0);
    let sum = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| (x - mean) * (y - mean)).sum::<f64>();
    sum(&a, &b) / (sum(&a, &a) * sum(&b, &b)).sqrt()
}
