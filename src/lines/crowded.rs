//! A drawing that is too dense for its size: every line of it is meant, so before lines are left out, all move
//! apart a little, and then are drawn thinner.

use std::sync::Arc;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::candidates::LineCandidates;
use super::clearance::{Cleared, clear, move_apart};
use super::lead_on;
use super::outlines::Rank;
use super::params::Params;
use super::saliency::saliency;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// All lines of a drawing are thinner only if that keeps at least this share more: thin lines are
/// harder to feel.
const THINNER_KEEPS: f32 = 0.03;

/// A drawing of which less than this share has room is far too dense, as squared paper in an overview.
const HOPELESS: f32 = 0.5;

/// Clears lines (see [`clear`]). Those of a drawing may move apart, be centrelines of narrow bars, or be thinner,
/// whichever keeps most of them; also returns what was to be drawn and how it is drawn then. Where nothing has to be
/// left out this costs nothing more, else up to five times as much.
pub(super) fn cleared(
    candidates: impl Fn(&Params) -> LineCandidates + Sync,
    area: MmRect,
    params: Params,
) -> (Arc<LineCandidates>, Vec<Cleared>, Params) {
    let wide = Params { widen_bars: params.of_drawing, ..params };
    let merged = Params { widen_bars: false, ..params };
    let of_wide = Arc::new(candidates(&wide));
    let mut best = Attempt::of(&of_wide, area, wide);
    if !params.of_drawing || best.lost() < params.min_length {
        return best.taken();
    }
    let of_merged = Arc::new(candidates(&merged));
    if best.drawn() < HOPELESS * best.wanted() {
        return Attempt::of(&of_merged, area, merged).taken();
    }
    // the most that could be drawn: bars with both sides
    let most = wanted(&of_wide);
    let thin = wide.thin();
    let of_thin = || Arc::new(candidates(&thin));
    let tries: [&(dyn Fn() -> Attempt + Sync); 4] = [
        &|| Attempt::moved_apart(&of_wide, area, wide),
        &|| Attempt::of(&of_merged, area, merged),
        &|| Attempt::moved_apart(&of_merged, area, merged),
        &|| Attempt::moved_apart(&of_thin(), area, thin),
    ];
    let attempts: Vec<Attempt> = tries.into_par_iter().map(|attempt| attempt()).collect();
    let mut kept = best.kept(most);
    for this in attempts {
        let gain = if this.params.width_max < wide.width_max { THINNER_KEEPS } else { 0.0 };
        if this.kept(most) > kept + gain {
            (kept, best) = (this.kept(most), this);
        }
    }
    best.taken()
}

/// Lines cleared with one set of parameters.
struct Attempt {
    candidates: Arc<LineCandidates>,
    cleared: Vec<Cleared>,
    params: Params,
}

impl Attempt {
    /// Of lines where they are.
    fn of(candidates: &Arc<LineCandidates>, area: MmRect, params: Params) -> Self {
        let cleared = clear(candidates.lines.clone(), &candidates.saliencies, area, &params);
        Self { candidates: candidates.clone(), cleared, params }
    }

    /// Of lines that are moved apart beforehand.
    fn moved_apart(candidates: &Arc<LineCandidates>, area: MmRect, params: Params) -> Self {
        let (apart, saliencies) = apart(candidates, area, &params);
        let cleared = clear(apart, &saliencies, area, &params);
        Self { candidates: candidates.clone(), cleared, params }
    }

    fn taken(self) -> (Arc<LineCandidates>, Vec<Cleared>, Params) {
        (self.candidates, self.cleared, self.params)
    }

    /// Length of what is not drawn, mm; but for faint lines, which are to give way.
    fn lost(&self) -> f32 {
        let lines = self.candidates.lines.iter().filter(|(_, rank)| *rank != Rank::Faint);
        let wanted: f32 = lines.map(|(line, _)| line.length()).sum();
        wanted - self.strong().map(|line| line.polyline.length()).sum::<f32>()
    }

    /// What is drawn but for faint lines.
    fn strong(&self) -> impl Iterator<Item = &Cleared> {
        self.cleared.iter().filter(|line| line.rank != Rank::Faint)
    }

    /// Saliency of what is drawn: a ring in parts or a line that wavers counts for less.
    fn drawn(&self) -> f32 {
        self.strong().map(|line| line.saliency).sum()
    }

    fn wanted(&self) -> f32 {
        wanted(&self.candidates)
    }

    /// How much of a drawing whose bars all have two sides, which together are worth `most`, is kept, 0..=1. It is the
    /// geometric mean of two shares: of what this attempt itself wants, which falls where lines are torn; and of
    /// `most`, which falls where centrelines stand for two sides.
    fn kept(&self, most: f32) -> f32 {
        let wanted = self.wanted();
        self.drawn() / (wanted * most.max(wanted)).sqrt().max(f32::EPSILON)
    }
}

/// Saliency of what is wanted. What is too short for a line, as a small box that became its centreline, is wanted too.
fn wanted(candidates: &LineCandidates) -> f32 {
    let strong = candidates.lines.iter().zip(&candidates.saliencies).filter(|((_, rank), _)| *rank != Rank::Faint);
    strong.map(|(_, saliency)| saliency).sum::<f32>() + candidates.short.length()
}

/// The lines of a drawing, moved apart, and their saliencies.
fn apart(lines: &LineCandidates, area: MmRect, params: &Params) -> (Vec<(Polyline<Vertex>, Rank)>, Vec<f32>) {
    // faint lines, such as an even grid, stay where they are
    let (mut faint, strong): (Vec<_>, Vec<_>) = lines.lines.iter().cloned().partition(|(_, rank)| *rank == Rank::Faint);
    let (mut polylines, ranks): (Vec<_>, Vec<_>) = strong.into_iter().unzip();
    if let Some(apart) = move_apart(&polylines, area, params) {
        polylines = apart;
        // an end may have come off the line on which it lay
        lead_on::extend(&mut polylines, area, params.bridged_gap());
    }
    let mut all: Vec<(Polyline<Vertex>, Rank)> = polylines.into_iter().zip(ranks).collect();
    all.append(&mut faint);
    let saliencies = all.iter().map(|(line, _)| saliency(line, params)).collect();
    (all, saliencies)
}
