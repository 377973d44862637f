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
    pub(super) things: String,
    texts: String,
    pub(super) ink: String,
    pub(super) rng: Rng,
    pub(super) task: Task,
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

    pub(super) fn slant(&mut self, most: f64) -> f64 {
        if self.task.slanted { self.rng.between(8.0, most) * if self.rng.coin() { 1.0 } else { -1.0 } } else { 0.0 }
    }

    /// A word that has room in a width.
    pub(super) fn word(&mut self, width: f64) -> &'static str {
        let size = f64::from(self.task.size);
        let fits: Vec<&str> =
            WORDS.into_iter().filter(|word| 0.62 * size * word.chars().count() as f64 <= width).collect();
        // longer ones more often
        let pick = self.rng.below(fits.len().max(1)).max(self.rng.below(fits.len().max(1)));
        fits.get(pick).copied().unwrap_or("Ob")
    }

    pub(super) fn text(&mut self, text: &str, at: [f64; 2], anchor: &str, angle: f64) {
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

    pub(super) fn dot(&mut self, at: [f64; 2], radius: f64) {
        let ink = self.ink.clone();
        let _ =
            write!(self.things, "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius:.1}\" fill=\"{ink}\"/>", at[0], at[1]);
    }

    pub(super) fn line(&mut self, points: &[[f64; 2]], stroke: f64) {
        self.path(points, "", "none", stroke);
    }

    pub(super) fn shape(&mut self, points: &[[f64; 2]], fill: &str, stroke: f64) {
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
pub(super) fn pastel(rng: &mut Rng) -> String {
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
