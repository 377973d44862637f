//! Capital letters as strokes, for the few words on a map: the library has no fonts.

use resvg::tiny_skia::{Color, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, Transform};

/// Width and height of a letter in its own units, and the distance to the next letter.
const WIDE: f32 = 4.0;
const HIGH: f32 = 6.0;
const STEP: f32 = 5.4;

/// The strokes of a letter: polylines of points from 00 (top left) to 46 (bottom right), column before row.
fn strokes(letter: char) -> &'static [&'static str] {
    match letter {
        'A' => &["06 20 46", "14 34"],
        'B' => &["00 06 36 45 44 33 03", "00 30 41 42 33"],
        'C' => &["41 30 10 01 05 16 36 45"],
        'D' => &["00 06 26 44 42 20 00"],
        'E' => &["40 00 06 46", "03 33"],
        'G' => &["41 30 10 01 05 16 36 45 43 23"],
        'J' => &["40 45 36 16 05"],
        'K' => &["00 06", "40 03 46"],
        'L' => &["00 06 46"],
        'N' => &["06 00 46 40"],
        'O' => &["10 30 41 45 36 16 05 01 10"],
        'R' => &["06 00 30 41 42 33 03", "23 46"],
        'T' => &["00 40", "20 26"],
        'U' => &["00 05 16 36 45 40"],
        'W' => &["00 16 22 36 40"],
        'Y' => &["00 23 40", "23 26"],
        _ => &[], // a blank; the test below asks for strokes of every letter in the names of classes
    }
}

fn outline(word: &str) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (number, letter) in word.chars().enumerate() {
        for stroke in strokes(letter) {
            for (at, point) in stroke.split(' ').enumerate() {
                let [x, y] = [0, 1].map(|k| point.as_bytes().get(k).map_or(0.0, |digit| f32::from(digit - b'0')));
                let x = x + STEP * number as f32;
                if at == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
        }
    }
    path.finish()
}

/// Width of a word whose letters are `height` pixels high.
pub(super) fn width(word: &str, height: f32) -> f32 {
    (STEP * (word.chars().count().max(1) - 1) as f32 + WIDE) * height / HIGH
}

/// Writes a word in black on a white box, its middle at (x, y) pixels.
pub(super) fn write(canvas: &mut Pixmap, word: &str, (x, y): (f32, f32), height: f32) {
    let scale = height / HIGH;
    let (left, top) = (x - 0.5 * width(word, height), y - 0.5 * height);
    let pad = 0.35 * height;
    let mut paint = Paint::default();
    paint.set_color(Color::WHITE);
    if let Some(back) = Rect::from_xywh(left - pad, top - pad, width(word, height) + 2.0 * pad, height + 2.0 * pad) {
        canvas.fill_rect(back, &paint, Transform::identity(), None);
    }
    paint.set_color(Color::BLACK);
    paint.anti_alias = true;
    let pen = Stroke { width: 0.9, line_cap: LineCap::Round, line_join: LineJoin::Round, ..Stroke::default() };
    if let Some(path) = outline(word) {
        let place = Transform::from_row(scale, 0.0, 0.0, scale, left, top);
        canvas.stroke_path(&path, &paint, &pen, place, None);
    }
}

#[cfg(test)]
mod tests;
