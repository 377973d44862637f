//! What the signs of a kind look like: how much ink each of their pixels has. By it they are found where something else
//! touches them, and told from letters.

use super::blobs::{Blob, apart};
use crate::edges::faint::BLACK;
use crate::edges::stroke::smoothed;
use crate::raster::plane::Plane;
use crate::units::Size;

/// So much around a sign is looked at, px.
const MARGIN: i32 = 3;
/// Pixels so far beside a sign are smoothed into the ground, px.
const RIM: i32 = 2;
/// Ink is a colour between that of the ground and that of the sign, but for this share of how far these are apart.
const OFF: f32 = 0.35;
/// A sign of a kind lacks no more than this share of its ink, and has no more beside it; a cross, which is all arms,
/// less.
const LACKS: f32 = 0.22;
const BESIDE: f32 = 0.5;
const BESIDE_CROSS: f32 = 0.3;
/// One that is by itself lacks no more than this share, with half of what it has beside it.
const UNLIKE: f32 = 0.35;
/// A sign with more ink beside it than this share is touched by something else.
const TOUCHED: f32 = 0.12;
/// A pixel is part of the shape from this share of its greatest ink on.
const INKED: f32 = 0.45;
/// The two halves of a symmetric sign differ by no more than this share of its ink.
const SYMMETRIC: f32 = 0.25;
/// A side of a convex shape is no farther in than this, px.
const CONVEX: f32 = 1.3;
/// A filled shape has at least this share of ink.
const FILLED: f32 = 0.85;

/// The look of signs of a kind.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Template {
    /// Columns and rows of the sign, and of its picture.
    pub(super) sides: [i32; 2],
    full: [i32; 2],
    colour: [f32; 3],
    ground: [f32; 3],
    /// Row by row, 0..=1.
    ink: Vec<f32>,
}

/// How much ink of a colour there is in each pixel of a picture, 0..=1, smoothed: a sign that lies half a pixel aside
/// looks nearly the same then.
#[derive(Debug)]
pub(super) struct Inks {
    size: Size,
    soft: Vec<f32>,
}

/// Signs of a kind, to be found in a picture.
#[derive(Debug)]
pub(super) struct Sought<'a> {
    template: &'a Template,
    inks: Inks,
    /// The ink of the sign, smoothed.
    soft: Vec<f32>,
    sum: f32,
}

/// Where a sign was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Match {
    /// The first column and row of its picture.
    pub(super) min: [i32; 2],
    lacks: f32,
    beside: f32,
}

impl Match {
    fn cost(&self) -> f32 {
        self.lacks + 0.5 * self.beside
    }

    /// Whether something of its colour touches it.
    pub(super) fn is_touched(&self) -> bool {
        self.beside > TOUCHED
    }
}

/// What a shape stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Filled,
    Hollow,
    Cross,
}

impl Template {
    /// That of signs that are alike.
    pub(super) fn of(kind: &[Blob], planes: &[Plane]) -> Self {
        let middle = |mut of: Vec<f32>| {
            of.sort_by(f32::total_cmp);
            of[of.len() / 2]
        };
        let sides = [0, 1].map(|axis| middle(kind.iter().map(|blob| blob.sides[axis] as f32).collect()) as i32);
        let full = sides.map(|side| side + 2 * MARGIN);
        let pixel = |[x, y]: [i32; 2]| colour_at(planes, [x, y]);
        let corner = |blob: &Blob| corner(blob, full);
        let is_rim = |x: i32, y: i32| x == 0 || y == 0 || x == full[0] - 1 || y == full[1] - 1;
        let cells = || (0..full[1]).flat_map(move |y| (0..full[0]).map(move |x| [x, y]));
        let rims: Vec<[f32; 3]> = kind
            .iter()
            .flat_map(|blob| {
                let [left, top] = corner(blob);
                let rim = cells().filter(|[x, y]| is_rim(*x, *y));
                rim.filter_map(move |[x, y]| pixel([left + x, top + y])).collect::<Vec<_>>()
            })
            .collect();
        let ground = match rims.is_empty() {
            true => [0.0; 3],
            false => [0, 1, 2].map(|k| middle(rims.iter().map(|colour| colour[k]).collect())),
        };
        let colour = [0, 1, 2].map(|k| middle(kind.iter().map(|blob| blob.colour[k]).collect()));
        let mean = |[x, y]: [i32; 2]| {
            let ink = kind.iter().map(|blob| {
                let [left, top] = corner(blob);
                pixel([left + x, top + y]).map_or(0.0, |of| ink(of, colour, ground))
            });
            ink.sum::<f32>() / kind.len() as f32
        };
        let ink: Vec<f32> = cells().map(mean).collect();
        Self { sides, full, colour, ground, ink }
    }

    /// The mean of its sides, px.
    pub(super) fn side(&self) -> f32 {
        0.5 * (self.sides[0] + self.sides[1]) as f32
    }

    /// How far its colour is from that of its ground; of thin strokes pixels show less.
    pub(super) fn contrast(&self) -> f32 {
        apart(self.colour, self.ground).min(BLACK) * self.most_ink()
    }

    fn most_ink(&self) -> f32 {
        self.ink.iter().copied().fold(0.0, f32::max)
    }

    fn at(&self, x: i32, y: i32) -> f32 {
        self.ink[(y * self.full[0] + x) as usize]
    }

    /// The least ink of a pixel of its shape.
    fn inked(&self) -> f32 {
        INKED * self.most_ink()
    }

    /// The middle of a match.
    pub(super) fn middle(&self, found: &Match) -> [f32; 2] {
        [0, 1].map(|axis| found.min[axis] as f32 + 0.5 * self.full[axis] as f32)
    }

    /// What it stands for, if it is one of the shapes that mark places: round, or with some corners, filled or hollow,
    /// or a cross.
    pub(super) fn shape(&self) -> Option<Shape> {
        let [width, height] = self.full;
        let sum: f32 = self.ink.iter().sum();
        // thin strokes lie between pixels
        let soft = softened(&self.ink, Size::new(width as u32, height as u32));
        let at = |x: i32, y: i32| soft[(y * width + x) as usize];
        let mirrored = |of: &dyn Fn(i32, i32) -> [i32; 2]| {
            let off = |x: i32, y: i32| {
                let [mx, my] = of(x, y);
                (at(x, y) - at(mx, my)).abs()
            };
            let all: f32 = (0..height).flat_map(|y| (0..width).map(move |x| off(x, y))).sum();
            all <= 2.0 * SYMMETRIC * sum
        };
        let across = mirrored(&|x, y| [width - 1 - x, y]);
        let down = mirrored(&|x, y| [x, height - 1 - y]);
        let silhouette = self.silhouette();
        let count = silhouette.iter().filter(|is| **is).count() as f32;
        let within: f32 = (0..silhouette.len()).filter(|&i| silhouette[i]).map(|i| self.ink[i]).sum();
        if (across || down) && self.is_convex(&silhouette) {
            return Some(if within >= FILLED * count { Shape::Filled } else { Shape::Hollow });
        }
        let is_inked = self.at(width / 2, height / 2) >= self.inked();
        let turned = || {
            let scaled = |at: i32, from: i32, to: i32| (at * (to - 1) + from / 2) / (from - 1);
            (width - height).abs() <= 1 && mirrored(&|x, y| [scaled(y, height, width), scaled(x, width, height)])
        };
        (across && down && is_inked && turned()).then_some(Shape::Cross)
    }

    /// The pixels that the outside does not reach.
    fn silhouette(&self) -> Vec<bool> {
        let [width, height] = self.full;
        let inked = self.inked();
        let mut is_in = vec![true; self.ink.len()];
        let mut next: Vec<[i32; 2]> = (0..width).flat_map(|x| [[x, 0], [x, height - 1]]).collect();
        next.extend((0..height).flat_map(|y| [[0, y], [width - 1, y]]));
        while let Some([x, y]) = next.pop() {
            if x < 0 || y < 0 || x >= width || y >= height {
                continue;
            }
            let cell = (y * width + x) as usize;
            if is_in[cell] && self.ink[cell] < inked {
                is_in[cell] = false;
                next.extend([[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]]);
            }
        }
        is_in
    }

    /// Whether each of its rows is one piece, and its sides do not bend inwards.
    fn is_convex(&self, silhouette: &[bool]) -> bool {
        let width = self.full[0] as usize;
        let mut rows: Vec<[f32; 3]> = Vec::new();
        for (y, row) in silhouette.chunks_exact(width).enumerate() {
            let Some(first) = row.iter().position(|is| *is) else { continue };
            let last = row.iter().rposition(|is| *is).unwrap_or(first);
            if row[first..=last].iter().any(|is| !is) {
                return false;
            }
            rows.push([y as f32, first as f32, last as f32]);
        }
        let n = rows.len();
        let bends_in = |i: usize, j: usize, k: usize| {
            let share = (rows[j][0] - rows[i][0]) / (rows[k][0] - rows[i][0]);
            let between = |side: usize| rows[i][side] + share * (rows[k][side] - rows[i][side]);
            rows[j][1] > between(1) + CONVEX || rows[j][2] < between(2) - CONVEX
        };
        n > 2 && !(0..n).any(|i| (i + 2..n).any(|k| (i + 1..k).any(|j| bends_in(i, j, k))))
    }

    /// The pixels of a sign in the picture, with those around it that are smoothed into the ground.
    pub(super) fn cells(&self, min: [i32; 2], size: Size) -> Vec<usize> {
        let silhouette = self.silhouette();
        let [width, height] = self.full;
        let is_in = |x: i32, y: i32| {
            let near = (-RIM..=RIM).flat_map(|dy| (-RIM..=RIM).map(move |dx| [x + dx, y + dy]));
            let mut inside = near.filter(|[x, y]| (0..width).contains(x) && (0..height).contains(y));
            inside.any(|[x, y]| silhouette[(y * width + x) as usize])
        };
        let all = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        all.filter(|[x, y]| is_in(*x, *y)).filter_map(|[x, y]| cell(size, [min[0] + x, min[1] + y])).collect()
    }

    /// Where its picture begins around a small thing.
    pub(super) fn corner_at(&self, blob: &Blob) -> [i32; 2] {
        corner(blob, self.full)
    }
}

impl Inks {
    fn of(template: &Template, planes: &[Plane], size: Size) -> Self {
        let of = |cell: usize| {
            let at = std::array::from_fn(|k| planes.get(k).map_or(0.0, |plane| plane.values[cell]));
            ink(at, template.colour, template.ground)
        };
        let all: Vec<f32> = (0..size.len()).map(of).collect();
        Self { size, soft: softened(&all, size) }
    }

    fn at(&self, at: [i32; 2]) -> f32 {
        cell(self.size, at).map_or(0.0, |cell| self.soft[cell])
    }
}

/// Values smoothed over a pixel.
fn softened(values: &[f32], size: Size) -> Vec<f32> {
    smoothed(&smoothed(&Plane { size, values: values.to_vec() })).values
}

impl<'a> Sought<'a> {
    /// Those that look like these, which are alike.
    pub(super) fn of(template: &'a Template, kind: &[Blob], planes: &[Plane]) -> Option<Self> {
        let inks = Inks::of(template, planes, planes.first()?.size);
        let mean = |x: i32, y: i32| {
            let own = kind.iter().map(|blob| {
                let [left, top] = corner(blob, template.full);
                inks.at([left + x, top + y])
            });
            own.sum::<f32>() / kind.len() as f32
        };
        let [width, height] = template.full;
        let cells = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        let soft: Vec<f32> = cells.map(|[x, y]| mean(x, y)).collect();
        let sum = soft.iter().sum::<f32>().max(1.0);
        Some(Self { template, inks, soft, sum })
    }

    /// All places of the picture that look like it, each once.
    pub(super) fn matches(&self, shape: Shape) -> Vec<Match> {
        let (size, full) = (self.inks.size, self.template.full);
        let sums = Sums::of(&self.inks.soft, size);
        let most = if shape == Shape::Cross { BESIDE_CROSS } else { BESIDE };
        let mut found: Vec<Match> = Vec::new();
        for y in -MARGIN..=size.height as i32 - full[1] + MARGIN {
            for x in -MARGIN..=size.width as i32 - full[0] + MARGIN {
                let sum = sums.within([x, y], full) / self.sum;
                if (1.0 - LACKS..=1.0 + most).contains(&sum) {
                    found.extend(self.compare([x, y], LACKS).filter(|at| at.beside <= most));
                }
            }
        }
        found.sort_by(|a, b| a.cost().total_cmp(&b.cost()).then(a.min[1].cmp(&b.min[1])).then(a.min[0].cmp(&b.min[0])));
        let apart = 0.6 * self.template.sides[0].max(self.template.sides[1]) as f32;
        let mut once: Vec<Match> = Vec::new();
        for at in found {
            let is_near =
                |other: &Match| ((other.min[0] - at.min[0]) as f32).hypot((other.min[1] - at.min[1]) as f32) < apart;
            if !once.iter().any(is_near) {
                once.push(at);
            }
        }
        once
    }

    fn compare(&self, min: [i32; 2], most: f32) -> Option<Match> {
        let (mut lacks, mut beside) = (0.0, 0.0);
        let [width, height] = self.template.full;
        for y in 0..height {
            for x in 0..width {
                let more = self.inks.at([min[0] + x, min[1] + y]) - self.soft[(y * width + x) as usize];
                lacks -= more.min(0.0);
                beside += more.max(0.0);
            }
            if lacks > most * self.sum {
                return None;
            }
        }
        Some(Match { min, lacks: lacks / self.sum, beside: beside / self.sum })
    }

    /// Whether a small thing looks like it.
    pub(super) fn has(&self, blob: &Blob) -> bool {
        self.compare(corner(blob, self.template.full), UNLIKE).is_some_and(|found| found.cost() <= UNLIKE)
    }
}

/// Where a picture with these sides begins that has a small thing in its middle.
fn corner(blob: &Blob, full: [i32; 2]) -> [i32; 2] {
    [0, 1].map(|axis| blob.min[axis] + (blob.sides[axis] - full[axis]).div_euclid(2))
}

/// The number of a pixel, if it is in the picture.
fn cell(size: Size, [x, y]: [i32; 2]) -> Option<usize> {
    let is_in = x >= 0 && y >= 0 && x < size.width as i32 && y < size.height as i32;
    is_in.then(|| y as usize * size.width as usize + x as usize)
}

fn colour_at(planes: &[Plane], at: [i32; 2]) -> Option<[f32; 3]> {
    let cell = cell(planes.first()?.size, at)?;
    Some(std::array::from_fn(|k| planes.get(k).map_or(0.0, |plane| plane.values[cell])))
}

/// How far a colour is from that of the ground to that of the sign; nothing if it is another one.
fn ink(of: [f32; 3], colour: [f32; 3], ground: [f32; 3]) -> f32 {
    let full = apart(colour, ground).max(1.0);
    let way: [f32; 3] = std::array::from_fn(|k| (colour[k] - ground[k]) / full);
    let along: f32 = (0..3).map(|k| (of[k] - ground[k]) * way[k]).sum();
    let on: [f32; 3] = std::array::from_fn(|k| ground[k] + along * way[k]);
    if apart(of, on) > OFF * full { 0.0 } else { (along / full).clamp(0.0, 1.0) }
}

/// Sums over boxes of pixels.
struct Sums {
    width: usize,
    height: usize,
    sums: Vec<f64>,
}

impl Sums {
    fn of(values: &[f32], size: Size) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let mut sums = vec![0.0; (width + 1) * (height + 1)];
        for y in 0..height {
            let mut row = 0.0;
            for x in 0..width {
                row += f64::from(values[y * width + x]);
                sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
            }
        }
        Self { width, height, sums }
    }

    fn within(&self, min: [i32; 2], sides: [i32; 2]) -> f32 {
        let clamp = |at: i32, most: usize| at.clamp(0, most as i32) as usize;
        let (left, right) = (clamp(min[0], self.width), clamp(min[0] + sides[0], self.width));
        let (top, bottom) = (clamp(min[1], self.height), clamp(min[1] + sides[1], self.height));
        let at = |x: usize, y: usize| self.sums[y * (self.width + 1) + x];
        (at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top)) as f32
    }
}
