//! Cells in lines.

use std::ops::Range;

use super::Braille;

/// Cells in lines of a width.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrapped {
    /// The lines, none empty.
    pub lines: Vec<Vec<u8>>,
    /// Whether a word is longer than a line, and was cut.
    pub cut: bool,
}

/// Whether words are divided at the ends of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Divide {
    /// No word is: as in titles, if there is room.
    Never,
    /// Where a line would be less than three quarters full without: a divided word takes longer to read.
    Words,
}

/// Dots 3 and 6: the hyphen of all codes.
const HYPHEN: u8 = 0b10_0100;

/// Braille in lines of at most `width` cells: lines end at a blank, behind a hyphen that the text has, or where a
/// word is divided, and within an equation or in front of a unit only where these are longer than a line. A word that
/// is longer than a line and cannot be divided is cut; an address goes on behind the sign that its code has for that.
pub fn wrap(braille: &Braille, width: usize, divide: Divide) -> Wrapped {
    wrap_beside(braille, width, width, divide)
}

/// The same where the first line has at most `first` cells, as beside a page number.
pub fn wrap_beside(braille: &Braille, first: usize, width: usize, divide: Divide) -> Wrapped {
    let cells = &braille.cells;
    let mut wrapped = Wrapped { lines: Vec::new(), cut: false };
    let mut from = 0;
    while let Some(begin) = cells[from..].iter().position(|&cell| cell != 0) {
        from += begin;
        let width = if wrapped.lines.is_empty() { first } else { width }.max(1);
        let longest = (from + width).min(cells.len());
        let last_end =
            |can_end: fn(&Braille, usize) -> bool| (from + 1..=longest).rev().find(|&end| can_end(braille, end));
        let whole = last_end(can_end).or_else(|| last_end(is_blank));
        let is_full = whole.is_some_and(|end| end == cells.len() || 4 * (end - from) >= 3 * width);
        // with room for the sign behind it; an address only where it is longer than a line
        let room = whole.unwrap_or(from) + 1..from + width;
        let divided = divided(braille, &room)
            .filter(|&(_, sign)| !is_full && if sign == HYPHEN { divide == Divide::Words } else { whole.is_none() })
            .max_by_key(|(at, _)| *at);
        wrapped.cut |= whole.is_none() && divided.is_none();
        let end = divided.map(|(at, _)| at).or(whole).unwrap_or(longest);
        let mut line = trimmed(&cells[from..end]).to_vec();
        line.extend(divided.map(|(_, sign)| sign));
        wrapped.lines.push(line);
        from = end;
    }
    wrapped
}

/// Behind which cells a word or an address can be divided, of those for which there is room, with the sign that stands
/// there at the end of a line.
fn divided(braille: &Braille, room: &Range<usize>) -> impl Iterator<Item = (usize, u8)> {
    let words = within(&braille.divisions, room, |&at| at).iter().map(|&at| (at, HYPHEN));
    words.chain(within(&braille.continued, room, |&(at, _)| at).iter().copied())
}

/// Those of some things whose places, which are in order, lie in a range.
fn within<'a, T>(all: &'a [T], range: &Range<usize>, place: impl Fn(&T) -> usize) -> &'a [T] {
    let from = all.partition_point(|of| place(of) < range.start);
    let to = all.partition_point(|of| place(of) < range.end);
    &all[from..to.max(from)]
}

/// Braille in two lines, as narrow as they can be without cutting a word; none if it has only one that cannot be
/// divided.
pub fn in_two(braille: &Braille, divide: Divide) -> Option<[Vec<u8>; 2]> {
    in_two_where(braille, divide, can_end)
}

/// The same where a line may end at any blank, also within an equation and in front of a unit.
pub fn in_two_at_any_blank(braille: &Braille) -> Option<[Vec<u8>; 2]> {
    in_two_where(braille, Divide::Never, is_blank)
}

fn in_two_where(braille: &Braille, divide: Divide, can_end: fn(&Braille, usize) -> bool) -> Option<[Vec<u8>; 2]> {
    let part = |end: usize, sign: Option<u8>| {
        let (first, second) = braille.cells.split_at(end);
        let mut first = trimmed(first).to_vec();
        first.extend(sign);
        [first, trimmed(second).to_vec()]
    };
    // a blank that the second line would begin with is none of it
    let width =
        |end: usize, hyphen: usize| (end + hyphen).max(braille.cells.len() - end - usize::from(is_blank(braille, end)));
    let whole = (1..braille.cells.len()).filter(|&end| can_end(braille, end)).map(|end| (width(end, 0), end, None));
    let anywhere = if divide == Divide::Words { 0..usize::MAX } else { 0..0 };
    let divided = divided(braille, &anywhere).map(|(end, sign)| (width(end, 1), end, Some(sign)));
    let (_, end, sign) = whole.chain(divided).min_by_key(|(width, ..)| *width)?;
    Some(part(end, sign))
}

/// Whether a line can end in front of this cell.
fn can_end(braille: &Braille, at: usize) -> bool {
    let is_joined = braille.joined.binary_search(&at).is_ok();
    is_blank(braille, at) && !is_joined || braille.breaks.binary_search(&at).is_ok()
}

/// Whether this cell is a blank or the end of the text.
fn is_blank(braille: &Braille, at: usize) -> bool {
    braille.cells.get(at).is_none_or(|&cell| cell == 0)
}

/// Without blanks at its ends.
fn trimmed(line: &[u8]) -> &[u8] {
    let begin = line.iter().position(|&cell| cell != 0).unwrap_or(line.len());
    let end = line.iter().rposition(|&cell| cell != 0).map_or(begin, |last| last + 1);
    &line[begin..end]
}
