//! Pictures that cost a decoder and an edge detector what a photograph costs them, at any size and always the same.
//!
//! A scene is smooth shading with soft and sharp objects before it. Its texture is the sum of noises at all scales down to
//! the pixel, each as strong as the next or nearly so: that is the spectrum of photographs (amplitude falls as 1/f), and
//! why a larger picture of a scene has as much to code for each pixel as a smaller one. Last comes the grain of a sensor.
//! The strengths are set so that JPEG of quality 90 (4:2:0) takes 1.7 to 2.3 bits a pixel, as camera pictures do.

use std::num::NonZero;

use crate::rng::{dice, hash};

/// Samples of 16 bits, three to a pixel, row by row.
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// All samples.
    pub rgb: Vec<u16>,
}

impl Picture {
    /// A picture whose pixels a function of column and row gives, 0 to 1.
    fn paint(width: usize, height: usize, colour: impl Fn(usize, usize) -> [f32; 3] + Sync) -> Self {
        let mut rgb = vec![0; width * height * 3];
        let workers = std::thread::available_parallelism().map_or(1, NonZero::get);
        let rows = height.div_ceil(workers);
        std::thread::scope(|scope| {
            for (part, band) in rgb.chunks_mut(rows * width * 3).enumerate() {
                let colour = &colour;
                scope.spawn(move || {
                    for (i, pixel) in band.chunks_exact_mut(3).enumerate() {
                        let value = colour(i % width, part * rows + i / width);
                        for (sample, value) in pixel.iter_mut().zip(value) {
                            *sample = (value.clamp(0.0, 1.0) * 65535.0 + 0.5) as u16;
                        }
                    }
                });
            }
        });
        Self { width, height, rgb }
    }

    /// The same in 8 bits.
    pub fn bytes(&self) -> Vec<u8> {
        self.rgb.iter().map(|&sample| (sample >> 8) as u8).collect()
    }
}

/// From 0 to 1.
fn chance(x: u32, y: u32, seed: u32) -> f32 {
    (hash(x, y, seed) >> 8) as f32 / (1 << 24) as f32
}

/// Nearly a normal distribution of deviation 1.
fn grain(x: u32, y: u32, seed: u32) -> f32 {
    (f32::from(dice(x, y, seed)) - 510.0) / 147.8
}

fn smooth(t: f32) -> f32 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Noise with one value to a cell and smooth between, -1 to 1.
fn cells(x: f32, y: f32, seed: u32) -> f32 {
    let (column, row) = (x.floor(), y.floor());
    let (u, v) = (smooth(x - column), smooth(y - row));
    let (column, row) = (column as i32 as u32, row as i32 as u32);
    let at = |dx: u32, dy: u32| chance(column.wrapping_add(dx), row.wrapping_add(dy), seed);
    let upper = at(0, 0) + (at(1, 0) - at(0, 0)) * u;
    let lower = at(0, 1) + (at(1, 1) - at(0, 1)) * u;
    2.0 * (upper + (lower - upper) * v) - 1.0
}

/// The cells of the coarsest noise, as a share of the picture's width.
const COARSEST: f32 = 0.12;
/// The cells of the finest, px. Below it lenses leave nothing.
const FINEST: f32 = 2.5;
/// How strong each noise is beside the one of twice its size.
const FALL: f32 = 1.0;

/// Noise of all scales down to the pixel.
fn texture(x: f32, y: f32, width: f32, seed: u32) -> f32 {
    let (mut cell, mut weight, mut sum) = (COARSEST * width, 1.0, 0.0);
    let mut octave = seed;
    while cell >= FINEST {
        sum += weight * cells(x / cell, y / cell, octave);
        cell *= 0.5;
        weight *= FALL;
        octave += 1;
    }
    sum
}

/// Something that stands before the rest. Lengths are shares of the picture's width.
struct Thing {
    at: [f32; 2],
    half: [f32; 2],
    turn: [f32; 2],
    is_round: bool,
    /// Over what its edge fades: sharp where the lens was in focus.
    soft: f32,
    colour: [f32; 3],
    shade: f32,
    rough: f32,
}

impl Thing {
    fn nth(i: u32) -> Self {
        let roll = |what: u32| chance(i, what, 77);
        let size = 0.02 + 0.16 * roll(0) * roll(1);
        let (sin, cos) = (std::f32::consts::PI * roll(4)).sin_cos();
        // Colours of things are mostly dull, a few pure.
        let (grey, pure) = (0.12 + 0.7 * roll(5), roll(6) * roll(6));
        let colour = [roll(7), roll(8), roll(9)].map(|part| grey + (part - 0.5) * (0.2 + 0.8 * pure));
        Self {
            at: [roll(2), 0.75 * roll(3)],
            half: [size * (0.4 + roll(10)), size * (0.4 + roll(11))],
            turn: [cos, sin],
            is_round: roll(12) < 0.5,
            soft: 0.0002 + 0.008 * roll(13) * roll(13) * roll(13),
            colour,
            shade: roll(14) - 0.5,
            rough: 0.015 + 0.08 * roll(15) * roll(15),
        }
    }

    /// How much of a place it covers, and where on it the place is, from -1 to 1 downwards.
    fn cover(&self, x: f32, y: f32, soft: f32) -> (f32, f32) {
        let (dx, dy) = (x - self.at[0], y - self.at[1]);
        let (u, v) = (dx * self.turn[0] + dy * self.turn[1], dy * self.turn[0] - dx * self.turn[1]);
        let (u, v) = (u / self.half[0], v / self.half[1]);
        let out = if self.is_round { (u * u + v * v).sqrt() } else { u.abs().max(v.abs()) };
        let distance = (1.0 - out) * self.half[0].min(self.half[1]);
        (smooth(0.5 + distance / (2.0 * soft)), v)
    }
}

/// How many things there are.
const THINGS: u32 = 90;
/// Deviation of a sensor's grain: 4 of 255.
const GRAIN: f32 = 4.0 / 255.0;

/// A photograph of a made-up scene.
pub fn photo(width: usize, height: usize) -> Picture {
    let things: Vec<Thing> = (0..THINGS).map(Thing::nth).collect();
    let scale = width as f32;
    Picture::paint(width, height, |column, row| {
        let (px, py) = (column as f32, row as f32);
        let (x, y) = (px / scale, py / scale);
        // Sky over ground, with a far horizon between.
        let ground = smooth(0.5 + (y - 0.38 - 0.03 * cells(x * 5.0, 0.5, 9)) / 0.004);
        let sky = [0.55 + 0.3 * y, 0.7 + 0.2 * y, 0.9];
        let earth = [0.42 - 0.15 * y, 0.4 - 0.1 * y, 0.28 - 0.1 * y];
        let mut colour: [f32; 3] = std::array::from_fn(|c| sky[c] + (earth[c] - sky[c]) * ground);
        let mut rough = 0.006 + 0.06 * ground;
        for thing in &things {
            if (x - thing.at[0]).abs().max((y - thing.at[1]).abs()) > 0.36 {
                continue; // no thing reaches as far
            }
            let (cover, v) = thing.cover(x, y, thing.soft.max(0.7 / scale));
            if cover > 0.0 {
                for (value, own) in colour.iter_mut().zip(thing.colour) {
                    *value += (own * (1.0 + 0.5 * thing.shade * v) - *value) * cover;
                }
                rough += (thing.rough - rough) * cover;
            }
        }
        let bright = rough * texture(px, py, scale, 100);
        let hue = 0.4 * rough * cells(px / (0.01 * scale), py / (0.01 * scale), 200);
        let (x, y) = (column as u32, row as u32);
        std::array::from_fn(|c| {
            let grain = (grain(x, y, c as u32) + grain(x, y, 9)) * std::f32::consts::FRAC_1_SQRT_2;
            colour[c] + bright + hue * (c as f32 - 1.0) + GRAIN * grain
        })
    })
}

/// A picture full of texture: a lawn, blade by blade.
pub fn lawn(width: usize, height: usize) -> Picture {
    let mut lawn = Picture::paint(width, height, |_, _| [0.1, 0.16, 0.05]);
    let blades = width * height / 90;
    for i in 0..blades as u32 {
        let roll = |what: u32| chance(i, what, 5);
        let (mut x, mut y) = (roll(0) * width as f32, roll(1) * (height + 60) as f32);
        let (lean, bend) = (roll(2) - 0.5, 0.03 * (roll(3) - 0.5));
        let light = 0.3 + 0.7 * roll(4);
        let colour = [0.45 * light + 0.1 * roll(5), 0.75 * light, 0.25 * light * roll(6)];
        let length = 20.0 + 40.0 * roll(7);
        for step in 0..length as u32 {
            let half = 1.5 * (1.0 - step as f32 / length) + 0.5;
            for column in ((x - half).max(0.0) as usize)..((x + half).max(0.0) as usize).min(width) {
                if y >= 0.0 && (y as usize) < height {
                    let at = (y as usize * width + column) * 3;
                    for (sample, value) in lawn.rgb[at..at + 3].iter_mut().zip(colour) {
                        *sample = (value.clamp(0.0, 1.0) * 65535.0) as u16;
                    }
                }
            }
            x += lean + bend * step as f32;
            y -= 1.0;
        }
    }
    lawn
}

/// Nothing but noise, each sample on its own.
pub fn noise(width: usize, height: usize) -> Picture {
    Picture::paint(width, height, |x, y| std::array::from_fn(|c| chance(x as u32, y as u32, c as u32)))
}

/// A blank sheet.
pub fn white(width: usize, height: usize) -> Picture {
    Picture::paint(width, height, |_, _| [1.0; 3])
}
