//! Textures of dots that can stand anywhere: the lattices of [`crate::textures`], with dots in place of rhombuses.

use super::Field;
use super::pattern::DENSE_FROM;
use super::strays::{self, Apart};
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
/// Dots keep this share of the pitch from the border of their region, so that two textures are half as far again apart as
/// the dots of a row.
const FROM_BORDER: f32 = 0.75;

/// The dots of each region.
pub(super) fn fill(field: &Field<'_>, lines: &[Line], part: MmRect) -> Vec<Vec<MmPoint>> {
    let Field { area, classes, params, .. } = field;
    let mut sets = vec![Vec::new(); classes.regions.len()];
    let (across, grey) = (ACROSS.max(1.6 * params.pitch), GREY.max(params.pitch));
    let lattice = textures::Params {
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
    };
    let gap = (params.line_gap + 1) as f32 * params.pitch;
    let near = index(lines, *area, gap);
    for class in Class::ALL {
        lattice::each_position(class, *area, &lattice, |place| {
            let at = place.at;
            let Some((region, amount)) = field.at(at) else { return };
            let fits = field.class_of(region) == class && from_amount(place.from_density) <= amount;
            let glyph = Glyph { at, shape: Shape::Dot { diameter: params.diameter } };
            let margin = (FROM_BORDER * params.pitch - glyph.radius()).max(0.0);
            if fits
                && part.contains_inclusive(at)
                && field.holds(at)
                && field.borders.keeps_inside(&glyph, &glyph.corners(), region, margin)
                && is_clear(&near, at, gap)
            {
                sets[region as usize].push(at);
            }
        });
    }
    let apart = Apart {
        pitch: params.pitch,
        along: params.pitch,
        off: 0.3 * params.pitch,
        across: (2.0 * across).max(3.0_f32.sqrt() * grey),
    };
    for (set, region) in sets.iter_mut().zip(&classes.regions) {
        let sign = params.palette.sign(region.class);
        strays::leave_out(set, sign, apart);
    }
    sets
}

/// The amount of texture from which a place of the lattice is filled.
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
