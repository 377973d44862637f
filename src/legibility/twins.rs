//! Lines that lie on one another point for point, as after a copy in an editor: told once for all of them, and judged
//! once. Each pair of them would break every rule of distances all along.

use std::collections::{HashMap, HashSet};

use super::finding::{FoundBreach, around};
use super::marks::name_in;
use super::rules::OVERLAP;
use crate::page::{Line, Names, Page, Parts};

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
    for (at, &of) in of.iter().enumerate().filter(|(at, of)| at != *of) {
        twins[of] += usize::from(at != of);
    }
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

/// What equal lines have in common: every number of their marks.
fn key(line: &Line) -> Vec<u32> {
    let of_run = |run: &crate::page::Run| {
        let points = run.points.iter().flat_map(|at| [at.x.to_bits(), at.y.to_bits()]);
        [run.points.len() as u32, u32::from(run.closed), run.width.to_bits()]
            .into_iter()
            .chain(points)
            .collect::<Vec<_>>()
    };
    line.runs.iter().flat_map(of_run).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Run;
    use crate::units::MmPoint;

    fn line(y: f32) -> Line {
        let points = vec![MmPoint::new(10.0, y), MmPoint::new(50.0, y), MmPoint::new(90.0, y)];
        Line { strength: 1.0, runs: vec![Run::stroke(1.0, points)] }
    }

    #[test]
    fn of_equal_lines_the_first_stays_and_is_told_once() {
        let mut lines = vec![line(10.0), line(20.0), line(10.0), line(30.0), line(10.0), line(20.0)];
        let mut names: Vec<String> = (1..=6).map(|number| format!("line {number}")).collect();
        let mut found = Vec::new();
        assert!(has_twins(&lines));
        one_of_each(&mut lines, &mut names, &mut found);
        assert_eq!(lines, [line(10.0), line(20.0), line(30.0)]);
        assert_eq!(names, ["line 1", "line 2", "line 4"]);
        let told: Vec<&str> = found.iter().map(|found| found.what.as_str()).collect();
        assert_eq!(told.len(), 2, "{told:?}");
        assert!(told[0].contains("line 1: 2 other lines lie on it") && told[1].contains("line 2: another line"));
        assert!(!has_twins(&lines));
    }

    /// The same line drawn from its other end is another one here: what lies on it is told by the rule of distances.
    #[test]
    fn lines_that_differ_in_a_number_stay() {
        let mut wider = line(10.0);
        wider.runs[0].width = 1.2;
        assert!(!has_twins(&[line(10.0), wider, line(10.01)]));
    }
}
