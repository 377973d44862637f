//! The order in which a machine visits dots, so that it travels little: an open path through all of them with fixed
//! ends, the shortest Hamiltonian path by local search.
//!
//! Positions are in hundredths of a millimetre, as the machine is told them: whole numbers, so that equal positions
//! are equal and the order is the same on every computer. The machine moves in a straight line from one to the next:
//! Marlin, the firmware of BrailleRAP, runs both axes at once and takes the feed as the speed along the line (its
//! `G1`), so that the length of the path is Euclidean.
//!
//! The first axis moves the needle, the second the paper. [`order`] keeps paper from being pulled back far: going along
//! the path, no dot lies more than `most_back` above any dot before it.
//!
//! # How, and at what cost
//!
//! 1. Sorted by position, equal positions once: the order of the input does not matter.
//! 2. Nearest neighbour: from where the needle is to the nearest dot that does not leave another dot more than
//!    `most_back` above it. About n steps of a few cells each.
//! 3. 2-opt and Or-opt with neighbour lists until no change is a gain: about n changes of up to n steps each, mostly
//!    few.
//! 4. Up to 10,000 double bridges, each undone unless 2-opt and Or-opt make a gain of it.
//!
//! 20,000 dots take 0.16 s, 2,000 dots 0.06 s. `tools/src/bin/travel.rs` prints lengths and times: without a limit to
//! `most_back` paths are 1 to 3 % above the bound of Held and Karp for up to some 3,000 dots at random, in text and in
//! textures, 6 % in drawings where the bound itself is low.

mod improve;
mod neighbours;

pub use neighbours::DotPosition;

/// The dots in an order of short travel that begins at `ends[0]` and goes on to `ends[1]` behind the last dot;
/// neither is a dot. Equal positions come once; the order of `dots` does not matter. Going along the path, no dot
/// lies more than `most_back` (hundredths of a millimetre, taken as 0 if negative) above a dot before it; `i32::MAX`
/// lifts the limit.
pub fn order(dots: &[DotPosition], ends: [DotPosition; 2], most_back: i32) -> Vec<DotPosition> {
    let dots = sorted(dots);
    let start = nearest_neighbour(&dots, ends[0], most_back.max(0));
    if dots.len() < 2 {
        return dots;
    }
    let neighbours = neighbours::PositionGrid::new(&dots).neighbours();
    let count = dots.len() as u32;
    let path = [count].into_iter().chain(start).chain([count + 1]).collect();
    let positions: Vec<DotPosition> = dots.iter().copied().chain(ends).collect();
    let path = improve::shorten(&positions, &neighbours, path, most_back.max(0));
    path[1..=dots.len()].iter().map(|&number| positions[number as usize]).collect()
}

fn sorted(dots: &[DotPosition]) -> Vec<DotPosition> {
    let mut dots = dots.to_vec();
    dots.sort_unstable_by_key(|&[x, y]| (y, x));
    dots.dedup();
    dots
}

/// The path from each dot to the nearest that may come next, as numbers of the dots, which are sorted.
fn nearest_neighbour(dots: &[DotPosition], start: DotPosition, most_back: i32) -> Vec<u32> {
    let mut grid = neighbours::PositionGrid::new(dots);
    let mut visited = vec![false; dots.len()];
    let (mut here, mut highest) = (start, 0);
    let mut path = Vec::with_capacity(dots.len());
    while highest < dots.len() {
        // The highest that is left is always allowed, so there is a nearest one.
        let lowest = dots[highest][1].saturating_add(most_back);
        let Some(next) = grid.nearest(here, lowest) else { break };
        grid.remove(next);
        visited[next as usize] = true;
        path.push(next);
        here = dots[next as usize];
        highest += visited[highest..].iter().take_while(|&&visited| visited).count();
    }
    path
}

#[cfg(test)]
mod tests;
