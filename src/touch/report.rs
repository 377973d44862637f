//! What was felt, in numbers and in sentences that can be read aloud.

use std::fmt;
use std::iter::Sum;
use std::ops::Add;

use super::felt::{Cell, FeltCells, JUDGED_FROM};
use super::ink::Ink;
use super::measure::{CELLS_PER_MM, PX_PER_MM};
use crate::geom::components::{self, Connectivity};
use crate::page::Class;
use crate::raster::plane::Plane;

/// Share of the blackest ink from which a pixel belongs to a glyph: dots that are pressed low are drawn grey.
const BLACK: f32 = 0.5;

/// What was felt on a page.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// Size of the fingertip, mm.
    pub finger: f32,
    /// One for each class that is on the page, in the order of [`Class::ALL`].
    pub classes: Vec<OfClass>,
}

/// What was felt of one class's textures.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct OfClass {
    /// The class that is meant.
    pub class: Class,
    /// How much of its textured area is felt as what.
    pub areas: Areas,
    /// What most of the wrong part is felt as; none if nothing is felt wrong.
    pub mostly_felt_as: Option<FeltAs>,
    /// Ink in the textured area, 0..=1.
    pub ink: f32,
    /// Glyphs to a square centimetre.
    pub density: f32,
}

/// What a fingertip takes a texture for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeltAs {
    /// The texture of this class.
    Class(Class),
    /// Blank paper.
    Blank,
}

impl FeltAs {
    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Class(class) => class.name(),
            Self::Blank => "blank paper",
        }
    }
}

/// A textured area in four parts, mm^2.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Areas {
    /// What is clearly felt as the class that is meant.
    pub right: f32,
    /// What could as well be felt as another class.
    pub unclear: f32,
    /// What is clearly felt as another class.
    pub wrong: f32,
    /// What is nearer than 7 mm to a line or a border.
    pub not_judged: f32,
}

impl Areas {
    /// The sum of all parts, mm^2.
    pub fn textured(&self) -> f32 {
        self.judged() + self.not_judged
    }

    /// The part that is judged, mm^2.
    pub fn judged(&self) -> f32 {
        self.right + self.unclear + self.wrong
    }

    /// The right part as a share of the judged part, 0..=1; 0 where nothing is judged.
    pub fn right_of_judged(&self) -> f32 {
        share(self.right, self.judged())
    }
}

impl Add for Areas {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            right: self.right + other.right,
            unclear: self.unclear + other.unclear,
            wrong: self.wrong + other.wrong,
            not_judged: self.not_judged + other.not_judged,
        }
    }
}

impl Sum for Areas {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), Self::add)
    }
}

/// A part of a whole, 0..=1; 0 of nothing.
fn share(part: f32, whole: f32) -> f32 {
    if whole > 0.0 { part / whole } else { 0.0 }
}

/// The report on `felt`, which was felt in `ink`.
pub fn report(ink: &Ink, felt: &FeltCells) -> Report {
    let classes = ink.textures.iter().map(|(class, plane)| {
        let areas = areas_of(felt, *class);
        let inked = plane.values.iter().sum::<f32>() / (PX_PER_MM * PX_PER_MM) as f32;
        OfClass {
            class: *class,
            areas,
            mostly_felt_as: mostly_felt_as(felt, *class),
            ink: share(inked, areas.textured()).min(1.0),
            density: 100.0 * share(glyphs(plane) as f32, areas.textured()),
        }
    });
    Report { finger: felt.finger, classes: classes.filter(|of| of.areas.textured() > 0.0).collect() }
}

impl Report {
    /// The areas of all classes together: a share of this total is the mean of the classes' shares, weighted by their
    /// textured areas.
    pub fn total(&self) -> Areas {
        self.classes.iter().map(|of| of.areas).sum()
    }
}

/// How many glyphs there are in ink: the 8-connected components of its dark pixels.
fn glyphs(ink: &Plane) -> usize {
    let blackest = ink.values.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let is_ink: Vec<bool> = ink.values.iter().map(|&value| value >= BLACK * blackest).collect();
    let components = components::of_labels(&is_ink, ink.size, Connectivity::Eight);
    components.iter().filter(|component| is_ink[component[0]]).count()
}

/// The area of all cells that pass, mm^2.
fn area_of<'a>(cells: impl Iterator<Item = &'a Cell>, passes: impl Fn(&Cell) -> bool) -> f32 {
    cells.filter(|cell| passes(cell)).count() as f32 / (CELLS_PER_MM * CELLS_PER_MM) as f32
}

fn areas_of(felt: &FeltCells, class: Class) -> Areas {
    let area =
        |passes: &dyn Fn(&Cell) -> bool| area_of(felt.cells.iter(), |cell| cell.meant == Some(class) && passes(cell));
    Areas {
        right: area(&|cell| cell.judged && cell.clear && cell.felt == Some(class)),
        unclear: area(&|cell| cell.judged && !cell.clear),
        wrong: area(&|cell| cell.judged && cell.clear && cell.felt != Some(class)),
        not_judged: area(&|cell| !cell.judged),
    }
}

fn mostly_felt_as(felt: &FeltCells, class: Class) -> Option<FeltAs> {
    let judged = |cell: &Cell| cell.meant == Some(class) && cell.judged && cell.clear;
    let others = Class::ALL.map(Some).into_iter().chain([None]).filter(|other| *other != Some(class));
    let areas = others.map(|other| (area_of(felt.cells.iter(), |cell| judged(cell) && cell.felt == other), other));
    areas
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(area, _)| *area > 0.0)
        .map(|(_, other)| other.map_or(FeltAs::Blank, FeltAs::Class))
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.classes.is_empty() {
            return writeln!(f, "There are no textures on this page: a fingertip feels blank paper and lines.");
        }
        writeln!(f, "What a fingertip of {} mm feels, in shares of the textured area of each colour:", self.finger)?;
        let total = self.total();
        for of in &self.classes {
            let of_all = Percent(share(of.areas.textured(), total.textured()));
            write!(f, "{}, {of_all} of all textures: {}", of.class.name(), Shares(of.areas))?;
            if let Some(other) = of.mostly_felt_as {
                write!(f, ". Wrong is mostly felt as {}", other.name())?;
            }
            writeln!(f, ". Ink {}, {:.1} glyphs to a square centimetre.", Percent(of.ink), of.density)?;
        }
        writeln!(f, "All textures: {}.", Shares(total))?;
        let nearer = format_args!("What lies nearer than {JUDGED_FROM} mm to a line or a border is not judged");
        writeln!(f, "{nearer}: a fingertip feels both sides there.")
    }
}

/// The four parts of an area as shares of it.
struct Shares(Areas);

impl fmt::Display for Shares {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |part: f32| Percent(share(part, self.0.textured()));
        let Areas { right, unclear, wrong, not_judged } = self.0;
        write!(f, "right {}, unclear {}, wrong {}, ", percent(right), percent(unclear), percent(wrong))?;
        write!(f, "not judged {}", percent(not_judged))
    }
}

/// A share in whole percent. Nothing is written as 0 or 100 that is not.
struct Percent(f32);

impl fmt::Display for Percent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.0;
        match percent {
            p if p > 0.0 && p < 0.5 => write!(f, "under 1 %"),
            p if (99.5..100.0).contains(&p) => write!(f, "over 99 %"),
            p => write!(f, "{p:.0} %"),
        }
    }
}

#[cfg(test)]
mod tests;
