//! The main thing of a picture: what stands out in its middle and does not touch its edges.

use super::choose::{saliency, survives_opening};
use super::merge::Node;
use super::tree::Tree;

/// A region counts less by the factor e at this distance of its centre from that of the picture, in shares of its
/// sides. In 284 photographs of BSDS500 (train and val) two people or more outlined the same thing away from the edge.
/// By these numbers it is the region that is chosen (more than half of both in common) in 37 percent of each; the
/// most salient region, wherever it lies, is that thing in 19. At .2 and .3 it is about the same. The numbers were
/// chosen with both sets in view.
const MIDDLE: f64 = 0.25;
/// Exponents of the area and of how clear the outline is, beside what they count for all regions. Where clear outlines
/// count less, the sky between a rocket and its tower would be the thing, with a border along which nothing is seen.
const LARGE: f64 = 0.7;
const CLEAR: i32 = 2;
/// Most of an outline that lies on the edge of the picture: a thing that is cut off there is seldom the main one.
const ON_PICTURE_EDGE: f64 = 0.1;

/// The number of the region that is the main thing, if one of those that have at least a share of the saliency of
/// the most salient one can be it. `mm_per_cell` is the side of a cell on the sheet.
pub(super) fn main_thing(tree: &Tree, mm_per_cell: f32, least_share: f32) -> Option<u32> {
    let cells = tree.basin.len();
    let saliencies: Vec<f64> = tree.nodes.iter().map(|node| saliency(node, cells, mm_per_cell)).collect();
    let least = f64::from(least_share) * saliencies.iter().copied().fold(0.0, f64::max);
    let stands_out = |((node, saliency), centre): ((&Node, &f64), [f64; 2])| {
        let from_middle = centre.iter().map(|at| (at - 0.5).powi(2)).sum::<f64>();
        let may_be = *saliency > 0.0 && *saliency >= least && node.on_picture_edge() <= ON_PICTURE_EDGE;
        may_be.then(|| {
            saliency
                * node.outline.clearness().powi(CLEAR)
                * node.area.powf(LARGE)
                * (-from_middle / (MIDDLE * MIDDLE)).exp()
        })
    };
    let all = tree.nodes.iter().zip(&saliencies).zip(centres(tree)).map(stands_out);
    let mut ranked: Vec<(u32, f64)> = (0..).zip(all).filter_map(|(node, by)| Some((node, by?))).collect();
    ranked.sort_by(|a, b| b.1.total_cmp(&a.1));
    ranked.into_iter().map(|(node, _)| node).find(|&node| survives_opening(tree, node, mm_per_cell))
}

/// Where the centre of each region is, in shares of the picture.
fn centres(tree: &Tree) -> Vec<[f64; 2]> {
    let (width, height) = (tree.grid.cells.width as usize, tree.grid.cells.height as usize);
    let mut sums = vec![[0.0; 2]; tree.nodes.len()];
    for (y, row) in tree.basin.chunks_exact(width).enumerate() {
        for (x, &basin) in row.iter().enumerate() {
            let [across, down] = &mut sums[basin as usize];
            *across += (x as f64 + 0.5) / width as f64;
            *down += (y as f64 + 0.5) / height as f64;
        }
    }
    // what a region is merged of has lower numbers
    for node in 0..sums.len() {
        if let Some(children) = tree.nodes[node].children {
            sums[node] = [0, 1].map(|axis| children.iter().map(|&child| sums[child as usize][axis]).sum());
        }
    }
    sums.iter().zip(&tree.nodes).map(|(sum, node)| sum.map(|sum| sum / node.area)).collect()
}

#[cfg(test)]
pub(super) mod tests;
