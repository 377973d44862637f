//! Whether the overview shows what the figure shows, and nothing else; and what the figure lacks of its picture.

use std::collections::HashSet;

use super::finding::{FoundBreach, around};
use super::limits::{CELL, RuleLimits, SHAPE};
use super::marks::name_in;
use super::paths::{Paths, point_at};
use super::rules::{LEFT_OUT, OVERVIEW, OVERVIEW_LACKS};
use crate::Note;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::{ALONG, ninths};
use crate::listing::first_few;
use crate::page::{InSet, LeftOut, Names, Overview, Page, which_are_weak};
use crate::units::{MmPoint, MmRect, MmVector};

/// Lines are looked at this often, mm of the overview.
const STEP: f32 = 0.5;
/// A line whose larger part is missing in the other picture is missing there.
const MISSING: f32 = 0.5;
/// A shape that a person drew may lie where another was, which the overview still shows. So it is missing there from
/// this share on: a circle in place of a square of its width lies apart from it for half of its length.
const MISSING_BY_HAND: f32 = 0.25;
/// And only what is no farther off than this share of the clearance of lines is like it: half of it is what drawing
/// by eye and simplifying may move a line by. Both are chosen by us.
const NEAR_BY_HAND: f32 = 0.5;

/// A figure and its overview, as places of the one in the other.
#[derive(Clone, Copy)]
struct Pair {
    figure: MmPoint,
    overview: MmPoint,
    /// Millimetres of the figure for one of the overview.
    scale: f32,
}

impl Pair {
    fn of(page: &Page, overview: &Overview) -> Self {
        let (figure, place) = (page.figure.place, overview.place);
        let scale = figure.width() / place.width().max(f32::MIN_POSITIVE);
        Self { figure: figure.min, overview: place.min, scale }
    }

    fn in_figure(self, at: MmPoint) -> MmPoint {
        self.figure + (at - self.overview) * self.scale
    }

    fn in_overview(self, at: MmPoint) -> MmPoint {
        self.overview + (at - self.figure) / self.scale
    }
}

/// `paths` are those of the figure, `index` their segments.
pub(super) fn findings(
    page: &Page,
    names: &Names,
    paths: &Paths,
    index: &Nearby,
    limits: &RuleLimits,
) -> Vec<FoundBreach> {
    // one on a sheet of its own has its figure on another
    let is_alone = page.figure.lines.is_empty() && InSet::of(page).is_some();
    let Some(overview) = page.overview.as_ref().filter(|_| !is_alone) else { return Vec::new() };
    let pair = Pair::of(page, overview);
    let of_overview = Paths::whole(&overview.lines);
    let mut found = added(overview, (&of_overview, &names.overview_lines), (index, pair), limits);
    found.extend(lacking(page, (paths, names), (&of_overview, pair), limits));
    found
}

/// Lines of the overview that the figure has not.
fn added(
    overview: &Overview,
    (paths, names): (&Paths, &[String]),
    (index, pair): (&Nearby, Pair),
    limits: &RuleLimits,
) -> Vec<FoundBreach> {
    let of_line = |number: usize| {
        let own = (0..paths.paths.len()).filter(|&path| paths.paths[path].line == number);
        let segments = own.flat_map(|path| paths.segments_of(path));
        let like = Like { index, reach: pair.scale * limits.spacing(), missing: MISSING };
        let Missing { length, places } = missing(segments, STEP, |at| pair.in_figure(at), like)?;
        let at = places.get(places.len() / 2).copied()?;
        let extent = around(places.iter().copied()).unwrap_or_else(MmRect::zero);
        let name = name_in(names, number);
        let what = format!("the figure has nothing like {name}, {length:.0} mm of it");
        Some(FoundBreach::at(OVERVIEW, at, extent, length, what).unmeasured().of(name))
    };
    (0..overview.lines.len()).filter_map(of_line).collect()
}

/// Closed lines of the figure that are large enough for the overview and not in it.
fn lacking(
    page: &Page,
    (paths, names): (&Paths, &Names),
    (of_overview, pair): (&Paths, Pair),
    limits: &RuleLimits,
) -> Vec<FoundBreach> {
    let index = of_overview.index(CELL);
    // those of a grid would hide its shapes
    let weak = which_are_weak(&page.figure.lines, limits.least_strength);
    let of_path = |path: usize| {
        let of = paths.paths.get(path).filter(|of| of.closed && !weak[of.line])?;
        let segments = paths.segments_of(path);
        let extent = around(segments.iter().map(|segment| segment.a))?;
        let side = extent.width().min(extent.height()) / pair.scale;
        if side < SHAPE {
            return None;
        }
        let name = name_in(&names.lines, of.line);
        let (reach, missing_from) = match names.by_hand.contains(name) {
            true => (NEAR_BY_HAND * limits.spacing(), MISSING_BY_HAND),
            false => (limits.spacing(), MISSING),
        };
        let like = Like { index: &index, reach, missing: missing_from };
        missing(segments.iter(), pair.scale * STEP, |at| pair.in_overview(at), like)?;
        let what = format!(
            "the overview has nothing like {name} of the figure, which is closed, {:.0} mm wide and {:.0} mm high",
            extent.width(),
            extent.height()
        );
        Some(FoundBreach::at(OVERVIEW_LACKS, segments.first()?.a, extent, side, what).of(name))
    };
    (0..paths.paths.len()).filter_map(of_path).collect()
}

/// An overview of a drawing that lacks this share of its lines is told, as it is where the page is made.
const LACKS: f32 = 0.15;
/// So many of them are named.
const MOST_NAMED: usize = 3;

/// That the overview lacks much of what the figure of a drawing shows: open lines and shapes too small to be told one
/// by one.
pub(super) fn lacks_much(page: &Page, names: &Names, paths: &Paths, limits: &RuleLimits) -> Option<FoundBreach> {
    let overview = page.overview.as_ref().filter(|overview| !overview.lines.is_empty())?;
    if LeftOut::of(page).of_photograph {
        return None;
    }
    let pair = Pair::of(page, overview);
    let of_overview = Paths::whole(&overview.lines);
    let index = of_overview.index(CELL);
    let weak = which_are_weak(&page.figure.lines, limits.least_strength);
    let counts = |path: &&usize| !weak[paths.paths[**path].line];
    let all: Vec<usize> = (0..paths.paths.len()).collect();
    let whole: f32 = all.iter().filter(counts).map(|&path| paths.paths[path].length).sum();
    let gone = |&path: &usize| {
        let like = Like { index: &index, reach: limits.spacing(), missing: MISSING };
        let segments = paths.segments_of(path);
        let missing = missing(segments.iter(), pair.scale * STEP, |at| pair.in_overview(at), like)?;
        Some((missing.length, path, *missing.places.first()?))
    };
    let mut gone: Vec<(f32, usize, MmPoint)> = all.iter().filter(counts).filter_map(gone).collect();
    gone.sort_by(|a, b| b.0.total_cmp(&a.0));
    let share = gone.iter().map(|(length, ..)| length).sum::<f32>() / whole.max(f32::MIN_POSITIVE);
    let &(_, longest, at) = gone.first().filter(|_| share >= LACKS)?;
    let mut lacking: Vec<&str> =
        gone.iter().map(|(_, path, _)| name_in(&names.lines, paths.paths[*path].line)).collect();
    let mut known = HashSet::new();
    lacking.retain(|name| known.insert(*name));
    let extent = around(paths.segments_of(longest).iter().map(|segment| segment.a))?;
    let what = format!(
        "the overview lacks {:.0} % of the lines of the figure: {}",
        100.0 * share,
        first_few(&lacking, MOST_NAMED, |name| (*name).to_owned())
    );
    Some(FoundBreach::at(OVERVIEW_LACKS, at, extent, share, what).unmeasured())
}

/// What is like a line in another picture.
struct Like<'a> {
    index: &'a Nearby,
    /// How far from its place, mm of that picture.
    reach: f32,
    /// From which share on the line is missing there.
    missing: f32,
}

/// What of a line is missing in another picture.
struct Missing {
    length: f32,
    places: Vec<MmPoint>,
}

/// The part of these segments that has nothing like it, of its direction, in the other picture, if it is so large that
/// they are missing; `there` leads into that picture.
fn missing<'a>(
    segments: impl Iterator<Item = &'a Segment>,
    step: f32,
    there: impl Fn(MmPoint) -> MmPoint,
    Like { index, reach, missing }: Like<'_>,
) -> Option<Missing> {
    let (mut lost, mut all, mut places) = (0.0, 0.0, Vec::new());
    for segment in segments {
        let length = (segment.b - segment.a).length();
        let steps = (length / step).ceil().max(1.0);
        let way = (segment.b - segment.a).try_normalize().unwrap_or_default();
        let is_along = |other: &Segment| {
            let own = (other.b - other.a).try_normalize().unwrap_or_default();
            way.dot(own).abs() >= ALONG || way.length() * own.length() == 0.0
        };
        for k in 0..steps as u32 {
            let at = point_at(segment, segment.arc + (k as f32 + 0.5) / steps * length);
            all += length / steps;
            if index.nearest(there(at), reach, is_along).is_none() {
                lost += length / steps;
                places.push(at);
            }
        }
    }
    (lost > missing * all).then_some(Missing { length: lost, places })
}

/// Less than this share of the contours, or than this length in mm, is what joins and corners cost.
const LEFT_OUT_SHARE: f32 = 0.05;
const LEFT_OUT_LENGTH: u32 = 20;

/// Contours of the picture that are not on the page, as whoever made the page wrote into it.
pub(super) fn left_out(page: &Page) -> Option<FoundBreach> {
    let left = LeftOut::of(page);
    let least = if left.of_photograph { LeftOut::CROWDED } else { LEFT_OUT_SHARE };
    if left.share() < least || left.millimetres < LEFT_OUT_LENGTH {
        return None;
    }
    let percent = 100.0 * left.share();
    let what = format!("{} mm of contours of the picture, {percent:.0} %, are not on the page", left.millimetres);
    let Some(ninth) = left.most_in() else { return Some(FoundBreach::of_page(LEFT_OUT, Some(percent), what)) };
    let place = page.figure.place;
    let size = MmVector::new(place.width() / 3.0, place.height() / 3.0);
    let corner = place.min + MmVector::new((ninth % 3) as f32 * size.x, (ninth / 3) as f32 * size.y);
    let extent = MmRect::new(corner, corner + size);
    let at = MmPoint::new(0.5 * (extent.min.x + extent.max.x), 0.5 * (extent.min.y + extent.max.y));
    let what = format!("{what}, most of them in the {}", ninths::NAMES[ninth]);
    Some(FoundBreach::at(LEFT_OUT, at, extent, percent, what))
}

/// What whoever checks a page of a photograph is told of these, where they are no breach.
pub fn told_left_out(page: &Page) -> Option<Note> {
    let left = LeftOut::of(page);
    let is_told = left.of_photograph && (LeftOut::TOLD..LeftOut::CROWDED).contains(&left.share());
    let (millimetres, percent) = (left.millimetres, (100.0 * left.share()).round() as u32);
    let place = left.most_in().map(|ninth| ninths::NAMES[ninth]);
    is_told.then_some(Note::LinesLeftOut { millimetres, percent, place, is_larger_turned: false })
}
