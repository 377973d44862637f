//! Few shapes: where the maker of a page wants no more than some, the most salient ones stay.

use super::clearance::Cleared;
use super::params::Params;
use super::vertex::FoundIn;
use crate::geom::components::DisjointSets;
use crate::geom::nearby::Nearby;

/// How many of the lines are left out as there are to be few.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Beyond {
    /// Shapes: closed lines, and in a drawing lines that hang together.
    pub shapes: usize,
    /// Other lines.
    pub lines: usize,
}

/// Keeps of the lines, which come in the order of their saliency, the first shapes, at most so many, and as many single
/// open lines. Outlines of regions are shapes already, and none of them goes.
pub(super) fn keep_first(drawn: &mut Vec<&Cleared>, most: usize, of_outlines: usize) -> Beyond {
    let mut budget = Budget::new(most.saturating_sub(of_outlines), most);
    // a photograph's exact lines were added by a person
    let is_added = |line: &Cleared| line.polyline.vertices.iter().all(|vertex| vertex.source == FoundIn::Vector);
    drawn.retain(|line| line.rank.is_outline() || is_added(line) || budget.has(line.polyline.closed));
    budget.beyond
}

/// The same of a drawing. There lines that meet are one shape, and are drawn together or not at all. `all` has the
/// segments of the lines, under their places among them.
pub(super) fn keep_first_things(drawn: &mut Vec<&Cleared>, most: usize, all: &Nearby, params: &Params) -> Beyond {
    let thing = things(drawn, all, params);
    let mut things = vec![(0.0_f32, 0_usize, false); thing.len()];
    for (&thing, line) in thing.iter().zip(drawn.iter()) {
        let (saliency, lines, has_ring) = &mut things[thing];
        *saliency += line.saliency;
        *lines += 1;
        *has_ring |= line.polyline.closed;
    }
    let mut order: Vec<usize> = (0..things.len()).filter(|&thing| things[thing].1 > 0).collect();
    order.sort_by(|&a, &b| things[b].0.total_cmp(&things[a].0).then(a.cmp(&b)));
    let mut budget = Budget::new(most, most);
    let mut stays = vec![false; things.len()];
    for number in order {
        let (_, lines, has_ring) = things[number];
        stays[number] = budget.has(has_ring || lines > 1);
    }
    let mut of_line = thing.into_iter();
    drawn.retain(|_| of_line.next().is_some_and(|thing| stays[thing]));
    budget.beyond
}

/// How many more may be drawn, and how many are beyond it.
struct Budget {
    shapes: usize,
    lines: usize,
    beyond: Beyond,
}

impl Budget {
    fn new(shapes: usize, lines: usize) -> Self {
        Self { shapes, lines, beyond: Beyond::default() }
    }

    /// Whether one more is within it, which it then counts.
    fn has(&mut self, is_shape: bool) -> bool {
        let (budget, beyond) = match is_shape {
            true => (&mut self.shapes, &mut self.beyond.shapes),
            false => (&mut self.lines, &mut self.beyond.lines),
        };
        let is_within = *budget > 0;
        *budget = budget.saturating_sub(1);
        *beyond += usize::from(!is_within);
        is_within
    }
}

/// For each line the number of a line that stands for all that it hangs together with: an end of one lies on another.
/// `all` has their segments.
fn things(drawn: &[&Cleared], all: &Nearby, params: &Params) -> Vec<usize> {
    let reach = 0.5 * params.width_max;
    let mut sets = DisjointSets::default();
    drawn.iter().for_each(|_| {
        sets.add();
    });
    for (number, line) in drawn.iter().enumerate() {
        line.polyline.each_that_it_ends_on(all, reach, |other| sets.join(number, other));
    }
    (0..drawn.len()).map(|line| sets.lowest(line)).collect()
}
