//! A vector drawing that is too dense for its size: every line of it is meant, so before lines are left out, all move
//! apart a little, and then are drawn thinner.

use super::candidates::Candidates;
use super::clearance::{Cleared, clear, spread};
use super::junction;
use super::outlines::Rank;
use super::params::Params;
use super::saliency::saliencies;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// All lines of a drawing are thinner only if that keeps at least this share of their saliency more: thin lines are
/// harder to feel.
const THINNER_KEEPS: f32 = 0.03;

/// A drawing of which less than this share has room is far too dense, as squared paper in an overview.
const HOPELESS: f32 = 0.5;

/// Clears lines (see [`clear`]). Those of a vector drawing may move apart, be centrelines of narrow bars, or be
/// thinner, whichever keeps most of them; also returns how they are drawn then. Where nothing has to be left out this
/// costs nothing more, else up to five times as much.
pub(super) fn cleared(
    candidates: impl Fn(&Params) -> Candidates,
    area: MmRect,
    params: Params,
) -> (Candidates, Vec<Cleared>, Params) {
    let params = Params { widen_bars: params.exact, ..params };
    let attempt = |params: Params, moves_apart: bool| {
        let lines = candidates(&params);
        let cleared = match moves_apart {
            true => {
                let (apart, saliencies) = apart(&lines, area, &params);
                clear(apart, &saliencies, area, &params)
            }
            false => clear(lines.lines.clone(), &lines.saliencies, area, &params),
        };
        (lines, cleared, params)
    };
    let centrelines = Params { widen_bars: false, ..params };
    let mut best = attempt(params, false);
    if !params.exact || lost(&best.0, &best.1) < params.min_length {
        return best;
    }
    let mut share = drawn_share(&best.0, &best.1);
    if share < HOPELESS {
        return attempt(centrelines, false);
    }
    for (params, moves_apart, gain) in
        [(params, true, 0.0), (centrelines, false, 0.0), (centrelines, true, 0.0), (params.thin(), true, THINNER_KEEPS)]
    {
        let this = attempt(params, moves_apart);
        let drawn = drawn_share(&this.0, &this.1);
        if drawn > share + gain {
            (share, best) = (drawn, this);
        }
    }
    best
}

/// The lines of a drawing, moved apart, and their saliencies.
fn apart(lines: &Candidates, area: MmRect, params: &Params) -> (Vec<(Polyline<Vertex>, Rank)>, Vec<f32>) {
    let (mut polylines, ranks): (Vec<_>, Vec<_>) = lines.lines.iter().cloned().unzip();
    if let Some(apart) = spread(&polylines, area, params) {
        polylines = apart;
        // an end may have come off the line on which it lay
        junction::extend(&mut polylines, area, params.join_gap);
    }
    let saliencies = saliencies(&polylines, params);
    (polylines.into_iter().zip(ranks).collect(), saliencies)
}

/// Length of what is not drawn, mm.
fn lost(lines: &Candidates, cleared: &[Cleared]) -> f32 {
    let wanted: f32 = lines.lines.iter().map(|(line, _)| line.length()).sum();
    wanted - cleared.iter().map(|line| line.polyline.length()).sum::<f32>()
}

/// Share of what is wanted, by saliency, that is drawn: a ring in parts or a line that wavers counts for less. What is
/// too short for a line, as a small box that became its centreline, is wanted too.
fn drawn_share(lines: &Candidates, cleared: &[Cleared]) -> f32 {
    let wanted = lines.saliencies.iter().sum::<f32>() + lines.short.length();
    cleared.iter().map(|line| line.saliency).sum::<f32>() / wanted.max(f32::EPSILON)
}
