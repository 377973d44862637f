//! The same scenes as pages of dots: can a fingertip tell the colours that a device of this pitch draws?

use std::sync::Arc;

use tactograph::Page;
use tactograph::devices::{Grid, Room};
use tactograph::dots::textures::{self, Params};
use tactograph::page::{Class, Figure, Height, Line, Palette, Parts, Pen, Run};
use tactograph::pipeline::{Request, colours};
use tactograph::profile::Plan;
use tactograph::units::{MmPoint, MmRect, Size};

/// A4, and the part of it that a device reaches, mm.
const SHEET: [f32; 2] = [210.0, 297.0];
const MARGIN: f32 = 10.0;
/// Lines are followed in steps of this, mm.
const STEP: f32 = 0.25;

/// A device: where its dots can be, and how they are drawn.
pub(crate) struct Device {
    pub(crate) room: Room,
    pub(crate) params: Params,
}

impl Device {
    /// A grid of so many millimetres, `cells` for braille cells of six dots, or `free` for dots anywhere.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let (pitch, room) = match name {
            "free" => {
                let part = MmRect::new(MmPoint::zero(), MmPoint::new(SHEET[0], SHEET[1]));
                (2.5, Room::Free(part.inflate(-MARGIN, -MARGIN)))
            }
            "cells" => (2.34, Room::Grid(cells())),
            pitch => {
                let pitch: f32 = pitch.parse().ok()?;
                let places = |side: f32| {
                    let count = ((side - 2.0 * MARGIN) / pitch) as usize;
                    let first = 0.5 * (side - count as f32 * pitch);
                    (0..=count).map(|i| first + i as f32 * pitch).collect()
                };
                (pitch, Room::Grid(Grid { columns: places(SHEET[0]), rows: places(SHEET[1]) }))
            }
        };
        let params = Params {
            pitch,
            diameter: diameter(pitch),
            line_gap: line_gap(pitch),
            least_gap: line_gap(pitch),
            density_blur: 8.0,
            dense_from: 0.5,
            white_from: 0.92,
            palette: Palette::PAPER,
        };
        Some(Self { room, params })
    }

    /// The page of dots of a picture. Its lines are those of `page`, the same picture's page of swell paper.
    pub(crate) fn page_of(&self, picture: &[u8], page: &Page, plan: &Plan) -> Page {
        let fonts = || Arc::new(usvg::fontdb::Database::new());
        let request =
            Request { plan, limits: Default::default(), fonts: &fonts, title: "scene", fit: Default::default() };
        let sorted = colours::sort(picture, &request, &mut |_| ()).expect("a scene has colours");
        let lines: Vec<Line> = page.figure.lines.iter().map(|line| self.dotted(line)).collect();
        let textures = sorted
            .classes
            .map(|classes| textures::fill(&classes, page.figure.place, &lines, &self.room, &self.params))
            .unwrap_or_default();
        let figure = Figure { place: page.figure.place, source: page.figure.source, textures, lines };
        page_with(figure, SHEET)
    }

    /// One texture all over a page.
    pub(crate) fn page_of_sample(&self, class: Class, lightness: f32, density: f32, place: MmRect) -> Page {
        let texture = textures::sample(class, lightness, density, place, &self.room, &self.params);
        let figure = Figure { place, source: Size::new(1, 1), textures: vec![texture], lines: Vec::new() };
        page_with(figure, SHEET)
    }

    /// A line as dots side by side.
    fn dotted(&self, line: &Line) -> Line {
        let mut dots: Vec<MmPoint> = Vec::new();
        for pair in line.runs.iter().flat_map(|run| run.points.windows(2)) {
            let steps = ((pair[1] - pair[0]).length() / STEP).ceil().max(1.0);
            for at in (0..=steps as u32).map(|k| pair[0].lerp(pair[1], k as f32 / steps)) {
                let at = match &self.room {
                    Room::Grid(grid) => MmPoint::new(nearest(&grid.columns, at.x), nearest(&grid.rows, at.y)),
                    Room::Free(_) => at,
                };
                let apart = if matches!(self.room, Room::Free(_)) { self.params.pitch } else { f32::EPSILON };
                if dots.last().is_none_or(|last| (*last - at).length() >= apart) {
                    dots.push(at);
                }
            }
        }
        Line {
            strength: line.strength,
            runs: vec![Run { width: self.params.diameter, points: dots, pen: Pen::Dots(Height::High) }],
        }
    }
}

/// Standard braille cells of six dots: 2.34 mm from dot to dot, 6.2 mm from cell to cell, 10 mm from line to line.
fn cells() -> Grid {
    let places = |side: f32, step: f32, dots: usize| {
        let cells = ((side - 2.0 * MARGIN) / step) as usize;
        let first = 0.5 * (side - cells as f32 * step);
        (0..cells * dots).map(|i| first + (i / dots) as f32 * step + (i % dots) as f32 * 2.34).collect()
    };
    Grid { columns: places(SHEET[0], 6.2, 2), rows: places(SHEET[1], 10.0, 3) }
}

fn diameter(pitch: f32) -> f32 {
    match pitch {
        p if p < 1.5 => 1.0,
        p if p < 1.9 => 1.2,
        _ => 1.5,
    }
}

fn line_gap(pitch: f32) -> u32 {
    (4.0 / pitch).round().max(2.0) as u32 - 1
}

fn nearest(places: &[f32], at: f32) -> f32 {
    places.iter().copied().min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs())).unwrap_or(at)
}

fn page_with(figure: Figure, sheet: [f32; 2]) -> Page {
    let parts = Parts { title: "dots".into(), ..Parts::of(sheet, figure) };
    Page::new(parts).expect("all dots lie on the sheet")
}
