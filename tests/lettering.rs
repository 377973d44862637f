//! Text in the pixels of a picture is left out, and what looks like it is not.

use tactograph::{Drawing, Note, Options, Picture, Profile};
use tactograph_tools::bitmap;
use tactograph_tools::drawn::{Point, share_near};

/// Letters of 5 x 7 pixels.
const LETTERS: [(char, [&str; 7]); 13] = [
    ('A', [" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"]),
    ('E', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"]),
    ('I', [" ### ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "]),
    ('L', ["#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"]),
    ('M', ["#   #", "## ##", "# # #", "# # #", "#   #", "#   #", "#   #"]),
    ('N', ["#   #", "##  #", "# # #", "#  ##", "#   #", "#   #", "#   #"]),
    ('P', ["#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "]),
    ('R', ["#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"]),
    ('S', [" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "]),
    ('0', [" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "]),
    ('1', ["  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "]),
    ('2', [" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####"]),
    ('5', ["#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "]),
];
const WIDTH: usize = 600;
const HEIGHT: usize = 400;

/// A drawing in black on white, row by row.
struct Canvas(Vec<bool>);

impl Canvas {
    fn new() -> Self {
        Self(vec![false; WIDTH * HEIGHT])
    }

    fn bar(&mut self, x: usize, y: usize, width: usize, height: usize) {
        for row in y..y + height {
            self.0[row * WIDTH + x..row * WIDTH + x + width].fill(true);
        }
    }

    /// Writes a text with pixels of `scale`, its top left corner at a place.
    fn text(&mut self, text: &str, [x, y]: [usize; 2], scale: usize) {
        for (i, letter) in text.chars().enumerate() {
            let (_, rows) = LETTERS.iter().find(|(known, _)| *known == letter).expect("a known letter");
            for (row, pixels) in rows.iter().enumerate() {
                for (column, _) in pixels.chars().enumerate().filter(|(_, pixel)| *pixel == '#') {
                    self.bar(x + (6 * i + column) * scale, y + row * scale, scale, scale);
                }
            }
        }
    }

    fn frame(&mut self, x: usize, y: usize, width: usize, height: usize) {
        self.bar(x, y, width, 2);
        self.bar(x, y + height - 2, width, 2);
        self.bar(x, y, 2, height);
        self.bar(x + width - 2, y, 2, height);
    }

    /// Axes with ticks, and a bar.
    fn chart() -> Self {
        let mut canvas = Self::new();
        canvas.bar(100, 60, 2, 280);
        canvas.bar(100, 340, 460, 2);
        (0..3).for_each(|i| canvas.bar(90, 120 + 80 * i, 10, 2));
        canvas.frame(220, 160, 90, 181);
        canvas.frame(400, 220, 90, 121);
        canvas
    }

    fn labelled_chart() -> Self {
        let mut canvas = Self::chart();
        canvas.text("RAINLESS", [220, 20], 3);
        canvas.text("ARE", [240, 356], 2);
        canvas.text("APRIL", [415, 356], 2);
        canvas.text("150", [50, 114], 2);
        canvas.text("100", [50, 194], 2);
        canvas.text("5", [74, 274], 2);
        canvas
    }

    fn drawing(&self, keep_text: bool) -> Drawing {
        let grey = |i: usize| if self.0[i] { 20 } else { 255 };
        converted([WIDTH, HEIGHT], grey, &Options::new(profile()).keep_text(keep_text))
    }
}

/// A chart with six texts, as PNG.
pub(crate) fn labelled_chart() -> Vec<u8> {
    let pixels: Vec<u8> = Canvas::labelled_chart().0.iter().map(|ink| if *ink { 20 } else { 255 }).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&pixels).expect("the pixels");
    writer.finish().expect("the end");
    bytes
}

/// The page of a picture in greys.
fn converted([width, height]: [usize; 2], grey: impl Fn(usize) -> u8, options: &Options) -> Drawing {
    let pixels: Vec<u8> = (0..width * height).flat_map(|i| [grey(i), grey(i), grey(i), 255]).collect();
    let picture = Picture::rgba8(width as u32, height as u32, &pixels).expect("a picture");
    tactograph::convert(picture, options).expect("a page")
}

fn profile() -> Profile {
    Profile::named("swell-a4").expect("a profile")
}

fn lines(drawing: &Drawing) -> Vec<Vec<Point>> {
    let runs = drawing.page.figure.lines.iter().flat_map(|line| &line.runs);
    let points = |run: &tactograph::marks::Run| {
        let points = run.points.iter().chain(run.points.first().filter(|_| run.closed));
        points.map(|at| [f64::from(at.x), f64::from(at.y)]).collect()
    };
    runs.map(points).collect()
}

/// How much of what one drawing has the other has too, and the other way round.
fn same(a: &Drawing, b: &Drawing) -> [f64; 2] {
    let share = |a: &Drawing, b: &Drawing| share_near(&lines(a), &lines(b)).expect("lines");
    [share(a, b), share(b, a)]
}

fn is_told(drawing: &Drawing) -> Option<(usize, &'static str)> {
    drawing.notes.iter().find_map(|note| match note {
        Note::LetteringLeftOut { texts, place, .. } => Some((*texts, *place)),
        _ => None,
    })
}

#[test]
fn a_chart_without_its_letters_is_the_chart() {
    let (bare, labelled) = (Canvas::chart().drawing(false), Canvas::labelled_chart().drawing(false));
    let [there, no_more] = same(&bare, &labelled);
    assert!(there > 0.99 && no_more > 0.99, "{there} {no_more} {:?}", labelled.texts);
    assert_eq!((is_told(&labelled), is_told(&bare)), (Some((6, "upper middle")), None));
    assert_eq!((bare.texts.len(), labelled.texts.len()), (0, 6));
    assert!(labelled.page.overview.is_some(), "the overview is drawn");
    let told = labelled.notes.iter().map(ToString::to_string).find(|note| note.contains("texts left out"));
    let wanted =
        "6 texts left out, the largest in the upper middle, as fingers cannot read letters; keep the text to draw them";
    assert_eq!(told.as_deref(), Some(wanted));
}

/// Whoever reads gets a picture of each text, and the words are its string; a reader that gives too few is told.
#[test]
fn a_reader_gives_words_to_the_texts() {
    type Reader = fn(&[Vec<u8>]) -> Result<Vec<String>, String>;
    let read = |chart: &[u8], reader: Reader| {
        tactograph::convert(chart, &Options::new(profile()).text_reader(reader)).expect("a page")
    };
    let chart = labelled_chart();
    let drawing = read(&chart, |lines| {
        let size = |line: &Vec<u8>| -> String {
            let info = png::Decoder::new(std::io::Cursor::new(line)).read_info().expect("a PNG").info().size();
            format!(" {}\n x ", info.0 / info.1)
        };
        Ok(lines.iter().map(size).collect())
    });
    let mut texts: Vec<&str> = drawing.texts.iter().map(|text| text.string.as_str()).collect();
    texts.sort_unstable();
    // as wide as their letters are many: 1, 3, 3, 3, 5 and 8
    assert_eq!(texts, ["0 x", "1 x", "1 x", "1 x", "2 x", "3 x"]);
    assert!(drawing.notes.iter().any(|note| matches!(note, Note::TextsLeftOut(texts) if texts.len() == 6)));
    let drawing = read(&chart, |_| Ok(vec!["one".to_owned()]));
    let told = Note::TextsNotRead("6 texts were given to be read, and 1 came back".to_owned());
    assert!(drawing.notes.contains(&told) && is_told(&drawing).is_some(), "{:?}", drawing.notes);
}

#[test]
fn places_and_sizes_of_texts_are_kept() {
    let drawing = Canvas::labelled_chart().drawing(false);
    let place = drawing.page.figure.place;
    let mm = f64::from(place.width()) / WIDTH as f64;
    let title = drawing.texts.iter().max_by(|a, b| a.size.total_cmp(&b.size)).expect("texts");
    assert_eq!((title.string.as_str(), title.hidden), ("", false));
    assert!(title.angle.abs() < 1.0, "{title:?}");
    let on_sheet = |x: f64, y: f64| [f64::from(place.min.x) + mm * x, f64::from(place.min.y) + mm * y];
    let ([left, top], [right, bottom]) = (on_sheet(220.0, 20.0), on_sheet(361.0, 41.0));
    let found = [title.place.min.x, title.place.min.y, title.place.max.x, title.place.max.y].map(f64::from);
    for (found, wanted) in found.into_iter().zip([left, top, right, bottom]) {
        assert!((found - wanted).abs() < 3.0 * mm, "{title:?}");
    }
    assert!((f64::from(title.size) / mm - 1.6 * 21.0).abs() < 4.0, "{title:?}");
}

#[test]
fn letters_are_drawn_where_they_are_to_be_kept() {
    let (bare, kept) = (Canvas::chart().drawing(true), Canvas::labelled_chart().drawing(true));
    assert!(kept.texts.is_empty() && is_told(&kept).is_none());
    let [_, beside] = same(&bare, &kept);
    assert!(beside < 0.9, "letters are lines");
}

/// Rows of things that are no letters: dots, dashes, dashes and dots, ticks, windows, bricks.
#[test]
fn rows_of_other_things_are_no_text() {
    let mut canvas = Canvas::new();
    (0..20).for_each(|i| canvas.bar(40 + 24 * i, 40, 6, 6));
    (0..16).for_each(|i| canvas.bar(40 + 32 * i, 70, 18, 3));
    (0..10).for_each(|i| {
        canvas.bar(40 + 52 * i, 95, 24, 3);
        canvas.bar(75 + 52 * i, 95, 4, 3);
    });
    (0..40)
        .for_each(|i| canvas.bar(40 + 13 * i, if i % 5 == 0 { 115 } else { 123 }, 2, if i % 5 == 0 { 20 } else { 12 }));
    for i in 0..12 {
        canvas.frame(40 + 44 * i, 160, 24, 36);
        canvas.bar(40 + 44 * i, 174, 24, 2);
        canvas.bar(51 + 44 * i, 160, 2, 36);
    }
    for row in 0..6 {
        (0..9).for_each(|i| canvas.frame(40 + 52 * i + 26 * (row % 2), 230 + 22 * row, 46, 16));
    }
    let (drawing, kept) = (canvas.drawing(false), canvas.drawing(true));
    assert_eq!((drawing.texts.len(), is_told(&drawing)), (0, None));
    assert_eq!(lines(&drawing), lines(&kept));
}

/// Crescents are shown by a disc over a disc: none of the paths is one.
#[test]
fn phases_of_the_moon_are_no_text() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 400'><rect width='900' height='400' \
                   fill='#fff'/><circle cx='450' cy='230' r='120' fill='none' stroke='#000' stroke-width='6'/>"
        .to_owned();
    for i in 0..8 {
        let x = 120 + 90 * i;
        let over = x + 4 * i - 14;
        svg +=
            &format!("<circle cx='{x}' cy='60' r='16' fill='#000'/><circle cx='{over}' cy='60' r='16' fill='#fff'/>");
    }
    svg += "</svg>";
    let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
    let drawing = tactograph::convert(svg.as_bytes(), &options).expect("a page");
    assert_eq!(drawing.texts, []);
}

#[test]
fn ticks_of_a_clock_are_no_text() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 500'><rect width='500' height='500' \
                   fill='#fff'/><g stroke='#000' fill='none'><circle cx='250' cy='250' r='220' stroke-width='6'/>"
        .to_owned();
    for minute in 0..60 {
        let (y, x) = (6.0 * f64::from(minute)).to_radians().sin_cos();
        let (inner, width) = if minute % 5 == 0 { (190.0, 5) } else { (205.0, 2) };
        let at = |radius: f64| format!("{:.1} {:.1}", 250.0 + radius * x, 250.0 + radius * y);
        svg += &format!("<path d='M{}L{}' stroke-width='{width}'/>", at(inner), at(218.0));
    }
    svg += "</g></svg>";
    let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
    let drawing = tactograph::convert(svg.as_bytes(), &options).expect("a page");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    assert!(!told.iter().any(|note| note.contains("as fingers cannot read letters")), "{told:?}");
}

/// The first curve of a common plotting program is blue. In a plane of colour pixels that it covers in part differ
/// more from white than those that it covers whole.
#[test]
fn a_thin_blue_curve_is_no_text() {
    let mut points = String::new();
    for i in 0..=100 {
        let along = f64::from(i) / 100.0;
        let (x, y) = (112.0 + 698.0 * along, 312.0 - 200.0 * (std::f64::consts::TAU * along).sin());
        points += &format!("{x:.2},{y:.2} ");
    }
    let curve = bitmap::png(
        &format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='618'><rect width='900' height='618' \
             fill='#fff'/><polyline points='{points}' fill='none' stroke='#1f77b4' stroke-width='2.08'/></svg>"
        ),
        900,
    )
    .expect("a picture");
    let drawing = tactograph::convert(&curve[..], &Options::new(profile())).expect("a page");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    assert!(!told.iter().any(|note| note.contains("letters")), "{told:?}");
    let lengths: Vec<f32> = drawing.page.figure.lines.iter().map(tactograph::marks::Line::length).collect();
    assert_eq!(lengths.len(), 1, "{lengths:?}");
}

/// The same picture in white on black, and one where text stands upright.
#[test]
fn light_letters_and_letters_that_stand_upright_are_text() {
    let canvas = Canvas::labelled_chart();
    let options = Options::new(profile());
    let light = converted([WIDTH, HEIGHT], |i| if canvas.0[i] { 240 } else { 10 }, &options);
    assert_eq!(light.texts.len(), 6, "{:?}", light.texts);
    let turned = |i: usize| canvas.0[(i % HEIGHT) * WIDTH + WIDTH - 1 - i / HEIGHT];
    let upright = converted([HEIGHT, WIDTH], |i| if turned(i) { 20 } else { 255 }, &options);
    assert!(upright.texts.len() >= 4, "{:?}", upright.texts);
    assert!(upright.texts.iter().all(|text| (text.angle - 90.0).abs() < 2.0), "{:?}", upright.texts);
}

#[test]
fn no_text_is_looked_for_in_a_picture_of_lines() {
    // four small rings look like letters
    const RINGS: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'>\
        <rect width='900' height='600' fill='#fff'/><g fill='none' stroke='#000' stroke-width='14'>\
        <circle cx='150' cy='300' r='45'/><circle cx='350' cy='300' r='45'/><circle cx='550' cy='300' r='45'/>\
        <circle cx='750' cy='300' r='45'/></g></svg>";
    let rings = bitmap::png(RINGS, 900).expect("a picture");
    let options = Options::new(profile()).lines(rings).expect("a picture of lines");
    let drawing = converted([900, 600], |i| if i == 0 { 254 } else { 255 }, &options);
    assert!(drawing.notes.iter().all(|note| !note.to_string().contains("text")), "{:?}", drawing.notes);
    let lines = &drawing.page.figure.lines;
    assert_eq!(lines.iter().filter(|line| line.runs.iter().all(|run| run.closed)).count(), 4, "{lines:?}");
}

/// The arm of a person may be taken for a text: then there is one, or there are two.
#[test]
fn of_few_texts_is_said_that_they_may_be_none() {
    let note = |texts: usize, are_shapes: bool| Note::LetteringLeftOut { texts, place: "middle", are_shapes };
    let told = |texts: usize| note(texts, false).to_string();
    let wanted =
        "1 text left out, in the middle, as fingers cannot read letters; keep the text to draw it, or if it is none";
    assert_eq!(told(1), wanted);
    assert!(told(2).ends_with("draw them, or if one of them is none"), "{}", told(2));
    assert!(told(3).ends_with("draw them"), "{}", told(3));
    // a chart whose letters are paths can be saved with text
    let shapes = note(3, true).to_string();
    assert!(shapes.contains("letters; for braille save the drawing with its text as text"), "{shapes}");
    assert!(shapes.contains("svg.fonttype none") && shapes.ends_with("), or keep the text to draw them"), "{shapes}");
}
