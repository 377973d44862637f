//! Few shapes: where the maker of a page wants no more than some, the most salient ones stay.

use super::clearance::Cleared;
use super::outlines::Outlines;
use super::params::Params;
use super::vertex::{FoundIn, Vertex, nearby};
use crate::geom::components::DisjointSets;
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// How many of the lines are left out as there are to be few.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Beyond {
    /// Shapes: closed lines, and in a drawing lines that hang together.
    pub shapes: usize,
    /// Other lines.
    pub lines: usize,
}

/// Leaves out the lines beyond as many as there are to be beside outlines, and those that are too short beside them.
/// Where none is an outline all stay: they are what there is to feel.
pub(super) fn keep_beside_outlines(cleared: &mut Vec<Cleared>, outlines: &Outlines) {
    let Some((most, length)) = outlines.others else { return };
    if !cleared.iter().any(|line| line.rank.is_outline()) {
        return;
    }
    let mut count = 0;
    cleared.retain(|line| {
        let stays = line.rank.is_outline() || is_of_person(&line.polyline);
        count += usize::from(!stays && line.polyline.length() >= length);
        stays || (count <= most && line.polyline.length() >= length)
    });
}

/// Keeps of the lines, which come in the order of their saliency, as many shapes and single open lines as are asked for
/// at most.
pub(super) fn keep(drawn: &mut Vec<&Cleared>, of_outlines: usize, area: MmRect, params: &Params) -> Beyond {
    match params.most_shapes {
        None => Beyond::default(),
        Some(most) if params.of_drawing => {
            let all = nearby(drawn.iter().map(|line| &line.polyline), area, params);
            keep_first_things(drawn, most, &all, params)
        }
        Some(most) => keep_first(drawn, most, of_outlines),
    }
}

/// Whether a line is one that a person drew into the picture: none of these is beyond what there is to be.
pub(super) fn is_of_person(line: &Polyline<Vertex>) -> bool {
    let vertices = &line.vertices;
    2 * vertices.iter().filter(|vertex| vertex.source == FoundIn::Person).count() > vertices.len()
}

/// Keeps the first shapes, at most so many, and as many single open lines. Outlines of regions are shapes already, and
/// none of them goes.
fn keep_first(drawn: &mut Vec<&Cleared>, most: usize, of_outlines: usize) -> Beyond {
    let mut budget = Budget::new(most.saturating_sub(of_outlines), most);
    drawn.retain(|line| line.rank.is_outline() || is_of_person(&line.polyline) || budget.has(line.polyline.closed));
    budget.beyond
}

/// The same of a drawing. There lines that meet are one shape, and are drawn together or not at all. `all` has the
/// segments of the lines, under their places among them.
fn keep_first_things(drawn: &mut Vec<&Cleared>, most: usize, all: &Nearby, params: &Params) -> Beyond {
    let thing_of_line = connected(drawn, all, params);
    let mut things = vec![Thing::default(); thing_of_line.len()];
    for (&thing, line) in thing_of_line.iter().zip(drawn.iter()) {
        things[thing].add(line);
    }
    let mut order: Vec<usize> = (0..things.len()).filter(|&thing| things[thing].lines > 0).collect();
    order.sort_by(|&a, &b| things[b].saliency.total_cmp(&things[a].saliency).then(a.cmp(&b)));
    let mut budget = Budget::new(most, most);
    for thing in order {
        things[thing].stays = things[thing].is_of_person || budget.has(things[thing].is_shape());
    }
    let mut of_line = thing_of_line.into_iter();
    drawn.retain(|_| of_line.next().is_some_and(|thing| things[thing].stays));
    budget.beyond
}

/// Lines of a drawing that hang together.
#[derive(Debug, Clone, Default)]
struct Thing {
    saliency: f32,
    lines: usize,
    has_ring: bool,
    /// Whether a person drew some of it.
    is_of_person: bool,
    /// Whether it is drawn.
    stays: bool,
}

impl Thing {
    fn add(&mut self, line: &Cleared) {
        self.saliency += line.saliency;
        self.lines += 1;
        self.has_ring |= line.polyline.closed;
        self.is_of_person |= is_of_person(&line.polyline);
    }

    fn is_shape(&self) -> bool {
        self.has_ring || self.lines > 1
    }
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
fn connected(drawn: &[&Cleared], all: &Nearby, params: &Params) -> Vec<usize> {
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

#[cfg(test)]
mod tests;
