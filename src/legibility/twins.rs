//! Lines that lie on one another point for point, as after a copy in an editor: told once for all of them, and judged
//! once. Each pair of them would break every rule of distances all along.

use std::collections::{HashMap, HashSet};

use super::finding::{FoundBreach, around};
use super::marks::name_in;
use super::rules::OVERLAP;
use crate::page::{Line, Names, Page, Parts, Pen, Run};
use crate::units::MmPoint;

/// A page without its lines that lie on an equal one, its names, and what is told of them. `page` is returned as it is
/// where there are none.
pub(super) fn merged(page: Page, names: &Names) -> (Page, Names, Vec<FoundBreach>) {
    let overview = page.overview.as_ref().map(|overview| &overview.lines);
    if !has_twins(&page.figure.lines) && !overview.is_some_and(|lines| has_twins(lines)) {
        return (page, names.clone(), Vec::new());
    }
    let mut parts = Parts::clone(&page);
    let (own, mut names) = (names, names.clone());
    let mut found = Vec::new();
    one_of_each(&mut parts.figure.lines, &mut names.lines, &mut found);
    if let Some(overview) = &mut parts.overview {
        one_of_each(&mut overview.lines, &mut names.overview_lines, &mut found);
    }
    match Page::new(parts) {
        Ok(one) => (one, names, found),
        // not reached: the page passed with more marks
        Err(_) => (page, own.clone(), Vec::new()),
    }
}

/// Whether a line lies on another one.
fn has_twins(lines: &[Line]) -> bool {
    let mut known = HashSet::with_capacity(lines.len());
    !lines.iter().all(|line| known.insert(key(line)))
}

fn one_of_each(lines: &mut Vec<Line>, names: &mut Vec<String>, found: &mut Vec<FoundBreach>) {
    let mut first: HashMap<Vec<u32>, usize> = HashMap::with_capacity(lines.len());
    // for each line the first that is equal
    let of: Vec<usize> = (0..).zip(lines.iter()).map(|(at, line)| *first.entry(key(line)).or_insert(at)).collect();
    let mut twins = vec![0_usize; lines.len()];
    of.iter().enumerate().filter(|(at, of)| at != *of).for_each(|(_, &of)| twins[of] += 1);
    for (at, count) in twins.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        let points = || lines[at].runs.iter().flat_map(|run| run.points.iter().copied());
        let (Some(middle), Some(extent)) = (points().nth(points().count() / 2), around(points())) else { continue };
        let what = match count {
            1 => format!("{}: another line lies on it, point for point", name_in(names, at)),
            _ => format!("{}: {count} other lines lie on it, point for point", name_in(names, at)),
        };
        found.push(FoundBreach::at(OVERLAP, middle, extent, 0.0, what).of(name_in(names, at)));
    }
    let is_first = |at: usize| of.get(at).is_none_or(|of| *of == at);
    let mut number = 0..;
    lines.retain(|_| number.next().is_some_and(is_first));
    let mut number = 0..;
    names.retain(|_| number.next().is_some_and(is_first));
}

/// What equal lines have in common: every number of their marks, from whichever end they are drawn.
fn key(line: &Line) -> Vec<u32> {
    let of_run = |run: &Run, backwards: bool| {
        let pen = match run.pen {
            Pen::Stroke => 0,
            Pen::Dots(height) => 1 + height as u32,
        };
        let mut key = vec![run.points.len() as u32, u32::from(run.closed), run.width.to_bits(), pen];
        let bits = |at: &MmPoint| [at.x.to_bits(), at.y.to_bits()];
        match backwards {
            false => key.extend(run.points.iter().flat_map(bits)),
            true => key.extend(run.points.iter().rev().flat_map(bits)),
        }
        key
    };
    let forwards: Vec<u32> = line.runs.iter().flat_map(|run| of_run(run, false)).collect();
    let backwards = line.runs.iter().rev().flat_map(|run| of_run(run, true)).collect();
    forwards.min(backwards)
}

#[cfg(test)]
mod tests;
