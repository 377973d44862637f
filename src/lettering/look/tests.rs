//! What letters in pixels look like, and what only looks like them.

use super::*;
use crate::raster::Raster;
use crate::units::Size;

const SIZE: Size = Size { width: 320, height: 120 };

/// Letters of 5 x 7 pixels.
const LETTERS: [(char, [&str; 7]); 8] = [
    ('A', [" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"]),
    ('E', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"]),
    ('N', ["#   #", "##  #", "# # #", "#  ##", "#   #", "#   #", "#   #"]),
    ('P', ["#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "]),
    ('Q', [" ### ", "#   #", "#   #", "#   #", "# # #", "#  # ", " ## #"]),
    ('R', ["#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"]),
    ('S', [" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "]),
    ('5', ["#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "]),
];
/// Side of a pixel of a letter, px.
const SCALE: usize = 3;

/// A picture of ink and paper, each by its light.
struct Sheet {
    is_ink: Vec<bool>,
}

impl Sheet {
    fn of(texts: &[(&str, [usize; 2])]) -> Self {
        Self::of_scale(SCALE, texts)
    }

    fn of_scale(scale: usize, texts: &[(&str, [usize; 2])]) -> Self {
        let mut sheet = Self { is_ink: vec![false; SIZE.len()] };
        for (text, [left, top]) in texts {
            for (i, letter) in text.chars().enumerate() {
                let (_, rows) = LETTERS.iter().find(|(known, _)| *known == letter).expect("a known letter");
                for (y, row) in rows.iter().enumerate() {
                    for (x, _) in row.chars().enumerate().filter(|(_, pixel)| *pixel == '#') {
                        sheet.bar([left + (6 * i + x) * scale, top + y * scale], [scale, scale]);
                    }
                }
            }
        }
        sheet
    }

    fn bar(&mut self, [left, top]: [usize; 2], [width, height]: [usize; 2]) {
        for row in top..top + height {
            self.is_ink[row * SIZE.width as usize + left..][..width].fill(true);
        }
    }

    /// Looks for text that is darker or lighter than its ground, in a picture of ink and paper of this light, and
    /// gives what `of` makes of it; none if nothing thin is there.
    fn look<T>(
        &self,
        [ink, paper]: [f32; 2],
        polarity: Polarity,
        strict: Strictness,
        of: impl FnOnce(&Look, &Colours<'_>) -> T,
    ) -> Option<T> {
        let light = self.is_ink.iter().map(|is_ink| if *is_ink { ink } else { paper }).collect();
        let raster = Raster::grey(SIZE, light);
        let colours = Colours::new(&raster, strict == Strictness::Drawing);
        let plane = &colours.planes[0];
        Look::new((plane, &Levels::of(plane)), polarity, &colours, strict).map(|look| of(&look, &colours))
    }

    /// How many single letters are text beside the words of five letters of a drawing.
    fn singles(&self) -> Option<usize> {
        self.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, |look, colours| {
            let words: Vec<TextLine> = look.lines(colours).into_iter().filter(|line| line.letters.len() == 5).collect();
            look.in_style(colours, &words).iter().filter(|line| line.letters.len() == 1).count()
        })
    }

    /// How many letters each line of dark text in a drawing has.
    fn letters(&self) -> Vec<usize> {
        let lines = |look: &Look, colours: &Colours<'_>| look.lines(colours);
        let lines = self.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, lines).unwrap_or_default();
        lines.iter().map(|line| line.letters.len()).collect()
    }
}

#[test]
fn a_word_is_one_line_with_all_its_letters() {
    assert_eq!(Sheet::of(&[("SPARE", [40, 40])]).letters(), [5]);
    assert_eq!(Sheet::of(&[("SPARE", [40, 20]), ("NEAR", [160, 80])]).letters().iter().sum::<usize>(), 9);
    assert_eq!(Sheet::of(&[]).letters(), [0_usize; 0]);
}

#[test]
fn light_text_is_seen_by_the_look_for_light_things_only() {
    let sheet = Sheet::of(&[("SPARE", [40, 40])]);
    let count =
        |polarity| sheet.look([1.0, 0.0], polarity, Strictness::Drawing, |look, colours| look.lines(colours).len());
    assert_eq!(count(Polarity::Above), Some(1));
    assert_eq!(count(Polarity::Below).unwrap_or(0), 0);
}

#[test]
fn a_digit_alone_is_text_only_beside_others_of_its_style() {
    let sheet = Sheet::of(&[("SPARE", [40, 40]), ("5", [200, 40])]);
    let found = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, |look, colours| {
        let words: Vec<TextLine> = look.lines(colours).into_iter().filter(|line| line.letters.len() == 5).collect();
        let alone =
            |others: &[TextLine]| look.in_style(colours, others).iter().filter(|line| line.letters.len() == 1).count();
        (words.len(), alone(&words), alone(&[]))
    });
    assert_eq!(found, Some((1, 1, 0)));
}

#[test]
fn single_letters_at_even_steps_are_text_if_they_are_unlike() {
    let count = |texts: [(&str, [usize; 2]); 3]| {
        let mut sheet = Sheet::of(&[&[("SPARE", [190, 8])][..], &texts[..]].concat());
        // a tick leads to each
        texts.iter().for_each(|(_, [left, top])| sheet.bar([left + 7, top - 15], [2, 9]));
        sheet.singles()
    };
    assert_eq!(count([("A", [16, 80]), ("N", [80, 80]), ("5", [144, 80])]), Some(3));
    assert_eq!(count([("A", [16, 80]), ("N", [60, 80]), ("5", [144, 80])]), Some(0), "uneven");
    assert_eq!(count([("A", [16, 80]), ("N", [80, 60]), ("5", [144, 80])]), Some(0), "in no row");
    assert_eq!(count([("E", [16, 80]), ("E", [80, 80]), ("E", [144, 80])]), Some(0), "alike");
}

#[test]
fn small_letters_anywhere_are_text_if_they_are_several_and_unlike() {
    let count =
        |texts: &[(&str, [usize; 2])]| Sheet::of_scale(2, &[&[("SPARE", [10, 8])][..], texts].concat()).singles();
    let [a, n, five] = [("A", [180, 48]), ("N", [260, 90]), ("5", [120, 70])];
    assert_eq!(count(&[a, n, five]), Some(3));
    assert_eq!(count(&[a, n]), Some(0), "two");
    assert_eq!(count(&[("E", a.1), ("E", n.1), ("E", five.1)]), Some(0), "alike");
}

#[test]
fn a_digit_twice_is_a_number_beside_text() {
    let pairs = |pair: &str| {
        let sheet = Sheet::of(&[("SPARE", [40, 40]), (pair, [200, 40])]);
        let found = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, |look, colours| {
            let words: Vec<TextLine> = look.lines(colours).into_iter().filter(|line| line.letters.len() == 5).collect();
            look.in_style(colours, &words).iter().filter(|line| line.letters.len() == 2).count()
        });
        found.expect("something thin")
    };
    assert_eq!(["55", "5E", "EE"].map(pairs), [1, 1, 0]);
}

#[test]
fn letters_that_follow_one_another_are_text_without_any_other() {
    let count = |texts: &[(&str, [usize; 2])], frame: usize| {
        let mut sheet = Sheet::of(texts);
        // a line around each, so many px from it
        for [left, top] in texts.iter().map(|(_, at)| *at).filter(|_| frame > 0) {
            let (width, height) = (15 + 2 * frame, 21 + 2 * frame);
            sheet.bar([left - frame, top - frame], [width, 2]);
            sheet.bar([left - frame, top + 19 + frame], [width, 2]);
            sheet.bar([left - frame, top - frame], [2, height]);
            sheet.bar([left + 13 + frame, top - frame], [2, height]);
        }
        let found = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, |look, colours| {
            (look.lines(colours).len(), look.in_succession(colours, &[]).len())
        });
        found.expect("something thin")
    };
    let [p, q, r] = [("P", [30, 80]), ("Q", [140, 30]), ("R", [250, 70])];
    assert_eq!(count(&[p, q, r], 0), (0, 3));
    assert_eq!(count(&[p, q, r], 14), (0, 3), "in cells");
    assert_eq!(count(&[p, q, r], 6), (0, 0), "in windows");
    assert_eq!(count(&[p, q], 0), (0, 0), "two");
    assert_eq!(count(&[p, ("N", q.1), ("5", r.1)], 0), (0, 0), "others");
}

#[test]
fn pieces_of_larger_shapes_are_no_letters_that_follow_one_another() {
    let texts = [("P", [30, 20]), ("Q", [140, 10]), ("R", [250, 30])];
    // a bar leads on below each, so many px from it
    let count = |gap: usize, long: usize| {
        let mut sheet = Sheet::of(&texts);
        texts.iter().for_each(|(_, [left, top])| sheet.bar([*left, top + 21 + gap], [3, long]));
        let found = |look: &Look, colours: &Colours<'_>| look.in_succession(colours, &[]).len();
        sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, found).expect("something thin")
    };
    assert_eq!(count(2, 40), 0);
    assert_eq!(count(5, 40), 3, "apart");
    assert_eq!(count(2, 12), 3, "a tick");
}

#[test]
fn a_number_with_a_decimal_point_is_one_line() {
    // its digits are 15 px apart there, and 21 px high
    let number = |rest: &str, point: Option<[usize; 2]>| {
        let mut sheet = Sheet::of(&[("5", [40, 40]), (rest, [70, 40])]);
        if let Some(at) = point {
            sheet.bar(at, [3, 3]);
        }
        sheet.letters()
    };
    assert_eq!((number("AE", Some([61, 58])), number("A", Some([61, 58]))), (vec![3], vec![2]));
    for no_point in [None, Some([61, 48])] {
        assert!(number("AE", no_point).iter().all(|letters| *letters < 3), "{no_point:?}");
        assert_eq!(number("A", no_point), [0_usize; 0], "{no_point:?}");
    }
}

#[test]
fn a_minus_before_a_number_is_part_of_it() {
    let start = |bar: [usize; 2], sides: [usize; 2]| {
        let mut sheet = Sheet::of(&[("5AE", [60, 40])]);
        sheet.bar(bar, sides);
        let lines = |look: &Look, colours: &Colours<'_>| look.lines(colours);
        let lines = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, lines).unwrap_or_default();
        lines.first().map(|line| line.along[0].round() as i32)
    };
    assert_eq!(start([42, 49], [12, 3]), Some(42));
    assert_eq!(start([20, 49], [12, 3]), Some(60), "too far");
    assert_eq!(start([42, 58], [12, 3]), Some(60), "at the foot");
    assert_eq!(start([14, 49], [40, 3]), Some(60), "too long");
}

#[test]
fn bars_side_by_side_are_no_text() {
    let mut bars = Sheet::of(&[]);
    (0..8).for_each(|i| bars.bar([40 + 24 * i, 40], [4, 30]));
    assert_eq!(bars.letters(), [0_usize; 0]);
}

#[test]
fn hatching_around_a_word_is_clutter() {
    let mut hatched = Sheet::of(&[("SPARE", [40, 40])]);
    for row in (22..100).step_by(6) {
        // between the rows of pixels of letters, too
        hatched.bar([20, row], [140, 2]);
    }
    assert_eq!(hatched.letters(), [0_usize; 0]);
}

#[test]
fn in_a_photograph_pale_letters_are_not_looked_at() {
    let sheet = Sheet::of(&[("SPARE", [40, 40])]);
    let count = |ink: f32, strict: Strictness| {
        let count = |look: &Look, _: &Colours<'_>| look.letters.len();
        sheet.look([ink, 0.5], Polarity::Below, strict, count).unwrap_or(0)
    };
    // 0.3 is darker than 0.5 by 15 of 100 of lightness, 0.05 by 50
    assert_eq!([0.3, 0.05].map(|ink| count(ink, Strictness::Drawing)), [5, 5]);
    assert_eq!([0.3, 0.05].map(|ink| count(ink, Strictness::Photograph)), [0, 5]);
}

#[test]
fn the_cells_of_a_line_are_those_of_its_letters() {
    let mut sheet = Sheet::of(&[("SPARE", [40, 40])]);
    let ink = sheet.is_ink.iter().filter(|is_ink| **is_ink).count() as f32;
    sheet.bar([10, 100], [300, 3]);
    let cells =
        |look: &Look, colours: &Colours<'_>| look.lines(colours).iter().map(|line| look.cells(line).len()).sum();
    let cells: Option<usize> = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, cells);
    let cells = cells.expect("something thin") as f32;
    assert!((cells / ink - 1.0).abs() < 0.1, "{cells} cells of {ink}");
}
