//! Textures of dots that can stand anywhere: the lattices of [`crate::textures`], with dots in place of rhombuses.

use super::field::{Field, Params};
use super::pattern::DENSE_FROM;
use super::small_components::{self, LatticeSpacing};
use crate::classes::Class;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::lines::Line;
use crate::textures::{self, Glyph, Shape, lattice};
use crate::units::{MmPoint, MmRect};

/// Distance of rows, mm: as far as those of rhombuses, for the same reason.
const ACROSS: f32 = 4.0;
/// Distance of the dots of dense grey, mm: as that of [`crate::textures`].
const GREY: f32 = 3.2;
/// Dots keep this share of the pitch from the border of their region, so that two textures are half as far again
/// apart as the dots of a row.
const FROM_BORDER: f32 = 0.75;

/// The dots that would be set if there were no lines.
pub(super) struct FreeCandidates<'a> {
    field: &'a Field<'a>,
    /// The region of each dot and where it is.
    dots: Vec<(u32, MmPoint)>,
}

impl<'a> FreeCandidates<'a> {
    /// The candidates in `part` of the sheet.
    pub(super) fn of(field: &'a Field<'a>, part: MmRect) -> Self {
        let lattice = lattice_of(field.params);
        let mut dots = Vec::new();
        for class in Class::ALL {
            lattice::each_position(class, field.area, &lattice, |place| {
                let region = region_at(field, class, place.at, place.from_density);
                dots.extend(region.filter(|_| part.contains_inclusive(place.at)).map(|region| (region, place.at)));
            });
        }
        Self { field, dots }
    }

    /// The dots of each region that keep the distance of `gap` empty dots from those of lines.
    pub(super) fn dots(&self, lines: &[Line], gap: u32) -> Vec<Vec<MmPoint>> {
        let Field { area, classes, params, .. } = self.field;
        let gap = (gap + 1) as f32 * params.pitch;
        let near = index(lines, *area, gap);
        let mut sets = vec![Vec::new(); classes.regions.len()];
        for &(region, at) in self.dots.iter().filter(|(_, at)| is_clear(&near, *at, gap)) {
            sets[region as usize].push(at);
        }
        let (across, grey) = distances(params);
        let spacing = LatticeSpacing {
            pitch: params.pitch,
            along: params.pitch,
            off: 0.3 * params.pitch,
            across: (2.0 * across).max(3.0_f32.sqrt() * grey),
        };
        for (set, region) in sets.iter_mut().zip(&classes.regions) {
            small_components::leave_out(set, params.palette.sign(region.class), spacing, params.least);
        }
        sets
    }
}

/// The region of a dot of the lattice of `class`, if it is set: its region has the class and enough texture, and the
/// dot is far enough from the region's border.
fn region_at(field: &Field<'_>, class: Class, at: MmPoint, from_density: f32) -> Option<u32> {
    let params = field.params;
    let (region, amount) = field.at(at)?;
    let fits = field.class_of(region) == class && from_amount(from_density) <= amount;
    let glyph = Glyph { at, shape: Shape::Dot { diameter: params.diameter } };
    let margin = (FROM_BORDER * params.pitch - glyph.radius()).max(0.0);
    let is_inside = || field.holds(at) && field.borders.keeps_inside(&glyph, &glyph.corners(), region, margin);
    (fits && is_inside()).then_some(region)
}

/// Distance of rows and of the dots of dense grey, mm.
fn distances(params: &Params) -> (f32, f32) {
    (ACROSS.max(1.6 * params.pitch), GREY.max(params.pitch))
}

/// The lattices of rhombuses with dots in their place.
fn lattice_of(params: &Params) -> textures::Params {
    let (across, grey) = distances(params);
    textures::Params {
        line_gap: 0.0,
        along: params.pitch,
        across,
        length: params.diameter,
        thickness: params.diameter,
        dot: params.diameter,
        dot_pitch: grey,
        min_glyph: 0.0,
        density_blur: params.density_blur,
        dense_from: params.dense_from,
        white_from: params.white_from,
        palette: params.palette,
    }
}

/// The amount of texture from which a dot of the lattice is set.
fn from_amount(from_density: f32) -> f32 {
    if from_density < 0.0 { -1.0 } else { DENSE_FROM + 0.5 * (from_density - 0.5) }
}

fn index(lines: &[Line], area: MmRect, gap: f32) -> Nearby {
    let mut nearby = Nearby::new(area, gap);
    for run in lines.iter().flat_map(|line| &line.runs) {
        for (i, &a) in run.points.iter().enumerate() {
            let b = run.points.get(i + 1).copied().unwrap_or(a);
            nearby.insert(Segment { a, b, half_width: 0.0, line: 0, index: i as u32, arc: 0.0 });
        }
    }
    nearby
}

fn is_clear(lines: &Nearby, at: MmPoint, gap: f32) -> bool {
    let mut clear = true;
    lines.around(at, at, gap, |segment| clear &= nearest_on_segment(at, segment.a, segment.b).0 >= gap);
    clear
}
