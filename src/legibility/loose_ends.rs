//! Ends of contours that lead to nothing. One of them says little: contours of photographs fade, and many are cut to
//! keep clear of others. Of leaves or grass there are so many scraps of contours that a finger meets one end after the
//! other and has nothing to follow.

use super::finding::FoundBreach;
use super::limits::{CELL, ROUNDING, RuleLimits};
use super::paths::{PathKind, Paths, nearest};
use super::rules::LOOSE_ENDS;
use crate::geom::nearby::Nearby;
use crate::page::{LeftOut, Page};
use crate::units::MmPoint;

/// Ends are counted in so many square mm.
const AREA: f32 = 1e4;
/// So many ends are too few to be told on any figure: a small one has few lines anyway.
const LEAST: usize = 12;
/// An end may lead to its own line if that comes back to it after so many times the blank to other lines.
const OWN: f32 = 4.0;

/// Ends of lines that lead to nothing, of which a figure has too many.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LooseEnds {
    /// How many there are.
    pub(crate) count: usize,
    /// How many there are in 100 square cm.
    each: f32,
}

impl LooseEnds {
    /// Those of a page, if it is of a photograph and has too many.
    pub(crate) fn of(page: &Page, limits: &RuleLimits) -> Option<Self> {
        // asked here too, as of a drawing nothing has to be made as wide as it is felt
        let felt = LeftOut::of(page).of_photograph.then(|| page.risen())?;
        let paths = Paths::whole(&felt.figure.lines);
        too_many(&felt, &paths, &paths.index(CELL), limits)
    }
}

/// The breach of a figure of a photograph with too many ends that lead to nothing.
pub(super) fn findings(page: &Page, paths: &Paths, index: &Nearby, limits: &RuleLimits) -> Option<FoundBreach> {
    let LooseEnds { count, each } = too_many(page, paths, index, limits)?;
    let most = limits.loose_ends();
    let what = format!(
        "{count} ends of lines lead to nothing, {each:.0} in each 100 square cm of the figure, so that a finger \
         meets one end after the other and can hardly follow what the picture shows; {most:.0} is the most"
    );
    Some(FoundBreach::of_page(LOOSE_ENDS, Some(each), what))
}

/// The loose ends of a figure of a photograph, if they are too many. In a drawing every line is meant.
fn too_many(page: &Page, paths: &Paths, index: &Nearby, limits: &RuleLimits) -> Option<LooseEnds> {
    if !LeftOut::of(page).of_photograph {
        return None;
    }
    let ends = Ends { paths, index, least: 0.5 * limits.missed_gap(), widest: paths.widest() };
    // what ends before the border of the figure goes on beyond it
    let inner = page.figure.place.inflate(-limits.missed_gap(), -limits.missed_gap());
    let count = ends.loose().filter(|at| inner.contains_inclusive(*at)).count();
    let each = AREA * count as f32 / page.figure.place.area().max(f32::MIN_POSITIVE);
    (count >= LEAST && each > limits.loose_ends()).then_some(LooseEnds { count, each })
}

/// The ends of the lines of a figure.
struct Ends<'a> {
    paths: &'a Paths,
    index: &'a Nearby,
    /// An end with less blank before it than this, mm, leads to what is there.
    least: f32,
    /// Half the width of the widest line, mm.
    widest: f32,
}

impl Ends<'_> {
    /// Where those are that lead to nothing. The second row of a heavy line of dots ends where it does because of the
    /// first.
    fn loose(&self) -> impl Iterator<Item = MmPoint> + '_ {
        let has_ends = move |path: &usize| {
            let path = &self.paths.paths[*path];
            path.kind != PathKind::BesideRow && !path.is_ring_of_dots
        };
        let tips = move |path: usize| self.paths.tips(path).into_iter().map(move |tip| (path, tip));
        let all = (0..self.paths.paths.len()).filter(has_ends).flat_map(tips);
        all.filter(move |(path, (tip, at, arc))| !self.leads_on(*path, *at, *arc, tip.half_width))
            .map(|(_, (_, at, _))| at)
    }

    /// Whether there is a line at an end of a path, given with its place along that and half its width.
    fn leads_on(&self, path: usize, at: MmPoint, arc: f32, half_width: f32) -> bool {
        let mut is_met = false;
        self.index.around(at, at, self.least + half_width + self.widest, |segment| {
            let (distance, _, along) = nearest(segment, at);
            let blank = distance - half_width - segment.half_width;
            let is_other = segment.line as usize != path || (along - arc).abs() > OWN * self.least;
            is_met |= is_other && blank < self.least - ROUNDING;
        });
        is_met
    }
}

#[cfg(test)]
mod tests;
