//! Single letters and digits at even steps, as at an axis: in a row or a column, of one size, and unlike one another.

use super::chain::RotatedLetter;
use super::limits::LetterLength;
use super::line::TextLine;
use crate::geom::order::middle;

/// They stand on one line, or one above the other, but for this.
const OFF: LetterLength = LetterLength::new(0.12, 1.0);
/// Their heights differ by at most this.
const HEIGHTS: LetterLength = LetterLength::new(0.1, 1.0);
/// From the middle of one to that of the next are at least so many heights, and at most so many: closer ones are the
/// letters of a word.
const STEP: [f32; 2] = [1.3, 30.0];
/// A step is the usual one, or two or three of it, but for this.
const UNEVEN: LetterLength = LetterLength::new(0.15, 1.5);
const MOST_STEPS: f32 = 3.0;
/// Least share of steps that are: between the axes of two charts there is another one.
const EVEN: f32 = 0.7;
/// They are so many at least.
const FEWEST: usize = 3;

/// A length of a text, by which letters are compared.
type Measure<'a> = &'a dyn Fn(&TextLine) -> f32;

/// Which of some single letters stand at even steps beside others that are `unlike`, all at one angle.
pub(super) fn at_even_steps(singles: &[TextLine], unlike: impl Fn(&[RotatedLetter]) -> bool) -> Vec<bool> {
    let mut is_one = vec![false; singles.len()];
    let level = |line: &TextLine| line.across[1];
    let starts = |line: &TextLine| line.along[0];
    let middles = |line: &TextLine| 0.5 * (line.along[0] + line.along[1]);
    let ends = |line: &TextLine| line.along[1];
    let heights = |line: &TextLine| 0.5 * (line.across[0] + line.across[1]);
    let lined: [(Measure<'_>, Measure<'_>); 4] =
        [(&level, &middles), (&starts, &heights), (&middles, &heights), (&ends, &heights)];
    for (key, place) in lined {
        let mut sorted: Vec<usize> = (0..singles.len()).collect();
        sorted.sort_by(|&a, &b| key(&singles[a]).total_cmp(&key(&singles[b])).then(a.cmp(&b)));
        let mut from = 0;
        for &i in &sorted {
            if is_one[i] {
                continue;
            }
            let (at, height) = (key(&singles[i]), singles[i].height);
            let off = OFF.of(height);
            from += sorted[from..].iter().take_while(|&&j| key(&singles[j]) < at - off).count();
            let near = sorted[from..].iter().copied().take_while(|&j| key(&singles[j]) <= at + off);
            let of_height = |&j: &usize| (singles[j].height - height).abs() <= HEIGHTS.of(height);
            let mut row: Vec<usize> = near.filter(of_height).collect();
            row.sort_by(|&a, &b| place(&singles[a]).total_cmp(&place(&singles[b])).then(a.cmp(&b)));
            let run = run_around(&row, i, |j| place(&singles[j]), height);
            let letters: Vec<RotatedLetter> = run.iter().map(|&j| singles[j].letters[0]).collect();
            let places: Vec<f32> = run.iter().map(|&j| place(&singles[j])).collect();
            if run.len() >= FEWEST && are_even(&places, height) && unlike(&letters) {
                run.iter().for_each(|&j| is_one[j] = true);
            }
        }
    }
    is_one
}

/// The part of a row around one of it that has no gap.
fn run_around(row: &[usize], one: usize, place: impl Fn(usize) -> f32, height: f32) -> &[usize] {
    let goes_on = |a: &usize, b: &usize| (STEP[0]..=STEP[1]).contains(&((place(*b) - place(*a)) / height));
    row.chunk_by(goes_on).find(|run| run.contains(&one)).unwrap_or_default()
}

/// Whether places in their order are at even steps.
fn are_even(places: &[f32], height: f32) -> bool {
    let steps: Vec<f32> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let usual = middle(steps.clone());
    let is_even = |step: &&f32| {
        let count = (*step / usual).round().clamp(1.0, MOST_STEPS);
        (*step - count * usual).abs() <= UNEVEN.of(height)
    };
    steps.iter().filter(is_even).count() as f32 >= EVEN * steps.len() as f32
}
