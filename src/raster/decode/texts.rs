//! The texts of a drawing. Letters as lines are squiggles under a finger, so texts are left out of the picture, and
//! kept as data.

use resvg::tiny_skia::{Pixmap, Transform};
use usvg::{BaselineShift, Group, Node, Text, TextAnchor, TextChunk, TextSpan, Tree};

use super::colour::one_line;
use crate::listing::{counted, first_few};
use crate::raster::vector::{DrawnText, PixelArea};
use crate::units::{PxPoint, Size};

/// The texts of a drawing which is rendered with `transform` at a size, in the order in which they are painted.
pub(super) fn of_tree(tree: &Tree, transform: Transform, size: Size) -> Vec<DrawnText> {
    let mut found = Vec::new();
    add_group(tree.root(), transform, size, &mut found);
    found
}

/// Most texts that are named in a remark.
const MOST_NAMED: usize = 5;

/// What is told of texts that are not seen.
pub(super) fn told_unseen(unseen: &[DrawnText]) -> Option<String> {
    let are = if unseen.len() == 1 { "is" } else { "are" };
    let names = first_few(unseen, MOST_NAMED, |text| format!("\"{}\"", short(&text.string)));
    let texts = counted(unseen.len(), "text");
    (!unseen.is_empty()).then(|| {
        format!(
            "{texts} that {are} not seen in the drawing (transparent, covered, or of the colour of the ground): {names}"
        )
    })
}

/// The beginning of a text from a drawing, on one line.
pub(super) fn short(text: &str) -> String {
    const LONGEST: usize = 60;
    let text = one_line(&text);
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text,
    }
}

/// Letters are seen where they change a value of 0 to 255 by more than this: as many as blending rounds off.
const SEEN: u8 = 3;

/// Whether letters are seen, by the drawing rendered with and without its texts: not those that are transparent,
/// covered, clipped, or of the colour of their ground.
pub(super) fn is_seen(text: &DrawnText, [with, without]: [&Pixmap; 2]) -> bool {
    let columns = text.min.x.max(0.0) as usize..(text.max.x.ceil() as usize).min(with.width() as usize);
    let rows = text.min.y.max(0.0) as usize..(text.max.y.ceil() as usize).min(with.height() as usize);
    let row = |pixmap: &Pixmap, y: usize| {
        let start = y * pixmap.width() as usize;
        4 * (start + columns.start)..4 * (start + columns.end)
    };
    let differs = |(a, b): (&u8, &u8)| a.abs_diff(*b) > SEEN;
    !columns.is_empty() && { rows }
        .any(|y| with.data()[row(with, y)].iter().zip(&without.data()[row(without, y)]).any(differs))
}

/// Texts of which some are lines of one sentence, as programs write them that know no paragraphs: the lines are one
/// text. One goes on with the other if it comes next, begins with a small letter right below a text that begins with a
/// capital, in letters of the same size, and one of them has several words. A list of single words is none.
pub(super) fn sentences(texts: Vec<DrawnText>) -> Vec<DrawnText> {
    let mut joined: Vec<DrawnText> = Vec::new();
    // the last line of the text that was last
    let mut line: Option<(PxPoint, PxPoint)> = None;
    for text in texts {
        let own = (text.min, text.max);
        match (joined.last_mut(), line) {
            (Some(last), Some(above)) if goes_on(last, above, &text) => {
                match last.string.strip_suffix('-') {
                    // of La Chaux-de-Fonds the hyphen is one of the name; of U-Bahn-Sta-tion the last is none
                    Some(_) if text.string.split(' ').next().is_some_and(|word| word.contains('-')) => {
                        last.string.push_str(&text.string);
                    }
                    Some(begun) => last.string = format!("{begun}{}", text.string),
                    None => last.string = format!("{} {}", last.string, text.string),
                }
                (last.min, last.max) = (last.min.min(text.min), last.max.max(text.max));
            }
            _ => joined.push(text),
        }
        line = Some(own);
    }
    joined
}

/// Lines of a paragraph are so far apart, in sizes of their font (the usual leading is 1.2).
pub(super) const LEADING: std::ops::RangeInclusive<f32> = 0.9..=1.45;
/// Their beginnings or their middles are in line within this, in sizes of their font.
pub(super) const IN_LINE: f32 = 0.35;

/// Whether a text goes on with the sentence of `text`, whose last line is `above` it.
fn goes_on(text: &DrawnText, (min, max): (PxPoint, PxPoint), next: &DrawnText) -> bool {
    let size = text.size.max(f32::MIN_POSITIVE);
    let is_alike = text.hidden == next.hidden
        && (next.size / size - 1.0).abs() < 0.05
        && text.angle.abs() < 1.0
        && next.angle.abs() < 1.0;
    let step = 0.5 * (next.min.y + next.max.y - min.y - max.y) / size;
    let middles = 0.5 * (next.min.x + next.max.x - min.x - max.x);
    let in_line = (next.min.x - min.x).abs().min(middles.abs()) <= IN_LINE * size;
    let begins = text.string.chars().next().is_some_and(char::is_uppercase);
    let is_ended = text.string.ends_with(['.', '!', '?', ':', ';']);
    let has_small = next.string.chars().next().is_some_and(char::is_lowercase);
    let has_words = text.string.contains(' ') || next.string.contains(' ') || text.string.ends_with('-');
    is_alike && LEADING.contains(&step) && in_line && begins && !is_ended && has_small && has_words
}

/// Whether a group has a text in it. (usvg 0.49 has such a question, but does not look into groups.)
pub(super) fn has_any(group: &Group) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => has_any(group),
        Node::Text(_) => true,
        Node::Path(_) | Node::Image(_) => false,
    })
}

fn add_group(group: &Group, transform: Transform, size: Size, found: &mut Vec<DrawnText>) {
    for node in group.children() {
        match node {
            Node::Group(group) => add_group(group, transform, size, found),
            Node::Text(text) => found.extend(drawn(text, transform, size)),
            Node::Path(_) | Node::Image(_) => {}
        }
    }
}

/// A text, if it has letters and a part of it is in the picture.
fn drawn(text: &Text, transform: Transform, size: Size) -> Option<DrawnText> {
    let letters = joined(&in_order(pieces(text)));
    let string = letters.split_whitespace().collect::<Vec<_>>().join(" ");
    let place = text.abs_bounding_box().transform(transform)?;
    let (min, max) = (PxPoint::new(place.left(), place.top()), PxPoint::new(place.right(), place.bottom()));
    let area = PixelArea { min, max };
    if string.is_empty() || !area.is_seen(size) {
        return None;
    }
    let to_pixels = transform.pre_concat(text.abs_transform());
    let turned = text.rotate().first().copied().unwrap_or(0.0);
    let largest = text.chunks().iter().flat_map(|chunk| chunk.spans()).map(|span| span.font_size().get());
    Some(DrawnText {
        string,
        min,
        max,
        angle: -to_pixels.ky.atan2(to_pixels.sx).to_degrees() - turned,
        size: largest.fold(0.0, f32::max) * to_pixels.kx.hypot(to_pixels.sy),
        hidden: false,
    })
}

/// A part of a text that has a place of its own, as programs write each sign of a formula.
struct Piece {
    text: String,
    /// Whether it goes on in the word of the last one, but for blanks that it has itself.
    goes_on: bool,
    /// Where it begins, if that is known.
    at: Option<Place>,
    /// Size of its font.
    size: f32,
    /// How far it stands above the line on which its part of the text begins.
    up: f32,
}

/// A place in a frame: 0 is that of the drawing, others are those of parts whose place in it is not known, such as
/// centred ones.
#[derive(Clone, Copy)]
struct Place {
    frame: usize,
    x: f32,
    y: f32,
}

/// The pieces of a text. In a row of places, one for each sign, the first alone has a height, and blanks are signs of
/// the row.
fn pieces(text: &Text) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    // how many signs came before, and at which height they end
    let (mut before, mut height) = (0_usize, None);
    for (frame, chunk) in (1..).zip(text.chunks()) {
        let level = chunk.y().or(height);
        let known = chunk.x().zip(level).filter(|_| chunk.anchor() == TextAnchor::Start);
        let place = known.map_or(Place { frame, x: 0.0, y: 0.0 }, |(x, y)| Place { frame: 0, x, y });
        let mut own = pieces_of(chunk, place, [text.dx(), text.dy()].map(|of| of.get(before..).unwrap_or_default()));
        if let Some(first) = own.first_mut() {
            first.goes_on = chunk.y().is_none() && pieces.last().is_some_and(|last| is_next(first, last));
            if !first.goes_on {
                first.text = first.text.trim_start().to_owned();
            }
        }
        pieces.extend(own);
        let signs = chunk.text().chars().count();
        height = level.map(|y| y + text.dy().iter().skip(before).take(signs).sum::<f32>());
        before += signs;
    }
    pieces
}

/// The pieces of a part of a text that begins at a place, and whose signs are shifted by so much each: spans that are
/// raised or lowered are pieces of their own. How far to the right they begin is guessed.
fn pieces_of(chunk: &TextChunk, place: Place, [dx, dy]: [&[f32]; 2]) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let first = dy.first().copied().unwrap_or(0.0);
    // where a span begins, but for its own shifts; how far above the line the last one ends; how many signs were before
    let (mut at, mut level, mut before) = (place, 0.0, 0);
    for span in chunk.spans() {
        let string = chunk.text().get(span.start()..span.end()).unwrap_or_default();
        let (signs, size, lift) = (string.chars().count(), span.font_size().get(), raised(span));
        let shift = |by: &[f32], count: usize| by.iter().skip(before).take(count).sum::<f32>();
        let y = at.y + shift(dy, 1) - lift;
        let up = place.y + first - y;
        let goes_on = !pieces.is_empty();
        match pieces.last_mut() {
            Some(last) if (up - level).abs() <= LEVEL * size => {
                // blanks between the elements of a file are of any size
                last.size = if last.text.trim().is_empty() { size } else { last.size };
                last.size = if string.trim().is_empty() { last.size } else { last.size.max(size) };
                last.text.push_str(string);
            }
            _ => {
                // what is moved back stands below or above another part
                let is_known = !goes_on || shift(dx, 1) >= 0.0;
                let at = is_known.then_some(Place { y, ..at });
                pieces.push(Piece { text: string.to_owned(), goes_on, at, size, up });
            }
        }
        at = Place { x: at.x + USUAL * size * signs as f32, y: at.y + shift(dy, signs), ..at };
        level = place.y + first - at.y + lift;
        before += signs;
    }
    pieces
}

/// How far a span is raised by its style. How far "super" and "sub" are is a matter of its font, and guessed.
fn raised(span: &TextSpan) -> f32 {
    let of = |shift: &BaselineShift| match shift {
        BaselineShift::Baseline => 0.0,
        BaselineShift::Subscript => -SHIFT * span.font_size().get(),
        BaselineShift::Superscript => SHIFT * span.font_size().get(),
        BaselineShift::Number(up) => *up,
    };
    span.baseline_shift().iter().map(of).sum()
}

/// Signs of a formula in the order in which they stand on their line: matplotlib writes those of one size and style
/// together. Not those of fractions, whose numbers would be mixed. Where blanks are signs too, no others are between
/// words.
fn in_order(mut pieces: Vec<Piece>) -> Vec<Piece> {
    if !is_formula(&pieces) {
        return pieces;
    }
    let x = |piece: &Piece| piece.at.map_or(0.0, |at| at.x);
    let mut sorted: Vec<&Piece> = pieces.iter().collect();
    sorted.sort_by(|a, b| x(a).total_cmp(&x(b)));
    if sorted.windows(2).any(|pair| above(pair[0], pair[1]).is_some()) {
        return pieces;
    }
    pieces.sort_by(|a, b| x(a).total_cmp(&x(b)));
    let is_blank = |piece: &Piece| piece.text.trim().is_empty();
    if pieces.iter().any(is_blank) {
        for i in 1..pieces.len() {
            let step = x(&pieces[i]) - x(&pieces[i - 1]);
            pieces[i].goes_on = !is_blank(&pieces[i - 1]) && step <= BROADEST * pieces[i - 1].size;
        }
    }
    pieces
}

/// Whether pieces are signs with a place each, beside one line, and some of them are small. Such signs of languages
/// that are written to the left have an order of their own.
fn is_formula(pieces: &[Piece]) -> bool {
    let Some(line) = pieces.iter().max_by(|a, b| a.size.total_cmp(&b.size)) else { return false };
    let to_left =
        |sign: char| matches!(sign, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{feff}');
    let is_sign = |piece: &Piece| {
        let text = piece.text.trim();
        piece.at.is_some_and(|at| at.frame == 0) && text.chars().count() <= 1 && !text.contains(to_left)
    };
    let is_beside = |piece: &Piece| from(line, piece).is_some_and(|(_, up)| up.abs() <= BESIDE_LINE * line.size);
    let is_small = |piece: &Piece| piece.size <= SMALL * line.size;
    pieces.iter().all(|piece| is_sign(piece) && is_beside(piece)) && pieces.iter().any(is_small)
}

/// How far the second of two pieces stands above the first, or below, if they are as large, and one is over the other
/// as the numbers of a fraction are.
fn above(first: &Piece, second: &Piece) -> Option<f32> {
    let (right, up) = from(first, second)?;
    let is_alike = (first.size - second.size).abs() <= 0.05 * first.size;
    let is_over = right.abs() <= BESIDE * first.size && OVER.contains(&(up.abs() / first.size));
    (is_alike && is_over).then_some(up)
}

/// Whether of a piece and those before and after it two are numbers of a fraction: over one another, and not an index
/// and then the power of a letter.
fn has_fraction(around: &[Piece], on_line: &Piece) -> bool {
    let has_letter = on_line.text.trim_end().ends_with(char::is_alphabetic);
    around.windows(2).any(|pair| above(&pair[0], &pair[1]).is_some_and(|up| up < 0.0 || !has_letter))
}

/// Whether a piece begins where the only sign of the last one ends.
fn is_next(piece: &Piece, last: &Piece) -> bool {
    let is_alike = (piece.size - last.size).abs() <= 0.05 * last.size;
    let is_near =
        |(right, up): (f32, f32)| right > 0.0 && right <= BROADEST * last.size && up.abs() <= LEVEL * last.size;
    last.text.chars().count() == 1 && is_alike && from(last, piece).is_some_and(is_near)
}

/// Above and below the line that letters stand on, in sizes of their font.
pub(super) const ASCENT: f64 = 0.75;
pub(super) const DESCENT: f64 = 0.22;

/// Two digits, or the point of a decimal and a digit, begin no farther apart where no space is between them, in sizes
/// of their font: digits are at most 0.64 wide, and with a space 0.75 at least, but in narrow fonts.
const DIGIT: f32 = 0.68;
const POINT: f32 = 0.45;
/// No sign is broader, in sizes of its font.
const BROADEST: f32 = 1.1;
/// A raised or lowered sign is as small as this beside those on the line, and stands so far off it, in sizes of these.
pub(super) const SMALL: f32 = 0.85;
pub(super) const OFF_LINE: f32 = 0.1;
/// No sign of a formula of one line stands farther off it, in sizes of the largest.
const BESIDE_LINE: f32 = 0.6;
/// What stands over another number begins no farther beside it, and its line is so far off, in sizes of their font.
const BESIDE: f32 = 0.45;
pub(super) const OVER: std::ops::RangeInclusive<f32> = 0.7..=2.0;
/// What is raised or lowered within a part of a text may be as large as that, if it stands so far off its line, in
/// sizes of their font.
const FAR_OFF_LINE: std::ops::RangeInclusive<f32> = 0.2..=0.6;
/// How far "super" and "sub" are off the line, in sizes of their font.
const SHIFT: f32 = 0.4;
/// A usual sign is so broad, in sizes of its font.
const USUAL: f32 = 0.5;
/// Signs of a row are level but for this, in sizes of their font.
const LEVEL: f32 = 0.01;

/// The pieces of a text as one: with a space between them, but for the digits of one number and what is raised or
/// lowered behind a sign, which has characters of its own. So "1", "0" and a small "3" above the line are 10 to the
/// power of 3, and not "1 0 3".
fn joined(pieces: &[Piece]) -> String {
    let mut all = String::new();
    // the last piece, and the last that stands on the line
    let mut before: Option<[&Piece; 2]> = None;
    for (i, piece) in pieces.iter().enumerate() {
        let around = &pieces[i.saturating_sub(1)..pieces.len().min(i + 2)];
        let base = before.filter(|[_, on_line]| !has_fraction(around, on_line));
        let is_alone = !around.windows(2).any(|pair| is_level(&pair[0], &pair[1]));
        let script = base.and_then(|[last, on_line]| script(piece, last, on_line, is_alone));
        let is_right_on = !piece.goes_on && before.is_some_and(|[last, on_line]| goes_right_on(piece, last, on_line));
        if script.is_some() || is_right_on {
            all.truncate(all.trim_end().len());
        } else if before.is_some() && !piece.goes_on {
            all.push(' ');
        }
        all.push_str(script.as_deref().unwrap_or(&piece.text));
        if script.is_some() && piece.text.ends_with(char::is_whitespace) {
            all.push(' ');
        }
        let on_line = before.filter(|_| script.is_some()).map_or(piece, |[_, on_line]| on_line);
        before = Some([piece, on_line]);
    }
    all
}

/// How far to the right and how far up a piece begins from another, if that is known.
fn from(other: &Piece, piece: &Piece) -> Option<(f32, f32)> {
    let (at, from) = (piece.at?, other.at?);
    (at.frame == from.frame).then_some((at.x - from.x, from.y - at.y))
}

/// Whether a piece stands on the line right behind the last one: both are of one number, or the last one is a raised or
/// lowered number.
fn goes_right_on(piece: &Piece, last: &Piece, on_line: &Piece) -> bool {
    let is_point = |text: &str| text == "." || text == ",";
    let is_digit = |text: &str| text.len() == 1 && text.chars().all(|sign| sign.is_ascii_digit());
    let is_script = !std::ptr::eq(last, on_line);
    let farthest = match (last.text.trim(), piece.text.trim()) {
        (last, own) if is_digit(last) && (is_script || is_digit(own) || is_point(own)) => DIGIT,
        (last, own) if is_point(last) && is_digit(own) => POINT,
        _ => return false,
    };
    let is_alike = (piece.size - on_line.size).abs() <= 0.05 * on_line.size;
    let is_near = from(last, piece).is_some_and(|(right, _)| (0.0..=farthest * last.size).contains(&right));
    is_alike && is_near && from(on_line, piece).is_some_and(|(_, up)| up.abs() <= OFF_LINE * on_line.size)
}

/// Whether two pieces of one size are on one line.
fn is_level(first: &Piece, second: &Piece) -> bool {
    let is_alike = (first.size - second.size).abs() <= 0.05 * first.size;
    is_alike && from(first, second).is_some_and(|(_, up)| up.abs() <= LEVEL * first.size)
}

/// A piece in raised or lowered characters, if it stands small above or below the line right behind the last one; as a
/// power if there are no such characters, and it is alone.
fn script(piece: &Piece, last: &Piece, on_line: &Piece, is_alone: bool) -> Option<String> {
    let (right, _) = from(last, piece)?;
    let (behind, up) = from(on_line, piece)?;
    let (own, widest) = (piece.text.trim(), BROADEST * last.size * last.text.trim().chars().count() as f32);
    let is_far = |up: f32| FAR_OFF_LINE.contains(&(up.abs() / piece.size));
    let is_moved_by_style = piece.size <= on_line.size && up * piece.up > 0.0 && is_far(up) && is_far(piece.up);
    // a small line below another one begins where that does
    let is_script = behind > 0.0
        && (is_moved_by_style || piece.size <= SMALL * on_line.size)
        && (0.0..=widest).contains(&right)
        && (OFF_LINE * on_line.size..=on_line.size).contains(&up.abs());
    let as_power = || power(own, &on_line.text).filter(|_| up > 0.0 && is_alone);
    is_script.then(|| scripted(own, up > 0.0).or_else(as_power))?
}

/// A power as it is typed, with a blank behind it, if it may be one of what a text ends in, a number or a letter by
/// itself: 2^n, which is not 2n, and 10^1.5, which is not 101.5. Other letters are those of ordinals and the like.
pub(super) fn power(own: &str, base: &str) -> Option<String> {
    let mut before = base.trim_end().chars().rev();
    let last = before.next()?;
    let is_letter = last.is_alphabetic() && before.next().is_none_or(|sign| !sign.is_alphabetic());
    // the usual ones; by its place alone a small a, e, h or m may be of a footnote, an ordinal or a unit as well
    let is_term = |sign: char| sign.is_ascii_digit() || "ktnxy.,".contains(sign);
    let is_sum = |sign: char| is_term(sign) || "+-\u{2212}".contains(sign);
    let is_power = !own.is_empty() && !own.starts_with(['.', ',']) && own.chars().all(is_sum);
    let is_known = is_power && (last.is_ascii_digit() || is_letter) && own.contains(char::is_alphanumeric);
    is_known.then(|| if own.chars().all(is_term) { format!("^{own} ") } else { format!("^({own}) ") })
}

/// A text in raised or lowered characters, if there are such.
pub(super) fn scripted(text: &str, is_raised: bool) -> Option<String> {
    let sign = |sign: char| {
        let (_, raised, lowered) = DIGITS.iter().chain(&SIGNS).find(|(own, ..)| *own == sign)?;
        Some(if is_raised { *raised } else { *lowered })
    };
    (!text.is_empty()).then(|| text.chars().map(sign).collect::<Option<_>>())?
}

/// Digits, raised and lowered.
const DIGITS: [(char, char, char); 10] = [
    ('0', '\u{2070}', '\u{2080}'),
    ('1', '\u{b9}', '\u{2081}'),
    ('2', '\u{b2}', '\u{2082}'),
    ('3', '\u{b3}', '\u{2083}'),
    ('4', '\u{2074}', '\u{2084}'),
    ('5', '\u{2075}', '\u{2085}'),
    ('6', '\u{2076}', '\u{2086}'),
    ('7', '\u{2077}', '\u{2087}'),
    ('8', '\u{2078}', '\u{2088}'),
    ('9', '\u{2079}', '\u{2089}'),
];

/// Signs, raised and lowered.
const SIGNS: [(char, char, char); 3] =
    [('\u{2212}', '\u{207b}', '\u{208b}'), ('-', '\u{207b}', '\u{208b}'), ('+', '\u{207a}', '\u{208a}')];

#[cfg(test)]
mod tests;
