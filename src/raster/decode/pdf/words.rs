//! Letters on a page are joined into texts by their places: a document does not say where a word or a line ends.

use hayro_interpret::kurbo::{Point, Rect, Vec2};
use resvg::tiny_skia::Transform;

use super::super::texts::{self, ASCENT, DESCENT, power, scripted, sentences};
use crate::raster::vector::DrawnText;
use crate::units::{PxPoint, Size};

/// CSS pixels for a point, in which PDF measures.
pub(super) const PX_PER_POINT: f32 = 96.0 / 72.0;

/// Widest gap inside a word, in font sizes. Spaces between words are 0.22 (set close by TeX) to 0.6.
const IN_WORD: f64 = 0.19;

/// Widest gap between words of one text, in font sizes; beyond it stands another column or label.
const BETWEEN_WORDS: f64 = 1.5;

/// How far a letter may reach back into the one before it, in font sizes: accents and kerning do.
const BACK: f64 = 0.5;

/// The same of a raised or lowered number, and of what stands behind it.
const BACK_OFF_LINE: f64 = 0.2;

/// How far letters of one text may stand above or below its line, in font sizes.
const OFF_LINE: f64 = 0.2;

/// How much larger or smaller letters of one text may be.
const OTHER_SIZE: f64 = 1.15;

/// A letter on the page, in points from the top left.
pub(super) struct Letter {
    /// Which it is, if that is known.
    pub(super) string: Option<String>,
    /// Where it begins on the line that it stands on.
    pub(super) from: Point,
    /// Where the next may begin.
    pub(super) to: Point,
    /// From the line up, as long as the font size.
    pub(super) up: Vec2,
    /// In the direction of reading, as long as the font size.
    pub(super) along: Vec2,
    /// Whether it is not painted, as the letters behind a scanned picture are not.
    pub(super) hidden: bool,
}

/// A text on the page, in points from the top left.
#[derive(Debug, Clone)]
pub(super) struct Written {
    string: String,
    place: Rect,
    up: Vec2,
    along: Vec2,
    /// Where its first letter begins.
    from: Point,
    /// Where its last letter ends.
    end: Point,
    /// If raised or lowered numbers are at its end, where they begin, in its string and on its line.
    script: Option<(usize, Point)>,
    hidden: bool,
}

/// Texts as they grow.
#[derive(Default)]
pub(super) struct Texts {
    done: Vec<Written>,
    unknown: usize,
    /// Whether a space was written after the last letter.
    spaced: bool,
    /// Whether the next letter may belong to the last text.
    open: bool,
}

impl Texts {
    /// Adds a letter where a part of it lies in the box that is seen.
    pub(super) fn add(&mut self, letter: Letter, seen: Option<Rect>) {
        let place = place(&letter);
        let is_finite = place.is_finite() && letter.up.is_finite() && letter.along.is_finite();
        if !is_finite || seen.is_none_or(|seen| !is_seen(place, seen)) {
            self.open = false;
            return;
        }
        let Some(string) = letter.string.as_deref() else {
            self.unknown += usize::from(!letter.hidden);
            return;
        };
        if string.chars().all(char::is_whitespace) {
            self.space(&letter);
        } else if let Some(gap) = self.gap(&letter).filter(|gap| *gap <= BETWEEN_WORDS)
            && let Some(last) = self.done.last_mut()
        {
            if self.spaced || gap > IN_WORD {
                last.string.push(' ');
            }
            last.string.push_str(string);
            last.place = last.place.union(place);
            last.end = letter.to;
            self.spaced = false;
        } else {
            self.done.push(Written {
                string: string.to_owned(),
                place,
                up: letter.up,
                along: letter.along,
                from: letter.from,
                end: letter.to,
                script: None,
                hidden: letter.hidden,
            });
            (self.spaced, self.open) = (false, true);
        }
    }

    fn space(&mut self, letter: &Letter) {
        if self.gap(letter).is_some_and(|gap| gap <= BETWEEN_WORDS)
            && let Some(last) = self.done.last_mut()
        {
            last.end = letter.to;
            self.spaced = true;
        }
    }

    /// How far behind the last text a letter stands, in font sizes; none if it stands on another line or is of another
    /// size or direction.
    fn gap(&self, letter: &Letter) -> Option<f64> {
        let last = self.done.last().filter(|_| self.open)?;
        let (size, own) = (last.up.hypot(), letter.up.hypot());
        let alike = size > 0.0 && own > 0.0 && (own / size).max(size / own) <= OTHER_SIZE;
        let along = last.along.normalize();
        if !alike || is_turned(last.along, letter.along) || last.hidden != letter.hidden {
            return None;
        }
        let step = letter.from - last.end;
        let gap = along.dot(step) / size;
        (along.cross(step).abs() <= OFF_LINE * size && gap >= -BACK).then_some(gap)
    }

    /// The texts in their order, and how many letters are not known.
    pub(super) fn finish(self) -> (Vec<Written>, usize) {
        (with_scripts(&self.done), self.unknown)
    }
}

/// Texts with what is raised or lowered right behind them, in characters of its own, and with what goes on there.
fn with_scripts(texts: &[Written]) -> Vec<Written> {
    let mut all: Vec<Written> = Vec::new();
    for (i, text) in texts.iter().enumerate() {
        let around = &texts[i.saturating_sub(1)..texts.len().min(i + 2)];
        let is_over = around.windows(2).any(|pair| pair[0].is_over(&pair[1]));
        let is_joined = all.last_mut().is_some_and(|last| last.add_script(text, is_over) || last.go_on(text));
        if !is_joined {
            all.push(text.clone());
        }
    }
    all
}

impl Written {
    /// How far a point is from another one, along the line and above it, in font sizes.
    fn step(&self, from: Point, to: Point) -> (f64, f64) {
        let (along, step, size) = (self.along.normalize(), to - from, self.up.hypot());
        (along.dot(step) / size, along.cross(step) * along.cross(self.up).signum() / size)
    }

    /// How large another text is beside this one, if both are painted in one direction: sizes of letters behind a
    /// scanned picture are guessed.
    fn size_of(&self, other: &Self) -> Option<f64> {
        let is_painted = !self.hidden && !other.hidden && self.up.hypot() > 0.0;
        (is_painted && !is_turned(self.along, other.along)).then(|| other.up.hypot() / self.up.hypot())
    }

    /// Whether this text and another one of its size stand over one another, as the numbers of a fraction do.
    fn is_over(&self, other: &Self) -> bool {
        let (begin, up) = self.step(self.from, other.from);
        let (own, end) = (self.step(self.from, self.end).0, self.step(self.from, other.end).0);
        let is_alike = self.size_of(other).is_some_and(|size| size.max(size.recip()) <= OTHER_SIZE);
        let common = own.min(end) - begin.max(0.0);
        is_alike && common > 0.5 * own.min(end - begin) && texts::OVER.contains(&(up.abs() as f32))
    }

    /// Adds a text that is a raised or lowered number right behind this one, and says whether it is. An index and a
    /// power of a letter may be over one another; over one another behind a number are those of a fraction.
    fn add_script(&mut self, next: &Self, is_over: bool) -> bool {
        let is_behind = |end: Point| (-BACK_OFF_LINE..=IN_WORD).contains(&self.step(end, next.from).0);
        let off_line = f64::from(texts::OFF_LINE)..=1.0;
        let up = self.step(self.end, next.from).1;
        let is_small = self.size_of(next).is_some_and(|size| size <= f64::from(texts::SMALL));
        let (base, end) = self.script.filter(|_| is_over).unwrap_or((self.string.len(), self.end));
        let is_of_letter = self.string[..base].ends_with(char::is_alphabetic);
        let is_script = is_small && off_line.contains(&up.abs()) && is_behind(end) && (is_of_letter || !is_over);
        let has_number = next.string.contains(|sign: char| sign.is_ascii_digit());
        let as_power = || power(&next.string, &self.string).filter(|_| up > 0.0 && self.script.is_none());
        let own = scripted(&next.string, up > 0.0).filter(|_| has_number).or_else(as_power);
        let Some(own) = own.filter(|_| is_script) else { return false };
        // an index is written before the power that is over it
        let at = if up > 0.0 { self.string.len() } else { base };
        self.string.insert_str(at, &own);
        self.script = Some((base, end));
        self.place = self.place.union(next.place);
        let further = self.step(self.end, next.end).0.max(0.0);
        self.end += self.along.normalize() * (further * self.up.hypot());
        true
    }

    /// Adds a text that goes on with this one behind a raised or lowered number, and says whether it does.
    fn go_on(&mut self, next: &Self) -> bool {
        let (gap, up) = self.step(self.end, next.from);
        let is_alike = self.size_of(next).is_some_and(|size| size.max(size.recip()) <= OTHER_SIZE);
        let is_near = up.abs() <= OFF_LINE && (-BACK_OFF_LINE..=BETWEEN_WORDS).contains(&gap);
        if self.script.is_none() || !is_alike || !is_near {
            return false;
        }
        if gap > IN_WORD {
            self.string.push(' ');
        }
        self.string.push_str(&next.string);
        self.place = self.place.union(next.place);
        (self.end, self.script) = (next.end, None);
        true
    }
}

/// Whether two directions of reading are not the same.
fn is_turned(along: Vec2, other: Vec2) -> bool {
    let along = along.normalize();
    along.cross(other.normalize()).abs() > 0.02 || along.dot(other) < 0.0
}

fn is_seen(place: Rect, seen: Rect) -> bool {
    place.x0 < seen.x1 && place.y0 < seen.y1 && place.x1 > seen.x0 && place.y1 > seen.y0
}

/// The box around a letter.
fn place(letter: &Letter) -> Rect {
    let (above, below) = (letter.up * ASCENT, letter.up * -DESCENT);
    let around = Rect::from_points(letter.from + above, letter.to + below);
    around.union(Rect::from_points(letter.from + below, letter.to + above))
}

/// The texts that are seen on a canvas of a size, which shows a drawing in CSS pixels with `transform`.
pub(super) fn on_canvas(texts: &[Written], transform: Transform, size: Size) -> Vec<DrawnText> {
    let transform = transform.pre_scale(PX_PER_POINT, PX_PER_POINT);
    let canvas = Rect::new(0.0, 0.0, f64::from(size.width), f64::from(size.height));
    let at = |point: Point| {
        let mut at = resvg::tiny_skia::Point::from_xy(point.x as f32, point.y as f32);
        transform.map_point(&mut at);
        PxPoint::new(at.x, at.y)
    };
    let drawn = |text: &Written| {
        let (min, max) = (at(Point::new(text.place.x0, text.place.y0)), at(Point::new(text.place.x1, text.place.y1)));
        let place = Rect::new(f64::from(min.x), f64::from(min.y), f64::from(max.x), f64::from(max.y));
        is_seen(place, canvas).then(|| DrawnText {
            string: text.string.split_whitespace().collect::<Vec<_>>().join(" "),
            min,
            max,
            angle: -text.along.atan2().to_degrees() as f32,
            size: text.up.hypot() as f32 * transform.sy.hypot(transform.kx),
            hidden: text.hidden,
        })
    };
    sentences(texts.iter().filter_map(drawn).collect())
}

#[cfg(test)]
mod tests;
