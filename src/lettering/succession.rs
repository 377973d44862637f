//! Single digits and capitals that follow one another, as 1, 2 and 3 on the face of a clock and A, B and C at the
//! corners of a triangle. Where there is no other text, small shapes are hardly ever so by chance.

use super::character::Likeness;
use super::line::TextLine;

/// How many follow one another at least: in steps of one, and in steps of two, as 0, 2, 4 and 6 at an axis. They are
/// one more where one of them looks more like another character: of three leaves one may be a 7, one a 6 or 8, one a 9.
const FEWEST: [(u8, usize); 2] = [(1, 3), (2, 4)];
/// These may be missing among others: the first two are looked for nowhere, and the tail of the last hangs below, or is
/// small.
const MAY_BE_MISSING: [char; 3] = ['I', 'J', 'Q'];
/// At least this share of the shapes of their style and size look like some digit or capital.
const NAMED: f32 = 0.5;

/// Which of some single letters follow one another, if each looks like these characters.
pub(super) fn successive(singles: &[TextLine], names: &[Vec<Likeness>]) -> Vec<bool> {
    let mut is_one = vec![false; singles.len()];
    for (i, one) in singles.iter().enumerate() {
        if is_one[i] || names[i].is_empty() {
            continue;
        }
        let is_of_size = |j: usize| singles[j].is_size_of(one) || names[j].iter().any(|name| name.character == 'Q');
        let is_like = |&j: &usize| !is_one[j] && singles[j].is_styled_as(one) && is_of_size(j);
        let like: Vec<usize> = (0..singles.len()).filter(is_like).collect();
        let named: Vec<usize> = like.iter().copied().filter(|&j| !names[j].is_empty()).collect();
        if named.len() as f32 >= NAMED * like.len() as f32 {
            run(&named, names).into_iter().for_each(|j| is_one[j] = true);
        }
    }
    is_one
}

/// The digit that a shape looks like most, or the capital.
fn name(names: &[Likeness], is_digit: bool) -> Option<char> {
    names.iter().map(|name| name.character).find(|name| name.is_ascii_digit() == is_digit)
}

/// Those of some letters that are in the longest run of characters, if that is long enough and there are no more of
/// each character than it has characters, and one: more are signs of a plot.
fn run(letters: &[usize], names: &[Vec<Likeness>]) -> Vec<usize> {
    let mut longest: Vec<(char, usize)> = Vec::new();
    for (step, fewest) in FEWEST {
        for first in (b'0'..=b'9').chain(b'A'..=b'Z') {
            let run = run_from(first, step, letters, names);
            let is_sure =
                run.iter().all(|&(character, of)| name(&names[of], character.is_ascii_digit()) == Some(character));
            let fewest = if is_sure { fewest } else { fewest + 1 };
            if run.len() >= fewest && run.len() > longest.len() {
                longest = run;
            }
        }
    }
    let (characters, longest): (Vec<char>, Vec<usize>) = longest.into_iter().unzip();
    let is_digit = characters.first().is_some_and(char::is_ascii_digit);
    let count = |of: char| letters.iter().filter(|&&letter| name(&names[letter], is_digit) == Some(of)).count();
    if characters.iter().any(|&character| count(character) > characters.len() + 1) {
        return Vec::new();
    }
    let is_named = |letter: usize| name(&names[letter], is_digit).is_some_and(|name| characters.contains(&name));
    letters.iter().copied().filter(|&letter| is_named(letter) || longest.contains(&letter)).collect()
}

/// Letters that look like one character and those that follow it, each the most like of those that are left.
fn run_from(first: u8, step: u8, letters: &[usize], names: &[Vec<Likeness>]) -> Vec<(char, usize)> {
    let last = if first.is_ascii_digit() { b'9' } else { b'Z' };
    let mut run: Vec<(char, usize)> = Vec::new();
    for character in (first..=last).step_by(usize::from(step)).map(char::from) {
        let off = |of: usize| names[of].iter().find(|name| name.character == character).map(|name| name.off);
        let left = letters.iter().filter(|letter| run.iter().all(|(_, other)| other != *letter));
        let alike = left.filter_map(|&letter| Some((off(letter)?, letter)));
        match alike.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))) {
            Some((_, next)) => run.push((character, next)),
            None if MAY_BE_MISSING.contains(&character) => {}
            None => break,
        }
    }
    run
}

#[cfg(test)]
mod tests;
