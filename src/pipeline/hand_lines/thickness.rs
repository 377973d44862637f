//! How thick the strokes in a picture of lines are says how strong its lines are.

use super::line::graded;
use crate::edges::{ChainKind, Edges};
use crate::profile::Plan;

/// A stroke of this share of the thickest is as strong: as thick as one pen draws, and as exactly as pixels show it.
const OF_ONE_PEN: f32 = 0.8;
/// The thickest strokes are this share of all lines by length: a blot is none of them.
const THICKEST: f32 = 0.05;

/// Makes lines weaker the thinner their strokes are beside the thickest, so that they are thinner on the page in
/// proportion. What is too broad for one line, of which two sides were found, counts as broad as `widest`, px.
pub(in crate::pipeline) fn weaken_thin_strokes(edges: &mut Edges, widest: f32, plan: &Plan) {
    let width = |kind: &ChainKind| kind.stroke.unwrap_or(widest);
    let mut widths: Vec<(f32, f32)> =
        edges.chains.iter().map(|range| (width(&range.kind), edges.chain(range).length())).collect();
    widths.sort_by(|a, b| b.0.total_cmp(&a.0));
    let whole: f32 = widths.iter().map(|(_, length)| length).sum();
    let mut sum = 0.0;
    let thickest = widths.iter().find(|(_, length)| {
        sum += length;
        sum >= THICKEST * whole
    });
    let Some(&(thickest, _)) = thickest else { return };
    for range in &edges.chains {
        let share = width(&range.kind) / (OF_ONE_PEN * thickest);
        let Some(most) = graded(share * plan.lines().width_max, plan) else { continue };
        edges.edgels[range.edgels.clone()].iter_mut().for_each(|edgel| edgel.strength = edgel.strength.min(most));
    }
}

#[cfg(test)]
mod tests;
