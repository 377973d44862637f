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
/// The lines between two cells of a table are no broader than this, mm: two rows of dots.
const BETWEEN_CELLS: f32 = 4.5;
/// Points that a person gives by hand are in a row up to so much, mm.
const BY_HAND: f32 = 2.0;

/// How the labels of a group lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum GroupDirection {
    /// Side by side, in place of texts.
    Row,
    /// Side by side, below points.
    BelowPoints,
    /// One above the other, with this edge in line.
    Column(Edge),
}

/// The edge of the texts of a column that is in line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Edge {
    Left,
    Middle,
    Right,
}

impl Edge {
    /// Where it lies, as a share of a text's width from its left.
    pub(super) fn share(self) -> f32 {
        match self {
            Self::Left => 0.0,
            Self::Middle => 0.5,
            Self::Right => 1.0,
        }
    }

    /// Where the left side of a label of this width lies that has this edge in line with that of its text.
    pub(super) fn left_of(self, text: MmRect, width: f32) -> f32 {
        text.min.x + self.share() * (text.width() - width)
    }
}

/// Labels that are placed together, in their order.
#[derive(Debug, Clone)]
pub(super) struct Group {
    /// Which they are.
    pub(super) members: Vec<usize>,
    /// In a row or a column.
    pub(super) lies: GroupDirection,
    /// Of numbers along an axis, how many steps each lies from zero.
    pub(super) steps: Option<Vec<i64>>,
    /// Whether they are the months of a year.
    pub(super) is_of_months: bool,
    /// Whether it is a row, and numbers along an axis stand in a column.
    pub(super) is_beside_column: bool,
}

impl Group {
    fn new(members: Vec<usize>, lies: GroupDirection) -> Self {
        Self { members, lies, steps: None, is_of_months: false, is_beside_column: false }
    }

    /// Every how many-th of numbers along an axis.
    pub(super) fn every(&self, count: i64) -> Self {
        let steps = self.steps.as_deref().unwrap_or_default();
        let (members, steps) =
            self.members.iter().zip(steps).filter(|(_, step)| *step % count == 0).map(|(&i, &step)| (i, step)).unzip();
        Self { members, steps: Some(steps), ..self.clone() }
    }

    /// Whether its labels stand in the cells of a table, of which `cell` gives that of each: boxes that stand apart, as
    /// those of a family tree, are none. Numbers in even steps do if each has a cell of its own, with another text, as
    /// in a table of the elements; those of an axis may stand in the squares of its grid.
    pub(super) fn is_of_table(&self, wanted: &[Wanted], cell: impl Fn(usize) -> Option<MmRect>) -> bool {
        let is_in = |of: &MmRect, label: usize| of.contains(wanted[label].anchor.center());
        let is_own = |own: usize, of: &MmRect| self.members.iter().all(|&label| label == own || !is_in(of, label));
        let has_other = |own: usize, of: &MmRect| {
            (0..wanted.len()).any(|label| label != own && !wanted[label].anchor.is_empty() && is_in(of, label))
        };
        let is_of_cell = |own: usize, of: &MmRect| self.steps.is_none() || is_own(own, of) && has_other(own, of);
        let is_beside = |a: &MmRect, b: &MmRect| a.inflate(BETWEEN_CELLS, BETWEEN_CELLS).intersects(b);
        let has_next = |own: usize, of: &MmRect| {
            (0..wanted.len()).any(|label| label != own && cell(label).is_some_and(|other| is_beside(of, &other)))
        };
        self.members.iter().any(|&label| cell(label).is_some_and(|of| has_next(label, &of)))
            && self.members.iter().all(|&label| cell(label).is_some_and(|of| is_of_cell(label, &of)))
    }
}

/// What is written of what is wanted, in rows and columns: texts, and points that are at the lower side of a shape. Two
/// numbers one above the other are a scale if both stand at a level line.
pub(super) fn of(
    wanted: &[Wanted],
    is_written: impl Fn(usize) -> bool,
    is_low: impl Fn(usize) -> bool,
    is_at_line: impl Fn(usize) -> bool,
) -> Vec<Group> {
    let anchor = |label: usize| (label, wanted[label].anchor);
    let (texts, points): (Vec<usize>, Vec<usize>) =
        (0..wanted.len()).filter(|&label| is_written(label)).partition(|&label| !wanted[label].anchor.is_empty());
    let points: Vec<_> = points.into_iter().filter(|&at| is_low(at)).map(anchor).collect();
    let below = in_line(&points, |place| place.center().y, BY_HAND);
    let below = below.into_iter().map(|members| Group::new(members, GroupDirection::BelowPoints));
    let texts: Vec<_> = texts.into_iter().map(anchor).collect();
    let mut groups: Vec<Group> = below.chain(of_texts(&texts)).collect();
    groups.extend(pairs(&texts, &groups, |label| scale::is_number(&wanted[label].text) && is_at_line(label)));
    for group in &mut groups {
        let along = |label: &usize| match (group.lies, wanted[*label].anchor.center()) {
            (GroupDirection::Column(_), at) => at.y,
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
        // and a power may stand at its place among numbers of which it is no step
        let on_line: Vec<usize> =
            numbers.iter().copied().filter(|&label| !scale::is_power(&wanted[label].text)).collect();
        let count = group.members.len();
        let mut scales = [numbers, on_line].into_iter().filter(|of| of.len() >= FEWEST || of.len() == count);
        let found = scales.find_map(|members| Some((scale(&members)?, members)));
        if let Some((steps, members)) = found {
            group.steps = Some(steps);
            group.members = members;
        }
    }
    groups.retain(|group| group.members.len() >= FEWEST || group.steps.is_some());
    let is_column = |group: &Group| matches!(group.lies, GroupDirection::Column(_));
    let are_columns = groups.iter().any(|group| is_column(group) && group.steps.is_some());
    groups.iter_mut().for_each(|group| group.is_beside_column = are_columns && !is_column(group));
    groups
}

/// A coordinate of a box in which those of a row or column agree.
type Coordinate = fn(MmRect) -> f32;

/// Texts in these boxes that stand in rows, the largest first, then columns of those that are in no row. Numbers at an
/// axis end in line, names in a list begin so.
fn of_texts(texts: &[(usize, MmRect)]) -> Vec<Group> {
    let rows = in_line(texts, |place| place.center().y, ALIGNED);
    let mut groups: Vec<Group> = rows.into_iter().map(|members| Group::new(members, GroupDirection::Row)).collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.members.len()));
    let mut alone = texts.to_vec();
    loop {
        alone.retain(|(label, _)| !groups.iter().any(|group| group.members.contains(label)));
        let columns = [Edge::Right, Edge::Left, Edge::Middle].into_iter().flat_map(|edge| {
            let coordinate: Coordinate = match edge {
                Edge::Right => |text| text.max.x,
                Edge::Left => |text| text.min.x,
                Edge::Middle => |text| text.center().x,
            };
            let columns = in_line(&alone, coordinate, ALIGNED).into_iter();
            columns.map(move |members| Group::new(members, GroupDirection::Column(edge)))
        });
        match columns.reduce(|a, b| if b.members.len() > a.members.len() { b } else { a }) {
            Some(column) => groups.push(column),
            None => return groups,
        }
    }
}

/// Two and two numbers of scales that are in no other group, one above the other.
fn pairs(texts: &[(usize, MmRect)], groups: &[Group], is_of_scale: impl Fn(usize) -> bool) -> Vec<Group> {
    let is_alone = |label: usize| !groups.iter().any(|group| group.members.contains(&label));
    let numbers: Vec<_> = texts.iter().copied().filter(|(label, _)| is_alone(*label)).collect();
    let sides: [(Edge, Coordinate); 2] = [(Edge::Right, |text| text.max.x), (Edge::Left, |text| text.min.x)];
    let columns = sides.into_iter().flat_map(|(edge, side)| {
        let pairs = in_line_of(&numbers, side, ALIGNED, 2).into_iter().filter(|of| of.len() == 2);
        pairs.map(move |members| Group::new(members, GroupDirection::Column(edge)))
    });
    let mut pairs: Vec<Group> = Vec::new();
    for pair in columns.filter(|pair| pair.members.iter().all(|&label| is_of_scale(label))) {
        if !pairs.iter().any(|other| other.members.iter().any(|label| pair.members.contains(label))) {
            pairs.push(pair);
        }
    }
    pairs
}

/// Those that agree in a coordinate up to `off` mm, all with the first of them.
fn in_line(labels: &[(usize, MmRect)], coordinate: Coordinate, off: f32) -> Vec<Vec<usize>> {
    in_line_of(labels, coordinate, off, FEWEST)
}

/// The same of at least so many.
fn in_line_of(labels: &[(usize, MmRect)], coordinate: Coordinate, off: f32, fewest: usize) -> Vec<Vec<usize>> {
    let mut sorted: Vec<(usize, f32)> = labels.iter().map(|&(label, text)| (label, coordinate(text))).collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut lines: Vec<Vec<(usize, f32)>> = Vec::new();
    for label in sorted {
        match lines.last_mut() {
            Some(line) if label.1 - line[0].1 <= off => line.push(label),
            _ => lines.push(vec![label]),
        }
    }
    lines.retain(|line| line.len() >= fewest);
    lines.into_iter().map(|line| line.into_iter().map(|(label, _)| label).collect()).collect()
}

#[cfg(test)]
mod tests;
