//! Drawings as teachers convert them, with the contours that a reader should find on the page. Every scene is 900 x 600
//! units, and its parts lie so far apart that all of them keep the clearance of swell paper down to a figure 60 mm wide.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use tactograph_tools::rng::Rng;

/// Width of a scene before it is turned, in units of the drawing (CSS pixels).
pub(crate) const WIDTH: f64 = 900.0;
/// Its height.
pub(crate) const HEIGHT: f64 = 600.0;

/// Width of the faint ring's stroke at least, in units: thinner, it is fainter than a contour may be on a small page.
const FAINT_STROKE: f64 = 4.0;

/// A point of a drawing.
pub(crate) type Point = [f64; 2];

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// One closed polygon with an outline, on a coloured ground.
    Polygon,
    /// Six coloured areas that share their borders.
    Map,
    /// A triangle, a rectangle and a circle as outlines on white.
    Outlines,
    /// Two axes and four bars that stand on one of them.
    Bars,
    /// A circle with lines from its outline to where labels would be.
    Leaders,
    /// Strokes with a pen: a wave, a zigzag, a straight line.
    Ink,
    /// Rings around one centre, the innermost but one faint.
    Rings,
    /// Ruled lines of a table.
    Table,
    /// A cell with a nucleus and a vacuole, filled.
    Cell,
    /// Two curves that cross, over two axes.
    Plot,
    /// A house: wall, roof, door.
    House,
    /// Areas without strokes: a square, a triangle and a disc, a smaller one hidden behind the disc.
    Fills,
}

impl Kind {
    /// All of them; the first six are those of the first measurement.
    pub(crate) const ALL: [Self; 12] = [
        Self::Polygon,
        Self::Map,
        Self::Outlines,
        Self::Bars,
        Self::Leaders,
        Self::Ink,
        Self::Rings,
        Self::Table,
        Self::Cell,
        Self::Plot,
        Self::House,
        Self::Fills,
    ];

    /// Its name in tables and on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Polygon => "polygon",
            Self::Map => "map",
            Self::Outlines => "outlines",
            Self::Bars => "bars",
            Self::Leaders => "leaders",
            Self::Ink => "ink",
            Self::Rings => "rings",
            Self::Table => "table",
            Self::Cell => "cell",
            Self::Plot => "plot",
            Self::House => "house",
            Self::Fills => "fills",
        }
    }
}

/// A drawing and its true contours.
pub(crate) struct Scene {
    svg: String,
    truth: Vec<Vec<Point>>,
    stroke: f64,
    ink: String,
}

impl Scene {
    /// Draws a kind with strokes of a width in units; near seeds give unlike drawings.
    pub(crate) fn new(kind: Kind, stroke: f64, seed: u64) -> Self {
        let mut rng = Rng::new(seed.wrapping_mul(0x9e37_79b9) ^ ((kind as u64) << 32) ^ stroke.to_bits());
        let level = rng.between(0x18 as f64, 0x50 as f64) as u8;
        let mut scene =
            Self { svg: String::new(), truth: Vec::new(), stroke, ink: format!("#{level:02x}{level:02x}{level:02x}") };
        match kind {
            Kind::Polygon => scene.polygon(&mut rng),
            Kind::Map => scene.map(&mut rng),
            Kind::Outlines => scene.outlines(&mut rng),
            Kind::Bars => scene.bars(&mut rng),
            Kind::Leaders => scene.leaders(&mut rng),
            Kind::Ink => scene.strokes(&mut rng),
            Kind::Rings => scene.rings(&mut rng),
            Kind::Table => scene.table(&mut rng),
            Kind::Cell => scene.cell(&mut rng),
            Kind::Plot => scene.plot(&mut rng),
            Kind::House => scene.house(&mut rng),
            Kind::Fills => scene.fills(&mut rng),
        }
        scene
    }

    /// The drawing as SVG after so many quarter turns clockwise.
    pub(crate) fn svg(&self, turns: u8) -> String {
        let ([width, height], transform) = match turns % 4 {
            0 => ([WIDTH, HEIGHT], String::new()),
            1 => ([HEIGHT, WIDTH], format!("translate({HEIGHT} 0) rotate(90)")),
            2 => ([WIDTH, HEIGHT], format!("translate({WIDTH} {HEIGHT}) rotate(180)")),
            _ => ([HEIGHT, WIDTH], format!("translate(0 {WIDTH}) rotate(270)")),
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\">\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/><g transform=\"{transform}\">{}</g></svg>",
            self.svg
        )
    }

    /// Its true contours after so many quarter turns, as polylines; closed ones repeat their first point.
    pub(crate) fn truth(&self, turns: u8) -> Vec<Vec<Point>> {
        let turned = |&[x, y]: &Point| match turns % 4 {
            0 => [x, y],
            1 => [HEIGHT - y, x],
            2 => [WIDTH - x, HEIGHT - y],
            _ => [y, WIDTH - x],
        };
        self.truth.iter().map(|line| line.iter().map(turned).collect()).collect()
    }

    // ---------------------------------------------------------------------------------------------- what is drawn

    fn polygon(&mut self, rng: &mut Rng) {
        self.ground(&pastel(rng));
        let count = 5 + rng.below(4);
        let start = rng.between(0.0, TAU);
        let corners = (0..count).map(|i| {
            let angle = start + TAU * (i as f64 + rng.between(-0.2, 0.2)) / count as f64;
            let radius = rng.between(190.0, 260.0);
            [450.0 + 1.4 * radius * angle.cos(), 300.0 + radius * angle.sin()]
        });
        let corners: Vec<Point> = corners.collect();
        self.closed(&corners, &pastel(rng));
    }

    fn map(&mut self, rng: &mut Rng) {
        let mut corner = |i: usize, j: usize| {
            let jitter = |rng: &mut Rng, on_rim: bool| if on_rim { 0.0 } else { rng.between(-45.0, 45.0) };
            let x = 60.0 + 260.0 * i as f64 + jitter(rng, i == 0 || i == 3);
            let y = 60.0 + 240.0 * j as f64 + jitter(rng, j == 0 || j == 2);
            [x, y]
        };
        let corners: Vec<Vec<Point>> = (0..3).map(|j| (0..4).map(|i| corner(i, j)).collect()).collect();
        for j in 0..2 {
            for i in 0..3 {
                let area = [corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]];
                self.shape(&area, true, &pastel(rng));
            }
        }
        self.truth.extend(corners.iter().cloned());
        self.truth.extend((0..4).map(|i| corners.iter().map(|row| row[i]).collect::<Vec<_>>()));
    }

    fn outlines(&mut self, rng: &mut Rng) {
        let mut at = |x: f64, y: f64| [x + rng.between(-8.0, 8.0), y + rng.between(-25.0, 25.0)];
        let triangle = [at(60.0, 500.0), at(270.0, 480.0), at(160.0, 120.0)];
        let [left, top] = at(380.0, 150.0);
        let centre = at(742.0, 310.0);
        self.closed(&triangle, "none");
        self.closed(&[[left, top], [left + 160.0, top], [left + 160.0, top + 300.0], [left, top + 300.0]], "none");
        self.closed(&circle(centre, [110.0, 110.0]), "none");
    }

    fn bars(&mut self, rng: &mut Rng) {
        self.open(&[[60.0, 40.0], [60.0, 540.0], [870.0, 540.0]]);
        for i in 0..4 {
            let left = 140.0 + 185.0 * f64::from(i);
            let top = rng.between(90.0, 400.0);
            let corners = [[left, 540.0], [left, top], [left + 100.0, top], [left + 100.0, 540.0]];
            let fill = pastel(rng);
            self.shape(&corners, true, &fill);
            self.truth.push(corners.to_vec());
        }
    }

    fn leaders(&mut self, rng: &mut Rng) {
        let (centre, radius) = ([450.0, 300.0], rng.between(100.0, 120.0));
        self.closed(&circle(centre, [radius, radius]), &pastel(rng));
        let start = rng.between(0.0, TAU);
        for i in 0..4 {
            let angle = start + TAU * (f64::from(i) + rng.between(-0.15, 0.15)) / 4.0;
            let at = |r: f64| [centre[0] + r * angle.cos(), centre[1] + r * angle.sin()];
            self.open(&[at(radius), at(radius + rng.between(150.0, 170.0))]);
        }
    }

    fn strokes(&mut self, rng: &mut Rng) {
        let phase = rng.between(0.0, TAU);
        let wave = |i: i32| {
            let x = 60.0 + 6.5 * f64::from(i);
            [x, 140.0 + 60.0 * (phase + x / 90.0).sin()]
        };
        self.open(&(0..=120).map(wave).collect::<Vec<_>>());
        let zigzag = |i: i32| [80.0 + 145.0 * f64::from(i), if i % 2 == 0 { 320.0 } else { 430.0 }];
        self.open(&(0..6).map(zigzag).collect::<Vec<_>>());
        self.open(&[[70.0, 530.0], [rng.between(700.0, 850.0), rng.between(530.0, 570.0)]]);
    }

    fn rings(&mut self, rng: &mut Rng) {
        let centre = [450.0 + rng.between(-30.0, 30.0), 300.0 + rng.between(-8.0, 8.0)];
        for (radius, faint) in [(280.0, false), (195.0, true), (110.0, false)] {
            let ring = circle(centre, [radius, radius]);
            let ink = std::mem::replace(&mut self.ink, "#ebebeb".into());
            let stroke = self.stroke;
            if faint {
                self.stroke = stroke.max(FAINT_STROKE);
            } else {
                self.ink = ink.clone();
            }
            self.closed(&ring, "none");
            (self.ink, self.stroke) = (ink, stroke);
        }
    }

    fn table(&mut self, rng: &mut Rng) {
        let mut rules = |count: usize, step: f64| -> Vec<f64> {
            let spread = 0.15 * step;
            (0..count)
                .map(|i| 60.0 + step * i as f64 + if i % 3 == 0 { 0.0 } else { rng.between(-spread, spread) })
                .collect()
        };
        let (columns, rows) = (rules(4, 260.0), rules(4, 160.0));
        for &y in &rows {
            self.open(&[[columns[0], y], [columns[3], y]]);
        }
        for &x in &columns {
            self.open(&[[x, rows[0]], [x, rows[3]]]);
        }
    }

    fn cell(&mut self, rng: &mut Rng) {
        self.closed(&circle([450.0, 300.0], [380.0, 260.0]), &pastel(rng));
        let nucleus = [300.0 + rng.between(-15.0, 15.0), 300.0 + rng.between(-15.0, 15.0)];
        self.closed(&circle(nucleus, [110.0, 90.0]), &pastel(rng));
        let vacuole = [610.0 + rng.between(-15.0, 15.0), 290.0 + rng.between(-15.0, 15.0)];
        self.closed(&circle(vacuole, [80.0, 80.0]), &pastel(rng));
    }

    fn plot(&mut self, rng: &mut Rng) {
        self.open(&[[60.0, 40.0], [60.0, 540.0], [870.0, 540.0]]);
        let (low, high) = (rng.between(420.0, 450.0), rng.between(90.0, 140.0));
        let curve = |from: f64, to: f64| -> Vec<Point> {
            (0..=80)
                .map(|i| f64::from(i) / 80.0)
                .map(|t| [140.0 + 690.0 * t, from + (to - from) * t * t * (3.0 - 2.0 * t)])
                .collect()
        };
        self.open(&curve(low, high));
        self.open(&curve(high, low));
    }

    fn house(&mut self, rng: &mut Rng) {
        let top = rng.between(260.0, 300.0);
        let wall = [[200.0, 550.0], [200.0, top], [700.0, top], [700.0, 550.0]];
        self.shape(&wall, true, &pastel(rng));
        self.truth.push(vec![wall[3], wall[0], wall[1]]);
        self.truth.push(vec![wall[2], wall[3]]);
        self.closed(&[[140.0, top], [450.0, 60.0], [760.0, top]], &pastel(rng));
        let door = [[400.0, 550.0], [400.0, top + 110.0], [520.0, top + 110.0], [520.0, 550.0]];
        self.shape(&door, true, &pastel(rng));
        self.truth.push(door.to_vec());
    }

    fn fills(&mut self, rng: &mut Rng) {
        self.stroke = 0.0;
        let mut at = |x: f64, y: f64| [x + rng.between(-20.0, 20.0), y + rng.between(-20.0, 20.0)];
        let [left, top] = at(90.0, 110.0);
        let triangle = [at(690.0, 500.0), at(850.0, 460.0), at(760.0, 150.0)];
        let disc = at(480.0, 300.0);
        let square = [[left, top], [left + 165.0, top], [left + 165.0, top + 260.0], [left, top + 260.0]];
        let fills = ["#2a5fe6", "#2ca83c", "#e02a24"];
        self.closed(&square, fills[rng.below(3)]);
        self.closed(&triangle, fills[rng.below(3)]);
        self.closed(&circle(disc, [90.0, 90.0]), fills[rng.below(3)]);
        // hidden behind the disc
        self.shape(&[[disc[0] - 50.0, disc[1] - 20.0], [disc[0] + 50.0, disc[1] + 30.0], disc], true, "#ffd21a");
        self.shape(&circle(disc, [89.9, 89.9]), true, fills[0]);
    }

    // ----------------------------------------------------------------------------------------------- how it is drawn

    fn ground(&mut self, fill: &str) {
        let _ = write!(self.svg, "<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"{fill}\"/>");
    }

    fn closed(&mut self, corners: &[Point], fill: &str) {
        self.shape(corners, true, fill);
        self.truth.push(corners.iter().chain(corners.first()).copied().collect());
    }

    fn open(&mut self, points: &[Point]) {
        self.shape(points, false, "none");
        self.truth.push(points.to_vec());
    }

    fn shape(&mut self, points: &[Point], closed: bool, fill: &str) {
        let mut data = String::new();
        for (i, [x, y]) in points.iter().enumerate() {
            let _ = write!(data, "{}{x:.3} {y:.3}", if i == 0 { "M" } else { " L" });
        }
        let end = if closed { " Z" } else { "" };
        let _ = write!(
            self.svg,
            "<path d=\"{data}{end}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"{}\"/>",
            self.ink, self.stroke
        );
    }
}

/// An ellipse as a polygon; its sides lie within 0.1 units of it.
fn circle(centre: Point, radius: [f64; 2]) -> Vec<Point> {
    let at = |i: i32| f64::from(i) * TAU / 144.0;
    (0..144).map(at).map(|a| [centre[0] + radius[0] * a.cos(), centre[1] + radius[1] * a.sin()]).collect()
}

/// A light colour.
fn pastel(rng: &mut Rng) -> String {
    let mut part = || rng.between(150.0, 245.0) as u8;
    format!("#{:02x}{:02x}{:02x}", part(), part(), part())
}
