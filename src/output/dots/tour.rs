//! The order in which a machine visits dots, so that it travels little.
//!
//! Places are in hundredths of a millimetre, as the machine is told them: whole numbers, so that equal places are equal and
//! the order is the same on every computer. The way from place to place is straight: Marlin, the firmware of BrailleRAP,
//! runs both axes at once and takes the feed as the speed along the line (its `G1`), so that the path's length is Euclid's.
//!
//! The first axis moves the needle, the second the paper. [`order`] keeps paper from being pulled back far: going along
//! the path, no dot lies more than `most_back` above any dot before it.
//!
//! # How, and at what cost
//!
//! 1. Sorted by place, equal places once: the order of the input plays no part.
//! 2. Nearest neighbour: from where the needle is to the nearest dot that does not leave another dot more than `most_back`
//!    above it. About n steps of a few cells each.
//! 3. 2-opt and Or-opt with neighbour lists until no change is a gain: about n changes of up to n steps each, mostly few.
//! 4. Up to 10,000 small upsets, each taken back unless 2-opt and Or-opt make a gain of it.
//!
//! 20,000 dots take 0.16 s, 2,000 dots 0.06 s. `tools/src/bin/travel.rs` tells lengths and times: without
//! a limit to `most_back` paths are 1 to 3 % above the bound of Held and Karp for up to some 3,000 dots at random, in text
//! and in textures, 6 % in drawings where the bound itself is low.

mod bound;
mod improve;
mod near;

/// A place: across and down, in hundredths of a millimetre.
pub type Place = [i32; 2];

/// The dots in an order of short travel that begins at `ends[0]` and goes on to `ends[1]` behind the last dot; neither is a
/// dot. Equal places come once; the order of `dots` does not matter. Going along the path, no dot lies more than
/// `most_back` (hundredths of a millimetre, taken as 0 if negative) above a dot before it; `i32::MAX` lets it go anywhere.
pub fn order(dots: &[Place], ends: [Place; 2], most_back: i32) -> Vec<Place> {
    let dots = sorted(dots);
    let start = visit_nearest(&dots, ends[0], most_back.max(0));
    if dots.len() < 2 {
        return dots;
    }
    let neighbours = near::Grid::new(&dots).neighbours();
    let count = dots.len() as u32;
    let path = [count].into_iter().chain(start).chain([count + 1]).collect();
    let places: Vec<Place> = dots.iter().copied().chain(ends).collect();
    let path = improve::shorten(&places, &neighbours, path, most_back.max(0));
    path[1..=dots.len()].iter().map(|&number| places[number as usize]).collect()
}

/// The dots from each to the nearest that is left, a common measure of how good an order is. `most_back` as for [`order`].
pub fn nearest_neighbour(dots: &[Place], start: Place, most_back: i32) -> Vec<Place> {
    let dots = sorted(dots);
    visit_nearest(&dots, start, most_back.max(0)).into_iter().map(|number| dots[number as usize]).collect()
}

/// The dots row by row in bands `height` high (hundredths of a millimetre, at least 1), to and fro.
pub fn row_by_row(dots: &[Place], height: i32) -> Vec<Place> {
    let mut dots = sorted(dots);
    let band = |dot: &Place| dot[1].div_euclid(height.max(1));
    dots.sort_unstable_by_key(|dot| (band(dot), *dot));
    for (number, row) in dots.chunk_by_mut(|a, b| band(a) == band(b)).enumerate() {
        if number % 2 == 1 {
            row.reverse();
        }
    }
    dots
}

/// Length of the path through `dots` from `ends[0]` to `ends[1]`, hundredths of a millimetre.
pub fn length(dots: &[Place], ends: [Place; 2]) -> f64 {
    let places = || [ends[0]].into_iter().chain(dots.iter().copied()).chain([ends[1]]);
    places().zip(places().skip(1)).map(|(a, b)| distance(a, b)).sum()
}

/// A length that no path through all `dots` from `ends[0]` to `ends[1]` is below, whatever its order: the bound of Held and
/// Karp, some 1 to 3 % below the shortest path for up to 4,000 dots; for more dots the work is cut, and the bound falls
/// towards that of the least spanning tree, some 10 % below. Takes seconds, so it is for reports only.
pub fn lower_bound(dots: &[Place], ends: [Place; 2]) -> f64 {
    let dots = sorted(dots);
    let known = length(&order(&dots, ends, i32::MAX), ends);
    let places: Vec<Place> = [ends[0]].into_iter().chain(dots).chain([ends[1]]).collect();
    bound::lower_bound(&places, known)
}

/// How far back the path goes at most: the largest drop of the second coordinate from any dot to any later one.
pub fn most_back(dots: &[Place]) -> i32 {
    let mut lowest = i32::MIN;
    let back = dots.iter().map(|dot| {
        lowest = lowest.max(dot[1]);
        lowest.saturating_sub(dot[1])
    });
    back.max().unwrap_or(0)
}

fn sorted(dots: &[Place]) -> Vec<Place> {
    let mut dots = dots.to_vec();
    dots.sort_unstable_by_key(|&[x, y]| (y, x));
    dots.dedup();
    dots
}

/// Numbers of the dots, which are sorted, from each to the nearest that may come next.
fn visit_nearest(dots: &[Place], start: Place, most_back: i32) -> Vec<u32> {
    let mut grid = near::Grid::new(dots);
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

fn distance(a: Place, b: Place) -> f64 {
    let (x, y) = (f64::from(a[0]) - f64::from(b[0]), f64::from(a[1]) - f64::from(b[1]));
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Dots of a picture in characters, 1 mm apart; the order is told by letters.
    fn dots(picture: &str) -> Vec<Place> {
        let rows = picture.split_whitespace().enumerate();
        let mut dots: Vec<_> = rows
            .flat_map(|(y, row)| {
                row.bytes().enumerate().map(move |(x, letter)| (letter, [x as i32 * 100, y as i32 * 100]))
            })
            .filter(|(letter, _)| *letter != b'.')
            .collect();
        dots.sort_unstable();
        dots.into_iter().map(|(_, place)| place).collect()
    }

    #[track_caller]
    fn check(path: &[Place], picture: &str) {
        assert_eq!(path, dots(picture));
    }

    #[test]
    fn rows_go_to_and_fro() {
        // Rows without dots do not count.
        let picture = "a.bc fed. .... g.hi";
        check(&row_by_row(&dots(picture), 1), picture);
        // Bands of two rows: the first goes right, column by column, the second left.
        let picture = "a.ce .bdf .... ihg.";
        check(&row_by_row(&dots(picture), 200), picture);
        assert_eq!(row_by_row(&[], 1), [[0; 2]; 0]);
    }

    #[test]
    fn the_nearest_comes_next_unless_it_leaves_another_too_far_behind() {
        let picture = "a..c b... ....";
        check(&nearest_neighbour(&dots(picture), [0, 0], i32::MAX), picture);
        check(&nearest_neighbour(&dots(picture), [0, 0], 0), "a..b c... ....");
    }

    #[test]
    fn paper_is_pulled_back_as_far_as_is_allowed_and_no_farther() {
        let picture = "a.f b.e c.d";
        let ends = [[0, 0], [200, 0]];
        check(&order(&dots(picture), ends, 200), picture);
        assert_eq!(most_back(&dots(picture)), 200);
        for back in [0, 50, 199] {
            assert!(most_back(&order(&dots(picture), ends, back)) <= back);
        }
    }

    #[test]
    fn the_farthest_places_there_are() {
        let far = [[i32::MIN, i32::MIN], [i32::MAX, i32::MAX], [i32::MIN, i32::MAX], [0, 0], [i32::MAX, i32::MIN]];
        for back in [i32::MIN, 0, i32::MAX - 1, i32::MAX] {
            let path = order(&far, [[i32::MIN, 0], [i32::MAX, 0]], back);
            assert_eq!(sorted(&path), sorted(&far));
        }
    }
}
