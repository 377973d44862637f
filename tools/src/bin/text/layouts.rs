//! What is in each kind of scene, and where.

use std::fmt::Write as _;

use tactograph_tools::rng::Rng;

use super::scenes::{Ground, Scene, pastel};

impl Scene<'_> {
    pub(super) fn chart(&mut self) {
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

    pub(super) fn map(&mut self) {
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

    pub(super) fn sign(&mut self) {
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

    pub(super) fn worksheet(&mut self) {
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

    pub(super) fn dots(&mut self) {
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

    pub(super) fn dashes(&mut self) {
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

    pub(super) fn windows(&mut self) {
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

    pub(super) fn leaves(&mut self) {
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

    pub(super) fn ticks(&mut self) {
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

    pub(super) fn bricks(&mut self) {
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
}
