//! Paths of a skeleton become lines: short spurs go, and arms that continue one another through a junction are one
//! line.

use super::skeleton::{Node, Path};
use crate::geom::polyline::Polyline;
use crate::units::{PxPoint, PxVector};

/// The direction of an arm is taken from its junction over this much of it, px.
const HEADING: f32 = 8.0;
/// Two arms go on through a junction if the cosine between their directions is at most this (30 degrees from straight).
const STRAIGHT: f32 = -0.866;
/// The two straightest arms of a junction are one line, unless they make a sharper corner than this (120 degrees).
const BENT: f32 = -0.5;
/// An arm with a free end that is no longer than this, px, beyond the stroke's own half width, is a spur that thinning
/// left.
const SPUR: f32 = 3.0;

/// A line of pixels, which may lead through junctions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strand {
    pub(super) line: Polyline<PxPoint>,
    /// Whether its start and its end are free, and not at a junction.
    pub(super) free: [bool; 2],
}

/// An end of a path at a junction.
#[derive(Debug, Clone, Copy)]
struct Arm {
    path: usize,
    at_start: bool,
    heading: PxVector,
}

/// The lines of a skeleton, pixel by pixel.
pub(super) fn joined(paths: Vec<Path>, nodes: &[Node]) -> Vec<Strand> {
    let is_spur = |path: &Path| match path.nodes {
        [Some(node), None] | [None, Some(node)] => path.points.len() as f32 <= SPUR + nodes[node].depth,
        _ => false,
    };
    let paths: Vec<Path> = paths.into_iter().filter(|path| !is_spur(path)).collect();
    let mut arms_of: Vec<Vec<Arm>> = vec![Vec::new(); nodes.len()];
    for (number, path) in paths.iter().enumerate() {
        for at_start in [true, false] {
            if let Some(node) = path.nodes[usize::from(!at_start)] {
                arms_of[node].push(Arm { path: number, at_start, heading: heading(path, at_start, nodes[node].at) });
            }
        }
    }
    // partner[path][end]: the end that goes on, and through which junction
    let mut partner: Vec<[Option<(usize, bool, usize)>; 2]> = vec![[None; 2]; paths.len()];
    for (node, arms) in arms_of.iter().enumerate() {
        for (a, b) in pairs(arms) {
            partner[a.path][usize::from(!a.at_start)] = Some((b.path, b.at_start, node));
            partner[b.path][usize::from(!b.at_start)] = Some((a.path, a.at_start, node));
        }
    }
    let lone = |node: usize| arms_of[node].len() < 2;
    strung(&paths, &partner, nodes, &lone)
}

/// The direction in which an arm leaves its junction.
fn heading(path: &Path, at_start: bool, node: PxPoint) -> PxVector {
    let n = path.points.len();
    let from_node = |i: usize| path.points[if at_start { i } else { n - 1 - i }];
    let far = (0..n).map(from_node).find(|at| (*at - node).length() >= HEADING).unwrap_or_else(|| from_node(n - 1));
    (far - node).try_normalize().unwrap_or(PxVector::zero())
}

/// Which arms of a junction go on into which.
fn pairs(arms: &[Arm]) -> Vec<(Arm, Arm)> {
    let mut all: Vec<(f32, usize, usize)> = Vec::new();
    for i in 0..arms.len() {
        for k in i + 1..arms.len() {
            all.push((arms[i].heading.dot(arms[k].heading), i, k));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = vec![true; arms.len()];
    let mut pairs = Vec::new();
    for (number, &(cosine, i, k)) in all.iter().enumerate() {
        // of two arms that are left of a junction, both go on, whatever the corner
        let most = match (arms.len(), number) {
            (2, _) => 1.0,
            (_, 0) => BENT,
            _ => STRAIGHT,
        };
        if cosine <= most && free[i] && free[k] {
            (free[i], free[k]) = (false, false);
            pairs.push((arms[i], arms[k]));
        }
    }
    pairs
}

/// The lines along paths and their partners.
fn strung(
    paths: &[Path],
    partner: &[[Option<(usize, bool, usize)>; 2]],
    nodes: &[Node],
    lone: &dyn Fn(usize) -> bool,
) -> Vec<Strand> {
    let mut used = vec![false; paths.len()];
    let mut lines = Vec::new();
    // first from ends without partner, then round what is closed
    let ends = (0..paths.len()).flat_map(|path| [(path, true), (path, false)]);
    let free = ends.filter(|&(path, at_start)| partner[path][usize::from(!at_start)].is_none());
    for (path, at_start) in free.chain((0..paths.len()).map(|path| (path, true))) {
        if used[path] {
            continue;
        }
        let mut points: Vec<PxPoint> = Vec::new();
        let node_at = |path: &Path, start: bool| path.nodes[usize::from(!start)];
        let start = node_at(&paths[path], at_start).filter(|_| partner[path][usize::from(!at_start)].is_none());
        points.extend(start.map(|node| nodes[node].at));
        let (mut here, mut from_start) = (path, at_start);
        let (closed, end) = loop {
            used[here] = true;
            match from_start {
                true => points.extend(&paths[here].points),
                false => points.extend(paths[here].points.iter().rev()),
            }
            match partner[here][usize::from(from_start)] {
                Some((next, next_at_start, node)) if !used[next] => {
                    points.push(nodes[node].at);
                    (here, from_start) = (next, next_at_start);
                }
                Some((next, ..)) => {
                    let end = node_at(&paths[here], !from_start);
                    points.extend(end.map(|node| nodes[node].at));
                    break (next == path, end);
                }
                None => {
                    let end = node_at(&paths[here], !from_start);
                    points.extend(end.map(|node| nodes[node].at));
                    break (paths[here].closed, end);
                }
            }
        };
        points.dedup();
        if points.len() > 1 {
            let line = Polyline { closed: closed && points.len() > 2, vertices: points };
            let free = [start, end].map(|node| !line.closed && node.is_none_or(lone));
            lines.push(Strand { line, free });
        }
    }
    lines
}
