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
use super::whole::Ground;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// All lines of a drawing are thinner only if that keeps at least this share more: thin lines are
/// harder to feel.
const THINNER_KEEPS: f32 = 0.03;

/// A drawing of which less than this share has room is far too dense, as squared paper in an overview.
const HOPELESS: f32 = 0.5;

/// A shorter gap, mm, is none in a drawing: less than the lines of an overview need between them.
const GAP: f32 = 2.0;
/// The outline of the whole goes first only if that closes this share of what lines enclose: a small field of a map.
/// Chosen by us. Of 30 drawings of worksheets twelve had as much open; most of these have loops of arrows.
const FIELD: f32 = 0.05;
/// It may cost no more than this share of the lines: a lake or two, and not all that a shape is drawn for.
const COSTS: f32 = 0.15;

/// Clears lines (see [`clear`]). Those of a drawing may move apart, be centrelines of narrow bars, or be thinner,
/// whichever keeps most of them; in an overview that is open without, the outline of the whole goes first. Also returns
/// what was to be drawn and how it is drawn then. Where nothing has to be left out this costs nothing more, else up to
/// seven times as much.
pub(super) fn cleared(
    candidates: impl Fn(&Params) -> LineCandidates + Sync,
    area: MmRect,
    params: Params,
) -> (Arc<LineCandidates>, Vec<Cleared>, Params) {
    let wide = Params { widen_bars: params.of_drawing, ..params };
    let of_wide = Arc::new(candidates(&wide));
    let first = Attempt::of(&of_wide, area, wide);
    if !params.of_drawing || first.lost() < GAP {
        return first.taken();
    }
    // the most that could be drawn: bars with both sides
    let most = wanted(&of_wide);
    let best = if first.lost() < params.min_length { first } else { best_way(first, most, candidates, area) };
    closed(best, most, area).taken()
}

/// The way to draw a drawing that keeps most of its lines, of which all as they are is the first.
fn best_way(first: Attempt, most: f32, candidates: impl Fn(&Params) -> LineCandidates + Sync, area: MmRect) -> Attempt {
    let (of_wide, wide) = (first.candidates.clone(), first.params);
    let mut best = first;
    let merged = Params { widen_bars: false, ..wide };
    let of_merged = Arc::new(candidates(&merged));
    if best.drawn() < HOPELESS * best.wanted() {
        return Attempt::of(&of_merged, area, merged);
    }
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
    best
}

/// The same attempt, or in an overview on paper of which much is open, one in which the outline of the whole goes
/// first: if it closes more than it costs of the lines.
fn closed(attempt: Attempt, most: f32, area: MmRect) -> Attempt {
    let (candidates, params) = (attempt.candidates.clone(), attempt.params);
    let may_be_closed = params.in_overview_of_drawing() && !params.on_dots();
    if !may_be_closed || attempt.lost() < GAP || attempt.drawn() < HOPELESS * attempt.wanted() {
        return attempt;
    }
    let ground = Ground::of(strong(&candidates).map(|((line, _), _)| line), area);
    let opened = |attempt: &Attempt| ground.opened(&Ground::of(attempt.strong().map(|line| &line.polyline), area));
    let open = opened(&attempt);
    let outline_first = if open < FIELD { None } else { ground.outline_first(&candidates.lines, &params) };
    let Some(lines) = outline_first else { return attempt };
    let (moved_apart, as_they_are) = rayon::join(
        || Attempt::moved_apart_of(&candidates, &lines, area, params),
        || Attempt::of_lines(&candidates, lines.clone(), area, params),
    );
    let (kept_open, most_open) = (attempt.kept(most), open - FIELD);
    let mut worth = kept_open - open;
    let mut best = attempt;
    for this in [as_they_are, moved_apart] {
        let (kept, open) = (this.kept(most), opened(&this));
        if open <= most_open && kept >= kept_open - COSTS && kept - open > worth {
            (worth, best) = (kept - open, this);
        }
    }
    best
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
        Self::of_lines(candidates, candidates.lines.clone(), area, params)
    }

    /// The same of these lines, which are the candidates with ranks of their own.
    fn of_lines(
        candidates: &Arc<LineCandidates>,
        lines: Vec<(Polyline<Vertex>, Rank)>,
        area: MmRect,
        params: Params,
    ) -> Self {
        let cleared = clear(lines, &candidates.saliencies, area, &params);
        Self { candidates: candidates.clone(), cleared, params }
    }

    /// Of lines that are moved apart beforehand.
    fn moved_apart(candidates: &Arc<LineCandidates>, area: MmRect, params: Params) -> Self {
        Self::moved_apart_of(candidates, &candidates.lines, area, params)
    }

    /// The same of these lines, which are the candidates with ranks of their own.
    fn moved_apart_of(
        candidates: &Arc<LineCandidates>,
        lines: &[(Polyline<Vertex>, Rank)],
        area: MmRect,
        params: Params,
    ) -> Self {
        let (apart, saliencies) = apart(lines, area, &params);
        let cleared = clear(apart, &saliencies, area, &params);
        Self { candidates: candidates.clone(), cleared, params }
    }

    fn taken(self) -> (Arc<LineCandidates>, Vec<Cleared>, Params) {
        (self.candidates, self.cleared, self.params)
    }

    /// Length of what is not drawn, mm; but for faint lines, which are to give way.
    fn lost(&self) -> f32 {
        let wanted: f32 = strong(&self.candidates).map(|((line, _), _)| line.length()).sum();
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
    strong(candidates).map(|(_, saliency)| saliency).sum::<f32>() + candidates.short.length()
}

/// What is wanted but for faint lines, each with its saliency.
fn strong(candidates: &LineCandidates) -> impl Iterator<Item = (&(Polyline<Vertex>, Rank), &f32)> {
    candidates.lines.iter().zip(&candidates.saliencies).filter(|((_, rank), _)| *rank != Rank::Faint)
}

/// The lines of a drawing, moved apart, and their saliencies.
fn apart(
    lines: &[(Polyline<Vertex>, Rank)],
    area: MmRect,
    params: &Params,
) -> (Vec<(Polyline<Vertex>, Rank)>, Vec<f32>) {
    // faint lines, such as an even grid, stay where they are
    let (mut faint, strong): (Vec<_>, Vec<_>) = lines.iter().cloned().partition(|(_, rank)| *rank == Rank::Faint);
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
