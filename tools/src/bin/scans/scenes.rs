//! Drawings on paper, with the class of each of their areas. Every scene is 900 x 600 units.

use std::fmt::Write as _;

use tactograph::internals::classes::Class;
use tactograph_tools::rng::Rng;

/// Width of a scene in units.
pub(crate) const WIDTH: f64 = 900.0;
/// Its height.
pub(crate) const HEIGHT: f64 = 600.0;

/// Tints of each class: light, middle, dark.
const TINTS: [(Class, [&str; 3]); 5] = [
    (Class::Blue, ["#cfe4f7", "#9ec9e8", "#2f6fd0"]),
    (Class::Green, ["#d2ecc8", "#a5d6a0", "#3a9a4a"]),
    (Class::Yellow, ["#fff2b0", "#f7e07a", "#e8c020"]),
    (Class::Red, ["#f7cfcf", "#eba3a3", "#d03a3a"]),
    (Class::Grey, ["#d6d6d6", "#aaaaaa", "#606060"]),
];

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Outlines of shapes, and strokes of a pen: all blank.
    Outlines,
    /// Two axes and five bars, one of each class.
    Bars,
    /// Six pale areas that share their borders, with a margin.
    Map,
    /// One light tint over nearly half of the paper, and two small ones beside it.
    Large,
    /// Closed outlines with blank paper in them, and small areas on that.
    Rings,
    /// A map without any paper around it.
    Full,
    /// White and yellow shapes on a coloured ground.
    Poster,
}

impl Kind {
    /// All of them.
    pub(crate) const ALL: [Self; 7] =
        [Self::Outlines, Self::Bars, Self::Map, Self::Large, Self::Rings, Self::Full, Self::Poster];

    /// Its name in tables and on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Outlines => "outlines",
            Self::Bars => "bars",
            Self::Map => "map",
            Self::Large => "large",
            Self::Rings => "rings",
            Self::Full => "full",
            Self::Poster => "poster",
        }
    }
}

/// What is at a place of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Truth {
    /// Paper, or what is as white.
    Blank,
    /// An area of a class.
    Area(Class),
    /// A stroke: nobody asks for its class.
    Stroke,
}

impl Truth {
    /// As a colour, for drawing what is true.
    fn colour(self) -> [u8; 3] {
        match self {
            Self::Blank => [255; 3],
            Self::Stroke => [0; 3],
            Self::Area(class) => [8 * (1 + class as u8), 0, 128],
        }
    }

    /// The truth that is nearest to a colour.
    pub(crate) fn named(colour: [u8; 3]) -> Self {
        let areas = Class::ALL.into_iter().map(Self::Area);
        let all = [Self::Blank, Self::Stroke].into_iter().chain(areas);
        let distance = |of: &Self| -> u32 {
            of.colour().into_iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
        };
        all.min_by_key(distance).unwrap_or(Self::Stroke)
    }
}

/// A drawing and what is true of it.
#[derive(Default)]
pub(crate) struct Scene {
    /// Both as SVG.
    drawing: String,
    truth: String,
}

impl Scene {
    /// Draws a kind; near seeds give unlike drawings.
    pub(crate) fn new(kind: Kind, seed: u64) -> Self {
        let mut rng = Rng::new(seed.wrapping_mul(0x9e37_79b9) ^ ((kind as u64) << 32));
        let mut scene = Self::default();
        match kind {
            Kind::Outlines => scene.outlines(&mut rng),
            Kind::Bars => scene.bars(&mut rng),
            Kind::Map => scene.map(&mut rng, 45.0),
            Kind::Large => scene.large(&mut rng),
            Kind::Rings => scene.rings(&mut rng),
            Kind::Full => scene.map(&mut rng, -20.0),
            Kind::Poster => scene.poster(&mut rng),
        }
        scene
    }

    /// The drawing as SVG.
    pub(crate) fn svg(&self) -> String {
        document(&self.drawing)
    }

    /// What is true, in the colours of [`Truth`].
    pub(crate) fn truth(&self) -> String {
        document(&self.truth)
    }

    /// A closed shape: paper, or an area of a colour, with an outline.
    fn area(&mut self, path: &str, fill: Option<(Class, &str)>, outline: f64) {
        let truth = fill.map_or(Truth::Blank, |(class, _)| Truth::Area(class));
        let stroke =
            if outline > 0.0 { format!(r##" stroke="#222" stroke-width="{outline}""##) } else { String::new() };
        let fill = fill.map_or("#fff", |(_, colour)| colour);
        let _ = write!(self.drawing, r#"<path d="{path}" fill="{fill}"{stroke}/>"#);
        let [r, g, b] = truth.colour();
        let wide = outline.max(2.0);
        let _ =
            write!(self.truth, r#"<path d="{path}" fill="rgb({r},{g},{b})" stroke="black" stroke-width="{wide}"/>"#);
    }

    fn stroke(&mut self, path: &str, width: f64) {
        let drawn = format!(r#"<path d="{path}" fill="none" stroke-linecap="round" stroke-width="{width}""#);
        let _ = write!(self.drawing, r##"{drawn} stroke="#222"/>"##);
        let _ = write!(self.truth, r#"{drawn} stroke="black"/>"#);
    }

    fn outlines(&mut self, rng: &mut Rng) {
        for column in 0..3 {
            for row in 0..2 {
                let at = [150.0 + 300.0 * f64::from(column), 150.0 + 300.0 * f64::from(row)];
                let corners = 3 + rng.below(30);
                self.area(&polygon(at, rng.between(60.0, 110.0), corners, rng), None, rng.between(2.0, 5.0));
            }
        }
        let mut wave = String::from("M40 300");
        for step in 0..20 {
            let _ = write!(wave, "q20 {} 40 0", if step % 2 == 0 { -14 } else { 14 });
        }
        self.stroke(&wave, 3.0);
    }

    fn bars(&mut self, rng: &mut Rng) {
        for (number, (class, tints)) in TINTS.into_iter().enumerate() {
            let (left, height) = (110.0 + 150.0 * number as f64, rng.between(120.0, 470.0));
            let tint = tints[rng.below(3)];
            let path = format!("M{left} 540v-{height}h100v{height}z");
            self.area(&path, Some((class, tint)), if rng.coin() { 2.0 } else { 0.0 });
        }
        self.stroke("M70 30V540H880", 3.0);
    }

    /// Six areas that share their borders, so far from the edges.
    fn map(&mut self, rng: &mut Rng, margin: f64) {
        let mut node = |column: usize, row: usize| {
            let at = [
                margin + (WIDTH - 2.0 * margin) * column as f64 / 3.0,
                margin + (HEIGHT - 2.0 * margin) * row as f64 / 2.0,
            ];
            let inside = |at: usize, last: usize| if at == 0 || at == last { 0.0 } else { 50.0 };
            let [dx, dy] = [inside(column, 3), inside(row, 2)];
            [at[0] + rng.between(-1.0, 1.0) * dx, at[1] + rng.between(-1.0, 1.0) * dy]
        };
        let nodes: Vec<Vec<[f64; 2]>> = (0..4).map(|column| (0..3).map(|row| node(column, row)).collect()).collect();
        let first = rng.below(5);
        for number in 0..6 {
            let (column, row) = (number % 3, number / 3);
            let (class, tints) = TINTS[(first + number) % 5];
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, down)| nodes[column + right][row + down]);
            self.area(&closed(&corners), Some((class, tints[rng.below(2)])), 2.0);
        }
    }

    fn large(&mut self, rng: &mut Rng) {
        let (first, class) = (rng.below(5), |number: usize| TINTS[number % 5]);
        let outline = if rng.coin() { 3.0 } else { 0.0 };
        let corners = [[50.0, 60.0], [560.0, 40.0], [600.0, 540.0], [70.0, 560.0]];
        let corners = corners.map(|[x, y]| [x + rng.between(-20.0, 20.0), y + rng.between(-20.0, 20.0)]);
        let (own, tints) = class(first);
        self.area(&closed(&corners), Some((own, tints[0])), outline);
        for (number, y) in [(1, 160.0), (2, 430.0)] {
            let (own, tints) = class(first + number);
            let corners = 3 + rng.below(9);
            self.area(&polygon([750.0, y], 90.0, corners, rng), Some((own, tints[rng.below(3)])), outline);
        }
    }

    fn rings(&mut self, rng: &mut Rng) {
        for (number, x) in [230.0, 670.0].into_iter().enumerate() {
            self.area(&polygon([x, 300.0], 200.0, 40, rng), None, 4.0);
            for (part, y) in [210.0, 390.0].into_iter().enumerate() {
                let (class, tints) = TINTS[(2 * number + part + rng.below(2)) % 5];
                self.area(&polygon([x, y], 65.0, 24, rng), Some((class, tints[rng.below(3)])), 3.0);
            }
        }
    }

    fn poster(&mut self, rng: &mut Rng) {
        let (class, tints) = TINTS[rng.below(4)];
        self.area("M-20 -20H920V620H-20Z", Some((class, tints[1])), 0.0);
        self.area(&polygon([250.0, 300.0], 150.0, 30, rng), None, 0.0);
        let (other, tints) = TINTS[(2 + 2 * usize::from(class == Class::Yellow)) % 5];
        self.area(&polygon([640.0, 300.0], 150.0, 5, rng), Some((other, tints[1])), 3.0);
    }
}

fn document(content: &str) -> String {
    format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}"><rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>{content}</svg>"##
    )
}

fn polygon(middle: [f64; 2], radius: f64, corners: usize, rng: &mut Rng) -> String {
    let turn = rng.between(0.0, std::f64::consts::TAU);
    let corner = |k: usize| {
        let angle = turn + std::f64::consts::TAU * k as f64 / corners as f64;
        [middle[0] + radius * angle.cos(), middle[1] + radius * angle.sin()]
    };
    closed(&(0..corners).map(corner).collect::<Vec<_>>())
}

fn closed(corners: &[[f64; 2]]) -> String {
    let points: Vec<String> = corners.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    format!("M{}Z", points.join("L"))
}
