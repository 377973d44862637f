//! Names of places in two lines, as programs write them that know no paragraphs: "Saint" and "Gallen" beside the sign
//! of one town are one text.

use super::texts::{IN_LINE, LEADING};
use crate::raster::vector::{DrawnText, PixelArea, VectorDrawing};
use crate::units::PxPoint;

/// With more pairs of texts that may be the lines of names, none is looked at: for each, all texts and paths of the
/// drawing are. They are more labels than a page takes.
const MOST_PAIRS: usize = 300;
/// Most letters of a line of a name.
const LONGEST: usize = 24;
/// The sign of a place is so large at most, and so small at least, in sizes of the font.
const SIGN: std::ops::RangeInclusive<f32> = 0.15..=1.2;
/// Its sides differ by so much at most, as shares.
const ROUND: f32 = 0.2;
/// Paths whose middles are no farther apart, in sizes of the font, are of one sign.
const SAME: f32 = 0.1;
/// It stands so near to its name, in sizes of the font, and no other sign within twice that.
const NEAR: f32 = 1.2;
/// A text above or below that is so near, in sizes of the font, is of the same list.
const IN_LIST: f32 = 1.8;
/// What is longer than this, in sizes of the font, is neither a sign nor a sample of a legend.
const LONGEST_SAMPLE: f32 = 3.0;

/// Texts of which two lines that name one place are one. `drawing` has the signs of places; it is not asked where no
/// texts stand as such lines.
pub(super) fn joined(texts: Vec<DrawnText>, drawing: impl FnOnce() -> Option<VectorDrawing>) -> Vec<DrawnText> {
    let mut pairs: Vec<usize> = (1..texts.len()).filter(|&next| are_lines(&texts[next - 1], &texts[next])).collect();
    let Some(drawing) = (1..=MOST_PAIRS).contains(&pairs.len()).then(drawing).flatten() else { return texts };
    let seconds = pairs.clone();
    // three lines are a list
    pairs.retain(|next| !seconds.contains(&(next - 1)) && !seconds.contains(&(next + 1)));
    pairs.retain(|&next| name_one(&texts, next, &drawing));
    let mut all: Vec<DrawnText> = Vec::with_capacity(texts.len());
    for (number, text) in texts.into_iter().enumerate() {
        match all.last_mut().filter(|_| pairs.contains(&number)) {
            Some(first) => {
                let between = if first.string.ends_with('-') { "" } else { " " };
                first.string = format!("{}{between}{}", first.string, text.string);
                (first.min, first.max) = (first.min.min(text.min), first.max.max(text.max));
            }
            None => all.push(text),
        }
    }
    all
}

/// Whether two texts could be the lines of one name: words in letters of one size, the second right below the first.
fn are_lines(first: &DrawnText, second: &DrawnText) -> bool {
    let is_word = |text: &DrawnText| {
        let is_level = !text.hidden && text.angle.abs() < 1.0;
        let is_of_letters = text.string.starts_with(char::is_alphabetic) && !text.string.contains(is_of_others);
        is_level && is_of_letters && text.string.chars().count() <= LONGEST
    };
    let size = first.size.max(f32::MIN_POSITIVE);
    let step = (middle(second).y - middle(first).y) / size;
    let off = [second.min.x - first.min.x, second.max.x - first.max.x];
    let off = off.into_iter().chain([0.5 * (off[0] + off[1])]).map(f32::abs).fold(f32::INFINITY, f32::min);
    let is_alike = (second.size / size - 1.0).abs() < 0.05;
    let begins = first.string.starts_with(char::is_uppercase) && is_in_capitals(first) == is_in_capitals(second);
    is_word(first) && is_word(second) && is_alike && begins && LEADING.contains(&step) && off <= IN_LINE * size
}

/// Whether a text is in capitals only, as the name of a country above that of a town.
fn is_in_capitals(text: &DrawnText) -> bool {
    text.string.chars().count() > 1 && !text.string.contains(char::is_lowercase)
}

/// What no line of a name has: digits, and what ends a sentence or stands in formulas.
fn is_of_others(sign: char) -> bool {
    !(sign.is_alphabetic() || matches!(sign, ' ' | '-' | '\'' | '\u{2019}' | '.'))
}

/// Whether the texts before this number and at it name one place: one sign stands beside them, nearer than to any other
/// text, and no other sign or line of a list is near.
fn name_one(texts: &[DrawnText], next: usize, drawing: &VectorDrawing) -> bool {
    let (first, second) = (&texts[next - 1], &texts[next]);
    let (size, middles) = (first.size, [middle(first).y, middle(second).y]);
    let name = PixelArea { min: first.min.min(second.min), max: first.max.max(second.max) };
    let Some(sign) = only_sign_near(&name, size, drawing) else { return false };
    let own = gap(sign, &name);
    let others = || texts.iter().enumerate().filter(|(other, _)| *other != next && *other + 1 != next);
    let is_of_list = |text: &DrawnText| {
        let is_near = middles.iter().any(|of| (middle(text).y - of).abs() <= IN_LIST * size);
        is_near && text.min.x < name.max.x && text.max.x > name.min.x
    };
    let is_apart = |text: &DrawnText| gap(sign, &PixelArea { min: text.min, max: text.max }) > own && !is_of_list(text);
    0.0 < own && own <= NEAR * size && others().all(|(_, text)| is_apart(text))
}

/// The middle of the only small path near to a name, if that is as wide as high; a disc and its outline are one. In a
/// legend a sample of a line, which is flat, stands below a point.
fn only_sign_near(name: &PixelArea, size: f32, drawing: &VectorDrawing) -> Option<PxPoint> {
    let mut found: Option<PxPoint> = None;
    for painted in &drawing.paths {
        let bounds = painted.path.bounds();
        let (width, height) = (bounds.width(), bounds.height());
        let at = PxPoint::new(bounds.left() + 0.5 * width, bounds.top() + 0.5 * height);
        let is_round = (width - height).abs() <= ROUND * width.max(height);
        if width.max(height) > LONGEST_SAMPLE * size || gap(at, name) > 2.0 * NEAR * size {
            continue;
        }
        let is_sign = is_round && SIGN.contains(&(width.max(height) / size));
        if !is_sign || found.is_some_and(|other| (other - at).length() > SAME * size) {
            return None;
        }
        found = Some(at);
    }
    found
}

/// How far a point is from a box, px.
fn gap(at: PxPoint, of: &PixelArea) -> f32 {
    (at - at.clamp(of.min, of.max)).length()
}

fn middle(text: &DrawnText) -> PxPoint {
    text.min.lerp(text.max, 0.5)
}

#[cfg(test)]
mod tests;
