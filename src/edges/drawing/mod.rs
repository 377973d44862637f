//! Contours of a vector drawing: its own geometry proposes them, its picture confirms them.
//!
//! ```text
//! VectorDrawing -> painted_signs (small paths that mark places; rings in the end)
//!               -> flatten (outlines of fills, centre lines of strokes)
//!               -> confirm (the stretches where the picture shows a step or a stroke at that very place)
//!               -> unite (of paths that coincide, one) -> Edges
//! ```
//!
//! What is hidden, clipped or of the colour of its ground is not seen in the picture, so it needs no geometry of its
//! own. Contours in places without paths (photographs, gradients, blurs) come from the pixels, as in any picture.

mod confirm;
mod flatten;
mod painted_signs;
mod proposal;
mod unite;

use super::edgel::{ChainKind, Edgel, Edges};
use super::params::Params;
use super::signs::Signs;
use crate::raster::Raster;
use crate::raster::vector::VectorDrawing;
use confirm::Lab;
use proposal::Confirmed;

/// An edge found in the pixels that is this near to a contour of the drawing, px, is that contour.
const EXPLAINED: f32 = 4.0;

/// Finds the contours of a drawing and of its rendering, `raster`.
pub fn find_in_vector(raster: &Raster, drawing: &VectorDrawing, params: &Params) -> Edges {
    let are_signs = vec![false; drawing.paths.len()];
    contours(raster, drawing, (&Signs::default(), &are_signs), &Lab::of(raster), params)
}

/// The same with its signs that mark places as rings.
pub fn find_in_vector_with_signs(raster: &Raster, drawing: &VectorDrawing, params: &Params, px_per_mm: f32) -> Edges {
    let picture = Lab::of(raster);
    let found = painted_signs::find(&drawing.paths, &picture, params, px_per_mm, raster.size());
    let (signs, are_signs) = found.unwrap_or_else(|| (Signs::default(), vec![false; drawing.paths.len()]));
    contours(raster, drawing, (&signs, &are_signs), &picture, params)
}

/// The contours of a drawing, those of its paths that are signs as rings.
fn contours(
    raster: &Raster,
    drawing: &VectorDrawing,
    (signs, are_signs): (&Signs, &[bool]),
    picture: &Lab,
    params: &Params,
) -> Edges {
    let size = raster.size();
    let others = drawing.paths.iter().zip(are_signs).filter(|(_, is_sign)| !**is_sign).map(|(path, _)| path);
    let proposals = flatten::proposals(others, params.widest_stroke, size);
    let (mut confirmed, mut edges): (Vec<Vec<Confirmed>>, Edges) = (Vec::new(), Edges::none(size));
    for proposal in &proposals {
        let of_proposal = confirm::confirmed(proposal, picture, params);
        edges.dashed += usize::from(proposal.dashed && !of_proposal.is_empty());
        confirmed.push(of_proposal);
    }
    let (contours, overlaid) = unite::merged_coincident(confirmed, size);
    edges.overlaid = overlaid;
    for Confirmed { line, stroke, faint, .. } in contours {
        edges.push_as(
            ChainKind { exact: true, of_drawing: true, stroke, faint, ..ChainKind::default() },
            line.vertices.into_iter(),
            line.closed,
        );
    }
    signs.add_to(&mut edges);
    if drawing.pixel_areas.iter().any(|area| area.is_seen(size)) {
        add_from_pixels(raster, drawing, params, &mut edges);
    }
    edges
}

/// Adds what edges the pixels have in the areas without paths, less what lies on a contour of the drawing.
fn add_from_pixels(raster: &Raster, drawing: &VectorDrawing, params: &Params, edges: &mut Edges) {
    let explained = unite::Covered::of(edges, EXPLAINED);
    let found = super::find(raster, params);
    for chain in found.chains() {
        let is_new = |edgel: &Edgel| {
            drawing.pixel_areas.iter().any(|area| area.contains(edgel.at)) && !explained.is_near(edgel.at)
        };
        let new: Vec<bool> = chain.vertices.iter().map(is_new).collect();
        if new.iter().all(|new| *new) {
            edges.push(chain.vertices.iter().copied(), chain.closed);
            continue;
        }
        for run in chain.vertices.chunk_by(|a, b| is_new(a) == is_new(b)).filter(|run| is_new(&run[0])) {
            let length: f32 = run.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
            if length >= params.min_length {
                edges.push(run.iter().copied(), false);
            }
        }
    }
}

#[cfg(test)]
mod tests;
