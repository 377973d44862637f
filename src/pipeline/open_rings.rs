//! Closed lines that are open as dots: of a narrow box one side is too near to the other, and a piece of it is left
//! out, which may be little of the whole.

use crate::lines::{Line, LostLine};
use crate::units::{MmPoint, MmRect};

/// Two ends are no farther apart than this where one dot is missing between them, in steps.
const MISSING: f32 = 2.1;
/// An end so near to the dots of another line may be where the two meet, in least distances of two lines: dots of
/// slanting lines lie a diagonal of the grid apart.
const AT_OTHER: f32 = std::f32::consts::SQRT_2;

/// The longest gap of each line that is closed and, as it is `pressed`, open: a row of its dots ends there, and neither
/// another of its rows begins nor is another line near. `stand_for` says of which line each of those pressed is; dots
/// lie `pitch` mm apart, and the middles of lines at least `apart` mm.
pub(super) fn gaps(
    lines: &[Line],
    pressed: &[Line],
    stand_for: &[Option<usize>],
    [pitch, apart]: [f32; 2],
) -> Vec<Option<LostLine>> {
    let gap = |(number, line): (usize, &Line)| -> Option<LostLine> {
        let of_line = |is_own: bool| {
            let all = pressed.iter().zip(stand_for);
            all.filter(move |(_, of)| (**of == Some(number)) == is_own).map(|(line, _)| line)
        };
        if !line.ends_meet() || of_line(true).any(Line::is_ring_of_dots) {
            return None;
        }
        let rows = of_line(true).filter(|line| !line.is_block_of_dots()).filter_map(Line::row);
        let ends: Vec<MmPoint> =
            rows.flat_map(|row| [row.points.first(), row.points.last()]).flatten().copied().collect();
        let others: Vec<MmPoint> =
            of_line(false).flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied()).collect();
        let is_at_other = |end: MmPoint| others.iter().any(|dot| (*dot - end).length() <= AT_OTHER * apart);
        // from each end to the next one
        let to_next = |end: usize| {
            let to_others = (0..ends.len()).filter(|other| *other != end).map(|other| ends[other] - ends[end]);
            to_others.min_by(|a, b| a.length().total_cmp(&b.length())).map(|gap| (ends[end], gap))
        };
        let open = (0..ends.len()).filter_map(to_next).filter(|(_, gap)| gap.length() > MISSING * pitch);
        let longest = open.filter(|(end, _)| !is_at_other(*end));
        let (end, gap) = longest.max_by(|(_, a), (_, b)| a.length().total_cmp(&b.length()))?;
        let extent = MmRect::from_points([end, end + gap]);
        Some(LostLine { extent, length: gap.length(), closed: true, is_faint: false, form: None })
    };
    lines.iter().enumerate().map(gap).collect()
}

#[cfg(test)]
mod tests;
