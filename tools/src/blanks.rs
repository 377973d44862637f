//! Blanks between marks by a search of all pairs in 64 bits, on pages of random marks: what the distances of a check are
//! held against.

use tactograph::internals::page::{
    BrailleText, Class, Dots, Figure, Glyph, Line, Page, Parts, Run, Shape, Sign, TextRole, Texture,
};
use tactograph::internals::units::{MmPoint, MmRect, MmVector, Size};
use tactograph::{Checked, Error, Rule};

use crate::P;
use crate::rng::Rng;

/// A stroke, or a disc where both ends are one point: its middle line and half of its width, mm.
pub type Stroke = ((P, P), f64);

/// What is told is short of a limit by more than rounding, mm: by three halves of the last digit of a page.
const ROUNDING: f64 = 0.016;

fn wide(at: MmPoint) -> P {
    [at.x, at.y].map(f64::from)
}

fn to_segment(p: P, (a, b): (P, P)) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (a[0] + share * dx - p[0]).hypot(a[1] + share * dy - p[1])
}

/// The distance of two segments, mm; 0 where they cross.
fn distance(one: (P, P), other: (P, P)) -> f64 {
    let ((a, b), (c, d)) = (one, other);
    let side = |p: P, q: P, r: P| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let ends = [to_segment(a, other), to_segment(b, other), to_segment(c, one), to_segment(d, one)];
    ends.into_iter().fold(f64::MAX, f64::min)
}

/// All strokes of a line.
pub fn strokes(line: &Line) -> Vec<Stroke> {
    let of = |run: &Run| {
        let path: Vec<P> = run.path().map(wide).collect();
        let half = f64::from(run.width) / 2.0;
        path.windows(2).map(|pair| ((pair[0], pair[1]), half)).collect::<Vec<_>>()
    };
    line.runs.iter().flat_map(of).collect()
}

/// The sides of a rhombus, or the disc of a dot.
fn outline(glyph: &Glyph) -> Vec<Stroke> {
    let at = wide(glyph.at);
    match glyph.shape {
        Shape::Dot { diameter } => vec![((at, at), f64::from(diameter) / 2.0)],
        Shape::Rhombus { length, thickness, degrees } => {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let [along, across] = [length, thickness].map(|diagonal| f64::from(diagonal) / 2.0);
            // degrees are those of a reader, and y runs down
            let corner = |u: f64, v: f64| [at[0] + u * cos + v * sin, at[1] - u * sin + v * cos];
            let corners = [corner(along, 0.0), corner(0.0, across), corner(-along, 0.0), corner(0.0, -across)];
            (0..4).map(|i| ((corners[i], corners[(i + 1) % 4]), 0.0)).collect()
        }
    }
}

fn discs(dots: &Dots) -> Vec<Stroke> {
    dots.at.iter().map(|&at| ((wide(at), wide(at)), f64::from(dots.diameter) / 2.0)).collect()
}

/// The least blank between any of some strokes and any of others, mm; below 0 where they overlap. What lies wholly in a
/// rhombus is not found: the strokes of these pages are longer than their rhombuses.
pub fn least(some: &[Stroke], others: &[Stroke]) -> f64 {
    let pairs = some.iter().flat_map(|one| others.iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| distance(one.0, other.0) - one.1 - other.1).fold(f64::MAX, f64::min)
}

/// A line across a sheet of A4, from x = 20 to 128 mm in pieces of 3 mm and more, around `y`.
fn wave(y: f32, swing: f32, period: f32) -> Vec<MmPoint> {
    let at = |k: u8| {
        let x = 20.0 + 3.0 * f32::from(k);
        MmPoint::new(x, y + swing * (x / period).sin())
    };
    (0..=36).map(at).collect()
}

fn waves(rng: &mut Rng) -> Vec<Line> {
    let count = 3 + rng.below(7);
    let mut line = || {
        let (y, swing) = (rng.between_f32(40.0, 240.0), rng.between_f32(0.0, 5.0));
        let points = wave(y, swing, rng.between_f32(8.0, 30.0));
        Line { strength: 20.0, runs: vec![Run::stroke(rng.between_f32(0.75, 1.5), points)] }
    };
    (0..count).map(|_| line()).collect()
}

/// A place up to 7 mm above or below one of the lines.
fn beside(lines: &[Line], rng: &mut Rng) -> MmPoint {
    let points = &lines[rng.below(lines.len())].runs[0].points;
    let at = points[rng.below(points.len())];
    at + MmVector::new(rng.between_f32(-1.5, 1.5), rng.between_f32(-7.0, 7.0))
}

fn page(lines: Vec<Line>, textures: Vec<Texture>, braille: Vec<BrailleText>) -> Result<Page, Error> {
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(200.0, 287.0));
    let figure = Figure { place, source: Size::new(100, 100), textures, lines };
    Page::new(Parts { braille, ..Parts::of([210.0, 297.0], figure) })
}

/// Textures of a few rhombuses and dots beside waves, and of each texture the least blank to any line, mm.
///
/// # Errors
/// If a mark reaches beyond the sheet, which none does.
pub fn textures_beside_waves(seed: u64) -> Result<(Page, Vec<f64>), Error> {
    let mut rng = Rng::new(seed);
    let lines = waves(&mut rng);
    let mut glyph = || {
        let at = beside(&lines, &mut rng);
        let (length, thickness) = (rng.between_f32(1.0, 2.9), rng.between_f32(0.5, 1.5));
        let rhombus = Shape::Rhombus { length, thickness, degrees: rng.between_f32(0.0, 180.0) };
        Glyph { at, shape: if rng.coin() { rhombus } else { Shape::Dot { diameter: thickness } } }
    };
    let mut texture = || Texture {
        class: Class::Green,
        sign: Sign::Rhombus { degrees: 45.0 },
        colour: [0, 128, 0],
        area: 1000.0,
        glyphs: (0..3).map(|_| glyph()).collect(),
    };
    let textures: Vec<Texture> = (0..15).map(|_| texture()).collect();
    let all: Vec<Stroke> = lines.iter().flat_map(strokes).collect();
    let blank = |texture: &Texture| least(&texture.glyphs.iter().flat_map(outline).collect::<Vec<_>>(), &all);
    let blanks = textures.iter().map(blank).collect();
    Ok((page(lines, textures, Vec::new())?, blanks))
}

/// Words of four dots beside waves, and the least blank of each to each line and to each other word, mm.
///
/// # Errors
/// If a mark reaches beyond the sheet, which none does.
pub fn braille_beside_waves(seed: u64) -> Result<(Page, Vec<f64>), Error> {
    let mut rng = Rng::new(seed);
    let lines = waves(&mut rng);
    let mut text = |number: u32| {
        let at = beside(&lines, &mut rng);
        let dots = [(0.0, 0.0), (2.5, 0.0), (0.0, 2.5), (2.5, 5.0)].map(|(x, y)| at + MmVector::new(x, y));
        BrailleText {
            role: TextRole::Label,
            text: format!("word {number}"),
            language: "en".into(),
            abbreviation: None,
            lines: vec!["\u{281b}".into()],
            dots: Dots { diameter: 1.5, at: dots.to_vec() },
            leader: None,
        }
    };
    let braille: Vec<BrailleText> = (0..12).map(&mut text).collect();
    let words: Vec<Vec<Stroke>> = braille.iter().map(|text| discs(&text.dots)).collect();
    let all: Vec<Vec<Stroke>> = lines.iter().map(strokes).collect();
    let blanks = |(number, word): (usize, &Vec<Stroke>)| {
        let others = all.iter().chain(&words[..number]);
        others.map(|other| least(word, other)).collect::<Vec<_>>()
    };
    let blanks = words.iter().enumerate().flat_map(blanks).collect();
    Ok((page(lines, Vec::new(), braille)?, blanks))
}

/// A line that goes across the sheet as a wave, turns far from it, and comes back below as another wave, with the least
/// blank between the way there and the way back, mm.
pub fn there_and_back(seed: u64) -> (Line, f64) {
    let mut rng = Rng::new(seed);
    let (swing, period) = (rng.between_f32(0.0, 4.0), rng.between_f32(8.0, 30.0));
    let out = wave(100.0, swing, period);
    let mut back = wave(100.0 + rng.between_f32(2.0, 6.0), swing + rng.between_f32(-0.7, 0.7), period);
    back.reverse();
    let [from, to] = [out[out.len() - 1], back[0]];
    let turn = vec![from, MmPoint::new(160.0, 55.0), MmPoint::new(190.0, 100.0), MmPoint::new(160.0, 150.0), to];
    let [one, other] = [0, 1].map(|_| rng.between_f32(0.75, 1.5));
    let run = |(width, points): (f32, Vec<MmPoint>)| Run::stroke(width, points);
    let line = Line { strength: 20.0, runs: Vec::from([(one, out), (one, turn), (other, back)].map(run)) };
    let of = |number: usize| strokes(&Line { strength: 20.0, runs: vec![line.runs[number].clone()] });
    // the turn begins and ends beside the waves
    let turn = of(1);
    let (there, back) = ([of(0), turn[..1].to_vec()].concat(), [of(2), turn[turn.len() - 1..].to_vec()].concat());
    let blank = least(&there, &back);
    (line, blank)
}

/// How many blanks a check tells by a rule, and how far the worst of them is off those that are known, mm; infinitely
/// where it does not tell one that is too little, or tells one that there is not.
pub fn off(checked: &Checked, rule: &str, mut known: Vec<f64>) -> (usize, f64) {
    let of_rule = checked.findings.iter().filter(|finding| finding.rule.id == rule);
    let mut told: Vec<f64> = of_rule.filter_map(|finding| finding.measured).map(f64::from).collect();
    let rule = Rule::all().iter().find(|of_all| of_all.id == rule);
    let limit = rule.and_then(|rule| checked.limit(rule)).map_or(f64::INFINITY, |(least, _)| f64::from(least));
    told.sort_by(f64::total_cmp);
    known.sort_by(f64::total_cmp);
    let is_missed = known.get(told.len()).is_some_and(|blank| *blank < limit - ROUNDING);
    if is_missed || told.len() > known.len() {
        return (told.len(), f64::INFINITY);
    }
    let worst = told.iter().zip(&known).map(|(told, known)| (told - known).abs()).fold(0.0, f64::max);
    (told.len(), worst)
}
