//! Which labels stand in one row or column of the picture, as at the axes of a chart.

use super::placed::Wanted;
use super::scale;
use crate::units::MmRect;

/// From so many labels on a row without numbers is taken for that of an axis.
pub(super) const OF_AN_AXIS: usize = 5;

/// Fewest labels of a row. Two may stand side by side by chance.
const FEWEST: usize = 3;
/// Texts of one row have their middles at one height, and those of a column one edge below the other, up to so much,
/// mm: more than rounding, less than print lines are apart.
const ALIGNED: f32 = 0.7;
/// Points that a person gives by hand are in a row up to so much, mm.
const BY_HAND: f32 = 2.0;

/// How the labels of a group lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lies {
    /// Side by side, in place of texts.
    Row,
    /// Side by side, below points.
    BelowPoints,
    /// One above the other, with one edge in line: 0 is the left one, 1 the right one.
    Column(f32),
}

/// Labels that are placed together, in their order.
#[derive(Debug, Clone)]
pub(super) struct Group {
    /// Which they are.
    pub(super) members: Vec<usize>,
    /// In a row or a column.
    pub(super) lies: Lies,
    /// Of numbers along an axis, how many steps each lies from zero.
    pub(super) steps: Option<Vec<i64>>,
    /// Whether they are the months of a year.
    pub(super) is_of_months: bool,
    /// Whether it is a row, and numbers along an axis stand in a column.
    pub(super) is_beside_column: bool,
}

impl Group {
    fn new(members: Vec<usize>, lies: Lies) -> Self {
        Self { members, lies, steps: None, is_of_months: false, is_beside_column: false }
    }

    /// Every how many-th of numbers along an axis.
    pub(super) fn every(&self, count: i64) -> Self {
        let steps = self.steps.as_deref().unwrap_or_default();
        let (members, steps) =
            self.members.iter().zip(steps).filter(|(_, step)| *step % count == 0).map(|(&i, &step)| (i, step)).unzip();
        Self { members, steps: Some(steps), ..self.clone() }
    }
}

/// What is written of what is wanted, in rows and columns: texts, and points that are at the lower side of a shape.
pub(super) fn of(wanted: &[Wanted], is_written: impl Fn(usize) -> bool, is_low: impl Fn(usize) -> bool) -> Vec<Group> {
    let anchor = |label: usize| (label, wanted[label].anchor);
    let (texts, points): (Vec<usize>, Vec<usize>) =
        (0..wanted.len()).filter(|&label| is_written(label)).partition(|&label| !wanted[label].anchor.is_empty());
    let points: Vec<_> = points.into_iter().filter(|&at| is_low(at)).map(anchor).collect();
    let below = in_line(&points, |place| place.center().y, BY_HAND);
    let below = below.into_iter().map(|members| Group::new(members, Lies::BelowPoints));
    let mut groups: Vec<Group> = below.chain(of_texts(&texts.into_iter().map(anchor).collect::<Vec<_>>())).collect();
    for group in &mut groups {
        let along = |label: &usize| match (group.lies, wanted[*label].anchor.center()) {
            (Lies::Column(_), at) => at.y,
            (_, at) => at.x,
        };
        group.members.sort_by(|a, b| along(a).total_cmp(&along(b)));
        // the letter at the end of an axis may stand in line with its numbers
        let scale = |members: &[usize]| {
            let texts: Vec<&str> = members.iter().map(|&label| wanted[label].text.as_str()).collect();
            scale::steps(&texts, &members.iter().map(along).collect::<Vec<_>>())
        };
        let numbers: Vec<usize> =
            group.members.iter().copied().filter(|&label| scale::is_number(&wanted[label].text)).collect();
        group.steps = scale(&numbers);
        if group.steps.is_some() {
            group.members = numbers;
        }
    }
    let is_column = |group: &Group| matches!(group.lies, Lies::Column(_));
    let are_columns = groups.iter().any(|group| is_column(group) && group.steps.is_some());
    groups.iter_mut().for_each(|group| group.is_beside_column = are_columns && !is_column(group));
    groups
}

/// A coordinate of a box in which those of a row or column agree.
type Key = fn(MmRect) -> f32;

/// Texts in these boxes that stand in rows, the largest first, then columns of those that are in no row. Numbers at an
/// axis end in line, names in a list begin so.
fn of_texts(texts: &[(usize, MmRect)]) -> Vec<Group> {
    let rows = in_line(texts, |place| place.center().y, ALIGNED);
    let mut groups: Vec<Group> = rows.into_iter().map(|members| Group::new(members, Lies::Row)).collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.members.len()));
    let mut alone = texts.to_vec();
    loop {
        alone.retain(|(label, _)| !groups.iter().any(|group| group.members.contains(label)));
        let edges: [(Key, f32); 3] =
            [(|place| place.max.x, 1.0), (|place| place.min.x, 0.0), (|place| place.center().x, 0.5)];
        let columns = edges.into_iter().flat_map(|(edge, side)| {
            in_line(&alone, edge, ALIGNED).into_iter().map(move |members| Group::new(members, Lies::Column(side)))
        });
        match columns.reduce(|a, b| if b.members.len() > a.members.len() { b } else { a }) {
            Some(column) => groups.push(column),
            None => return groups,
        }
    }
}

/// Those that agree in a coordinate up to `off` mm, all with the first of them.
fn in_line(labels: &[(usize, MmRect)], key: Key, off: f32) -> Vec<Vec<usize>> {
    let mut sorted: Vec<(usize, f32)> = labels.iter().map(|&(label, place)| (label, key(place))).collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut lines: Vec<Vec<(usize, f32)>> = Vec::new();
    for label in sorted {
        match lines.last_mut() {
            Some(line) if label.1 - line[0].1 <= off => line.push(label),
            _ => lines.push(vec![label]),
        }
    }
    lines.retain(|line| line.len() >= FEWEST);
    lines.into_iter().map(|line| line.into_iter().map(|(label, _)| label).collect()).collect()
}
