//! Scenes as large as a camera's pictures whose outlines, steps and colours are known: discs, ellipses and boxes of many colours
//! before sky and ground that meet in a wave.
//!
//! Light mixes at an outline as in a lens: in linear light, over a Gaussian of about a pixel. Grain comes last. The step of a
//! shape is anything from one that is hardly worth a line to a strong one.

use tactograph::internals::classes::Class;

/// Widths and heights, px: about the shapes of cameras' pictures, of 9 to 12 megapixels. All can be divided by 8, so
/// that they keep their shape at each fraction at which a JPEG is decoded.
const SIZES: [[usize; 2]; 3] = [[4000, 3000], [4000, 2672], [4000, 2256]];
/// Blur of lens and sensor, sigma, px.
const BLUR: f64 = 1.0;
/// Deviation of the grain, of 255.
const GRAIN: f64 = 4.0;
/// How many shapes are tried to be placed.
const SHAPES: usize = 26;
/// Least distance of two shapes, px: 7 mm and more on an A4 page, so that no line makes way for another.
const APART: f64 = 125.0;

use crate::P;
use crate::rng::{dice, hash};

/// Hues in the middle of their classes, degrees; grey has none.
const HUES: [(Class, f64); 5] =
    [(Class::Blue, 222.0), (Class::Green, 118.0), (Class::Yellow, 53.0), (Class::Red, 0.0), (Class::Grey, 0.0)];

/// A colour: what it is called and its sRGB, 0 to 1.
#[derive(Debug, Clone, Copy)]
struct Paint {
    class: Class,
    rgb: [f64; 3],
}

impl Paint {
    fn new(class: Class, lightness: f64) -> Self {
        let hue = HUES.iter().find(|(other, _)| *other == class).map_or(0.0, |(_, hue)| *hue);
        let saturation = if class == Class::Grey { 0.0 } else { 0.8 };
        let chroma = saturation * lightness.min(1.0 - lightness);
        let rgb = [0.0, 8.0, 4.0].map(|shift: f64| {
            let k = (shift + hue / 30.0).rem_euclid(12.0);
            lightness - chroma * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0)
        });
        Self { class, rgb }
    }

    fn light(&self) -> [f64; 3] {
        self.rgb.map(|v| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) })
    }

    /// Lightness and twice the colour axes of CIELAB (white of D65).
    fn lab(&self) -> [f64; 3] {
        let [r, g, b] = self.light();
        let f = |t: f64| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
        let x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        let y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890);
        [116.0 * y - 16.0, 1000.0 * (x - y), 400.0 * (y - z)]
    }

    fn step(&self, other: &Self) -> f64 {
        self.lab().iter().zip(other.lab()).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }
}

#[derive(Debug, Clone)]
struct Shape {
    at: P,
    half: P,
    turn: P,
    is_box: bool,
    paint: Paint,
}

impl Shape {
    fn own(&self, p: P) -> P {
        let (dx, dy) = (p[0] - self.at[0], p[1] - self.at[1]);
        [dx * self.turn[0] + dy * self.turn[1], dy * self.turn[0] - dx * self.turn[1]]
    }

    fn reach(&self) -> f64 {
        if self.is_box { self.half[0].hypot(self.half[1]) } else { self.half[0].max(self.half[1]) }
    }

    /// How deep a place lies inside, px; negative outside. Exact at the outline.
    fn depth(&self, p: P) -> f64 {
        let [u, v] = self.own(p);
        if self.is_box {
            let (x, y) = (u.abs() - self.half[0], v.abs() - self.half[1]);
            return if x > 0.0 && y > 0.0 { -x.hypot(y) } else { -x.max(y) };
        }
        let (u, v) = (u / self.half[0], v / self.half[1]);
        let out = u.hypot(v);
        let slope = (u / self.half[0]).hypot(v / self.half[1]) / out.max(1e-9);
        (1.0 - out) / slope.max(1e-9)
    }

    /// Points of the outline, about a pixel apart.
    fn outline(&self) -> Vec<P> {
        let count = (8.0 * self.reach()) as usize;
        let place = |i: usize| {
            let t = i as f64 / count as f64;
            let [u, v] = if self.is_box {
                let (side, along) = ((t * 4.0) as usize, 2.0 * (t * 4.0).fract() - 1.0);
                let [a, b] = self.half;
                match side {
                    0 => [along * a, -b],
                    1 => [a, along * b],
                    2 => [-along * a, b],
                    _ => [-a, -along * b],
                }
            } else {
                let (sin, cos) = (std::f64::consts::TAU * t).sin_cos();
                [self.half[0] * cos, self.half[1] * sin]
            };
            [self.at[0] + u * self.turn[0] - v * self.turn[1], self.at[1] + u * self.turn[1] + v * self.turn[0]]
        };
        (0..=count).map(|i| place(i % count)).collect()
    }
}

/// A scene.
pub struct Scene {
    /// Width and height, px.
    pub size: [usize; 2],
    sky: Paint,
    ground: Paint,
    wave: [f64; 3],
    shapes: Vec<Shape>,
    seed: u32,
}

/// A true outline, in pixels of the scene, and the height of its step.
pub struct Outline {
    /// About a pixel apart.
    pub points: Vec<P>,
    /// The distance of the colours on both sides, as in CIELAB.
    pub step: f64,
}

impl Scene {
    /// The scene of a seed.
    pub fn new(seed: u32) -> Self {
        let mut number = 0;
        let mut roll = || {
            number += 1;
            chance(number, 1, seed)
        };
        let [sky, ground] =
            if seed.is_multiple_of(2) { [Class::Blue, Class::Green] } else { [Class::Grey, Class::Yellow] };
        let (sky, ground) = (Paint::new(sky, 0.72), Paint::new(ground, 0.48));
        let size = SIZES[seed as usize % SIZES.len()];
        let [width, height] = size.map(|side| side as f64);
        let wave = [height * (0.45 + 0.1 * roll()), 60.0 + 60.0 * roll(), width / (4.0 + 4.0 * roll())];
        let mut scene = Self { size, sky, ground, wave, shapes: Vec::new(), seed };
        for i in 0..SHAPES {
            let half = |roll: f64| 150.0 + 230.0 * roll;
            let (sin, cos) = (std::f64::consts::TAU * roll()).sin_cos();
            let (half, is_box) = ([half(roll()), half(roll())], i % 3 == 2);
            // the lightness of what is behind, and away from it
            let away = [0.03, 0.06, 0.12, 0.2, 0.3][i % 5];
            let class = HUES[(7.0 * roll()) as usize % 5].0;
            for _ in 0..400 {
                let at = [width * roll(), height * roll()];
                let behind = if scene.under(at) > 0.0 { ground } else { sky };
                let lightness = |paint: Paint| {
                    0.5 * (paint.rgb.iter().copied().fold(0.0, f64::max)
                        + paint.rgb.iter().copied().fold(1.0, f64::min))
                };
                let lightness = lightness(behind);
                let lightness = if lightness > 0.5 { lightness - away } else { lightness + away };
                let faint = i % 5 < 3;
                let paint = Paint::new(if faint { behind.class } else { class }, lightness);
                let shape = Shape { at, half, turn: [cos, sin], is_box, paint };
                let room = shape.reach() + APART;
                let is_free = at[0] > room
                    && at[1] > room
                    && at[0] < width - room
                    && at[1] < height - room
                    && scene.under(at).abs() > room * 1.2 + scene.wave[1]
                    && scene.shapes.iter().all(|o| (o.at[0] - at[0]).hypot(o.at[1] - at[1]) > room + o.reach());
                if is_free && paint.step(&behind) > 8.0 {
                    scene.shapes.push(shape);
                    break;
                }
            }
        }
        scene
    }

    /// How far a place lies below the wave, px; exact at the wave.
    fn under(&self, p: P) -> f64 {
        let [level, high, long] = self.wave;
        let (sin, cos) = (p[0] / long).sin_cos();
        (p[1] - level - high * sin) / (1.0 + (high / long * cos).powi(2)).sqrt()
    }

    /// Its outlines.
    pub fn outlines(&self) -> Vec<Outline> {
        let [level, high, long] = self.wave;
        let wave = (0..=self.size[0]).map(|x| [x as f64, level + high * (x as f64 / long).sin()]).collect();
        let mut outlines = vec![Outline { points: wave, step: self.sky.step(&self.ground) }];
        outlines.extend(self.shapes.iter().map(|shape| {
            let behind = if self.under(shape.at) > 0.0 { &self.ground } else { &self.sky };
            Outline { points: shape.outline(), step: shape.paint.step(behind) }
        }));
        outlines
    }

    /// How far a place is from every outline, px; exact near one.
    pub fn clearance(&self, p: P) -> f64 {
        self.shapes.iter().map(|shape| shape.depth(p).abs()).fold(self.under(p).abs(), f64::min)
    }

    /// The class at a place.
    pub fn class(&self, p: P) -> Class {
        let shape = self.shapes.iter().find(|shape| shape.depth(p) > 0.0);
        let behind = if self.under(p) > 0.0 { self.ground.class } else { self.sky.class };
        shape.map_or(behind, |shape| shape.paint.class)
    }

    /// The picture: three bytes a pixel.
    pub fn pixels(&self) -> Vec<u8> {
        let [sky, ground] = [self.sky.light(), self.ground.light()];
        let paints: Vec<[f64; 3]> = self.shapes.iter().map(|shape| shape.paint.light()).collect();
        let mut pixels = Vec::with_capacity(3 * self.size[0] * self.size[1]);
        for y in 0..self.size[1] {
            let near: Vec<usize> = (0..self.shapes.len())
                .filter(|&i| (self.shapes[i].at[1] - y as f64).abs() < self.shapes[i].reach() + 10.0)
                .collect();
            for x in 0..self.size[0] {
                let p = [x as f64 + 0.5, y as f64 + 0.5];
                let below = cover(self.under(p));
                let mut light: [f64; 3] = std::array::from_fn(|c| sky[c] + (ground[c] - sky[c]) * below);
                for &i in &near {
                    let shape = &self.shapes[i];
                    if (shape.at[0] - p[0]).abs() > shape.reach() + 10.0 {
                        continue;
                    }
                    let inside = cover(shape.depth(p));
                    light.iter_mut().zip(paints[i]).for_each(|(light, own)| *light += (own - *light) * inside);
                }
                pixels.extend((0..3).map(|c| {
                    let v = light[c as usize];
                    let code = 255.0 * if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
                    (code + GRAIN * grain(x as u32, y as u32, c + 4 * self.seed)).round().clamp(0.0, 255.0) as u8
                }));
            }
        }
        pixels
    }
}

/// How much of a place so deep inside is covered after the blur: the normal distribution, by the logistic curve, which is
/// nowhere off by more than 0.01.
fn cover(depth: f64) -> f64 {
    1.0 / (1.0 + (-1.702 * depth / BLUR).exp())
}

/// From 0 to 1.
fn chance(x: u32, y: u32, seed: u32) -> f64 {
    f64::from(hash(x, y, seed)) / f64::from(u32::MAX)
}

/// Nearly a normal distribution of deviation 1.
fn grain(x: u32, y: u32, seed: u32) -> f64 {
    (f64::from(dice(x, y, seed)) - 510.0) / 147.8
}
