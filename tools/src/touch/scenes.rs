//! Scenes whose colours are known at every place: bars, ramps, maps, stripes, discs, wheels, each turned by any angle.
//!
//! A scene says what a person would call a colour only where there is no doubt: the hues of a class lie well inside it, a
//! dark yellow (which is olive, and so green) is left out. Where there is doubt the truth is `Truth::Unknown`, and like any
//! other border it is kept away from.

use std::f32::consts::TAU;

use tactograph::internals::page::Class;

use crate::rng::Rng;

/// Side of a square picture on the A4 profile, mm.
pub const SIDE_MM: usize = 166;
/// Pixels of a scene for a millimetre.
pub const FINE_PX: usize = 3;
/// Pixels of a quick scene for a millimetre.
pub const QUICK_PX: usize = 1;
/// Points of a pixel that are averaged along each side.
const FINE: usize = 2;

/// The kinds of scenes.
pub const KINDS: [&str; 6] = ["bars", "ramps", "map", "stripes", "discs", "wheel"];

/// What lies at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Truth {
    /// This colour, of this HSL lightness.
    Colour(Class, f32),
    /// Nothing.
    White,
    /// A colour that one may call this or that.
    Unknown,
}

/// A picture and what is on it.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Width and height, px.
    pub side: usize,
    /// The picture as a PPM file.
    pub picture: Vec<u8>,
    /// The colour in the middle of each pixel, row by row.
    pub colours: Vec<[f32; 3]>,
    /// The truth in the middle of each pixel, row by row.
    pub truth: Vec<Truth>,
}

impl Scene {
    /// The scene cut into so many squares across and as many down.
    pub fn parts(&self, count: usize) -> Vec<Self> {
        let side = self.side / count;
        let corners = (0..count).flat_map(|row| (0..count).map(move |column| (column * side, row * side)));
        corners.map(|(x, y)| self.part(x, y, side)).collect()
    }

    fn part(&self, left: usize, top: usize, side: usize) -> Self {
        let rows = (top..top + side).map(|y| y * self.side + left..y * self.side + left + side);
        let pixels = self.picture.len() - 3 * self.side * self.side;
        let mut picture = format!("P6 {side} {side} 255\n").into_bytes();
        for row in rows.clone() {
            picture.extend(&self.picture[pixels + 3 * row.start..pixels + 3 * row.end]);
        }
        Self {
            side,
            picture,
            colours: rows.clone().flat_map(|row| &self.colours[row]).copied().collect(),
            truth: rows.flat_map(|row| &self.truth[row]).copied().collect(),
        }
    }
}

/// The scene of a kind and a seed, so many pixels a millimetre. Seed 0 stands upright, all others are turned.
pub fn scene(kind: usize, seed: u64, px_per_mm: usize) -> Scene {
    let mut rng = Rng::new(seed * 8 + kind as u64);
    let turn = if seed == 0 { 0.0 } else { rng.between_f32(0.0, TAU) };
    match kind {
        0 => paint(px_per_mm, turn, bars()),
        1 => paint(px_per_mm, turn, ramps(&mut rng)),
        2 => paint(px_per_mm, turn, map(&mut rng)),
        3 => paint(px_per_mm, turn, stripes(&mut rng)),
        4 => paint(px_per_mm, turn, discs(&mut rng)),
        _ => paint(px_per_mm, turn, wheel(&mut rng)),
    }
}

type Spot = ([f32; 3], Truth);
const BLANK: Spot = ([1.0; 3], Truth::White);

/// A colour of a class; `hue` 0..1 from one end of its hues to the other.
fn colour(class: Class, hue: f32, lightness: f32) -> Spot {
    let (from, to) = match class {
        Class::Blue => (200.0, 250.0),
        Class::Green => (98.0, 150.0),
        Class::Yellow => (47.0, 60.0),
        Class::Red => (-12.0, 10.0),
        Class::Grey => (0.0, 0.0),
    };
    let saturation = if class == Class::Grey { 0.0 } else { 1.0 };
    let known = class != Class::Yellow || lightness >= 0.4; // darker, it is olive
    let truth = if known { Truth::Colour(class, lightness) } else { Truth::Unknown };
    (hsl(from + (to - from) * hue, saturation, lightness), truth)
}

/// sRGB of a colour in HSL; hue in degrees.
fn hsl(hue: f32, saturation: f32, lightness: f32) -> [f32; 3] {
    let chroma = saturation * lightness.min(1.0 - lightness);
    [0.0, 8.0, 4.0].map(|shift| {
        let k = (shift + hue / 30.0).rem_euclid(12.0);
        lightness - chroma * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0)
    })
}

fn lightness_for(class: Class, rng: &mut Rng) -> f32 {
    rng.between_f32(if class == Class::Yellow { 0.42 } else { 0.15 }, 0.86)
}

/// Width of a bar with its gap, or of a band, mm: those of all classes side by side take 150 mm.
const BAND: f32 = 150.0 / Class::ALL.len() as f32;

/// The number of the band in which a place is, and how far across it, 0..1.
fn band_at(x: f32) -> Option<(usize, f32)> {
    let band = (x + 75.0) / BAND;
    (0.0..Class::ALL.len() as f32).contains(&band).then_some((band as usize, band.fract()))
}

/// The paper's bars, one for each class: 26 mm of colour on white where there are five.
fn bars() -> impl Fn(f32, f32) -> Spot {
    |x, y| match band_at(x) {
        Some((bar, share)) if share < 26.0 / 30.0 && y.abs() < 62.0 => colour(Class::ALL[bar], 0.5, 0.5),
        _ => BLANK,
    }
}

/// A band for each class from dark to white.
fn ramps(rng: &mut Rng) -> impl Fn(f32, f32) -> Spot {
    let hues = Class::ALL.map(|_| rng.between_f32(0.0, 1.0));
    move |x, y| {
        let lightness = 0.12 + 0.88 * (y + 75.0) / 150.0;
        match band_at(x) {
            Some((band, _)) if (0.12..1.0).contains(&lightness) => colour(Class::ALL[band], hues[band], lightness),
            _ => BLANK,
        }
    }
}

/// Twelve areas round random places, each of a random class and lightness or blank.
fn map(rng: &mut Rng) -> impl Fn(f32, f32) -> Spot {
    let seats: Vec<(f32, f32, Spot)> = (0..12)
        .map(|_| {
            let class = rng.below(Class::ALL.len() + 1); // the last is blank
            let spot = Class::ALL.get(class).map_or(BLANK, |&class| {
                let lightness = lightness_for(class, rng);
                colour(class, rng.between_f32(0.0, 1.0), lightness)
            });
            (rng.between_f32(-80.0, 80.0), rng.between_f32(-80.0, 80.0), spot)
        })
        .collect();
    move |x, y| {
        let far = |seat: &&(f32, f32, Spot)| (seat.0 - x).hypot(seat.1 - y);
        seats.iter().min_by(|a, b| far(a).total_cmp(&far(b))).map_or(BLANK, |seat| seat.2)
    }
}

/// Stripes that get narrower from 34 to 4 mm, each of another class than the one before.
fn stripes(rng: &mut Rng) -> impl Fn(f32, f32) -> Spot {
    let mut list = Vec::new();
    let (mut at, mut width, mut class) = (-110.0, 34.0, rng.below(Class::ALL.len()));
    while at < 110.0 {
        let lightness = lightness_for(Class::ALL[class], rng);
        list.push((at, colour(Class::ALL[class], rng.between_f32(0.0, 1.0), lightness)));
        at += width;
        width = (width * 0.85_f32).max(4.0);
        class = (class + 1 + rng.below(Class::ALL.len() - 1)) % Class::ALL.len();
    }
    move |x, _| list.iter().rev().find(|(from, _)| x >= *from).map_or(BLANK, |(_, spot)| *spot)
}

/// Discs of 46 down to 4 mm on white, none over another.
fn discs(rng: &mut Rng) -> impl Fn(f32, f32) -> Spot {
    let mut list: Vec<(f32, f32, f32, Spot)> = Vec::new();
    let mut diameter = 46.0;
    while diameter >= 4.0 {
        for _ in 0..200 {
            let room = 80.0 - 0.5 * diameter;
            let (x, y) = (rng.between_f32(-room, room), rng.between_f32(-room, room));
            if list.iter().all(|other| (other.0 - x).hypot(other.1 - y) > 0.5 * diameter + other.2 + 5.0) {
                let class = Class::ALL[rng.below(Class::ALL.len())];
                let lightness = lightness_for(class, rng);
                list.push((x, y, 0.5 * diameter, colour(class, rng.between_f32(0.0, 1.0), lightness)));
                break;
            }
        }
        diameter *= 0.88;
    }
    move |x, y| list.iter().find(|d| (d.0 - x).hypot(d.1 - y) <= d.2).map_or(BLANK, |d| d.3)
}

/// All hues round a grey hub, light or dark.
fn wheel(rng: &mut Rng) -> impl Fn(f32, f32) -> Spot {
    let (lightness, hub, start) = (rng.between_f32(0.42, 0.8), rng.between_f32(0.2, 0.85), rng.between_f32(0.0, 360.0));
    move |x, y| {
        let (radius, hue) = (x.hypot(y), (y.atan2(x).to_degrees() + start).rem_euclid(360.0));
        let class = match hue {
            h if !(12.0..348.0).contains(&h) => Some(Class::Red),
            h if (47.0..60.0).contains(&h) => Some(Class::Yellow),
            h if (98.0..150.0).contains(&h) => Some(Class::Green),
            h if (200.0..250.0).contains(&h) => Some(Class::Blue),
            _ => None,
        };
        let truth = class.map_or(Truth::Unknown, |class| Truth::Colour(class, lightness));
        match radius {
            r if r < 24.0 => colour(Class::Grey, 0.0, hub),
            r if r < 80.0 => (hsl(hue, 1.0, lightness), truth),
            _ => BLANK,
        }
    }
}

/// Paints a scene whose places are in millimetres from its middle, turned by `turn`.
fn paint(px_per_mm: usize, turn: f32, spot: impl Fn(f32, f32) -> Spot) -> Scene {
    let (sin, cos) = turn.sin_cos();
    let side = SIDE_MM * px_per_mm;
    let at = |x: f32, y: f32| {
        let mm = |px: f32| (px - 0.5 * side as f32) / px_per_mm as f32;
        let (x, y) = (mm(x), mm(y));
        spot(x * cos + y * sin, y * cos - x * sin)
    };
    let mut picture = format!("P6 {side} {side} 255\n").into_bytes();
    let (mut colours, mut truth) = (Vec::with_capacity(side * side), Vec::with_capacity(side * side));
    for y in 0..side {
        for x in 0..side {
            let mut sum = [0.0; 3];
            for (i, j) in (0..FINE * FINE).map(|k| (k % FINE, k / FINE)) {
                let part = |k: usize| (k as f32 + 0.5) / FINE as f32;
                let (colour, _) = at(x as f32 + part(i), y as f32 + part(j));
                sum.iter_mut().zip(colour).for_each(|(sum, value)| *sum += value);
            }
            picture.extend(sum.map(|sum| (255.0 * sum / (FINE * FINE) as f32).round() as u8));
            let (colour, known) = at(x as f32 + 0.5, y as f32 + 0.5);
            colours.push(colour);
            truth.push(known);
        }
    }
    Scene { side, picture, colours, truth }
}
