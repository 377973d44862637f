//! Charts, maps, signs and worksheets with text, and what is taken for text most easily: dots, dashes, windows, leaves,
//! ticks, bricks. Every scene is 900 x 600 px.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use tactograph_tools::rng::Rng;

use crate::picture::{Fault, fonts};

/// Width of a scene, px.
pub(crate) const WIDTH: u32 = 900;
/// Its height.
pub(crate) const HEIGHT: u32 = 600;

/// Fonts of Debian: sans, serif, monospaced, narrow, round.
pub(crate) const FONTS: [&str; 10] = [
    "DejaVu Sans",
    "DejaVu Serif",
    "Liberation Sans",
    "Liberation Serif",
    "Liberation Mono",
    "Lato",
    "Open Sans",
    "EB Garamond",
    "Comfortaa",
    "Noto Sans",
];

/// Words of labels, from short to long.
const WORDS: [&str; 36] = [
    "Ob",
    "Rhine",
    "Apple",
    "Mon",
    "Tue",
    "North",
    "Plum",
    "2019",
    "Bern",
    "Lake",
    "Kiwi",
    "Hafen",
    "Harbour",
    "Zürich",
    "Nucleus",
    "Pear tree",
    "Castle",
    "Membrane",
    "Grey heron",
    "Old town",
    "Åre",
    "Évry",
    "Station",
    "Rain in mm",
    "Wasserturm",
    "Chloroplast",
    "Market square",
    "Temperature",
    "Favourite fruit",
    "River crossing",
    "No entry",
    "Population in millions",
    "Beware of the dog",
    "Number of pupils",
    "Figure 3: the water cycle",
    "Write the names in the boxes",
];

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// Axes with ticks and numbers, bars with names, a title.
    Chart,
    /// Areas, towns as dots with names, a road as a dashed line.
    Map,
    /// A board with a frame and two lines, an arrow.
    Sign,
    /// Lines of text beside a house.
    Worksheet,
    /// Dots in rows and dots scattered.
    Dots,
    /// Dashed and dash-dotted lines, straight and curved.
    Dashes,
    /// A front with windows, each with a cross.
    Windows,
    /// A branch with leaves.
    Leaves,
    /// A ruler with long and short ticks.
    Ticks,
    /// A wall of bricks.
    Bricks,
}

impl Kind {
    pub(crate) const ALL: [Self; 10] = [
        Self::Chart,
        Self::Map,
        Self::Sign,
        Self::Worksheet,
        Self::Dots,
        Self::Dashes,
        Self::Windows,
        Self::Leaves,
        Self::Ticks,
        Self::Bricks,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Chart => "chart",
            Self::Map => "map",
            Self::Sign => "sign",
            Self::Worksheet => "worksheet",
            Self::Dots => "dots",
            Self::Dashes => "dashes",
            Self::Windows => "windows",
            Self::Leaves => "leaves",
            Self::Ticks => "ticks",
            Self::Bricks => "bricks",
        }
    }
}

/// What lies behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ground {
    /// White.
    Plain,
    /// One colour, light or dark.
    Coloured,
    /// A photograph.
    Photo,
}

impl Ground {
    pub(crate) const ALL: [Self; 3] = [Self::Plain, Self::Coloured, Self::Photo];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Coloured => "coloured",
            Self::Photo => "photo",
        }
    }
}

/// One scene to be drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Task {
    pub(crate) kind: Kind,
    pub(crate) ground: Ground,
    /// Size of the font, px.
    pub(crate) size: u32,
    /// Whether labels that can be are slanted.
    pub(crate) slanted: bool,
    pub(crate) seed: u64,
}

impl Task {
    /// Its name in lists and of files.
    pub(crate) fn name(&self) -> String {
        let Self { kind, ground, size, slanted, seed } = self;
        let direction = if *slanted { "aslant" } else { "level" };
        format!("{}-{}-{size}px-{direction}-{seed}", kind.name(), ground.name())
    }
}

/// A text as it stands in a scene.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrueText {
    start: [f64; 2],
    end: [f64; 2],
    /// Degrees counter-clockwise.
    pub(crate) angle: f64,
}

impl TrueText {
    /// Points along its middle, as close as its letters.
    pub(crate) fn along(&self) -> Vec<[f64; 2]> {
        const COUNT: i32 = 24;
        let share = |i: i32| (f64::from(i) + 0.5) / f64::from(COUNT);
        let at = |share: f64| [0, 1].map(|axis| self.start[axis] + share * (self.end[axis] - self.start[axis]));
        (0..COUNT).map(share).map(at).collect()
    }
}

/// A scene: layers as SVG without a root.
pub(crate) struct Scene<'a> {
    ground: String,
    things: String,
    texts: String,
    ink: String,
    rng: Rng,
    task: Task,
    font: String,
    /// Lightness of the photograph behind, 0..=1, at a point.
    behind: Option<&'a dyn Fn([f64; 2]) -> f64>,
}

impl<'a> Scene<'a> {
    /// Draws a scene. `behind` tells how light the photograph behind is, where there is one: texts are black or white,
    /// whichever is better seen.
    pub(crate) fn new(task: Task, behind: Option<&'a dyn Fn([f64; 2]) -> f64>) -> Self {
        let Task { kind, ground, size, slanted, seed } = task;
        let place = (u64::from(size) << 8) | ((kind as u64) << 1) | u64::from(slanted);
        let mut rng = Rng::new(seed.wrapping_mul(0x9e37_79b9) ^ (place << 24) ^ ((ground as u64) << 50));
        let font = FONTS[((seed as usize) * 3 + size as usize + kind as usize) % FONTS.len()];
        let style = ["", "", "font-weight=\"bold\"", "font-style=\"italic\""][rng.below(4)];
        let dark = rng.between(0.0, 60.0) as u8;
        let (back, ink) = match ground {
            Ground::Plain => ("#fff".to_owned(), format!("#{dark:02x}{dark:02x}{dark:02x}")),
            Ground::Coloured if rng.coin() => (pastel(&mut rng), format!("#{dark:02x}{dark:02x}40")),
            Ground::Coloured => (deep(&mut rng), "#fffbe8".to_owned()),
            Ground::Photo => (String::new(), if rng.coin() { "#fff" } else { "#000" }.to_owned()),
        };
        let rect = format!("<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"{back}\"/>");
        let mut scene = Self {
            ground: if back.is_empty() { String::new() } else { rect },
            things: String::new(),
            texts: String::new(),
            ink,
            rng,
            task,
            font: format!("font-family=\"{font}\" {style}"),
            behind,
        };
        match kind {
            Kind::Chart => scene.chart(),
            Kind::Map => scene.map(),
            Kind::Sign => scene.sign(),
            Kind::Worksheet => scene.worksheet(),
            Kind::Dots => scene.dots(),
            Kind::Dashes => scene.dashes(),
            Kind::Windows => scene.windows(),
            Kind::Leaves => scene.leaves(),
            Kind::Ticks => scene.ticks(),
            Kind::Bricks => scene.bricks(),
        }
        scene
    }

    /// The scene as SVG, with its things and with its texts or without.
    pub(crate) fn svg(&self, things: bool, texts: bool) -> String {
        let layer = |layer: &str, on: bool| if on { layer.to_owned() } else { String::new() };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\">{}{}{}</svg>",
            self.ground,
            layer(&self.things, things),
            layer(&self.texts, texts)
        )
    }

    /// Where its texts stand, by the letters that are drawn.
    pub(crate) fn texts(&self) -> Result<Vec<TrueText>, Fault> {
        let options = usvg::Options { fontdb: fonts(), ..usvg::Options::default() };
        let tree = usvg::Tree::from_str(&self.svg(false, true), &options)?;
        let mut texts = Vec::new();
        for text in all_texts(tree.root()) {
            let (place, transform) = (text.bounding_box(), text.abs_transform());
            // letters without what hangs below: a third from the bottom
            let middle = place.top() + 0.6 * place.height();
            let mut ends = [(place.left(), middle), (place.right(), middle)]
                .map(|(x, y)| usvg::tiny_skia_path::Point::from_xy(x, y));
            transform.map_points(&mut ends);
            let [start, end] = ends.map(|at| [f64::from(at.x), f64::from(at.y)]);
            let angle = (start[1] - end[1]).atan2(end[0] - start[0]).to_degrees();
            texts.push(TrueText { start, end, angle });
        }
        Ok(texts)
    }

    // --------------------------------------------------------------------------------------------- what is drawn

    fn chart(&mut self) {
        let size = f64::from(self.task.size);
        let (left, bottom) = (60.0 + 2.2 * size, 560.0 - 1.6 * size);
        self.line(&[[left, 30.0 + 1.5 * size], [left, bottom], [870.0, bottom]], 2.0);
        let step = (bottom - 60.0 - 1.5 * size) / 5.0;
        for i in 0..5 {
            let y = bottom - step * f64::from(i);
            self.line(&[[left - 10.0, y], [left, y]], 2.0);
            let number = (i * 25).to_string();
            self.text(&number, [left - 16.0, y + 0.35 * size], "end", 0.0);
        }
        for i in 0..4 {
            let x = left + 40.0 + (830.0 - left) / 4.0 * f64::from(i);
            let top = self.rng.between(60.0 + 2.5 * size, bottom - 60.0);
            let fill = pastel(&mut self.rng);
            let width = (830.0 - left) / 4.0 - 60.0;
            let _ = write!(
                self.things,
                "<rect x=\"{x}\" y=\"{top}\" width=\"{width}\" height=\"{}\" fill=\"{fill}\" stroke=\"{}\" \
                 stroke-width=\"2\"/>",
                bottom - top,
                self.ink
            );
            let name = self.word(width + 40.0);
            self.text(name, [x + 0.5 * width, bottom + 1.25 * size], "middle", 0.0);
        }
        let title = self.word(700.0);
        self.text(title, [450.0, 10.0 + size], "middle", 0.0);
        let angle = if self.task.slanted { 90.0 } else { 0.0 };
        if angle > 0.0 {
            let name = self.word(400.0);
            self.text(name, [14.0 + size, 0.5 * bottom + 30.0], "middle", angle);
        }
    }

    fn map(&mut self) {
        let corner = |rng: &mut Rng, i: usize, j: usize| {
            let jitter = |rng: &mut Rng, rim: bool| if rim { 0.0 } else { rng.between(-40.0, 40.0) };
            [30.0 + 280.0 * i as f64 + jitter(rng, i == 0 || i == 3), 30.0 + 270.0 * j as f64 + jitter(rng, j != 1)]
        };
        let corners: Vec<Vec<[f64; 2]>> =
            (0..3).map(|j| (0..4).map(|i| corner(&mut self.rng, i, j)).collect()).collect();
        for j in 0..2 {
            for i in 0..3 {
                let area = [corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]];
                let is_filled = self.task.ground == Ground::Plain;
                let fill = if is_filled { pastel(&mut self.rng) } else { "none".to_owned() };
                self.shape(&area, &fill, 2.0);
                let [x, y] = [0, 1].map(|axis| 0.25 * area.iter().map(|at| at[axis]).sum::<f64>());
                let name = self.word(190.0);
                let angle = self.slant(30.0);
                self.text(name, [x, y - 10.0], "middle", angle);
                if !self.task.slanted {
                    let town = [x - 70.0, y + 65.0];
                    self.dot(town, 5.0);
                    let name = self.word(120.0);
                    self.text(name, [town[0] + 14.0, town[1] + 0.35 * f64::from(self.task.size)], "start", 0.0);
                }
            }
        }
    }

    fn sign(&mut self) {
        let size = f64::from(self.task.size);
        let angle = self.slant(25.0);
        let (width, height) = (14.0 * size + 60.0, 4.0 * size + 50.0);
        let [x, y] = [450.0, 280.0];
        let fill = if self.task.ground == Ground::Photo {
            self.ink = "#111".to_owned();
            pastel(&mut self.rng)
        } else {
            "none".to_owned()
        };
        let _ = write!(
            self.things,
            "<rect x=\"{}\" y=\"{}\" width=\"{width}\" height=\"{height}\" rx=\"8\" fill=\"{fill}\" stroke=\"{}\" \
             stroke-width=\"3\" transform=\"rotate({} {x} {y})\"/>",
            x - 0.5 * width,
            y - 0.5 * height,
            self.ink,
            -angle
        );
        let (sin, cos) = angle.to_radians().sin_cos();
        for line in [-0.25, 1.25] {
            let name = self.word(12.0 * size);
            let down = line * size;
            self.text(name, [x + sin * down, y + cos * down], "middle", angle);
        }
    }

    fn worksheet(&mut self) {
        let size = f64::from(self.task.size);
        self.shape(&[[620.0, 540.0], [620.0, 330.0], [860.0, 330.0], [860.0, 540.0]], "none", 3.0);
        self.shape(&[[600.0, 330.0], [740.0, 200.0], [880.0, 330.0]], "none", 3.0);
        self.shape(&[[710.0, 540.0], [710.0, 430.0], [770.0, 430.0], [770.0, 540.0]], "none", 3.0);
        let angle = if self.task.slanted { self.rng.between(-6.0, 6.0) } else { 0.0 };
        let lines = ((420.0 / (1.5 * size)) as usize).min(8);
        for line in 0..lines {
            let name = self.word(520.0);
            self.text(name, [40.0, 80.0 + 1.5 * size * line as f64], "start", angle);
        }
    }

    fn dots(&mut self) {
        for i in 0..12 {
            self.dot([60.0 + 40.0 * f64::from(i), 80.0], 6.0);
            self.dot([60.0 + 16.0 * f64::from(i), 140.0], 4.0);
        }
        for _ in 0..25 {
            let at = [self.rng.between(40.0, 860.0), self.rng.between(200.0, 430.0)];
            let radius = self.rng.between(3.5, 9.0);
            if self.rng.coin() {
                self.dot(at, radius);
            } else {
                let ink = self.ink.clone();
                let _ = write!(
                    self.things,
                    "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius:.1}\" fill=\"none\" stroke=\"{ink}\" \
                     stroke-width=\"2\"/>",
                    at[0], at[1]
                );
            }
        }
        self.caption();
    }

    fn dashes(&mut self) {
        for (i, pattern) in ["14 10", "20 8", "18 6 4 6", "8 8", "24 8 6 8 6 8"].into_iter().enumerate() {
            let y = 60.0 + 50.0 * i as f64;
            let end = self.rng.between(-30.0, 30.0);
            let _ = write!(
                self.things,
                "<path d=\"M40 {y} L860 {:.1}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" \
                 stroke-dasharray=\"{pattern}\"/>",
                y + end,
                self.ink,
                2 + i % 3
            );
        }
        let _ = write!(
            self.things,
            "<path d=\"M60 430 C200 300 400 520 860 340\" fill=\"none\" stroke=\"{}\" stroke-width=\"3\" \
             stroke-dasharray=\"16 9\"/>",
            self.ink
        );
        self.caption();
    }

    fn windows(&mut self) {
        self.shape(&[[80.0, 470.0], [80.0, 60.0], [820.0, 60.0], [820.0, 470.0]], "none", 3.0);
        let width = self.rng.between(26.0, 44.0);
        for j in 0..4 {
            for i in 0..8 {
                let (x, y) = (120.0 + 85.0 * f64::from(i), 90.0 + 92.0 * f64::from(j));
                let high = 1.5 * width;
                self.shape(&[[x, y], [x + width, y], [x + width, y + high], [x, y + high]], "none", 2.0);
                self.line(&[[x + 0.5 * width, y], [x + 0.5 * width, y + high]], 2.0);
                self.line(&[[x, y + 0.4 * high], [x + width, y + 0.4 * high]], 2.0);
            }
        }
        self.caption();
    }

    fn leaves(&mut self) {
        self.line(&[[60.0, 420.0], [300.0, 330.0], [600.0, 240.0], [850.0, 90.0]], 4.0);
        for i in 0..14 {
            let x = 110.0 + 52.0 * f64::from(i);
            let side = if i % 2 == 0 { -1.0 } else { 1.0 };
            let stem = [x, 400.0 - 0.38 * (x - 60.0)];
            let angle: f64 = side * self.rng.between(50.0, 100.0) - 20.0;
            let length = self.rng.between(30.0, 62.0);
            let broad = self.rng.between(0.25, 0.4) * length;
            let start = 12.0;
            let fill = if self.rng.coin() { "none" } else { "#3c8c3c" };
            let _ = write!(
                self.things,
                "<g transform=\"translate({:.1} {:.1}) rotate({angle:.1})\"><path d=\"M{start} 0 Q{:.1} {broad:.1} \
                 {:.1} 0 Q{:.1} {:.1} {start} 0 Z\" fill=\"{fill}\" stroke=\"{ink}\" stroke-width=\"2\"/></g>",
                stem[0],
                stem[1],
                start + 0.5 * length,
                start + length,
                start + 0.5 * length,
                -broad,
                ink = self.ink
            );
        }
        self.caption();
    }

    fn ticks(&mut self) {
        for (y, turn) in [(150.0, 0.0), (320.0, self.rng.between(-8.0, 8.0))] {
            let mut path = format!("M40 {y} L860 {y}");
            for i in 0..42 {
                let x = 40.0 + 20.0 * f64::from(i);
                let high = if i % 5 == 0 { 34.0 } else { 20.0 };
                let from = if turn == 0.0 { 0.0 } else { 6.0 }; // the ticks of one ruler stand free
                let _ = write!(path, " M{x} {:.1} L{x} {:.1}", y - from, y - from - high);
            }
            let _ = write!(
                self.things,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" transform=\"rotate({turn} 450 {y})\"/>",
                self.ink
            );
        }
        self.caption();
    }

    fn bricks(&mut self) {
        let (wide, high) = (self.rng.between(36.0, 60.0), self.rng.between(14.0, 22.0));
        let gap = self.rng.between(3.0, 6.0);
        let fill = if self.rng.coin() { "none" } else { "#b5533c" };
        for row in 0..12 {
            let y = 60.0 + (high + gap) * f64::from(row);
            let mut x = 60.0;
            let mut first = if row % 2 == 0 { wide } else { 0.5 * wide };
            while x + first <= 840.0 {
                let _ = write!(
                    self.things,
                    "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{first:.1}\" height=\"{high:.1}\" fill=\"{fill}\" \
                     stroke=\"{}\" stroke-width=\"1.5\"/>",
                    self.ink
                );
                x += first + gap;
                first = wide;
            }
        }
        self.caption();
    }

    fn caption(&mut self) {
        let name = self.word(700.0);
        let angle = if self.task.slanted { self.rng.between(-4.0, 4.0) } else { 0.0 };
        self.text(name, [450.0, 545.0], "middle", angle);
    }

    // ----------------------------------------------------------------------------------------------- how it is drawn

    fn slant(&mut self, most: f64) -> f64 {
        if self.task.slanted { self.rng.between(8.0, most) * if self.rng.coin() { 1.0 } else { -1.0 } } else { 0.0 }
    }

    /// A word that has room in a width.
    fn word(&mut self, width: f64) -> &'static str {
        let size = f64::from(self.task.size);
        let fits: Vec<&str> =
            WORDS.into_iter().filter(|word| 0.62 * size * word.chars().count() as f64 <= width).collect();
        // longer ones more often
        let pick = self.rng.below(fits.len().max(1)).max(self.rng.below(fits.len().max(1)));
        fits.get(pick).copied().unwrap_or("Ob")
    }

    fn text(&mut self, text: &str, at: [f64; 2], anchor: &str, angle: f64) {
        let ink = match self.behind.filter(|_| self.task.kind != Kind::Sign) {
            Some(behind) => {
                // the ground under the text, sampled along it
                let length = 0.55 * f64::from(self.task.size) * text.chars().count() as f64;
                let start = match anchor {
                    "start" => 0.0,
                    "middle" => -0.5,
                    _ => -1.0,
                };
                let up = 0.3 * f64::from(self.task.size);
                let along = |i: i32| [at[0] + length * (start + 0.1 * f64::from(i)), at[1] - up];
                let mean = (0..=10).map(|i| behind(turned(along(i), at, angle))).sum::<f64>() / 11.0;
                if mean < 0.5 { "#fff" } else { "#000" }.to_owned()
            }
            None => self.ink.clone(),
        };
        let _ = write!(
            self.texts,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{}\" {} fill=\"{}\" text-anchor=\"{anchor}\" \
             transform=\"rotate({:.1} {x:.1} {y:.1})\">{text}</text>",
            self.task.size,
            self.font,
            ink,
            -angle,
            x = at[0],
            y = at[1],
        );
    }

    fn dot(&mut self, at: [f64; 2], radius: f64) {
        let ink = self.ink.clone();
        let _ =
            write!(self.things, "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius:.1}\" fill=\"{ink}\"/>", at[0], at[1]);
    }

    fn line(&mut self, points: &[[f64; 2]], stroke: f64) {
        self.path(points, "", "none", stroke);
    }

    fn shape(&mut self, points: &[[f64; 2]], fill: &str, stroke: f64) {
        self.path(points, " Z", fill, stroke);
    }

    fn path(&mut self, points: &[[f64; 2]], end: &str, fill: &str, stroke: f64) {
        let mut data = String::new();
        for (i, [x, y]) in points.iter().enumerate() {
            let _ = write!(data, "{}{x:.2} {y:.2}", if i == 0 { "M" } else { " L" });
        }
        let _ = write!(
            self.things,
            "<path d=\"{data}{end}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"{stroke}\"/>",
            self.ink
        );
    }
}

fn all_texts(group: &usvg::Group) -> Vec<&usvg::Text> {
    let mut texts = Vec::new();
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => texts.extend(all_texts(group)),
            usvg::Node::Text(text) => texts.push(&**text),
            _ => {}
        }
    }
    texts
}

/// A light colour.
fn pastel(rng: &mut Rng) -> String {
    let mut part = || rng.between(165.0, 245.0) as u8;
    format!("#{:02x}{:02x}{:02x}", part(), part(), part())
}

/// A dark colour.
fn deep(rng: &mut Rng) -> String {
    let mut part = || rng.between(10.0, 110.0) as u8;
    format!("#{:02x}{:02x}{:02x}", part(), part(), part())
}

/// A turn of a point about another, degrees counter-clockwise as seen.
pub(crate) fn turned(at: [f64; 2], about: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = (degrees / 360.0 * TAU).sin_cos();
    let [dx, dy] = [at[0] - about[0], at[1] - about[1]];
    [about[0] + cos * dx + sin * dy, about[1] - sin * dx + cos * dy]
}
