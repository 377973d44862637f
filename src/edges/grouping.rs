//! What the tree of regions is made of: all chains with their strengths, and the colours of cells.

use pulp::Arch;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::chain::Chain;
use super::ridge::RidgePoint;
use crate::geom::polyline::Polyline;
use crate::raster::Raster;
use crate::raster::lab;
use crate::raster::plane::Plane;
use crate::raster::shrink::Shrinker;
use crate::regions::{Detail, RegionGrid, TracePoint, TracedContour, Tree};

/// The tree of the regions between all chains, given with the strengths along each, be they strong enough for contours
/// or not.
pub(super) fn tree(
    raster: &Raster,
    points: &[RidgePoint],
    chains: &[Chain],
    strengths: &[Vec<f32>],
    detail: Detail,
) -> Tree {
    let grid = RegionGrid::new(raster.size());
    let trace = |(chain, strengths): (&Chain, &Vec<f32>)| -> TracedContour {
        let point = |(&number, &strength): (&u32, &f32)| TracePoint { at: points[number as usize].at, strength };
        Polyline { vertices: chain.vertices.iter().zip(strengths).map(point).collect(), closed: chain.closed }
    };
    let (traces, colours) =
        rayon::join(|| chains.par_iter().zip(strengths).map(trace).collect::<Vec<_>>(), || colours(raster, grid));
    Tree::new(&traces, &colours, grid, detail)
}

/// L, 2a and 2b of the cells, or L alone.
fn colours(raster: &Raster, grid: RegionGrid) -> Vec<Plane> {
    let arch = Arch::new();
    let width = raster.size().width as usize;
    let cells = raster.planes().as_ref().par_map(|plane| {
        let mut shrinker = Shrinker::new(raster.size(), grid.cells);
        plane.chunks_exact(width).for_each(|row| shrinker.push(row));
        shrinker.finish().values
    });
    let mut planes = vec![vec![0.0; grid.cells.len()]; lab::planes(raster)];
    let from: Vec<&[f32]> = cells.iter().map(Vec::as_slice).collect();
    lab::convert(arch, &from, &mut planes);
    planes.into_iter().map(|values| Plane { size: grid.cells, values }).collect()
}
